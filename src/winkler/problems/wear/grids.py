"""The grid on which a bed wears: of a round contact or of a line contact."""

from __future__ import annotations

import functools
from typing import overload

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.foundation.line_bed import LineBed
from winkler.numerics.types import Array
from winkler.problems.wear.round_grid import RoundGrid
from winkler.problems.wear.strip_grid import StripGrid


@functools.lru_cache(maxsize=8)
def _cached_grid(bed: Foundation | LineBed, nodes: bytes) -> RoundGrid | StripGrid:
    places = np.frombuffer(nodes)
    return StripGrid(bed, places) if isinstance(bed, LineBed) else RoundGrid(bed, places)


@overload
def wear_grid(bed: Foundation, nodes: Array) -> RoundGrid: ...
@overload
def wear_grid(bed: LineBed, nodes: Array) -> StripGrid: ...
def wear_grid(bed: Foundation | LineBed, nodes: Array) -> RoundGrid | StripGrid:
    """Return a bed on a grid; the last few are cached.

    Parameters
    ----------
    bed : Foundation or LineBed
        Before wear.
    nodes : ndarray, (n,)
        Distances from the middle [m], rising from zero.
    """
    return _cached_grid(bed, np.ascontiguousarray(nodes, dtype=float).tobytes())
