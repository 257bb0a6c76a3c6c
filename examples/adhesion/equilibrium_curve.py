r"""
Every state a sticky ball can be in
===================================

A force curve shows only the states in which a contact stays. Behind it lies a curve of *all* equilibria, one for each
contact radius. Where it turns back, the machine decides: what a stiff stage still holds, a soft cantilever has lost.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

RADIUS, WORK = 1e-3, 0.05
rubber = wk.HalfSpace.between(wk.Elastic(young=1e6, poisson=0.5))
ball = wk.Foundation(wk.Paraboloid(RADIUS), rubber)

# %%
# One curve, three machines
# -------------------------
# Thick where the contact is stable, thin where it is not: in fixed grips down to five sixths of :math:`\pi w R`, under
# a dead load to three halves of it, on a cantilever somewhere between.

unit = np.pi * WORK * RADIUS
figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.2), layout="constrained")
machines = (
    (0.0, "dead load", "C3", 6.0),
    (100.0, "cantilever, 100 N/m", "C1", 3.5),
    (np.inf, "fixed grips", "C0", 1.4),
)
for stiffness, name, colour, width in machines:
    curve = wk.Equilibrium(ball, wk.ShortRange(WORK), reach=4e-4, machine_stiffness=stiffness, count=400).solve()
    is_stable = curve.stable
    held = np.where(is_stable, curve.force, np.nan)
    left.plot(1e6 * curve.depth, held / unit, color=colour, linewidth=width, label=name)
    lowest = curve.force[np.argmax(is_stable)] / unit  # the smallest contact that holds
    print(f"{name:20s} comes off at {lowest:.3f} pi w R")
left.plot(1e6 * curve.depth, curve.force / unit, color="0.6", linewidth=0.8, zorder=0)
left.set(xlabel="depth d [µm]", ylabel=r"force over $\pi w R$ [-]", xlim=(-3, 4), ylim=(-1.7, 1.5))
left.legend(frameon=False, title="stable with")
assert abs(lowest + 5 / 6) < 1e-3

# %%
# A wavy ball has several
# -----------------------
# Waves make the curve wind: a ball of 0.23 m on gelatine, with waves of 6 mm. Each piece that is stable ends in a jump
# to the next one.

gelatine = wk.HalfSpace.between(wk.Elastic(young=28e3, poisson=0.5))
law, radius = wk.ShortRange(8.0), 0.23
wavy = wk.Foundation(wk.Paraboloid(radius) + wk.Wavy(amplitude=0.12e-3, wavelength=6e-3), gelatine)
curve = wk.Equilibrium(wavy, law, reach=40e-3, count=1500).solve()
unit = np.pi * law.work * radius
right.plot(1e3 * curve.depth, curve.force / unit, color="0.6", linewidth=0.8)
right.plot(1e3 * curve.depth, np.where(curve.stable, curve.force, np.nan) / unit, color="C0", linewidth=2.2)
right.set(xlabel="depth d [mm]", ylabel=r"force over $\pi w R$ [-]", title=f"wavy: {len(curve.branches)} stable pieces")
plt.show()
assert len(curve.branches) > 2
