"""Arrays in a file of NumPy's kind ``.npz``: what stood there is replaced only once the new one is whole.

The version of winkler stands beside them.
"""

from __future__ import annotations

import os
import zipfile
from collections.abc import Mapping
from importlib.metadata import version
from pathlib import Path

import numpy as np

from winkler.errors import InvalidInput
from winkler.numerics.types import Array

__all__ = ["version_of", "write_arrays"]


def version_of(path: Path) -> str:
    """Return the version of winkler that wrote a file; empty if the file does not tell."""
    try:
        with np.load(path, allow_pickle=False) as stored:
            return str(stored["version"])
    except (OSError, ValueError, KeyError, EOFError, TypeError, zipfile.BadZipFile):
        return ""


def write_arrays(path: Path, arrays: Mapping[str, Array]) -> None:
    """Write arrays beside the file, and then put them in its place.

    Raises
    ------
    InvalidInput
        If there is no such folder, or its file cannot be written.
    """
    partial = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        with partial.open("wb") as file:
            np.savez(file, allow_pickle=False, version=np.array(version("winkler")), **arrays)
            file.flush()
            os.fsync(file.fileno())
        partial.replace(path)
    except OSError as error:
        partial.unlink(missing_ok=True)
        raise InvalidInput(
            f"{path}: cannot be written ({error.strerror}); name a file in a folder that exists."
        ) from None
    except BaseException:
        partial.unlink(missing_ok=True)
        raise
