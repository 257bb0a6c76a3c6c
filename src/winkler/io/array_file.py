"""Arrays in a file of NumPy's kind ``.npz``: what stood there is replaced only once the new one is whole."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from winkler.errors import InvalidInput
from winkler.numerics.types import Array

__all__ = ["write_arrays"]


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
            np.savez(file, allow_pickle=False, **arrays)
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
