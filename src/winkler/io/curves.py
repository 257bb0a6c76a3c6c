r"""Force curves in files: tables, and with the extra ``afm`` the formats of atomic force microscopes.

A piezo counts its height down when it approaches; here positions grow towards the sample, so that the height changes
its sign.
"""

from __future__ import annotations

import dataclasses
import os
import tempfile
import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.io.archive_file import archive, is_archive, member, refuse_large_archive
from winkler.io.foreign import in_file, quiet, reason_of, sentence_of, without_stale_sizes
from winkler.io.hdf5_file import refuse_other_files
from winkler.io.instruments.find import instrument_tests
from winkler.io.instruments.instrument_test import InstrumentTest
from winkler.io.instruments.tests_side_by_side import tests_side_by_side
from winkler.io.instruments.to_curve import curves_of_test
from winkler.io.memory import limited_memory
from winkler.io.placed_curves import PlacedCurve, UnreadCurve
from winkler.io.segments import directions, segment_fact
from winkler.io.tables.curve_table import is_curve_table, read_curve_tables
from winkler.io.tables.given_units import GivenFacts, checked_columns, checked_units
from winkler.io.tables.table_lines import table_sheets
from winkler.io.text_file import UNMARKED_UTF16, UTF16_MARKS, existing, refuse_large
from winkler.io.workbooks.array_workbook import is_array_workbook
from winkler.io.workbooks.workbook_cells import is_workbook
from winkler.values.errors import InvalidInput
from winkler.values.limits import FILE_BYTES

__all__ = ["BENDING", "PlacedCurve", "UnreadCurve", "read_curve", "read_curves", "try_curves"]

HDF5_ENDING = ".h5"
ARCHIVE = ".zip"
ARCHIVE_ENDINGS = (".jpk", ARCHIVE)
"""Endings of archives, which may not begin as such: their list of contents stands at the end."""
HIDDEN, MOST_MEMBERS = "__MACOSX", 10_000
"""Folder of another system's own files, and most files of an archive."""
IMAGE_HINT = "; an image without curves is read by read_topography; else export its curves as text"
BENDING = "the file does not state how a deflection becomes a force"
"""What lacks of a curve of a microscope."""
JPK_WAYS = ("extend", "retract")
HEIGHT_COLUMNS = ("height (measured)", "height (piezo)")


def read_curve(
    path: str | os.PathLike[str],
    *,
    spring_constant: float | None = None,
    sensitivity: float | None = None,
    units: Mapping[str, str] | None = None,
    columns: Mapping[str, int] | None = None,
) -> ForceCurve:
    """Read the force curve of a file.

    Parameters
    ----------
    path : str or path
        A text table (see `winkler.io.tables.curve_table`); a file of NanoScope; the text that JPK exports; a file of a
        nanoindenter (Hysitron, FischerScope, Micro Materials, FemtoTools, with the extra ``nanoindentation`` workbooks
        of Agilent, Keysight, KLA and MTS); or with the extra ``afm`` what afmformats reads: JPK, NT-MDT, Asylum, AFM
        workshop and others.
    spring_constant : float, optional
        Spring constant of the cantilever [N/m]. It replaces the value in the file, and is required if the file has
        none.
    sensitivity : float, optional
        Deflection per volt [m/V], likewise.
    units : mapping of str to str, optional
        Units of columns for which the file states none: ``{"position": "nm", "force": "uN", "time": "s"}``.
    columns : mapping of str to int, optional
        For a table without column names: the number of each column, counted from 1: ``{"depth": 1, "force": 2, "time":
        3}``.

    Returns
    -------
    ForceCurve
        The curve; its ``reading`` states how the file was interpreted.

    Raises
    ------
    InvalidInput
        If the file cannot be read, lacks a required number or unit, contradicts a given unit, or contains several
        curves.
    """
    curves = list(
        read_curves(path, spring_constant=spring_constant, sensitivity=sensitivity, units=units, columns=columns)
    )
    if len(curves) > 1:
        raise InvalidInput(f"{path}: the file holds {len(curves)} curves; use read_curves(path), it yields them all.")
    if not curves:
        raise InvalidInput(f"{path}: the file holds no curve; give another one.")
    return curves[0].curve


def read_curves(
    path: str | os.PathLike[str],
    *,
    spring_constant: float | None = None,
    sensitivity: float | None = None,
    units: Mapping[str, str] | None = None,
    columns: Mapping[str, int] | None = None,
) -> Iterator[PlacedCurve]:
    """Yield every force curve of a file, of a force map one after the other; parameters as for `read_curve`.

    Raises
    ------
    InvalidInput
        As `read_curve`; of a curve within a map the message names its number.
    """
    for placed_or_unread in _each(path, _given(spring_constant, sensitivity, units, columns)):
        if isinstance(placed_or_unread, UnreadCurve):
            raise InvalidInput(placed_or_unread.reason)
        yield placed_or_unread


def try_curves(
    path: str | os.PathLike[str],
    *,
    spring_constant: float | None = None,
    sensitivity: float | None = None,
    units: Mapping[str, str] | None = None,
    columns: Mapping[str, int] | None = None,
    rigid: bool = False,
) -> Iterator[PlacedCurve | UnreadCurve]:
    """Yield every curve of a file like `read_curves`, and in the place of one that cannot be read the reason.

    With `rigid` a position without a spring constant is the travel of the tip, as in nanoindenters.
    """
    try:
        yield from _each(path, _given(spring_constant, sensitivity, units, columns, rigid=rigid))
    except InvalidInput as error:
        yield UnreadCurve(Path(path).name, str(error))


def _given(
    spring_constant: float | None,
    sensitivity: float | None,
    units: Mapping[str, str] | None,
    columns: Mapping[str, int] | None,
    *,
    rigid: bool = False,
) -> GivenFacts:
    return GivenFacts(spring_constant, sensitivity, checked_units(units or {}), checked_columns(columns or {}), rigid)


def _each(path: str | os.PathLike[str], given: GivenFacts) -> Iterator[PlacedCurve | UnreadCurve]:
    with sentence_of(path, "a force curve cannot be read from it", "check the file, or save it anew"):
        file = existing(path, "a force curve")
        refuse_large(file, FILE_BYTES)
        is_text = _is_text(file)
        is_table = is_text or is_workbook(file)
        if given.columns:
            if not is_table:
                raise InvalidInput(f"{file}: columns are counted in tables, and this is none; leave columns out.")
            yield from _curves_of_columns(file, given)
            return
        tests = tests_side_by_side(file, given) if is_table and not is_text else None
        if tests is None:
            tests = instrument_tests(file, given, is_text=is_text)
        if tests is None and is_text:
            tests = tests_side_by_side(file, given)
        if tests is not None:
            try:
                yield from _curves_of_tests(tests, file, given)
            except InvalidInput:  # no sheet of a test; a rheometer's workbook is a table
                if is_text or not is_table or not is_curve_table(file):
                    raise
                yield from read_curve_tables(file, given)
            return
        if is_text and is_curve_table(file):
            yield from read_curve_tables(file, given)
            return
        yield from _curves_of_afmformats(file, given)


def _curves_of_columns(file: Path, given: GivenFacts) -> Iterator[PlacedCurve]:
    """Yield the curves in columns of given numbers; of arrays those of each sheet, such as the cells of MATLAB."""
    parts = table_sheets(file) if is_array_workbook(file) else []
    if len(parts) < 2:
        yield from read_curve_tables(file, given)
        return
    for part in parts:
        for placed in read_curve_tables(part, given):
            yield dataclasses.replace(
                placed, curve=dataclasses.replace(placed.curve, name=f"{file.name}, {part.label}")
            )


def _curves_of_tests(
    tests: Iterator[InstrumentTest], path: Path, given: GivenFacts
) -> Iterator[PlacedCurve | UnreadCurve]:
    for test in tests:
        try:
            placed = curves_of_test(test, path, given)
        except InvalidInput as error:
            yield UnreadCurve(test.name, str(error))
        else:
            yield from placed


def _is_text(path: Path) -> bool:
    """Return whether the file may be a table: it is text."""
    with path.open("rb") as file:
        start = file.read(4096)
    if start.startswith(UTF16_MARKS) or UNMARKED_UTF16.match(start):  # their reader names what it cannot read
        return True
    return b"\x00" not in start and not start.startswith((b"PK", b"\x89HDF"))


def _curves_of_afmformats(path: Path, given: GivenFacts) -> Iterator[PlacedCurve | UnreadCurve]:
    try:
        import afmformats
        from afmformats.errors import AFMFileFormatError, MissingMetaDataError
    except ImportError:
        raise _no_table(
            path,
            "this is no text table, and the formats of microscopes need the extra afm; install it with "
            "pip install 'winkler[afm]'",
        ) from None
    stated = {"spring constant": given.spring_constant, "sensitivity": given.sensitivity}
    overrides = {key: number for key, number in stated.items() if number}
    known = afmformats.formats.supported_extensions
    if path.suffix.lower() not in known:
        end = f"files that end in '{path.suffix}' are not known; tables and {', '.join(known)} are read"
        raise _no_table(path, end)
    exchanged = packed = False
    with quiet(), limited_memory(path):
        try:
            _refuse_large_contents(path)
            with without_stale_sizes():
                try:
                    group = afmformats.load_data(path, meta_override=overrides)
                except NotImplementedError:  # of some formats it takes no other numbers: they are exchanged below
                    group, exchanged = afmformats.load_data(path), True
        except MissingMetaDataError:
            other = (
                "; if it is no curve of a microscope but numbers without names, give columns = { depth = 1, "
                "force = 2 } and units, or write a header such as 'depth [nm], force [uN]'"
            )
            raise InvalidInput(
                f"{path}: {BENDING}; give spring_constant in N/m and sensitivity in m/V{other * _is_text(path)}."
            ) from None
        except (InvalidInput, MemoryError):
            raise
        except (Exception, AFMFileFormatError) as error:  # its readers of ten formats raise many types
            group = _paused(path, overrides)
            if not group:
                packed = path.suffix.lower() == ARCHIVE and zipfile.is_zipfile(path)
                if not packed:
                    why = f"afmformats cannot read this file ({reason_of(error)}){IMAGE_HINT}"
                    raise _no_table(path, why) from None
    if packed:  # not as afmformats has archives, but one file of curves beside the other
        yield from _curves_of_archive(path, given)
        return
    for number, data in enumerate(group):
        name = path.name if len(group) == 1 else f"{path.name}, curve {number}"
        try:
            remedy = "save it anew, or as a table"
            with (
                sentence_of(path, f"'{name}' cannot be read", remedy, also=(AFMFileFormatError,)),
                quiet(),
                limited_memory(path),
            ):
                placed = _translated(data, name, str(path), overrides, exchanged=exchanged)
        except InvalidInput as error:
            yield UnreadCurve(name, str(error))
        else:
            yield placed


def _curves_of_archive(path: Path, given: GivenFacts) -> Iterator[PlacedCurve | UnreadCurve]:
    """Yield the curves of all files of an archive, in the order of their names; each stands in a file of its own."""
    with archive(path, path, remedy="save a part of the curves", members=MOST_MEMBERS) as pack:
        inside = sorted(
            (one for one in pack.infolist() if not one.is_dir() and HIDDEN not in one.filename),
            key=lambda one: one.filename,
        )
        if not inside:
            raise InvalidInput(f"{path}: the archive is empty; give one of files with curves.")
        for one in inside:
            with tempfile.TemporaryDirectory(prefix="winkler-") as folder:
                file = Path(folder, Path(one.filename).name)
                file.write_bytes(member(pack, one))
                name = f"{path.name}, {one.filename}"
                try:
                    if file.suffix.lower() == ARCHIVE and zipfile.is_zipfile(file):
                        raise InvalidInput(f"{file}: an archive within an archive is not opened; unpack it.")
                    for placed in _each(file, given):
                        yield _renamed(placed, file, f"{path}, {one.filename}", name)
                except InvalidInput as error:
                    yield UnreadCurve(name, str(error).replace(str(file), f"{path}, {one.filename}"))


def _renamed(placed: PlacedCurve | UnreadCurve, file: Path, where: str, name: str) -> PlacedCurve | UnreadCurve:
    """Return a curve under the name of its file within an archive."""
    if isinstance(placed, UnreadCurve):
        return UnreadCurve(placed.name.replace(file.name, name), placed.reason.replace(str(file), where))
    curve = dataclasses.replace(placed.curve, name=placed.curve.name.replace(file.name, name))
    return dataclasses.replace(placed, curve=curve)


class _PausedCurve:
    """A curve of JPK with a pause, as the classes of afmformats have it."""

    columns = (*HEIGHT_COLUMNS, "force", "segment", "time")

    def __init__(self, reader: Any, index: int) -> None:
        self._reader, self._index = reader, index
        self.metadata = reader.get_metadata(index=index)

    def __getitem__(self, column: str) -> Any:
        return self._reader.get_data(column, self._index)


def _paused(path: Path, overrides: dict[str, float]) -> list[_PausedCurve]:
    """Return the curves of a file of JPK whose order of pauses afmformats does not name; empty if it is none."""
    if not path.suffix.lower().startswith(".jpk"):
        return []
    from afmformats.formats.fmt_jpk.jpk_reader import JPKReader

    class Reader(JPKReader):  # type: ignore[misc]
        def get_imaging_mode(self) -> str:
            return "force-distance"

        def get_metadata_jpk_secondary(self, index: int, segment: int) -> dict[str, Any]:
            found: dict[str, Any] = super().get_metadata_jpk_secondary(index, segment)
            if found.get("curve type") not in JPK_WAYS:  # such as an oscillation at rest
                found["curve type"] = "pause"
            return found

    try:
        reader = Reader(path)
        reader.set_metadata(overrides)
        curves = [_PausedCurve(reader, index) for index in range(len(reader))]
        curves[0]["force"]
        return curves
    except Exception:  # afmformats has said why it cannot be read
        return []


def _no_table(path: Path, reason: str) -> InvalidInput:
    """Return the reason why a file cannot be read; of an incomplete table its reader raises what is missing."""
    if _is_text(path):
        read_curve_tables(path)
    return InvalidInput(f"{path}: {reason}.")


def _refuse_large_contents(path: Path) -> None:
    """Refuse a file that unpacks to more than can be read."""
    remedy = "save a part of the map, or single curves"
    if is_archive(path) or (path.suffix.lower().startswith(ARCHIVE_ENDINGS) and zipfile.is_zipfile(path)):
        refuse_large_archive(path, remedy)
    refuse_other_files(path)
    if path.suffix.lower() == HDF5_ENDING:
        import h5py

        sizes: list[int] = []
        with h5py.File(path, "r") as file:
            file.visititems(lambda _, item: sizes.append(item.nbytes) if isinstance(item, h5py.Dataset) else None)
        if sum(sizes) > FILE_BYTES:
            raise InvalidInput(
                f"{path}: its arrays have {sum(sizes) / 1e6:.0f} MB, at most {FILE_BYTES / 1e6:.0f} MB are read; "
                f"{remedy}."
            )


def _translated(
    data: Any, name: str, file_name: str, overrides: dict[str, float], *, exchanged: bool = False
) -> PlacedCurve:
    """Return a curve of afmformats in the signs of winkler; `exchanged` if its force is by the numbers of the file."""
    columns = set(data.columns)
    height = next((word for word in HEIGHT_COLUMNS if word in columns), "")
    if not height or "force" not in columns:
        raise InvalidInput(
            f"{file_name}: '{name}' has the columns {', '.join(sorted(columns))}; a force curve needs a height and a "
            "force."
        )
    position, force = -np.asarray(data[height], dtype=float), np.asarray(data["force"], dtype=float)
    stiffness = overrides.get("spring constant", data.metadata.get("spring constant", np.nan))
    for word in overrides if exchanged else ():
        stated = data.metadata.get(word, np.nan)
        if not stated > 0.0:
            raise InvalidInput(
                f"{file_name}: the file states no {word} by which its force could be turned into another."
            )
        force = force * overrides[word] / stated
    if not stiffness > 0.0:
        raise InvalidInput(
            f"{file_name}: the file does not state the spring constant of the cantilever, from which the depth "
            "follows; give spring_constant in N/m."
        )
    segment = np.asarray(data["segment"]) if "segment" in columns else np.zeros(0)
    time = np.asarray(data["time"], dtype=float) if "time" in columns else np.zeros(0)
    with in_file(file_name):
        directed = directions(position, force, segment)
        doubts = segment_fact(position, force, segment, "segment")
        reading = _reading(data, height, bool(time.size), overrides) + f"; {doubts}" * bool(doubts)
        curve = ForceCurve(position, force, float(stiffness), time, directed, name, reading=reading)
    x, y = (float(data.metadata.get(f"position {axis}", np.nan)) for axis in "xy")
    return PlacedCurve(curve, x, y)


def _reading(data: Any, height: str, timed: bool, overrides: dict[str, float]) -> str:
    """Return what was taken for what, and where spring constant and sensitivity come from."""
    software = str(data.metadata.get("software", "") or data.metadata.get("format", "")).strip()
    if software.startswith("NT-MDT"):  # nothing in such a file says so
        software = "numbers without names, taken as NT-MDT exports height [nm] and deflection there and back [nA]"
    facts = [f"position from '{height}', its sign changed, force from 'force'" + ", time from 'time'" * timed]
    for word, unit in (("spring constant", "N/m"), ("sensitivity", "m/V")):
        number = overrides.get(word, data.metadata.get(word, np.nan))
        if np.isfinite(number):
            facts.append(f"{word} {number:.5g} {unit} {'given' if word in overrides else 'from the file'}")
    return f"afmformats{f', file of {software}' if software else ''}: {'; '.join(facts)}"
