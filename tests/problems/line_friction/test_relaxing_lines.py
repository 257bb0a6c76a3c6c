"""Sheared line contacts of bodies that relax: elastic limits, Cattaneo as it creeps, a second discretisation."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.laws.friction import Coulomb
from winkler.materials.layered import Layer
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.line_friction.path import LinePath
from winkler.values.errors import InvalidInput, OutsideValidity

STANDARD = StandardSolid(0.05, 0.2, 0.2)
MU, LOAD = 0.3, 1e-4


def sheared(solid, path, profile=None, **more):
    bed = wk.LineFoundation(profile or wk.Paraboloid(1.0), ViscoelasticHalfSpace(solid))
    return wk.LineTangential(bed, Coulomb(MU), path, **more).solve()


@pytest.mark.parametrize(("tau", "young"), [(1e7, 0.75), (1e-5, 0.15)])
def test_fast_and_slow_a_bulk_stress_strains_them_as_if_elastic(tau, young):
    peak = 2.0 * LOAD / np.pi / np.sqrt(4.0 * LOAD * 0.75 / (np.pi * young))
    bulk = 0.8 * MU * peak * np.array([0.0, 1.0, 0.3, -0.3, 0.5, -0.2])
    shear = 0.5 * MU * LOAD * np.array([0.0, 0.0, 1.0, -1.0, 1.0, 0.0])
    ours = sheared(StandardSolid(0.05, 0.2, tau), LinePath(LOAD, shear, bulk_stress=bulk, time=np.arange(6.0)))
    elastic = wk.LineFoundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(young, 0.5)))
    true = wk.LineTangential(elastic, Coulomb(MU), LinePath(LOAD, shear, bulk_stress=bulk)).solve()
    for name in ("stick_half_width", "stick_middle", "slip_shift", "dissipation_per_length"):
        expected, found = (np.array([getattr(state, name) for state in one.states[1:]]) for one in (true, ours))
        assert found == pytest.approx(expected, abs=6e-3 * np.max(np.abs(expected)))
    x = 0.97 * np.linspace(-1.0, 1.0, 99) * true.half_width[-1]
    for one, two in zip(ours.states[1:], true.states[1:], strict=True):
        assert one.traction(x) == pytest.approx(two.traction(x), abs=0.01 * MU * peak)
    still = wk.LineTangential(elastic, Coulomb(MU), LinePath(LOAD, shear)).solve()
    assert ours.dissipation_per_length[-1] > 1.1 * still.dissipation_per_length[-1]  # the bulk stress is felt


def crossing(seed):
    """Return forces that rise and fall out of step, so that the contact reverses and narrows at once."""
    random = np.random.default_rng(seed)
    time = np.linspace(0.0, 4.0, int(random.choice([9, 17, 33, 41])))
    force = LOAD * (1.0 + 0.7 * np.sin(random.uniform(0.5, 3.0) * time + random.uniform(0.0, 6.0)))
    return time, force, 0.8 * MU * force * np.sin(random.uniform(0.5, 4.0) * time)


@pytest.mark.parametrize("seed", [0, 7, 8, pytest.param(22, marks=pytest.mark.slow), 29])
def test_an_element_at_its_bound_divides_no_strip_that_sticks(seed):
    time, force, shear = crossing(seed)
    bed = wk.LineFoundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(0.75, 0.5)))
    exact = wk.LineTangential(bed, Coulomb(MU), LinePath(force, shear)).solve()
    elements = wk.LineTangential(bed, Coulomb(MU), LinePath(force, shear), wk.Method.ELEMENTS).solve()
    relaxing = sheared(StandardSolid(0.05, 0.2, 1e9), LinePath(force, shear, time=time))
    for ours in (elements, relaxing):
        error = np.abs(ours.stick_half_width - exact.stick_half_width) / exact.half_width
        assert np.max(error) < 0.01  # an element at the edge; a strip divided was wrong by up to 0.44


def test_a_shear_force_that_grows_is_cattaneos_however_the_bodies_creep():
    """What sticks moves as one at all times, as the elastic tractions of each moment do: q needs not know of time."""
    time, part = np.array([0.0, 60.0, 60.1, 60.3, 61.0]), np.array([0.0, 0.0, 0.3, 0.5, 0.6])
    ours = sheared(STANDARD, LinePath(LOAD, part * MU * LOAD, time=time))
    a = np.sqrt(4.0 * LOAD / (np.pi * 0.2))
    assert ours.half_width[1:] == pytest.approx(a, rel=1e-5)
    for state, share in zip(ours.states[2:], part[2:], strict=True):
        c = a * np.sqrt(1.0 - share)
        assert state.stick_half_width == pytest.approx(c, rel=2e-3)
        x = np.linspace(-0.95, 0.95, 39) * a
        inner = np.sqrt(np.maximum(1.0 - (x / c) ** 2, 0.0)) * c / a
        expected = MU * 2.0 * LOAD / (np.pi * a) * (np.sqrt(1.0 - (x / a) ** 2) - inner)
        assert state.traction(x) == pytest.approx(expected, abs=0.02 * MU * 2.0 * LOAD / (np.pi * a))


def even_kernel(edges):
    """Displacement of the middles of elements by tractions on half-planes of E* = 1."""
    far = 0.5 * (edges[1:] + edges[:-1])[:, None] - edges
    antiderivative = far * np.log(np.abs(far) / edges[-1]) - far
    return -2.0 / np.pi * (antiderivative[:, :-1] - antiderivative[:, 1:])


def own_march(edges, bound, moments, shears, creep):
    """Even elements of one width, and the creep summed over all earlier moments: no exponentials, no memory terms.

    `creep` has the displacements by tractions of an age, a matrix.
    """
    x, h, count = 0.5 * (edges[1:] + edges[:-1]), edges[1] - edges[0], edges.size - 1
    tractions, slips = [np.zeros(count)], [np.zeros(count)]
    lost, sides = 0.0, np.zeros(count)
    for n in range(1, moments.size):
        ages = moments[n] - moments[: n + 1]

        def mean(k, ages=ages):
            """Creep of a rise that is straight from moment k - 1 to k, at Simpson's three places."""
            middle = 0.5 * (ages[k - 1] + ages[k])
            return (creep(ages[k - 1]) + 4.0 * creep(middle) + creep(ages[k])) / 6.0

        crept = sum((mean(k) @ (tractions[k] - tractions[k - 1]) for k in range(1, n)), np.zeros(count))
        now = mean(n)
        crept = crept - now @ tractions[-1]
        for _ in range(200):
            stuck = sides == 0.0
            m = int(stuck.sum())
            slid = np.where(stuck, 0.0, sides * bound)
            matrix = np.block([[now[np.ix_(stuck, stuck)], -np.ones((m, 1))], [h * np.ones((1, m)), np.zeros((1, 1))]])
            known = crept + now @ slid
            right = np.append(-slips[-1][stuck] - known[stuck], shears[n] - h * slid.sum())
            found = np.linalg.solve(matrix, right)
            q = slid.copy()
            q[stuck] = found[:-1]
            ahead = found[-1] - crept - now @ q  # how far the second body is ahead
            moved = ahead - slips[-1]
            wrong_stuck = stuck & (np.abs(q) > bound * (1.0 + 1e-12))
            wrong_slid = ~stuck & (sides * moved < -1e-15)
            if not (wrong_stuck | wrong_slid).any():
                break
            sides = np.where(wrong_stuck, np.sign(q), np.where(wrong_slid, 0.0, sides))
        else:
            raise AssertionError("the zones were not found")
        lost += h * float(np.sum(np.abs(q) * np.where(sides != 0.0, np.abs(moved), 0.0)))
        tractions.append(q)
        slips.append(np.where(sides != 0.0, ahead, slips[-1]))
    return x, tractions, slips, lost


@pytest.mark.slow
def test_even_elements_and_hereditary_sums_agree():
    """A cylinder that has crept to its end is pushed to and fro, as fast as it relaxes."""
    per, period = 32, 1.0
    late = np.arange(2 * per + 1) / per * period
    shears = 0.7 * MU * LOAD * np.sin(2.0 * np.pi * late / period)
    time = np.append(0.0, 60.0 + late)
    ours = sheared(STANDARD, LinePath(LOAD, np.append(0.0, shears), time=time))
    half_width = float(ours.half_width[-1])
    assert half_width == pytest.approx(np.sqrt(4.0 * LOAD / (np.pi * 0.2)), rel=1e-4)  # E* = 4 G, relaxed

    edges = np.linspace(-half_width, half_width, 121)
    kernel, root = even_kernel(edges), np.sqrt(np.maximum(half_width**2 - edges**2, 0.0))
    area = edges * root + half_width**2 * np.arcsin(edges / half_width)
    bound = MU * LOAD / (np.pi * half_width**2) * np.diff(area) / (edges[1] - edges[0])

    def creep(t):  # of 1/E*: J/4
        return 0.25 * (20.0 - 16.0 * np.exp(-t)) * kernel

    x, tractions, slips, lost = own_march(edges, bound, late, shears, creep)
    peak = MU * 2.0 * LOAD / (np.pi * half_width)
    for n in (per // 4, per // 2, per, 2 * per):
        inside = np.abs(x) < 0.97 * half_width
        assert ours.states[1 + n].traction(x[inside]) == pytest.approx(tractions[n][inside], abs=0.03 * peak)
        ahead = ours.states[1 + n].slip(x)
        assert ahead - ahead.mean() == pytest.approx(slips[n] - slips[n].mean(), abs=0.02 * np.ptp(slips[per // 4]))
    assert ours.dissipation_per_length[-1] == pytest.approx(lost, rel=0.01)
    relaxed = wk.LineFoundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(0.15, 0.5)))
    elastic = wk.LineTangential(relaxed, Coulomb(MU), LinePath(LOAD, shears)).solve()
    assert abs(lost / elastic.dissipation_per_length[-1] - 1.0) > 0.05  # what relaxes is felt


def test_stuck_strips_lose_nothing_to_friction():
    time = np.linspace(0.0, 2.0, 9)
    path = LinePath(LOAD, 1e-3 * MU * LOAD * np.sin(np.pi * time), time=time)
    ours = sheared(Maxwell(shear=0.25, relaxation_time=0.5), path)
    assert ours.dissipation_per_length[-1] < 1e-4 * MU * LOAD * ours.half_width[-1]


@pytest.mark.slow
def test_layers_that_relax_alike_have_their_elastic_limit_and_feel_their_base():
    layers = wk.CoatedHalfSpace([Layer(wk.Elastic(1.0, 0.3), 0.01)], on=wk.Elastic(10.0, 0.3))
    shear = 0.6 * MU * LOAD * np.array([0.0, 1.0, -1.0])
    elastic = wk.LineTangential(
        wk.LayeredLineFoundation(wk.Paraboloid(1.0), layers), Coulomb(MU), LinePath(LOAD, shear)
    )
    true = elastic.solve()
    relaxing = RelaxingInProportion(layers, StandardSolid(0.05, 0.2, 1e7), shear=0.25)
    bed = wk.LayeredLineFoundation(wk.Paraboloid(1.0), relaxing)
    ours = wk.LineTangential(bed, Coulomb(MU), LinePath(LOAD, shear, time=np.arange(3.0))).solve()
    assert ours.half_width == pytest.approx(true.half_width, rel=1e-4)
    assert ours.dissipation_per_length == pytest.approx(
        true.dissipation_per_length, abs=5e-3 * true.dissipation_per_length[-1]
    )
    base = wk.LineFoundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(10.0, 0.3)))
    alone = wk.LineTangential(base, Coulomb(MU), LinePath(LOAD, shear)).solve()
    assert ours.dissipation_per_length[-1] > 1.5 * alone.dissipation_per_length[-1]


def test_what_is_not_followed_is_refused():
    bed = wk.LineFoundation(wk.Paraboloid(1.0), ViscoelasticHalfSpace(STANDARD))
    with pytest.raises(InvalidInput, match="states none"):
        wk.LineTangential(bed, Coulomb(MU), LinePath(LOAD, [0.0, 1e-6]))
    with pytest.raises(InvalidInput, match="falls from one point"):
        LinePath(LOAD, [0.0, 1e-6], time=[1.0, 0.0])
    with pytest.raises(InvalidInput, match="method exact"):
        wk.LineTangential(bed, Coulomb(MU), LinePath(LOAD, [0.0, 1e-6], time=[0.0, 1.0]), wk.Method.EXACT)
    film = wk.PoroelasticFilm(0.05, 0.3, 1.0, 0.1)
    layers = wk.LayeredLineFoundation(wk.Paraboloid(1.0), film)
    with pytest.raises(InvalidInput, match="elastic CoatedHalfSpace"):
        wk.LineTangential(layers, Coulomb(MU), LinePath(LOAD, [0.0, 1e-6], time=[0.0, 1.0]))
    steps = wk.LineTangential(bed, Coulomb(MU), LinePath(LOAD, [0.0, 1e-6, LOAD], time=[0.0, 1.0, 2.0])).steps()
    assert next(steps).shear_force_per_length == 0.0
    assert next(steps).shear_force_per_length == 1e-6
    with pytest.raises(OutsideValidity, match="index 2"):
        next(steps)


def test_a_dashpot_alongside_needs_time():
    shear = 0.3 * MU * LOAD * np.array([0.0, 0.0, 1.0, 1.0])
    ours = sheared(KelvinVoigt(0.25, 0.05), LinePath(LOAD * np.array([0.0, 1.0, 1.0, 1.0]), shear, time=[0, 1, 2, 2]))
    assert ours.stick_half_width[-1] == ours.stick_half_width[-2] < ours.half_width[-1]
    with pytest.raises(OutsideValidity, match="index 2 .* give the step some time"):
        sheared(KelvinVoigt(0.25, 0.05), LinePath(LOAD * np.array([0.0, 1.0, 1.0]), shear[:3], time=[0, 1, 1]))
