"""Find what files are taken for: each is read as what its header names, or by the instrument that wrote it."""

from __future__ import annotations

import contextlib
import dataclasses
import itertools
import math
import os
import re
import time
from collections.abc import Generator, Iterator, Sequence
from pathlib import Path

import numpy as np

from winkler.fitting.curves.checks import examined
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.nanoindentation.thermal_drift import found_drift
from winkler.fitting.nanoindentation.zero_point import found_zero_point
from winkler.io.curves import BENDING, try_curves
from winkler.io.foreign import reason_of
from winkler.io.indenter_file import AREA, read_indenter
from winkler.io.indenter_file import DEPTH as CONTACT_DEPTH
from winkler.io.instruments.find import METHOD, states_curves
from winkler.io.placed_curves import UnreadCurve
from winkler.io.tables.curve_table import DEPTH, FORCE, RESULTS, is_curve_table
from winkler.io.tables.given_units import LACKS_UNIT
from winkler.io.tables.header import bare_columns, header_lines, names_columns
from winkler.io.tables.path_table import LATERAL_COLUMNS
from winkler.io.tables.relaxation_table import MODULI, SHEAR_STORAGE, read_creep, read_dynamic, read_relaxation
from winkler.io.tables.scan_table import HEIGHT_COLUMN, PLACE_COLUMN
from winkler.io.tables.table import read_table
from winkler.io.tables.table_lines import TablePart, sheets_naming
from winkler.io.tables.tests_of_table import parts_of_table
from winkler.io.text_file import existing
from winkler.io.workbooks.workbook_cells import is_workbook
from winkler.loading.loads import Angle, Torque
from winkler.materials.relaxation_data import CreepData, DynamicData, RelaxationData
from winkler.materials.sweeps import DynamicSweeps
from winkler.profiles.rough.line_scan import LineScan
from winkler.study.batch.pool import Machine, completed
from winkler.study.inspection.file_kinds import (
    GENERAL,
    GREATEST,
    HELD,
    REDUCED,
    SPECIFIC,
    AreaTable,
    HeldTable,
    TableKind,
)
from winkler.study.inspection.inspection import InspectedColumn, Inspection, columns_of
from winkler.study.inspection.logs import log_doubts, log_lines
from winkler.study.inspection.starting import starting_study
from winkler.study.inspection.surfaces import SurfaceOptions, read_surface_file
from winkler.values.errors import InvalidInput, WinklerError
from winkler.values.readable import with_unit

ANY_COLUMNS = (DEPTH, FORCE)
"""What a header may name, for messages."""
NO_HEADER = "without a header above them"
BARE_MODULI = 'give header = "frequency [Hz], storage [kPa], loss [kPa]"'
BARE_CURVE = 'give columns = { position = 1, force = 2 } and units = { position = "mm", force = "N" }'
NO_FREQUENCY = (
    "its header names moduli and no frequency, as a sweep of strain or time at one frequency does; give a sweep of "
    'frequency, or if it is one, header = "frequency [Hz], storage [kPa], loss [kPa]".'
)
NO_PLACES = (
    "its header names heights and no places; give --lengths '4 mm', the length of the scan, --unit of the heights, and "
    "--channel, the name of another column."
)
OWN_NAMES = (
    f"; of moduli {BARE_MODULI}; if a column holds heights at equal steps, give --channel, its name, --lengths '4 mm', "
    "of the scan, and --unit."
)
NO_UNIT_OF_MAP = "does not state the unit of its heights"
MOST_OF_TABLE = 24
"""Columns of bare numbers that may be a table and no map."""
OF_GREATEST = (
    "its header names the greatest force and the greatest depth, one of each test, as in a table of results, which is "
    "no curve; give the curves themselves."
)
OF_MODULI = ("storage and loss", "storage and loss at several temperatures")
SCAN = (PLACE_COLUMN, HEIGHT_COLUMN)
TIPS = {".toml"}
ARRAYS = {".npy", ".npz"}
PROFILES = {".prr", ".prw", ".ban", ".whl"}
SURFACE_KINDS = ("height map", "line scan")
LEAST_HARDNESS = 10e6
"""Greatest force over 24.5 squares of the travel [Pa], from which on a test with an unloading is taken for a
nanoindentation: the hardness by a Berkovich tip."""
BERKOVICH = 24.5
BARE_MODULUS = re.compile(r"storage[ _-]modulus|speichermodul|module de conservation", re.IGNORECASE)
OF_SHEAR = re.compile(r"shear|torque|viscosity|scher|schub|moment|cisaillement|\bg'|rheo", re.IGNORECASE)
"""Words of rheometers, which measure in shear; a DMA, in tension and bending, has none of them."""
BY_TEST = {"dynamic": read_dynamic, "relaxation": read_relaxation, "creep": read_creep}
"""Studies whose files are read by the key `test`, and their readers."""
STILL = 0.01
"""Greatest travel of a gap that is held, in parts of it."""
TWO_HOLDS = 'two holds, of other width or depth, make a study with kind = "held_contacts" (winkler show held_contacts)'
MOST_CURVES_COUNTED, LONGEST_COUNT = 10_000, 2.0
"""Curves of a file that are counted, and time for it [s]."""
FEWEST_FOR_JUMPS, LEAST_JUMP = 20, 0.5
"""Fewest steps of a position among which a jump is sought, and its least part of the whole travel."""
UNPRESSED_PARTS = 8
"""Parts of a way in, in each of which the mean force is below that before, where no contact is pressed."""
FEWEST_SHARED = 100
"""Files of a list from which on several processes read them; starting them takes a second or two."""
LISTED_BYTES = 50_000_000
"""Greatest file that is read for a list of files."""


def inspect_file(
    path: str | os.PathLike[str], options: SurfaceOptions | None = None, *, brief: bool = False
) -> Inspection:
    """Return what a file is taken for.

    Parameters
    ----------
    path : str or path
    options : SurfaceOptions, optional
        How a map or a scan is read; if given, the file is taken for one of them.
    brief : bool, optional
        Whether events, touch and drift are left out, which take most of the time, and only the first curve of a file
        is read.

    Raises
    ------
    InvalidInput
        If the file does not exist.  One that cannot be read is returned, with the reason.
    """
    file = existing(path, "a measured file")
    given = options if options is not None else SurfaceOptions()
    if options is None:
        suffix = file.suffix.lower()
        if suffix in TIPS:
            return _tip(file)
        if suffix in PROFILES:
            return _by_kind(file, next(one for one in GENERAL if one.study == "cross_profile"), "its ending")
        found = _as_table_or_curve(file, brief=brief) if suffix not in ARRAYS else []
        if isinstance(found, Inspection):
            return found
        reasons = found
        if suffix == ".npz" and (
            load := _tried(file, next(k for k in SPECIFIC if k.study == "surface_load"), "arrays")
        ):
            return load
    else:
        reasons = []
    try:
        read = read_surface_file(file, given)
    except InvalidInput as error:
        return Inspection(str(file), "", _reason(file, str(error), reasons))
    kind = SURFACE_KINDS[isinstance(read.surface, LineScan)]
    why = "by its columns of places and heights" if kind == "line scan" else "its numbers are a map of heights"
    columns = columns_of(read.surface)
    if not isinstance(read.surface, LineScan):
        rows, wide = read.surface.heights.shape
        sides = " x ".join(with_unit(float(side), "m", 4) for side in read.surface.lengths)
        why += f": {rows} x {wide} pixels, {sides}"
    found = Inspection(str(file), kind, why, 1, columns, read.numbers, (), read.doubts, content=read.statistics)
    of_scan = "" if given.lengths else "line_scan"  # a study reads places
    return _finished(found, "height_map" if kind == "height map" else of_scan)


def inspect_files(paths: Sequence[Path], seconds: float) -> Iterator[tuple[int, Inspection]]:
    """Yield place and inspection of many files, in short, as long as there is time; many are read by all processors.

    Parameters
    ----------
    paths : sequence of path
    seconds : float
        Time after which no further file is taken [s].
    """
    end = time.monotonic() + seconds
    with contextlib.closing(_all_listed(paths)) as found:
        for place, inspection in found:
            yield place, inspection
            if time.monotonic() > end:
                return


def _all_listed(paths: Sequence[Path]) -> Generator[tuple[int, Inspection], None, None]:
    """Yield all files: few by this process, many by as many as there are processors."""
    processors = Machine().processors
    if len(paths) < FEWEST_SHARED or processors < 2:
        yield from enumerate(map(_listed, paths))
    else:
        yield from completed(_listed, paths, processors)


def _listed(path: Path) -> Inspection:
    """Return the inspection of a file for a list, without its content, which would be sent between processes."""
    try:
        size = path.stat().st_size
        if size > LISTED_BYTES:
            return Inspection(str(path), "", f"{size / 1e6:.0f} MB, not opened for a list; show it by itself.")
        return dataclasses.replace(inspect_file(path, brief=True), content=None)
    except WinklerError as error:
        return Inspection(str(path), "", str(error).removeprefix(f"{path}: "))
    except OSError as error:
        return Inspection(str(path), "", f"it cannot be read ({reason_of(error)}).")


def _reason(file: Path, last: str, reasons: Sequence[tuple[str, str]]) -> str:
    """Return why a file cannot be read: by its header if that names a kind, else as the reader that lacks least."""
    named = [(what, why.removeprefix(f"{file}: ")) for what, why in reasons]
    if not named and NO_HEADER in last:
        return f"{last.rstrip('.')}; of a force curve {BARE_CURVE}; of moduli {BARE_MODULI}."
    if len(named) < 2 and NO_UNIT_OF_MAP in last and 2 <= bare_columns(file) <= MOST_OF_TABLE:
        return f"{last.rstrip('.')}; of a table without names: {BARE_CURVE}; of moduli {BARE_MODULI}."
    if not named or (len(named) == 1 and "does not state" in last):
        return last
    what, why = named[0]
    return f"{file}: read as {what}: {why}"


def _as_table_or_curve(file: Path, *, brief: bool) -> Inspection | list[tuple[str, str]]:
    """Return a table or a curve; else why it is none, by what was tried."""
    reasons: list[tuple[str, str]] = []
    try:
        head = header_lines(file, ANY_COLUMNS)
    except InvalidInput:
        head = []
    for kind in SPECIFIC:
        found = _by_header(file, head, kind, reasons)
        if found is not None:
            return found
    if not reasons and head and any(names_columns(file, pair[:2], head=head) for pair in MODULI):
        reasons.append(("storage and loss", f"{file}: {NO_FREQUENCY}"))
    curve = _curve(file, brief=brief)
    of_moduli = [one for one in reasons if one[0] in OF_MODULI] if _has_moduli(file, head) else []
    if curve.is_read and not (of_moduli and _is_still(curve.column("position"))):
        return curve
    if curve.is_read:  # a rheometer's sweep of strain, over a gap that stays
        return Inspection(str(file), "", _reason(file, curve.reason, of_moduli))
    is_curve = is_curve_table(file) if head else False
    for kind in GENERAL:
        if is_curve and kind.name == HELD:  # it names a place as well
            continue
        found = _by_header(file, head, kind, reasons)
        if found is not None:
            return found
    if head and names_columns(file, GREATEST, head=head):
        return [("list of results", f"{file}: {OF_GREATEST}"), *reasons]
    lacks = any(one in curve.reason for one in ((LACKS_UNIT, METHOD, BENDING) if head else (LACKS_UNIT,)))
    own = "" if is_curve or lacks or reasons or bare_columns(file) < 2 else OWN_NAMES
    of_curve = ("force curve", curve.reason.rstrip(".") + own if own else curve.reason)
    if lacks or (not head and (states_curves(file) or is_workbook(file))):
        return [of_curve, *reasons]
    if not head or names_columns(file, SCAN, head=head):  # bare numbers, and scans: the reason is that of surfaces
        return reasons
    if is_curve:  # its header names one: no reader of surfaces, which take long to refuse a table, is tried
        # a sweep names a force and a gap, too; a test over the gap has columns of moduli without a number
        reasons = [one for one in reasons if one[0] not in OF_MODULI]
        return Inspection(str(file), "", _reason(file, curve.reason, [*of_moduli, of_curve, *reasons]))
    if names_columns(file, (HEIGHT_COLUMN,), head=head) and not names_columns(file, (FORCE,), head=head):
        reasons.append(("line scan", f"{file}: {NO_PLACES}"))
    return [*reasons, of_curve]


def _has_moduli(file: Path, head: list[str]) -> bool:
    """Return whether the columns of a storage modulus, if there are some, hold numbers."""
    for size in {one[0]: None for one in MODULI}:
        if head and names_columns(file, (size,), head=head):
            try:
                return bool(np.any(read_table(file, (size,)).values > 0.0))
            except InvalidInput:  # rows without one, as between two tests
                return True
    return False


def _is_still(position: InspectedColumn) -> bool:
    """Return whether a gap stays where it is."""
    return position.high - position.low <= STILL * max(abs(position.low), abs(position.high))


def _by_header(file: Path, head: list[str], kind: TableKind, reasons: list[tuple[str, str]]) -> Inspection | None:
    columns = next((header for header in kind.headers if head and names_columns(file, header, head=head)), None)
    if columns is None:
        return None
    words = [column.word for column in columns]
    names = f"{', '.join(words[:-1])} and {words[-1]}" if len(words) > 1 else words[0]
    try:
        return _by_kind(file, kind, f"its header names {names}")
    except InvalidInput as error:
        if names_columns(file, columns):  # the sheet of the head, and its rows of units, may name others
            reasons.append((kind.name, str(error)))
        return None


def _tried(file: Path, kind: TableKind, why: str) -> Inspection | None:
    with contextlib.suppress(InvalidInput):
        return _by_kind(file, kind, f"its {why}")
    return None


def _by_kind(file: Path, kind: TableKind, why: str) -> Inspection:
    tests: list[TablePart] = []
    try:
        content = kind.read(file)
    except InvalidInput:
        tests = parts_of_table(file, kind.headers) if kind.study in BY_TEST else []
        if len(tests) < 2:
            raise
        content = BY_TEST[kind.study](file, test=1)
        why += f"; {tests[0].label}"
    done = (TWO_HOLDS,) if isinstance(content, HeldTable) else log_lines(content)
    if isinstance(content, RelaxationData | CreepData | DynamicData | DynamicSweeps) and content.reading:
        done = (*done, content.reading)
    columns = columns_of(content)
    count = max(len(tests), 1)
    found = Inspection(str(file), kind.name, why, count, columns, (), done, log_doubts(content), content=content)
    found = dataclasses.replace(found, doubts=(*found.doubts, *_table_doubts(file, kind, content)))
    twisted = {column.word for angle in (Angle, Torque) for column in LATERAL_COLUMNS[angle]}
    study = kind.study
    if study == "path" and any(word in why for word in twisted):
        study = "twisted_path"
    return _finished(found, study)


def _table_doubts(file: Path, kind: TableKind, content: object) -> Iterator[str]:
    """Yield what is doubtful about a table by its names: other sheets that name the same, moduli of which kind."""
    sheets = next(filter(None, (sheets_naming(file, columns) for columns in kind.headers)), [])
    if len(sheets) > 1:
        labels = ", ".join(sheet.label.removeprefix("sheet ") for sheet in sheets[1:6]) + " ..." * (len(sheets) > 6)
        how = "test = 2 of a study reads the second" if kind.study in BY_TEST else "save each by itself"
        yield f"The first of {len(sheets)} sheets that name these columns was read, not {labels}; {how}."
    if kind.study == "path" and names_columns(file, (SHEAR_STORAGE,)):
        yield (
            "Its header names a storage modulus too, as a rheometer's sweep of strain does: its force and torque are "
            "those of plates, no path of a contact."
        )
    if isinstance(content, AreaTable):
        beside = [one.word for one in (FORCE, *RESULTS, REDUCED) if names_columns(file, (AREA, one))]
        depth = read_table(file, (CONTACT_DEPTH, AREA)).read_as[0]
        if beside:
            yield (
                f"Its header names a {' and a '.join(beside)} too, as a list of results does: the areas are those of "
                f"the tip only if '{depth}' is the contact depth, not that of the whole travel."
            )
    if isinstance(content, DynamicData | DynamicSweeps):
        head = header_lines(file, ANY_COLUMNS)
        if any(BARE_MODULUS.search(line) for line in head) and not any(OF_SHEAR.search(line) for line in head):
            yield (
                "Nothing in the file says that its storage modulus is that of shear, G'; if it is E', of tension or "
                "bending as in a DMA, name it tensile_storage, and the loss tensile_loss."
            )


def _tip(file: Path) -> Inspection:
    try:
        tip = read_indenter(file)
    except InvalidInput as error:
        run = "if it is a study, solve it by `winkler run` or `winkler fit`"
        return Inspection(str(file), "", f"{str(error).rstrip('.')}; {run}.")
    numbers = ", ".join(f"{one:.4g}" for one in tip.area.coefficients)
    done = (f"area coefficients {numbers} (SI)", f"frame compliance {with_unit(tip.frame_compliance, 'm/N', 4)}")
    return _finished(Inspection(str(file), "calibrated indenter", "its key kind", 1, (), (), done, content=tip), "tip")


def _curve(file: Path, *, brief: bool) -> Inspection:
    """Return the first force curve of a file, and how many there are; without one the reason."""
    begun, count, unread = time.monotonic(), 0, 0
    stopped: tuple[str, ...] = ()
    first, reason = None, ""
    for placed in itertools.islice(try_curves(file, rigid=False), 1 if brief else MOST_CURVES_COUNTED):
        if isinstance(placed, UnreadCurve):
            unread += 1
            reason = reason or placed.reason
        elif first is None:
            first = placed.curve
        count += 1
        if time.monotonic() - begun > LONGEST_COUNT and first is not None:
            stopped = (f"curves were counted for {LONGEST_COUNT:g} s; there may be more",) * (not brief)
            break
    if first is None:
        return Inspection(str(file), "", reason or f"{file}: the file holds no curve; give another one.")
    hard = _is_nanoindentation(first)
    kind = "nanoindentation" if hard else "force curve"
    done = () if brief else (*_done(first, nano=hard), *stopped)
    flags = examined(first) if np.any(first.direction != 0.0) else ()
    doubts = [flag.statement for flag in flags if not (hard and flag.name == "no_baseline")]
    if not np.any(first.direction != 0.0):
        doubts.append(
            f"The tip is held over all {first.position.size} points: the curve has no approach and no retraction."
        )
    doubts += _jumps(first)
    doubts += _unpressed(first)
    if unread:
        doubts.append(f"{unread} of {count} curves cannot be read; the first: {reason}")
    found = Inspection(
        str(file), kind, first.reading, count, _curve_columns(first), (), done, tuple(doubts), content=first
    )
    return _finished(found, "nanoindentation" if hard else "force_curve")


def _jumps(curve: ForceCurve) -> Iterator[str]:
    """Yield that the position jumps, as where a way back is written from its end, or two tests are one."""
    steps = np.abs(np.diff(curve.position))
    if steps.size >= FEWEST_FOR_JUMPS and float(steps.max()) > LEAST_JUMP * float(np.ptp(curve.position)):
        yield (
            f"position: a jump of {with_unit(float(steps.max()), 'm', 3)} behind row {int(np.argmax(steps)) + 1}, more "
            "than half of the travel; a retraction may be stored in reverse order, or two tests below each other."
        )


def _unpressed(curve: ForceCurve) -> Iterator[str]:
    """Yield that the force falls over the whole way in: nothing is touched, or the sign of the force is wrong."""
    inwards = curve.force[curve.direction > 0.0]
    part = inwards.size // UNPRESSED_PARTS
    if part < FEWEST_FOR_JUMPS:
        return
    means = inwards[: part * UNPRESSED_PARTS].reshape(UNPRESSED_PARTS, part).mean(axis=1)
    if np.all(np.diff(means) < 0.0):
        yield (
            f"The force falls during the whole approach, by {with_unit(float(means[0] - means[-1]), 'N', 3)}: the "
            "tip does not touch, or the sign of its deflection is wrong; a fit of it means nothing."
        )


def _curve_columns(curve: ForceCurve) -> tuple[InspectedColumn, ...]:
    return tuple(sorted(columns_of(curve), key=lambda one: ("time", "position", "force").index(one.name)))


def _is_nanoindentation(curve: ForceCurve) -> bool:
    travel = float(np.ptp(curve.position))
    if math.isfinite(curve.machine_stiffness) or not travel > 0.0:
        return False
    unloads = any(one.kind is SegmentKind.LAST_UNLOADING for one in curve.segments)
    return unloads and float(curve.force.max()) > LEAST_HARDNESS * BERKOVICH * travel**2


def _done(curve: ForceCurve, *, nano: bool) -> Iterator[str]:
    """Yield what was done and what happened: segments and events, first touch, drift."""
    yield from curve.events.lines(curve.time if curve.timed else ())
    if not nano:
        return
    try:
        touch = found_zero_point(curve)
    except InvalidInput as error:
        yield f"first touch: {error}"
    else:
        beyond = ", extrapolated: no point was taken before it" if touch.extrapolated else ""
        scatter = f" ± {with_unit(touch.error, 'm', 2)}" if math.isfinite(touch.error) else ""
        yield f"first touch at {with_unit(touch.position, 'm', 5)}{scatter}{beyond}"
    drift = found_drift(curve)
    if drift.measured:
        yield f"drift {with_unit(drift.rate, 'm/s', 3)} ± {with_unit(drift.error, 'm/s', 2)}, measured in a hold"
    else:
        yield f"drift not measured{f': {drift.doubt}' if drift.doubt else ': no hold in contact at a small force'}"


def _finished(found: Inspection, study: str) -> Inspection:
    """Return an inspection with the doubts of its columns, and its study."""
    of_columns: list[str] = []
    if found.taken_for not in SURFACE_KINDS:
        recorded = isinstance(found.content, ForceCurve)
        of_columns = [doubt for column in found.columns for doubt in column.doubts(recorded=recorded)]
    found = dataclasses.replace(found, doubts=(*found.doubts, *of_columns))
    return dataclasses.replace(found, study=starting_study(found, study))
