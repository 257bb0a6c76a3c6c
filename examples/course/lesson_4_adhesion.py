r"""
Lesson 4: springs that stick at their ends
==========================================

*Before:* lesson 1. *Afterwards* you can compute pull-off forces of your own shapes.

With adhesion the outermost springs are stretched, not pressed. They let go when they are longer by

.. math:: \Delta l(a) = \sqrt{\frac{2 \pi a w}{E^*}} ,

where :math:`w` is the work of adhesion per area (Heß). So a contact of the radius :math:`a` belongs to the depth
:math:`d = g(a) - \Delta l(a)`. This is the theory of Johnson, Kendall and Roberts, for each body of revolution.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# The curve of a ball
# -------------------
# A rubber ball of 10 mm, :math:`E^*` = 1 MPa, on glass with 50 mJ/m². The row gives depth and force for each radius of
# the contact.

RADIUS, MODULUS, WORK = 10e-3, 1e6, 50e-3
unit = (np.arange(2000) + 0.5) / 2000


def contact(profile, a):
    """Return depth [m] and force [N] of contacts of the radii a [m] under a plane profile g(x)."""
    depth = profile(a) - np.sqrt(2.0 * np.pi * a * WORK / MODULUS)
    under = depth[:, np.newaxis] - profile(a[:, np.newaxis] * unit)
    return depth, 2.0 * MODULUS * under.mean(axis=1) * a


a = np.linspace(0.05e-3, 0.45e-3, 400)
depth, force = contact(lambda x: x**2 / RADIUS, a)
print(f"lowest force {1e3 * force.min():.4f} mN; 3/2 pi w R is {1.5e3 * np.pi * WORK * RADIUS:.4f} mN")
assert abs(force.min() / (-1.5 * np.pi * WORK * RADIUS) - 1.0) < 1e-4

rubber = wk.HalfSpace.between(wk.Elastic(young=0.75e6, poisson=0.5))
pull = wk.PullOff(wk.Foundation(wk.Paraboloid(RADIUS), rubber), wk.ShortRange(WORK)).solve()
print(f"winkler: {1e3 * pull.force:.4f} mN")

figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
axes.plot(1e6 * depth, 1e3 * force, "C0", label="contacts of all radii")
lowest = int(np.argmin(force))
axes.plot(1e6 * depth[lowest], 1e3 * force[lowest], "C3o", label="pulled off under a force")
first = int(np.argmin(depth))
axes.plot(1e6 * depth[first], 1e3 * force[first], "C2s", label="pulled off by a stiff machine")
axes.axhline(0.0, color="0.7", linewidth=0.8)
axes.set(xlabel="depth [µm]", ylabel="force [mN]", title="A sticky ball")
axes.legend(frameon=False)

# %%
# Exercise
# --------
# A flat end of the radius 0.5 mm sticks to the same glass: :math:`g = 0` up to its rim. How large is its pull-off
# force, and which power of the radius does it follow? Kendall found :math:`\sqrt{8 \pi E^* w a^3}`.
#
# Solution
# --------
# The contact does not change until all lets go at once, so there is one radius only. The power is 3/2: small pads stick
# better for their area, which is why a gecko has many.

FLAT = 0.5e-3
_, at_once = contact(np.zeros_like, np.array([FLAT, 2.0 * FLAT]))
kendall = np.sqrt(8.0 * np.pi * MODULUS * WORK * FLAT**3)
print(f"flat end: {-1e3 * at_once[0]:.3f} mN by the springs, {1e3 * kendall:.3f} mN by Kendall")
print(f"twice the radius, {at_once[1] / at_once[0]:.3f} times the force")
assert abs(-at_once[0] / kendall - 1.0) < 1e-12
plt.show()
