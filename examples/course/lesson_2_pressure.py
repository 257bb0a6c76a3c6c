r"""
Lesson 2: the springs know the pressure
=======================================

*Before:* lesson 1. *Afterwards* you can bring back the pressure below any body of revolution.

The row of springs bears :math:`q(x) = E^* (d - g(x))` per length. The pressure of the three-dimensional contact has the
same Abel integral as the profile, backwards:

.. math:: p(r) = -\frac{1}{\pi} \int_r^a \frac{q'(x)}{\sqrt{x^2 - r^2}} \,\mathrm{d}x .
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# The rule, by numbers
# --------------------
# Put :math:`x^2 = r^2 + t^2`: the root leaves the integral again.


def pressure(slope_of_g, r, radius, modulus):
    """Return p [Pa] at the radii r [m] of a contact of a radius [m], by the slope g'(x) and E* [Pa]."""
    end = np.sqrt(radius**2 - r**2)[:, np.newaxis]
    t = (np.arange(4000) + 0.5) / 4000 * end
    x = np.hypot(r[:, np.newaxis], t)
    return modulus * (slope_of_g(x) / x).mean(axis=1) * end[:, 0] / np.pi


RADIUS, MODULUS, CONTACT = 10e-3, 115e9, 0.2e-3  # of the ball [m]; E* [Pa]; of the contact [m]
r = np.linspace(0.02, 0.98, 49) * CONTACT
ball = pressure(lambda x: 2.0 * x / RADIUS, r, CONTACT, MODULUS)
hertz = 2.0 * MODULUS / (np.pi * RADIUS) * np.sqrt(CONTACT**2 - r**2)
print(f"below the middle {ball[0] / 1e9:.4f} GPa, Hertz {hertz[0] / 1e9:.4f} GPa")
assert np.allclose(ball, hertz, rtol=1e-6)

# %%
# The pressure bears the force
# ----------------------------
# A check that costs nothing: the pressure over all rings has to be what the springs bear.

edges = np.linspace(0.0, CONTACT, 2001)
rings = 0.5 * (edges[1:] + edges[:-1])
of_rings = pressure(lambda x: 2.0 * x / RADIUS, rings, CONTACT, MODULUS)
force = float(np.sum(2.0 * np.pi * rings * of_rings) * edges[1])
springs = 4.0 / 3.0 * MODULUS * CONTACT**3 / RADIUS
print(f"all rings bear {force:.2f} N, the springs {springs:.2f} N")
assert abs(force / springs - 1.0) < 1e-3

# %%
# Exercise
# --------
# How large is the pressure below the point of a cone? Take :math:`g = \frac{\pi}{2} x \tan\theta` from lesson 1, with
# the slope 0.05, and go nearer and nearer to the axis.
#
# Solution
# --------
# It grows without bound, by the same step for each halving of the distance: like a logarithm. The closed form is
# :math:`p = \frac{1}{2} E^* \tan\theta \,\mathrm{arcosh}(a/r)`. Real points are round, or yield.

slope = 0.05
near = CONTACT * np.array([0.4, 0.2, 0.1, 0.05])
cone = pressure(lambda x: np.full_like(x, 0.5 * np.pi * slope), near, CONTACT, MODULUS)
for place, found in zip(near, cone, strict=True):
    print(f"at {1e6 * place:5.1f} um: {found / 1e9:.3f} GPa")
assert np.allclose(cone, 0.5 * MODULUS * slope * np.arccosh(CONTACT / near), rtol=1e-3)

steel = wk.Elastic(young=2.0 * MODULUS * 0.91, poisson=0.3)
half_space = wk.HalfSpace.between(steel, steel)
figure, axes = plt.subplots(figsize=(7.0, 3.8), layout="constrained")
for shape, colour, label in (
    (wk.Paraboloid(RADIUS), "C0", "ball"),
    (wk.Cone(half_angle=np.arctan(1.0 / slope)), "C3", "cone"),
):
    contact = wk.Indentation(wk.Foundation(shape, half_space), wk.Radius(CONTACT)).solve()
    axes.plot(1e6 * r, wk.restore(contact, r).pressure / 1e9, colour, label=f"{label}, winkler")
axes.plot(1e6 * r[::4], ball[::4] / 1e9, "C0o", label="ball, by hand")
axes.plot(1e6 * near, cone / 1e9, "C3s", label="cone, by hand")
axes.set(xlabel="r [µm]", ylabel="pressure [GPa]", title="What the springs bear, brought back to the surface")
axes.legend(frameon=False)
plt.show()
