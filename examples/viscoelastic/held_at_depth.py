"""
Held at a depth: what relaxes, and what stays
=============================================

Press a bead into a gel at once and hold it there: the contact keeps its size, and the force falls as the gel relaxes,
as :math:`E(t)` does and nothing else. That makes the test the simplest of all to read. A real machine needs some time
to arrive; how long may that take before it shows?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

gel = wk.Prony(relaxed_shear=500.0, shears=[1500.0, 1000.0], relaxation_times=[0.05, 1.0])
bed = wk.Foundation(wk.Paraboloid(5e-6), wk.ViscoelasticHalfSpace(gel))
DEPTH = 0.5e-6

# %%
# At once
# -------

time = np.geomspace(1e-3, 30.0, 120)
held = wk.RelaxationTest(bed, DEPTH, time).solve()
figure, (left, right) = plt.subplots(1, 2, figsize=(10.0, 4.0), layout="constrained")
left.semilogx(time, 1e9 * held.force, label="pressed at once")
assert np.isclose(held.radius[0], np.sqrt(5e-6 * DEPTH))

# %%
# With a ramp
# -----------
# The same, arriving within a tenth of a second, a second and ten of them. What is left of the ramp fades with the gel's
# own times: a quick ramp is forgotten later than a slow one, counted in ramps.

for ramp, colour in ((0.1, "C1"), (1.0, "C2"), (10.0, "C3")):
    late = np.concatenate([[0.0], np.geomspace(0.01, 1.0, 40) * ramp, ramp + np.geomspace(1e-3, 30.0, 60)])
    depth = DEPTH * np.minimum(late / ramp, 1.0)
    real = wk.ViscoelasticIndentation(bed, wk.Path(late, wk.Depth(depth))).solve()
    left.semilogx(real.time[1:], 1e9 * real.force[1:], color=colour, label=f"within {ramp:g} s")
    after = real.time > ramp
    ideal = wk.RelaxationTest(bed, DEPTH, real.time[after]).solve().force
    error = real.force[after] / ideal - 1.0
    right.loglog(real.time[after] / ramp, error, color=colour, label=f"{ramp:g} s")
    far = real.time[after] > 5.0 * ramp
    if np.any(far):
        print(f"ramp of {ramp:4.1f} s: {error[0]:5.1%} too much at its end, {error[far][0]:.1%} five ramps later")
left.set(xlabel="time since the beginning [s]", ylabel="force [nN]", ylim=(0, None))
left.legend(frameon=False)
right.set(xlabel="time over that of the ramp [-]", ylabel="force above that of the step [-]", ylim=(1e-4, 1.0))
right.legend(frameon=False, title="ramp")
plt.show()
