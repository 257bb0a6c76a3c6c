"""Every medium with random, sensible numbers: to put a new one under all laws, add a line to `MEDIA`.

A `Sample` makes the same medium with all its lengths times one factor and all its moduli times another.  Media that
need a second or so before their first result stand in `LAYERED` and have laws of their own, with few examples.
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


def _grading(e: float, nu: float, scale: float, k: float) -> Callable[[float, float], object]:
    return lambda s, m: wk.PowerLawGraded(m * e, s * scale, k, nu)


def _graded(one: tuple, other: tuple, k: float, alone: bool) -> Sample:
    first = _grading(*one, k)
    second = (lambda s, m: wk.Rigid()) if alone else _grading(*other, k)
    return Sample(
        lambda s, m: wk.GradedHalfSpace(first(s, m), second(s, m)),
        lambda s, m: wk.GradedHalfSpace(second(s, m), first(s, m)),
    )


solid = st.tuples(young, poisson, number(0.1, 10.0))
power_law = st.builds(_graded, solid, solid, number(-0.5, 0.8), st.booleans())


def _pair(kind: type, first: Body, second: Body) -> Sample:
    return Sample(lambda s, m: kind(first(m), second(m)), lambda s, m: kind(second(m), first(m)))


MEDIA: dict[str, st.SearchStrategy[Sample]] = {
    "half_space": st.builds(_pair, st.just(wk.HalfSpace), elastic, st.one_of(elastic, rigid)),
    "transverse": st.builds(
        _pair, st.just(wk.TransverselyIsotropicHalfSpace), transverse, st.one_of(transverse, elastic, rigid)
    ),
    "graded": power_law,
}

Sheet = tuple[float, float, float]
"""Young's modulus, Poisson's ratio and thickness of a layer."""


def _coated(sheets: list[Sheet], on: Body, second: Body) -> Sample:
    return Sample(
        lambda s, m: wk.CoatedHalfSpace(
            [wk.Layer(wk.Elastic(m * e, nu), s * h) for e, nu, h in sheets], on(m), second(m)
        )
    )


def _depth_graded(kind: Callable[[float, float], object], second: Body) -> Sample:
    return Sample(lambda s, m: wk.DepthGradedHalfSpace(kind(s, m), second(m), tolerance=1e-2))


sheet = st.tuples(number(0.2, 10.0), number(-0.2, 0.5), number(0.3, 1.5))
counterpart = st.one_of(rigid, elastic)
LAYERED: dict[str, st.SearchStrategy[Sample]] = {
    "coating": st.builds(_coated, st.lists(sheet, min_size=1, max_size=1), elastic, rigid),
    "film": st.builds(_coated, st.lists(sheet, min_size=1, max_size=1), rigid, counterpart),
    "two_layers": st.builds(_coated, st.lists(sheet, min_size=2, max_size=2), st.one_of(elastic, rigid), rigid),
    "three_layers": st.builds(_coated, st.lists(sheet, min_size=3, max_size=3), elastic, counterpart),
}
"""Bonded layers; lengths of the order of one."""
SMOOTHLY: dict[str, st.SearchStrategy[Sample]] = {
    "exponential": st.just(_depth_graded(lambda s, m: wk.ExponentialGrading(m, 2.0 * m, s, 0.3), lambda m: wk.Rigid())),
    "sigmoidal": st.just(
        _depth_graded(lambda s, m: wk.SigmoidalGrading(3.0 * m, m, s, 0.3 * s, 0.5), lambda m: wk.Elastic(5.0 * m, 0.2))
    ),
    "tabulated": st.just(
        _depth_graded(
            lambda s, m: wk.TabulatedGrading([0.0, s, 2.0 * s], [m, 2.0 * m, 1.5 * m], [0.3, 0.25, 0.4]),
            lambda m: wk.Rigid(),
        )
    ),
}
"""Graded in depth; one each, because the grading must be resolved anew for every number."""
