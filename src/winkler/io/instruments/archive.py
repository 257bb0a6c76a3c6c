"""Archives (.zip) of texts of one instrument."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator
from pathlib import Path

from winkler.io.archive_file import refuse_large_archive
from winkler.io.foreign import path_text
from winkler.io.instruments.instrument_test import InstrumentTest
from winkler.io.instruments.micro_materials import NAME, is_micro_materials, tests_of_micro_materials
from winkler.io.text_file import lines_of_bytes
from winkler.values.errors import InvalidInput
from winkler.values.limits import HEADER_LETTERS

__all__ = ["is_archive_of_tests", "tests_of_archive"]

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
