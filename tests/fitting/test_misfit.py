"""A model that does not explain the contact is detected, however long the curve was out of contact."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from relaxing_curves import BEAD, FIRST, model, power_law_force, start
from scipy.optimize import least_squares
from synthetic import hertz, noise

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.materials.fractional import PowerLawSolid

YOUNG = "bed.medium.first.young"
FREE = [YOUNG, "contact_point", "baseline"]
LEVEL = 2e-11
POSITION = np.linspace(-9e-6, 1e-6, 4000)
"""Nine tenths of the travel are free."""


def bead():
    return wk.Indentation(wk.Foundation(wk.Paraboloid(BEAD), wk.HalfSpace.between(wk.Elastic(1e5, 0.5))), wk.Depth(0.0))


def pressed_cone(position, modulus=1e4, slope=0.05):
    """Sneddon's cone, F = 2 E* d^2 / (pi tan(beta))."""
    return 2.0 / np.pi * modulus / slope * np.maximum(position, 0.0) ** 2


def curve(force, seed, memory=0.0):
    return ForceCurve(POSITION, force + LEVEL * noise(np.random.default_rng(seed), POSITION.size, memory))


def scale_of_misfit(goal):
    """The modulus of a cone whose best ball leaves `goal` times the noise in contact, noise included."""
    force = pressed_cone(POSITION)

    def left(numbers):
        return (force - hertz(POSITION - 1e-7 * numbers[1], 1e4 * numbers[0], BEAD)) / force.max()

    best = least_squares(left, [1.0, 0.0], xtol=1e-12, ftol=1e-12)
    inside = 1e-7 * best.x[1] < POSITION
    ratio = np.sqrt(np.mean(left(best.x)[inside] ** 2)) * force.max() / LEVEL
    return 1e4 * np.sqrt(goal**2 - 1.0) / ratio


def misfits(found):
    return [flag.statement for flag in found.flags if flag.name == "misfit"]


def test_a_ball_does_not_explain_a_cone():
    """Residuals of 3.1 times the noise where the tip touches; over the whole curve chi-square is below 2."""
    found = fit(curve(pressed_cone(POSITION, scale_of_misfit(3.1)), 1), bead(), free=FREE)
    assert found.chi_square < 2.0
    assert np.sqrt(found.chi_square_in_contact) == pytest.approx(3.1, rel=0.1)
    assert misfits(found) == [
        f"The residuals are {np.sqrt(found.chi_square):.3g} times the noise, in contact "
        f"{np.sqrt(found.chi_square_in_contact):.3g} times: the model does not explain the curve."
    ]


@pytest.mark.few(2)
@pytest.mark.parametrize("memory", [0.0, 0.9])
@pytest.mark.parametrize("seed", range(4))
def test_a_right_model_is_let_through(seed, memory):
    """A chance of one in a thousand each, also where the noise remembers, or few points are in contact."""
    for count in (4000, 120):
        index = np.linspace(0, 3999, count).astype(int)
        found = fit(curve(hertz(POSITION, 1e4, BEAD), seed, memory).chosen(index), bead(), free=FREE)
        assert not misfits(found)
        assert found.chi_square_in_contact < 4.0


def test_a_contact_that_is_few_points_has_its_own_freedom():
    found = fit(curve(hertz(POSITION, 1e4, BEAD), 3), bead(), free=FREE)
    inside = found.touched
    assert found.contact_count == np.count_nonzero(inside)
    assert 380 < found.contact_count < 420
    chi = (
        np.sum(found.residuals[inside] ** 2) / (found.contact_count - 2) / found.noise**2
    )  # the line follows from the free points
    assert found.chi_square_in_contact == pytest.approx(chi, rel=1e-12)


def relaxing(seed, level):
    """In and held for two seconds after eighteen of free travel, on a power-law body of exponent 0.2."""
    time = np.linspace(-18.0, 2.0, 2400)
    travel, direction = 1e-6 * np.minimum(time, 1.0), np.where(time <= 1.0, 1.0, 0.0)
    force = power_law_force(time, 1.0, 1e-6, 500.0, 0.2, held=True)
    force = np.where(time > 0.0, force, 0.0) + level * np.random.default_rng(seed).standard_normal(time.size)
    return ForceCurve(travel + 4e-7, force, time=time + 18.0, direction=direction)


def test_a_relaxing_model_that_is_wrong():
    """The exponent is taken for 0.3 and fixed: visible in contact, and not in nine tenths of free travel."""
    wrong = model(PowerLawSolid(2e3, 1.0, 0.3, shortest=1e-3, longest=40.0))
    free = [f"{FIRST}shear", "contact_point", "baseline"]
    found = fit(relaxing(1, 2e-10), wrong, free=free)
    assert found.chi_square < 2.0 < 4.0 < found.chi_square_in_contact
    assert len(misfits(found)) == 1
    assert "in contact" in misfits(found)[0]
    right = start("relaxation")
    good = fit(relaxing(1, 2e-10), right, free=[*free, f"{FIRST}exponent"])
    assert not misfits(good)
    assert good.chi_square_in_contact == pytest.approx(1.0, abs=0.4)


def test_an_interval_of_a_number_that_is_nearly_nothing():
    """The error is thousands of times the number: an end that no float can hold is infinite, not an OverflowError."""
    found = fit(curve(hertz(POSITION, 1e4, BEAD), 5), bead(), free=FREE)
    lost = dataclasses.replace(found, standard_errors=1e4 * found.values)
    assert lost.interval(YOUNG) == (0.0, np.inf)
    assert np.isfinite(lost.interval("baseline")).all()
