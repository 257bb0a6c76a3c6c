"""Pictures in somebody else's figure: axes, lists of axes, sub-figures."""

from __future__ import annotations

import pytest
from matplotlib.figure import Figure

import winkler as wk
from winkler.plot import draw
from winkler.values.errors import InvalidInput

BED = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25)))
ONE = wk.Indentation(BED, wk.Force(1.0)).solve()


def numbers(axes):
    """Return what is drawn as lines."""
    return [line.get_xydata().tolist() for line in axes.get_lines()]


def test_a_sub_figure_holds_what_a_figure_would():
    alone = draw(ONE)
    figure = Figure(layout="constrained")
    left, right = figure.subfigures(1, 2)
    assert draw(ONE, ax=left) is left
    assert [numbers(axes) for axes in left.axes] == [numbers(axes) for axes in alone.axes]
    assert left.get_suptitle() == alone.get_suptitle()
    assert right.axes == []


def test_axes_are_filled_in_the_order_of_the_panels():
    alone = draw(ONE)
    figure = Figure()
    mine = figure.subplots(2, 2)
    assert draw(ONE, ax=mine) is figure
    assert [numbers(axes) for axes in figure.axes] == [numbers(axes) for axes in alone.axes]
    assert [axes.get_title(loc="left") or axes.get_title() for axes in figure.axes] == [
        axes.get_title(loc="left") or axes.get_title() for axes in alone.axes
    ]


def test_the_style_of_axes_stays_and_their_number_is_counted():
    figure = Figure()
    first, *others = figure.subplots(1, 5)
    colour = first.spines["bottom"].get_edgecolor()
    with pytest.raises(
        InvalidInput, match=r"draw: the picture has 4 panels, and ax 1 axes; give as many, or a sub-fig"
    ):
        draw(ONE, ax=first)
    assert draw(BED, ax=[first, *others][: len(draw(BED).axes)]) is figure
    assert first.spines["bottom"].get_edgecolor() == colour


@pytest.mark.parametrize("wrong", ["axes", 3, [None], []])
def test_what_is_no_place_is_refused(wrong):
    with pytest.raises(
        InvalidInput, match=r"draw: ax is .*; give axes of matplotlib, a list of them, a figure or a sub"
    ):
        draw(ONE, ax=wrong)
