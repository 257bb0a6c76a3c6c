"""Make sliding_film.csv and gel_film_hold.csv: a bead on gel films on glass, with scatter.

The curves are not real ones.  What they should give is known.  The first: a rigid bead of 5 um radius is pressed into
an incompressible film of E = 4 kPa, 2 um thick, without friction on the glass below.  The contact is solved here, not
by winkler: pressures P_2n(y) / y, y = (1 - r^2/a^2)^(1/2), whose Hankel transforms are spherical Bessel functions, and
the compliance (cosh 2x - 1) / (sinh 2x + 2x) of the film.  It scatters by 10 pN (normally distributed, seeded).

The second: the film is bonded to the glass, (sinh 2x - 2x) / (cosh 2x + 1 + 2x^2), and relaxes, G = 300 Pa +
700 Pa exp(-t / 0.8 s).  The bead goes in for a second and is held.  On a rigid base all of the film relaxes as one, so
that F = int G(t-s) dF_1(d(s)), F_1 that of an elastic film with G = 1 Pa.

Run it in the folder where the files are wanted:  python make_film_curve.py
"""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.special import spherical_jn

YOUNG, POISSON, THICKNESS, BEAD = 4e3, 0.5, 2e-6, 5e-6
SPRING, SCATTER, BASELINE, FIRST_TOUCH, SEED = 0.05, 10e-12, 35e-12, 2.4e-6, 2002
TERMS = 16
RELAXED, SHEAR, TIME = 300.0, 700.0, 0.8
DEEPEST, HELD = 0.4e-6, 6.0

HEADER = """\
# NOT a real measurement: made by examples/data/make_film_curve.py from a known contact, with seeded scatter.
# Gel film, E = 4 kPa, nu = 0.5, 2 um, sliding on glass; bead of 5 um radius.
k (N/m) {spring}
piezo [nm], force [nN]
"""


HOLD_HEADER = """\
# NOT a real measurement: made by examples/data/make_film_curve.py from a known contact, with seeded scatter.
# Gel film, G = 300 Pa + 700 Pa exp(-t / 0.8 s), nu = 0.5, 2 um, bonded to glass; bead of 5 um radius.
depth [nm], force [nN], time [s]
"""


def sliding(x: np.ndarray) -> np.ndarray:
    """Return the compliance of a film that slides on a rigid base, over that of a half-space."""
    return np.asarray((np.cosh(2.0 * x) - 1.0) / (np.sinh(2.0 * x) + 2.0 * x))


def bonded(x: np.ndarray) -> np.ndarray:
    """Return that of an incompressible film that is bonded to it."""
    return np.asarray((np.sinh(2.0 * x) - 2.0 * x) / (np.cosh(2.0 * x) + 1.0 + 2.0 * x**2))


def pressed(ratio: float, film: Callable[[np.ndarray], np.ndarray] = sliding) -> tuple[float, float]:
    """Return d R / h^2 and F R / (E* h^3) at the contact radius `ratio` times the thickness."""
    nodes, weights = np.polynomial.legendre.leggauss(300)
    x = 10.0 * (nodes + 1.0)
    missing = film(x) - 1.0
    order = np.arange(TERMS)
    waves = spherical_jn(2 * order[:, None], ratio * x)
    matrix = np.diag(0.5 * np.pi / (4.0 * order + 1.0)) + ratio * (waves * (10.0 * weights * missing)) @ waves.T
    flat, bead = np.zeros(TERMS), np.zeros(TERMS)
    flat[0], bead[0], bead[1] = 1.0, -(ratio**2) / 3.0, 2.0 * ratio**2 / 15.0
    of_flat, of_bead = np.linalg.solve(matrix, np.stack([flat, bead], axis=1)).T
    depth = -np.sum((-1.0) ** order * of_bead) / np.sum((-1.0) ** order * of_flat)  # no pressure at the edge
    return float(depth), float(np.pi * ratio * (depth * of_flat[0] + of_bead[0]))


def held(random: np.random.Generator) -> str:
    """Return the table of the bead that is held on the film that relaxes."""
    depth, force = np.array([(0.0, 0.0)] + [pressed(r, bonded) for r in np.linspace(0.0, 2.0, 41)[1:].tolist()]).T
    elastic = CubicSpline(np.sqrt(depth * THICKNESS**2 / BEAD), force * 4.0 * THICKNESS**3 / BEAD)  # G = 1 Pa, E* = 4 G
    fine = np.linspace(0.0, HELD, 6001)
    rise = np.diff(elastic(np.sqrt(DEEPEST * np.minimum(fine, 1.0))))
    time = np.linspace(-1.0, HELD, 281)
    since = np.maximum(time, 0.0)[:, None] - 0.5 * (fine[1:] + fine[:-1])
    borne = np.where(since > 0.0, RELAXED + SHEAR * np.exp(-np.maximum(since, 0.0) / TIME), 0.0) @ rise
    measured = borne + BASELINE + SCATTER * random.standard_normal(time.size)
    place = DEEPEST * np.minimum(time, 1.0) + FIRST_TOUCH
    rows = zip(place, measured, time + 1.0, strict=True)
    return HOLD_HEADER + "".join(f"{1e9 * x:.2f}, {1e9 * f:.4f}, {t:.4f}\n" for x, f, t in rows)


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
    Path("gel_film_hold.csv").write_text(held(random), encoding="utf-8")
    print("Written sliding_film.csv and gel_film_hold.csv")
