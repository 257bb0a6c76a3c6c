"""
A measured tip: from points with scatter to force and stress
============================================================

The tip of your probe is what your microscope says it is, and not a ball of 120 nm. winkler takes the points as they
come: a scan across the apex, with scatter, with an arbitrary zero.

The points of this example are made, not measured: a ball of 120 nm with a tangent cone of 35 degrees, a scatter of
0.2 nm in height, an apex 3.7 nm beside the zero of the scan. So the true answer is known, and one can see what scatter
costs.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.reference.rounded import sphero_conical_depth, sphero_conical_force

# The manual runs this script in its own folder, without __file__.
HERE = Path(__file__).resolve().parent if "__file__" in globals() else Path.cwd()
TRUE = {"curvature_radius": 120e-9, "half_angle": np.radians(35.0)}

# %%
# Read it
# -------
# The header of the file names columns and units, ``x [nm], height [nm]``. Negative x tell that the scan crosses the
# apex; it is found, and both flanks are folded onto one another. Which curve stands for the points is decided by
# cross-validation: as many pieces of a cubic spline as predict left-out points best. The notes say what was chosen.

tip = wk.read_profile(HERE.parent / "data" / "measured_tip.csv")
for note in tip.notes:
    print(note)

# %%
# The curve and its transform
# ---------------------------
# An elastic solid does not care for single points. The equivalent profile :math:`g(x)` is an integral over the
# slope, and the force an integral over g; each of them smooths once more. What shows the scatter longest is the
# slope of g, of which the pressure is made (right): the fine kink where the ball goes over into the cone is lost in
# it.

r = np.linspace(0.0, tip.reach, 400)
ideal = wk.SpheroConical(**TRUE)

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(11.5, 3.7), layout="constrained")
above = np.array(tip.heights) - tip.curve.evaluate(np.zeros(1))[0]
left.plot(r * 1e9, tip.height(r) * 1e9, "C0", label="chosen curve f(r)")
left.plot(
    tip.radii[::8] * 1e9, above[::8] * 1e9, "o", color="0.3", fillstyle="none", markersize=4, label="points (some)"
)
left.plot(r * 1e9, tip.gap(r) * 1e9, "C1", label="equivalent profile g(x)")
left.set(xlabel="r or x [nm]", ylabel="height [nm]", xlim=(0, 150), ylim=(-2, None), title="what was measured")
left.legend(frameon=False)

middle.plot(
    tip.radii * 1e9, (above - tip.height(np.array(tip.radii))) * 1e9, ".", color="0.6", markersize=3, label="points"
)
middle.plot(r * 1e9, (ideal.height(r) - tip.height(r)) * 1e9, "C2", label="true shape")
middle.axhline(0.0, color="C0", label="curve")
middle.set(
    xlabel="r [nm]", ylabel="above the curve [nm]", xlim=(0, 150), ylim=(-0.8, 1.5), title="scatter about the curve"
)
middle.legend(frameon=False, loc="upper right")

right.plot(r * 1e9, tip.gap_slope(r), "C1", label="measured")
right.plot(r * 1e9, ideal.gap_slope(r), "k--", linewidth=1, label="true")
right.set(
    xlabel="x [nm]", ylabel="slope of g [-]", xlim=(0, 150), ylim=(0, None), title="the slope that makes the pressure"
)
right.legend(frameon=False)
plt.show()

# %%
# Press it in
# -----------
# Into a soft polymer, to 60 nm. The force of the true shape follows from its closed solution.

polymer = wk.HalfSpace.between(wk.Elastic(young=50e6, poisson=0.45))
bed = wk.Foundation(tip, polymer)
depth = np.linspace(0.0, 60e-9, 121)
curve = wk.Indentation(bed, wk.Depth(depth)).solve()

radius = np.linspace(0.0, 150e-9, 4001)
true_force = np.interp(
    depth, sphero_conical_depth(radius, **TRUE), sphero_conical_force(radius, modulus=polymer.modulus, **TRUE)
)
error = curve.force[1:] / true_force[1:] - 1.0

contact = curve.at(-1)
print(f"\nF(60 nm) = {contact.force * 1e9:.3f} nN, contact radius {contact.radius * 1e9:.2f} nm")
print(f"the true shape has {true_force[-1] * 1e9:.3f} nN: {100 * error[-1]:+.2f} %")
print(f"largest deviation beyond 5 nm depth: {100 * np.abs(error[depth[1:] >= 5e-9]).max():.1f} %")
assert abs(error[-1]) < 0.01
assert np.abs(error[depth[1:] >= 5e-9]).max() < 0.05

# %%
# Pressure and stress
# -------------------
# The field below the contact comes from the same springs. What the validity says must be read: the flanks of this tip
# are steep, and a linear theory of small slopes cannot promise its usual accuracy.

fields = wk.restore(contact, r[r < 1.5 * contact.radius])
grid = np.linspace(-1.6, 1.6, 161) * contact.radius, np.linspace(0.0, 1.8, 91) * contact.radius
x, z = np.meshgrid(*grid)
stress = wk.restore(contact, np.abs(x), z).von_mises

figure, (left, middle, right) = plt.subplots(
    1, 3, figsize=(11.5, 3.9), layout="constrained", width_ratios=(1.0, 1.0, 1.25)
)
left.plot(depth * 1e9, curve.force * 1e9, "C0", label="measured tip")
left.plot(depth[::8] * 1e9, true_force[::8] * 1e9, "ko", fillstyle="none", label="true shape, closed form")
hertz = 4 / 3 * polymer.modulus * np.sqrt(TRUE["curvature_radius"] * depth**3)
left.plot(depth * 1e9, hertz * 1e9, ":", color="0.4", label="ball of 120 nm, Hertz")
left.set(xlabel="depth d [nm]", ylabel="force F [nN]", xlim=(0, 60), ylim=(0, None), title="force and depth")
left.legend(frameon=False)

middle.plot(fields.r * 1e9, fields.pressure / 1e6)
middle.set(xlabel="r [nm]", ylabel="pressure p [MPa]", xlim=(0, None), ylim=(0, None), title="pressure at 60 nm depth")

image = right.contourf(x * 1e9, z * 1e9, stress / 1e6, levels=12, cmap="viridis")
right.plot([-contact.radius * 1e9, contact.radius * 1e9], [0, 0], "C3", linewidth=4, clip_on=False)
right.set(xlabel="r [nm]", ylabel="z [nm]", aspect="equal", title="below the tip; red: contact")
right.invert_yaxis()
figure.colorbar(image, ax=right, location="bottom", shrink=0.9, label="von Mises stress [MPa]")
plt.show()

print()
for note in contact.validity:
    print(note)
