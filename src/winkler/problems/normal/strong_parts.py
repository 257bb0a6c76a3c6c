"""The parts of a medium that were given a strength: bodies, layers, and what carries the layers."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from winkler.materials.elastic import Elastic, TransverselyIsotropic
from winkler.materials.graded import PowerLawGraded
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium

ELASTIC = (Elastic, TransverselyIsotropic, PowerLawGraded)
"""Solids whose stresses are known."""


class StrongPart(NamedTuple):
    """A part of one of the bodies, of one solid.

    Parameters
    ----------
    name : str
        What it is called in a sentence.
    solid : Elastic
        In `elastic_parts` a TransverselyIsotropic or a PowerLawGraded as well.
    first : bool
        Whether it belongs to the first body, z > 0.
    top, bottom : float
        Depths between which it lies [m].
    """

    name: str
    solid: Any
    first: bool
    top: float = 0.0
    bottom: float = math.inf


def strong_parts(medium: object) -> tuple[StrongPart, ...]:
    """Return the parts of a medium whose strength is finite, from the surface of the first body down.

    Parameters
    ----------
    medium
        Any; one that names no solids has no such part.
    """
    return tuple(part for part in solid_parts(medium) if part.solid.strength < math.inf)


def solid_parts(medium: object) -> tuple[StrongPart, ...]:
    """Return the isotropic elastic parts of a medium, with a strength or without, from the first surface down.

    Parameters
    ----------
    medium
        Any; one that names no solids has no such part.
    """
    return tuple(part for part in elastic_parts(medium) if isinstance(part.solid, Elastic))


def elastic_parts(medium: object) -> tuple[StrongPart, ...]:
    """Return the same, and transversely isotropic and graded ones, to which no single strength belongs.

    Parameters
    ----------
    medium
        Any; one that names no solids has no such part.
    """
    return tuple(_parts(medium))


def _parts(medium: object) -> Iterator[StrongPart]:
    if offers(medium, RelaxingMedium):
        medium = medium.bodies
    first, second = getattr(medium, "first", None), getattr(medium, "second", None)
    spans: tuple[tuple[float, float], ...] = getattr(medium, "spans", ())
    if spans:
        layers, on = medium.layers, medium.on  # type: ignore[attr-defined]
        solids = [layer.solid for layer in layers] + [on]
        for number, (solid, span) in enumerate(zip(solids, spans, strict=False), 1):
            if isinstance(solid, ELASTIC):
                name = f"layer {number}" if number <= len(layers) else "body under the layers"
                yield StrongPart(name, solid, True, *span)
    elif isinstance(first, ELASTIC):
        yield StrongPart("first body", first, True)
    if isinstance(second, ELASTIC):
        yield StrongPart("second body", second, False)
