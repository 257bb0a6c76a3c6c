"""Some 5e4 hostile cases, other ones every day: an answer of which the laws hold, or one sentence; never a hang.

A failure names its seed and the files of its cases; see `fuzz_cases` and the page on contributing.
"""

from __future__ import annotations

import functools

import fuzz_studies
import fuzz_texts
import fuzz_words
import pytest
from fuzz_cases import Case, check
from fuzz_readers import READERS, SUFFIXES, TABLES
from fuzz_trials import tried, written

from winkler.study.language.template import whole_text

BASES = ("indentation", "tangential", "coated_half_space", "formula", "sum")
UNITS = ("m", "Pa", "rad", "", "N/m", "J/m^2", "K", "m^-0.5")


def spoilt_text(rng) -> Case:
    return Case("text", written(fuzz_studies.spoilt(rng)))


@functools.cache
def base(name: str) -> bytes:
    return whole_text(name).encode()


def spoilt_bytes(rng) -> Case:
    return Case.of_bytes("bytes", fuzz_texts.spoilt_bytes(rng, base(rng.choice(BASES))))


def any_text(rng) -> Case:
    return Case("text", fuzz_words.text(rng, 200))


def any_formula(rng) -> Case:
    return Case("formula", fuzz_texts.formula(rng))


def any_quantity(rng) -> Case:
    return Case("quantity", f"{rng.choice(UNITS)}\n{fuzz_texts.quantity(rng)}")


def spoilt_table(rng) -> Case:
    name = rng.choice(list(TABLES))
    return Case.of_bytes(f"file .csv {name}", fuzz_texts.spoilt_table(rng, TABLES[name]))


def any_file(rng) -> Case:
    name, suffix = rng.choice(list(READERS)), rng.choice(SUFFIXES)
    start = rng.choice(fuzz_texts.BINARY)
    return Case.of_bytes(f"file {suffix or '-'} {name}", start + rng.randbytes(rng.choice((0, 8, 64, 300))))


MADE = {
    "spoilt studies": (spoilt_text, 4_500),
    "more spoilt studies": (spoilt_text, 4_500),
    "spoilt bytes of studies": (spoilt_bytes, 3_000),
    "any text as a study": (any_text, 8_000),
    "formulas": (any_formula, 6_000),
    "quantities": (any_quantity, 16_000),
    "spoilt tables": (spoilt_table, 4_500),
    "any bytes as a file": (any_file, 3_000),
}
SOLVED = {
    "pressed": (
        *("indentation", "yield_onset", "elliptic_indentation", "nearly_round_indentation", "limiting_profile"),
        *("elliptic_yield_onset", "elliptic_wear", "contact_stress"),
        *("plastic_indentation",),
        *("relaxation_damper", "friction_damping", "bimodal_damping", "fretting_wear", "sliding_wear"),
        *(
            "line_indentation",
            "line_yield_onset",
            "line_shakedown",
            "line_tangential",
            "line_profile_contact",
            "roller_contact",
            "periodic_indentation",
        ),
        *("line_fretting_wear", "line_sliding_wear", "line_limiting_profile"),
    ),
    "sticky": (
        *("adhesive_indentation", "pull_off", "equilibrium", "adhesive_shear", "adhesive_cycle", "adhesive_impact"),
        *("elastic_plastic_particle", "impact", "viscoelastic_adhesion", "line_adhesion"),
    ),
    "relaxing and rolling": (
        *("viscoelastic_indentation", "creep_test", "relaxation_test", "harmonic_indentation", "sliding_resistance"),
        *("viscoelastic_impact", "tangential", "torsion", "rolling", "rolling_start"),
        *("simplified_rolling", "oscillating_rolling", "elastomer_friction", "master_curve", "poroelastic_relaxation"),
        *("held_contacts", "friction_loops", "measured_constriction"),
        *("line_rolling", "line_rolling_start", "line_rolling_resistance", "line_viscoelastic_indentation"),
    ),
    "warm and rough": (
        *("constriction", "thermal_constriction", "joule_heating", "spot_cluster", "conductance_bounds"),
        *("friction_heating", "transient_heating", "fretting_heat", "surface_contact", "surface_conduction"),
        *("true_area", "seal", "thermal_joint", "surface_constriction", "surface_wear"),
        *("map_stress", "profile_pair", "profile_pair_rolling", "surface_friction_heating", "surface_rolling_heating"),
        *("surface_adhesion", "surface_tangential", "reduced_friction", "surface_rolling", "surface_rolling_start"),
        "joint_stiffness",
        *(
            "reduction",
            "rough_contact",
            "rough_indentation",
            "line_constriction",
            "line_friction_heating",
            "band_heating",
            "elliptic_friction_heating",
        ),
    ),
}
"""Groups of problems that are solved; each takes about as long as the others."""
FEW = {
    "viscoelastic_adhesion": 3,
    "impact": 15,
    "sliding_wear": 15,
    "surface_wear": 15,
    "line_sliding_wear": 15,
    "adhesive_impact": 20,
    "viscoelastic_impact": 20,
}
"""Cases of problems that take long; of others there are `EACH`."""
EACH = 30


def test_every_problem_is_in_a_group():
    assert sorted(name for group in SOLVED.values() for name in group) == sorted(fuzz_studies.PROBLEMS)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("name", MADE)
def test_many_cases(name, tmp_path):
    make, count = MADE[name]
    check(name, count, make, tried, tmp_path)


@pytest.mark.parametrize("part", [pytest.param(3, marks=pytest.mark.slow), pytest.param(1, marks=pytest.mark.long)])
@pytest.mark.parametrize("group", SOLVED)
def test_many_studies_are_solved(group, part, tmp_path):
    """A third of the cases, and all of them before a release."""

    def made(problem, rng) -> Case:
        return Case("solve", written(fuzz_studies.solvable(rng, problem)))

    for problem in SOLVED[group]:
        check(problem, FEW.get(problem, EACH) // part, functools.partial(made, problem), tried, tmp_path)
