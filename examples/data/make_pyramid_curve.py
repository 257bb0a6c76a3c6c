"""Make gel_pyramid.csv: the force curve of a four-sided AFM tip on a gel, with the scatter of a measurement.

The curve is not a real one.  What it should give is known: a rigid, sharp pyramid of four faces, 35 degrees between its
axis and its faces, on a spring of 0.05 N/m, is pressed into an incompressible gel of E = 4 kPa.  The force,
F = 0.7376 E / (1 - nu^2) tan(35 degrees) d^2, is written out here, with the constant of another program's boundary
elements (ContactMechanics), not taken from winkler.  It scatters by 20 pN (normally distributed, seeded).

Run it in the folder where the file is wanted:  python make_pyramid_curve.py
"""

from pathlib import Path

import numpy as np

CONSTANT = 0.737617
TANGENT = np.tan(np.radians(35.0))
YOUNG, POISSON = 4e3, 0.5
SPRING = 0.05
SCATTER = 20e-12
BASELINE = 35e-12
FIRST_TOUCH = 2.4e-6
SEED = 1992

HEADER = """\
# NOT a real measurement: made by examples/data/make_pyramid_curve.py from a known contact, with seeded scatter.
# Gel, E = 4 kPa, nu = 0.5; a pyramid of four faces, 35 degrees between axis and face.
k (N/m) {spring}
piezo [nm], force [nN]
"""


def pyramid(position: np.ndarray) -> np.ndarray:
    """Return the force at positions D = d + F/k from first touch [N]: a quadratic equation for d."""
    factor = CONSTANT * YOUNG / (1.0 - POISSON**2) * TANGENT / SPRING
    depth = 2.0 * np.maximum(position, 0.0) / (1.0 + np.sqrt(1.0 + 4.0 * factor * np.maximum(position, 0.0)))
    return SPRING * factor * depth**2


if __name__ == "__main__":
    random = np.random.default_rng(SEED)
    place = np.linspace(-1.4e-6, 1.0e-6, 300)
    force = pyramid(place) + BASELINE + SCATTER * random.standard_normal(place.size)
    rows = (f"{1e9 * x:.2f}, {1e9 * f:.4f}\n" for x, f in zip(place + FIRST_TOUCH, force, strict=True))
    Path("gel_pyramid.csv").write_text(HEADER.format(spring=SPRING) + "".join(rows), encoding="utf-8")
    print("Written gel_pyramid.csv")
