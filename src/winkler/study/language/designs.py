"""Designs of a sweep: the choice of the points that are solved.

`Crossed`, every combination; `Zipped`, the first values of all keys, then the second ones; or points that are drawn:
`LatinHypercube`, each key evenly covered whatever the others do; `Sobol`, all keys together covered more evenly than by
chance; `Sensitivity`, pairs of Sobol points with their keys exchanged one by one, from which the indices of Sobol
follow (`winkler.study.batch.sensitivity`).  Equal seeds draw equal points.

All but the first have one dimension, ``point``.
"""

from __future__ import annotations

import functools
import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.numerics.types import Array
from winkler.study.language.varied import Axis, Range
from winkler.values.checks.number_checks import Whole, affordable
from winkler.values.errors import InvalidInput
from winkler.values.limits import MOST_NUMBERS, MOST_SWEPT_RUNS
from winkler.values.value import value

POINT = "point"
"""Dimension of the designs that do not cross their keys."""


@value
class Crossed:
    """Every combination, the last key changing fastest."""

    kind: ClassVar[str] = "crossed"
    draws: ClassVar[bool] = False
    sentence: ClassVar[str] = "Every combination was solved."


@value
class Zipped:
    """The first values of all keys, then the second ones, and so on."""

    kind: ClassVar[str] = "zipped"
    draws: ClassVar[bool] = False
    sentence: ClassVar[str] = "They vary together."


@value
class _Drawn:
    """Points that are drawn: how many, and the seed."""

    count: Annotated[int, Whole(1, MOST_SWEPT_RUNS)]
    seed: Annotated[int, Whole(0, MOST_SWEPT_RUNS)] = 0

    section: ClassVar[str] = "sweep.design"
    draws: ClassVar[bool] = True


@value
class _Even(_Drawn):
    """Points that are even with a power of two only."""

    def __post_init__(self) -> None:
        if self.count & (self.count - 1):
            below = 2 ** (self.count.bit_length() - 1)
            raise InvalidInput(
                f"sweep.design.count is {self.count}; a Sobol sequence is even with a power of two only: give {below} "
                f"or {2 * below}."
            )


@value
class LatinHypercube(_Drawn):
    """Points drawn so that each key has one value in each of `count` equal parts of its range.

    Parameters
    ----------
    count
        Number of points.
    seed
        Equal seeds draw equal points.

    References
    ----------
    McKay, Beckman, Conover: A comparison of three methods for selecting values of input variables in the analysis of
    output from a computer code. Technometrics 21 (1979) 239, doi:10.1080/00401706.1979.10489755
    """

    kind: ClassVar[str] = "latin_hypercube"
    sentence: ClassVar[str] = "The points are a Latin hypercube."

    def shares(self, keys: int) -> Array:
        """Return the places of the points in the ranges of the keys, shape ``(points, keys)``, from zero to one."""
        from scipy.stats import qmc

        return np.asarray(qmc.LatinHypercube(keys, seed=np.random.default_rng(self.seed)).random(self.count))


@value
class Sobol(_Even):
    """Points of a scrambled Sobol sequence: even in all keys together.

    Parameters
    ----------
    count
        Number of points, a power of two.
    seed
        Equal seeds draw equal points.

    References
    ----------
    Sobol': On the distribution of points in a cube and the approximate evaluation of integrals. USSR Computational
    Mathematics and Mathematical Physics 7 (1967) 86, doi:10.1016/0041-5553(67)90144-9
    Matousek: On the L2-discrepancy for anchored boxes. Journal of Complexity 14 (1998) 527 (the scrambling)
    """

    kind: ClassVar[str] = "sobol"
    sentence: ClassVar[str] = "The points are a scrambled Sobol sequence."

    def shares(self, keys: int) -> Array:
        """Return the places of the points in the ranges of the keys, shape ``(points, keys)``, from zero to one."""
        from scipy.stats import qmc

        return np.asarray(qmc.Sobol(keys, seed=np.random.default_rng(self.seed)).random(self.count))


@value
class Sensitivity(_Even):
    """Points from which the indices of Sobol follow: the part of the variance of the answers due to each key.

    Pairs of points A and B of a Sobol sequence, and for every key the point A with this key taken from B:
    ``count (keys + 2)`` points, those of one pair one after the other.

    Parameters
    ----------
    count
        Number of pairs, a power of two.
    seed
        Equal seeds draw equal points.

    References
    ----------
    Saltelli, Annoni, Azzini, Campolongo, Ratto, Tarantola: Variance based sensitivity analysis of model output.
    Computer Physics Communications 181 (2010) 259, doi:10.1016/j.cpc.2009.09.018
    """

    kind: ClassVar[str] = "sensitivity"
    sentence: ClassVar[str] = "Pairs of points of a Sobol sequence have their keys exchanged one by one."

    def shares(self, keys: int) -> Array:
        """Return the places of the points in the ranges of the keys, shape ``(points, keys)``, from zero to one."""
        pairs = Sobol(self.count, self.seed).shares(2 * keys)
        first, second = pairs[:, :keys], pairs[:, keys:]
        rows = np.repeat(first[:, np.newaxis, :], keys + 2, axis=1)
        rows[:, 1, :] = second
        for key in range(keys):
            rows[:, 2 + key, key] = second[:, key]
        return rows.reshape(-1, keys)


Design = Crossed | Zipped | LatinHypercube | Sobol | Sensitivity

DESIGNS: dict[str, type[Design]] = {one.kind: one for one in (Crossed, Zipped, LatinHypercube, Sobol, Sensitivity)}
"""Kind -> design."""


@functools.lru_cache(maxsize=8)
def axes_of(design: Design, lines: tuple[Axis | Range, ...]) -> tuple[Axis, ...]:
    """Return the values of every key: of a design that draws its points, one value for each point.

    Parameters
    ----------
    design
        The design.
    lines
        The keys, with their values or ranges.

    Raises
    ------
    InvalidInput
        If design and lines do not fit together.
    """
    if isinstance(design, Crossed | Zipped):
        for line in lines:
            if isinstance(line, Range):
                raise InvalidInput(
                    f"sweep: '{line.key}' is drawn from a range, but a {design.kind} design needs a list of values; "
                    "give "
                    'values, or a design such as { kind = "sobol", count = 128 }.'
                )
        axes = tuple(line for line in lines if isinstance(line, Axis))
        if isinstance(design, Crossed):
            affordable("sweep", "points", math.prod(len(axis.values) for axis in axes), MOST_SWEPT_RUNS)
        if isinstance(design, Zipped) and len({len(axis.values) for axis in axes}) > 1:
            counts = ", ".join(f"'{axis.key}' {len(axis.values)}" for axis in axes)
            raise InvalidInput(f"sweep: keys that vary together need equally many values; here {counts}.")
        return axes
    if not lines:
        raise InvalidInput(f"sweep: the design {design.kind} has no keys; give the keys that vary.")
    count = design.count * (len(lines) + 2 if isinstance(design, Sensitivity) else 1)
    affordable("sweep", "points", count, MOST_SWEPT_RUNS)
    affordable("sweep", "numbers of all points", count * len(lines), MOST_NUMBERS)
    shares = design.shares(len(lines))
    return tuple(line.spread(shares[:, place]) for place, line in enumerate(lines))
