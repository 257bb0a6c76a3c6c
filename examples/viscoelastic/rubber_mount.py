"""
A rubber mount that is shaken
=============================

A steel ball stands on rubber and is shaken along the surface. Energy is lost twice: in the rubber, whatever happens,
and to friction, where the rim slides. Which of the two is larger depends on how fast and how far it is shaken.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

rubber = wk.StandardSolid(relaxed_shear=0.5e6, shear=1.5e6, relaxation_time=0.02)
bed = wk.Foundation(wk.Paraboloid(20e-3), wk.ViscoelasticHalfSpace(rubber))
DEPTH, MU = 0.5e-3, wk.Coulomb(0.7)


def shaken(amplitude, frequency, cycles=3, points=64):
    """Press for a second, then shake."""
    turn = np.linspace(0.0, cycles, cycles * points + 1)
    time = np.concatenate([[0.0], 1.0 + turn / frequency])
    shift = np.concatenate([[0.0], amplitude * np.sin(2.0 * np.pi * turn)])
    return wk.Tangential(bed, MU, wk.Path(time, wk.Depth(DEPTH), wk.Shift(shift)), count=200).solve()


# %%
# Loops
# -----
# Slowly the rubber is soft and hardly loses; fast it is stiff; at about one over the relaxation time it loses most.

figure, (left, right) = plt.subplots(1, 2, figsize=(10.0, 4.2), layout="constrained")
for frequency, colour in ((0.5, "C0"), (8.0, "C1"), (200.0, "C2")):
    answer = shaken(0.15e-3, frequency)
    last = answer.time >= answer.time[-1] - 1.0 / frequency - 1e-9
    left.plot(1e3 * answer.shift[last], answer.shear_force[last], color=colour, label=f"{frequency:g} Hz")
left.set(xlabel="shift [mm]", ylabel="shear force [N]", title="the third cycle")
left.legend(frameon=False)

# %%
# Where the energy goes
# ---------------------

frequencies = np.geomspace(0.3, 300.0, 11)
rubbed, bulk = [], []
for frequency in frequencies:
    answer = shaken(0.15e-3, frequency)
    start = np.argmin(np.abs(answer.time - (answer.time[-1] - 1.0 / frequency)))
    rubbed.append(answer.friction_loss[-1] - answer.friction_loss[start])
    bulk.append(answer.bulk_loss[-1] - answer.bulk_loss[start])
right.semilogx(frequencies, 1e6 * np.array(bulk), label="in the rubber")
right.semilogx(frequencies, 1e6 * np.array(rubbed), label="to friction")
right.set(xlabel="frequency [Hz]", ylabel="loss in the third cycle [µJ]", ylim=(0, None))
right.legend(frameon=False)
best = frequencies[int(np.argmax(bulk))]
print(f"the rubber loses most at about {best:.0f} Hz; 1/(2 pi tau) is {1 / (2 * np.pi * 0.02):.0f} Hz")
plt.show()
assert min(bulk) > 0.0
assert 2.0 < best < 80.0
