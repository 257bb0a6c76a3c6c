r"""
Why it is exact: a staircase of flat punches, and point forces as reference
===========================================================================

How can springs that do not know of each other give the exact answer of a solid in which every point feels every other?
Because they do not stand for pieces of the solid. They stand for *moments of its loading*: at every moment the contact
advances like a flat punch of the radius that it has just then (Jaeger). This example takes a contact apart into such
punches, puts it together again, and compares it with a reference solution that uses neither.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.fields.punch_staircase import staircase
from winkler.plot import draw
from winkler.reference import point_forces

# %%
# The contact
# -----------
# A round tip that goes over into a cone, pressed into a polymer until the cone is in contact.

RADIUS = 1e-6
polymer = wk.HalfSpace.between(wk.Elastic(young=1e9, poisson=0.3))
tip = wk.RoundedCone(curvature_radius=RADIUS, half_angle=np.radians(75.0))
contact = wk.Indentation(wk.Foundation(tip, polymer), wk.Radius(0.5e-6)).solve()
a, modulus = contact.radius, polymer.modulus
print(f"a = {a * 1e9:.0f} nm, d = {contact.depth * 1e9:.6f} nm, F = {contact.force * 1e6:.6f} uN")
print(
    f"F / (E* R^2) = {contact.force / (modulus * RADIUS**2):.12f}, the cone begins at {tip.blend_radius * 1e9:.0f} nm"
)

# %%
# Seven punches
# -------------
# The increment :math:`\mathrm dg` of the depth belongs to a punch of the radius x that the contact has at that moment.
# With seven punches the pressure is a comb; where the comb's teeth stand close, it becomes a curve.

draw(staircase(contact, 7))

# %%
# More punches
# ------------
# Force and displacement of the staircase converge to those of winkler with the square of the number of punches. Its
# pressure is infinite at every edge; midway between two edges it converges with the root of the number only, which is
# why nobody should compute a pressure from punches.

counts = np.array([10, 30, 100, 300, 1000, 3000])
outside = 1.5 * a
restored = wk.restore(contact, [outside]).displacement[0]
errors = {"force": [], "displacement at 1.5 a": [], "pressure within 0.9 a": []}
for count in counts:
    punches = staircase(contact, int(count))
    between = 0.5 * (punches.radii[1:] + punches.radii[:-1])
    between = between[(between > 0.1 * a) & (between < 0.9 * a)]
    pressure = wk.restore(contact, between).pressure
    errors["force"].append(abs(punches.force / contact.force - 1.0))
    errors["displacement at 1.5 a"].append(abs(punches.displacement([outside])[0] / restored - 1.0))
    errors["pressure within 0.9 a"].append(np.max(np.abs(punches.pressure(between) / pressure - 1.0)))

print("\npunches     error of F   error of u(1.5 a)   error of p")
for row in zip(counts, *errors.values(), strict=True):
    print("{:7d} {:14.1e} {:16.1e} {:14.1e}".format(*row))
order = np.polyfit(np.log(counts[2:]), np.log(errors["force"][2:]), 1)[0]
print(f"order of the force: {order:.2f}")
assert -2.05 < order < -1.95
assert errors["force"][-1] < 1e-6

# %%
# The reference solution
# ----------------------
# A point force moves the surface by :math:`F/(\pi E^* s)` at the distance s, a pressure therefore by
#
# .. math:: u(r) = \frac{1}{\pi E^*}\iint\frac{p}{s}\,\mathrm dA .
#
# ``winkler.reference.point_forces`` does this integral directly. Put in the pressure that winkler restores, and the
# displacement must come out that winkler restores: :math:`d - f(r)` inside, the shape of the dent outside.

r = np.array([0.0, 0.1, 0.3, 0.5, tip.blend_radius / a, 0.7, 0.9, 0.99, 1.0, 1.01, 1.1, 1.5, 3.0]) * a
summed = point_forces.displacement(
    lambda s: wk.restore(contact, s).pressure, a, r, modulus, edge=0.5, breaks=[tip.blend_radius]
)
restored = wk.restore(contact, r).displacement
print("\n  r/a    u by point forces [nm]   u by winkler [nm]    difference")
for place, one, other in zip(r / a, summed, restored, strict=True):
    print(f"{place:6.3f} {one * 1e9:20.12f} {other * 1e9:20.12f} {one / other - 1.0:14.1e}")
worst = np.max(np.abs(summed / restored - 1.0))
print(f"largest difference: {worst:.1e}")
assert worst < 1e-9
inside = r <= a
assert np.allclose(summed[inside], contact.depth - tip.height(r[inside]), rtol=1e-9)

# %%
# Springs on an area fail against this reference. Give them the depth of the contact, and the stiffness that makes the
# force right: their pressure :math:`K(d - f)` does not bring the surface to the shape of the body.

places = np.linspace(0.0, 1.5, 61) * a
edge = tip.blend_radius + (contact.depth - tip.height(np.array([tip.blend_radius]))[0]) * np.tan(tip.half_angle)
s = np.linspace(0.0, edge, 4001)
stiffness = contact.force / np.trapezoid((contact.depth - tip.height(s)) * 2.0 * np.pi * s, s)
dent = point_forces.displacement(
    lambda s: stiffness * (contact.depth - tip.height(s)), edge, places, modulus, edge=1.0, breaks=[tip.blend_radius]
)

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(11.5, 3.8), layout="constrained")
for (name, error), mark in zip(errors.items(), ("o-", "s-", "^-"), strict=True):
    left.loglog(counts, error, mark, markersize=4, label=name)
left.set(xlabel="number of punches", ylabel="relative error", title="the staircase converges")
left.legend(frameon=False)

middle.semilogy(r / a, np.maximum(np.abs(summed / restored - 1.0), 2e-17), "o")
middle.axhline(2.2e-16, color="0.6", linewidth=0.8, linestyle="--")
middle.text(3.05, 1.6e-16, "last digit", ha="right", va="top", color="0.4")
middle.set(xlabel="r / a", ylabel="relative difference of u", ylim=(1e-17, 1e-12), title="point forces against winkler")

body = tip.height(places) - contact.depth
right.fill_between(places / a, body * 1e9, 60.0, color="0.9")
right.text(0.25, 15.0, "the tip", color="0.4")
right.plot(places / a, -wk.restore(contact, places).displacement * 1e9, "C0", label="winkler")
right.plot(places / a, -dent * 1e9, "C1--", label="pressure of springs on an area")
right.set(
    xlabel="r / a",
    ylabel="height of the surface [nm]",
    ylim=(-230, 60),
    xlim=(0, 1.5),
    title="the dent, same depth and force",
)
right.legend(frameon=False, loc="lower right")
plt.show()
