"""Sliding wear on layers: limits without layers, rings of even pressure by Hankel integrals, and a layer that wears."""

import math

import numpy as np
import pytest
from layered_rings_by_hankel import Discs, ball, bonded_on_rigid, flat_pin, sliding_on_elastic

import winkler as wk
from winkler.foundation.bed import PressedSprings

STEEL = wk.Elastic(210e9, 0.3)
POLYMER = wk.Elastic(3e9, 0.4)
THICK = 20e-6
RATE = 1e-13
BONDED = wk.CoatedHalfSpace([wk.Layer(POLYMER, THICK)], on=wk.Rigid())
SLIDING = wk.SlidingFilm([wk.Layer(POLYMER, THICK)], on=wk.Elastic(30e9, 0.3))
BASE_RATIO = SLIDING.modulus * (1.0 - 0.3**2) / 30e9
DISCS = {
    "bonded": (BONDED, Discs(bonded_on_rigid(0.4), THICK, BONDED.modulus)),
    "sliding": (SLIDING, Discs(sliding_on_elastic(BASE_RATIO), THICK, SLIDING.modulus)),
}


def worn(profile, medium, force, distance, count=60, **more):
    return wk.SlidingWear(
        wk.Foundation(profile, medium), wk.Archard(RATE), wk.Force(force), distance, count=count, **more
    ).solve()


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    ("medium", "plain"),
    [
        (wk.CoatedHalfSpace([wk.Layer(STEEL, 2e-6)], on=STEEL, second=STEEL), wk.HalfSpace(STEEL, STEEL)),
        (wk.CoatedHalfSpace([wk.Layer(STEEL, 1e4)], on=POLYMER, second=STEEL), wk.HalfSpace(STEEL, STEEL)),
    ],
    ids=["alike", "thick"],
)
def test_without_contrast_it_is_the_half_space(medium, plain):
    for profile, force, distance in ((wk.Paraboloid(1e-3), 1.0, 1e-4), (wk.FlatPunch(1e-4), 10.0, 0.1)):
        ours, other = (worn(profile, body, force, np.array([0.0, distance])) for body in (medium, plain))
        for field in ("depth", "radius", "worn_volume", "worn_depth"):
            np.testing.assert_allclose(getattr(ours, field), getattr(other, field), rtol=1e-6)
        last, same = ours.states[-1], other.states[-1]
        np.testing.assert_allclose(last.pressure, same.pressure, atol=1e-6 * float(np.max(same.pressure)))


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", DISCS)
def test_a_flat_pin_wears_as_rings_of_even_pressure_do(name):
    medium, discs = DISCS[name]
    radius, force, count = 40e-6, 1.0, 60
    run = worn(wk.FlatPunch(radius), medium, force, np.array([1e-2, 0.1, 30.0]), count=count)
    edges = radius * np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, count + 1))
    for state, most in zip(run.states[:2], (4e-3, 1e-3), strict=True):
        r, pressure, lost = flat_pin(discs, edges, force, RATE, state.elapsed)
        inner = r < 0.9 * radius
        ours = np.interp(r**2, state.radii**2, state.pressure)
        np.testing.assert_allclose(ours[inner], pressure[inner], rtol=1e-3)
        np.testing.assert_allclose(np.interp(r**2, state.radii**2, state.worn), lost, rtol=most)
    # in the end: what an even pressure leaves of the surface
    last, even = run.states[-1], force / (math.pi * radius**2)
    np.testing.assert_allclose(last.pressure, even, rtol=1e-5)
    bulge = even * (discs([0.0], [radius]) - discs(last.radii, [radius]))[:, 0]
    np.testing.assert_allclose(last.worn - last.worn[0], bulge, atol=7e-3 * bulge[-1])


@pytest.mark.parametrize("name", DISCS)
def test_a_ball_wears_as_rings_of_even_pressure_do(name):
    medium, discs = DISCS[name]
    curvature, force, distance = 1e-3, 0.05, 0.05
    run = worn(wk.Paraboloid(curvature), medium, force, np.array([0.0, distance]))
    first, last = run.states
    assert last.worn_depth > 0.6 * first.depth
    edges = np.linspace(0.0, last.radii[-1], 46)
    r, pressure, lost = ball(discs, edges, curvature, force, RATE, distance, 40)
    inner = r < 0.85 * last.radius
    np.testing.assert_allclose(np.interp(r**2, last.radii**2, last.pressure)[inner], pressure[inner], rtol=5e-3)
    np.testing.assert_allclose(np.interp(r**2, last.radii**2, last.worn), lost, atol=1e-2 * float(np.max(lost)))


HARD = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(400e9, 0.2), 2e-6)], on=wk.Elastic(70e9, 0.3), second=STEEL)
STACK = wk.StackedHalfSpace([wk.StackLayer(POLYMER, 5e-6, False), wk.StackLayer(STEEL, 2e-6)], on=POLYMER)
GRADED = wk.DepthGradedHalfSpace(wk.ExponentialGrading(1e9, 3e9, depth_scale=1e-5, poisson=0.3), tolerance=1e-4)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("medium", [HARD, STACK, GRADED], ids=["hard", "stack", "graded"])
def test_the_volume_is_rate_times_force_times_distance_on_layers(medium):
    run = worn(wk.Paraboloid(1e-3), medium, 0.1, np.array([1e-3, 5e-3]), count=30)
    np.testing.assert_allclose(run.worn_volume, RATE * 0.1 * run.distance, rtol=1e-10)
    # the body above wears, and the layers do not
    np.testing.assert_allclose(run.states[-1].second_volume, run.worn_volume[-1], rtol=1e-14)
    assert run.states[-1].first_volume == 0.0


@pytest.mark.slow
def test_a_film_much_thinner_than_the_contact():
    # springs that bear p = E* u / h each by itself: f' = kappa p at a steady depth decays as exp(-kappa E* s / h)
    film = wk.SlidingFilm([wk.Layer(POLYMER, 1e-7)], on=wk.Rigid())
    radius, depth = 40e-6, 1e-9
    bed = wk.Foundation(wk.FlatPunch(radius), film)
    length = 1e-7 / (RATE * film.modulus)
    run = wk.SlidingWear(bed, wk.Archard(RATE), wk.Depth(depth), length * np.array([0.0, 0.5, 1.0]), count=40).solve()
    inner = run.states[0].radii < 0.9 * radius
    start = film.modulus * depth / 1e-7
    for state in run.states:
        # each jump errs by a thousandth of the depth
        expected = start * math.exp(-state.elapsed / length)
        np.testing.assert_allclose(state.pressure[inner], expected, atol=2e-3 * start)


@pytest.mark.slow
def test_a_layer_that_wears_is_followed_up_to_a_part_of_its_thickness():
    film = wk.SlidingFilm([wk.Layer(POLYMER, 1e-6)], on=wk.Rigid())
    force, radius = 1.0, 1e-4
    step = 1e-6 * math.pi * radius**2 / (RATE * force)  # wears the layer away, were the pressure even
    problem = wk.SlidingWear(
        wk.Foundation(wk.FlatPunch(radius), film),
        wk.Archard(RATE),
        wk.Force(force),
        step * np.array([0.01, 0.03, 0.2]),
        count=40,
        layer_wears=True,
    )
    reached = []

    def advance():
        for state in problem.steps():
            reached.append(state)

    with pytest.raises(wk.OutsideValidity, match=r"5 per cent of the uppermost layer \(1e-06 m\) is worn off"):
        advance()
    assert [state.elapsed for state in reached] == list(problem.goals[:2])
    assert reached[-1].worn_depth > 0.03e-6
    assert reached[-1].second_volume == 0.0
    assert reached[-1].first_volume == pytest.approx(RATE * force * problem.goals[1], rel=1e-10)
    # a thin film that slides is a bed of springs, k = pi a^2 E* / h, but for its rim
    solution = problem.gathered(reached)
    share = reached[-1].worn_depth / 1e-6
    (stated,) = (note for note in solution.validity if "wear of the uppermost layer is" in note.statement)
    expected = 100.0 * share / (1.0 - share)
    stiffer = float(stated.statement.split("contact would be ")[1].split(" per cent stiffer")[0])
    assert stiffer == pytest.approx(expected, rel=0.03)


def test_which_body_wears_does_not_change_the_contact():
    one, other = (
        worn(wk.FlatPunch(1e-4), BONDED, 1.0, np.array([0.01, 0.02]), count=40, layer_wears=wears)
        for wears in (False, True)
    )
    np.testing.assert_array_equal(one.depth, other.depth)
    np.testing.assert_array_equal(one.states[-1].second_worn, other.states[-1].first_worn)
    assert any("Only the body without layers wears" in note.statement for note in one.validity)


@pytest.mark.slow
def test_a_march_on_layers_goes_on_with_the_same_numbers():
    bed = wk.Foundation(wk.Paraboloid(1e-3), BONDED)
    problem = wk.SlidingWear(bed, wk.Archard(RATE), wk.Force(0.05), np.array([0.01, 0.1, 0.4]), count=20)
    whole = list(problem.steps())
    assert whole[-1].radii[-1] > 1.4 * whole[0].radii[-1]
    assert list(problem.steps(start=whole[0])) == whole[1:]


def test_what_has_no_layer_is_refused():
    for medium in (wk.HalfSpace(STEEL, STEEL), GRADED):
        with pytest.raises(wk.InvalidInput, match="layer_wears is True, and a .* has no layers"):
            worn(wk.Paraboloid(1e-3), medium, 1.0, 1.0, layer_wears=True)


def bodies_below():
    """Contrast and thickness of layers, and gradings that soften and stiffen."""
    for contrast, thickness in ((0.1, 0.1), (0.1, 0.03), (100.0, 0.03)):
        layers = [wk.Layer(wk.Elastic(1.0, 0.3), thickness)]
        yield pytest.param(wk.CoatedHalfSpace(layers, on=wk.Elastic(contrast, 0.3)), id=f"{contrast}-{thickness}")
    for contrast in (0.1, 10.0):
        grading = wk.ExponentialGrading(1.0, contrast, depth_scale=1.0, poisson=0.3)
        yield pytest.param(wk.DepthGradedHalfSpace(grading), id=f"grading-{contrast}", marks=pytest.mark.long)


@pytest.mark.slow
@pytest.mark.parametrize("medium", list(bodies_below()))
@pytest.mark.parametrize("count", [50, 200])
def test_before_wear_rings_press_in_the_middle_as_beside_it(medium, count):
    """Too few points in the innermost cells had left a peak of the pressure there, which grew with finer rings."""
    bed = wk.Foundation(wk.Paraboloid(1.0), medium)
    pressed = wk.Indentation(bed, wk.Radius(3.0)).solve()
    rig = {"wear": wk.Archard(1.0), "count": count, "law": wk.Coulomb(0.4), "cycles": [0.0, 1e-9]}
    force = float(pressed.force)
    fresh = wk.FrettingWear(bed, normal=wk.Force(force), amplitude=wk.ShearForce(0.1 * force), **rig).solve().states[-1]
    inside = fresh.radii < 0.8 * pressed.radius
    expected = medium.pressure(PressedSprings(bed, float(pressed.depth), float(pressed.radius)), fresh.radii[inside])
    np.testing.assert_allclose(fresh.pressure[inside], expected, atol=1e-2 * expected[0])
