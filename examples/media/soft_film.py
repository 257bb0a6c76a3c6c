r"""
A soft film on a rigid base
===========================

Gels, rubber and cartilage are often measured as films on glass. Hertz's formula then reads the glass into the film. The
usual remedies are polynomials in :math:`\chi = \sqrt{Rd}/h`, good over part of the range. The layer itself can be
computed just as well: any thickness, any Poisson ratio, one half included, and with the true shape of the probe.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# Force over Hertz's force
# ------------------------
# A bead of 100 µm on a gel of 10 µm. The marks are two polynomials for incompressible films bonded to glass: that of
# Dimitriadis and others (Biophys. J. 82, 2002, 2798-2810) and the later one of Garcia and Garcia (Biophys. J. 114,
# 2018, 2923-2932). They answer the same question; the layer itself decides between them.

THICKNESS, RADIUS = 10e-6, 100e-6
force, axes = plt.subplots(figsize=(5.8, 4.0), layout="constrained")
chi = np.linspace(0.02, 1.0, 80)
films = {
    poisson: wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young=10e3, poisson=poisson), THICKNESS)], on=wk.Rigid())
    for poisson in (0.3, 0.45, 0.49, 0.5)
}
ratios = {}
for poisson, film in films.items():
    bed = wk.Foundation(wk.Paraboloid(RADIUS), film)
    contact = wk.Indentation(bed, wk.Depth((chi * THICKNESS) ** 2 / RADIUS)).solve()
    ratios[poisson] = contact.force / (4 / 3 * film.modulus * np.sqrt(RADIUS) * contact.depth**1.5)
    axes.plot(chi, ratios[poisson], label=f"Poisson's ratio {poisson}")
polynomials = {
    "Dimitriadis 2002": 1 + 1.133 * chi + 1.283 * chi**2 + 0.769 * chi**3 + 0.0975 * chi**4,
    "Garcia 2018": 1 + 1.133 * chi + 1.497 * chi**2 + 1.469 * chi**3 + 0.755 * chi**4,
}
for (name, values), mark in zip(polynomials.items(), "os", strict=True):
    axes.plot(chi[::6], values[::6], "k" + mark, fillstyle="none", markersize=5, label=f"{name}, for 0.5")
    off = np.abs(values / ratios[0.5] - 1)
    print(f"{name}: within {np.max(off[chi < 0.4]):.1%} for chi < 0.4, {off[-1]:.0%} off at chi = 1")
assert np.max(np.abs(polynomials["Garcia 2018"] / ratios[0.5] - 1)[chi < 0.4]) < 0.005
axes.set(xlabel=r"$\chi=\sqrt{Rd}\,/\,h$", ylabel="force / Hertz's force", xlim=(0, 1), ylim=(1, 8))
axes.legend(frameon=False)

# %%
# What is read into the film
# --------------------------
# Somebody who fits Hertz's formula finds the film stiffer by just this factor; and a Poisson ratio of 0.49 in place of
# 0.5 matters as soon as the contact is wider than the film is thick.

for poisson, ratio in ratios.items():
    print(
        f"Poisson's ratio {poisson}: Hertz's modulus is {np.interp(0.5, chi, ratio):.2f} times too large at chi = 0.5"
    )

# %%
# Pressure
# --------
# Squeezed to a contact many times wider than thick, an incompressible film carries the load like a viscous fluid in a
# gap: the pressure falls steeply from the middle, and outside the film bulges above its old surface.

shape, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8), layout="constrained")
bed = wk.Foundation(wk.Paraboloid(RADIUS), films[0.5])
for ratio in (0.1, 2.0, 8.0):
    contact = wk.Indentation(bed, wk.Radius(ratio * THICKNESS)).solve()
    r = np.linspace(0, 1.6, 161) * contact.radius
    surface = wk.restore(contact, r)
    left.plot(r / contact.radius, surface.pressure / contact.mean_pressure, label=f"a = {ratio:g} h")
    right.plot(r / contact.radius, -surface.displacement / contact.depth)
    inside = r < 0.99 * contact.radius
    body = contact.depth - r**2 / (2 * RADIUS)
    assert np.allclose(surface.displacement[inside], body[inside], rtol=0, atol=1e-8 * contact.depth)
left.set(xlabel="r / a", ylabel="pressure / mean pressure", xlim=(0, 1.6), ylim=(0, None))
right.axhline(0.0, color="0.7", linewidth=1)
right.set(xlabel="r / a", ylabel="height of the surface / depth", xlim=(0, 1.6))
left.legend(frameon=False)
assert surface.displacement[-1] < 0.0  # it bulges
plt.show()
