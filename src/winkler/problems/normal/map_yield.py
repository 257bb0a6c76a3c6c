"""Whether a body stays elastic below a map of loads."""

from __future__ import annotations

import functools
from typing import Any, TypeAlias

from winkler.materials.elastic import Elastic
from winkler.media.interior.map_peak import greatest_below
from winkler.media.interior.peak import StressSpot
from winkler.media.offers import LayerStack, offers
from winkler.numerics.caching import cached_by_value
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.yield_statement import share_of
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.values.validity import Assumption, Note, Standing

MISES = "R. von Mises, Nachr. Ges. Wiss. Goettingen (1913) 582; A. E. H. Love, doi:10.1098/rsta.1929.0009"
ROUNDING = 1e-9
"""Part of the side of a map below which a place is zero, in words."""

Body: TypeAlias = Elastic | LayerStack
"""What a load acts on: a half-space, or layers."""


def field_below(load: SurfaceLoad, body: Body) -> tuple[Any, float]:
    """Return the field below a load, and in which unit its displacements are."""
    if isinstance(body, Elastic):
        return load.field(body.poisson), 0.5 / body.shear
    from winkler.media.layered.map_interior import MapInLayers  # loaded with layers

    return MapInLayers(body, load.loads, load.pixel, periodic=load.periodic), 1.0


@functools.lru_cache(maxsize=16)
def greatest_stress(load: SurfaceLoad, solid: Elastic) -> StressSpot:
    """Return the greatest von Mises stress [Pa] in a half-space and its place [m], z >= 0."""
    found = greatest_below(load.field(solid.poisson), climbed=not load.periodic)
    return _placed(found.greatest[0], load)


@cached_by_value(maxsize=8)  # what is said of yielding and the summary ask for the same
def greatest_in_parts(load: SurfaceLoad, medium: object, parts: tuple[StrongPart, ...]) -> tuple[StressSpot, ...]:
    """Return the greatest von Mises stress [Pa] in each part of the bodies and its place [m], z into its body.

    Parameters
    ----------
    load : SurfaceLoad
        What acts on the first body.
    medium
        Homogeneous bodies, layers, or a grading, whose parts these are.
    parts : tuple of StrongPart
    """
    if not offers(medium, LayerStack):
        return tuple(greatest_stress(load if part.first else load.reversed(), part.solid) for part in parts)
    inside, _ = field_below(load, medium)
    return tuple(
        _placed(greatest_below(inside, top=part.top, bottom=part.bottom).greatest[0], load)
        if part.first
        else greatest_stress(load.reversed(), part.solid)
        for part in parts
    )


def _placed(spot: StressSpot, load: SurfaceLoad) -> StressSpot:
    return spot._replace(x=spot.x + float(load.corner[0]), y=spot.y + float(load.corner[1]))


def _shares(medium: object, load: SurfaceLoad) -> list[tuple[float, StressSpot, StrongPart]]:
    """Return the greatest stress over the strength of each part that has one."""
    parts = strong_parts(medium)
    spots = greatest_in_parts(load, medium, parts)
    return [(spot.value / part.solid.strength, spot, part) for spot, part in zip(spots, parts, strict=True)]


def greatest_share(medium: object, load: SurfaceLoad) -> float:
    """Return the greatest von Mises stress over the strength; zero where no body has a strength."""
    return max((share for share, _, _ in _shares(medium, load)), default=0.0)


def map_yield_notes(medium: object, load: SurfaceLoad, when: str = "") -> tuple[Note, ...]:
    """Return whether the bodies stay elastic; nothing where none of them has a strength.

    Parameters
    ----------
    medium
        Homogeneous bodies, layers, or a grading.
    load : SurfaceLoad
        What acts on the first body.
    when : str, optional
        Which of many states it is, added to the sentence.
    """
    found = _shares(medium, load)
    if not found:
        return ()
    share, spot, part = max(found, key=lambda each: each[0])
    depth = spot.z if part.first else -spot.z
    x, y = (each if abs(each) > ROUNDING * side else 0.0 for each, side in zip(spot[1:3], load.lengths, strict=True))
    where = f"{share_of(share, part)}, at x = {x:.3g} m, y = {y:.3g} m, z = {depth:.3g} m{when}"
    if share >= 1.0:
        return (
            Note(
                Assumption.ELASTIC,
                Standing.OUTSIDE,
                f"By von Mises' criterion yielding has begun: the greatest elastic stress is {where}; the result is "
                "not elastic.",
                MISES,
            ),
        )
    statement = f"By von Mises' criterion the bodies stay elastic: the greatest stress on this grid is {where}."
    return (Note(Assumption.ELASTIC, Standing.ASYMPTOTIC, statement, MISES),)
