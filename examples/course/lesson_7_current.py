r"""
Lesson 7: stiffness is conductance
==================================

*Before:* lesson 1. *Afterwards* you can turn a stiffness into a resistance, of any contact.

Current that squeezes through a disc and a punch that is pressed by its face solve the same problem of potential
theory. So each spring is a resistor as well: :math:`\Delta\Lambda = 2 \Delta x / (\rho_1 + \rho_2)` stands beside
:math:`\Delta k = E^* \Delta x`. Barber has shown that this is more than a likeness: the ratio of incremental
stiffness to conductance is the same for contacts of all shapes, rough ones too.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# A relay
# -------
# Two rivets of silver alloy, one round with 5 mm, the other flat, at 1 N.

RADIUS, FORCE, RESISTIVITY = 5e-3, 1.0, 20e-9
silver = wk.Elastic(young=80e9, poisson=0.37)
modulus = 80e9 / (2.0 * (1.0 - 0.37**2))  # E* [Pa]
radius = (0.75 * FORCE * RADIUS / modulus) ** (1.0 / 3.0)
x = (np.arange(1000) + 0.5) / 1000 * radius
conductance = 2.0 * float(np.sum(np.full_like(x, 2.0 / (2.0 * RESISTIVITY)))) * radius / 1000
holm = RESISTIVITY / (2.0 * radius)
print(f"contact radius {1e6 * radius:.2f} um; {1e6 / conductance:.2f} uohm by the springs, {1e6 * holm:.2f} by Holm")
assert abs(conductance * holm - 1.0) < 1e-12

rivets = wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace.between(silver, silver))
alloy = wk.ElectricalConductor(resistivity=RESISTIVITY)
relay = wk.Constriction(wk.Indentation(rivets, wk.Force(FORCE)), wk.ElectricalConductors(alloy, alloy)).solve()
print(f"winkler: {1e6 * relay.resistance:.2f} uohm")
assert abs(relay.resistance / holm - 1.0) < 1e-12

# %%
# Exercise
# --------
# You have measured force over depth of some contact, and know nothing of its shape. Predict its resistance. Try it
# with a cone, a ball and a worn ball.
#
# Solution
# --------
# Differentiate: :math:`\Lambda = 2 \frac{\mathrm{d}F}{\mathrm{d}d} \big/ \left( E^* (\rho_1 + \rho_2) \right)`.

figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
shapes = {
    "cone": wk.Cone(half_angle=np.radians(87.0)),
    "ball": wk.Paraboloid(RADIUS),
    "worn ball": wk.TruncatedParaboloid(curvature_radius=RADIUS, flat_radius=20e-6),
}
for (name, shape), colour in zip(shapes.items(), ("C3", "C0", "C2"), strict=True):
    bed = wk.Foundation(shape, wk.HalfSpace.between(silver, silver))
    depths = np.linspace(0.02e-6, 1.0e-6, 400)
    force = wk.Indentation(bed, wk.Depth(depths)).solve().force
    measured = np.gradient(force, depths)
    predicted = modulus * RESISTIVITY / measured
    known = (
        wk.Constriction(wk.Indentation(bed, wk.Depth(depths)), wk.ElectricalConductors(alloy, alloy)).solve().resistance
    )
    worst = float(np.max(np.abs(predicted / known - 1.0)[5:-5]))
    print(f"{name:9s}: resistance from the curve alone within {worst:.1e}")
    assert worst < 5e-3
    axes.loglog(force, 1e6 * known, colour, label=name)
    axes.loglog(force[5:-5:40], 1e6 * predicted[5:-5:40], colour + "o")
axes.set(xlabel="force [N]", ylabel="resistance [µΩ]", title="Resistances (lines) from curves of force (dots)")
axes.legend(frameon=False)
plt.show()
