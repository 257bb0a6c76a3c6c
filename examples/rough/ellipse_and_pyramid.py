"""
Not quite round: an ellipse, a pyramid
======================================

Two crossed cylinders touch on an ellipse; Hertz's solution is exact, and one ball is as deep under the same forces. A
pyramid has edges: the contour that makes the force greatest is nearly that of the contact.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

steel = wk.HalfSpace.between(wk.Elastic(young=210e9, poisson=0.3), wk.Elastic(young=210e9, poisson=0.3))

# %%
# Hertz's ellipse
# ---------------

bodies = wk.CurvedBodies(20e-3, 10e-3)
crossed = wk.EllipticIndentation(bodies, steel, wk.Force(100.0)).solve()
print(
    f"{crossed.longitudinal_semi_axis * 1e6:.0f} x {crossed.lateral_semi_axis * 1e6:.0f} um, "
    f"peak pressure {crossed.peak_pressure / 1e9:.2f} GPa; like a ball of {crossed.equivalent_radius * 1e3:.1f} mm"
)

# %%
# A pyramid
# ---------
# Its profile differs from direction to direction: across the faces it is that of a steep cone, along the edges it is
# flatter. Sixty-four directions are enough.

angles = np.arange(64) * 2.0 * np.pi / 64
slopes = np.tan(np.radians(22.0)) * np.cos((angles + np.pi / 4) % (np.pi / 2) - np.pi / 4)
faces = [wk.Cone(half_angle=np.pi / 2 - np.arctan(slope)) for slope in slopes]
silica = wk.HalfSpace.between(wk.Elastic(young=72e9, poisson=0.17))
pyramid = wk.NearlyRoundIndentation(faces, silica, wk.Depth(1e-6)).solve()
print(f"a pyramid 1 um deep bears {float(pyramid.force) * 1e3:.0f} mN")

figure, (left, right) = plt.subplots(1, 2, figsize=(8.6, 4.2), layout="constrained")
turn = np.linspace(0.0, 2.0 * np.pi, 200)
left.plot(
    crossed.longitudinal_semi_axis * np.cos(turn) * 1e6,
    crossed.lateral_semi_axis * np.sin(turn) * 1e6,
    color="tab:blue",
)
left.set(xlabel="x [µm]", ylabel="y [µm]", aspect="equal", title="crossed bodies under 100 N")
round_about = np.append(np.arange(64), 0)
edge = pyramid.contour[round_about] * 1e6
right.plot(edge * np.cos(angles[round_about]), edge * np.sin(angles[round_about]), color="tab:orange")
right.set(xlabel="x [µm]", ylabel="y [µm]", aspect="equal", title="a pyramid 1 µm deep")
plt.show()
