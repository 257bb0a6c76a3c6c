"""Ghosts: media of no class, delegating to a coating, stack, grading or power law, in problems on beds and on maps."""

from __future__ import annotations

import dataclasses
import functools
import re
from typing import Any

import numpy as np
import pytest
from change_of_units import Units
from example_answers import COSTLY, example_problem

import winkler as wk
from winkler.study.language.catalogue import CATALOGUE
from winkler.values.vocabulary import word

SOLID, BASE = wk.Elastic(0.91, 0.3, strength=0.2), wk.Elastic(0.2, 0.4, strength=0.1)
MEDIA = {
    "coating": wk.CoatedHalfSpace([wk.Layer(SOLID, 0.2)], BASE, wk.Elastic(5.0, 0.2)),
    "stack": wk.StackedHalfSpace([wk.StackLayer(SOLID, 0.2), wk.StackLayer(BASE, 0.3, bonded=False)], SOLID),
    "grading": wk.DepthGradedHalfSpace(wk.ExponentialGrading(0.9, 0.3, depth_scale=0.3, poisson=0.3), tolerance=1e-4),
    "relaxing layers": wk.ViscoelasticCoatedHalfSpace(
        [wk.ViscoelasticLayer(wk.StandardSolid(0.2, 0.3, 1.0), 0.2)], BASE
    ),
    "power law": wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 0.5, 0.3, 0.3)),
}


@functools.cache
def ghost_of(medium: Any) -> Any:
    """Return a medium that has the public members of another one, and none of its classes."""

    def delegated(name: str) -> Any:
        if callable(getattr(type(medium), name, None)):
            return lambda self, *given, **named: getattr(self.of, name)(*given, **named)
        return property(lambda self: getattr(self.of, name))

    names = {*dir(type(medium)), *(field.name for field in dataclasses.fields(medium))}
    members = {name: delegated(name) for name in names if not name.startswith("_")}
    kind = type("Ghost", (), {**members, "__annotations__": {"of": Any}})
    return dataclasses.dataclass(frozen=True)(kind)(medium)


MU, DEPTH, LOAD = wk.Coulomb(0.3), wk.Depth(0.02), wk.Force(0.005)
SHORT, FAR = wk.ShortRange(1e-4), wk.Dugdale(1e-4, strength=0.02)
STEEL = wk.HeatConductors(wk.ThermalConductor(45.0, 12e-6), wk.ThermalConductor(45.0, 12e-6))
PUSH = wk.Path.through(LOAD, wk.ShearForce([0.0, 0.001, -0.0005]))
SPECTRUM = wk.SelfAffine(hurst=0.8, rms_height=1e-3, longest=0.1, shortest=0.01)
COARSE = {
    "AdhesiveImpact": lambda bed: wk.AdhesiveImpact(bed, SHORT, 1.0, 0.01, count=11),
    "AdhesiveIndentation, Dugdale": lambda bed: wk.AdhesiveIndentation(bed, FAR, LOAD),
    "ContactLaw": lambda bed: wk.ContactLaw(bed, 0.02),
    "FrettingWear": lambda bed: wk.FrettingWear(
        bed, wk.Archard(1e-3), MU, DEPTH, wk.Shift(0.003), [0.0, 1.0], count=30, tolerance=1e-2
    ),
    "Impact": lambda bed: wk.Impact(bed, MU, 1.0, 0.01, 0.002, count=11),
    "RoughIndentation": lambda bed: wk.RoughIndentation(SPECTRUM, bed, 1.0, LOAD, realisations=2, count=128),
    "SlidingResistance": lambda bed: wk.SlidingResistance(bed, LOAD, 1.0, count=10),
    "SlidingWear": lambda bed: wk.SlidingWear(bed, wk.Archard(1e-3), LOAD, [0.0, 1.0], count=30, tolerance=1e-2),
    "Tangential, springs": lambda bed: wk.Tangential(bed, MU, PUSH, wk.Method.SPRINGS),
    "ViscoelasticImpact": lambda bed: wk.ViscoelasticImpact(bed, 1.0, 0.01, count=20),
    "YieldOnset, sliding": lambda bed: wk.YieldOnset(bed, MU),
}
"""Problems on beds whose examples would last, or of which another method or law is looked at besides."""


BODIES, HILL = wk.CurvedBodies(1.0, 2.0), wk.SampledProfile([0.6, 0.6], wk.Paraboloid(1.0), (16, 16))
FINE_HILL = wk.SampledProfile([0.6, 0.6], wk.Paraboloid(1.0), (32, 32))
OVAL = tuple(wk.Paraboloid(radius) for radius in (1.0, 1.5, 2.0, 1.5))
Y = np.linspace(-0.5, 0.5, 11)
PAIR = wk.CrossProfile(Y, 0.0 * Y), wk.CrossProfile(Y, 0.5 * Y**2)
ROLLER = 0.2, 0.5, wk.CrownedEnds(2.0)
SHEAR = wk.Path.through(LOAD, wk.ShearForce([0.0, 0.0005]))
FRETS = wk.Path.through(LOAD, wk.ShearForce([0.0, 0.0005, -0.0005, 0.0005, -0.0005]))
ON_SURFACES = {
    "FrictionHeating, ellipse": lambda medium: wk.FrictionHeating(
        wk.EllipticIndentation(BODIES, medium, LOAD), MU, STEEL, 3e-5
    ),
    "EllipticIndentation": lambda medium: wk.EllipticIndentation(BODIES, medium, LOAD),
    "EllipticWear": lambda medium: wk.EllipticWear(BODIES, medium, wk.Archard(1e-3), LOAD, 1.0),
    "JointStiffness": lambda medium: wk.JointStiffness(HILL, medium, MU, LOAD),
    "NearlyRoundIndentation": lambda medium: wk.NearlyRoundIndentation(OVAL, medium, LOAD),
    "ProfilePair": lambda medium: wk.ProfilePair(*PAIR, medium, LOAD, second_radius=1.0, pixels=16),
    "ProfilePairRolling": lambda medium: wk.ProfilePairRolling(
        wk.ProfilePair(*PAIR, medium, LOAD, second_radius=1.0, pixels=16), MU, lateral_drift=1e-2
    ),
    "ReducedFriction": lambda medium: wk.ReducedFriction(FINE_HILL, medium, MU, 0.04),
    "Reduction": lambda medium: wk.Reduction(FINE_HILL, medium, 0.04),
    "RollerContact": lambda medium: wk.RollerContact(*ROLLER, medium, LOAD, elements=16),
    "RoughContact": lambda medium: wk.RoughContact(SPECTRUM, medium, 1.0, LOAD, realisations=2, count=128),
    "SurfaceAdhesion": lambda medium: wk.SurfaceAdhesion(HILL, medium, FAR, wk.Depth([0.005, 0.01])),
    "SurfaceContact": lambda medium: wk.SurfaceContact(HILL, medium, LOAD),
    "SurfaceFrictionHeating": lambda medium: wk.SurfaceFrictionHeating(
        wk.SurfaceTangential(HILL, medium, MU, FRETS), STEEL, frequency=100.0
    ),
    "SurfaceRolling": lambda medium: wk.SurfaceRolling(HILL, medium, LOAD, MU, wk.Creepage(1e-2)),
    "SurfaceRollingStart": lambda medium: wk.SurfaceRollingStart(HILL, medium, LOAD, MU, wk.Creepage(1e-2), 0.1),
    "SurfaceTangential": lambda medium: wk.SurfaceTangential(HILL, medium, MU, SHEAR),
}  # fmt: skip


KINDS = {line.cls.__name__: kind for kind, line in CATALOGUE["problem"].items()}


def taken(kind: type) -> str:
    """Return the field in which a problem takes what lies on a medium: a bed, a medium, or a contact; or nothing."""
    types = {field.name: str(field.type) for field in dataclasses.fields(kind)}
    if types.get("bed") in ("Bed", "Foundation"):
        return "bed"
    if "MappedMedium" in types.get("medium", ""):
        return "medium"
    if types.get("contact", "").startswith("Indentation") and "conductors" in types:
        return "contact"
    return next((name for name, given in types.items() if given == "ProfilePair"), "")


TAKEN = {name: field for name, kind in KINDS.items() if (field := taken(CATALOGUE["problem"][kind].cls))}
PROBLEMS = sorted({*COARSE, *(name for name, field in TAKEN.items() if field in ("bed", "contact"))})
"""On beds: a kind of the catalogue needs no entry."""


def first_number(content: Any, unit: str) -> float:
    """Return the greatest of the first numbers of a unit in a value, the bodies of the bed before all others."""
    for field in dataclasses.fields(content):
        inside = getattr(content, field.name)
        if dataclasses.is_dataclass(inside):
            found = first_number(inside, unit)
        else:
            numeric = isinstance(inside, float | np.ndarray) and word(type(content), field.name).unit == unit
            found = float(np.max(inside)) if numeric else 0.0
        if 0.0 < found < np.inf:
            return found
    return 0.0


def by_example(name: str, medium: Any) -> Any:
    """Return the problem of an example on another medium, in units in which its first radius and modulus are 1."""
    problem, field = example_problem(KINDS[name]), TAKEN[name]
    units = Units(1.0 / first_number(problem, "m"), 1.0 / first_number(problem, "Pa"))
    changed, bed = units.changed(problem), wk.Foundation(wk.Paraboloid(1.0), medium)
    on = {"bed": bed, "medium": medium}
    on["contact"] = dataclasses.replace(changed.contact, bed=bed) if field == "contact" else None
    return dataclasses.replace(changed, **{field: on[field]})


def test_all_problems_on_a_bed_or_a_surface_are_walked():
    assert len(PROBLEMS) >= 44
    assert {name.split(",")[0] for name in ON_SURFACES} == {
        *(name for name, field in TAKEN.items() if field not in ("bed", "contact")),
        *("FrictionHeating", "SurfaceFrictionHeating"),
    }  # fmt: skip


@pytest.mark.slow
def test_examples_on_a_coating_have_numbers():
    """Else problems by their examples would be looked at in vain: both would refuse."""
    quick = [name for name in PROBLEMS if name not in COARSE and KINDS[name] not in COSTLY]
    assert sum(bool(outcome(name, MEDIA["coating"])[1]) for name in quick) >= 18


def outcome(name: str, medium: Any) -> tuple[list[str], list[np.ndarray]]:
    """Return the sentences and the numbers of an answer and of its validity, or the refusal."""
    try:
        problem = (
            ON_SURFACES[name](medium)
            if name in ON_SURFACES
            else COARSE[name](wk.Foundation(wk.Paraboloid(1.0), medium))
            if name in COARSE
            else by_example(name, medium)
        )
        solution = problem.solve()
        stated = solution.validity
    except wk.WinklerError as refusal:
        return [type(refusal).__name__, masked(str(refusal), medium)], []
    sentences = [masked(f"{note.assumption} {note.standing} {note.statement}", medium) for note in stated]
    return sentences, list(numbers(solution))


def masked(sentence: str, medium: Any) -> str:
    """Return a sentence without the name of the medium, or of the one it delegates to."""
    names = "|".join(type(one).__name__ for one in (medium, getattr(medium, "of", medium)))
    return re.sub(rf"\b({names})\b", "MEDIUM", sentence)


def numbers(answer: Any) -> Any:
    """Yield all numbers of an answer, those of its parts included, but not of the question."""
    if isinstance(answer, np.ndarray | float | int):
        yield np.asarray(answer, dtype=float)
    elif isinstance(answer, tuple):
        for part in answer:
            yield from numbers(part)
    elif dataclasses.is_dataclass(answer) and not isinstance(answer, wk.Foundation):
        for field in dataclasses.fields(answer):
            if field.name not in ("problem", "bed"):
                yield from numbers(getattr(answer, field.name))


QUICK = {
    *((name, "coating") for name in ("RollerContact", "SurfaceContact", "SurfaceTangential")),
    ("FrictionDamping", "coating"),
    ("Tangential", "coating"),
    ("Indentation", "stack"),
    ("Indentation", "grading"),
}
LONG = {
    *((name, medium) for name in ("YieldOnset", "YieldOnset, sliding", "AdhesiveImpact") for medium in MEDIA),
    *((name, "grading") for name in ("AdhesiveShear", "BimodalDamping", "Impact", "LimitingProfile", "Tangential")),
    *((name, "grading") for name in ("JointStiffness", "ProfilePairRolling", "ReducedFriction")),
    *((name, "coating") for name in ("FrictionHeating", "Impact", "ReducedFriction")),
    *(("AdhesiveIndentation, Dugdale", medium) for medium in ("stack", "grading")),
}


def marked(name: str, medium: str) -> Any:
    slow_on_power_law = ("AdhesiveImpact", "AdhesiveIndentation, Dugdale", "FrictionHeating", "Impact", "Torsion")
    quick = medium == "power law" and name in PROBLEMS and name not in slow_on_power_law
    if quick or (name, medium) in QUICK:
        return pytest.param(name, medium)
    late = (name, medium) in LONG or ([*PROBLEMS, *ON_SURFACES].index(name) + list(MEDIA).index(medium)) % 2
    return pytest.param(name, medium, marks=pytest.mark.long if late else pytest.mark.slow)


@pytest.mark.parametrize(
    ("name", "medium"), [marked(name, medium) for medium in MEDIA for name in (*PROBLEMS, *ON_SURFACES)]
)
def test_a_medium_of_no_class_gives_the_same_numbers_or_the_same_refusal(name, medium):
    known, ghost = (outcome(name, each) for each in (MEDIA[medium], ghost_of(MEDIA[medium])))
    assert known[1] or (name, medium) not in QUICK
    assert ghost[0] == known[0]
    assert len(ghost[1]) == len(known[1])
    for one, other in zip(ghost[1], known[1], strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-300)


RUBBER = wk.StandardSolid(0.1, 0.2, 1.0, poisson=0.3)
RELAXING = {
    "a half-space": wk.ViscoelasticHalfSpace(RUBBER),
    "two of one course": wk.ViscoelasticHalfSpace(RUBBER, wk.StandardSolid(0.2, 0.4, 1.0)),
    "two of two courses": wk.ViscoelasticHalfSpace(RUBBER, SOLID),
    "a coating": wk.RelaxingInProportion(MEDIA["coating"], RUBBER, 0.1),
    "layers by their own laws": wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(RUBBER, 0.2)], on=BASE),
}


@pytest.mark.parametrize("name", RELAXING)
def test_a_map_on_a_ghost_that_relaxes(name):
    known, ghost = (outcome("SurfaceTangential", each) for each in (RELAXING[name], ghost_of(RELAXING[name])))
    assert ghost[0] == known[0]
    assert len(ghost[1]) == len(known[1])
    for one, other in zip(ghost[1], known[1], strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-300)
    assert bool(known[1]) == (name != "two of two courses")


BONDED = wk.StackedHalfSpace([wk.StackLayer(SOLID, 0.2)], BASE, wk.Elastic(5.0, 0.2))
QUICK_ON_STACK = ("FrictionDamping", "Tangential", "Indentation")
SLOW_ON_STACK = ("AdhesiveShear", "FrettingWear", "Rolling", "SlidingWear", "Torsion")


@pytest.mark.parametrize(
    "name", [*QUICK_ON_STACK, *(pytest.param(name, marks=pytest.mark.slow) for name in SLOW_ON_STACK)]
)
def test_a_coating_is_the_stack_of_the_same_layers(name):
    """Numbers and notes; only the note of the medium itself names other layers."""
    found = []
    for medium in (MEDIA["coating"], BONDED):
        own = {note.statement for note in medium.notes}
        sentences, values = outcome(name, medium)
        found.append(([line for line in sentences if not any(line.endswith(note) for note in own)], values))
    (coated, numbers_on_coating), (stacked, numbers_on_stack) = found
    assert stacked == coated
    for one, other in zip(numbers_on_stack, numbers_on_coating, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-300)


def test_a_pyramid_on_a_bonded_stack_has_the_note_of_the_coating():
    """By how much the cone that stands for it is wrong was said of a CoatedHalfSpace alone."""
    tip = wk.Pyramid(face_angle=0.3, sides=4)
    coated, stacked = (
        wk.Indentation(wk.Foundation(tip, medium), DEPTH).solve().validity for medium in (MEDIA["coating"], BONDED)
    )
    assert coated[1:] == stacked[1:]


def test_stresses_of_a_push_in_an_anisotropic_second_body_are_refused_for_that():
    """They were refused because that body were rigid."""
    second = wk.TransverselyIsotropic(2.0, 0.5, 0.4, 1.5, 0.6)
    medium = wk.StackedHalfSpace([wk.StackLayer(SOLID, 0.2)], BASE, second)
    pressed = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), medium), DEPTH).solve().pressed
    place = np.array([0.05])
    with pytest.raises(wk.OutsideValidity, match="transversely isotropic second body"):
        medium.pushed_interior(pressed, place, place, place, below=False)
