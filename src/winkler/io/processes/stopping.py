"""Ctrl-C and termination: received at once, and remembered until they are handled.

Python raises an interrupt at the statement that is being executed.  In a callback (of a weak reference, while a module
is imported) it is reported and lost, and libraries turn it into errors of their own or swallow it.  So a flag stores
the signal that was received: it is checked between points, states and curves and before anything is written, and an
interrupt that was lost in a callback is raised again a moment later.  `deferred_signals` delays signals until a few
statements that belong together are done.
"""

from __future__ import annotations

import _thread
import contextlib
import gc
import signal
import sys
import threading
import time
import traceback
from collections.abc import Iterator
from types import FrameType
from typing import Any, NoReturn

INTERRUPTED, TERMINATED = 130, 143
"""What the command line returns after Ctrl-C, and after SIGTERM."""

REPEAT_DELAY = 0.01
"""Time after which a lost signal is raised again [s]."""


class _StopState:
    """The signal received, the number of blocks that defer signals, whether one came meanwhile, and what was kept."""

    signal: int = 0
    blocks: int = 0
    pending: bool = False
    kept: str = ""


_state = _StopState()


def raise_pending() -> None:
    """Raise the signal that was received, unless it has been cleared.

    Raises
    ------
    KeyboardInterrupt, SystemExit
        After Ctrl-C, after SIGTERM.
    """
    if _state.signal and not _state.blocks:
        _raise()


def clear_interrupt() -> None:
    """Clear Ctrl-C: the results so far are going to be written."""
    if _state.signal == signal.SIGINT:
        _state.signal = 0


def set_kept_text(sentence: str) -> None:
    """Set the sentence that states what was kept if the run is stopped."""
    _state.kept = sentence


@contextlib.contextmanager
def deferred_signals() -> Iterator[None]:
    """Defer signals: one that is received inside the block is raised after it, also by a handler of other programs."""
    if threading.current_thread() is not threading.main_thread():  # signals are raised in that one only
        yield
        return
    received: list[int] = []
    others: dict[int, Any] = {}
    for sign in (signal.SIGINT, signal.SIGTERM):
        handler = signal.getsignal(sign)
        if callable(handler) and handler is not _receive and not _state.blocks:
            others[sign] = handler
            signal.signal(sign, lambda number, _: received.append(number))
    _state.blocks += 1
    try:
        yield
    finally:
        _state.blocks -= 1
        for number, handler in others.items():
            signal.signal(number, handler)
    for number in received[:1]:
        signal.raise_signal(number)
    if _state.pending and not _state.blocks:
        _state.pending = False
        raise_pending()


class ReceivedSignal:
    """The signal that a block received, once it has ended.

    Parameters
    ----------
    code
        The exit code of the signal that was received and not cleared; 0 if there is none.
    kept
        What was kept, as the end of a sentence.
    """

    def __init__(self) -> None:
        self.code, self.kept = 0, ""


@contextlib.contextmanager
def receiving_signals() -> Iterator[ReceivedSignal]:
    """Receive Ctrl-C and SIGTERM in the main thread, where no other handler is installed."""
    received, installed, previous_hook = ReceivedSignal(), set[int](), sys.unraisablehook

    def report_lost(error: sys.UnraisableHookArgs) -> None:
        if not _state.signal:
            previous_hook(error)
        elif issubclass(error.exc_type, KeyboardInterrupt | SystemExit):
            _thread.start_new_thread(_repeat, ())
        # else an object that was incomplete when the signal came cannot be finalized; it is removed all the same

    default_handlers: dict[int, Any] = {signal.SIGINT: signal.default_int_handler, signal.SIGTERM: signal.SIG_DFL}
    outermost = all(signal.getsignal(number) is not _receive for number in default_handlers)
    if outermost:
        _reset()
        sys.unraisablehook = report_lost
    try:
        for number, handler in default_handlers.items():
            if signal.getsignal(number) is handler and threading.current_thread() is threading.main_thread():
                installed.add(number)
                signal.signal(number, _receive)
        yield received
    except BaseException as error:
        if _state.signal:
            _clear(error)
        raise
    finally:
        # a signal that comes now is in `received`
        with contextlib.suppress(KeyboardInterrupt, SystemExit), deferred_signals():
            for number in installed:
                if signal.getsignal(number) is _receive:
                    signal.signal(number, default_handlers[number])
            if sys.unraisablehook is report_lost:
                sys.unraisablehook = previous_hook
        received.code, received.kept = _code(), _state.kept or "nothing was written"
        if outermost:
            _reset()


def _clear(error: BaseException | None) -> None:
    """Release what the frames of an error hold, while errors in doing so are still reported here."""
    while error is not None:
        traceback.clear_frames(error.__traceback__)
        error = error.__context__
    gc.collect()


def _reset() -> None:
    _state.signal, _state.blocks, _state.pending, _state.kept = 0, 0, False, ""


def _code() -> int:
    if not _state.signal:
        return 0
    return INTERRUPTED if _state.signal == signal.SIGINT else TERMINATED


def _receive(number: int, frame: FrameType | None) -> None:
    _state.signal = number
    _state.pending = _state.blocks > 0
    raise_pending()


def _raise() -> NoReturn:
    if _state.signal == signal.SIGINT:
        raise KeyboardInterrupt
    raise SystemExit(TERMINATED)


def _repeat() -> None:
    """Send the main thread the lost signal once more, which also wakes a waiting thread."""
    time.sleep(REPEAT_DELAY)
    number = _state.signal
    if not number or signal.getsignal(number) is not _receive:
        return
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(threading.main_thread().ident or 0, number)
    else:
        _thread.interrupt_main(signal.Signals(number))
