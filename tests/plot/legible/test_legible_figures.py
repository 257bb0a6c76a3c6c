"""Faults of a figure are found; `tests/study/test_every_kind.py` looks for them in the figures of every kind."""

from __future__ import annotations

import numpy as np
import pytest
from legibility import faults
from matplotlib.figure import Figure

from winkler.plot.panel import Line, Panel, PanelAxis, Sheet
from winkler.plot.render import render


def plotted():
    """Return a figure without a fault, and its panel."""
    figure = Figure(figsize=(4.0, 3.0), layout="constrained")
    axes = figure.add_subplot()
    axes.plot(np.linspace(0.0, 1.0, 20), np.linspace(0.0, 1.0, 20))
    axes.set_xlabel("depth [m]")
    axes.set_ylabel("force [N]")
    return figure, axes


def test_a_figure_without_a_fault_has_none():
    assert faults(plotted()[0]) == []


@pytest.mark.parametrize("wanted", ["upper right", "best"])
def test_a_legend_covers_no_curve(wanted):
    x = np.linspace(0.0, 1.0, 200)
    curves = [Line(x, 0.5 + 0.5 * np.sin(phase + 9.0 * x), name=f"after {phase} s") for phase in range(5)]
    panel = Panel(tuple(curves), PanelAxis("place"), PanelAxis("height"), legend=wanted)
    assert faults(render(Sheet((panel,)))) == []


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda axes: axes.set_xlabel(""), "no name: the x axis"),
        (lambda axes: axes.set_xlim(2.0, 3.0), "cut: 20 of 20 points"),
        (lambda axes: axes.lines[0].remove(), "empty: "),
        (lambda axes: axes.text(0.5, 0.5, "here", fontsize=6.0), "small: 'here'"),
        (lambda axes: [axes.text(0.5, 0.5, word) for word in ("here", "there")], "overlap: 'there' and 'here'"),
        (lambda axes: axes.text(1.5, 0.5, "far away"), "outside: 'far away'"),
        (lambda axes: axes.set_ylabel("force [uN]"), "letters: 'force [uN]'"),
        (lambda axes: axes.set_ylim(0.0, 100.0), "flat: "),
        (
            lambda axes: (axes.set_yscale("log"), axes.set_ylim(0.2, 9.0), axes.yaxis.set_minor_formatter("")),
            "one number: ",
        ),
        (lambda axes: (axes.set_yscale("log"), axes.set_ylim(1e-19, 1.0)), "decades: "),
        (lambda axes: axes.set_ylim(1.0 - 1e-9, 1.0), "offset: "),
        (lambda axes: axes.plot([0.0, 0.4, 0.7, 1.0], [0.0, 0.1, 0.4, 0.9]), "polygon: a curve of 4 points"),
        (lambda axes: axes.fill_between([0.0, 1.0], 0.0, 0.004), "thin: "),
        (lambda axes: (axes.lines[0].set_label("curve"), axes.legend(loc="upper right")), "below the legend: 'curve'"),
        (lambda axes: axes.text(0.45, 0.48, "here"), "struck through: 'here'"),
        (lambda axes: axes.text(0.45, 0.48, "here", bbox={"color": "white"}), "below the text 'here'"),
    ],
)
def test_each_fault_is_found(spoil, fault):
    figure, axes = plotted()
    spoil(axes)
    figure.set_layout_engine("none") if fault.startswith("outside") else None
    assert any(found.startswith(fault) for found in faults(figure))


def test_a_legend_is_no_wider_than_its_panel():
    figure, axes = plotted()
    for number in range(3):
        axes.plot([0.0, 1.0], [2.0, 2.0], label=f"a name of thirty letters, {number}")
    axes.legend(loc="upper center", ncols=3, frameon=False).set_in_layout(False)
    assert "wider than its panel: the legend over 'depth [m]'" in faults(figure)
