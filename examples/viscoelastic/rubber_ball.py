r"""
How high does a ball bounce on rubber?
======================================

A solid that relaxes much faster or much slower than the impact lasts is elastic; in between it takes most of the
energy. Time counts in :math:`T_0=(m^2/E^{*2}Rv)^{1/5}`.
"""

import matplotlib.pyplot as plt
import numpy as np

from winkler import (
    Depth,
    Foundation,
    HarmonicIndentation,
    Paraboloid,
    StandardSolid,
    ViscoelasticHalfSpace,
    ViscoelasticImpact,
)

RADIUS, MASS, VELOCITY, MODULUS = 0.01, 0.03, 1.0, 8e6
unit = (MASS**2 / (MODULUS**2 * RADIUS * VELOCITY)) ** 0.2


def rubber(time: float) -> Foundation:
    """Half of its modulus relaxes."""
    solid = StandardSolid(relaxed_shear=MODULUS / 8.0, shear=MODULUS / 8.0, relaxation_time=time)
    return Foundation(Paraboloid(RADIUS), ViscoelasticHalfSpace(solid))


# %%
# Restitution against relaxation time
# -----------------------------------

ratios = np.geomspace(0.01, 100.0, 13)
bounced = [
    ViscoelasticImpact(rubber(ratio * unit), MASS, VELOCITY, count=200, tolerance=1e-4).solve().restitution
    for ratio in ratios
]
assert bounced[0] > 0.97
assert bounced[-1] > 0.97
assert np.isclose(np.interp(0.0, np.log10(ratios), bounced), 0.70318, atol=1e-3)  # at tau = T0

figure, (heights, loop) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
heights.semilogx(ratios, bounced, "o-")
heights.set(xlabel=r"$\tau / T_0$", ylabel="restitution", ylim=(0.6, 1.0))

# %%
# Force against depth
# -------------------

for ratio in (0.1, 1.0, 10.0):
    impact = ViscoelasticImpact(rubber(ratio * unit), MASS, VELOCITY, count=200, tolerance=1e-4).solve()
    loop.plot(impact.depth * 1e3, impact.force, label=rf"$\tau = {ratio:g}\,T_0$")
loop.set(xlabel="depth [mm]", ylabel="force [N]")
loop.legend(frameon=False)
plt.show()

# %%
# The loss tangent of the same rubber, as an oscillating indenter meets it, is greatest near one over its time.

omega = np.geomspace(0.01, 100.0, 201) / unit
shaken = HarmonicIndentation(rubber(unit), Depth(1e-4), omega).solve()
worst = omega[np.argmax(shaken.loss_tangent)] * unit
print(f"greatest loss tangent {np.max(shaken.loss_tangent):.3f} at omega = {worst:.2f} / T0")
assert np.isclose(worst, np.sqrt(0.5), rtol=0.05)
