"""A contact law as every target writes it: a kernel that does one step, its tables, its state, what goes in and out."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from winkler.exporting.translation.plain import plain
from winkler.exporting.translation.subset import Translatable
from winkler.numerics.types import Array

SIZE_POWERS = {"m": 1, "N": 2, "N/m": 1, "J": 3, "N m": 3}
"""With which power of their size quantities of balls that are alike grow, by their unit; others stay."""


class StepNumber(NamedTuple):
    """One number that goes into a step or comes out of it.

    Parameters
    ----------
    name, unit, meaning : str
    changes : bool
        Whether it is by how much something changes in the step, not what it is at its end.
    """

    name: str
    unit: str
    meaning: str
    changes: bool = False


RADIUS = StepNumber("curvature_radius", "m", "R of this pair, 1/R = 1/R1 + 1/R2; the same in all steps of a contact")
"""What goes in besides where the law is that of balls of all sizes."""


class LawTable(NamedTuple):
    """Numbers of a law that never change.

    Parameters
    ----------
    name, meaning : str
    numbers : ndarray
    falling : tuple of int
        Which of them fall with the size of balls that are alike, in proportion to its inverse (works of adhesion).
    """

    name: str
    meaning: str
    numbers: Array
    falling: tuple[int, ...] = ()


class StatePart(NamedTuple):
    """What a contact remembers from step to step.

    Parameters
    ----------
    name, meaning : str
    begin : ndarray
        Before the first touch; real numbers, whole numbers or truth values.
    """

    name: str
    meaning: str
    begin: np.ndarray[Any, Any]


class StepLaw(NamedTuple):
    """A contact law, step by step.

    Parameters
    ----------
    title : str
    kernel : Kernel or function
        Takes the tables, the parts of the state, motion and answer, in this order; writes state and answer.
    tables : tuple of LawTable
    state : tuple of StatePart
    motion, answer : tuple of StepNumber
        What goes in and comes out.
    notes : tuple of str
        What is assumed, and how far it holds.
    inputs : tuple of str
        The problem in words, line by line.
    trial : ndarray, (steps, inputs)
        Motions of the test trace.
    curvature_radius : float
        R [m] of the contact, 1/R = 1/R1 + 1/R2, if the bodies are balls; else not-a-number.
    against_plane : bool
        Whether it is one body against a plane that does not yield: the half of a contact of two that are alike.
    every_radius : bool
        Whether the last number that goes in is R of the pair. The kernel then does the step of a pair of R as
        `curvature_radius`, whose lengths, and forces over lengths squared, are in proportion.
    """

    title: str
    kernel: Translatable
    tables: tuple[LawTable, ...]
    state: tuple[StatePart, ...]
    motion: tuple[StepNumber, ...]
    answer: tuple[StepNumber, ...]
    notes: tuple[str, ...]
    inputs: tuple[str, ...]
    trial: Array
    curvature_radius: float = math.nan
    against_plane: bool = False
    every_radius: bool = False

    def trace(self, motions: Array | None = None) -> Array:
        """Return the answers, (steps, outputs), to motions, (steps, inputs); those of the test trace unless given."""
        rows = np.ascontiguousarray(self.trial if motions is None else motions, dtype=float)
        state = [np.array(part.begin) for part in self.state]
        answers = np.empty((len(rows), len(self.answer)))
        for row, into in zip(rows, answers, strict=True):
            self.step(state, row, into)
        return answers

    def step(self, state: list[Any], motion: Array, answer: Array, kernel: Any = None) -> None:
        """Move a contact by one step, by the plain source of the kernel unless another function is given."""
        own = plain(self.kernel) if kernel is None else kernel
        tables = [np.array(table.numbers, dtype=float) for table in self.tables]
        if not self.every_radius:
            own(*tables, *state, motion.copy(), answer)
            return
        size = motion[-1] / self.curvature_radius
        for table, numbers in zip(self.tables, tables, strict=True):
            numbers[list(table.falling)] /= size
        alike = [x / size if one.unit == "m" else x for x, one in zip(motion[:-1], self.motion, strict=False)]
        own(*tables, *state, np.array(alike), answer)
        for k, one in enumerate(self.answer):
            for _ in range(SIZE_POWERS.get(one.unit, 0)):
                answer[k] *= size

    @property
    def state_size(self) -> int:
        """Size of the state of one contact in bytes."""
        return sum(math.prod(part.begin.shape) * part.begin.itemsize for part in self.state)
