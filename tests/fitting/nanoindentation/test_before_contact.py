"""What comes before the contact decides nothing: air of any length, a lift-off, a preload that is left."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from nano_worlds import SILICA, Machine, indentation

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.nanoindentation.measurement import Nanoindentation
from winkler.fitting.nanoindentation.repetition import compared_quantities
from winkler.fitting.nanoindentation.thermal_drift import found_drift
from winkler.fitting.several.standing_out import copies, standing_out
from winkler.fitting.unloading.contact_reading import CalibratedArea
from winkler.values.validity import Standing

IDEAL = CalibratedIndenter(CalibratedArea([24.5]))
YOUNG, HARDNESS, POISSON, PEAK = 72e9, 9e9, 0.17, 10e-3
TIP = (1.0 - 0.07**2) / 1141e9


def _impression(young, hardness, poisson, peak, exponent=1.5, area=lambda depth: 24.5 * depth**2):
    """Greatest and final depth of an unloading F ~ (h - h_f)^m, from H = F/A(h_c) and S = 2 E_r sqrt(A/pi)."""
    modulus = 1.0 / ((1.0 - poisson**2) / young + TIP)
    depths = np.linspace(1e-9, 2e-6, 400001)
    contact = float(np.interp(peak / hardness, area(depths), depths))
    stiffness = 2.0 / np.sqrt(np.pi) * modulus * np.sqrt(area(contact))
    highest = contact + 0.75 * peak / stiffness
    return highest, highest - exponent * peak / stiffness


def _test(seed=2, gap=0.0):
    """An ideal Berkovich test after an approach of `gap` through air: E 72 GPa, H 9 GPa."""
    highest, final = _impression(YOUNG, HARDNESS, POISSON, PEAK)
    along, back = np.linspace(0.0, 1.0, 400), np.linspace(1.0, 0.0, 200)
    air = np.arange(-gap, 0.0, 1e-9)
    depth = np.r_[air, highest * along, final + (highest - final) * back ** (1.0 / 1.5)] + gap
    force = np.r_[0.0 * air, PEAK * along**2, PEAK * back]
    random = np.random.default_rng(seed)
    force = force + 3e-7 * random.standard_normal(force.size)
    depth = depth + 1e-10 * random.standard_normal(depth.size)
    return ForceCurve(depth, force, time=0.1 * np.arange(depth.size))


@pytest.mark.few(1, slow=9)
@pytest.mark.parametrize("gap", [2000e-9, 900e-9, 100e-9, 20e-9, 5e-6])
def test_the_length_of_the_approach_does_not_count(gap):
    """After 100, 900 and 2,000 nm of air E was 71.91, 69.58 +- 0.37 and 63.03 +- 0.59 GPa, for 72."""
    found = Nanoindentation(_test(gap=gap), IDEAL, POISSON).solve()
    assert found.zero_point.position == pytest.approx(gap, abs=1.5e-9)
    assert found.young[0] == pytest.approx(YOUNG, rel=5e-3)
    assert found.hardness[0] == pytest.approx(HARDNESS, rel=1e-2)
    assert abs(found.young[0] - YOUNG) < 3.0 * found.young_errors[0]
    assert abs(found.hardness[0] - HARDNESS) < 3.0 * found.hardness_errors[0]
    assert found.zero_point.error > 0.03e-9  # it was 0.0: a negative variance is unknown


@pytest.mark.slow
def test_intervals_hold_after_any_approach():
    """Of 30 tests after 30 to 3,000 nm of air, at most 4 miss the touch by more than 2 standard errors."""
    random = np.random.default_rng(11)
    missed = 0
    for seed in range(30):
        gap = float(np.exp(random.uniform(np.log(30e-9), np.log(3e-6))))
        zero = Nanoindentation(_test(seed, gap), IDEAL, POISSON).solve().zero_point
        missed += abs(zero.position - gap) > 2.0 * zero.error
    assert missed <= 4


def _lifted(begin=0.0):
    """E 210 GPa: in the first 2.1 s the tip lifts off by 25 nm at a steady -5 uN, comes back, loads, holds, unloads."""
    peak = 11e-3
    highest, final = _impression(210e9, 3.3135e9, 0.3, peak)
    time = np.arange(0.0, 43.0, 0.01)
    force = np.interp(time, [0, 0.7, 0.7001, 2.1, 2.1001, 4, 6, 36, 38, 42.7, 43],
                      [0, -4.9e-6, -5e-6, -5e-6, 0, 260e-6, 260e-6, peak, peak, 0, 0])  # fmt: skip
    depth = highest * np.sqrt(np.maximum(force, 0.0) / peak)
    depth[time > 38.0] = final + (highest - final) * (force[time > 38.0] / peak) ** (1.0 / 1.5)
    lifting = (time >= 0.7) & (time < 2.1)
    depth[lifting] = -25e-9 * (time[lifting] - 0.7) / 1.4
    random = np.random.default_rng(2)
    depth += 0.12e-9 * random.standard_normal(time.size)
    force = force + 50e-9 * random.standard_normal(time.size)
    chosen = time >= begin
    return ForceCurve(depth[chosen], force[chosen], time=time[chosen] - begin)


@pytest.mark.parametrize("begin", [0.0, 2.11])
def test_a_lift_off_is_no_drift(begin):
    """-10 nm/s was found in the air and subtracted over 43 s, and the test refused; E 210, H 3.31 GPa are right."""
    curve = _lifted(begin)
    drift = found_drift(curve)
    assert drift.rate == 0.0
    assert not drift.measured
    found = Nanoindentation(curve, IDEAL, 0.3).solve()
    assert found.young == pytest.approx([210e9], rel=0.01)
    assert found.hardness == pytest.approx([3.3135e9], rel=0.01)
    note = next(note for note in found.validity if note.statement.startswith("Drift"))
    assert drift.doubt
    assert drift.doubt in note.statement


def test_a_correction_beyond_the_depth_is_not_subtracted():
    """A hold in contact that moves by 5 nm/s would correct a loading of 40 s by 200 nm of 304."""
    plain = _test()
    depth = plain.position[589] + 5e-10 * np.arange(60)
    curve = ForceCurve(
        np.r_[plain.position[:590], depth], np.r_[plain.force[:590], np.full(60, plain.force[589])],
        time=0.1 * np.arange(650),
    ).with_segments([("loading", 0), ("unloading", 400), ("hold", 590)])  # fmt: skip
    drift = found_drift(curve)
    assert drift.rate == 0.0
    assert "5e-09 m/s" in drift.doubt


def test_a_preload_that_is_left_is_no_unloading():
    """A row of 217 GPa and 20 GPa at 2 mN came of a tip that leaves its preload; one unloading, E 130 GPa, is right."""
    radius, peak, exponent = 5323e-9, 200e-3, 1.4
    coefficients = [-np.pi, 2.0 * np.pi * radius]

    def area(depth):
        return coefficients[1] * depth - np.pi * depth**2

    hardness = 10.9e9
    highest, final = _impression(130e9, hardness, 0.25, peak, exponent, area)
    time = np.r_[np.arange(0.0, 0.3, 0.005), np.arange(0.3, 85.0, 0.02)]
    loaded = highest * (2e-3 / peak) ** 0.75
    force = np.interp(time, [0, 0.25, 0.2501, 5, 5.01, 9.99, 10, 70, 75, 85.2],
                      [2e-3, 0.2e-3, -0.1e-3, -0.1e-3, -0.08e-3, -0.08e-3, 0, peak, peak, 0])  # fmt: skip
    depth = highest * (np.maximum(force, 0.0) / peak) ** 0.75
    before = time < 10.0
    depth[before] = np.interp(time[before], [0, 0.25, 5, 10], [loaded, loaded - 26e-9, loaded - 906e-9, 0.0])
    depth[time > 75.0] = final + (highest - final) * (force[time > 75.0] / peak) ** (1.0 / exponent)
    random = np.random.default_rng(4)
    depth += 0.3e-9 * random.standard_normal(time.size)
    force += 15e-6 * random.standard_normal(time.size)
    found = Nanoindentation(
        ForceCurve(depth, force, time=time), CalibratedIndenter(CalibratedArea(coefficients)), 0.25
    ).solve()
    assert found.young == pytest.approx([130e9], rel=0.01)
    assert found.hardness == pytest.approx([hardness], rel=0.01)
    assert "before the first loading" in found.skipped[0]
    assert not found.drift.measured


def _soft_first(rise=0.18e-3, reach=0.85e-6):
    """The tip presses dust of 0.18 mN over 0.85 um before the sample of `_test`; its force remains as an offset."""
    plain = _test(gap=0.0)
    air = np.linspace(-0.9e-6, 0.0, 300, endpoint=False)
    before = rise * np.clip((air + reach) / reach, 0.0, 1.0) ** 0.7
    random = np.random.default_rng(2)
    depth = np.r_[air + 1e-10 * random.standard_normal(300), plain.position] + 0.9e-6
    force = np.r_[before + 3e-7 * random.standard_normal(300), np.maximum(plain.force, 0.0) + rise]
    return ForceCurve(depth, force, time=0.1 * np.arange(depth.size))


def test_two_touches_are_a_doubt():
    """Dust was taken for the contact: E 13.65 +- 0.04 for 72 GPa, while the events had a baseline over 910 nm."""
    found = Nanoindentation(_soft_first(), IDEAL, POISSON).solve()
    assert len(found.doubts) == 1
    assert "two touches" in found.doubts[0]
    assert [note.standing for note in found.validity if note.statement == found.doubts[0]] == [Standing.OUTSIDE]
    clean = Nanoindentation(_test(gap=0.9e-6), IDEAL, POISSON).solve()
    assert clean.doubts == ()


def test_an_exponent_on_its_bound_is_a_doubt():
    """Exponents of 21.09 = 1 + e^3 are the bound of the search."""
    plain = Nanoindentation(_test(), IDEAL, POISSON).solve()
    assert plain.doubts == ()
    bounded = dataclasses.replace(plain, exponent=np.array([1.0 + np.exp(3.0)]))
    assert "exponent of 21.09" in bounded.doubts[0]
    deep = dataclasses.replace(plain, final_depth=-10.0 * plain.depth)
    assert "final depth of -10" in deep.doubts[0]


def test_what_stands_out_is_named_and_copies_are_found():
    """One of nine with twice the modulus, one that touches 3 um later, and two with the data of the first."""
    plain = Nanoindentation(_test(), IDEAL, POISSON).solve()
    random = np.random.default_rng(3)
    moved = [
        dataclasses.replace(
            plain,
            young=plain.young * factor,
            zero_point=dataclasses.replace(plain.zero_point, position=plain.zero_point.position + shift),
            depth=plain.depth * random.normal(1.0, 0.01),
        )
        for factor, shift in zip(random.normal(1.0, 0.02, 9), random.normal(0.0, 1e-7, 9), strict=True)
    ]
    assert standing_out(compared_quantities(moved)) == ("",) * 9
    moved[4] = dataclasses.replace(moved[4], young=2.0 * plain.young)
    late = dataclasses.replace(plain.zero_point, position=plain.zero_point.position + 3e-6)
    moved[7] = dataclasses.replace(moved[7], zero_point=late)
    said = standing_out(compared_quantities(moved))
    assert [bool(text) for text in said] == [place in (4, 7) for place in range(9)]
    assert "Young's modulus 144 GPa, median 7" in said[4]
    assert "first touch" in said[7]
    assert copies(one.problem.curve for one in moved) == (0,) * 9
    other = dataclasses.replace(plain, problem=dataclasses.replace(plain.problem, curve=_test(seed=5)))
    assert copies(one.problem.curve for one in (plain, other, plain, other)) == (0, 1, 0, 1)


def _rough_start(seed):
    """A world with frame, drift, creep and slow noise, after air of 50 nm to 3 um; a fourth is lifted off first.

    A fourth presses dust of 0.1 to 0.3 mN before the sample.
    """
    random = np.random.default_rng(1000 + seed)
    machine = Machine(rate=8.0)
    curve, truth = indentation(machine, SILICA, seed, levels=2, leg=12.0, hold=8.0, low_hold=30.0)
    gap = float(np.exp(random.uniform(np.log(50e-9), np.log(3e-6))))
    steps = np.arange(-gap, 0.0, max(2e-9, gap / 200))
    lift = np.zeros(0)
    force = np.zeros(steps.size)
    if seed % 4 == 3:
        force = random.uniform(1e-4, 3e-4) * (np.arange(steps.size) / steps.size) ** 0.7
    elif seed % 2:
        lift = -30e-9 * np.sin(np.linspace(0.0, np.pi, 24)) - gap
    ahead = np.r_[lift, steps] + float(curve.position[0])
    before = np.r_[np.full(lift.size, -5e-6), force]
    offset = float(force[-1]) if seed % 4 == 3 else 0.0
    noise = random.standard_normal((2, ahead.size))
    position = np.r_[ahead + machine.depth_noise * noise[0], curve.position]
    force = np.r_[before + machine.force_noise * noise[1], np.maximum(curve.force, -1e-6) + offset]
    return ForceCurve(position, force, time=np.arange(position.size) / machine.rate), truth, seed % 4 == 3


@pytest.mark.long
def test_intervals_hold_whatever_comes_before_the_contact():
    """Of 180 worlds without dust 95 % intervals of E and of H hold 0.92 or more, not all; 60 dusty ones are doubted.

    Of intervals that hold 0.98 no one misses in 3 % of such series.  A share that small tells little of intervals that
    are too wide, so the deviations from the truth are compared with the standard errors, too.
    """
    machine = Machine(rate=8.0)
    indenter = CalibratedIndenter(CalibratedArea(machine.coefficients), machine.compliance)
    held, off, undoubted = {"young": [], "hardness": []}, {"young": [], "hardness": []}, []
    for seed in range(240):
        curve, truth, dusty = _rough_start(seed)
        found = Nanoindentation(curve, indenter, SILICA.poisson).solve()
        if dusty:
            undoubted += [seed] * (not found.doubts)
            continue
        for name, true in (("young", SILICA.young), ("hardness", float(truth.hardness[-1]))):
            low, high = (float(end[found.deepest]) for end in found.interval(name))
            held[name].append(low < true < high)
            off[name].append(np.log(true / np.sqrt(low * high)) / (0.25 * np.log(high / low)))
    assert undoubted == []
    for name in held:
        assert 0.92 * 180 <= sum(held[name]) < 180, (name, sum(held[name]))
        assert 0.8 <= np.std(off[name]) <= 1.2, (name, np.std(off[name]))
