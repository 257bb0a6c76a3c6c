"""Lengths times s and moduli times m: every result follows from its dimension, whatever the scale."""

from __future__ import annotations

import numpy as np
import pytest
from contacts import KINDS, contacts, examples, over_shapes
from hypothesis import given
from hypothesis import strategies as st
from media_cases import MEDIA
from shapes import number

import winkler as wk

DIMENSIONS = {"depth": (1, 0), "radius": (1, 0), "force": (2, 1), "stiffness": (1, 1), "energy": (3, 1)}
"""Powers of length and modulus."""


def scales(data) -> tuple[float, float]:
    return 10.0 ** data.draw(number(-2.0, 2.0)), 10.0 ** data.draw(number(-4.0, 4.0))


def loads(solution: wk.IndentationSolution, s: float, m: float, pinned: bool):
    yield wk.Depth(solution.depth * s)
    yield wk.Force(solution.force * s**2 * m)
    if not pinned:
        yield wk.Radius(solution.radius * s)


def assert_scaled(contact, s: float, m: float) -> None:
    solution = contact.solve()
    for load in loads(solution, s, m, contact.specimen.pinned):
        scaled = wk.Indentation(contact.bed(s, m), load).solve()
        for word, (lengths, moduli) in DIMENSIONS.items():
            expected = getattr(solution, word) * s**lengths * m**moduli
            assert getattr(scaled, word) == pytest.approx(expected, rel=1e-10, abs=0.0), (word, load)


FEW = [pytest.param(kind, 1 if kind == "wavy_ball" else 3, id=kind) for kind in KINDS]
MORE = [pytest.param(kind, 10, id=f"{kind}-10", marks=pytest.mark.long) for kind in KINDS]


@pytest.mark.few(3)
@pytest.mark.parametrize(("kind", "many"), [*FEW, *MORE])
def test_answers_scale(kind, many):
    @examples(many)
    @given(data=st.data())
    def law(data):
        assert_scaled(data.draw(contacts(kind)), *scales(data))

    law()


@pytest.mark.few(2)
@pytest.mark.parametrize("medium", [medium for medium in MEDIA if medium != "half_space"])
@pytest.mark.parametrize("kind", ["sphere", "truncated_cone", "pinned_cylinder"])
def test_answers_scale_on_every_medium(medium, kind):
    @examples(8)
    @given(data=st.data())
    def law(data):
        assert_scaled(data.draw(contacts(kind, medium)), *scales(data))

    law()


@over_shapes(6, 1)
def test_surface_fields_scale(contact):
    s, m = 37.0, 2.9e-3
    solution = contact.solve()
    scaled = wk.Indentation(contact.bed(s, m), wk.Depth(solution.depth * s)).solve()
    r = solution.radius * np.array([0.0, 0.13, 0.47, 0.81, 0.97, 1.1, 1.9])
    small, large = wk.restore(solution, r), wk.restore(scaled, r * s)
    middle = 3  # of the pressure, to compare an infinite one too
    np.testing.assert_allclose(large.pressure, m * small.pressure, rtol=1e-10, atol=1e-10 * m * small.pressure[middle])
    np.testing.assert_allclose(large.displacement, s * small.displacement, rtol=1e-10)
    # the gap is a small difference of lengths
    np.testing.assert_allclose(large.gap, s * small.gap, rtol=1e-10, atol=1e-10 * scaled.depth)


@over_shapes(4, 1, kinds=["sphere", "cone", "truncated_cone", "pinned_cylinder", "rounded_punch", "formula", "sum"])
def test_stresses_inside_scale(contact):
    s, m = 0.021, 530.0
    solution = contact.solve()
    scaled = wk.Indentation(contact.bed(s, m), wk.Depth(solution.depth * s)).solve()
    r, z = solution.radius * np.array([0.0, 0.4, 1.0, 1.6]), solution.radius * np.array([0.5, 0.03, 0.2, 1.4])
    small, large = wk.restore(solution, r, z), wk.restore(scaled, r * s, z * s)
    greatest, deepest = np.max(small.von_mises), np.max(np.abs(small.axial_displacement))
    for word in ("radial_stress", "hoop_stress", "axial_stress", "shear_stress", "von_mises", "max_shear"):
        expected = m * getattr(small, word)
        np.testing.assert_allclose(getattr(large, word), expected, rtol=1e-10, atol=1e-10 * m * greatest, err_msg=word)
    for word in ("radial_displacement", "axial_displacement"):
        expected = s * getattr(small, word)
        np.testing.assert_allclose(getattr(large, word), expected, rtol=1e-10, atol=1e-10 * s * deepest, err_msg=word)
