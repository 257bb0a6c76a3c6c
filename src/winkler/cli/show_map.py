"""``winkler show MAP``: the statistics of a height map or a line scan, what to know of it, and its curves."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from winkler.cli.streams import until_closed, write_json, write_line

if TYPE_CHECKING:
    from winkler.profiles.rough.line_scan import LineScan
    from winkler.profiles.rough.map_statistics import MapStatistics
    from winkler.profiles.rough.topography import Topography

__all__ = ["MapOptions", "is_file", "show_map"]

SHARES = (0.1, 0.5, 0.9)
"""Of the bearing curve in the table."""
LARGE_TILT = 0.2
"""Part of the mean square height that is worth a remark."""


class MapOptions(NamedTuple):
    """How a file is read and prepared, as the command line gives it."""

    unit: str = ""
    lengths: str = ""
    channel: str = ""
    periodic: bool = False
    tip_radius: str = ""
    without_spikes: bool = False
    detrend: str = "none"
    levelled: str = "none"
    lines_along: str = "x"


def is_file(name: str) -> bool:
    """Return whether a name means a file: no kind, group or material has a dot or a slash."""
    return "." in name or "/" in name or "\\" in name


def show_map(path: Path, options: MapOptions, output: Path | None, *, as_json: bool, overwrite: bool) -> None:
    """Print the statistics of a file, and write its picture.

    Raises
    ------
    InvalidInput
        If the file holds neither a map nor a scan, or the picture cannot be written.
    """
    from winkler.cli.options import refuse_existing
    from winkler.errors import InvalidInput
    from winkler.io.surfaces.surface_container import is_container, measurement_names
    from winkler.study.language.study import PICTURES

    if output is not None:
        if output.suffix.lstrip(".").lower() not in PICTURES:
            endings = ", ".join(f".{ending}" for ending in PICTURES)
            raise InvalidInput(f"show: '{output}' does not end like a picture; give {endings}.")
        refuse_existing(output, overwrite, "show: ")
    found, remarks = _read(path, options)
    if path.is_file() and is_container(path):
        remarks.insert(0, f"The container holds {', '.join(measurement_names(path))}; --channel takes one of them.")
    rows = _rows(found)
    if as_json:
        write_json({"file": str(path), "statistics": rows, "remarks": remarks})
    else:
        _print(path, rows, remarks)
    if output is not None:
        _draw(found, output)
        if not as_json:
            write_line(f"Written {output}")


def _read(path: Path, options: MapOptions) -> tuple[MapStatistics | LineScan, list[str]]:
    """Return the statistics of a map, or a scan, and what to know of it."""
    from winkler.errors import InvalidInput
    from winkler.io.tables.scan_table import read_scan
    from winkler.profiles.rough.map_notes import map_notes
    from winkler.profiles.rough.map_statistics import map_statistics
    from winkler.profiles.rough.plausibility import doubts_of_surface

    try:
        rough = _map(path, options)
    except InvalidInput as reason:
        try:
            scan = read_scan(path, unit=options.unit, channel=options.channel)
            whole = scan.missing + scan.heights.size
            remarks = [f"Missing: {scan.missing} of {whole} heights, left out."] if scan.missing else []
            length = float(scan.position[-1] - scan.position[0])
            return scan, [*remarks, *doubts_of_surface(scan.heights, scan.rms_slope, (length,))]
        except InvalidInput as other:
            raise (other if "is no map" in str(reason) or _names_scan(path) else reason) from None
    spikes = "" if options.without_spikes else str(rough.spikes())
    remarks = [f"Missing: {rough.missing} of {rough.heights.size} heights."] if rough.missing else []
    if spikes not in ("", "no spikes"):
        remarks.append(f"Spikes: {spikes}; --without-spikes takes them out.")
    if not rough.periodic and options.detrend == "none" and rough.rms_height > 0.0:
        tilted = 1.0 - (rough.detrended(1).rms_height / rough.rms_height) ** 2
        if tilted > LARGE_TILT:
            remarks.append(f"A plane makes up {tilted:.0%} of the mean square height; --detrend plane takes it off.")
    statistics = map_statistics(rough)
    remarks += doubts_of_surface(rough.heights, statistics.rms_slope, tuple(rough.lengths))
    return statistics, [*remarks, *(note.statement for note in map_notes(rough))]


def _names_scan(path: Path) -> bool:
    from winkler.errors import InvalidInput
    from winkler.io.tables.scan_table import is_scan

    try:
        return path.suffix.lower() in {".csv", ".txt"} and is_scan(path)
    except InvalidInput:
        return False


def _map(path: Path, options: MapOptions) -> Topography:
    import numpy as np

    from winkler.errors import InvalidInput
    from winkler.study.chapters.surfaces import read_surface
    from winkler.units import quantity

    sides = [quantity(side.strip(), "m", what="--lengths") for side in options.lengths.split(",") if side.strip()]
    if len(sides) > 2:
        raise InvalidInput(f"--lengths are {options.lengths!r}; give one or two, such as '10 um, 5 um'.")
    both = np.array(sides if len(sides) == 2 else 2 * sides) if sides else np.full(2, np.nan)
    return read_surface(
        path, lengths=both, unit=options.unit, periodic=options.periodic, channel=options.channel,
        tip_radius=quantity(options.tip_radius, "m", what="--tip-radius") if options.tip_radius else 0.0,
        without_spikes=options.without_spikes, levelled=options.levelled,
        scan_lines_along=options.lines_along, detrend=options.detrend, filled=options.without_spikes,
    )  # fmt: skip


def _rows(found: MapStatistics | LineScan) -> dict[str, dict[str, Any]]:
    """Return the numbers by name, each with symbol, unit and meaning."""
    from winkler.profiles.rough.line_scan import LineScan
    from winkler.profiles.rough.map_statistics import bearing_heights
    from winkler.vocabulary import word

    rows: dict[str, dict[str, Any]] = {}
    for name in type(found).__words__:
        entry, number = word(type(found), name), getattr(found, name)
        known = name != "tip_limit" or (not isinstance(found, LineScan) and found.topography.tip_radius > 0.0)
        if isinstance(number, float) and known:
            rows[name] = {"symbol": entry.symbol, "value": number, "unit": entry.unit or "", "meaning": entry.meaning}
    if not isinstance(found, LineScan):
        for share, height in zip(SHARES, bearing_heights(found.topography, SHARES).tolist(), strict=True):
            meaning = f"height above the mean above which {share:.0%} of the map lies"
            rows[f"bearing_height_{share:.0%}".rstrip("%")] = {
                "symbol": f"z({share:.0%})", "value": height, "unit": "m", "meaning": meaning,
            }  # fmt: skip
    return rows


@until_closed()
def _print(path: Path, rows: dict[str, dict[str, Any]], remarks: list[str]) -> None:
    from winkler.cli import terminal
    from winkler.readable import with_unit
    from winkler.study.language.explain import plain_symbol

    out = terminal.console()
    out.print(path.name)
    table = terminal.table("symbol", "value", "meaning")
    for row in rows.values():
        table.add_row(plain_symbol(row["symbol"]), with_unit(row["value"], row["unit"]), row["meaning"])
    out.print(table)
    for remark in remarks:
        out.print(f"- {remark}", soft_wrap=True)


def _draw(found: MapStatistics | LineScan, output: Path) -> None:
    import io

    from winkler.io.whole_file import write_whole
    from winkler.plot import sheet_of
    from winkler.plot.render import render

    with io.BytesIO() as drawn:
        render(sheet_of(found)).savefig(drawn, format=output.suffix[1:].lower())
        write_whole({output: drawn.getvalue()})
