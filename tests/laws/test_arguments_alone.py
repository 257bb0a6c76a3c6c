"""An argument that is given by itself changes the answer, is refused, or is named as without effect.

Some arguments act only together with others: the inertia of a body that strikes needs a lever.  Each optional argument
of each problem is given alone here, all others as by default.
"""

from __future__ import annotations

import contextlib
import dataclasses
from typing import Any

import numpy as np
import pytest
from example_answers import COSTLY, example_problem, solved

import winkler as wk
from winkler.study.batch.outcome import number_names
from winkler.study.language.catalogue import CATALOGUE
from winkler.values.errors import InvalidInput, OutsideValidity

RESOLUTION = {
    "count", "cycles", "elements", "per_decade", "pixels", "points", "realisations", "seed", "share",
    "temperature_step", "tolerance",
}  # fmt: skip
"""Arguments that say how finely or how often something is looked at."""

GIVEN: dict[str, Any] = {
    "adhesive_cycle.machine_stiffness": 1e3,
    "band_heating.partition": wk.FixedShare(0.2),
    "bimodal_damping.frequency": 10.0,
    "bimodal_damping.lateral_cycles": 2,
    "bimodal_damping.method": wk.Method.RINGS,
    "bimodal_damping.normal_cycles": 2,
    "constriction.mean_free_path": 40e-9,
    "elastic_plastic_particle.work_closing": 10.0,
    "elastic_plastic_particle.work_opening": 10.0,
    "elliptic_wear.passes": 2.0,
    "elliptic_yield_onset.angle": 0.3,
    "equilibrium.machine_stiffness": 1e3,
    "fretting_wear.layer_wears": True,
    "friction_damping.frequency": 10.0,
    "friction_damping.method": wk.Method.RINGS,
    "friction_loops.frame_compliance": 5e-9,
    "friction_heating.first_direction": 0.2,
    "friction_heating.second_direction": 0.3,
    "friction_heating.partition": wk.FixedShare(0.2),
    "friction_heating.second_speed": 1.0,
    "held_contacts.vertical": False,
    "impact.angular_velocity": 20.0,
    "joule_heating.law": wk.WiedemannFranz(3e-8),
    "joule_heating.temperature": 350.0,
    "measured_constriction.resistivity": 16e-9,
    "line_fretting_wear.layer_wears": True,
    "line_friction_heating.partition": wk.FixedShare(0.2),
    "line_profile_contact.alignment": wk.Tilt(1e-5),
    "line_rolling.coupled": True,
    "line_rolling_start.reference": 1e-2,
    "line_shakedown.friction": wk.Coulomb(0.2),
    "line_sliding_wear.layer_wears": True,
    "line_tangential.method": wk.Method.ELEMENTS,
    "line_yield_onset.friction": wk.Coulomb(0.2),
    "master_curve.by": wk.ShiftedBy.STORAGE,
    "master_curve.entropic": True,
    "master_curve.fluid": True,
    "master_curve.vertical": True,
    "oscillating_rolling.calibration": wk.Uncalibrated(),
    "profile_pair.first_radius": 0.5,
    "profile_pair.lateral": 1e-3,
    "profile_pair.roll": 1e-3,
    "plastic_impact.law": wk.Coulomb(0.2),
    "plastic_impact.lateral_velocity": 0.5,
    "plastic_impact.angular_velocity": 20.0,
    "plastic_impact.inertia": 1e-5,
    "plastic_impact.lever": 0.01,
    "profile_pair.rolled_radius": 0.5,
    "profile_pair_rolling.lateral_drift": 1e-3,
    "profile_pair_rolling.roll_rate": 1e-2,
    "profile_pair_rolling.speed": 20.0,
    "profile_pair_rolling.yaw_rate": 1e-2,
    "pull_off.machine_stiffness": 1e3,
    "roller_contact.alignment": wk.Tilt(1e-5),
    "rolling.calibration": wk.Uncalibrated(),
    "rolling_start.calibration": wk.Uncalibrated(),
    "rolling_start.start": wk.ShearForce(10.0),
    "simplified_rolling.speed": 20.0,
    "sliding_wear.layer_wears": True,
    "strength_from_dent.force_error": 10.0,
    "surface_constriction.law": wk.WiedemannFranz(3e-8),
    "surface_constriction.mean_free_path": 40e-9,
    "surface_constriction.temperature": 350.0,
    "surface_contact.hardness": 1e9,
    "surface_friction_heating.frequency": 50.0,
    "surface_friction_heating.first_bulk_temperature": 10.0,
    "surface_friction_heating.second_bulk_temperature": 10.0,
    "surface_friction_heating.first_speed": 1.0,
    "surface_friction_heating.second_speed": 1.0,
    "surface_tangential.twist": wk.Angle(1e-4),
    "tangential.method": wk.Method.SPRINGS,
    "thermal_joint.jump_distance": 1e-7,
    "transient_heating.partition": wk.FixedShare(0.2),
    "viscoelastic_adhesion.machine_stiffness": 1e3,
    "yield_onset.friction": wk.Coulomb(0.2),
}
"""Values of arguments that the examples leave out."""

TOGETHER = {
    "bimodal_damping.frequency": "relax",
    "bimodal_damping.method": "kernels of their own",
    "elastic_plastic_particle.work_closing": "work_opening",
    "friction_heating.second_direction": "second_speed",
    "fretting_wear.layer_wears": "no layers",
    "friction_damping.frequency": "relax",
    "friction_damping.method": "kernels of their own",
    "sliding_wear.layer_wears": "no layers",
    "impact.inertia": "lever",
    "impact.lever": "inertia",
    "impact.angular_velocity": "lever",
    "plastic_impact.inertia": "lever",
    "plastic_impact.lever": "inertia",
    "plastic_impact.angular_velocity": "lever",
    "line_fretting_wear.layer_wears": "no layers",
    "line_rolling_start.reference": "reference",
    "line_sliding_wear.layer_wears": "no layers",
    "surface_friction_heating.frequency": "leave it out",
    "surface_friction_heating.first_speed": "leave both out",
    "surface_friction_heating.second_speed": "leave both out",
    "thermal_joint.jump_distance": "gap_conductivity",
}
"""Arguments that are refused alone, and what the sentence asks for."""


def optional(kind: str) -> dict[str, Any]:
    """Return the arguments of a problem that may be left out, with their defaults, without those of the resolution."""
    return {
        field.name: field.default
        for field in dataclasses.fields(CATALOGUE["problem"][kind].cls)
        if field.default is not dataclasses.MISSING and field.name not in RESOLUTION
    }


ARGUMENTS = [f"{kind}.{name}" for kind in CATALOGUE["problem"] for name in optional(kind)]


def value_of(argument: str) -> Any:
    """Return what the example gives, or else the value of the table; the default if neither has one."""
    kind, name = argument.split(".")
    given = getattr(example_problem(kind), name)
    return given if given != optional(kind)[name] else GIVEN.get(argument, given)


def answered(problem: Any) -> tuple[dict[str, Any], str]:
    """Return the numbers of a solution, and the sentences of its notes."""
    solution = solved(problem)
    found = {}
    for name in {*number_names(type(solution)), *getattr(solution, "other_axes", ())}:
        with contextlib.suppress(OutsideValidity):
            found[name] = getattr(solution, name)
    return found, " ".join(note.statement for note in solution.validity)


def equal(one: Any, two: Any) -> bool:
    """Return whether two answers are the same; those that are no numbers are of one kind or are compared as values."""
    if isinstance(one, float | np.ndarray):
        return np.array_equal(one, two, equal_nan=True)
    return bool(one == two)


def test_each_optional_argument_has_a_value_to_be_tried():
    untried = []
    for argument in ARGUMENTS:
        kind, name = argument.split(".")
        if value_of(argument) == optional(kind)[name]:
            untried.append(argument)
    assert untried == []
    assert set(GIVEN) <= set(ARGUMENTS)


def without(argument: str, *, others: bool) -> Any:
    """Return a problem without an optional argument, and with the others of the example or without them."""
    kind, name = argument.split(".")
    defaults = optional(kind)
    return dataclasses.replace(example_problem(kind), **({name: defaults[name]} if others else defaults))


def given(argument: str, problem: Any) -> Any:
    """Return a problem with the argument."""
    return dataclasses.replace(problem, **{argument.split(".")[1]: value_of(argument)})


@pytest.mark.few(12)
@pytest.mark.parametrize(
    "argument",
    [
        pytest.param(argument, marks=pytest.mark.slow if argument.split(".")[0] in COSTLY else ())
        for argument in ARGUMENTS
        if argument not in TOGETHER
    ],
)
def test_an_argument_given_alone_acts_or_is_named(argument):
    """One that cannot be left out acts; where the others cannot be left out, they are those of the example."""
    for others in (False, True):
        try:
            before, notes = answered(without(argument, others=others))
        except InvalidInput:
            continue
        after, more = answered(given(argument, without(argument, others=others)))
        same = before.keys() == after.keys() and all(equal(before[name], after[name]) for name in before)
        assert not same or notes != more
        return
    answered(example_problem(argument.split(".")[0]))


@pytest.mark.parametrize("argument", sorted(TOGETHER))
def test_an_argument_that_acts_only_with_another_is_refused_alone(argument):
    with pytest.raises((InvalidInput, OutsideValidity), match=TOGETHER[argument]):
        answered(given(argument, without(argument, others=False)))
