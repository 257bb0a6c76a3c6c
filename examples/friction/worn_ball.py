r"""
A worn ball frets
=================

A ball on a plate is pushed to and fro. Wear has flattened it, and its contact is no contact of Hertz any more: the flat
sticks, the ring around it rubs. Boundary elements find where, on a grid of pixels, with Coulomb's law in each of them:

.. math:: |\tau| \le \mu p, \qquad \tau\cdot s = \mu p\,|s|.

What friction loses by place says where wear goes on.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# New and worn
# ------------
# Steel under 100 N; the shift goes to 1 µm on either side.

steel = wk.Elastic(young=210e9, poisson=0.3)
pair = wk.HalfSpace.between(steel, steel)
fretting = wk.Program([wk.Start(wk.Force(100.0)), wk.Oscillate(lateral=wk.Shift(1e-6), cycles=1.25, count=8)])
shapes = {
    "new": wk.Paraboloid(curvature_radius=10e-3),
    "flat of 0.1 mm": wk.TruncatedParaboloid(curvature_radius=10e-3, flat_radius=0.1e-3),
    "flat of 0.15 mm": wk.TruncatedParaboloid(curvature_radius=10e-3, flat_radius=0.15e-3),
}
SIDE, PIXELS = 0.6e-3, 81
solved = {}
for name, shape in shapes.items():
    grid = wk.SampledProfile([SIDE, SIDE], shape, (PIXELS, PIXELS))
    solved[name] = wk.SurfaceTangential(grid, pair, wk.Coulomb(0.6), fretting).solve()
    last = solved[name]
    print(f"{name}: {100 * last.stick_share[-1]:.0f} % sticks at the end, lost {last.dissipation[-1] * 1e6:.2f} uJ")

draw(solved["flat of 0.1 mm"])

# %%
# A ball has a reference
# ----------------------
# Springs of bodies of revolution take slip to be parallel to the force; with Poisson's ratio it is nearly so.

springs = wk.Tangential(wk.Foundation(shapes["new"], pair), wk.Coulomb(0.6), fretting).solve()
apart = np.max(np.abs(solved["new"].shear_force[:, 0] - springs.shear_force)) / np.max(springs.shear_force)
print(f"pixels and springs differ by at most {100 * apart:.2f} % of the shear force")
assert apart < 2e-3

# %%
# Where it wears
# --------------
# The loss per area through the middle, along the motion.

x = (np.arange(PIXELS) - PIXELS // 2) * SIDE / PIXELS
figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
for name, solution in solved.items():
    axes.plot(x * 1e3, solution.last.friction_work[:, PIXELS // 2], label=name)
axes.set(xlabel="x [mm]", ylabel="lost [J/m²]", title="loss of the first cycle and a quarter, through the middle")
axes.legend(frameon=False)
plt.show()
