"""Dugdale's law on layers, against a half-space, attraction without range, and a solution without springs."""

import functools
import itertools

import numpy as np
import pytest

import winkler as wk
from winkler.values.errors import NotConverged

WORK, RADIUS, THICKNESS = 0.05, 1e-3, 2e-5
GEL, STIFF, NETWORK, GLASSY = wk.Elastic(1e6, 0.4), wk.Elastic(210e9, 0.3), wk.Elastic(1e7, 0.3), wk.Elastic(1e10, 0.3)


def bed_of(layer, base):
    return wk.Foundation(wk.Paraboloid(RADIUS), wk.CoatedHalfSpace([wk.Layer(layer, THICKNESS)], on=base))


def film_kernel(poisson, distance):
    """Cosine transform of M of a film bonded to a rigid base (Hayes 1972; all lengths in thicknesses)."""
    nodes, weights = np.polynomial.legendre.leggauss(400)
    x = 12.5 * (nodes + 1.0)
    kappa = 3.0 - 4.0 * poisson
    compliance = (2.0 * kappa * np.sinh(2.0 * x) - 4.0 * x) / (
        2.0 * kappa * np.cosh(2.0 * x) + kappa**2 + 1.0 + 4.0 * x**2
    )
    return 2.0 / np.pi * np.tensordot(12.5 * weights * (compliance - 1.0), np.cos(np.multiply.outer(x, distance)), 1)


@functools.cache
def without_springs(poisson, radius, outer, stress):
    """Depth, force and opening at the rim, by Fredholm's equation of the whole line load.

    A paraboloid of curvature one on a film of thickness and modulus E* one; the stress pulls in radius < r < outer.
    """
    nodes, weights = np.polynomial.legendre.leggauss(60)
    inner, inner_weights = 0.5 * radius * (nodes + 1.0), 0.5 * radius * weights
    angle = np.arccos(radius / outer)
    turned = 0.5 * angle * (nodes + 1.0)
    ring, ring_weights = outer * np.cos(turned), 0.5 * angle * weights * outer * np.sin(turned)

    def kernel(x, t):
        return 0.5 * (film_kernel(poisson, x[:, None] - t) + film_kernel(poisson, x[:, None] + t))

    pulled = -2.0 * stress * np.sqrt(outer**2 - ring**2)
    matrix = np.eye(inner.size) + kernel(inner, inner) * inner_weights
    beside = kernel(inner, ring) @ (ring_weights * pulled)
    ends = np.array([radius])
    rigid, shaped = np.linalg.solve(matrix, np.ones(inner.size)), np.linalg.solve(matrix, -(inner**2) - beside)

    def at_edge(right, load, beside=0.0):  # Nystroem's interpolation
        return right - (kernel(ends, inner) @ (inner_weights * load))[0] - beside

    of_rigid = at_edge(1.0, rigid)
    of_shape = at_edge(-(radius**2), shaped, (kernel(ends, ring) @ (ring_weights * pulled))[0])
    depth = (-2.0 * stress * np.sqrt(outer**2 - radius**2) - of_shape) / of_rigid  # no jump of the line load
    load = depth * rigid + shaped
    force = 2.0 * (load @ inner_weights + pulled @ ring_weights)
    moved = pulled + kernel(ring, inner) @ (inner_weights * load) + kernel(ring, ring) @ (ring_weights * pulled)
    opening = 2.0 / np.pi * np.sum(0.5 * angle * weights * (ring**2 - depth + moved))
    return depth, force, opening


@pytest.mark.slow
@pytest.mark.parametrize("strength", [pytest.param(1e3, marks=pytest.mark.slow), 4e5])
def test_equal_layers_are_a_half_space(strength):
    law = wk.Dugdale(WORK, strength)
    layers, alike = bed_of(GEL, GEL), wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(GEL))
    ours, theirs = (wk.PullOff(bed, law).solve() for bed in (layers, alike))
    assert ours.force == pytest.approx(theirs.force, rel=1e-11)
    loads = wk.Force(np.array([-0.5, 0.0, 3.0]) * np.pi * WORK * RADIUS)
    ours, theirs = (wk.AdhesiveIndentation(bed, law, loads).solve() for bed in (layers, alike))
    np.testing.assert_allclose(ours.radius, theirs.radius, rtol=1e-10)
    np.testing.assert_allclose(ours.depth, theirs.depth, rtol=1e-10)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("radius", "outer", "stress"),
    [(0.5, 0.7, 0.3), *(pytest.param(*each, marks=pytest.mark.slow) for each in ((3.0, 3.4, 2.0), (1e-9, 0.8, 0.1)))],
)
def test_a_film_against_its_line_load(radius, outer, stress):
    depth, force, opening = without_springs(0.4, radius, outer, stress)
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0 - 0.4**2, 0.4), 1.0)], on=wk.Rigid())
    bed = wk.Foundation(wk.Paraboloid(1.0), film)
    contact = wk.AdhesiveIndentation(bed, wk.Dugdale(stress * opening, stress), wk.Radius(radius)).solve()
    assert contact.depth == pytest.approx(depth, rel=1e-9)
    assert contact.force == pytest.approx(force, rel=1e-9)


@pytest.mark.slow
def test_great_strength_is_attraction_without_range():
    bed = bed_of(NETWORK, GEL)
    short = wk.PullOff(bed, wk.ShortRange(WORK)).solve().force
    errors = [wk.PullOff(bed, wk.Dugdale(WORK, strength)).solve().force / short - 1.0 for strength in (4e6, 16e6)]
    assert 0.0 < errors[1] < errors[0] / 8.0 < 2e-4


@pytest.mark.slow
def test_far_attraction_of_a_hard_pair_is_twice_pi_w_r():
    touching = wk.AdhesiveIndentation(bed_of(STIFF, GLASSY), wk.Dugdale(WORK, 3e5), wk.Radius(1e-9)).solve()
    assert touching.force == pytest.approx(-2.0 * np.pi * WORK * RADIUS, rel=1e-2)


@pytest.mark.slow
def test_a_ring_far_wider_than_a_hard_layer_is_refused():
    with pytest.raises(NotConverged, match="is too wide against the layers"):
        wk.AdhesiveIndentation(bed_of(STIFF, GEL), wk.Dugdale(WORK, 3e2), wk.Radius(1e-9)).solve()


@pytest.mark.slow
def test_energy_is_the_work_of_the_machine_from_before_touch_on():
    law, bed = wk.Dugdale(WORK, 2e4), bed_of(NETWORK, GEL)
    touch = wk.AdhesiveIndentation(bed, law, wk.Radius(0.0)).solve().depth
    nodes, weights = np.polynomial.legendre.leggauss(24)
    ends = np.array([touch - 0.05 * law.range, touch, touch + 0.5 * law.range])
    half = 0.5 * np.diff(ends)[:, None]
    depths = (ends[:-1, None] + half * (nodes + 1.0)).ravel()
    path = wk.AdhesiveCycle(bed, law, wk.Depth(np.concatenate([ends[:1], depths, ends[-1:]]))).solve()
    assert path.radius[0] == 0.0 > path.force[0]
    assert path.dissipation[-1] == path.dissipation[0]
    work = np.sum((half * weights).ravel() * path.force[1:-1])
    assert path.energy[-1] - path.energy[0] == pytest.approx(work, rel=1e-6)


@pytest.mark.slow
def test_the_restored_pressure_pulls_with_the_strength():
    strength = 4e4
    contact = wk.AdhesiveIndentation(bed_of(NETWORK, GEL), wk.Dugdale(WORK, strength), wk.Force(1e-4)).solve()
    r = contact.radius * np.array([1.001, 1.01, 1.02])
    np.testing.assert_allclose(wk.restore(contact, r).pressure, -strength, rtol=1e-6)


def graded(base):
    return wk.ExponentialGrading(1e6, base, depth_scale=THICKNESS, poisson=0.4)


@pytest.mark.slow
@pytest.mark.parametrize("radius", [pytest.param(0.0, marks=pytest.mark.slow), 4e-5])
def test_a_body_that_is_hardly_graded_is_a_half_space(radius):
    law = wk.Dugdale(WORK, 2e4)
    media = (wk.DepthGradedHalfSpace(graded(1e6 * (1.0 + 1e-9))), wk.HalfSpace(GEL))
    ours, theirs = (
        wk.AdhesiveIndentation(wk.Foundation(wk.Paraboloid(RADIUS), medium), law, wk.Radius(radius)).solve()
        for medium in media
    )
    assert ours.force == pytest.approx(theirs.force, rel=2e-9)
    assert ours.depth == pytest.approx(theirs.depth, rel=1e-8)


@pytest.mark.slow
def test_a_graded_body_is_the_limit_of_stacks_of_layers():
    """Layers of the mean modulus over equal steps of the modulus; the error falls with the square of their number."""
    grading, law = graded(3e6), wk.Dugdale(WORK, 4e4)

    def solved(medium):
        solution = wk.AdhesiveIndentation(wk.Foundation(wk.Paraboloid(RADIUS), medium), law, wk.Radius(4e-5)).solve()
        return np.array([solution.depth, solution.force])

    def stack(count):
        share = np.linspace(0.0, 1.0, count + 1)
        depth = -THICKNESS * np.log1p(-share * (1.0 - 1e-4))
        young = [np.mean(grading.young_at(np.linspace(*ends, 21))) for ends in itertools.pairwise(depth)]
        layers = [
            wk.Layer(wk.Elastic(float(modulus), 0.4), float(thickness))
            for modulus, thickness in zip(young, np.diff(depth), strict=True)
        ]
        return solved(wk.CoatedHalfSpace(layers, on=wk.Elastic(3e6, 0.4)))

    few, many = stack(8), stack(16)
    wanted, found = (4.0 * many - few) / 3.0, solved(wk.DepthGradedHalfSpace(grading))
    assert found[0] == pytest.approx(wanted[0], abs=3e-4 * 4e-5**2 / RADIUS)
    assert found[1] == pytest.approx(wanted[1], rel=3e-4)


@pytest.mark.slow
def test_great_strength_on_a_graded_body_is_attraction_without_range():
    bed, at = wk.Foundation(wk.Paraboloid(RADIUS), wk.DepthGradedHalfSpace(graded(3e6))), wk.Radius(6e-5)
    short = wk.AdhesiveIndentation(bed, wk.ShortRange(WORK), at).solve().force
    forces = [wk.AdhesiveIndentation(bed, wk.Dugdale(WORK, strength), at).solve().force for strength in (1e6, 4e6)]
    errors = [abs(force / short - 1.0) for force in forces]
    assert errors[1] < errors[0] / 8.0
    assert errors[1] < 1e-3


@pytest.mark.slow
def test_a_cycle_on_a_weak_grading_is_that_on_a_half_space():
    law, path = wk.Dugdale(0.01, 2e4), wk.Depth([-1e-6, 1e-7, -1e-6])
    weak = wk.ExponentialGrading(1e6, 1e6 * (1.0 + 1e-9), depth_scale=1e-5, poisson=0.3)
    media = (wk.HalfSpace(wk.Elastic(1e6, 0.3)), wk.DepthGradedHalfSpace(weak))
    plain, graded = (
        wk.AdhesiveCycle(wk.Foundation(wk.Paraboloid(1e-5), medium), law, path).solve() for medium in media
    )
    assert graded.dissipation[-1] == pytest.approx(plain.dissipation[-1], rel=1e-8)
    assert graded.force[1] == pytest.approx(plain.force[1], rel=1e-8)
    assert [jump.snap_in for jump in graded.jumps] == [True, False]
