r"""Strips on layers that relax in proportion: contacts of the elastic layers, each with a share of its own.

The flat strips between two half-widths add what the pressure of the elastic contact grows by from one to the other,

.. math:: p(x,t) = \sum_j \sigma_j(t)\,\bigl[p_\mathrm{el}(x; c_{j+1}) - p_\mathrm{el}(x; c_j)\bigr] ,

with the share :math:`\sigma_j` of the load that they still bear; so does the approach, with that of what has crept.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.foundation.strip_sums import added_responses
from winkler.numerics.panels.chebyshev import fit_panels
from winkler.numerics.transforms.strips.strip_modes import pressure_of_modes
from winkler.numerics.types import Array
from winkler.problems.line.approach import Place
from winkler.problems.line.layered_approach import layered_approach

TOLERANCE = 1e-9
"""Of an approach, over the greatest, between half-widths at which it is computed."""

RelaxingBed = LineFoundation | LayeredLineFoundation
Line = TypeVar("Line", bound=RelaxingBed)


def elastic_line(bed: Line) -> Line:
    """Return the bed as if it were elastic."""
    medium: Any = bed.medium
    return dataclasses.replace(bed, medium=medium.elastic)


def shares_of(line: LineBed, edges: Array, loads: Array) -> Array:
    """Return the parts of their elastic loads that strips between edges bear, ``(..., n - 1)``, from loads [N/m]."""
    grown = line.medium.modulus * np.diff(line.load_profile(edges))
    return np.asarray(-np.diff(loads, axis=-1) / np.where(grown > 0.0, grown, np.inf))


def layered_pressure(
    line: LayeredLineFoundation, edges: Array, shares: Array, edge_load: float
) -> Callable[[Array], Array]:
    """Return what layers add to the pressure on half-planes [Pa], over places that are not negative ``(k,)`` [m].

    Parameters
    ----------
    line : LayeredLineFoundation
        The elastic layers.
    edges, shares : ndarray
        Half-widths c, ascending from zero [m] ``(n,)``, and the parts of the elastic loads that strips between them
        bear ``(n - 1,)``.
    edge_load : float
        What the last edge bears like that of a flat punch [N/m].
    """
    weights = shares - np.append(shares[1:], 0.0)  # of the contact up to the upper edge of each interval
    used, last = weights != 0.0, float(edges[-1])
    c, modes = edges[1:][used, None], added_responses(line, edges[1:][used]).closing if used.any() else np.zeros((0, 1))
    weights = -2.0 / np.pi * line.medium.modulus * weights[used, None] / c
    punch = line.carried(last, 1.0).added - line.carried(last, 0.0).added if edge_load > 0.0 else np.zeros(1)

    def pressure(x: Array) -> Array:
        t = np.minimum(x / c, 1.0)
        before, now, total = np.zeros(t.shape), np.ones(t.shape), np.zeros(t.shape)  # sin(n angle) / sin(angle)
        for mode in modes.T[1:]:
            total += mode[:, None] * now**2
            before, now = now, 2.0 * t * now - before
        found = np.sum(weights * np.sqrt((1.0 - t) * (1.0 + t)) * total, axis=0)
        if edge_load > 0.0:
            found += edge_load * pressure_of_modes(punch, last, x, float(np.sum(punch)))
        return np.asarray(found)

    return pressure


def layered_approaches(line: LayeredLineFoundation, edges: Array, sunk: Array, places: tuple[Place, Place]) -> Array:
    """Return how far two points have come together at every moment ``(m,)`` [m], one in each body.

    Parameters
    ----------
    line : LayeredLineFoundation
        The elastic layers.
    edges : ndarray, (n,)
        Half-widths c of strips, ascending from zero [m].
    sunk : ndarray, (m, n)
        Loads that, borne by wider strips, sink elastic layers as they have sunk by now [N/m].
    places : tuple
        As of `winkler.problems.line.approach.approach`.
    """
    kinks = [c for c, _ in line.kinks if edges[0] < c < edges[-1]]
    ends = np.log(np.array([max(float(edges[0]), 0.5 * float(edges[1])), *kinks, float(edges[-1])]))

    def approach(c: float) -> float:
        return layered_approach(line, c, 0.0, *places)

    def curve(x: Array) -> Array:
        return np.reshape([approach(c) for c in np.exp(x).ravel().tolist()], x.shape)

    smooth = fit_panels(curve, ends, TOLERANCE * abs(approach(float(edges[-1]))))
    nearer = np.append(0.0 if edges[0] == 0.0 else approach(float(edges[0])), smooth(np.log(edges[1:])))
    found = shares_of(line, edges, sunk) @ np.diff(nearer)
    if np.any(sunk[:, -1] != 0.0):
        last, load = float(edges[-1]), float(line.load_profile(edges[-1:])[0])
        punch = (layered_approach(line, last, load, *places) - nearer[-1]) / (load * line.medium.modulus)
        found = found + punch * sunk[:, -1]
    return np.asarray(found)
