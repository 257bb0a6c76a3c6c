"""Ctrl-C and termination: heard at once, remembered until somebody answers.

Python raises an interrupt wherever the interpreter stands.  In a callback (of a weak reference, while a module is
imported) it is reported and forgotten, and libraries turn it into errors of their own or swallow it.  So one flag holds
the signal that was heard: it is looked at between points, states and curves and before anything is written, and an
interrupt that was lost in a callback is raised again a moment later.  `held` keeps signals away from a few statements
that belong together.
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

__all__ = ["INTERRUPTED", "TERMINATED", "Heard", "answered", "held", "keeping", "listening", "look"]

INTERRUPTED, TERMINATED = 130, 143
"""What the command line returns after Ctrl-C, and after SIGTERM."""

AGAIN = 0.01
"""How long after it was lost a signal is raised again [s]."""


class _State:
    """The flag, how many blocks hold signals back, whether one came meanwhile, and what was kept."""

    signal: int = 0
    blocks: int = 0
    late: bool = False
    kept: str = ""


_state = _State()


def look() -> None:
    """Raise what was heard, if nobody has answered it.

    Raises
    ------
    KeyboardInterrupt, SystemExit
        After Ctrl-C, after SIGTERM.
    """
    if _state.signal and not _state.blocks:
        _raise()


def answered() -> None:
    """Forget Ctrl-C: what was reached is going to be written."""
    if _state.signal == signal.SIGINT:
        _state.signal = 0


def keeping(sentence: str) -> None:
    """Say from now on that this was kept, if the run is stopped."""
    _state.kept = sentence


@contextlib.contextmanager
def held() -> Iterator[None]:
    """Hold statements together: a signal that is heard meanwhile is raised after them."""
    if threading.current_thread() is not threading.main_thread():  # signals are raised in that one only
        yield
        return
    _state.blocks += 1
    try:
        yield
    finally:
        _state.blocks -= 1
    if _state.late and not _state.blocks:
        _state.late = False
        look()


class Heard:
    """What became of the signals of a block, once it has ended.

    Parameters
    ----------
    code
        The exit code of the signal that was heard and not answered; 0 if there is none.
    kept
        What was kept, as the end of a sentence.
    """

    def __init__(self) -> None:
        self.code, self.kept = 0, ""


@contextlib.contextmanager
def listening() -> Iterator[Heard]:
    """Hear Ctrl-C and SIGTERM in the main thread, where nobody else listens to them already."""
    end, taken, before = Heard(), set[int](), sys.unraisablehook

    def lost(error: sys.UnraisableHookArgs) -> None:
        if not _state.signal:
            before(error)
        elif issubclass(error.exc_type, KeyboardInterrupt | SystemExit):
            _thread.start_new_thread(_repeat, ())
        # else something that was half-made when the signal came cannot be taken down: it is gone all the same

    free: dict[int, Any] = {signal.SIGINT: signal.default_int_handler, signal.SIGTERM: signal.SIG_DFL}
    outermost = all(signal.getsignal(number) is not _hear for number in free)
    if outermost:
        _forget()
        sys.unraisablehook = lost
    try:
        for number, handler in free.items():
            if signal.getsignal(number) is handler and threading.current_thread() is threading.main_thread():
                taken.add(number)
                signal.signal(number, _hear)
        yield end
    except BaseException as error:
        if _state.signal:
            _clear(error)
        raise
    finally:
        with contextlib.suppress(KeyboardInterrupt, SystemExit), held():  # what comes now is in `end`
            for number in taken:
                if signal.getsignal(number) is _hear:
                    signal.signal(number, free[number])
            if sys.unraisablehook is lost:
                sys.unraisablehook = before
        end.code, end.kept = _code(), _state.kept or "nothing was written"
        if outermost:
            _forget()


def _clear(error: BaseException | None) -> None:
    """Take down what the frames of an error hold, while what goes wrong at it is still heard here."""
    while error is not None:
        traceback.clear_frames(error.__traceback__)
        error = error.__context__
    gc.collect()


def _forget() -> None:
    _state.signal, _state.blocks, _state.late, _state.kept = 0, 0, False, ""


def _code() -> int:
    if not _state.signal:
        return 0
    return INTERRUPTED if _state.signal == signal.SIGINT else TERMINATED


def _hear(number: int, frame: FrameType | None) -> None:
    _state.signal = number
    _state.late = _state.blocks > 0
    look()


def _raise() -> NoReturn:
    if _state.signal == signal.SIGINT:
        raise KeyboardInterrupt
    raise SystemExit(TERMINATED)


def _repeat() -> None:
    """Send the main thread once more the signal that it has lost; it wakes a thread that waits, too."""
    time.sleep(AGAIN)
    number = _state.signal
    if not number or signal.getsignal(number) is not _hear:
        return
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(threading.main_thread().ident or 0, number)
    else:
        _thread.interrupt_main(signal.Signals(number))
