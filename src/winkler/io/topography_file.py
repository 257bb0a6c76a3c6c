"""Height maps in files: of instruments through SurfaceTopography, or plain matrices as text, NPY and NPZ."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from winkler.errors import InvalidInput
from winkler.io.foreign import reader
from winkler.io.height_matrix import FoundMap, array_map, text_map
from winkler.io.instrument_map import instrument_map
from winkler.io.text_file import content_of, existing
from winkler.limits import TEXT_BYTES
from winkler.profiles.rough.topography import Topography
from winkler.units import scale

__all__ = ["read_topography"]

ARRAYS = {".npy", ".npz"}
TEXTS = {".csv", ".txt", ".asc", ".dat", ".tsv"}
IMPOSSIBLE = 1e4
"""Root mean square height over the size of a pixel: only mistaken units reach it."""
TRIED = 400_000
"""Lines of a text that every reader of SurfaceTopography is tried on; some take 20 us for a line."""
UNKNOWN = (float("nan"), float("nan"))


@reader("a height map")
def read_topography(
    path: str | os.PathLike[str],
    *,
    lengths: tuple[float, float] = UNKNOWN,
    unit: str = "",
    periodic: bool = False,
    channel: str = "",
) -> Topography:
    """Read a height map.

    Parameters
    ----------
    path : str or path
        A matrix of heights as text (tabs, semicolons, commas or spaces between them; every line runs along the second
        direction; nan or nothing where heights are missing; what Gwyddion writes above a matrix is understood); an NPY
        file; an NPZ file with ``heights`` and, if they are known, ``lengths``, ``unit`` and ``periodic``; or a file
        that SurfaceTopography reads (extra ``topography``): Bruker, Digital Surf, Zygo, Gwyddion, X3P and some forty
        others.
    lengths : tuple of float, optional
        Lengths [m] of the map; needed where the file does not tell them, and taken before what it tells.
    unit : str, optional
        Of heights, and of lengths that stand in the file as well, where it does not name one: any unit of length, such
        as um or nm.
    periodic : bool, optional
        Whether the map is repeated for ever, where the file does not say so.
    channel : str, optional
        Which one of several height channels of an instrument's file; the first by default.

    Returns
    -------
    Topography

    Raises
    ------
    InvalidInput
        If the file cannot be read or holds no height map, or a length or unit is missing or told twice.
    """
    file = existing(path, "a height map")
    suffix = file.suffix.lower()
    if channel and suffix in ARRAYS:
        raise InvalidInput(f"{file}: an array has no channels; leave channel {channel!r} out.")
    if suffix in ARRAYS:
        found = array_map(file)
    elif suffix in TEXTS and not channel:
        try:
            found = text_map(file)
        except InvalidInput as reason:
            found = _other_text(file, reason)
    else:
        found = instrument_map(file, channel)
    if not isinstance(unit, str):
        raise InvalidInput(f"{file}: unit is {unit!r}; give the name of a unit, such as 'nm' or 'um'.")
    if not (found.unit or unit):
        raise InvalidInput(f"{file}: the file does not tell the unit of its heights; give unit, such as 'nm' or 'um'.")
    parts = _parts(found.unit or unit, f"{file}, unit")
    if unit and _parts(unit, "unit") != parts:
        raise InvalidInput(f"{file}: the file tells its unit, {found.unit}, and {unit} was given; leave it out.")
    try:
        given = np.array(lengths, dtype=float)
    except (TypeError, ValueError):
        given = np.empty(0)
    if given.shape != (2,):
        raise InvalidInput(f"{file}: lengths are {lengths!r}; give two numbers, in m.")
    known = np.where(np.isnan(given), found.lengths / parts, given)
    if np.any(np.isnan(known)):
        raise InvalidInput(f"{file}: the file does not tell the lengths of the map; give lengths=(x, y) in m.")
    try:
        rough = Topography(found.heights / parts, known, periodic or found.periodic)
    except InvalidInput as error:
        raise InvalidInput(f"{file}: {error}") from None
    steep = rough.rms_height / min(rough.pixel)
    if steep > IMPOSSIBLE:
        raise InvalidInput(
            f"{file}: heights of {rough.rms_height:.3g} m on pixels of {min(rough.pixel):.3g} m are no surface; check "
            f"the unit of the heights ({found.unit or unit}), and the lengths ({known[0]:.3g} m, {known[1]:.3g} m)."
        )
    return rough


def _other_text(file: Path, reason: InvalidInput) -> FoundMap:
    """Return the map of a text that is no matrix: some instruments write texts too; else say why it is no matrix."""
    if content_of(file, TEXT_BYTES).count(b"\n") > TRIED:
        raise reason
    try:
        return instrument_map(file, "")
    except InvalidInput:
        raise reason from None


def _parts(unit: str, what: str) -> float:
    """Return how many of a unit are a metre: dividing by it rounds once."""
    scale(unit, "m", what=what)  # says what is wrong with the unit
    return scale("m", unit)
