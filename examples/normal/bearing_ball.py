r"""
A ball in its raceway
=====================

A ball of a bearing touches the ring on an ellipse that is long across the groove. How large is it, what does the steel
bear below the surface, and how does the onset of yield depend on friction and its direction? The pressure is that of
Hertz,

.. math:: p = p_0\sqrt{1-\frac{x^2}{a^2}-\frac{y^2}{b^2}}, \qquad p_0 = \frac{3F}{2\pi ab},

and the stresses are those of this half-ellipsoid and of the traction :math:`\mu p` (Sackfield and Hills 1983).
"""

import math

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# The ellipse
# -----------
# A ball of 5 mm radius runs on an inner ring of 26 mm, in a groove of 5.2 mm. The groove is hollow: its radius is
# negative.

STRENGTH = 1.8e9
bodies = wk.CurvedBodies.of(first=(5e-3, 5e-3), second=(26e-3, -5.2e-3))
steel = wk.Elastic(young=208e9, poisson=0.3, strength=STRENGTH)
pair = wk.HalfSpace.between(steel, steel)
contact = wk.EllipticIndentation(bodies, pair, wk.Force(500.0)).solve()
a, b, peak = contact.longitudinal_semi_axis, contact.lateral_semi_axis, contact.peak_pressure
print(f"{2e3 * a:.3f} mm along the groove, {2e3 * b:.3f} mm across it, greatest pressure {peak / 1e9:.2f} GPa")
assert np.isclose(peak, 1.5 * 500.0 / (math.pi * a * b), rtol=1e-12)

draw(contact)

# %%
# Fatigue
# -------
# At each passage the shear stress in planes along the surface swings between :math:`-\tau_0` and :math:`\tau_0`. After
# Lundberg and Palmgren, with :math:`b/a = \sqrt{(t^2-1)(2t-1)}`, it is :math:`\tau_0 = p_0\sqrt{2t-1}/(2t(t+1))`.

smaller, larger = sorted((a, b))
t = 1.0
for _ in range(60):
    t = math.sqrt(1.0 + (smaller / larger) ** 2 / (2.0 * t - 1.0))
place = contact.greatest_stress(measure="orthogonal_shear")
print(f"orthogonal shear stress {place.value / peak:.4f} p0, {place.z * 1e6:.0f} um below the surface")
assert np.isclose(place.value / peak, math.sqrt(2.0 * t - 1.0) / (2.0 * t * (t + 1.0)), rtol=1e-9)

# %%
# All greatest stresses of a contact with their depths, in one answer:

stress = wk.ContactStress(wk.EllipticIndentation(bodies, pair, wk.Force(500.0))).solve()
assert np.isclose(stress.orthogonal_shear, place.value, rtol=1e-9)
draw(stress)

# %%
# Friction in both directions
# ---------------------------
# Where the ball slides, yielding begins earlier, and from about :math:`\mu=0.3` on at the surface.

frictions = np.linspace(0.0, 0.5, 11)
figure, axes = plt.subplots(figsize=(6.0, 4.0), layout="constrained")
for angle, name, colour in ((0.0, "along the groove", "C0"), (0.5 * math.pi, "across it", "C3")):
    onsets = [wk.EllipticYieldOnset(bodies, pair, wk.Coulomb(float(mu)), angle).solve() for mu in frictions]
    axes.plot(frictions, [onset.peak_pressure / STRENGTH for onset in onsets], colour, label=name)
    assert onsets[0].z > 0.0
    assert onsets[-1].z == 0.0
axes.set(
    xlabel="coefficient of friction [-]", ylabel="greatest pressure / strength [-]", xlim=(0.0, 0.5), ylim=(0.0, 2.0)
)
axes.set(title="onset of yield of a sliding ball")
axes.legend(frameon=False)
plt.show()

# %%
# The stresses of the ball that slides across the groove, at the load at which it yields.

draw(onsets[5])
