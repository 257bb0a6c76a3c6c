"""What twelve calculators compute: similarity of each problem, with all pure numbers from tables of the package.

A kernel takes the numbers of its sliders in SI units, its tables, and the array for its answers.  The laws of contact
are in the tables (`winkler.calculators.tables`): a kernel knows how results grow with lengths, moduli and forces.
"""

from __future__ import annotations

import math

from winkler.calculators.series import series, series_of_two
from winkler.numerics.types import Array

__all__ = [
    "adhesion", "conduction", "damping", "graded", "heating", "normal", "rolling", "roughness", "tangential", "torsion",
    "viscoelastic", "wear",
]  # fmt: skip

COMPLETE = 40.0
"""Times of retardation after which creep is complete to all digits."""


def together(young: float, poisson: float, other_young: float, other_poisson: float) -> float:
    """Return E* [Pa] of two bodies."""
    return 1.0 / ((1.0 - poisson**2) / young + (1.0 - other_poisson**2) / other_young)


def sheared(young: float, poisson: float) -> float:
    """Return G* [Pa] of two bodies that are alike."""
    return young / ((1.0 + poisson) * (2.0 - poisson))


def ball_depth(hertz: Array, modulus: float, radius: float, force: float) -> float:
    """Return the depth [m] of a ball."""
    return float(hertz[0] * (force**2 / (radius * modulus**2)) ** (1.0 / 3.0))


def ball_radius(hertz: Array, modulus: float, radius: float, force: float) -> float:
    """Return the contact radius [m] of a ball."""
    return float(hertz[1] * (force * radius / modulus) ** (1.0 / 3.0))


def normal(x: Array, hertz: Array, y: Array) -> None:
    """A ball on a body: depth, contact radius, greatest and mean pressure, stiffness."""
    modulus = together(x[2], x[3], x[4], x[5])
    y[0] = ball_depth(hertz, modulus, x[0], x[1])
    y[1] = ball_radius(hertz, modulus, x[0], x[1])
    y[2] = hertz[2] * (x[1] * modulus**2 / x[0] ** 2) ** (1.0 / 3.0)
    y[3] = hertz[3] * (x[1] * modulus**2 / x[0] ** 2) ** (1.0 / 3.0)
    y[4] = hertz[4] * (x[1] * x[0] * modulus**2) ** (1.0 / 3.0)


def tangential(x: Array, hertz: Array, shift: Array, stick: Array, y: Array) -> None:
    """A ball pushed along the surface: shift, shear force, contact radius, stick radius."""
    modulus = together(x[2], x[3], x[2], x[3])
    a = ball_radius(hertz, modulus, x[0], x[1])
    most = x[4] * ball_depth(hertz, modulus, x[0], x[1]) * modulus / sheared(x[2], x[3])
    s = (1.0 - x[5]) ** (1.0 / 3.0)
    y[0] = most * x[5] * series(shift, s)
    y[1] = x[5] * x[4] * x[1]
    y[2] = a
    y[3] = a * series(stick, s)


def rolling(x: Array, line: Array, creepage: Array, stick: Array, y: Array) -> None:
    """A cylinder that rolls and pulls: creepage, force, part that sticks, half-width, greatest pressure, loss."""
    modulus = together(x[2], x[3], x[2], x[3])
    half = line[0] * math.sqrt(x[1] * x[0] / modulus)
    s = math.sqrt(1.0 - x[5])
    y[0] = x[4] * half / x[0] * x[5] * series(creepage, s)
    y[1] = x[5] * x[4] * x[1]
    y[2] = series(stick, s)
    y[3] = half
    y[4] = line[1] * math.sqrt(x[1] * modulus / x[0])
    y[5] = y[0] * y[1]


def adhesion(x: Array, pull: Array, radius: Array, depth: Array, y: Array) -> None:
    """A ball that sticks: contact radius, depth, force, pull-off force, contact radius when it parts."""
    modulus = x[1] / (1.0 - x[2] ** 2)
    unit = (x[0] ** 2 * x[3] / modulus) ** (1.0 / 3.0)
    s = math.sqrt(1.0 + x[4])
    y[3] = pull[0] * x[0] * x[3]
    y[0] = unit * series(radius, s)
    y[1] = unit**2 / x[0] * series(depth, s)
    y[2] = -x[4] * y[3]
    y[4] = pull[1] * unit


def heating(x: Array, hertz: Array, peak: Array, y: Array) -> None:
    """A ball that rubs on a moving body: greatest temperature, heat, share of that body, Peclet number, radius."""
    a = ball_radius(hertz, together(x[2], x[3], x[2], x[3]), x[0], x[1])
    y[4] = a
    y[1] = x[4] * x[1] * x[5]
    y[3] = 0.5 * x[5] * a / x[7]
    moving = series(peak, math.log1p(y[3])) / (a * x[6])
    still = series(peak, 0.0) / (a * x[8])
    y[2] = still / (still + moving)
    y[0] = y[1] * y[2] * moving


def conduction(x: Array, hertz: Array, spot: Array, film: Array, y: Array) -> None:
    """A current from a ball into a body: resistance, its parts by constriction and film, contact radius, depth."""
    modulus = together(x[2], x[3], x[2], x[3])
    a = ball_radius(hertz, modulus, x[0], x[1])
    both = x[4] + x[5]
    y[1] = both / a * series(spot, math.log(x[6] / (both * a)))
    y[2] = film[0] * x[6] / a**2
    y[0] = y[1] + y[2]
    y[3] = a
    y[4] = ball_depth(hertz, modulus, x[0], x[1])


def viscoelastic(x: Array, hertz: Array, crept: Array, y: Array) -> None:
    """A ball on a solid that creeps: depth, contact radius."""
    last = 4.0 * x[2]
    first = 4.0 * (x[2] + x[3])
    times = x[5] * x[2] / (x[4] * (x[2] + x[3]))
    grown = series(crept, math.log1p(min(times, COMPLETE)))
    modulus = 1.0 / (1.0 / first + (1.0 / last - 1.0 / first) * grown)
    y[0] = ball_depth(hertz, modulus, x[0], x[1])
    y[1] = ball_radius(hertz, modulus, x[0], x[1])


def graded(x: Array, force: Array, depth: Array, stiffness: Array, y: Array) -> None:
    """A ball on a body that stiffens with depth: depth, contact radius, stiffness, mean pressure."""
    unit = x[2] / x[3] ** x[4]
    a = (x[1] * x[0] / (unit * math.exp(series_of_two(force, x[4], x[5])))) ** (1.0 / (3.0 + x[4]))
    y[0] = a**2 / x[0] * series(depth, x[4])
    y[1] = a
    y[2] = x[1] / y[0] * series(stiffness, x[4])
    y[3] = x[1] / (math.pi * a**2)


def damping(x: Array, hertz: Array, shift: Array, loss: Array, y: Array) -> None:
    """A ball pushed to and fro: loss in a cycle, amplitudes of force and shift, contact radius."""
    modulus = together(x[2], x[3], x[2], x[3])
    most = x[4] * ball_depth(hertz, modulus, x[0], x[1]) * modulus / sheared(x[2], x[3])
    s = (1.0 - x[5]) ** (1.0 / 3.0)
    y[0] = x[4] * x[1] * most * x[5] ** 3 * series(loss, s)
    y[1] = x[5] * x[4] * x[1]
    y[2] = most * x[5] * series(shift, s)
    y[3] = ball_radius(hertz, modulus, x[0], x[1])


def roughness(x: Array, hertz: Array, least: Array, greatest: Array, spot: Array, y: Array) -> None:
    """A rough ball on a body: least, smooth and greatest conductance, the same of the stiffness."""
    modulus = together(x[2], x[3], x[2], x[3])
    smooth = hertz[4] * (x[1] * x[0] * modulus**2) ** (1.0 / 3.0)
    rough = math.log(x[4] / ball_depth(hertz, modulus, x[0], x[1]))
    y[3] = smooth * math.exp(series(least, rough))
    y[4] = smooth
    y[5] = smooth * math.exp(series(greatest, rough))
    per = spot[0] / (modulus * (x[5] + x[5]))
    for k in range(3):
        y[k] = per * y[3 + k]


def wear(x: Array, ends: Array, stick: Array, radius: Array, force: Array, volume: Array, y: Array) -> None:
    """A ball that frets until no more is worn: volume, radius of its core and of its contact, force, amplitude."""
    modulus = together(x[2], x[3], x[2], x[3])
    most = x[4] * x[1] * modulus / sheared(x[2], x[3])
    a = ends[0] * math.sqrt(x[0] * x[1])
    s = math.sqrt(1.0 - x[5])
    y[0] = a**4 / x[0] * math.exp(series(volume, s))
    y[1] = a * series(stick, s)
    y[2] = a * series(radius, s)
    y[3] = modulus * a * x[1] * series(force, s)
    y[4] = most * x[5]


def torsion(x: Array, hertz: Array, most: Array, angle: Array, stick: Array, y: Array) -> None:
    """A ball that is twisted: angle, torque, contact radius, radius that sticks, greatest torque."""
    a = ball_radius(hertz, together(x[2], x[3], x[2], x[3]), x[0], x[1])
    y[4] = most[0] * x[4] * x[1] * a
    y[1] = x[5] * y[4]
    y[0] = x[4] * x[1] * 4.0 * (1.0 + x[3]) / (x[2] * a**2) * x[5] * series(angle, x[5])
    y[2] = a
    y[3] = a * series(stick, x[5])
