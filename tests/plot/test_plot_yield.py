"""Pictures of where line contacts and contacts on layers begin to yield, and of the shakedown limit."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import sheet_of
from winkler.plot.marks import Line, Map

STRONG = wk.Elastic(210e9, 0.3, strength=700e6)
BALL, E = wk.Paraboloid(1e-2), 210e9
BASE = wk.Elastic(E, 0.3, strength=1e9)
WEAVE = wk.TransverselyIsotropic(400e9, 160e9, 120e9, 240e9, 80e9)
UNDER_WEAVE = wk.StackedHalfSpace([wk.StackLayer(WEAVE, 5e-5, True)], on=BASE)
FAR_BELOW = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(E, 0.3), 1e-3)], on=wk.Elastic(E, 0.3, strength=3e6))
STRONG_LAYER = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(4.0 * E, 0.25, strength=9e9), 5e-5)], on=BASE)


@pytest.mark.parametrize("problem", [wk.LineYieldOnset, wk.LineShakedown])
def test_the_map_is_of_the_body_that_yields_at_its_surface(problem):
    """The first body is rigid: it has no stresses."""
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), wk.HalfSpace(wk.Rigid(), STRONG))
    limit = problem(bed, wk.Coulomb(0.5)).solve()
    assert limit.z == 0.0
    (panel,) = sheet_of(limit).panels
    (drawn,) = (mark for mark in panel.marks if isinstance(mark, Map))
    (place,) = (mark for mark in panel.marks if isinstance(mark, Line))
    assert np.max(drawn.y) == 0.0 > np.min(drawn.y)
    assert place.x[0] == limit.x


def test_the_marked_place_has_the_greatest_of_what_is_drawn():
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(STRONG, wk.Elastic(210e9, 0.3)))
    for problem, most in ((wk.LineYieldOnset, 700e6), (wk.LineShakedown, 700e6 / np.sqrt(3.0))):
        limit = problem(bed, wk.Coulomb(0.2)).solve()
        (panel,) = sheet_of(limit).panels
        (drawn,) = (mark for mark in panel.marks if isinstance(mark, Map))
        level = np.asarray(drawn.z)
        assert np.max(level) == pytest.approx(most, rel=0.01)
        place = np.unravel_index(np.argmax(level), level.shape)
        across, down = (np.broadcast_to(part, level.shape)[place] for part in (drawn.x, drawn.y))
        assert np.hypot(across - limit.x, down - limit.z) < 0.1 * limit.half_width


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("mu", [0.0, 0.3])
@pytest.mark.parametrize("medium", [UNDER_WEAVE, FAR_BELOW, STRONG_LAYER])
def test_the_place_that_yields_is_on_the_map(medium, mu):
    """Also far below the contact, and under a layer whose stresses are not known."""
    onset = wk.YieldOnset(wk.Foundation(BALL, medium), wk.Coulomb(mu)).solve()
    (panel, _) = sheet_of(onset).panels
    maps = [mark for mark in panel.marks if isinstance(mark, Map)]  # one for each body, no row on an interface
    (stress,) = (drawn for drawn in maps if 0.99999 * np.min(drawn.y) <= onset.z <= np.max(drawn.y))
    (place,) = (mark for mark in panel.marks if getattr(mark, "marker", "") == "+")
    assert (place.x[0], place.y[0]) == (onset.x, onset.z)
    assert np.min(stress.x) <= onset.x <= np.max(stress.x)
