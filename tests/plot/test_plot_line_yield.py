"""Pictures of where a line contact begins to yield, and of its shakedown limit."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import sheet_of
from winkler.plot.marks import Line, Map

STRONG = wk.Elastic(210e9, 0.3, strength=700e6)


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
