r"""Which curves of a batch stand out of it, and which are copies of others.

Each quantity is compared with its median :math:`\tilde x` and the median absolute deviation (MAD) about it:
:math:`0.6745\,|x-\tilde x|/\mathrm{MAD}` is of a Gaussian distribution the distance in standard deviations.  Quantities
that are positive are compared by their logarithms.  The limit grows where few are compared, whose deviation is hardly
known: of 20,000 Gaussian batches of 5, 6, 10 and 50 curves 3.4, 1.2, 0.7 and 0.1 % had one beyond it.

References
----------
B. Iglewicz, D. C. Hoaglin, How to Detect and Handle Outliers, ASQC Quality Press (1993)
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.numerics.types import Array, ArrayLike
from winkler.values.readable import with_unit
from winkler.values.value import value, words

FEWEST, LEAST_STATED = 5, 3
"""Fewest curves that are compared, and of which median and deviation are stated."""
LIMIT = 5.0
"""Least distance from the median, in robust standard deviations, of very many curves."""
FEW = 5.0
"""Number of curves at which the limit is twice as large."""
GAUSSIAN = 0.6745
LEAST_SHARE = 1e-3
"""Least change of a positive quantity, in parts of it, that can stand out."""
MOST_NAMED = 2
"""Most quantities in one sentence."""


@value
class BatchQuantity:
    """One quantity of all curves of a batch.

    Parameters
    ----------
    name : str
    unit : str
        SI; empty of a pure number.
    numbers : ndarray, (n,)
        In that unit; nan where a curve has none.
    errors : ndarray, (n,), optional
        Standard errors of the single curves, which explain a part of their distance.
    is_place : bool, optional
        Whether the zero of the quantity is arbitrary; others are compared by their logarithms where all are positive.
    """

    __words__ = words(
        name=("", None, "name of the quantity"),
        unit=("", None, "its SI unit"),
        numbers=("x", None, "the quantity of each curve"),
        errors=("s", None, "standard errors of the curves"),
        is_place=("", None, "whether the zero of the quantity is arbitrary"),
    )

    name: str
    unit: str
    numbers: Array
    errors: Array | tuple[()] = ()
    is_place: bool = False

    @property
    def known(self) -> Array:
        """The numbers that are finite."""
        return np.asarray(self.numbers[np.isfinite(self.numbers)])

    @property
    def median(self) -> float:
        """Median of the curves; nan without any."""
        return float(np.median(self.known)) if self.known.size else float("nan")

    @property
    def deviation(self) -> float:
        """Median absolute deviation from the median (MAD); nan without any curve."""
        return float(np.median(np.abs(self.known - self.median))) if self.known.size else float("nan")

    def text(self, number: float, digits: int = 3) -> str:
        """Return a number of this quantity with its unit."""
        return with_unit(number, self.unit, digits)

    def distances(self) -> Array:
        """Return how far each curve lies from the median over the limit ``(n,)``: above 1 it stands out."""
        known = np.isfinite(self.numbers)
        found = np.zeros(known.size)
        errors = np.zeros(known.size) if isinstance(self.errors, tuple) else np.nan_to_num(self.errors)
        x, s, least = self.numbers[known], errors[known], 0.0
        if not self.is_place and np.all(x > 0.0):
            x, s, least = np.log(x), s / x, LEAST_SHARE
        found[known] = outlying(x, s, least)
        return found


def outlying(numbers: ArrayLike, errors: ArrayLike = 0.0, least: float = 0.0) -> Array:
    """Return how far numbers lie from their median over the limit ``(n,)``: above 1 a number stands out.

    Parameters
    ----------
    numbers : array_like, (n,)
        Zero is returned of fewer than five, and where more than half are equal and `least` is zero.
    errors : array_like, (n,), optional
        Standard errors: what the scatter exceeds them by is common to all numbers.
    least : float, optional
        Least difference that can stand out.

    Examples
    --------
    >>> outlying([70.0, 71.0, 69.0, 70.5, 69.5, 140.0]).round(1).tolist()
    [0.0, 0.1, 0.1, 0.0, 0.1, 6.8]
    """
    x = np.asarray(numbers, dtype=float)
    if x.size < FEWEST:
        return np.zeros(x.size)
    limit = LIMIT * (1.0 + FEW / x.size)
    variances = np.broadcast_to(np.square(np.asarray(errors, dtype=float)), x.shape)
    off = np.abs(x - np.median(x))
    between = max((float(np.median(off)) / GAUSSIAN) ** 2 - float(np.median(variances)), 0.0)
    spread = np.maximum(np.sqrt(between + variances), least / limit)
    return np.asarray(np.divide(off, limit * spread, out=np.zeros(x.size), where=spread > 0.0))


def standing_out(quantities: Iterable[BatchQuantity]) -> tuple[str, ...]:
    """Return a sentence for each curve that stands out of its batch, and an empty text for the others.

    Parameters
    ----------
    quantities : iterable of BatchQuantity
        Of the same curves.
    """
    compared = [(one, one.distances()) for one in quantities]
    count = compared[0][1].size if compared else 0
    sentences: list[list[tuple[float, str]]] = [[] for _ in range(count)]
    for one, far in compared:
        for place in np.flatnonzero(far > 1.0).tolist():
            own, usual = one.text(float(one.numbers[place])), one.text(one.median)
            sentences[place].append((float(far[place]), f"{one.name} {own}, median {usual}"))
    return tuple(
        f"Stands out: {'; '.join(text for _, text in sorted(found, reverse=True)[:MOST_NAMED])}." if found else ""
        for found in sentences
    )


def copies(curves: Iterable[ForceCurve]) -> tuple[int, ...]:
    """Return of each curve the place of the first one with the same forces and positions ``(n,)``."""
    seen: dict[bytes, int] = {}
    return tuple(seen.setdefault(_digest(curve), place) for place, curve in enumerate(curves))


def _digest(curve: ForceCurve) -> bytes:
    content = hashlib.sha256(np.ascontiguousarray(curve.position).tobytes())
    content.update(np.ascontiguousarray(curve.force).tobytes())
    return content.digest()


def doubts_of_batch(
    names: Sequence[str], first: Sequence[int], quantities: Iterable[BatchQuantity]
) -> Iterator[tuple[str, ...]]:
    """Yield for each curve the sentences on what sets it apart from the others; mostly none.

    Parameters
    ----------
    names : sequence of str, (n,)
    first : sequence of int, (n,)
        From `copies`.
    quantities : iterable of BatchQuantity
        Of the curves that are no copies, in their order.
    """
    apart = iter(standing_out(quantities))
    for place, origin in enumerate(first):
        if origin < place:
            yield (f"Copy: the data of {names[origin]}, counted once.",)
        else:
            said = next(apart, "")
            yield (said,) if said else ()
