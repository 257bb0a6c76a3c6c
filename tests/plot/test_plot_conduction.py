"""Pictures of contacts that conduct: what they draw is what the answers say, and every axis has its unit."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw

SILVER = wk.Elastic(83e9, 0.37)
BALL = wk.Foundation(wk.Paraboloid(2e-3), wk.HalfSpace.between(SILVER, SILVER))
METAL, OTHER = wk.ElectricalConductor(15.9e-9, 3.8e-3), wk.ElectricalConductor(70e-9, 6e-3)
PAIR = wk.ElectricalConductors(METAL, OTHER)
HEAT = wk.HeatConductors(wk.ThermalConductor(45.0, 12e-6), wk.ThermalConductor(390.0, 1.1e-4))
FILMED = wk.ElectricalConductors(wk.Rod(METAL, 1e-3, 1e-2), OTHER, wk.SurfaceFilm(1e-12))


def labels(figure) -> list[str]:
    return [text for axes in figure.axes for text in (axes.get_xlabel(), axes.get_ylabel()) if text]


def test_resistance_is_drawn_over_force_with_the_requested_points():
    item = wk.Constriction(wk.Indentation(BALL, wk.Force(1.0)), PAIR).solve()
    figure = draw(item)
    left = figure.axes[0]
    point = next(line for line in left.lines if line.get_label() == "requested")
    assert "Ω]" in left.get_ylabel()
    factor = {"m": 1e-3, "µ": 1e-6}[left.get_ylabel()[-3]]
    assert point.get_ydata()[0] * factor == pytest.approx(item.resistance, rel=1e-12)
    curve = left.lines[0]
    slope = np.polyfit(np.log(curve.get_xdata()), np.log(curve.get_ydata()), 1)[0]
    assert slope == pytest.approx(-1.0 / 3.0, rel=1e-6)


def test_parts_of_a_resistance_add_up():
    figure = draw(wk.Constriction(wk.Indentation(BALL, wk.Force(np.geomspace(0.1, 10.0, 5))), FILMED).solve())
    names = list(figure.axes[0].get_legend_handles_labels()[1])
    assert names == ["resistance", "constriction", "film", "length of the rods", "requested"]
    assert figure.axes[1].get_ylim() == (0.0, 100.0)


@pytest.mark.slow
@pytest.mark.parametrize(
    "item",
    [
        wk.JouleHeating(wk.Indentation(BALL, wk.Force(1.0)), PAIR, wk.Voltage(0.1)),
        wk.ThermalConstriction(wk.Indentation(BALL, wk.Force(1.0)), HEAT, 10.0),
    ],
    ids=["current", "heat"],
)
def test_the_map_covers_both_bodies_and_the_cut_the_contact(item):
    solution = item.solve()
    figure = draw(solution)
    low, high = figure.axes[0].get_ylim()
    assert low > 0.0 > high  # z points down
    assert sum("temperature" in label for label in labels(figure)) >= 2
    assert any("/m²]" in label for label in labels(figure))


@pytest.mark.slow
def test_where_the_field_is_not_known_other_curves_are_drawn():
    figure = draw(wk.JouleHeating(wk.Indentation(BALL, wk.Force(1.0)), FILMED, wk.Current(5.0)).solve())
    assert len(figure.axes) == 2
    assert "current $I$ [A]" in labels(figure)
    many = draw(wk.JouleHeating(wk.Indentation(BALL, wk.Force(np.array([0.1, 1.0]))), PAIR, wk.Current(5.0)).solve())
    assert "force $F_N$ [N]" in labels(many)


def test_fields_are_drawn_on_grids_and_along_lines():
    solution = wk.ThermalConstriction(wk.Indentation(BALL, wk.Force(1.0)), HEAT, 10.0).solve()
    r, z = np.linspace(0.0, 1e-4, 13), np.linspace(-5e-5, 1e-4, 11)
    one = draw(wk.restore_conduction(solution, r[:, None], z[None, :]))
    turned = draw(wk.restore_conduction(solution, r[None, :], z[:, None]))
    assert one.axes[0].get_xlim() == turned.axes[0].get_xlim()
    line = draw(wk.restore_conduction(solution, 0.0, z))
    assert any(label.startswith("heat flux") for label in labels(line))
    with pytest.raises(wk.InvalidInput, match="does not make a curve"):
        draw(wk.restore_conduction(solution, 0.0, 0.0))


def test_spots_and_bounds():
    spots = wk.SpotCluster([0.0, 1e-5], [0.0, 0.0], [2e-6, 3e-6], METAL, METAL).solve()
    figure = draw(spots)
    assert math.isfinite(spots.holm_radius)
    assert "mΩ" in figure.axes[1].get_title(loc="left")
    bounds = wk.ConductanceBounds(BALL, PAIR, roughness=1e-7, force=1.0).solve()
    band = draw(bounds).axes[0]
    slopes = {line.get_label(): np.ptp(line.get_ydata()) / np.ptp(line.get_xdata()) for line in band.lines[3:]}
    flattest, steepest = (
        next(slope for name, slope in slopes.items() if name.startswith(which)) for which in ("flattest", "steepest")
    )
    assert steepest / flattest == pytest.approx(bounds.greatest_stiffness / bounds.least_stiffness, rel=1e-9)


@pytest.mark.parametrize(
    ("item", "message"),
    [
        (wk.Constriction(wk.Indentation(BALL, wk.Depth(-1e-6)), PAIR), "do not touch"),
        (wk.JouleHeating(wk.Indentation(BALL, wk.Force(1.0)), PAIR, wk.Voltage(0.0)), "no current flows"),
    ],
)
def test_nothing_is_not_drawn(item, message):
    with pytest.raises(wk.OutsideValidity, match=message):
        draw(item.solve())
    with pytest.raises(wk.InvalidInput, match="extent"):
        draw(item.solve(), extent=1.0)
