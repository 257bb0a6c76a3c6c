"""Elliptic contacts that wear a little: quadratures of Hertz' ellipse, balances, and the first wear of a ball."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import quad

import winkler as wk
from winkler.values.value import value

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
BODIES, LOAD = wk.CurvedBodies(20e-3, 5e-3), wk.Force(100.0)
SLIDER, TRACK = 1e-17, 1e-15
BOTH = wk.PairWear(wk.Archard(SLIDER), wk.Archard(TRACK))


def worn(bodies=BODIES, wear=BOTH, distance=1.0, **more):
    return wk.EllipticWear(bodies, PAIR, wear, LOAD, distance, **more).solve()


def half_ellipsoid(item):
    """The pressure of a half-ellipsoid that bears the load, in mpmath."""
    a, b = (mp.mpf(float(getattr(item.contact, f"{name}_semi_axis"))) for name in ("longitudinal", "lateral"))
    peak = 3 * mp.mpf(100) / (2 * mp.pi * a * b)
    return a, b, lambda x, y: peak * mp.sqrt(max(1 - (x / a) ** 2 - (y / b) ** 2, mp.mpf(0)))


@pytest.mark.parametrize("angle", [0.0, 0.4, 2.0, math.pi / 2, -7.0])
def test_a_track_is_the_pressure_along_the_sliding(angle):
    item = worn(angle=angle, passes=3.0)
    a, b, pressure = half_ellipsoid(item)
    cos, sin = mp.cos(angle), mp.sin(angle)
    for share in (0.0, 0.3, -0.9):
        t = share * mp.mpf(item.track_half_width)
        square, mixed = (cos / a) ** 2 + (sin / b) ** 2, t * cos * sin * (1 / b**2 - 1 / a**2)
        rest = 1 - t * t * ((sin / a) ** 2 + (cos / b) ** 2)
        middle, half = -mixed / square, mp.sqrt((mixed / square) ** 2 + rest / square)
        along = mp.quad(
            lambda u, t=t: pressure(u * cos - t * sin, u * sin + t * cos), [middle - half, middle, middle + half]
        )
        assert float(item.track(float(t))) == pytest.approx(3.0 * TRACK * float(along), rel=1e-13)
    assert item.track_depth == pytest.approx(3.0 * TRACK * 0.75 * 100.0 / item.track_half_width, rel=1e-14)


def test_the_slider_loses_rate_times_pressure_and_distance():
    item = worn(distance=2.0)
    a, b, pressure = half_ellipsoid(item)
    places = np.array([[0.0, 0.0], [0.5, 0.2], [-0.1, -0.9], [0.9, 0.9], [0.0, 1.1]]) * (float(a), float(b))
    expected = [2.0 * SLIDER * float(pressure(mp.mpf(x), mp.mpf(y))) for x, y in places.tolist()]
    np.testing.assert_allclose(item.worn(*places.T), expected, rtol=1e-13)
    assert item.worn_depth == pytest.approx(expected[0], rel=1e-14)


def test_what_is_worn_is_rate_times_force_times_distance():
    item = worn(distance=2.0, passes=4.0, angle=0.7)
    assert item.worn_volume == pytest.approx(SLIDER * 100.0 * 2.0, rel=1e-14)
    # on a track of the length L, n passes are a distance of n L
    assert item.track_area == pytest.approx(4.0 * TRACK * 100.0, rel=1e-14)
    half = item.track_half_width
    section = quad(item.track, -half, half, epsabs=0.0, epsrel=1e-12)[0]
    assert section == pytest.approx(item.track_area, rel=1e-11)
    np.testing.assert_array_equal(item.track([-1.01 * half, 1.01 * half]), 0.0)


def test_a_track_is_as_wide_as_the_ellipse():
    a, b = (float(getattr(worn().contact, f"{name}_semi_axis")) for name in ("longitudinal", "lateral"))
    assert worn(angle=0.0).track_half_width == b
    assert worn(angle=math.pi / 2).track_half_width == pytest.approx(a, rel=1e-15)
    turned = worn(wk.CurvedBodies(5e-3, 20e-3), angle=math.pi / 2 - 0.3)
    assert turned.track_half_width == pytest.approx(worn(angle=0.3).track_half_width, rel=1e-14)
    assert turned.track_depth == pytest.approx(worn(angle=0.3).track_depth, rel=1e-14)


def test_a_circle_begins_to_wear_as_the_ball_that_is_followed():
    """What differs from `SlidingWear`, which follows the pressure, falls with the worn share."""
    ball, law = wk.Foundation(wk.Paraboloid(10e-3), PAIR), wk.Archard(1e-14)
    unit = worn(wk.CurvedBodies(10e-3, 10e-3), law)
    off = []
    for share in (0.02, 0.01):
        item = worn(wk.CurvedBodies(10e-3, 10e-3), law, share / unit.worn_share)
        assert item.worn_share == pytest.approx(share, rel=1e-12)
        followed = wk.SlidingWear(ball, law, LOAD, [0.0, item.problem.distance], count=60).solve()
        assert item.worn_volume == pytest.approx(followed.worn_volume[-1], rel=1e-9)
        off.append(item.worn_depth / followed.worn_depth[-1] - 1.0)
    assert 0.4 < off[1] / off[0] < 0.6
    assert 0.3 < off[1] / 0.01 < 0.6


@value
class Squared:
    """Wear with the square of the pressure."""

    def depth_per_slip(self, pressure):
        return 1e-26 * pressure**2


def test_a_law_of_ones_own_is_integrated():
    item = worn(wear=wk.PairWear(Squared(), Squared()), passes=2.0)
    a, b, peak = item.contact.longitudinal_semi_axis, item.contact.lateral_semi_axis, item.contact.peak_pressure
    assert item.worn_depth == pytest.approx(1e-26 * peak**2, rel=1e-14)
    assert item.worn_volume == pytest.approx(1e-26 * peak**2 * math.pi * a * b / 2.0, rel=1e-13)
    assert item.track_depth == pytest.approx(2.0 * 1e-26 * peak**2 * 4.0 / 3.0 * a, rel=1e-13)
    assert float(item.track(0.6 * b)) == pytest.approx(item.track_depth * 0.8**3, rel=1e-13)


def test_one_law_alone_wears_the_slider():
    item = worn(wear=wk.Archard(SLIDER))
    assert item.worn_depth == worn().worn_depth
    assert (item.track_depth, item.track_area) == (0.0, 0.0)


def notes_on_wear(item):
    return [note for note in item.validity if note.assumption is wk.Assumption.WEAR]


@pytest.mark.parametrize(
    ("share", "standing"),
    [(9e-3, wk.Standing.ASYMPTOTIC), (0.09, wk.Standing.APPROXIMATE), (0.11, wk.Standing.OUTSIDE)],
)
def test_it_states_how_much_was_worn(share, standing):
    item = worn(distance=share / worn(wear=wk.Archard(SLIDER)).worn_share, wear=wk.Archard(SLIDER))
    first = notes_on_wear(item)[0]
    assert first.standing is standing
    assert ("SlidingWear" in first.statement) is (standing is wk.Standing.OUTSIDE)


def test_yield_without_friction_is_only_approximate():
    strong = wk.Elastic(210e9, 0.3, strength=5e9)
    problem = wk.EllipticWear(BODIES, wk.HalfSpace.between(strong, strong), BOTH, LOAD, 1.0)
    notes = [note for note in problem.solve().validity if note.assumption is wk.Assumption.ELASTIC]
    assert [note.standing for note in notes] == [wk.Standing.APPROXIMATE]


def test_passes_need_a_distance():
    a = worn().contact.longitudinal_semi_axis
    assert worn(distance=20.1 * a, passes=10.0).track_depth > 0.0
    with pytest.raises(wk.OutsideValidity, match="give a longer distance or fewer passes"):
        worn(distance=19.9 * a, passes=10.0)


@pytest.mark.parametrize(
    "wrong",
    [{"load": wk.Force(0.0)}, {"load": wk.Force([1.0, 2.0])}, {"distance": 0.0}, {"wear": 1.0}, {"passes": 0.0}],
)
def test_wrong_arguments_are_refused(wrong):
    given = {"bodies": BODIES, "medium": PAIR, "wear": BOTH, "load": LOAD, "distance": 1.0}
    with pytest.raises(wk.InvalidInput):
        wk.EllipticWear(**{**given, **wrong})


def test_slender_ellipses_lose_more_pressure_as_the_note_says():
    """A cylinder that is followed: what its pressure loses, over the approach of an ellipse of 1 : 100."""
    radius, law = 10e-3, wk.Archard(1e-14)
    line = wk.LineFoundation(wk.Paraboloid(radius), PAIR)
    at_rest = wk.LineIndentation(line, wk.LineForce(1e5)).solve()
    slender = wk.EllipticIndentation(wk.CurvedBodies(radius * 2.05e3, radius), PAIR, LOAD).solve()
    part = slender.depth / (slender.lateral_semi_axis**2 / (2.0 * radius))
    lost = 0.01 * float(at_rest.half_width) ** 2 / (2.0 * radius)
    distance = lost / (law.rate * float(at_rest.peak_pressure))
    states = wk.LineSlidingWear(line, law, wk.LineForce(1e5), [0.0, distance], count=100).solve().states
    fallen = 1.0 - states[1].pressure[0] / states[0].pressure[0]
    assert slender.problem.bodies.slenderness == pytest.approx(0.01, rel=0.1)
    assert 1.7 < part * fallen / 0.01 < 2.3


COATED = wk.CoatedHalfSpace((wk.Layer(wk.Elastic(420e9, 0.25), 20e-6),), STEEL, second=STEEL)
GRADED = wk.GradedHalfSpace(wk.PowerLawGraded(4e9, 1e-3, 0.3, 0.3))


@pytest.mark.parametrize("angle", [0.0, 0.7])
def test_on_layers_like_their_base_it_wears_as_on_a_half_space(angle):
    like = wk.CoatedHalfSpace((wk.Layer(STEEL, 20e-6),), STEEL, second=STEEL)
    load = wk.Force(5.0)
    found, plain = (
        wk.EllipticWear(BODIES, medium, BOTH, load, 1.0, angle=angle, passes=3.0).solve() for medium in (like, PAIR)
    )
    assert found.worn_depth == pytest.approx(plain.worn_depth, rel=found.contact.grid_error)
    assert found.worn_volume == pytest.approx(plain.worn_volume, rel=1e-13)
    assert found.track_area == pytest.approx(plain.track_area, rel=1e-13)
    assert found.track_half_width == pytest.approx(plain.track_half_width, rel=found.contact.edge_error)
    across = np.array([0.0, -0.4, 0.7]) * plain.track_half_width
    np.testing.assert_allclose(
        found.track(across), plain.track(across), atol=found.contact.edge_error * plain.track_depth, rtol=0.0
    )


@pytest.mark.slow
@pytest.mark.parametrize("medium", [COATED, GRADED], ids=["coated", "graded"])
def test_a_ball_on_other_media_loses_rate_times_the_pressure_of_the_springs(medium):
    """Round bodies pressed by pixels wear like the pressure of the one-dimensional foundation, projected by hand."""
    bodies, load = wk.CurvedBodies(10e-3, 10e-3), wk.Force(5.0)
    item = wk.EllipticWear(bodies, medium, BOTH, load, 1.0, angle=0.3, passes=2.0).solve()
    round_one = wk.Indentation(wk.Foundation(wk.Paraboloid(10e-3), medium), load).solve()
    a = round_one.radius
    r = a * np.array([0.0, 0.3, 0.6, 0.8])
    expected = SLIDER * wk.restore(round_one, r).pressure
    np.testing.assert_allclose(item.worn(r, 0.0 * r), expected, rtol=3e-3)
    np.testing.assert_allclose(item.worn(0.0 * r, -r), expected, rtol=3e-3)
    assert item.track_half_width == pytest.approx(a, rel=item.contact.edge_error)
    for t in (0.0, 0.5 * a):
        chord, turn = math.sqrt(a * a - t * t), 0.5 * math.pi * (np.arange(400) + 0.5) / 400
        pressure = wk.restore(round_one, np.hypot(chord * np.sin(turn), t)).pressure
        along = 2.0 * chord * float(np.sum(pressure * np.cos(turn))) * (0.5 * math.pi / 400)
        assert float(item.track(t)) == pytest.approx(2.0 * TRACK * along, rel=5e-3)
    half = 1.05 * item.track_half_width
    t = np.linspace(-half, half, 401)
    assert np.trapezoid(item.track(t), t) == pytest.approx(item.track_area, rel=2e-3)


def test_a_coating_that_is_worn_away_is_said():
    thin = wk.CoatedHalfSpace((wk.Layer(wk.Elastic(420e9, 0.25), 20e-9),), STEEL, second=STEEL)
    item = wk.EllipticWear(BODIES, thin, wk.Archard(SLIDER), wk.Force(5.0), 1.0).solve()
    (note,) = notes_on_wear(item)[:1]
    assert note.standing is wk.Standing.OUTSIDE
    assert "of its uppermost layer" in note.statement
