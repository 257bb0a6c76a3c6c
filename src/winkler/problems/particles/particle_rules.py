"""What an elastic-plastic, adhesive particle does when its depth changes: arithmetic that other languages share.

The edge of the contact advances when it gains more than closing needs, recedes when parting is paid for, else it rests;
beyond the greatest depth so far, and beyond yield, the particle yields.  `winkler.problems.particles.elastic_plastic`
tells where the law comes from.
"""

from __future__ import annotations

import math

from winkler.problems.particles.particle_edge import (
    FULL_CONTACT_ANGLE,
    Springs5,
    balanced,
    held_edge,
    least_stable,
    potential,
    spring_sums,
    stable_edge,
)

Particle = tuple[float, float, float, float, float, float, float, float, float, float]
"""R [m], Y, G [Pa], nu, E_c [Pa], depth of yield [m], A and b before it [m], works of closing and opening [J/m^2]."""
ParticleMemory = tuple[float, float, float, bool, float]
"""Greatest depth, compression of the springs [m], angle of the edge, whether it touches, work spent [J]."""
YIELD_PRESSURE_RISE, YIELD_PRESSURE_FALL = 1.75, 4.4
"""Of the yield pressure, fitted by Zunker and Kamrin to finite elements."""


def yield_pressure(radius: float, strength: float, depth: float) -> float:
    """Return p_Y [Pa] at a depth."""
    return strength * (YIELD_PRESSURE_RISE * math.exp(-YIELD_PRESSURE_FALL * depth / radius) + 1.0)


def yield_square(radius: float, onset: float, depth: float) -> float:
    """Return b^2 [m^2]: that of Hertz where yield begins, then that of a ball cut off at the depth."""
    return depth * (2.0 * radius - depth) - onset * (radius - onset)


def yield_force(particle: Particle, depth: float) -> float:
    """Return the force that presses the particle deeper than ever before, beyond yield [N]."""
    radius, strength, _, _, _, onset, _, _, _, _ = particle
    return math.pi * yield_square(radius, onset, depth) * yield_pressure(radius, strength, depth)


def yield_work(particle: Particle, depth: float) -> float:
    """Return the integral of that force over the depth, up to a constant [J]."""
    radius, strength, _, _, _, onset, _, _, _, _ = particle
    offset = onset * (onset - radius)
    rate = YIELD_PRESSURE_FALL / radius
    plain = depth * (offset + depth * (radius - depth / 3.0))
    falling = yield_square(radius, onset, depth) / rate + 2.0 * (radius - depth) / (rate * rate)
    falling -= 2.0 / (rate * rate * rate)
    return math.pi * strength * (plain - YIELD_PRESSURE_RISE * math.exp(-rate * depth) * falling)


def particle_springs(particle: Particle, largest: float) -> Springs5:
    """Return the springs after the particle was once pressed to a depth."""
    radius, strength, shear, poisson, modulus, onset, height, half_width, _, _ = particle
    if largest <= onset:
        return modulus, height, half_width, 0.0, 1.0
    square = yield_square(radius, onset, largest)
    b = math.sqrt(square)
    high = 4.0 * yield_pressure(radius, strength, largest) * b / modulus
    compression = 0.5 * high
    centre = radius - (largest - compression)
    far = math.hypot(b, centre)
    # how far the centre of the particle moves under the uniform pressure, against its surface far away
    bent = 2.0 * square * (poisson - 1.0) - (2.0 * poisson - 1.0) * centre * (far - centre)
    bulk = yield_force(particle, largest) * bent / (2.0 * math.pi * shear * square * far)
    return modulus, high, b, largest - compression - bulk, 1.0 + bulk / compression


def particle_depth(particle: Particle, memory: ParticleMemory, depth: float) -> ParticleMemory:
    """Return the memory of the particle once it is at a depth."""
    _, _, _, _, _, onset, _, _, closing, opening = particle
    largest, compression, angle, touching, work = memory
    springs = particle_springs(particle, largest)
    _, _, _, origin, stretch = springs
    roof = max(largest, onset)
    goal = (min(depth, roof) - origin) / stretch
    compression, angle, touching, work = _within(springs, closing, opening, compression, angle, touching, work, goal)
    deepest = max(largest, depth)
    if depth <= roof:
        return deepest, compression, angle, touching, work
    work += yield_work(particle, depth) - yield_work(particle, roof)
    _, _, _, origin, stretch = particle_springs(particle, deepest)
    return deepest, (depth - origin) / stretch, FULL_CONTACT_ANGLE, True, work


def _within(
    springs: Springs5, closing: float, opening: float, start: float, angle: float, touching: bool, work: float,
    goal: float,
) -> tuple[float, float, bool, float]:  # fmt: skip
    """Move while the particle does not yield; return compression, angle, whether it touches, and work."""
    if not touching:
        if goal < 0.0:
            return goal, angle, False, work
        start = 0.0
        angle = held_edge(springs, 0.0, closing, 0.0)
    if goal > balanced(springs, angle, closing):
        edge = held_edge(springs, goal, closing, angle)
        return goal, edge, True, work + _spent(springs, start, angle, goal, edge, closing)
    if goal >= balanced(springs, angle, opening):
        return goal, angle, True, work + _spent(springs, start, angle, goal, angle, opening)
    least = least_stable(springs, goal, opening, angle)
    if angle < least or goal < balanced(springs, least, opening):
        end = min(angle, least)
        last = balanced(springs, end, opening)
        return goal, 0.0, False, work + _spent(springs, start, angle, last, end, opening)
    edge = stable_edge(springs, goal, opening, least, angle)
    return goal, edge, True, work + _spent(springs, start, angle, goal, edge, opening)


def _spent(springs: Springs5, start: float, angle: float, goal: float, edge: float, work: float) -> float:
    """Let the edge rest, go to an angle while it is just held, and rest again; return what that takes [J]."""
    if edge == angle:
        return _rested(springs, angle, start, goal)
    first = balanced(springs, angle, work)
    last = balanced(springs, edge, work) if edge == FULL_CONTACT_ANGLE else goal
    spent = _rested(springs, angle, start, first) + _rested(springs, edge, last, goal)
    return spent + potential(springs, edge, last, work) - potential(springs, angle, first, work)


def _rested(springs: Springs5, angle: float, start: float, stop: float) -> float:
    """Return what is spent while the edge rests [J]: the force is linear, so that of the middle counts."""
    if start == stop:
        return 0.0
    force, _ = spring_sums(springs, angle, 0.5 * (start + stop))
    _, _, _, _, stretch = springs
    return stretch * force * (stop - start)
