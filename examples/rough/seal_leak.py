"""
What leaks through a pressed seal
=================================

A blasted steel seal is pressed flat by more and more force. How much of it touches, in how many patches, and how well
is that known on its pixels? What flows through the gap under one bar of water, and where is it narrowest?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

steel = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
blasted = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=6e-5, roll_off=2.5e-4)
surface = wk.random_topography(blasted, (128, 128), lengths=(1e-3, 1e-3), seed=3)
contact = wk.SurfaceContact(surface, steel, wk.Force(np.geomspace(30.0, 600.0, 4)))

# %%
# The true area: pixels that touch, less what they count too much along their edge. The map is pressed again on every
# second point; by as much as the answers change, so far may they be from those of a finer map.

touching = wk.TrueArea(contact).solve()
for force, area, error, patches in zip(
    touching.force, touching.area, touching.area_error, touching.patch_count, strict=True
):
    print(
        f"{force:4.0f} N: {area / surface.area:.3f} of the map (+- {error / surface.area:.3f}) in {patches:.0f} patches"
    )
draw(touching)

# %%
# The leak, by Reynolds' equation on the gap. Beside it stands Bruggeman's effective medium, which needs the
# distribution of the gaps only, and fails where few ways are left.

seal = wk.Seal(contact, viscosity=1e-3, pressure_drop=1e5).solve()
for force, leak, medium, gap in zip(seal.force, seal.leak_rate, seal.medium_leak_rate, seal.critical_gap, strict=True):
    print(
        f"{force:4.0f} N: {leak * 1e9:.2e} mm^3/s, effective medium {medium * 1e9:.2e}; "
        f"grains up to {gap * 1e9:.0f} nm pass"
    )
draw(seal)

plt.show()
