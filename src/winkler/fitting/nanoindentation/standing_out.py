r"""Which of repeated indentations stand out, and which are copies of others.

Modulus, hardness, depth at the peak, first touch and noise of each are compared with their median :math:`\tilde x` and
the median absolute deviation about it: :math:`0.6745\,|x-\tilde x|/\mathrm{MAD}` is of a Gaussian distribution the
distance in standard deviations.  The limit grows where few are compared, whose deviation is hardly known.

References
----------
B. Iglewicz, D. C. Hoaglin, How to Detect and Handle Outliers, ASQC Quality Press (1993)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from winkler.fitting.nanoindentation.solution import NanoindentationSolution
from winkler.numerics.types import Array
from winkler.readable import with_unit

__all__ = ["copies", "outlying", "standing_out"]

FEWEST = 5
"""Fewest curves that are compared."""
LIMIT = 5.0
"""Least distance from the median, in robust standard deviations, of very many curves."""
FEW = 5.0
"""Number of curves at which the limit is twice as large."""
GAUSSIAN = 0.6745
LEAST_SHARE = 1e-3
"""Least deviation, in parts of the median, of a quantity that is not a position."""
MOST_NAMED = 2
"""Most quantities in one sentence."""


def outlying(numbers: Array) -> Array:
    """Return how far numbers lie from their median over the limit ``(n,)``: above 1 a number stands out.

    Parameters
    ----------
    numbers : ndarray, (n,)
        Zero is returned of fewer than five, and where more than half are equal.

    Examples
    --------
    >>> outlying([70.0, 71.0, 69.0, 70.5, 69.5, 140.0]).round(1).tolist()
    [0.0, 0.1, 0.1, 0.0, 0.1, 6.8]
    """
    x = np.asarray(numbers, dtype=float)
    off = np.abs(x - np.median(x)) if x.size >= FEWEST else np.zeros(x.size)
    spread = float(np.median(off)) if x.size else 0.0
    return np.asarray(GAUSSIAN * off / spread / (LIMIT * (1.0 + FEW / x.size))) if spread > 0.0 else np.zeros(x.size)


def standing_out(solutions: Sequence[NanoindentationSolution]) -> tuple[str, ...]:
    """Return a sentence for each indentation that stands out of its group, and an empty text for the others.

    Parameters
    ----------
    solutions : sequence of NanoindentationSolution, (n,)
    """
    if len(solutions) < FEWEST:
        return ("",) * len(solutions)
    places = [one.deepest for one in solutions]

    def at_peak(name: str) -> Array:
        return np.array([getattr(one, name)[place] for one, place in zip(solutions, places, strict=True)])

    noise = solutions[0].sources.index("noise")
    scatter = [one.young_shares[noise, place] / one.young[place] for one, place in zip(solutions, places, strict=True)]
    compared = (
        ("Young's modulus", "Pa", at_peak("young")),
        ("hardness", "Pa", at_peak("hardness")),
        ("depth at the peak", "m", at_peak("depth")),
        ("first touch", "m", np.array([one.zero_point.position for one in solutions])),
        ("noise of the unloading", "", np.array(scatter)),
    )
    sentences: list[list[tuple[float, str]]] = [[] for _ in solutions]
    for name, unit, numbers in compared:
        middle, far = float(np.median(numbers)), outlying(numbers)
        least = 0.0 if name == "first touch" else LEAST_SHARE * abs(middle)
        for place in np.flatnonzero((far > 1.0) & (np.abs(numbers - middle) > least)).tolist():
            own, usual = (with_unit(x, unit, 3) if unit else f"{x:.2g}" for x in (float(numbers[place]), middle))
            sentences[place].append((float(far[place]), f"{name} {own}, median {usual}"))
    return tuple(
        f"Stands out: {'; '.join(text for _, text in sorted(found, reverse=True)[:MOST_NAMED])}." if found else ""
        for found in sentences
    )


def copies(solutions: Sequence[NanoindentationSolution]) -> tuple[int, ...]:
    """Return of each indentation the place of the first one with the same forces and positions ``(n,)``."""
    return tuple(_first_of_each(solutions))


def _first_of_each(solutions: Sequence[NanoindentationSolution]) -> Iterator[int]:
    seen: dict[tuple[bytes, bytes], int] = {}
    for place, one in enumerate(solutions):
        curve = one.problem.curve
        yield seen.setdefault((curve.position.tobytes(), curve.force.tobytes()), place)
