"""Make sliding_film.csv: the force curve of a bead on a swollen gel film that slides on its glass, with scatter.

The curve is not a real one.  What it should give is known: a rigid bead of 5 um radius is pressed into an
incompressible film of E = 4 kPa, 2 um thick, without friction on the glass below.  The contact is solved here, not by
winkler: pressures P_2n(y) / y, y = (1 - r^2/a^2)^(1/2), whose Hankel transforms are spherical Bessel functions, and the
compliance (cosh 2x - 1) / (sinh 2x + 2x) of the film.  It scatters by 10 pN (normally distributed, seeded).

Run it in the folder where the file is wanted:  python make_film_curve.py
"""

from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.special import spherical_jn

YOUNG, POISSON, THICKNESS, BEAD = 4e3, 0.5, 2e-6, 5e-6
SPRING, SCATTER, BASELINE, FIRST_TOUCH, SEED = 0.05, 10e-12, 35e-12, 2.4e-6, 2002
TERMS = 16

HEADER = """\
# NOT a real measurement: made by examples/data/make_film_curve.py from a known contact, with seeded scatter.
# Gel film, E = 4 kPa, nu = 0.5, 2 um, sliding on glass; bead of 5 um radius.
k (N/m) {spring}
piezo [nm], force [nN]
"""


def pressed(ratio: float) -> tuple[float, float]:
    """Return d R / h^2 and F R / (E* h^3) at the contact radius `ratio` times the thickness."""
    nodes, weights = np.polynomial.legendre.leggauss(300)
    x = 10.0 * (nodes + 1.0)
    missing = (np.cosh(2.0 * x) - 1.0) / (np.sinh(2.0 * x) + 2.0 * x) - 1.0
    order = np.arange(TERMS)
    waves = spherical_jn(2 * order[:, None], ratio * x)
    matrix = np.diag(0.5 * np.pi / (4.0 * order + 1.0)) + ratio * (waves * (10.0 * weights * missing)) @ waves.T
    flat, bead = np.zeros(TERMS), np.zeros(TERMS)
    flat[0], bead[0], bead[1] = 1.0, -(ratio**2) / 3.0, 2.0 * ratio**2 / 15.0
    of_flat, of_bead = np.linalg.solve(matrix, np.stack([flat, bead], axis=1)).T
    depth = -np.sum((-1.0) ** order * of_bead) / np.sum((-1.0) ** order * of_flat)  # no pressure at the edge
    return float(depth), float(np.pi * ratio * (depth * of_flat[0] + of_bead[0]))


if __name__ == "__main__":
    random = np.random.default_rng(SEED)
    depth, force = np.array([(0.0, 0.0)] + [pressed(r) for r in np.linspace(0.0, 2.0, 41)[1:].tolist()]).T
    depth = depth * THICKNESS**2 / BEAD
    force = force * YOUNG / (1.0 - POISSON**2) * THICKNESS**3 / BEAD
    curve = CubicSpline(np.sqrt(depth + force / SPRING), force)
    place = np.linspace(-0.8e-6, 0.8e-6, 300)
    measured = curve(np.sqrt(np.maximum(place, 0.0))) + BASELINE + SCATTER * random.standard_normal(place.size)
    rows = (f"{1e9 * x:.2f}, {1e9 * f:.4f}\n" for x, f in zip(place + FIRST_TOUCH, measured, strict=True))
    Path("sliding_film.csv").write_text(HEADER.format(spring=SPRING) + "".join(rows), encoding="utf-8")
    print("Written sliding_film.csv")
