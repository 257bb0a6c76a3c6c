"""What an instrument wrote over the first loading of its test: stiffness, and modulus and hardness of its own."""

from __future__ import annotations

import math

import numpy as np

from winkler.fitting.unloading.continuous_stiffness import ContinuousStiffness
from winkler.numerics.types import Array
from winkler.values.value import value

FEWEST = 2
YOUNG_NAMES = ("modulus", "young's modulus", "youngs modulus", "elastic modulus", "indentation modulus", "eit", "e")
HARDNESS_NAMES = ("hardness", "indentation hardness", "hit")


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


@value
class StatedResults:
    """An instrument's own modulus and hardness over depth, up to the deepest point.

    Parameters
    ----------
    depth, young, hardness : ndarray, (n,)
        [m], [Pa] and [Pa]; nan where the instrument has no number.
    """

    depth: Array
    young: Array
    hardness: Array

    def mean(self, low: float, high: float) -> tuple[float, float]:
        """Return the means of modulus and hardness [Pa] between two depths [m]; nan where there is none."""
        inside = (self.depth >= low) & (self.depth <= high)
        found = [numbers[inside & np.isfinite(numbers)] for numbers in (self.young, self.hardness)]
        young, hardness = (float(one.mean()) if one.size else math.nan for one in found)
        return young, hardness


def stated_results(depth: Array, young: Array, hardness: Array) -> StatedResults | None:
    """Return the results up to the deepest point; None if no number is positive.

    Parameters
    ----------
    depth, young, hardness : ndarray, (n,)
        [m], [Pa], [Pa]; a number that is not positive is none.
    """
    loading = slice(0, int(np.nanargmax(depth)) + 1)
    with np.errstate(invalid="ignore"):
        young, hardness = (
            np.where((one > 0.0) & (one < math.inf), one, math.nan)[loading] for one in (young, hardness)
        )
    if not np.any(np.isfinite(young) | np.isfinite(hardness)):
        return None
    return StatedResults(depth[loading], young, hardness)
