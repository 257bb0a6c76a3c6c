"""How far the simplified theories of rolling are from boundary elements: the tables, and points between entries."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import numpy as np
import pytest

import winkler as wk
from winkler.problems.rolling.distances import OF_BALLS, OF_ELLIPSES, POISSON, RATIOS, ball_distances, ellipse_distances

SCRIPT = Path(__file__).parents[3] / "benchmarks" / "rolling_distances.py"


@pytest.fixture(scope="module")
def script():
    spec = importlib.util.spec_from_file_location("rolling_distances", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.long
@pytest.mark.parametrize("row", range(len(RATIOS)))
def test_the_table_of_ellipses_is_that_of_the_script(script, row):
    for column, poisson in enumerate(POISSON):
        if row > 2 and column != 1:  # long contacts take long
            continue
        found = np.array(script.ellipse_row(RATIOS[row], poisson))
        assert np.all(found <= OF_ELLIPSES[row, column])
        assert np.all(found > OF_ELLIPSES[row, column] - 0.0151)  # rounded up


@pytest.mark.slow
def test_the_table_of_balls_is_that_of_the_script(script):
    for poisson, stated in zip(POISSON, OF_BALLS, strict=True):
        found = np.array(script.ball_row(poisson))
        assert np.all(found <= stated)
        assert np.all(found > stated - 0.0151)


OTHER_AMOUNTS, OTHER_SPINS = (0.45, 0.95, 1.5, 2.7), (0.5, 1.1, 2.2)
ONE = tuple((amount, angle, 0.0) for amount in OTHER_AMOUNTS for angle in (0.0, 90.0))
BOTH = tuple((amount, angle, 0.0) for amount in OTHER_AMOUNTS for angle in (12.0, 33.0, 57.0, 80.0))
SPUN = tuple(
    (amount, angle, spin) for spin in OTHER_SPINS for amount in (0.0, 0.4, 1.3) for angle in (20.0, 70.0, -20.0, -70.0)
)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("ratio", [0.3, 0.7, 1.0, 1.4, 3.3])
@pytest.mark.parametrize("poisson", [0.12, 0.3, 0.4])
def test_other_creepages_ellipses_and_bodies_are_within_what_is_stated(script, ratio, poisson):
    stated = ellipse_distances(ratio, poisson)
    assert np.all(np.array(script.ellipse_row(ratio, poisson, ONE, BOTH, SPUN)) <= np.array(stated))


@pytest.mark.parametrize(
    ("ratio", "poisson", "row"),
    [
        (1.0, 0.5, (2.74, -77.0, 1.45)),
        (0.5, 0.5, (2.88, 83.0, -1.37)),
        (0.5, 0.25, (2.27, 84.0, -1.0)),
        (2.0, 0.0, (0.14, -66.0, 0.44)),
        (2.0, 0.5, (0.47, 77.0, -1.24)),
    ],
)
def test_the_farthest_of_random_creepages_are_within_what_is_stated(script, ratio, poisson, row):
    """Of 150 with up to three times the creepage and spin of sliding, on ellipses and bodies of the table itself."""
    force, moment = script.apart(*script.rolled(ratio, poisson, (row,)))
    stated = ellipse_distances(ratio, poisson)
    assert force <= stated.spun
    assert moment <= stated.spun_moment


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("poisson", [0.12, 0.3, 0.4])
def test_balls_on_a_line_are_within_what_is_stated(script, poisson):
    assert np.all(np.array(script.ball_row(poisson, ONE, BOTH)) <= np.array(ball_distances(poisson)))


@pytest.mark.long
def test_finer_pixels_change_the_distances_by_less_than_they_are_rounded(script):
    for rows in (script.ONE, script.SPUN):
        coarse, fine = (script.apart(*script.rolled(0.5, 0.25, rows, count)) for count in (script.COUNT, 128))
        assert fine == pytest.approx(coarse, abs=script.BETWEEN)


def test_entries_beside_are_the_greatest_neighbours():
    assert tuple(ellipse_distances(1.0, 0.25)) == tuple(OF_ELLIPSES[2, 1])
    assert tuple(ellipse_distances(1.3, 0.3)) == tuple(np.max(OF_ELLIPSES[2:4, 1:3], axis=(0, 1)))
    assert tuple(ellipse_distances(5.0, 0.5)) == tuple(OF_ELLIPSES[4, 2])
    assert tuple(ellipse_distances(0.2, 0.0)) == tuple(OF_ELLIPSES[0, 0])
    assert ellipse_distances(5.1, 0.3) is None
    assert ball_distances(0.4) == tuple(OF_BALLS[2])


def simplified(a, b, poisson, creepage):
    body = wk.Elastic(1.0, poisson)
    medium = wk.HalfSpace.between(body, body)
    problem = wk.SimplifiedRolling(wk.ContactEllipse(a, b), medium, wk.Coulomb(0.3), creepage, wk.Force(1e-6))
    return [note.statement for note in problem.solve().validity]


@pytest.mark.parametrize(
    ("creepage", "sentence"),
    [
        (wk.Creepage(1e-3), "Under longitudinal or lateral creepage alone the force differs by at most 0.05 mu F_N"),
        (
            wk.Creepage(1e-3, 1e-3),
            "Under both creepages the force differs by at most 0.14 mu F_N, the moment by at most 0.06",
        ),
        (
            wk.Creepage(1e-3, 1e-3, 0.1),
            "With spin the force differs by at most 0.19 mu F_N, the moment by at most 0.09",
        ),
    ],
)
def test_notes_state_the_distance_under_their_own_creepage(creepage, sentence):
    assert any(sentence in note for note in simplified(0.01, 0.01, 0.3, creepage))


def test_notes_say_where_nothing_was_compared():
    assert any("were not compared" in note for note in simplified(0.08, 0.01, 0.3, wk.Creepage(1e-3)))


def test_the_manual_has_the_same_table():
    page = (SCRIPT.parents[1] / "docs" / "chapters" / "rolling.md").read_text(encoding="utf-8")
    lines = page.split("| | $a/b=0.2$ |")[1].split("\n\n")[0].splitlines()[2:]
    rows = np.array([[float(part) for part in line.strip("|").split("|")[1:]] for line in lines])
    assert rows.reshape(3, 3, 5) == pytest.approx(np.moveaxis(OF_ELLIPSES[:, :, :3], (0, 1, 2), (2, 1, 0)))
