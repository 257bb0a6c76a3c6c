"""The folder of results: written completely or not at all.

Everything is written into a hidden folder beside the wanted one, which takes its name when it is complete.  Two runs
into one folder never mix, and a run that is stopped leaves what was there before.  What a killed run leaves, the
next one removes: see `winkler.study.report.reserving`.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import uuid
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from winkler.io.foreign import path_text
from winkler.io.processes.stopping import deferred_signals, raise_pending, set_kept_text
from winkler.io.whole_file import FULL, unwritable, write_new
from winkler.study.batch.outcome import Outcome, Provenance
from winkler.study.language.writing import study_text
from winkler.values.errors import InvalidInput

if TYPE_CHECKING:
    from winkler.study.batch.fit_outcome import FitOutcome
    from winkler.study.batch.journal import Journal


PROVENANCE = "provenance.json"
"""File that marks a folder of results, and lists its files."""
MOST_NAME_BYTES = 220
"""Longest name of a folder [bytes]; names of hidden files beside it are longer, and file systems allow 255."""
FOLDER = "folder with --output"
BLOCK_BYTES = 4096
"""How much more than its bytes a small file takes on a disk."""
PARTIAL, OLD = ".partial", ".old"
"""Endings of folders that are being written, and of those put aside; a mark of the run stands in front."""


def outcome_files(outcome: Outcome | FitOutcome, *, pages: int = 0) -> dict[str, bytes]:
    """Return the files of the results of a study: name in their folder -> content.

    Numbers (NetCDF and CSV), figures, report.html, the study itself (study.toml, which runs again to the same
    numbers), and provenance.json; of fits also pages of the first curves.
    """
    shown = outcome.study.output.report or outcome.study.output.figures
    if isinstance(outcome, Outcome):
        from winkler.study.report import archive

        files = archive.archive_files(outcome)
        if shown:
            from winkler.study.report import report

            files |= report.report_files(outcome)
        text, left = study_text(outcome.study), 0
    else:
        from winkler.study.report import fit_writing

        files = fit_writing.number_files(outcome)
        if shown:
            from winkler.study.report import fit_report, page_parts

            files |= page_parts.page_files(outcome, fit_report.figures_of(outcome), fit_report.page)
        if pages:
            from winkler.study.report.fits.pages import curve_pages

            files |= curve_pages(outcome, pages)
        text, left = outcome.study.text, outcome.left
    if outcome.study.output.workbook:
        from winkler.io.workbooks.table_workbook import workbook_file

        files |= workbook_file(files)
    if text:
        files["study.toml"] = text.encode("utf-8")
    return with_provenance(files, outcome.provenance, missing=left)


def with_provenance(files: dict[str, bytes], made: Provenance, *, missing: int = 0) -> dict[str, bytes]:
    """Return files with provenance.json, which lists them.

    Parameters
    ----------
    files
        Name -> content.
    made
        Provenance of the numbers.
    missing
        Number of curves of an interrupted batch that were not reached.
    """
    content = {
        "program": "winkler",
        "version": made.version,
        "sources": made.sources,
        "study": made.source,
        "hash": made.hash,
        "created": made.created,
        "seconds": made.seconds,
        "packages": dict(made.packages),
        **({"missing": missing} if missing else {}),
        "files": [*sorted(files), PROVENANCE],
    }
    return files | {PROVENANCE: (json.dumps(content, indent=2) + "\n").encode("utf-8")}


def write_files(files: Mapping[str, bytes], folder: Path, journal: Journal | None = None) -> None:
    """Write files into a folder, and folders in it, that nobody else sees yet.

    Parameters
    ----------
    files
        Name -> content.
    folder
        Must exist.
    journal
        Record of the same numbers on the same disk: it is removed if the files fit in its place, and only then.

    Raises
    ------
    OSError
        If one cannot be written.
    """
    left = sum(map(len, files.values())) + BLOCK_BYTES * len(files)
    with contextlib.ExitStack() as rest:
        for name, content in files.items():
            path = folder / name
            try:
                write_new(path, content)
            except OSError as error:
                written = path.stat().st_size if path.exists() else 0
                if error.errno not in FULL or journal is None or journal.size + written < left:
                    raise
                rest.enter_context(deferred_signals())  # a stop before the end would lose what is in neither
                journal.remove()
                journal = None
                write_new(path, content)
            left -= len(content) + BLOCK_BYTES


def _files(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if not path.is_dir())


def holds_results(folder: Path) -> bool:
    """Return whether `folder` holds results that a new run would replace; False if it is free.

    Raises
    ------
    InvalidInput
        If the folder cannot be used: it is a file, or holds anything that winkler did not write.
    """
    if "\0" in str(folder) or len(os.fsencode(folder.name)) > MOST_NAME_BYTES:
        raise InvalidInput(
            f"output: '{path_text(folder)}' has a name that cannot be used; give a folder whose name has at most "
            f"{MOST_NAME_BYTES} bytes, with --output."
        )
    if _is_here(folder):
        raise InvalidInput(f"output: '{folder}' is the working directory or contains it; give a folder inside it.")
    try:
        for ancestor in folder.parents:
            if ancestor.is_file():
                raise InvalidInput(f"output: '{folder}' lies in '{ancestor}', which is a file; give another folder.")
        if not folder.exists():
            return False
        if not folder.is_dir():
            raise InvalidInput(f"output: '{folder}' is a file; give a folder.")
        present = _files(folder)
    except OSError as error:
        raise unwritable(folder, error, option=FOLDER) from None
    if not present and not any(folder.iterdir()):
        return False
    foreign = [name for name in present if name not in _listed(folder)]
    if foreign or not present:
        names = ", ".join(foreign[:3]) or "other folders"
        raise InvalidInput(
            f"output: '{folder}' holds what winkler did not write ({names}); give another folder, or move that away."
        )
    return True


def missing(folder: Path) -> int:
    """Return how many curves are missing in results of a batch that was interrupted; zero if it was not."""
    count = _provenance(folder).get("missing", 0)
    return count if isinstance(count, int) else 0


def _listed(folder: Path) -> set[str]:
    try:
        return set(_provenance(folder)["files"])
    except (KeyError, TypeError):
        return set()


def _provenance(folder: Path) -> dict[str, Any]:
    """Return the content of provenance.json; empty if winkler did not write it."""
    try:
        content = json.loads((folder / PROVENANCE).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return content if isinstance(content, dict) and content.get("program") == "winkler" else {}


def _is_here(folder: Path) -> bool:
    here, there = Path.cwd().resolve(), folder.resolve()
    return there == here or there in here.parents


@contextlib.contextmanager
def placed(folder: Path, *, overwrite: bool) -> Iterator[Path]:
    """Provide an empty folder to write into; at the end it is renamed to `folder`, unless an error or a stop occurs.

    Parameters
    ----------
    folder
        Where the results go; the folder that holds it is there, as `winkler.study.report.reserving.reserved` sees to.
    overwrite
        Whether results of an earlier run may be replaced.

    Raises
    ------
    InvalidInput
        If the folder cannot be used or written.
    """
    if holds_results(folder) and not overwrite:
        raise _occupied(folder)
    mark = f".{folder.name}.{uuid.uuid4().hex[:12]}"
    partial = folder.parent / f"{mark}{PARTIAL}"
    done = False
    try:
        try:
            partial.mkdir()
            yield partial
            raise_pending()
            with (
                deferred_signals()
            ):  # a stop between the two names, or before the old results are gone, would leave both
                _move_into_place(partial, folder, folder.parent / f"{mark}{OLD}", overwrite)
                done = True
                set_kept_text(f"the results in {folder} are complete")
        except OSError as error:
            raise unwritable(folder, error, option=FOLDER) from None
    finally:
        if not done:
            with deferred_signals():
                shutil.rmtree(partial, ignore_errors=True)


def _occupied(folder: Path) -> InvalidInput:
    return InvalidInput(
        f"output: '{folder}' already holds results; add --overwrite to replace them, or give another folder "
        "with --output."
    )


def _move_into_place(partial: Path, folder: Path, previous: Path, overwrite: bool) -> None:
    """Give `partial` the name `folder`; what was there goes `aside` and is removed only afterwards."""
    moved = False
    try:
        if holds_results(folder):
            if not overwrite:
                raise _occupied(folder)
            os.rename(folder, previous)
            moved = True
        elif folder.exists():
            folder.rmdir()
        os.rename(partial, folder)
    finally:
        if moved and not folder.exists():
            os.rename(previous, folder)
        elif moved:
            shutil.rmtree(previous, ignore_errors=True)
