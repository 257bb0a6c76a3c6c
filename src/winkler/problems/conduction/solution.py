"""What solutions of conducting bodies have in common: the contact, its resistance, and one load out of many."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar, TypeVar

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.numerics.types import PerLoad, Q
from winkler.problems.conduction.disc import scope_notes
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.normal.strong_parts import strong_parts
from winkler.problems.normal.yield_statement import yield_notes_of_bed
from winkler.values.validity import Note
from winkler.values.value import value

One = TypeVar("One", covariant=True)
"""The solution of one load."""


@value
class ConductingSolution(PerLoad[One, Q]):
    """The contact through which something flows; every quantity has the shape of the load.

    Parameters
    ----------
    problem : Constriction, ThermalConstriction or JouleHeating
        The problem that was solved.
    contact : IndentationSolution
        The contact, of the shape of the load.
    resistance : float or ndarray
        R [ohm or K/W]; infinite without contact.
    """

    problem: Any
    contact: IndentationSolution[Q]
    resistance: Q

    per_load: ClassVar[str] = "resistance"

    @property
    def depth(self) -> Q:
        """d [m] of the contact."""
        return self.contact.depth

    @property
    def force(self) -> Q:
        """F_N [N]."""
        return self.contact.force

    @property
    def radius(self) -> Q:
        """a [m] of the contact."""
        return self.contact.radius

    @property
    def pressed(self) -> PressedSprings:
        """The springs, from which pressure and stress are restored; of one load."""
        return self.contact.pressed

    @property
    def _disc_notes(self) -> tuple[Note, ...]:
        """How far analogy, bodies and film can be trusted."""
        bed, conductors = self.problem.contact.bed, self.problem.conductors
        depth, radius = np.asarray(self.depth, dtype=float), np.asarray(self.radius, dtype=float)
        yielding = yield_notes_of_bed(bed, depth, radius) if strong_parts(bed.medium) else ()
        return (*scope_notes(bed, conductors, radius), *yielding, *conductors.notes)

    def at(self, index: int | tuple[int, ...]) -> One:
        """Return the solution of one load of an array.

        Raises
        ------
        InvalidInput
            If there is no such load.
        """
        one: One = dataclasses.replace(self.problem, contact=self.contact.at(index).problem).solve()
        return one
