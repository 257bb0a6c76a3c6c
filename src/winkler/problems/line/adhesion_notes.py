"""Validity notes of a line contact that sticks: range of the attraction, overlap beside it, other stable states."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.laws.adhesion import Dugdale
from winkler.numerics.types import Array
from winkler.problems.adhesion.widest_contact import stable_counts
from winkler.problems.assumptions.adhesion_range import range_note
from winkler.problems.line.equilibria import FIXED_GRIPS, LineLaw, line_states
from winkler.problems.line.stress import Strip
from winkler.problems.line.validity import line_notes
from winkler.problems.line.yield_statement import line_yield_notes
from winkler.values.validity import Assumption, Note, Standing

BESIDE = 4.0
"""How many half-widths from the middle overlap is sought."""
SAMPLES = 512
OVERLAP_TOLERANCE = 1e-9
BANEY = "J. M. Baney, C.-Y. Hui, J. Adhes. Sci. Technol. 11 (1997) 393-406, doi:10.1163/156856197X00778"


def adhesion_notes(
    stressed: Any,
    bed: LineBed,
    law: LineLaw,
    strip: Strip,
    separation: Callable[[Array], Array],
    forces: Array,
) -> tuple[Note, ...]:
    """Return the notes; of many loads, those of the widest contact.

    Parameters
    ----------
    stressed, bed : LineBed
        With the attraction beside the strip, and without.
    law : ShortRange or Dugdale
    strip : Strip
        The widest contact.
    separation
        Takes places beside it [m], returns the distance of the surfaces [m].
    forces : ndarray
        Prescribed forces per length [N/m]; empty if a half-width was prescribed.
    """
    a = strip.half_width
    notes = [*line_notes(stressed, *strip, sticking=True)]
    if a == 0.0:
        return tuple(notes)
    stretch = float(np.sqrt(2.0 * np.pi * a * law.work / bed.medium.modulus) * bed.edge_share(np.array([a]))[0])
    if isinstance(law, Dugdale):
        text = (
            f"For a constant stress of the range {law.range:.3g} m, which is {law.range / stretch:.3g} of the "
            "edge stretch in the limit of short range. Other laws of the same work and strength differ in the "
            "transition."
        )
        notes.append(Note(Assumption.ADHESION, Standing.EXACT, text, BANEY))
    else:
        notes.append(range_note(law, stretch, "By attraction without range"))
    if a < bed.rim and not bed.single:
        notes.append(_overlap_note(bed, a, separation))
    count = int(np.max(stable_counts(line_states(bed, law), FIXED_GRIPS, forces))) if forces.size else 0
    if count > 1:
        text = (
            f"Up to {count} half-widths are stable under one load. The largest is returned, which remains after "
            "firm pressing."
        )
        source = "all limits of stability along the states of equilibrium"
        notes.append(Note(Assumption.EQUILIBRIUM, Standing.EXACT, text, source))
    return (*notes, *line_yield_notes(stressed, strip))


def _overlap_note(bed: LineBed, half_width: float, separation: Callable[[Array], Array]) -> Note:
    end = min(BESIDE * half_width, bed.reach, bed.rim)
    x = half_width + (end - half_width) * (np.arange(SAMPLES) + 0.5) / SAMPLES
    apart = separation(x)
    source = "separation of the deformed surfaces"
    overlap = apart < -OVERLAP_TOLERANCE * float(np.max(np.abs(bed.profile.height(x))))
    if overlap.any():
        text = (
            f"At x = {x[overlap][0]:.4g} m the surfaces would overlap beside the strip: the contact consists "
            "of several strips."
        )
        return Note(Assumption.SINGLE_CONTACT, Standing.OUTSIDE, text, source)
    text = "The load profile may decrease somewhere. It was checked that the surfaces do not overlap beside the strip."
    return Note(Assumption.SINGLE_CONTACT, Standing.EXACT, text, source)
