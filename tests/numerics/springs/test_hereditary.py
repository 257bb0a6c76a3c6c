"""Forces along a motion, and depths under forces: against closed forms, tables of theory, and the rows of springs."""

from __future__ import annotations

import math
from pathlib import Path as FilePath

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import beta, betainc

import winkler as wk
from winkler.fitting.viscoelastic.response import elastic_table, forces, positions
from winkler.loading.path import Path
from winkler.materials.fractional import PowerLawSolid
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import elastic_like

SLS = StandardSolid(relaxed_shear=0.05, shear=0.2, relaxation_time=0.3)
POWER = PowerLawSolid(0.25, 1.0, 0.2, shortest=1e-5, longest=20.0, tolerance=1e-7)


def bed(solid, profile=None):
    return wk.Foundation(profile or wk.Paraboloid(1.0), ViscoelasticHalfSpace(solid))


def solutions(solid, time, place, turn, compliance=0.0, profile=None):
    one = bed(solid, profile)
    table = elastic_table(elastic_like(one), float(np.max(place)))
    found = forces(table, one.medium.relaxation, time, place, turn, compliance)
    return found, table.radius_at(found.edge)


def triangle(count, free=0.0):
    time = np.linspace(-free, 2.0 + free, count)
    return time, np.where(time < 1.0, time, 2.0 - time), int(np.argmax(time > 1.0))


@pytest.mark.parametrize(
    ("solid", "stated"),
    [
        (
            Maxwell(0.25, 0.3),
            {0.5: (0.26465, math.sqrt(0.5)), 1.0: (0.48812, 1.0), 1.1: (0.18571, 0.92138), 1.2: (0.0012, 0.33849)},
        ),
        (SLS, {0.5: (0.306, math.sqrt(0.5)), 1.0: (0.65716, 1.0), 1.2: (0.18017, 0.80255), 1.4: (0.00082, 0.14335)}),
    ],
    ids=["Maxwell", "standard solid"],
)
def test_triangles_of_the_theory(solid, stated):
    time, place, turn = triangle(2001)
    found, radius = solutions(solid, time, place, turn)
    for at, (force, wide) in stated.items():
        index = int(np.argmin(np.abs(time - at)))
        assert found.force[index] == pytest.approx(force, abs=6e-6)
        assert radius[index] == pytest.approx(wide, abs=6e-6)


def test_a_power_law_in_and_out_is_the_closed_form_of_ting():
    """First touch falls within a step, over which the force is taken for straight: the error is of order 3/2."""
    errors = []
    for count in (2001, 8001):
        time, place, turn = triangle(count, free=0.2)
        found, _ = solutions(POWER, time, place, turn)
        before = np.where(time <= 1.0, time, time - 2.0 ** (1.0 / 0.8) * (time - 1.0))
        part = np.clip(before / np.where(time > 0.0, time, 1.0), 0.0, 1.0)
        exact = 2.0 * beta(1.5, 0.8) * np.maximum(time, 0.0) ** 1.3 * betainc(1.5, 0.8, part)
        errors.append(float(np.max(np.abs(found.force - exact)) / np.max(exact)))
        apart = time[turn + np.argmax(found.force[turn:] == 0.0)]
        touch = 2.0 ** (1.0 / 0.8)
        assert apart == pytest.approx(touch / (touch - 1.0), abs=2.0 * (time[1] - time[0]))
    assert errors[1] < 2e-6
    assert errors[0] < 1.2e-5


def test_a_dashpot_in_and_out_is_the_closed_form():
    """Loading F = 4/3 E* d^(3/2) + 2 eta* sqrt(d) d', unloading 4/3 E* (d + tau d')^(3/2), with tau = 0.2."""
    time, place, turn = triangle(1001)
    found, radius = solutions(KelvinVoigt(0.25, 0.05), time, place, turn)
    loading = 4.0 / 3.0 * place**1.5 + 2.0 * 0.2 * np.sqrt(np.maximum(place, 0.0))
    pressed = np.maximum(place - 0.2, 0.0)
    inward = slice(1, turn)
    outward = slice(turn + 2, -1)
    assert found.force[inward] == pytest.approx(loading[inward], rel=1e-6)
    assert found.force[outward] == pytest.approx(4.0 / 3.0 * pressed[outward] ** 1.5, abs=1e-5)
    assert radius[outward] == pytest.approx(np.sqrt(pressed[outward]), abs=1e-4)


@pytest.mark.parametrize("compliance", [0.0, 0.5])
@pytest.mark.parametrize(
    ("profile", "close"),
    [(wk.Paraboloid(1.0), 4e-5), (wk.Cone(0.7), 2e-4), (wk.Sphere(2.0), 4e-5), (wk.RoundedCone(0.7, 0.2), 3e-4)],
    ids=["paraboloid", "cone", "sphere", "rounded cone"],
)
def test_the_rows_of_springs_agree(profile, close, compliance):
    """A motion in that speeds up, a hold, and a retraction; the springs do not use Ting's time."""
    solid = Prony(0.05, [0.1, 0.15], [0.05, 0.7])
    time = np.linspace(0.0, 3.0, 901)
    place = np.where(time < 1.0, time**1.5, np.where(time < 1.6, 1.0 + 0.1 * (time - 1.0), 1.06 - 0.9 * (time - 1.6)))
    found, radius = solutions(solid, time, place, int(np.argmax(time > 1.6)), compliance, profile)
    assert found.depth + compliance * found.force == pytest.approx(place, abs=1e-9)
    springs = ViscoelasticIndentation(bed(solid, profile), Path(time, wk.Depth(found.depth)), count=1500).solve()
    assert np.max(np.abs(springs.force - found.force)) < close * np.max(springs.force)
    assert np.max(np.abs(springs.radius - radius)) < 5e-3 * np.max(radius)


def test_a_hold_after_a_sudden_step_is_the_relaxation():
    time = np.geomspace(1e-3, 10.0, 200)
    time = np.concatenate([[0.0], time])
    found, _ = solutions(SLS, time, np.ones(time.size), time.size)
    assert found.force == pytest.approx(4.0 / 3.0 * bed(SLS).medium.relaxation.at(time), rel=1e-12)


def test_a_compliant_machine_relaxes_what_the_integral_says():
    """Step of the machine by D = 1, paraboloid, Maxwell: F = Phi(d(0)) M(t) + integral of M(t-s) dPhi, d = 1 - cF."""
    solid, c = Maxwell(0.25, 0.5), 0.8
    time = np.concatenate([[0.0], np.linspace(1e-4, 2.0, 4001)])
    found, _ = solutions(solid, time, np.ones(time.size), time.size, c)
    # F' + F / tau = Phi'(d) d', d' = -c F': F' (1 + c Phi') = -F / tau, integrated over the force
    first = brentq(lambda f: f - 4.0 / 3.0 * (1.0 - c * f) ** 1.5, 0.0, 1.0)
    assert found.force[0] == pytest.approx(first, rel=1e-10)
    for index in (500, 2000, 4000):
        force = found.force[index]
        spent = quad(lambda f: 0.5 * (1.0 + 2.0 * c * math.sqrt(1.0 - c * f)) / f, force, first)[0]
        assert spent == pytest.approx(time[index], rel=2e-5)


def test_depths_under_a_force_are_those_of_creep():
    time = np.linspace(0.0, 5.0, 60)
    one = bed(SLS)
    table = elastic_table(elastic_like(one), 3.0)
    found = positions(table, one.medium.creep, time, np.full(time.size, 0.1))
    exact = (0.75 * 0.1 * one.medium.creep.at(time)) ** (2.0 / 3.0)
    assert found == pytest.approx(exact, rel=1e-11)
    assert np.isnan(positions(elastic_table(elastic_like(one), 0.1), one.medium.creep, time, np.full(60, 0.1))[-1])


def test_depths_under_a_ramp_are_the_integral_of_creep():
    time = np.linspace(0.0, 2.0, 11)
    one = bed(Maxwell(0.25, 0.5))
    table = elastic_table(elastic_like(one), 3.0)
    found = positions(table, one.medium.creep, time, 0.1 * time)
    exact = (0.75 * 0.1 * (time + time**2)) ** (2.0 / 3.0)  # integral of 1 + (t - s) / tau
    assert found == pytest.approx(exact, rel=1e-10, abs=1e-15)


def test_forces_there_and_back_give_the_motion():
    random = np.random.default_rng(7)
    time = np.linspace(0.0, 3.0, 3001)
    place = np.cumsum(random.uniform(0.0, 1.0, time.size)) / time.size
    place -= place[0]
    found, _ = solutions(SLS, time, place, time.size)
    one = bed(SLS)
    back = positions(elastic_table(elastic_like(one), 1.0), one.medium.creep, time, found.force)
    assert back[100:] == pytest.approx(place[100:], rel=2e-4)


def test_no_profile_is_followed_beyond_what_is_known_of_it():
    table_of = FilePath(__file__).parents[3] / "examples" / "data" / "measured_tip.csv"
    tip = wk.read_profile(table_of)
    one = wk.Foundation(tip, ViscoelasticHalfSpace(SLS))
    with pytest.raises(wk.OutsideValidity, match="the profile is not defined"):
        elastic_table(elastic_like(one), 1.0)
