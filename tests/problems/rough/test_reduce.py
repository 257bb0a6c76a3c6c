"""Springs behind height maps: forces of closed forms and of the boundary elements themselves, and what runs on them."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.loading.loads import Depth
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.normal.indentation import Indentation
from winkler.problems.rough import reduce as reducing
from winkler.problems.rough.reduce import Reduction, reduce
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.profiles.rough.random_rough import random_topography
from winkler.profiles.rough.spectrum import SelfAffine
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

UNIT = HalfSpace(Elastic(1.0, 0.3))
COUNT = 95  # odd, so that the apex is the middle of a pixel


def places(count=COUNT, side=1.0):
    x = (np.arange(count) - (count - 1) / 2) * side / count
    return x[:, None], x[None, :]


def paraboloid(a=0.5, b=0.5):
    """Return the map of a x^2 + b y^2."""
    x, y = places()
    return Topography(-a * x**2 - b * y**2, [1.0, 1.0])


@pytest.mark.few(1)
@pytest.mark.parametrize(("a", "b", "same"), [(0.5, 0.5, 1.0), (0.4, 0.6, 1.0276201), (0.25, 0.75, 1.2132707)])
def test_ellipses_are_springs_under_a_paraboloid(a, b, same):
    """g = x^2/R_eq and F = 4/3 E* R_eq^(1/2) d^(3/2), theory 1.3."""
    result = Reduction(paraboloid(a, b), UNIT, 0.05).solve()
    for depth in (0.011, 0.024, 0.05):
        force = Indentation(result.bed, Depth(depth)).solve().force
        assert force == pytest.approx(4.0 / 3.0 * UNIT.modulus * math.sqrt(same) * depth**1.5, rel=1.5e-3)
    radius = np.linspace(0.1, 0.2, 101)  # stiffnesses jump by a per cent as pixels enter: g is known in the mean
    assert np.mean(result.bed.gap(radius) * same / radius**2) == pytest.approx(1.0, abs=2e-3)
    assert result.misfit <= 1e-3
    assert result.bed.mindlin_ratio == pytest.approx(2.0 * 0.7 / 1.7, rel=1e-12)


def test_a_pyramid_is_springs_under_a_cone():
    """F = 0.737617 E* d^2 (boundary elements extrapolated, theory 1.3)."""
    x, y = places()
    pyramid = Topography(-np.maximum(np.abs(x), np.abs(y)), [1.0, 1.0])
    bed = reduce(pyramid, UNIT, 0.3)
    assert Indentation(bed, Depth(0.3)).solve().force == pytest.approx(0.737617 * UNIT.modulus * 0.09, rel=2e-3)


def maps():
    x, y = places()
    spheres = -np.minimum((x - 0.2) ** 2, (x + 0.2) ** 2) / 2.0 - y**2 / 2.0
    rough = random_topography(SelfAffine(0.8, 0.03, 1.0, 0.1), (96, 96), [1.0, 1.0], seed=2)
    leaning = -0.1 * x + 0.0 * y
    return {
        "two spheres": (Topography(spheres, [1.0, 1.0]), 0.04),
        "rough": (Topography(rough.heights, [1.0, 1.0]), 0.08),
        "leaning": (Topography(leaning, [1.0, 1.0]), 0.03),
    }


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ["two spheres", "rough", "leaning"])
def test_the_error_of_the_force_is_as_stated(name):
    """At depths that were not requested, against boundary elements at these very depths."""
    topography, deepest = maps()[name]
    result = Reduction(topography, UNIT, deepest, tolerance=2e-3).solve()
    assert result.misfit <= 2e-3
    depths = deepest * np.array([0.013, 0.11, 0.37, 0.59, 0.83, 1.0])
    exact = SurfaceContact(topography, UNIT, Depth(depths)).solve()
    springs = Indentation(result.bed, Depth(depths)).solve()
    assert np.max(np.abs(springs.force - exact.force)) <= 2e-3 * exact.force[-1]
    assert result.force[-1] == pytest.approx(exact.force[-1], rel=1e-5)
    assert np.all(np.diff(result.depth) > 0.0)


@pytest.mark.few(2)
@pytest.mark.parametrize("seed", range(4))
def test_the_error_of_random_surfaces_is_as_stated(seed):
    """Rough stamps and rough balls, from a few spots to full contact, at depths of chance."""
    rng = np.random.default_rng(seed)
    spectrum = SelfAffine(rng.uniform(0.3, 1.0), 0.02, 1.0, 0.06)
    heights = random_topography(spectrum, (64, 64), [1.0, 1.0], seed=seed).heights
    x, y = places(64)
    topography = Topography(heights - (0.2 * (x**2 + y**2) if seed % 2 else 0.0), [1.0, 1.0])
    deepest = float(np.mean(topography.gaps)) * rng.uniform(0.7, 1.2)
    result = Reduction(topography, UNIT, deepest).solve()
    depths = deepest * rng.uniform(0.02, 1.0, 8)
    exact = SurfaceContact(topography, UNIT, Depth(depths)).solve().force
    assert np.max(np.abs(Indentation(result.bed, Depth(depths)).solve().force - exact)) <= 1e-3 * result.force[-1]


@pytest.mark.slow
def test_a_smaller_tolerance_needs_more_contacts():
    topography, deepest = maps()["rough"]
    loose, tight = (Reduction(topography, UNIT, deepest, tolerance).solve() for tolerance in (1e-2, 1e-3))
    assert loose.depth.size < tight.depth.size
    assert tight.misfit <= 1e-3


def test_steps_are_the_points_of_the_solution():
    question = Reduction(paraboloid(), UNIT, 0.05, tolerance=1e-2)
    assert sorted(state.force for state in question.steps()) == question.solve().force.tolist()


@pytest.mark.parametrize(
    ("numbers", "error", "sentence"),
    [
        ({"topography": Topography(-(places()[0] ** 2 + places()[1] ** 2), [1.0, 1.0], periodic=True)}, InvalidInput,
         "periodic and has no finite stiffness radius; cut a part out"),
        ({"tolerance": 1.0}, InvalidInput, "tolerance is 1.0; give a number between"),
        ({"depth": -1.0}, InvalidInput, "depth is -1.0; it must be a positive, finite number in m"),
        ({"depth": [0.1, 0.2]}, InvalidInput, "it must be a positive, finite number in m"),
        ({"topography": "map"}, InvalidInput, "topography is a str"),
        ({"depth": 1e-4}, OutsideValidity, "pixels touch, which determines too little"),
        ({"topography": Topography(np.where(places()[0] ** 2 + places()[1] ** 2 < 0.09, 0.0, -0.2), [1.0, 1.0])},
         OutsideValidity, "hardly grows with the depth"),
    ],
)  # fmt: skip
def test_wrong_questions_are_refused(numbers, error, sentence):
    prescribed = {"topography": paraboloid(), "medium": UNIT, "depth": 0.05} | numbers
    with pytest.raises(error, match=sentence):
        Reduction(**prescribed).solve()


def test_too_many_contacts_are_refused(monkeypatch):
    monkeypatch.setattr(reducing, "MOST_CONTACTS", 6)
    with pytest.raises(NotConverged, match="contacts do not determine"):
        reduce(paraboloid(), UNIT, 0.05)


@pytest.fixture(scope="module")
def reduced():
    """The map of a ball of radius 1, and what is known of that ball in closed form."""
    return Reduction(paraboloid(), UNIT, 0.05).solve(), wk.Foundation(wk.Paraboloid(1.0), UNIT)


def test_friction_runs_on_a_height_map(reduced):
    result, exact = reduced
    turns = np.concatenate([np.linspace(0.0, 1.0, 21), np.linspace(1.0, -1.0, 41)[1:], np.linspace(-1.0, 1.0, 41)[1:]])
    path = wk.Path.through(wk.Depth(np.full(turns.size, 0.04)), wk.Shift(0.008 * turns))
    springs, ball = (wk.Tangential(bed, wk.Coulomb(0.3), path).solve() for bed in (result.bed, exact))
    assert np.allclose(springs.shear_force, ball.shear_force, atol=3e-3 * np.max(np.abs(ball.shear_force)))
    assert springs.dissipation[-1] == pytest.approx(ball.dissipation[-1], rel=1e-2)


def test_damping_runs_on_a_height_map(reduced):
    lost = [
        wk.FrictionDamping(bed, wk.Coulomb(0.3), wk.Depth(0.04), wk.Shift(3e-3)).solve().loss_per_cycle
        for bed in (reduced[0].bed, reduced[1])
    ]
    assert lost[0] == pytest.approx(lost[1], rel=2e-2)


def test_conduction_runs_on_a_height_map(reduced):
    pair = wk.ElectricalConductors(wk.ElectricalConductor(1e-8), wk.ElectricalConductor(2e-8))
    ohms = [
        wk.Constriction(wk.Indentation(bed, wk.Depth(0.04)), pair).solve().resistance
        for bed in (reduced[0].bed, reduced[1])
    ]
    assert ohms[0] == pytest.approx(ohms[1], rel=5e-3)
    assert ohms[1] == pytest.approx(3e-8 / (4.0 * 0.2), rel=1e-12)  # Holm


def test_a_height_map_is_pressed_into_rubber(reduced):
    """Lee and Radok: the map on another medium, though it was reduced on an elastic one."""
    rubber = wk.ViscoelasticHalfSpace(wk.StandardSolid(relaxed_shear=0.1, shear=0.4, relaxation_time=0.5))
    path = wk.Path(np.linspace(0.0, 1.0, 41), wk.Depth(0.04 * np.sin(np.linspace(0.0, 2.6, 41))))
    forces = [
        wk.ViscoelasticIndentation(bed, path, count=200).solve().force
        for bed in (reduced[0].on(rubber), wk.Foundation(wk.Paraboloid(1.0), rubber))
    ]
    assert np.allclose(forces[0], forces[1], atol=3e-3 * np.max(forces[1]))
    stiff = wk.HalfSpace(wk.Elastic(7.0, 0.2))
    one, other = (Indentation(bed, Depth(0.03)).solve() for bed in (reduced[0].bed, reduced[0].on(stiff)))
    assert other.force / one.force == pytest.approx(stiff.modulus / UNIT.modulus, rel=1e-5)
    with pytest.raises(InvalidInput, match="need homogeneous half-spaces"):
        reduced[0].on(wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0, 0.3), 1.0)], on=wk.Rigid()))


def test_what_the_springs_leave_out_is_stated(reduced):
    message = " ".join(note.statement for note in reduced[0].validity)
    assert "Between these solutions the force error is at most" in message
    assert "The true body and its pressure are not known" in message
