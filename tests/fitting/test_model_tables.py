"""Tables that the models of one fit share give the forces of each model alone, whatever was fitted before."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.elastic.contact import states_for
from winkler.fitting.elastic.depth_response import HomogeneousResponse
from winkler.fitting.elastic.film_tables import FilmTables
from winkler.fitting.elastic.model_tables import EACH_ANEW, HomogeneousTables
from winkler.fitting.elastic.task import tables_for
from winkler.fitting.fit import fit
from winkler.fitting.varied import NATURAL_BOUNDS, parameters_of

R = 5e-6
FILM = "bed.medium.layers[0].solid.young"


def on_half_space(young: float) -> wk.Indentation:
    return wk.Indentation(wk.Foundation(wk.Paraboloid(R), wk.HalfSpace.between(wk.Elastic(young, 0.5))), wk.Depth(0.0))


def on_film(young: float, thickness: float, poisson: float = 0.45, depth=0.0) -> wk.Indentation:
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, poisson), thickness)], on=wk.Elastic(1e6, 0.4))
    return wk.Indentation(wk.Foundation(wk.Paraboloid(R), film), wk.Depth(depth))


@pytest.mark.parametrize("spring", [np.inf, 0.05, 5.0])
def test_one_table_for_all_moduli_gives_hertz(spring):
    tables, name = HomogeneousTables(on_half_space(3e4).bed), "bed.medium.first.young"
    for young, deepest in ((1e4, 1e-6), (3e2, 5e-7), (7e5, 1e-6), (2e4, 4e-6)):
        depth = np.linspace(0.0, deepest, 50)[1:]
        force = 4.0 / 3.0 * young / 0.75 * np.sqrt(R) * depth**1.5
        place = depth + force / spring
        response = tables.response(states_for(on_half_space(young)), 1.0 / spring, float(place[-1]))
        found = response.opening(place, np.inf)
        assert found.force == pytest.approx(force, rel=1e-8)
        assert found.radius == pytest.approx(np.sqrt(R * depth), rel=1e-8)
        slope = 1.5 * force / depth
        assert found.slope == pytest.approx(slope / (1.0 + slope / spring), rel=1e-6)
        known = tables.known({name: young}, 1.0 / spring, float(place[-1]))
        assert known.closing(place).force == pytest.approx(force, rel=1e-8)
        stiffer = tables.known({name: 1.001 * young}, 1.0 / spring, float(place[-1]))
        assert known.change(stiffer, found) == pytest.approx(1e-3 * force / (1.0 + slope / spring), rel=1e-6)


@pytest.mark.parametrize("spring", [np.inf, 0.02])
@pytest.mark.parametrize(
    "profile", [wk.Sphere(R), wk.Cone(0.3), wk.PowerLaw(1e17, 4.0), wk.PowerLaw(100.0, 1.5)], ids=repr
)
def test_forces_over_the_depth_are_those_of_the_radii(profile, spring):
    """From the surface on: d = g(a) and F = 2 E* (a g - the integral of g) of a hundred radii, and k = 2 E* a."""
    modulus, radius = 1e4 / 0.75, 1e-6 * np.concatenate([np.geomspace(1e-6, 1e-2, 20), np.linspace(0.02, 3.0, 80)])
    model = wk.Indentation(wk.Foundation(profile, wk.HalfSpace.between(wk.Elastic(1e4, 0.5))), wk.Depth(0.0))
    depth = profile.gap(radius)
    force = 2.0 * modulus * (radius * depth - profile.gap_integral(radius))
    position = depth + force / spring
    response = HomogeneousTables(model.bed).response(states_for(model), 1.0 / spring, float(position[-1]))
    assert isinstance(response, HomogeneousResponse)
    found = response.opening(position, np.inf)
    assert found.force == pytest.approx(force, rel=1e-7, abs=1e-11 * force[-1])
    assert found.radius == pytest.approx(radius, rel=1e-6, abs=1e-8 * radius[-1])
    stiffness = 2.0 * modulus * radius
    assert found.slope == pytest.approx(stiffness / (1.0 + stiffness / spring), rel=1e-6, abs=1e-8 * stiffness[-1])


@pytest.mark.parametrize("profile", [wk.FlatPunch(R), wk.TruncatedCone(0.3, 1e-6)], ids=repr)
def test_a_profile_with_an_edge_keeps_its_table_of_radii(profile):
    model = wk.Indentation(wk.Foundation(profile, wk.HalfSpace.between(wk.Elastic(1e4, 0.5))), wk.Depth(0.0))
    tables = HomogeneousTables(model.bed)
    assert not isinstance(tables.response(states_for(model), 0.0, 1e-6), HomogeneousResponse)
    assert tables.known({}, 0.0, 1e-6) is None


SLOW = pytest.mark.slow


@pytest.mark.slow
@pytest.mark.parametrize(
    ("ratio", "thickness"),
    [
        (100.0, 2e-6),
        pytest.param(0.01, 2e-6, marks=SLOW),
        pytest.param(0.01, 2e-4, marks=SLOW),
        pytest.param(0.01, 2e-7, marks=SLOW),
        pytest.param(100.0, 2e-7, marks=SLOW),
    ],
)
def test_films_between_moduli_have_the_forces_of_each_film_solved_alone(ratio, thickness):
    """Reference: the problem's own solver, which tabulates flat punches of all radii of one film."""
    young = 1e6 * ratio
    tables = FilmTables(on_film(young, thickness), FILM)
    depth = np.linspace(0.0, 1e-6, 12)[1:]
    for factor in (1.0, 0.3, 4.0):
        found = tables.response(states_for(on_film(factor * young, thickness)), 0.0, 1e-6).closing(depth)
        alone = on_film(factor * young, thickness, depth=depth).solve()
        assert found.force == pytest.approx(alone.force, rel=2e-5)
        assert found.radius == pytest.approx(alone.radius, rel=2e-5)


@SLOW
def test_a_thin_film_on_a_stiff_body_has_the_forces_of_an_elastic_foundation():
    """F = pi R M d^2 / h with the confined modulus M, in the limit of a film thin against the contact."""
    young, poisson, thickness, depth = 1e3, 0.3, 1e-8, 1e-9
    rigid = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, poisson), thickness)], on=wk.Rigid())
    model = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), rigid), wk.Depth(0.0))
    confined = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
    tables = FilmTables(model, FILM)
    found = tables.response(states_for(model), 0.0, depth).closing(np.array([depth]))
    assert found.force[0] == pytest.approx(np.pi * confined * depth**2 / thickness, rel=2e-3)
    assert tables.rough(states_for(model), depth)[0] == pytest.approx(found.force[0], rel=0.05)


def test_which_fits_share_tables():
    def of(model, *names):
        scales = {"contact_point": 1e-6}
        return tables_for(model, parameters_of(model, dict.fromkeys(names, ()), scales, NATURAL_BOUNDS))

    assert type(of(on_half_space(1e4), "bed.medium.first.young", "contact_point")) is HomogeneousTables
    assert of(on_half_space(1e4), "bed.profile.curvature_radius") is EACH_ANEW
    assert type(of(on_film(1e6, 1e-6), FILM, "contact_point")) is FilmTables
    assert of(on_film(1e6, 1e-6), FILM, "bed.medium.layers[0].thickness") is EACH_ANEW


def test_a_film_beyond_its_profile_is_solved_alone():
    """A ball pressed nearly to its equator has no table; the forces are those of its own solver."""
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1e6, 0.3), 1e-4)], on=wk.Elastic(1e7, 0.3))
    bed = wk.Foundation(wk.Sphere(1e-6), film)
    model = wk.Indentation(bed, wk.Depth(0.0))
    found = FilmTables(model, FILM).response(states_for(model), 0.0, 1e-6).closing(np.array([1e-6]))
    assert found.force[0] == pytest.approx(wk.Indentation(bed, wk.Depth(np.array([1e-6]))).solve().force[0], rel=1e-7)


def test_no_fit_depends_on_those_before_it():
    random = np.random.default_rng(7)
    depth = np.linspace(-1e-6, 1e-6, 200)
    curves = [
        ForceCurve(depth, 4.0 / 3.0 * e / 0.75 * np.sqrt(R) * np.maximum(depth, 0.0) ** 1.5
                   + 1e-11 * random.standard_normal(200))
        for e in (1e3, 5e4, 2e4)
    ]  # fmt: skip
    free = ["bed.medium.first.young", "contact_point", "baseline"]
    forward = [fit(curve, on_half_space(1e4), free=free).values for curve in curves]
    backward = [fit(curve, on_half_space(1e4), free=free).values for curve in curves[::-1]][::-1]
    assert all(np.array_equal(one, other) for one, other in zip(forward, backward, strict=True))
