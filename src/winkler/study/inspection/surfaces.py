"""Height maps and line scans of files: their statistics, and what to know of them."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

from winkler.io.surfaces.surface_container import is_container, measurement_names
from winkler.io.tables.scan_table import is_scan, read_scan
from winkler.profiles.rough.line_scan import LineScan
from winkler.profiles.rough.map_notes import map_notes
from winkler.profiles.rough.map_statistics import MapStatistics, bearing_heights, map_statistics
from winkler.profiles.rough.plausibility import doubts_of_surface
from winkler.profiles.rough.topography import Topography
from winkler.study.chapters.surfaces import read_surface
from winkler.study.inspection.inspection import InspectedNumber
from winkler.values.errors import InvalidInput
from winkler.values.units import quantity
from winkler.values.vocabulary import word

SHARES = (0.1, 0.5, 0.9)
"""Of the bearing curve among the numbers."""
LARGE_TILT = 0.2
"""Part of the mean square height that is worth a remark."""
STEEP = 0.3
"""Root mean square slope of a scan above which one unit for places and heights is worth a remark."""


class SurfaceOptions(NamedTuple):
    """How a map or a scan is read and prepared, as the command line gives it."""

    unit: str = ""
    lengths: str = ""
    channel: str = ""
    periodic: bool = False
    tip_radius: str = ""
    without_spikes: bool = False
    detrend: str = "none"
    levelled: str = "none"
    lines_along: str = "x"


class SurfaceRead(NamedTuple):
    """A map with its statistics, or a scan; and what is doubtful."""

    surface: Topography | LineScan
    statistics: MapStatistics | LineScan
    numbers: tuple[InspectedNumber, ...]
    doubts: tuple[str, ...]


def read_surface_file(path: Path, options: SurfaceOptions) -> SurfaceRead:
    """Return the map or the scan of a file.

    Raises
    ------
    InvalidInput
        If it holds neither, or a unit or length is missing.
    """
    try:
        rough = _map(path, options)
    except InvalidInput as reason:
        try:
            sides = _lengths(options)
            given = sides[0] if len(sides) == 1 and not is_scan(path) else 0.0
            scan = read_scan(path, unit=options.unit, channel=options.channel, length=given)
        except InvalidInput as other:
            raise (other if "is no map" in str(reason) or _names_scan(path) else reason) from None
        whole = scan.missing + scan.heights.size
        remarks = [f"Missing: {scan.missing} of {whole} heights, left out."] if scan.missing else []
        length = float(scan.position[-1] - scan.position[0])
        doubted = doubts_of_surface(scan.heights, scan.rms_slope, (length,))
        if not given and options.unit and "," not in options.unit and scan.rms_slope > STEEP and not doubted:
            doubted = (
                f"Doubtful: places and heights were both read in {options.unit}, and the root mean square slope is "
                f"{scan.rms_slope:.2g}; if the places are in mm, give --unit 'mm, {options.unit}'.",
            )
        doubts = (*_container(path), *remarks, *doubted)
        return SurfaceRead(scan, scan, _numbers(scan), doubts)
    statistics = map_statistics(rough)
    doubts = (*_container(path), *_map_doubts(rough, statistics, options))
    return SurfaceRead(rough, statistics, _numbers(statistics), doubts)


def _container(path: Path) -> tuple[str, ...]:
    if not is_container(path):
        return ()
    return (f"The container holds {', '.join(measurement_names(path))}; select one by --channel.",)


def _map_doubts(rough: Topography, statistics: MapStatistics, options: SurfaceOptions) -> list[str]:
    spikes = "" if options.without_spikes else str(rough.spikes())
    remarks = [f"Missing: {rough.missing} of {rough.heights.size} heights."] if rough.missing else []
    if spikes not in ("", "no spikes"):
        remarks.append(f"Spikes: {spikes}; --without-spikes removes them.")
    if not rough.periodic and options.detrend == "none" and rough.rms_height > 0.0:
        tilted = 1.0 - (rough.detrended(1).rms_height / rough.rms_height) ** 2
        if tilted > LARGE_TILT:
            remarks.append(f"A plane makes up {tilted:.0%} of the mean square height; --detrend plane subtracts it.")
    remarks += doubts_of_surface(rough.heights, statistics.rms_slope, tuple(rough.lengths))
    return [*remarks, *(note.statement for note in map_notes(rough))]


def _names_scan(path: Path) -> bool:
    try:
        return path.suffix.lower() in {".csv", ".txt"} and is_scan(path)
    except InvalidInput:
        return False


def _map(path: Path, options: SurfaceOptions) -> Topography:
    sides = _lengths(options)
    both = np.array(sides if len(sides) == 2 else 2 * sides) if sides else np.full(2, np.nan)
    return read_surface(
        path, lengths=both, unit=options.unit, periodic=options.periodic, channel=options.channel,
        tip_radius=quantity(options.tip_radius, "m", what="--tip-radius") if options.tip_radius else 0.0,
        without_spikes=options.without_spikes, levelled=options.levelled,
        scan_lines_along=options.lines_along, detrend=options.detrend, filled=options.without_spikes,
    )  # fmt: skip


def _lengths(options: SurfaceOptions) -> list[float]:
    sides = [quantity(side.strip(), "m", what="--lengths") for side in options.lengths.split(",") if side.strip()]
    if len(sides) > 2:
        raise InvalidInput(f"--lengths are {options.lengths!r}; give one or two, such as '10 um, 5 um'.")
    return sides


def _numbers(found: MapStatistics | LineScan) -> tuple[InspectedNumber, ...]:
    """Return the statistics, and of a map its bearing curve at three heights."""
    rows = []
    for name in type(found).__words__:
        entry, number = word(type(found), name), getattr(found, name)
        known = name != "tip_limit" or (not isinstance(found, LineScan) and found.topography.tip_radius > 0.0)
        if isinstance(number, float) and known:
            rows.append(InspectedNumber(name, entry.symbol, number, entry.unit or "", entry.meaning))
    if not isinstance(found, LineScan):
        for share, height in zip(SHARES, bearing_heights(found.topography, SHARES).tolist(), strict=True):
            meaning = f"height above the mean above which {share:.0%} of the map lies"
            name = f"bearing_height_{share:.0%}".rstrip("%")
            rows.append(InspectedNumber(name, f"z({share:.0%})", height, "m", meaning))
    return tuple(rows)
