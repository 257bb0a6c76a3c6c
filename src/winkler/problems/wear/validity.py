"""How far worn profiles can be trusted."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from winkler.foundation.bed import Bed
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.media.offers import PressedWaves, offers
from winkler.problems.assumptions.coupling import sliding_note, sticking_note
from winkler.problems.normal.strong_parts import strong_parts
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.normal.validity import indentation_notes
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.problems.wear.states import WearState, WornState
from winkler.values.validity import Assumption, Note, Standing, standing_of

DIMAKI = "A. V. Dimaki, A. I. Dmitriev, Y. S. Chai, V. L. Popov, Int. J. Solids Struct. 51 (2014) 4215-4220"
POPOV = "V. L. Popov, Sci. Rep. 4 (2014) 3749, doi:10.1038/srep03749"
JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sect. 7.2, doi:10.1017/CBO9781139171731"


FINE_SLIP, COARSE_SLIP = 0.01, 0.1
"""Relative error of the loss in a cycle up to which a grid is fine, and beyond which it does not resolve the slip."""
SAME_CORE = 1e-6
"""Part of the radius of a core by which it may differ and count as the same."""
UNWORN = 1e-9
"""Worn depth over the size of the contact below which nothing is said of worn edges."""

DEBRIS = Note(
    Assumption.WEAR,
    Standing.APPROXIMATE,
    "Debris is assumed to leave the contact at once, and the law of wear not to change. A layer of debris or "
    "oxide that carries load and slips is not modelled.",
    "assumption of the law of wear",
)


def slip_note(bed: Bed) -> Note:
    """Return the note on the slip of a fretting contact."""
    bodies = (bed.medium.first, bed.medium.second) if isinstance(bed.medium, HalfSpace) else ()
    if bodies and max(body.poisson for body in bodies if isinstance(body, Elastic)) == 0.0:
        slip = "Slip is axisymmetric and parallel to the motion, because Poisson's ratio is zero."
        return Note(Assumption.SLIP, Standing.EXACT, slip, JOHNSON)
    slip = (
        "Slip is assumed axisymmetric and parallel to the motion (Cattaneo-Mindlin). If Poisson's ratio is not "
        "zero, the true worn profile is not quite round."
    )
    if offers(bed.medium, PressedWaves):
        slip += (
            " Under this assumption pressures, tractions and slip follow from the normal and shear kernels of "
            "the layers."
        )
    return Note(Assumption.SLIP, Standing.APPROXIMATE, slip, JOHNSON)


SLIDES_EVERYWHERE = Note(
    Assumption.WEAR,
    Standing.APPROXIMATE,
    "Every point of the contact slides over the whole distance. This assumption applies to a body that stays in "
    "contact. The other body wears along a track of many contact lengths; its wear is not included.",
    "assumption of gross sliding",
)


def core_note(source: str) -> Note:
    """Return the note on what the core bears in the end, according to a source."""
    return Note(
        Assumption.WEAR,
        Standing.EXACT,
        "The limiting profile does not depend on the law of wear. The pressure is infinite at the edge of the "
        "stick zone; a real edge yields or cracks.",
        source,
    )


def resolution_note(last: WornState, tolerance: float, scale: str) -> Note:
    """Return the note on grid and jumps.

    Parameters
    ----------
    last : WornState
    tolerance : float
        Of each jump.
    scale : str
        What it is a part of.
    """
    return Note(
        Assumption.RESOLUTION,
        Standing.APPROXIMATE,
        f"The worn profile is known at {last.nodes.size} places; the error of each jump is at most "
        f"{tolerance:.0e} of the {scale}. Use a finer grid or a smaller tolerance to see the effect.",
        DIMAKI,
    )


def core_notes(bed: Bed, first: float, alone: float) -> Iterator[Note]:
    """Yield the notes on the limiting profile around a core.

    Parameters
    ----------
    bed : Bed
    first, alone : float
        Radius of what sticks before wear, and where the core bears alone [m].
    """
    grows = alone > first * (1.0 + SAME_CORE)
    if not grows:
        yield core_note(POPOV)
    if not offers(bed.medium, PressedWaves):
        return
    yield moved_core_note(first, alone, "FrettingWear")


def moved_core_note(first: float, alone: float, follow: str) -> Note:
    """Return the note on a core on layers, which moves while its surroundings wear.

    Parameters
    ----------
    first, alone : float
        What sticks before wear, and where the core bears alone [m].
    follow : str
        The problem that follows the core.
    """
    grows = alone > first * (1.0 + SAME_CORE)
    fate = (
        f"grows while its surroundings wear, to less than {alone:.4g} m. The final half-width of the stick zone "
        f"depends on the law of wear; the stick zone before wear was used. {follow} computes its growth."
        if grows
        else (
            f"shrinks while its surroundings wear, to {min(first, alone):.4g} m. At this half-width it carries "
            "the whole load without slip."
        )
    )
    return Note(
        Assumption.SLIP,
        Standing.APPROXIMATE if grows else Standing.EXACT,
        "With the normal and shear kernels of the layers the half-width of the stick zone before wear is "
        f"{first:.4g} m. The stick zone {fate}",
        "the friction limit of a spring on layers depends on the pressure outside of it",
    )


def _march_notes(bed: Bed, tolerance: float, states: Sequence[WearState], rubbing: SurfaceFriction) -> tuple[Note, ...]:
    # the notes on the profile's own slopes and yield before wear
    depth, radius = (np.array([getattr(states[0], word)]) for word in ("depth", "radius"))
    pressed = indentation_notes(bed, depth, radius, rubbing)
    worn = worn_yield(bed.medium, states[1:]) if len(states) > 1 else ()
    return (*pressed, *worn, DEBRIS, resolution_note(states[-1], tolerance, "depth"))


LEAST_SHARE = 1e-11
"""Below this part of the shear force of sliding the stick radius differs from the contact radius by rounding."""


def slip_grid_note(found: float, expected: float, share: float) -> tuple[Note, ...]:
    """Return the note on how well a grid resolves the slip, by its loss in a cycle before wear and that of springs.

    Wear takes pressure times slip, which is this loss over the coefficient of friction.  Nothing is said where nothing
    slips.

    Parameters
    ----------
    found, expected : float
        Loss in a cycle before wear on the grid and of springs [J], or per length [J/m].
    share : float
        Amplitude of the shear force before wear, over the force at which everything slides [-].
    """
    lost = (
        f"The shear force is {share:.2g} of the sliding force before wear; slip and wear are of the order of "
        "rounding errors"
    )
    if 0.0 < share < LEAST_SHARE or found > expected == 0.0:
        return (Note(Assumption.RESOLUTION, Standing.OUTSIDE, f"{lost}; give a larger amplitude.", DIMAKI),)
    if not expected > 0.0:
        return ()
    error = found / expected - 1.0
    more = "more" if error > 0.0 else "less"
    text = (
        f"In a cycle before wear the grid dissipates {100.0 * abs(error):.2g} per cent {more} than infinitely "
        "fine springs"
    )
    if abs(error) > FINE_SLIP:
        text += ": the slip zone is narrow, and its wear rate has this error; use more cells"
    return (
        Note(Assumption.RESOLUTION, standing_of(abs(error), FINE_SLIP, COARSE_SLIP), f"{text}.", DIMAKI, abs(error)),
    )


def worn_yield(medium: object, states: Sequence[WornState]) -> tuple[Note, ...]:
    """Return what is known of yield under the worn profile.

    Parameters
    ----------
    medium
        Any.
    states : sequence of WornState
        None if the pressure is infinite somewhere.
    """
    parts = strong_parts(medium)
    fact = ""
    if states and parts:
        least = min(part.solid.strength for part in parts)
        share = max(float(np.max(state.pressure)) for state in states) / least
        fact = f"The maximum mean pressure at a node is {share:.3g} of the smallest strength."
    return unknown_yield(medium, "the stresses under the worn profile are not computed", fact)


def fretting_notes(bed: Bed, coefficient: float, tolerance: float, states: Sequence[WearState]) -> tuple[Note, ...]:
    """Return how far a fretting contact can be trusted.

    Parameters
    ----------
    bed : Bed
        Before wear.
    coefficient : float
        Of friction [-].
    tolerance : float
        Of each jump.
    states : sequence of WearState
    """
    coupled = sticking_note(bed.medium, coefficient)
    return (*_march_notes(bed, tolerance, states, SurfaceFriction(coefficient)), coupled, slip_note(bed))


def sliding_notes(bed: Bed, tolerance: float, states: Sequence[WearState]) -> tuple[Note, ...]:
    """Return how far a sliding contact can be trusted; parameters as `fretting_notes`."""
    return (
        # the law of wear does not define the friction
        *_march_notes(bed, tolerance, states, SurfaceFriction(math.inf)),
        *edge_notes(states[-1]),
        sliding_note(bed.medium, math.nan),
        SLIDES_EVERYWHERE,
    )


def edge_notes(last: WornState) -> tuple[Note, ...]:
    """Return how much more than the mean a node bears in a state worn by sliding."""
    if last.worn_depth < UNWORN * last.edge or not last.mean_pressure > 0.0:
        return ()
    excess = float(np.max(last.pressure)) / last.mean_pressure
    stated = (
        f"In the last state the maximum pressure at a node is {excess:.3g} of the mean. A node at the edge of a "
        "growing contact may carry about twice the mean pressure until its corner is worn off. The position of "
        "the edge has an error of one node."
    )
    return (Note(Assumption.RESOLUTION, Standing.APPROXIMATE, stated, "the shape is straight in x^2 between nodes"),)
