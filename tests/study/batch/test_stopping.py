"""Ctrl-C and SIGTERM: what libraries make of them, they are not lost, and some statements are not torn apart."""

from __future__ import annotations

import contextlib
import gc
import os
import signal
import subprocess
import sys
import time
import weakref

import pytest

from winkler.cli import main
from winkler.io.processes import stopping
from winkler.study.language import reading
from winkler.study.report import writing
from winkler.values.errors import InvalidInput

BALL = """title = "A ball"

[problem]
kind = "indentation"
load = { kind = "force", force = "100 N" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "210 GPa", poisson = 0.3 } }

[output]
figures = []
report = false
"""
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143}
MESSAGES = {signal.SIGINT: "winkler: interrupted; nothing was written.\n", signal.SIGTERM: ""}

pytestmark = pytest.mark.skipif(os.name == "nt", reason="a process cannot send itself these signals there")


def send(sign):
    """Send a signal, and wait until Python has acted on it."""
    os.kill(os.getpid(), sign)
    time.sleep(60.0)
    pytest.fail("the signal was not raised")


class Thing:
    """What a weak reference can point at."""


def lost(sign):
    """The signal falls into a callback whose errors nobody gets; then there is a long computation."""
    thing = Thing()
    reference = weakref.ref(thing, lambda _: send(sign))
    del thing
    assert reference() is None
    time.sleep(60.0)
    pytest.fail("the signal was not raised again")


def another(sign):
    """As the compiled parts of pydantic do, while they build what checks a model."""
    try:
        send(sign)
    except BaseException:
        raise RuntimeError("SchemaError: KeyboardInterrupt:") from None


def misread(sign):
    """A library of readers takes it for a broken file, and so does the reader."""
    try:
        send(sign)
    except BaseException:
        raise InvalidInput("the file is broken.") from None


def swallowed(sign):
    with contextlib.suppress(BaseException):
        send(sign)


@pytest.fixture(scope="module")
def _frozen_heap():
    """Whoever hears a signal looks for garbage: not again each time among all that the tests before have left."""
    gc.collect()
    gc.freeze()


@pytest.fixture
def here(tmp_path, monkeypatch, _frozen_heap):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ball.toml").write_text(BALL, encoding="utf-8")
    before = [(sign, signal.getsignal(sign)) for sign in CODES]
    for sign, handler in ((signal.SIGINT, signal.default_int_handler), (signal.SIGTERM, signal.SIG_DFL)):
        signal.signal(sign, handler)
    yield tmp_path
    for sign, handler in before:
        signal.signal(sign, handler)


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="there is no SIGINT of a process alone there")
@pytest.mark.parametrize("workers", ["0", "1"])
def test_tests_hear_ctrl_c_where_the_shell_starts_them_deaf_to_it(workers, root):
    """As `pytest &` in a script does: two tests failed there."""
    deaf = "import os, signal, sys; signal.signal(2, signal.SIG_IGN); os.execv(sys.executable, sys.argv[1:])"
    tests = "tests/study/nanoindentation/test_first_yield_and_stiffness.py::test_ctrl_c_keeps_the_curves_that_are_done"
    words = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "-n", workers, tests]
    ended = subprocess.run([sys.executable, "-c", deaf, *words], cwd=root, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stdout


@pytest.mark.parametrize("sign", CODES)
@pytest.mark.parametrize("how", [lost, another, misread, swallowed])
@pytest.mark.parametrize("when", ["read_study", "study_text"])
def test_no_signal_is_lost(when, how, sign, here, monkeypatch, capsys):
    """Before the study is solved, and while its results are written."""
    module = {"read_study": reading, "study_text": writing}[when]
    real, hook = getattr(module, when), sys.unraisablehook

    def met(*given, **more):
        how(sign)
        return real(*given, **more)

    monkeypatch.setattr(module, when, met)
    assert main(["run", "ball.toml", "--quiet"]) == CODES[sign]
    assert capsys.readouterr().err == MESSAGES[sign]
    assert [path.name for path in here.iterdir()] == ["ball.toml"]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
    assert sys.unraisablehook is hook
    stopping.raise_pending()  # what was received is not left to the next run


def test_a_point_that_failed_of_an_interrupt_is_not_stored_as_a_failed_one(here, monkeypatch, capsys):
    import winkler as wk

    text = BALL + '\n[sweep]\n"problem.load.force" = ["1 N", "2 N", "3 N"]\n'
    (here / "balls.toml").write_text(text, encoding="utf-8")
    solve, calls = wk.Indentation.solve, []

    def met(self):
        calls.append(self)
        if len(calls) == 2:
            misread(signal.SIGINT)
        return solve(self)

    with monkeypatch.context() as patch:
        patch.setattr(wk.Indentation, "solve", met)
        assert main(["run", "balls.toml", "--quiet"]) == 130
    assert "interrupted; 1 of 3 points are kept" in capsys.readouterr().err
    assert main(["run", "balls.toml"]) == 0
    assert "1 of 3 points were known" in capsys.readouterr().out


@pytest.mark.parametrize("sign", CODES)
def test_the_two_renamings_are_not_torn_apart(sign, here, monkeypatch, capsys):
    """The signal comes between them: the results are placed, and stated to be complete."""
    assert main(["run", "ball.toml", "--quiet"]) == 0
    old = (here / "results/ball/provenance.json").stat().st_ino
    real = os.rename

    def rename(one, other):
        os.kill(os.getpid(), sign)
        real(one, other)

    monkeypatch.setattr(writing.os, "rename", rename)
    assert main(["run", "ball.toml", "--quiet", "--overwrite"]) == CODES[sign]
    message = f"winkler: interrupted; the results in {os.path.join('results', 'ball')} are complete.\n"
    assert capsys.readouterr().err == (message if sign == signal.SIGINT else "")
    assert (here / "results/ball/provenance.json").stat().st_ino != old
    assert [path.name for path in (here / "results").iterdir()] == ["ball"]


def test_what_was_half_made_is_taken_down_without_a_word(here, monkeypatch, capsys):
    class HalfMade:
        def __init__(self):
            self.itself = self
            send(signal.SIGTERM)
            self.closed = False

        def __del__(self):
            assert not self.closed  # there is no such attribute yet

    monkeypatch.setattr(writing, "study_text", lambda study: str(HalfMade()))
    assert main(["run", "ball.toml", "--quiet"]) == 143
    assert capsys.readouterr().err == ""


def test_whoever_listens_already_goes_on_listening(here):
    """A program that runs a command in itself keeps its own handlers."""
    received = []
    signal.signal(signal.SIGINT, lambda *_: received.append(1))
    signal.signal(signal.SIGTERM, lambda *_: received.append(2))
    with stopping.receiving_signals() as end:
        os.kill(os.getpid(), signal.SIGINT)
        os.kill(os.getpid(), signal.SIGTERM)
        stopping.raise_pending()
    assert received == [1, 2]
    assert end.code == 0


def test_a_held_signal_is_raised_after_the_statements(here):
    done = []

    def three():
        with stopping.deferred_signals():
            with stopping.deferred_signals():
                os.kill(os.getpid(), signal.SIGINT)
                done.append("inner")
            done.append("outer")
        done.append("after")

    with pytest.raises(KeyboardInterrupt), stopping.receiving_signals():
        three()
    assert done == ["inner", "outer"]
