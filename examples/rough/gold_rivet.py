"""
A rough, gold-plated rivet
==========================

The rivet of a relay is a ball of bronze under a micron of gold, turned to a roughness of some tens of nanometres. It
touches its spring in a few spots, most of which flow. What do they resist, what does the plating save, and at which
current does the gold soften?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

turned = wk.RandomTopography(
    [80e-6, 80e-6], wk.SelfAffine(hurst=0.8, rms_height=60e-9, longest=40e-6, shortest=8e-6), (96, 96), seed=4
)
rivet = wk.RoughProfile(turned, wk.Paraboloid(curvature_radius=3e-3))
bronze = wk.Elastic(young=110e9, poisson=0.34)
contact = wk.SurfaceContact(
    rivet, wk.HalfSpace.between(bronze, bronze), wk.Force(np.geomspace(0.02, 1.0, 4)), hardness=0.8e9
)

# %%
# The mean pressure of the spots against the hardness: where it limited nearly all of them, their area would be F / H.

pressed = contact.solve()
for force, area, share in zip(pressed.force, pressed.area, pressed.hardened_share, strict=True):
    print(
        f"{force * 1e3:5.0f} mN: {area * 1e12:5.0f} um^2, mean pressure {force / area / 0.8e9:.0%} of the hardness, "
        f"which {share:.0%} of the pixels bear"
    )

# %%
# The resistance of the spots, through the plating and a film of tarnish. The currents are those at which the hottest
# place softens and melts: without a film that takes 0.07 V and 0.41 V, whatever the spots look like.

gold, body = wk.ElectricalConductor(22e-9), wk.ElectricalConductor(130e-9)
plated = wk.Plated(gold, 1e-6, body)
pair = wk.ElectricalConductors(plated, plated, wk.SurfaceFilm(area_resistance=1e-13))
electric = wk.SurfaceConstriction(
    contact, pair, wk.Current(2.0), softening_temperature=373.0, melting_temperature=1336.0
).solve()
for i, force in enumerate(electric.force):
    print(
        f"{force * 1e3:5.0f} mN: {electric.resistance[i] * 1e3:.2f} mohm in {electric.patch_count[i]:.0f} spots, "
        f"the plating leaves {electric.plating_factor[i]:.2f} of the constriction; softens at "
        f"{electric.softening_current[i]:.0f} A, melts at {electric.melting_current[i]:.0f} A"
    )
draw(electric)

plt.show()
