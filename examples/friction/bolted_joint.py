r"""
How tight should a bolt be?
===========================

Most of the damping of a machine comes from its joints. Under the washer of a bolt the surfaces are pressed together and
pushed to and fro by the vibration; what slides is a ring at the edge. A tight bolt damps little, because nothing
slides; a loose one little, because nothing presses, and it may come off. Between lies a preload that damps most.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# The washer
# ----------
# Steel on steel, a flat face of 8 mm radius whose edge is rounded, with 0.15 as the coefficient of friction. Under a
# sharp edge nothing would slide before everything does, and nothing would be lost: the rounding makes the damping.

FLAT, FRICTION = 8e-3, wk.Coulomb(0.15)
steel = wk.Elastic(young=210e9, poisson=0.3)
medium = wk.HalfSpace.between(steel, steel)
washers = {
    edge: wk.Foundation(wk.RoundedPunch(flat_radius=FLAT, edge_radius=edge), medium) for edge in (10e-3, 0.1, 1.0)
}
sharp = wk.Foundation(wk.FlatPunch(radius=FLAT), medium)

# %%
# The same shear force, more and more preload
# -------------------------------------------
# The vibration pushes with 300 N to each side. Preloads below 2 kN would not hold it: the joint slides away, and
# winkler refuses the question. The loss falls with the preload; how fast depends on the edge.

PUSH = 300.0
least = PUSH / FRICTION.coefficient
preload = least * np.geomspace(1.0, 12.0, 20)
figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
for (edge, washer), colour in zip(washers.items(), ("C0", "C1", "C2"), strict=True):
    swings = [wk.FrictionDamping(washer, FRICTION, wk.Force(one), wk.ShearForce(PUSH)).solve() for one in preload]
    loss = np.array([swing.loss_per_cycle for swing in swings])
    left.loglog(preload / 1e3, loss * 1e6, color=colour, label=f"{edge * 1e3:g} mm")
    fall = np.diff(np.log(loss)) / np.diff(np.log(preload))
    print(f"edge {edge * 1e3:6g} mm: {loss[0] * 1e6:7.3f} uJ at the limit, then as the preload to the {fall[-1]:.2f}")
    assert np.all(np.diff(loss) < 0.0)
nothing = wk.FrictionDamping(sharp, FRICTION, wk.Force(1.01 * least), wk.ShearForce(PUSH)).solve()
assert nothing.loss_per_cycle == 0.0
try:
    wk.FrictionDamping(washers[0.1], FRICTION, wk.Force(0.9 * least), wk.ShearForce(PUSH)).solve()
except wk.OutsideValidity as refusal:
    print(f"\n{refusal}\n")
left.axvline(least / 1e3, color="0.6", linewidth=0.8)
left.text(least / 1e3 * 1.03, left.get_ylim()[0] * 1.5, "slides away to the left", color="0.4")
left.set(xlabel="preload [kN]", ylabel="loss per cycle [µJ]", title=f"a shear force of {PUSH:g} N")
left.set_xticks([2, 5, 10, 20], ["2", "5", "10", "20"])
left.minorticks_off()
left.legend(frameon=False, fontsize="small", title="edge rounded with")

# %%
# The same shift
# --------------
# Where the vibration prescribes how far the surfaces are moved, half a micrometre, a loose joint slides and loses
# :math:`4\mu FU`; a tight one sticks. The best preload lies between, at about half of what would hold it.

SHIFT = 0.5e-6
preload = np.geomspace(0.2e3, 30e3, 45)
best = {}
for (edge, washer), colour in zip(washers.items(), ("C0", "C1", "C2"), strict=True):
    swings = [wk.FrictionDamping(washer, FRICTION, wk.Force(one), wk.Shift(SHIFT)).solve() for one in preload]
    loss = np.array([swing.loss_per_cycle for swing in swings])
    right.semilogx(preload / 1e3, loss * 1e6, color=colour, label=f"{edge * 1e3:g} mm")
    top = int(np.argmax(loss))
    best[edge] = preload[top]
    right.plot(preload[top] / 1e3, loss[top] * 1e6, "o", color=colour)
    swing = swings[top]
    print(
        f"edge {edge * 1e3:6g} mm: best at {preload[top] / 1e3:.2f} kN, {loss[top] * 1e6:.1f} uJ per cycle, loss "
        f"factor {swing.loss_factor:.3f}, at 100 Hz a damper of {swing.damping(100.0) / 1e3:.2f} kN s/m"
    )
right.set(xlabel="preload [kN]", ylabel="loss per cycle [µJ]", title=f"a shift of {SHIFT * 1e6:g} µm", ylim=(0, None))
right.legend(frameon=False, fontsize="small", title="edge rounded with", loc="center right")
plt.show()

# %%
# Check
# -----
# A sharp punch slides as a whole: :math:`W = 4\mu F(U-\mu F/2G^*b)`, greatest at :math:`\mu F = G^*bU`, half of the
# force that holds it. A rounded edge moves that a little.

flat_best = medium.shear_modulus * FLAT * SHIFT / FRICTION.coefficient
flat = wk.FrictionDamping(sharp, FRICTION, wk.Force(flat_best), wk.Shift(SHIFT)).solve()
assert np.isclose(flat.loss_per_cycle, 2.0 * medium.shear_modulus * FLAT * SHIFT**2, rtol=1e-12)
assert np.isclose(best[10e-3], flat_best, rtol=0.15)
