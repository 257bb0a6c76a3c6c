"""The command line: ``winkler run study.toml`` and what belongs to it.

Nothing heavy is imported here; every command imports what it needs when it is called.

Exit codes: 0 done; 1 a number is not what ``[[expect]]`` or a literature case says; 2 the input cannot be used; 3 a
solver did not converge; 4 the theory does not hold there; 70 a mistake in winkler itself; 130 interrupted; 143
terminated.
"""

from __future__ import annotations

import contextlib
import gc
import sys
from collections.abc import Sequence

from winkler.cli.saying import emptied, say, spell
from winkler.study.batch import stopping

__all__ = ["main"]

UNUSABLE, MISTAKE = 2, 70
LONGEST = 200
"""Letters of a path in a sentence."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code; errors become one sentence on stderr.

    Parameters
    ----------
    arguments
        Words after ``winkler``; those of the process if not given.
    """
    traceback, heard = False, stopping.Heard()
    try:
        with stopping.listening() as heard:
            spell()
            words = list(sys.argv[1:] if arguments is None else arguments)
            traceback = "--traceback" in words
            code = _command([word for word in words if word != "--traceback"])
            emptied()
            return code
    except KeyboardInterrupt:
        return _stopped(heard)
    except SystemExit:
        if not heard.code:
            raise
        return heard.code
    except Exception as error:
        if traceback:
            raise
        return _told(error, heard)


def _command(words: list[str]) -> int:
    from winkler.cli.app import command

    stopping.look()  # what is imported may swallow a signal
    gc.set_threshold(100_000)  # what is loaded stays: to look through it for garbage takes a tenth of a short run
    answer = command(args=words or ["--help"], prog_name="winkler", standalone_mode=False)
    stopping.look()
    if answer == stopping.INTERRUPTED:  # what typer makes of Ctrl-C
        raise KeyboardInterrupt
    return answer if isinstance(answer, int) else 0


def _told(error: Exception, heard: stopping.Heard) -> int:
    """Say what went wrong in one sentence, and return the exit code."""
    from winkler.errors import Interrupted, WinklerError, mistake_in

    with contextlib.suppress(WinklerError):  # one error is reported, and this one comes first
        emptied()
    if (heard.code and not isinstance(error, Interrupted)) or type(error).__name__ == "Abort":
        return _stopped(heard)  # a library made an error of its own of it
    if isinstance(error, WinklerError):
        _say(str(error))
        return error.exit_code
    if hasattr(error, "format_message") and hasattr(error, "exit_code"):
        context = getattr(error, "ctx", None)
        path = context.command_path if context is not None else "winkler"
        _say(f"{str(error.format_message()).rstrip('.')}; `{path} --help` tells what is known.")
        return int(error.exit_code)
    if isinstance(error, OSError) and isinstance(error.filename, str):
        _say(f"'{error.filename[-LONGEST:]}' cannot be used ({(error.strerror or '').lower()}); give another path.")
        return UNUSABLE
    _say(f"{mistake_in(error)}; run again with --traceback and report it.")
    return MISTAKE


def _stopped(heard: stopping.Heard) -> int:
    """Return the exit code of a run that was stopped; after Ctrl-C a sentence says what was kept."""
    if heard.code == stopping.TERMINATED:
        return heard.code
    _say(f"interrupted; {heard.kept or 'nothing was written'}.")
    return stopping.INTERRUPTED


def _say(sentence: str) -> None:
    say(f"winkler: {sentence}", error=True)
