r"""
A rounded cone: when is the tip a ball, when a cone?
====================================================

No cone is sharp. The tip of an AFM probe or of a conical nanoindenter is a ball of some radius R that runs into a cone
without a kink. Pressed in lightly it answers like a ball, :math:`F \sim d^{3/2}`, pressed in deeply like a cone,
:math:`F \sim d^2`; in between neither formula is right, and that is where most measurements are made.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw
from winkler.reference.rounded import rounded_cone_force, sphero_conical_force
from winkler.values.validity import worst

# %%
# The tip
# -------
# A conical probe for polymers: tip radius 250 nm, half-angle 60 degrees (measured from the axis). The ball ends
# where its slope is that of the cone, at :math:`b = R\cos\theta`.

TIP = {"curvature_radius": 250e-9, "half_angle": np.radians(60.0)}
tip = wk.SpheroConical(**TIP)
polymer = wk.HalfSpace.between(wk.Elastic(young=2.5e9, poisson=0.4))
bed = wk.Foundation(tip, polymer)

at_blend = wk.Indentation(bed, wk.Radius(tip.blend_radius)).solve()
print(f"the cone begins at a radius of        {tip.blend_radius * 1e9:.1f} nm")
print(f"the contact gets there at a depth of  {at_blend.depth * 1e9:.1f} nm, a force of {at_blend.force * 1e6:.2f} uN")

draw(wk.Indentation(bed, wk.Radius(2.0 * tip.blend_radius)).solve())

# %%
# From ball to cone
# -----------------
# The slope of the force-depth curve in logarithms, :math:`n = \mathrm d\ln F/\mathrm d\ln d`, is the exponent that
# a fit of a power law would find. It needs no differences, because the stiffness is known: :math:`n = k\,d/F`. It
# passes from 3/2 to 2, and needs two decades of depth for it. Just before the blend it dips to 1.47: the true ball
# is a little softer than the paraboloid that Hertz put in its place.

depth = np.geomspace(1e-10, 1e-5, 251)
curve = wk.Indentation(bed, wk.Depth(depth)).solve()
exponent = curve.stiffness * curve.depth / curve.force

ball = 4.0 / 3.0 * polymer.modulus * np.sqrt(TIP["curvature_radius"] * depth**3)
cone = 2.0 / np.pi * polymer.modulus * np.tan(TIP["half_angle"]) * depth**2

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(11.5, 3.7), layout="constrained")
left.loglog(depth * 1e9, curve.force * 1e6, "k", label="round tip and cone")
left.loglog(depth * 1e9, ball * 1e6, "--", color="C0", label="ball alone (Hertz)")
left.loglog(depth * 1e9, cone * 1e6, ":", color="C1", label="sharp cone (Love, Sneddon)")
left.set(xlabel="depth d [nm]", ylabel="force F [µN]", ylim=(1e-5, 1e8), title="force and depth")
left.legend(frameon=False, loc="upper left")

middle.semilogx(depth * 1e9, exponent, "k")
middle.set(
    xlabel="depth d [nm]", ylabel="exponent d ln F / d ln d", ylim=(1.45, 2.05), title="what a power law would find"
)
for level, name, colour in ((1.5, "ball", "C0"), (2.0, "cone", "C1")):
    middle.axhline(level, linestyle="--", color=colour, linewidth=0.9)
    middle.text(1.2e-1, level + 0.012, name, color=colour)

right.semilogx(depth * 1e9, ball / curve.force, "--", color="C0", label="ball alone")
right.semilogx(depth * 1e9, cone / curve.force, ":", color="C1", label="sharp cone")
right.axhspan(0.95, 1.05, color="0.9", label="within 5 %")
right.set(xlabel="depth d [nm]", ylabel="F of the formula / F", ylim=(0.0, 1.6), title="error of the two formulas")
right.legend(frameon=False, loc="upper left")
for axes in (left, middle, right):
    axes.axvline(at_blend.depth * 1e9, color="0.6", linewidth=0.8)
    axes.set_xlim(0.1, 1e4)
plt.show()

# %%
# The grey line is the depth at which the contact reaches the cone. How far the two formulas carry:

good_ball = depth[np.abs(ball / curve.force - 1.0) < 0.05].max()
good_cone = depth[np.abs(cone / curve.force - 1.0) < 0.05].min()
print(
    f"Hertz' formula is good to 5 % up to        {good_ball * 1e9:8.1f} nm = {good_ball / at_blend.depth:5.2f} d_blend"
)
print(
    f"the cone's formula is good to 5 % beyond   {good_cone * 1e9:8.1f} nm = {good_cone / at_blend.depth:5.2f} d_blend"
)

# %%
# What it costs to ignore it
# --------------------------
# Somebody who fits a cone to a curve of 50 nm depth gets a Young's modulus that is too high by the factor
# :math:`F/F_\text{cone}`, since the round tip is stiffer there than the sharp one.

depth_of_fit = np.linspace(0.0, 50e-9, 101)
measured = wk.Indentation(bed, wk.Depth(depth_of_fit)).solve().force
for name, shape in (
    ("sharp cone", 2.0 / np.pi * np.tan(TIP["half_angle"]) * depth_of_fit**2),
    ("ball", 4.0 / 3.0 * np.sqrt(TIP["curvature_radius"] * depth_of_fit**3)),
):
    fitted = float(measured @ shape / (shape @ shape))
    print(f"E* from a fit of a {name:10s}:  {fitted / 1e9:6.3f} GPa instead of {polymer.modulus / 1e9:.3f} GPa")

# %%
# Round or parabolic
# ------------------
# ``RoundedCone`` has a parabolic tip, which has a closed solution with fewer logarithms and is often used for a round
# one. With equal radius of curvature at the apex its cone begins later, and the force differs by several per cent.

parabolic = wk.Indentation(wk.Foundation(wk.RoundedCone(**TIP), polymer), wk.Depth(at_blend.depth)).solve()
print(
    f"parabolic instead of spherical tip: F differs by {100 * (parabolic.force / at_blend.force - 1):.1f} % at d_blend"
)

# %%
# Check and trust
# ---------------
# Against the closed solutions, from the very tip to far up the cone. And how far to trust it: inside the contact the
# flanks rise with a slope of 0.58, which the linear theory calls not small. For the usual etched silicon tips of 20
# degrees, with a slope of 2.7, winkler calls its own answer outside of validity: formulas for such tips are habit, not
# theory.

assert exponent.min() < 1.5 < 1.98 < exponent[-1] < 2.0
exact = sphero_conical_force(curve.radius, modulus=polymer.modulus, **TIP)
assert np.allclose(curve.force, exact, rtol=1e-10)
exact = rounded_cone_force(parabolic.radius, modulus=polymer.modulus, **TIP)
assert np.isclose(parabolic.force, exact, rtol=1e-10)

for angle in (20.0, 60.0, 85.0):
    shape = wk.SpheroConical(curvature_radius=250e-9, half_angle=np.radians(angle))
    contact = wk.Indentation(wk.Foundation(shape, polymer), wk.Radius(1.5 * shape.blend_radius)).solve()
    print(f"half-angle {angle:.0f} deg: {worst(contact.validity).value}")
