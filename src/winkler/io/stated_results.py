"""Modulus and hardness that an instrument computed itself and wrote beside depth and force."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array
from winkler.values import value

__all__ = ["HARDNESS_NAMES", "YOUNG_NAMES", "StatedResults", "stated_results"]

YOUNG_NAMES = ("modulus", "young's modulus", "youngs modulus", "elastic modulus", "indentation modulus", "eit", "e")
HARDNESS_NAMES = ("hardness", "indentation hardness", "hit")


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
