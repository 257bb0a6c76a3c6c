"""The sheet of a map's statistics: heights, cuts, bearing curve, autocorrelation, spectrum and curvature."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.transforms.autocorrelation import autocorrelation, rays
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Panel, PanelAxis, Rule, Sheet, among, note, titled, zero
from winkler.plot.rough.roughness import cuts_panel, heights_of, map_panel, spectrum_panel
from winkler.plot.series import Scale, scale_of, with_unit
from winkler.profiles.rough.correlation import CORRELATION_LEVEL
from winkler.profiles.rough.line_scan import LineScan
from winkler.profiles.rough.map_spectrum import spectrum_of
from winkler.profiles.rough.map_statistics import MapStatistics, bearing_heights
from winkler.profiles.rough.tip_limit import curvature_over_distance
from winkler.profiles.rough.topography import Topography

SHARES = np.linspace(0.0, 1.0, 201)
FARTHEST = 6.0
"""Distances of the autocorrelation that are drawn, in longest correlation lengths."""


def _bearing_panel(heights: Array, scale: Scale, of: str) -> Panel:
    """Return which part of a map or scan lies above a height."""
    across = PanelAxis(f"part of the {of} above [%]", low=0.0, high=100.0)
    upright = PanelAxis("height above the mean", scale, margin=0.06)
    return Panel((zero(), Line(100.0 * SHARES, heights, style.BLUE)), across, upright)


def _correlation_panel(item: MapStatistics) -> Panel:
    """Return the autocorrelation along and across the direction of its slowest fall."""
    rough = item.topography
    along = item.texture_direction
    angles = np.array([along, (along + 0.5 * math.pi) % math.pi])
    names = [f"{math.degrees(angle):.0f}° from $x$" for angle in angles]
    found = rays(autocorrelation(rough.heights, periodic=rough.periodic), rough.pixel, angles)
    lines, reach = [], 0.0
    for place, (name, (distance, ray)) in enumerate(zip(names, found, strict=True)):
        lines.append(among(place, distance, ray, name, most=0))
        reach = max(reach, float(distance[-1]))
    slowest = item.correlation_length / item.texture_aspect if item.texture_aspect > 0.0 else math.inf
    far = min(reach, FARTHEST * slowest)
    scale = scale_of("m", far)
    across = PanelAxis("distance", scale, low=0.0, high=far)
    marks = (*lines, zero(), Rule(CORRELATION_LEVEL, dash=(4.0, 3.0)))
    return Panel(marks, across, PanelAxis("autocorrelation", high=1.05), legend="upper right")


def _curvature_panel(item: Topography) -> Panel:
    """Return root mean square and sharpest curvature over the distance of second differences."""
    found = curvature_over_distance(item)
    sharp = np.where(found.sharpest > 0.0, found.sharpest, np.nan)
    marks: list[Line | Rule] = [
        among(0, found.distance, found.rms, "root mean square", most=0),
        among(1, found.distance, sharp, "sharpest summit", most=0),
    ]
    if item.tip_radius > 0.0:
        marks.append(Rule(0.5 / item.tip_radius, dash=(4.0, 3.0), name="half the curvature of the tip"))
    across = PanelAxis("distance", scale_of("m", found.distance), log=True, margin=0.04)
    return Panel(tuple(marks), across, PanelAxis("curvature [1/m]", log=True, margin=0.08), legend="lower left")


@without_extent(LineScan)
def scan_sheet(item: LineScan) -> Sheet:
    """Return the heights of a scan without their tilt, its bearing curve, and the spectrum of the surface behind it."""
    level = item.levelled
    scale = scale_of("m", level.heights)
    across = PanelAxis("place $x$", scale_of("m", level.position), margin=0.0)
    heights = PanelAxis("height $z$", scale, margin=0.06)
    panels = (
        Panel((zero(), Line(level.position, level.heights, style.BLUE, width=1.0)), across, heights),
        _bearing_panel(np.quantile(level.heights, 1.0 - SHARES), scale, "scan"),
        spectrum_panel([(item.spectrum, "")]),
    )
    sizes = [with_unit(size, "m", 3) for size in (item.arithmetic_height, item.rms_height)]
    title = (
        f"{level.heights.size} heights;  Ra {sizes[0]}, Rq {sizes[1]}, Rsk {item.skewness:.2g}, Rku {item.kurtosis:.3g}"
    )
    return Sheet(
        titled(panels, "heights without tilt", "bearing curve", "spectrum of an isotropic surface"), 3,
        width=4.0, height=3.3, title=title,
    )  # fmt: skip


@without_extent(MapStatistics)
def statistics_sheet(item: MapStatistics) -> Sheet:
    """Return a map with cuts, bearing curve, autocorrelation, spectrum and curvature over distance."""
    rough = item.topography
    spectrum = (
        Panel((note(f"no spectrum: {rough.missing} heights are missing"),))
        if rough.missing
        else spectrum_panel([(spectrum_of(rough), "")])
    )
    panels = (
        map_panel(rough, heights_of(rough), style.RELIEFS, label="height $z$", lowest=np.inf),
        cuts_panel(rough),
        _bearing_panel(bearing_heights(rough, SHARES), heights_of(rough).scale, "map"),
        _correlation_panel(item),
        spectrum,
        _curvature_panel(rough),
    )
    names = ("heights", "cuts through the middle", "bearing curve", "autocorrelation", "power spectrum", "curvature")
    nx, ny = rough.heights.shape
    sizes = [with_unit(size, "m", 3) for size in (item.arithmetic_height, item.rms_height, item.correlation_length)]
    title = (
        f"{nx} × {ny} pixels;  Sa {sizes[0]}, Sq {sizes[1]}, Ssk {item.skewness:.2g}, Sku {item.kurtosis:.3g}, "
        f"Sal {sizes[2]}"
    )
    return Sheet(titled(panels, *names), 3, width=4.0, height=3.3, title=title)
