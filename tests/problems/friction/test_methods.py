"""The method of each problem of slip: taken where it holds, refused with those that do."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.line_friction.marched_states import LineMarchedState

STEEL, SOFT = wk.Elastic(210e9, 0.3), wk.Elastic(20e9, 0.4)
HALF, COATED = wk.HalfSpace(STEEL, STEEL), wk.CoatedHalfSpace([wk.Layer(SOFT, 1e-4)], on=STEEL)
BALL, LAW = wk.Paraboloid(1e-2), wk.Coulomb(0.3)
LINE = wk.LinePath([1e3, 1.5e3, 1.2e3], [0.0, 200.0, -100.0])


def pressed_line(method, medium=HALF):
    bed = wk.LineFoundation(BALL, medium) if medium is HALF else wk.LayeredLineFoundation(BALL, medium)
    return wk.LineTangential(bed, LAW, LINE, method)


def bimodal(method, medium=HALF, coefficient=0.3):
    bed = wk.Foundation(BALL, medium)
    return wk.BimodalDamping(bed, wk.Coulomb(coefficient), 1e-6, 4e-7, 2e-7, 0.7, method=method)


@pytest.mark.parametrize(
    ("make", "known"),
    [
        (pressed_line, "auto, exact or elements"),
        (bimodal, "auto, exact or rings"),
    ],
)
def test_another_method_is_refused_with_those_that_hold(make, known):
    words = known.replace(" or ", ", ").split(", ")
    for method in wk.Method:
        if method in words and (make, method) != (bimodal, wk.Method.RINGS):
            assert make(method).method is method
        elif method in words:
            assert bimodal(method, COATED).method is method
        else:
            with pytest.raises(wk.InvalidInput, match=f"the method {method} does not follow .*; give {known}[.]"):
                make(method)


@pytest.mark.slow
def test_elements_of_a_line_agree_with_sums_of_earlier_contacts():
    exact, elements = (pressed_line(method).solve() for method in (wk.Method.EXACT, wk.Method.ELEMENTS))
    assert exact.states == pressed_line(wk.Method.AUTO).solve().states
    assert isinstance(elements.states[-1], LineMarchedState)
    assert elements.dissipation_per_length == pytest.approx(exact.dissipation_per_length, rel=2e-3)
    assert elements.slip_shift == pytest.approx(exact.slip_shift, abs=2e-3 * np.max(np.abs(exact.slip_shift)))


@pytest.mark.slow
def test_sums_are_refused_where_they_do_not_hold():
    with pytest.raises(wk.OutsideValidity, match="the method exact adds up .*Give the method elements"):
        pressed_line(wk.Method.EXACT, COATED).solve()
    with pytest.raises(wk.OutsideValidity, match="exact needs one ratio: give the method rings"):
        bimodal(wk.Method.EXACT, COATED).solve()
    with pytest.raises(
        wk.OutsideValidity,
        match=r"BimodalDamping: the medium of the bed is a HalfSpace.*leave the method out for other media",
    ):
        bimodal(wk.Method.RINGS)


@pytest.mark.slow
def test_rings_of_a_coating_that_is_none_lose_what_springs_do():
    same = wk.CoatedHalfSpace([wk.Layer(STEEL, 1e-4)], on=STEEL)
    exact, rings = (bimodal(method, same).solve() for method in (wk.Method.EXACT, wk.Method.RINGS))
    assert exact.loss_per_cycle == pytest.approx(bimodal(wk.Method.AUTO, same).solve().loss_per_cycle, rel=1e-12)
    assert rings.loss_per_cycle == pytest.approx(exact.loss_per_cycle, rel=2e-3)
    assert any("divided into annular elements" in note.statement for note in rings.validity)
    assert math.isfinite(rings.loss_per_cycle)
