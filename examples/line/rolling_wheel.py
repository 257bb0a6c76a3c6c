r"""
A wheel that pulls, from its first millimetre on
================================================

A driven wheel turns a little faster than it rolls: where it touches the rail the surfaces stick at first and slip
before they part. Carter solved this for a locomotive in 1926,

.. math:: \frac{Q}{\mu P} = 1 - \frac{c^2}{a^2}, \qquad \xi = \frac{\mu(a-c)}{R} ,

with the force :math:`Q` per length, the creepage :math:`\xi`, and a zone of stick that reaches from the leading edge
:math:`a` back to :math:`a-2c` (Johnson 1985, section 8.3). How does the wheel come to this state from rest, and what
resists it if it runs on rubber?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# Steady pull
# -----------
# A steel wheel of half a metre under 180 N/mm, with a coefficient of friction of 0.3.

steel = wk.Elastic(young=210e9, poisson=0.28)
bed = wk.LineFoundation(wk.Paraboloid(curvature_radius=0.5), wk.HalfSpace.between(steel, steel))
friction, load = wk.Coulomb(0.3), wk.LineForce(180e3)
creepages = np.linspace(0.0, 8e-4, 33)
pulls = wk.LineRolling(bed, friction, wk.Creepage(longitudinal=creepages), load).solve()
a = float(pulls.contact.half_width)
used = np.minimum(creepages * 0.5 / (0.3 * a), 1.0)
assert np.allclose(pulls.traction_ratio, 1.0 - (1.0 - used) ** 2, rtol=1e-12, atol=1e-15)

draw(pulls)

# %%
# From rest
# ---------
# The wheel bears 64 % of what friction allows before it moves: it sticks in the middle of the strip only. Then it
# rolls. The surface that comes in carries no traction yet, the old one takes its traction out of the strip, and the
# creepage overshoots before it settles.

force = wk.LineShearForce(0.64 * 0.3 * 180e3)
start = wk.LineRollingStart(bed, friction, force, load, distance=4.0 * a).solve()
peak = np.max(start.longitudinal_creepage) / start.steady.longitudinal_creepage
print(f"greatest creepage {peak:.2f} times the steady one, after {start.distance[-1] / a:.0f} half-widths "
      f"{start.longitudinal_creepage[-1] / start.steady.longitudinal_creepage:.3f}")  # fmt: skip
assert abs(start.longitudinal_creepage[-1] / start.steady.longitudinal_creepage - 1.0) < 5e-3

draw(start)

# %%
# On rubber
# ---------
# Rubber that is pressed in quickly is stiff, and behind the wheel it has not yet come back: the strip lies ahead of the
# lowest point, and its pressure resists. The coefficient is greatest where the rubber passes the strip in about its
# relaxation time. A rubber with a broad spectrum resists over many decades of the speed.

sharp = wk.StandardSolid(relaxed_shear=1e6, shear=3e6, relaxation_time=1e-2)
broad = wk.Prony(1e6, np.full(7, 3e6 / 7.0), np.geomspace(1e-5, 10.0, 7))
speeds = np.geomspace(1e-4, 1e3, 60)
figure, axes = plt.subplots(figsize=(6.0, 4.0), layout="constrained")
for name, rubber in (("one relaxation time", sharp), ("seven, over six decades", broad)):
    track = wk.LineFoundation(wk.Paraboloid(curvature_radius=50e-3), wk.ViscoelasticHalfSpace(rubber))
    rolling = wk.LineRollingResistance(track, wk.LineForce(300.0), speeds).solve()
    axes.semilogx(speeds, rolling.coefficient, label=name)
axes.set(xlabel="speed [m/s]", ylabel="resistance / normal force [-]", title="a wheel on rubber", ylim=(0.0, None))
axes.legend(frameon=False)

one = wk.LineFoundation(wk.Paraboloid(curvature_radius=50e-3), wk.ViscoelasticHalfSpace(sharp))
draw(wk.LineRollingResistance(one, wk.LineForce(300.0), np.geomspace(1e-3, 1e2, 41)).solve())
plt.show()
