r"""
Lesson 3: stick and slip, one spring at a time
==============================================

*Before:* lesson 1. *Afterwards* you can push a pressed ball to and fro, and say what it loses.

Each spring gets a second stiffness, along the surface: :math:`G^* \Delta x`. It holds until its load times the
coefficient of friction is reached; then it slides. That is the whole theory of Cattaneo and Mindlin.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# Push once
# ---------
# Steel on steel, a ball of 10 mm pressed by 4 µm. A spring bears at most :math:`\mu E^* (d - g)`; moved by
# :math:`u`, it pulls with :math:`G^* u`.

RADIUS, DEPTH, FRICTION = 10e-3, 4e-6, 0.3
steel = wk.Elastic(young=210e9, poisson=0.3)
half_space = wk.HalfSpace.between(steel, steel)
ball = wk.Foundation(wk.Paraboloid(RADIUS), half_space)
normal = 210e9 / (2.0 * (1.0 - 0.3**2))  # E* [Pa]
shear = 2.0 * 210e9 / 2.6 / (2.0 - 0.3)  # G* = 2 G / (2 - nu), of two like bodies [Pa]

a = np.sqrt(DEPTH * RADIUS)
x = (np.arange(4000) + 0.5) / 4000 * a  # one half of the row
step = a / 4000
bound = FRICTION * normal * (DEPTH - x**2 / RADIUS)

SHIFT = 1e-6
pulls = np.minimum(shear * SHIFT, bound)
force = 2.0 * pulls.sum() * step
stick = x[pulls < bound].max()
full = FRICTION * 4.0 / 3.0 * normal * np.sqrt(RADIUS * DEPTH**3)
left = 1.0 - shear * SHIFT / (FRICTION * normal * DEPTH)
mindlin = full * (1.0 - left**1.5)
print(f"{force:.4f} N by the springs, {mindlin:.4f} N by Mindlin; what sticks ends at {1e6 * stick:.1f} um")
assert abs(force / mindlin - 1.0) < 1e-4
assert abs(stick / (a * np.sqrt(left)) - 1.0) < 1e-3

# %%
# To and fro
# ----------
# Springs remember. A small step moves the end of each; what would exceed the bound slides, and work is lost.


def swing(path):
    """Return shear force [N] and what was lost so far [J] at all points of a path of shifts [m]."""
    stretch = np.zeros_like(x)
    forces, losses, lost = [0.0], [0.0], 0.0
    for moved in np.diff(path):
        tried = stretch + moved
        stretch = np.clip(tried, -bound / shear, bound / shear)
        lost += 2.0 * float(np.sum(bound * np.abs(tried - stretch))) * step
        forces.append(2.0 * shear * float(stretch.sum()) * step)
        losses.append(lost)
    return np.array(forces), np.array(losses)


turns = np.array([0.0, SHIFT, -SHIFT, SHIFT])
path = np.concatenate([np.linspace(first, last, 201)[:-1] for first, last in zip(turns, turns[1:], strict=False)])
path = np.append(path, SHIFT)
forces, losses = swing(path)
cycle = losses[-1] - losses[200]
damping = wk.FrictionDamping(ball, wk.Coulomb(FRICTION), wk.Depth(DEPTH), wk.Shift(SHIFT)).solve()
print(f"a cycle loses {1e9 * cycle:.3f} nJ by the springs, {1e9 * damping.loss_per_cycle:.3f} nJ by winkler")
assert abs(cycle / damping.loss_per_cycle - 1.0) < 0.01

figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
axes.plot(1e6 * path, forces, "C0")
axes.set(xlabel="shift [µm]", ylabel="shear force [N]", title="A ball that is pushed to and fro")

# %%
# Exercise
# --------
# Small swings lose little. With which power of the amplitude does the loss of a cycle grow? Halve the shift twice.
#
# Solution
# --------
# With the third. A quarter of the shift loses a sixty-fourth: only the outermost springs slide, and only a little.

lost = [
    wk.FrictionDamping(ball, wk.Coulomb(FRICTION), wk.Depth(DEPTH), wk.Shift(SHIFT * part)).solve().loss_per_cycle
    for part in (0.02, 0.01, 0.005)
]
power = np.log2(lost[1] / lost[2])
print(f"the loss grows with the power {power:.3f} of the shift")
assert abs(power - 3.0) < 0.01
plt.show()
