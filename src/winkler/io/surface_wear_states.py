"""Save and read states of worn height maps: a stopped march is continued from the last one, with the same numbers.

Numbers are kept of all states, maps of the first and the last one alone: a file of a thousand states is as large as one
of two.
"""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from winkler.io.array_file import read_state, write_state
from winkler.io.foreign import reader
from winkler.problems.surface_wear.states import SurfaceWearState
from winkler.values.errors import InvalidInput

__all__ = ["read_surface_wear", "write_surface_wear"]

FORMAT = "winkler surface wear 1"
MAPS = ("worn", "pressure", "separation")
NUMBERS = tuple(field.name for field in dataclasses.fields(SurfaceWearState) if field.name not in MAPS)


def write_surface_wear(states: Sequence[SurfaceWearState], path: str | os.PathLike[str]) -> Path:
    """Save states of a worn map; a file of that name is replaced only once the new one is whole.

    Parameters
    ----------
    states : sequence of SurfaceWearState
        Of one problem, in their order; at least one.
    path : str or path
        The file, of NumPy's kind ``.npz``.

    Returns
    -------
    Path

    Raises
    ------
    InvalidInput
        If there is no state, or the file cannot be written.
    """
    if not states:
        raise InvalidInput(f"{path}: there is no state to save; give at least one.")
    numbers = np.array([[getattr(state, name) for name in NUMBERS] for state in states])
    maps = {name: np.stack([getattr(state, name) for state in (states[0], states[-1])]) for name in MAPS}
    return write_state(path, FORMAT, {"numbers": numbers, **maps})


@reader("wear of a height map")
def read_surface_wear(path: str | os.PathLike[str]) -> tuple[SurfaceWearState, ...]:
    """Return states of a worn map as they were saved; those between the first and the last have empty maps.

    Parameters
    ----------
    path : str or path
        A file that `write_surface_wear` wrote.

    Returns
    -------
    tuple of SurfaceWearState
        The last is the one to continue from: ``problem.steps(start=states[-1])``.

    Raises
    ------
    InvalidInput
        If the file is missing, broken, or of another kind.
    """
    words = ("numbers", *MAPS)
    rows: dict[str, Any] = read_state(path, FORMAT, words, needed=words, what="surface_wear")
    numbers, size = rows["numbers"], rows["worn"].shape
    sound = numbers.dtype.kind == "f" and numbers.ndim == 2 and numbers.shape[1] == len(NUMBERS) and numbers.size > 0
    maps = all(
        rows[name].dtype.kind == "f" and rows[name].shape == size and np.isfinite(rows[name]).all() for name in MAPS
    )
    if not (sound and len(size) == 3 and size[0] == 2 and maps and np.isfinite(numbers).all()):
        raise InvalidInput(
            f"{path}: no wear of a height map can be read from it (its numbers and maps do not fit together); give a "
            "file of write_surface_wear."
        )
    none = np.zeros((0, 0))
    last = len(numbers) - 1

    def state(place: int) -> SurfaceWearState:
        kept = {0: 0, last: 1}.get(place)
        content: dict[str, Any] = dict(zip(NUMBERS, numbers[place].tolist(), strict=True))
        content |= {name: none if kept is None else rows[name][kept] for name in MAPS}
        return SurfaceWearState(**content)

    return tuple(state(place) for place in range(len(numbers)))
