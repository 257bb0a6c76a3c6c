"""The page's side of the worker: questions go out, answers come back, and whatever takes too long is stopped."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import multiprocessing
import threading
import time
from collections.abc import Callable
from typing import Any, NamedTuple, Protocol

from winkler.web.session.worker import Done, Solve, work

__all__ = ["Solver", "Worker", "started"]


class Worker(NamedTuple):
    """A process, and the pipe to it."""

    process: Any
    pipe: Any


def started() -> Worker:
    """Start a worker; it gets ready on its own."""
    context = multiprocessing.get_context("spawn")
    mine, theirs = context.Pipe()
    process = context.Process(target=work, args=(theirs,), daemon=True)
    process.start()
    theirs.close()
    return Worker(process, mine)


class Heard(Protocol):
    """Takes a part of an answer, and whether it is one to the newest question."""

    def __call__(self, reply: Any, *, newest: bool) -> None: ...


class Solver:
    """Asks one worker.

    Parameters
    ----------
    heard
        Called, in the loop of the page, with every part of the answers to the newest question and the newest study.
    lost
        Called there when the worker has ended by itself, with whether it had been ready.

    Raises
    ------
    OSError
        If no process can be started; also by `ask` and `stop`, after which the next question tries again.
    """

    def __init__(self, heard: Heard, lost: Callable[[bool], None]) -> None:
        self.heard, self.lost = heard, lost
        self.loop = asyncio.get_running_loop()
        self.number = self.study = 0
        self.since = 0.0
        self.open: set[int] = set()
        self.process: Any = None
        self.pipe: Any = None
        self._begin()

    def _begin(self) -> None:
        self.ready = False
        self.process, self.pipe = started()
        try:
            threading.Thread(target=self._listen, args=(self.pipe,), daemon=True).start()
        except RuntimeError as error:
            self.close()
            raise OSError(errno.EAGAIN, str(error)) from None

    def _listen(self, pipe: Any) -> None:
        with contextlib.suppress(EOFError, OSError, RuntimeError), pipe:  # the worker, or the loop, has ended
            while True:
                number, reply = pipe.recv()
                self.loop.call_soon_threadsafe(self._take, pipe, number, reply)
        with contextlib.suppress(RuntimeError):
            self.loop.call_soon_threadsafe(self._ended, pipe)

    def _ended(self, pipe: Any) -> None:
        if pipe is self.pipe:  # else it was ended by the page
            ready = self.ready
            self.close()
            self.lost(ready)

    def _take(self, pipe: Any, number: int, reply: Any) -> None:
        if pipe is not self.pipe:
            return
        if number == 0:
            self.ready, self.since = True, time.monotonic()
            return
        if isinstance(reply, Done):
            self.open.discard(number)
        if number in (self.number, self.study):
            self.heard(reply, newest=number == self.number)

    def ask(self, make: Callable[[int], Any]) -> None:
        """Ask a question; `make` gets its number."""
        if self.pipe is None:
            self._begin()
        self.number += 1
        self.open.add(self.number)
        self.since = time.monotonic()
        question = make(self.number)
        if isinstance(question, Solve):
            self.study = self.number
        with contextlib.suppress(OSError):  # the worker has ended, which is heard of
            self.pipe.send(question)

    @property
    def working(self) -> bool:
        """Whether an answer is not complete."""
        return bool(self.open)

    @property
    def starting(self) -> bool:
        """Whether there is a worker that is not ready."""
        return self.pipe is not None and not self.ready

    @property
    def seconds(self) -> float:
        """For how long the worker has been at the newest question [s]."""
        return time.monotonic() - self.since if self.working and self.ready else 0.0

    def stop(self) -> None:
        """End what is going on, and begin anew."""
        self.close()
        self._begin()

    def close(self) -> None:
        """End the worker."""
        self.pipe = None
        self.ready = False
        self.open.clear()
        if self.process is not None:
            self.process.kill()
            self.process.join(1.0)
            self.process = None
