"""Random histories of kernels: what they take, by the name of the kernel, from stored seeds."""

from __future__ import annotations

import copy

import numpy as np

from winkler.media.interior.rectangle import corners_at, sum_corners
from winkler.numerics.springs.contact_kernels import impact_balls, move_balls, turn_balls
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.springs.fastsim import strip
from winkler.numerics.springs.free_relaxation import Recovery
from winkler.numerics.springs.hereditary import forces_of_motion, motion_of_forces
from winkler.numerics.springs.relaxing_friction import drag
from winkler.numerics.springs.relaxing_springs import advance_springs, advance_to_force
from winkler.numerics.springs.rolling_kernels import push, roll
from winkler.numerics.springs.slip_kernels import march_line
from winkler.numerics.springs.slip_plane import march_plane
from winkler.numerics.springs.slip_pull import pull_line
from winkler.numerics.springs.spring_pass import pass_over

SERIES = RelaxationSeries(0.3, 0.0, np.array([0.5, 0.2]), np.array([0.1, 1.7]))
"""A solid with two relaxation times."""


def law():
    """Return what the kernels of relaxing springs take of the solid."""
    return Recovery.of(SERIES).law(SERIES)


def corners(rng):
    return rng.normal(size=5), rng.normal(size=4), 0.3, 0.3, 1e-20, bool(rng.integers(2)), np.zeros((9, 5, 4))


def sums_of_corners(rng):
    places = rng.uniform(0.1, 2.0, (6, 3))
    return places, rng.normal(size=(4, 2)), rng.normal(size=(4, 3)), True, 0.28, 1e-20, np.zeros((6, 9))


def balls(rng):
    n, steps = 3, 12
    radius, spacing = rng.uniform(0.5, 2.0, n), rng.uniform(0.05, 0.1, n)
    depth, motion = rng.uniform(-0.1, 0.4, (n, steps + 1)), rng.normal(scale=0.05, size=(n, steps, 2))
    return (
        np.zeros((n, 9, 2)), radius, spacing, rng.uniform(1.0, 2.0, n), rng.uniform(0.2, 0.6, n), depth, motion,
        np.zeros((n, steps, 2)), np.zeros((n, steps)), np.zeros((n, steps)),
    )  # fmt: skip


def turns(rng):
    n, steps = 3, 12
    stiffness, moment = rng.uniform(0.0, 1.0, (n, steps + 1)), rng.uniform(0.0, 1.0, (n, steps + 1))
    turn = rng.normal(size=(n, steps, 2))
    return (
        np.zeros((n, 2)),
        stiffness,
        moment,
        turn,
        np.zeros((n, steps, 2)),
        np.zeros((n, steps)),
        np.zeros((n, steps)),
    )


def impacts(rng):
    n = 3
    one = np.ones(n)
    velocity, sliding = rng.uniform(0.5, 1.0, n), rng.normal(size=(n, 2))
    out = [np.zeros(n) for _ in range(3)]
    return (np.zeros((7, 2)), one, one, 0.8 * one, 0.4 * one, one, 2.5 * one, 0.02 * one, 1.5 * one, 800, velocity,
            sliding, *out)  # fmt: skip


def line(rng):
    n, steps = 60, 15
    gap = np.sort(rng.uniform(0.0, 1.0, n))
    depth, shift = rng.uniform(-0.1, 1.0, steps + 1), rng.normal(scale=0.3, size=steps + 1)
    depth[5:8] = depth[5]
    slope = np.full(n, 0.4) if rng.integers(2) else rng.uniform(0.2, 0.5, n)
    return np.zeros(n), gap, rng.uniform(0.5, 1.0, n), slope, depth, shift, *(np.zeros(steps) for _ in range(3))


def pulled(rng):
    n, steps = 40, 10
    gap, stiffness, slope = np.sort(rng.uniform(0.0, 1.0, n)), rng.uniform(0.5, 1.0, n), np.full(n, 0.4)
    depth = rng.uniform(0.3, 1.0, steps + 1)
    most = np.array([np.sum(stiffness * slope * np.maximum(d - gap, 0.0)) for d in depth[1:]])
    target = 0.9 * most * rng.uniform(-1.0, 1.0, steps)
    return (np.zeros(n), gap, stiffness, slope, depth, target, np.zeros(steps + 1),
            *(np.zeros(steps) for _ in range(3)))  # fmt: skip


def plane(rng):
    n, steps = 300, 12
    gap = np.sort(rng.uniform(0.0, 1.0, n))
    depth = rng.uniform(0.1, 1.0, steps + 1)
    depth[5:8] = depth[5]
    bound = 0.3 * np.maximum(depth[:, None] - gap, 0.0)
    shift = np.cumsum(rng.normal(scale=0.2, size=(steps + 1, 2)), axis=0)
    hold = 1.0 if rng.integers(2) else 1.4
    return (np.zeros((2, n)), np.zeros(n, dtype=bool), gap, rng.uniform(0.5, 1.0, n), bound, hold, depth, shift,
            np.zeros((steps, 2)), np.zeros(steps), np.zeros(steps))  # fmt: skip


def strips(rng):
    n = 20
    edges = np.linspace(0.01, 0.99, 2 * n + 1)
    halves = np.log(edges[1:] / edges[:-1]) - np.log((1.0 - edges[1:]) / (1.0 - edges[:-1]))
    fall = np.append(rng.normal(size=4), rng.choice([0.4, 1.0]))
    return (
        float(rng.uniform(-0.9, 0.9)), rng.normal(size=4), fall, halves, np.zeros((2, n + 1)), np.zeros(n + 1),
        np.zeros(4),
    )  # fmt: skip


def rows(rng):
    x = np.linspace(-1.0, 1.0, 30)
    return rng.uniform(-0.1, 0.1, 30), 0.5 * (1.0 - x * x), 0.4, float(rng.uniform(0.0, 0.05)), 50


def pushes(rng):
    x = np.linspace(-1.0, 1.0, 30)
    bound = 0.5 * (1.0 - x * x)
    force = float(rng.uniform(-0.5, 0.5))
    return np.zeros(30), bound, np.full(30, 2.0 / 30), 0.4, int(rng.choice([-1, 0, 1])), force, 20


def relaxing(rng):
    n, steps = 25, 20
    x = np.linspace(0.0, 1.0, n)
    springs = x * x, np.full(n, 1.0 / n), x
    state = np.zeros(n), np.zeros((2, n)), np.zeros(n, dtype=bool), np.zeros(2, dtype=np.int64)
    changes = rng.normal(scale=0.2, size=steps)
    changes[0] = 0.5
    times = rng.uniform(0.0, 0.5, steps) * (rng.uniform(size=steps) > 0.2)
    return law(), springs, state, np.array([0.0, 1.0, 0.0]), changes, times, np.zeros((steps, 10))


def relaxing_to_force(rng):
    laws, springs, state, motion, changes, times, numbers = relaxing(rng)
    advance_springs.function(laws, springs, state, motion, changes[:1], times[:1], numbers[:1])
    return laws, springs, state, motion, np.array([0.05, 1.0, 0.0, 0.0]), 0.1, 0.0, 0.1


def dragged(rng):
    n = 12
    before, after = rng.uniform(0.0, 1.0, n), rng.uniform(0.0, 1.0, n)
    out = np.zeros(n), np.zeros(n, dtype=bool), np.zeros(6)
    return (law(), np.full(n, 0.1), before, after, np.ones(n), 0.1, float(rng.normal()), rng.normal(size=n),
            0.1 * rng.normal(size=(n, 2)), np.zeros(n, dtype=bool), *out)  # fmt: skip


def forced(rng):
    time = np.linspace(0.0, 2.0, 40)
    place = np.sin(np.linspace(0.0, np.pi, 40)) * rng.uniform(0.5, 1.0)
    turn = int(np.argmax(place)) + 1
    table = np.linspace(0.0, 1.0, 33) ** 3
    slopes = 3.0 * np.linspace(0.0, 1.0, 33) ** 2
    written = [np.zeros(40), np.zeros(40), np.zeros(40), np.zeros((40, 2)), np.zeros((40, 2)), np.zeros(40)]
    return (time, place, turn, float(rng.choice([0.0, 0.1])), SERIES.relaxed, 0.0, SERIES.moduli, SERIES.times, 1.0,
            table, slopes, *written)  # fmt: skip


def moved_by_force(rng):
    table = np.linspace(0.0, 1.0, 33) ** 3
    slopes = 3.0 * np.linspace(0.0, 1.0, 33) ** 2
    force = 0.1 * np.sort(rng.uniform(size=30))
    return (np.linspace(0.0, 2.0, 30), force, 1.0, 0.0, np.array([0.3, 0.2]), np.array([0.1, 1.0]), 1.0, table, slopes,
            np.zeros(30))  # fmt: skip


def passed_over(rng):
    place = np.linspace(0.0, 1.0, 30)
    u = place * (1.0 - place)
    slope = 1.0 - 2.0 * place
    nodes, weights = np.polynomial.legendre.leggauss(6)
    rule = 0.5 * (nodes + 1.0), 0.5 * weights
    lengths = rng.uniform(0.1, 2.0, 2)
    return (0.3, 0.01, np.array([0.5, 0.2]), lengths, place, u, slope[:-1].copy(), slope[1:].copy(), np.zeros(2),
            np.zeros(30), rule, np.zeros(3))  # fmt: skip


HISTORIES = {
    "corners_at": (corners_at, corners),
    "sum_corners": (sum_corners, sums_of_corners),
    "move_balls": (move_balls, balls),
    "turn_balls": (turn_balls, turns),
    "impact_balls": (impact_balls, impacts),
    "march_line": (march_line, line),
    "pull_line": (pull_line, pulled),
    "march_plane": (march_plane, plane),
    "strip": (strip, strips),
    "roll": (roll, rows),
    "push": (push, pushes),
    "advance_springs": (advance_springs, relaxing),
    "advance_to_force": (advance_to_force, relaxing_to_force),
    "drag": (drag, dragged),
    "forces_of_motion": (forces_of_motion, forced),
    "motion_of_forces": (motion_of_forces, moved_by_force),
    "pass_over": (pass_over, passed_over),
}


def history(name, seed):
    """Return the arguments of a kernel for a seed."""
    with np.errstate(all="ignore"):
        return HISTORIES[name][1](np.random.default_rng(seed))


def outcome(function, arguments):
    """Return what a function returns, and its arguments after it, as flat numbers."""
    own = copy.deepcopy(arguments)
    with np.errstate(all="ignore"):
        result = function(*own)
    flat = [] if result is None else [np.atleast_1d(np.asarray(result, dtype=float)).ravel()]

    def collect(part):
        if isinstance(part, tuple):
            for inner in part:
                collect(inner)
        elif isinstance(part, np.ndarray):
            flat.append(part.astype(float).ravel())

    collect(own)
    return flat
