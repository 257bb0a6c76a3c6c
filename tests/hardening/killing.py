"""A process that has winkler loaded and warm, and forks children which run one command and are killed before its end.

It reads one request per line from its standard input and replies with one line: see `request` of `Killer`.  A child
gets its signal before the n-th operation on a file (a hook of the interpreter counts them), or after so many seconds of
its own processor time, which does not depend on how busy the machine is.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from winkler.cli import main
from winkler.study.batch import fit_run, run
from winkler.study.batch.outcome import Provenance

FILES = {"open", "os.rename", "os.mkdir", "os.rmdir", "os.remove", "os.truncate", "fcntl.flock"}
"""What an audit hook hears of that changes a folder; of files that are opened only those in the folder count."""


class Killer:
    """The process, as the tests use it."""

    def __init__(self) -> None:
        threads = dict.fromkeys(
            ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS"), "1"
        )
        self.process = subprocess.Popen(
            [sys.executable, __file__],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=os.environ | threads,
        )

    def request(self, folder: Path, *words: str, **how: Any) -> dict[str, Any]:
        """Run ``winkler WORDS`` in `folder`.

        ``fork=False`` runs it in the process itself, which is warm afterwards; ``sign`` is the signal of a child, which
        comes before file operation ``event`` or after ``seconds``.  Returns the code (negative: the signal that ended
        it), the operations, the seconds, and what was written on stderr.
        """
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write(json.dumps({"folder": str(folder), "words": words, **how}) + "\n")
        self.process.stdin.flush()
        answer: dict[str, Any] = json.loads(self.process.stdout.readline())
        return answer

    def close(self) -> None:
        """End the process."""
        self.process.communicate()


def _answer(folder: str, words: list[str], fork: bool = True, **how: Any) -> dict[str, Any]:
    errors = Path(folder).with_suffix(".errors")
    os.chdir(folder)
    if not fork:
        return {"code": main(words)}
    reader, writer = os.pipe()
    child = os.fork()
    if not child:
        os.close(reader)
        with errors.open("w", encoding="utf-8") as sys.stderr, open(os.devnull, "w") as sys.stdout:
            count, began = _armed(folder, **how), time.process_time()
            code = main(words)
            os.write(writer, json.dumps({"events": count[0], "seconds": time.process_time() - began}).encode())
        os._exit(code)
    os.close(writer)
    with os.fdopen(reader) as pipe:
        counted = pipe.read()
    _, status = os.waitpid(child, 0)
    return {"code": os.waitstatus_to_exitcode(status), "errors": errors.read_text(), **json.loads(counted or "{}")}


def _armed(folder: str, sign: int = 0, event: int = 0, seconds: float = 0.0) -> list[int]:
    """Make ready to be killed; return the counter of operations on files."""
    count = [0]

    def hook(name: str, arguments: tuple[Any, ...]) -> None:
        if name in FILES and (
            name != "open" or str(arguments[0]).startswith((f"{folder}/", "results", ".", "/dev/fd"))
        ):
            count[0] += 1
            if count[0] == event:
                os.kill(os.getpid(), sign)

    sys.addaudithook(hook)
    if seconds:
        # what this timer does by default ends a process as abruptly as SIGKILL
        kill = signal.SIG_DFL if sign == signal.SIGKILL else lambda *_: os.kill(os.getpid(), sign)
        signal.signal(signal.SIGPROF, kill)
        signal.setitimer(signal.ITIMER_PROF, seconds)
    return count


def _serve() -> None:
    def timeless(question: str, seconds: float, source: str) -> Provenance:
        return Provenance("0", question, "1970-01-01T00:00:00+00:00", 1.0, (("python", "3"),), source)

    run.provenance = fit_run.provenance = timeless
    signal.signal(signal.SIGINT, signal.default_int_handler)
    requests, answers = sys.stdin, sys.stdout
    with open(os.devnull) as sys.stdin, open(os.devnull, "w") as sys.stdout:
        for line in requests:
            print(json.dumps(_answer(**json.loads(line))), file=answers, flush=True)


if __name__ == "__main__":
    _serve()
