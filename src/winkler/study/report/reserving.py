"""One run at a time into a folder of results, and what killed runs have left beside it.

A run holds the lock ``.NAME.lock`` beside its folder.  Whoever gets it knows that nobody else is writing there: what
lies beside the folder half-written is of a run that was killed.
"""

from __future__ import annotations

import contextlib
import glob
import os
import shutil
from collections.abc import Iterator
from pathlib import Path

from winkler.errors import InvalidInput
from winkler.study.batch.locking import locked
from winkler.study.batch.stopping import deferred_signals
from winkler.study.report.writing import OLD, PARTIAL, holds_results, unwritable

__all__ = ["reserved"]

HEX = "[0-9a-f]"


@contextlib.contextmanager
def reserved(folder: Path) -> Iterator[None]:
    """Keep a folder of results for this run, and remove first what runs that were killed have left beside it.

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
                alone = stack.enter_context(locked(parent / f".{folder.name}.lock"))
            except BlockingIOError:
                raise InvalidInput(
                    f"output: another run is writing into '{folder}'; wait for its end, or give another folder with "
                    "--output."
                ) from None
            except OSError as error:
                raise unwritable(folder, error) from None
            if alone:
                _put_right(folder)
            try:
                yield
            finally:
                if alone:
                    _put_right(folder)
    finally:
        for path in created:
            with contextlib.suppress(OSError):
                path.rmdir()


def _put_right(folder: Path) -> None:
    """Remove what is half-written, and give results back their name that were put aside and not replaced."""
    name, parent = glob.escape(folder.name), folder.parent
    with deferred_signals():
        for aside in parent.glob(f".{name}.{HEX * 12}{OLD}"):
            if aside.with_suffix(PARTIAL).exists() and not folder.exists():
                with contextlib.suppress(OSError):
                    os.rename(aside, folder)
            else:
                shutil.rmtree(aside, ignore_errors=True)
        for partial in parent.glob(f".{name}.{HEX * 12}{PARTIAL}"):
            shutil.rmtree(partial, ignore_errors=True)
        for part in parent.glob(f"..{name}.{HEX * 16}.*.part"):
            with contextlib.suppress(OSError):
                part.unlink()
