"""Validity notes of a sheared line contact: coupling, slip, bulk stress, yield."""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.laws.friction import Coulomb
from winkler.loading.loads import LineForce
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.line.indentation import LineIndentation, LineSolution
from winkler.problems.line_friction.bulk import bulk_note
from winkler.problems.line_friction.marched_states import LineMarchedState
from winkler.problems.line_friction.states import LineTangentialState
from winkler.problems.line_viscoelastic.validity import relaxing_line_notes
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.values.validity import Assumption, Note, Standing

CIAVARELLA = (
    "M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349-2362, doi:10.1016/S0020-7683(97)00154-6; J. Jaeger, Arch. "
    "Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661"
)
SLIP_SUMS = Note(
    Assumption.SLIP,
    Standing.EXACT,
    "For similar bodies the tractions of partial slip are sums of the tractions of normal contacts. Every "
    "history of straight steps in both forces is computed exactly, except for rounding.",
    CIAVARELLA,
)


MARCHED = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "Stick and slip are computed step by step with boundary elements and Coulomb's law. Compared with the "
    "Ciavarella-Jaeger superposition, where it applies, dissipated energy and slip differ by about 0.1 % of their "
    "maximum. Tractions differ by a few per cent of their maximum at the boundaries between stick and slip zones.",
    "compared with sums of earlier contacts where those hold; D. A. Hills, D. Nowell, Mechanics of Fretting Fatigue, "
    "Kluwer, 1994",
)


DRAGGED = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "Stick and slip on the viscoelastic bodies are computed step by step with boundary elements and Coulomb's law. The "
    "pressure does not depend on the traction. Compared with a second discretisation with other elements and time "
    "steps, tractions differ by at most 3 % of their maximum, the dissipated energy by at most 1 %.",
    "tests/problems/line_friction/test_relaxing_lines.py",
)


def dragged_line_notes(
    bed: LineFoundation | LayeredLineFoundation, law: Coulomb, widest: LineMarchedState, moments: Array
) -> tuple[Note, ...]:
    """Return how far a sheared line contact of bodies that relax can be trusted; its moments [s]."""
    pressed = relaxing_line_notes(bed, moments, widest.half_width)
    return (*pressed, sticking_note(bed.medium, law.coefficient), DRAGGED)  # type: ignore[arg-type]


def sheared_line_notes(
    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation,
    law: Coulomb,
    widest: LineTangentialState | LineMarchedState,
    bulk: float,
) -> tuple[Note, ...]:
    """Return how far a sheared line contact can be trusted.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
    law : Coulomb
    widest : LineTangentialState or LineMarchedState
        Of the path.
    bulk : float
        Greatest magnitude of the bulk stress [Pa].
    """
    a, contact = widest.half_width, LineIndentation(bed, LineForce(widest.force_per_length)).solve()
    of_bodies = [note for note in contact.validity if note.assumption is not Assumption.ELASTIC]
    notes = [*of_bodies, sticking_note(bed.medium, law.coefficient)]  # type: ignore[arg-type]
    if isinstance(widest, LineMarchedState):
        notes.append(MARCHED)
    elif widest.lean == 0.0 or a == 0.0:
        notes.append(SLIP_SUMS)
    else:
        notes.append(bulk_note(widest.lean, a, widest.force_per_length / bed.medium.modulus))
    return (*notes, *slid_yield_notes(contact, law, bed.strain_per_stress * bulk if bulk else 0.0))


def slid_yield_notes(contact: LineSolution, law: Coulomb, strain: float) -> tuple[Note, ...]:
    """Return whether the bodies stay elastic: without friction they are stressed least, where all slides most.

    The mean of a contact and of its mirror image, sheared in the opposite direction, is the contact without friction,
    whose greatest von Mises stress is therefore not above theirs.
    """
    notes = tuple(note for note in contact.validity if note.assumption is Assumption.ELASTIC)
    if not notes or notes[0].standing is Standing.OUTSIDE or not np.isfinite(contact.peak_pressure):
        return notes
    most = max(
        _slid_stress(contact, part, law.coefficient, strain) / part.solid.strength
        for part in strong_parts(contact.problem.bed.medium)
    )
    if most < 1.0:
        text = f"By von Mises' criterion the contact stays elastic: were all of it to slide, {most:.3g} of the strength"
        return (Note(Assumption.ELASTIC, notes[0].standing, f"{text} would be reached.", notes[0].source),)
    text = (
        "By von Mises' criterion the contact stays elastic without friction, and would yield if all of it slid "
        f"({most:.3g} of the strength). For partial slip `stresses` of a state computes the stresses on "
        "homogeneous bodies, but not on layers."
    )
    return (Note(Assumption.ELASTIC, Standing.APPROXIMATE, text, notes[0].source),)


def _slid_stress(contact: LineSolution, part: StrongPart, friction: float, strain: float) -> float:
    """Return a bound of the von Mises stress [Pa]: that of sliding, and that of the bulk stress beside it."""
    poisson = part.solid.poisson
    bulk: float = part.solid.young / (1.0 - poisson**2) * strain if part.first else 0.0
    return contact.part_stress(part, friction).value + abs(bulk) * math.sqrt(1.0 - poisson + poisson**2)
