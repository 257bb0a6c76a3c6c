"""The same histories, from stored seeds, through every target that runs here."""

from __future__ import annotations

import all_targets
import numpy as np
import pytest
from exported_laws import PROBLEMS, random_motions

from winkler.exporting.choose import law_of

TOLERANCE = 1e-13
FEW, MANY, STEPS = 6, 112, 12
"""Histories of one law; the many are more than a thousand over all laws."""


def laws_and_motions(names, count):
    laws = {name: law_of(PROBLEMS[name], tolerance=1e-6, count=6) for name in names}
    motions = {name: random_motions(law, count, STEPS, 20261123 + k) for k, (name, law) in enumerate(laws.items())}
    return laws, motions, {name: all_targets.by_reference(law, motions[name]) for name, law in laws.items()}


@pytest.fixture(scope="module")
def few():
    return laws_and_motions(["beads", "powder"], FEW)


@pytest.fixture(scope="module")
def many():
    return laws_and_motions(PROBLEMS, MANY)


def off(found, expected):
    """Return the greatest difference over the greatest number of each column of each history."""
    scale = np.maximum(np.max(np.abs(expected), axis=1, keepdims=True), 1e-300)
    return float(np.max(np.abs(found - expected) / scale))


def agree(found, expected):
    assert {name: off(found[name], expected[name]) for name in expected if off(found[name], expected[name]) > TOLERANCE} == {}


def by_units(folder, laws, motions):
    """Return what units answer, and what the source answers to the same motions."""
    found, moved = all_targets.by_units(folder, laws, motions)
    return found, {name: all_targets.by_reference(law, moved[name])[:, 1:] for name, law in laws.items()}


def test_a_few_histories_are_the_same_in_c_fortran_python_and_units(tmp_path, few):
    laws, motions, expected = few
    agree(all_targets.by_c(tmp_path, laws, motions), expected)
    agree(all_targets.by_python(laws, motions), expected)
    agree(*by_units(tmp_path, laws, motions))


def test_a_few_histories_are_the_same_in_fortran(tmp_path, few):
    laws, motions, expected = few
    agree(all_targets.by_fortran(tmp_path, laws, motions), expected)
