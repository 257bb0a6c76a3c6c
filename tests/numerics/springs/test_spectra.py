"""Relaxation and creep: closed forms, the convolution that ties them, and there and back."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from winkler.numerics.springs.exponential_sums import CreepSeries, RelaxationSeries, merged, of_creep, of_relaxation


def relaxing(relaxed, viscosity, *pairs):
    return RelaxationSeries(relaxed, viscosity, np.array([m for m, _ in pairs]), np.array([t for _, t in pairs]))


TIMES = np.array([0.0, 0.1, 0.7, 3.0, 40.0])
CLOSED = {
    "elastic": (relaxing(2.0, 0.0), lambda t: 0.5 + 0.0 * t),
    "dashpot": (relaxing(0.0, 4.0), lambda t: t / 4.0),
    "Kelvin-Voigt": (relaxing(2.0, 3.0), lambda t: -np.expm1(-2.0 * t / 3.0) / 2.0),
    "Maxwell": (relaxing(0.0, 0.0, (2.0, 3.0)), lambda t: (1.0 + t / 3.0) / 2.0),
    "standard solid": (relaxing(0.2, 0.0, (0.8, 0.3)), lambda t: 5.0 - 0.8 / 0.2 * np.exp(-0.2 * t / 0.3)),
    "Jeffreys": (
        relaxing(0.0, 1.0, (2.0, 3.0)),  # 1/C = s (1 + 6 / (1 + 3 s)): C = (1 + 3 s) / (s (7 + 3 s))
        lambda t: t / 7.0 - 18.0 / 49.0 * np.expm1(-7.0 * t / 3.0),
    ),
}


@pytest.mark.parametrize("name", CLOSED)
def test_creep_of_simple_solids(name):
    series, creep = CLOSED[name]
    assert of_relaxation(series).at(TIMES) == pytest.approx(creep(TIMES), rel=1e-13, abs=1e-16)


@pytest.mark.slow
def test_the_convolution_of_both_is_the_time():
    """Int_0^t M(t - s) C(s) ds = t, by mpmath."""
    series = relaxing(0.3, 0.0, (1.0, 0.05), (0.5, 0.4), (2.0, 6.0))
    creep = of_relaxation(series)
    for t in (0.02, 1.0, 30.0):
        whole = mp.quad(
            lambda s, t=t: float(series.at(np.array(t - float(s)))) * float(creep.at(np.array(float(s)))),
            [0, t / 30, t / 3, t - t / 10, t - t / 200, t],
        )
        assert float(whole) == pytest.approx(t, rel=1e-9)


solids = st.builds(
    lambda relaxed, viscosity, strengths, gaps: RelaxationSeries(
        relaxed, viscosity, np.array(strengths[: len(gaps)]), 1e-3 * np.cumprod(np.array(gaps[: len(strengths)]))
    ),
    st.sampled_from([0.0, 0.5, 3.0]),
    st.sampled_from([0.0, 1e-3, 2.0]),
    st.lists(st.floats(1e-3, 1e3), min_size=1, max_size=6),
    st.lists(st.floats(1.05, 50.0), min_size=1, max_size=6),
)


@settings(max_examples=80, deadline=None)
@given(solids)
def test_there_and_back(series):
    creep = of_relaxation(series)
    again = of_creep(creep)
    omega = np.geomspace(1e-4, 1e5, 40)
    dynamic = series.dynamic(omega)
    direct = (
        creep.glassy
        + creep.fluidity / (1j * omega)
        + (1.0 / (1.0 + 1j * omega[:, None] * creep.times)) @ (creep.compliances)
    )
    assert np.abs(direct * dynamic - 1.0).max() < 1e-9
    assert np.abs(again.dynamic(omega) / dynamic - 1.0).max() < 1e-9
    assert np.all(creep.compliances > 0.0)
    assert np.all(np.diff(creep.times) > 0.0)


def test_one_behind_the_other():
    first = CreepSeries(1.0, 0.1, np.array([1.0, 2.0]), np.array([1.0, 5.0]))
    second = CreepSeries(0.5, 0.0, np.array([4.0]), np.array([5.0]))
    both = first.plus(second)
    assert both.times.tolist() == [1.0, 5.0]
    assert both.at(TIMES) == pytest.approx(first.at(TIMES) + second.at(TIMES), rel=1e-14)


def test_equal_times_are_one():
    strengths, times = merged(np.array([1.0, 2.0, 0.0, 3.0]), np.array([2.0, 1.0, 7.0, 2.0]))
    assert (strengths.tolist(), times.tolist()) == ([2.0, 4.0], [1.0, 2.0])


def test_terms_of_hardly_any_strength_do_not_matter():
    """A compliance of 1e-15 of the others has its zero nearer to its pole than logarithms resolve."""
    gel = CreepSeries(1e-3, 2e-3, np.array([4.2e-18, 2.2e-19]), np.array([0.00711, 0.0948]))
    back = of_creep(gel)
    times = np.geomspace(1e-3, 10.0, 7)
    assert back.at(times) == pytest.approx(1e3 * np.exp(-2.0 * times), rel=1e-9)
