r"""
Where fretting ends
===================

A ball that is pushed to and fro by less than what makes it slide wears in a ring at the edge of its contact. The core
sticks, and does not wear. Does this ever end? It does: once the ring bears nothing any more there is no pressure left
that could wear it. The shape it then has depends on neither the material nor the law of wear.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# The contact
# -----------
# Steel on steel, pressed by one micrometre and held there. The amplitude is chosen so that half of the contact sticks.

steel = wk.Elastic(young=210e9, poisson=0.3)
medium = wk.HalfSpace.between(steel, steel)
bed = wk.Foundation(wk.Paraboloid(curvature_radius=10e-3), medium)
friction, depth = wk.Coulomb(0.5), wk.Depth(1e-6)
swing = wk.Shift(0.5 * medium.modulus / medium.shear_modulus * 0.75e-6)

# %%
# Cycle after cycle
# -----------------
# Taking every cycle would be a waste: one wears off a fraction of a nanometre. The march jumps over as many as the
# error allows.

cycles = np.array([0.0, 3e4, 1e5, 2e5, 4e5, 1e7])
worn = wk.FrettingWear(bed, wk.Archard(1e-14), friction, depth, swing, cycles, count=100).solve()
limit = wk.LimitingProfile(bed, friction, depth, swing).solve()

figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
for state in worn.states:
    inside = state.radii < 1.4 * limit.radius
    left.plot(1e6 * state.radii[inside], 1e9 * state.height[inside], label=f"{state.elapsed:,.0f} cycles")
    right.plot(1e6 * state.radii[inside], 1e-9 * state.pressure[inside])
r = np.linspace(0.0, 1.4 * limit.radius, 400)
left.plot(1e6 * r, 1e9 * limit.height(r), "k:", label="the limit")
left.set(xlabel="r [µm]", ylabel="height [nm]", title="Worn profiles")
right.set(xlabel="r [µm]", ylabel="pressure [GPa]", title="Pressure", ylim=(0.0, 1.6))
left.legend()

# %%
# Two methods for the same shape
# ------------------------------
# Popov's closed form needs no march. Both agree, the closer the finer the grid.

miss = worn.worn_volume[-1] / limit.worn_volume - 1.0
print(
    f"worn off: {worn.worn_volume[-1] * 1e18:.0f} um^3 after ten million cycles,"
    f" {limit.worn_volume * 1e18:.0f} in the end"
)
print(f"the core bears {worn.force[-1]:.2f} N of the {worn.force[0]:.2f} N before wear")
assert abs(miss) < 0.01
plt.show()
