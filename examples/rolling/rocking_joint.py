r"""
Does a rocking contact hold?
============================

A ball between two plates carries a shear force, less than friction bears. Then the machine begins to vibrate, and the
ball rocks: it rolls to and fro by a fraction of its contact. Whatever leaves the contact forgets the load it bore, and
its neighbours must take it over. If they can, the ball comes to rest, a little farther on. If not, it creeps on.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# A ball, and the force it may bear
# ---------------------------------
# Only springs that never leave the contact can bear anything for ever, and they no more than their least bound:
# :math:`F_\mathrm{lim}/\mu F_N = 1-\frac32w+\frac12w^3`, where w is the amplitude over the contact radius.

steel = wk.Elastic(young=208e9, poisson=0.3)
bed = wk.Foundation(wk.Paraboloid(curvature_radius=10e-3), wk.HalfSpace.between(steel, steel))
MU, LOAD = wk.Coulomb(0.3), wk.Force(100.0)
contact = wk.Indentation(bed, LOAD).solve()
most, a = MU.coefficient * contact.force, contact.radius


def rocked(share, w=0.2, cycles=40):
    return wk.OscillatingRolling(bed, MU, w * a, share * most, LOAD, cycles=cycles).solve()


# %%
# Below and above the limit
# -------------------------
# A fifth of the contact radius: the limit is 0.704 of the sliding force.

figure, (left, right) = plt.subplots(1, 2, figsize=(10.0, 3.9), layout="constrained")
for share, colour in ((0.60, "C0"), (0.69, "C2"), (0.71, "C1"), (0.75, "C3")):
    answer = rocked(share)
    left.plot(answer.cycle, 1e6 * answer.shift, color=colour, label=f"{share:.2f}")
    print(
        f"{share:.2f} of the sliding force: {'creeps on' if answer.ratchets else 'comes to rest'}, "
        f"{1e9 * answer.shift_per_cycle:8.3f} nm in the last cycle"
    )
    assert answer.ratchets == (share > 0.704)
left.set(xlabel="cycles", ylabel="shift [µm]", title="a fifth of the contact radius", xlim=(0, None), ylim=(0, None))
left.legend(frameon=False, title="force over sliding force")

# %%
# How fast it creeps on
# ---------------------
# Just above the limit hardly at all; the closer to the sliding force, the faster.

for w, colour in ((0.1, "C0"), (0.2, "C1"), (0.4, "C2")):
    limit = rocked(0.1, w, cycles=1).shakedown_force / most
    shares = limit + (1.0 - limit) * np.linspace(0.02, 0.9, 14)
    steps = [rocked(share, w, cycles=25).shift_per_cycle for share in shares]
    right.semilogy(shares, 1e9 * np.array(steps), color=colour, marker=".", label=f"{w:g}")
    right.axvline(limit, color=colour, linewidth=0.8, linestyle=":")
    assert np.all(np.diff(steps) > 0.0)
right.set(
    xlabel="force over sliding force", ylabel="shift per cycle [nm]", title="above the limit (dotted)", ylim=(None, 3e4)
)
right.legend(frameon=False, loc="upper left", ncols=3, title="amplitude over radius")
plt.show()

# %%
# Check
# -----

assert np.isclose(rocked(0.5).shakedown_force / most, 0.704, rtol=1e-12)
assert rocked(0.69).shift_per_cycle < 1e-6 * rocked(0.71).shift[0]
