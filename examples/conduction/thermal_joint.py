"""
Heat through a joint
====================

A steel pin of 4 mm draws heat out of a warm copper plate. It touches with its slightly domed end. What holds the heat
back, the pin or the contact? And what does roughness change, if nothing is known but its height?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

steel, copper = wk.Elastic(young=210e9, poisson=0.3), wk.Elastic(young=120e9, poisson=0.34)
dome = wk.Foundation(wk.Paraboloid(curvature_radius=0.2), wk.HalfSpace.between(copper, steel))
plate = wk.ThermalConductor.of(conductivity=390.0, density=8960.0, heat_capacity=385.0)
pin = wk.Rod(wk.ThermalConductor.of(conductivity=45.0, density=7850.0, heat_capacity=470.0), radius=2e-3, length=20e-3)
joint = wk.HeatConductors(plate, pin, wk.ThermalInterface(interface_conductance=5e4))

# %%
# Three resistances in a row
# --------------------------
# The end touches in a small disc, through which all heat has to pass; grease or an oxide holds back so much per area;
# the pin itself conducts along its length. A wide contact leaves heat less to spread: on the pin it constricts less
# than on a thick body.

force = np.geomspace(1.0, 500.0, 40)
curve = wk.ThermalConstriction(wk.Indentation(dome, wk.Force(force)), joint, temperature_drop=50.0).solve()
figure, axes = plt.subplots(figsize=(6.0, 4.0), layout="constrained")
parts = {
    "constriction": curve.constriction,
    "interface": curve.interface_resistance,
    "pin": np.full(force.shape, curve.bulk_resistance),
}
axes.stackplot(force, *parts.values(), labels=list(parts), alpha=0.6)
axes.set_xscale("log")
axes.set(xlabel="force [N]", ylabel="temperature drop per heat rate [K/W]", title="what holds the heat back")
axes.legend(frameon=False)
plt.show()
for place in (0, 20, 39):
    print(
        f"{force[place]:6.1f} N: {curve.heat_rate[place]:5.3f} W, of which {parts['pin'][place]:.1f} K/W pin, "
        f"{curve.constriction[place]:6.1f} K/W constriction, {curve.interface_resistance[place]:7.1f} K/W interface"
    )

# %%
# Around a clean contact
# ----------------------

bare = wk.HeatConductors(plate, wk.ThermalConductor(conductivity=45.0, diffusivity=12.2e-6))
picture = draw(wk.ThermalConstriction(wk.Indentation(dome, wk.Force(100.0)), bare, temperature_drop=50.0).solve())

# %%
# Rough ends
# ----------
# Conductance and stiffness are in proportion, and the stiffness of a rough body has bounds: its force curve lies
# between that of the smooth one and the same moved by the height of the roughness. Here it is that of a current, with
# one over the conductivity for the resistivity.

conductors = wk.ElectricalConductors(wk.ElectricalConductor(1.0 / 390.0), wk.ElectricalConductor(1.0 / 45.0))
for height in (0.05e-6, 0.2e-6, 1e-6):
    bounds = wk.ConductanceBounds(dome, conductors, roughness=height, force=100.0).solve()
    print(
        f"roughness {height * 1e6:4.2f} um: {bounds.least_conductance * 1e3:5.2f} to "
        f"{bounds.greatest_conductance * 1e3:5.2f} mW/K, smooth {bounds.smooth_conductance * 1e3:5.2f} mW/K"
    )
    assert bounds.least_conductance < bounds.smooth_conductance < bounds.greatest_conductance

# %%
# Check
# -----
# Without an interface two thick bodies pass 4 λ a ΔT, with half the harmonic mean of their conductivities for λ.

thick = wk.ThermalConstriction(wk.Indentation(dome, wk.Force(100.0)), bare, temperature_drop=50.0).solve()
assert np.isclose(thick.heat_rate, 4.0 * thick.radius * 50.0 / (1.0 / 390.0 + 1.0 / 45.0), rtol=1e-12)
assert np.isclose(thick.heat_rate / 50.0, bounds.smooth_conductance, rtol=1e-12)
