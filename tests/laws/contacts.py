"""A shape pressed into a medium, at any size and stiffness; and quadrature that does not mind kinks."""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st
from media_cases import MEDIA, Sample
from shapes import KINDS, Specimen, number

import winkler as wk

SLOW = {"formula", "wavy_ball"}
"""Shapes whose contacts are checked one by one, because it is unknown beforehand whether g rises."""
PINNED = ("flat_punch", "pinned_cylinder")
FREE = tuple(kind for kind in KINDS if kind not in PINNED)


def examples(count: int):
    """So many examples; the time they take is bounded by their number, not by a clock."""
    return settings(
        max_examples=count,
        phases=[Phase.explicit, Phase.generate, Phase.shrink],
        suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
    )


class Contact(NamedTuple):
    """A contact whose lengths are `unit` and whose moduli are `modulus` times those of the specimens."""

    specimen: Specimen
    sample: Sample
    unit: float
    modulus: float
    fraction: float

    def bed(self, lengths: float = 1.0, moduli: float = 1.0) -> wk.Foundation:
        s = self.unit * lengths
        return wk.Foundation(self.specimen.make(s), self.sample.make(s, self.modulus * moduli))

    @property
    def radius(self) -> float:
        """Of the contact [m]."""
        flat, widest = self.specimen.flat, self.specimen.widest
        return self.unit * (widest if self.specimen.pinned else flat + self.fraction * (widest - flat))

    @property
    def depth(self) -> float:
        """Of the contact [m]."""
        closing = float(self.bed().gap(np.array([self.radius]))[0])
        return closing + (0.3 * self.fraction * self.radius if self.specimen.pinned else 0.0)

    def solve(self) -> wk.IndentationSolution:
        return wk.Indentation(self.bed(), wk.Depth(self.depth)).solve()


@st.composite
def contacts(draw, kind: str, medium: str = "half_space", least: float = 0.1) -> Contact:
    """Draw a contact of a kind of shape with a kind of medium."""
    return Contact(
        draw(KINDS[kind]),
        draw(MEDIA[medium]),
        10.0 ** draw(number(-8.0, -1.0)),
        10.0 ** draw(number(3.0, 11.0)),
        draw(number(least, 0.95)),
    )


def over_shapes(count: int, slow: int, *, kinds: Iterable[str] = KINDS, medium: str = "half_space"):
    """Turn a law of a contact into a test of every kind of shape: each with a third of so many examples.

    All of them are long tests.
    """
    all_of = {kind: slow if kind in SLOW else count for kind in kinds}
    few = [pytest.param(kind, math.ceil(many / 3), id=kind) for kind, many in all_of.items()]
    more = [
        pytest.param(kind, many, id=f"{kind}-{many}", marks=pytest.mark.long)
        for kind, many in all_of.items()
        if many > 1
    ]

    def decorate(law: Callable[[Contact], None]):
        @pytest.mark.parametrize(("kind", "many"), [*few, *more])
        @functools.wraps(law, assigned=("__module__", "__name__", "__qualname__", "__doc__"))
        def test(kind: str, many: int) -> None:
            examples(many)(given(contacts(kind, medium))(law))()

        del test.__wrapped__
        return test

    return decorate


def graded(cuts: Iterable[float], towards: Iterable[float], panels: int = 12, order: int = 12, ratio: float = 0.2):
    """Return nodes and weights of Gauss' panels between the cuts that shrink towards some of them."""
    nodes, weights = np.polynomial.legendre.leggauss(order)
    cuts, towards = sorted(set(cuts)), set(towards)
    x, w = [], []
    steps = np.append(ratio ** np.arange(panels), 0.0)
    for low, high in itertools.pairwise(cuts):
        left = low + (high - low) * (0.5 * steps if low in towards else np.array([0.5, 0.0]))
        right = high - (high - low) * (0.5 * steps if high in towards else np.array([0.5, 0.0]))
        for ends in (left[::-1], right):
            half, middle = 0.5 * np.diff(ends), 0.5 * (ends[1:] + ends[:-1])
            x.append((middle[:, None] + half[:, None] * nodes).ravel())
            w.append((half[:, None] * weights).ravel())
    return np.concatenate(x), np.concatenate(w)


def along(bed: wk.Foundation, end: float, *, angular: bool = False):
    """Return nodes and weights from the axis to `end` that step from kink to kink.

    With `angular` the nodes are end sin(t), which takes inverse square roots from the end.
    """
    exponent = getattr(bed.medium, "exponent", 0.0)
    panels = math.ceil(12 / (1.0 + min(0.0, exponent)))  # roots are steeper where a medium hardens towards its surface
    kinks = [(b, strength) for b, strength in bed.kinks if b < end]
    relevant = [b for b, strength in kinks if strength != 0.0 or len(kinks) <= 9]
    cuts, towards = np.array([0.0, *(b for b, _ in kinks), end]), np.array([0.0, *relevant, end])
    if not angular:
        return graded(cuts, towards, panels)
    t, weight = graded(np.arcsin(cuts / end), np.arcsin(towards[:-1] / end), panels)
    if exponent != 0.0:  # cos^k is left at the end, and no double lies closer to it than this
        last = 0.5 * (np.arcsin(cuts[-2] / end) + 0.5 * np.pi)
        near, more = graded([last, 0.5 * np.pi], [0.5 * np.pi], panels=7)
        t, weight = np.concatenate([t[t < last], near]), np.concatenate([weight[t < last], more])
    return end * np.sin(t), end * np.cos(t) * weight
