r"""
A ball on a graded ceramic
==========================

A ceramic whose surface is infiltrated with glass is soft at the top and hard in the depth; such gradients keep contacts
from cracking. With Young's modulus :math:`E(z) = E_0 (z/c_0)^k` the springs of the method have the stiffness
:math:`E^*(x/c_0)^k`, and everything stays exact.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# Three ceramics, one ball
# ------------------------
# All have E = 300 GPa at a depth of 0.1 mm. Positive k is softer above and stiffer below, negative k a hard skin. The
# picture shows the first: Young's modulus from the surface down, and the stiffness of its springs.

ball = wk.Sphere(curvature_radius=2e-3)
media = {
    k: wk.GradedHalfSpace.between(wk.PowerLawGraded(young=300e9, depth_scale=0.1e-3, exponent=k, poisson=0.22))
    for k in (0.2, 0.0, -0.2)
}
springs = draw(media[0.2], extent=0.2e-3)

contacts = {}
for k, medium in media.items():
    contacts[k] = contact = wk.Indentation(wk.Foundation(ball, medium), wk.Force(30.0)).solve()
    peak = wk.restore(contact, 0.0).pressure
    size = f"depth {contact.depth * 1e6:.3f} µm, a = {contact.radius * 1e6:.1f} µm"
    print(f"k = {k:+.1f}: {size}, p(0) = {peak / 1e9:.2f} GPa, {peak / contact.mean_pressure:.3f} of the mean")

# %%
# Pressure and surface
# --------------------
# Pressure falls to the edge like :math:`(a^2-r^2)^{(1+k)/2}`. A soft surface spreads the same force over a wider
# contact, so that its peak is lower, although the distribution itself is more pointed. What counts for cracks round the
# contact, the tension just outside, is a stress inside the body; in this closed form it is not known, and winkler says
# so.

fields, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8), layout="constrained")
r = np.linspace(0.0, 150e-6, 401)
for k, contact in contacts.items():
    surface = wk.restore(contact, r)
    left.plot(r * 1e6, surface.pressure / 1e9, label=f"k = {k:+.1f}" if k else "k = 0, homogeneous")
    right.plot(r * 1e6, -surface.displacement * 1e6)
left.set(xlabel="distance from the axis [µm]", ylabel="pressure [GPa]", xlim=(0, 100), ylim=(0, None))
right.set(xlabel="distance from the axis [µm]", ylabel="height of the surface [µm]", xlim=(0, 150), ylim=(None, 0))
left.legend(frameon=False)
try:
    wk.restore(contacts[0.2], 0.0, 10e-6)
except wk.OutsideValidity as refusal:
    print(refusal)

# %%
# The closed form
# ---------------
# For a paraboloid everything is known: :math:`d = a^2/((1+k)R)`, and the peak is :math:`(3+k)/2` of the mean pressure.

for k, medium in media.items():
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(2e-3), medium), wk.Force(30.0)).solve()
    assert abs(contact.depth / (contact.radius**2 / ((1.0 + k) * 2e-3)) - 1.0) < 1e-12
    assert abs(wk.restore(contact, 0.0).pressure / contact.mean_pressure / ((3.0 + k) / 2.0) - 1.0) < 1e-9
plt.show()
