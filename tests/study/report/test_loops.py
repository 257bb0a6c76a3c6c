"""The loops of a path against the closed form of Cattaneo and Mindlin, and sweeps with several patches of contact."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest
import tomli_w
from scipy.integrate import quad

from winkler.study.batch.run import run
from winkler.study.language.explain import example_study
from winkler.study.language.reading import parse_study
from winkler.study.report.figures import answers_over
from winkler.study.report.headline.loops import loop_rows
from winkler.study.report.tables import loops_section
from winkler.values.units import quantity

STUDIES = Path(__file__).resolve().parents[3] / "examples" / "studies"
CYCLES, FORCE, SHEAR, FRICTION = 3, 100.0, 20.0, 0.3


def rubbed():
    """Return the outcome of a ball under 100 N that is pushed to and fro by 20 N, from +20 N to +20 N three times."""
    table = example_study("tangential")
    table["problem"]["bed"]["profile"] = {"kind": "paraboloid", "curvature_radius": "10 mm"}
    start = {"kind": "start", "normal": {"kind": "force", "force": f"{FORCE} N"}}
    swing = {"kind": "oscillate", "lateral": {"kind": "shear_force", "shear_force": f"{SHEAR} N"}}
    table["problem"]["path"] = {"kind": "program", "steps": [start, swing | {"cycles": CYCLES + 0.25}]}
    return run(parse_study(tomli_w.dumps({"title": "x", **table})))


def test_each_loop_loses_what_mindlin_gives():
    r"""U(T) = \mu (E*/G*) d (1 - (1 - T/\mu N)^(2/3)), and loops are twice that curve (Masing)."""
    outcome = rubbed()
    modulus, shear = 210e9 / 0.91, 4.0 * 210e9 / 2.6 / 1.7
    depth = (0.75 * FORCE / (modulus * np.sqrt(10e-3))) ** (2.0 / 3.0)

    def moved(pushed):
        return FRICTION * modulus / shear * depth * (1.0 - (1.0 - pushed / (FRICTION * FORCE)) ** (2.0 / 3.0))

    below = SHEAR * moved(SHEAR) - quad(moved, 0.0, SHEAR)[0]
    loss = 8.0 * (below - 0.5 * SHEAR * moved(SHEAR))
    rows = loop_rows(outcome)
    assert len(rows) == CYCLES
    for row in rows:
        assert quantity(row.loss.replace("µ", "u"), "J", what="loss") == pytest.approx(loss, rel=1e-3)
        stiffness = quantity(row.stiffness, "N/m", what="stiffness")
        assert stiffness == pytest.approx(SHEAR / moved(SHEAR), rel=1e-3)
        assert float(row.factor) == pytest.approx(loss / (np.pi * SHEAR * moved(SHEAR)), rel=1e-3)
    assert "Loops of the path" in loops_section(outcome)


def test_loops_follow_each_other_and_the_last_is_the_last_cycle():
    (point,) = rubbed().solved
    cycles = point.solution.cycles()
    assert cycles[-1] == point.solution.last_cycle
    assert [one.last for one in cycles[:-1]] == [one.first for one in cycles[1:]]
    assert len(point.solution.cycles(2)) == 2


def test_a_path_without_loops_has_no_table():
    outcome = run(parse_study(tomli_w.dumps({"title": "x", **example_study("indentation")})))
    assert loop_rows(outcome) == ()
    assert loops_section(outcome) == ""


@pytest.mark.slow
def test_patches_are_drawn_over_what_was_swept_for_each_other_setting():
    """A wheel near its flange touches in two places: a curve for each place over the coefficient of friction."""
    file = STUDIES / "rolling" / "wheel_rail.toml"
    table = tomllib.loads(file.read_text(encoding="utf-8"))
    table["problem"]["pair"]["pixels"] = 24
    table["sweep"] = {"problem.friction.coefficient": [0.2, 0.3], "problem.pair.lateral": ["3 mm"]}
    outcome = run(parse_study(tomli_w.dumps(table), folder=file.parent))
    assert len(outcome.solved) == len(outcome.points)
    assert {point.answers["place"].size for point in outcome.solved} == {2}
    figures = {one.name: one for one in answers_over(outcome, pictured=False)}
    assert figures["answer_longitudinal_force"].title == "Longitudinal force over coefficient"
    assert "patch of contact and other setting" in figures["answer_longitudinal_force"].sentence
    assert "answer_grid_error" not in figures
