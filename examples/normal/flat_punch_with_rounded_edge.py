r"""
A flat punch, and what a rounded edge does to it
================================================

Under a sharp edge the pressure of a flat punch is infinite, :math:`p = E^*d/(\pi\sqrt{a^2-r^2})`. No edge is sharp:
a rounding of a hundredth of the radius hardly shows in the force-depth curve, but it decides whether the material
under the edge yields, cracks or endures.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.reference.punch import flat_punch_force, flat_punch_pressure
from winkler.reference.rounded import rounded_punch_depth, rounded_punch_force

# %%
# The punches
# -----------
# A steel pin with a flat end, 5 mm in radius, on aluminium. ``RoundedPunch`` is flat up to b and then rises like
# :math:`(r-b)^2/2R`. Three roundings are compared with the sharp edge, under the same force of 2 kN.

FORCE, FLAT = 2000.0, 5e-3
aluminium = wk.Elastic(young=70e9, poisson=0.33, strength=250e6)
steel = wk.Elastic(young=210e9, poisson=0.3)
medium = wk.HalfSpace.between(aluminium, steel)

sharp = wk.Indentation(wk.Foundation(wk.FlatPunch(radius=FLAT), medium), wk.Force(FORCE)).solve()
rounded = {
    edge: wk.Indentation(
        wk.Foundation(wk.RoundedPunch(flat_radius=FLAT, edge_radius=edge), medium), wk.Force(FORCE)
    ).solve()
    for edge in (0.1e-3, 1e-3, 10e-3)
}
assert np.isclose(sharp.force, flat_punch_force(sharp.depth, radius=FLAT, modulus=medium.modulus), rtol=1e-12)

print(f"mean pressure {sharp.mean_pressure / 1e6:.1f} MPa")
print("edge radius    depth [um]   stiffness [N/um]   contact beyond the flat [um]   greatest pressure [MPa]")
print(f"sharp         {sharp.depth * 1e6:9.3f} {sharp.stiffness / 1e6:16.1f} {0.0:22.2f} {'infinite':>29s}")
for edge, contact in rounded.items():
    r = FLAT + (contact.radius - FLAT) * np.linspace(-3.0, 1.0, 2001)
    peak = wk.restore(contact, r).pressure.max()
    print(
        f"{edge * 1e3:5.1f} mm      {contact.depth * 1e6:9.3f} {contact.stiffness / 1e6:16.1f} "
        f"{(contact.radius - FLAT) * 1e6:22.2f} {peak / 1e6:29.1f}"
    )

# %%
# The pressure at the edge
# ------------------------
# In the middle all agree. Near the edge the pressure rises with the sharp punch's until the rounding lifts off, a few
# micrometres beyond the flat, and then falls to zero.

figure, (left, right) = plt.subplots(1, 2, figsize=(10.0, 3.8), layout="constrained")
r = np.linspace(0.0, FLAT, 2000)[:-1]
for axes in (left, right):
    pressure = flat_punch_pressure(r, FLAT, depth=sharp.depth, modulus=medium.modulus)
    axes.plot(r * 1e3, pressure / 1e6, "k--", linewidth=1, label="sharp")
for edge, contact in rounded.items():
    near = contact.radius - (contact.radius - FLAT) * np.linspace(0.0, 8.0, 800) ** 2
    place = np.unique(np.concatenate([np.linspace(0.0, 1.002 * contact.radius, 400), near[near > 0.0]]))
    pressure = wk.restore(contact, place).pressure
    for axes in (left, right):
        axes.plot(place * 1e3, pressure / 1e6, label=f"rounded with {edge * 1e3:g} mm")
left.set(xlabel="distance from the axis r [mm]", ylabel="pressure p [MPa]", xlim=(0, 5.3), ylim=(0, 200))
left.set_title("all of the punch")
left.legend(frameon=False, loc="upper left")
right.set(xlabel="distance from the axis r [mm]", ylabel="pressure p [MPa]", title="its edge")
right.set(xlim=(4.85, 5.08), ylim=(0, 350))
right.axvline(FLAT * 1e3, color="0.6", linewidth=0.8)
right.text(FLAT * 1e3 - 0.004, 8, "end of the flat", ha="right", va="bottom", color="0.4")
plt.show()

# %%
# How much rounding is enough?
# ----------------------------
# The load at which the aluminium begins to yield, under the edge, over the radius of the rounding. For a sharp edge
# it is zero, and winkler refuses the question instead of answering it.

try:
    wk.YieldOnset(wk.Foundation(wk.FlatPunch(radius=FLAT), medium)).solve()
except wk.OutsideValidity as refusal:
    print(f"\n{refusal}\n")

edges = np.geomspace(0.1e-3, 100e-3, 7)
onset = [
    wk.YieldOnset(wk.Foundation(wk.RoundedPunch(flat_radius=FLAT, edge_radius=edge), medium)).solve() for edge in edges
]
print(f"edge rounded with 1 mm: yields at {onset[2].force:.0f} N, {onset[2].z * 1e6:.1f} um below the surface")

figure, axes = plt.subplots(figsize=(5.6, 3.6), layout="constrained")
axes.loglog(edges * 1e3, [one.force for one in onset], "o-")
axes.axhline(FORCE, color="0.6", linewidth=0.8, linestyle="--")
axes.text(0.11, FORCE * 1.08, "2 kN", color="0.4")
axes.set(
    xlabel="radius of the edge R [mm]", ylabel="force at first yield [N]", title="aluminium under a steel punch of 5 mm"
)
plt.show()

# %%
# Check
# -----
# Against the closed solution, and its value for :math:`E^*=R=1`, :math:`b=0.2`, :math:`a=0.5`.

for edge, contact in rounded.items():
    numbers = {"flat_radius": FLAT, "edge_radius": edge}
    assert np.isclose(contact.depth, rounded_punch_depth(contact.radius, **numbers), rtol=1e-10)
    assert np.isclose(contact.force, rounded_punch_force(contact.radius, modulus=medium.modulus, **numbers), rtol=1e-10)

unit = wk.HalfSpace.between(wk.Elastic(young=1.0, poisson=0.0))
one = wk.Indentation(wk.Foundation(wk.RoundedPunch(flat_radius=0.2, edge_radius=1.0), unit), wk.Radius(0.5)).solve()
assert np.isclose(one.depth, 0.113200836675051, rtol=1e-12)
assert np.isclose(one.force, 0.0886784482022164, rtol=1e-12)
