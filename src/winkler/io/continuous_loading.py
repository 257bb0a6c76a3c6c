"""Stiffness that an instrument measured continuously, over the first loading of its test."""

from __future__ import annotations

import numpy as np

from winkler.fitting.unloading.continuous_stiffness import ContinuousStiffness
from winkler.numerics.types import Array

__all__ = ["loading_stiffness", "stiffness_fact"]

FEWEST = 2


def loading_stiffness(
    depth: Array, force: Array, stiffness: Array, time: Array, name: str
) -> ContinuousStiffness | None:
    """Return the stiffness in contact up to the greatest force; None if hardly a point has one.

    Parameters
    ----------
    depth, force, stiffness : ndarray, (n,)
        [m], [N] and [N/m]; the stiffness nan where there is none.
    time : ndarray, (n,) or (0,)
        [s].
    name : str
        Origin of the data.
    """
    with np.errstate(invalid="ignore"):
        kept = (np.arange(depth.size) <= int(np.argmax(force))) & (depth > 0.0) & (force > 0.0) & (stiffness > 0.0)
    if np.count_nonzero(kept) < FEWEST:
        return None
    return ContinuousStiffness(depth[kept], force[kept], stiffness[kept], time[kept] if time.size else time, name=name)


def stiffness_fact(column: str, found: ContinuousStiffness | None) -> str:
    """Return what was taken from a column of stiffness, as a phrase."""
    if found is None:
        return f"{column} holds no stiffness of the loading"
    return f"continuous stiffness from {column}: {found.count} points of the loading"
