"""
How fine must a map be?
=======================

The same rough surface with more and more of its waves, on finer and finer pixels, under one force: the depth hardly
changes, the true area falls. A contact on 768 x 768 pixels takes a second or two; the log tells what a large map takes,
and how far it is.
"""

import logging

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

logging.basicConfig(level=logging.INFO, format="%(message)s")

glass = wk.HalfSpace.between(wk.Elastic(70e9, 0.22), wk.Elastic(70e9, 0.22))
side, pixels = 1e-3, 768
fine = wk.random_topography(
    wk.SelfAffine(hurst=0.8, rms_height=0.5e-6, longest=side / 2, shortest=side / 128),
    (pixels, pixels),
    (side, side),
    seed=2,
)

# %%
# Pixels are joined to coarser ones, which lose the short waves.

blocks = np.array([12, 6, 3, 2, 1])
areas, errors, depths = [], [], []
for times in blocks.tolist():
    contact = wk.SurfaceContact(fine.coarsened(times) if times > 1 else fine, glass, wk.Force(20.0)).solve()
    areas.append(contact.area / side**2)
    errors.append(contact.area_error / side**2)
    depths.append(contact.depth)
    print(
        f"{pixels // times:4d} x {pixels // times}: {contact.area / side**2:.2%} +- {contact.area_error / side**2:.2%} "
        f"touches, {contact.depth * 1e6:.2f} um deep, overlap {contact.penetration:.0e} of it"
    )

# %%
# The error bars are those of pixels along the edges of the contact; what a coarse map does not hold they cannot know.

figure, axes = plt.subplots(figsize=(5, 3.5), layout="constrained")
axes.errorbar(side / pixels * blocks * 1e6, np.array(areas) * 100, np.array(errors) * 100, marker="o", capsize=3)
axes.set(xlabel="pixel / µm", ylabel="true area / % of the map", xlim=(0, None), ylim=(0, None))
plt.show()
