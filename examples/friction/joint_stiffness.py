"""
How stiff is a bolted joint?
============================

Two blasted steel faces are pressed together. The joint gives way across and along, and pushed to and fro it loses
energy by slip at the rims of its spots. One part of the faces, repeated for ever, tells stiffness and loss per area: by
boundary elements with friction, and by springs that know the stiffness without slip alone.
"""

import numpy as np

import winkler as wk
from winkler.plot import draw

steel = wk.Elastic(young=210e9, poisson=0.3)
pair = wk.HalfSpace.between(steel, steel)

# %%
# The faces
# ---------
# Half a millimetre of them, with waves from 30 to 250 µm.

blasted = wk.SelfAffine(hurst=0.8, rms_height=0.5e-6, longest=250e-6, shortest=30e-6)
face = wk.RandomTopography([0.5e-3, 0.5e-3], blasted, (64, 64), seed=4)

# %%
# Stiffness and damping
# ---------------------
# Mindlin's ratio of a disc, 2 (1 - nu) / (2 - nu) = 0.824, holds within some per cent, more along one direction than
# along the other.

joint = wk.JointStiffness(face, pair, wk.Coulomb(0.3), wk.Force(np.geomspace(1.0, 40.0, 5))).solve()
for i, pressure in enumerate(joint.nominal_pressure):
    print(
        f"{pressure * 1e-6:4.0f} MPa: {joint.areal_stiffness[i] * 1e-12:5.0f} N/um per mm^2 across, "
        f"{joint.areal_stiffness_x[i] * 1e-12:5.0f} along x, ratios {joint.ratio_x[i]:.3f} and {joint.ratio_y[i]:.3f}"
    )
picture = draw(joint)

# %%
# Without Poisson's ratio
# -----------------------
# Then a joint is as stiff along as across, whatever its map.

even = wk.Elastic(young=210e9, poisson=0.0)
alike = wk.JointStiffness(face, wk.HalfSpace.between(even, even), wk.Coulomb(0.3), wk.Force(10.0), share=[0.5]).solve()
print(f"ratios without Poisson's ratio: {alike.ratio_x:.5f} and {alike.ratio_y:.5f}")
assert abs(alike.ratio_x - 1.0) < 1e-4
