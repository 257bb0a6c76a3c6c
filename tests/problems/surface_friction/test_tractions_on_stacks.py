"""Tractions of height maps on bonded stacks: isotropic layers as coated half-spaces, one solid as a half-space."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.problems.rough.compliance import compliance_of

STIFF, SOFT = wk.Elastic(10.0, 0.3), wk.Elastic(1.0, 0.4)
WEAVE = wk.TransverselyIsotropic(10.0, 4.0, 3.0, 6.0, 2.0)


def along(medium, periodic):
    compliance = compliance_of(medium).in_units_of(0.1)
    return TractionGrid.of((20, 18), (1.0, 0.9), compliance, periodic=periodic).along


@pytest.mark.parametrize("periodic", [False, True])
def test_bonded_stacks_are_sheared_as_what_they_are_made_of(periodic):
    layers = [wk.Layer(STIFF, 0.3), wk.Layer(SOFT, 0.5)]
    stack = wk.StackedHalfSpace(layers, on=STIFF, second=SOFT)
    coated = along(wk.CoatedHalfSpace(layers, on=STIFF, second=SOFT), periodic)
    assert along(stack, periodic) == pytest.approx(coated, rel=1e-8, abs=1e-9 * np.max(coated))
    woven = wk.StackedHalfSpace([wk.StackLayer(WEAVE, 0.3, True)], on=WEAVE, second=SOFT)
    plain = along(wk.TransverselyIsotropicHalfSpace(WEAVE, SOFT), periodic)
    assert along(woven, periodic) == pytest.approx(plain, rel=1e-8, abs=1e-9 * np.max(plain))


def test_a_layer_that_slides_bears_no_tractions():
    slides = wk.StackedHalfSpace([wk.Layer(STIFF, 0.1), wk.StackLayer(WEAVE, 0.3, False)], on=WEAVE)
    with pytest.raises(
        wk.OutsideValidity, match="The layer of a StackedHalfSpace that slides carries no tangential tractions"
    ):
        compliance_of(slides)
