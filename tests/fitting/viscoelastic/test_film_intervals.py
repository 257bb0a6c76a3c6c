"""Intervals of fits of films that relax: how often they hold the truth, under white noise and under assumed noise."""

from __future__ import annotations

import dataclasses
import functools
from pathlib import Path

import numpy as np
import pytest
from scipy.fft import idct
from scipy.stats import binom

import winkler as wk
from winkler.fitting.noise.estimate import ABSENT, FAINT, FAINT_WEIGHT, NONE_WEIGHT, PRESENT, noise_of
from winkler.fitting.noise.spectra import candidates
from winkler.fitting.viscoelastic.drive import driven_task, examined_stroke
from winkler.study.batch.fit_run import fit_study
from winkler.study.language.fit_reading import parse_fit_study

BALL, THICK = 10e-6, 5e-6
FILM = "bed.medium.layers[0].solid."
FREE = (f"{FILM}relaxed_shear", f"{FILM}shear", f"{FILM}relaxation_time", "contact_point", "baseline")
TRUE = (1e3, 4e3, 0.8, 4e-7, 3e-11)
COUNT = 181
LOW, HIGH = 0.92, 0.98


def film(*numbers):
    stack = wk.ViscoelasticCoatedHalfSpace(
        [wk.ViscoelasticLayer(wk.StandardSolid(*numbers, poisson=0.5), THICK)], on=wk.Elastic(3e4, 0.49)
    )
    return wk.Foundation(wk.Paraboloid(BALL), stack)


def start(*numbers):
    return wk.ViscoelasticIndentation(film(*numbers), wk.Path([0.0], wk.Depth(0.0)))


@functools.cache
def pressed_and_held():
    """Time, position and forces of the march of the problem: its own waves, steps by their error, 250 cells."""
    time = np.linspace(-1.0, 5.0, COUNT)
    depth = 1e-6 * np.minimum(time, 1.0)
    path = wk.Path(time + 1.0, wk.Depth(depth))
    force = wk.ViscoelasticIndentation(film(*TRUE[:3]), path, count=250, tolerance=1e-5).solve().force
    return time + 1.0, depth + 4e-7, force + 3e-11


def curve(noise, **more):
    time, position, force = pressed_and_held()
    direction = np.where(time <= 2.0, 1.0, 0.0)
    return wk.ForceCurve(position, force + 0.01 * force.max() * noise, time=time, direction=direction, **more)


@functools.cache
def at_the_truth():
    """Derivatives of the forces by the five numbers, and the courses of disturbances, of the fit of the film."""
    measured = curve(np.random.default_rng(0).standard_normal(COUNT))
    outline, _ = examined_stroke(measured)
    task = driven_task(measured, start(*TRUE[:3]), dict.fromkeys(FREE, ()), np.zeros(()), outline)
    place = np.array([p.inward(number) for p, number in zip(task.parameters, TRUE, strict=True)])
    jacobian = task.instrument(place, task.prediction(place))
    return jacobian, task.courses(jacobian)


def held(draw, count, *, white):
    """In how many of so many linear fits the 95 % interval of each number holds zero, the truth."""
    jacobian, courses = at_the_truth()
    random, inside = np.random.default_rng(31), np.zeros(len(FREE), dtype=int)
    for _ in range(count):
        found = noise_of(draw(random, courses), jacobian, courses, white=white)
        half = found.mixture.reaches[:, 2] * np.sqrt(np.diag(found.covariance))
        inside += np.abs(found.step) <= half
    return inside


def assumed(random, courses):
    """Noise as the fit assumes it: a spectrum and disturbances by their prior weights."""
    table = candidates(COUNT)
    which = random.choice(table.priors.size, p=table.priors / table.priors.sum())
    noise = idct(random.standard_normal(COUNT) * np.sqrt(np.repeat(table.spectra[which], table.sizes)), norm="ortho")
    kind = random.choice(3, p=[NONE_WEIGHT, FAINT_WEIGHT, 1.0 - NONE_WEIGHT - FAINT_WEIGHT])
    sizes = [ABSENT] * courses.shape[1], [FAINT] * courses.shape[1], None
    size = sizes[kind]
    while size is None or (kind == 2 and max(size) == ABSENT):
        size = random.choice([ABSENT, PRESENT], courses.shape[1])
    return noise + courses @ (np.asarray(size) * random.standard_normal(courses.shape[1]))


@pytest.mark.long
def test_white_noise_that_is_stated():
    """Of 1,000 curves 92 to 98 % are held for each number: an honest interval fails once in 10,000 such tests."""
    inside = held(lambda random, _: random.standard_normal(COUNT), 1000, white=True)
    assert np.all((inside >= LOW * 1000) & (inside <= HIGH * 1000)), inside


@pytest.mark.long
def test_noise_as_it_is_assumed():
    """Of 200 curves; one number of an honest interval leaves the bounds once in a thousand tests."""
    inside = held(assumed, 200, white=False)
    assert np.all((inside >= binom.ppf(5e-4, 200, 0.95)) & (inside <= binom.ppf(1.0 - 5e-4, 200, 0.95))), inside


@pytest.mark.long
def test_fits_of_curves_with_white_noise():
    """Whole fits: of 20 curves as many are held as once in a thousand tests, and the errors are those of intervals."""
    inside, errors = np.zeros(len(FREE), dtype=int), []
    for seed in range(7000, 7020):
        noise = np.random.default_rng(seed).standard_normal(COUNT)
        found = wk.fit(curve(noise, noise_spectrum="white"), start(4e3, 4e3, 4.0), free=FREE)
        ends = [found.interval(name) for name in FREE]
        inside += [low <= truth <= high for (low, high), truth in zip(ends, TRUE, strict=True)]
        errors.append([(found.value(name) - true) / found.error(name) for name, true in zip(FREE, TRUE, strict=True)])
        assert not found.flags
    assert np.min(inside) >= int(binom.ppf(1e-3, 20, 0.95)), inside
    assert 0.55 < np.sqrt(np.mean(np.square(errors))) < 1.45  # five numbers that go together: 20 of them count


def elastic_curve(noise, **more):
    """A ball on a half-space by Hertz: E* = 4/3 kPa."""
    depth = np.linspace(-1e-6, 1e-6, 200)
    force = 4.0 / 3.0 * 4e3 / 3.0 * np.sqrt(5e-6) * np.maximum(depth, 0.0) ** 1.5
    return wk.ForceCurve(depth + 3e-6, force + 0.02 * force.max() * noise, **more)


def fitted(measured):
    bed = wk.Foundation(wk.Paraboloid(5e-6), wk.HalfSpace.between(wk.Elastic(5e3, 0.5)))
    free = ["bed.medium.first.young", "contact_point", "baseline"]
    return wk.fit(measured, wk.Indentation(bed, wk.Depth(0.0)), free=free)


def test_stated_white_noise_gives_the_errors_of_least_squares():
    """Covariance s^2 (J^T J)^-1 with derivatives of Hertz by hand, s^2 the sum of squares over n - p - 2."""
    found = fitted(elastic_curve(np.random.default_rng(3).standard_normal(200), noise_spectrum="white"))
    young, point, baseline = found.values
    depth = np.maximum(found.curve.position - point, 0.0)
    per_young = 16.0 / 9.0 * np.sqrt(5e-6) * depth**1.5
    rows = np.stack([per_young, -1.5 * young * 16.0 / 9.0 * np.sqrt(5e-6 * depth), np.ones(200)], axis=1)
    residuals = found.curve.force - young * per_young - baseline
    size = np.linalg.norm(rows, axis=0)
    covariance = np.linalg.inv((rows / size).T @ (rows / size)) / np.outer(size, size)
    wanted = np.sqrt(np.diag(covariance) * (residuals @ residuals) / 195.0)
    assert found.standard_errors == pytest.approx(wanted, rel=1e-3)
    assert found.quantile(0.95, "baseline") == pytest.approx(1.96, abs=1e-2)
    assert found.effective_count == pytest.approx(200.0, rel=1e-9)
    assert not found.flags


def test_slow_noise_that_was_stated_to_be_white_is_doubted():
    random = np.random.default_rng(5)
    noise = random.standard_normal(200) + 0.5 * np.cumsum(random.standard_normal(200))
    stated, unknown = (fitted(elastic_curve(0.3 * noise, noise_spectrum=word)) for word in ("white", "unknown"))
    assert "not_white" in [flag.name for flag in stated.flags]
    assert "not_white" not in [flag.name for flag in unknown.flags]
    assert np.all(stated.standard_errors < unknown.standard_errors)


def test_other_words_for_noise_are_refused():
    with pytest.raises(wk.InvalidInput, match="noise_spectrum is 'pink'; give 'unknown' or 'white'"):
        dataclasses.replace(elastic_curve(np.zeros(200)), noise_spectrum="pink")


def test_a_study_states_that_the_noise_is_white():
    folder = Path(__file__).parents[3] / "examples" / "studies" / "fitting"
    text = (folder / "fit_gel.toml").read_text(encoding="utf-8")
    unknown, white = (
        fit_study(parse_fit_study(text.replace("[fit.free]", f'noise_spectrum = "{word}"\n[fit.free]'), folder=folder))
        for word in ("unknown", "white")
    )
    (before,), (after,) = (outcome.fitted for outcome in (unknown, white))
    assert after.fit.slow_share == 0.0 < before.fit.slow_share
    assert np.all(after.fit.standard_errors < before.fit.standard_errors)
    assert unknown.provenance.hash != white.provenance.hash
