"""The page's side of the worker: requests, replies, and stopping."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import multiprocessing
import signal
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple, Protocol

from winkler.io.foreign import reason_of
from winkler.web.session.worker import Done, Halt, Solve, work


class Worker(NamedTuple):
    """A process, and the pipe to it."""

    process: Any
    pipe: Any


def started() -> Worker:
    """Start a worker, which reports when it is ready."""
    context = multiprocessing.get_context("spawn")
    page_end, worker_end = context.Pipe()
    process = context.Process(target=work, args=(worker_end,), daemon=True)
    with _interrupts_held():
        process.start()
    worker_end.close()
    return Worker(process, page_end)


@contextlib.contextmanager
def _interrupts_held() -> Iterator[None]:
    """Hold back Ctrl-C while a process is started, which is then deaf to it from its first line on."""
    if not hasattr(signal, "pthread_sigmask"):  # not on Windows
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


class ReplyReceiver(Protocol):
    """Receives a reply, and whether it belongs to the newest request."""

    def __call__(self, reply: Any, *, newest: bool) -> None:
        """Take a reply."""


class Solver:
    """Sends requests to one worker.

    Parameters
    ----------
    on_reply
        Called, in the event loop of the page, with the replies to the newest request and the newest study.
    on_exit
        Called there when the worker has ended by itself, with whether it was ready.
    take
        Gives a worker; by default a new one.

    Raises
    ------
    OSError
        If no process can be started; also by `send` and `stop`, after which the next request tries again.
    """

    def __init__(
        self, on_reply: ReplyReceiver, on_exit: Callable[[bool], None], take: Callable[[], Worker] | None = None
    ) -> None:
        self.on_reply, self.on_exit, self.take = on_reply, on_exit, take
        self.loop = asyncio.get_running_loop()
        self.number = self.study = 0
        self.started_at = 0.0
        self.pending: set[int] = set()
        self.process: Any = None
        self.pipe: Any = None
        self._begin()

    def _begin(self) -> None:
        self.ready = False
        self.process, self.pipe = (self.take or started)()
        try:
            threading.Thread(target=self._listen, args=(self.pipe,), daemon=True).start()
        except RuntimeError as error:
            self.close()
            raise OSError(errno.EAGAIN, str(error)) from None

    def _listen(self, pipe: Any) -> None:
        with contextlib.suppress(EOFError, OSError, RuntimeError), pipe:  # the worker, or the loop, has ended
            while True:
                number, reply = pipe.recv()
                self.loop.call_soon_threadsafe(self._pass_on, pipe, number, reply)
        with contextlib.suppress(RuntimeError):
            self.loop.call_soon_threadsafe(self._closed, pipe)

    def _closed(self, pipe: Any) -> None:
        if pipe is self.pipe:  # otherwise the page has ended it
            ready = self.ready
            self.close()
            self.on_exit(ready)

    def _pass_on(self, pipe: Any, number: int, reply: Any) -> None:
        if pipe is not self.pipe:
            return
        if number == 0:  # it is ready, or has been told to halt
            if not self.ready:
                self.ready, self.started_at = True, time.monotonic()
            return
        if isinstance(reply, Done):
            self.pending.discard(number)
        if number in (self.number, self.study):
            self.on_reply(reply, newest=number == self.number)

    def send(self, make: Callable[[int], Any]) -> None:
        """Send a request; `make` builds it from its number."""
        if self.pipe is None:
            self._begin()
        self.number += 1
        self.pending.add(self.number)
        self.started_at = time.monotonic()
        request = make(self.number)
        if isinstance(request, Solve):
            self.study = self.number
        with contextlib.suppress(OSError):  # the worker has ended, which the listener notices
            self.pipe.send(request)

    def disregard(self) -> None:
        """Pass on no further reply to earlier requests, as their results would replace why there are none."""
        self.number += 1
        self.study = self.number

    @property
    def working(self) -> bool:
        """Whether a reply is incomplete."""
        return bool(self.pending)

    @property
    def starting(self) -> bool:
        """Whether there is a worker that is not ready."""
        return self.pipe is not None and not self.ready

    @property
    def seconds(self) -> float:
        """Time since the newest request [s]."""
        return time.monotonic() - self.started_at if self.working and self.ready else 0.0

    def halt(self) -> None:
        """End a batch of fits after the present curve; what was fitted is its answer."""
        if self.pipe is not None:
            with contextlib.suppress(OSError):
                self.pipe.send(Halt())

    def stop(self) -> None:
        """Stop the running request by starting a new worker."""
        self.close()
        self._begin()

    def close(self) -> None:
        """End the worker."""
        self.pipe = None
        self.ready = False
        self.pending.clear()
        if self.process is not None:
            self.process.kill()
            self.process.join(1.0)
            self.process = None


def no_process(error: OSError) -> str:
    """Return the sentence for a process that cannot be started."""
    return f"No process can be started ({reason_of(error).lower()}); close other programs, then change the study."
