"""No energy comes from nowhere: losses against closed forms, and balances, at ratios of times from 1e-20 to 1e20."""

from __future__ import annotations

import dataclasses
import math

import mpmath
import numpy as np
import pytest

import winkler as wk
from winkler.numerics.springs.spring_work import work_in_plane
from winkler.problems.assumptions.energy import missing_energy
from winkler.values.validity import Assumption, Standing

RATIOS = [1e-20, 1e-10, 1e-3, 0.1, 1.0, 30.0, 1e4, 1e14, 1e20]
"""Relaxation times over the duration."""
MODULUS, DEPTH = 0.25, 0.02
"""G [Pa] of what relaxes, so that E* = 1 Pa; d [m], reached after a second."""


def solids(ratio):
    """Solids of which all times are this one; those of a dashpot alongside have what it takes in place of a modulus."""
    return {
        "standard solid": wk.StandardSolid(0.1 * MODULUS, MODULUS, ratio),
        "Maxwell": wk.Maxwell(MODULUS, ratio),
        "Kelvin-Voigt": wk.KelvinVoigt(MODULUS, MODULUS * ratio),
        "Prony": wk.Prony(0.1 * MODULUS, [MODULUS, MODULUS], [ratio, 1e-3 * ratio], 0.01 * MODULUS * ratio),
        "flowing": wk.GeneralisedKelvin(1.0 / MODULUS, [0.3 / MODULUS], [ratio], 0.1 / (MODULUS * ratio)),
    }


SOLIDS = list(solids(1.0))


def bed(solid, profile=None):
    return wk.Foundation(profile or wk.Paraboloid(1.0), wk.ViscoelasticHalfSpace(solid))


def standing(solution):
    (note,) = [note for note in solution.validity if note.assumption is Assumption.ENERGY]
    return note.standing


def ramp(ratio, order):
    r"""Force, work, stored and lost energy of the standard solid at the end of a ramp to the depth d, per K(d).

    With K growing like :math:`d^n` the springs that touch at :math:`\gamma` are :math:`n\gamma^{n-1}\mathrm d\gamma`,
    and :math:`\int e^{-xs}\,\mathrm dK` over the parts s of the ramp for which they are pressed is
    :math:`{}_1F_1(1;1+n;-x)`; a flat punch has n = 0.  E* = 1 is what relaxes, 0.1 what does not.
    """
    with mpmath.workdps(130):
        x, n, depth = 1 / mpmath.mpf(ratio), mpmath.mpf(order), mpmath.mpf(DEPTH)
        one, two = (mpmath.hyp1f1(1, 1 + n, -k * x) for k in (1, 2))
        mean, square = 1 / (1 + n), 2 / ((1 + n) * (2 + n))
        force = depth * ((1 - one) / x + mpmath.mpf(0.1) * mean)
        stored = depth**2 * ((1 - 2 * one + two) / x**2 + mpmath.mpf(0.1) * square) / 2
        work = depth**2 * ((mean * x - 1 + one) / x**2 + mpmath.mpf(0.1) * square / 2)
        lost = depth**2 * (2 * mean * x - 3 + 4 * one - two) / (2 * x**2)
        return [float(each) for each in (force, work, stored, lost)]


SHAPES = {
    "flat punch": (wk.FlatPunch(0.3), 0.0, 0.6, 1e-12),
    "paraboloid": (wk.Paraboloid(1.0), 0.5, 2.0 * math.sqrt(DEPTH), 3e-5),
    "cone": (wk.Cone(math.radians(80.0)), 1.0, 4.0 / math.pi * DEPTH * math.tan(math.radians(80.0)), 3e-5),
}
"""Profile, how its stiffness grows with the depth, K(d) [N/m] for E* = 1, and the error of 400 springs."""


@pytest.mark.few(4)
@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("ratio", RATIOS)
def test_a_ramp_loses_the_energy_of_its_closed_form(shape, ratio):
    """`StandardSolid(relaxation_time=1e14)` lost 3.6e-6 J where 7e-19 is true, and at 1e20 it gave -0.17 J back."""
    profile, order, stiffness, tolerance = SHAPES[shape]
    path = wk.Path([0.0, 1.0], wk.Depth([0.0, DEPTH]))
    result = wk.ViscoelasticIndentation(bed(solids(ratio)["standard solid"], profile), path, count=400).solve()
    ends = [each[-1] / stiffness for each in (result.force, result.work, result.stored_energy, result.dissipation)]
    assert ends == pytest.approx(ramp(ratio, order), rel=tolerance)
    assert standing(result) is Standing.EXACT


@pytest.mark.parametrize("name", SOLIDS)
@pytest.mark.parametrize("ratio", RATIOS)
def test_indentation_to_and_fro_keeps_account(name, ratio):
    """Springs part and are caught again; what the dashpots lose is never negative, and nothing else is missing."""
    path = wk.Path([0.0, 1.0, 2.0, 3.0, 4.0], wk.Depth([0.0, DEPTH, 0.5 * DEPTH, -0.1 * DEPTH, 0.2 * DEPTH]))
    result = wk.ViscoelasticIndentation(bed(solids(ratio)[name]), path, count=60).solve()
    assert missing_energy(result.work, result.stored_energy, result.dissipation) <= 1e-12
    assert standing(result) is Standing.EXACT
    assert np.all(np.diff(result.dissipation) >= 0.0)
    assert np.all(result.stored_energy >= 0.0)


@pytest.mark.few(2, slow=1)
@pytest.mark.parametrize("ratio", RATIOS)
def test_sudden_depths_and_forces_keep_account(ratio):
    solid = solids(ratio)["standard solid"]
    jumps = wk.Path([0.0, 0.0, 1.0, 1.0, 2.0], wk.Depth([0.0, DEPTH, DEPTH, 0.3 * DEPTH, 0.3 * DEPTH]))
    loads = wk.Path([0.0, 1.0, 1.0, 2.0], wk.Force([0.0, 1e-3, 4e-4, 0.0]))
    for path in (jumps, loads):
        result = wk.ViscoelasticIndentation(bed(solid), path, count=40, tolerance=1e-4).solve()
        assert missing_energy(result.work, result.stored_energy, result.dissipation) <= 1e-11
        assert np.all(np.diff(result.dissipation) >= 0.0)


@pytest.mark.few(6)
@pytest.mark.parametrize("name", SOLIDS)
@pytest.mark.parametrize("ratio", [1e-20, 1e-3, 0.1, 1.0, 1e4, 1e20])
def test_a_body_that_is_dragged_keeps_account(name, ratio):
    path = wk.Path(
        [0.0, 1.0, 2.0, 3.0], wk.Depth([0.0, DEPTH, 0.5 * DEPTH, -0.1 * DEPTH]), wk.Shift([0.0, 4e-3, -2e-3, 6e-3])
    )
    problem = wk.Tangential(bed(solids(ratio)[name]), wk.Coulomb(0.5), path, count=20, tolerance=1e-2)
    result = problem.solve()
    assert missing_energy(result.work, result.stored_energy, result.dissipation) <= 1e-12
    assert standing(result) is Standing.EXACT
    for loss in (result.friction_loss, result.bulk_loss):
        assert np.all(np.diff(loss) >= 0.0)
    assert result.dissipation == pytest.approx(result.friction_loss + result.bulk_loss, rel=1e-14)


@pytest.mark.few(1, slow=1)
@pytest.mark.parametrize("ratio", [1e-20, 1e-3, 1.0, 1e4, 1e20])
def test_what_an_impact_takes_is_stored_or_lost(ratio):
    solid = solids(ratio)["standard solid"]
    result = wk.ViscoelasticImpact(bed(solid), mass=1.0, velocity=1.0, count=40, tolerance=1e-2).solve()
    assert standing(result) is Standing.EXACT
    assert np.all(np.diff(result.bulk_loss) >= 0.0)
    assert 0.0 < result.dissipation < 0.5
    if ratio == 1e20:  # as long as the bodies touch little fades: the loss falls with the relaxation time
        soon = wk.ViscoelasticImpact(
            bed(solids(1e10)["standard solid"]), mass=1.0, velocity=1.0, count=40, tolerance=1e-2
        )
        assert result.dissipation == pytest.approx(1e-10 * soon.solve().dissipation, rel=1e-8)


def test_rubber_far_below_its_glass_transition_loses_next_to_nothing():
    """Seven decades colder an `AtTemperature` gave 4.5e12 J."""
    law = wk.WilliamsLandelFerry(393.15, 17.44, 51.6)
    solid = wk.AtTemperature(wk.Prony(1e5, [1e6, 1e7], [1e-3, 1.0]), law, 350.0)
    assert solid.factor > 1e20
    path = wk.Path([0.0, 1.0, 2.0], wk.Depth([0.0, 1e-4, 0.0]))
    result = wk.ViscoelasticIndentation(bed(solid, wk.Paraboloid(0.01)), path, count=100).solve()
    assert 0.0 < result.dissipation[-1] < 1e-18 * result.work[1]
    assert standing(result) is Standing.EXACT


def test_a_march_that_misses_energy_notes_it():
    path = wk.Path([0.0, 1.0, 2.0], wk.Depth([0.0, DEPTH, 0.0]))
    result = wk.ViscoelasticIndentation(bed(solids(1.0)["Maxwell"]), path, count=40).solve()
    scale = np.max(result.work)
    for missing, expected in ((3e-10, Standing.EXACT), (3e-9, Standing.APPROXIMATE), (2e-3, Standing.OUTSIDE)):
        wrong = dataclasses.replace(result, dissipation=result.dissipation + missing * scale * (result.time > 1.0))
        assert standing(wrong) is expected
    wrong = dataclasses.replace(result, dissipation=result.dissipation * math.nan)
    assert standing(wrong) is Standing.OUTSIDE


@pytest.mark.parametrize("speed", [1e-20, 1e-14, 1e-8, 1e8, 1e14, 1e20])
def test_next_to_nothing_resists_a_ball_that_slides_far_from_its_relaxation_time(speed):
    r"""Slow :math:`\tau v\int u'^2\,\mathrm dx=\tfrac83\tau va^3`, fast :math:`\int u^2\,\mathrm dx/(\tau v)=16a^5/15`.

    The resistance of a Kelvin-Voigt solid at 1e-20 m/s was negative, that of a standard solid at 1e20 m/s rounding.
    """
    depth = 0.01
    width, tolerance = math.sqrt(depth), 3e-6 if speed in (1e-8, 1e8) else 1e-9
    slow, fast = 8.0 / 3.0 * speed * width**3, 16.0 / 15.0 / speed * width**5
    for name in ("standard solid", "Kelvin-Voigt") if speed < 1.0 else ("standard solid", "Maxwell"):
        result = wk.SlidingResistance(bed(solids(1.0)[name]), wk.Depth(depth), speed).solve()
        assert result.line_shear_force == pytest.approx(slow if speed < 1.0 else fast, rel=tolerance)


@pytest.mark.few(2)
@pytest.mark.parametrize("coefficient", [0.3, math.inf])
@pytest.mark.parametrize("profile", [wk.Paraboloid(0.01), wk.FlatPunch(1e-3)], ids=["paraboloid", "punch"])
def test_slip_on_a_random_path_balances_energy(profile, coefficient):
    """The work is that of every spring along its path: stuck, sliding, coming and leaving."""
    random, count = np.random.default_rng(1), 40
    contact = wk.Foundation(profile, wk.HalfSpace.between(wk.Elastic(210e9, 0.3)))
    depth = np.where(random.random(count) < 0.3, 1e-6, 1e-6 * random.uniform(-0.2, 1.0, count))
    force = wk.Indentation(contact, wk.Depth(np.abs(depth))).solve().force
    pulled = min(coefficient, 1.0) * 0.9 * force * random.uniform(-1.0, 1.0, count)
    time = np.arange(float(count))
    for path in (
        wk.Path(time, wk.Depth(depth), wk.Shift(1e-6 * random.uniform(-1.0, 1.0, count))),
        wk.Path(time, wk.Force(force), wk.ShearForce(pulled)),
    ):
        result = wk.Tangential(contact, wk.Coulomb(coefficient), path).solve()
        assert missing_energy(result.work, result.stored_energy, result.dissipation) <= 1e-10
        assert standing(result) is Standing.EXACT


class Rooted:
    """A law of one's own: friction grows like the root of the load."""

    def shear_bound(self, line_load):
        return 100.0 * np.sqrt(line_load)


LAWS = [wk.Coulomb(0.3), wk.Coulomb(math.inf), wk.StaticKinetic(0.5, 0.3), Rooted()]


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("law", LAWS, ids=["Coulomb", "rough", "static", "own"])
@pytest.mark.parametrize("profile", [wk.Paraboloid(0.01), wk.FlatPunch(1e-3)], ids=["paraboloid", "punch"])
def test_springs_on_random_paths_balance_energy(law, profile):
    """Only where a spring turns in the plane while its load changes is the loss approximate, and the note states it."""
    random, count = np.random.default_rng(3), 40
    contact = wk.Foundation(profile, wk.HalfSpace.between(wk.Elastic(210e9, 0.3)))
    time, steady = np.arange(float(count)), np.full(count, 1e-6)
    depth = np.where(random.random(count) < 0.3, 1e-6, 1e-6 * random.uniform(-0.2, 1.0, count))
    line, plane = 1e-6 * random.uniform(-1.0, 1.0, count), 1e-6 * random.uniform(-1.0, 1.0, (count, 2))
    for loads, shift, allowed in (
        (steady, line, 1e-13),
        (depth, line, 1e-13),
        (steady, plane, 1e-13),
        (depth, plane, 1e-4),
    ):
        result = wk.Tangential(
            contact, law, wk.Path(time, wk.Depth(loads), wk.Shift(shift)), wk.Method.SPRINGS, count=60
        ).solve()
        missing = missing_energy(result.work, result.stored_energy, result.dissipation)
        assert missing <= allowed
        assert standing(result) is (Standing.EXACT if missing <= 1e-9 else Standing.APPROXIMATE)


@pytest.mark.parametrize("law", LAWS[::2], ids=["Coulomb", "static"])
def test_sliding_in_the_plane_keeps_account(law):
    contact = wk.Foundation(wk.Paraboloid(0.01), wk.HalfSpace.between(wk.Elastic(210e9, 0.3)))
    angle = np.linspace(0.0, 7.0, 12)
    circle = 5e-7 * np.column_stack([np.cos(angle), np.sin(angle)])
    result = wk.Tangential(contact, law, wk.Path(angle, wk.Depth(1e-6), wk.Shift(circle))).solve()
    assert missing_energy(result.work, result.stored_energy, result.dissipation) <= 1e-13
    assert standing(result) is Standing.EXACT


@pytest.mark.parametrize(
    ("last", "angle", "track"),
    [(1.0, 1.2, 3.0), (1.5, 1.0, 4.0), (0.2, 2.3, 1.0), (3.0, 0.7, 60.0), (1.0, 1.5, 0.01), (1.05, 1.2, 0.3)],
)
def test_a_spring_that_turns_takes_the_work_of_its_path(last, angle, track):
    """By mpmath: tan(theta/2) falls like a power of a bound that goes from 1 m to another one."""
    start, one = np.array([[np.cos(angle)], [np.sin(angle)]]), np.ones(1)
    result = work_in_plane(start, np.zeros(1, bool), 0.0 * one, one, one, last * one, 1.0, 1.0, last, track, 0.0)

    def pull(x):
        bound = 1 + (last - 1) * x / track
        y = x if last == 1.0 else track / (last - 1) * mpmath.log(bound)
        return bound * mpmath.cos(2 * mpmath.atan(mpmath.exp(-y) * mpmath.tan(angle / 2)))

    assert result == pytest.approx(float(mpmath.quad(pull, [0.0, 0.1 * track, 0.3 * track, track])), rel=1e-9)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("coefficient", [math.inf, 0.3])
@pytest.mark.parametrize("profile", [wk.Paraboloid(0.01), wk.FlatPunch(1e-3)], ids=["paraboloid", "punch"])
def test_torsion_on_a_random_path_balances_energy(profile, coefficient):
    random, count = np.random.default_rng(2), 8
    contact = wk.Foundation(profile, wk.HalfSpace.between(wk.Elastic(210e9, 0.3)))
    depth = np.where(random.random(count) < 0.3, 1e-6, 1e-6 * random.uniform(-0.2, 1.0, count))
    time, twist = np.arange(float(count)), wk.Angle(1e-3 * random.uniform(-1.0, 1.0, count))
    for loads in (depth, np.full(count, 1e-6)):
        result = wk.Torsion(contact, wk.Coulomb(coefficient), wk.Path(time, wk.Depth(loads), twist)).solve()
        assert missing_energy(result.work, result.stored_energy, result.dissipation) <= 1e-11
        assert standing(result) is Standing.EXACT


@pytest.mark.slow
def test_the_work_of_a_twist_is_the_integral_of_its_torque():
    """To Simpson's rule over many points of a stroke to and fro under a changing load."""
    contact = wk.Foundation(wk.Paraboloid(0.01), wk.HalfSpace.between(wk.Elastic(210e9, 0.3)))
    ends, share = wk.Path([0.0, 1.0, 2.0], wk.Depth([1e-6, 2e-6, 1e-6]), wk.Angle([0.0, 1e-3, -5e-4])), 16
    time = np.linspace(0.0, 2.0, 2 * share + 1)
    depth, angle = (np.interp(time, ends.time, each) for each in (ends.across, ends.along))
    law = wk.Coulomb(0.3)
    torque = wk.Torsion(contact, law, wk.Path(time, wk.Depth(depth), wk.Angle(angle))).solve().torque
    weights = np.array([1.0, *[4.0, 2.0] * (share // 2 - 1), 4.0, 1.0]) / (3.0 * share)
    first, second = (float(weights @ each) for each in (torque[: share + 1], torque[share:]))
    result = wk.Torsion(contact, law, ends).solve().work
    assert result[1:] == pytest.approx([1e-3 * first, 1e-3 * first - 1.5e-3 * second], rel=2e-4)


@pytest.mark.few(1)
@pytest.mark.parametrize("speed", [1e-20, 1e-8, 1e14])
def test_the_edge_of_rubber_keeps_account(speed):
    """Slowly nothing but leaps is lost, as in a cycle without speed; at once nothing is."""
    rubber = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(young=1e6, poisson=0.5)))
    law = wk.RateDependentWork(work=0.05, reference_speed=1e-6, exponent=0.6)
    time, places = np.array([0.0, 5e-5, 1e-4]) / speed, wk.Depth([5e-6, -45e-6, 5e-6])
    result = wk.ViscoelasticAdhesion(rubber, law, wk.Path(time, places)).solve()
    assert missing_energy(result.work, result.energy, result.dissipation) <= 1e-5
    assert np.all(np.diff(result.dissipation) >= 0.0)
    assert standing(result) is (Standing.EXACT if speed == 1e14 else Standing.APPROXIMATE)
    slow = wk.AdhesiveCycle(rubber, wk.ShortRange(0.05), places).solve().dissipation
    if speed == 1e-20:
        assert result.dissipation == pytest.approx(slow, rel=3e-6)
    if speed == 1e14:
        assert result.dissipation[1] == pytest.approx(slow[0], rel=1e-6)
