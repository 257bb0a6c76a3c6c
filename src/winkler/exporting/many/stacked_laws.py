"""Laws of one form, stacked for many contacts: tables of every kind of contact, and the loop over all contacts."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.exporting.choose import law_of
from winkler.exporting.laws.balls import ball_rows
from winkler.exporting.many.loops import (
    loop_attracted,
    loop_balls,
    loop_damped,
    loop_particles,
    loop_relaxing,
    loop_sheared,
    loop_table,
    loop_yielding,
)
from winkler.exporting.step_law import StepLaw
from winkler.numerics.jit import Kernel
from winkler.numerics.types import Array
from winkler.problems.particles.contacts import Contacts
from winkler.values.errors import InvalidInput

WORK_SPACE = "work space"
"""What a part of the state is called that holds nothing from one step to the next."""


class ContactLoop(NamedTuple):
    """How contacts of one kernel are stepped.

    Parameters
    ----------
    kernel : Kernel
        The loop over contacts.
    asks_for_memory : bool
        Whether a step does so.
    entries : tuple of str
        What goes in, in this order.
    springs : tuple of str
        Parts of the state that may be kept in single precision.
    deepest : tuple of (str, int)
        In which table, and where, the greatest depth stands.
    """

    kernel: Kernel[Any, None]
    asks_for_memory: bool
    entries: tuple[str, ...]
    springs: tuple[str, ...]
    deepest: tuple[str, int]


LOOPS: dict[str, ContactLoop] = {
    "step_table": ContactLoop(loop_table, False, ("depth",), (), ("depth", -1)),
    "step_attracted": ContactLoop(loop_attracted, False, ("depth",), (), ("depth", -1)),
    "step_sheared": ContactLoop(loop_sheared, True, ("depth", "motion"), ("displaced",), ("depth", -1)),
    "step_ball": ContactLoop(loop_balls, False, ("depth", "motion", "twist", "roll"), ("displaced",), ("law", 5)),
    "step_particle": ContactLoop(loop_particles, False, ("depth",), (), ("law", 10)),
    "step_yielding": ContactLoop(loop_yielding, False, ("depth",), (), ("depth", -1)),
    "step_damped": ContactLoop(loop_damped, True, ("depth", "duration"), (), ("depth", -1)),
    "step_relaxing": ContactLoop(loop_relaxing, True, ("depth", "duration"), ("place", "memory"), ("solid", 2)),
}
"""Name of the kernel of a law -> its loop."""


class StackedLaws(NamedTuple):
    """Laws of one form.

    Parameters
    ----------
    law : StepLaw
        The first of them.
    tables : tuple of ndarray, (kinds, ...)
    kinds : int
        How many laws there are.
    """

    law: StepLaw
    tables: tuple[Array, ...]
    kinds: int

    @property
    def loop(self) -> ContactLoop:
        """The loop over contacts of these laws."""
        return LOOPS[self.law.kernel.__name__]

    @property
    def deepest(self) -> Array:
        """Greatest depth of every kind [m], ``(kinds,)``."""
        name, place = self.loop.deepest
        names = [table.name for table in self.law.tables]
        return np.asarray(self.tables[names.index(name)][:, place])

    def parts(self, *, single: bool) -> dict[str, np.ndarray[Any, Any]]:
        """Return name -> what a contact remembers before its first touch, of the type that it is kept in."""
        parts = {part.name: np.array(part.begin) for part in self.law.state if part.meaning != WORK_SPACE}
        if single:
            parts.update((name, parts[name].astype(np.float32)) for name in self.loop.springs)
        return parts

    def work(self) -> list[np.ndarray[Any, Any]]:
        """Return work space for one step, that of what goes in and comes out at the end."""
        return [np.array(part.begin) for part in self.law.state if part.meaning == WORK_SPACE]


def stacked_laws(law: Any, *, tolerance: float, count: int) -> StackedLaws:
    """Return the laws of a problem, of several in a list, or of `Contacts` that differ.

    Raises
    ------
    InvalidInput
        If one is no contact law, or they are not of one form.
    """
    if isinstance(law, Contacts):
        if not law.depth.size:
            raise InvalidInput("ContactArray: the Contacts are none; give Contacts.apart(...) of at least one pair.")
        if np.any(law.displaced != 0.0) or np.any(law.dissipation != 0.0) or np.any(law.depth > 0.0):
            raise InvalidInput("ContactArray: the contacts have been moved already; give Contacts.apart(...).")
        fields = [field.name for field in dataclasses.fields(law)]
        one = Contacts(**{name: getattr(law, name)[:1] for name in fields})
        return StackedLaws(law_of(one, tolerance=tolerance, count=count), (ball_rows(law),), law.depth.size)
    problems = law if isinstance(law, Sequence) else (law,)
    if not problems:
        raise InvalidInput("ContactArray: no law is given; give a problem that `export` supports, or a list of them.")
    laws = [law_of(problem, tolerance=tolerance, count=count) for problem in problems]
    forms = [_form(one) for one in laws]
    for place, form in enumerate(forms):
        if form != forms[0]:
            raise InvalidInput(
                f"ContactArray: law {place} has another form than law 0 (another kind of law, or tables with other "
                "numbers of rows or springs); give each form a ContactArray of its own."
            )
    rows = zip(*(one.tables for one in laws), strict=True)
    tables = tuple(np.stack([np.array(table.numbers, dtype=float) for table in row]) for row in rows)
    return StackedLaws(laws[0], tables, len(laws))


def _form(law: StepLaw) -> tuple[Any, ...]:
    """Return what laws must share to be stepped in one loop."""
    begins = tuple((part.name, part.begin.shape, part.begin.tobytes()) for part in law.state)
    return law.kernel.__name__, tuple(np.shape(table.numbers) for table in law.tables), begins
