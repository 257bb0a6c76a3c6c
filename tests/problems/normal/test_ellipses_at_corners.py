"""Ellipses on layers thin and thick, hard and soft to a factor of a million, against round contacts."""

from __future__ import annotations

import itertools

import pytest

import winkler as wk

CORNERS = list(itertools.product([1e-6, 1e-3, 1e3, 1e6], [1e-3, 0.1, 1.0, 10.0, 1e3], [0.3, 0.5]))
ONE_FILM_THAT_KEEPS_ITS_VOLUME = (1e-6, 1e3, 0.5)


@pytest.mark.few(6, slow=34)
@pytest.mark.parametrize(("contrast", "ratio", "poisson"), CORNERS)
def test_two_equal_curvatures_are_the_ball(contrast, ratio, poisson):
    """Force over depth by pixels, of which a map that bends a plate has the error that it states.

    By depth plates a million times stiffer than their base ended in NotConverged as wide as they are thick.
    """
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(contrast, poisson), 1.0)], on=wk.Elastic(1.0, 0.3))
    radius = 1e3 * max(1.0, ratio)
    ball = wk.Indentation(wk.Foundation(wk.Paraboloid(radius), medium), wk.Radius(ratio)).solve()
    for load in (wk.Force(float(ball.force)), wk.Depth(float(ball.depth))):
        ellipse = wk.EllipticIndentation(wk.CurvedBodies(radius, radius), medium, load)
        if (contrast, ratio, poisson) == ONE_FILM_THAT_KEEPS_ITS_VOLUME:
            with pytest.raises(wk.OutsideValidity, match="too coarse"):
                ellipse.solve()
            continue
        found = ellipse.solve()
        assert (found.force, found.depth) == pytest.approx((ball.force, ball.depth), rel=0.012)
        edge = max(0.03, found.edge_error)
        assert found.area == pytest.approx(3.14159265 * ratio**2, rel=2.0 * edge)


def test_by_depth_and_by_force_a_bent_plate_is_the_same():
    plate = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1e6, 0.5), 1.0)], on=wk.Elastic(1.0, 0.3))
    bodies = wk.CurvedBodies(1.1e3, 1e3)
    ball = wk.Indentation(wk.Foundation(wk.Paraboloid(1e3), plate), wk.Radius(0.5)).solve()
    pressed = wk.EllipticIndentation(bodies, plate, wk.Force(float(ball.force))).solve()
    again = wk.EllipticIndentation(bodies, plate, wk.Depth(float(pressed.depth))).solve()
    assert again.force == pytest.approx(pressed.force, rel=1e-4)
    assert again.depth == pytest.approx(pressed.depth, rel=1e-6)
