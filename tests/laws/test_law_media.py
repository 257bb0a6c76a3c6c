"""Laws of the media: which body is called first, a very stiff body and a rigid one, isotropy as a special case."""

from __future__ import annotations

import numpy as np
import pytest
from contacts import examples
from hypothesis import given
from hypothesis import strategies as st
from media_cases import MEDIA, elastic, number, transverse, young

import winkler as wk

A = np.array([1e-3, 0.1, 1.0, 7.0])
BALL = wk.Sphere(20.0)


def moduli(medium) -> np.ndarray:
    """All properties of the springs of a medium, at several radii."""
    stiffness = (medium.punch_stiffness(A), medium.normal_stiffness(A), medium.tangential_stiffness(A))
    return np.array([*stiffness, medium.gap(BALL, A), medium.gap_slope(BALL, A), medium.gap_load(BALL, A)])


def isotropic(body: wk.Elastic) -> wk.TransverselyIsotropic:
    g, nu = body.shear, body.poisson
    c11 = 2.0 * g * (1.0 - nu) / (1.0 - 2.0 * nu)
    c12 = 2.0 * g * nu / (1.0 - 2.0 * nu)
    return wk.TransverselyIsotropic(c11, c12, c12, c11, g)


@pytest.mark.parametrize("kind", MEDIA)
@examples(40)
@given(data=st.data())
def test_exchanging_the_bodies_changes_nothing(kind, data):
    sample = data.draw(MEDIA[kind])
    if sample.swapped is None:
        return  # its bodies are of different kinds
    np.testing.assert_allclose(moduli(sample.swapped(1.0, 1.0)), moduli(sample.make(1.0, 1.0)), rtol=1e-13)


@pytest.mark.parametrize("kind", MEDIA)
@examples(25)
@given(data=st.data(), m=number(1e-3, 1e12))
def test_springs_scale_with_the_moduli(kind, data, m):
    sample = data.draw(MEDIA[kind])
    scaled, plain = moduli(sample.make(1.0, m)), moduli(sample.make(1.0, 1.0))
    np.testing.assert_allclose(scaled[[0, 1, 2, 5]], m * plain[[0, 1, 2, 5]], rtol=1e-12)
    np.testing.assert_allclose(scaled[[3, 4]], plain[[3, 4]], rtol=1e-12)


def stiffened(body, factor: float):
    if isinstance(body, wk.Elastic):
        return wk.Elastic(body.young * factor, body.poisson)
    return wk.TransverselyIsotropic(*(factor * c for c in (body.c11, body.c12, body.c13, body.c33, body.c44)))


@pytest.mark.parametrize("medium", [wk.HalfSpace, wk.TransverselyIsotropicHalfSpace])
@examples(40)
@given(data=st.data())
def test_a_body_a_billion_times_stiffer_is_rigid(medium, data):
    bodies = elastic if medium is wk.HalfSpace else st.one_of(elastic, transverse)
    first, second = data.draw(bodies)(1.0), data.draw(bodies)(1.0)
    stiff, rigid = moduli(medium(first, stiffened(second, 1e9))), moduli(medium(first))
    np.testing.assert_allclose(stiff, rigid, rtol=1e-6)
    # and the deviation has the sign and size of the compliance that is left
    softer = moduli(medium(first, stiffened(second, 1e5)))
    assert np.all(softer[:3] < stiff[:3])
    assert np.all(stiff[:3] < rigid[:3])
    np.testing.assert_allclose((rigid - softer)[:3], 1e4 * (rigid - stiff)[:3], rtol=1e-2)


@examples(40)
@given(e=young, nu=number(-0.5, 0.49), e2=young, nu2=number(-0.5, 0.49))
def test_isotropic_constants_make_a_transversely_isotropic_half_space_a_half_space(e, nu, e2, nu2):
    first, second = wk.Elastic(e, nu), wk.Elastic(e2, nu2)
    same = moduli(wk.HalfSpace(first, second))
    for one, other in ((isotropic(first), isotropic(second)), (first, isotropic(second)), (first, second)):
        np.testing.assert_allclose(moduli(wk.TransverselyIsotropicHalfSpace(one, other)), same, rtol=1e-12)


@examples(25)
@given(first=elastic, second=elastic)
def test_two_bodies_are_springs_in_series(first, second):
    one, other = first(1.0), second(1.0)
    both = wk.HalfSpace(one, other)
    for word in ("modulus", "shear_modulus"):
        parts = [1.0 / getattr(wk.HalfSpace(body), word) for body in (one, other)]
        assert getattr(both, word) == pytest.approx(1.0 / sum(parts), rel=1e-14)


@examples(25)
@given(first=elastic, second=elastic, m=number(0.1, 1e12))
def test_mismatch_belongs_to_the_pair(first, second, m):
    one, other = first(1.0), second(1.0)
    beta = wk.HalfSpace(one, other).mismatch
    assert abs(beta) <= 0.5 + 1e-15 or min(one.poisson, other.poisson) < 0.0
    assert wk.HalfSpace(other, one).mismatch == -beta
    assert wk.HalfSpace(first(m), second(m)).mismatch == pytest.approx(beta, rel=1e-12, abs=1e-15)
    # alike bodies are alike, whether they are one object or two
    assert wk.HalfSpace(one, one).mismatch == 0.0
    assert wk.HalfSpace(one, first(1.0)).mismatch == 0.0
    assert len(wk.HalfSpace(one, one).notes) == 1
    assert wk.HalfSpace(one, one) == wk.HalfSpace(one, first(1.0))


@examples(25)
@given(first=elastic, second=elastic)
def test_what_is_inside_the_first_body_is_inside_the_second_of_the_exchanged_pair(first, second):
    ball = wk.Paraboloid(1.0)
    pair, exchanged = wk.HalfSpace(first(1.0), second(1.0)), wk.HalfSpace(second(1.0), first(1.0))
    r, z = np.array([0.0, 0.05, 0.1, 0.2]), np.array([0.05, 0.02, 0.1, 0.1])
    fields = []
    for medium, side in ((pair, 1.0), (exchanged, -1.0)):
        contact = wk.Indentation(wk.Foundation(ball, medium), wk.Radius(0.1)).solve()
        fields.append(wk.restore(contact, r, side * z))
    for word in ("radial_stress", "hoop_stress", "axial_stress", "shear_stress", "von_mises", "axial_displacement"):
        one, other = (getattr(field, word) for field in fields)
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-13 * np.max(np.abs(one)))
