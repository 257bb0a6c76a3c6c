"""Many states of a height map gathered into columns, with the maps of those under which the bodies may yield first.

Not every map is kept: those of the greatest pressure, of the greatest traction in a pixel, of the greatest shear force,
and of the greatest root of p^2 + 3 tau^2 in a pixel are candidates for the greatest von Mises stress.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.subsurface.traction_frames import FrameKeeper
from winkler.values.value import value, words

GREATER = 1.0 + 1e-9
"""By which a load exceeds another one that is more than rounding."""


@value
class LoadedMap:
    """Pressures and tractions of one of many states.

    Parameters
    ----------
    index : int
        Which state, from zero.
    pressure : ndarray, (nx, ny)
        p [Pa].
    traction : ndarray, (2, nx, ny)
        (tau_x, tau_y) [Pa], with which the second body drags the first.
    """

    __words__ = words(index=("", "", "which state, from zero"))

    index: int
    pressure: Array
    traction: Array


class GatheredMaps(NamedTuple):
    """States of a map.

    Parameters
    ----------
    columns
        Name -> number of every state.
    maps
        Of the solution: the last state, candidates for the greatest stress and frames, in their order.
    """

    columns: dict[str, Any]
    maps: dict[str, Any]


APART = ("problem", "last", "heaviest", "frames")
"""Fields of a solution that are no numbers of its states."""


def gathered_maps(states: Iterable[Any], solution: type) -> GatheredMaps:
    """Return the numbers of all states, the last one, and those that load the bodies most.

    Parameters
    ----------
    states
        With `pressure` and `traction`, maps.
    solution
        Class whose fields name their numbers, beside problem, last, heaviest and frames.
    """
    names = [name for name in getattr(solution, "__dataclass_fields__", ()) if name not in APART]
    rows: dict[str, list[Any]] = {name: [] for name in names}
    most: dict[str, float] = {}
    found: dict[str, LoadedMap] = {}
    last, keeper = None, FrameKeeper()
    for index, state in enumerate(states):
        last = state
        for name in names:
            rows[name].append(getattr(state, name))
        keeper.add(index, state)
        loaded = LoadedMap(index, state.pressure, state.traction)
        for name, load in _loads(state.pressure, state.traction).items():
            if load > 0.0 and load > GREATER * most.get(name, 0.0):
                most[name], found[name] = load, loaded
    heaviest = {loaded.index: loaded for loaded in found.values()}
    columns = {name: np.array(row) for name, row in rows.items()}
    worst = tuple(heaviest[index] for index in sorted(heaviest))
    return GatheredMaps(columns, {"last": last, "heaviest": worst, "frames": keeper.kept()})


def _loads(pressure: Array, traction: Array) -> dict[str, float]:
    square = np.sum(traction**2, axis=0)
    return {
        "pressure": float(np.max(pressure)),
        "traction": float(np.max(square)),
        "shear": float(np.hypot(*np.sum(traction, axis=(1, 2)))),
        "both": float(np.max(pressure**2 + 3.0 * square)),
    }
