"""Every kind of problem states what is known of yield, if its solids have a strength."""

from __future__ import annotations

import dataclasses

import pytest

import winkler as wk
from winkler.study.language.build import build
from winkler.study.language.catalogue import kinds, slot_of
from winkler.study.language.explain import example_study
from winkler.validity import worst

ELASTIC = wk.Assumption.ELASTIC


def strengthened(item, strength):
    """Return a problem whose elastic solids all have this strength."""
    if isinstance(item, wk.Elastic):
        return wk.Elastic(item.young, item.poisson, strength)
    if isinstance(item, wk.Rigid):
        return wk.Elastic(1e12, 0.3, strength)
    if isinstance(item, tuple):
        return tuple(strengthened(part, strength) for part in item)
    if not dataclasses.is_dataclass(item):
        return item
    old = {field.name: getattr(item, field.name) for field in dataclasses.fields(item) if field.init}
    new = {name: strengthened(part, strength) for name, part in old.items()}
    return type(item)(**new) if any(new[name] is not part for name, part in old.items()) else item


WITHOUT = {
    "elastic_plastic_particle": "its strength is its law",
    "elastomer_friction": "a relaxing body under a rigid one: no solid has a strength",
    "elliptic_yield_onset": "the onset is its answer",
    "line_shakedown": "the limit after yield is its answer",
    "line_yield_onset": "the onset is its answer",
    "master_curve": "measurements of a solid, no contact",
    "poroelastic_relaxation": "a wet gel, whose network has no strength",
    "spot_cluster": "no elastic bodies",
    "surface_friction_heating": "a map of loads without elastic bodies",
    "yield_onset": "the onset is its answer",
}
UNKNOWN = {
    "conductance_bounds", "creep_test", "harmonic_indentation", "line_rolling_resistance",
    "line_viscoelastic_indentation", "nearly_round_indentation", "reduction", "relaxation_test", "sliding_resistance",
    "surface_adhesion", "viscoelastic_adhesion", "viscoelastic_impact", "viscoelastic_indentation",
    "viscoelastic_tangential",
}  # fmt: skip
"""Whose stresses are not computed: they state it, whatever the strength is."""
PROBLEMS = sorted(name for name in kinds() if slot_of(name) == "problem" and name not in WITHOUT)


@pytest.mark.parametrize("name", PROBLEMS)
def test_all_kinds_state_it(name):
    """A tiny strength is stated as yield or as unknown, a huge one never as yield."""
    prescribed = build(example_study(name)["problem"])
    assert ELASTIC in prescribed.assumptions
    for strength, standings in (
        (1e-3, {wk.Standing.APPROXIMATE} if name in UNKNOWN else {wk.Standing.OUTSIDE}),
        (1e60, set(wk.Standing) - {wk.Standing.OUTSIDE}),
    ):
        notes = [note for note in strengthened(prescribed, strength).solve().validity if note.assumption is ELASTIC]
        assert notes
        assert worst(notes) in standings
