"""Maps that mislead: each gets one sentence, before or beside the numbers of its contact."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.values.validity import Standing

STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
PLACE = (np.arange(48) + 0.5) / 48 * 1e-3 - 0.5e-3
BALL = -(PLACE[:, None] ** 2 + PLACE**2) / (2 * 50e-3)
ROUGH = wk.random_topography(wk.SelfAffine(0.8, 0.5e-6, 1e-3, 8e-5), (64, 64), [1e-3, 1e-3], seed=2)


def standings(solution, words):
    return [note.standing for note in solution.validity if words in note.statement]


def pressed(topography, load):
    return wk.SurfaceContact(topography, STEEL, load).solve()


def test_missing_heights_and_single_pixels():
    heights = BALL.copy()
    heights[3, 4] = np.nan
    with pytest.raises(
        wk.InvalidInput, match=r"^SurfaceContact: 1 of 2304 heights are missing; fill them with topography"
    ):
        pressed(wk.Topography(heights, [1e-3, 1e-3]), wk.Force(1.0))
    with pytest.raises(wk.InvalidInput, match=r"heights have the shape \(1, 1\); give a map of at least 2 x 2 pixels"):
        wk.Topography([[1e-6]], [1e-3, 1e-3])
    with pytest.raises(wk.InvalidInput, match="all missing; give finite ones, nan for missing"):
        wk.Topography(np.full((4, 4), np.nan), [1e-3, 1e-3])


def test_heights_in_a_wrong_unit():
    """Nanometres taken for micrometres: slopes of ten."""
    steep = wk.Topography(1e3 * ROUGH.heights, ROUGH.lengths, periodic=True)
    assert standings(pressed(steep, wk.Force(1e4)), "are heights and lengths both in m?") == [Standing.OUTSIDE]
    assert standings(pressed(ROUGH, wk.Force(3.0)), "are heights and lengths both in m?") == []


def test_a_map_that_is_not_periodic():
    part = wk.Topography(ROUGH.heights[:40, :], [0.625e-3, 1e-3], periodic=True)
    assert standings(pressed(part, wk.Force(3.0)), "heights at its border jump") == [Standing.OUTSIDE]
    assert standings(pressed(ROUGH, wk.Force(3.0)), "heights at its border jump") == []
    tilted = wk.Topography(BALL + 1e-2 * PLACE[:, None], [1e-3, 1e-3], periodic=True)
    sticky = wk.SurfaceAdhesion(
        tilted, wk.HalfSpace(wk.Elastic(1e6, 0.5)), wk.ExponentialAttraction(0.05, 5e-6), wk.Depth([-1e-5])
    ).solve()
    assert standings(sticky, "heights at its border jump") == [Standing.OUTSIDE]


def test_a_map_too_small_for_its_load():
    """A ball whose contact would be wider than its map."""
    ball = wk.Topography(BALL, [1e-3, 1e-3])
    words = "it is too small for this load: use a larger map"
    assert standings(pressed(ball, wk.Depth(1e-6)), words) == []
    assert standings(pressed(ball, wk.Depth(10e-6)), words) == [Standing.APPROXIMATE]


def test_what_was_removed_is_said_to_the_end(tmp_path):
    """From the key of a study to the notes of its answer."""
    from winkler.study.batch.run import run
    from winkler.study.language.reading import parse_study

    heights = ROUGH.heights.copy()
    heights[30, 12] += 20e-6
    np.save(tmp_path / "map.npy", 1e6 * heights)
    text = f"""
[problem]
kind = "surface_contact"
load = {{ kind = "force", force = "3 N" }}
medium = {{ kind = "half_space", first = {{ kind = "elastic", young = "210 GPa", poisson = 0.3 }} }}
[problem.topography]
kind = "height_map"
file = "{(tmp_path / "map.npy").as_posix()}"
unit = "um"
lengths = "1 mm"
tip_radius = "20 mm"
without_spikes = true
filled = true
"""
    (point,) = run(parse_study(text)).solved
    said = [note.statement for note in point.solution.validity]
    assert any(
        line.startswith("Removed from the measured heights, and bridged: 1 of 4096 pixels stand out") for line in said
    )
    assert any("a tip of 0.02 m has rounded the map" in line for line in said)
