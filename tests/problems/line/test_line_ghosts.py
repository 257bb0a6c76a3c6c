"""Ghosts: a parabola that is no `Paraboloid`, and layers of no family, in each problem of a line contact."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import numpy as np
import pytest

import winkler as wk
from winkler.profiles.profile import RisingShape
from winkler.values.value import value

SOLID = wk.Elastic(0.91, 0.3, strength=0.2)
PLAIN = wk.HalfSpace(SOLID)
STEEL = wk.ThermalConductor(45.0, 12e-6)
WIRE = wk.ElectricalConductor(0.2e-6)
MU = wk.Coulomb(0.3)
LOAD = wk.LineForce(0.1)


@value
class Parabola(RisingShape):
    """f = x^2 / 2, known by its values alone."""

    def height(self, r):
        return 0.5 * r * r

    def slope(self, r):
        return 1.0 * r

    def curvature(self, r):
        return np.ones(np.shape(r))


def numbers(*names) -> Callable[[object], np.ndarray]:
    def read(solution):
        return np.array([np.ravel(getattr(solution, name))[-1] for name in names], dtype=float)

    return read


PATH = wk.LinePath([0.1, 0.1, 0.12, 0.08], [0.0, 0.02, -0.01, 0.01])
PULLED = wk.LinePath(0.1, [0.0, 0.02, -0.01], bulk_stress=0.02)
SLIPS = numbers("half_width", "stick_half_width", "slip_shift", "dissipation_per_length")


def heated(bed):
    pair = wk.HeatConductors(STEEL, STEEL)
    return wk.LineFrictionHeating(wk.LineIndentation(bed, LOAD), MU, pair, first_speed=3e-5, second_speed=1e-5).solve()


def fretted(bed):
    swing = wk.LineShearForce(0.01)
    return wk.LineFrettingWear(bed, wk.Archard(1e-3), MU, LOAD, swing, cycles=[0.0, 10.0], count=24).solve()


def conducting(bed):
    pair = wk.ElectricalConductors(WIRE, WIRE)
    return wk.LineConstriction(wk.LineIndentation(bed, LOAD), pair, first_depth=2.0, second_depth=2.0).solve()


def worn(bed):
    return wk.LineSlidingWear(bed, wk.Archard(1e-3), LOAD, distance=[0.0, 1.0], count=24).solve()


PROBLEMS = {
    "LineIndentation": (
        lambda bed: wk.LineIndentation(bed, LOAD).solve(), numbers("half_width", "peak_pressure"), 1e-11
    ),
    "LineTangential": (lambda bed: wk.LineTangential(bed, MU, PATH).solve(), SLIPS, 1e-9),
    "LineTangential, bulk": (lambda bed: wk.LineTangential(bed, MU, PULLED).solve(), SLIPS, 2e-3),
    "LineFrictionHeating": (heated, numbers("flash_temperature", "first_mean_temperature"), 1e-9),
    "LineConstriction": (conducting, numbers("resistance_per_length"), 1e-11),
    "LineYieldOnset": (
        lambda bed: wk.LineYieldOnset(bed, wk.Coulomb(0.1)).solve(), numbers("force_per_length", "z"), 1e-6
    ),
    "LineShakedown": (lambda bed: wk.LineShakedown(bed, MU).solve(), numbers("force_per_length"), 1e-9),
    "LineAdhesion": (
        lambda bed: wk.LineAdhesion(bed, wk.ShortRange(1e-4), LOAD).solve(), numbers("half_width"), 1e-10
    ),
    "LineAdhesion, Dugdale": (
        lambda bed: wk.LineAdhesion(bed, wk.Dugdale(1e-4, strength=0.01), LOAD).solve(), numbers("half_width"), 1e-9
    ),
    "LineLimitingProfile": (
        lambda bed: wk.LineLimitingProfile(bed, MU, LOAD, wk.LineShearForce(0.01)).solve(),
        numbers("half_width", "stick_half_width"),
        1e-9,
    ),
    "LineFrettingWear": (fretted, numbers("half_width"), 1e-9),
    "LineSlidingWear": (worn, numbers("half_width"), 1e-9),
    "PeriodicIndentation": (
        lambda bed: wk.PeriodicIndentation(bed, 2.0, LOAD).solve(), numbers("half_width"), 1e-9
    ),
    "LineViscoelasticIndentation": (
        lambda bed: wk.LineViscoelasticIndentation(
            dataclasses.replace(bed, medium=wk.ViscoelasticHalfSpace(wk.StandardSolid(0.05, 0.2, 0.5))),
            wk.LineForcePath([0.0, 1.0, 2.0], [0.0, 1e-3, 0.5e-3], count=8),
        ).solve(),
        numbers("half_width"),
        1e-6,
    ),
}  # fmt: skip
ROLL = wk.LineShearForce(0.01)
ROLLED = numbers("longitudinal_creepage", "stick_share")
ROLLING = {
    "LineRolling": (lambda bed: wk.LineRolling(bed, MU, ROLL, LOAD).solve(), ROLLED, 0.0),
    "LineRolling, coupled": (lambda bed: wk.LineRolling(bed, MU, ROLL, LOAD, coupled=True).solve(), ROLLED, 0.0),
    "LineRollingStart": (
        lambda bed: wk.LineRollingStart(bed, MU, ROLL, LOAD, distance=0.1, points=1, count=20).solve(), ROLLED, 0.0
    ),
}  # fmt: skip
"""On ghosts of layers alone."""
SLOW_OF_GHOSTS = ("LineShakedown", "LineViscoelasticIndentation")
NOT_FOR_GHOSTS = {
    "LinePlasticIndentation": "the tables of metals are those of a cylinder",
    "LineRolling": "only a round body keeps its profile while it rolls",
    "LineRollingStart": "only a round body keeps its profile while it rolls",
    "LineRollingResistance": "only a round body keeps its profile while it rolls",
}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.slow] * (name in SLOW_OF_GHOSTS)) for name in PROBLEMS]
)
def test_a_parabola_that_is_no_paraboloid_gives_the_same_numbers(name):
    solve, read, error = PROBLEMS[name]
    known, ghost = (read(solve(wk.LineFoundation(shape, PLAIN))) for shape in (wk.Paraboloid(1.0), Parabola()))
    assert np.all(np.isfinite(known))
    np.testing.assert_allclose(ghost, known, rtol=error)


def test_all_problems_of_lines_are_walked():
    """By name, so that a new one is added here, or to those that say why they take no ghost."""
    found = {
        name
        for name in wk.__all__
        if dataclasses.is_dataclass(kind := getattr(wk, name))
        and hasattr(kind, "solve")
        and any(
            (field.name == "bed" and "LineFoundation" in str(field.type))
            or (field.name == "contact" and str(field.type).startswith("LineIndentation["))
            for field in dataclasses.fields(kind)
        )
    }
    assert found == {name.split(",")[0] for name in PROBLEMS} | set(NOT_FOR_GHOSTS)


def delegated(name):
    return property(lambda self: getattr(self.of, name))


@dataclasses.dataclass(frozen=True)
class Ghost:
    """Layers that belong to no family."""

    of: wk.CoatedHalfSpace

    layers, stack, on, second = (delegated(name) for name in ("layers", "stack", "on", "second"))
    thickness, spans, modulus = (delegated(name) for name in ("thickness", "spans", "modulus"))
    along_modulus, response, along_response, coupling_response = (
        delegated(name) for name in ("along_modulus", "response", "along_response", "coupling_response")
    )


COATED = wk.CoatedHalfSpace([wk.Layer(SOLID, 0.2)], wk.Elastic(0.2, 0.4, strength=0.1), wk.Elastic(5.0, 0.2))
ON_LAYERS = (
    "PeriodicIndentation",
    "LineIndentation",
    "LineTangential",
    "LineFrictionHeating",
    "LineConstriction",
    "LineYieldOnset",
    "LineShakedown",
    "LineAdhesion",
    "LineLimitingProfile",
    "LineFrettingWear",
    "LineSlidingWear",
    *ROLLING,
)


SLOW_ON_LAYERS = (
    "PeriodicIndentation",
    "LineTangential",
    "LineTangential, bulk",
    "LineYieldOnset",
    "LineShakedown",
    "LineRolling, coupled",
)


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.long)
        if name == "LineAdhesion, Dugdale"
        else pytest.param(name, marks=[pytest.mark.slow] * (name in SLOW_ON_LAYERS))
        for name in (*PROBLEMS, *ROLLING)
    ],
)
def test_layers_of_no_family_give_the_same_numbers_or_the_same_refusal(name):
    solve, read, _ = (PROBLEMS | ROLLING)[name]
    beds = [wk.LayeredLineFoundation(wk.Paraboloid(1.0), medium) for medium in (COATED, Ghost(COATED))]
    if name.split(",")[0] in ON_LAYERS:
        known, ghost = (read(solve(bed)) for bed in beds)
        np.testing.assert_allclose(ghost, known, rtol=1e-12)
        return
    known, ghost = (refusal(solve, bed) for bed in beds)
    assert known == ghost.replace("Ghost", "CoatedHalfSpace")


def test_strips_on_layers_of_no_family_are_the_same():
    row = wk.CylinderRow([1.0, 0.7], [-0.2, 0.2], [0.0, 0.0])
    known, ghost = (wk.LineProfileContact(row, medium, LOAD).solve() for medium in (COATED, Ghost(COATED)))
    np.testing.assert_allclose(ghost.edges, known.edges, rtol=1e-12)
    stresses = [one.stresses([0.0, 0.3], [0.1, 0.4], 0.1).von_mises for one in (ghost, known)]
    np.testing.assert_allclose(*stresses, rtol=1e-12)


def refusal(solve, bed):
    with pytest.raises(wk.WinklerError) as caught:
        solve(bed)
    return str(caught.value)


RELAXING = wk.RelaxingInProportion(COATED, wk.StandardSolid(0.2, 0.8, 0.5), shear=1.0)
GEL = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(wk.StandardSolid(0.2, 0.8, 0.5), 0.2)], on=SOLID)


@pytest.mark.parametrize("medium", [RELAXING, GEL])
@pytest.mark.parametrize("name", [name for name in (*PROBLEMS, *ROLLING) if name != "LineViscoelasticIndentation"])
def test_layers_that_relax_are_not_taken_for_elastic_ones(name, medium):
    solve, _, _ = (PROBLEMS | ROLLING)[name]
    with pytest.raises((wk.OutsideValidity, wk.InvalidInput)):
        solve(wk.LayeredLineFoundation(wk.Paraboloid(1.0), medium))


@dataclasses.dataclass(frozen=True)
class RelaxingGhost:
    """Layers that relax and belong to no family."""

    of: wk.RelaxingInProportion


for member in sorted({name for name in dir(RELAXING) if name[0] != "_"}):
    setattr(RelaxingGhost, member, delegated(member))


def test_layers_that_relax_are_asked_for_what_they_offer():
    bed, ghost = (wk.LayeredLineFoundation(wk.Paraboloid(1.0), one) for one in (RELAXING, RelaxingGhost(RELAXING)))
    path = wk.LineForcePath([0.0, 1.0, 2.0], [0.0, 1e-3, 0.5e-3], count=2)
    for solve, names in (
        (lambda bed: wk.LineViscoelasticIndentation(bed, path, count=20).solve(), ("half_width", "peak_pressure")),
        (
            lambda bed: wk.LineRollingResistance(bed, wk.HalfWidth(0.1), 0.5).solve(),
            ("force_per_length", "coefficient"),
        ),
    ):
        known, other = (numbers(*names)(solve(each)) for each in (bed, ghost))
        np.testing.assert_allclose(other, known, rtol=1e-12)
