"""The command line: ``winkler run study.toml`` and the other commands.

Nothing heavy is imported here; every command imports what it needs when it is called.

Exit codes: 0 done; 1 a number differs from ``[[expect]]`` or a literature case; 2 the input cannot be used; 3 a
solver did not converge; 4 the theory does not hold there; 70 a mistake in winkler itself; 130 interrupted; 143
terminated.
"""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Sequence

from winkler.cli.streams import flush_streams, spell_unencodable, write_line
from winkler.io.processes import stopping

UNUSABLE_INPUT, MISTAKE = 2, 70
MOST_CHARACTERS = 200
"""Longest path in a sentence [characters]."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code; errors become one sentence on stderr.

    Parameters
    ----------
    arguments
        Words after ``winkler``; those of the process if not given.
    """
    traceback, received = False, stopping.ReceivedSignal()
    try:
        with stopping.receiving_signals() as received:
            spell_unencodable()
            words = list(sys.argv[1:] if arguments is None else arguments)
            traceback = "--traceback" in words
            code = _command([word for word in words if word != "--traceback"])
            flush_streams()
            return code
    except KeyboardInterrupt:
        return _stopped(received)
    except SystemExit:
        if not received.code:
            raise
        return received.code
    except Exception as error:
        if traceback:
            raise
        return _report_error(error, received)


def _command(words: list[str]) -> int:
    from winkler.cli.app import command

    stopping.raise_pending()  # what is imported may swallow a signal
    answer = command(args=words or ["--help"], prog_name="winkler", standalone_mode=False)
    stopping.raise_pending()
    if answer == stopping.INTERRUPTED:  # typer's exit code for Ctrl-C
        raise KeyboardInterrupt
    return answer if isinstance(answer, int) else 0


def _report_error(error: Exception, received: stopping.ReceivedSignal) -> int:
    """Write one sentence about an error, and return the exit code."""
    from winkler.values.errors import Interrupted, WinklerError, mistake_in

    with contextlib.suppress(WinklerError):  # one error is reported, and this one comes first
        flush_streams()
    if (received.code and not isinstance(error, Interrupted)) or type(error).__name__ == "Abort":
        return _stopped(received)  # a library turned the signal into an error of its own
    if isinstance(error, WinklerError):
        _write_error(str(error))
        return error.exit_code
    if hasattr(error, "format_message") and hasattr(error, "exit_code"):
        context = getattr(error, "ctx", None)
        path = context.command_path if context is not None else "winkler"
        _write_error(f"{str(error.format_message()).rstrip('.')}; `{path} --help` lists what is allowed.")
        return int(error.exit_code)
    if isinstance(error, OSError) and isinstance(error.filename, str):
        _write_error(
            f"'{error.filename[-MOST_CHARACTERS:]}' cannot be used ({(error.strerror or '').lower()}); give another "
            "path."
        )
        return UNUSABLE_INPUT
    _write_error(f"{mistake_in(error)}; run again with --traceback and report it.")
    return MISTAKE


def _stopped(received: stopping.ReceivedSignal) -> int:
    """Return the exit code of a run that was stopped; after Ctrl-C a sentence states what was stored."""
    if received.code == stopping.TERMINATED:
        return received.code
    _write_error(f"interrupted; {received.kept or 'nothing was written'}.")
    return stopping.INTERRUPTED


def _write_error(sentence: str) -> None:
    write_line(f"winkler: {sentence}", error=True)
