"""
The resistance of a rough joint
===============================

A blasted silver surface is pressed onto a flat one. It touches in a few spots, all current has to pass through them,
and the resistance falls as new spots come into contact. Three methods lead to it: boundary elements, which solve the
contact of this very surface; lines of springs, which know its power spectrum alone; and bounds, which know no more than
its height.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

silver = wk.HalfSpace.between(wk.Elastic(young=83e9, poisson=0.37), wk.Elastic(young=83e9, poisson=0.37))
metal = wk.ElectricalConductor(resistivity=15.9e-9)

# %%
# The surface
# -----------
# In place of a measured one (``wk.read_topography``) a self-affine surface is made at random: rough from a quarter of a
# millimetre down to twenty micrometres. It stands alone, like a stamp of a square millimetre.

blasted = wk.SelfAffine(hurst=0.8, rms_height=0.6e-6, longest=1e-3, shortest=20e-6, roll_off=0.25e-3)
surface = wk.RandomTopography([1e-3, 1e-3], blasted, (96, 96), seed=7, periodic=False)
print(f"root mean squares: height {surface.rms_height * 1e6:.2f} um, slope {surface.rms_slope:.3f}")
picture = draw(surface)

# %%
# Pressed
# -------
# The boundary elements march through the loads, each from the contact before.

forces = np.geomspace(0.1, 100.0, 7)
contact = wk.SurfaceContact(surface, silver, wk.Force(forces))
joint = wk.SurfaceConduction(contact, wk.ElectricalConductors(metal, metal), realisations=20).solve()
picture = draw(joint.contact)

# %%
# Resistance against force
# ------------------------
# Conductance and stiffness are in proportion, whatever the spots look like (Barber). Shaded is where no surface of this
# height from valley to peak can leave.

figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
axes.fill_between(forces, joint.least_resistance, joint.greatest_resistance, color="0.9", label="bounds")
axes.loglog(forces, joint.resistance, "o-", label="boundary elements")
axes.loglog(forces, joint.line_resistance, "s--", label="lines of springs, same spectrum")
axes.set(xlabel="force [N]", ylabel="resistance [Ω]", title="a blasted silver joint")
axes.legend(frameon=False)
plt.show()

for force, exact, line in zip(forces, joint.resistance, joint.line_resistance, strict=True):
    print(f"{force:7.2f} N: {exact * 1e6:7.1f} microohm, by lines of springs {line / exact:4.2f} times as much")

# %%
# True contact area
# -----------------
# The springs of a line do not know of one another: their length in contact is no area. Persson's theory gives the area
# from the same spectrum.

share = joint.contact.area / surface.area
persson = joint.line.area / surface.area
print(f"under {forces[-1]:.0f} N {share[-1]:.1%} of the surface touches, {persson[-1]:.1%} by Persson's theory")

# %%
# Check
# -----
# The resistance lies between its bounds, and falls about like a power of the force.

assert np.all(joint.least_resistance <= joint.resistance)
assert np.all(joint.resistance <= joint.greatest_resistance)
assert np.all(np.diff(joint.resistance) < 0.0)
assert np.max(np.abs(np.log(joint.line_resistance / joint.resistance))) < np.log(2.5)
