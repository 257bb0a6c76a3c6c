"""Pictures of the onset of yield on layers: where it begins is on the map, also far below the contact."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot.drawing import sheet_of

BALL, E = wk.Paraboloid(1e-2), 210e9
BASE = wk.Elastic(E, 0.3, strength=1e9)
WEAVE = wk.TransverselyIsotropic(400e9, 160e9, 120e9, 240e9, 80e9)
UNDER_WEAVE = wk.StackedHalfSpace([wk.StackLayer(WEAVE, 5e-5, True)], on=BASE)
FAR_BELOW = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(E, 0.3), 1e-3)], on=wk.Elastic(E, 0.3, strength=3e6))
STRONG_LAYER = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(4.0 * E, 0.25, strength=9e9), 5e-5)], on=BASE)


@pytest.mark.slow
@pytest.mark.parametrize("mu", [0.0, 0.3])
@pytest.mark.parametrize("medium", [UNDER_WEAVE, FAR_BELOW, STRONG_LAYER])
def test_the_place_that_yields_is_on_the_map(medium, mu):
    onset = wk.YieldOnset(wk.Foundation(BALL, medium), wk.Coulomb(mu)).solve()
    (panel, _) = sheet_of(onset).panels
    (stress,) = (mark for mark in panel.marks if type(mark).__name__ == "Map")
    (place,) = (mark for mark in panel.marks if getattr(mark, "marker", "") == "+")
    assert (place.x[0], place.y[0]) == (onset.x, onset.z)
    assert np.min(stress.x) <= onset.x <= np.max(stress.x)
    assert 0.99999 * np.min(stress.y) <= onset.z <= np.max(stress.y)  # a row lies just below the interface
