r"""
Wobble of a twisted punch
=========================

A flat punch is twisted to and fro. A punch that sticks everywhere has an infinite traction at its rim, but an infinite
pressure too: nothing slides below the angle :math:`\mu F/(8G_ta^2)`. Beyond it a ring slides inwards from the rim, and
every swing costs energy. When the force on the punch wobbles too, the same twist costs more or less, depending on when
the punch is pressed least.
"""

import matplotlib.pyplot as plt
import numpy as np

from winkler import Angle, Coulomb, Elastic, FlatPunch, Force, Foundation, HalfSpace, Path, Torsion

RADIUS, FORCE, FRICTION = 5e-3, 200.0, 0.5
rubber = HalfSpace.between(Elastic(young=5e6, poisson=0.5))
bed = Foundation(FlatPunch(RADIUS), rubber)
first_slip = FRICTION * FORCE / (8.0 * rubber.torsional_modulus * RADIUS**2)

# %%
# Loops at a steady and at a wobbling force
# -----------------------------------------

time = np.linspace(0.0, 3.0, 121)
swing = 2.5 * first_slip * np.sin(2.0 * np.pi * time)
figure, (loops, losses) = plt.subplots(1, 2, figsize=(10.5, 4.2), layout="constrained")
lost = {}
for label, phase in (
    ("steady", None),
    ("pressed least on the outward swing", 0.5 * np.pi),
    ("pressed least at the turns", 0.0),
):
    wobble = 0.0 if phase is None else 0.3 * np.cos(4.0 * np.pi * time + phase)
    twist = Torsion(
        bed, Coulomb(FRICTION), Path(time, Force(FORCE * (1.0 + wobble + 0.0 * time)), Angle(swing))
    ).solve()
    loops.plot(twist.angle, twist.torque, label=label)
    losses.plot(twist.time, twist.dissipation, label=label)
    lost[label] = twist.dissipation[-1] - twist.dissipation[40]
    assert np.all(np.diff(twist.dissipation) >= 0.0)
loops.set(xlabel="angle in rad", ylabel="torque in N m")
losses.set(xlabel="time in s", ylabel="energy lost in J")
losses.legend()

# %%
# What two swings cost

for label, loss in lost.items():
    print(f"{label:30s} {loss:.4g} J")
plt.show()
