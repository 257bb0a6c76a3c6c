"""Save and read states of wear: a stopped march is continued from the last one, with the same numbers.

Numbers and rows of nodes are kept of all states, height maps of the first and the last one alone: a file of a thousand
states of a map is as large as one of two.
"""

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
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.io.array_file import read_state, write_state
from winkler.io.foreign import reader
from winkler.numerics.types import Array
from winkler.problems.surface_wear.states import SurfaceWearState
from winkler.problems.wear.line_states import LineFrettingState, LineWearState
from winkler.problems.wear.states import FrettingState, WearState
from winkler.values.errors import InvalidInput

FORMAT = "winkler wear 2"
State = WearState | LineWearState | SurfaceWearState
KINDS: dict[str, type[State]] = {
    "sliding": WearState,
    "fretting": FrettingState,
    "line_sliding": LineWearState,
    "line_fretting": LineFrettingState,
    "surface": SurfaceWearState,
}
OF_NODES, OF_MAPS = 2, 3
"""Dimensions of an array of rows of nodes, one for each state, and of maps, of the first and the last state."""


def _field_names(kind: type[State]) -> tuple[str, ...]:
    return tuple(field.name for field in dataclasses.fields(kind) if field.name != "bed")


def _row(states: Sequence[State], word: str) -> Array:
    """Return a field of all states, or a map of the first and the last."""
    kept = (states[0], states[-1]) if np.ndim(getattr(states[0], word)) == OF_MAPS - 1 else states
    return np.array([getattr(state, word) for state in kept])


def write_wear(states: Sequence[State], path: str | os.PathLike[str]) -> Path:
    """Save states of wear; a file of that name is replaced only once the new one is whole.

    Parameters
    ----------
    states : sequence of WearState, FrettingState, LineWearState, LineFrettingState or SurfaceWearState
        Of one problem, in their order; at least one.
    path : str or path
        Path of the file, in NumPy's format ``.npz``.

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
    rows = {word: _row(states, word) for word in _field_names(KINDS[kind])}
    return write_state(path, FORMAT, {"kind": np.array(kind), **rows})


@reader("wear")
def read_wear(
    path: str | os.PathLike[str],
    bed: Foundation | LineFoundation | LayeredLineFoundation | PowerLawLineFoundation | None = None,
) -> tuple[State, ...]:
    """Return states of wear as they were saved; of height maps those between the first and the last have empty maps.

    Parameters
    ----------
    path : str or path
        A file that `write_wear` wrote.
    bed : Foundation, LineFoundation, LayeredLineFoundation or PowerLawLineFoundation, optional
        The springs before wear, of the problem whose states they are; a height map needs none.

    Returns
    -------
    tuple of WearState, FrettingState, LineWearState, LineFrettingState or SurfaceWearState
        The last is the one to continue from: ``problem.steps(start=states[-1])``.

    Raises
    ------
    InvalidInput
        If the file is missing, broken, or of another kind, or its springs are not given.
    """
    wanted = {word for kind in KINDS.values() for word in _field_names(kind)}
    rows: dict[str, Any] = read_state(path, FORMAT, ("kind", *sorted(wanted)), needed=("kind",), what="wear")
    kind: Any = KINDS.get(str(rows.pop("kind")))
    if kind is None:
        raise InvalidInput(f"{path}: it does not hold '{FORMAT}'; give one that this version wrote.")
    springs: dict[str, Any] = {} if kind is SurfaceWearState else {"bed": bed}
    if springs and bed is None:
        raise InvalidInput(f"{path}: its states are read with the springs before wear; give bed=problem.bed.")
    _refuse_unfit(kind, rows, path)
    last = len(rows["jump"]) - 1

    def field(word: str, i: int) -> Any:
        row = rows[word]
        if row.ndim < OF_MAPS:
            return float(row[i]) if row.ndim < OF_NODES else row[i]
        return row[i and 1] if i in (0, last) else np.zeros((0, 0))

    return tuple(kind(**springs, **{word: field(word, i) for word in _field_names(kind)}) for i in range(last + 1))


def _refuse_unfit(kind: type[State], rows: dict[str, Any], path: str | os.PathLike[str]) -> None:
    """Refuse arrays that are no numbers, or of different numbers of states or sizes."""
    absent = np.array("")
    count = np.size(rows.get("jump", absent))
    size = rows.get("pressure", absent).shape[1:] or (0,)
    types = typing.get_type_hints(kind)
    for word in _field_names(kind):
        row = rows.get(word, absent)
        shape = (count if len(size) < OF_NODES else 2, *size) if types[word] == Array else (count,)
        if row.dtype.kind != "f" or row.shape != shape or not np.isfinite(row).all():
            raise InvalidInput(
                f"{path}: no wear can be read from it ({word} is not finite numbers of the shape {shape}); give a file "
                "of write_wear."
            )
