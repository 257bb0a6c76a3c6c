r"""
Friction that weakens
=====================

Fresh surfaces rub harder than worn ones. Here the coefficient of friction falls with the path :math:`s` along which a
place has slipped, to and fro alike,

.. math:: \mu = \mu_k+(\mu_s-\mu_k)\,e^{-s/D},

and a ball that frets rubs its friction down from the edge inwards.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

steel = wk.Elastic(young=210e9, poisson=0.3)
pair = wk.HalfSpace.between(steel, steel)
SIDE, PIXELS = 0.5e-3, 49
ball = wk.SampledProfile([SIDE, SIDE], wk.Paraboloid(curvature_radius=10e-3), (PIXELS, PIXELS))
law = wk.ExponentialSlipWeakening(static_coefficient=0.6, kinetic_coefficient=0.4, distance=5e-6)

# %%
# Loops that shrink
# -----------------
# A hundred newtons, and a shift of 3 µm to either side, which makes all of the contact slide.

CYCLES, COUNT = 5, 16
fretting = wk.Program([wk.Start(wk.Force(100.0)), wk.Oscillate(lateral=wk.Shift(3e-6), cycles=CYCLES, count=COUNT)])
problem = wk.SurfaceTangential(ball, pair, law, fretting)
states = list(problem.steps())
rubbed = problem.gathered(states)
draw(rubbed)
for cycle in range(CYCLES):
    lost = rubbed.dissipation[COUNT * (cycle + 1)] - rubbed.dissipation[COUNT * cycle]
    print(f"cycle {cycle + 1}: {rubbed.shear_force[COUNT * cycle + COUNT // 4, 0]:.1f} N, lost {lost * 1e6:.0f} uJ")

# %%
# From the edge inwards
# ---------------------
# The coefficient through the middle, along the motion, while the first cycle goes on.

x = (np.arange(PIXELS) - PIXELS // 2) * SIDE / PIXELS
figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
for index in (2, 3, 4, COUNT // 2, COUNT, CYCLES * COUNT):
    cut = states[index].pressure[:, PIXELS // 2] > 0.0
    coefficient = law.after_slip(states[index].slip_path[:, PIXELS // 2])
    axes.plot(1e3 * x[cut], coefficient[cut], label=f"after {index / COUNT:.2f} cycles")
axes.set(xlabel="x [mm]", ylabel="coefficient of friction", title="friction through the middle", ylim=(0.3, 0.62))
axes.legend(frameon=False, ncols=2, loc="lower center")

# %%
# Over a long path the kinetic coefficient is left
# ------------------------------------------------

far = wk.Path.through(wk.Force(100.0), wk.Shift(1e-6 * np.array([0.0, 3.0, 100.0])))
slid = wk.SurfaceTangential(ball, pair, law, far).solve()
print(f"{slid.shear_force[-1, 0]:.3f} N of {0.4 * 100.0:.0f} N")
assert abs(slid.shear_force[-1, 0] - 40.0) < 1e-3
plt.show()
