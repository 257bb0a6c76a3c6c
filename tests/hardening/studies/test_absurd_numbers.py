"""Numbers beyond all physics in any study: a solution with all its properties, or one sentence; never a warning."""

from __future__ import annotations

import dataclasses
import functools
import warnings

import numpy as np
import pytest

import winkler as wk
from winkler.cli import main
from winkler.study.language.build import build
from winkler.study.language.catalogue import kinds, slot_of
from winkler.study.language.explain import completed
from winkler.values.errors import InvalidInput, OutsideValidity, WinklerError

SIZES = (1e300, 1e59, 1e20, 1e-20, 1e-59, 1e-300)
QUICK = (
    "adhesive_indentation", "adhesive_shear", "elliptic_indentation", "equilibrium", "indentation",
    "nearly_round_indentation", "pull_off",
)  # fmt: skip
MARCHES = [name for name, line in kinds().items() if hasattr(line.cls, "steps")]
"""They are looked at elsewhere, step by step."""
OTHERS = [name for name, line in kinds().items() if hasattr(line.cls, "solve") and name not in (*QUICK, *MARCHES)]
LASTING = ("strength",)
"""An onset of yield that is far from what elastic bodies bear is searched for, for seconds."""
BED = wk.Foundation(wk.Paraboloid(1e-2), wk.HalfSpace(wk.Elastic(210e9, 0.3)))


def numbers(content, route=()):
    """Yield the route to every number inside a value, but not to counts, nor to maps that are left out."""
    for field in dataclasses.fields(content):
        inside = getattr(content, field.name)
        if field.init and isinstance(inside, float | np.ndarray) and np.size(inside) and field.name not in LASTING:
            yield (*route, field.name)
        elif field.init and dataclasses.is_dataclass(inside):
            yield from numbers(inside, (*route, field.name))


def put(content, route, size):
    """Return a value with a number of a size at a place inside it."""
    key, *rest = route
    inside = getattr(content, key)
    return dataclasses.replace(content, **{key: put(inside, rest, size) if rest else sized(inside, size)})


def sized(number, size):
    """Return a number of a size, or an array whose greatest number has it; all of them if it was zeros."""
    if not np.ndim(number):
        return size
    return size * (number / np.max(np.abs(number)) if np.any(number) else np.ones(number.shape))


def text(answer) -> None:
    """Read all properties of a solution."""
    for name in dir(type(answer)):
        if isinstance(getattr(type(answer), name), property | functools.cached_property) and name[0] != "_":
            getattr(answer, name)


def faults(name: str, start: int = 0, step: int = 1) -> list[str]:
    """Return what is wrong with the answers of a kind, for each number with every so many sizes."""
    example, wrong = build(completed({"kind": name}), slot_of(name)), []
    routes = enumerate(numbers(example))
    for route, size in [(route, size) for n, route in routes for size in SIZES[(start + n) % step :: step]]:
        where = f"{'.'.join(route)} = {size:g}"
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                text(put(example, route, size).solve())
        except WinklerError as error:
            if "\n" in str(error) or not str(error).rstrip().endswith((".", ")")):
                wrong.append(f"{where}: {error}")
        except Exception as error:  # collected, and shown together
            wrong.append(f"{where}: {type(error).__name__} {error}")
    return wrong


@pytest.mark.few(3, slow=2)
@pytest.mark.parametrize("name", QUICK)
def test_every_number_of_a_problem(name):
    assert faults(name) == []


@pytest.mark.few(0, slow=8)
@pytest.mark.parametrize("start", [0, pytest.param(1, marks=pytest.mark.long)])
@pytest.mark.parametrize("name", OTHERS)
def test_every_number_of_other_problems(name, start):
    """Each number with every second size, its neighbours with the sizes between; the rest are long tests."""
    assert faults(name, start, 2) == []


@pytest.mark.parametrize("load", [wk.Force, wk.Depth, wk.Radius, wk.Shift, wk.ShearForce, wk.Angle, wk.Torque])
def test_a_load_beyond_all_physics_is_named(load):
    word = dataclasses.fields(load)[0].name
    with pytest.raises(InvalidInput, match=rf"^{load.__name__}: {word} is 1e\+300; numbers in SI units .* check the"):
        load(1e300)


BEADS = wk.Contacts.apart(BED.medium, curvature_radius=[1e-3], coefficient=0.3, reach=2e-6)


@pytest.mark.parametrize(
    ("word", "made"),
    [
        ("motion", lambda: BEADS.moved([1e-6], motion=[[1e300, 0.0]])),
        ("twist", lambda: BEADS.moved([1e-6], twist=[-1e300])),
        ("curvature_radius", lambda: dataclasses.replace(BEADS, curvature_radius=np.array([1e300]))),
        ("time", lambda: wk.Path([0.0, 1e300], wk.Depth([0.0, 1e-6]))),
        ("duration", lambda: wk.Hold(duration=1e300)),
        ("position", lambda: wk.ForceCurve([0.0, 1e300], [0.0, 1.0])),
        ("force", lambda: wk.ForceCurve([0.0, 1.0], [0.0, 1e300])),
    ],
)
def test_what_is_given_beside_loads_is_bounded_by_the_same_sentence(word, made):
    with pytest.raises(
        InvalidInput, match=rf"{word} is .*1e\+300.*; numbers in SI units are between 1e-60 and 1e\+60 in"
    ):
        made()


def test_the_greatest_of_many_is_named():
    with pytest.raises(InvalidInput, match=r"^Depth: depth is up to 1e\+200 in size; numbers in SI units"):
        wk.Depth([1.0, 1e200])


def test_what_a_solution_computes_afterwards_is_guarded():
    solution = wk.Indentation(BED, wk.Depth(1e-6)).solve()
    far = dataclasses.replace(solution, depth=np.float64(1e200), radius=np.float64(1e99), force=np.float64(1e300))
    with pytest.raises(OutsideValidity, match=r"^Indentation: .* so that it cannot be computed .*; check the numbers"):
        _ = far.energy


def test_the_command_line_says_one_sentence(tmp_path, capfd):
    study = tmp_path / "study.toml"
    assert main(["new", "indentation", "--output", str(study)]) == 0
    study.write_text(study.read_text(encoding="utf-8").replace('"100 N"', '"1e300 N"'), encoding="utf-8")
    capfd.readouterr()
    assert main(["run", str(study)]) != 0
    text = capfd.readouterr().err.strip()
    assert text.endswith(
        "problem.load.force is 1e+300; numbers in SI units are between 1e-60 and 1e+60 in size: check the unit."
    )
    assert "\n" not in text
