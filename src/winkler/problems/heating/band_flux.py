"""Heat on a strip as a source, 1 W per length in all: in the shape of a line contact's pressure, or even."""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.numerics.fields.band_source import BandSource
from winkler.numerics.panels.chebyshev import fit_panels
from winkler.numerics.types import Array
from winkler.problems.line.indentation import LineSolution
from winkler.problems.line.peak_pressure import is_sharp, rim_load
from winkler.values.checks.number_checks import PositiveQuantity
from winkler.values.value import value

TABLE_TOLERANCE = 1e-13
"""Error of a tabulated flux over its mean."""


@value
class EvenBand:
    """A strip on which as much heat enters everywhere.

    Parameters
    ----------
    half_width : float or ndarray
        a [m].
    """

    half_width: PositiveQuantity


HeatedLine = LineSolution | EvenBand
"""Where heat enters: a line contact, in the shape of its pressure, or an even band."""


@functools.lru_cache(maxsize=64)
def band_source(bed: LineBed, force: float, half_width: float) -> BandSource:
    """Return the source of a line contact.

    Parameters
    ----------
    bed : LineBed
    force : float
        P [N/m], positive.
    half_width : float
        a [m].
    """
    if bed.hertzian:
        return BandSource(half_width, (), lambda angle: 2.0 / math.pi * np.cos(angle) ** 2)
    on_rim = rim_load(bed, force, half_width) * bed.medium.modulus / (math.pi * force)
    kinks = tuple(math.asin(b / half_width) for b, _ in bed.kinks if 0.0 < b < half_width)

    def flux(angle: Array) -> Array:
        # the pressure vanishes at the edge, where rounding must not carry the place beyond it
        x = np.minimum(half_width * np.sin(angle), np.nextafter(half_width, 0.0))
        smooth = bed.pressure(np.maximum(x, 1e-14 * half_width), half_width, 0.0)
        return np.asarray(on_rim + half_width * np.cos(angle) * smooth / force)

    if is_sharp(bed, half_width, 0.0):
        return BandSource(half_width, (0.0, *kinks), flux, on_rim > 0.0)
    table = fit_panels(flux, np.array([0.0, *kinks, 0.5 * math.pi]), TABLE_TOLERANCE)
    return BandSource(half_width, kinks, table, on_rim > 0.0)


def band_sources(heated: HeatedLine) -> list[BandSource | None]:
    """Return the source of each load or half-width; None where there is no contact."""
    if isinstance(heated, EvenBand):
        widths = np.ravel(heated.half_width)
        return [BandSource(float(a), (), lambda angle: 0.5 * np.cos(angle)) for a in widths]
    pairs = zip(np.ravel(heated.force_per_length), np.ravel(heated.half_width), strict=True)
    return [band_source(heated.problem.bed, float(p), float(a)) if p > 0.0 and a > 0.0 else None for p, a in pairs]
