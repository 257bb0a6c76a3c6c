"""The same histories, from stored seeds, through every target that runs here; and what they must never do."""

from __future__ import annotations

import sys

import all_targets
import numpy as np
import pytest
from exported_laws import PROBLEMS, random_motions

from winkler.exporting.choose import law_of
from winkler.exporting.export import of_every_radius

TOLERANCE = 1e-13
FEW, MANY, STEPS = 5, 84, 4
"""Histories of one law; the many are more than a thousand over all laws."""
SIZED = ("beads", "sticky")
"""Laws that are compared as those of all radii, too."""


def laws_and_motions(names, sized, count):
    laws = {name: law_of(PROBLEMS[name], tolerance=1e-6, count=6) for name in names}
    laws |= {f"{name}_sized": of_every_radius(law_of(PROBLEMS[name], tolerance=1e-6, count=6), PROBLEMS[name])
             for name in sized}  # fmt: skip
    motions = {name: random_motions(law, count, STEPS, 20261123 + k) for k, (name, law) in enumerate(laws.items())}
    return laws, motions, {name: all_targets.by_reference(law, motions[name]) for name, law in laws.items()}


@pytest.fixture(scope="module")
def few():
    return laws_and_motions(["beads"], ["powder"], FEW)


@pytest.fixture(scope="module")
def many():
    return laws_and_motions(PROBLEMS, SIZED, MANY)


def agree(laws, found, expected, tolerance=TOLERANCE):
    """Compare over the greatest number of each column of each history, losses over the greatest energy, of which they
    are what is left; a tolerance of zero asks for the same bits.
    """
    for name, true in expected.items():
        assert np.all(np.isfinite(true)), name
        if tolerance == 0.0:
            np.testing.assert_array_equal(found[name], true, err_msg=name)
        scale = np.maximum(np.max(np.abs(true), axis=1, keepdims=True), 1e-300)
        energies = [place for place, number in enumerate(laws[name].answer) if number.unit == "J"]
        if energies:
            scale[..., energies] = np.max(scale[..., energies], axis=-1, keepdims=True)
        assert np.max(np.abs(found[name] - true) / scale) <= tolerance, name


@pytest.mark.slow
def test_a_few_histories_are_the_same_in_c_and_python(tmp_path, few):
    laws, motions, expected = few
    agree(laws, all_targets.by_c(tmp_path, laws, motions), expected, 0.0)
    agree(laws, all_targets.by_python(laws, motions), expected)


@pytest.mark.slow
def test_a_thousand_histories_are_the_same_bits_in_c_and_in_webassembly(tmp_path, many):
    """The library of C of WebAssembly, musl, has another `pow`, whose last bit differs here and there from glibc's."""
    laws, motions, expected = many
    assert sum(len(one) for one in motions.values()) > 1000
    agree(laws, all_targets.by_c(tmp_path, laws, motions), expected, 0.0)
    found = all_targets.by_webassembly(tmp_path, laws, motions)
    agree(laws, found, expected, 1e-14)
    if sys.platform == "linux":
        agree(laws, found, all_targets.by_c_with_the_library_of_webassembly(tmp_path, laws, motions), 0.0)


@pytest.mark.slow
def test_a_thousand_histories_are_the_same_in_python_and_fortran(tmp_path, many):
    laws, motions, expected = many
    agree(laws, all_targets.by_python(laws, motions), expected)
    agree(laws, all_targets.by_fortran(tmp_path, laws, motions), expected)


@pytest.mark.long
def test_a_thousand_histories_are_the_same_in_units(tmp_path, many):
    """A unit takes differences of places, which are rounded; the C files take just these differences."""
    laws, motions, _ = many
    laws = {name: law for name, law in laws.items() if not law.every_radius}
    found, moved = all_targets.by_units(tmp_path, laws, motions)
    expected = all_targets.by_c(tmp_path, laws, moved)
    agree(laws, found, {name: one[:, 1:] for name, one in expected.items()})


EDGES = [0.0, 1e-300, 5e-324, -1e-300, 1e-16, 1e-9, 0.5, 1.0, 1.0, -1.0, -1e300, 0.0, 1.0]
"""Depths over the greatest one: no overlap, hardly any, all of it, far apart."""


@pytest.mark.parametrize("sized", [False, True])
@pytest.mark.parametrize("name", PROBLEMS)
def test_no_overlap_and_huge_and_tiny_steps_have_an_answer(name, sized):
    law = law_of(PROBLEMS[name], tolerance=1e-6, count=6)
    if sized and np.isnan(law.curvature_radius):
        return
    law = of_every_radius(law, PROBLEMS[name]) if sized else law
    deepest = np.max(law.trial[:, 0])
    for others in (0.0, 1e-300, 1e-12, 1e12):
        motions = np.full((len(EDGES), len(law.motion)), others)
        motions[:, 0] = deepest * np.array(EDGES)
        if sized:
            motions[:, -1] = law.trial[0, -1]
        with np.errstate(all="ignore"):
            answers = law.trace(motions)
        assert np.all(np.isfinite(answers)), (others, answers)
