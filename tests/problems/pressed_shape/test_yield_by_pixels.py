"""What is stated of yield of shapes pressed by pixels: closed forms, the round engine, rollers against ellipses."""

from __future__ import annotations

import re

import pytest

import winkler as wk
from winkler.problems.normal.elliptic import pressed_yield_notes
from winkler.problems.normal.greatest_stress import greatest_stress
from winkler.problems.normal.strong_parts import strong_parts

STRENGTH, FORCE = 0.05, wk.Force(2e-3)
BASE = wk.Elastic(1.0, 0.3, strength=STRENGTH)
BALL = wk.Paraboloid(1.0)


def coated(young, thickness=0.05):
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, 0.3, strength=STRENGTH), thickness)], on=BASE)


def share(notes):
    """The greatest stress over the strength that is stated, of three digits, and of which part."""
    (note,) = [each for each in notes if each.assumption is wk.Assumption.ELASTIC]
    number, part = re.search(r"([0-9.]+) (?:of|times) the strength of the ([a-z0-9 ]+),", note.statement).groups()
    assert (note.standing is wk.Standing.OUTSIDE) == (float(number) >= 1.0)
    return float(number), part


def of_the_round_engine(medium, friction=0.0):
    pressed = wk.Indentation(wk.Foundation(BALL, medium), FORCE).solve().pressed
    found = [
        (greatest_stress(pressed, part, friction, fine=True).value / STRENGTH, part.name)
        for part in strong_parts(medium)
    ]
    return max(found)


@pytest.mark.parametrize("ratio", [3.0, 20.0])
def test_an_ellipse_on_equal_layers_has_the_stress_of_the_closed_form(ratio):
    bodies = wk.CurvedBodies(1.0, ratio)
    known = wk.EllipticIndentation(bodies, wk.HalfSpace(BASE), FORCE).solve().greatest_stress().value / STRENGTH
    found, _ = share(wk.EllipticIndentation(bodies, coated(1.0), FORCE).solve().validity)
    assert found == pytest.approx(known, rel=5e-3)


@pytest.mark.few(1)
@pytest.mark.parametrize("young", [0.1, 10.0])
@pytest.mark.parametrize("friction", [0.0, 0.2])
def test_an_ellipse_that_is_a_ball_has_the_stress_of_the_round_engine(young, friction):
    medium = coated(young)
    solution = wk.EllipticIndentation(wk.CurvedBodies(1.0, 1.0), medium, FORCE).solve()
    notes = pressed_yield_notes(solution, (friction, 0.0)) if friction else solution.validity
    found, part = share(notes)
    known, named = of_the_round_engine(medium, friction)
    assert (found, part) == (pytest.approx(known, rel=1e-2), named)


@pytest.mark.few(1)
@pytest.mark.parametrize("medium", [wk.HalfSpace(BASE), coated(0.1), coated(10.0)])
def test_a_nearly_round_body_that_is_round_has_the_stress_of_the_round_engine(medium):
    found, part = share(wk.NearlyRoundIndentation((BALL,) * 6, medium, FORCE).solve().validity)
    known, named = of_the_round_engine(medium)
    assert (found, part) == (pytest.approx(known, rel=5e-3), named)


def test_below_a_sharp_tip_the_onset_is_not_known():
    contact = wk.NearlyRoundIndentation((wk.Cone(0.2),) * 6, coated(0.1), FORCE).solve()
    (note,) = [each for each in contact.validity if each.assumption is wk.Assumption.ELASTIC]
    assert "infinite at a sharp tip" in note.statement


def test_a_crowned_roller_on_a_half_space_has_the_stress_of_the_ellipse():
    bodies, medium = wk.CurvedBodies(3.0, 1.0), wk.HalfSpace(BASE)
    found, _ = share(wk.RollerContact(1.0, 1.5, wk.CrownedEnds(3.0), medium, FORCE, elements=64).solve().validity)
    known = wk.EllipticIndentation(bodies, medium, FORCE).solve().greatest_stress().value / STRENGTH
    assert found == pytest.approx(known, rel=1e-2)


@pytest.mark.parametrize("young", [0.1, pytest.param(10.0, marks=pytest.mark.slow)])
def test_a_crowned_roller_is_an_ellipse(young):
    """Slender elements of graded lengths against square pixels; the contact ends before the roller does."""
    medium, bodies = coated(young), wk.CurvedBodies(3.0, 1.0)
    roller = wk.RollerContact(1.0, 1.5, wk.CrownedEnds(3.0), medium, FORCE, elements=128).solve()
    found, part = share(roller.validity)
    known, named = share(wk.EllipticIndentation(bodies, medium, FORCE).solve().validity)
    assert (found, part) == (pytest.approx(known, rel=1e-2), named)


def test_a_roller_with_sharp_ends_or_of_an_earlier_load_says_why_it_is_not_known():
    medium = coated(0.1)
    sharp = wk.RollerContact(1.0, 1.0, wk.SharpEnds(), medium, FORCE, elements=32).solve()
    falling = wk.RollerContact(1.0, 1.5, wk.CrownedEnds(3.0), medium, wk.Force([2e-3, 1e-3]), elements=32).solve()
    for contact, why in ((sharp, "infinite at sharp ends"), (falling, "which is not the greatest")):
        (note,) = [each for each in contact.validity if each.assumption is wk.Assumption.ELASTIC]
        assert why in note.statement
