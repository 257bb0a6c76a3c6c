"""Creep, relaxation and harmonic tests: closed forms, and the march through the same history."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.loading.loads import Depth, Force
from winkler.loading.path import Path
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.material_tests import CreepTest, RelaxationTest
from winkler.problems.viscoelastic.oscillation import HarmonicIndentation
from winkler.values.errors import InvalidInput


def bed(solid, profile=None) -> wk.Foundation:
    return wk.Foundation(wk.Paraboloid(1.0) if profile is None else profile, ViscoelasticHalfSpace(solid))


TIMES = np.array([1e-3, 0.1, 1.0, 10.0])


@pytest.mark.parametrize(
    ("solid", "creep"),
    [
        (KelvinVoigt(0.25, 0.075), -np.expm1(-TIMES / 0.3)),
        (Maxwell(0.25, 0.3), 1.0 + TIMES / 0.3),
        (StandardSolid(0.05, 0.2, 0.3), 5.0 - 4.0 * np.exp(-TIMES * 0.2 / 0.3)),
    ],
    ids=["Kelvin-Voigt", "Maxwell", "standard"],
)
def test_creep(solid, creep):
    """a^3 = (3 R F / 4) J*(t)."""
    result = CreepTest(bed(solid), 0.01, TIMES).solve()
    assert result.radius**3 == pytest.approx(0.0075 * creep, rel=1e-11)
    assert result.depth == pytest.approx(result.radius**2, rel=1e-12)
    assert np.all(result.force == 0.01)


@pytest.mark.parametrize("shape", [wk.Cone(1.2), wk.FlatPunch(0.3), wk.PowerLaw(1.0, 4.0)], ids=["cone", "flat", "r^4"])
def test_the_march_follows_the_closed_form(shape):
    solid = Prony(0.05, [0.1, 0.1], [0.1, 2.0])
    where = bed(solid, shape)
    creep = CreepTest(where, 0.01, TIMES[1:]).solve()
    path = Path(np.append(0.0, TIMES[1:]), Force(0.01))
    assert ViscoelasticIndentation(where, path).solve().depth[1:] == pytest.approx(creep.depth, rel=1e-5)
    relaxing = RelaxationTest(where, 0.2, TIMES).solve()
    path = Path(np.concatenate([[0.0, 0.0], TIMES]), Depth(np.append(0.0, np.full(5, 0.2))))
    assert ViscoelasticIndentation(where, path).solve().force[2:] == pytest.approx(relaxing.force, rel=1e-11)


def test_relaxation_of_a_cone():
    """F = E*(t) (2 / pi) d^2 tan(half angle)."""
    result = RelaxationTest(bed(StandardSolid(0.05, 0.2, 0.3), wk.Cone(1.2)), 0.1, TIMES).solve()
    exact = (0.2 + 0.8 * np.exp(-TIMES / 0.3)) * 2.0 / math.pi * 0.01 * math.tan(1.2)
    assert result.force == pytest.approx(exact, rel=1e-12)


def test_a_small_oscillation_marched_through():
    """The steady oscillation of the march about a held depth, by Fourier's sum over its last cycle."""
    solid = Prony(0.05, [0.1, 0.1], [0.05, 0.5])
    omega, depth, amplitude = 4.0, 0.25, 1e-5
    shaken = HarmonicIndentation(bed(solid), Depth(depth), omega).solve()
    time = np.linspace(0.0, 6.0 * 2.0 * math.pi / omega, 6 * 400 + 1)
    depths = depth + amplitude * np.sin(omega * time)
    result = ViscoelasticIndentation(bed(solid), Path(time, Depth(depths))).solve().force[-400:]
    last = time[-400:]
    in_phase, ahead = (2.0 * np.mean(result * wave(omega * last)) / amplitude for wave in (np.sin, np.cos))
    assert in_phase == pytest.approx(shaken.storage_stiffness, rel=2e-3)
    assert ahead == pytest.approx(shaken.loss_stiffness, rel=2e-3)


def test_harmonic_closed_forms():
    omega = np.array([0.1, 1.0, 10.0])
    result = HarmonicIndentation(bed(StandardSolid(0.05, 0.2, 0.3)), Depth(0.25), omega).solve()
    wt = 0.3 * omega
    assert result.storage_stiffness == pytest.approx(0.2 + 0.8 * wt**2 / (1.0 + wt**2), rel=1e-12)
    assert result.loss_tangent == pytest.approx(0.8 * wt / (1.0 + wt**2) / result.storage_stiffness, rel=1e-12)
    by_force = HarmonicIndentation(bed(StandardSolid(0.05, 0.2, 0.3)), Force(result.force), omega).solve()
    assert by_force.depth == pytest.approx(0.25, rel=1e-12)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: CreepTest(bed(Maxwell(1.0, 1.0)), -1.0, [1.0]), "force is -1.0"),
        (lambda: CreepTest(bed(Maxwell(1.0, 1.0)), 1.0, [0.0]), "time is"),
        (lambda: RelaxationTest(bed(Maxwell(1.0, 1.0)), 0.0, [1.0]), "depth is 0.0"),
        (lambda: HarmonicIndentation(bed(Maxwell(1.0, 1.0)), Force(1.0), 1.0), "creeps without limit"),
        (lambda: HarmonicIndentation(bed(Maxwell(1.0, 1.0)), Depth([1.0, 2.0]), 1.0), "one positive number"),
        (lambda: HarmonicIndentation(bed(Maxwell(1.0, 1.0)), Depth(1.0), -1.0), "angular_frequency"),
    ],
)
def test_what_is_refused(make, message):
    with pytest.raises(InvalidInput, match=message):
        make()
