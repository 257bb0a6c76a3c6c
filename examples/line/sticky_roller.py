r"""
A rubber roller that sticks
===========================

Soft rollers stick: the edges of the strip are held until they release the work of adhesion :math:`\gamma`. With
:math:`w(a)` of the profile, the force per length of a strip of the half-width :math:`a` is

.. math:: P(a) = E^* w(a) - \sqrt{2\pi a E^*\gamma} ,

and for a cylinder (Barquins 1988; Chaudhury and others 1996) :math:`E^* w = \pi E^* a^2/(4R)`.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# Pressure with tension at the edges
# ----------------------------------
# A rubber roller of 5 mm radius rests on a glass plate without any load; it still touches in a strip.

RADIUS, WORK = 5e-3, 50e-3
rubber = wk.HalfSpace.between(wk.Elastic(young=1e6, poisson=0.5))
bed = wk.LineFoundation(wk.Paraboloid(curvature_radius=RADIUS), rubber)
resting = wk.LineAdhesion(bed, wk.ShortRange(WORK), wk.LineForce(0.0)).solve()
print(f"half-width without load: {resting.half_width * 1e6:.1f} um")
assert np.isclose(resting.half_width, (32 * RADIUS**2 * WORK / (np.pi * rubber.modulus)) ** (1 / 3), rtol=1e-12)

draw(resting)

# %%
# Pull-off
# --------
# Pulled, the strip narrows to 0.397 of that before it lets go at once, under
# :math:`P_c = -\frac34\,(4\pi E^*\gamma^2 R)^{1/3}`.

limit = resting.pull_off_force_per_length
print(f"pull-off: {limit:.3f} N/m at a half-width of {resting.pull_off_half_width * 1e6:.1f} um")
assert np.isclose(limit, -0.75 * (4 * np.pi * rubber.modulus * WORK**2 * RADIUS) ** (1 / 3), rtol=1e-12)

# %%
# Waves hold on
# -------------
# Shallow waves along the surface make the strip jump from wave to wave, and hold it a little more firmly.

widths = np.linspace(20e-6, 260e-6, 481)
figure, axes = plt.subplots()
for amplitude in (0.0, 0.1e-6, 0.2e-6):
    profile = bed.profile + wk.Wavy(amplitude=amplitude, wavelength=50e-6) if amplitude else bed.profile
    wavy = wk.LineFoundation(profile, rubber)
    states = wk.LineAdhesion(wavy, wk.ShortRange(WORK), wk.HalfWidth(widths)).solve()
    axes.plot(states.force_per_length, widths * 1e6, label=f"waves of {amplitude * 1e6:.1f} µm")
    firm = wk.LineAdhesion(wavy, wk.ShortRange(WORK), wk.LineForce(0.0)).solve()
    print(f"waves of {amplitude * 1e6:.1f} um: pull-off {firm.pull_off_force_per_length:.3f} N/m")
axes.set(xlabel="force per length [N/m]", ylabel="half-width [µm]")
axes.legend()
plt.show()
