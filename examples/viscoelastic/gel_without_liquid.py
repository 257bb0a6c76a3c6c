r"""
Liquid leaves a gel
===================

A ball is held at a constant depth on a gel: the force falls while the liquid flows out of the contact, in a time that
grows as the square of the contact radius, :math:`a^2/D`. Two depths therefore tell such a gel from a viscoelastic one.
"""

import matplotlib.pyplot as plt
import numpy as np

from winkler import HeldContacts, HeldForce, Paraboloid, PoroelasticRelaxation

rng, time, holds = np.random.default_rng(1), np.geomspace(1.0, 3e3, 80), []
figure, axes = plt.subplots(figsize=(5.5, 3.6), layout="constrained")
for depth in (10e-6, 40e-6):
    gel = PoroelasticRelaxation(
        Paraboloid(1e-3), shear=5e3, poisson=0.3, diffusivity=1e-10, depth=depth, time=time
    ).solve()
    measured = gel.force * (1.0 + 5e-3 * rng.standard_normal(time.size))
    holds.append(HeldForce(gel.problem.profile, depth, time, measured))
    axes.semilogx(time, measured / gel.first_force, ".", markersize=4, label=f"{depth * 1e6:.0f} µm")
    axes.semilogx(time, gel.force / gel.first_force, "k", linewidth=0.8)
axes.set(xlabel="time [s]", ylabel="force over the first one [-]")
axes.legend(title="depth", frameon=False)

# %%
# What two holds tell
# -------------------

found = HeldContacts(holds).solve()
print(f"{found.scaling.verdict}: times grow with the power {found.scaling.exponent:.2f} of the contact radius")
print("D between {:.2e} and {:.2e} m^2/s".format(*found.body.interval("diffusivity")))
assert found.scaling.verdict == "poroelastic"
