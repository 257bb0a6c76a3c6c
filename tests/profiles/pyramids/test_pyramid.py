"""Pyramids against boundary elements of the test, published numbers, geometry, and their limits over thin layers."""

import math

import numpy as np
import pytest
from pressed_elements import HALF_WIDTH, Elements, extrapolated, layer_excess, rounded, sharp, turned

import winkler as wk
from winkler.problems.assumptions.pyramid_film import ERRORS, pyramid_layer_error
from winkler.profiles.pyramids.pyramid import (
    AREA_CONSTANTS,
    CONTACT_OUTLINES,
    FORCE_CONSTANTS,
    edge_angle_of,
    face_angle_of,
)
from winkler.values.validity import Standing

UNIT = wk.HalfSpace(wk.Elastic(1.0, 0.0))


def pressed(tip, depth, medium=UNIT):
    return wk.Indentation(wk.Foundation(tip, medium), wk.Depth(depth)).solve()


def sharp_force(sides, count):
    pixel = 2.0 * HALF_WIDTH[sides] / count
    places = ((0.2, (0.37, 0.61)), (0.9, (0.1, 0.8)))
    grid = Elements(count, pixel)
    return np.mean([grid.force(sharp(sides, *turned(count, pixel, *place)), 1.0) for place in places])


def test_the_elements_give_the_cone():
    assert extrapolated(lambda n: sharp_force(0, n), 64) == pytest.approx(2.0 / math.pi, rel=5e-6)


@pytest.mark.few(1)
@pytest.mark.parametrize(("sides", "within"), [(3, 2e-4), (4, 5e-5), (8, 5e-5)])
def test_forces_by_boundary_elements(sides, within):
    tip = wk.Pyramid(sides=sides, face_angle=math.radians(70.0))
    force = extrapolated(lambda n: sharp_force(sides, n), 64) * math.tan(math.radians(70.0)) * 0.3**2
    assert pressed(tip, 0.3).force == pytest.approx(force, rel=within)


@pytest.mark.slow
@pytest.mark.parametrize(("sides", "count"), [(3, 128), (4, 128), (5, 64), (6, 64), (7, 64), (8, 64)])
def test_constants_by_boundary_elements(sides, count):
    assert extrapolated(lambda n: sharp_force(sides, n), count) == pytest.approx(FORCE_CONSTANTS[sides], rel=2e-5)


def test_a_square_pyramid_of_another_code():
    """ContactMechanics, extrapolated (shared data, shapes_force_depth.csv): 0.737617 E* d^2 at a slope of one."""
    assert pressed(wk.Pyramid(4, math.radians(45.0)), 1.0).force == pytest.approx(0.737617043, rel=1e-5)


@pytest.mark.parametrize(("sides", "published"), [(3, 0.8887), (4, 0.7453)])
def test_bilodeaus_approximation_is_one_per_cent_high(sides, published):
    assert 0.005 < published / FORCE_CONSTANTS[sides] - 1.0 < 0.011


def test_more_faces_come_near_the_cone():
    excess = np.array([FORCE_CONSTANTS[n] * math.pi / 2.0 - 1.0 for n in range(3, 9)])
    assert np.all(np.diff(excess) < 0.0)
    assert 0.02 < excess[-1] < 0.04


@pytest.mark.slow
@pytest.mark.parametrize("sides", [3, 4, *(pytest.param(n, marks=pytest.mark.slow) for n in (5, 6, 7, 8))])
def test_area_and_outline_of_the_contact(sides):
    count = 200
    pixel = 2.0 * HALF_WIDTH[sides] / count
    x, y = turned(count, pixel)
    touching = Elements(count, pixel).pressed(sharp(sides, x, y), 1.0) > 0.0
    assert np.sum(touching) * pixel**2 == pytest.approx(AREA_CONSTANTS[sides], rel=0.016)  # half a pixel around
    turn = np.mod(np.arctan2(y, x), 2.0 * math.pi / sides)
    middle = math.pi / sides
    face, edge = np.minimum(turn, 2.0 * middle - turn) < 0.05, np.abs(turn - middle) < 0.05
    near, far = (np.hypot(x, y)[touching & part].max() for part in (face, edge))
    assert near == pytest.approx(CONTACT_OUTLINES[sides][0], rel=0.035)
    assert far == pytest.approx(CONTACT_OUTLINES[sides][1], rel=0.035)


def test_angles():
    """A cube corner, and half of a regular octahedron: 45 degrees to the edges, 35.26 to the faces."""
    cube = wk.PyramidByEdges(3, math.acos(1.0 / math.sqrt(3.0)))
    assert math.degrees(cube.face_angle) == pytest.approx(35.26438968, abs=1e-7)
    assert wk.Pyramid(3, cube.face_angle).edge_angle == pytest.approx(cube.edge_angle, rel=1e-14)
    assert math.degrees(edge_angle_of(math.acos(math.sqrt(2.0 / 3.0)), 4)) == pytest.approx(45.0, abs=1e-9)
    assert pressed(cube, 1.0).force == pytest.approx(FORCE_CONSTANTS[3] / math.sqrt(2.0), rel=1e-12)
    assert face_angle_of(edge_angle_of(1.1, 5), 5) == pytest.approx(1.1, rel=1e-14)


def test_cross_sections():
    """Vickers: 24.504 h^2; modified Berkovich: 24.494 h^2; a triangle by the corners of its plane cut."""
    assert wk.Pyramid(4, math.radians(68.0)).cross_section(1.0) == pytest.approx(24.504, abs=5e-4)
    assert wk.Pyramid(3, math.radians(65.27)).cross_section(1.0) == pytest.approx(24.494, abs=5e-4)
    tip = wk.Pyramid(5, 0.7)
    corners = math.tan(tip.edge_angle) * np.exp(2j * math.pi * np.arange(6) / 5.0)
    area = 0.5 * np.sum((np.conj(corners[:-1]) * corners[1:]).imag)
    assert tip.cross_section(2.0) == pytest.approx(4.0 * area, rel=1e-13)


@pytest.mark.parametrize(("tip", "cone", "less"), [(4, wk.Vickers(), 0.0261), (3, wk.Berkovich(), 0.0722)])
def test_equal_area_cones_bear_less(tip, cone, less):
    angle = math.radians({4: 68.0, 3: 65.27}[tip])
    share = pressed(cone, 1e-6).force / pressed(wk.Pyramid(tip, angle), 1e-6).force
    assert 1.0 - share == pytest.approx(less, abs=1e-4)


def test_contact_of_a_pyramid():
    tip, depth = wk.Pyramid(4, 1.0), 2e-7
    contact = pressed(tip, depth)
    assert contact.stiffness == pytest.approx(2.0 * contact.force / depth, rel=1e-12)
    assert contact.radius == pytest.approx(FORCE_CONSTANTS[4] * math.tan(1.0) * depth, rel=1e-12)
    assert tip.contact_area(depth) < math.pi * contact.radius**2
    (note,) = tip.notes
    assert note.standing is Standing.APPROXIMATE
    assert "within 1e-5" in note.statement


@pytest.mark.few(1)
@pytest.mark.parametrize("sides", [3, 4])
@pytest.mark.parametrize("depth", [0.4, 1.3, 4.0, 18.0])
def test_rounded_pyramids_by_boundary_elements(sides, depth):
    """Depths in R / tan^2, other than those to which the slopes were fitted."""
    angle, radius = math.radians(60.0), 3e-8

    def force(count):
        pixel = 2.0 * HALF_WIDTH[sides] * (depth + 0.5) / count
        return Elements(count, pixel).force(rounded(sides, *turned(count, pixel)), depth)

    tangent = math.tan(angle)
    unit = radius / tangent**2
    found = pressed(wk.RoundedPyramid(sides, angle, radius), depth * unit).force / (unit * radius / tangent)
    assert found == pytest.approx(extrapolated(force, 80), rel=4e-4)


@pytest.mark.parametrize("sides", [3, 4])
def test_limits_of_rounded_pyramids(sides):
    angle, radius = 1.0, 2e-6
    tip, unit = wk.RoundedPyramid(sides, angle, radius), radius / math.tan(angle) ** 2
    shallow = 0.9 * unit * math.cos(math.pi / sides) ** 2
    assert pressed(tip, shallow).force == pytest.approx(4.0 / 3.0 * math.sqrt(radius) * shallow**1.5, rel=1e-12)
    far = 1e3 * unit
    assert pressed(tip, far).force == pytest.approx(
        FORCE_CONSTANTS[sides] * math.tan(angle) * (far + 0.5 * unit) ** 2, rel=2e-5
    )
    slopes = tip.slope(np.linspace(0.0, 100.0 * radius, 20001))
    assert np.all(np.diff(slopes) > -1e-12)


def test_the_thin_layers_limit_is_the_volume():
    """Over a thin compressible layer on a rigid base F ~ the volume inside: cone over pyramid, own integrals."""
    for sides in (3, 4):
        cone = 0.5 * math.pi * FORCE_CONSTANTS[sides]  # radius of the cross-section at the height one
        share = math.pi * cone**2 / (sides * math.tan(math.pi / sides))
        assert ERRORS[sides][0][-1, -1] == pytest.approx(share - 1.0, rel=0.01)


def layer_force(sides, depth, contrast, poisson, count):
    shear = (1.0 - poisson) / (contrast * (1.0 - 0.3))  # E / (1 - nu^2) = 2 G / (1 - nu)
    for width in (1.0, 1.3):
        pixel = 2.0 * width * HALF_WIDTH[sides] * depth / count
        grid = Elements(count, pixel, lambda x: layer_excess(x, poisson, 0.3, shear))
        try:
            return grid.force(sharp(sides, *turned(count, pixel)), depth)
        except AssertionError:
            continue
    raise AssertionError("the contact reaches the border")


def film(contrast, poisson):
    young = contrast * (1.0 - 0.3**2)
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0 - poisson**2, poisson), 1.0)], on=wk.Elastic(young, 0.3))


@pytest.mark.parametrize(("contrast", "depth"), [(0.1, 0.3), (10.0, 3.0)])
def test_the_layers_kernel_gives_cones_on_films(contrast, depth):
    expected = pressed(wk.Cone(math.radians(45.0)), depth, film(contrast, 0.3)).force
    assert layer_force(0, depth, contrast, 0.3, 120) == pytest.approx(expected, rel=2e-4)


CASES = [
    (sides, poisson, contrast, radius)
    for sides in (3, 4)
    for poisson in (0.3, 0.5)
    for contrast, radius in ((0.1, 1.0), (0.1, 3.0), (10.0, 1.0), (1e3, 3.0))
]


@pytest.mark.parametrize(
    ("sides", "poisson", "contrast", "radius"),
    [
        CASES[1],
        CASES[-2],
        *(
            pytest.param(*case, marks=pytest.mark.long if place % 4 else pytest.mark.slow)
            for place, case in enumerate(CASES)
        ),
    ],
)
def test_errors_on_layers_by_boundary_elements(sides, poisson, contrast, radius):
    tip = wk.Pyramid(sides, math.radians(45.0))
    bed = wk.Foundation(tip, film(1e4 if contrast == 1e3 else contrast, poisson))
    contact = wk.Indentation(bed, wk.Radius(radius)).solve()
    force = layer_force(sides, float(contact.depth), 1e4 if contrast == 1e3 else contrast, poisson, 120)
    stated = pyramid_layer_error(sides, radius, contrast, poisson)
    assert contact.force / force - 1.0 == pytest.approx(stated, abs=1e-3 + 0.01 * abs(stated))


@pytest.mark.slow
def test_a_pyramid_on_a_film_states_its_error():
    soft = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1e3, 0.3), 1e-6)], on=wk.Rigid())
    for tip in (wk.Pyramid(4, math.radians(80.0)), wk.RoundedPyramid(4, math.radians(80.0), 1e-9)):
        contact = wk.Indentation(wk.Foundation(tip, soft), wk.Radius(1e-6)).solve()
        (note,) = [note for note in contact.validity if "differs from that of the pyramid" in note.statement]
        assert note.standing is Standing.APPROXIMATE
        assert "+2.69%" in note.statement
    thick = wk.Indentation(wk.Foundation(tip, soft), wk.Radius(0.05e-6)).solve()
    assert "+0.00%" in " ".join(note.statement for note in thick.validity)
    graded = wk.GradedHalfSpace(wk.PowerLawGraded(1e9, 1e-3, 0.2, 0.3))
    notes = " ".join(note.statement for note in pressed(tip, 1e-7, graded).validity)
    assert "On this body its error is not known" in notes


@pytest.mark.parametrize("sides", [2, 9, 4.0, "4", True])
def test_bad_numbers_of_faces(sides):
    with pytest.raises(wk.InvalidInput, match=r"^Pyramid: sides is .*whole number of faces from 3 to 8\.$"):
        wk.Pyramid(sides, 1.0)


@pytest.mark.parametrize("angle", [0.0, -1.0, math.pi / 2.0, math.nan, "35 deg"])
def test_bad_angles(angle):
    with pytest.raises(wk.InvalidInput, match="face_angle is .* between 0 and pi/2"):
        wk.Pyramid(4, angle)


def test_degrees_are_recognised():
    with pytest.raises(wk.InvalidInput, match=r"if 35 are degrees, give math\.radians\(35\)"):
        wk.Pyramid(4, 35.0)


@pytest.mark.parametrize("wrong", [(2, 1.0, 1.0), (4, 0.0, 1.0), (4, 1.0, -1.0), (4, float("nan"), 1.0)])
def test_the_public_error_on_layers_refuses_what_is_no_layer(wrong):
    with pytest.raises(wk.InvalidInput, match="at least three faces, and positive numbers"):
        wk.pyramid_layer_error(*wrong, 0.3)
