"""What is wrong with a curve is found, by name; what is right is let through."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from synthetic import hertz, jkr, there_and_back

from winkler.fitting.curves.checks import examined, outline, refuse, unsaturated
from winkler.fitting.curves.curve import ForceCurve
from winkler.values.errors import InvalidInput


def good(seed: int = 1, noise: float = 1e-11) -> ForceCurve:
    position, _ = there_and_back(-1e-6, 1e-6, 300)
    force = hertz(position, 1e4, 5e-6) + noise * np.random.default_rng(seed).standard_normal(position.size)
    return ForceCurve(position, force, name="gel")


def names(curve: ForceCurve) -> list[str]:
    return [flag.name for flag in examined(curve)]


def test_a_good_curve_has_no_flag():
    assert names(good()) == []
    assert refuse(good()) == ()


def test_the_outline_of_a_good_curve():
    rough_outline = outline(good())
    assert rough_outline.contact_point == pytest.approx(0.0, abs=1e-7)
    assert rough_outline.noise == pytest.approx(1e-11, rel=0.3)
    assert rough_outline.top == pytest.approx(hertz(1e-6, 1e4, 5e-6), rel=0.02)
    assert rough_outline.pull == 0.0


def test_no_contact():
    position = np.linspace(0.0, 1e-6, 300)
    noise = np.random.default_rng(2).standard_normal(300)
    assert names(ForceCurve(position, 1e-11 * noise)) == ["no_contact"]
    with pytest.raises(InvalidInput, match="curve 'air': no_contact: .* no contact can be distinguished"):
        refuse(ForceCurve(position, 1e-11 * noise, name="air"))


def test_no_contact_without_noise():
    assert names(ForceCurve(np.linspace(0.0, 1e-6, 300), np.zeros(300))) == ["no_contact"]


def test_reversed_force():
    curve = good()
    assert names(dataclasses.replace(curve, force=-curve.force)) == ["reversed"]
    with pytest.raises(InvalidInput, match="reversed: .* change the sign of force or position"):
        refuse(dataclasses.replace(curve, force=-curve.force))


def test_saturated():
    curve = good()
    cut = dataclasses.replace(curve, force=np.minimum(curve.force, 0.5 * curve.force.max()))
    assert names(cut) == ["saturated"]
    mended = unsaturated(cut)
    assert mended.count < curve.count
    assert names(mended) == []
    assert unsaturated(curve) is curve


def test_few_points():
    curve = good().chosen(np.arange(5))
    assert names(curve) == ["few_points"]
    with pytest.raises(InvalidInput, match="5 points; at least 10"):
        refuse(curve)


def test_units():
    curve = good()
    assert "units" in names(ForceCurve(1e9 * curve.position, 1e9 * curve.force))
    with pytest.raises(InvalidInput, match="positions in m and forces in N"):
        refuse(ForceCurve(1e9 * curve.position, 1e9 * curve.force))


def test_no_baseline_is_only_a_flag():
    curve = good()
    inside = curve.chosen(curve.position > 1e-7)
    assert names(inside) == ["no_baseline"]
    assert [flag.name for flag in refuse(inside)] == ["no_baseline"]


def sticky(level: float = 1e-11) -> ForceCurve:
    position, inward = there_and_back(-1e-6, 1e-6, 400)
    force = jkr(position, inward, 1.33e4, 5e-6, 1e-4, 0.05)
    return ForceCurve(position, force + level * np.random.default_rng(3).standard_normal(800), 0.05, name="sticky")


def test_a_sticky_curve_has_no_flag():
    assert names(sticky()) == []


@pytest.mark.parametrize("make", [good, sticky])
@pytest.mark.parametrize(("word", "direction"), [("approach", 1.0), ("retract", -1.0)])
def test_the_branch_that_lacks_a_baseline_is_named(make, word, direction):
    curve = make()
    cut = curve.chosen((curve.direction != direction) | (curve.position > 2e-8))
    flags = examined(cut)
    assert [flag.name for flag in flags] == ["no_baseline"]
    assert f"n {word} " in flags[0].statement
    other = {"approach": "retract", "retract": "approach"}[word]
    assert other not in flags[0].statement.partition(";")[0] or "ends before pull-off" in flags[0].statement


def test_a_curve_that_ends_before_the_tip_has_come_off():
    curve = sticky()
    off = curve.position[curve.direction < 0.0][np.argmin(curve.force[curve.direction < 0.0])]
    flags = examined(curve.chosen((curve.direction > 0.0) | (curve.position > off)))
    assert [flag.name for flag in flags] == ["no_baseline"]


def test_drag_is_no_missing_baseline():
    curve = good()
    assert names(dataclasses.replace(curve, force=curve.force + 2e-10 * curve.direction)) == []


def test_a_detector_at_its_lower_end():
    curve = sticky()
    cut = dataclasses.replace(curve, force=np.maximum(curve.force, 0.5 * curve.force.min()))
    assert names(cut) == ["saturated"]
    mended = unsaturated(cut)
    assert 700 < mended.count < 800
    assert "saturated" not in names(mended)


def test_reversed_position():
    curve = good()
    assert names(dataclasses.replace(curve, position=-curve.position)) == ["reversed"]


def test_a_machine_that_would_bend_more_than_it_moved():
    """Forces in nN that are taken for N, or a position that is the tip's already."""
    curve = dataclasses.replace(sticky(), machine_stiffness=1e-4)
    with pytest.raises(InvalidInput, match="units: A machine of 0.0001 N/m bends by .* positions in m of the stage"):
        refuse(curve)


def test_a_flag_can_be_read():
    assert str(examined(good().chosen(np.arange(5)))[0]).startswith("few_points: The curve has 5 points")


@pytest.mark.slow
def test_noise_alone_is_no_pull():
    """The least of many means of points lies several of their errors below the far end; that is no tension."""
    position = np.linspace(-1.1e-6, 0.9e-6, 150)
    found = []
    for seed in range(200):
        noise = 1e-10 * np.random.default_rng(seed).standard_normal(position.size)
        found += names(ForceCurve(position, 4e-9 * (np.clip(position, 0.0, None) / 0.9e-6) ** 1.5 + noise))
    assert found == []
