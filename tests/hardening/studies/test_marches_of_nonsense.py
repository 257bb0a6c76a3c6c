"""Marches with numbers of any finite size: states without an undefined number, or one sentence, by both methods."""

from __future__ import annotations

import dataclasses
import itertools
import math
import warnings

import numpy as np
import pytest

import winkler as wk
from winkler.study.language.build import build
from winkler.study.language.catalogue import kinds, slot_of
from winkler.study.language.explain import completed
from winkler.values.errors import InvalidInput, OutsideValidity, WinklerError
from winkler.values.value import value

MARCHES = [name for name, line in kinds().items() if hasattr(line.cls, "steps")]
SIZES = (1e200, 1e59, 1e30, 1e-30, 1e-59, 1e-200, 1e-308)
STATES = 5
SLOW = (
    "impact",
    "adhesive_impact",
    "viscoelastic_adhesion",
    "surface_adhesion",
    "surface_contact",
    "reduction",
    "fretting_wear",
    "sliding_wear",
    "surface_wear",
    "impacts",
)
"""They may take minutes to find that numbers do not fit together."""


def numbers(content, route=()):
    """Yield the route to every number inside a value that has a unit or none, but no count."""
    for field in dataclasses.fields(content):
        if not field.init:
            continue
        inside = getattr(content, field.name)
        if isinstance(inside, float | np.ndarray):
            yield (*route, field.name)
        elif dataclasses.is_dataclass(inside):
            yield from numbers(inside, (*route, field.name))
        elif isinstance(inside, tuple):
            for place, one in enumerate(inside):
                if dataclasses.is_dataclass(one):
                    yield from numbers(one, (*route, field.name, place))


def put(content, route, size):
    """Return a value with a number of a size at a place inside it."""
    key, *rest = route
    if isinstance(key, int):
        return (*content[:key], put(content[key], rest, size), *content[key + 1 :])
    inside = getattr(content, key)
    if rest:
        new = put(inside, rest, size)
    else:
        new = inside / np.max(np.abs(inside)) * size if isinstance(inside, np.ndarray) else size
    return dataclasses.replace(content, **{key: new})


def undefined(answer) -> list[str]:
    """Return the numbers of an answer that are none."""
    found = ((field.name, getattr(answer, field.name)) for field in dataclasses.fields(answer))
    return [
        name
        for name, inside in found
        if (isinstance(inside, float) and math.isnan(inside))
        or (isinstance(inside, np.ndarray) and inside.dtype == float and np.isnan(inside).any())
    ]


def faults(name: str, start: int = 0, step: int = 1) -> list[str]:
    """Return what is wrong with the marches of a kind, for each number with every so many sizes."""
    example, wrong = build(completed({"kind": name}), slot_of(name)), []
    routes = enumerate(numbers(example))
    for route, size in [(route, size) for n, route in routes for size in SIZES[(start + n) % step :: step]]:
        where = f"{'.'.join(map(str, route))} = {size:g}"
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                for state in itertools.islice(put(example, route, size).steps(), STATES):
                    if bad := undefined(state):
                        wrong.append(f"{where}: {bad}")
        except WinklerError as error:
            if not str(error).rstrip().endswith((".", ")")):
                wrong.append(f"{where}: {error}")
        except Exception as error:  # collected, and shown together
            wrong.append(f"{where}: {type(error).__name__} {error}")
    return wrong


def test_a_quick_march():
    assert faults("elastic_plastic_particle") == []


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize("start", [0, pytest.param(1, marks=pytest.mark.long)])
@pytest.mark.parametrize("name", [name for name in MARCHES if name not in SLOW])
def test_every_march(name, start):
    """Each number with every second size, its neighbours with the sizes between; the rest are long tests."""
    assert faults(name, start, 2) == []


BALL = wk.Foundation(wk.Sphere(10e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3)))


@value
class Undefined:
    """What a compiled kernel returns that has lost its numbers: numpy does not warn of them."""

    force: float


@value
class Losing:
    """A problem that loses its numbers in a kernel."""

    size: float = 1.0

    def solve(self) -> Undefined:
        """Return nothing."""
        return Undefined(math.nan)

    def steps(self):
        """Yield nothing."""
        yield Undefined(math.nan)


@pytest.mark.parametrize("method", [lambda problem: problem.solve(), lambda problem: list(problem.steps())])
def test_what_overflows_in_a_kernel_is_stated_by_both_methods(method):
    with pytest.raises(
        OutsideValidity, match=r"^Losing: .* cannot be computed \(the force comes out undefined\); check"
    ):
        method(Losing())


def test_no_load_is_beyond_physics():
    with pytest.raises(InvalidInput, match=r"^Depth: depth is up to 1e\+200 in size; numbers in SI units"):
        wk.Path([0.0, 1.0, 2.0], wk.Depth([1e200, 1e200, 1e200]), wk.Shift([0.0, 1e-6, -1e-6]))


def test_who_iterates_may_overflow_between_steps():
    """The guard of a march ends with each of its steps."""
    path = wk.Path([0.0, 1.0], wk.Force(100.0), wk.Shift([0.0, 1e-6]))
    with np.errstate(over="ignore"):
        for _ in wk.Tangential(BALL, wk.Coulomb(0.3), path).steps():
            assert np.isinf(np.array([1e300]) ** 2)


def test_coefficients_that_cannot_be_divided():
    with pytest.raises(
        InvalidInput, match=r"^StaticKinetic: kinetic_coefficient is 1e-308; numbers .* are between 1e-60 and"
    ):
        wk.StaticKinetic(0.3, 1e-308)
    path = wk.Path(np.linspace(0.0, 1.0, 9), wk.Force(100.0), wk.Shift(1e-6 * np.sin(np.linspace(0.0, 9.0, 9))))
    lost = [wk.Tangential(BALL, wk.StaticKinetic(0.3, mu), path).solve().dissipation[-1] for mu in (1e-60, 1e-20)]
    assert lost[0] == pytest.approx(lost[1], rel=1e-12)


@pytest.mark.parametrize("exponent", [1e-308, 9e-4, 1.1, 0.0])
def test_exponents_of_cracks(exponent):
    with pytest.raises(InvalidInput, match=rf"^RateDependentWork: exponent is {exponent}; it must be a number from 0"):
        wk.RateDependentWork(work=0.05, reference_speed=1e-6, exponent=exponent)


@pytest.mark.slow
def test_the_smallest_exponent_of_a_crack():
    """A law that is a step: the edge rests until it is driven by twice the work, so JKR with 2 w pulls it off."""
    bed = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e6, 0.5)))
    law = wk.RateDependentWork(work=0.05, reference_speed=1e-6, exponent=1e-3)
    pulled = wk.ViscoelasticAdhesion(bed, law, wk.Path([0.0, 50.0], wk.Depth([5e-6, -45e-6]))).solve()
    assert pulled.lowest_force[-1] == pytest.approx(-1.5 * np.pi * 0.1 * 1e-3, rel=5e-3)


@pytest.mark.parametrize(("distance", "word"), [(1e-12, "short"), (1e6, "long")])
def test_a_distance_that_cannot_be_sampled(distance, word):
    problem = wk.RollingStart(BALL, wk.Coulomb(0.3), wk.Creepage(longitudinal=1e-3), wk.Force(100.0), distance)
    for method in (problem.solve, lambda: next(problem.steps())):
        with pytest.raises(OutsideValidity, match=rf"^RollingStart: .* is so {word} beside the contact radius"):
            method()
