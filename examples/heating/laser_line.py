r"""
A line of laser light
=====================

A line of light, even over its width :math:`2b`, hardens a steel surface that passes below it at the speed V. How warm
does the surface get? The slower it passes, the deeper the heat goes; if it passes fast, the heat only goes straight
down, and the greatest rise is Jaeger's

.. math:: T = \frac{2q}{\lambda}\sqrt{\frac{2b\,\kappa}{\pi V}} .
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

steel = wk.ThermalConductor(conductivity=30.0, diffusivity=7e-6)
pair = wk.HeatConductors(steel, steel)


def under_light(speed):
    """Return the rise of temperature of a surface that takes all of the heat: 20 W/mm^2 over 2 mm."""
    return wk.BandHeating(1e-3, 20e6, pair, first_speed=speed, second_speed=0.0, partition=wk.FixedShare(1.0)).solve()


# %%
# At 20 mm/s the warmest place lies behind the middle.

passing = under_light(20e-3)
print(f"{passing.first_max_temperature:.0f} K, Peclet number {passing.first_peclet:.2f}")
draw(passing)

# %%
# Over the speed
# --------------

speeds = np.geomspace(5e-3, 0.5, 25)
swept = under_light(speeds)
fast = 2.0 * 20e6 / 30.0 * np.sqrt(2e-3 * 7e-6 / (np.pi * speeds))
assert np.isclose(swept.first_max_temperature[-1], fast[-1], rtol=2e-2)
figure, axes = plt.subplots(figsize=(6.0, 4.0), layout="constrained")
axes.loglog(speeds * 1e3, swept.first_max_temperature, label="greatest rise")
axes.loglog(speeds * 1e3, fast, "--", label="fast limit (Jaeger)")
axes.axhline(1450.0, color="0.6", lw=0.8)
axes.text(speeds[-1] * 1e3, 1480.0, "steel melts", ha="right", color="0.4")
axes.set(xlabel="speed [mm/s]", ylabel="rise of temperature [K]", title="steel, 20 W/mm² over 2 mm")
axes.legend(frameon=False)
plt.show()
