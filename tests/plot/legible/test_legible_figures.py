"""Faults of a figure are found; `tests/study/test_every_kind.py` looks for them in the figures of every kind."""

from __future__ import annotations

import numpy as np
import pytest
from legibility import faults
from matplotlib.figure import Figure


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


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda axes: axes.set_xlabel(""), "no name: the x axis"),
        (lambda axes: axes.set_xlim(2.0, 3.0), "cut: 20 of 20 points"),
        (lambda axes: axes.lines[0].remove(), "empty: "),
        (lambda axes: axes.text(0.5, 0.5, "here", fontsize=6.0), "small: 'here'"),
        (lambda axes: [axes.text(0.5, 0.5, word) for word in ("here", "there")], "overlap: 'there' and 'here'"),
        (lambda axes: axes.text(1.5, 0.5, "far away"), "outside: 'far away'"),
    ],
)
def test_each_fault_is_found(spoil, fault):
    figure, axes = plotted()
    spoil(axes)
    figure.set_layout_engine("none") if fault.startswith("outside") else None
    assert any(found.startswith(fault) for found in faults(figure))
