r"""
How warm a wheel and a rail get
===============================

A wheel that pulls slips on the rail, and friction heats a patch that passes in half a millisecond. The heat is released
where the wheel slips, :math:`q = V\,\tau\cdot s'`, each body carries it away, and the surfaces have one temperature
wherever they touch. Boundary elements find all of it for any outline: here of a new tread and of a worn one.
"""

import dataclasses

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

steel = wk.HalfSpace.between(wk.Elastic(210e9, 0.28), wk.Elastic(210e9, 0.28))
conductor = wk.ThermalConductor.of(conductivity=50.0, density=7850.0, heat_capacity=450.0)
pair = wk.HeatConductors(conductor, conductor)
SPEED = 30.0

# %%
# A new wheel that pulls
# ----------------------
# With a creepage of 0.3 % and some spin. The heat is what creepages times forces take.

wheel = wk.CurvedBodies(longitudinal_curvature_radius=0.46, lateral_curvature_radius=0.3)
new = wk.SampledProfile([18e-3, 14e-3], wheel, (72, 56))
pulls = wk.SurfaceRolling(
    new, steel, wk.Force(80e3), wk.Coulomb(0.3), wk.Creepage(longitudinal=3e-3, spin=0.2), speed=SPEED
)
warm = wk.SurfaceFrictionHeating(pulls, pair).solve()
assert np.isclose(warm.heat_rate, warm.creep_power, rtol=5e-3)
print(f"{warm.heat_rate / 1e3:.2f} kW, up to {warm.max_temperature:.1f} K, {-warm.x * 1e3:.1f} mm behind the middle")
draw(warm)

# %%
# A worn one
# ----------
# Ten micrometres were worn off the middle of the tread: it bears on both sides, and that is where it gets warm.

y = (np.arange(56) - 27.5) * new.pixel[1]
worn = wk.Topography(new.heights - 10e-6 * np.exp(-((y / 2.5e-3) ** 2)), new.lengths)
hollow = wk.SurfaceFrictionHeating(dataclasses.replace(pulls, topography=worn), pair).solve()
print(f"{hollow.heat_rate / 1e3:.2f} kW, up to {hollow.max_temperature:.1f} K at y = {hollow.y * 1e3:.1f} mm")
draw(hollow)

# %%
# Temperatures over the creepage
# ------------------------------
# Where all slides they grow with the creepage; before, only a part of the contact is heated.

creepage = wk.Creepage(longitudinal=np.geomspace(2e-4, 2e-2, 9))
figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
for name, tread, look in (("new", new, "o-"), ("worn hollow", worn, "s-")):
    rolling = dataclasses.replace(pulls, topography=tread, drive=creepage)
    curve = wk.SurfaceFrictionHeating(rolling, pair).solve()
    axes.loglog(100 * creepage.longitudinal, curve.max_temperature, look, label=name)
axes.set(xlabel="creepage [%]", ylabel="greatest rise of temperature [K]")
axes.legend(frameon=False)
plt.show()

# %%
# A locked wheel
# --------------
# It slides at 0.1 m/s and rests against the contact: the rail takes most of the heat, and the wheel is hotter than one
# that rolls and slips as fast, as the heat stays at one place of its tread.

pressed = wk.SurfaceContact(new, steel, wk.Force(80e3)).solve().surface_load
rubbed = dataclasses.replace(pressed, x_traction=-0.3 * pressed.pressure)
locked = wk.SurfaceFrictionHeating(rubbed, pair, first_speed=0.1).solve()
rolls = wk.SurfaceFrictionHeating(rubbed, pair, first_speed=SPEED, second_speed=SPEED - 0.1).solve()
assert locked.max_temperature > rolls.max_temperature
print(f"locked: {locked.max_temperature:.0f} K, {locked.first_share:.1%} to the rail")
print(f"slips as fast while it rolls: {rolls.max_temperature:.0f} K, {rolls.first_share:.1%} to the rail")
draw(locked)
