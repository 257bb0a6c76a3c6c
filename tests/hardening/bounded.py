"""A call within bounds of memory, processor and time: in a child, so that a bound that is passed kills nothing else."""

from __future__ import annotations

import os
import resource
import signal
from pathlib import Path

from winkler.values.errors import WinklerError

__all__ = ["sentence_within"]

MEMORY = 600_000_000
"""Bytes that may be allocated, beyond what the process has."""
PROCESSOR = 10
"""Seconds of the processor; what is tested takes less than one."""
WAITING = 60
"""Seconds after which what waits for ever is ended."""


def sentence_within(call) -> str:
    """Return the sentence of the `WinklerError` that a call raises; "" if it returns, else what became of it."""
    held = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    ours, theirs = os.pipe()
    child = os.fork()
    if not child:
        code = 1
        try:
            resource.setrlimit(resource.RLIMIT_AS, (held + MEMORY, held + MEMORY))
            resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR, PROCESSOR + 1))
            signal.signal(signal.SIGALRM, signal.SIG_DFL)
            signal.alarm(WAITING)
            try:
                call()
                text = ""
            except WinklerError as error:
                text = str(error)
            except BaseException as error:
                text = f"raised {type(error).__name__}: {error}"
            os.write(theirs, text.encode("utf-8", "replace")[:6000])
            code = 0
        finally:
            os._exit(code)
    os.close(theirs)
    with open(ours, "rb") as pipe:
        text = pipe.read().decode("utf-8")
    _, status = os.waitpid(child, 0)
    return text if status == 0 else f"ended by {os.waitstatus_to_exitcode(status)}"
