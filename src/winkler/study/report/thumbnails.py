"""Thumbnails: a few curves in a small SVG of bounded size, without axes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from winkler.numerics.types import Array
from winkler.study.report.markup import safe

__all__ = ["THUMBNAIL_POINTS", "thumbnail"]

THUMBNAIL_POINTS = 48
"""Most points of a curve."""
WIDE, HIGH, EDGE = 120, 44, 3
COLOURS = ("#9aa5b1", "#c2410c")
"""Of what was measured and what was fitted to it."""


def thumbnail(curves: Sequence[tuple[Array, Array]], label: str) -> str:
    """Return an inline SVG with curves over each other, all on one scale.

    Parameters
    ----------
    curves : sequence of pairs of ndarray
        Abscissae and ordinates ``(n,)`` of each: what was measured, then what was fitted.
    label : str
        What is shown, for those who do not see it.
    """
    chosen = [_few(x, y) for x, y in curves]
    whole = [np.concatenate(parts) for parts in zip(*chosen, strict=True)] if chosen else []
    if not whole or whole[0].size < 2:
        return ""
    low, span = ([f(part) for part in whole] for f in (np.min, np.ptp))
    lines = []
    for (x, y), colour in zip(chosen, COLOURS, strict=False):
        across = EDGE + (WIDE - 2 * EDGE) * (x - low[0]) / (span[0] or 1.0)
        down = HIGH - EDGE - (HIGH - 2 * EDGE) * (y - low[1]) / (span[1] or 1.0)
        points = " ".join(f"{a:.0f},{b:.1f}" for a, b in zip(across.tolist(), down.tolist(), strict=True))
        lines.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
    return (
        f'<svg class="thumbnail" role="img" aria-label="{safe(label)}" width="{WIDE}" height="{HIGH}" '
        f'viewBox="0 0 {WIDE} {HIGH}">{"".join(lines)}</svg>'
    )


def _few(x: Array, y: Array) -> tuple[Array, Array]:
    """Return points of a curve spread evenly, with the extremes of its ordinate."""
    known = np.flatnonzero(np.isfinite(x) & np.isfinite(y))
    if known.size > THUMBNAIL_POINTS:
        places = np.linspace(0, known.size - 1, THUMBNAIL_POINTS - 2).round().astype(int)
        ends = [int(np.argmax(y[known])), int(np.argmin(y[known]))]
        known = known[np.unique([*places.tolist(), *ends])]
    return x[known], y[known]
