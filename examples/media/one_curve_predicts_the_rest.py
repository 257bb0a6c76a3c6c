"""
One measured curve predicts the rest
====================================

Somebody presses a body that is not round into a half-space and gives you the force curve, with scatter. Two functions
decide everything else about this contact, its stiffness k and its depth, and the curve holds both: the
stiffness is its slope. So the same curve predicts other loads, the energy, the tangential stiffness, and even the
electrical and thermal resistance of the contact. This page checks each against the exact answer.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

import winkler as wk

# %%
# The exact answers
# -----------------
# The body is an elliptic paraboloid, z = x²/4R + y²/2R: Hertz solved it, with complete elliptic integrals K and E of
# m = 1 - b²/a². These lines know the body; nothing below does.

R = 1e-3
glass = wk.Elastic(young=70e9, poisson=0.22)
half_space = wk.HalfSpace.between(glass)
modulus, nu, shear = half_space.modulus, glass.poisson, glass.shear


def ratio(m: float) -> float:
    """Return the ratio of both curvatures."""
    return (ellipe(m) / (1.0 - m) - ellipk(m)) / (ellipk(m) - ellipe(m))


m = brentq(lambda m: ratio(m) - 2.0, 0.01, 0.99)
K, E = ellipk(m), ellipe(m)
constant = 2.0 * np.pi / 3.0 * modulus / K * np.sqrt(4.0 * R * (K - E) / (m * K))
assert np.isclose(constant / (modulus * np.sqrt(R)), 1.6014550, rtol=1e-6)  # as a boundary-element code finds, too


def semi_axes(d: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the half axes a > b of the contact ellipse at a depth."""
    a = np.sqrt(4.0 * R * d * (K - E) / (m * K))
    return a, a * np.sqrt(1.0 - m)


def stiffness(d: np.ndarray) -> np.ndarray:
    """Return dF/dd of F = constant d^(3/2)."""
    return 1.5 * constant * np.sqrt(d)


def tangential(d: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the tangential stiffness along a and along b (no slip), from the displacement under an elliptic punch."""
    a, b = semi_axes(d)
    angle = np.linspace(0.0, np.pi / 2.0, 2001)
    radius = 1.0 / np.sqrt((np.cos(angle) / a[:, None]) ** 2 + (np.sin(angle) / b[:, None]) ** 2)
    total, along = (4.0 * np.trapezoid(radius * weight, angle) for weight in (1.0, np.cos(angle) ** 2))
    across = total - along
    return tuple(8.0 * np.pi * shear * a * b / ((1.0 - nu) * total + nu * part) for part in (along, across))


def resistance(d: np.ndarray, resistivity: float) -> np.ndarray:
    """Return the constriction resistance of an elliptic spot between two half-spaces of one resistivity (Holm)."""
    return resistivity * K / (np.pi * semi_axes(d)[0])


# %%
# The measurement
# ---------------
# 400 points with a scatter of one part in a thousand. From them a convex curve is fitted, because the stiffness of a
# growing contact can only rise; how far it misses the points is part of the answer.

depth = np.linspace(0.0, 1e-6, 401)
force = constant * depth**1.5
measured = force + 1e-3 * force[-1] * np.random.default_rng(3).standard_normal(depth.size)
bed = wk.MeasuredBed.from_curve(depth, measured, modulus, mindlin_ratio=half_space.shear_modulus / modulus)
for note in bed.notes:
    print(note)

# %%
# What it predicts
# ----------------
# Mindlin's ratio G*/E* = 2(1 - nu)/(2 - nu) turns normal into tangential stiffness; for an ellipse it is exact for the
# compliance averaged over both directions. And by Barber's analogy (2003) normal stiffness and conductance of a contact
# are one and the same function of its shape, round or not: between half-spaces of resistivities rho
#
# .. math:: \frac1{R_\text{el}} = \frac{2}{(\varrho_1+\varrho_2)\,E^*}\,\frac{\mathrm dF}{\mathrm dd} ,
#
# and heat flows likewise, with resistivities 1/lambda.

load = wk.Force(np.linspace(0.1, 0.95, 35) * force[-1])
answer = wk.Indentation(bed, load).solve()
exact_depth = (load.force / constant) ** (2.0 / 3.0)
k = stiffness(exact_depth)
x, weights = np.polynomial.legendre.leggauss(64)
shaken = np.array([a * (weights @ bed.tangential_stiffness(0.5 * a * (x + 1.0))) for a in answer.radius])
along, across = tangential(exact_depth)
copper = 1.7e-8  # ohm m: the same shape pressed equally deep, but of copper on copper
predicted_ohm = copper * modulus / answer.stiffness
exact_ohm = resistance(exact_depth, copper)

checks = {
    "depth": (answer.depth, exact_depth),
    "energy": (answer.energy, 0.4 * load.force * exact_depth),
    "stiffness": (answer.stiffness, k),
    "tangential stiffness, mean": (shaken, 2.0 / (1.0 / along + 1.0 / across)),
    "resistance": (predicted_ohm, exact_ohm),
}
for word, (found, exact) in checks.items():
    error = np.max(np.abs(found / exact - 1.0))
    print(f"{word:>27}: within {100 * error:.2f} %")
    assert error < 0.02
print(f"  each direction for itself: {along[0] / shaken[0]:.3f} and {across[0] / shaken[0]:.3f} of the predicted one")

# %%
# What it cannot say
# ------------------
# Many bodies share one force curve. Where the pressure is, or what the body looks like, winkler refuses to tell.

try:
    wk.restore(answer.at(0), 0.0)
except wk.OutsideValidity as refusal:
    print(refusal)

# %%
# Only if you may add that the body is round, `design_profile` returns the one body of revolution that would have given
# this curve: here a paraboloid in between both curvatures.

round_body = wk.design_profile(depth[1:], force[1:], half_space)
a = round_body.reach
print(f"the round body of equal stiffness has R = {a**2 / (2 * round_body.height(np.array([a]))[0]) * 1e3:.3f} mm")

figure, axes = plt.subplots(1, 3, figsize=(11.5, 3.7), layout="constrained")
axes[0].plot(depth[::4] * 1e9, measured[::4], ".", color="0.6", markersize=4, label="measured")
axes[0].plot(answer.depth * 1e9, answer.force, "C0", label="bed from the curve")
axes[0].set(xlabel="depth [nm]", ylabel="force [N]", title="the one curve")
axes[1].plot(load.force, k * 1e-6, "k", linewidth=1, label="exact, normal")
axes[1].plot(load.force[::3], answer.stiffness[::3] * 1e-6, "oC0", markersize=4, label="from the curve")
axes[1].fill_between(load.force, across * 1e-6, along * 1e-6, color="C1", alpha=0.3, label="exact, along and across")
axes[1].plot(load.force[::3], shaken[::3] * 1e-6, "sC1", markersize=4, label="tangential, from the curve")
axes[1].set(xlabel="force [N]", ylabel="stiffness [N/µm]", title="stiffness")
axes[2].plot(load.force, exact_ohm * 1e6, "k", linewidth=1, label="exact (Holm)")
axes[2].plot(load.force[::3], predicted_ohm[::3] * 1e6, "oC2", markersize=4, label="from the curve")
axes[2].set(xlabel="force [N]", ylabel="resistance of copper [microohm]", title="electrical resistance")
for panel in axes:
    panel.set_xlim(left=0)
    panel.set_ylim(bottom=0)
    panel.legend(frameon=False)
plt.show()
