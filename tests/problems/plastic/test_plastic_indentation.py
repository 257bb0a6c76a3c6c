"""Metals that yield under a round body, against closed forms, the literature, and symmetry."""

import math

import numpy as np
import pytest
from closed_correlations import (
    CONES,
    HARDENING_BALLS,
    STEEPER,
    critical,
    etsion_dent,
    etsion_release,
    ghaednia,
    jackson_chusoipin_green,
    jackson_green,
    kogut_etsion,
)
from finite_elements import FAR, Body, pressed_and_released, released

import winkler as wk
from winkler.foundation.foundation import Foundation
from winkler.problems.plastic.indentation import PlasticIndentation
from winkler.values.errors import InvalidInput, OutsideValidity

RADIUS = 5e-3
STEEL = wk.Elastic(210e9, 0.3, 1e9)
STIFFNESS = 210e9 / (1.0 - 0.09)
WOOD = wk.TransverselyIsotropic(c11=15e9, c12=5e9, c13=4e9, c33=20e9, c44=4e9)
BALL = Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(STEEL))


def pressed(bed, path):
    return PlasticIndentation(bed, path).solve()


def test_it_is_hertz_up_to_first_yield():
    onset = wk.YieldOnset(BALL).solve()
    # p0 = 1.60 Y for nu = 0.3 (Johnson 1985, section 6.1), so F = pi^3 R^2 p0^3 / (6 E*^2)
    assert onset.force == pytest.approx(math.pi**3 * RADIUS**2 * (1.61 * 1e9) ** 3 / (6.0 * STIFFNESS**2), rel=0.02)
    forces = onset.force * np.array([1e-6, 0.1, 0.5, 1.0, 0.3])
    solved, elastic = pressed(BALL, wk.Force(forces)), wk.Indentation(BALL, wk.Force(forces)).solve()
    for name in ("depth", "radius", "mean_pressure", "energy"):
        np.testing.assert_allclose(getattr(solved, name), getattr(elastic, name), rtol=1e-10)
    assert np.all(solved.dissipation == 0.0)
    assert np.all(solved.residual_depth == 0.0)


def test_nothing_jumps_where_yielding_begins():
    onset = wk.YieldOnset(BALL).solve()
    depths = onset.depth * np.array([1.0 - 1e-5, 1.0, 1.0 + 1e-5])
    solved = pressed(BALL, wk.Depth(depths))
    slopes = np.diff(solved.force) / np.diff(depths)
    np.testing.assert_allclose(slopes, 2.0 * STIFFNESS * onset.radius, rtol=2e-5)
    assert 0.0 <= solved.residual_depth[2] < 1e-8 * onset.depth


@pytest.mark.parametrize("ratio", [200.0, 1000.0])
def test_load_and_area_are_those_of_others_finite_elements(ratio):
    steel = wk.Elastic(210e9, 0.3, 210e9 / ratio)
    depth, load = critical(STIFFNESS, 0.3, RADIUS, steel.strength)
    w = np.geomspace(1.9, 110.0, 25)
    solved = pressed(Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(steel)), wk.Depth(w * depth))
    area = solved.radius**2 / (RADIUS * depth)
    for forces, areas in (kogut_etsion(w), jackson_green(w, STIFFNESS, 0.3, steel.strength)):
        np.testing.assert_allclose(solved.force / load, forces, rtol=0.05)
        np.testing.assert_allclose(area, areas, rtol=0.05)


@pytest.mark.parametrize("metal", HARDENING_BALLS, ids=["8", "9", "10", "11", "12"])
def test_balls_that_harden_on_elastic_flats_are_those_of_others_finite_elements(metal):
    """Contact radius, and the load, which theirs has with the composite modulus: 2 to 9 % too low for one body."""
    radius, (young, poisson, strength, share, flat, of_flat) = 1e-3, metal
    ball = wk.LinearHardening(young, poisson, strength, plastic_modulus=young * share / (1.0 - share))
    bed = Foundation(wk.Paraboloid(radius), wk.HalfSpace(ball, wk.Elastic(flat, of_flat)))
    first, _ = critical(bed.medium.modulus, poisson, radius, strength)
    depth = np.geomspace(1.9 * first, 0.005 * radius, 25)  # up to a/R = 0.085: beyond, large strains count
    solved = pressed(bed, wk.Depth(depth))
    load, wide = ghaednia(depth, radius, *metal)
    np.testing.assert_allclose(solved.radius, wide, rtol=0.05)
    print(
        np.min(solved.force / load),
        np.max(solved.force / load),
        np.min(solved.radius / wide),
        np.max(solved.radius / wide),
    )
    assert np.all((solved.force / load > 0.98) & (solved.force / load < 1.11))


def test_dents_and_releases_are_those_of_others_finite_elements():
    """A ball that hardens as theirs, and one that does not: within the 0.025 by which these two differ here."""
    strength = 0.2e9
    depth, _ = critical(STIFFNESS, 0.3, RADIUS, strength)
    w = np.array([1.5, 3.0, 6.0, 10.0, 20.0, 40.0, 70.0, 110.0, 150.0])
    tangent = 0.02 * 210e9  # of the whole strain
    for solid, near in (
        (wk.LinearHardening(210e9, 0.3, strength, plastic_modulus=tangent / (1.0 - 0.02)), 0.015),
        (wk.Elastic(210e9, 0.3, strength), 0.03),
    ):
        bed = Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(solid))
        solved = pressed(bed, wk.Depth(w * depth))
        left = solved.residual_depth / solved.depth
        np.testing.assert_allclose(left, etsion_dent(w), atol=near)
        for top, low in zip(solved.depth, solved.residual_depth, strict=True):
            part = np.linspace(0.0, 1.0, 21)[1:-1]
            released = pressed(bed, wk.Depth(np.append(top, low + part * (top - low))))
            borne = released.force[1:] / released.force[0]
            np.testing.assert_allclose(borne, etsion_release(top / depth, part), atol=0.03)


def test_deep_dents_lie_between_those_of_two_other_groups():
    """Those of Jackson, Chusoipin and Green are deeper than those of Etsion's group, by up to 0.1 of the depth."""
    depth, _ = critical(STIFFNESS, 0.3, RADIUS, 0.2e9)
    w = np.geomspace(1.9, 170.0, 25)
    solved = pressed(
        Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(wk.Elastic(210e9, 0.3, 0.2e9))), wk.Depth(w * depth)
    )
    left, theirs, deep = solved.residual_depth / solved.depth, jackson_chusoipin_green(w), w > 30.0
    np.testing.assert_allclose(left[~deep], theirs[~deep], atol=0.03)
    assert np.all((left[deep] > etsion_dent(w[deep])) & (left[deep] < theirs[deep]))


@pytest.mark.parametrize(("rows", "error"), [(CONES, 0.02), (STEEPER, 0.2)])
def test_cones_are_those_of_others_finite_elements(rows, error):
    """Force over the squared depth, perfectly plastic and hardening; beyond the tables by the error of the note."""
    for exponent, young, strength, curvature in rows:
        solid = wk.PowerHardening(young * 1e9, 0.3, strength * 1e9, exponent=exponent)
        solved = pressed(Foundation(wk.Cone(math.radians(80.0)), wk.HalfSpace(solid)), wk.Depth([1e-6]))
        assert solved.force[0] / 1e-12 == pytest.approx(curvature * 1e9, rel=error)
        stated = max(note.error for note in solved.validity if note.error)
        assert abs(solved.force[0] / 1e-12 / (curvature * 1e9) - 1.0) < stated


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["ball", "cone", "hardening ball"])
def test_force_radius_and_dent_are_those_of_finite_elements(kind):
    """Extrapolated from 8 and 16 elements along the contact radius, which is one; the modulus is one."""
    ball, rise = kind != "cone", 0.05 if kind == "hardening ball" else 0.0
    strength = STIFFNESS / 210e9 / (10.0 if ball else 5.0)  # a/R and the slope of the cone are one
    profile = (lambda r: 0.5 * r * r) if ball else (lambda r: r)
    coarse, fine = (np.array(pressed_and_released(cells, 0.3, strength, profile, rise)) for cells in (8, 16))
    depth, force, residual, spent, given = 2.0 * fine - coarse
    if not ball:  # the same at every size, while its first contacts have few elements
        spent = force * depth / 3.0
    # the strength over the modulus is that of a metal: slopes and strengths are scaled down together
    scale = 1e-3
    shape = wk.Paraboloid(1.0 / scale) if ball else wk.Cone(math.pi / 2.0 - math.atan(scale))
    solid = wk.LinearHardening(1.0, 0.3, strength * scale, plastic_modulus=rise) if rise else None
    bed = Foundation(shape, wk.HalfSpace(solid or wk.Elastic(1.0, 0.3, strength * scale)))
    solved = pressed(bed, wk.Depth([depth * scale]))
    assert solved.force[0] == pytest.approx(force * scale, rel=0.02)
    assert solved.radius[0] == pytest.approx(1.0, rel=0.02)
    assert solved.residual_depth[0] / solved.depth[0] == pytest.approx(residual / depth, abs=0.01)
    # what an impact bounces with; cones come back a little faster than the two shapes of pressure of the law have it
    restitution = math.sqrt(solved.energy[0] / solved.work[0])
    assert restitution == pytest.approx(math.sqrt(given / spent), abs=0.01 if ball else 0.02)


@pytest.mark.slow
@pytest.mark.parametrize(("other", "load"), [((1.0, 0.3, math.inf), 12.0), ((2.0, 0.25, 1.5), 12.0)])
def test_two_unlike_bodies_are_those_of_finite_elements(other, load):
    """Beside an elastic body and a stronger one; `load` is E* over the strength at a contact radius of one."""
    young, poisson, stronger = other
    modulus = 1.0 / (0.91 + (1.0 - poisson**2) / young)
    strength, scale, found = modulus / load, 1e-3, []
    for cells in (8, 16):
        body = Body(cells, 0.3, strength, other=(young, poisson, stronger * strength, 0.0))
        depth, force = [body.event(k, 0.5 * body.r**2) for k in range(1, cells + 1)][-1]
        found.append((depth + 0.3 * force / (modulus * FAR), force, released(body, cells, 0.02)[0]))
    depth, force, residual = 2.0 * np.array(found[1]) - np.array(found[0])
    solids = wk.Elastic(1.0, 0.3, strength * scale), wk.Elastic(young, poisson, stronger * strength * scale)
    solved = pressed(Foundation(wk.Paraboloid(1.0 / scale), wk.HalfSpace(*solids)), wk.Depth([depth * scale]))
    left = solved.residual_depth[0] / solved.depth[0]
    print(other, solved.force[0] / scale / force, solved.radius[0], left - residual / depth)
    assert solved.force[0] == pytest.approx(force * scale, rel=0.02)
    assert solved.radius[0] == pytest.approx(1.0, rel=0.02)
    assert left == pytest.approx(residual / depth, abs=0.015)


def test_first_yield_is_the_closed_form():
    """Johnson 1985, section 6.1: p0 = 1.60 Y and a depth of 0.48 a for a Poisson's ratio of 0.3."""
    z = np.linspace(0.3, 0.7, 400_001)
    stress = 1.5 / (1.0 + z * z) - 1.3 * (1.0 - z * np.arctan(1.0 / z))
    peak = 1e9 / np.max(stress)
    assert peak == pytest.approx(1.61e9, rel=0.005)
    assert z[np.argmax(stress)] == pytest.approx(0.48, abs=0.005)
    radius = math.pi * RADIUS * peak / (2.0 * STIFFNESS)
    problem = PlasticIndentation(BALL, wk.Force([1.0]))
    assert problem.yield_depth == pytest.approx(radius**2 / RADIUS, rel=1e-8)
    assert problem.yield_force == pytest.approx(2.0 / 3.0 * math.pi * peak * radius**2, rel=1e-8)
    just = pressed(BALL, wk.Force([problem.yield_force * (1.0 - 1e-9), problem.yield_force * 1.01]))
    assert just.dissipation[0] == 0.0 < just.dissipation[1]


def test_oliver_and_pharr_find_the_modulus_of_a_made_curve():
    curve = pressed(BALL, wk.Force(np.concatenate([np.linspace(0.0, 3000.0, 200), np.linspace(3000.0, 0.0, 400)])))
    depth, force = curve.depth[200:], curve.force[200:]
    upper = force > 0.5 * force[0]

    def fitted(left):
        line, misfit, *_ = np.polyfit(np.log(depth[upper] - left), np.log(force[upper]), 1, full=True)
        return float(misfit[0]), left, float(line[0])

    _, left, power = min(fitted(share * curve.residual_depth[-1]) for share in np.linspace(0.8, 1.1, 301))
    assert 1.0 < power < 1.6
    slope = power * force[0] / (depth[0] - left)
    # contact depth, and the area of the paraboloid there: W. C. Oliver, G. M. Pharr, J. Mater. Res. 7 (1992) 1564-1583
    contact_depth = depth[0] - 0.75 * force[0] / slope
    of_tip = 2.0 * math.pi * RADIUS * contact_depth
    seen = math.pi * curve.radius[199] ** 2
    assert 0.5 * math.sqrt(math.pi / seen) * slope == pytest.approx(STIFFNESS, rel=0.02)
    # by the depth alone it is worse, since the edge piles up: a limit of the method, not of the curve
    assert 0.5 * math.sqrt(math.pi / of_tip) * slope == pytest.approx(STIFFNESS, rel=0.1)


def test_no_strength_at_all_presses_evenly_and_gives_nothing_back():
    """Where the elastic strains vanish the mean pressure is three times the strength, and the dent is the depth."""
    soft = Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(wk.Elastic(210e9, 0.3, 1.0)))
    solved = pressed(soft, wk.Force([1e-3, 0.0]))
    assert solved.mean_pressure[0] == pytest.approx(3.0, rel=1e-3)
    assert solved.residual_depth[0] == pytest.approx(solved.depth[0], rel=1e-3)
    assert solved.energy[0] < 1e-3 * solved.work[0]
    assert any(note.error == 0.18 for note in solved.validity)


def test_the_notes_say_how_far_it_holds():
    elastic = pressed(BALL, wk.Force([1.0])).validity
    assert all(note.error != 0.02 for note in elastic)
    yielded = pressed(BALL, wk.Force([1000.0])).validity
    assert [note.error for note in yielded if "tables fitted" in note.statement] == [0.02]
    blunt = Foundation(wk.SpheroConical(1e-4, 1.2), wk.HalfSpace(STEEL))
    assert any(
        "neither a paraboloid nor a cone" in note.statement for note in pressed(blunt, wk.Force([60.0])).validity
    )


def test_pressure_reaches_the_plateau_of_hardness():
    depth, _ = critical(STIFFNESS, 0.3, RADIUS, STEEL.strength)
    solved = pressed(BALL, wk.Depth(np.array([50.0, 80.0, 110.0, 150.0]) * depth))
    assert np.all(np.diff(solved.mean_pressure) > 0.0)
    assert np.all((solved.mean_pressure > 2.5e9) & (solved.mean_pressure < 3.0e9))


def test_letting_go_is_elastic_and_the_old_load_comes_back():
    forces = np.array([3000.0, 2999.9, 1000.0, 0.0, 1500.0, 3000.0, 3500.0, 0.0])
    solved = pressed(BALL, wk.Force(forces))
    slope = (forces[0] - forces[1]) / (solved.depth[0] - solved.depth[1])
    assert slope == pytest.approx(2.0 * STIFFNESS * solved.radius[0], rel=1e-3)
    for name in ("depth", "radius", "energy", "dissipation", "residual_depth"):
        row = getattr(solved, name)
        assert row[5] == pytest.approx(row[0], rel=1e-12)
    assert solved.depth[3] == solved.residual_depth[3]
    assert solved.radius[3] == 0.0 == solved.energy[3]
    straight = pressed(BALL, wk.Force([3500.0]))
    assert solved.depth[6] == straight.depth[0]


def test_the_dent_is_a_bed_on_which_other_problems_are_solved():
    solved = pressed(BALL, wk.Force([3000.0, 0.0]))
    again = wk.Indentation(solved.dented, wk.Force(np.array([100.0, 1500.0, 2999.0]))).solve()
    path = pressed(BALL, wk.Force([3000.0, 100.0, 1500.0, 2999.0]))
    np.testing.assert_allclose(again.depth + solved.residual_depth[0], path.depth[1:], rtol=1e-12)
    np.testing.assert_allclose(again.energy, path.energy[1:], rtol=1e-9)
    np.testing.assert_allclose(again.radius, path.radius[1:], rtol=1e-12)


@pytest.mark.parametrize(
    "bed",
    [
        BALL,
        Foundation(wk.Cone(1.22), wk.HalfSpace(STEEL)),
        Foundation(wk.Hyperboloid(1e-4, 1.22), wk.HalfSpace(STEEL, wk.Elastic(70e9, 0.33, 0.3e9))),
    ],
)
def test_energy_closes_and_only_rises(bed):
    up = np.linspace(0.0, 1.0, 400) ** 2
    loads = np.concatenate([50.0 * up, 50.0 * up[::-1], 90.0 * up])
    solved = pressed(bed, wk.Force(loads))
    work = np.concatenate([[0.0], np.cumsum(np.diff(solved.depth) * 0.5 * (loads[1:] + loads[:-1]))])
    np.testing.assert_allclose(solved.work, work, rtol=2e-5, atol=2e-5 * np.max(work))
    assert np.all(np.diff(solved.dissipation) >= -1e-12 * solved.dissipation[-1])
    assert np.all(solved.energy >= 0.0)
    assert np.all(np.diff(solved.residual_depth) >= 0.0)


def test_two_alike_bodies_are_two_halves():
    """By symmetry their common surface is as a rigid flat: each is pressed by half of the gap."""
    forces = np.array([50.0, 500.0, 5000.0, 1000.0, 0.0])
    pair = pressed(Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(STEEL, STEEL)), wk.Force(forces))
    half = pressed(Foundation(wk.Paraboloid(2.0 * RADIUS), wk.HalfSpace(STEEL)), wk.Force(forces))
    np.testing.assert_allclose(pair.depth, 2.0 * half.depth, rtol=1e-9)
    np.testing.assert_allclose(pair.radius, half.radius, rtol=1e-9)
    np.testing.assert_allclose(pair.dissipation, 2.0 * half.dissipation, rtol=1e-6)


def test_the_order_of_the_bodies_does_not_matter_and_a_stiff_one_is_rigid():
    other = wk.Elastic(70e9, 0.33, 0.3e9)
    loads = wk.Force([10.0, 300.0, 3000.0, 0.0])
    one, two = (
        pressed(Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(*bodies)), loads)
        for bodies in ((STEEL, other), (other, STEEL))
    )
    np.testing.assert_allclose(one.depth, two.depth, rtol=1e-9)
    stiff = pressed(Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(STEEL, wk.Elastic(210e15, 0.3))), loads)
    np.testing.assert_allclose(stiff.depth, pressed(BALL, loads).depth, rtol=1e-5)


def test_one_yielding_body_is_harder_than_the_composite_modulus_says():
    """Finite elements of two bodies: 2 to 9 per cent more force at the same depth, and a shallower dent."""
    ball = wk.Elastic(210e9, 0.3)
    apart = Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(STEEL, ball))
    composite = wk.Elastic(105e9, 0.3, STEEL.strength)
    depths = wk.Depth(np.geomspace(6e-6, 60e-6, 9))
    true, naive = pressed(apart, depths), pressed(Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(composite)), depths)
    excess = true.force / naive.force
    assert np.all((excess > 1.0) & (excess < 1.10))
    assert np.max(excess) > 1.02
    assert np.all(true.residual_depth < naive.residual_depth)


def test_a_cone_is_the_same_at_every_size():
    solved = pressed(Foundation(wk.Cone(1.22), wk.HalfSpace(STEEL)), wk.Force([1e-3, 1.0, 1e3]))
    for row in (solved.mean_pressure, solved.residual_depth / solved.depth, solved.dissipation / solved.force**1.5):
        np.testing.assert_allclose(row, row[0], rtol=1e-9)


def test_the_hardness_of_cones_is_above_that_of_the_cavity():
    """K. L. Johnson, J. Mech. Phys. Solids 18 (1970) 115-126: finite elements lie up to 18 % above his estimate."""
    for slope in (0.02, 0.04, 0.08):
        bed = Foundation(wk.Cone(math.pi / 2.0 - math.atan(slope)), wk.HalfSpace(STEEL))
        pressure = pressed(bed, wk.Force([10.0])).mean_pressure[0] / STEEL.strength
        cavity = 2.0 / 3.0 * (2.0 + math.log((210.0 * slope + 4.0 * 0.4) / (6.0 * 0.7)))
        assert 1.0 < pressure / cavity < 1.18


def test_without_a_strength_that_matters_it_is_elastic():
    hard = wk.Elastic(210e9, 0.3, 4e9)
    bed = Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(hard))
    solved = pressed(bed, wk.Depth([1e-6, 0.5e-6, -1e-6]))
    np.testing.assert_allclose(
        solved.force, wk.Indentation(bed, wk.Depth(np.array([1e-6, 0.5e-6, -1e-6]))).solve().force
    )
    assert solved.radius[2] == 0.0


@pytest.mark.parametrize(
    ("bed", "path", "says"),
    [
        (Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(wk.Elastic(210e9, 0.3))), [1.0], "no body has a strength"),
        (Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(wk.Elastic(210e9, 0.3, 5e9))), [1.0], "a fiftieth"),
        (Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(wk.Elastic(210e9, -0.1, 1e9))), [1.0], "from 0 to 0.45"),
        (Foundation(wk.FlatPunch(RADIUS), wk.HalfSpace(STEEL)), [1.0], "flat end"),
        (BALL, [[1.0, 2.0]], "one row"),
        (
            Foundation(wk.Paraboloid(RADIUS), wk.TransverselyIsotropicHalfSpace(WOOD)),
            [1.0],
            "no single strength",
        ),
    ],
)
def test_what_it_cannot_do_it_says(bed, path, says):
    with pytest.raises(InvalidInput, match=says):
        PlasticIndentation(bed, wk.Force(path))


def test_a_pull_is_refused():
    with pytest.raises(OutsideValidity, match="index 1 of the path"):
        pressed(BALL, wk.Force([1.0, -1.0]))


def test_a_much_blunter_profile_is_refused():
    bed = Foundation(wk.PowerLaw(coefficient=1e9, exponent=4.0), wk.HalfSpace(STEEL))
    with pytest.raises(OutsideValidity, match="grows like the power 4 of the radius"):
        pressed(bed, wk.Force([1000.0]))
