r"""
From the tread to the flange
============================

A wheel that moves sideways on its rail touches it elsewhere, on another part of both profiles: the patch changes its
shape, the pressure its height, and at some position the flange begins to bear. `ProfilePair` places both bodies by
their profiles, finds all patches, and how the wheel slips over the rail on each of them while it rolls.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# Two profiles
# ------------
# One in the format of Simpack, whose z counts downwards, and one as a table. A spline keeps their curvature.

# The manual runs this script in its own folder, without __file__.
HERE = Path(__file__).resolve().parent if "__file__" in globals() else Path.cwd()
rail = wk.read_cross_profile(HERE.parent / "data" / "rail_head.prr", down=True)
wheel = wk.read_cross_profile(HERE.parent / "data" / "wheel_tread.csv")
steel = wk.Elastic(young=210e9, poisson=0.28, strength=700e6)
track = wk.HalfSpace.between(steel, steel)
print(f"radius of the rail's crown: {-1e3 / float(rail.curvature(np.array(0.0))):.0f} mm")

# %%
# Over the lateral position
# -------------------------

positions = np.array([-4e-3, -2e-3, 0.0, 1e-3, 2e-3, 3e-3])
pairs = [
    wk.ProfilePair(rail, wheel, track, wk.Force(80e3), float(y), second_radius=0.46, pixels=64).solve()
    for y in positions
]
for y, pair in zip(positions, pairs, strict=True):
    for patch in pair.patches:
        print(
            f"{y * 1e3:4.0f} mm: {patch.force / 1e3:5.1f} kN at y = {patch.y * 1e3:6.1f} mm, {patch.angle:.3f} rad, "
            f"{patch.peak_pressure / 1e6:5.0f} MPa, spin {patch.creepage.spin:6.3f} 1/m"
        )
assert [len(pair.patches) for pair in pairs] == [1, 1, 1, 1, 1, 2]

# %%
# Two places at once
# ------------------

draw(pairs[-1])

# %%
# Friction on every patch
# -----------------------
# While the wheel rolls, every patch slips by what the rolled radius, the contact angle and the yaw leave. Exact theory
# gives the creep forces; Kalker's simplified theory, on the ellipse that is as long and as wide, is near them where the
# patch is nearly one.

yawed = wk.ProfilePair(rail, wheel, track, wk.Force(80e3), yaw=1e-3, second_radius=0.46, pixels=64)
rolls = wk.ProfilePairRolling(yawed, wk.Coulomb(0.3)).solve()
place = rolls.patches[0].patch
ellipse = wk.ContactEllipse(0.5 * place.longitudinal_length, 0.5 * place.lateral_length)
springs = wk.SimplifiedRolling(
    ellipse, track, wk.Coulomb(0.3), rolls.patches[0].creepage, wk.Force(place.force)
).solve()
print(f"lateral creepage {rolls.lateral_creepage[0]:.2e}: {rolls.lateral_force[0] / 1e3:.1f} kN")
print(f"simplified theory: {springs.lateral_force / 1e3:.1f} kN")
assert abs(rolls.lateral_force[0] / springs.lateral_force - 1.0) < 0.2

on_two = wk.ProfilePairRolling(pairs[-1].problem, wk.Coulomb(0.3)).solve()
print(f"on tread and flange friction takes {on_two.loss_per_distance:.0f} J/m")
draw(on_two)
plt.show()
