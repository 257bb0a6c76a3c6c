r"""Line sources that stand for round sources of heat: from the load of the springs, or from a flux over the radius."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from winkler.numerics.fields.line_source import TOLERANCE, LineSource
from winkler.numerics.fields.source_tables import cosine_rule
from winkler.numerics.panels.chebyshev import fit_panels
from winkler.numerics.panels.cosine_pieces import cosine_places, pieces_of, place_on
from winkler.numerics.types import Array, Curve

FLUX_TOLERANCE = 1e-10
"""Of the flux times sqrt(a^2 - r^2), relative to the greatest."""
FLUX_NODES = 48


def line_source(load: Curve, joints: Sequence[float], radius: float) -> LineSource:
    """Return the source of a line load.

    Parameters
    ----------
    load
        q(x) [W/m] for 0 <= x <= a; it may start or end like a square root at every joint and at a.
    joints
        Where it is not smooth [m].
    radius
        a [m].

    Raises
    ------
    NotConverged
        If it is too rough.
    """
    ends = pieces_of(joints, radius)

    def cosine_part(place: Array) -> Array:
        return load(radius * place_on(place, ends))

    scale = float(np.max(np.abs(cosine_part(np.linspace(0.0, ends.size - 1.0, 64 * ends.size)))))
    curve = fit_panels(lambda place: cosine_part(place) / scale, np.arange(ends.size, dtype=float), TOLERANCE)
    return LineSource(radius, scale, ends, curve)


def projected(flux: Curve, joints: Sequence[float], radius: float) -> LineSource:
    """Return the source of a flux p(r) [W/m^2] that ends at `radius`, by T5: its line load.

    With r^2 = x^2 + (a^2 - x^2) sin(phi)^2 that is the integral of 2 sqrt(a^2 - r^2) p(r) over phi: nothing diverges at
    the edge, however the flux ends there.
    """
    ends = pieces_of(joints, radius)
    inner = ends[1:-1]

    def lowered(place: Array) -> Array:
        part = np.clip(place_on(place, ends), 0.0, 1.0 - 1e-15)
        return np.asarray(np.sqrt((1.0 - part) * (1.0 + part)) * flux(radius * part))

    scale = float(np.max(np.abs(lowered(np.linspace(0.0, ends.size - 1.0, 64 * ends.size)[1:-1]))))
    table = fit_panels(lambda place: lowered(place) / scale, np.arange(ends.size, dtype=float), FLUX_TOLERANCE)
    node, weight = cosine_rule(FLUX_NODES)

    def load(x: Array) -> Array:
        part = np.ravel(x)[:, None] / radius
        chord = np.sqrt(np.maximum((1.0 - part) * (1.0 + part), np.finfo(float).tiny))
        turns = np.arcsin(np.clip(np.sqrt(np.maximum(inner**2 - part**2, 0.0)) / chord, 0.0, 1.0))
        cuts = np.concatenate([np.zeros(part.shape), turns, np.full(part.shape, 0.5 * np.pi)], axis=1)
        width = np.diff(cuts)[..., None]
        r = np.hypot(part[..., None], chord[..., None] * np.sin(cuts[:, :-1, None] + width * node))
        values = table(cosine_places(np.minimum(r, 1.0), ends))
        return np.asarray(2.0 * scale * radius * np.sum(values * width * weight, axis=(1, 2)).reshape(np.shape(x)))

    return line_source(load, joints, radius)
