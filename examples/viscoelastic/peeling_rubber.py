"""
Rubber holds the harder the faster it is pulled
===============================================

What it takes to open a square metre of a rubber contact grows with the speed of the crack. So a ball comes off at a
force that is no property of the pair: it depends on how fast one pulls, and how softly the machine is built.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

RADIUS, WORK = 2e-3, 0.05
rubber = wk.HalfSpace.between(wk.Elastic(young=2e6, poisson=0.5))
bed = wk.Foundation(wk.Paraboloid(RADIUS), rubber)
law = wk.RateDependentWork(work=WORK, reference_speed=1e-6, exponent=0.6)
JKR = 1.5 * np.pi * WORK * RADIUS


def pulled(speed, stiffness=np.inf):
    """Press by 10 µm, then pull at a steady speed."""
    places = np.concatenate([np.linspace(10e-6, -15e-6, 120), [-90e-6]])
    path = wk.Path((10e-6 - places) / speed, wk.Depth(places))
    return wk.ViscoelasticAdhesion(bed, law, path, machine_stiffness=stiffness).solve()


# %%
# Force over position
# -------------------

speeds = np.array([1e-9, 1e-7, 1e-6])
gripped = [pulled(speed) for speed in speeds]
figure, (left, right) = plt.subplots(1, 2, figsize=(10.0, 4.2), layout="constrained")
for speed, answer in zip(speeds, gripped, strict=True):
    left.plot(1e6 * answer.position, 1e3 * answer.force, label=f"{1e6 * speed:g} µm/s")
left.axhline(-1e3 * JKR, color="0.7", linestyle=":")
left.set(xlabel="position [µm]", ylabel="force [mN]", xlim=(-15, 10))
left.legend(frameon=False, title="pulled at (dotted: JKR)")

# %%
# Pull-off over speed
# -------------------
# A soft spring lets the crack run when it yields, and pays less for the same speed of the machine.

sprung = [pulled(speed, stiffness=200.0) for speed in speeds[1:]]
for answers, name, mark in ((gripped, "fixed grips", "o-"), (sprung, "spring of 200 N/m", "s-")):
    lowest = np.array([-answer.lowest_force[-1] for answer in answers])
    right.loglog(1e6 * speeds[-lowest.size :], lowest / JKR, mark, fillstyle="none", label=name)
    assert np.all(np.diff(lowest) > 0.0)
right.axhline(1.0, color="0.7", linestyle=":")
right.set(xlabel="speed of pulling [µm/s]", ylabel="pull-off force over that of JKR [-]")
right.legend(frameon=False)
plt.show()
