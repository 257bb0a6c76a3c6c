"""
Springs under friction, and their error
=======================================

A machined face is rough along one direction and smooth along the other: where it touches, the contact is long, and
yields more to a push along it than across. Springs from a few dozen normal contacts know both stiffnesses. Boundary
elements with friction run through one loop along each direction and state how far the springs are off; from then on
histories cost the springs alone.
"""

import time

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

steel = wk.Elastic(young=210e9, poisson=0.3)
pair = wk.HalfSpace.between(steel, steel)
friction = wk.Coulomb(0.3)

# %%
# A turned tip
# ------------
# A crowned tip, 10 mm and 20 mm round, with the ridges of a tool 75 µm apart.

pixels, side = 96, 0.45e-3
place = (np.arange(pixels) + 0.5) / pixels * side - side / 2
x, y = place[:, None], place[None, :]
tip = wk.Topography(-(x**2) / 40e-3 - y**2 / 20e-3 + 0.1e-6 * np.cos(2 * np.pi * y / 75e-6), [side, side])

# %%
# Both loops, by springs and by elements
# --------------------------------------
# The title states the greatest differences.

begun = time.perf_counter()
found = wk.ReducedFriction(tip, pair, friction, depth=0.8e-6).solve()
print(f"springs and their error in {time.perf_counter() - begun:.1f} s")
bed = found.bed
print(f"stiffness along the surface over k: {bed.ratios_along[-1]:.3f} along x, {bed.ratios_across[-1]:.3f} along y")
print(f"shifts within {100 * found.shift_error:.1f} %, losses within {100 * found.loss_error:.1f} % of the elements")
picture = draw(found)

# %%
# A history on springs
# --------------------
# Two tones of vibration, two thousand steps, along x and along y under the same force.

turn = np.linspace(0.0, 40.0, 2000)
shear = 0.8 * friction.coefficient * found.force * (0.6 * np.sin(turn) + 0.4 * np.sin(2.9 * turn))
path = wk.Path(turn, wk.Depth(0.8e-6), wk.ShearForce(shear))
figure, axes = plt.subplots(figsize=(6.0, 4.2), layout="constrained")
lost = {}
wk.Tangential(bed, friction, path, wk.Method.SPRINGS, 300).solve()  # compiles at its first use
for name, springs in {"x": bed, "y": bed.turned}.items():
    begun = time.perf_counter()
    shaken = wk.Tangential(springs, friction, path, wk.Method.SPRINGS, 300).solve()
    print(f"along {name}: {turn.size} steps in {1e3 * (time.perf_counter() - begun):.0f} ms")
    axes.plot(shaken.shift * 1e9, shaken.shear_force, linewidth=0.8, label=f"along {name}")
    lost[name] = float(shaken.dissipation[-1])
axes.set(xlabel="shift [nm]", ylabel="shear force [N]", title="two tones of vibration on springs of a turned tip")
axes.legend(frameon=False)
plt.show()
print(f"lost: {lost['x'] * 1e6:.2f} uJ along x, {lost['y'] * 1e6:.2f} uJ along y")

# %%
# Check
# -----
# Boundary elements at the greatest force of that history.

most = float(np.max(shear))
pushed = wk.SurfaceTangential(
    tip, pair, friction, wk.Path.through(wk.Depth(0.8e-6), wk.ShearForce([0.0, most]))
).solve()
sprung = wk.Tangential(bed, friction, wk.Path.through(wk.Depth(0.8e-6), wk.ShearForce([0.0, most]))).solve()
print(f"at {most:.1f} N: springs {sprung.shift[-1] * 1e9:.2f} nm, boundary elements {pushed.shift[-1, 0] * 1e9:.2f} nm")
assert abs(sprung.shift[-1] - pushed.shift[-1, 0]) < found.shift_error * np.max(found.shift[:, 0])
