"""Pictures of heated maps: what is drawn of one creepage and of many, of either body, and of bodies at rest."""

from __future__ import annotations

import numpy as np

import winkler as wk
from winkler.plot import sheet_of
from winkler.plot.panel import Arrow, Strokes

STEEL = wk.ThermalConductor(45.0, 12e-6)
STEELS = wk.HeatConductors(STEEL, STEEL)
BALL = wk.SampledProfile([0.5e-3, 0.5e-3], wk.Paraboloid(10e-3), (25, 25))
MEDIUM = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))


def of_rolling(creepage: list[float]):
    rolling = wk.SurfaceRolling(
        BALL, MEDIUM, wk.Force(60.0), wk.Coulomb(0.3), wk.Creepage(longitudinal=creepage), speed=5.0
    )
    return sheet_of(wk.SurfaceFrictionHeating(rolling, STEELS).solve())


def of_sliding(first: float, second: float, traction: float, hot: float = 0.0):
    pressure = np.zeros((6, 5))
    pressure[1:5, 1:4] = 50e6
    load = wk.SurfaceLoad(pressure, [6e-3, 5e-3], x_traction=traction * pressure, corner=[1e-3, 0.0])
    return sheet_of(wk.SurfaceFrictionHeating(load, STEELS, first, second, 0.0, hot).solve())


def test_of_many_creepages_the_curve_is_drawn_too():
    one, many = of_rolling([5e-3]), of_rolling([1e-3, 2e-3, 5e-3])
    assert len(one.panels) == 3
    assert len(many.panels) == 4
    assert [line.name for line in many.panels[3].marks] == ["greatest of the contact", "mean"]
    assert many.panels[1].title == "surface of the first body; + hottest, → its motion"
    (arrow,) = (mark for mark in one.panels[1].marks if isinstance(mark, Arrow))
    assert arrow.stop[0] < arrow.start[0]  # material passes to the left


def test_the_outline_is_the_border_of_the_pixels_and_the_map_lies_at_its_place():
    flux, surface, along = of_sliding(1.0, 0.0, -0.1).panels
    (outline,) = (mark for mark in surface.marks if isinstance(mark, Strokes))
    assert len(outline.x) == 2 * (4 + 3)
    assert np.allclose((outline.x.min(), outline.x.max()), (2e-3, 6e-3), rtol=1e-12)
    assert np.allclose((outline.y.min(), outline.y.max()), (1e-3, 4e-3), rtol=1e-12)
    assert np.nanmax(flux.marks[0].z) == 0.1 * 50e6
    (arrow,) = (mark for mark in surface.marks if isinstance(mark, Arrow))
    assert arrow.stop[0] > arrow.start[0]
    assert [mark.name for mark in along.marks[:2]] == ["first body", "second body"]


def test_the_body_that_moves_is_shown():
    assert "second body" in of_sliding(0.0, 1.0, 0.1).panels[1].title
    still = of_sliding(0.0, 0.0, 0.1, hot=10.0).panels[1]
    assert still.title == "surface of the first body; + hottest"
    assert not any(isinstance(mark, Arrow) for mark in still.marks)
