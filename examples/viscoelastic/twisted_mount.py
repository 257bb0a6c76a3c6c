"""
A rubber mount that is twisted, and a roller that is shaken
===========================================================

A steel ball on rubber is twisted to and fro about its axis, and a steel roller on the same rubber is shaken along it.
Both lose energy in the rubber and to friction. Which is larger depends on how fast they are moved.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

TAU, MU = 0.02, wk.Coulomb(0.6)
rubber = wk.StandardSolid(relaxed_shear=0.5e6, shear=1.5e6, relaxation_time=TAU)
on_rubber = wk.ViscoelasticHalfSpace(rubber)
ball = wk.Foundation(wk.Paraboloid(20e-3), on_rubber)
TURN = np.linspace(0.0, 2.0, 65)
WAVE = np.append(0.0, np.sin(2.0 * np.pi * TURN))


def twisted(frequency, amplitude=0.02):
    """Rest for a second, then twist to and fro."""
    time = np.append(0.0, 1.0 + TURN / frequency)
    path = wk.Path(time, wk.Force(0.5), wk.Angle(amplitude * WAVE))
    return wk.Torsion(ball, MU, path, count=150).solve()


# %%
# The loss of a cycle
# -------------------
#
# ``loss_per_cycle`` and ``secant_stiffness`` belong to the last cycle of the path. At low and at high frequency the
# rubber is nearly elastic, and friction dissipates most of the energy.

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13.0, 4.0), layout="constrained")
for frequency, colour in ((0.5, "C0"), (8.0, "C1"), (200.0, "C2")):
    answer = twisted(frequency)
    cycle = slice(answer.last_cycle.first, answer.last_cycle.last + 1)
    left.plot(1e3 * answer.angle[cycle], 1e3 * answer.torque[cycle], color=colour, label=f"{frequency:g} Hz")
left.set(xlabel="angle [mrad]", ylabel="torque [mN m]", title="the second cycle")
left.legend(frameon=False)

frequencies = np.geomspace(0.3, 300.0, 9)
answers = [twisted(frequency) for frequency in frequencies]
whole = np.array([answer.loss_per_cycle for answer in answers])
rubbed = np.array([np.ptp(answer.friction_loss[answer.last_cycle.first :]) for answer in answers])
middle.semilogx(frequencies, 1e6 * whole, label="all")
middle.semilogx(frequencies, 1e6 * rubbed, label="to friction")
middle.set(xlabel="frequency [Hz]", ylabel="loss in a cycle [µJ]", ylim=(0, None), title="a twisted ball")
middle.legend(frameon=False)

# %%
# A roller
# --------
#
# A roller on the same rubber has no torsional motion; it is sheared by a force per length. Elastic half-planes have no
# finite displacement, so its ``dissipation_per_length`` is the loss to friction alone.

strip = wk.LineFoundation(wk.Paraboloid(20e-3), on_rubber)
corners = np.array([0.0, 1.0, -1.0, 1.0])
lost = []
for duration in (0.002, 0.02, 0.2):
    time = np.append(0.0, 1.0 + duration * np.arange(4.0))
    path = wk.LinePath(200.0, 0.7 * 0.6 * 200.0 * np.append(0.0, corners), time=time)
    lost.append(wk.LineTangential(strip, MU, path).solve().loss_per_cycle_per_length)
right.bar(["2 ms", "20 ms", "0.2 s"], 1e3 * np.array(lost))
right.set(xlabel="time from one load reversal to the next", ylabel="loss to friction [mJ/m]", title="a shaken roller")
plt.show()
print(f"the twisted ball loses most at about {frequencies[int(np.argmax(whole))]:.0f} Hz")
assert np.all(whole > rubbed)
assert lost[0] < lost[2]
