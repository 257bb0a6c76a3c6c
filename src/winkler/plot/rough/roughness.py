"""Rough surfaces: maps with colour bars, sections, power spectra; and curves of several models over a load."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Map, Panel, PanelAxis, Sheet, among, note, plane
from winkler.plot.series import Series, scale_of, series, with_unit
from winkler.profiles.rough.map_spectrum import spectrum_of
from winkler.profiles.rough.spectrum import PowerSpectrum, SelfAffine, Spectrum
from winkler.profiles.rough.topography import Topography
from winkler.values.vocabulary import Word

MOST_PIXELS = 512
"""Most pixels along a side; larger maps are averaged over blocks."""
WAVE_NUMBERS_DRAWN = 300
CLIPPED_SHARE = 0.002
"""Part of the pixels that may lie beyond the range of colours, as pits and spikes."""
LEAST_DENSITY_SHARE = 1e-10
"""Relative spectral density below which only leakage of the window is left, which is not drawn."""


def _block_means(content: Array) -> Array:
    """Return a map reduced by means over blocks."""
    times = max(1, -(-max(content.shape) // MOST_PIXELS))
    if times == 1:
        return content
    nx, ny = (n // times for n in content.shape)
    blocks = content[: nx * times, : ny * times].reshape(nx, times, ny, times)
    counted = np.isfinite(blocks)
    sums = np.where(counted, blocks, 0.0).sum(axis=(1, 3))
    number = counted.sum(axis=(1, 3))
    return np.where(number > 0, sums / np.maximum(number, 1), np.nan)


def _limits(finite: Array) -> tuple[float, float, str]:
    """Return the range of colours, and the ends beyond which a few pixels lie."""
    if not finite.size:
        return 0.0, 1.0, "neither"
    ends = float(finite.min()), float(finite.max())
    low, high = (float(part) for part in np.quantile(finite, (CLIPPED_SHARE, 1.0 - CLIPPED_SHARE)))
    wide = high - low
    deep, clips_high = low - ends[0] > wide, ends[1] - high > wide
    beyond = {(True, True): "both", (True, False): "min", (False, True): "max"}.get((deep, clips_high), "neither")
    return low if deep else ends[0], high if clips_high else ends[1], beyond


def image_of(of: Series, colours: Any, ends: Sequence[Array], *, label: str = "", lowest: float = 0.0) -> Map:
    """Return one quantity over the pixels of a map, with a colour bar.

    Parameters
    ----------
    of : Series
        The quantity ``(n, m)``; white where it is undefined.
    colours : str or tuple of str
    ends : pair of ndarray
        First and last edge of the pixels along x and along y [m].
    label : str
        Of the colour bar, without a unit; the name of the quantity if empty.
    lowest : float
        Lower end of the colours, unless a value is lower.
    """
    reduced = _block_means(of.content)
    low, high, beyond = _limits(reduced[np.isfinite(reduced)])
    limits: dict[str, Any] = {"low": min(lowest, low), "high": high}
    bar = PanelAxis(label, of.scale, **limits) if label else PanelAxis.of(of, **limits)
    return Map(ends[0], ends[1], reduced, bar, kind="pixels", colours=colours, extend=beyond, shrink=0.9, pad=0.02)


def sides_of(item: Topography) -> tuple[Array, Array]:
    """Return the ends of a map along x and along y [m]."""
    x, y = (np.array([0.0, float(length)]) for length in item.lengths)
    return x, y


def map_panel(item: Topography, of: Series, colours: Any, **more: Any) -> Panel:
    """Return one quantity over a map, in its frame; parameters as for `image_of`."""
    return framed(image_of(of, colours, sides_of(item), **more))


def framed(image: Map) -> Panel:
    """Return an image in a closed frame with equal axes."""
    return Panel((image,), *plane(scale_of("m", image.x, image.y)), equal=True, grid="", boxed=True)


def heights_of(item: Topography) -> Series:
    """Return the heights above their mean."""
    return series("heights", item.heights - np.nanmean(item.heights))


def share_of_map(area: ArrayLike, item: Topography) -> Series:
    """Return contact areas in per cent of a map."""
    part = 100.0 * np.ravel(np.asarray(area, dtype=float)) / item.area
    return Series("part of the map in contact [%]", Word("", "", "part of the map in contact"), part)


def cuts_panel(item: Topography) -> Panel:
    """Return the heights along two lines through the middle of a map."""
    of = heights_of(item)
    nx, ny = of.content.shape
    lines = [
        among(axis, (np.arange(line.size) + 0.5) * float(item.pixel[axis]), line, name, most=0, width=1.2)
        for name, line, axis in (("along $x$", of.content[:, ny // 2], 0), ("along $y$", of.content[nx // 2], 1))
    ]
    across = PanelAxis("place", scale_of("m", item.lengths), margin=0.0)
    upright = PanelAxis(f"height ${of.word.symbol}$", of.scale, margin=0.25)
    return Panel(tuple(lines), across, upright, legend="upper right", columns=2)


def spectrum_panel(spectra: Sequence[tuple[Spectrum, str]]) -> Panel:
    """Return power spectra over the wave number, both logarithmic; of several each with a name."""
    lines = []
    for place, (spectrum, name) in enumerate(spectra):
        measured = isinstance(spectrum, PowerSpectrum)
        q: Array = np.geomspace(spectrum.smallest, spectrum.greatest, WAVE_NUMBERS_DRAWN)
        if isinstance(spectrum, PowerSpectrum):
            q = spectrum.wave_numbers
        lines.append(among(place, q, spectrum.at(q), name, most=WAVE_NUMBERS_DRAWN if measured else 0, size=3.0))
    floor = LEAST_DENSITY_SHARE * max(float(np.max(line.y)) for line in lines)
    lines = [dataclasses.replace(line, y=np.where(line.y >= floor, line.y, np.nan)) for line in lines]
    across = PanelAxis("wave number $q$ [1/m]", margin=0.05, log=True)
    upright = PanelAxis("spectral density $C$ [m⁴]", margin=0.08, log=True)
    return Panel(tuple(lines), across, upright, legend="lower left")


def _map_text(item: Topography) -> str:
    """Return a description of a map in one line."""
    nx, ny = item.heights.shape
    parts = [
        f"{nx} × {ny} pixels of {with_unit(item.pixel[0], 'm', 3)} × {with_unit(item.pixel[1], 'm', 3)}",
        f"height {with_unit(item.rms_height, 'm', 3)} and slope {item.rms_slope:.2g} (root mean squares)",
    ]
    if item.missing:
        parts.append(f"{item.missing} missing")
    return ";  ".join(parts)


@without_extent(Topography)
def topography_sheet(item: Topography) -> Sheet:
    """Return a height map, two cuts through it, and its power spectrum."""
    rough = item.rms_height > 0.0 and not item.missing and min(item.heights.shape) >= 8
    heights = map_panel(item, heights_of(item), style.RELIEFS, label="height $z$", lowest=np.inf)
    panels = [heights.plus(title="heights"), cuts_panel(item).plus(title="cuts through the middle")]
    if rough:
        panels.append(spectrum_panel([(spectrum_of(item), "")]).plus(title="power spectrum, all directions"))
    return Sheet(tuple(panels), width=4.0, height=3.3, title=_map_text(item))


@without_extent(SelfAffine, PowerSpectrum)
def spectrum_sheet(item: Spectrum) -> Sheet:
    """Return a power spectrum."""
    slope = note(f"slope {item.rms_slope:.3g} (root mean square)")
    return Sheet((spectrum_panel([(item, "")]).plus(slope, title="power spectrum"),), width=4.8, height=3.3)
