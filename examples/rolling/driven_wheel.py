r"""
A driven wheel, and free rolling of unlike rollers
==================================================

A wheel transmits the force of its motor, and creeps as it must. With the forces given the creepages are found, steady
rolling by boundary elements,

.. math:: s(x) = w\,\Delta x - u(x) + u(x+\Delta x) , \qquad \int\tau\,\mathrm dA = F .

Rollers of unlike materials creep even without a force: pressures draw one of the surfaces farther along than the other.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# Creepages of a driven wheel
# ---------------------------
# It pulls and guides: the flange needs a force across, which costs creepage along as well.

steel = wk.HalfSpace.between(wk.Elastic(210e9, 0.28), wk.Elastic(210e9, 0.28))
wheel = wk.SampledProfile([18e-3, 14e-3], wk.CurvedBodies(0.46, 0.3), (54, 42))
FRICTION = wk.Coulomb(0.3)
pull = np.linspace(1e3, 20e3, 8)
driven = {
    guiding: wk.SurfaceRolling(wheel, steel, wk.Force(80e3), FRICTION, wk.CreepForce(pull, guiding)).solve()
    for guiding in (0.0, 6e3, 12e3)
}
figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
for guiding, found in driven.items():
    assert np.all(found.misfit <= 1e-7)
    axes.plot(pull / 1e3, 100 * found.longitudinal_creepage, "o-", label=f"{guiding / 1e3:.0f} kN across")
axes.set(xlabel="force along the rolling [kN]", ylabel="creepage along the rolling [%]", title="a driven wheel")
axes.legend(frameon=False)

draw(wk.SurfaceRolling(wheel, steel, wk.Force(80e3), FRICTION, wk.CreepForce(12e3, 6e3, wk.Spin(0.4))).solve())

# %%
# Free rolling of a ball of aluminium on steel
# --------------------------------------------
# Without friction to speak of all slips, and the ball creeps by :math:`0.5312\,\beta a/R`. The more friction, the more
# sticks; what sticks cannot give way, and the creepage falls.

unlike = wk.HalfSpace.between(wk.Elastic(70e9, 0.33), wk.Elastic(210e9, 0.28))
ball = wk.SampledProfile([0.7e-3, 0.7e-3], wk.Paraboloid(10e-3), (40, 40))
friction = np.geomspace(1e-3, 1.0, 10)
free = [wk.SurfaceRolling(ball, unlike, wk.Force(100.0), wk.Coulomb(mu), wk.CreepForce()).solve() for mu in friction]
a = (0.75 * 100.0 * 10e-3 / unlike.modulus) ** (1.0 / 3.0)
slides = 0.53123 * unlike.mismatch * a / 10e-3
assert abs(free[0].longitudinal_creepage / slides - 1.0) < 0.02

figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
left.semilogx(friction, [100 * found.longitudinal_creepage for found in free], "o-")
left.axhline(100 * slides, color="0.5", ls="--", label="no friction")
left.set(xlabel="coefficient of friction", ylabel="creepage [%]", title="free rolling", ylim=(0.0, None))
left.legend(frameon=False)
right.semilogx(friction, [100 * found.stick_share for found in free], "s-")
right.set(xlabel="coefficient of friction", ylabel="part of the contact that sticks [%]", title="what sticks")
plt.show()
