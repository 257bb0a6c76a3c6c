r"""Springs under half an ellipse with an edge that attraction holds: plain arithmetic, which other languages share.

.. math:: g(x) = A\sin^2\tfrac\varphi2, \qquad x = b\sin\varphi , \qquad
          F = E_c\int_{-a}^{a}(u-g(x))\,\mathrm dx, \qquad g(a)-u = \sqrt{2\pi a w/E_c}

`springs` are E_c [Pa], A and b [m], and the d_0 [m] and s [-] of u = (d - d_0)/s.  A ball's are A = 4R, b = R; of a
paraboloid both in the limit A = 4R n^2, b = Rn of a great n.
"""

from __future__ import annotations

import math

Springs5 = tuple[float, float, float, float, float]
ANGLE_SERIES = tuple((-1) ** k * (4.0**k - 4.0) / (3.0 * math.factorial(2 * k + 1)) for k in range(13, 1, -1))
"""Of the angle less its value by the sine, over its fifth power: factors of powers of its square, the highest first."""
SERIES_ANGLE, SMALL_ANGLE, FEW_TERMS = 1.2, 0.3, 5
"""Below the first the series is exact to rounding, below the second without so many terms, which are the highest."""
FULL_CONTACT_ANGLE = 0.5 * math.pi
"""The angle at which all springs are in contact."""
CRITICAL, BALANCED = 0, 1
"""What vanishes at the root that is looked for."""
MOST_TRIALS = 400
ROOT_TOLERANCE = 4e-16


def _half_square_and_sine(angle: float) -> tuple[float, float]:
    """Return the squared sine of half an angle, and the sine of the angle itself."""
    half = math.sin(0.5 * angle)
    square = half * half
    return square, 2.0 * half * math.sqrt(1.0 - square)


def spring_sums(springs: Springs5, angle: float, compression: float) -> tuple[float, float]:
    r"""Return force [N] and elastic energy of the springs [J], exact to rounding.

    With the integrals from 0 to the angle :math:`\varphi`, :math:`s = \sin\tfrac\varphi2`,

    .. math:: \int\cos\theta\sin^2\tfrac\theta2 = \tfrac13 s^2\sin\varphi - \tfrac14 D, \qquad
              \int\cos\theta\sin^4\tfrac\theta2 = \tfrac13 s^4\sin\varphi - \tfrac14 D, \qquad
              D = \varphi - (1 + \tfrac23 s^2)\sin\varphi .
    """
    modulus, height, half_width, _, _ = springs
    square, sine = _half_square_and_sine(angle)
    if angle < SERIES_ANGLE:
        x = angle * angle
        rest = 0.0
        for k in range(FEW_TERMS if angle < SMALL_ANGLE else 0, len(ANGLE_SERIES)):
            rest = rest * x + ANGLE_SERIES[k]
        rest *= angle * x * x
    else:
        rest = angle - sine * (1.0 + 2.0 / 3.0 * square)
    second = height * (sine * square / 3.0 - 0.25 * rest)
    fourth = height * height * (sine * square * square / 3.0 - 0.25 * rest)
    scale = modulus * half_width
    force = 2.0 * scale * (compression * sine - second)
    return force, scale * (compression * (compression * sine - 2.0 * second) + fourth)


def balanced(springs: Springs5, angle: float, work: float) -> float:
    """Return the compression of the springs when an edge at the angle is just held by a work of adhesion [m]."""
    modulus, height, half_width, _, _ = springs
    square, sine = _half_square_and_sine(angle)
    return height * square - math.sqrt(2.0 * math.pi * half_width * sine * work / modulus)


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
    square, sine = _half_square_and_sine(angle)
    cosine = 1.0 - 2.0 * square
    if what == CRITICAL:
        root = math.sqrt(sine)
        return sine * root - target * cosine, 1.5 * root * cosine + target * sine
    stretch = math.sqrt(2.0 * math.pi * half_width * sine * work / modulus)
    slope = 0.5 * height * sine
    if stretch > 0.0:
        slope -= 0.5 * cosine * stretch / sine
    return height * square - stretch - target, slope


def _angle_of(springs: Springs5, what: int, work: float, target: float, least: float, guess: float) -> float:
    """Return the angle beyond `least` where an excess that grows from below zero vanishes: bounded Newton steps."""
    low = least
    high = FULL_CONTACT_ANGLE
    angle = guess if low < guess < high else 0.5 * (low + high)
    moved = 0.0
    before = 0.0
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
        # the step after this one would be about the curvature over twice the slope, times its square
        step = better - angle
        last = abs((slope - before) * step) * abs(step) <= 2.0 * ROOT_TOLERANCE * angle * abs(slope * moved)
        moved = step
        before = slope
        angle = better
        if last:
            break
    return angle


def critical_angle(springs: Springs5, work: float, factor: float) -> float:
    """Return the angle where a g' is `factor` times the stretch of the last spring: the end of stability.

    1/2 under a prescribed depth, 3/2 under a dead load.
    """
    if work == 0.0:
        return 0.0
    number = _critical_number(springs, work, factor)
    return _angle_of(springs, CRITICAL, work, number, 0.0, _beyond_critical(number))


def _critical_number(springs: Springs5, work: float, factor: float) -> float:
    """Return what the sine to the power 3/2 is over the cosine, of the critical angle."""
    modulus, height, half_width, _, _ = springs
    return 2.0 * factor * math.sqrt(2.0 * math.pi * half_width * work / modulus) / height


def _beyond_critical(number: float) -> float:
    """Return an angle that is greater than the critical one, and near it where that is small."""
    return math.asin(min(number, 1.0) ** (2.0 / 3.0))


def least_stable(springs: Springs5, compression: float, work: float, near: float) -> float:
    """Return the critical angle at a prescribed depth, or a greater one that is below both `near` and the stable edge.

    The greater one needs no search.
    """
    beyond = _beyond_critical(_critical_number(springs, work, 0.5))
    if near >= beyond and compression >= balanced(springs, beyond, work):
        return beyond
    return critical_angle(springs, work, 0.5)


def held_edge(springs: Springs5, compression: float, work: float, near: float) -> float:
    """Return the angle of the stable edge at a depth; zero if there is none. It is looked for from `near` on."""
    least = least_stable(springs, compression, work, near)
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
