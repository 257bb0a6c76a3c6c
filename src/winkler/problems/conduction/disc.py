"""The disc through which a pressed contact conducts, and what the medium behind it means for conduction."""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.directional import DirectionalBed
from winkler.foundation.footprint import RoundOutline
from winkler.materials.conducting_body import Plated
from winkler.media.conduction.conductors import ElectricalConductors, HeatConductors
from winkler.media.conduction.disc_resistance import BARBER, HOLM, Resistances
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.types import Array, Q
from winkler.problems.conduction.stiffness_analogy import plain
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.validity import shape_notes
from winkler.values.checks.outline import refuse_unless_round
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing


def resistances_of(bed: Bed, conductors: ElectricalConductors | HeatConductors, radius: Array) -> Resistances:
    """Return the resistances to a current through contacts of given radii `(m,)` [m].

    A film counts by the area of the contact; how the current spreads below it, as in the disc of equal stiffness.

    Raises
    ------
    OutsideValidity
        If a film or a plating needs an area that the bed does not define; if the contact is nearly as wide as a rod;
        if the springs are those of a height map on layers.
    """
    if isinstance(bed, DirectionalBed) and not bed.homogeneous:
        raise OutsideValidity(
            f"{type(conductors).__name__}: the springs of a height map on layers do not determine its "
            "conductance, because its stiffness is not that of a homogeneous half-space; reduce the map on a "
            "HalfSpace."
        )
    if any(isinstance(body, Plated) for body in (conductors.first, conductors.second)):
        refuse_unless_round(bed, type(conductors).__name__, "a plating")
    parts = conductors.resistances(radius)
    if not np.any(parts.film) or isinstance(bed.footprint, RoundOutline):
        return parts
    touching = radius > 0.0
    a = np.where(touching, radius, 1.0)
    return parts._replace(film=parts.film * math.pi * a**2 / bed.footprint.area(a))


def conducting_disc(
    contact: Indentation[Q], conductors: ElectricalConductors | HeatConductors
) -> tuple[IndentationSolution[Q], Resistances]:
    """Return the contact under its loads, and the resistances `(m,)` of its disc."""
    pressed = contact.solve()
    return pressed, resistances_of(contact.bed, conductors, np.ravel(np.asarray(pressed.radius, dtype=float)))


def scope_notes(bed: Bed, conductors: ElectricalConductors | HeatConductors, radius: Array) -> tuple[Note, ...]:
    """Return why the disc of this bed conducts as it does; of many loads for the widest contact."""
    widest = float(np.max(radius, initial=0.0))
    if not isinstance(bed.footprint, RoundOutline) and not plain(conductors):
        first = Note(
            Assumption.CONDUCTION,
            Standing.APPROXIMATE,
            "Thick bare conductors conduct through this contact as through the disc of equal stiffness. The "
            "spreading by a film and the constriction by a rod are computed for this disc. The resistance of a "
            "film itself is computed with the true area.",
            BARBER,
        )
    elif not isinstance(bed.footprint, RoundOutline):
        first = Note(
            Assumption.CONDUCTION,
            Standing.EXACT,
            "A contact of any shape conducts as the disc of equal stiffness. This requires homogeneous, elastic "
            "bodies and radii of the foundation equal to k / (2 E*).",
            BARBER,
        )
    elif not plain(conductors):
        first = Note(
            Assumption.CONDUCTION,
            Standing.EXACT,
            "With a film, a plating or a rod conductance is not proportional to stiffness. The resistance is "
            "computed from the contact radius alone.",
            HOLM,
        )
    elif isinstance(bed.medium, HomogeneousMedium):
        first = Note(
            Assumption.CONDUCTION,
            Standing.EXACT,
            "The conductance of the contact is 2 / (E* (rho_1 + rho_2)) times its stiffness dF/dd; so every "
            "spring in contact has the same conductance.",
            BARBER,
        )
    else:
        first = Note(
            Assumption.CONDUCTION,
            Standing.EXACT,
            "The elastic medium is not homogeneous, so conductance is not proportional to stiffness. The "
            "conductors are computed as given, and the resistance follows from the contact radius alone.",
            HOLM,
        )
    if widest == 0.0:
        return (*bed.notes, first)
    return (*bed.notes, first, *shape_notes(bed, widest))


def mean_free_path_note(radius: Array, mean_free_path: float) -> tuple[Note, ...]:
    """Return what free flight of the carriers means for the narrowest contact; nothing if their path is zero.

    Parameters
    ----------
    radius : ndarray
        [m].
    mean_free_path : float
        [m].
    """
    touching = np.ravel(radius)[np.ravel(radius) > 0.0]
    if mean_free_path == 0.0 or touching.size == 0:
        return ()
    narrowest = float(np.min(touching))
    number = mean_free_path / narrowest
    # Sharvin's 4 rho l / (3 pi a^2) over Holm's rho / (2 a), of two like bodies
    share = 8.0 * number / (3.0 * math.pi)
    standing = Standing.ASYMPTOTIC if share < 0.01 else Standing.APPROXIMATE if share < 0.1 else Standing.OUTSIDE
    return (
        Note(
            Assumption.CONTINUUM,
            standing,
            f"The mean free path of the carriers is {number:.3g} times the radius of the narrowest contact "
            f"(Knudsen number). Sharvin's resistance is {100.0 * share:.3g} % of Holm's and is not included.",
            "Yu. V. Sharvin, Sov. Phys. JETP 21 (1965) 655",
        ),
    )
