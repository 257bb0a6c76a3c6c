"""Validity notes of every contact of a body that relaxes."""

from __future__ import annotations

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.problems.normal.validity import contact_notes
from winkler.problems.viscoelastic.march import elastic_like
from winkler.values.validity import Note


def relaxing_notes(bed: Bed, depth: Array, radius: Array, own: tuple[Note, ...]) -> tuple[Note, ...]:
    """Return the notes on bed, contact `(m,)` and yield about those of one kind of problem."""
    contact = contact_notes(elastic_like(bed), depth, radius)
    return (*bed.notes, *contact, *own, *relaxing_yield(bed.medium))
