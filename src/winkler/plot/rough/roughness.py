"""Rough surfaces: maps with their colour bars, cuts through them, power spectra; and what is drawn over a load."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from winkler.plot import style
from winkler.plot.draw import draw
from winkler.plot.families import spans_decades, stretch
from winkler.plot.series import Series, middle_scale, scale_of, series, told
from winkler.plot.viscoelastic.contacts import refuse_extent
from winkler.profiles.rough.map_spectrum import spectrum_of
from winkler.profiles.rough.spectrum import PowerSpectrum, SelfAffine, Spectrum
from winkler.profiles.rough.topography import Topography

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from winkler.numerics.types import Array
    from winkler.plot.picture import Picture

__all__ = ["Band", "draw_map", "draw_models", "draw_spectrum", "heights_of", "spectrum_sheet", "topography_sheet"]

SHOWN = 512
"""Pixels along a side of a picture; larger maps are shown with means."""
WAVES = 300
FEW_PIXELS = 0.002
"""Part of the pixels that may lie far beyond the colours: a pit, a spike."""
FADED = 1e-14
"""Part of the greatest density below which nothing but the window of the transform is left."""
FEW = 40
WIDER = 3.0
"""Logarithmic axes show so many times more than the models."""


def _fewer(content: Array) -> Array:
    """Return a map with means over blocks, small enough for a picture."""
    times = max(1, -(-max(content.shape) // SHOWN))
    if times == 1:
        return content
    nx, ny = (n // times for n in content.shape)
    blocks = content[: nx * times, : ny * times].reshape(nx, times, ny, times)
    counted = np.isfinite(blocks)
    sums = np.where(counted, blocks, 0.0).sum(axis=(1, 3))
    number = counted.sum(axis=(1, 3))
    return np.where(number > 0, sums / np.maximum(number, 1), np.nan)


def _limits(known: Array) -> tuple[float, float, str]:
    """Return between which numbers colours change, and which ends of them a few pixels lie beyond."""
    if not known.size:
        return 0.0, 1.0, "neither"
    ends = float(known.min()), float(known.max())
    low, high = (float(part) for part in np.quantile(known, (FEW_PIXELS, 1.0 - FEW_PIXELS)))
    wide = high - low
    deep, steep = low - ends[0] > wide, ends[1] - high > wide
    beyond = {(True, True): "both", (True, False): "min", (False, True): "max"}.get((deep, steep), "neither")
    return low if deep else ends[0], high if steep else ends[1], beyond


def draw_map(axes: Axes, item: Topography, of: Series, colours: Any, *, label: str = "", lowest: float = 0.0) -> None:
    """Draw one quantity over the pixels of a map, with a colour bar.

    Parameters
    ----------
    axes : Axes
        Empty.
    item : Topography
        Tells the size of the pixels.
    of : Series
        The quantity; white where it is not known.
    colours : Colormap
    label : str
        Of the colour bar, without a unit; the name of the quantity if empty.
    lowest : float
        Where the colours begin, if nothing is lower.
    """
    across = scale_of("m", item.lengths)
    upright = of.scale
    shown = _fewer(of.content) / upright.factor
    low, high, beyond = _limits(shown[np.isfinite(shown)])
    image = axes.imshow(
        shown.T,
        origin="lower",
        extent=(0.0, float(item.lengths[0]) / across.factor, 0.0, float(item.lengths[1]) / across.factor),
        cmap=colours,
        interpolation="nearest",
        vmin=min(lowest, low),
        vmax=high,
    )
    axes.grid(visible=False)
    for side in ("top", "right"):
        axes.spines[side].set_visible(True)
    axes.set_xlabel(f"$x$ [{across.unit}]")
    axes.set_ylabel(f"$y$ [{across.unit}]")
    bar = axes.figure.colorbar(image, ax=axes, shrink=0.9, pad=0.02, extend=beyond)
    bar.outline.set_visible(False)
    bar.set_label(f"{label} [{upright.unit}]" if label else of.label(upright))


def heights_of(item: Topography) -> Series:
    """Return the heights above their mean."""
    return series("Topography", "heights", item.heights - np.nanmean(item.heights))


def draw_cuts(axes: Axes, item: Topography) -> None:
    """Draw the heights along two lines through the middle of a map."""
    of = heights_of(item)
    nx, ny = of.content.shape
    across = scale_of("m", item.lengths)
    lines = (("along $x$", of.content[:, ny // 2], 0), ("along $y$", of.content[nx // 2], 1))
    for place, (name, line, axis) in enumerate(lines):
        step = item.pixel[axis] / across.factor
        axes.plot(
            (np.arange(line.size) + 0.5) * step,
            line / of.scale.factor,
            color=style.CYCLE[place],
            linestyle=style.DASHES[place],
            linewidth=1.2,
            label=name,
        )
    axes.margins(x=0.0, y=0.25)
    axes.set_xlabel(f"place [{across.unit}]")
    axes.set_ylabel(f"height ${of.word.symbol}$ [{of.scale.unit}]")
    style.framed_legend(axes, loc="upper right", ncols=2)


def draw_spectrum(axes: Axes, spectra: Sequence[tuple[Spectrum, str]]) -> None:
    """Draw power spectra over the wave number, both logarithmic; of several each with a name."""
    for place, (spectrum, name) in enumerate(spectra):
        measured = isinstance(spectrum, PowerSpectrum)
        q: Array = np.geomspace(spectrum.smallest, spectrum.greatest, WAVES)
        if isinstance(spectrum, PowerSpectrum):
            q = spectrum.wave_numbers
        along, of = series("PowerSpectrum", "wave_numbers", q), series("PowerSpectrum", "densities", spectrum.at(q))
        axes.plot(
            along.content,
            of.content,
            color=style.CYCLE[place],
            linestyle=style.DASHES[place % len(style.DASHES)],
            marker="o" if measured and q.size <= WAVES else "",
            markersize=3.0,
            label=name or None,
        )
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.margins(x=0.05, y=0.08)
    most = max(float(line.get_ydata().max()) for line in axes.lines)  # type: ignore[union-attr]
    axes.set_ylim(max(axes.get_ylim()[0], FADED * most), None)
    axes.set_xlabel("wave number $q$ [1/m]")
    axes.set_ylabel("spectral density $C$ [m⁴]")
    if any(name for _, name in spectra):
        style.framed_legend(axes, loc="lower left")


def told_of(item: Topography) -> str:
    """Return what a map is, in one line."""
    nx, ny = item.heights.shape
    parts = [
        f"{nx} × {ny} pixels of {told(item.pixel[0], 'm', 3)} × {told(item.pixel[1], 'm', 3)}",
        f"height {told(item.rms_height, 'm', 3)} and slope {item.rms_slope:.2g} (root mean squares)",
    ]
    if item.missing:
        parts.append(f"{item.missing} missing")
    return ";  ".join(parts)


@draw.register(Topography)
def topography_sheet(item: Topography, *, extent: float | None = None) -> Picture:
    """Return a height map, two cuts through it, and its power spectrum."""
    refuse_extent(item, extent)
    rough = item.rms_height > 0.0 and not item.missing and min(item.heights.shape) >= 8
    with style.styled():
        figure = style.figure(3 if rough else 2, width=4.0, height=3.3)
        panels = figure.subplots(1, 3 if rough else 2)
        draw_map(panels[0], item, heights_of(item), style.reliefs(), label="height $z$", lowest=np.inf)
        panels[0].set_title("heights")
        draw_cuts(panels[1], item)
        panels[1].set_title("cuts through the middle")
        if rough:
            draw_spectrum(panels[2], [(spectrum_of(item), "")])
            panels[2].set_title("power spectrum, all directions")
        figure.suptitle(told_of(item))
    return figure


@draw.register(SelfAffine)
@draw.register(PowerSpectrum)
def spectrum_sheet(item: Spectrum, *, extent: float | None = None) -> Picture:
    """Return a power spectrum."""
    refuse_extent(item, extent)
    with style.styled():
        figure = style.figure(width=4.8, height=3.3)
        axes: Any = figure.subplots()
        draw_spectrum(axes, [(item, "")])
        axes.set_title("power spectrum")
        style.note(axes, f"slope {item.rms_slope:.3g} (root mean square)")
    return figure


class Band(NamedTuple):
    """What is shaded between two curves."""

    low: Array
    high: Array
    name: str
    colour: str


def draw_models(
    axes: Axes,
    along: Series,
    lines: Sequence[tuple[Series, str]],
    bands: Sequence[Band] = (),
    *,
    label: str = "",
) -> None:
    """Draw what several models say of one quantity, and between which bounds.

    Parameters
    ----------
    axes : Axes
        Empty.
    along : Series
        What they are drawn over; in any order.
    lines : sequence of (Series, str)
        One curve for each model, and its name; empty for a single one.
    bands : sequence of Band
    label : str
        Of the upright axis, without a unit; the name of the first quantity if empty.
    """
    order = np.argsort(along.content, kind="stable")
    contents = np.concatenate([of.content for of, _ in lines])
    steep = spans_decades(along.content)
    steeper = steep and (spans_decades(contents) or (bool(bands) and bool(np.min(contents) > 0.0)))
    first = lines[0][0]
    across = middle_scale(along.word.unit, along.content) if steep else along.scale
    upright = (middle_scale if steeper else scale_of)(first.word.unit, contents)
    x = along.shown(across)[order]
    for band in bands:
        low, high = (part[order] / upright.factor for part in (band.low, band.high))
        axes.fill_between(x, low, high, color=band.colour, alpha=0.2, linewidth=0.0, label=band.name)
    for place, (of, name) in enumerate(lines):
        axes.plot(
            x,
            of.shown(upright)[order],
            color=style.CYCLE[place],
            linestyle=style.DASHES[place % len(style.DASHES)],
            marker="o" if order.size <= FEW else "",
            markersize=4.0,
            label=name or None,
        )
    axes.margins(x=0.04, y=0.08)
    if steeper:  # bounds may lie far off, or be infinite
        least, most = float(np.min(contents[contents > 0.0])), float(np.max(contents[np.isfinite(contents)]))
        axes.set_ylim(least / upright.factor / WIDER, most / upright.factor * WIDER)
    else:
        shaded = [band.high[np.isfinite(band.high)] for band in bands]
        most = float(np.max(contents[np.isfinite(contents)]))
        top = max([most, *(float(np.max(part)) for part in shaded if part.size and np.max(part) < WIDER * most)])
        axes.set_ylim(0.0, 1.15 * top / upright.factor)
    for axis, decades in ((axes.xaxis, steep), (axes.yaxis, steeper)):
        if decades:
            stretch(axes, axis)
    axes.set_xlabel(along.label(across))
    axes.set_ylabel(f"{label} [{upright.unit}]" if label and upright.unit else label or first.label(upright))
    if axes.get_legend_handles_labels()[1]:
        style.framed_legend(axes, loc="best")
