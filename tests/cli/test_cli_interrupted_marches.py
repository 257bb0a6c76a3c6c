"""Ctrl-C in a march leaves the points that were reached, whatever it marches through; on a terminal there is a bar."""

from __future__ import annotations

import csv
import io
import sys

import pytest
import tomli_w

from winkler.cli import main, terminal
from winkler.study.language.catalogue import kinds
from winkler.study.language.explain import example_study

SEVEN = {
    "adhesive_cycle": 7,
    "impact": 7,
    "adhesive_impact": 7,
    "elastic_plastic_particle": 2,
    "rolling_start": 7,
    "oscillating_rolling": 7,
    "line_rolling_start": 7,
    "reduction": 12,
    "surface_adhesion": 7,
    "surface_tangential": 7,
    "surface_rolling": 3,
    "surface_rolling_start": 7,
}
"""Kind -> after how many states it is interrupted."""


def interrupted(monkeypatch, cls, count):
    """Let the first march of a class be interrupted."""
    steps, calls = cls.steps, []

    def broken(self):
        calls.append(self)
        for place, state in enumerate(steps(self)):
            if place == count and len(calls) == 1:
                raise KeyboardInterrupt
            yield state

    monkeypatch.setattr(cls, "steps", broken)


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize("name", SEVEN)
def test_ctrl_c_keeps_the_points_that_were_reached(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    interrupted(monkeypatch, kinds()[name].cls, SEVEN[name])
    study = example_study(name) | {"output": {"figures": [], "report": False}}
    (tmp_path / "study.toml").write_text(tomli_w.dumps(study), encoding="utf-8")
    assert main(["run", "study.toml", "--output", "out"]) == 130
    with (tmp_path / "out" / "results.csv").open(encoding="utf-8") as file:
        assert len(list(csv.DictReader(file))) == SEVEN[name]
    output = capsys.readouterr()
    assert f"After {SEVEN[name]} " in output.out
    assert "the calculation ended: it was interrupted." in output.out
    assert "the points that were reached are kept in out" in output.err


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ["adhesive_cycle", "adhesive_impact", "elastic_plastic_particle"])
def test_the_report_draws_what_was_reached_and_says_so(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    interrupted(monkeypatch, kinds()[name].cls, SEVEN[name])
    (tmp_path / "study.toml").write_text(tomli_w.dumps(example_study(name)), encoding="utf-8")
    assert main(["run", "study.toml", "--output", "out", "--quiet"]) == 130
    report = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "Where the calculation ended early" in report
    assert f"After {SEVEN[name]} of " in report
    assert any((tmp_path / "out" / "figures").iterdir())


class Screen(io.StringIO):
    """A terminal."""

    def isatty(self):
        return True


@pytest.mark.parametrize(("total", "shown"), [(5, "5/5"), (None, "5/?")])
def test_a_bar_counts_states_also_where_nobody_knows_how_many(total, shown, monkeypatch):
    screen = Screen()
    monkeypatch.setattr(sys, "stderr", screen)
    monkeypatch.setenv("TERM", "xterm")
    assert list(terminal.marching(hidden=False)(iter(range(5)), total)) == [0, 1, 2, 3, 4]
    assert "marching" in screen.getvalue()
    assert shown in screen.getvalue()
