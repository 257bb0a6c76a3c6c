r"""
Logs of tests: loops of friction, contact resistance
====================================================

A ball rubs to and fro on a plate; the machine writes displacement and friction force of all cycles. Coefficient,
compliance of the frame, loss and slip follow from the loops, each with its error. Resistances over the force tell the
resistivity and the leads of a contact.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

data = Path("../data")
steel = wk.Elastic(young=210e9, poisson=0.3)
bed = wk.Foundation(wk.Paraboloid(curvature_radius=5e-3), wk.HalfSpace.between(steel, steel))
log = wk.read_friction_log(data / "logs/fretting_loops.csv")
loops = wk.FrictionLoops(bed, wk.Force(20.0), log, frame_compliance=50e-9).solve()

figure, axes = plt.subplots(1, 2, figsize=(9.5, 3.6), layout="constrained")
for place in (0, 5, len(log.cycles) - 1):
    low, _, end = log.cycles[place]
    axes[0].plot(1e6 * log.displacement[low:end], log.force[low:end], ".", markersize=3, label=f"cycle {place + 1}")
axes[0].plot(1e6 * loops.loop[0], loops.loop[1], "k", linewidth=1.0, label="fitted to the last")
axes[0].set(xlabel="displacement [µm]", ylabel="friction force [N]")
axes[0].margins(y=0.4)
axes[0].legend(frameon=False, loc="upper left", ncols=2)
axes[1].plot(np.arange(1, len(log.cycles) + 1), 1e6 * log.loss_per_cycle, ".")
axes[1].set(xlabel="cycle", ylabel="loss per cycle [µJ]", ylim=(0, None))
print(f"coefficient {loops.coefficient:.3f} ± {loops.coefficient_error:.1g}, made with 0.62")
print(f"contact {loops.contact_stiffness / 1e6:.1f} MN/m, of the bed {loops.expected_stiffness / 1e6:.1f} MN/m")

# %%
# Contact resistance over force
# -----------------------------

gold = wk.Elastic(young=79e9, poisson=0.42)
ball = wk.Foundation(wk.Paraboloid(curvature_radius=2e-3), wk.HalfSpace.between(gold, gold))
found = wk.MeasuredConstriction(ball, wk.read_resistance_log(data / "logs/contact_resistance.csv")).solve()
draw(found)
low, high = found.interval("resistivity")
print(f"resistivity {1e9 * low:.1f} to {1e9 * high:.1f} nohm m, made with 24")
assert low < 24e-9 < high
