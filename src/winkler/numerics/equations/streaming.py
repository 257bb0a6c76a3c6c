"""A routine that calls a function, turned into a stream that is read.

Minimisers call what they minimise, and return at the end.  Here the routine runs in a thread of its own that rests
whenever it has handed something over, until the reader asks for the next; only one of the two is at work at a time.
"""

from __future__ import annotations

import contextvars
import threading
from collections.abc import Callable, Iterator
from queue import SimpleQueue
from typing import TypeVar

__all__ = ["streamed"]

T = TypeVar("T")
R = TypeVar("R")

GRACE_SECONDS = 2.0
"""How long a routine whose reader has left may go on until it next hands something over [s]."""


class _Left(BaseException):
    """The reader has left; nothing in the routine is to take this for an error of its own."""


def streamed(routine: Callable[[Callable[[T], None]], R]) -> Iterator[T | R]:
    """Yield what a routine hands over, one after the other, and last what it returns.

    Parameters
    ----------
    routine : callable
        Takes the function by which it hands over.

    Raises
    ------
    Exception
        Whatever the routine raises.

    Examples
    --------
    >>> def counting(hand_over):
    ...     for number in range(2):
    ...         hand_over(number)
    ...     return "done"
    >>> list(streamed(counting))
    [0, 1, 'done']
    """
    items: SimpleQueue[T | R] = SimpleQueue()
    turn, left = threading.Semaphore(0), threading.Event()
    ended: list[BaseException | None] = []

    def hand_over(item: T) -> None:
        items.put(item)
        turn.acquire()
        if left.is_set():
            raise _Left

    def run() -> None:
        try:
            result = routine(hand_over)
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
