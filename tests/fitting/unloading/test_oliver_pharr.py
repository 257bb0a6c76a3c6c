"""Oliver and Pharr's reading: exact on exact elastic curves, honest about noise, and it refuses what it cannot read."""

from __future__ import annotations

import dataclasses
import math

import mpmath
import numpy as np
import pytest

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.unloading.contact_reading import CalibratedArea, intercept_factor, sample_young
from winkler.fitting.unloading.oliver_pharr import OliverPharr
from winkler.io.curves import read_curve
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

MODULUS = 70e9 / 0.91


def paraboloid(depth, radius=1e-6):
    return 4.0 / 3.0 * MODULUS * math.sqrt(radius) * depth**1.5


def cone(depth, half_angle=1.2):
    return 2.0 / math.pi * MODULUS * math.tan(half_angle) * depth**2


DEPTH = np.linspace(2e-7, 1e-9, 400)


@pytest.mark.parametrize("exponent", ["1.05", "1.2", "1.5", "1.8", "2", "2.5"])
def test_the_intercept_factor_to_many_digits(exponent):
    with mpmath.workdps(30):
        m = mpmath.mpf(exponent)
        ratio = mpmath.gamma(m / (2 * (m - 1))) / mpmath.gamma(1 / (2 * (m - 1)))
        exact = m * (1 - 2 * (m - 1) * ratio / mpmath.sqrt(mpmath.pi))
    assert intercept_factor(float(exponent)) == pytest.approx(float(exact), rel=1e-12)
    assert intercept_factor(1.0) == 1.0


@pytest.mark.parametrize(
    ("force", "profile", "exponent", "share"),
    [
        (paraboloid, wk.Paraboloid(1e-6), 1.5, 0.5),
        (cone, wk.Cone(half_angle=1.2), 2.0, 2.0 / math.pi),
        (cone, wk.AreaFunction((math.pi * math.tan(1.2) ** 2,)), 2.0, 2.0 / math.pi),
    ],
    ids=["paraboloid", "cone", "area function"],
)
def test_elastic_curves_are_read_exactly(force, profile, exponent, share):
    found = OliverPharr(ForceCurve(DEPTH, force(DEPTH)), profile).solve()
    assert found.exponent == pytest.approx(exponent, rel=1e-8)
    assert found.final_depth == pytest.approx(0.0, abs=1e-14)
    assert found.contact_depth == pytest.approx(share * 2e-7, rel=1e-8)
    assert found.stiffness == pytest.approx(exponent * force(2e-7) / 2e-7, rel=1e-8)
    assert found.modulus == pytest.approx(MODULUS, rel=1e-8)
    assert found.force == pytest.approx(force(2e-7), rel=1e-10)
    assert found.hardness == pytest.approx(found.force / found.area, rel=1e-12)


def test_a_residual_impression():
    """The same unloading, shifted: a sunken paraboloid of another size is read at its own area."""
    final, flat = 3e-7, 5e-8
    depth = np.linspace(final + flat, final + 1e-10, 400)
    force = 4.0 / 3.0 * MODULUS * math.sqrt(1e-6) * (depth - final) ** 1.5
    found = OliverPharr(ForceCurve(depth, force), wk.Cone(half_angle=1.2)).solve()
    stiffness = 2.0 * MODULUS * math.sqrt(1e-6 * flat)
    contact = depth[0] - 0.75 * force[0] / stiffness
    area = math.pi * (contact * math.tan(1.2)) ** 2
    assert found.final_depth == pytest.approx(final, rel=1e-8)
    assert found.contact_depth == pytest.approx(contact, rel=1e-8)
    assert found.modulus == pytest.approx(0.5 * math.sqrt(math.pi / area) * stiffness, rel=1e-8)


def test_frame_contact_point_and_shape_factor():
    force = cone(DEPTH)
    curve = ForceCurve(DEPTH + 3e-8 + force / 2e6, force, 2e6)
    found = OliverPharr(curve, wk.Cone(half_angle=1.2), contact_point=3e-8, shape_factor=1.034).solve()
    assert found.modulus == pytest.approx(MODULUS / 1.034, rel=1e-8)


@pytest.mark.slow
def test_errors_are_honest():
    """Of 30 noisy unloadings about 95 % lie within 1.96 standard errors; fewer than 24 once in a thousand tests."""
    force, inside = cone(DEPTH), np.zeros(3)
    for seed in range(30):
        noisy = force + 2e-3 * force[0] * np.random.default_rng(seed).standard_normal(400)
        found = OliverPharr(ForceCurve(DEPTH, noisy), wk.Cone(half_angle=1.2)).solve()
        truth = (2.0 * force[0] / DEPTH[0], MODULUS, force[0] / (math.pi * (math.tan(1.2) * 4e-7 / math.pi) ** 2))
        read = (found.stiffness, found.modulus, found.hardness)
        inside += np.abs(np.subtract(read, truth)) < 1.96 * found.standard_errors[[2, 5, 6]]
    assert inside.min() >= 24


def test_the_samples_modulus():
    diamond = wk.Elastic(1141e9, 0.07)
    pair = wk.HalfSpace.between(wk.Elastic(72e9, 0.17), diamond)
    assert sample_young(pair.modulus, 0.17, diamond) == pytest.approx(72e9, rel=1e-12)
    assert sample_young(MODULUS, 0.3, wk.Rigid()) == pytest.approx(70e9, rel=1e-12)
    with pytest.raises(OutsideValidity, match="leaves nothing for the sample"):
        sample_young(2e12, 0.3, diamond)


def test_what_cannot_be_read_is_refused():
    curve = ForceCurve(DEPTH, cone(DEPTH))
    with pytest.raises(InvalidInput, match="limits of the fitted part"):
        OliverPharr(curve, wk.Cone(half_angle=1.2), upper=0.3)
    with pytest.raises(InvalidInput, match="shape_factor is 0.0"):
        OliverPharr(curve, wk.Cone(half_angle=1.2), shape_factor=0.0)
    with pytest.raises(InvalidInput, match="has no unloading of at least 10 points"):
        OliverPharr(ForceCurve(DEPTH[::-1], cone(DEPTH[::-1])), wk.Cone(half_angle=1.2)).solve()
    with pytest.raises(InvalidInput, match="check signs and contact_point"):
        OliverPharr(dataclasses.replace(curve, force=-curve.force), wk.Cone(half_angle=1.2)).solve()
    with pytest.raises(InvalidInput, match="points lie between 0.4 and 0.98"):
        OliverPharr(curve.chosen(np.arange(0, 400, 35)), wk.Cone(half_angle=1.2)).solve()
    small = wk.Measured(np.linspace(0.0, 1e-8, 50), np.linspace(0.0, 1e-8, 50) / math.tan(1.2))
    with pytest.raises(OutsideValidity, match="beyond the tip, which is defined up to a radius of 1e-08 m"):
        OliverPharr(curve, small).solve()


# ------------------------------------------------------------------------------------------- holds, partial unloadings

TANGENT = math.tan(1.2)
PEAK, CREPT, FINAL = 1e-3, 212e-9, 180e-9
"""A peak of 1 mN: reached at 200 nm, held until 212 nm, and unloaded as (h - 180 nm)^1.5 over a cone."""
STIFFNESS = 1.5 * PEAK / (CREPT - FINAL)
CONTACT = CREPT - 0.75 * PEAK / STIFFNESS
PAIR = 0.5 * math.sqrt(math.pi) * STIFFNESS / (math.sqrt(math.pi) * TANGENT * CONTACT)


def played(*, noise=0.0, leg=400, held=200, partial=True, rest=300, timed=True, drift=0.0):
    """Return a test under a driven force: partial unloadings during loading, a hold that creeps, a hold at a tenth."""
    inward, depth, force = np.linspace(0.0, 1.0, leg), [], []
    for low, high in ((0.0, 0.4), (0.04, 0.7), (0.07, 1.0)) if partial else ((0.0, 1.0),):
        path = low + (high - low) * inward
        peaks = np.maximum(path, low * 10.0)  # below the peak before, the same unloading is gone back
        depth.append(200e-9 * np.sqrt(peaks) * (0.9 + 0.1 * (path / np.maximum(peaks, 1e-9)) ** (2.0 / 3.0)))
        force.append(path)
        if high < 1.0:
            down = high * (1.0 - 0.9 * inward[1:])
            depth.append(200e-9 * math.sqrt(high) * (0.9 + 0.1 * (down / high) ** (2.0 / 3.0)))
            force.append(down)
    depth.append(200e-9 + (CREPT - 200e-9) * (1.0 - np.exp(-np.arange(1, held + 1) / (0.05 * held))))
    force.append(np.ones(held))
    down = np.linspace(1.0, 0.1, leg)[1:]
    depth.append(FINAL + (CREPT - FINAL) * down ** (1.0 / 1.5))
    force.append(down)
    depth.append(np.full(rest, depth[-1][-1]))
    force.append(np.full(rest, 0.1))
    down = np.linspace(0.1, 0.0, leg // 9)[1:]
    depth.append(FINAL + (CREPT - FINAL) * down ** (1.0 / 1.5))
    force.append(down)
    position, load = np.concatenate(depth), PEAK * np.concatenate(force)
    load = load + noise * PEAK * np.random.default_rng(5).standard_normal(load.size)
    time = 0.01 * np.arange(load.size)
    return ForceCurve(position + drift * time, load, time=time if timed else np.zeros(0))


KINDS = ["loading", "partial unloading"] * 2 + ["loading", "hold", "last unloading", "hold", "last unloading"]


def test_a_hold_at_the_peak_does_not_enter_the_fit():
    curve = played()
    assert [segment.kind.value for segment in curve.segments] == KINDS
    found = OliverPharr(curve, wk.Cone(half_angle=1.2)).solve()
    assert found.force == pytest.approx(PEAK, rel=1e-12)
    assert found.depth == pytest.approx(CREPT, rel=1e-8)
    assert found.exponent == pytest.approx(1.5, rel=1e-6)
    assert found.final_depth == pytest.approx(FINAL, rel=1e-6)
    assert found.stiffness == pytest.approx(STIFFNESS, rel=1e-6)
    assert found.modulus == pytest.approx(PAIR, rel=1e-6)
    assert found.hardness == pytest.approx(PEAK / (math.pi * (TANGENT * CONTACT) ** 2), rel=1e-6)


@pytest.mark.parametrize("noise", [1e-4, 1e-3])
def test_noise_moves_the_reading_by_its_errors(noise):
    found = OliverPharr(played(noise=noise), wk.Cone(half_angle=1.2)).solve()
    assert found.force == pytest.approx(PEAK, rel=noise)
    assert abs(found.modulus - PAIR) < 4.0 * found.standard_errors[5]
    assert found.modulus == pytest.approx(PAIR, rel=20.0 * noise)


def test_thermal_drift_moves_no_segment():
    """0.5 nm/s over a test of 30 s, more than the hold creeps."""
    curve = played(drift=0.5e-9)
    assert [segment.kind.value for segment in curve.segments] == KINDS


def test_the_partial_unloadings_do_not_count_as_loading():
    curve = played()
    inward = curve.approach
    assert np.all(np.diff(curve.force[curve.direction > 0.0]) > -PEAK)
    assert inward.count == pytest.approx(3 * 400, abs=10)
    assert np.count_nonzero(curve.direction < 0.0) == pytest.approx(3 * 400 + 400 // 9, abs=12)


def test_thirty_points_a_leg_keep_their_summit():
    """Without a column of segments; the summit itself once fell between loading and unloading, -3.4 % in depth."""
    up = np.linspace(0.0, 1.0, 30)
    share = np.concatenate([up, up[-2::-1]])
    depth = np.where(np.arange(59) < 30, 2e-7 * np.sqrt(share), 1.7e-7 + 0.3e-7 * share ** (1.0 / 1.5))
    found = OliverPharr(ForceCurve(depth, PEAK * share), wk.Cone(half_angle=1.2)).solve()
    stiffness = 1.5 * PEAK / 0.3e-7
    area = math.pi * (TANGENT * (2e-7 - 0.75 * PEAK / stiffness)) ** 2
    assert found.depth == 2e-7
    assert found.force == pytest.approx(PEAK, rel=1e-8)
    assert found.modulus == pytest.approx(0.5 * math.sqrt(math.pi / area) * stiffness, rel=1e-7)


def test_stated_segments_are_read():
    """Whoever states the hold as part of the unloading reads what such a fit gives: another number."""
    curve = played()
    first = curve.segments[-4].first
    stated = curve.with_segments([("loading", 0), ("unloading", first)])
    wrong = OliverPharr(stated, wk.Cone(half_angle=1.2), upper=1.0).solve()
    assert abs(wrong.modulus / PAIR - 1.0) > 0.02
    again = curve.with_segments([(part.kind.value, part.first) for part in curve.segments])
    assert OliverPharr(again, wk.Cone(half_angle=1.2)).solve().modulus == pytest.approx(PAIR, rel=1e-6)


@pytest.mark.parametrize(("length", "load"), [(1e-6, 1e-6), (1e6, 1e3), (1e9, 1e-9)])
def test_no_length_and_no_force_is_absolute(length, load):
    curve = played()
    scaled = dataclasses.replace(curve, position=length * curve.position, force=load * curve.force)
    found = OliverPharr(scaled, wk.Cone(half_angle=1.2)).solve()
    assert found.modulus * length**2 / load == pytest.approx(PAIR, rel=1e-6)
    assert found.contact_depth / length == pytest.approx(CONTACT, rel=1e-6)
    again = OliverPharr(ForceCurve(scaled.position, scaled.force), wk.Cone(half_angle=1.2)).solve()
    assert again.modulus == pytest.approx(found.modulus, rel=1e-12)


def test_a_reading_speaks_of_what_it_assumes():
    found = OliverPharr(played(), wk.Cone(half_angle=1.2)).solve()
    assert {note.assumption for note in found.validity} == OliverPharr.assumptions


def test_a_real_curve_with_a_hold(shared_data):
    """Steel at 3.000 mN for 5 s: scipy's fit of the rows behind 17.06 s, the hold left out by hand, says the same."""
    from scipy.optimize import curve_fit

    path = shared_data / "nanoindentation" / "RobinSteel0000LC.txt"
    rows = [line.split("\t")[:3] for line in path.read_text(encoding="latin1").splitlines()[5:] if line.strip()]
    depth, force, time = np.array(rows, dtype=float).T
    out = (time > 17.07) & (force < 0.98 * 3000.0) & (force > 0.4 * 3000.0)
    law = curve_fit(lambda h, b, final, m: b * (h - final) ** m, depth[out], force[out], p0=(60.0, 138.0, 1.5))[0]
    deepest = float(np.median(depth[(time > 16.5) & (time < 17.05)]))
    slope = law[0] * law[2] * (deepest - law[1]) ** (law[2] - 1.0) * 1e3
    contact = deepest * 1e-9 - float(intercept_factor(law[2])) * 3e-3 / slope
    area = wk.Berkovich().half_angle
    modulus = 0.5 * slope / (math.tan(area) * contact)
    found = OliverPharr(read_curve(path), wk.Berkovich()).solve()
    assert found.force == pytest.approx(3.000e-3, rel=1e-4)  # 3.064 mN once
    assert found.modulus == pytest.approx(modulus, rel=0.01)  # 6 % more once
    assert found.fitted_force == pytest.approx(3.000e-3, rel=0.02)


# ------------------------------------------------------------------------------------------------------------ validity


def statements(found, word):
    """Return standing and statement of the notes that begin with a word."""
    return [(note.standing, note.statement) for note in found.validity if note.statement.startswith(word)]


def impression(share, exponent=1.5, points=400, creep=0.0):
    """Return a loading, a hold of 5 s, and an unloading in 5 s with h_f/h and m as given; creep in m/s while held."""
    path = np.linspace(1.0, 0.0, points)[1:]
    deep = 2e-7
    depth = np.concatenate(
        [
            deep * np.sqrt(path[::-1]),
            deep + creep * np.linspace(0.0, 5.0, points),
            deep + 5.0 * creep - deep * (1.0 - share) * (1.0 - path ** (1.0 / exponent)),
        ]
    )
    force = PEAK * np.concatenate([path[::-1], np.ones(points), path])
    return ForceCurve(depth, force, time=np.linspace(0.0, 15.0, force.size))


def read(curve, profile=None, **options):
    return OliverPharr(curve, profile or wk.Cone(half_angle=1.2), **options).solve()


@pytest.mark.parametrize(("share", "standing"), [(0.6, Standing.ASYMPTOTIC), (0.85, Standing.OUTSIDE)])
def test_pile_up_is_shouted(share, standing):
    ((found, sentence),) = statements(read(impression(share)), "Pile-up")
    assert found is standing
    assert f"{share:.2f} of the maximum depth" in sentence


@pytest.mark.parametrize(
    ("creep", "standing"),
    [(0.0, Standing.ASYMPTOTIC), (5e-10, Standing.APPROXIMATE), (2e-9, Standing.OUTSIDE)],
)
def test_creep_is_classified_by_the_rates(creep, standing):
    """S dh/dt over dF/dt by hand: dF/dt = 1 mN in 5 s, S = 1.5 F/(h - h_f)."""
    found = read(impression(0.6, creep=creep))
    ((stated, sentence),) = statements(found, "Creep")
    assert stated is standing
    share = creep * 1.5 * PEAK / (0.4 * 2e-7) / (PEAK / 5.0)
    number = float(sentence.split("stiffness by ")[1].split("%")[0]) / 100.0
    assert number == pytest.approx(share, abs=0.02 * share + 6e-4)


def test_without_times_or_hold_creep_is_not_known():
    (without,) = statements(read(dataclasses.replace(impression(0.6), time=np.zeros(0))), "Creep")
    assert without[0] is Standing.APPROXIMATE
    assert "are not known" in without[1]
    (still,) = statements(read(ForceCurve(DEPTH, cone(DEPTH), time=np.linspace(0.0, 1.0, 400))), "Creep")
    assert "are not known" in still[1]


@pytest.mark.parametrize(
    ("exponent", "standing"),
    [(1.4, Standing.ASYMPTOTIC), (2.0, Standing.APPROXIMATE), (1.1, Standing.APPROXIMATE), (3.0, Standing.OUTSIDE)],
)
def test_unusual_exponents(exponent, standing):
    ((found, _),) = statements(read(impression(0.6, exponent=exponent)), "Exponent")
    assert found is standing


def test_a_law_that_misses_the_peak():
    """An unloading with a kink: its lower part is another power law than its upper one."""
    curve = impression(0.6)
    bent = curve.position - 3e-9 * (curve.force < 0.9 * PEAK) * (np.arange(curve.count) > 800)
    found = read(dataclasses.replace(curve, position=bent), upper=0.85)
    ((standing, sentence),) = statements(found, "Peak")
    assert standing is Standing.OUTSIDE
    assert "differs from the force measured at the peak" in sentence
    assert statements(read(curve), "Peak") == []


def test_what_is_known_of_the_area():
    polynomial = (math.pi * TANGENT**2,)
    for tip, standing, words in [
        (wk.Cone(half_angle=1.2), Standing.APPROXIMATE, "ideal Cone"),
        (wk.AreaFunction(polynomial), Standing.APPROXIMATE, "depths of its calibration are not stated"),
        (CalibratedArea(polynomial, 1e-8, 1e-6), Standing.ASYMPTOTIC, "was calibrated from 10 nm to 1 µm"),
        (CalibratedArea(polynomial, 1e-8, 1e-7), Standing.OUTSIDE, "is extrapolated"),
        (CalibratedArea(polynomial, 2e-7, 1e-6), Standing.OUTSIDE, "is extrapolated"),
    ]:
        found = read(impression(0.6), tip)
        ((stated, sentence),) = statements(found, "Area")
        assert stated is standing
        assert words in sentence


def test_an_area_that_shrinks_at_the_contact_depth():
    shrinking = statements(read(impression(0.6), CalibratedArea((-14.0, 4e-6))), "Area")
    assert shrinking[0][0] is Standing.OUTSIDE
    assert "decreases at the contact depth" in shrinking[0][1]


def test_few_points():
    ((found, sentence),) = statements(read(impression(0.6, points=40)), "Points")
    assert found is Standing.APPROXIMATE
    assert "fewer than 50 points" in sentence
    ((found, _),) = statements(read(impression(0.6)), "Points")
    assert found is Standing.ASYMPTOTIC
