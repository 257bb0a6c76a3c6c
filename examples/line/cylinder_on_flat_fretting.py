r"""
A cylinder frets on a flat
==========================

A fatigue specimen is clamped between cylindrical pads. Each cycle pulls it, and the pads, which are held, resist: a
shear force per length :math:`Q` and a bulk stress :math:`\sigma_B` change in phase. The middle of the contact sticks,
its edges slip, and at the trailing edge the stress is where cracks begin.

The traction is that of a sliding contact less that of an earlier, narrower one (Cattaneo; Johnson 1985, section 7.2),

.. math:: q(x) = \mu\,[p(x;P) - p(x;\gamma)], \qquad Q = \mu\,(P-\gamma),

and the bulk stress shifts the latter by :math:`e = \sigma_B a/(4\mu p_0)` (Nowell and Hills 1987).
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# Without a bulk stress
# ---------------------
# Pads of 50 mm radius of the same aluminium press with 400 N/mm; the shear force goes to and fro.

aluminium = wk.Elastic(young=73e9, poisson=0.33)
bed = wk.LineFoundation(wk.Paraboloid(curvature_radius=50e-3), wk.HalfSpace.between(aluminium, aluminium))
PRESS, SHEAR, MU = 400e3, 120e3, 0.6
there_and_back = [0.0, SHEAR, -SHEAR, SHEAR]
rubbed = wk.LineTangential(bed, wk.Coulomb(MU), wk.LinePath(PRESS, there_and_back, count=50)).solve()
a, c = rubbed.half_width[50], rubbed.stick_half_width[50]
assert np.isclose(c / a, np.sqrt(1.0 - SHEAR / (MU * PRESS)), rtol=1e-12)
cycle = rubbed.dissipation_per_length[-1] - rubbed.dissipation_per_length[50]
print(f"half-width {a * 1e3:.3f} mm, of which {c * 1e3:.3f} mm stick at the turning points")
print(f"one cycle loses {cycle * 1e3:.2f} mJ for each metre of the pad")

draw(rubbed)

# %%
# With a bulk stress
# ------------------
# A tension of 120 MPa at the peak of the shear force shifts what sticks: the slip zones are no longer alike, and the
# wider one, at the trailing edge, slips more.

pulled = wk.LineTangential(bed, wk.Coulomb(MU), wk.LinePath(PRESS, there_and_back, bulk_stress=120e6, count=50)).solve()
peak, plain = pulled.at(50), rubbed.at(50)
p0 = 2.0 * PRESS / (np.pi * a)
assert np.isclose(peak.stick_middle, 120e6 * a / (4.0 * MU * p0), rtol=1e-12)
for edge, name in ((-a, "trailing"), (a, "leading")):
    amplitude = 0.5 * (peak.slip(edge) - pulled.at(100).slip(edge))
    print(f"{name} edge: slip amplitude {amplitude * 1e6:.2f} um, without bulk stress {plain.slip(edge) * 1e6:.2f} um")

draw(peak)

# %%
# Out of phase
# ------------
# The specimen is pulled a quarter of a cycle after the pads are pushed. The stress is stated at every point, and the
# contact is marched along on boundary elements: once it is pulled in phase with so much tension that an edge slips
# back, once out of phase.

turn = np.linspace(0.0, 4.5 * np.pi, 73)
for lag, name in ((0.0, "in phase"), (0.5 * np.pi, "a quarter behind")):
    path = wk.LinePath(PRESS, SHEAR * np.sin(turn), bulk_stress=350e6 * np.sin(turn - lag))
    marched = wk.LineTangential(bed, wk.Coulomb(MU), path).solve()
    lost = marched.dissipation_per_length[-1] - marched.dissipation_per_length[-33]
    stuck = np.min(marched.stick_half_width[-33:])
    print(f"{name}: at least {stuck / a:.2f} of the half-width sticks, a cycle loses {lost * 1e3:.2f} mJ/m")

draw(marched)

# %%
# The stress along the surface
# ----------------------------
# Sliding alone would pull the trailing edge by :math:`2\mu p_0`; partial slip pulls it less, and the bulk
# stress adds.

x = np.linspace(-2.0, 2.0, 801) * a
figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
for state, colour, name in ((plain, "C0", "shear force"), (peak, "C3", "shear force and bulk stress")):
    along = state.stresses(x, 0.0).xx_stress
    axes.plot(x * 1e3, along * 1e-6, colour, label=name)
    print(f"{name}: at the trailing edge {state.stresses(-a, 0.0).xx_stress * 1e-6:.0f} MPa")
slid = wk.LineTangential(bed, wk.Coulomb(MU), wk.LinePath(PRESS, [0.0, MU * PRESS])).solve().at(-1)
assert np.isclose(slid.stresses(-a, 0.0).xx_stress, 2.0 * MU * p0, rtol=1e-9)
axes.plot(x * 1e3, slid.stresses(x, 0.0).xx_stress * 1e-6, "0.6", linestyle="--", label="sliding")
axes.axhline(0.0, color="0.3", linewidth=0.8)
axes.set(xlabel="x [mm]", ylabel=r"$\sigma_x$ at the surface [MPa]", title="stress along the surface of the specimen")
axes.legend(frameon=False)
plt.show()
