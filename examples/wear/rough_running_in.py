"""
A rough surface runs in
=======================

A blasted surface slides on a flat. Its peaks bear nearly all, and lose nearly all: Archard's law in every pixel, with
the pressures of the worn surface by boundary elements. What happens to its area of contact, its pressures and its
roughness numbers?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

steel = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
blasted = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=0.5e-3, shortest=125e-6)
surface = wk.RandomTopography([1e-3, 1e-3], blasted, (48, 48), seed=2)
contact = wk.SurfaceContact(surface, steel, wk.Force(50.0))

# %%
# Steps are as long as an error of 0.3 per cent of the worn depth allows. What is lost is the rate times force and
# distance, to rounding.

wear = wk.Archard(rate=1e-14)  # 1e-5 mm^3/(N m)
running = wk.SurfaceWear(contact, wear, np.array([0.0, 1e-3, 1e-2, 3e-2, 0.1, 0.3]), tolerance=3e-3)
worn = running.solve()
for i, distance in enumerate(worn.distance):
    print(
        f"{distance * 1e3:4.0f} mm: {worn.area[i] / surface.area:5.1%} touches, "
        f"up to {worn.peak_pressure[i] / 1e6:4.0f} MPa; Sq {worn.rms_height[i] * 1e6:.2f} um, "
        f"Ssk {worn.skewness[i]:+.2f}, {worn.worn_volume[i] * 1e18:7.0f} um^3 lost (balance {worn.imbalance[i]:.0e})"
    )
draw(worn)

# %%
# It can go on from where it stopped, and the worn surface is a height map like any other: pressed again, with the same
# force, it touches where it did.

farther = wk.SurfaceWear(contact, wear, [0.3, 0.5], tolerance=3e-3)
*_, last = farther.steps(start=worn.last)
print(f"after {last.distance} m {last.area / surface.area:.0%} touches")
again = wk.SurfaceContact(worn.worn_topography(), steel, wk.Force(50.0)).solve()
print(f"pressed again: {again.area / surface.area:.1%}, up to {np.max(again.last.pressure) / 1e6:.0f} MPa")

plt.show()
