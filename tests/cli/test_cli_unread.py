"""Stdout whose reader has gone, that is closed, or that cannot be written: the results and the exit code stay."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from winkler.cli import main

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
MISSED = '\n[[expect]]\nquantity = "force"\nvalue = "1 N"\ntolerance = 0.1\n'


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("ball.toml").write_text(BALL, encoding="utf-8")
    Path("missed.toml").write_text(BALL + MISSED, encoding="utf-8")
    return tmp_path


@pytest.fixture
def unread():
    """A pipe that nobody reads, as behind ``| head`` that has read enough."""
    reader, writer = os.pipe()
    os.close(reader)
    with os.fdopen(writer, "w", encoding="utf-8") as stream:
        yield stream


@pytest.mark.parametrize(
    ("words", "code"),
    [
        (["run", "ball.toml"], 0),
        (["run", "missed.toml", "--json", "--output", "results/missed"], 1),
        (["run", "missed.toml"], 1),
        (["show"], 0),
        (["show", "copper"], 0),
        (["cite", "ball.toml"], 0),
    ],
)
def test_the_exit_code_is_that_of_the_command_if_the_reader_has_gone(words, code, here, unread, capfd, monkeypatch):
    monkeypatch.setattr(sys, "stdout", unread)  # here, since pytest sets its own after the fixtures
    assert main(words) == code
    assert capfd.readouterr().err == ""
    unread.flush()  # as Python does at its end; it would say that this failed
    if words[0] == "run":
        assert (here / "results" / Path(words[1]).stem / "provenance.json").is_file()


def test_an_error_is_printed_whoever_reads_what_came_before(here, unread, capfd, monkeypatch):
    monkeypatch.setattr(sys, "stdout", unread)
    unread.write("what was written before")
    assert main(["run", "ball.tml"]) == 2
    assert capfd.readouterr().err.startswith("winkler: ball.tml: there is no such file")
    unread.flush()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no full device")
@pytest.mark.parametrize(
    "words", [["run", "ball.toml"], ["run", "ball.toml", "--json", "--output", "results/ball"], ["show"]]
)
def test_a_full_disk_behind_stdout_is_stated_in_a_sentence(words, here, monkeypatch, capfd):
    with open("/dev/full", "w", encoding="utf-8") as stream:
        monkeypatch.setattr(sys, "stdout", stream)
        assert main(words) == 2
        output = capfd.readouterr().err
    assert output.startswith("winkler: stdout cannot be written (no space left on device); send it elsewhere.")
    assert output.count("\n") == 1
    assert (here / "results/ball/provenance.json").is_file() == (words[0] == "run")


def test_closed_streams_are_not_written(here, monkeypatch):
    monkeypatch.setattr(sys, "stdout", None)
    monkeypatch.setattr(sys, "stderr", None)
    assert main(["run", "ball.toml"]) == 0
    assert main(["run", "ball.toml"]) == 2  # there are results already
