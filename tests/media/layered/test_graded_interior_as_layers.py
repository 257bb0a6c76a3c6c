"""Stresses inside a body graded in depth against a stack of even layers that follows it, and their greatest."""

import numpy as np
import pytest

import winkler as wk

GRADINGS = [wk.ExponentialGrading(380e9, 100e9, 1e-4, 0.3), wk.ExponentialGrading(100e9, 380e9, 1e-4, 0.3)]


def pressed(medium):
    return wk.Indentation(wk.Foundation(wk.Paraboloid(10e-3), medium), wk.Force(100.0))


def layers(grading, count):
    """Return a stack of layers as stiff as the grading is in their middles, and the middles."""
    edges = 8e-4 * (np.arange(count + 1) / count) ** 1.5
    middles = 0.5 * (edges[1:] + edges[:-1])
    young = [float(grading.young_at(np.array(z))) for z in (*middles, edges[-1])]
    stack = [wk.Layer(wk.Elastic(e, 0.3), float(h)) for e, h in zip(young, np.diff(edges), strict=False)]
    return wk.CoatedHalfSpace(stack, on=wk.Elastic(young[-1], 0.3)), middles


@pytest.mark.parametrize("grading", GRADINGS, ids=["softer below", "stiffer below"])
def test_as_in_the_middles_of_layers(grading):
    """Four times nearer with twice as many layers; without the moduli at each depth it is off by a seventh."""
    medium, apart = wk.DepthGradedHalfSpace(grading, tolerance=1e-4), []
    own = pressed(medium).solve()
    for count in (16, 32):
        stack, middles = layers(grading, count)
        other = pressed(stack).solve()
        z = middles[(middles > 0.1 * own.radius) & (middles < 2.0 * own.radius)]
        worst = 0.0
        for r in (np.zeros(z.size), np.full(z.size, 0.6 * own.radius)):
            fields = [
                solution.problem.bed.medium.interior(solution.pressed, r, z, below=True) for solution in (own, other)
            ]
            for kind in ("radial_stress", "hoop_stress", "axial_stress"):
                one, two = (getattr(field, kind) for field in fields)
                worst = max(worst, float(np.max(np.abs(one - two))) / own.peak_pressure)
        apart.append(worst)
    assert apart[0] < 0.01
    assert apart[1] < 0.4 * apart[0]


def test_stresses_are_smooth_through_the_depth_of_a_radius():
    own = pressed(wk.DepthGradedHalfSpace(GRADINGS[0])).solve()
    z = own.radius * (1.0 + 1e-3 * np.array([-1.0, 1.0]))
    field = own.problem.bed.medium.interior(own.pressed, np.zeros(2), z, below=True)
    assert field.radial_stress[0] == pytest.approx(field.radial_stress[1], abs=1e-3 * own.peak_pressure)


def test_the_greatest_stresses_of_a_grading_that_hardly_varies_are_those_of_a_half_space():
    solid, grading = wk.Elastic(210e9, 0.3), wk.ExponentialGrading(210e9, 210.00001e9, 2e-4, 0.3)
    one = wk.ContactStress(pressed(wk.DepthGradedHalfSpace(grading, second=solid))).solve()
    two = wk.ContactStress(pressed(wk.HalfSpace.between(solid, solid))).solve()
    assert [part.name for part in one.parts] == ["graded body", "second body"]
    for kind in ("von_mises", "max_shear", "orthogonal_shear"):
        assert getattr(one, kind) == pytest.approx(getattr(two, kind), rel=1e-6), kind
        assert abs(getattr(one, f"{kind}_depth")) == pytest.approx(abs(getattr(two, f"{kind}_depth")), rel=1e-4), kind


@pytest.mark.few(1)
@pytest.mark.parametrize("grading", GRADINGS, ids=["softer below", "stiffer below"])
def test_the_greatest_stresses_of_a_grading_are_those_on_a_fine_mesh(grading):
    """Every depth of the axis tried: von Mises' stress there is the difference of two principal ones."""
    problem = pressed(wk.DepthGradedHalfSpace(grading))
    found, contact = wk.ContactStress(problem).solve(), problem.solve()
    r, z = (side.ravel() for side in np.meshgrid(*(contact.radius * np.linspace(0.0, 1.2, 25),) * 2, indexing="ij"))
    field = contact.problem.bed.medium.interior(contact.pressed, r, z + 1e-3 * contact.radius, below=True)
    radial, hoop, axial, shear = field[:4]
    mises = np.sqrt(0.5 * ((radial - hoop) ** 2 + (hoop - axial) ** 2 + (axial - radial) ** 2) + 3.0 * shear**2)
    assert float(np.max(mises)) <= found.von_mises * (1.0 + 1e-9)
    assert float(np.max(mises)) == pytest.approx(found.von_mises, rel=0.01)


def test_other_contacts_on_gradings_are_refused():
    medium = wk.DepthGradedHalfSpace(GRADINGS[0])
    with pytest.raises(wk.InvalidInput, match="under round contacts only"):
        wk.ContactStress(wk.EllipticIndentation(wk.CurvedBodies(5e-3, 10e-3), medium, wk.Force(50.0)))
