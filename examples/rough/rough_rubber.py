"""
Rough rubber: a trend
=====================

A rough road shears rubber at the frequency :math:`vq` with every wave q of its roughness. Where the rubber loses most
at these frequencies, friction is greatest; warmer rubber is quicker, and its peak lies at a higher speed. Independent
springs are disputed here, so take this as a trend.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

road = wk.SelfAffine(hurst=0.8, rms_height=1e-4, longest=1e-2, shortest=1e-5)
speeds = np.geomspace(1e-6, 100.0, 60)

figure, axes = plt.subplots(figsize=(6.0, 4.0), layout="constrained")
for name, time in (("cold", 1e-2), ("room", 1e-4), ("warm", 1e-6)):
    rubber = wk.StandardSolid(relaxed_shear=1e6, shear=1e7, relaxation_time=time)
    found = wk.ElastomerFriction(road, rubber, speeds).solve()
    axes.semilogx(speeds, found.coefficient, label=f"{name}, {1e3 * time:g} ms")
    peak = int(np.argmax(found.coefficient))
    print(f"{name}: at most {found.coefficient[peak]:.2f}, at {speeds[peak]:.1e} m/s")
axes.set(xlabel="velocity [m/s]", ylabel="coefficient of friction [-]", title="a rough road on three rubbers")
axes.set_ylim(0.0, 0.42)
axes.legend(frameon=False, loc="upper center", ncols=3, fontsize=9, title="relaxes in")
plt.show()
