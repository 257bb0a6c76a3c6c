"""Solids: shear modulus, and one clear sentence for everything that is no solid."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk


@pytest.mark.parametrize(("poisson", "shear"), [(0.0, 0.5), (0.25, 0.4), (0.5, 1.0 / 3.0), (-0.5, 1.0)])
def test_shear_modulus(poisson, shear):
    assert wk.Elastic(1.0, poisson).shear == pytest.approx(shear, rel=1e-15)


@pytest.mark.parametrize("bad", [0.0, -210e9, math.nan, math.inf, "210 GPa", None, [1.0]])
def test_bad_youngs_moduli(bad):
    with pytest.raises(wk.InvalidInput, match=r"^Elastic: young is .*; it must be a positive, finite number in Pa\.$"):
        wk.Elastic(young=bad, poisson=0.3)


@pytest.mark.parametrize("bad", [-1.0, -2.0, 0.5000001, 1.0, math.nan, math.inf, "0.3", None])
def test_bad_poisson_ratios(bad):
    with pytest.raises(
        wk.InvalidInput, match=r"^Elastic: poisson is .*; a Poisson ratio is above -1 and at most 0\.5\.$"
    ):
        wk.Elastic(young=1.0, poisson=bad)


@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, "high", None])
def test_bad_strengths(bad):
    with pytest.raises(
        wk.InvalidInput, match="^Elastic: strength is .*; it must be a positive number in Pa, or infinite"
    ):
        wk.Elastic(1.0, 0.3, strength=bad)
    assert wk.Elastic(1.0, 0.3).strength == math.inf


def test_numpy_numbers_are_numbers():
    solid = wk.Elastic(np.float64(2.0), np.float32(0.25))
    assert solid == wk.Elastic(2.0, 0.25)
    assert type(solid.young) is float
    assert wk.Elastic(np.array(2.0), np.array(0.25)) == solid


STABLE = {"c11": 10.0, "c12": 4.0, "c13": 3.5, "c33": 12.0, "c44": 3.0}


@pytest.mark.parametrize(
    "change",
    [
        {"c44": 0.0},
        {"c44": -1.0},
        {"c12": 10.0},
        {"c12": -10.0},
        {"c11": 3.0},
        {"c33": 0.0},
        {"c33": -12.0},
        {"c13": 9.2},
        {"c13": -9.2},
    ],
)
def test_unstable_solids(change):
    with pytest.raises(
        wk.InvalidInput,
        match=r"give a negative strain energy; a stable solid has c44 > 0, c11 > \|c12\| "
        r"and \(c11 \+ c12\) c33 > 2 c13\^2\.$",
    ):
        wk.TransverselyIsotropic(**STABLE | change)


@pytest.mark.parametrize("change", [{"c13": -9.1}, {"c12": -9.9, "c13": 0.7}, {"c12": 9.9, "c13": 10.9}])
def test_stable_to_the_last(change):
    """Positive definite by its eigenvalues, whatever the signs."""
    c = STABLE | change
    matrix = np.array([[c["c11"], c["c12"], c["c13"]], [c["c12"], c["c11"], c["c13"]], [c["c13"], c["c13"], c["c33"]]])
    assert np.linalg.eigvalsh(matrix).min() > 0.0
    wk.TransverselyIsotropic(**c)


@pytest.mark.parametrize("bad", [math.nan, math.inf, "10", None])
@pytest.mark.parametrize("word", STABLE)
def test_bad_stiffnesses(word, bad):
    with pytest.raises(wk.InvalidInput, match=rf"^TransverselyIsotropic: {word} is .*; give a finite number in Pa\.$"):
        wk.TransverselyIsotropic(**STABLE | {word: bad})
