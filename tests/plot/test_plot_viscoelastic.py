"""Pictures of viscoelastic solids and contacts: what they draw is what the answers say, and every axis has its unit."""

from __future__ import annotations

import functools

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw
from winkler.plot.curves import Quantity, curves_panel
from winkler.plot.panel import Sheet
from winkler.plot.render import render
from winkler.plot.series import scale_of, series, with_unit
from winkler.values.errors import InvalidInput

RUBBER = wk.StandardSolid(relaxed_shear=1e6, shear=3e6, relaxation_time=0.1)
MEDIUM = wk.ViscoelasticHalfSpace(RUBBER)
BED = wk.Foundation(wk.Paraboloid(10e-3), MEDIUM)
TIME = np.linspace(0.0, 0.4, 21)
DEPTH = 1e-4 * np.interp(TIME, [0.0, 0.1, 0.3, 0.4], [0.0, 1.0, 1.0, 0.0])
MOMENTS = np.geomspace(1e-3, 10.0, 9)
OMEGA = np.geomspace(0.1, 1e3, 9)


@functools.cache
def problem():
    return wk.ViscoelasticIndentation(BED, wk.Path(TIME, wk.Depth(DEPTH)), count=60)


@functools.cache
def states():
    return tuple(problem().steps())


@functools.cache
def dragged():
    path = wk.Path([0.0, 0.1, 0.2], wk.Depth([5e-5, 1e-4, 8e-5]), wk.Shift([0.0, 3e-5, -3e-5]))
    return wk.Tangential(BED, wk.Coulomb(0.5), path, count=40).solve()


def pulled():
    law = wk.RateDependentWork(work=0.05, reference_speed=1e-6, exponent=0.6)
    path = wk.Path(np.linspace(0.0, 30.0, 16), wk.Depth(np.linspace(5e-6, -25e-6, 16)))
    return wk.ViscoelasticAdhesion(BED, law, path).solve()


ITEMS = {
    "path": (lambda: problem().solve(), 7),  # one panel has a second axis
    "pressed": (lambda: states()[8], 2),
    "let go": (lambda: states()[-1], 2),
    "creep": (lambda: wk.CreepTest(BED, 1.0, MOMENTS).solve(), 2),
    "relaxation": (lambda: wk.RelaxationTest(BED, 1e-4, MOMENTS).solve(), 1),
    "one moment": (lambda: wk.CreepTest(BED, 1.0, [0.1]).solve(), 2),
    "oscillation": (lambda: wk.HarmonicIndentation(BED, wk.Depth(1e-4), OMEGA).solve(), 2),
    "one frequency": (lambda: wk.HarmonicIndentation(BED, wk.Force(1.0), 10.0).solve(), 2),
    "dragged": (lambda: dragged(), 6),
    "dragged, one moment": (lambda: dragged().states[1], 2),
    "sliding": (lambda: wk.SlidingResistance(BED, wk.Force(1.0), np.geomspace(1e-4, 1.0, 5), count=100).solve(), 3),
    "one speed": (lambda: wk.SlidingResistance(BED, wk.Depth(1e-4), 1e-3, count=100).solve(), 3),
    "pulled off": (lambda: pulled(), 4),
    "impact": (lambda: wk.ViscoelasticImpact(BED, 0.03, 1.0, count=40, tolerance=1e-2).solve(), 5),
    "standard solid": (lambda: RUBBER, 3),
    "dashpot": (lambda: wk.Prony(0.0, [], [], viscosity=2.0), 3),
    "voigt": (lambda: wk.KelvinVoigt(1e6, 1e5), 3),
    "maxwell": (lambda: wk.Maxwell(1e6, 2.0), 3),
    "power law": (lambda: wk.PowerLawSolid(500.0, 1.0, 0.2, 1e-3, 10.0), 3),
    "relaxation data": (lambda: wk.RelaxationData(MOMENTS, RUBBER.relaxation(MOMENTS)), 3),
    "creep data": (lambda: wk.CreepData(MOMENTS, RUBBER.creep(MOMENTS)), 3),
    "dynamic data": (lambda: wk.DynamicData(OMEGA, RUBBER.storage(OMEGA), RUBBER.loss(OMEGA)), 3),
    "warm": (lambda: wk.AtTemperature(RUBBER, wk.Arrhenius(300.0, 8e4), 320.0), 3),
    "bed": (lambda: BED, 2),
    "film": (lambda: wk.RelaxingInProportion(wk.HalfSpace(wk.Elastic(1e6, 0.3)), RUBBER, 1e6), 3),
    "pair": (lambda: wk.ViscoelasticHalfSpace(RUBBER, wk.Elastic(5e6, 0.3)), 3),
}


@functools.cache
def picture(name):
    return draw(ITEMS[name][0]())


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize("name", list(ITEMS))
def test_every_picture_has_its_panels_and_units(name):
    figure = picture(name)
    assert len(figure.axes) == ITEMS[name][1]
    for axes in figure.axes:
        if not axes.axison:
            continue
        for label in (axes.get_xlabel(), axes.get_ylabel()):
            assert "[" in label or name == "film" or "tan" in label or "coefficient" in label or not label
    figure.set_layout_engine("none")  # which takes two thirds of a drawing
    figure.draw_without_rendering()


def test_the_loop_is_the_answer():
    axes = picture("path").axes[0]
    loop = max(axes.lines, key=lambda line: len(line.get_xdata()))
    answer = problem().solve()
    assert np.asarray(loop.get_xdata()) * 1e-6 == pytest.approx(answer.depth, abs=1e-15)
    assert np.max(loop.get_ydata()) == pytest.approx(np.max(answer.force))


def test_springs_that_recover_differ_from_those_in_contact():
    from matplotlib.colors import to_hex

    from winkler.plot import style

    coils = picture("let go").axes[0].collections
    colours = [to_hex(colour) for item in coils for colour in item.get_edgecolor()]
    assert style.GREEN in colours
    assert style.RED not in colours
    pressed = picture("pressed").axes[0].collections
    assert style.RED in [to_hex(colour) for item in pressed for colour in item.get_edgecolor()]


def test_measured_points_are_shown_beside_the_series():
    points = [line for line in picture("creep data").axes[1].lines if line.get_linestyle() == "None"]
    assert len(points) == 1
    assert len(points[0].get_xdata()) == MOMENTS.size


def test_requested_points_lie_on_the_curve():
    axes = picture("creep").axes[0]
    curve, points = axes.lines[0], axes.lines[1]
    found = np.interp(np.log(points.get_xdata()), np.log(curve.get_xdata()), curve.get_ydata())
    assert found == pytest.approx(np.asarray(points.get_ydata()), rel=1e-3)


def test_a_curve_that_falls_to_nothing_ends_the_axis():
    along = series("time", np.geomspace(1.0, 1e2, 9))
    falling = Quantity(series("shear", np.exp(-along.content)))
    axes = render(Sheet((curves_panel(along, [falling]),))).axes[0]
    assert axes.get_yscale() == "log"
    assert axes.get_ylim()[0] > 1e-6


@pytest.mark.parametrize("name", ["path", "let go", "creep", "oscillation", "impact", "standard solid", "pair"])
def test_an_extent_has_no_meaning_here(name):
    with pytest.raises(InvalidInput, match="no extent; leave it out"):
        draw(ITEMS[name][0](), extent=1.0)


def test_compliances_have_their_own_prefixes():
    assert scale_of("1/Pa", [2.5e-7]) == (1e-6, "1/MPa")
    assert with_unit(2.5e-7, "1/Pa") == "0.25 1/MPa"
    assert with_unit(0.0, "1/Pa") == "0 1/Pa"
