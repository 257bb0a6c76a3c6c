"""Verdicts on models, on curves of closed forms under slow noise."""

import numpy as np
import pytest
from noisy_worlds import coloured
from synthetic import hertz

import winkler as wk

E = "bed.medium.first.young"
FREE = [E, "contact_point", "baseline"]


def model(profile):
    return wk.Indentation(wk.Foundation(profile, wk.HalfSpace.between(wk.Elastic(3e4, 0.5))), wk.Depth(0.0))


MODELS = {"ball": (model(wk.Paraboloid(5e-6)), FREE), "cone": (model(wk.Cone(1.2)), FREE)}


def measured(seed, law, level, count=300, flicker=1.0 / 3.0):
    random = np.random.default_rng(seed)
    depth = np.linspace(-0.5e-6, 0.5e-6, count)
    force = hertz(depth, 1e4 / 0.75, 5e-6)
    if law == "cone":  # the same force at the greatest depth
        force = force.max() * np.maximum(depth / depth.max(), 0.0) ** 2
    if law == "step":
        force = force * (1.0 + 0.6 * np.tanh((depth - 0.25e-6) / 1e-8))
    noise = random.standard_normal(count) + flicker * coloured(random, count, 1.0)
    return wk.ForceCurve(depth + 1e-6, force + level * noise)


def compared(*args, **kwargs):
    return wk.compare(measured(*args, **kwargs), MODELS)


@pytest.mark.parametrize(("law", "other"), [("ball", "cone"), ("cone", "ball")])
def test_clear_curves_tell(law, other):
    found = compared(1, law, 1e-11)
    assert found.decided
    assert found.possible == (law,)
    assert found.verdict == f"This curve distinguishes {law} from {other}."


def test_noise_hides_the_tip():
    found = compared(2, "ball", 1e-9, count=60)
    assert not found.decided
    assert set(found.possible) == {"ball", "cone"}
    assert found.verdict.startswith("This curve does not distinguish ")


def test_no_model_is_confirmed_by_a_worse_one():
    found = compared(3, "step", 1e-11)
    assert not found.decided
    assert not found.explained
    assert found.possible == ()
    assert "None of the models explains" in found.verdict


@pytest.mark.long
def test_wrong_models_are_rarely_told():
    """From noise that hides the tip to noise that does not: no curve is called the other tip."""
    wrong = right = 0
    for seed in range(50):
        law = ("ball", "cone")[seed % 2]
        found = compared([4, seed], law, 10.0 ** np.random.default_rng(seed).uniform(-10.5, -9.0), count=150)
        wrong += found.decided and found.possible != (law,)
        right += found.decided and found.possible == (law,)
    assert wrong == 0
    assert right >= 10


def test_a_single_model_is_not_told():
    one = wk.compare(measured(1, "ball", 1e-11), {"ball": MODELS["ball"]})
    assert one.verdict == "ball is the only model that was fitted."
    assert not one.decided
