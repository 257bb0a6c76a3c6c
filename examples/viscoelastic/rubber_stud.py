r"""
A rubber stud that is pushed along the road
===========================================

An oval stud of rubber is pressed onto the road, held until its pressure has relaxed, and pushed to and fro. Boundary
elements find where it sticks and slips, with Coulomb's law in each pixel. All pixels relax by one function of time:

.. math:: \tau(t) = \int G(t-t')\,\frac{\partial w}{\partial t'}\,\mathrm dt', \qquad |\tau| \le \mu p .

The speed decides whether friction or the rubber dissipates the energy.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

TAU, MU, FAR = 0.05, wk.Coulomb(0.7), 60e-6
rubber = wk.StandardSolid(relaxed_shear=0.5e6, shear=1.5e6, relaxation_time=TAU, poisson=0.49)
road = wk.ViscoelasticHalfSpace(rubber)
oval = wk.SampledProfile([10e-3, 5e-3], wk.CurvedBodies(80e-3, 20e-3), shape=(64, 32))
WAVE = np.append(0.0, np.sin(2.0 * np.pi * np.linspace(0.0, 2.0, 81)))


def pushed(topography, medium, period, force=3.0):
    """Press, rest for a second, then push to and fro twice."""
    time = np.append(0.0, 1.0 + np.linspace(0.0, 2.0, 81) * period)
    return wk.SurfaceTangential(topography, medium, MU, wk.Path(time, wk.Force(force), wk.Shift(FAR * WAVE))).solve()


# %%
# Loops
# -----
#
# ``friction_loss`` and ``bulk_loss`` are the two parts of ``dissipation``. The second cycle is drawn.

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13.0, 4.0), layout="constrained")
lost = {}
for period, colour in ((5e-4, "C0"), (0.3, "C1"), (50.0, "C2")):
    found = pushed(oval, road, period)
    cycle = slice(found.last_cycle.first, found.last_cycle.last + 1)
    left.plot(1e6 * found.shift_x[cycle], found.shear_force_x[cycle], color=colour, label=f"{period:g} s")
    lost[period] = np.ptp(found.friction_loss[cycle]), np.ptp(found.bulk_loss[cycle])
    assert found.loss_per_cycle > 0.0
left.set(xlabel="shift [µm]", ylabel="shear force [N]", title="the second cycle")
left.legend(title="period", frameon=False)
rubbed, inside = 1e6 * np.array(list(lost.values())).T
names = [f"{period:g} s" for period in lost]
middle.bar(names, rubbed, label="friction")
middle.bar(names, inside, bottom=rubbed, label="inside the rubber")
middle.set(xlabel="period", ylabel="loss in a cycle [µJ]", title="where the energy goes", ylim=(0, 180))
middle.legend(loc="upper right", frameon=False)
assert inside[1] > inside[0]
assert inside[1] > inside[2]

# %%
# What is let go recovers
# -----------------------
#
# The stud is lifted, and comes back after a pause. Its surface is still dented: the shorter the pause, the smaller the
# force.

pauses = np.array([0.02, 0.05, 0.1, 0.2, 0.4])
back = []
for pause in pauses:
    away = np.linspace(0.0, pause, 7)
    time = np.concatenate([[0.0, 1.0], 1.0 + away, [1.0 + pause]])
    depth = 0.2e-3 * np.concatenate([[1.0, 1.0], np.full(7, -1.0), [1.0]])
    path = wk.Path(time, wk.Depth(depth), wk.Shift(0.0))
    back.append(wk.SurfaceTangential(oval, road, MU, path).solve().force)
right.plot(1e3 * pauses, [force[-1] for force in back], "o-", label="after a pause")
right.axhline(back[0][0], color="0.5", linestyle="--", label="for the first time")
right.set(xlabel="pause [ms]", ylabel="force at once [N]", ylim=(0, None), title="pressed once more")
right.legend(frameon=False)
plt.show()

# %%
# A ball has a reference
# ----------------------
#
# The springs of round contacts relax, too. Two bodies that are alike, without Poisson's ratio, slip as the springs do.

dull = wk.StandardSolid(relaxed_shear=0.5e6, shear=1.5e6, relaxation_time=TAU, poisson=0.0)
alike = wk.ViscoelasticHalfSpace(dull, dull)
ball = wk.SampledProfile([10e-3, 10e-3], wk.Paraboloid(40e-3), (64, 64))
time = np.append(0.0, 1.0 + np.linspace(0.0, 2.0, 81) * 0.3)
path = wk.Path(time, wk.Depth(0.3e-3), wk.Shift(2.0 * FAR * WAVE))
pixels = wk.SurfaceTangential(ball, alike, MU, path).solve()
springs = wk.Tangential(wk.Foundation(wk.Paraboloid(40e-3), alike), MU, path).solve()
apart = np.max(np.abs(pixels.shear_force_x - springs.shear_force)) / np.max(MU.coefficient * springs.force[1:])
print(f"pixels and springs differ by at most {100 * apart:.2f} % of the friction")
assert apart < 5e-3
