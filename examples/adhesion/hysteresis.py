r"""
Closing for less than opening
=============================

Real surfaces give back less when they close than they take when they open: chains tangle, water bridges form, steps
of atoms pin the edge. With a work of closing :math:`w_c` and of opening :math:`w_o > w_c` the edge **rests** when the
motion turns: the ball first moves like a flat punch, along a straight line, and the loop is wide even where nothing
jumps.
"""

import matplotlib.pyplot as plt
import numpy as np

from winkler import Depth, Elastic, Foundation, HalfSpace, Paraboloid
from winkler.laws.adhesion import ShortRange
from winkler.problems.adhesion.cycle import AdhesiveCycle

RADIUS, OPENING = 1e-3, 0.5
silicone = HalfSpace.between(Elastic(young=2e6, poisson=0.5))
bed = Foundation(Paraboloid(curvature_radius=RADIUS), silicone)

# %%
# A loop in contact, and one to the end
# -------------------------------------

turns = 1e-6 * np.array([0.0, 12.0, 0.0, 8.0, 0.0, 12.0, -8.0])
path = np.concatenate([np.linspace(low, high, 300) for low, high in zip(turns[:-1], turns[1:], strict=True)])
figure, (forces, radii) = plt.subplots(1, 2, figsize=(10.5, 4.2), layout="constrained")
for ratio, colour in ((1.0, "0.6"), (0.5, "C0"), (0.1, "C1")):
    law = ShortRange(work_closing=ratio * OPENING, work_opening=OPENING)
    cycle = AdhesiveCycle(bed, law, Depth(path)).solve()
    name = f"closing gives {ratio:.0%} back"
    forces.plot(cycle.depth * 1e6, cycle.force * 1e3, color=colour, label=name)
    radii.plot(cycle.depth * 1e6, cycle.radius * 1e6, color=colour)
    share = cycle.hysteresis[-1] / cycle.dissipation[-1]
    print(f"{name}: {cycle.dissipation[-1] * 1e9:.2f} nJ lost, {share:.1%} of it by hysteresis")
forces.set(xlabel="depth d [µm]", ylabel="force F [mN]")
forces.legend(frameon=False)
radii.set(xlabel="depth d [µm]", ylabel="contact radius a [µm]")
plt.show()

# %%
# How deep one has pressed
# ------------------------
# Without hysteresis the pull-off takes 7.09 units of energy, however firmly the ball was pressed on. With it, every
# square micrometre that was closed has its price.

depths = np.linspace(5e-6, 150e-6, 40)
figure, axes = plt.subplots(figsize=(6.5, 3.8), layout="constrained")
for ratio, colour in ((1.0, "0.6"), (0.5, "C0"), (0.1, "C1")):
    law = ShortRange(work_closing=ratio * OPENING, work_opening=OPENING)
    lost = [AdhesiveCycle(bed, law, Depth([depth, -1e-4])).solve().dissipation[-1] for depth in depths]
    axes.plot(depths * 1e6, np.array(lost) * 1e9, color=colour, label=f"closing gives {ratio:.0%} back")
    if ratio == 1.0:
        unit = (OPENING**5 * RADIUS**4 / silicone.modulus**2) ** (1 / 3)
        assert np.allclose(np.array(lost) / unit, 7.092195972, rtol=1e-9)
axes.set(xlabel="greatest depth [µm]", ylabel="energy lost in the cycle [nJ]", ylim=(0, None))
axes.legend(frameon=False)
plt.show()
