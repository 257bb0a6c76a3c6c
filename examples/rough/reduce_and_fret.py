"""
Springs in place of a surface
=============================

Boundary elements solve one contact at a time. What needs no more than forces and depths can do with springs: a
dozen contacts give the force curve F(d) of an arbitrary body, its slope gives the stiffness, and the springs that have
both run any history of pressing and rubbing without another solve.
"""

import time

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

steel = wk.HalfSpace.between(wk.Elastic(young=210e9, poisson=0.3), wk.Elastic(young=210e9, poisson=0.3))

# %%
# A body that is none of revolution
# ---------------------------------
# A barrel, 10 mm round in one direction and 30 mm in the other, with the waves of a worn tool on it.

pixels, side = 128, 0.6e-3
place = (np.arange(pixels) + 0.5) / pixels * side - side / 2
x, y = place[:, None], place[None, :]
heights = -(x**2) / (2 * 10e-3) - y**2 / (2 * 30e-3) + 20e-9 * np.cos(2 * np.pi * x / 60e-6)
barrel = wk.Topography(heights, [side, side])

begun = time.perf_counter()
bed = wk.ReducedBed(barrel, steel, depth=2e-6)
print(f"{bed.radii.size} springs from boundary elements in {time.perf_counter() - begun:.1f} s")
picture = draw(wk.Reduction(barrel, steel, 2e-6).solve())

# %%
# Rubbed
# ------
# A thousand steps of fretting under a force that swings, too.

begun = time.perf_counter()
turn = np.linspace(0.0, 4.0 * np.pi, 1000)
path = wk.Path(turn, wk.Force(35.0 + 15.0 * np.sin(0.5 * turn)), wk.Shift(0.4e-6 * np.sin(2.0 * turn)))
rubbed = wk.Tangential(bed, wk.Coulomb(0.3), path).solve()
print(f"a thousand steps in {time.perf_counter() - begun:.1f} s")

figure, axes = plt.subplots(figsize=(5.6, 4.0), layout="constrained")
axes.plot(rubbed.shift * 1e6, rubbed.shear_force)
axes.set(xlabel="shift [µm]", ylabel="shear force [N]", title="a wavy barrel, rubbed under a swinging force")
plt.show()

# %%
# Check
# -----
# The springs bear what the boundary elements find, also between the contacts from which they were made.

depth = 1.3e-6
springs = wk.Indentation(bed, wk.Depth(depth)).solve().force
reference = wk.SurfaceContact(barrel, steel, wk.Depth(depth)).solve().force
print(f"at {depth * 1e6:.1f} um: springs {springs:.3f} N, boundary elements {reference:.3f} N")
assert abs(springs / reference - 1.0) < 5e-3
