r"""
Running in
==========

A pin with a round tip slides on a disc. At first a small spot bears everything, under a pressure of gigapascals; as the
tip wears, the spot grows and the pressure falls. How far must it slide until the pressure is a tenth of what it was?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# A ball of 1 mm under 1 N
# ------------------------
# The worn volume grows with force and distance from the first moment on; the contact at first hardly knows, because
# what is elastic is larger than what is worn.

steel = wk.Elastic(young=210e9, poisson=0.3)
bed = wk.Foundation(wk.Paraboloid(curvature_radius=1e-3), wk.HalfSpace.between(steel, steel))
distance = np.geomspace(1e-4, 1.0, 25)
worn = wk.SlidingWear(bed, wk.Archard(1e-14), wk.Force(1.0), distance, count=60).solve()

figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
cap = (4.0 * 1e-3 * worn.worn_volume / np.pi) ** 0.25
left.loglog(worn.distance, 1e6 * worn.radius, label="elastic and worn")
left.loglog(worn.distance, 1e6 * cap, "k:", label="worn alone: $V = \\pi a^4/4R$")
left.set(xlabel="distance [m]", ylabel="contact radius [µm]", title="The contact grows")
left.legend()
for state in worn.states[::6]:
    inside = state.radii < 1.3 * state.radius
    right.plot(1e6 * state.radii[inside], 1e-9 * state.pressure[inside], label=f"{1e3 * state.elapsed:.0f} mm")
right.set(xlabel="r [µm]", ylabel="pressure [GPa]", title="The pressure evens out")
right.legend()

# %%
# When is it run in?
# ------------------

tenth = worn.mean_pressure[0] / 10.0
far = np.exp(np.interp(np.log(tenth), np.log(worn.mean_pressure[::-1]), np.log(worn.distance[::-1])))
print(f"the mean pressure is a tenth of {1e-9 * worn.mean_pressure[0]:.2f} GPa after {far:.2f} m")
assert np.allclose(worn.worn_volume, 1e-14 * worn.distance, rtol=1e-6)
plt.show()
