r"""
Lesson 6: springs that relax
============================

*Before:* lesson 1. *Afterwards* you can press rubber, and let it go.

In a solid that relaxes each spring is a small rheometer. If Poisson's ratio does not change, its force follows its
own shortening :math:`u` alone, by the relaxation function :math:`G(t)` of the solid. What lies beside it does not
matter: that is why the method holds while the contact grows and, unlike the closed form of Lee and Radok, while it
shrinks.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# A row of rheometers
# -------------------
# An incompressible standard solid: 1 MPa when relaxed, 3 MPa more at first, with a relaxation time of 1 s. A ball is
# pressed in by 0.1 mm within 1 s and drawn back as fast. :math:`E^* = 4 G`.

RADIUS, DEPTH, RELAXED, FAST, TIME = 10e-3, 0.1e-3, 1e6, 3e6, 1.0
x = (np.arange(400) + 0.5) / 400 * np.sqrt(RADIUS * DEPTH)  # one half of the row
step = x[1] - x[0]
times = np.linspace(0.0, 2.0, 2001)
depth = DEPTH * (1.0 - np.abs(1.0 - times))


def march(times, depth):
    """Return the forces [N] at all times [s] of a ball that follows depths [m]."""
    quick, shortened = np.zeros_like(x), np.zeros_like(x)  # force of the fast part [N/m^2], and u [m]
    forces = []
    for k in range(times.size):
        pressed = depth[k] - x**2 / RADIUS
        passed = times[k] - times[k - 1] if k else 0.0
        decay = np.exp(-passed / TIME)
        grown = TIME / passed * (1.0 - decay) if passed else 1.0  # exact for a constant rate
        tried = decay * quick + 4.0 * FAST * grown * (pressed - shortened)
        load = 4.0 * RELAXED * pressed + tried
        free = load <= 0.0
        # a spring that is free bears nothing: its own relaxation pushes it back
        back = (4.0 * FAST * grown * shortened - decay * quick) / (4.0 * (RELAXED + FAST * grown))
        shortened = np.where(free, np.maximum(back, 0.0), pressed)
        quick = np.where(free, -4.0 * RELAXED * shortened, tried)
        forces.append(2.0 * float(np.sum(np.where(free, 0.0, load))) * step)
    return np.array(forces)


forces = march(times, depth)
rubber = wk.ViscoelasticHalfSpace(wk.StandardSolid(relaxed_shear=RELAXED, shear=FAST, relaxation_time=TIME))
ball = wk.Foundation(wk.Paraboloid(RADIUS), rubber)
solution = wk.ViscoelasticIndentation(ball, wk.Path(times[::20], wk.Depth(depth[::20]))).solve()
peak, found = forces.max(), solution.force.max()
print(f"greatest force {peak:.4f} N by hand, {found:.4f} N by winkler")
assert abs(peak / found - 1.0) < 5e-3
assert np.allclose(forces[::20], solution.force, atol=0.01 * peak)
ends = times[np.flatnonzero(forces > 0.0)[-1]]
print(f"the contact is lost at {ends:.3f} s, {1e6 * np.interp(ends, times, depth):.1f} um before the way back ends")

# %%
# Exercise
# --------
# Which part of the work of pressing is lost in this loop? And what happens if the whole takes ten times, or a tenth, of
# the time?
#
# Solution
# --------
# The area of the loop over the work of the way in. Very slow and very fast loops lose little: the solid is elastic
# there, with 1 or with 4 MPa. Between them lies a speed that loses most.

figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
for slower, colour in ((0.005, "C0"), (1.0, "C3"), (500.0, "C2")):
    taken = march(slower * times, depth)
    work = np.trapezoid(taken[:1001], depth[:1001])
    lost = np.trapezoid(taken, depth) / work
    print(f"within {2.0 * slower:7.2f} s: {lost:.1%} lost")
    axes.plot(1e6 * depth, taken, colour, label=f"{2.0 * slower:g} s")
axes.set(xlabel="depth [µm]", ylabel="force [N]", title="A ball in rubber, pressed and drawn back")
axes.legend(frameon=False, title="within")
plt.show()
