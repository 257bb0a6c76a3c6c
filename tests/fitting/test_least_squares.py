"""Full steps of Gauss and Newton end where an independent trust region ends, from any start; else that goes on."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import curve_fit

import winkler as wk
from winkler.fitting import least_squares
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.elastic.task import elastic_task
from winkler.fitting.search import Search

RADIUS, YOUNG, BASE, POINT, SPRING = 5e-6, 1e4, 1e-10, 3e-6, 0.05
NAMES = ("bed.medium.first.young", "contact_point", "baseline")
NOISE = 3e-11


def hertz(depth, young):
    return 4.0 / 3.0 * young / 0.75 * np.sqrt(RADIUS) * np.maximum(depth, 0.0) ** 1.5


def task_of(spring, count=400):
    depth = np.linspace(-1e-6, 1e-6, count)
    force = hertz(depth, YOUNG)
    position = depth + force / spring + POINT
    noisy = force + BASE + NOISE * np.random.default_rng(5).standard_normal(count)
    bed = wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace.between(wk.Elastic(2e4, 0.5)))
    curve = ForceCurve(position, noisy, spring)
    return elastic_task(curve, wk.Indentation(bed, wk.Depth(0.0)), dict.fromkeys(NAMES, ()), np.zeros(()))


def placed(task, numbers):
    return np.array([p.inward(number) for p, number in zip(task.parameters, numbers, strict=True)])


START = (9e3, POINT + 3e-8, 0.0)
FAR = (3e6, POINT - 1.5e-6, 1e-9)


@pytest.mark.parametrize("start", [START, FAR], ids=["near", "far"])
def test_the_optimum_is_that_of_the_closed_form(start):
    """Hertz' force, fitted by scipy with its own derivatives; errors by its covariance."""
    task = task_of(np.inf)

    def model(position, young, point, base):
        return hertz(position - 1e-6 * point, 1e4 * young) + 1e-10 * base

    scaled, covariance = curve_fit(
        model, task.curve.position, task.curve.force, p0=(1.0, 3.0, 1.0), sigma=np.full(task.curve.count, NOISE),
        ftol=1e-14, xtol=1e-14,
    )  # fmt: skip
    numbers, squares = least_squares.solved(task, placed(task, start), Search())
    found = np.array(list(task.numbers(numbers).values())) / (1e4, 1e-6, 1e-10)
    assert np.abs(found - scaled) == pytest.approx(0.0, abs=1e-3 * np.sqrt(np.diag(covariance)).min())
    left = task.curve.force - model(task.curve.position, *scaled)
    assert squares == pytest.approx(float(left @ left), rel=1e-9)


@pytest.mark.parametrize("spring", [np.inf, SPRING])
def test_full_steps_and_the_trust_region_alone_agree(spring, monkeypatch):
    task = task_of(spring)
    stepped, squares = least_squares.solved(task, placed(task, START), Search())
    monkeypatch.setattr(least_squares, "MOST_FULL_STEPS", 0)
    alone, others = least_squares.solved(task, placed(task, START), Search())
    jacobian = task.jacobian(alone, task.prediction(alone))
    errors = NOISE * np.sqrt(np.diag(np.linalg.inv(jacobian.T @ jacobian)))
    assert np.all(np.abs(stepped - alone) < 1e-3 * errors)
    assert squares == pytest.approx(others, rel=1e-9)


def test_a_fit_of_numbers_that_go_together_is_left_to_the_trust_region():
    """Two columns in one direction have no full step: the start comes back, unsettled."""

    def misfit(at):
        return np.array([at[0] + at[1] - 1.0, 0.5])

    start, far = np.zeros(2), np.full(2, np.inf)
    columns = np.array([[1.0, 1.0], [0.0, 0.0]])
    found, squares = least_squares._stepped(misfit, lambda at: columns, start, -far, far, 1e-10)
    assert squares is None
    assert np.array_equal(found, start)
