"""An independent reference solution: the restored pressures, as loads on a three-dimensional half-space that creeps.

At every moment of a history the pressure of the springs is put on the surface; Boussinesq's integral over the contact
gives how an elastic half-space would sink, the hereditary integral over the past how the creeping one does.  Under the
body that must be d - f(r), whatever has happened before; outside it is what `restore` says.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import ellipkm1

import winkler as wk
from winkler.fields.restoration import restore
from winkler.loading.loads import Depth, Force
from winkler.loading.path import Path
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation

MAXWELL, STANDARD = Maxwell(0.25, 0.3), StandardSolid(0.05, 0.2, 0.3)
TWO = Prony(0.05, [0.1, 0.1], [0.05, 1.0])
NODES, WEIGHTS = (0.5 * part for part in np.polynomial.legendre.leggauss(20))
NODES = NODES + 0.5


def sunk(state, r):
    """Return how far a pressure sinks the surface of a half-space with E* = 1 at a place, by rings of K."""
    if state.radius == 0.0:
        return 0.0
    total, a = 0.0, state.radius
    near = min(r, a)
    # cubes crowd the nodes where the integrand is not smooth: at the place itself and at the edge
    for sharp, other in ((near, 0.0), (near, 0.5 * (near + a)), (a, 0.5 * (near + a))):
        if sharp != other:
            s, ds = sharp + (other - sharp) * NODES**3, 3.0 * abs(other - sharp) * NODES**2
            rings = ellipkm1(np.maximum(((r - s) / (r + s)) ** 2, 1e-40))
            total += float(WEIGHTS @ (state.pressure(s) * s / (r + s) * rings * ds))
    return 4.0 / math.pi * total


def crept(creep, times, loads):
    """Return the hereditary integral of loads known at times, straight in between, at the last of them."""
    end, out = times[-1], creep.glassy * loads[-1]
    for i in range(times.size - 1):
        dt = times[i + 1] - times[i]
        if dt == 0.0:
            continue
        climb = (loads[i + 1] - loads[i]) / dt
        out += creep.fluidity * 0.5 * (loads[i] + loads[i + 1]) * dt
        for strength, tau in zip(creep.compliances, creep.times, strict=True):
            first, last = math.exp(-(end - times[i]) / tau), math.exp(-(end - times[i + 1]) / tau)
            out += strength * (last * loads[i + 1] - first * loads[i] - climb * tau * (last - first))
    return out


def solve(solid, shape, corners, loads, steps, places, count=400):
    """Return the last state of a history, and how far the creeping half-space has sunk at some places by then."""
    medium = ViscoelasticHalfSpace(solid)
    times = np.unique(np.concatenate([np.linspace(0.0, corners[-1], steps + 1), corners]))
    problem = ViscoelasticIndentation(
        wk.Foundation(shape, medium), Path(times, type(loads)(np.interp(times, corners, _numbers(loads)))), count=count
    )
    states = list(problem.steps())
    return states[-1], np.array(
        [crept(medium.creep, times, np.array([sunk(state, r) for state in states])) for r in places]
    )


def _numbers(loads):
    return loads.depth if isinstance(loads, Depth) else loads.force


@pytest.mark.slow
@settings(max_examples=5, deadline=None, derandomize=True)
@given(
    st.lists(st.tuples(st.floats(0.1, 1.0), st.floats(0.05, 0.5)), min_size=1, max_size=3),
    st.sampled_from([MAXWELL, STANDARD, TWO]),
)
def test_growing_contacts_sink_as_the_body_says(steps, solid):
    corners = np.concatenate([[0.0], np.cumsum([dt for dt, _ in steps])])
    depths = np.concatenate([[0.0], np.cumsum([change for _, change in steps])])
    depth, places = depths[-1], np.array([0.25, 0.8]) * math.sqrt(depths[-1])
    _, found = solve(solid, wk.Paraboloid(1.0), corners, Depth(depths), 40, places, 200)
    assert found == pytest.approx(depth - 0.5 * places**2, rel=4e-3)


HISTORIES = {
    "unloading": ([0.0, 1.0, 1.08], [0.0, 1.0, 0.9], (0.3, 0.7)),
    "held and unloading": ([0.0, 0.3, 0.5, 0.53], [0.0, 1.0, 1.0, 0.94], (0.3, 0.6)),
    "lost and found": ([0.0, 0.4, 0.6, 1.0], [0.0, 0.5, -0.3, 0.6], (0.2, 0.5)),
}


@pytest.mark.few(3)
@pytest.mark.parametrize("name", HISTORIES)
@pytest.mark.parametrize("solid", [MAXWELL, TWO], ids=["Maxwell", "two times"])
def test_under_the_body_the_surface_follows_it(name, solid):
    corners, depths, places = HISTORIES[name]
    state, result = solve(solid, wk.Paraboloid(1.0), np.array(corners), Depth(np.array(depths)), 160, np.array(places))
    assert max(places) < state.radius
    assert result == pytest.approx(depths[-1] - 0.5 * np.array(places) ** 2, rel=1.5e-3)


def test_the_reference_solution_converges():
    """The error is that of the reference solution's straight lines in time, and goes."""
    corners, depths = np.array([0.0, 0.4, 0.6, 1.0]), np.array([0.0, 0.5, -0.3, 0.6])
    place = np.array([0.5])
    errors = [
        abs(solve(MAXWELL, wk.Paraboloid(1.0), corners, Depth(depths), steps, place)[1][0] - 0.475)
        for steps in (40, 160)
    ]
    assert errors[1] < 0.2 * errors[0]


@pytest.mark.parametrize(
    "shape", [wk.Paraboloid(1.0), wk.Cone(1.0), wk.PowerLaw(1.0, 4.0)], ids=["ball", "cone", "blunt"]
)
def test_outside_the_surface_is_where_it_is_restored(shape):
    """Where it has not recovered from a wider contact."""
    corners, depths = np.array([0.0, 1.0, 1.1]), np.array([0.0, 0.5, 0.4])
    result = solve(STANDARD, shape, corners, Depth(depths), 120, np.zeros(0))[0]
    places = np.array([0.5 * (result.radius + result.pressed.radius), 1.5 * result.pressed.radius])
    state, moved = solve(STANDARD, shape, corners, Depth(depths), 120, places)
    fields = restore(state, places)
    assert fields.displacement == pytest.approx(moved, rel=2e-3)
    assert np.all(fields.gap > 0.0)


def test_a_dent_recovers_as_it_is_restored():
    """After the body has gone."""
    corners, depths, places = (
        np.array([0.0, 0.5, 0.55, 0.9]),
        np.array([0.0, 0.5, -0.5, -0.5]),
        np.array([0.2, 0.6, 1.0]),
    )
    state, moved = solve(TWO, wk.Paraboloid(1.0), corners, Depth(depths), 200, places)
    assert state.radius == 0.0
    fields = restore(state, places)
    assert np.all(fields.pressure == 0.0)
    assert fields.displacement == pytest.approx(moved, rel=4e-3)
    assert fields.gap == pytest.approx(0.5 * places**2 + 0.5 + fields.displacement, rel=1e-12)


def test_under_a_force():
    """Loaded, held, and taken off within the relaxation time; the depth is that of the marched springs."""
    corners, forces = np.array([0.0, 0.3, 1.0, 1.1]), np.array([0.0, 0.1, 0.1, 0.06])
    places = np.array([0.2, 0.4])
    state, result = solve(STANDARD, wk.Paraboloid(1.0), corners, Force(forces), 120, places, 200)
    assert max(places) < state.radius
    assert result == pytest.approx(state.depth - 0.5 * places**2, rel=2e-3)


@pytest.mark.slow
def test_a_dashpot_alongside():
    corners, depths, places = np.array([0.0, 1.0, 1.2]), np.array([0.0, 0.5, 0.46]), np.array([0.2, 0.5])
    _, result = solve(KelvinVoigt(0.25, 0.075), wk.Paraboloid(1.0), corners, Depth(depths), 160, places)
    assert result == pytest.approx(0.46 - 0.5 * places**2, rel=3e-3)
