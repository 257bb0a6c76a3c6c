"""The answers of the example studies, solved once in each worker for all tests that look at them."""

from __future__ import annotations

import functools
from collections.abc import Iterable
from typing import Any

import pytest

from winkler.study.language.build import build
from winkler.study.language.explain import example_study

LASTING = {
    "adhesive_impact", "joint_stiffness", "reduced_friction", "reduction", "sliding_resistance", "sliding_wear",
    "surface_adhesion", "surface_rolling_start", "surface_tangential", "surface_wear", "viscoelastic_adhesion",
}  # fmt: skip
"""Kinds of problems whose examples take longer to solve than all others together."""
COSTLY = LASTING | {
    "elliptic_wear", "fretting_wear", "friction_heating", "map_stress", "master_curve", "oscillating_rolling",
    "profile_pair", "profile_pair_rolling", "rolling_start", "seal", "simplified_rolling", "transient_heating",
    "viscoelastic_impact", "viscoelastic_indentation", "yield_onset",
}  # fmt: skip
"""These, and those that take some tenths of a second, or more than one where their kernels are compiled first."""


def lasting_slow(kinds: Iterable[str]) -> list[Any]:
    """Return parameters of a test of all kinds, of which those that take long are slow tests."""
    return [pytest.param(kind, marks=pytest.mark.slow) if kind in LASTING else kind for kind in kinds]


@functools.cache
def example_problem(kind: str) -> Any:
    """The problem of the example study of a kind."""
    return build(example_study(kind)["problem"])


@functools.cache
def solved(problem: Any) -> Any:
    """The solution of a problem; problems of equal content share it."""
    return problem.solve()
