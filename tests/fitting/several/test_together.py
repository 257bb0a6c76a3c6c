"""Curves with shared numbers, against dense equations, scipy's least squares of all curves, and seeded worlds."""

import numpy as np
import pytest
from noisy_worlds import coloured
from relaxing_curves import FIRST, power_law_force
from relaxing_curves import model as relaxing
from scipy.optimize import least_squares
from synthetic import hertz

import winkler as wk
from winkler.fitting.several.arrowhead import CurveBlock, solved_blocks
from winkler.fitting.several.together import fit_together, joint_of
from winkler.materials.fractional import PowerLawSolid
from winkler.values.errors import InvalidInput, OutsideValidity

E = "bed.medium.first.young"
FREE = [E, "contact_point", "baseline"]


def model(radius=5e-6):
    return wk.Indentation(
        wk.Foundation(wk.Paraboloid(radius), wk.HalfSpace.between(wk.Elastic(3e4, 0.5))), wk.Depth(0.0)
    )


def measured(random, *, young=1e4, radius=5e-6, deepest=1e-6, level=3e-11, flicker=0.0, origin=2e-6, count=250):
    depth = np.linspace(-1e-6, deepest, count)
    slow = flicker * coloured(random, count, 1.0) if flicker else 0.0
    force = hertz(depth, young / 0.75, radius) + 1e-10 + level * (random.standard_normal(count) + slow)
    return wk.ForceCurve(depth + origin, force)


def test_arrowhead_is_the_dense_inverse():
    random, blocks, own = np.random.default_rng(1), [], [2, 1, 3]
    whole, right = np.zeros((8, 8)), np.zeros(8)
    first = 2
    for count in own:
        factor = random.standard_normal((2 + count, 9))
        information, gradient = factor @ factor.T, random.standard_normal(2 + count)
        place = random.permutation(2 + count)  # shared numbers stand anywhere
        where = np.empty(2 + count, dtype=int)
        where[place[:2]], where[np.sort(place[2:])] = [0, 1], np.arange(first, first + count)
        whole[np.ix_(where, where)] += information
        right[where] += gradient
        blocks.append((CurveBlock(information, gradient, place[:2]), where))
        first += count
    shared, steps, covariances = solved_blocks([block for block, _ in blocks])
    dense = np.linalg.inv(whole)
    assert shared == pytest.approx(dense[:2, :2], rel=1e-9)
    for (_, where), step, covariance in zip(blocks, steps, covariances, strict=True):
        assert step == pytest.approx((dense @ right)[where], rel=1e-8)
        assert covariance == pytest.approx(dense[np.ix_(where, where)], rel=1e-8)


def test_joint_numbers_are_those_of_all_points():
    """White noise of different levels, depths and balls; scipy fits one modulus and eight own numbers at once."""
    random = np.random.default_rng(2)
    worlds = [(2e-6, 0.4e-6, 1e-11), (5e-6, 1e-6, 3e-11), (5e-6, 0.6e-6, 1e-11), (10e-6, 0.3e-6, 5e-11)]
    curves = [
        measured(random, radius=radius, deepest=deepest, level=level, origin=index * 1e-6)
        for index, (radius, deepest, level) in enumerate(worlds)
    ]
    found = fit_together(curves, [model(radius) for radius, _, _ in worlds], free=FREE, shared=[E])

    def misfit(numbers):
        parts = []
        for index, ((radius, _, level), curve) in enumerate(zip(worlds, curves, strict=True)):
            along = curve.position - 1e-6 * numbers[1 + 2 * index]
            force = hertz(along, np.exp(numbers[0]) / 0.75, radius) + 1e-10 * numbers[2 + 2 * index]
            parts.append((curve.force - force) / level)
        return np.concatenate(parts)

    start = np.array([np.log(1e4), *np.ravel([[index, 1.0] for index in range(4)])])
    dense = least_squares(misfit, start, x_scale="jac", xtol=1e-13, ftol=1e-13)
    error = float(np.sqrt(np.linalg.inv(dense.jac.T @ dense.jac)[0, 0]))
    assert abs(np.log(found.value(E)) - dense.x[0]) < 0.4 * error
    assert found.error(E) / found.value(E) == pytest.approx(error, rel=0.35)
    assert found.flags == ()
    assert found.shares.sum(axis=0) == pytest.approx([1.0])
    assert np.all(found.error(E) < found.single_errors[:, 0])
    for index, one in enumerate(found.fits):
        assert one.value(E) == found.value(E)
        assert one.value("contact_point") == pytest.approx(index * 1e-6, abs=4e-9)


@pytest.mark.slow
def test_curves_fitted_before_are_joined():
    random = np.random.default_rng(3)
    curves = [measured(random) for _ in range(3)]
    at_once = fit_together(curves, model(), free=FREE, shared=[E])
    after = joint_of([wk.fit(curve, model(), free=FREE) for curve in curves], [E])
    assert after.values == pytest.approx(at_once.values, rel=1e-9)
    assert after.interval(E) == pytest.approx(at_once.interval(E), rel=1e-6)


@pytest.mark.slow
def test_another_sample_is_found():
    random = np.random.default_rng(4)
    curves = [measured(random, young=young) for young in (1e4, 1e4, 1.05e4, 1e4)]
    found = fit_together(curves, model(), free=FREE, shared=[E])
    assert [flag.name for flag in found.flags][:1] == ["disagree"]
    assert "numbered 3 most" in found.flags[0].statement or int(np.argmin(found.chances)) == 2
    alone = fit_together(curves[:2], model(), free=FREE, shared=[E])
    assert alone.flags == ()
    assert found.error(E) > 2.0 * alone.error(E)
    assert found.single_values[:, 0] == pytest.approx([1e4, 1e4, 1.05e4, 1e4], rel=0.01)


@pytest.mark.slow
def test_shared_modulus_holds():
    """Three curves with 1/f noise: the interval of the shared modulus holds the truth."""
    held, flagged, worlds = 0, 0, 5
    for seed in range(worlds):
        random = np.random.default_rng([5, seed])
        curves = [measured(random, flicker=1.0 / 3.0, count=150) for _ in range(3)]
        found = fit_together(curves, model(), free=FREE, shared=[E])
        low, high = found.interval(E)
        held, flagged = held + (low < 1e4 < high), flagged + bool(found.flags)
    assert held >= 4
    assert flagged <= 1


@pytest.mark.long
def test_shared_modulus_holds_in_many_worlds():
    held, worlds = 0, 40
    for seed in range(worlds):
        random = np.random.default_rng([6, seed])
        curves = [measured(random, flicker=1.0 / 3.0, count=150) for _ in range(3)]
        low, high = fit_together(curves, model(), free=FREE, shared=[E]).interval(E)
        held += low < 1e4 < high
    assert held / worlds >= 0.92


@pytest.mark.slow
def test_speeds_share_one_power_law():
    """Two speeds on one body that relaxes: the shared numbers are the true ones, with less error than those of one."""
    fits, solid = [], PowerLawSolid(2e3, 1.0, 0.45, shortest=1e-3, longest=20.0)
    time, names = np.linspace(-0.5, 2.5, 250), [f"{FIRST}shear", f"{FIRST}exponent"]
    for seed, speed in enumerate((1e-6, 2e-6)):
        turn, random = 1e-6 / speed, np.random.default_rng(seed)
        force = power_law_force(time, turn, speed, 500.0, 0.2, held=True) + 1e-11 * random.standard_normal(250)
        curve = wk.ForceCurve(
            speed * np.minimum(time, turn) + 2e-6, force, time=time + 0.5, direction=np.where(time < turn, 1.0, 0.0)
        )
        fits.append(wk.fit(curve, relaxing(solid), free=[*names, "contact_point", "baseline"]))
    found = joint_of(fits, names)
    for name, true in zip(names, (500.0, 0.2), strict=True):
        low, high = found.interval(name, 0.999)
        assert low < true < high
        assert found.error(name) < min(one.error(name) for one in fits)
    assert found.flags == ()


def test_refused():
    random = np.random.default_rng(7)
    curves = [measured(random) for _ in range(2)]
    for curves_, models, shared, says in (
        (curves[:1], model(), [E], "cannot share"),
        (curves, model(), [], "nothing is shared"),
        (curves, model(), ["bed.medium.first.yung"], "not free"),
        (curves, [model()], [E], "2 curves and 1 models"),
    ):
        with pytest.raises(InvalidInput, match=says):
            fit_together(curves_, models, free=FREE, shared=shared)
    radius = "bed.profile.curvature_radius"
    with pytest.raises(OutsideValidity, match="together do not determine"):
        fit_together(curves, model(), free=[*FREE, radius], shared=[E, radius])
