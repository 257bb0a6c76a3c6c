r"""The mean of repeated indentations, with the shares of its uncertainty.

The mean of n indentations has the variance

.. math:: u^2 = \max\Bigl(\frac{s^2}n, \frac{\overline{u_{own}^2}}n\Bigr) + \sum_j \bar u_j^2 ,

with the scatter s of the indentations, the uncertainties :math:`u_{own}` of each by noise, zero point and drift,
which the
scatter contains, and those by calibration, epsilon and constants, which all indentations share and no mean reduces.
The
interval takes Student's t with the degrees of freedom of Welch and Satterthwaite.

References
----------
JCGM 100:2008, doi:10.59161/JCGM100-2008E, annex G
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.fitting.nanoindentation.measurement import COMMON_SOURCES, NanoindentationSolution
from winkler.fitting.several.standing_out import BatchQuantity
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

LARGEST_RELATIVE = 600.0
"""Half-width of an interval, relative to the mean, from which on its upper end is beyond all moduli."""


@value
class RepeatedMean:
    """Mean of one quantity over repeated indentations.

    Parameters
    ----------
    mean : float
        [Pa].
    sources : tuple of str
        noise, zero point, drift (from the single indentations), repetition (additional scatter), calibration, epsilon,
        constants.
    shares : ndarray, (sources,)
        Standard uncertainties of the mean by each [Pa]; their squares add.
    freedom : float
        Effective degrees of freedom.
    count : int
        Number of indentations.
    scatter : float
        Standard deviation of the indentations [Pa]; nan of a single one.
    """

    __words__ = words(
        mean=(r"\bar x", "Pa", "mean of the indentations"),
        sources=("", None, "sources of uncertainty"),
        shares=("u_i", "Pa", "standard uncertainty of the mean by each source"),
        freedom=(r"\nu_{eff}", "", "effective degrees of freedom"),
        scatter=("s", "Pa", "standard deviation of the indentations"),
    )

    mean: float
    sources: tuple[str, ...]
    shares: Array
    freedom: float
    count: int
    scatter: float

    @property
    def error(self) -> float:
        """Combined standard uncertainty [Pa]."""
        return float(np.sqrt(np.sum(np.square(self.shares))))

    def interval(self, confidence: float = 0.95) -> tuple[float, float]:
        """Return the interval by Student's t, of the logarithm: its lower end is above zero."""
        from scipy.special import stdtrit

        width = float(stdtrit(min(self.freedom, 1e6), 0.5 + 0.5 * confidence)) * self.error
        relative = width / self.mean
        return self.mean * math.exp(-relative), self.mean * math.exp(min(relative, LARGEST_RELATIVE))


def repeated_mean(solutions: Sequence[NanoindentationSolution], name: str = "young") -> RepeatedMean:
    """Return the mean at the maximum force of repeated indentations with one indenter.

    Parameters
    ----------
    solutions : sequence of NanoindentationSolution
    name : str
        "young" or "hardness".

    Raises
    ------
    InvalidInput
        If there is no indentation, or the name is another one.
    """
    if not solutions or name not in ("young", "hardness"):
        raise InvalidInput(
            f"repeated_mean: of {len(solutions)} indentations and {name!r}; give one, and young or hardness."
        )
    numbers = np.array([getattr(one, name)[one.deepest] for one in solutions])
    shares = np.array([getattr(one, f"{name}_shares")[:, one.deepest] for one in solutions])
    sources, count = solutions[0].sources, numbers.size
    common = np.array([source in COMMON_SOURCES for source in sources])
    parts = np.where(common, shares.mean(axis=0), np.sqrt(np.mean(np.square(shares), axis=0) / count))
    own = float(np.sum(np.square(parts[~common])))
    scatter = float(np.std(numbers, ddof=1)) if count > 1 else math.nan
    observed = scatter**2 / count if count > 1 else 0.0
    beyond = math.sqrt(max(observed - own, 0.0))
    whole = own + beyond**2 + float(np.sum(np.square(parts[common])))
    random = own + beyond**2
    freedom = (count - 1) * (whole / random) ** 2 if beyond > 0.0 and random > 0.0 else 1e6
    order = [
        *[s for s in sources if s not in COMMON_SOURCES],
        "repetition",
        *[s for s in sources if s in COMMON_SOURCES],
    ]
    lookup = {**dict(zip(sources, parts.tolist(), strict=True)), "repetition": beyond}
    return RepeatedMean(
        float(numbers.mean()), tuple(order), np.array([lookup[s] for s in order]), float(freedom), count, scatter
    )


def compared_quantities(solutions: Sequence[NanoindentationSolution]) -> tuple[BatchQuantity, ...]:
    """Return what is compared of repeated indentations, at the greatest force of each.

    Parameters
    ----------
    solutions : sequence of NanoindentationSolution
    """
    places = [one.deepest for one in solutions]

    def at_peak(name: str) -> Array:
        return np.array([getattr(one, name)[place] for one, place in zip(solutions, places, strict=True)])

    scatter = [
        one.young_shares[one.sources.index("noise"), place] / one.young[place]
        for one, place in zip(solutions, places, strict=True)
    ]
    return (
        BatchQuantity("Young's modulus", "Pa", at_peak("young")),
        BatchQuantity("hardness", "Pa", at_peak("hardness")),
        BatchQuantity("depth at the peak", "m", at_peak("depth")),
        BatchQuantity("first touch", "m", np.array([one.zero_point.position for one in solutions]), is_place=True),
        BatchQuantity("noise of the unloading", "", np.array(scatter)),
    )
