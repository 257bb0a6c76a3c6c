"""
The puzzle of the elastic foundation: times four, or times 2.83?
================================================================

Multibody and haptics codes often model contact by an *elastic foundation*: a mesh whose every face carries a
spring, independent of its neighbours. Press a ball into such a bed, double the depth, and the force becomes four
times as large. Hertz says :math:`2^{3/2} = 2.83`. Users meet this again and again, look for the bug in their mesh
or in their stiffness, and find none.

There is none. The springs are not to blame either, only their arrangement: they belong on a **line**, under the profile
:math:`g(x)`, and not on an **area** under the profile :math:`f(r)`.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.reference.power import power_law_force, stretch

# %%
# What the mesh does
# ------------------
# A steel ball of 20 mm radius on rubber. On an area the spring at the distance r from the axis is compressed by
# :math:`d - r^2/2R`, up to :math:`r = \sqrt{2Rd}`. With the stiffness :math:`K` per area
#
# .. math:: F = K \int_0^{\sqrt{2Rd}} \left(d - \frac{r^2}{2R}\right) 2\pi r\,\mathrm dr = \pi K R\,d^2 .
#
# Depth squared, whatever the mesh and whatever :math:`K`: the touched *area* grows with d, and so does the compression.

RADIUS = 20e-3
rubber = wk.Elastic(young=2e6, poisson=0.5)
medium = wk.HalfSpace.between(rubber)
ball = wk.Paraboloid(curvature_radius=RADIUS)
modulus = medium.modulus


def on_an_area(depth, stiffness, pixel=0.05e-3):
    """The force of springs on a square mesh, as a multibody code would sum them up."""
    x = np.arange(-8e-3, 8e-3, pixel) + 0.5 * pixel
    r = np.hypot(x[:, None], x)
    return float(np.sum(stiffness * np.maximum(depth - ball.height(r), 0.0)) * pixel**2)


once, twice = (on_an_area(depth, stiffness=1e9) for depth in (0.4e-3, 0.8e-3))
print(f"springs on an area, doubling the depth:   F x {twice / once:.4f}")
assert np.isclose(twice / once, 4.0, rtol=1e-3)

# %%
# What the solid does
# -------------------
# In a solid every point feels every other: the touched circle is smaller, :math:`a = \sqrt{Rd}`, and the pressure falls
# to zero at its edge with a vertical slope. All of this is contained in *one row* of springs of the stiffness
# :math:`E^*\,\mathrm dx`, if the profile is replaced by
#
# .. math:: g(x) = x\int_0^x \frac{f'(r)}{\sqrt{x^2-r^2}}\,\mathrm dr = \frac{x^2}{R} ,
#
# twice as steep as the ball. The touched *length* grows with the square root of d, the compression with d: together
# :math:`d^{3/2}`.


def on_a_line(depth, pixel=1e-6):
    """The force of springs on a line under g(x): five lines that any code can take over."""
    x = np.arange(0.0, 8e-3, pixel) + 0.5 * pixel
    g = x**2 / RADIUS
    return float(2.0 * np.sum(modulus * np.maximum(depth - g, 0.0)) * pixel)


once, twice = (on_a_line(depth) for depth in (0.4e-3, 0.8e-3))
print(f"springs on a line, doubling the depth:    F x {twice / once:.4f}")
assert np.isclose(twice / once, 2.0**1.5, rtol=1e-3)

# %%
# That is what winkler does, for any body of revolution, without pixels:

bed = wk.Foundation(ball, medium)
depth = np.geomspace(0.02e-3, 2e-3, 100)
solid = wk.Indentation(bed, wk.Depth(depth)).solve()
once, twice = wk.Indentation(bed, wk.Depth([0.4e-3, 0.8e-3])).solve().force
print(f"winkler, doubling the depth:              F x {twice / once:.10f}")
print(f"Hertz:                                    F x {2**1.5:.10f}")
assert np.isclose(twice / once, 2.0**1.5, rtol=1e-12)

# %%
# No stiffness repairs it
# -----------------------
# One may choose :math:`K` so that both agree at *one* depth :math:`d_0`, from :math:`\pi K R d_0^2 = \frac43
# E^*\sqrt{R} d_0^{3/2}`. Away from it the force is off by :math:`\sqrt{d/d_0}`, and the pressure is wrong
# everywhere: a parabola over a circle that is 1.41 times too wide.

FITTED = 0.4e-3
stiffness = 4.0 * modulus / (3.0 * np.pi * np.sqrt(RADIUS * FITTED))
contact = wk.Indentation(bed, wk.Depth(FITTED)).solve()

figure, (beds, forces, pressures) = plt.subplots(1, 3, figsize=(11.5, 3.7), layout="constrained")

x = np.linspace(-6.0, 6.0, 241) * 1e-3
for shape, height, colour in (("f(r), on an area", ball.height, "C1"), ("g(x), on a line", ball.gap, "C0")):
    below = (height(np.abs(x)) - FITTED) * 1e3
    beds.plot(x * 1e3, below, color=colour, label=shape)
    edge = np.abs(x[np.flatnonzero(below < 0.0)]).max() * 1e3
    beds.plot([-edge, edge], [0, 0], "|", color=colour, markersize=12)
beds.axhline(0.0, color="0.6", linewidth=0.8, zorder=0)
beds.set(xlabel="r or x [mm]", ylabel="height [mm]", ylim=(-0.5, 1.0), title="the two beds at 0.4 mm depth")
beds.legend(frameon=False, loc="upper center")

forces.loglog(depth * 1e3, solid.force, color="C0", label="springs on a line = Hertz")
forces.loglog(depth * 1e3, np.pi * stiffness * RADIUS * depth**2, color="C1", label="springs on an area")
forces.plot(FITTED * 1e3, contact.force, "ko", label="fitted here")
forces.set(xlabel="depth d [mm]", ylabel="force F [N]", title="no stiffness repairs the exponent")
forces.legend(frameon=False)

r = np.linspace(0.0, 4.5e-3, 400)
pressures.plot(r * 1e3, wk.restore(contact, r).pressure / 1e3, color="C0", label="solid")
pressures.plot(
    r * 1e3, stiffness * np.maximum(FITTED - ball.height(r), 0.0) / 1e3, color="C1", label="springs on an area"
)
pressures.set(xlabel="distance from the axis r [mm]", ylabel="pressure p [kPa]", title="the same force, two pressures")
pressures.set(xlim=(0, None), ylim=(0, None))
pressures.legend(frameon=False)
plt.show()

# %%
# Other shapes
# ------------
# For :math:`f = c\,r^n` the springs on an area give :math:`F \sim d^{1+2/n}`, the solid :math:`F \sim d^{1+1/n}`.
# For a cone the mesh is off by a factor of two on every doubling; a flat punch, :math:`n\to\infty`, is the only
# shape for which the exponents agree.

exponents = np.linspace(1.0, 8.0, 71)
doubling = []
for n in exponents:
    shape = wk.PowerLaw(coefficient=1.0, exponent=n)
    low, high = wk.Indentation(wk.Foundation(shape, medium), wk.Depth([1e-3, 2e-3])).solve().force
    doubling.append(high / low)
doubling = np.array(doubling)
assert np.allclose(doubling, 2.0 ** (1.0 + 1.0 / exponents), rtol=1e-11)

figure, axes = plt.subplots(figsize=(5.6, 3.6), layout="constrained")
axes.plot(exponents, doubling, color="C0", label="solid (line of springs under g)")
axes.plot(exponents, 2.0 ** (1.0 + 2.0 / exponents), color="C1", label="area of springs under f")
for n, name in ((1, "cone"), (2, "ball")):
    for rise, colour, side, away in ((1, "C0", "right", (-6, -12)), (2, "C1", "left", (7, 4))):
        factor = 2.0 ** (1.0 + rise / n)
        axes.plot(n, factor, "o", color=colour)
        axes.annotate(f"{name}: {factor:.3g}", (n, factor), xytext=away, textcoords="offset points", ha=side)
axes.axhline(2.0, color="0.6", linewidth=0.8, linestyle="--")
axes.set(xlabel="exponent n of the shape", ylabel="F(2d) / F(d)", xlim=(0.0, 8.0), ylim=(1.8, 8.8))
axes.legend(frameon=False)
plt.show()

# %%
# What to do in your own code
# ---------------------------
# - *Bodies of revolution* (balls, cones, rounded tips, a measured profile): replace the mesh by the line. Take g from a
#   table that winkler computes once, or the finished law F(d) itself.
# - *Keep the mesh* only for what it is, a thin soft layer on a hard core. There the bed of springs on an area is
#   the right limit, with :math:`K = (1-\nu)E/((1+\nu)(1-2\nu)h)` for a compressible layer much thinner than the
#   contact is wide.
# - Never compare a stiffness fitted in one with the other: :math:`K` is in Pa/m, :math:`E^*` in Pa.

x = np.linspace(0.0, 6e-3, 7)
print("\n  x [mm]   g [mm]    F at d = g(x) [N]")
for place, g, force in zip(x, bed.gap(x), wk.Indentation(bed, wk.Radius(x)).solve().force, strict=True):
    print(f"{place * 1e3:8.1f} {g * 1e3:8.3f} {force:12.4f}")

coefficient = 1.0 / (2.0 * RADIUS)
assert np.isclose(stretch(2.0), 2.0)
assert np.isclose(force, power_law_force(x[-1], coefficient=coefficient, exponent=2.0, modulus=modulus), rtol=1e-12)
