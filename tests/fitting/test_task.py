"""Derivatives that least squares are given, against closed forms; where a contact may hold, and where no more."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq
from synthetic import hertz_on_spring, jkr_states

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.elastic.contact import attached, held_contact, runs_of
from winkler.fitting.elastic.task import elastic_task
from winkler.laws.adhesion import ShortRange
from winkler.problems.adhesion.indentation import AdhesiveIndentation

R, YOUNG, WORK, SPRING = 5e-6, 1e4, 1e-4, 0.05
MODULUS = YOUNG / 0.75
PATH = "bed.medium.first.young"
BED = wk.Foundation(wk.Paraboloid(R), wk.HalfSpace.between(wk.Elastic(YOUNG, 0.5)))


def derivatives(curve: ForceCurve, model, free: list[str]):
    question = elastic_task(curve, model, dict.fromkeys(free, ()), np.ones(()))
    best = np.array([p.inward(p.start) for p in question.parameters])
    prediction = question.prediction(best)
    return question, prediction, question.jacobian(best, prediction)


def test_hertz_on_a_spring():
    """From D = d + F/k_m: dF/dln E = F / (1 + F'(d)/k_m), F' = 3F / (2d)."""
    position = np.linspace(-2e-7, 1e-6, 200)
    force = hertz_on_spring(position, MODULUS, R, SPRING)
    _, _, columns = derivatives(ForceCurve(position, force, SPRING), wk.Indentation(BED, wk.Depth(0.0)), [PATH])
    touches = position > 0.0
    depth = position[touches] - force[touches] / SPRING
    exact = force[touches] / (1.0 + 1.5 * force[touches] / depth / SPRING)
    np.testing.assert_allclose(columns[touches, 0], exact, rtol=2e-5)
    assert not columns[~touches].any()


@pytest.mark.parametrize("stiffness", [SPRING, 1e9])
def test_jkr_on_a_spring(stiffness):
    """At the same D: dF = F_theta - (F_a / D_a) D_theta, all of them by hand."""
    place, force = jkr_states(MODULUS, R, WORK, stiffness, 3e-6)
    inside = (place > place[0] + 2e-9) & (place < 1e-6)
    position, force = place[inside][::-500], force[inside][::-500]
    curve = ForceCurve(position, force, stiffness)
    model = AdhesiveIndentation(BED, ShortRange(WORK), wk.Depth(0.0))
    _, prediction, columns = derivatives(curve, model, [PATH, "law.work"])
    assert prediction.touched.all()
    for index in range(0, position.size, 5):

        def missed(a, target=position[index]):
            d = a**2 / R - np.sqrt(2.0 * np.pi * a * WORK / MODULUS)
            f = 4.0 * MODULUS * a**3 / (3.0 * R) - np.sqrt(8.0 * np.pi * a**3 * WORK * MODULUS)
            return d + f / stiffness - target

        a = brentq(missed, 0.9 * prediction.contact.radius[index], 1.1 * prediction.contact.radius[index], xtol=1e-22)
        stretch, pull = np.sqrt(2.0 * np.pi * a * WORK / MODULUS), np.sqrt(8.0 * np.pi * a**3 * WORK * MODULUS)
        press = 4.0 * MODULUS * a**3 / (3.0 * R)
        along = 2.0 * a / R - 0.5 * stretch / a, (3.0 * press - 1.5 * pull) / a
        for column, (depth_by, force_by) in enumerate(
            ((0.5 * stretch, press - 0.5 * pull), (-0.5 * stretch, -0.5 * pull))
        ):
            slope = along[1] / (along[0] + along[1] / stiffness)
            exact = force_by - slope * (depth_by + force_by / stiffness)
            assert columns[index, column] == pytest.approx(exact, rel=1e-3, abs=1e-5 * np.abs(columns[:, column]).max())


@pytest.mark.slow
def test_a_coating_against_whole_predictions():
    """On a coated body no closed form exists: the difference of two whole predictions, by central differences."""
    film = wk.Layer(wk.Elastic(2e4, 0.45), 2e-6)
    medium = wk.CoatedHalfSpace([film], on=wk.Elastic(1e6, 0.2))
    model = wk.Indentation(wk.Foundation(wk.Paraboloid(R), medium), wk.Depth(0.0))
    position = np.linspace(1e-8, 2e-7, 30)
    name = "bed.medium.layers[0].solid.young"
    question, _, columns = derivatives(ForceCurve(position, position), model, [name])
    by = 1e-3
    apart = [question.held({name: 2e4 * np.exp(step)}).force for step in (by, -by)]
    np.testing.assert_allclose(columns[:, 0], (apart[0] - apart[1]) / (2.0 * by), rtol=1e-4)


def test_tension_beyond_the_limit_is_no_contact():
    """An attraction of almost nothing must not lend its steep end to whatever pull the curve shows."""
    position = np.linspace(-2e-7, 1e-6, 400)[::-1]
    curve = ForceCurve(position, position)
    model = AdhesiveIndentation(BED, ShortRange(1e-14), wk.Depth(0.0))
    held = held_contact(model, 1.0 / SPRING, position, runs_of(curve), 0.0)
    below = position < -1e-9
    assert held.force[below].max() < -1e-12  # the branch goes on, steeply
    holds = attached(held, held.force, runs_of(curve), np.ones(400))
    assert holds[position > 1e-9].all()
    assert not holds[below].any()
