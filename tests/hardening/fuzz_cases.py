"""One case of a fuzz test: tried under a limit of time and memory, reported with its seed, and stored.

The seed is the day, so that every day tries other cases; ``WINKLER_FUZZ_SEED`` sets it to repeat what was found.  A
case is a text, or bytes, and the name of what reads it; as a file in ``found`` it is tried in every run of the tests.
"""

from __future__ import annotations

import contextlib
import datetime
import json
import os
import resource
import signal
import traceback
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from typing import NamedTuple

from winkler.values.errors import WinklerError

FOUND = Path(__file__).parent / "found"
LIMIT = 20.0
"""Seconds of processor time after which a case hangs; nothing is timed otherwise."""
MEMORY = 2 * 2**30
"""Bytes that a case may allocate beyond what is in use already."""
SHOWN = 5
"""Faults that are shown of one test."""


class Hung(BaseException):
    """Raised inside a case that takes too long; no ``except Exception`` catches it."""


class Case(NamedTuple):
    """What is tried, and by which of the trials."""

    trial: str
    content: str
    encoding: str = "utf-8"

    @property
    def bytes(self) -> bytes:
        return self.content.encode(self.encoding)

    def text(self, why: str = "") -> str:
        return json.dumps({"why": why, **self._asdict()}, indent=1, ensure_ascii=True) + "\n"

    @classmethod
    def of_bytes(cls, trial: str, content: bytes) -> Case:
        return cls(trial, content.decode("latin-1"), "latin-1")


def seed() -> str:
    """Return what the cases of this run are drawn from."""
    return os.environ.get("WINKLER_FUZZ_SEED") or datetime.datetime.now(datetime.UTC).date().isoformat()


@contextlib.contextmanager
def limited() -> Iterator[None]:
    """Raise `Hung` after `LIMIT` of processor time, and every warning as an error."""

    def stop(*_: object) -> None:
        raise Hung(f"took more than {LIMIT:g} s of processor time")

    before = signal.signal(signal.SIGPROF, stop)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", ImportWarning)  # of a library that does without another one
            signal.setitimer(signal.ITIMER_PROF, LIMIT)
            yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)


@contextlib.contextmanager
def within_memory() -> Iterator[None]:
    """Let allocations fail that go far beyond what a case needs."""
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    pages = int(Path("/proc/self/statm").read_text().split()[0]) if Path("/proc/self/statm").exists() else 0
    if pages:
        resource.setrlimit(resource.RLIMIT_AS, (pages * resource.getpagesize() + MEMORY, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def sentence_is_good(error: WinklerError) -> bool:
    """Return whether an error is what a reader of it can use: sentences that end, without a trace."""
    message = str(error).rstrip()
    return message.endswith((".", ")")) and "Traceback" not in message


def fault(trial: Callable[[Case], object], case: Case) -> str:
    """Return what is wrong with the answer to a case; an empty text if nothing is."""
    try:
        with limited():
            trial(case)
    except WinklerError as error:
        return "" if sentence_is_good(error) else f"unclear: {error}"
    except Hung as error:
        return f"hangs: {error} {_place(error)}"
    except Exception as error:  # whatever a user would see as a traceback
        return f"{type(error).__name__}: {error} {_place(error)}"
    return ""


def _place(error: BaseException) -> str:
    """Return the lines of winkler where an error came from."""
    lines = traceback.extract_tb(error.__traceback__)
    return " < ".join(
        f"{Path(line.filename).name}:{line.lineno}" for line in reversed(lines) if "winkler" in line.filename
    )


def check(name: str, count: int, make: Callable[[Random], Case], trial: Callable[[Case], object], folder: Path) -> None:
    """Try so many cases; fail with those that are wrong, how to repeat them, and where they were written."""
    wrong: list[str] = []
    with within_memory():
        for place in range(count):
            case = make(Random(f"{seed()}/{name}/{place}"))
            if message := fault(trial, case):
                file = folder / f"{name.replace(' ', '_')}_{place}.json"
                file.write_text(case.text(message), encoding="utf-8")
                wrong.append(f"case {place}: {message}\n  {file}")
                if len(wrong) == SHOWN:
                    break
    assert not wrong, (
        f"{len(wrong)} of {count} cases of '{name}'; WINKLER_FUZZ_SEED='{seed()}' repeats them, and a file copied to "
        f"tests/hardening/found is tried in every run:\n" + "\n".join(wrong)
    )
