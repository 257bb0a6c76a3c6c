"""
A hard coating on steel: when does the substrate come in?
==========================================================

A rule of thumb says that an indenter feels the coating alone as long as it goes no deeper than a tenth of its
thickness. How good the rule is depends on the shape of the tip: what counts is how wide the contact is, not how deep.
Here a diamond-like coating of 2 µm on steel is indented by balls and by a blunt cone, without any approximation for the
thickness.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# The coating
# -----------
# One layer, bonded to the substrate. The indenter is of diamond and elastic too. ``draw`` shows the body from its
# surface down, and how stiff that makes the springs: near the middle like those of the coating, far out like those of
# the steel.

THICKNESS = 2e-6
steel = wk.Elastic(young=210e9, poisson=0.3)
carbon = wk.Elastic(young=600e9, poisson=0.2)
diamond = wk.Elastic(young=1140e9, poisson=0.07)
coating = wk.CoatedHalfSpace([wk.Layer(carbon, thickness=THICKNESS)], on=steel, second=diamond)
steel_alone = wk.HalfSpace.between(steel, diamond).modulus

stack = draw(coating)

# %%
# What an instrument would report
# -------------------------------
# From the stiffness S of the contact and its radius a the effective modulus S/2a is computed, as if there were no
# substrate. Over the depth every tip has its own curve, and the rule of a tenth (dashed) is off by ten to forty per
# cent. Over the contact radius all curves are one: S = k(a) belongs to the medium alone, whatever the shape.

bodies = {
    "ball, R = 10 µm": wk.Paraboloid(10e-6),
    "ball, R = 50 µm": wk.Paraboloid(50e-6),
    "cone, 70.3° (equal area of Berkovich)": wk.Cone(np.radians(70.3)),
}
depth = np.geomspace(0.005, 1.0, 60) * THICKNESS
contacts = {
    name: wk.Indentation(wk.Foundation(body, coating), wk.Depth(depth)).solve() for name, body in bodies.items()
}

report, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.9), layout="constrained", sharey=True)
for name, contact in contacts.items():
    apparent = contact.stiffness / (2 * contact.radius)
    left.semilogx(depth / THICKNESS, apparent / 1e9, label=name)
    right.semilogx(contact.radius / THICKNESS, apparent / 1e9)
    at_a_tenth = np.interp(0.1, depth / THICKNESS, apparent / coating.modulus)
    print(f"{name}: at a tenth of the thickness the apparent modulus is {at_a_tenth:.3f} of the coating's")
    assert 0.55 < at_a_tenth < 0.9  # the rule of thumb is not good to a percent
    # the same from the springs alone: S/2a is their mean stiffness over the contact
    assert np.allclose(contact.stiffness, coating.punch_stiffness(contact.radius), rtol=1e-12)
for axes in (left, right):
    axes.axhline(coating.modulus / 1e9, color="0.6", linewidth=1, linestyle=":")
    axes.axhline(steel_alone / 1e9, color="0.6", linewidth=1, linestyle=":")
left.annotate("coating alone", (0.0055, 1.01 * coating.modulus / 1e9), color="0.4", fontsize=8.5)
left.annotate("steel alone", (0.0055, 1.02 * steel_alone / 1e9), color="0.4", fontsize=8.5)
left.axvline(0.1, color="0.6", linestyle="--")
left.set(xlabel="depth / thickness", ylabel="apparent modulus, S / 2a [GPa]", ylim=(0, 1.1 * coating.modulus / 1e9))
right.set(xlabel="contact radius / thickness")
left.legend(frameon=False, loc="lower left", bbox_to_anchor=(0.0, 0.05), fontsize=8.5)

# %%
# Stress at the interface
# -----------------------
# The hard coating bends over the steel and is pulled along its lower face: that is where cracks begin. The radial
# stress jumps there, the axial one does not.

contact = wk.Indentation(wk.Foundation(bodies["ball, R = 50 µm"], coating), wk.Depth(0.1 * THICKNESS)).solve()
above = np.linspace(0.0, 1.0, 81) * THICKNESS
below = np.linspace(1.0 + 1e-9, 3.0, 81) * THICKNESS
stresses, axes = plt.subplots(figsize=(5.2, 4.2), layout="constrained")
for z in (above, below):
    field = wk.restore(contact, np.zeros_like(z), z)
    first = z is above
    axes.plot(field.radial_stress / 1e9, z * 1e6, "C0", label="radial = hoop" if first else None)
    axes.plot(field.axial_stress / 1e9, z * 1e6, "C1", label="axial" if first else None)
axes.axhline(THICKNESS * 1e6, color="0.6", linestyle="--")
axes.axvline(0.0, color="0.8", linewidth=1)
axes.annotate("carbon", (0.02, 0.68), xycoords="axes fraction", color="0.4", va="bottom")
axes.annotate("steel", (0.02, 0.64), xycoords="axes fraction", color="0.4", va="top")
axes.invert_yaxis()
axes.set(xlabel="stress on the axis, tension positive [GPa]", ylabel="depth below the surface [µm]")
axes.legend(frameon=False, loc="lower left")

at_interface = wk.restore(contact, 0.0, np.array([above[-1], below[0]]))
upper, lower = at_interface.radial_stress / 1e9
print(f"contact radius {contact.radius * 1e6:.2f} µm; radial stress at the interface: {upper:.2f} GPa in the coating,")
print(f"{lower:.2f} GPa in the steel")
assert upper > 0.0
assert np.isclose(*at_interface.axial_stress, rtol=1e-6)
plt.show()
