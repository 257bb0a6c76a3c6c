"""
The first millimetre of rolling
===============================

A wheel that begins to pull does not pull at once. Its contact must first be filled with stress, from the leading edge
backwards, and that takes about one width of the contact. A vehicle model that takes the steady creep force from the
first step on is too stiff at high frequencies. How long is the memory?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

steel = wk.Elastic(young=208e9, poisson=0.28)
bed = wk.Foundation(wk.Paraboloid(curvature_radius=0.3), wk.HalfSpace.between(steel, steel))
LOAD, MU = wk.Force(20e3), wk.Coulomb(0.35)
a = wk.Indentation(bed, LOAD).solve().radius

# %%
# Three creepages
# ---------------
# The smaller the creepage, the longer the distance: where much slides, the stress is soon where it may be at most.

figure, axes = plt.subplots(figsize=(6.8, 4.2), layout="constrained")
for creepage, colour in ((5e-4, "C0"), (2e-3, "C1"), (6e-3, "C2")):
    begun = wk.RollingStart(bed, MU, wk.Creepage(longitudinal=creepage), LOAD, distance=3.0 * a).solve()
    steady = begun.steady.longitudinal_force
    axes.plot(begun.distance / a, begun.shear_force / steady, color=colour, label=f"{100 * creepage:g} %")
    there = begun.distance[np.argmax(begun.shear_force > 0.95 * steady)]
    print(f"creepage {100 * creepage:.2f} %: {steady / 1e3:.2f} kN, 95 % of it after {1e3 * there:.1f} mm")
    assert np.isclose(begun.shear_force[-1], steady, rtol=1e-3)
axes.axvline(2.0, color="0.7", linestyle=":")
axes.set(xlabel="distance over the contact radius [-]", ylabel="creep force over the steady one [-]")
axes.set(xlim=(0, 3), ylim=(0, 1.05))
axes.legend(frameon=False, title="creepage")
plt.show()

# %%
# A wheel that was pulling in the other direction
# -----------------------------------------------
# The traction on the springs, after every step of the path.

turned = wk.RollingStart(
    bed, MU, wk.Creepage(longitudinal=2e-3), LOAD, distance=3.0 * a, start=wk.ShearForce(-4e3)
).solve()
sheet = draw(turned)
