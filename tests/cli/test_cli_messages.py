"""What a solver says of a long point is shown beside the terminal's spinner, and sentences stay."""

from __future__ import annotations

import io
import logging

from rich.console import Console

from winkler.cli import terminal
from winkler.cli.terminal import heard, one_line

LOG = logging.getLogger("winkler.numerics.surfaces.pressed_box")


def test_sentences_stay_and_steps_pass():
    text = io.StringIO()
    out = Console(file=text, force_terminal=True, width=120, highlight=False)
    with one_line(out) as show, heard(show):
        LOG.info("%d x %d pixels take 2 GiB.", 9, 9)
        LOG.info("step %d", 1)
        LOG.info("step %d", 2)
        LOG.debug("nobody asked")
    LOG.info("too late")
    shown = text.getvalue()
    assert "9 x 9 pixels take 2 GiB.\n" in shown.replace("\r\n", "\n")
    assert "step 2" in shown
    assert "nobody asked" not in shown
    assert "too late" not in shown


def test_the_logger_is_left_as_it_was():
    logger = logging.getLogger("winkler")
    level, handlers = logger.level, list(logger.handlers)
    with heard(lambda text: None):
        assert logger.isEnabledFor(logging.INFO)
    assert (logger.level, logger.handlers) == (level, handlers)


class Stream(io.StringIO):
    def isatty(self):
        return True


def single(states):
    for state in states:
        LOG.info("a step of state %d.", state)
        yield state


def test_only_a_terminal_hears_and_only_of_a_single_state(monkeypatch):
    def shown(stream, *, hidden=False, total=1):
        monkeypatch.setattr(terminal.sys, "stderr", stream)
        assert list(terminal.marching(hidden=hidden)(single(range(total)), total)) == list(range(total))
        return stream.getvalue()

    assert "a step of state 0." in shown(Stream())
    assert shown(io.StringIO()) == ""
    assert shown(Stream(), hidden=True) == ""
    assert "a step of state" not in shown(Stream(), total=2)
