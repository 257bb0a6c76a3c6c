r"""
When does it yield?
===================

A ball may be loaded until the greatest von Mises stress reaches the strength of the weaker body. The place is not
at the surface but half a contact radius below it, which is why bearings fail from the inside. For a ball and
:math:`\nu = 0.3` textbooks give :math:`p_0 = 1.60\,Y` (Johnson 1985, after Davies 1949); for other shapes there is
no formula, but the same question.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# A bearing ball
# --------------
# Of 5 mm radius, hardened steel on a ring of softer steel. The strength is the uniaxial yield strength.

RADIUS = 5e-3
ring = wk.Elastic(young=210e9, poisson=0.3, strength=1.0e9)
hard = wk.Elastic(young=210e9, poisson=0.3, strength=2.0e9)
medium = wk.HalfSpace.between(ring, hard)
onset = wk.YieldOnset(wk.Foundation(wk.Paraboloid(curvature_radius=RADIUS), medium)).solve()
print(f"yielding begins at    {onset.force:.2f} N, a depth of {onset.depth * 1e6:.3f} um")
print(f"in the ring, at       z = {onset.z * 1e6:.2f} um = {onset.z / onset.radius:.4f} a below the surface")

draw(onset)

# %%
# Against the textbook
# --------------------
# The greatest shear stress below a ball is :math:`0.310020502\,p_0` at :math:`z = 0.4808644853\,a` for
# :math:`\nu=0.3`, and on the axis von Mises' stress is twice the shear stress. So :math:`p_0 = 1.61280\,Y`, and
#
# .. math:: F_Y = \frac{\pi^3R^2}{6E^{*2}}\,p_0^3 .
#
# The stress at the place is a flat maximum: it is found to all digits, the place itself to half of them.

peak = wk.restore(wk.Indentation(onset.problem.bed, wk.Force(onset.force)).solve(), [0.0]).pressure[0]
print(f"p0 / Y = {peak / 1.0e9:.6f}")
theory = np.pi**3 * RADIUS**2 / (6.0 * medium.modulus**2) * (1.0e9 / (2.0 * 0.310020502)) ** 3
print(f"force by the formula  {theory:.2f} N")
assert np.isclose(peak / 1.0e9, 1.0 / (2.0 * 0.310020502), rtol=1e-7)
assert np.isclose(onset.force, theory, rtol=1e-7)
assert np.isclose(onset.z / onset.radius, 0.4808644853, rtol=1e-4)

# %%
# Other shapes
# ------------
# How much a ball may carry depends on its curvature where it touches: a flat ellipsoid carries as much as a ball of the
# same curvature. A shape that wear has flattened carries several times more, and the place that yields first has moved
# from the axis to below the edge.

shapes = {
    "ball, 5 mm": wk.Sphere(curvature_radius=RADIUS),
    "ball, 10 mm": wk.Sphere(curvature_radius=2 * RADIUS),
    "ellipsoid, 5 mm wide, 2.5 mm high": wk.Ellipsoid(radial_semi_axis=RADIUS, axial_semi_axis=RADIUS / 2),
    "fourth power, worn in": wk.PowerLaw(coefficient=1.0 / (8.0 * RADIUS * (0.2e-3) ** 2), exponent=4.0),
    "flat of 0.2 mm, edge rounded with 5 mm": wk.RoundedPunch(flat_radius=0.2e-3, edge_radius=RADIUS),
}
print(f"\n{'shape':42s} force [N]   depth [um]   r/a      z/a")
answers = {}
for name, shape in shapes.items():
    answers[name] = one = wk.YieldOnset(wk.Foundation(shape, medium)).solve()
    print(f"{name:42s} {one.force:9.2f} {one.depth * 1e6:12.3f} {one.r / one.radius:7.3f} {one.z / one.radius:8.3f}")

# %%
# The maps below show von Mises' stress at the onset of yield, on the same scale: the strength. Under flat shapes the
# stress hides under the edge, not on the axis.

chosen = ["ball, 5 mm", "fourth power, worn in", "flat of 0.2 mm, edge rounded with 5 mm"]
figure, panels = plt.subplots(1, 3, figsize=(11.5, 2.7), layout="constrained", sharey=True)
for axes, name in zip(panels, chosen, strict=True):
    one = answers[name]
    contact = wk.Indentation(one.problem.bed, wk.Force(one.force)).solve()
    x, z = np.meshgrid(np.linspace(-1.7, 1.7, 137), np.linspace(0.0, 1.8, 73))
    stress = wk.restore(contact, np.abs(x) * one.radius, z * one.radius).von_mises
    image = axes.contourf(x, z, stress / 1.0e9, np.linspace(0.0, 1.0, 11), extend="max", cmap="viridis")
    axes.plot([-1, 1], [0, 0], "C3", linewidth=4, clip_on=False)
    for side in (-1, 1) if one.r > 0.05 * one.radius else (1,):
        axes.plot(side * one.r / one.radius, one.z / one.radius, "w+", markersize=9, markeredgewidth=1.6)
    axes.set(xlabel="r / a", aspect="equal", title=f"{name.partition(',')[0]}: {one.force:.0f} N")
panels[0].set_ylabel("z / a")
panels[0].invert_yaxis()
figure.colorbar(image, ax=panels, label="von Mises stress / strength")
plt.show()

# %%
# The force grows with the square of the curvature radius and the third power of the strength. Poisson's ratio matters a
# little, since it moves stress from the axis to the surface:

ratios = np.array([0.0, 0.15, 0.3, 0.4, 0.5])
known = {0.0: 0.384821111, 0.25: 0.3216784032, 0.3: 0.310020502, 0.5: 0.2663485631}
factors = []
for poisson in ratios:
    solid = wk.HalfSpace.between(wk.Elastic(young=210e9, poisson=poisson, strength=1.0e9))
    one = wk.YieldOnset(wk.Foundation(wk.Paraboloid(curvature_radius=RADIUS), solid)).solve()
    factors.append(2.0 * solid.modulus * one.radius / (np.pi * RADIUS) / 1.0e9)

figure, axes = plt.subplots(figsize=(5.2, 3.4), layout="constrained")
axes.plot(ratios, factors, "o-", label="winkler")
axes.plot(
    list(known), [0.5 / tau for tau in known.values()], "kx", markersize=9, label="greatest shear stress, closed form"
)
axes.set(xlabel="Poisson's ratio [-]", ylabel="$p_0$ / strength at the onset", title="pressure that a ball may have")
axes.legend(frameon=False)
plt.show()
assert np.isclose(factors[2], 0.5 / known[0.3], rtol=1e-6)
