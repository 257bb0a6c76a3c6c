"""Save and read states of wear: a stopped march is continued from the last one, with the same numbers."""

from __future__ import annotations

import dataclasses
import os
import typing
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.io.array_file import read_state, write_state
from winkler.io.foreign import reader
from winkler.problems.wear.line_states import LineFrettingState, LineWearState
from winkler.problems.wear.states import FrettingState, WearState
from winkler.values.errors import InvalidInput

__all__ = ["read_wear", "write_wear"]

FORMAT = "winkler wear 1"
ABSENT = np.array("")
KINDS: dict[str, type[WearState | LineWearState]] = {
    "sliding": WearState,
    "fretting": FrettingState,
    "line_sliding": LineWearState,
    "line_fretting": LineFrettingState,
}


def _field_names(kind: type[WearState | LineWearState]) -> tuple[str, ...]:
    return tuple(field.name for field in dataclasses.fields(kind) if field.name != "bed")


def _count(kind: type[WearState | LineWearState], rows: dict[str, Any], path: str | os.PathLike[str]) -> int:
    """Return the number of states, if all arrays agree on it."""
    count, nodes = (*rows.get("places" if issubclass(kind, LineWearState) else "radii", ABSENT).shape, 0, 0)[:2]
    types = typing.get_type_hints(kind)
    for word in _field_names(kind):
        row, wanted = rows.get(word, ABSENT), (count,) if types[word] is float else (count, nodes)
        if row.dtype.kind != "f" or row.shape != wanted or np.isnan(row).any():
            raise InvalidInput(
                f"{path}: no wear can be read from it ({word} is not numbers of the shape {wanted}); give a file "
                "of write_wear."
            )
    return int(count)


def write_wear(states: Sequence[WearState | LineWearState], path: str | os.PathLike[str]) -> Path:
    """Save states of wear; a file of that name is replaced only once the new one is whole.

    Parameters
    ----------
    states : sequence of WearState, FrettingState, LineWearState or LineFrettingState
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
    kind = next(name for name, cls in KINDS.items() if type(states[0]) is cls)
    rows = {word: np.array([getattr(state, word) for state in states]) for word in _field_names(KINDS[kind])}
    return write_state(path, FORMAT, {"kind": np.array(kind), **rows})


@reader("wear")
def read_wear(
    bed: Foundation | LineFoundation | LayeredLineFoundation, path: str | os.PathLike[str]
) -> tuple[WearState | LineWearState, ...]:
    """Return states of wear as they were saved.

    Parameters
    ----------
    bed : Foundation, LineFoundation or LayeredLineFoundation
        The springs before wear, of the problem whose states they are.
    path : str or path
        A file that `write_wear` wrote.

    Returns
    -------
    tuple of WearState, FrettingState, LineWearState or LineFrettingState
        The last is the one to continue from: ``problem.steps(start=states[-1])``.

    Raises
    ------
    InvalidInput
        If the file is missing, broken, or of another kind.
    """
    wanted = {word for kind in KINDS.values() for word in _field_names(kind)}
    rows: dict[str, Any] = read_state(path, FORMAT, ("kind", *sorted(wanted)), needed=("kind",), what="wear")
    name = str(rows.pop("kind"))
    if name not in KINDS:
        raise InvalidInput(f"{path}: it does not hold '{FORMAT}'; give one that this version wrote.")
    kind: Any = KINDS[name]
    count = _count(kind, rows, path)

    def state(i: int) -> WearState | LineWearState:
        rows_of = {word: rows[word] for word in _field_names(kind)}
        content: dict[str, Any] = {word: float(row[i]) if row.ndim == 1 else row[i] for word, row in rows_of.items()}
        made: WearState | LineWearState = kind(bed, **content)
        return made

    return tuple(state(i) for i in range(count))
