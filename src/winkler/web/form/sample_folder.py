"""A made folder of curves over a gel with a stiff inclusion, in which one file is none."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

SIDE, STEP = 5, 2e-6
"""Places along either side of the map, and the distance between them [m]."""
SOFT, STIFF, WIDTH = 2e3, 9e3, 2.5e-6
"""E of the gel and in the middle of the inclusion [Pa], and the width of the inclusion [m]."""
RADIUS, POISSON, NOISE, COUNT = 5e-6, 0.5, 2e-11, 120
"""R of the tip [m], Poisson's ratio, standard deviation of the force [N], and points of a curve."""
FOLDER_REMARK = (
    "Made curves, not measurements: a ball of 5 um at 5 x 5 places over a gel of 2 kPa with an inclusion of 9 kPa, "
    "with noise, and one file that is no curve. Upload your own."
)


def modulus_at(x: float, y: float) -> float:
    """Return Young's modulus [Pa] under a place [m] on the map."""
    middle = 0.5 * (SIDE - 1) * STEP
    return SOFT + (STIFF - SOFT) * math.exp(-((x - middle) ** 2 + (y - middle) ** 2) / WIDTH**2)


def sample_folder() -> Iterator[tuple[str, bytes]]:
    """Yield name and content of each file: Hertz's force over the depth, with white noise; and notes."""
    depth = np.linspace(-6e-7, 6e-7, COUNT)
    noise = np.random.default_rng(3)
    for number in range(SIDE * SIDE):
        x, y = STEP * (number % SIDE), STEP * (number // SIDE)
        stiffness = 4.0 / 3.0 * modulus_at(x, y) / (1.0 - POISSON**2) * math.sqrt(RADIUS)
        force = stiffness * np.maximum(depth, 0.0) ** 1.5 + NOISE * noise.standard_normal(COUNT)
        head = (
            "# NOT a measurement: a ball of 5 um on a gel with an inclusion, with noise",
            f"# x [um]: {1e6 * x:g}",
            f"# y [um]: {1e6 * y:g}",
            "depth [nm], force [nN]",
        )
        rows = (f"{1e9 * d:.2f}, {1e9 * f:.5f}" for d, f in zip(depth, force, strict=True))
        yield f"place_{number + 1:02d}.csv", ("\n".join((*head, *rows)) + "\n").encode()
    yield "notes.txt", b"The cantilever was changed after place 12.\n"
