"""Which instrument has written a file, and the tests in it."""

from __future__ import annotations

import zipfile
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from winkler.io.archive_file import refuse_large_archive
from winkler.io.foreign import path_text
from winkler.io.instruments.asylum_pair import (
    ENDING,
    is_asylum_half,
    tests_of_asylum_columns,
    tests_of_asylum_pair,
)
from winkler.io.instruments.femtotools import is_femtotools, tests_of_femtotools
from winkler.io.instruments.fischerscope import is_fischerscope, tests_of_fischerscope
from winkler.io.instruments.hysitron import is_hld, is_nano_dma, tests_of_hld, tests_of_nano_dma
from winkler.io.instruments.instrument_test import InstrumentTest
from winkler.io.instruments.jpk_text import is_jpk_text, tests_of_jpk_text
from winkler.io.instruments.micro_materials import NAME, is_micro_materials, tests_of_micro_materials
from winkler.io.instruments.nanoscope import is_nanoscope, tests_of_nanoscope
from winkler.io.instruments.nanosurf import is_nanosurf_text, tests_of_nanosurf_text
from winkler.io.instruments.nanosurf_nid import is_nanosurf_nid, tests_of_nanosurf_nid
from winkler.io.instruments.universal_text import is_universal_text, tests_of_universal_text
from winkler.io.instruments.workbook import tests_of_workbook
from winkler.io.tables.given_units import GivenFacts
from winkler.io.text_file import head_of, lines_of, lines_of_bytes
from winkler.io.workbooks.workbook_cells import is_workbook
from winkler.values.errors import InvalidInput
from winkler.values.limits import HEADER_LETTERS

UNREAD = (".tdm", ".tdx")
"""Files of Hysitron in a format of National Instruments, of which no public one was found to compare numbers with."""
METHOD = "it is the method"
"""Of a test, which some export in place of its numbers."""
JPK_CURVES = (".jpk-force", ".jpk-qi-data")
"""How the endings of JPK's files of curves begin."""
Tests = Iterator[InstrumentTest]


def states_curves(path: Path) -> bool:
    """Return whether the first bytes of a file say that an instrument wrote force curves to it."""
    ending = path.suffix.lower()
    return is_nanosurf_nid(path) or is_nanoscope(path, images=False) or ending.startswith(JPK_CURVES)


def instrument_tests(path: Path, given: GivenFacts, *, is_text: bool) -> Tests | None:
    """Return the tests of a file of a nanoindenter; None if it is none of those that need an own reader.

    Parameters
    ----------
    path : path
        An existing file.
    given : GivenFacts
        What the file may not state.
    is_text : bool
        Whether it may be a text.

    Raises
    ------
    InvalidInput
        If it cannot be read.
    """
    if path.suffix.lower() in UNREAD:
        raise InvalidInput(
            f"{path}: files of TDM (an index .tdm, and numbers in .tdx) are not read; export the test from the "
            "indenter's software as text (.txt) or as .hld."
        )
    if is_workbook(path):
        return tests_of_workbook(path)
    if is_archive_of_tests(path):
        return tests_of_archive(path)
    if is_nanoscope(path):
        return tests_of_nanoscope(path, given)
    if is_nanosurf_nid(path):
        return tests_of_nanosurf_nid(path, given)
    if is_asylum_half(path):
        return tests_of_asylum_pair(path, given)
    if path.suffix.lower() == ENDING:
        return tests_of_asylum_columns(path, given)
    if not is_text:
        return None
    head = head_of(path, "a force curve")
    refuse_method(head, path)
    readers: list[tuple[bool, Callable[[list[str]], Tests]]] = [
        (is_hld(head), lambda lines: tests_of_hld(lines, path.name, path)),
        (is_nano_dma(head), lambda lines: tests_of_nano_dma(lines, path.name, path)),
        (is_fischerscope(head), lambda lines: tests_of_fischerscope(lines, path.name, path, dict(given.units))),
        (is_jpk_text(head), lambda lines: tests_of_jpk_text(lines, path.name, path, given)),
        (is_universal_text(head), lambda lines: tests_of_universal_text(lines, path.name, path, given)),
        (is_nanosurf_text(head), lambda lines: tests_of_nanosurf_text(lines, path.name, path, given)),
        (is_femtotools(head), lambda lines: tests_of_femtotools(lines, path.name, path)),
        (is_micro_materials(head, path.name), lambda lines: tests_of_micro_materials(lines, path.name, path)),
    ]
    read = next((read for fits, read in readers if fits), None)
    return read(lines_of(path, "a force curve")) if read is not None else None


def refuse_method(head: Sequence[str], path: object) -> None:
    """Refuse a text that holds the method of a test.

    Raises
    ------
    InvalidInput
    """
    if any(line.startswith("Method Name :") for line in head[:3]):
        method = head[0].partition(":")[2].strip().rpartition("\\")[2]
        raise InvalidInput(
            f"{path}: there is no table of a force curve in this text; {METHOD} '{method}' of NanoSuite "
            "(channels and inputs), and its curves are in the workbook (.xls) that NanoSuite exports."
        )


MOST_BYTES = 20_000_000
"""Of one test; those of NanoTest have some 30 kB."""


def is_archive_of_tests(path: Path) -> bool:
    """Return whether an archive holds exports of Micro Materials and nothing else."""
    if path.suffix.lower() != ".zip" or not zipfile.is_zipfile(path):
        return False
    with zipfile.ZipFile(path) as archive:
        names = _texts(archive)
        if not names or not all(NAME.fullmatch(Path(name).name) for name in names):
            return False
        refuse_large_archive(path, "save a part of the tests")
        with archive.open(names[0]) as file:
            start = file.read(HEADER_LETTERS)
    try:
        head = lines_of_bytes(start, names[0], "a curve", is_cut=len(start) == HEADER_LETTERS)
    except InvalidInput:  # its reader names what it cannot read
        return False
    return is_micro_materials(head, Path(names[0]).name)


def tests_of_archive(path: Path) -> Iterator[InstrumentTest]:
    """Yield the tests of an archive, in the order of their names."""
    with zipfile.ZipFile(path) as archive:
        for name in _texts(archive):
            where, size = f"{path_text(path)}, {name}", archive.getinfo(name).file_size
            if size > MOST_BYTES:
                raise InvalidInput(
                    f"{where}: {size / 1e6:.0f} MB are too much; at most {MOST_BYTES / 1e6:.0f} MB are read."
                )
            lines = lines_of_bytes(archive.read(name), where, "a curve")
            yield from tests_of_micro_materials(lines, Path(name).name, where)


def _texts(archive: zipfile.ZipFile) -> list[str]:
    return sorted(name for name in archive.namelist() if not name.endswith("/") and "__MACOSX" not in name)
