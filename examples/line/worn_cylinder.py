r"""
A fretting cylinder wears
=========================

A cylindrical pad is sheared to and fro on a flat, by less than what makes it slide. Its edges slip and wear; the strip
in its middle sticks. Which part of the load does that strip bear after a million cycles, and how wide is it then?

It sticks where the narrower contact under :math:`\gamma = P - Q/\mu` would be. What that contact is depends on the
shape within it alone, which does not wear: its half-width c stays, and in the end it bears everything.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# The contact
# -----------
# Steel on steel, 10 mm radius, 100 N for each millimetre; the shear force reaches three quarters of what friction
# bears, so that half of the contact sticks.

steel = wk.Elastic(young=210e9, poisson=0.3)
bed = wk.LineFoundation(wk.Paraboloid(curvature_radius=10e-3), wk.HalfSpace.between(steel, steel))
friction, load, swing = wk.Coulomb(0.5), wk.LineForce(100e3), wk.LineShearForce(37.5e3)

# %%
# Cycle after cycle
# -----------------

cycles = np.array([0.0, 3e4, 1e5, 3e5, 1e6, 1e7])
worn = wk.LineFrettingWear(bed, wk.Archard(1e-14), friction, load, swing, cycles, count=120).solve()
limit = wk.LineLimitingProfile(bed, friction, load, swing).solve()
assert np.allclose(worn.stick_half_width, limit.stick_half_width, rtol=1e-9)

figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
for state in worn.states:
    left.plot(1e6 * state.places, 1e9 * state.worn, label=f"{state.elapsed:,.0f} cycles")
    right.plot(1e6 * state.places, 1e-9 * state.pressure)
x = np.linspace(0.0, 1.1 * limit.half_width, 800)
left.plot(1e6 * x, 1e9 * limit.worn(x), "k:", label="the limit")
left.set(xlabel="x [µm]", ylabel="worn depth [nm]", title="Worn off")
right.set(xlabel="x [µm]", ylabel="pressure [GPa]", title="Pressure", ylim=(0.0, 1.6))
figure.legend(loc="outside lower center", ncols=7, frameon=False, fontsize=8.5)
plt.show()

# %%
# Two methods for the same shape
# ------------------------------
# The limit is a closed form: Hertz' pressure of the narrower contact, and that of a flat punch for the rest,
#
# .. math:: \Delta f(x) = \frac{1}{2R}\Big[a^2\,\mathrm{arcosh}\frac xc - x\sqrt{x^2-c^2}\Big] .

a, c = worn.half_width[0], limit.stick_half_width
assert np.isclose(
    limit.worn(1.2 * a), (a**2 * np.arccosh(1.2 * a / c) - 1.2 * a * np.sqrt((1.2 * a) ** 2 - c**2)) / 20e-3
)
miss = worn.worn_volume_per_length[-1] / limit.worn_volume_per_length - 1.0
print(f"what sticks is {c * 1e6:.1f} um to each side; wear ends at {limit.half_width * 1e6:.1f} um")
print(f"the march has come within {abs(miss):.1%} of the volume")
assert abs(miss) < 0.01

# %%
# Sliding
# -------
# A roller that slides instead is worn to a flat of the cross-section :math:`\kappa P s`, which is :math:`2a^3/3R`.

distance = np.array([0.0, 10.0, 100.0, 1000.0])
slid = wk.LineSlidingWear(bed, wk.Archard(1e-14), load, distance, count=80).solve()
flat = np.cbrt(1.5 * 10e-3 * 1e-14 * 100e3 * distance[1:])
for far, half, cap in zip(distance[1:], slid.half_width[1:], flat, strict=True):
    print(f"{far:5.0f} m: half-width {half * 1e3:.3f} mm, of a rigid roller {cap * 1e3:.3f} mm")
assert np.allclose(slid.half_width[1:], flat, rtol=0.03)
