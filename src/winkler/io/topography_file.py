"""Height maps in files: of instruments through SurfaceTopography, or plain matrices as text, NPY and NPZ."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path
from typing import Any

import numpy as np

from winkler.io.foreign import in_file, reader
from winkler.io.height_matrix import MapContents, array_map, point_map, refuse_many, refuse_table, text_map
from winkler.io.maps.simple_field import is_simple_field, simple_field_map
from winkler.io.maps.triangle_mesh import mesh_map
from winkler.io.surfaces.instrument_channels import channel_contents, tip_radius_of
from winkler.io.tables.header import names_columns
from winkler.io.tables.table import Column, read_table
from winkler.io.text_file import content_of, existing
from winkler.io.workbooks.workbook_cells import is_spreadsheet
from winkler.numerics.types import Array
from winkler.profiles.rough.plausibility import without_marks
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput
from winkler.values.limits import TEXT_BYTES
from winkler.values.readable import with_unit
from winkler.values.units import scale

ARRAY_ENDINGS = {".npy", ".npz"}
MESH_ENDING, OTHER_MESHES = ".stl", {".ply", ".obj"}
POINT_COLUMNS = (
    Column("x", ("x",), "m", "um"),
    Column("y", ("y",), "m", "um"),
    Column("height", ("z", "height", "h"), "m", "nm"),
)
TEXT_ENDINGS = {".csv", ".txt", ".asc", ".dat", ".tsv", ".xyz"}
STEEPEST_RATIO = 1e4
"""Largest ratio of root mean square height to pixel size; only mistaken units exceed it."""
MOST_LINES_TRIED = 400_000
"""Most lines of a text on which the readers of SurfaceTopography are tried; some take 20 us per line."""
UNSTATED_LENGTHS = (float("nan"), float("nan"))


@reader("a height map")
def read_topography(
    path: str | os.PathLike[str],
    *,
    lengths: tuple[float, float] = UNSTATED_LENGTHS,
    unit: str = "",
    periodic: bool = False,
    channel: str = "",
    tip_radius: float = 0.0,
) -> Topography:
    """Read a height map.

    Parameters
    ----------
    path : str or path
        A matrix of heights as text (tabs, semicolons, commas or spaces between; every line runs along the second
        direction; nan, nothing, or a number that instruments write for it (-25400, -9999, 1e10 ...), far from others,
        where heights are missing; header lines of Gwyddion above a matrix are read); a list of points x, y, z, with or
        without a header; triangles in an STL, each place with one height; a simple field of Gwyddion (.gsf); an NPY
        file; an NPZ file with ``heights`` and, if they are known, ``lengths``, ``unit`` and ``periodic``; or a file
        that SurfaceTopography reads (extra ``topography``): Bruker, Digital Surf (compressed, too), Zygo, Gwyddion,
        X3P and some forty others; or a container (zip) that contact.engineering has published, whose maps come as its
        authors prepared them.  Points and corners off a grid give a map of about as many pixels, with heights between
        them by triangles; a pixel more than two pixels from any is missing, and ``reading`` says so.
    lengths : tuple of float, optional
        Lengths [m] of the map; needed where the file does not state them; they replace those of the file.
    unit : str, optional
        Of heights, and of lengths that stand in the file as well, where it does not name one: any unit of length, such
        as um or nm; two units, such as "mm, um", where places and heights differ.
    periodic : bool, optional
        Whether the map is periodic, where the file does not state it.
    channel : str, optional
        Which one of several height channels of an instrument's file, or which measurement of a container; the first by
        default.
    tip_radius : float, optional
        Radius of the tip that has scanned the map [m], where the file does not state it; it replaces that of the file.

    Returns
    -------
    Topography

    Raises
    ------
    InvalidInput
        If the file cannot be read or holds no height map, or a length or unit is missing or given twice.
    """
    file = existing(path, "a height map")
    suffix = file.suffix.lower()
    if channel and suffix in ARRAY_ENDINGS:
        raise InvalidInput(f"{file}: an array has no channels; leave channel {channel!r} out.")
    if suffix in ARRAY_ENDINGS:
        contents = array_map(file)
    elif suffix == MESH_ENDING:
        contents = mesh_map(file)
    elif suffix in OTHER_MESHES:
        raise InvalidInput(f"{file}: of surfaces of triangles those in .stl are read; save it so, or as rows x, y, z.")
    elif is_simple_field(file):
        contents = simple_field_map(file)
    elif (suffix in TEXT_ENDINGS or is_spreadsheet(file)) and not channel:
        try:
            contents = text_map(file)
        except InvalidInput as reason:
            contents = _other_text(file, reason)
        else:
            if not contents.reading:
                refuse_table(file, contents.heights)
    else:
        contents = instrument_map(file, channel)
    if not isinstance(unit, str):
        raise InvalidInput(f"{file}: unit is {unit!r}; give the name of a unit, such as 'nm' or 'um'.")
    if not (contents.unit or unit):
        raise InvalidInput(f"{file}: the file does not state the unit of its heights; give unit, such as 'nm' or 'um'.")
    of_lengths, _, of_heights = (part.strip() for part in unit.partition(","))
    per_metre = _per_metre(contents.unit or contents.length_unit or of_lengths, f"{file}, unit")
    per_height = _per_metre(contents.unit or of_heights or of_lengths, f"{file}, unit")
    if contents.unit and any(_per_metre(one, "unit") != per_metre for one in (of_lengths, of_heights) if one):
        raise InvalidInput(f"{file}: the file states its unit, {contents.unit}, and {unit} was given; leave it out.")
    try:
        stated_lengths = np.array(lengths, dtype=float)
    except (TypeError, ValueError):
        stated_lengths = np.empty(0)
    if stated_lengths.shape != (2,):
        raise InvalidInput(f"{file}: lengths are {lengths!r}; give two numbers, in m.")
    map_lengths = np.where(np.isnan(stated_lengths), contents.lengths / per_metre, stated_lengths)
    if np.any(np.isnan(map_lengths)):
        raise InvalidInput(f"{file}: the file does not state the lengths of the map; give lengths=(x, y) in m.")
    with in_file(file):
        tip = tip_radius or contents.tip_radius * (scale(contents.tip_unit, "m") if contents.tip_unit else 1.0)
        heights, _ = without_marks(contents.heights / per_height)
        rough = Topography(heights, map_lengths, periodic or contents.periodic, tip_radius=tip)
        rough = dataclasses.replace(rough, reading=_reading_of(rough, contents.reading))
    steep = rough.rms_height / min(rough.pixel)
    if steep > STEEPEST_RATIO:
        raise InvalidInput(
            f"{file}: heights of {rough.rms_height:.3g} m on pixels of {min(rough.pixel):.3g} m are no surface; check "
            f"the unit of the heights ({contents.unit or unit}), and the lengths ({map_lengths[0]:.3g} m, "
            f"{map_lengths[1]:.3g} m)."
        )
    return rough


def _reading_of(rough: Topography, points: str) -> str:
    """Return how heights came from points off a grid; empty of others."""
    if not points:
        return ""
    steps = " x ".join(with_unit(step, "m", 3) for step in rough.pixel)
    filled = 1.0 - rough.missing / rough.heights.size
    return f"heights between {points}, on pixels of {steps}; {filled:.0%} of them have a height"


def _other_text(file: Path, reason: InvalidInput) -> MapContents:
    """Return the map of a text that is no matrix: points with a header, or a text of an instrument; else raise why."""
    if _has_points(file):
        return point_map(file, read_table(file, POINT_COLUMNS).values)._replace(unit="m")
    if content_of(file, TEXT_BYTES).count(b"\n") > MOST_LINES_TRIED:
        raise reason
    try:
        return instrument_map(file, "")
    except InvalidInput:
        raise reason from None


def _has_points(file: Path) -> bool:
    try:
        return names_columns(file, POINT_COLUMNS)
    except InvalidInput:  # the reason why it is no text is known already
        return False


def _per_metre(unit: str, what: str) -> float:
    """Return the number of units in a metre: dividing by it rounds once."""
    scale(unit, "m", what=what)  # raises what is wrong with the unit
    return scale("m", unit)


def instrument_map(path: Path, channel: str) -> MapContents:
    """Return a height map of an instrument's file, or of a container of contact.engineering.

    Parameters
    ----------
    path : path
        The file.
    channel : str
        Name of one of several channels or measurements; the first if empty.

    Raises
    ------
    InvalidInput
        If SurfaceTopography is not installed or cannot read the file, or the file holds no such map.
    """
    return channel_contents(path, channel, 2, refuse_many, _contents)


def _contents(surface: Any) -> MapContents:
    heights: Array = np.ma.filled(np.ma.asarray(surface.heights(), dtype=float), np.nan)
    sizes = [np.nan if size is None else float(size) for size in surface.physical_sizes or (None, None)]
    return MapContents(
        heights, np.array(sizes), str(surface.unit or ""), bool(surface.is_periodic), *tip_radius_of(surface)
    )
