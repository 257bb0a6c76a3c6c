"""``winkler show FILE``: what files are taken for, their columns, what was done, what is doubtful, and a study."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from winkler.cli.options import refuse_existing
from winkler.cli.streams import until_closed, write_json, write_line
from winkler.values.errors import InvalidInput

if TYPE_CHECKING:
    from winkler.study.inspection.inspection import Inspection
    from winkler.study.inspection.surfaces import SurfaceOptions

MOST_FILES = 10_000
"""Files of a list."""
LONGEST_LIST = 60.0
"""Time after which no further file of a list is read [s]."""
LONGEST_LINE = 100
"""Characters of a doubt in a list."""


class ShownFile(NamedTuple):
    """What is done with a file besides showing it: its picture, and the study that is written."""

    output: Path | None = None
    write: Path | None = None
    overwrite: bool = False
    as_json: bool = False


def files_named(words: list[str]) -> list[Path]:
    """Return the files and folders that words mean; empty where they mean something else.

    No kind, group or material has a dot or a slash.
    """
    paths = [Path(word) for word in words]
    if words and all("." in word or "/" in word or "\\" in word or Path(word).is_dir() for word in words):
        return paths
    whole = " ".join(words)
    return [Path(whole)] if any(mark in whole for mark in "./\\") and Path(whole).exists() else []


def show_files(paths: list[Path], options: SurfaceOptions | None, how: ShownFile) -> None:
    """Show one file, or a list of several and of those in folders.

    Raises
    ------
    InvalidInput
        If a file does not exist or cannot be read, or the picture or the study cannot be written.
    """
    from winkler.study.inspection.inspect import inspect_file

    if len(paths) > 1 or paths[0].is_dir():
        _list(paths, options, how)
        return
    path = paths[0]
    _refuse(how)
    found = inspect_file(path, options)
    if not found.is_read:
        raise InvalidInput(found.reason)
    if how.output is not None and found.taken_for not in DRAWN:
        raise InvalidInput(
            f"{path}: --output draws height maps, line scans and curves, and this is a {found.taken_for}."
        )
    if how.write is not None:
        _write(found, os.path.relpath(path, how.write.parent), how)
    if how.as_json:
        write_json(found.table())
    else:
        _print(found)
    if how.output is not None:
        _draw(found, how.output)
    if not how.as_json:
        _say_written(how)


DRAWN = ("height map", "line scan", "force curve", "nanoindentation")
"""What ``--output`` draws."""


def _refuse(how: ShownFile) -> None:
    """Refuse what would replace a file, before anything is read."""
    from winkler.study.language.study import PICTURES

    if how.output is not None:
        if how.output.suffix.lstrip(".").lower() not in PICTURES:
            endings = ", ".join(f".{ending}" for ending in PICTURES)
            raise InvalidInput(f"show: '{how.output}' does not end like a picture; give {endings}.")
        refuse_existing(how.output, how.overwrite, "show: ")
    if how.write is not None:
        if how.write.suffix.lower() != ".toml":
            raise InvalidInput(f"show: --write is '{how.write}'; a study ends in .toml.")
        refuse_existing(how.write, how.overwrite, "show: ")


def _say_written(how: ShownFile) -> None:
    if how.output is not None:
        write_line(f"Written {how.output}")
    if how.write is not None:
        command = "fit" if _fits(how.write) else "run"
        write_line(f"Written {how.write}; run it with: winkler {command} {how.write}")


def _fits(study: Path) -> bool:
    from winkler.cli.measured_problem import is_measured_problem
    from winkler.study.language.reading import parsed, read_text

    raw = parsed(read_text(study), study.name)
    return "fit" in raw or "indentation" in raw or is_measured_problem(study)


def _write(found: Inspection, file: str, how: ShownFile) -> None:
    from winkler.io.whole_file import write_whole
    from winkler.study.inspection.starting import placed_study

    assert how.write is not None
    if not found.study:
        raise InvalidInput(f"{found.file}: there is no study to start from for a {found.taken_for}; leave --write out.")
    text = placed_study(found, Path(file).as_posix()).replace("STUDY", str(how.write))
    write_whole({how.write: text.encode()})


def _list(paths: list[Path], options: SurfaceOptions | None, how: ShownFile) -> None:
    """Show a list, a row for each file."""
    from winkler.cli.terminal import tracked
    from winkler.study.inspection.inspect import inspect_files

    if options is not None or how.output is not None:
        raise InvalidInput("show: several files make a list; options of one file are for one: give its path alone.")
    _refuse(how)
    files = list(_files(paths))
    if not files:
        raise InvalidInput(f"{paths[0]}: the folder holds no files; give another one.")
    taken = files[:MOST_FILES]
    found = dict(tracked(inspect_files(taken, LONGEST_LIST), len(taken), hidden=how.as_json, doing="reading"))
    rows = [found[place] for place in sorted(found)]
    left = len(files) - len(rows)
    if how.write is not None:
        _write_batch(paths, rows, how)
    if how.as_json:
        write_json({"files": [one.table() for one in rows], "not_read": left})
        return
    _print_list(rows, left)
    _say_written(how)


def _files(paths: list[Path]) -> Iterator[Path]:
    """Yield files, and those in folders in the order of their names."""
    import re

    def in_numbers(path: Path) -> list[tuple[int, str]]:
        return [(int(part), "") if part.isdecimal() else (-1, part) for part in re.split(r"(\d+)", path.name)]

    for path in paths:
        if path.is_dir():
            yield from sorted(
                (one for one in path.iterdir() if one.is_file() and not one.name.startswith(".")), key=in_numbers
            )
        else:
            yield path


def _write_batch(paths: list[Path], rows: list[Inspection], how: ShownFile) -> None:
    """Write one study of all curves of a folder."""
    assert how.write is not None
    kinds = {one.taken_for for one in rows if one.is_read}
    if len(paths) > 1 or not paths[0].is_dir():
        raise InvalidInput("show: --write makes one study of a file or of the curves of a folder; give one of them.")
    if len(kinds) != 1 or kinds <= {"height map", "line scan"} or not kinds <= set(DRAWN):
        there = ", ".join(sorted(kinds)) or "nothing that can be read"
        raise InvalidInput(f"show: a study of a folder evaluates curves of one kind, and {paths[0]} holds {there}.")
    first = next(one for one in rows if one.is_read)
    _write(first, os.path.relpath(paths[0], how.write.parent), how)


@until_closed()
def _print(found: Inspection) -> None:
    from winkler.cli import terminal
    from winkler.study.language.explain import plain_symbol
    from winkler.values.readable import with_unit

    out = terminal.console()
    many = f", the first of {found.count}" if found.count > 1 else ""
    out.print(f"{Path(found.file).name}: {found.taken_for}{many}")
    out.print(f"Taken for it by: {found.reason}", soft_wrap=True)
    if found.columns:
        table = terminal.table("column", "symbol", "numbers", "range", "in the order of the file")
        for one in found.columns:
            numbers = str(one.values.size)
            table.add_row(one.name, plain_symbol(one.symbol), numbers, one.range, one.sparkline)
        out.print(table)
    if found.numbers:
        table = terminal.table("symbol", "value", "meaning")
        for number in found.numbers:
            table.add_row(plain_symbol(number.symbol), with_unit(number.value, number.unit), number.meaning)
        out.print(table)
    for title, lines in (("What was done", found.done), ("What is doubtful", found.doubts)):
        if lines:
            out.print(f"{title}:")
        for line in lines:
            out.print(f"- {line}", soft_wrap=True)
    if found.study:
        out.print("--write STUDY.toml writes a study to start from.")


@until_closed()
def _print_list(rows: list[Inspection], left: int) -> None:
    from winkler.cli import terminal

    out = terminal.console()
    table = terminal.table("file", "read as", "values", "range of the last column", "", "doubtful")
    for one in rows:
        last = one.columns[-1] if one.columns else None
        reason = one.reason.removeprefix(f"{one.file}: ")
        doubt = reason if not one.is_read else one.doubts[0] if one.doubts else ""
        more = f" and {len(one.doubts) - 1} more" if len(one.doubts) > 1 else ""
        cut = doubt if len(doubt) <= LONGEST_LINE else f"{doubt[:LONGEST_LINE]} ..."
        table.add_row(
            Path(one.file).name,
            one.taken_for or "not read",
            str(last.values.size) if last else "",
            last.range if last else "",
            last.sparkline if last else "",
            cut + more,
        )
    out.print(table)
    counts: dict[str, int] = {}
    for one in rows:
        counts[one.taken_for or "not read"] = counts.get(one.taken_for or "not read", 0) + 1
    out.print(f"{len(rows)} files: {', '.join(f'{count} {kind}' for kind, count in counts.items())}.")
    if left:
        out.print(f"{left} more files were not read; the limits are {MOST_FILES} files and {LONGEST_LIST:.0f} s.")


def _draw(found: Inspection, output: Path) -> None:
    from winkler.io.whole_file import write_whole
    from winkler.plot.picture_file import picture_file
    from winkler.plot.registered import sheet_of_kind

    write_whole({output: picture_file(sheet_of_kind(found.content), output.suffix[1:].lower())})
