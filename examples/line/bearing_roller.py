r"""
A bearing roller, once and a million times
==========================================

A cylindrical roller touches its raceway in a narrow strip. How wide is it, how great is the pressure, at which load
does the steel yield, and how much may pass over it again and again? The pressure is that of Hertz,

.. math:: a = \sqrt{\frac{4PR}{\pi E^*}}, \qquad p_0 = \sqrt{\frac{PE^*}{\pi R}},

with :math:`P` the force per length (Johnson 1985, section 4.2).
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# Width and pressure
# ------------------
# A roller of 5 mm radius runs on an inner ring of 26 mm radius; the curvatures add:
# :math:`1/R = 1/5\,\mathrm{mm} + 1/26\,\mathrm{mm}`.

RADIUS = 1.0 / (1.0 / 5e-3 + 1.0 / 26e-3)
STRENGTH = 1.8e9
ring = wk.Elastic(young=208e9, poisson=0.3, strength=STRENGTH)
bed = wk.LineFoundation(wk.Paraboloid(curvature_radius=RADIUS), wk.HalfSpace.between(ring, wk.Elastic(208e9, 0.3)))
loads = np.geomspace(20e3, 2e6, 25)
contact = wk.LineIndentation(bed, wk.LineForce(loads)).solve()
print("force per length [N/mm]   width [um]   greatest pressure [MPa]")
for index in range(0, loads.size, 6):
    one = contact.at(index)
    print(f"{one.force_per_length * 1e-3:23.1f} {2 * one.half_width * 1e6:12.2f} {one.peak_pressure * 1e-6:25.1f}")
modulus = bed.medium.modulus
assert np.allclose(contact.half_width, np.sqrt(4.0 * loads * RADIUS / (np.pi * modulus)), rtol=1e-12)
assert np.allclose(contact.peak_pressure, np.sqrt(loads * modulus / (np.pi * RADIUS)), rtol=1e-12)

draw(contact)

# %%
# Once: the onset of yield
# ------------------------
# Without friction the greatest shear stress is :math:`0.3003\,p_0` at :math:`0.786\,a` below the surface. Von Mises'
# stress, in which the stress along the strip counts as well, is greatest at :math:`0.704\,a` for :math:`\nu=0.3`. With
# friction the place comes nearer, and from about :math:`\mu=0.3` on it is the surface that yields.

onset = wk.LineYieldOnset(bed, wk.Coulomb(0.0)).solve()
print(f"\nyielding begins at {onset.force_per_length * 1e-3:.0f} N/mm, {onset.z * 1e6:.0f} um below the surface")
draw(onset)

# %%
# Again and again: shakedown
# --------------------------
# A raceway that has yielded a little at the first passes keeps residual stresses, and may bear more than at the onset
# of yield without yielding again. Without friction a cylinder shakes down up to :math:`p_0 = 4k`, with :math:`k` the
# strength in shear (Johnson 1985, section 9.2). Friction takes most of this reserve away.

frictions = np.linspace(0.0, 0.5, 11)
in_shear = STRENGTH / np.sqrt(3.0)
first, limit = [], []
for friction in frictions:
    law = wk.Coulomb(float(friction))
    once = wk.LineYieldOnset(bed, law).solve().force_per_length
    again = wk.LineShakedown(bed, law).solve().force_per_length
    for peaks, force in ((first, once), (limit, again)):
        peaks.append(float(wk.LineIndentation(bed, wk.LineForce(force)).solve().peak_pressure) / in_shear)
assert np.isclose(limit[0], 4.0, rtol=1e-6)

figure, axes = plt.subplots(figsize=(6.0, 4.0), layout="constrained")
axes.plot(frictions, limit, "C3", label="shakedown")
axes.plot(frictions, first, "C0", label="onset of yield")
axes.fill_between(frictions, 0.0, first, color="C0", alpha=0.12, linewidth=0.0)
axes.fill_between(frictions, first, limit, color="C2", alpha=0.15, linewidth=0.0)
axes.text(0.02, 1.2, "elastic")
axes.text(0.01, 3.3, "elastic in the end")
axes.text(0.3, 3.4, "yields at each pass")
axes.set(xlabel="coefficient of friction [-]", ylabel="greatest pressure / strength in shear, $p_0/k$ [-]")
axes.set(xlim=(0.0, 0.5), ylim=(0.0, 4.4), title="what a raceway bears")
axes.legend(frameon=False)
plt.show()
