"""Whether a body stays elastic below a map of loads."""

from __future__ import annotations

from winkler.media.interior.peak import StressSpot
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.normal.yield_statement import share_of
from winkler.problems.subsurface.below_surface import greatest_stress
from winkler.problems.subsurface.surface_load import SurfaceLoad
from winkler.validity import Assumption, Note, Standing, worst

__all__ = ["greatest_share", "last_yield_notes", "map_yield_notes"]

MISES = "R. von Mises, Nachr. Ges. Wiss. Goettingen (1913) 582; A. E. H. Love, doi:10.1098/rsta.1929.0009"


def _shares(medium: object, load: SurfaceLoad) -> list[tuple[float, StressSpot, StrongPart]]:
    """Return the greatest stress over the strength of each part that has one."""
    found = []
    for part in strong_parts(medium):
        spot = greatest_stress(load if part.first else load.reversed(), part.solid)
        found.append((spot.value / part.solid.strength, spot, part))
    return found


def greatest_share(medium: object, load: SurfaceLoad) -> float:
    """Return the greatest von Mises stress over the strength; zero where no body has a strength."""
    return max((share for share, _, _ in _shares(medium, load)), default=0.0)


def map_yield_notes(medium: object, load: SurfaceLoad) -> tuple[Note, ...]:
    """Return whether the bodies stay elastic; nothing where none of them has a strength.

    Parameters
    ----------
    medium
        A homogeneous one.
    load : SurfaceLoad
        What acts on the first body.
    """
    found = _shares(medium, load)
    if not found:
        return ()
    share, spot, part = max(found, key=lambda each: each[0])
    depth = spot.z if part.first else -spot.z
    where = f"{share_of(share, part)}, at x = {spot.x:.3g} m, y = {spot.y:.3g} m, z = {depth:.3g} m"
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


def last_yield_notes(medium: object, load: SurfaceLoad, others_bear_more: bool) -> tuple[Note, ...]:
    """Return what is known of yield where the pressures and tractions are those of the last of many states.

    Parameters
    ----------
    medium
        A homogeneous one.
    load : SurfaceLoad
        What acts on the first body in the last state.
    others_bear_more : bool
        Whether another state has a greater pressure or shear force.
    """
    last = map_yield_notes(medium, load)
    if others_bear_more and last and worst(last) is not Standing.OUTSIDE:
        return unknown_yield(medium, "tractions are stored of the last state, and others bear more")
    return last
