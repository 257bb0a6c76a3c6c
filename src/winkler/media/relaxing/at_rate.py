"""Solids that relax, and layers of them, at Laplace's s: by the correspondence they are elastic ones of its modulus."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from operator import attrgetter
from typing import Any, NamedTuple

import numpy as np

from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.layered.wave_constants import IsotropicAt, Wave, half_space_compliance
from winkler.numerics.springs.exponential_sums import CreepSeries, of_relaxation
from winkler.numerics.types import ComplexArray
from winkler.values.errors import InvalidInput

ShearOf = Callable[[ViscoelasticSolid], float]
GLASSY: ShearOf = attrgetter("series.glassy")
RELAXED: ShearOf = attrgetter("series.relaxed")
"""Shear moduli of a sudden step, and after all time [Pa]."""


class LayerAt(NamedTuple):
    """A layer of a solid at s, thick [m]."""

    solid: Any
    thickness: float
    bonded: bool = True


def solid_at(solid: ViscoelasticSolid | Elastic | TransverselyIsotropic | Rigid, s: ComplexArray) -> Any:
    """Return a solid at s [1/s] ``(m,)``, of which infinite ones are a sudden step; itself if it does not relax."""
    if not isinstance(solid, ViscoelasticSolid):
        return solid
    series, sudden = solid.series, np.isinf(np.abs(s))
    return IsotropicAt(np.where(sudden, series.glassy, series.at_rate(np.where(sudden, 0.0, s))), solid.poisson)


def both(part: Wave, first: Any, second: Any) -> ComplexArray:
    """Return what both surfaces answer, the second that of a half-space: their sum, of couplings the difference."""
    added = half_space_compliance(second, part)
    return np.asarray(first - added if part is Wave.COUPLING else first + added)


def elastic_with(solid: Any, shear: ShearOf) -> Any:
    """Return the elastic solid with the shear modulus of one that relaxes [Pa]; others as they are."""
    if not isinstance(solid, ViscoelasticSolid):
        return solid
    return Elastic(2.0 * (1.0 + solid.poisson) * shear(solid), solid.poisson)


def half_space_creep(solid: ViscoelasticSolid | Elastic | Rigid) -> CreepSeries:
    """Return how much a half-space sinks after a step of pressure, 1/E* [1/Pa]."""
    if isinstance(solid, ViscoelasticSolid):
        return of_relaxation(solid.series).scaled(0.5 * (1.0 - solid.poisson))
    return CreepSeries(half_space_compliance(solid, Wave.NORMAL), 0.0, np.empty(0), np.empty(0))


def refuse_unbounded(owner: str, solids: Iterable[Any]) -> None:
    """Refuse solids that relax to nothing, or resist a step without bound."""
    for solid in solids:
        if not isinstance(solid, ViscoelasticSolid):
            continue
        series = solid.series
        if series.relaxed == 0.0 or math.isinf(series.glassy):
            what = "creeps without limit" if series.relaxed == 0.0 else "resists a step with an infinite modulus"
            raise InvalidInput(
                f"{owner}: a {type(solid).__name__} {what}; give a solid with a positive relaxed modulus and without a "
                "dashpot alongside, such as StandardSolid or Prony."
            )
