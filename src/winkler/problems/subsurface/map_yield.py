"""Whether a body stays elastic below a map of loads."""

from __future__ import annotations

from winkler.media.interior.peak import StressSpot
from winkler.numerics.types import Array
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.yield_statement import share_of
from winkler.problems.subsurface.below_surface import greatest_in_parts
from winkler.problems.subsurface.loaded_history import LoadedMap
from winkler.problems.subsurface.surface_load import SurfaceLoad
from winkler.values.validity import Assumption, Note, Standing

__all__ = ["greatest_share", "history_yield_notes", "map_yield_notes"]

MISES = "R. von Mises, Nachr. Ges. Wiss. Goettingen (1913) 582; A. E. H. Love, doi:10.1098/rsta.1929.0009"


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
    where = f"{share_of(share, part)}, at x = {spot.x:.3g} m, y = {spot.y:.3g} m, z = {depth:.3g} m{when}"
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


def history_yield_notes(
    medium: object, lengths: Array, heaviest: tuple[LoadedMap, ...], count: int, *, periodic: bool = False
) -> tuple[Note, ...]:
    """Return whether the bodies stay elastic in all states of a history, and which one strains them most.

    Parameters
    ----------
    medium
        Homogeneous bodies, layers, or a grading.
    lengths : ndarray, (2,)
        Lengths of the map [m].
    heaviest : tuple of LoadedMap
        States among which the greatest stress is sought.
    count : int
        How many states there are.
    periodic : bool, optional
        Whether the map is repeated.
    """
    loads = [SurfaceLoad.of_map(lengths, each.pressure, each.traction, periodic=periodic) for each in heaviest]
    if not loads:
        return ()
    shares = [greatest_share(medium, load) if len(loads) > 1 else 0.0 for load in loads]
    worst = shares.index(max(shares))
    when = ""
    if count > 1:
        when = (
            f", in state {heaviest[worst].index + 1} of {count}, the worst of those under the greatest pressure, "
            "traction or shear force"
        )
    return map_yield_notes(medium, loads[worst], when)
