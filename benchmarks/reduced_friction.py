"""How far springs of height maps are from boundary elements under friction: the table of the manual.

`python benchmarks/reduced_friction.py` prints it again, in a minute; the test
tests/problems/surface_friction/test_manual_table.py compares it with what the manual states.
"""

from __future__ import annotations

import numpy as np

import winkler as wk
from winkler.profiles.rough.random_rough import random_topography

COUNT, MU = 95, 0.3
POISSON = (0.0, 0.3, 0.5)


def maps(count: int = COUNT) -> dict[str, tuple[wk.Topography, float]]:
    """Return maps of a side of 1 m, and the depths to which they are pressed."""
    side = (np.arange(count) - (count - 1) / 2) / count
    x, y = side[:, None], side[None, :]
    spots = np.min([(x - a) ** 2 + (y - b) ** 2 for a in (-0.3, 0.0, 0.3) for b in (-0.3, 0.0, 0.3)], axis=0)
    rough = random_topography(wk.SelfAffine(0.8, 0.03, 1.0, 0.1), (count, count), [1.0, 1.0], seed=2).heights
    heights = {
        "ball": (-0.5 * (x**2 + y**2), 0.05),
        "ellipse of 1 : 3": (-0.16 * x**2 - 0.84 * y**2, 0.024),
        "nine balls in a square": (-0.5 * spots, 0.006),
        "rough punch": (rough, 0.08),
    }
    return {name: (wk.Topography(map_, [1.0, 1.0]), depth) for name, (map_, depth) in heights.items()}


def errors(name: str, poisson: float) -> tuple[float, float, float, float]:
    """Return K_x/k and K_y/k at the greatest depth, and the errors of shift and loss."""
    body = wk.Elastic(1.0, poisson)
    topography, depth = maps()[name]
    found = wk.ReducedFriction(topography, wk.HalfSpace.between(body, body), wk.Coulomb(MU), depth).solve()
    bed = found.bed
    return float(bed.ratios_along[-1]), float(bed.ratios_across[-1]), found.shift_error, found.loss_error


def main() -> None:
    """Print the table."""
    print("| map | Poisson's ratio | K_x/k | K_y/k | shift | loss |")
    print("|---|---|---|---|---|---|")
    for name in maps():
        for poisson in POISSON:
            along, across, shift, loss = errors(name, poisson)
            print(f"| {name} | {poisson:g} | {along:.3f} | {across:.3f} | {100 * shift:.2f} % | {100 * loss:.2f} % |")


if __name__ == "__main__":
    main()
