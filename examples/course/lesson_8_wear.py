r"""
Lesson 8: what fretting leaves
==============================

*Before:* lessons 1 to 3. *Afterwards* you know the last shape of a body that frets, without a law of wear.

A ball is pressed to a depth and moved to and fro by little. Springs inside the stick zone never slide, so nothing
wears there. Outside all slides, and wears until it bears nothing. The springs tell where: the stick zone ends where
the pull of a spring, :math:`G^* u`, reaches its bound, :math:`\mu E^* (d - g(c))`. It stays there, as nothing inside
changes.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# The last row
# ------------
# Steel on steel, 10 mm, pressed by 2 µm and moved by 0.3 µm. Within :math:`c` the plane profile is the old one; between
# :math:`c` and the edge it is :math:`d`, and bears nothing.

RADIUS, DEPTH, SHIFT, FRICTION = 10e-3, 2e-6, 0.3e-6, 0.3
steel = wk.Elastic(young=210e9, poisson=0.3)
ball = wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace.between(steel, steel))
normal, shear = 210e9 / (2.0 * 0.91), 2.0 * 210e9 / 2.6 / 1.7
stick = np.sqrt(RADIUS * (DEPTH - shear * SHIFT / (FRICTION * normal)))
x = (np.arange(4000) + 0.5) / 4000 * stick
core = 2.0 * normal * float(np.sum(DEPTH - x**2 / RADIUS)) * stick / 4000
before = 4.0 / 3.0 * normal * np.sqrt(RADIUS * DEPTH**3)
print(f"the stick zone ends at {1e6 * stick:.2f} um; the force falls from {before:.2f} to {core:.2f} N")

limit = wk.LimitingProfile(ball, wk.Coulomb(FRICTION), wk.Depth(DEPTH), wk.Shift(SHIFT)).solve()
print(f"winkler: {1e6 * limit.stick_radius:.2f} um, {limit.force:.2f} N")
assert abs(stick / limit.stick_radius - 1.0) < 1e-9
assert abs(core / limit.force - 1.0) < 1e-6

# %%
# The last shape
# --------------
# The rule of lesson 1, backwards, brings the shape back: :math:`f(r) = \frac{2}{\pi}\int_0^r g(x)/\sqrt{r^2 - x^2}\,
# \mathrm{d}x`.


def shape(g, r):
    """Return f [m] at the radii r [m] of a body with the plane profile g."""
    angle = (np.arange(4000) + 0.5) * 0.5 * np.pi / 4000
    return g(r[:, np.newaxis] * np.sin(angle)).mean(axis=1)


r = np.linspace(0.0, 160e-6, 161)
edge = float(limit.radius)
worn = shape(lambda x: np.where(x < stick, x**2 / RADIUS, np.maximum(DEPTH, x**2 / RADIUS)), r)
inside = r < stick
assert np.allclose(worn[inside], r[inside] ** 2 / (2.0 * RADIUS), atol=1e-12)

figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
axes.plot(1e6 * r, 1e6 * r**2 / (2.0 * RADIUS), "0.6", label="new")
axes.plot(1e6 * r[r <= edge], 1e6 * worn[r <= edge], "C3", label="fretted to the end")
axes.axvline(1e6 * stick, color="C0", linestyle=":", label="end of the stick zone")
axes.set(xlabel="r [µm]", ylabel="height [µm]", title="What fretting leaves of a ball")
axes.legend(frameon=False)

# %%
# Exercise
# --------
# The core bears all that is left. Is its pressure at the end of the stick zone finite? Use the rule of lesson 2 with
# the row that you have now, and go near.
#
# Solution
# --------
# No. The row ends in a step there: like at the edge of a flat punch the pressure grows like
# :math:`1/\sqrt{c^2 - r^2}`. Such an edge yields, or cracks: fretting fatigue begins here.

near = stick * (1.0 - np.array([1e-2, 1e-3, 1e-4]))
jump = normal * (DEPTH - stick**2 / RADIUS)
pressure = 2.0 * normal / (np.pi * RADIUS) * np.sqrt(stick**2 - near**2) + jump / (np.pi * np.sqrt(stick**2 - near**2))
for place, found in zip(near, pressure, strict=True):
    print(f"{1e6 * (stick - place):7.4f} um before the end: {found / 1e9:7.3f} GPa")
assert abs(pressure[2] / pressure[1] / np.sqrt(10.0) - 1.0) < 0.05
plt.show()
