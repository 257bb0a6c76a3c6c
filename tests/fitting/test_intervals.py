"""Profile likelihood against closed forms and brute force, and comparison of models."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.stats import norm
from synthetic import hertz, hertz_on_spring, jkr, noise, there_and_back

import winkler as wk
from winkler.fitting.compare import compare
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.fitting.intervals import profile_interval
from winkler.fitting.noise.estimate import noise_of
from winkler.laws.adhesion import DerjaguinMullerToporov, ShortRange
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.values.errors import InvalidInput, OutsideValidity

R, YOUNG = 5e-6, 1e4
MODULUS = YOUNG / 0.75
PATH = "bed.medium.first.young"


def bed(profile=None) -> wk.Foundation:
    return wk.Foundation(profile or wk.Paraboloid(R), wk.HalfSpace.between(wk.Elastic(3e4, 0.5)))


def test_of_a_linear_fit_it_is_the_mixture_over_noises():
    position = np.linspace(1e-8, 1e-6, 100)
    punch = wk.Foundation(wk.FlatPunch(1e-6), wk.HalfSpace.between(wk.Elastic(YOUNG, 0.5)))
    force = 2.0 * MODULUS * 1e-6 * position + 1e-10 * noise(np.random.default_rng(4), 100)
    found = fit(ForceCurve(position, force), wk.Indentation(punch, wk.Depth(0.0)), free=["baseline", "tilt"])
    jacobian = np.stack([np.ones(100), position], axis=1)
    mixture = noise_of(found.residuals, jacobian, np.zeros((100, 0))).mixture

    def held(width):  # of the tilt, both ends of every candidate
        apart, errors = mixture.steps[:, 1] - mixture.mean[1], np.sqrt(mixture.covariances[:, 1, 1])
        return mixture.shares @ (norm.cdf((width - apart) / errors) - norm.cdf((-width - apart) / errors)) - 0.95

    width = brentq(held, 0.0, 10.0 * found.error("tilt"))
    low, high = profile_interval(found, "tilt")
    assert low == pytest.approx(found.value("tilt") - width, abs=0.005 * width)
    assert high == pytest.approx(found.value("tilt") + width, abs=0.005 * width)
    assert found.interval("tilt") == pytest.approx((low, high), abs=0.005 * width)


@pytest.mark.long
def test_of_hertz_against_a_scan():
    """The modulus held, the contact point found by a fine scan: no least squares, no derivative."""
    position = np.linspace(-5e-7, 5e-7, 120)
    force = hertz(position, MODULUS, R) + 3e-10 * noise(np.random.default_rng(2), 120)
    found = fit(ForceCurve(position, force), wk.Indentation(bed(), wk.Depth(0.0)), free=[PATH, "contact_point"])
    low, high = profile_interval(found, PATH)
    origins = np.linspace(-4e-8, 4e-8, 4001)

    def residuals(young):
        return np.array([force - hertz(position - origin, young / 0.75, R) for origin in origins])

    k, i = np.arange(120)[:, None], np.arange(120)
    cosines = np.sqrt(np.where(k == 0, 1.0, 2.0) / 120.0) * np.cos(np.pi * k * (i + 0.5) / 120.0)
    along = np.sqrt(3.0) * (2.0 * i - 119.0) / np.sqrt(120.0**2 - 1.0)
    young, place = found.value(PATH), position - found.value("contact_point")
    moved = hertz(place + 1e-10, young / 0.75, R) - hertz(place - 1e-10, young / 0.75, R)
    jacobian = np.stack([hertz(place, young / 0.75, R), moved], axis=1)
    mean = noise_of(found.residuals, jacobian, along[:, None])
    whole = cosines.T @ np.diag(mean.spectrum) @ cosines + mean.amplitudes[0] ** 2 * np.outer(along, along)
    inverse = np.linalg.inv(whole)

    def least(young):
        return float(np.einsum("oi,ij,oj->o", residuals(young), inverse, residuals(young)).min())

    best = min(least(young) for young in np.linspace(low, high, 60))
    growths = np.array([least(end) for end in (low, high)]) - best
    plain = np.linalg.inv(jacobian.T @ inverse @ jacobian)[0, 0]  # of a relative change
    allowed = (found.error(PATH) / young) / np.sqrt(plain) * found.quantile(0.95, PATH)
    assert np.sqrt(growths).mean() == pytest.approx(allowed, rel=0.01)  # the centre is the mean over noises, not one's
    np.testing.assert_allclose(np.sqrt(growths), allowed, rtol=0.06)
    assert found.interval(PATH) == pytest.approx((low, high), abs=0.03 * (high - low))


def test_a_bound_ends_an_interval():
    position = np.linspace(-5e-7, 5e-7, 120)
    force = hertz(position, MODULUS, R) + 3e-10 * noise(np.random.default_rng(2), 120)
    free = {PATH: (9.9e3, 1.2e4), "contact_point": ()}
    found = fit(ForceCurve(position, force), wk.Indentation(bed(), wk.Depth(0.0)), free=free)
    low, _ = profile_interval(found, PATH)
    assert low == pytest.approx(9.9e3)
    with pytest.raises(InvalidInput, match="'tilt' was not free"):
        profile_interval(found, "tilt")


def models() -> dict:
    work = [PATH, "law.work", "contact_point", "baseline"]
    return {
        "Hertz": (wk.Indentation(bed(), wk.Depth(0.0)), [PATH, "contact_point", "baseline"]),
        "cone": (wk.Indentation(bed(wk.Cone(half_angle=1.2)), wk.Depth(0.0)), [PATH, "contact_point", "baseline"]),
        "JKR": (AdhesiveIndentation(bed(), ShortRange(1e-3), wk.Depth(0.0)), work),
        "DMT": (AdhesiveIndentation(bed(), DerjaguinMullerToporov(1e-3), wk.Depth(0.0)), work),
        "DMT of a cone": (
            AdhesiveIndentation(bed(wk.Cone(half_angle=1.2)), DerjaguinMullerToporov(1e-3), wk.Depth(0.0)),
            work,
        ),
    }


@pytest.mark.slow
def test_a_sticky_curve_speaks_for_jkr():
    position, inward = there_and_back(-1e-6, 1e-6, 150)
    force = jkr(position, inward, MODULUS, R, 1e-4, 0.05) + 3e-11 * noise(np.random.default_rng(1), 300)
    found = compare(ForceCurve(position, force, 0.05), models())
    assert found.models[0] == "JKR"
    assert found.best is found.fits[0]
    assert found.evidence[0] == 1.0
    assert found.evidence[1] > 100.0
    assert np.all(found.evidence[2:] > 1e6)
    assert np.all(np.diff(found.aic) >= 0.0)
    assert len(found.refused) == 1
    assert "DMT of a cone: DerjaguinMullerToporov" in found.refused[0]
    assert not found.decided
    assert found.verdict.endswith("Not fitted, and therefore not excluded: DMT of a cone.")
    sizes = np.array([len(one.names) for one in found.fits])
    np.testing.assert_allclose(found.bic - found.aic, (np.log(found.effective_count) - 2.0) * sizes, rtol=1e-6)


def test_a_dry_curve_does_not_need_adhesion():
    position, _ = there_and_back(-1e-6, 1e-6, 150)
    force = hertz_on_spring(position, MODULUS, R, 0.05) + 3e-11 * noise(np.random.default_rng(3), 300)
    kinds = models()
    found = compare(ForceCurve(position, force, 0.05), {name: kinds[name] for name in ("cone", "Hertz")})
    assert found.models == ("Hertz", "cone")


def test_comparing_nothing_is_refused():
    position = np.linspace(-1e-6, 1e-6, 150)
    curve = ForceCurve(position, hertz(position, MODULUS, R))
    with pytest.raises(InvalidInput, match="no model is given"):
        compare(curve, {})
    with pytest.raises(OutsideValidity, match="no model can be fitted; DMT of a cone"):
        compare(curve, {"DMT of a cone": models()["DMT of a cone"]})


@pytest.mark.slow
def test_what_cannot_be_told_apart_is_named():
    """A ball and a cone far apart; a ball, and one with an attraction that the noise hides."""
    position, _ = there_and_back(-1e-6, 1e-6, 150)
    clean = hertz_on_spring(position, MODULUS, R, 0.05)
    curve = ForceCurve(position, clean + 3e-11 * noise(np.random.default_rng(3), 300), 0.05)
    kinds = models()
    told = compare(curve, {name: kinds[name] for name in ("cone", "Hertz")})
    assert told.possible == ("Hertz",)
    assert told.excluded == ("cone",)
    assert told.decided
    assert told.evidence[1] > np.exp(7.0)
    assert told.verdict == "This curve distinguishes Hertz from cone."
    near = compare(curve, {name: kinds[name] for name in ("Hertz", "JKR")})
    assert set(near.possible) == {"Hertz", "JKR"}
    assert not near.decided
    assert near.verdict == f"This curve does not distinguish {' and '.join(near.models)}."
    both = compare(curve, {name: kinds[name] for name in ("Hertz", "JKR", "cone")})
    assert set(both.possible) == {"Hertz", "JKR"}
    assert both.verdict == f"This curve does not distinguish {' and '.join(both.possible)}; it excludes cone."


def test_when_no_model_explains_the_curve_none_wins():
    """A flat punch in hardly any noise, for balls and cones: the likelier one is not said to be right."""
    position, _ = there_and_back(-1e-6, 1e-6, 150)
    force = 2.0 * MODULUS * 1e-6 * np.maximum(position, 0.0)
    curve = ForceCurve(position, force + 1e-12 * noise(np.random.default_rng(3), 300))
    kinds = models()
    found = compare(curve, {name: kinds[name] for name in ("Hertz", "cone")})
    assert found.evidence[1] > 100.0
    assert not found.explained
    assert found.possible == ()
    assert found.excluded == found.models
    assert not found.decided
    assert found.verdict == f"None of the models explains this curve; {found.models[0]} comes nearest."


@pytest.mark.parametrize("size", [0.0, 1e-300, 1.0, 1e4, 1e154, 1e300, np.inf])
@pytest.mark.parametrize("confidence", [1e-12, 0.95, 1.0 - 1e-15])
def test_an_interval_of_extremes_is_honest(size, confidence):
    """Errors, stretches and reaches of all sizes: ends in order, no overflow, no NaN, and what is open is named."""
    position = np.linspace(-5e-7, 5e-7, 120)
    force = hertz(position, MODULUS, R) + 3e-10 * noise(np.random.default_rng(2), 120)
    found = fit(ForceCurve(position, force), wk.Indentation(bed(), wk.Depth(0.0)), free=[PATH, "contact_point"])
    for stretch in (0.2, 1.0, 5.0):
        errors = size * np.abs(found.values)
        lost = dataclasses.replace(found, standard_errors=errors, stretches=np.full((2, 2), stretch))
        for name in found.names:
            low, high = lost.interval(name, confidence)
            assert low <= found.value(name) <= high
        if size >= 1e4 and confidence > 0.9:
            assert lost.interval(PATH, confidence) == (0.0, np.inf)
            assert PATH in lost.unbounded
    if size <= 1.0:
        assert lost.unbounded == ()
