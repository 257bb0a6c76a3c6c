r"""
The flash temperature of a pair of gear teeth
=============================================

Two teeth of spur gears touch along a line that runs across the flanks while they mesh. At each position they are two
cylinders: involutes have the radii of curvature :math:`R_1 = r_{b1}\tan\alpha + s` and
:math:`R_2 = r_{b2}\tan\alpha - s`, with the base radii :math:`r_b`, the pressure angle :math:`\alpha` and the distance
:math:`s` from the pitch point along the line of action. Their surfaces move past the contact with
:math:`V_i = \omega_i R_i`, and slide with the difference. When the lubricant film breaks down, how warm do the
flanks get?

This is a contact at given positions, not a gear program: load sharing between pairs of teeth, profile corrections and
the bulk temperature of the gears are up to the reader.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# One position
# ------------
# A pinion of 25 teeth drives a wheel of 45 teeth; module 4 mm, pressure angle 20 degrees, 3000 turns per minute. Each
# millimetre of width bears 200 N, and friction of unlubricated flanks is taken as 0.08.

MODULE, TEETH, PRESSURE_ANGLE = 4e-3, (25, 45), np.radians(20.0)
LOAD, FRICTION = wk.LineForce(200e3), wk.Coulomb(0.08)
steel = wk.Elastic(young=206e9, poisson=0.3)
pair = wk.HalfSpace.between(steel, steel)
conductor = wk.ThermalConductor.of(conductivity=46.0, density=7850.0, heat_capacity=470.0)
conductors = wk.HeatConductors(conductor, conductor)
turning = 3000.0 * 2.0 * np.pi / 60.0 * np.array([1.0, TEETH[0] / TEETH[1]])
arms = 0.5 * MODULE * np.array(TEETH) * np.sin(PRESSURE_ANGLE)


def teeth(s):
    """Return the contact of both flanks, s [m] behind the pitch point on the line of action."""
    radii = arms + np.array([s, -s])
    bed = wk.LineFoundation(wk.Paraboloid(curvature_radius=1.0 / np.sum(1.0 / radii)), pair)
    first, second = turning * radii
    pressed = wk.LineIndentation(bed, LOAD)
    return wk.LineFrictionHeating(pressed, FRICTION, conductors, first_speed=first, second_speed=second)


end = teeth(6e-3).solve()
print(f"speeds {end.problem.first_speed:.2f} and {end.problem.second_speed:.2f} m/s, Pe = {end.first_peclet:.0f}")
print(f"half-width {end.half_width * 1e6:.0f} um, greatest pressure {end.contact.peak_pressure / 1e6:.0f} MPa")
print(f"flash temperature {end.flash_temperature:.1f} K above the bulk, {end.first_share:.1%} to the pinion")
draw(end)

# %%
# Blok's formula
# --------------
# Both surfaces move so fast that heat flows into the depth alone, and Blok's formula holds,
#
# .. math:: T = 0.786\,\frac{\mu P\,|\sqrt{V_1}-\sqrt{V_2}|}{\sqrt{\lambda\rho c\,a}}
#
# for like bodies (rules for gears round the factor to 0.80). `fast_temperature` is this limit.

effusivity = conductor.conductivity / np.sqrt(conductor.diffusivity)
roots = np.sqrt(end.problem.first_speed) - np.sqrt(end.problem.second_speed)
blok = 0.786 * FRICTION.coefficient * 200e3 * roots / (effusivity * np.sqrt(end.half_width))
print(f"Blok: {blok:.1f} K, limit of fast sliding: {end.fast_temperature:.1f} K")
assert np.isclose(end.fast_temperature, blok, rtol=1e-3)
assert np.isclose(end.flash_temperature, end.fast_temperature, rtol=1e-3)

# %%
# Along the line of action
# ------------------------
# At the pitch point the flanks roll without sliding, and stay cold. Towards the root of the driving tooth its surface
# is slow and strongly curved: the flash temperature is greatest at the ends of the path of contact.

positions = np.linspace(-10e-3, 10e-3, 41)
flash, surface = [], []
for s in positions:
    warm = teeth(s).solve()
    flash.append(warm.flash_temperature)
    surface.append(warm.contact.greatest_stress(FRICTION.coefficient).value)
assert flash[20] == 0.0
assert flash[0] > flash[-1]

figure, axes = plt.subplots(figsize=(6.0, 3.6), layout="constrained")
axes.plot(positions * 1e3, flash, "C3")
axes.set(xlabel="distance from the pitch point [mm]", ylabel="flash temperature [K]", ylim=(0.0, None))
stress = axes.twinx()
stress.plot(positions * 1e3, np.array(surface) / 1e6, "C0--")
stress.set(ylabel="greatest von Mises stress [MPa]", ylim=(0.0, None))
axes.set_title("a pair of teeth under 200 N/mm")
plt.show()
