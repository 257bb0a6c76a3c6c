"""Families of curves: a result over one varied quantity, one curve for each value of another."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.panel import Bars, Panel, PanelAxis, Sheet, among
from winkler.plot.series import Scale, Series, common_scale, middle_scale

MOST_COLOURS = len(style.CYCLE)
"""Greatest number of curves with distinct colours; more take the shades of a colour map."""
LETTERS = 40
"""Of a line of the name of a bar; longer names have several lines."""
LEAST_DECADES = 1.5
"""Values that span more decades than this are shown on a logarithmic axis."""


def spans_decades(content: np.ndarray) -> bool:
    """Return whether numbers are positive and span more than `LEAST_DECADES` decades."""
    finite = content[np.isfinite(content)]
    if finite.size < 3 or finite.min() <= 0.0:
        return False
    return bool(np.log10(finite.max() / finite.min()) > LEAST_DECADES)


def in_equal_ratios(rising: np.ndarray) -> bool:
    """Return whether rising numbers over decades stand closer to equal ratios than to equal steps."""
    if not spans_decades(rising):
        return False
    steps, ratios = np.diff(rising), np.diff(np.log(rising))
    return bool(np.all(ratios >= 0.0) and np.ptp(ratios) / np.mean(ratios) < np.ptp(steps) / np.mean(steps))


def family_sheet(
    along: Sequence[Series], of: Sequence[Series], labels: Sequence[str], *, ordered: bool = True
) -> Sheet:
    """Return one result over one varied quantity.

    Parameters
    ----------
    along, of : sequence of Series
        One pair for each curve, of one quantity each.
    labels : sequence of str
        One for each curve; a legend is shown if there are several.
    ordered : bool, optional
        Whether points are joined in ascending order; if not, in the given order.
    """
    logarithmic = spans_decades(np.concatenate([one.content.ravel() for one in along]))
    logarithmic_upright = logarithmic and spans_decades(np.concatenate([one.content.ravel() for one in of]))
    many = len(of) > MOST_COLOURS
    lines = []
    for place, (x, y) in enumerate(zip(along, of, strict=True)):
        order = np.argsort(x.content, kind="stable") if ordered else np.arange(x.content.size)
        look: dict[str, Any] = {"colour": style.shade(0.15 + 0.85 * place / (len(of) - 1)), "dash": ()} if many else {}
        name = labels[place] if not many or place in (0, len(of) // 2, len(of) - 1) else ""
        lines.append(among(place, x.content[order], y.content[order], name, **look))
    across = PanelAxis.of(along[0], _scale(along, logarithmic), margin=0.04, log=logarithmic, plain=logarithmic)
    upright = PanelAxis.of(
        of[0], _scale(of, logarithmic_upright), margin=0.06, log=logarithmic_upright, plain=logarithmic_upright
    )
    names = [line.name for line in lines if line.name]
    below = 0 if len(labels) < 2 else 1 if max(map(len, names)) > 28 else 2
    panel = Panel(tuple(lines), across, upright)
    return Sheet((panel,), width=4.6, height=3.3 if len(labels) < 2 else 3.9, below=below)


def _scale(many: Sequence[Series], logarithmic: bool) -> Scale:
    """Return one scale for all: by the greatest number, or on a logarithmic axis by the middle one."""
    if logarithmic:
        return middle_scale(many[0].word.unit, np.concatenate([one.content.ravel() for one in many]))
    return common_scale(*many)


def bar_sheet(names: Sequence[str], of: Series) -> Sheet:
    """Return one result for varied items that are not numbers, such as shapes or solids: one bar each.

    Parameters
    ----------
    names : sequence of str
        What was varied: one for each bar.
    of : Series
        One number for each bar; none where it is NaN.
    """
    places = np.arange(float(len(names)))
    texts = tuple("\n".join(textwrap.wrap(name, LETTERS)) for name in names)
    upright = PanelAxis(ticks=places, names=texts, falling=True)
    panel = Panel((Bars(places, np.nan_to_num(of.content)),), PanelAxis.of(of), upright, grid="x")
    most = max((text.count("\n") for text in texts), default=0)
    return Sheet((panel,), width=4.6, height=max(1.6, 0.9 + (0.3 + 0.14 * most) * len(names)))
