r"""
How warm does a pin on a disc get?
==================================

A steel pin with a round end slides on a disc. At a crawl the contact hardly warms up, at walking pace it gains more
than a hundred kelvin, at the speed of a brake it glows. In between one number decides: how far heat diffuses into the
disc while the contact passes by, measured by the Peclet number :math:`\mathrm{Pe}=Va/2\kappa`.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# Pin and disc
# ------------
# The contact rests on the pin (the second body) and moves over the disc (the first one). Both are of steel; the disc
# may also be of bronze, which conducts better.

elastic = wk.Elastic(young=210e9, poisson=0.3)
bed = wk.Foundation(wk.Sphere(curvature_radius=5e-3), wk.HalfSpace.between(elastic, elastic))
steel = wk.ThermalConductor.of(conductivity=45.0, density=7850.0, heat_capacity=470.0)
bronze = wk.ThermalConductor.of(conductivity=60.0, density=8800.0, heat_capacity=380.0)
friction, pressed = wk.Coulomb(0.4), wk.Indentation(bed, wk.Force(10.0))
rubbing = wk.FrictionHeating(pressed, friction, wk.HeatConductors(steel, steel), first_speed=1.0).solve()
print(
    f"{rubbing.heat_rate:.2f} W on a radius of {rubbing.contact.radius * 1e6:.0f} um, Pe = {rubbing.first_peclet:.2f}"
)
print(f"flash temperature {rubbing.flash_temperature:.0f} K, {rubbing.first_share:.0%} of the heat goes into the disc")
for note in rubbing.validity:
    if note.standing is wk.Standing.APPROXIMATE:
        print(note)

# %%
# The disc carries its heat away: the warmest place lies behind the middle, and a wake follows. The pin stays where it
# is. Blok's rule lets both reach the same greatest temperature; the right picture shows how far the fast disc stays
# below what the rule for bodies at rest gives.

draw(rubbing)

# %%
# Over the speed
# --------------
# Many speeds, and many loads, are solved at once. The dashed lines are the limits: both bodies at rest, and a disc
# so fast that heat only flows downwards. The fit of Tian and Kennedy joins them within about one per cent.

speed = np.geomspace(0.01, 100.0, 33)
figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
for disc, name, colour in ((steel, "steel", "C0"), (bronze, "bronze", "C1")):
    many = wk.FrictionHeating(pressed, friction, wk.HeatConductors(disc, steel), first_speed=speed).solve()
    left.loglog(speed, many.flash_temperature, color=colour, label=f"disc of {name}")
    left.loglog(speed, many.stationary_temperature, color=colour, linewidth=0.9, linestyle="--")
    left.loglog(speed, many.fast_temperature, color=colour, linewidth=0.9, linestyle=":")
    right.semilogx(speed, many.first_share, color=colour, label=f"disc of {name}")
    if name == "steel":
        pair = many
left.set(xlabel="speed of sliding [m/s]", ylabel="flash temperature [K]", ylim=(0.3, 3e3), title="flash temperature")
right.set(xlabel="speed of sliding [m/s]", ylabel="part of the heat [-]", ylim=(0.0, 1.0), title="what the disc takes")
left.legend(frameon=False)
right.legend(frameon=False)
plt.show()

# %%
# Check
# -----
# At low speed the rule :math:`T=\mu vE^*d/2(\lambda_1+\lambda_2)` holds: temperature is the displacement of the
# surface, times a constant. At any speed both bodies together stay below what each would have alone.

v, slow = speed[0], pair.at(0)
rule = 0.4 * v * bed.medium.modulus * slow.contact.depth / (2.0 * (45.0 + 45.0))
assert np.isclose(slow.stationary_temperature, rule, rtol=1e-6)
assert np.isclose(slow.flash_temperature, rule, rtol=0.02)
assert np.all(np.diff(pair.overestimate) > 0.0)
assert np.allclose(pair.tian_kennedy_temperature, pair.flash_temperature, rtol=0.011)
