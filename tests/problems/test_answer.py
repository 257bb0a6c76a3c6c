"""Protocols: solutions, marches and states are distinguished by their members, and states become columns."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.problems import answer
from winkler.values.value import value

BED = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
PRESSED = wk.Indentation(BED, wk.Force(np.array([10.0, 100.0])))
PATH = wk.Path.through(wk.Depth([1e-6, 1e-6]), wk.Shift([0.0, 0.1e-6]))
DRAGGED = wk.Tangential(BED, wk.Coulomb(0.3), PATH)


@value
class Marched:
    """A solution of a march."""

    problem: str
    depth: np.ndarray
    force: np.ndarray
    most: float
    states: tuple[object, ...]

    @property
    def validity(self) -> tuple[wk.Note, ...]:
        """Nothing."""
        return ()


class Step:
    def __init__(self, depth: float) -> None:
        self.depth, self.force = depth, 2.0 * depth


def test_states_become_columns_and_what_is_given_stays():
    steps = [Step(1.0), Step(3.0)]
    gathered = answer.gather(Marched, "a march", iter(steps), most=6.0)
    assert gathered.problem == "a march"
    assert gathered.depth.tolist() == [1.0, 3.0]
    assert gathered.force.tolist() == [2.0, 6.0]
    assert (gathered.most, gathered.states) == (6.0, tuple(steps))


def test_a_quantity_that_no_state_has_must_be_given():
    with pytest.raises(AttributeError, match="most"):
        answer.gather(Marched, "", [Step(1.0)])


def test_members_define_a_solution():
    many, dragged = PRESSED.solve(), DRAGGED.solve()
    assert answer.is_march(DRAGGED)
    assert not answer.is_march(PRESSED)
    assert answer.is_history(dragged)
    assert not answer.is_history(many)
    assert answer.many_loads(many)
    assert answer.is_restorable(many.at(0))
    assert not answer.is_dragged(many.at(0))
    assert answer.is_dragged(dragged.at(-1))
    assert answer.is_solution(many)
    assert not answer.is_solution(PRESSED)
    assert not answer.is_solution(type(many))


def test_springs_that_recover_are_known_one_by_one():
    soft = wk.Foundation(wk.Paraboloid(1.0), wk.ViscoelasticHalfSpace(wk.Maxwell(shear=0.25, relaxation_time=1.0)))
    state = next(wk.ViscoelasticIndentation(soft, wk.Path([0.0, 1.0], wk.Depth([0.01, 0.01])), count=4).steps())
    assert answer.is_recovering(state)
    assert not answer.is_recovering(PRESSED.solve().at(0))
