"""Every kind of problem states what is known of yield, if its solids have a strength."""

from __future__ import annotations

import dataclasses

import pytest
from example_answers import LASTING, example_problem, solved

import winkler as wk
from winkler.study.language.catalogue import kinds, slot_of
from winkler.values.validity import worst

ELASTIC = wk.Assumption.ELASTIC


def strengthened(item, strength):
    """Return a problem whose elastic solids all have this strength."""
    if isinstance(item, wk.Elastic):
        return wk.Elastic(item.young, item.poisson, strength)
    if isinstance(item, wk.Rigid):
        return wk.Elastic(1e12, 0.3, strength)
    if isinstance(item, tuple):
        parts = tuple(strengthened(part, strength) for part in item)
        return type(item)(*parts) if hasattr(item, "_fields") else parts
    if not dataclasses.is_dataclass(item):
        return item
    old = {field.name: getattr(item, field.name) for field in dataclasses.fields(item) if field.init}
    new = {name: strengthened(part, strength) for name, part in old.items()}
    return type(item)(**new) if any(new[name] is not part for name, part in old.items()) else item


WITHOUT = {
    "band_heating": "an even flux of heat, no bodies that are pressed",
    "elastic_plastic_particle": "its strength is its law",
    "elastomer_friction": "a relaxing body under a rigid one: no solid has a strength",
    "elliptic_yield_onset": "the onset is its answer",
    "line_shakedown": "the limit after yield is its answer",
    "line_yield_onset": "the onset is its answer",
    "master_curve": "measurements of a solid, no contact",
    "plastic_impact": "its strength is its law",
    "plastic_indentation": "its strength is its law",
    "line_plastic_indentation": "its strength is its law",
    "dent_limit": "its strength is its law",
    "strength_from_dent": "the strength is its answer",
    "poroelastic_relaxation": "a wet gel, whose network has no strength",
    "held_contacts": "measurements of a body that relaxes",
    "friction_loops": "measurements",
    "measured_constriction": "measurements",
    "spot_cluster": "no elastic bodies",
    "yield_onset": "the onset is its answer",
}
UNKNOWN = {
    "conductance_bounds", "creep_test", "harmonic_indentation", "line_rolling_resistance",
    "line_viscoelastic_indentation", "reduction", "relaxation_test", "sliding_resistance",
    "surface_adhesion", "surface_wear", "viscoelastic_adhesion", "viscoelastic_impact", "viscoelastic_indentation",
}  # fmt: skip
"""Whose stresses are not computed: they state it, whatever the strength is."""
PROBLEMS = sorted(name for name in kinds() if slot_of(name) == "problem" and name not in WITHOUT)


ON_MAPS = {
    "reduced_friction", "surface_conduction", "surface_constriction", "surface_contact", "surface_rolling",
    "surface_friction_heating", "surface_rolling_start", "surface_tangential",
}  # fmt: skip
"""Whose stresses take a second; those of one of them are computed by default."""
LATER = (LASTING | ON_MAPS | {"profile_pair_rolling", "seal"}) - {"surface_contact"}
TINY, HUGE = 1e-3, 1e60


def assert_stated(name, solution, strength):
    """A tiny strength is stated as yield or as unknown, a huge one never as yield."""
    if strength == HUGE:
        standings = set(wk.Standing) - {wk.Standing.OUTSIDE}
    else:
        standings = {wk.Standing.APPROXIMATE if name in UNKNOWN else wk.Standing.OUTSIDE}
    notes = [note for note in solution.validity if note.assumption is ELASTIC]
    assert notes
    assert worst(notes) in standings


CASES = [
    pytest.param(name, strength, marks=pytest.mark.slow if strength == TINY else pytest.mark.long)
    if name in LATER or (name in ON_MAPS and strength == HUGE)
    else (name, strength)
    for name in PROBLEMS
    for strength in (TINY, HUGE)
]


@pytest.mark.few(2, slow=12)
@pytest.mark.parametrize(("name", "strength"), CASES)
def test_all_kinds_state_it(name, strength):
    """Elastic solids answer the same whatever their strength is: it is put into the answer of the example."""
    problem = example_problem(name)
    assert ELASTIC in problem.assumptions
    solution = strengthened(solved(problem), strength)
    assert solution.problem == strengthened(problem, strength)
    assert_stated(name, solution, strength)


SOLVED = {"indentation", "tangential", "line_rolling", "surface_contact"}


def when(place, name):
    """By default those, every fifth of the others among the slow tests: the example's answer is stated by default."""
    return [] if name in SOLVED else [pytest.mark.long if place % 5 else pytest.mark.slow]


@pytest.mark.few(1)
@pytest.mark.parametrize("name", [pytest.param(name, marks=when(place, name)) for place, name in enumerate(PROBLEMS)])
def test_all_kinds_are_solved_and_state_it(name):
    """The same where the strength is known before."""
    assert_stated(name, strengthened(example_problem(name), TINY).solve(), TINY)
