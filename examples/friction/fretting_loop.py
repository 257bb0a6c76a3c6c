r"""
A fretting loop, and what it costs
==================================

A ball pressed on a plate and rubbed to and fro by fractions of a micrometre does not slide: only a ring at the edge of
the contact does. Force over shift is a narrow loop, and its area is the energy lost in a cycle. It grows with the cube
of the amplitude, until the ring has eaten up the contact and the ball slides.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.reference.damping import ball_loss, small_loss

# %%
# The contact
# -----------
# A ball of 10 mm radius, of steel like the plate, under 100 N, with a coefficient of friction of 0.6. Sliding begins
# at the shift :math:`U_c = \mu d E^*/G^*`.

FORCE, FRICTION = 100.0, wk.Coulomb(0.6)
steel = wk.Elastic(young=210e9, poisson=0.3)
medium = wk.HalfSpace.between(steel, steel)
bed = wk.Foundation(wk.Paraboloid(curvature_radius=10e-3), medium)
contact = wk.Indentation(bed, wk.Force(FORCE)).solve()
sliding = FRICTION.coefficient * contact.depth * medium.modulus / medium.shear_modulus
print(f"contact radius {contact.radius * 1e6:.1f} um, sliding begins at {sliding * 1e6:.3f} um")

# %%
# Loops
# -----
# ``Tangential`` marches along a path: up to the amplitude, back, and round again. Between turning points nothing needs
# to be refined, the points between are there for the picture.

figure, (loops, losses) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
cycles = np.concatenate([np.linspace(0.0, 1.0, 21), *[s * np.linspace(1.0, -1.0, 41)[1:] for s in (1, -1, 1, -1)]])
for part, colour in ((0.4, "C0"), (0.9, "C1"), (1.5, "C3")):
    path = wk.Path.through(wk.Force(FORCE), wk.Shift(part * sliding * cycles))
    rubbed = wk.Tangential(bed, FRICTION, path).solve()
    loops.plot(rubbed.shift * 1e6, rubbed.shear_force, color=colour, label=f"{part:g} of the sliding shift")
    lost = rubbed.dissipation[-1] - rubbed.dissipation[-81]
    swing = wk.FrictionDamping(bed, FRICTION, wk.Force(FORCE), wk.Shift(part * sliding)).solve()
    print(f"{part:g} U_c: {lost * 1e6:8.4f} uJ in a cycle, loss factor {swing.loss_factor:.4f}")
    assert np.isclose(lost, swing.loss_per_cycle, rtol=1e-9)
loops.set(xlabel="shift $u_x$ [µm]", ylabel="shear force $F_x$ [N]", title="loops of force and shift")
loops.legend(frameon=False, fontsize="small", loc="upper left")

# %%
# Loss per cycle
# --------------
# ``FrictionDamping`` gives it for all amplitudes at once. The dashed line is the cube, with :math:`g'(a) = 2a/R`.

amplitude = sliding * np.geomspace(0.02, 5.0, 200)
swing = wk.FrictionDamping(bed, FRICTION, wk.Force(FORCE), wk.Shift(amplitude)).solve()
cube = small_loss(
    amplitude,
    coefficient=FRICTION.coefficient,
    gap_slope=2.0 * contact.radius / 10e-3,
    modulus=medium.modulus,
    shear_modulus=medium.shear_modulus,
)
losses.loglog(amplitude * 1e6, swing.loss_per_cycle * 1e6, color="C4", label="loss per cycle")
losses.loglog(amplitude[:120] * 1e6, cube[:120] * 1e6, "k--", linewidth=1, label="cube of the amplitude")
losses.axvline(sliding * 1e6, color="0.6", linewidth=0.8)
losses.set(xlabel="amplitude of the shift [µm]", ylabel="loss per cycle [µJ]", title="loss and loss factor")
factor = losses.twinx()
factor.semilogx(amplitude * 1e6, swing.loss_factor, color="C2", label="loss factor")
factor.set(ylabel="loss factor [-]", ylim=(0.0, 1.8))
factor.axhline(4.0 / np.pi, color="C2", linewidth=0.8, linestyle=":")
factor.text(amplitude[0] * 1e6, 1.2, r"$4/\pi$", color="C2")
lines = [*losses.get_lines()[:2], factor.get_lines()[0]]
losses.legend(lines, [line.get_label() for line in lines], frameon=False, fontsize="small", loc="upper left")
plt.show()

# %%
# Check
# -----
# Against Mindlin and Deresiewicz, and the limits: the cube, and :math:`4/\pi` for sliding throughout.

partial = amplitude < sliding
closed = ball_loss(
    swing.shear_force[partial],
    force=FORCE,
    coefficient=FRICTION.coefficient,
    radius=contact.radius,
    shear_modulus=medium.shear_modulus,
)
assert np.allclose(swing.loss_per_cycle[partial], closed, rtol=1e-7)
assert np.isclose(swing.loss_per_cycle[0] / cube[0], 1.0, atol=0.02)
assert np.all(np.diff(swing.loss_factor) > 0.0)
assert swing.loss_factor[-1] < 4.0 / np.pi
