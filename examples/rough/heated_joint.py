"""
Heat through a bolted joint: metal spots and air
================================================

Two blasted aluminium plates are pressed together. They touch in a few per cent of their area, and there heat is
squeezed through narrow spots; the air between them is a poor conductor, but it is everywhere and thin. Which of
the two carries the heat?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

aluminium = wk.HalfSpace.between(wk.Elastic(70e9, 0.33), wk.Elastic(70e9, 0.33))
blasted = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=0.5e-3, shortest=6e-5, roll_off=2.5e-4)
surface = wk.random_topography(blasted, (96, 96), lengths=(1e-3, 1e-3), seed=3)
contact = wk.SurfaceContact(surface, aluminium, wk.Force(np.geomspace(0.3, 30.0, 5)))
plates = wk.HeatConductors(wk.ThermalConductor(160.0, 6.5e-5), wk.ThermalConductor(160.0, 6.5e-5))

# %%
# In a vacuum, in air at 1 bar, with thermal grease. Rarefied air behaves as if each wall were farther away: together
# some 0.4 um.

fillings = {"vacuum": (0.0, 0.0), "air": (0.026, 0.4e-6), "grease": (1.0, 0.0)}
joints = {
    name: wk.ThermalJoint(contact, plates, gap_conductivity=conductivity, jump_distance=jump).solve()
    for name, (conductivity, jump) in fillings.items()
}
for name, joint in joints.items():
    rows = ", ".join(
        f"{h / 1e3:.1f}" + (f" ({share:.0%} through it)" if name != "vacuum" else "")
        for h, share in zip(joint.joint_conductance, joint.gap_conductance / joint.conductance, strict=True)
    )
    print(f"{name}: {rows} kW/(m^2 K)")
draw(joints["air"])

# %%
# Conductance over pressure: nearly in proportion in a vacuum, level where the gap conducts.

figure, axes = plt.subplots(figsize=(6.0, 4.2), layout="constrained")
for name, joint in joints.items():
    axes.loglog(joint.force / surface.area / 1e6, joint.joint_conductance, marker="o", label=name)
axes.set(xlabel="nominal pressure [MPa]", ylabel="joint conductance [W/(m² K)]")
axes.legend(frameon=False)

# %%
# What oil finds of the same gap before the plates are pressed: Patir and Cheng's flow factors.

apart = np.linspace(0.25, 6.0, 12) * surface.rms_height
factors = wk.flow_factors(surface, apart)
print(f"the last way along x closes when the mean planes are {factors.closing_separation * 1e6:.2f} um apart")
draw(factors)

plt.show()
