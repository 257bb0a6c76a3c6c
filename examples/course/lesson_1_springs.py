r"""
Lesson 1: a contact becomes a row of springs
============================================

*For whom:* you know Hertz' formula. *Afterwards* you can press any body of revolution into an elastic solid by hand.

Two things go in. The first is the stiffness of a flat punch, :math:`k(a) = 2 E^* a`. Independent springs that stand
on a line, each as stiff as :math:`E^* \Delta x`, have just this stiffness over a width of :math:`2 a`. The second is
the rule that changes the shape :math:`f(r)` into a plane profile,

.. math:: g(x) = |x| \int_0^{|x|} \frac{f'(r)}{\sqrt{x^2 - r^2}} \,\mathrm{d}r .
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# The rule, by numbers
# --------------------
# Put :math:`r = x \sin\varphi`: the root leaves the integral, and the middle rule is enough. For a ball of the radius
# :math:`R`, taken as a paraboloid, it gives :math:`g = x^2 / R`: twice the shape.

RADIUS, MODULUS = 10e-3, 115e9  # of the ball [m]; E* of steel on steel [Pa]
middles = (np.arange(400) + 0.5) * 0.5 * np.pi / 400


def plane_profile(slope, x):
    """Return g [m] of a body with the slope f'(r), at the places x [m]."""
    r = np.abs(x)[:, np.newaxis] * np.sin(middles)
    return np.abs(x) * slope(r).mean(axis=1) * 0.5 * np.pi


x = np.linspace(-300e-6, 300e-6, 601)
step = x[1] - x[0]
g = plane_profile(lambda r: r / RADIUS, x)
assert np.allclose(g, x**2 / RADIUS, rtol=1e-5, atol=0.0)

# %%
# Press the springs
# -----------------
# A spring at :math:`x` is pressed by :math:`d - g(x)` where that is positive. The contact ends where it is zero, and
# the force is the sum over the springs.

DEPTH = 4e-6
pressed = np.maximum(DEPTH - g, 0.0)
force = MODULUS * pressed.sum() * step
radius = np.sqrt(DEPTH * RADIUS)
hertz = 4.0 / 3.0 * MODULUS * np.sqrt(RADIUS * DEPTH**3)
print(f"the springs give {force:.3f} N, Hertz {hertz:.3f} N; the contact radius is {1e6 * radius:.1f} um")
assert abs(force / hertz - 1.0) < 1e-4

steel = wk.Elastic(young=2.0 * MODULUS * 0.91, poisson=0.3)
ball = wk.Foundation(wk.Paraboloid(curvature_radius=RADIUS), wk.HalfSpace.between(steel, steel))
print(f"winkler gives {wk.Indentation(ball, wk.Depth(DEPTH)).solve().force:.3f} N")

figure, axes = plt.subplots(figsize=(7.0, 3.8), layout="constrained")
axes.plot(1e6 * x, 1e6 * (g - DEPTH), "C0", label="plane profile, pressed in by d")
axes.vlines(1e6 * x[::15], -7.0, 1e6 * np.minimum(g - DEPTH, 0.0)[::15], color="0.6", label="springs")
axes.set(xlabel="x [µm]", ylabel="height [µm]", ylim=(-7.0, 6.0), title="A ball on springs that stand on a line")
axes.legend(frameon=False, loc="upper center")

# %%
# Exercise
# --------
# A cone touches with the slope :math:`\tan\theta = 0.1`. How does its force grow with the depth, and how large is it at
# :math:`d` = 4 µm? Sneddon found :math:`F = 2 E^* d^2 / (\pi \tan\theta)`.
#
# Solution
# --------
# Only the slope changes. The profile is :math:`g = \frac{\pi}{2} |x| \tan\theta`.

slope = 0.1
cone = plane_profile(lambda r: np.full_like(r, slope), x)
force = MODULUS * np.maximum(DEPTH - cone, 0.0).sum() * step
sneddon = 2.0 * MODULUS * DEPTH**2 / (np.pi * slope)
print(f"a cone: {force:.3f} N by the springs, {sneddon:.3f} N by Sneddon")
assert abs(force / sneddon - 1.0) < 1e-3
doubled = MODULUS * np.maximum(2.0 * DEPTH - cone, 0.0).sum() * step
print(f"twice the depth, {doubled / force:.3f} times the force")
plt.show()
