"""Fits: exact curves give their numbers back, wrong questions are refused by name, errors are what they should be."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from synthetic import hertz, hertz_on_spring, jkr, noise, there_and_back

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.fitting.noise.estimate import noise_of
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Note

R, YOUNG, POISSON, WORK = 5e-6, 1e4, 0.5, 1e-4
MODULUS = YOUNG / (1.0 - POISSON**2)
SPRING = 0.05
ORIGIN, BASE, TILT = 2e-6, 1e-10, 3e-5
PATH = "bed.medium.first.young"


def bed(young: float = 3e6, radius: float = R) -> wk.Foundation:
    return wk.Foundation(wk.Paraboloid(radius), wk.HalfSpace.between(wk.Elastic(young, POISSON)))


def elastic(young: float = 3e6, radius: float = R) -> wk.Indentation:
    return wk.Indentation(bed(young, radius), wk.Depth(0.0))


def sticky(law, young: float = 3e6, radius: float = R) -> AdhesiveIndentation:
    return AdhesiveIndentation(bed(young, radius), law, wk.Depth(0.0))


def measured(force, position, seed: int = 0, level: float = 2e-11, stiffness: float = SPRING) -> ForceCurve:
    line = BASE + TILT * position
    disturbed = force + line + level * noise(np.random.default_rng(seed), position.size)
    return ForceCurve(position + ORIGIN, disturbed, stiffness, name="synthetic")


def within(found, expected: dict[str, float], errors: float = 4.0) -> None:
    for name, number in expected.items():
        assert abs(found.value(name) - number) < errors * found.error(name), name


def test_hertz_on_a_cantilever():
    """Modulus, contact point, baseline and tilt, from a modulus that is 300 times too large."""
    position, _ = there_and_back(-1e-6, 1e-6, 300)
    curve = measured(hertz_on_spring(position, MODULUS, R, SPRING), position)
    found = fit(curve, elastic(), free=[PATH, "contact_point", "baseline", "tilt"])
    within(found, {PATH: YOUNG, "contact_point": ORIGIN, "baseline": BASE, "tilt": TILT})
    assert found.error(PATH) < 1e-2 * YOUNG
    assert found.scatter == pytest.approx(2e-11, rel=0.1)
    assert found.noise == pytest.approx(2e-11, rel=0.15)
    assert found.chi_square == pytest.approx(1.0, abs=0.2)
    assert found.flags == ()
    assert found.model.bed.medium.first.young == found.value(PATH)
    assert found.model.load.depth == pytest.approx(found.depth.max(), rel=1e-9)
    np.testing.assert_allclose(found.residuals, curve.force - found.predicted, rtol=1e-15)
    assert all(isinstance(note, Note) for note in found.validity)


def test_without_noise_the_numbers_come_back():
    position, _ = there_and_back(-1e-6, 1e-6, 100)
    curve = ForceCurve(position + ORIGIN, hertz_on_spring(position, MODULUS, R, SPRING), SPRING)
    found = fit(curve, elastic(), free=[PATH, "contact_point"])
    assert found.value(PATH) == pytest.approx(YOUNG, rel=1e-7)
    assert found.value("contact_point") == pytest.approx(ORIGIN, rel=1e-8)


@pytest.mark.few(1)
@pytest.mark.parametrize("stiffness", [SPRING, np.inf])
def test_jkr_there_and_back(stiffness):
    position, inward = there_and_back(-1e-6, 1e-6, 300)
    force = jkr(position, inward, MODULUS, R, WORK, min(stiffness, 1e12))
    curve = measured(force, position, stiffness=stiffness)
    found = fit(curve, sticky(ShortRange(0.03)), free=[PATH, "law.work", "contact_point", "baseline", "tilt"])
    within(found, {PATH: YOUNG, "law.work": WORK, "contact_point": ORIGIN, "baseline": BASE, "tilt": TILT})
    assert found.error("law.work") < 0.02 * WORK
    assert np.count_nonzero(found.contact != (force != 0.0)) <= 1
    assert found.model.law == ShortRange(found.value("law.work"))


def test_jkr_on_retraction_alone():
    position, inward = there_and_back(-1e-6, 1e-6, 300)
    curve = measured(jkr(position, inward, MODULUS, R, WORK, SPRING), position).retract
    found = fit(curve, sticky(ShortRange(0.03)), free=[PATH, "law.work", "contact_point", "baseline", "tilt"])
    within(found, {PATH: YOUNG, "law.work": WORK, "contact_point": ORIGIN})


@pytest.mark.slow
def test_an_early_pull_off_is_read_from_the_curve():
    """Vibration parts the contact before its limit: the numbers do not suffer."""
    position, inward = there_and_back(-1e-6, 1e-6, 300)
    force = jkr(position, inward, MODULUS, R, WORK, SPRING)
    force[~inward & (position < -5e-8)] = 0.0
    found = fit(
        measured(force, position),
        sticky(ShortRange(0.03)),
        free=[PATH, "law.work", "contact_point", "tilt", "baseline"],
    )
    within(found, {PATH: YOUNG, "law.work": WORK, "contact_point": ORIGIN})


def test_the_radius_of_the_tip():
    """With a modulus that is known, the tip's radius comes out."""
    position, _ = there_and_back(-1e-6, 1e-6, 300)
    curve = measured(hertz_on_spring(position, MODULUS, R, SPRING), position)
    model = elastic(YOUNG, 1e-6)
    found = fit(curve, model, free=["bed.profile.curvature_radius", "contact_point", "baseline", "tilt"])
    within(found, {"bed.profile.curvature_radius": R, "contact_point": ORIGIN})


def test_dmt():
    """F = Hertz - 2 pi R w while in contact, and nothing out of it."""
    position, _ = there_and_back(-1e-6, 1e-6, 300)
    force = hertz(position, MODULUS, R) - 2.0 * np.pi * R * WORK * (position >= 0.0)
    curve = measured(force, position, stiffness=np.inf)
    found = fit(
        curve, sticky(DerjaguinMullerToporov(0.01)), free=[PATH, "law.work", "contact_point", "baseline", "tilt"]
    )
    within(found, {PATH: YOUNG, "law.work": WORK, "contact_point": ORIGIN})


@pytest.mark.slow
def test_maugis_converges_from_a_hopeless_start():
    """Dugdale's law with a great strength is JKR; the fit finds JKR's numbers from a hopeless start."""
    position, inward = there_and_back(-1e-6, 1e-6, 150)
    curve = measured(jkr(position, inward, MODULUS, R, WORK, SPRING), position)
    found = fit(curve, sticky(Dugdale(1e-3, 1e5)), free=[PATH, "law.work", "contact_point", "baseline", "tilt"])
    assert found.value("law.work") == pytest.approx(WORK, rel=0.03)
    assert found.value(PATH) == pytest.approx(YOUNG, rel=0.02)


@pytest.mark.slow
def test_the_modulus_of_a_coating():
    """A soft film on glass, its modulus unknown: exact curve of the coated problem, checked elsewhere, and noise."""

    def coated(young: float) -> wk.Indentation:
        film = wk.Layer(wk.Elastic(young, 0.45), 2e-6)
        medium = wk.CoatedHalfSpace([film], on=wk.Elastic(70e9, 0.2))
        return wk.Indentation(wk.Foundation(wk.Paraboloid(R), medium), wk.Depth(0.0))

    position = np.linspace(-1e-6, 5e-7, 200)
    force = dataclasses.replace(coated(2e4), load=wk.Depth(position)).solve().force
    curve = ForceCurve(position + ORIGIN, force + 2e-11 * noise(np.random.default_rng(1), 200))
    name = "bed.medium.layers[0].solid.young"
    found = fit(curve, coated(5e5), free=[name, "contact_point", "baseline"])
    within(found, {name: 2e4, "contact_point": ORIGIN, "baseline": 0.0})


def test_a_linear_fit_is_the_textbooks():
    """A flat punch in contact: force = k (D - D0) is linear; least squares by hand, and one step from there."""
    position = np.linspace(1e-8, 1e-6, 120)
    punch = wk.Foundation(wk.FlatPunch(1e-6), wk.HalfSpace.between(wk.Elastic(YOUNG, POISSON)))
    stiffness = 2.0 * MODULUS * 1e-6
    force = stiffness * position + 1e-10 * noise(np.random.default_rng(8), 120)
    found = fit(ForceCurve(position, force), wk.Indentation(punch, wk.Depth(0.0)), free=["baseline", "tilt"])
    columns = np.stack([np.ones(120), position], axis=1)
    numbers, square, *_ = np.linalg.lstsq(columns, force - stiffness * position, rcond=None)
    errors = np.sqrt(square[0] / 118.0 * np.diag(np.linalg.inv(columns.T @ columns)))
    course = np.linspace(-1.0, 1.0, 120)
    course /= np.sqrt(np.mean(course**2))
    mean = noise_of(force - stiffness * position - columns @ numbers, columns, course[:, None])
    np.testing.assert_allclose((found.values - numbers - mean.step) / errors, 0.0, atol=0.03)
    np.testing.assert_allclose(found.standard_errors, np.sqrt(np.diag(mean.covariance)), rtol=0.02)
    assert np.all(
        np.abs(found.values - numbers) < errors
    )  # white noise, which 120 points cannot call white for certain
    assert np.all(found.standard_errors > errors)
    assert square[0] < found.misfit < 1.1 * square[0]


def test_weights():
    """Points known ten times better count a hundred times more."""
    position = np.linspace(1e-8, 1e-6, 100)
    punch = wk.Foundation(wk.FlatPunch(1e-6), wk.HalfSpace.between(wk.Elastic(YOUNG, POISSON)))
    level = np.where(np.arange(100) < 50, 1e-11, 1e-10)
    force = 2.0 * MODULUS * 1e-6 * position + level * noise(np.random.default_rng(9), 100)
    model = wk.Indentation(punch, wk.Depth(0.0))
    found = fit(ForceCurve(position, force), model, free=["baseline"], noise=level)
    left = force - 2.0 * MODULUS * 1e-6 * position
    assert found.value("baseline") == pytest.approx(np.sum(left / level**2) / np.sum(1.0 / level**2), rel=1e-5)


def test_bounds_hold_and_are_flagged():
    position, _ = there_and_back(-1e-6, 1e-6, 200)
    curve = measured(hertz_on_spring(position, MODULUS, R, SPRING), position)
    found = fit(curve, elastic(1.5e4), free={PATH: (1.2e4, 2e4), "contact_point": (), "baseline": ()})
    assert found.value(PATH) == pytest.approx(1.2e4, rel=1e-6)
    assert "at_bound" in [flag.name for flag in found.flags]
    assert "misfit" in [flag.name for flag in found.flags]


def test_two_moduli_of_one_pair_cannot_be_distinguished():
    position, _ = there_and_back(-1e-6, 1e-6, 200)
    curve = measured(hertz_on_spring(position, MODULUS, R, SPRING), position)
    pair = wk.HalfSpace.between(wk.Elastic(2e4, POISSON), wk.Elastic(2e4, POISSON))
    model = wk.Indentation(wk.Foundation(wk.Paraboloid(R), pair), wk.Depth(0.0))
    message = "not identifiable: the curve does not distinguish bed.medium.first.young from bed.medium.second.young"
    with pytest.raises(OutsideValidity, match=message):
        fit(curve, model, free=[PATH, "bed.medium.second.young", "contact_point", "baseline"])


@pytest.mark.slow
def test_a_number_that_does_nothing_is_named():
    position, _ = there_and_back(-1e-6, 1e-6, 200)
    curve = measured(hertz_on_spring(position, MODULUS, R, SPRING), position)
    strong = wk.Indentation(
        wk.Foundation(wk.Paraboloid(R), wk.HalfSpace.between(wk.Elastic(YOUNG, POISSON, strength=1e9))), wk.Depth(0.0)
    )
    with pytest.raises(OutsideValidity, match="the curve does not depend on bed.medium.first.strength"):
        fit(curve, strong, free=[PATH, "bed.medium.first.strength", "contact_point"])


def test_a_tip_that_is_known_too_little_of():
    position = np.linspace(-1e-6, 1e-6, 200)
    curve = measured(hertz(position, MODULUS, R), position, stiffness=np.inf)
    radii = np.linspace(0.0, 1e-6, 200)
    model = wk.Indentation(
        wk.Foundation(wk.Measured(radii, radii**2 / (2.0 * R)), wk.HalfSpace.between(wk.Elastic(YOUNG, POISSON))),
        wk.Depth(0.0),
    )
    with pytest.raises(OutsideValidity, match="beyond 1e-06 m, where the profile is not defined"):
        fit(curve, model, free={PATH: YOUNG, "contact_point": ORIGIN})


def test_held_points_are_left_out():
    position, _ = there_and_back(-1e-6, 1e-6, 200)
    curve = measured(hertz_on_spring(position, MODULUS, R, SPRING), position)
    direction = curve.direction.copy()
    direction[195:205] = 0.0
    found = fit(dataclasses.replace(curve, direction=direction), elastic(), free=[PATH, "contact_point"])
    assert found.curve.count == 390


@pytest.mark.parametrize(
    ("free", "error", "message"),
    [
        ([], InvalidInput, "nothing is free"),
        (["young"], InvalidInput, "'young' is neither a path"),
        (["contact_pont"], InvalidInput, r"did you mean 'contact_point'\?"),
        (["bed.medium.first.yung"], InvalidInput, r"did you mean 'young'\?"),
        ({PATH: (2.0, 1.0)}, InvalidInput, "correct it"),
        ({PATH: "large"}, InvalidInput, r"give \(low, high\), a start value"),
    ],
)
def test_wrong_questions_are_refused(free, error, message):
    position, _ = there_and_back(-1e-6, 1e-6, 100)
    curve = measured(hertz_on_spring(position, MODULUS, R, SPRING), position)
    with pytest.raises(error, match=message):
        fit(curve, elastic(), free=free)


@pytest.mark.parametrize("level", [-1.0, np.nan, np.ones(3)])
def test_wrong_noise_is_refused(level):
    position, _ = there_and_back(-1e-6, 1e-6, 100)
    curve = measured(hertz_on_spring(position, MODULUS, R, SPRING), position)
    with pytest.raises(InvalidInput, match="noise"):
        fit(curve, elastic(), free=[PATH], noise=level)


def test_a_curve_that_is_wrong_is_refused_by_name():
    position, _ = there_and_back(-1e-6, 1e-6, 100)
    curve = measured(-hertz_on_spring(position, MODULUS, R, SPRING), position)
    with pytest.raises(InvalidInput, match="curve 'synthetic': reversed"):
        fit(curve, elastic(), free=[PATH, "contact_point"])


def test_a_curve_whose_position_stands_still_is_refused():
    held = ForceCurve(np.zeros(100), np.linspace(0.0, 1e-9, 100), name="held")
    with pytest.raises(InvalidInput, match=r"^curve 'held': 0 of 100 points lie on a loading or an unloading"):
        fit(held, wk.Indentation(bed(), wk.Depth(0.0)), free=[PATH])


def test_another_problem_is_refused():
    position, _ = there_and_back(-1e-6, 1e-6, 100)
    curve = measured(hertz_on_spring(position, MODULUS, R, SPRING), position)
    strong = wk.Foundation(wk.Paraboloid(R), wk.HalfSpace.between(wk.Elastic(YOUNG, POISSON, strength=1e3)))
    with pytest.raises(InvalidInput, match="the model is a YieldOnset"):
        fit(curve, wk.YieldOnset(strong), free=[PATH, "contact_point"])


def test_an_unknown_name_of_an_answer():
    position, _ = there_and_back(-1e-6, 1e-6, 100)
    curve = measured(hertz_on_spring(position, MODULUS, R, SPRING), position)
    found = fit(curve, elastic(), free=[PATH, "contact_point"])
    with pytest.raises(InvalidInput, match="'tilt' was not free"):
        found.value("tilt")
    with pytest.raises(InvalidInput, match=r"confidence is 95; .* between 0 and 1"):
        found.interval(PATH, 95)
