"""What a page asks its worker: one question at a time, and the newest study before everything else."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from winkler.web.pictures.answer import Frame
from winkler.web.session.export import File
from winkler.web.session.worker import Done, Progress, Wrong

__all__ = ["Questions"]

Question = Callable[[int], Any]
"""Makes a question of its number."""


class Questions:
    """Questions that wait, and the one that is being answered.

    A study that is asked makes what was asked about the answer before worthless: moments of it are no longer looked at,
    and a sweep or sheets that are under way end.  What is looked at or taken along ends nothing.

    Parameters
    ----------
    ask
        Sends a question to the worker.
    """

    def __init__(self, ask: Callable[[Question], None]) -> None:
        self.ask = ask
        self.forget()

    def forget(self) -> None:
        """Nothing is asked any more."""
        self._study: Question | None = None
        self._look: Question | None = None
        self._exports: list[Question] = []
        self._answering = False
        self._solving = False

    @property
    def quiet(self) -> bool:
        """Whether nothing is asked and nothing waits."""
        return not (self._answering or self._study or self._look or self._exports)

    def study(self, question: Question) -> None:
        """Ask a study; of several that wait only the newest is asked."""
        self._study, self._look = question, None
        self._next()

    def look(self, question: Question) -> None:
        """Ask for another moment of the answer that is shown, unless that answer is about to go."""
        if not (self._study or self._solving):
            self._look = question
            self._next()

    def export(self, question: Question) -> None:
        """Ask for a file."""
        self._exports.append(question)
        self._next()

    def heard(self, reply: Any) -> None:
        """Take note of a reply to the question that was asked last, and go on."""
        if isinstance(reply, Wrong):
            self._exports.clear()
        if isinstance(reply, Frame | Wrong | Done):
            self._solving = False
        # sheets follow after the frame, and a sweep gives way to another study
        if isinstance(reply, Frame | Wrong | Done | File) or (isinstance(reply, Progress) and self._study):
            self._answering = False
        self._next()

    def _next(self) -> None:
        if self._answering:
            return
        if self._exports and not self._solving:
            question = self._exports.pop(0)
        elif self._study:
            question, self._study, self._solving = self._study, None, True
        elif self._look:
            question, self._look = self._look, None
        else:
            return
        self._answering = True
        self.ask(question)
