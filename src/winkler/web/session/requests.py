"""Requests of a page to its worker: one at a time, and the newest study first."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from winkler.web.pictures.replies import File, InspectedFile, MomentComplete
from winkler.web.session.worker import Done, Progress, Wrong

MakeRequest = Callable[[int], Any]
"""Builds a request from its number."""


class RequestQueue:
    """Waiting requests, and the running one.

    A new study cancels waiting moments of the previous results, and ends its sweep or sheets.  Requests for moments and
    exports end nothing.

    Parameters
    ----------
    send
        Sends a request to the worker.
    """

    def __init__(self, send: Callable[[MakeRequest], None]) -> None:
        self.send = send
        self.clear()

    def clear(self) -> None:
        """Discard all requests."""
        self._study: MakeRequest | None = None
        self._look: MakeRequest | None = None
        self._exports: list[MakeRequest] = []
        self._is_busy = False
        self._is_solving = False

    @property
    def is_idle(self) -> bool:
        """Whether no request runs or waits."""
        return not (self._is_busy or self._study or self._look or self._exports)

    def study(self, request: MakeRequest) -> None:
        """Request a study; of several waiting ones only the newest is sent."""
        self._study, self._look = request, None
        self._next()

    def look(self, request: MakeRequest) -> None:
        """Request another moment of the displayed results, unless they are about to be replaced."""
        if not (self._study or self._is_solving):
            self._look = request
            self._next()

    def export(self, request: MakeRequest) -> None:
        """Request a file, or what an uploaded one is taken for."""
        self._exports.append(request)
        self._next()

    def received(self, reply: Any) -> None:
        """Process a reply to the last request, and send the next one."""
        if isinstance(reply, Wrong):
            self._exports.clear()
        if isinstance(reply, MomentComplete | Wrong | Done):
            self._is_solving = False
        # sheets follow after the pictures, and a sweep ends for another study
        if isinstance(reply, MomentComplete | Wrong | Done | File | InspectedFile) or (
            isinstance(reply, Progress) and self._study
        ):
            self._is_busy = False
        self._next()

    def _next(self) -> None:
        if self._is_busy:
            return
        if self._exports and not self._is_solving:
            request = self._exports.pop(0)
        elif self._study:
            request, self._study, self._is_solving = self._study, None, True
        elif self._look:
            request, self._look = self._look, None
        else:
            return
        self._is_busy = True
        self.send(request)
