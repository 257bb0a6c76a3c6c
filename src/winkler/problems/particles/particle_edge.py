r"""Springs under half an ellipse with an edge that attraction holds: plain arithmetic, which other languages share.

.. math:: g(x) = A\sin^2\tfrac\varphi2, \qquad x = b\sin\varphi , \qquad
          F = E_c\int_{-a}^{a}(u-g(x))\,\mathrm dx, \qquad g(a)-u = \sqrt{2\pi a w/E_c}

`springs` are E_c [Pa], A and b [m], and the d_0 [m] and s [-] of u = (d - d_0)/s.  A ball's are A = 4R, b = R; of a
paraboloid both in the limit A = 4R n^2, b = Rn of a great n.
"""

from __future__ import annotations

import math

import numpy as np

__all__ = [
    "FULL_CONTACT_ANGLE", "Springs5", "balanced", "critical_angle", "held_edge", "potential", "spring_sums",
    "stable_edge", "with_surface",
]  # fmt: skip

Springs5 = tuple[float, float, float, float, float]
NODES, WEIGHTS = (tuple(map(float, row)) for row in np.polynomial.legendre.leggauss(16))
FEW_NODES, FEW_WEIGHTS = (tuple(map(float, row)) for row in np.polynomial.legendre.leggauss(6))
THREE_NODES, THREE_WEIGHTS = (tuple(map(float, row)) for row in np.polynomial.legendre.leggauss(3))
SMALL_ANGLE, LEAST_ANGLE = 0.3, 1e-6
"""Below the first six nodes are exact to rounding, below the second, where half an ellipse is a parabola, three."""
FULL_CONTACT_ANGLE = 0.5 * math.pi
"""The angle at which all springs are in contact."""
CRITICAL, BALANCED = 0, 1
"""What vanishes at the root that is looked for."""
MOST_TRIALS = 400
ROOT_TOLERANCE = 4e-16


def spring_sums(springs: Springs5, angle: float, compression: float) -> tuple[float, float]:
    """Return force [N] and elastic energy of the springs [J], from quadrature that is exact to rounding."""
    if angle < LEAST_ANGLE:
        return _summed(THREE_NODES, THREE_WEIGHTS, springs, angle, compression)
    if angle < SMALL_ANGLE:
        return _summed(FEW_NODES, FEW_WEIGHTS, springs, angle, compression)
    return _summed(NODES, WEIGHTS, springs, angle, compression)


def _summed(
    nodes: tuple[float, ...], weights: tuple[float, ...], springs: Springs5, angle: float, compression: float
) -> tuple[float, float]:
    """Return both sums at given nodes."""
    modulus, height, half_width, _, _ = springs
    force = 0.0
    energy = 0.0
    for k in range(len(nodes)):
        theta = 0.5 * angle * (nodes[k] + 1.0)
        sine = math.sin(0.5 * theta)
        pressed = compression - height * sine * sine
        weight = modulus * half_width * angle * weights[k] * (1.0 - 2.0 * sine * sine)
        force += weight * pressed
        energy += 0.5 * weight * pressed * pressed
    return force, energy


def balanced(springs: Springs5, angle: float, work: float) -> float:
    """Return the compression of the springs when an edge at the angle is just held by a work of adhesion [m]."""
    modulus, height, half_width, _, _ = springs
    sine = math.sin(0.5 * angle)
    return height * sine * sine - math.sqrt(2.0 * math.pi * half_width * math.sin(angle) * work / modulus)


def potential(springs: Springs5, angle: float, compression: float, work: float) -> float:
    """Return elastic and surface energy, at a prescribed depth [J]."""
    _, energy = spring_sums(springs, angle, compression)
    return with_surface(springs, angle, energy, work)


def with_surface(springs: Springs5, angle: float, energy: float, work: float) -> float:
    """Return the energy of the springs together with that of the surface [J]."""
    _, _, half_width, _, stretch = springs
    radius = half_width * math.sin(angle)
    return stretch * (energy - work * math.pi * radius * radius)


def _excess(springs: Springs5, what: int, angle: float, work: float, target: float) -> tuple[float, float]:
    """Return what vanishes at the angle that is looked for, and its slope."""
    modulus, height, half_width, _, _ = springs
    sine = math.sin(angle)
    cosine = math.cos(angle)
    if what == CRITICAL:
        root = math.sqrt(sine)
        return sine * root - target * cosine, 1.5 * root * cosine + target * sine
    slope = 0.5 * height * sine
    if sine > 0.0 and work > 0.0:
        slope -= cosine * math.sqrt(0.5 * math.pi * half_width * work / (modulus * sine))
    return balanced(springs, angle, work) - target, slope


def _angle_of(springs: Springs5, what: int, work: float, target: float, least: float, guess: float) -> float:
    """Return the angle beyond `least` where an excess that grows from below zero vanishes: bounded Newton steps."""
    low = least
    high = FULL_CONTACT_ANGLE
    angle = guess if low < guess < high else 0.5 * (low + high)
    trials = 0
    while trials < MOST_TRIALS:
        trials += 1
        value, slope = _excess(springs, what, angle, work, target)
        if value == 0.0:
            break
        if value < 0.0:
            low = angle
        else:
            high = angle
        better = angle - value / slope if slope > 0.0 else low
        if abs(better - angle) <= ROOT_TOLERANCE * angle or high - low <= ROOT_TOLERANCE * high:
            break
        if not low < better < high:
            better = math.sqrt(low * high) if low > 0.0 and high > 2.0 * low else 0.5 * (low + high)
        if not low < better < high:
            break
        angle = better
    return angle


def critical_angle(springs: Springs5, work: float, factor: float) -> float:
    """Return the angle where a g' is `factor` times the stretch of the last spring: the end of stability.

    1/2 under a prescribed depth, 3/2 under a dead load.
    """
    if work == 0.0:
        return 0.0
    modulus, height, half_width, _, _ = springs
    number = 2.0 * factor * math.sqrt(2.0 * math.pi * half_width * work / modulus) / height
    return _angle_of(springs, CRITICAL, work, number, 0.0, math.asin(min(number, 1.0) ** (2.0 / 3.0)))


def held_edge(springs: Springs5, compression: float, work: float, near: float) -> float:
    """Return the angle of the stable edge at a depth; zero if there is none. It is looked for from `near` on."""
    least = critical_angle(springs, work, 0.5)
    if work > 0.0 and compression < balanced(springs, least, work):
        return 0.0
    return stable_edge(springs, compression, work, least, near)


def stable_edge(springs: Springs5, compression: float, work: float, least: float, near: float) -> float:
    """Return the same where it is known to be at `least` or beyond."""
    _, height, _, _, _ = springs
    if work == 0.0:
        return 2.0 * math.asin(math.sqrt(min(max(compression, 0.0) / height, 0.5)))
    if compression <= balanced(springs, least, work):
        return least
    if compression >= balanced(springs, FULL_CONTACT_ANGLE, work):
        return FULL_CONTACT_ANGLE
    sine = math.sqrt(min(max(compression, 0.0) / height, 0.5))
    guess = near if near > least else max(2.0 * math.asin(sine), 2.0 * least)
    return _angle_of(springs, BALANCED, work, compression, least, guess)
