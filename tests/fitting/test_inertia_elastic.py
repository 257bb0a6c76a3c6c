"""The inertia of a probe on an elastic body: fast curves whose tip moves as a sinusoid, by Hertz and Newton."""

import numpy as np
import pytest
from noisy_worlds import coloured

import winkler as wk
from winkler.study.language.fit_reading import parse_fit_study

RADIUS, TRUE, TOUCH, SWING, PERIOD = 5e-6, 1e4, 2e-6, 0.6e-6, 1e-3
YOUNG = "bed.medium.first.young"
FREE = [YOUNG, "contact_point", "baseline"]


def measured(seed, spring, share=0.08, count=600, noise=4e-3):
    """A spring bears F = F_c + m x'' at D = x + F/k; m x'' is at most `share` of the greatest force of the contact."""
    random, time = np.random.default_rng(seed), np.linspace(0.0, PERIOD, count)
    turns = 2.0 * np.pi / PERIOD
    tip = -0.2e-6 - SWING * np.cos(turns * time)
    bent = SWING * turns**2 * np.cos(turns * time)
    contact = 4.0 / 3.0 * TRUE / 0.75 * np.sqrt(RADIUS) * np.maximum(tip, 0.0) ** 1.5
    mass = share * contact.max() / (SWING * turns**2)
    force = contact + mass * bent
    scatter = random.standard_normal(count) + coloured(random, count, 1.0) / 3.0
    shown = force + noise * contact.max() * scatter
    return wk.ForceCurve(tip + force / spring + TOUCH, shown, spring, time), mass


def model():
    bed = wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace.between(wk.Elastic(3e4, 0.5)))
    return wk.Indentation(bed, wk.Depth(0.0))


@pytest.mark.parametrize("spring", [0.05, np.inf])
def test_modulus_and_mass_are_found(spring):
    curve, mass = measured(1, spring)
    found = wk.fit(curve, model(), free=[*FREE, "inertia"])
    for name, truth in ((YOUNG, TRUE), ("contact_point", TOUCH), ("inertia", mass)):
        low, high = found.interval(name)
        assert low < truth < high, name
    assert found.value("inertia") == pytest.approx(mass, rel=0.03)
    assert found.value(YOUNG) == pytest.approx(TRUE, rel=0.01)
    assert found.depth.max() == pytest.approx(SWING - 0.2e-6, rel=0.02)


def test_a_soft_spring_shows_a_wrong_modulus_without_it():
    curve, _ = measured(1, 0.05)
    assert wk.fit(curve, model(), free=FREE).value(YOUNG) > 1.05 * TRUE


@pytest.mark.slow
@pytest.mark.parametrize("spring", [0.05, np.inf])
def test_intervals_hold(spring):
    held = []
    for seed in range(40):
        curve, mass = measured(seed, spring)
        found = wk.fit(curve, model(), free=[*FREE, "inertia"])
        ends = [found.interval(name) for name in (YOUNG, "contact_point", "inertia")]
        held.append([low < truth < high for (low, high), truth in zip(ends, (TRUE, TOUCH, mass), strict=True)])
    assert np.all(np.mean(held, axis=0) >= 0.85)  # of 40: less than 0.95 by three standard errors


def test_it_needs_times_and_is_a_key_of_studies():
    curve, _ = measured(1, 0.05)
    timeless = wk.ForceCurve(curve.position, curve.force, 0.05)
    with pytest.raises(wk.InvalidInput, match="'inertia' needs times"):
        wk.fit(timeless, model(), free=[*FREE, "inertia"])
    text = """
[problem]
kind = "indentation"
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "5 um" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 kPa", poisson = 0.5 } }
[fit]
curve = "fast.csv"
part = "both"
free = { "problem.bed.medium.first.young" = true, inertia = ["1 ng", "1 mg"] }
"""
    (*_, mass) = parse_fit_study(text.replace('curve = "fast.csv"', f'curve = "{__file__}"')).free
    assert (mass.key, mass.given) == ("inertia", pytest.approx((1e-12, 1e-6)))
