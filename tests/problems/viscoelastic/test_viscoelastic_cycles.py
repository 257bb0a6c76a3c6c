"""Cycles of forces: pressed, let go, pressed again, any number of times; energy, limits, and unloading by depths."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import winkler as wk
from winkler.loading.loads import Depth, Force
from winkler.loading.path import Path
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.errors import OutsideValidity

MAXWELL, STANDARD, VOIGT = Maxwell(0.25, 0.3), StandardSolid(0.05, 0.2, 0.3), KelvinVoigt(0.25, 0.075)
BOTH = Prony(0.01, [0.1, 0.2], [0.01, 5.0], 0.02)
SOLIDS = {"Maxwell": MAXWELL, "standard": STANDARD, "Voigt": VOIGT, "both": BOTH}


def pressed(solid, time, load, shape=None, **more):
    bed = wk.Foundation(wk.Paraboloid(1.0) if shape is None else shape, ViscoelasticHalfSpace(solid))
    return ViscoelasticIndentation(bed, Path(time, load), **more).solve()


spans = st.lists(st.floats(0.02, 2.0), min_size=8, max_size=8)
tops = st.lists(st.floats(0.002, 0.1), min_size=4, max_size=4)


@settings(max_examples=12, deadline=None)
@given(spans, tops, st.booleans(), st.sampled_from(list(SOLIDS)))
def test_no_energy_is_made_in_two_cycles(dts, levels, taken_off, name):
    """Up, held or changed, down to nothing or nearly so, and again."""
    low = 0.0 if taken_off else 1e-3
    forces = np.array([0.0, levels[0], levels[1], low, low, levels[2], levels[3], low, low])
    times = np.concatenate([[0.0], np.cumsum(dts)])
    found = pressed(SOLIDS[name], times, Force(forces), count=60, tolerance=1e-4)
    assert np.all(np.diff(found.dissipation) > -1e-9 * np.max(found.stored_energy))
    assert np.all(found.stored_energy >= 0.0)
    assert np.all(found.radius[forces > 0.0] > 0.0)


@pytest.mark.parametrize("name", ["Maxwell", "standard"])
def test_depths_give_the_forces_back(name):
    """Three cycles, sudden steps among them; the depths that were found, prescribed, bear the forces."""
    corners = np.array([0.0, 0.2, 0.4, 0.4, 0.7, 0.9, 0.9, 1.2, 1.3])
    forces = np.array([0.0, 0.05, 0.01, 0.03, 0.03, 0.005, 0.04, 0.0, 0.02])
    fine = np.unique(np.concatenate([np.linspace(0.0, 1.3, 651), corners]))
    t = np.sort(np.concatenate([fine, [0.4, 0.9]]))
    first, second = int(np.searchsorted(t, 0.4)), int(np.searchsorted(t, 0.9))
    f = np.interp(t, corners[[0, 1, 2, 4, 5, 7, 8]], forces[[0, 1, 2, 4, 5, 7, 8]])
    f[first + 1 : int(np.searchsorted(t, 0.7)) + 1] = 0.03
    late = (np.arange(t.size) > second) & (t <= 1.2)
    f[late] = np.interp(t[late], [0.9, 1.2], [0.04, 0.0])
    driven = pressed(SOLIDS[name], t, Force(f), count=150)
    back = pressed(SOLIDS[name], t, Depth(driven.depth), count=150)
    remaining = f > 2e-3
    assert back.force[remaining] == pytest.approx(f[remaining], rel=2e-3)
    assert driven.dissipation[-1] == pytest.approx(back.dissipation[-1], rel=2e-3)


def test_slow_cycles_are_elastic():
    """Twice up and down, with rests at no force: at every point the depth is that of the relaxed ball."""
    forces = np.array([0.0, 0.01, 0.0, 0.0, 0.02, 0.005, 0.0])
    solid = StandardSolid(0.25, 1.0, 1e-9)
    result = pressed(solid, np.arange(7.0), Force(forces), count=400)
    elastic = (0.75 * forces) ** (2.0 / 3.0)
    assert result.depth == pytest.approx(elastic, rel=1e-4, abs=1e-6)
    assert abs(result.dissipation[-1]) < 1e-6


def test_a_second_touch_finds_what_the_first_has_left():
    """Taken off and put on again at once, the body stands where it had crept to; much later all is forgotten."""
    times = np.array([0.0, 0.5, 0.5, 0.5, 1.0])
    result = pressed(STANDARD, times, Force(np.array([0.01, 0.01, 0.0, 0.01, 0.01])), count=200)
    straight = pressed(STANDARD, [0.0, 0.5, 1.0], Force(np.array([0.01, 0.01, 0.01])), count=200)
    assert result.depth[[1, 3]] == pytest.approx(straight.depth[[1, 1]], rel=1e-6)
    assert result.depth[4] == pytest.approx(straight.depth[2], rel=1e-5)
    rested = pressed(STANDARD, [0.0, 0.5, 0.5, 300.0, 300.0, 300.5], Force([0.01, 0.01, 0.0, 0.0, 0.01, 0.01]))
    assert rested.depth[[4, 5]] == pytest.approx(rested.depth[[0, 1]], rel=1e-5)


def test_a_fluid_keeps_its_dent():
    """A Maxwell body that was pressed does not come back; the body rests in its dent, and sinks on from there."""
    result = pressed(MAXWELL, [0.0, 1.0, 1.0, 50.0], Force(np.array([0.01, 0.01, 0.0, 0.0])), count=200, tolerance=1e-5)
    assert result.depth[3] > 0.5 * result.depth[1]
    assert result.depth[3] == pytest.approx(result.depth[2], rel=0.2)


def test_many_cycles_of_depth():
    """Fifty cycles with touch lost in each: the last two are alike, and each loses what work goes into it."""
    t = np.linspace(0.0, 50.0, 5001)
    result = pressed(STANDARD, t, Depth(0.1 * np.sin(2.0 * np.pi * t)), count=100)
    loops = result.force[1:].reshape(50, 100)
    assert loops[-1] == pytest.approx(loops[-2], abs=1e-9 * loops.max())
    work = np.sum(0.5 * (result.force[1:] + result.force[:-1]) * np.diff(result.depth))
    assert result.dissipation[-1] + result.stored_energy[-1] == pytest.approx(work, rel=2e-3)
    assert np.count_nonzero(result.radius[1:].reshape(50, 100)[-1] == 0.0) > 50


def test_no_force_is_no_touch():
    with pytest.raises(OutsideValidity, match="never touch"):
        pressed(STANDARD, [0.0, 1.0], Force(np.zeros(2)))
