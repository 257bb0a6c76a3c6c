"""
Many small spots, or one large one?
===================================

Two rough metals touch in spots, and the current must squeeze through each of them. Ten spots are better than one of the
same area, but they hinder each other: packed closely they are one large spot again.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

copper = wk.ElectricalConductor(resistivity=16.8e-9)
AREA = np.pi * (100e-6) ** 2
"""Area of all spots together."""


def cluster(count, width, seed=3):
    """Spots of one size, strewn over a disc of that width, none touching another."""
    radius = np.sqrt(AREA / (np.pi * count))
    draws = np.random.default_rng(seed)
    places: list[np.ndarray] = []
    while len(places) < count:
        place = width * np.sqrt(draws.uniform()) * np.exp(2j * np.pi * draws.uniform())
        if all(abs(place - other) > 2.1 * radius for other in places):
            places.append(place)
    x, y = np.real(places), np.imag(places)
    return wk.SpotCluster(x, y, np.full(count, radius), copper, copper).solve()


# %%
# Forty spots
# -----------

forty = cluster(40, 400e-6)
sheet = draw(forty)
one = 16.8e-9 / (2.0 * 100e-6)
print(f"one spot of the same area  {1e6 * one:.1f} µohm")
print(f"forty spots                {1e6 * forty.resistance:.1f} µohm")
print(f"if they did not interact   {1e6 * forty.alone:.1f} µohm")
print(f"Greenwood's estimate       {1e6 * forty.greenwood:.1f} µohm")
assert forty.alone < forty.resistance < one

# %%
# How far apart?
# --------------
# Strewn widely they come near to forty times the conductance of one; packed, to that of the disc that they fill.

widths = np.array([250e-6, 300e-6, 400e-6, 600e-6, 1e-3, 2e-3, 4e-3])
figure, axes = plt.subplots(figsize=(6.6, 4.2), layout="constrained")
for count, colour in ((10, "C0"), (40, "C1")):
    found = [cluster(count, width) for width in widths]
    axes.loglog(1e3 * widths, [1e6 * each.resistance for each in found], "o-", color=colour, label=f"{count} spots")
    axes.axhline(1e6 * found[-1].alone, color=colour, linestyle=":", linewidth=0.9)
axes.loglog(
    1e3 * widths, 1e6 * 16.8e-9 / (2.0 * widths), color="0.6", linestyle="--", label="a full disc of that radius"
)
axes.axhline(1e6 * one, color="0.6", linewidth=0.8)
axes.set(xlabel="radius of the disc they lie in [mm]", ylabel="resistance [µΩ]", ylim=(8, 120))
axes.set_title("dotted: each alone; solid grey: one spot of the same area", fontsize=9)
axes.set_xticks([0.3, 0.5, 1.0, 2.0, 4.0], labels=["0.3", "0.5", "1", "2", "4"])
axes.set_xticks([], minor=True)
axes.legend(frameon=False, loc="upper right", bbox_to_anchor=(1.0, 0.88))
plt.show()
