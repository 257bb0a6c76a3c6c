r"""Boundary elements of a line contact: where they lie, and what friction bears on each of them.

Lengths are counted in the greatest half-width A of the path, tractions in E*.  Each element bears an even traction, of
at most :math:`\mu` times its mean pressure, so that all of them together bear :math:`\mu P`.  Elements are narrow
where the edge of the contact goes; one touches when its middle does, and what presses on it before counts to the next.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.numerics.types import Array
from winkler.problems.line.peak_pressure import rim_load

INNER = 200
"""Elements on half of the narrowest contact, narrow at its edge."""
LEAST_OUTER, MOST_OUTER, OUTER_PER_WIDTH = 40, 120, 320.0
"""Elements between the edges of the narrowest and the widest contact."""
MERGED = 0.05
"""Part of the range of the edge within which turning points count as one."""
ROUNDING = 1e-12


class LineElements(NamedTuple):
    """Elements over the widest contact.

    Parameters
    ----------
    scale
        A [m].
    edges
        Ascending ``(n + 1,)``, over A.
    x, widths
        Their middles and widths ``(n,)``, over A.
    compliance
        Displacement at the middles ``(n, n)`` over A by tractions over E*.
    """

    scale: float
    edges: Array
    x: Array
    widths: Array
    compliance: Array


def elements_for(bed: LineBed, half_widths: Array) -> LineElements:
    """Return the elements for contacts of these half-widths [m], at least one above zero."""
    scale = float(np.max(half_widths))
    ends = np.unique(half_widths) / scale
    inner, outer = INNER, min(max(OUTER_PER_WIDTH * (1.0 - ends[0]), LEAST_OUTER), MOST_OUTER)
    ends = ends[np.append(np.diff(ends) > MERGED * (1.0 - ends[0]), True)]  # edges of the contact at turning points
    half = np.zeros(1)
    for start, end in zip(np.append(0.0, ends), ends, strict=False):
        if end > 0.0:
            count = inner if start == 0.0 and end == ends[0] else max(round(outer * (end - start) / (1.0 - ends[0])), 4)
            half = np.append(half, start + (end - start) * np.sin(0.5 * np.pi * np.arange(1, count + 1) / count))
    edges = np.concatenate([-half[:0:-1], half])
    return LineElements(
        scale, edges, 0.5 * (edges[1:] + edges[:-1]), np.diff(edges), bed.shear_compliance(scale * edges)
    )


def pressed_elements(bed: LineBed, elements: LineElements, force: float, half_width: float) -> Array:
    """Return the mean pressure on every element over E* ``(n,)``; zero where it does not touch.

    Parameters
    ----------
    bed : LineBed
    elements : LineElements
    force : float
        P [N/m].
    half_width : float
        a [m].
    """
    n, a = elements.x.size // 2, half_width / elements.scale
    load = force / (bed.medium.modulus * elements.scale)
    if load == 0.0:
        return np.zeros(2 * n)
    on_rim = rim_load(bed, force, half_width)
    mean = bed.mean_pressures(elements.scale * elements.edges[n:], half_width, on_rim)
    return pressures_of(elements, mean, load, a)


def pressures_of(elements: LineElements, mean: Array, load: float, a: float) -> Array:
    """Return the mean pressures over E* ``(n,)`` from those on the right half, of a contact of half-width `a` over A.

    What presses on an element that does not touch counts to the last that does, and all add up to P over E* A.
    """
    n = elements.x.size // 2
    borne = mean * elements.widths[n:]
    touching = max(int(np.sum(elements.x[n:] < a * (1.0 - ROUNDING))), 1)
    borne[touching - 1] += float(np.sum(borne[touching:]))
    borne[touching:] = 0.0
    right = 0.5 * load * borne / float(np.sum(borne)) / elements.widths[n:]
    return np.concatenate([right[::-1], right])
