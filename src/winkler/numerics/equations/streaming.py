"""A routine that calls a function, turned into a stream that is read.

Minimisers call what they minimise, and return at the end.  Here the routine runs in a thread of its own that rests
whenever it has emitted an item, until the reader requests the next; only one of the two is at work at a time.
"""

from __future__ import annotations

import contextvars
import threading
from collections.abc import Callable, Iterator
from queue import SimpleQueue
from typing import TypeVar

T = TypeVar("T")
R = TypeVar("R")

GRACE_SECONDS = 2.0
"""How long a routine whose reader has left may go on until it next emits an item [s]."""


class _ReaderGone(BaseException):
    """The reader has left; nothing in the routine is to take this for an error of its own."""


def streamed(routine: Callable[[Callable[[T], None]], R]) -> Iterator[T | R]:
    """Yield what a routine emits, one after the other, and last what it returns.

    Parameters
    ----------
    routine : callable
        Takes the function by which it emits.

    Raises
    ------
    Exception
        Whatever the routine raises.

    Examples
    --------
    >>> def counting(emit):
    ...     for number in range(2):
    ...         emit(number)
    ...     return "done"
    >>> list(streamed(counting))
    [0, 1, 'done']
    """
    items: SimpleQueue[T | R] = SimpleQueue()
    turn, left = threading.Semaphore(0), threading.Event()
    ended: list[BaseException | None] = []

    def emit(item: T) -> None:
        items.put(item)
        turn.acquire()
        if left.is_set():
            raise _ReaderGone

    def run() -> None:
        try:
            result = routine(emit)
            ended.append(None)
            items.put(result)
        except BaseException as error:
            ended.append(error)
            items.put(None)  # type: ignore[arg-type]

    thread = threading.Thread(target=contextvars.copy_context().run, args=(run,), daemon=True)
    thread.start()
    try:
        while True:
            item = items.get()
            if ended and ended[0] is not None:
                raise ended[0]
            yield item
            if ended:
                return
            turn.release()
    finally:
        left.set()
        turn.release()
        thread.join(GRACE_SECONDS)
