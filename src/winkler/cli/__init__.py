"""The command line: ``winkler run study.toml`` and what belongs to it.

Nothing heavy is imported here; every command imports what it needs when it is called.

Exit codes: 0 done; 1 a number is not what ``[[expect]]`` or a literature case says; 2 the input cannot be used; 3 a
solver did not converge; 4 the theory does not hold there; 70 a mistake in winkler itself; 130 interrupted; 143
terminated.
"""

from __future__ import annotations

import contextlib
import signal
import sys
from collections.abc import Iterator, Sequence
from threading import current_thread, main_thread
from types import FrameType
from typing import NoReturn

__all__ = ["main"]

UNUSABLE, MISTAKE, INTERRUPTED, TERMINATED = 2, 70, 130, 143
LONGEST = 200
"""Letters of a path in a sentence."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code; errors become one sentence on stderr.

    Parameters
    ----------
    arguments
        Words after ``winkler``; those of the process if not given.
    """
    words = list(sys.argv[1:] if arguments is None else arguments)
    traceback = "--traceback" in words
    words = [word for word in words if word != "--traceback"]
    _end_cleanly_when_terminated()
    with _interrupts() as interrupts:
        try:
            from winkler.cli.app import app

            answer = app(args=words or ["--help"], prog_name="winkler", standalone_mode=False)
            if answer == INTERRUPTED:  # what typer makes of Ctrl-C
                return _interrupted()
            return answer if isinstance(answer, int) else 0
        except KeyboardInterrupt:
            return _interrupted()
        except Exception as error:
            if traceback:
                raise
            return _told(error, interrupts)


def _told(error: Exception, interrupts: list[int]) -> int:
    """Say what went wrong in one sentence, and return the exit code."""
    from winkler.errors import WinklerError

    if isinstance(error, WinklerError):
        _say(str(error))
        return error.exit_code
    if interrupts or type(error).__name__ == "Abort":
        return _interrupted()
    if hasattr(error, "format_message") and hasattr(error, "exit_code"):
        context = getattr(error, "ctx", None)
        path = context.command_path if context is not None else "winkler"
        _say(f"{str(error.format_message()).rstrip('.')}; `{path} --help` tells what is known.")
        return int(error.exit_code)
    if isinstance(error, OSError) and isinstance(error.filename, str):
        _say(f"'{error.filename[-LONGEST:]}' cannot be used ({(error.strerror or '').lower()}); give another path.")
        return UNUSABLE
    text = " ".join(str(error).split())
    _say(f"winkler made a mistake ({type(error).__name__}: {text}); run again with --traceback and report it.")
    return MISTAKE


def _interrupted() -> int:
    _say("interrupted; nothing was written.")
    return INTERRUPTED


def _say(sentence: str) -> None:
    print(f"winkler: {sentence}", file=sys.stderr)


@contextlib.contextmanager
def _interrupts() -> Iterator[list[int]]:
    """Give the list of the times that Ctrl-C was pressed: some libraries turn the interrupt into an error of theirs."""
    seen: list[int] = []

    def remembered(number: int, frame: FrameType | None) -> None:
        seen.append(number)
        signal.default_int_handler(number, frame)

    heard = signal.getsignal(signal.SIGINT) is signal.default_int_handler and current_thread() is main_thread()
    if heard:  # else somebody else takes care of it
        signal.signal(signal.SIGINT, remembered)
    try:
        yield seen
    finally:
        if heard and signal.getsignal(signal.SIGINT) is remembered:
            signal.signal(signal.SIGINT, signal.default_int_handler)


def _end_cleanly_when_terminated() -> None:
    def stop(*_: object) -> NoReturn:
        raise SystemExit(TERMINATED)

    try:
        signal.signal(signal.SIGTERM, stop)
    except ValueError:  # not in the main thread: whoever runs us there keeps its own handler
        return
