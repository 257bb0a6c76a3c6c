r"""Positive functions of a positive variable that are nearly powers of it, tabulated where they are evaluated.

Over :math:`\ln x` the logarithm of such a function is nearly straight: blocks of a few octaves of x are fitted by
`fit_panels` when one of their places is evaluated first, and serve from then on.

What is fitted is the logarithm of the function over :math:`s\,(x/m)^p`, with the power p of the block.  It stays small
where p is large, as of the gap of a very blunt tip, :math:`x^{256}`: its rounding is not that of :math:`p\ln(x/m)`.
Where the unit is a power of two, so are the middles m, and x/m is not rounded.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.types import Array, Curve
from winkler.values.errors import NotConverged

OCTAVES_PER_BLOCK = 2
"""Octaves of a block."""
RELATIVE_TOLERANCE = 2e-14
"""Relative error wanted."""
MOST_PANELS = 64
"""Panels of a block; a function that needs more is evaluated itself."""


class _Block(NamedTuple):
    """ln(f / (scale (x / middle)^power)) over ln(x / middle), or nothing where that is not smooth."""

    middle: float
    scale: float = 1.0
    power: float = 0.0
    panels: Panels | None = None


class Octaves:
    """A function and its table.

    Parameters
    ----------
    function
        Takes places ``(m,)`` between `low` and `high`, returns positive values ``(m,)``.
    unit : float
        Where one block ends and the next begins; the others follow.
    low, high : float
        Blocks that are not wholly inside are not tabulated.
    """

    def __init__(self, function: Curve, unit: float, low: float, high: float) -> None:
        self.function, self.unit, self.low, self.high = function, unit, low, high
        self._blocks: dict[int, _Block] = {}

    def __call__(self, x: Array) -> Array:
        """Return the function at places ``(m,)``."""
        if x.size == 1:
            return self._inside(math.floor(math.log2(float(x[0]) / self.unit) / OCTAVES_PER_BLOCK), x)
        numbers = np.floor(np.log2(x / self.unit) / OCTAVES_PER_BLOCK).astype(int)
        result = np.empty(x.shape)
        for number in np.unique(numbers).tolist():
            here = numbers == number
            result[here] = self._inside(number, x[here])
        return result

    def _inside(self, number: int, x: Array) -> Array:
        block = self._blocks.get(number)
        if block is None:
            block = self._blocks[number] = self._block(number)
        if block.panels is None:
            return self.function(x)
        along = x / block.middle
        return np.asarray(block.scale * along**block.power * np.exp(block.panels(np.log(along))))

    def _block(self, number: int) -> _Block:
        """Return the table of a block."""
        start = self.unit * 2.0 ** (OCTAVES_PER_BLOCK * number)
        middle = start * 2.0 ** (OCTAVES_PER_BLOCK / 2)
        if not (self.low <= start and start * 2.0**OCTAVES_PER_BLOCK <= self.high):
            return _Block(middle)
        half = 2.0 ** (OCTAVES_PER_BLOCK / 2)
        edges = (np.arange(OCTAVES_PER_BLOCK + 1) - OCTAVES_PER_BLOCK / 2) * math.log(2.0)
        try:
            with np.errstate(all="ignore"):
                low, scale, high = self.function(middle * np.array([1.0 / half, 1.0, half])).tolist()
                power = math.log2(high / scale * (scale / low)) / OCTAVES_PER_BLOCK

                def bent(u: Array) -> Array:
                    along = np.exp(u.ravel())
                    return np.asarray(np.log(self.function(middle * along) / scale * along**-power).reshape(u.shape))

                rounded = 2.0 * np.finfo(float).eps * abs(power)  # of the function, by the rounding of its places
                panels = fit_panels(bent, edges, max(RELATIVE_TOLERANCE, rounded), MOST_PANELS)
        except (NotConverged, ArithmeticError, ValueError):
            return _Block(middle)
        return _Block(middle, scale, power, panels if np.all(np.isfinite(panels.coefficients)) else None)
