"""Draw the figure of docs/tutorials/own-program.md: the grains of the hopper that are near its middle plane.

::

    python docs/figures/draw_hopper.py grains.dump

reads what examples/exchange/hopper.lmp writes, and writes docs/figures/hopper.png.
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection

from winkler.plot.picture import styled

HERE = Path(__file__).resolve().parent
RADIUS, SLICE, STEP = 1e-3, 2e-3, 5e-6
MOMENTS = (0.0, 0.5, 1.0)
WALL = np.array([[8.0, 0.0], [39.0, 50.0], [39.0, 130.0]])


def moments(path: Path) -> dict[int, np.ndarray]:
    """Return place and velocity of the grains, (grains, 6), at every moment of a dump."""
    lines, found, at = path.read_text(encoding="utf-8").splitlines(), {}, 0
    while at < len(lines):
        step, count = int(lines[at + 1]), int(lines[at + 3])
        rows = lines[at + 9 : at + 9 + count]
        if len(rows) == count:
            found[step] = np.array([line.split()[1:7] for line in rows], dtype=float)
        at += 9 + count
    return found


def main() -> None:
    """Draw three moments of a run."""
    found = moments(Path(sys.argv[1]))
    steps = sorted(found)
    with styled():
        figure, axes = plt.subplots(1, 3, figsize=(7.2, 4.2), sharey=True, layout="constrained")
        for axis, part in zip(axes, MOMENTS, strict=True):
            step = steps[round(part * (len(steps) - 1))]
            x, y, z, *velocity = found[step].T
            near = np.abs(y) < SLICE
            size = np.full(np.sum(near), 2e3 * RADIUS)
            grains = EllipseCollection(
                size, size, np.zeros(size.size), units="xy", offsets=1e3 * np.column_stack([x, z])[near],
                offset_transform=axis.transData, array=np.linalg.norm(velocity, axis=0)[near], cmap="viridis",
            )  # fmt: skip
            grains.set_clim(0.0, 1.0)
            axis.add_collection(grains)
            for side in (-1.0, 1.0):
                axis.plot(side * WALL[:, 0], WALL[:, 1], color="0.3")
            axis.set(
                xlim=(-45, 45), ylim=(-45, 135), aspect="equal", xlabel="x [mm]", title=f"{1e3 * step * STEP:g} ms"
            )
            axis.axhline(-40.0, color="0.3")
        axes[0].set_ylabel("height [mm]")
        figure.colorbar(grains, ax=axes, label="speed [m/s]", shrink=0.7)
        figure.savefig(HERE / "hopper.png", dpi=85)


if __name__ == "__main__":
    main()
