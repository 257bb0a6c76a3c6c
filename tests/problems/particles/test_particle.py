"""The elastic-plastic particle against another code, Johnson, Kendall and Roberts, and brute force."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

import winkler as wk
from winkler.problems.particles.elastic_plastic import ElasticPlasticParticle, ParticleSolution
from winkler.values.validity import Standing

RADIUS, YOUNG, POISSON, STRENGTH = 1e-3, 1e9, 0.3, 20e6
PLANE = YOUNG / (1.0 - POISSON**2)
SHEAR = YOUNG / (2.0 * (1.0 + POISSON))
POWDER = wk.Elastic(YOUNG, POISSON, STRENGTH)
GEL = wk.Elastic(0.75, 0.5)
"""E_c = 1."""
WORK = 1e-9
PULL = 1.5 * math.pi * WORK
"""Of a ball of radius one."""


def pressed(path, *, solid=POWDER, radius=RADIUS, opening=0.0, closing=0.0) -> ParticleSolution:
    return ElasticPlasticParticle(radius, solid, path, opening, closing).solve()


@pytest.fixture(scope="module")
def lammps(shared_data):
    def read(kind):
        return np.genfromtxt(shared_data / "reference" / f"particle_mdr_{kind}.csv", delimiter=",", names=True)

    return read


# ---------------------------------------------------------------------------------------------------------------------
# the law once more, written down from the paper


def ellipse(height, width, depth):
    if depth <= 0.0:
        return 0.0
    z = depth / height
    return PLANE * height * width / 4.0 * (math.acos(1.0 - 2.0 * z) - (1.0 - 2.0 * z) * 2.0 * math.sqrt(z * (1.0 - z)))


def yield_pressure(depth, radius=RADIUS):
    return STRENGTH * (1.75 * math.exp(-4.4 * depth / radius) + 1.0)


def hertz(depth, radius=RADIUS):
    return 4.0 * PLANE * math.sqrt(depth / radius) / (3.0 * math.pi)


ONSET = brentq(lambda d: hertz(d) - yield_pressure(d), 1e-9, 1e-4, xtol=1e-25)


def law(depth, largest):
    if largest <= ONSET:
        return ellipse(4.0 * RADIUS, 2.0 * RADIUS, depth)
    a2 = 2.0 * largest * RADIUS - largest**2 + ONSET**2 - ONSET * RADIUS
    a, p = math.sqrt(a2), yield_pressure(largest)
    height = 4.0 * p * a / PLANE
    z = RADIUS - (largest - height / 2.0)
    far = math.hypot(a, z)
    moved = math.pi * a2 * p * (2.0 * a2 * (POISSON - 1.0) - (2.0 * POISSON - 1.0) * z * (far - z))
    moved /= 2.0 * math.pi * SHEAR * a2 * far
    u = (depth - largest + height / 2.0 + moved) / (1.0 + 2.0 * moved / height)
    return ellipse(height, 2.0 * a, min(u, height / 2.0))


def grown(depths, substeps=20):
    """Load with the apparent radius growing at constant volume, as the other code does, by small steps."""
    fine = np.concatenate([np.linspace(a, b, substeps, endpoint=False) for a, b in pairwise(depths)])
    bulk = YOUNG / (3.0 * (1.0 - 2.0 * POISSON))
    volume = 4.0 / 3.0 * math.pi * RADIUS**3
    radius, offset, strain, before, result = RADIUS, None, 0.0, 0.0, []
    for x in fine:
        d = x + radius - RADIUS
        p = yield_pressure(d, radius)
        if offset is None and hertz(d, radius) > p:
            offset = d * d - d * radius
        if offset is None:
            force = ellipse(4.0 * radius, 2.0 * radius, d)
        else:
            force = math.pi * (2.0 * d * radius - d * d + offset) * p
        new = -force * (RADIUS - x) / (3.0 * bulk * volume)
        if offset is not None:
            squeezed = math.pi * (x - before) * (2.0 * x * RADIUS - x * x + radius**2 - RADIUS**2)
            free = 4.0 * math.pi * radius**2 - 2.0 * math.pi * radius * d
            radius += max((volume * (new - strain) + squeezed) / free, 0.0)
        result.append(force)
        strain, before = new, x
    return np.array(result)[::substeps]


def test_elastic_particles_agree_with_the_other_code(lammps):
    table = lammps("elastic")
    assert table.size > 200
    contact = pressed(wk.Depth(table["overlap_m"] / 2.0), solid=wk.Elastic(YOUNG, POISSON, 1e12))
    # the other code loses digits in arccos at small depths
    assert contact.force == pytest.approx(table["force_N"], rel=3e-11, abs=1e-14)
    rounding = 10.0 * np.finfo(float).eps * np.max(contact.energy)
    assert contact.dissipation == pytest.approx(np.zeros(table.size), abs=rounding)


def test_yielding_particles_agree_but_for_their_growth(lammps):
    table = lammps("plastic")
    top = int(np.argmax(table["overlap_m"]))
    depths, forces = table["overlap_m"][: top + 1] / 2.0, table["force_N"][: top + 1]
    contact = pressed(wk.Depth(depths))
    elastic = depths < ONSET
    assert contact.force[elastic] == pytest.approx(forces[elastic], rel=3e-11, abs=1e-14)
    # what is left is that the other code lets the radius grow: with that growth put in, it is gone
    assert np.max(np.abs(contact.force[1:] / forces[1:] - 1.0)) == pytest.approx(0.0166, abs=2e-4)
    assert grown(depths)[1:] == pytest.approx(forces[1:-1], rel=1.1e-4)


def test_let_go_they_bounce_alike_but_for_their_growth(lammps):
    """The same curve from its greatest overlap back until the particles part: force, and work given back over spent."""
    table = lammps("plastic")
    depths, forces = table["overlap_m"] / 2.0, table["force_N"]
    top = int(np.argmax(depths))
    contact = pressed(wk.Depth(depths))
    back = slice(top, None)
    assert np.count_nonzero(forces[back]) > 10
    assert contact.force[back] == pytest.approx(forces[back], abs=0.0167 * forces[top])

    def restitution(force):
        given, spent = -np.trapezoid(force[back], depths[back]), np.trapezoid(force[: top + 1], depths[: top + 1])
        return math.sqrt(given / spent)

    assert restitution(contact.force) == pytest.approx(restitution(forces), abs=0.003)


def test_loading_and_unloading_as_written_in_the_paper():
    depths = np.concatenate([np.linspace(0.0, 0.1, 60), np.linspace(0.1, 0.0, 80), np.linspace(0.0, 0.15, 70)]) * RADIUS
    contact = pressed(wk.Depth(depths))
    largest = np.maximum.accumulate(depths)
    expected = [law(d, most) for d, most in zip(depths, largest, strict=True)]
    assert contact.force == pytest.approx(expected, rel=1e-9, abs=1e-12)
    assert contact.yield_depth == pytest.approx(ONSET, rel=1e-12)


def test_where_yield_begins():
    particle = ElasticPlasticParticle(2.0, wk.Elastic(5e6, 0.4, 1.9e5), wk.Depth([0.0]))
    # the root of 4 E_c sqrt(x) / 3 pi = Y (1.75 exp(-4.4 x) + 1), by mpmath
    assert particle.yield_depth / 2.0 == pytest.approx(0.0353030214852804, rel=1e-13)


def test_a_strong_particle_never_yields():
    assert ElasticPlasticParticle(1.0, wk.Elastic(1e6, 0.3), wk.Depth([0.0])).yield_depth == math.inf
    assert ElasticPlasticParticle(1.0, wk.Elastic(1e6, 0.3, 1e7), wk.Depth([0.0])).yield_depth == math.inf


# ---------------------------------------------------------------------------------------------------------------------
# adhesion before yield


def test_the_pull_off_is_that_of_johnson_kendall_and_roberts():
    dead = ElasticPlasticParticle(1.0, GEL, wk.Force([0.0, -0.999 * PULL, -1.001 * PULL]), WORK, WORK)
    states = dead.steps()
    at_rest, nearly = next(states), next(states)
    assert at_rest.radius == pytest.approx((4.5 * math.pi * WORK) ** (1.0 / 3.0), rel=1e-5)
    assert nearly.force == -0.999 * PULL
    with pytest.raises(wk.OutsideValidity, match="pulls the particle off"):
        next(states)


def test_a_cycle_under_fixed_grips_loses_the_energy_of_johnson_kendall_and_roberts():
    cycle = pressed(wk.Depth([1e-4, -1e-4]), solid=GEL, radius=1.0, opening=WORK, closing=WORK)
    assert cycle.radius[-1] == 0.0
    assert cycle.dissipation[-1] / WORK ** (5.0 / 3.0) == pytest.approx(7.092196, rel=1e-5)
    assert cycle.energy[-1] == 0.0


def test_the_whole_curve_is_that_of_the_adhesive_contact():
    # a = (4.5 pi w)^(1/3) is 0.0024 here, so that ellipse and parabola differ by 1e-5
    depths = np.linspace(2e-6, -1.6e-6, 41)
    particle = pressed(wk.Depth(depths), solid=GEL, radius=1.0, opening=WORK, closing=WORK)
    bed = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace.between(GEL))
    for depth, force, radius in zip(depths[::8], particle.force[::8], particle.radius[::8], strict=True):
        exact = wk.AdhesiveIndentation(bed, wk.ShortRange(WORK), wk.Depth(float(depth))).solve()
        assert force == pytest.approx(exact.force, rel=2e-5, abs=1e-5 * PULL)
        assert radius == pytest.approx(exact.radius, rel=1e-5)


def test_two_equal_spheres_are_two_particles_with_half_the_work_each():
    pair = wk.Foundation(wk.Paraboloid(0.5), wk.HalfSpace.between(GEL, GEL))
    exact = wk.AdhesiveIndentation(pair, wk.ShortRange(2.0 * WORK), wk.Depth(np.array([-2e-6, 1e-6, 4e-6]))).solve()
    particle = pressed(wk.Depth([2e-6, 0.5e-6, -1e-6]), solid=GEL, radius=1.0, opening=WORK, closing=WORK)
    assert particle.force[::-1] == pytest.approx(exact.force, rel=2e-5, abs=1e-5 * PULL)
    assert particle.radius[::-1] == pytest.approx(exact.radius, rel=1e-5)


def test_without_a_gain_in_closing_the_edge_rests_before_it_recedes():
    path = wk.Depth(np.concatenate([np.linspace(0.0, 1e-5, 11), np.linspace(1e-5, -5e-6, 61)]))
    particle = pressed(path, solid=GEL, radius=1.0, opening=WORK)
    assert particle.force[:11] == pytest.approx(4.0 / 3.0 * particle.depth[:11] ** 1.5, rel=1e-5)
    resting = particle.radius == particle.radius[10]
    assert 3 < np.count_nonzero(resting) < 50
    assert np.min(particle.force) == pytest.approx(-PULL, rel=0.02)


@pytest.mark.parametrize("depth", [0.02, 0.06, 0.2])
def test_after_yield_the_edge_stands_where_the_energy_is_least(depth):
    """Brute force: the energy of elastic springs and surfaces, by quadrature, does not change with the edge."""
    opening = 0.3
    let_go = np.linspace(depth, 0.0, 400) * RADIUS
    particle = pressed(wk.Depth(let_go), opening=opening)
    moving = np.flatnonzero((np.diff(particle.radius) < 0.0) & (particle.radius[1:] > 0.0)) + 1
    assert moving.size > 3
    largest = depth * RADIUS
    b = math.sqrt(2.0 * largest * RADIUS - largest**2 + ONSET**2 - ONSET * RADIUS)
    height = 4.0 * yield_pressure(largest) * b / PLANE
    stretch = (largest - particle.residual_depth[0]) / (height / 2.0)

    def gap(x):
        return height / 2.0 * (1.0 - math.sqrt(1.0 - (x / b) ** 2))

    for index in moving[:: max(moving.size // 4, 1)]:
        u = (let_go[index] - particle.residual_depth[index]) / stretch
        a = particle.radius[index]
        force = 2.0 * PLANE * quad(lambda x, u=u: u - gap(x), 0.0, a, epsabs=0.0, epsrel=1e-11)[0]
        assert particle.force[index] == pytest.approx(force, rel=1e-9, abs=1e-9)
        # what a receding edge sets free per area is what parting costs
        release = PLANE * (gap(a) - u) ** 2 / (2.0 * math.pi * a)
        assert release == pytest.approx(opening, rel=1e-9)


# ---------------------------------------------------------------------------------------------------------------------
# energy


@pytest.mark.parametrize("seed", range(8))
def test_no_history_creates_energy(seed):
    rng = np.random.default_rng(seed)
    opening = float(rng.choice([0.0, 0.2, 5.0]))
    closing = opening * float(rng.choice([0.0, 0.5, 1.0]))
    depths = rng.uniform(-0.02, 0.3, 60) * RADIUS * np.linspace(0.05, 1.0, 60)
    particle = pressed(wk.Depth(depths), opening=opening, closing=closing)
    scale = np.max(particle.work)
    assert np.min(np.diff(particle.dissipation, prepend=0.0)) >= -1e-12 * scale
    assert particle.dissipation[-1] > 0.0


@pytest.mark.few(2)
@pytest.mark.parametrize(("opening", "closing"), [(0.0, 0.0), (0.5, 0.0), (0.5, 0.5)])
def test_the_work_is_the_integral_of_the_force(opening, closing):
    corners = np.array([0.005, 0.08, 0.06, 0.0, 0.1, 0.085]) * RADIUS
    depths = np.concatenate([np.linspace(a, b, 1500) for a, b in pairwise(corners)])
    particle = pressed(wk.Depth(depths), opening=opening, closing=closing)
    integral = np.concatenate([[0.0], np.cumsum((particle.force[1:] + particle.force[:-1]) / 2.0 * np.diff(depths))])
    # only within a step in which the edge jumps, or yield begins, is the trapezium wrong
    assert particle.work - particle.work[0] == pytest.approx(integral, abs=2e-5 * np.max(particle.work))


def test_the_solution_depends_on_the_turning_points_alone():
    corners = wk.Depth(np.array([0.08, -0.02, 0.05, 0.12, 0.09]) * RADIUS)
    fine = wk.Depth(np.concatenate([np.linspace(a, b, 50) for a, b in pairwise(corners.depth)]))
    few, many = (pressed(path, opening=0.4, closing=0.1) for path in (corners, fine))
    assert few.dissipation[-1] == pytest.approx(many.dissipation[-1], rel=1e-11)
    assert few.force[-1] == pytest.approx(many.force[-1], rel=1e-11)


@pytest.mark.parametrize(("opening", "closing"), [(0.0, 0.0), (0.5, 0.0), (0.5, 0.5)])
def test_forces_lead_to_the_depths_that_lead_to_them(opening, closing):
    depths = np.array([0.005, 0.011, 0.03, 0.06, 0.055, 0.052, 0.058, 0.09, 0.084]) * RADIUS
    by_depth = pressed(wk.Depth(depths), opening=opening, closing=closing)
    by_force = pressed(wk.Force(by_depth.force), opening=opening, closing=closing)
    assert by_force.depth == pytest.approx(depths, rel=1e-10)
    assert by_force.radius == pytest.approx(by_depth.radius, rel=1e-9)
    assert np.diff(by_force.work) == pytest.approx(np.diff(by_depth.work), rel=1e-8)


def test_a_force_in_the_jump_at_yield_is_held_there():
    below = pressed(wk.Depth([ONSET * (1.0 - 1e-9)])).force[0]
    above = pressed(wk.Depth([ONSET * (1.0 + 1e-9)])).force[0]
    assert above > below * 1.0005
    held = pressed(wk.Force([0.5 * (below + above)]))
    assert held.depth[0] == pytest.approx(ONSET, rel=1e-12)
    assert held.force[0] == 0.5 * (below + above)


# ---------------------------------------------------------------------------------------------------------------------
# words


def test_what_is_refused():
    for wrong in (
        {"curvature_radius": 0.0},
        {"work_opening": -1.0},
        {"work_closing": 1.0},
        {"solid": 3.0},
        {"path": wk.Radius(1.0)},
        {"path": wk.Depth(1.0)},
        {"work_opening": True},
    ):
        given = {"curvature_radius": 1.0, "solid": POWDER, "path": wk.Depth([0.1]), **wrong}
        with pytest.raises(wk.InvalidInput, match="ElasticPlasticParticle"):
            ElasticPlasticParticle(**given)


def test_too_deep_is_outside():
    steps = ElasticPlasticParticle(RADIUS, POWDER, wk.Depth([0.4 * RADIUS, 0.6 * RADIUS])).steps()
    assert next(steps).force > 0.0
    with pytest.raises(wk.OutsideValidity, match="compressed as a whole"):
        next(steps)
    with pytest.raises(wk.OutsideValidity, match="deeper than"):
        pressed(wk.Force([1e6]))
    with pytest.raises(wk.OutsideValidity, match="pulls the particle off"):
        pressed(wk.Force([1.0, -1e-3]))


def test_a_note_states_that_it_is_an_engineering_law():
    assert len(pressed(wk.Depth([0.005 * RADIUS])).validity) == 1
    notes = pressed(wk.Depth([0.1 * RADIUS])).validity
    assert [note.standing for note in notes] == [Standing.APPROXIMATE] * 2
    assert "engineering law" in notes[1].statement
