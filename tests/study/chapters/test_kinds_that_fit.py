"""What does not fit is refused when a value is made, by one sentence; what is accepted is solved, or refused so.

All kinds of the catalogue are put where all others stand, right or wrong.
"""

from __future__ import annotations

import dataclasses
import functools
import itertools
from typing import Any, get_type_hints

import pytest

import winkler as wk
from winkler.foundation.bed import Bed
from winkler.study.language.build import build
from winkler.study.language.catalogue import CATALOGUE, slot_of
from winkler.study.language.explain import example_study, place_of, table_at
from winkler.values.errors import InvalidInput, WinklerError

PROBLEMS = sorted(CATALOGUE["problem"])
OTHERS = sorted(name for slot, table in CATALOGUE.items() if slot != "problem" for name in table)
PRESSED = [
    name for name in PROBLEMS if "bed" in {field.name for field in dataclasses.fields(CATALOGUE["problem"][name].cls)}
]
COSTLY = {"bimodal_damping", "impact", "sliding_wear", "tangential", "viscoelastic_adhesion"}
"""Problems that take seconds on all beds; they run among the slow tests."""
ON_MAPS = {"joint_stiffness", "reduced_friction", "surface_rolling", "surface_rolling_start", "surface_tangential"}
"""Problems that take a second or more with all parts; those of the others on maps run by default."""
REDUCED = {"reduced_bed"}
"""A part whose springs are computed for each of the others, which takes seconds."""
STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
BALL = wk.Paraboloid(10e-3)
LONG = {
    "coated_half_space",
    "depth_graded_half_space",
    "poroelastic_film",
    "relaxing_in_proportion",
    "sliding_film",
    "stacked_half_space",
    "viscoelastic_coated_half_space",
}
"""Media whose tables take seconds: each is pressed once."""
MARCHES = {"adhesive_impact", "friction_heating", "transient_heating", "viscoelastic_adhesion", "viscoelastic_impact"}
"""Problems that take seconds on a bed: they are solved on each kind of bed and medium, not under each profile."""


@functools.cache
def example(name: str) -> Any:
    """An example of a kind."""
    if slot_of(name) == "problem":
        return build(example_study(name)["problem"])
    return build(table_at(example_study(name), place_of(name)), slot_of(name))


@functools.cache
def beds() -> dict[str, Any]:
    """A bed of each kind, on each medium, under each profile."""
    found = {name: example(name) for name in CATALOGUE["bed"]}
    for name in CATALOGUE["medium"]:
        found[f"foundation on {name}"] = wk.Foundation(BALL, example(name))
        if name not in LONG:
            found[f"plane foundation on {name}"] = wk.PlaneFoundation(BALL, example(name))
    for name in CATALOGUE["profile"]:
        if name != "wavy":  # alone it is no body
            found[f"foundation under {name}"] = wk.Foundation(example(name), PAIR)
    reduction = example("reduction").solve()
    found |= {"reduced": reduction.bed, "reduced, soft": reduction.on(example("viscoelastic_half_space"))}
    found["soft ellipse"] = wk.EllipticFoundation(wk.CurvedBodies(1e-2, 5e-3), example("viscoelastic_half_space"))
    return found


def parts(content: Any) -> list[str]:
    """The fields of a value that hold other values, or rows of them."""
    found = []
    for field in dataclasses.fields(content):
        inside = getattr(content, field.name)
        row = isinstance(inside, tuple) and inside and dataclasses.is_dataclass(inside[0])
        if field.init and (dataclasses.is_dataclass(inside) or row):
            found.append(field.name)
    return found


def replaced(content: Any, field: str, part: Any) -> Any:
    """The value with another part, or None if it refuses that by a sentence."""
    inside = (part,) if isinstance(getattr(content, field), tuple) else part
    try:
        return dataclasses.replace(content, **{field: inside})
    except WinklerError:
        return None


def solve_or_refuse(problem: Any) -> None:
    """Solve, or march two steps; errors of winkler are answers."""
    try:
        if callable(getattr(type(problem), "steps", None)):
            list(itertools.islice(problem.steps(), 2))
        else:
            problem.solve()
    except WinklerError:
        pass


@pytest.mark.few(50, slow=20)
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow) if name in REDUCED else name for name in OTHERS]
)
def test_a_part_is_taken_or_refused_by_a_sentence(name):
    whole = example(name)
    for field, other in itertools.product(parts(whole), (*OTHERS, *PROBLEMS)):
        replaced(whole, field, example(other))


@pytest.mark.few(8, slow=6)
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow) if name in ON_MAPS else name for name in PROBLEMS]
)
def test_a_problem_takes_what_it_can_answer(name):
    """Parts of all other kinds, beds apart; what is taken is solved or refused by a sentence."""
    whole = example(name)
    for field, other in itertools.product(parts(whole), (*OTHERS, *PROBLEMS)):
        changed = replaced(whole, field, example(other))
        if changed is not None and slot_of(other) != "bed" and other not in LONG:
            solve_or_refuse(changed)


@pytest.mark.few(6, slow=7)
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow) if name in COSTLY else name for name in PRESSED]
)
def test_a_problem_answers_on_a_bed_or_refuses_it(name):
    whole = example(name)
    taken = {word: replaced(whole, "bed", bed) for word, bed in beds().items()}
    for word, changed in taken.items():
        slow = any(medium in word for medium in LONG) and name != "indentation"
        many = name in MARCHES and word.startswith(("plane foundation on", "foundation under"))
        if changed is not None and not (slow or many or ("on graded" in word and "viscoelastic" in name)):
            solve_or_refuse(changed)
    outline = getattr(type(whole), "needs_round", "")
    for word in ("elliptic_foundation", "measured_bed", "reduced_bed", "reduced", "reduced, soft", "soft ellipse"):
        assert outline == "" or taken[word] is None, f"{name} says that it needs a disc, and takes a {word}"


def test_a_problem_on_a_bed_says_whether_it_needs_a_disc():
    """An empty text: it is solved by force, depth and stiffness, whatever the outline is."""
    classes = [CATALOGUE["problem"][name].cls for name in PROBLEMS]
    on_beds = [cls for cls in classes if get_type_hints(cls).get("bed") is Bed]
    assert len(on_beds) > 30
    undecided = [cls.__name__ for cls in on_beds if not hasattr(cls, "needs_round")]
    assert undecided == [], "say in needs_round which of its results need a disc"


def test_no_pair_of_curvatures_is_rubbed():
    """The case of the issue: it was taken, and ended in solve() by an AttributeError."""
    heat = wk.HeatConductors(wk.ThermalConductor(45.0, 12e-6), wk.ThermalConductor(45.0, 12e-6))
    with pytest.raises(InvalidInput, match="FrictionHeating: the contact is a CurvedBodies; give Indentation"):
        wk.FrictionHeating(wk.CurvedBodies(1e-2, 1e-3), wk.Coulomb(0.1), heat, 1.0)


def test_what_a_written_bed_lacks_is_named():
    class Row:
        """Half of a bed and a little more."""

    for member in sorted(name for name in vars(Bed) if name[0] != "_" and name not in ("footprint", "gap_slope")):
        setattr(Row, member, None)
    with pytest.raises(InvalidInput, match="the bed is a Row without footprint, gap_slope; give a bed, such as"):
        wk.Indentation(Row(), wk.Force(1.0))
