"""Thumbnails: a few curves in a small SVG of bounded size, without axes; and many of them with their flags."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.study.report.markup import safe, section

THUMBNAIL_POINTS, MANY_POINTS, MANY = 48, 24, 100
"""Most points of a curve; where there are more thumbnails than that on a page, fewer."""
MOST_THUMBNAILS = 1000
"""Of one page: a megabyte at most."""
WIDE, HIGH, EDGE = 120, 44, 3
COLOURS = ("#9aa5b1", "#c2410c")
"""Of what was measured and what was fitted to it."""


class ThumbnailOf(NamedTuple):
    """What is drawn of one curve: lines, name, flags in words (empty if none), and whether it has an answer."""

    curves: Sequence[tuple[Array, Array]]
    name: str
    flags: str
    answered: bool = True


def thumbnails_section(items: Sequence[ThumbnailOf]) -> str:
    """Return thumbnails with names and flags, those without an answer or with flags first; empty for a single one.

    Parameters
    ----------
    items : sequence of ThumbnailOf
    """
    if len(items) < 2:
        return ""
    shown = _chosen(items)
    points = MANY_POINTS if len(shown) > MANY else THUMBNAIL_POINTS
    cards = []
    for one in shown:
        kind = "flagged" if one.flags or not one.answered else "plain"
        words = f"<figcaption>{safe(one.name)}" + f"<br><em>{safe(one.flags)}</em>" * bool(one.flags) + "</figcaption>"
        drawn = thumbnail(one.curves, one.name, points) or "<p>not drawn</p>"
        cards.append(f'<figure class="mini {kind}">{drawn}{words}</figure>')
    flagged = sum(bool(one.flags) or not one.answered for one in items)
    lead = (
        f"Measured in grey, fitted in red. {flagged} of {len(items)} curves have flags or no answer; they come first."
    )
    if len(shown) < len(items):
        lead += f" {len(shown)} of all are shown."
    return section("All curves at a glance", f"<p>{lead}</p>", f'<div class="thumbnails">{"".join(cards)}</div>')


def _chosen(items: Sequence[ThumbnailOf]) -> list[ThumbnailOf]:
    """Return flagged curves, then the others, spread evenly where there are too many."""
    flagged = [one for one in items if one.flags or not one.answered][:MOST_THUMBNAILS]
    plain = [one for one in items if one.answered and not one.flags]
    room = MOST_THUMBNAILS - len(flagged)
    if len(plain) > room:
        plain = [plain[place] for place in np.linspace(0, len(plain) - 1, room).round().astype(int).tolist()]
    return [*flagged, *plain]


def thumbnail(curves: Iterable[tuple[Array, Array]], label: str, points: int = THUMBNAIL_POINTS) -> str:
    """Return an inline SVG with curves over each other, all on one scale.

    Parameters
    ----------
    curves : sequence of pairs of ndarray
        Abscissae and ordinates ``(n,)`` of each: what was measured, then what was fitted.
    label : str
        What is shown, for those who do not see it.
    points : int, optional
        Most points of a curve.
    """
    chosen = [_few(x, y, points) for x, y in curves]
    whole = [np.concatenate(parts) for parts in zip(*chosen, strict=True)] if chosen else []
    if not whole or whole[0].size < 2:
        return ""
    low, span = ([f(part) for part in whole] for f in (np.min, np.ptp))
    lines = []
    for (x, y), colour in zip(chosen, COLOURS, strict=False):
        across = EDGE + (WIDE - 2 * EDGE) * (x - low[0]) / (span[0] or 1.0)
        down = HIGH - EDGE - (HIGH - 2 * EDGE) * (y - low[1]) / (span[1] or 1.0)
        path = " ".join(f"{a:.0f},{b:.1f}" for a, b in zip(across.tolist(), down.tolist(), strict=True))
        lines.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
    return (
        f'<svg class="thumbnail" role="img" aria-label="{safe(label)}" width="{WIDE}" height="{HIGH}" '
        f'viewBox="0 0 {WIDE} {HIGH}">{"".join(lines)}</svg>'
    )


def _few(x: Array, y: Array, most: int) -> tuple[Array, Array]:
    """Return points of a curve spread evenly, with the extremes of its ordinate."""
    known = np.flatnonzero(np.isfinite(x) & np.isfinite(y))
    if known.size > most:
        places = np.linspace(0, known.size - 1, most - 2).round().astype(int)
        ends = [int(np.argmax(y[known])), int(np.argmin(y[known]))]
        known = known[np.unique([*places.tolist(), *ends])]
    return x[known], y[known]
