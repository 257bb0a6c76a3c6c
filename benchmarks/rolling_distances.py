"""How far the simplified theories of rolling are from boundary elements: the tables that their notes read.

`python benchmarks/rolling_distances.py` prints them again, in minutes; tests/problems/rolling/test_distances.py
compares them with what stands in the package, and with creepages, ellipses and bodies between the tabulated ones.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import brentq

import winkler as wk
from winkler.problems.rolling.kalker import creep_coefficients

BETWEEN = 5e-3
"""What the distances change by on half the pixels, or at creepages between."""
Rows = tuple[tuple[float, float, float], ...]
"""Amount, direction [deg] and spin of creepages."""
MU, FORCE = 0.3, 1e-2
NU = (0.0, 0.3, 0.5)
"""Poisson's ratios of layers."""
COUNT, MARGIN = 72, 4
"""Pixels along each axis of the ellipse, and beside it."""
AMOUNTS, ANGLES = (0.3, 0.5, 0.7, 1.0, 1.4, 2.0, 4.0), (15.0, 30.0, 45.0, 60.0, 75.0)
"""Creepages over 3 mu F_N / (G ab c_ii), and the directions of both together [deg]."""
SPINS = (0.3, 0.5, 0.8, 1.2, 1.5, 2.2, 3.0)
"""Spins over 3 mu F_N / (G (ab)^1.5 c_23)."""
ONE = tuple((amount, angle, 0.0) for amount in AMOUNTS for angle in (0.0, 90.0))
BOTH = tuple((amount, angle, 0.0) for amount in AMOUNTS for angle in ANGLES)
TURNED = (0.0, 45.0, 75.0, 90.0, -45.0, -75.0, -90.0)
BESIDE = ((0.0, 0.0), *((amount, angle) for amount in (0.3, 0.8, 2.0, 2.8, 4.0) for angle in TURNED))
SPUN = tuple((*beside, spin) for spin in SPINS for beside in BESIDE)


def bodies_of(ratio: float) -> wk.CurvedBodies:
    """Return bodies that touch on an ellipse of the ratio a/b."""
    of = lambda log: wk.CurvedBodies(math.exp(log), 1.0).slenderness  # noqa: E731
    return wk.CurvedBodies(math.exp(brentq(lambda log: math.log(of(log) * ratio), -12.0, 12.0, xtol=1e-12)), 1.0)


def creepages(ratio: float, poisson: float, axes: tuple[float, float], shear: float, rows: Rows) -> wk.Creepage:
    """Return creepages from their amounts, angles and spins."""
    amount, angle, spin = np.array(rows).T
    c, square = creep_coefficients(ratio, poisson), axes[0] * axes[1]
    unit = 3.0 * MU * FORCE / (shear * square)
    along, across = amount * np.cos(np.radians(angle)), amount * np.sin(np.radians(angle))
    return wk.Creepage(
        unit * along / c.longitudinal, unit * across / c.lateral, unit * spin / (c.spin * math.sqrt(square))
    )


def rolled(ratio: float, poisson: float, rows: Rows, count: int = COUNT) -> tuple[object, object, float]:
    """Return the simplified and the exact solution, and the length sqrt(ab)."""
    body = wk.Elastic(1.0, poisson)
    pair, bodies = wk.HalfSpace.between(body, body), bodies_of(ratio)
    axes = bodies.semi_axes(pair.modulus, FORCE)
    creepage = creepages(ratio, poisson, axes, body.shear, rows)
    wide = count + 2 * MARGIN
    rough = wk.SampledProfile(np.array(axes) * 2.0 * wide / count, bodies, (wide, wide))
    exact = wk.SurfaceRolling(rough, pair, wk.Force(FORCE), wk.Coulomb(MU), creepage).solve()
    simple = wk.SimplifiedRolling(bodies, pair, wk.Coulomb(MU), creepage, wk.Force(FORCE)).solve()
    return simple, exact, math.sqrt(axes[0] * axes[1])


def apart(simple: object, exact: object, length: float) -> tuple[float, float]:
    """Return the greatest differences of the force over mu F_N, and of the moment over mu F_N sqrt(ab)."""
    most = MU * FORCE
    along, across = (
        np.subtract(getattr(simple, n), getattr(exact, n)) for n in ("longitudinal_force", "lateral_force")
    )
    turned = np.subtract(simple.moment, exact.moment)
    return float(np.max(np.hypot(along, across)) / most), float(np.max(np.abs(turned)) / (most * length))


def ellipse_row(ratio: float, poisson: float, one: Rows = ONE, both: Rows = BOTH, spun: Rows = SPUN) -> list[float]:
    """Return the distances of `SimplifiedRolling` in the order of `EllipseDistances`."""
    (first, turned), (second, twisted), (third, spinning) = (
        apart(*rolled(ratio, poisson, rows)) for rows in (one, both, spun)
    )
    return [first, second, third, max(turned, twisted), spinning]


def ball_row(poisson: float, one: Rows = ONE, both: Rows = BOTH) -> list[float]:
    """Return the distances of `Rolling` of a ball under one creepage, and under both."""
    found = []
    for rows in (one, both):
        _, exact, _ = rolled(1.0, poisson, rows)
        problem = exact.problem
        bed = wk.Foundation(wk.Paraboloid(1.0), problem.medium)
        line = wk.Rolling(bed, wk.Coulomb(MU), problem.drive, wk.Force(FORCE)).solve()
        off = [np.subtract(getattr(line, n), getattr(exact, n)) for n in ("longitudinal_force", "lateral_force")]
        found.append(float(np.max(np.hypot(*off))) / (MU * FORCE))
    return found


def layered_row(contrast: float, width: float, poisson: float, count: int = 40) -> list[float]:
    """Return the distances of `Rolling` of a ball on a layer of a contrast and a contact radius over its thickness."""
    a, layer = 1e-2, wk.Layer(wk.Elastic(contrast, poisson), 1e-2 / width)
    medium = wk.CoatedHalfSpace([layer], wk.Elastic(1.0, poisson))
    bed = wk.Foundation(wk.Paraboloid(1.0), medium)
    load = wk.Force(float(wk.Indentation(bed, wk.Radius(a)).solve().force))
    most, stiffness = MU * load.force, np.array(wk.Kalker().stiffness(bed, a))
    wide, found = count + 2 * MARGIN, []
    rough = wk.SampledProfile([2.0 * a * wide / count] * 2, wk.Paraboloid(1.0), (wide, wide))
    for rows in (ONE, BOTH):
        amount, angle, _ = np.array(rows).T
        each = amount * np.stack([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        creepage = wk.Creepage(*(1.5 * most / a**2 * each / stiffness[:, None]))
        exact = wk.SurfaceRolling(rough, medium, load, wk.Coulomb(MU), creepage).solve()
        line = wk.Rolling(bed, wk.Coulomb(MU), creepage, load).solve()
        off = [np.subtract(getattr(line, n), getattr(exact, n)) for n in ("longitudinal_force", "lateral_force")]
        found.append(float(np.max(np.hypot(*off))) / most)
    return found


def upward(number: float) -> float:
    """Return a number rounded up to hundredths, with what pixels and creepages between may add."""
    return math.ceil(100.0 * (number + BETWEEN)) / 100.0


def main() -> None:
    """Print the tables."""
    from winkler.problems.rolling.distances import POISSON, RATIOS

    for ratio in RATIOS:
        print("    [" + ", ".join(str([upward(part) for part in ellipse_row(ratio, nu)]) for nu in POISSON) + "],")
    print([[upward(part) for part in ball_row(nu)] for nu in POISSON])
    layers = [
        layered_row(contrast, width, nu)
        for contrast in (0.1, 10.0)
        for width in (0.3, 1.0, 3.0, 10.0, 30.0)
        for nu in NU
    ]
    print([upward(part) for part in np.max(layers, axis=0)])


if __name__ == "__main__":
    main()
