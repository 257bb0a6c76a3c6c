"""Yield of a history is that of its worst state, wherever on the path it is: against the stresses of every state."""

from __future__ import annotations

import re

import numpy as np
import pytest

import winkler as wk
from winkler.problems.normal.map_yield import greatest_share

STRENGTH = 1.5e9
STEEL = wk.Elastic(210e9, 0.3, strength=STRENGTH)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
BALL = wk.SampledProfile([0.6e-3, 0.6e-3], wk.Paraboloid(10e-3), (25, 25))
SHORT = wk.SampledProfile([0.6e-3, 0.3e-3], wk.CurvedBodies(10e-3, 3e-3), (25, 25))


def loaded_and_unloaded():
    """Pressed, sheared to 0.9 of the friction, sheared back, and unloaded."""
    force = wk.Force(np.array([40.0, 100.0, 100.0, 100.0, 60.0]))
    return wk.SurfaceTangential(
        BALL, PAIR, wk.Coulomb(0.5), wk.Path(np.arange(5.0), force, wk.ShearForce(np.array([0.0, 0.0, 45.0, 5.0, 5.0])))
    )


HISTORIES = {
    "tangential": (loaded_and_unloaded, 3),
    "steady": (
        lambda: wk.SurfaceRolling(
            SHORT, PAIR, wk.Force(100.0), wk.Coulomb(0.5), wk.Creepage(np.array([1e-4, 4e-3, -2e-4]))
        ),
        2,
    ),
    "start": (
        lambda: wk.SurfaceRollingStart(
            SHORT, PAIR, wk.Force(100.0), wk.Coulomb(0.5), wk.ShearForce(45.0), distance=0.1e-3
        ),
        None,
    ),
}


def noted(solution):
    (note,) = (note for note in solution.validity if note.assumption is wk.Assumption.ELASTIC)
    share, state = re.search(r"is ([\d.]+) .*strength.*in state (\d+) of", note.statement).groups()
    return note, float(share), int(state)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["tangential", "steady", pytest.param("start", marks=pytest.mark.slow)])
def test_the_worst_state_of_a_history_decides(name):
    make, worst = HISTORIES[name]
    problem = make()
    lengths = problem.topography.lengths
    shares = [
        greatest_share(PAIR, wk.SurfaceLoad.of_map(lengths, state.pressure, state.traction))
        for state in problem.steps()
        if np.any(state.pressure)
    ]
    solution = problem.solve()
    note, share, state = noted(solution)
    missed = 0.03 if worst is None else 0.0  # from pixel to pixel hardly anything changes but the edge of the slip
    assert share == pytest.approx(shares[state - 1], rel=5e-3)
    assert (1.0 - missed - 1e-9) * max(shares) <= shares[state - 1] <= max(shares)
    assert worst in (None, state)
    assert len(solution.heaviest) <= 4
    assert f"of {len(shares)}, the worst of those" in note.statement


@pytest.mark.slow
def test_yield_that_has_passed_is_stated():
    """The last state alone is elastic; the greatest shear before it was not."""
    problem = loaded_and_unloaded()
    states = list(problem.steps())
    weaker = (
        0.999
        * STRENGTH
        * max(
            greatest_share(PAIR, wk.SurfaceLoad.of_map(BALL.lengths, state.pressure, state.traction))
            for state in states
        )
    )
    body = wk.Elastic(210e9, 0.3, strength=weaker)
    stated = wk.SurfaceTangential(BALL, wk.HalfSpace.between(body, body), problem.law, problem.path)
    note, _, state = noted(stated.solve())
    assert note.standing is wk.Standing.OUTSIDE
    assert state == 3
    begun = stated.gathered(states[:2])
    note, _, state = noted(begun)
    assert note.standing is wk.Standing.ASYMPTOTIC
    assert state == 2
