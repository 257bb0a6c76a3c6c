"""Every medium with random, sensible numbers: to put a new one under all laws, add a line to `MEDIA`.

A `Sample` makes the same medium with all its lengths times one factor and all its moduli times another.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from hypothesis import strategies as st
from shapes import number

import winkler as wk
from winkler.media.medium import Medium


class Sample(NamedTuple):
    """A medium at any scale of lengths and moduli, and the same with its bodies exchanged where they can be."""

    make: Callable[[float, float], Medium]
    swapped: Callable[[float, float], Medium] | None = None

    def __repr__(self) -> str:
        return f"Sample({self.make(1.0, 1.0)!r})"


Body = Callable[[float], object]
young = number(0.1, 10.0)
poisson = number(-0.4, 0.5)
elastic: st.SearchStrategy[Body] = st.builds(lambda e, nu: lambda m: wk.Elastic(m * e, nu), young, poisson)
rigid: st.SearchStrategy[Body] = st.just(lambda m: wk.Rigid())


def _anisotropic(c11: float, p12: float, p13: float, c33: float, c44: float) -> Body:
    c12 = p12 * c11
    c13 = p13 * (0.5 * (c11 + c12) * c33) ** 0.5  # keeps (c11 + c12) c33 > 2 c13^2
    return lambda m: wk.TransverselyIsotropic(m * c11, m * c12, m * c13, m * c33, m * c44)


transverse: st.SearchStrategy[Body] = st.builds(_anisotropic, young, number(-0.5, 0.8), number(-0.5, 0.9), young, young)


def _pair(kind: type, first: Body, second: Body) -> Sample:
    return Sample(lambda s, m: kind(first(m), second(m)), lambda s, m: kind(second(m), first(m)))


MEDIA: dict[str, st.SearchStrategy[Sample]] = {
    "half_space": st.builds(_pair, st.just(wk.HalfSpace), elastic, st.one_of(elastic, rigid)),
    "transverse": st.builds(
        _pair, st.just(wk.TransverselyIsotropicHalfSpace), transverse, st.one_of(transverse, elastic, rigid)
    ),
}
