"""The states of a study in their order, for undo and redo."""

from __future__ import annotations

import time
from collections.abc import Callable

TOGETHER = 1.0
"""Changes of values in less than this are one step, as those of a slider that moves [s]."""
MOST_STATES = 200
"""States that are kept; the oldest go first."""


class UndoStates:
    """Texts of a study, of which one is the present one.

    Parameters
    ----------
    clock
        Returns the time [s].
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self.clock = clock
        self.states: list[str] = []
        self.place = -1
        self._at, self._value_before = 0.0, False

    @property
    def can_undo(self) -> bool:
        """Whether there is an earlier state."""
        return self.place > 0

    @property
    def can_redo(self) -> bool:
        """Whether a later state was undone."""
        return self.place < len(self.states) - 1

    def keep(self, text: str, *, value: bool) -> bool:
        """Keep a state, and return whether it is a new one; what was undone before is dropped.

        Parameters
        ----------
        text
            The study.
        value
            Whether only a value has changed: several within a second are one step.
        """
        if self.states and text == self.states[self.place]:
            return False
        now = self.clock()
        together = value and self._value_before and not self.can_redo and now - self._at < TOGETHER and self.place > 0
        del self.states[self.place + 1 - together :]
        self.states.append(text)
        del self.states[: max(0, len(self.states) - MOST_STATES)]
        self.place = len(self.states) - 1
        self._at, self._value_before = now, value
        return True

    def undo(self) -> str:
        """Return the state before, which becomes the present one; the present one if there is none before."""
        return self._go(-1)

    def redo(self) -> str:
        """Return the state that was undone last, which becomes the present one."""
        return self._go(1)

    def _go(self, step: int) -> str:
        self.place = min(max(self.place + step, 0), len(self.states) - 1)
        self._value_before = False
        return self.states[self.place]
