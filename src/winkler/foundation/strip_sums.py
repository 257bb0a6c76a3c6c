"""What layers add to strips of many half-widths: solved one by one and kept, or read from polynomials over octaves.

A bed is a `winkler.foundation.layered_line.LayeredLineFoundation`.
"""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.transforms.cosine_transform import has_tail, in_own_lengths
from winkler.numerics.transforms.strips.strip_equation import StripResponse
from winkler.numerics.types import Array, Curve
from winkler.values.errors import NotConverged, OutsideValidity

WIDEST = 1024.0
"""Greatest half-width over the thickness of the uppermost layer."""
MOST_KEPT = 16384
"""Half-widths whose modes are kept of one bed."""
MANY, FEWEST, MOST_FITTED, FITTED = 64, 8, 4, 1e-12
"""Half-widths, of all and in an octave, up to which each is solved by itself; polynomials in an octave, their error."""


def edge_fall(modes: Array, half_width: Array) -> Array:
    """Return how steeply loads of modes ``(a, n)`` fall at the edges of strips, over a flat punch of one [1/m]."""
    return np.asarray(2.0 / half_width * (modes @ np.arange(modes.shape[1]) ** 2))


def added_sums(bed: Any, half_width: Array) -> Array:
    """Return what the layers add to the load over E* [m], how steeply that ends [-], and the edges of flat punches.

    Of more than a few half-widths they are read from polynomials over octaves of half-widths, ``(3, m)``.
    """
    if half_width.size <= MANY:
        return _direct(bed, half_width)
    ratio, known = half_width / bed.medium.response.smooth, _octaves(bed.alike)
    number = np.floor(np.log2(ratio)).astype(int)
    found, own = np.empty((3, half_width.size)), bed.half_plane.load_profile(half_width)
    for octave in np.unique(number).tolist():
        (at,) = np.nonzero(number == octave)
        if octave not in known and at.size > FEWEST:
            known[octave] = _octave(bed, octave)
        fitted = known.get(octave)
        if fitted is None or np.any(ratio[at] > fitted[0]):
            found[:, at] = _direct(bed, half_width[at])
        else:
            found[:, at] = [each(np.log(ratio[at])) for each in fitted[1]]
            found[:2, at] *= own[at] / np.array([np.ones(at.size), half_width[at]])
    return found


def _direct(bed: Any, half_width: Array) -> Array:
    found = added_responses(bed, half_width)
    return np.array([found.closing[:, 0], edge_fall(found.closing, half_width), np.sum(found.punch, axis=1)])


@functools.lru_cache(maxsize=16)
def _octaves(alike: tuple[object, ...]) -> dict[int, tuple[float, tuple[Panels, ...]] | None]:
    """Return the polynomials of beds that are alike; it fills itself."""
    return {}


def _octave(bed: Any, octave: int) -> tuple[float, tuple[Panels, ...]] | None:
    """Return up to which half-width over the shortest length polynomials hold, and those of `added_sums`.

    They are over ln a, the first of the load over w(a), the second over w(a)/a.  None where more of them would be
    needed than what is read from them is worth.
    """
    unit, low = bed.medium.response.smooth, 2.0**octave
    high = min(2.0 * low, min(bed.reach, bed.rim, WIDEST * bed.layered_body.unit[1]) / unit)
    if not (low < high and float(bed.half_plane.load_profile(np.array([low * unit]))[0]) > 0.0):
        return None
    cuts = np.log([low, *(b / unit for b, _ in bed.kinks if low < b / unit < high), high])

    def sums(place: Array) -> Array:
        a = unit * np.exp(place.ravel())
        own = bed.half_plane.load_profile(a)
        return np.asarray(_direct(bed, a) / np.array([own, own / a, np.ones(a.size)]))

    def one(row: int) -> Curve:
        return lambda x: sums(x)[row].reshape(x.shape)

    size = np.maximum(np.max(np.abs(sums(cuts)), axis=1), 1.0)
    try:
        return high, tuple(fit_panels(one(row), cuts, FITTED * size[row], MOST_FITTED) for row in range(3))
    except NotConverged:
        return None


@functools.lru_cache(maxsize=16)
def _kept(alike: tuple[object, ...]) -> dict[float, tuple[Array, Array]]:
    """Return the responses of the last half-widths over the unit of length under beds that are alike; it fills itself.

    What closes a strip is kept over the load of the half-plane.
    """
    return {}


def added_responses(bed: Any, half_width: Array) -> StripResponse:
    """Return what the layers add under strips of these half-widths; those solved before are kept."""
    response, top = bed.medium.response, bed.layered_body.unit[1]
    kept, unit = _kept(bed.alike), in_own_lengths(response)[1]
    places, own = (half_width / unit).tolist(), bed.half_plane.load_profile(half_width)
    own = np.where(own != 0.0, own, 1.0)
    unknown = {ratio: at for at, ratio in enumerate(places) if ratio not in kept}
    if unknown:
        if len(kept) > MOST_KEPT:
            kept.clear()
            unknown = {ratio: at for at, ratio in enumerate(places)}
        ratios = sorted(unknown)
        at = [unknown[ratio] for ratio in ratios]
        missing = half_width[at]
        if not has_tail(response) and missing[-1] > WIDEST * top:
            raise OutsideValidity(
                f"LayeredLineFoundation: a strip of the half-width {missing[-1]:.6g} m is more than {WIDEST:.0f} times "
                f"as wide as the uppermost layer is thick ({top:.6g} m); press less, or leave so thin a layer out."
            )
        solved = bed.solved(missing)
        kept.update(zip(ratios, zip(solved.closing / own[at, None], solved.punch, strict=True), strict=True))
    rows = [kept[ratio] for ratio in places]
    result = StripResponse(*np.zeros((2, len(rows), max(closing.size for closing, _ in rows))))
    for place, (closing, punch) in enumerate(rows):
        result.closing[place, : closing.size], result.punch[place, : punch.size] = own[place] * closing, punch
    return result
