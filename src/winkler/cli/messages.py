"""What a solver says while it works on one point for long: memory that it takes, steps that it has made."""

from __future__ import annotations

import contextlib
import logging
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console
    from rich.status import Status

__all__ = ["heard", "one_line"]

SOLVERS = "winkler"
"""Name of the logger."""


class _Listener(logging.Handler):
    """Hands messages on."""

    def __init__(self, show: Callable[[str], None]) -> None:
        super().__init__(logging.INFO)
        self.show = show

    def emit(self, record: logging.LogRecord) -> None:
        self.show(record.getMessage())


@contextlib.contextmanager
def heard(show: Callable[[str], None]) -> Iterator[None]:
    """Show what solvers of this process say."""
    logger, listener = logging.getLogger(SOLVERS), _Listener(show)
    level = logger.level
    logger.addHandler(listener)
    logger.setLevel(logging.INFO)
    try:
        yield
    finally:
        logger.removeHandler(listener)
        logger.setLevel(level)


@contextlib.contextmanager
def one_line(out: Console) -> Iterator[Callable[[str], None]]:
    """Give a function that shows the last message in one line, which vanishes at the end; sentences stay."""
    status: Status | None = None

    def show(text: str) -> None:
        nonlocal status
        if text.endswith("."):
            out.print(text, soft_wrap=True)
        elif status is None:
            status = out.status(text)
            status.start()
        else:
            status.update(text)

    try:
        yield show
    finally:
        if status is not None:
            status.stop()
