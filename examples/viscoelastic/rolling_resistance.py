"""
What a steel ball meets that rolls over rubber
==============================================

Rubber that comes up behind the ball pushes it less than rubber that goes down before it held it back. The resistance is
small when the ball creeps, small when it races, and greatest in between, where the rubber has just no time to follow.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

rubber = wk.StandardSolid(relaxed_shear=0.5e6, shear=2.0e6, relaxation_time=1e-3)
LOAD = wk.Force(5.0)
speeds = np.geomspace(1e-3, 100.0, 50)

# %%
# Resistance over speed, for two balls
# ------------------------------------

figure, (left, right) = plt.subplots(1, 2, figsize=(10.0, 4.2), layout="constrained")
for radius, colour in ((5e-3, "C0"), (20e-3, "C1")):
    bed = wk.Foundation(wk.Paraboloid(radius), wk.ViscoelasticHalfSpace(rubber))
    rolled = wk.SlidingResistance(bed, LOAD, speeds).solve()
    left.semilogx(speeds, rolled.coefficient, color=colour, label=f"ball of {1e3 * radius:.0f} mm")
    right.semilogx(speeds, 1e3 * rolled.radius, color=colour, label="front edge")
    right.semilogx(speeds, 1e3 * rolled.trailing_edge, color=colour, linestyle="--", label="trailing edge")
    place = int(np.argmax(rolled.coefficient))
    print(f"{1e3 * radius:.0f} mm: at most {rolled.coefficient[place]:.3f} of the load, at {speeds[place]:.2f} m/s")
    assert 0 < place < speeds.size - 1
left.set(xlabel="speed [m/s]", ylabel="resistance over load [-]", ylim=(0, None))
left.legend(frameon=False)
right.axhline(0.0, color="0.7", linewidth=0.8)
right.set(xlabel="speed [m/s]", ylabel="place in the direction of motion [mm]")
right.legend(["front edge", "trailing edge"], frameon=False)
plt.show()

# %%
# How far to trust it
# -------------------
# The line of springs carries the whole slope of the profile, of which sliding sees a part: the resistance is brought to
# what is exact at low and at high speed, and is approximate between.

for note in rolled.validity:
    print(f"{note.standing.value}: {note.statement}")
