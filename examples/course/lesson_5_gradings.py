r"""
Lesson 5: another solid, another k(a)
=====================================

*Before:* lesson 1. *Afterwards* you can exchange the solid and keep the method.

Soils, bones and sintered ceramics stiffen with depth. Where Young's modulus follows a power,
:math:`E(z) = E_0 (z/z_0)^k`, the method stays exact (Heß). Flat punches then have stiffnesses :math:`k(a)` that
follow the power :math:`1 + k`, so the springs are stiffer outside, like :math:`|x|^k`. The rule of the profile
changes with them:

.. math:: g(x) = |x|^{1-k} \int_0^{|x|} \frac{f'(r)}{(x^2 - r^2)^{(1-k)/2}} \,\mathrm{d}r .
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# One measured punch is enough
# ----------------------------
# The constant of the springs comes from one punch. Here winkler plays the laboratory, with a punch of 0.1 mm.

RADIUS, EXPONENT, PUNCH = 5e-3, 0.3, 0.1e-3
soil = wk.PowerLawGraded(young=10e9, depth_scale=1e-3, exponent=EXPONENT, poisson=0.25)
graded = wk.GradedHalfSpace.between(soil)
ball = wk.Foundation(wk.Paraboloid(RADIUS), graded)
measured = float(ball.stiffness(np.array([PUNCH]))[0])  # k of the flat punch [N/m]
constant = measured * (1.0 + EXPONENT) / (2.0 * PUNCH ** (1.0 + EXPONENT))
print(f"a punch of 0.1 mm: {measured / 1e6:.4f} N/um; springs {constant:.4g} |x|^{EXPONENT:g} N/m per metre")

# %%
# The profile, and the force
# --------------------------
# Put :math:`r = x \sin\varphi` as before. A paraboloid becomes :math:`x^2 / (R (1 + k))`.

middles = (np.arange(4000) + 0.5) * 0.5 * np.pi / 4000


def plane_profile(slope, x):
    """Return g [m] of a body with the slope f'(r), at the places x [m]."""
    r = np.abs(x)[:, np.newaxis] * np.sin(middles)
    return np.abs(x) * (slope(r) * np.cos(middles) ** EXPONENT).mean(axis=1) * 0.5 * np.pi


def pressed(slope, radius, count=1000):
    """Return depth [m] and force [N] of a contact of a radius [m]."""
    x = (np.arange(count) + 0.5) / count * radius
    depth = float(plane_profile(slope, np.array([radius]))[0])
    springs = constant * x**EXPONENT * (depth - plane_profile(slope, x))
    return depth, 2.0 * float(springs.sum()) * radius / count


contact = 0.15e-3
depth, force = pressed(lambda r: r / RADIUS, contact)
assert abs(depth * RADIUS * (1.0 + EXPONENT) / contact**2 - 1.0) < 1e-4
solution = wk.Indentation(ball, wk.Depth(depth)).solve()
print(f"by hand {force:.4f} N at {1e6 * depth:.3f} um, winkler {solution.force:.4f} N")
assert abs(force / solution.force - 1.0) < 1e-3

# %%
# Exercise
# --------
# With which power of the depth does the force of a ball grow? Hertz has 3/2 at :math:`k = 0`. What remains at
# :math:`k = 1`, and of which foundation does that remind you?
#
# Solution
# --------
# The force grows like :math:`a^{3+k}`, the depth like :math:`a^2`: the power is :math:`(3 + k)/2`. At :math:`k = 1`
# it is 2, that of springs that stand on an area: an incompressible solid of Gibson's kind is Winkler's foundation.

deeper, stronger = pressed(lambda r: r / RADIUS, 2.0 * contact)
power = np.log(stronger / force) / np.log(deeper / depth)
print(f"the power is {power:.4f}, (3 + k)/2 is {0.5 * (3.0 + EXPONENT):.4f}")
assert abs(power - 0.5 * (3.0 + EXPONENT)) < 1e-4

figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
depths = np.linspace(0.0, 2.0 * depth, 60)[1:]
for exponent, colour in ((0.0, "C0"), (0.3, "C1"), (0.6, "C2")):
    other = wk.GradedHalfSpace.between(wk.PowerLawGraded(10e9, 1e-3, exponent, 0.25))
    curve = wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), other), wk.Depth(depths)).solve()
    axes.loglog(1e6 * depths, curve.force, colour, label=f"k = {exponent:g}")
axes.set(xlabel="depth [µm]", ylabel="force [N]", title="A ball on solids that stiffen with depth")
axes.legend(frameon=False)
plt.show()
