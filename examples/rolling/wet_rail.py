r"""
A wet rail
==========

Measured creep forces have a maximum and fall beyond it: friction falls where the surfaces slip fast. Each pixel of the
contact has the coefficient that belongs to its own slip velocity (Polach),

.. math:: \mu = \mu_k+(\mu_s-\mu_k)\,e^{-v/v_0},

and the creep force depends on how fast the wheel rolls.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

steel = wk.HalfSpace.between(wk.Elastic(210e9, 0.28), wk.Elastic(210e9, 0.28))
wheel = wk.CurvedBodies(longitudinal_curvature_radius=0.625, lateral_curvature_radius=1.777)
tread = wk.SampledProfile([14.5e-3, 28.5e-3], wheel, (40, 40))
LOAD = wk.Force(106.7e3)

# %%
# Creep curves
# ------------
# Polach's numbers of a dry and a wet rail: the coefficient without slip, the part of it that is left of fast slip, and
# the velocity.

rails = {
    "dry": wk.FallingFriction(0.55, 0.40 * 0.55, velocity=1.0 / 0.60),
    "wet": wk.FallingFriction(0.30, 0.40 * 0.30, velocity=1.0 / 0.20),
}
creep = np.geomspace(1e-4, 0.3, 15)
curves = {}
for name, friction in rails.items():
    for speed in (1.0, 10.0, 40.0):
        problem = wk.SurfaceRolling(tread, steel, LOAD, friction, wk.Creepage(longitudinal=creep), speed=speed)
        curves[name, speed] = problem.solve().longitudinal_force
        most = int(np.argmax(curves[name, speed]))
        print(
            f"{name}, {speed:2.0f} m/s: at most {curves[name, speed][most] / 1e3:.1f} kN, at {100 * creep[most]:.2f} %"
        )

figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
for (name, speed), force in curves.items():
    axes.plot(100 * creep, force / 1e3, "-" if name == "dry" else "--", label=f"{name}, {speed:.0f} m/s")
axes.set(xscale="log", xlabel="longitudinal creepage [%]", ylabel="creep force [kN]", title="dry and wet rail")
axes.legend(frameon=False)

# %%
# The contact
# -----------
# At 40 m/s and half a per cent all of the contact slips but its leading edge, and the coefficient falls towards the
# trailing edge, where slip is fastest.

pulled = wk.SurfaceRolling(tread, steel, LOAD, rails["dry"], wk.Creepage(longitudinal=5e-3), speed=40.0).solve()
last = pulled.last
draw(pulled)

touching = last.pressure > 0.0
size = np.hypot(*last.traction)
ratio = np.divide(size, last.pressure, out=np.full(size.shape, np.nan), where=touching)
figure, axes = plt.subplots(figsize=(6.4, 4.4), layout="constrained")
lengths = 1e3 * np.asarray(tread.lengths)
extent = (-0.5 * lengths[0], 0.5 * lengths[0], -0.5 * lengths[1], 0.5 * lengths[1])
image = axes.imshow(ratio.T, origin="lower", extent=extent)
axes.set(xlabel="x, along the rolling [mm]", ylabel="y [mm]", title="traction over pressure")
figure.colorbar(image, label="traction over pressure")

# %%
# Far beyond the maximum
# ----------------------
# What slips everywhere has the coefficient of the creepage: the displacements do not count.

slid = wk.SurfaceRolling(tread, steel, LOAD, rails["wet"], wk.Creepage(longitudinal=0.3), speed=10.0).solve()
expected = float(rails["wet"].at_velocity(np.array(3.0))) * 106.7e3
print(f"{slid.longitudinal_force:.0f} N, and mu times the load {expected:.0f} N")
assert abs(slid.longitudinal_force / expected - 1.0) < 1e-3
plt.show()
