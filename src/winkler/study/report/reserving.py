"""Reserve a folder of results for one run, and remove what killed runs have left beside it.

A run holds the lock ``.NAME.lock`` beside its folder.  With the lock no other run is writing there, so that an
incomplete folder beside it belongs to a run that was killed.
"""

from __future__ import annotations

import contextlib
import glob
import os
import shutil
from collections.abc import Iterator
from pathlib import Path

from winkler.io.processes.locking import locked
from winkler.io.processes.stopping import deferred_signals
from winkler.io.whole_file import remove_left, unwritable
from winkler.study.report.writing import FOLDER, OLD, PARTIAL, holds_results
from winkler.values.errors import InvalidInput

HEX_DIGIT = "[0-9a-f]"


@contextlib.contextmanager
def reserved(folder: Path) -> Iterator[None]:
    """Reserve a folder of results for this run, and remove first what killed runs have left beside it.

    Folders above it are made, and removed again if nothing was put there.

    Parameters
    ----------
    folder
        Where the results go.

    Raises
    ------
    InvalidInput
        If another run is writing there, or the folder cannot be used.
    """
    holds_results(folder)
    parent = folder.parent
    created = [path for path in (parent, *parent.parents) if not path.exists()]
    try:
        with contextlib.ExitStack() as stack:
            try:
                parent.mkdir(parents=True, exist_ok=True)
                has_lock = stack.enter_context(locked(parent / f".{folder.name}.lock"))
            except BlockingIOError:
                raise InvalidInput(
                    f"output: another run is writing into '{folder}'; wait for its end, or give another folder with "
                    "--output."
                ) from None
            except OSError as error:
                raise unwritable(folder, error, option=FOLDER) from None
            if has_lock:
                _clean_up(folder)
            try:
                yield
            finally:
                if has_lock:
                    _clean_up(folder)
    finally:
        for path in created:
            with contextlib.suppress(OSError):
                path.rmdir()


def _clean_up(folder: Path) -> None:
    """Remove incomplete folders, and restore the name of results that were put aside and not replaced."""
    name, parent = glob.escape(folder.name), folder.parent
    with deferred_signals():
        for aside in parent.glob(f".{name}.{HEX_DIGIT * 12}{OLD}"):
            if aside.with_suffix(PARTIAL).exists() and not folder.exists():
                with contextlib.suppress(OSError):
                    os.rename(aside, folder)
            else:
                shutil.rmtree(aside, ignore_errors=True)
        for partial in parent.glob(f".{name}.{HEX_DIGIT * 12}{PARTIAL}"):
            shutil.rmtree(partial, ignore_errors=True)
        remove_left(parent)
