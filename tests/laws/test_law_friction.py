"""The records of friction: what they hold, and what they refuse."""

import math
import pickle

import pytest

import winkler as wk


@pytest.mark.parametrize("coefficient", [0, 0.0, 0.3, 2.0, math.inf])
def test_a_coefficient_is_zero_or_more(coefficient):
    law = wk.Coulomb(coefficient)
    assert law.coefficient == coefficient
    assert law == pickle.loads(pickle.dumps(law))
    assert hash(law) == hash(wk.Coulomb(coefficient))


@pytest.mark.parametrize("coefficient", [-0.1, math.nan, "0.3", None, True, [0.3]])
def test_other_coefficients_are_refused(coefficient):
    with pytest.raises(wk.InvalidInput, match="Coulomb: coefficient is .*; give zero or a positive number"):
        wk.Coulomb(coefficient)


def test_static_friction_is_not_below_kinetic():
    law = wk.StaticKinetic(static_coefficient=0.5, kinetic_coefficient=0.3)
    assert (law.static_coefficient, law.kinetic_coefficient) == (0.5, 0.3)
    assert wk.StaticKinetic(0.3, 0.3) != law
    with pytest.raises(wk.InvalidInput, match="kinetic coefficient 0.5 is above the static one, 0.3"):
        wk.StaticKinetic(0.3, 0.5)


@pytest.mark.parametrize("both", [(0.0, 0.0), (math.inf, 0.3), (0.3, -0.1), (math.nan, 0.1), ("a", 0.1), (True, 0.1)])
def test_coefficients_that_drop_are_positive_and_finite(both):
    with pytest.raises(wk.InvalidInput, match="StaticKinetic: (static|kinetic)_coefficient is"):
        wk.StaticKinetic(*both)
