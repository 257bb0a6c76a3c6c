"""Segments that a file states are believed only where they agree with the signal."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.fit import fit
from winkler.io.curves import read_curve

R, SPRING = 2.5e-6, 0.3
YOUNG, RETRACT_YOUNG, POISSON = 50e3, 38e3, 0.5


def _forces(position, young):
    """Force of a ball on a cantilever, from F = 4/3 E* sqrt(R) d^(3/2) and position = d + F/k."""
    depth = np.linspace(0.0, 1e-6, 20001)
    force = 4.0 / 3.0 * young / (1.0 - POISSON**2) * np.sqrt(R) * depth**1.5
    return np.interp(position, depth + force / SPRING, force)


@pytest.fixture
def stated(tmp_path):
    """A file with approach by 50 kPa and retract by 38 kPa, and any column `segment`."""

    def written(segment):
        inward = np.linspace(-0.5e-6, 0.5e-6, 400)
        force = np.r_[_forces(inward, YOUNG), _forces(inward, RETRACT_YOUNG)[::-1]]
        force += 3e-11 * np.random.default_rng(4).standard_normal(force.size)
        rows = np.c_[np.r_[inward, inward[::-1]] * 1e9 + 500.0, force * 1e9, segment]
        path = tmp_path / "curve.csv"
        head = "k (N/m) 0.3\npiezo [nm],force [nN],segment\n"
        path.write_text(head + "\n".join(",".join(f"{x:.6g}" for x in row) for row in rows) + "\n")
        return read_curve(path)

    return written


@pytest.mark.parametrize(
    ("segment", "said"),
    [
        (np.zeros(800), "says nothing"),
        (np.full(800, 3), "says nothing"),
        (np.r_[np.zeros(790), np.ones(10)], "turns within 0"),
        (np.r_[np.zeros(400), np.ones(400)], "segments from 'segment'"),
    ],
)
def test_one_segment_says_nothing(stated, segment, said):
    """Approach and retract of 50 and 38 kPa became one loading: 43.8 +- 3.4 kPa; 50.0 is right."""
    curve = stated(segment)
    np.testing.assert_array_equal(curve.direction, np.r_[np.ones(400), -np.ones(400)])
    assert said in curve.reading
    assert ("turns within" in curve.reading) == (said == "turns within 0")
    if said == "says nothing" and segment[0] == 0:
        bed = wk.Foundation(wk.Paraboloid(R), wk.HalfSpace.between(wk.Elastic(1e4, POISSON)))
        free = ["bed.medium.first.young", "contact_point", "baseline"]
        found = fit(curve.approach, wk.Indentation(bed, wk.Depth(0.0)), free=free)
        assert found.value(free[0]) == pytest.approx(YOUNG, rel=2e-3)
        assert found.value(free[0]) == pytest.approx(YOUNG, abs=4.0 * found.error(free[0]))


def test_a_short_segment_about_the_turn_is_believed(stated):
    """A segment that travels 5 % of the way to the turn and back agrees with a pause."""
    curve = stated(np.r_[np.zeros(380), np.ones(40), np.full(380, 2)])
    assert "turns within" not in curve.reading
