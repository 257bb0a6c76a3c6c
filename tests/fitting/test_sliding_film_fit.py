"""Is a film bonded to its base, or does it slide? Curves of formulas of the tests, with white and slow noise."""

import functools

import numpy as np
import pytest
from harder_worlds import on_a_film
from noisy_worlds import coloured
from scipy.interpolate import CubicSpline
from sliding_solution import ball

import winkler as wk

YOUNG = "bed.medium.layers[0].solid.young"
TRUE, BEAD, FILM = 4e3, 5e-6, 2e-6
FREE = [YOUNG, "contact_point", "baseline", "tilt"]


@functools.cache
def reduced():
    """F R / (E* h^3) over the root of d R / h^2, of a paraboloid on a sliding film."""
    depth, force = np.array([(0.0, 0.0)] + [ball(one, 1.0, 1.0) for one in np.linspace(0.0, 2.2, 45)[1:].tolist()]).T
    return CubicSpline(np.sqrt(depth), force)


def sliding(position, modulus, radius, thickness):
    return modulus * thickness**3 / radius * reduced()(np.sqrt(np.maximum(position, 0.0) * radius) / thickness)


LAWS = {"bonded": on_a_film, "sliding": sliding}


def model(kind):
    medium = kind([wk.Layer(wk.Elastic(1e3, 0.5), FILM)], on=wk.Rigid())
    return wk.Indentation(wk.Foundation(wk.Paraboloid(BEAD), medium), wk.Depth(0.0)), FREE


MODELS = {"bonded": model(wk.CoatedHalfSpace), "sliding": model(wk.SlidingFilm)}


def measured(law, *, deepest, noise, seed, count=150):
    """A curve with noise in parts of its greatest force."""
    random = np.random.default_rng(seed)
    position = np.linspace(-deepest, deepest, count)
    force = LAWS[law](position, TRUE / 0.75, BEAD, FILM)
    disturbed = random.standard_normal(count) + coloured(random, count, 1.0) / 3.0
    disturbed += random.uniform(-1.0, 1.0) * np.linspace(-1.0, 1.0, count)
    return wk.ForceCurve(position + 3e-6, force + noise * force.max() * disturbed + 1e-10)


@pytest.mark.slow
@pytest.mark.parametrize("law", ["sliding", pytest.param("bonded", marks=pytest.mark.long)])
def test_a_deep_curve_tells_and_its_modulus_holds(law):
    """0.4 of the thickness deep, 0.5 % of noise: the other one would give a modulus wrong by a factor."""
    other = "bonded" if law == "sliding" else "sliding"
    found = wk.compare(measured(law, deepest=0.8e-6, noise=5e-3, seed=1, count=80), MODELS)
    assert found.verdict == f"This curve distinguishes {law} from {other}."
    low, high = found.best.interval(YOUNG)
    assert low < TRUE < high < 1.2 * low


@pytest.mark.long
def test_noise_hides_the_interface():
    found = wk.compare(measured("sliding", deepest=0.1e-6, noise=5e-2, seed=2, count=60), MODELS)
    assert set(found.possible) == {"bonded", "sliding"}
    assert found.verdict.startswith("This curve does not distinguish ")


@pytest.mark.long
def test_the_wrong_interface_is_not_told():
    wrong = right = 0
    for seed in range(4):
        law, noise = ("bonded", "sliding")[seed % 2], (5e-3, 3e-2)[seed // 2]
        found = wk.compare(measured(law, deepest=0.3e-6, noise=noise, seed=[3, seed], count=80), MODELS)
        wrong += found.decided and found.possible != (law,)
        right += found.decided and found.possible == (law,)
    assert wrong == 0
    assert right >= 2
