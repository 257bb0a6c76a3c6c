"""The statement on yield of every problem, against Hamilton's, Hertz's and Huber's stresses computed otherwise."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from scipy.optimize import minimize
from sliding_ball import mises, on_the_surface, point_loads

import winkler as wk

E, NU, Y, R = 210e9, 0.3, 1.2e9, 10e-3
ELASTIC = wk.Assumption.ELASTIC


def steel(strength=Y, nu=NU):
    return wk.Elastic(E, nu, strength)


def ball(strength=Y, nu=NU):
    return wk.Foundation(wk.Paraboloid(R), wk.HalfSpace(steel(strength, nu), steel(math.inf, nu)))


def hertz(share):
    """Return the force at which the frictionless von Mises stress is a share of the strength (0.62004 p0, nu = 0.3)."""
    modulus, p0 = 0.5 * E / (1.0 - NU**2), share * Y / 0.6200410039
    return math.pi**3 * R**2 * p0**3 / (6.0 * modulus**2)


def statement(solution):
    (note,) = (note for note in solution.validity if note.assumption is ELASTIC)
    return note


def slid(mu, force, strength=Y):
    """A ball that slides: the shift is more than friction bears."""
    path = wk.Path([0.0, 1.0], wk.Force(force), wk.Shift([0.0, 1e-3]))
    return wk.Tangential(ball(strength), wk.Coulomb(mu), path).solve()


def test_hamilton_six_tenths():
    """At 0.6 of the frictionless onset a ball that slides with 0.6 reaches 1.508 times the strength (Hamilton)."""
    load = hertz(1.0) * 0.6
    assert 0.6 ** (1.0 / 3.0) * on_the_surface(0.6, NU) / 0.6200410039 == pytest.approx(1.508, abs=1e-3)
    assert statement(wk.Indentation(ball(), wk.Force(load)).solve()).standing is wk.Standing.EXACT
    note = statement(slid(0.6, load))
    assert note.standing is wk.Standing.OUTSIDE
    assert "1.51 times the strength of the first body, at x = -" in note.statement
    assert "doi:10.1243/PIME_PROC_1983_197_076_02" in note.source


@pytest.mark.few(1)
@pytest.mark.parametrize("mu", [0.35, 0.5, 0.8, 1.5])
def test_first_yield_at_the_surface(mu):
    """Johnson: above a coefficient of 0.3 yielding begins at the surface; its load from closed forms."""
    share = 0.6200410039 / on_the_surface(mu, NU)
    below, above = (statement(slid(mu, hertz(1.0) * (factor * share) ** 3)) for factor in (0.999, 1.001))
    assert below.standing is wk.Standing.EXACT
    assert above.standing is wk.Standing.OUTSIDE
    assert ", z = 0 m" in above.statement


@pytest.mark.few(1)
@pytest.mark.parametrize(("mu", "nu"), [(0.1, 0.3), (0.25, 0.3), (0.2, 0.5)])
def test_first_yield_below_the_surface(mu, nu):
    """Point loads added up on the disc, and their greatest stress found by another search."""
    result = minimize(lambda place: -point_loads(mu, nu, place[0], math.exp(place[1])), [0.2, math.log(0.45)], tol=1e-9)
    peak = -result.fun
    modulus = 0.5 * E / (1.0 - nu * nu)
    for factor, standing in ((0.9999, wk.Standing.EXACT), (1.0001, wk.Standing.OUTSIDE)):
        p0 = factor * Y / peak
        force = math.pi**3 * R**2 * p0**3 / (6.0 * modulus**2)
        path = wk.Path([0.0, 1.0], wk.Force(force), wk.Shift([0.0, 1e-3]))
        bed = ball(nu=nu)
        assert statement(wk.Tangential(bed, wk.Coulomb(mu), path).solve()).standing is standing


def test_partial_slip_between_the_bounds_is_not_known():
    """Elastic without friction, not if all slid: a little shear leaves it open, and no shear bound leaves it open."""
    load = hertz(1.0) * 0.6
    path = wk.Path([0.0, 1.0], wk.Force(load), wk.ShearForce([0.0, 0.1 * 0.6 * load]))
    for solution in (
        wk.Tangential(ball(), wk.Coulomb(0.6), path).solve(),
        wk.Tangential(ball(), wk.Coulomb(math.inf), path).solve(),
        wk.RelaxationDamper(ball(), 1e-7, 1e-8, 100.0).solve(),
    ):
        note = statement(solution)
        assert note.standing is wk.Standing.APPROXIMATE
        assert "The onset of yield is not known because" in note.statement
    assert statement(slid(0.1, load)).standing is wk.Standing.EXACT


def test_kinetic_friction_counts_where_it_slides():
    """Static friction would make it yield, the kinetic one does not: not known; the greater kinetic one does."""
    load = hertz(1.0) * 0.6
    path = wk.Path([0.0, 1.0], wk.Force(load), wk.Shift([0.0, 1e-3]))
    weak, strong = (
        statement(wk.Tangential(ball(), wk.StaticKinetic(0.7, kinetic), path).solve()) for kinetic in (0.1, 0.6)
    )
    assert weak.standing is wk.Standing.APPROXIMATE
    assert strong.standing is wk.Standing.OUTSIDE
    assert "1.51 times" in strong.statement


def test_heating_slides():
    """A body that rubs slides: what makes heat makes it yield."""
    metal = wk.ThermalConductor(50.0, 1e-5)
    rubbed = wk.FrictionHeating(
        wk.Indentation(ball(), wk.Force(0.6 * hertz(1.0))), wk.Coulomb(0.6), wk.HeatConductors(metal, metal), 1.0
    )
    assert statement(rubbed.solve()).standing is wk.Standing.OUTSIDE


@pytest.mark.slow
def test_incompressible_cone():
    """Its deviator is bounded by 3/4 E* m at any load: never, or at the first touch."""
    m, modulus = 0.1, E / 0.75
    bound = 0.75 * modulus * m
    cone = wk.Cone(math.pi / 2.0 - math.atan(m))
    for factor, verdict, standing in (
        (1.001, "the body does not yield", wk.Standing.EXACT),
        (0.999, "yielding begins at the first touch", wk.Standing.OUTSIDE),
    ):
        bed = wk.Foundation(cone, wk.HalfSpace(wk.Elastic(E, 0.5, factor * bound)))
        with pytest.raises(wk.OutsideValidity, match=verdict):
            wk.YieldOnset(bed).solve()
        for depth in (1e-9, 1e-3):
            assert statement(wk.Indentation(bed, wk.Depth(depth)).solve()).standing is standing
    compressible = wk.Foundation(cone, wk.HalfSpace(wk.Elastic(E, 0.3, 1.2 * bound)))
    note = statement(wk.Indentation(compressible, wk.Depth(1e-6)).solve())
    assert note.standing is wk.Standing.APPROXIMATE
    assert note.statement.startswith("The apex is pointed, so the elastic stress is infinite there")


def test_capped_yields_at_the_cap_or_before():
    """A capped ball is Hertz's up to the edge of the flatter cap, where its slope jumps."""
    free = wk.YieldOnset(wk.Foundation(wk.Paraboloid(2.0 * R), wk.HalfSpace(steel()))).solve()
    wide = wk.YieldOnset(wk.Foundation(wk.CappedParaboloid(R, 2.0 * R, 1.1 * free.radius), wk.HalfSpace(steel())))
    assert wide.solve().force == pytest.approx(free.force, rel=1e-9)
    narrow = wk.Foundation(wk.CappedParaboloid(R, 2.0 * R, 0.9 * free.radius), wk.HalfSpace(steel()))
    onset = wk.YieldOnset(narrow).solve()
    assert (onset.radius, onset.r, onset.z) == (0.9 * free.radius, 0.9 * free.radius, 0.0)
    below, above = (wk.Indentation(narrow, wk.Force(part * onset.force)).solve() for part in (0.99, 1.01))
    assert statement(below).standing is wk.Standing.EXACT
    assert statement(above).standing is wk.Standing.APPROXIMATE
    assert statement(above).statement.startswith("The slope of the profile jumps")


def test_ellipse():
    """Steel, 3.77 mm x 124 mm, 1500 N: another program finds p0 2.62 GPa, 1502 MPa at 0.123 mm, the onset at 766 N."""

    def pressed(force, strength=1.2e9):
        medium = wk.HalfSpace(wk.Elastic(208e9, 0.3, strength), wk.Elastic(208e9, 0.3, strength))
        return wk.EllipticIndentation(wk.CurvedBodies(3.77e-3, 124e-3), medium, wk.Force(force)).solve()

    assert pressed(1500.0).peak_pressure == pytest.approx(2.62e9, rel=2e-3)
    note = statement(pressed(1500.0))
    assert note.standing is wk.Standing.OUTSIDE
    assert "yielding began at 76" in note.statement
    assert "at a depth of 0.000122 m" in note.statement
    onset = float(note.statement.split("began at ")[1].split(" N")[0])
    assert onset == pytest.approx(766.0, rel=1e-3)
    assert 1.2e9 * (1500.0 / onset) ** (1.0 / 3.0) == pytest.approx(1502e6, rel=1e-3)
    assert statement(pressed(760.0)).standing is wk.Standing.EXACT


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.5])
def test_round_ellipse_is_a_ball(nu):
    """Of equal curvatures the axis is Huber's, and the onset that of the round contact."""
    medium = wk.HalfSpace(steel(nu=nu))
    onset = wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), medium)).solve().force
    for factor, standing in ((0.9999, wk.Standing.EXACT), (1.0001, wk.Standing.OUTSIDE)):
        pressed = wk.EllipticIndentation(wk.CurvedBodies(R, R), medium, wk.Force(factor * onset)).solve()
        assert statement(pressed).standing is standing


@pytest.mark.slow
def test_layers_are_checked_one_by_one():
    """A layer of the substrate's own solid is no layer: Huber's axis gives both stresses, nu = 0.3, h = 1.5 a."""
    a, h = 1e-4, 1.5e-4
    peak, at_face = 0.6200410039, 0.0

    def axis(z):
        return abs(-1.0 / (1.0 + z * z) + 1.3 * (1.0 - z * math.atan(1.0 / z)) - 0.5 / (1.0 + z * z))

    at_face = axis(1.5)
    modulus = E / (1.0 - NU**2)
    p0 = 2.0 * modulus * a / (math.pi * R)
    for layer, base, standings in (
        (1.01 * peak, 1.01 * at_face, (wk.Standing.EXACT, wk.Standing.EXACT)),
        (0.99 * peak, 1.01 * at_face, (wk.Standing.OUTSIDE, wk.Standing.EXACT)),
        (1.01 * peak, 0.99 * at_face, (wk.Standing.EXACT, wk.Standing.OUTSIDE)),
    ):
        medium = wk.CoatedHalfSpace([wk.Layer(steel(layer * p0), h)], on=steel(base * p0))
        pressed = wk.Indentation(wk.Foundation(wk.Paraboloid(R), medium), wk.Radius(a)).solve()
        notes = [note for note in pressed.validity if note.assumption is ELASTIC]
        assert tuple(note.standing for note in notes) == standings
        assert "layer 1" in notes[0].statement
        assert "body under the layers" in notes[1].statement


@pytest.mark.slow
@pytest.mark.slow
def test_friction_on_a_bonded_stack_is_that_on_a_coating():
    layer, said = steel(2.0 * Y), []
    for medium in (
        wk.CoatedHalfSpace([wk.Layer(layer, 1e-4)], on=wk.Elastic(0.5 * E, NU)),
        wk.StackedHalfSpace([wk.StackLayer(layer, 1e-4, True)], on=wk.Elastic(0.5 * E, NU)),
    ):
        path = wk.Path([0.0, 1.0], wk.Force(5.0), wk.Shift([0.0, 1e-8]))
        said.append(statement(wk.Tangential(wk.Foundation(wk.Paraboloid(R), medium), wk.Coulomb(0.3), path).solve()))
    assert said[0].statement == said[1].statement
    assert said[1].standing is wk.Standing.EXACT


@pytest.mark.slow
def test_friction_on_layers_is_known_and_so_are_wide_contacts():
    medium = wk.CoatedHalfSpace([wk.Layer(steel(1e30), 1e-4)], on=wk.Elastic(E, NU))
    bed = wk.Foundation(wk.Paraboloid(R), medium)
    path = wk.Path([0.0, 1.0], wk.Force(1.0), wk.Shift([0.0, 1e-9]))
    rubbed = statement(wk.Tangential(bed, wk.Coulomb(0.3), path).solve())
    assert rubbed.standing is wk.Standing.EXACT
    assert "if all of it slid with the coefficient 0.3" in rubbed.statement
    thin = wk.CoatedHalfSpace([wk.Layer(steel(1e30), 1e-6)], on=wk.Elastic(E, NU))
    bed = wk.Foundation(wk.Paraboloid(R), thin)
    wide = statement(wk.Indentation(bed, wk.Radius(1.1e-5)).solve())
    assert wide.standing is wk.Standing.EXACT
    assert "of the strength of the layer 1" in wide.statement


@pytest.mark.long
def test_attraction_without_range():
    """The edge is torn with an infinite stress whatever the strength; the constant stress of Dugdale is finite."""
    rubber = wk.HalfSpace(wk.Elastic(1e6, 0.5, 1e9))
    bed = wk.Foundation(wk.Paraboloid(1e-3), rubber)
    short = statement(wk.AdhesiveIndentation(bed, wk.ShortRange(0.05), wk.Force(0.0)).solve())
    assert short.standing is wk.Standing.APPROXIMATE
    assert "pulls the edge" in short.statement
    ranged = statement(wk.AdhesiveIndentation(bed, wk.Dugdale(0.05, 1e6), wk.Force(0.0)).solve())
    assert ranged.standing is wk.Standing.EXACT


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    ("pressure", "standing"),
    [(1.7, wk.Standing.OUTSIDE), (1.2, wk.Standing.ASYMPTOTIC), (0.15, wk.Standing.ASYMPTOTIC)],
)
def test_height_map(pressure, standing):
    """A ball on a map, its greatest pressure over the strength; von Mises' stress is 0.62 of the former (nu = 0.3)."""
    x = np.linspace(-0.5, 0.5, 65)[:-1] + 1.0 / 128.0
    rough = wk.Topography(-0.5 * (x[:, None] ** 2 + x**2), [1.0, 1.0])
    modulus = 1.0 / (1.0 - NU**2)
    p0 = 2.0 * modulus * math.sqrt(0.125) / math.pi
    medium = wk.HalfSpace(wk.Elastic(1.0, NU, p0 / pressure))
    note = statement(wk.SurfaceContact(rough, medium, wk.Depth(0.125)).solve())
    assert note.standing is standing
    share = float(re.search(r"stress (?:on this grid )?is ([\d.]+) (?:times|of)", note.statement)[1])
    assert share == pytest.approx(0.6200410039 * pressure, rel=0.01)


@pytest.mark.slow
def test_twist():
    """The squares add: at the surface of a ball that turns all over, the traction mu p0 f adds to Hertz's stresses."""
    force = 0.5 * hertz(1.0)
    path = wk.Path([0.0, 1.0], wk.Force(force), wk.Angle([0.0, 1.0]))

    def turned(strength):
        return statement(wk.Torsion(ball(strength), wk.Coulomb(0.8), path).solve())

    p0 = 0.5 ** (1.0 / 3.0) * Y / 0.6200410039
    # at r on the surface: Hertz's three stresses, and the traction 0.8 p along the circle (the rest can only add)
    r = np.linspace(0.01, 0.99, 99)
    root = np.sqrt(1.0 - r * r)
    swell = (1.0 - 2.0 * NU) / 3.0 * (1.0 - root**3) / r**2
    least = p0 * float(np.max(mises(swell - root, -swell - 2.0 * NU * root, -root, 0.0, 0.0, 0.8 * root)))
    assert turned(0.98 * least).standing is wk.Standing.OUTSIDE
    assert turned(3.0 * least).standing is wk.Standing.EXACT
    assert least > 1.5 * 0.6200410039 * p0  # friction matters here


CRYSTAL = wk.TransverselyIsotropic(162e9, 92e9, 69e9, 181e9, 47e9)
RUBBER = wk.StandardSolid(relaxed_shear=1e9, shear=2e9, relaxation_time=1.0)


@pytest.mark.parametrize(
    "medium",
    [
        lambda solid: wk.HalfSpace(wk.Rigid(), solid),
        lambda solid: wk.TransverselyIsotropicHalfSpace(CRYSTAL, solid),
        lambda solid: wk.CoatedHalfSpace([wk.Layer(wk.Elastic(E, NU), 1e-3)], on=wk.Rigid(), second=solid),
        lambda solid: wk.CoatedHalfSpace([wk.Layer(wk.Elastic(E, NU), 1e-3)], on=solid),
    ],
)
def test_every_body_of_a_medium_is_checked(medium):
    """Whichever body is given the strength: tiny, it yields."""
    for strength, standing in ((1e3, wk.Standing.OUTSIDE), (1e30, wk.Standing.EXACT)):
        bed = wk.Foundation(wk.Paraboloid(R), medium(steel(strength)))
        note = statement(wk.Indentation(bed, wk.Force(10.0)).solve())
        assert note.standing is standing


@pytest.mark.parametrize(
    "medium",
    [
        lambda solid: wk.ViscoelasticHalfSpace(RUBBER, solid),
        lambda solid: wk.RelaxingInProportion(wk.HalfSpace(solid), RUBBER, shear=1e9),
    ],
)
def test_bodies_that_relax(medium):
    bed = wk.Foundation(wk.Paraboloid(R), medium(steel(1e3)))
    tested = wk.RelaxationTest(bed, depth=1e-6, time=np.array([0.1, 1.0])).solve()
    assert statement(tested).statement.startswith("The onset of yield is not known because the stresses in bodies that")


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("profile", [wk.FlatPunch(1e-3), wk.Cone(1.3), wk.TruncatedCone(1.3, 1e-4)])
def test_sharp_places(profile):
    """Infinite there whatever the strength; what is beyond a tenth of the contact radius decides."""
    for strength, standing in ((1e3, wk.Standing.OUTSIDE), (1e30, wk.Standing.APPROXIMATE)):
        bed = wk.Foundation(profile, wk.HalfSpace(steel(strength)))
        for solution in (
            wk.Indentation(bed, wk.Depth(1e-6)).solve(),
            wk.FrictionDamping(bed, wk.Coulomb(0.3), wk.Depth(1e-6), wk.Shift(1e-9)).solve(),
        ):
            assert statement(solution).standing is standing
            assert "so the elastic stress is infinite there" in statement(solution).statement


def test_flat_punch_away_from_its_rim():
    """Below the middle of a flat punch, nu = 0.5 (Sneddon's stresses): that much is reached away from the rim."""
    # on the axis sigma_z = -p_m (1 + 3 z^2)/(2 (1 + z^2)^2)
    force, a = 1.0, 1e-3
    mean = force / (math.pi * a * a)
    z = np.linspace(0.2, 3.0, 300)
    axial = -0.5 * (1.0 + 3.0 * z * z) / (1.0 + z * z) ** 2
    trace = -1.5 / (1.0 + z * z)  # sigma_x + sigma_y + sigma_z = -(1 + nu) p_m/(1 + z^2), nu = 1/2
    radial = 0.5 * (trace - axial)
    least = mean * float(np.max(np.abs(axial - radial)))
    bed = wk.Foundation(wk.FlatPunch(a), wk.HalfSpace(wk.Elastic(1e9, 0.5, 0.99 * least)))
    assert statement(wk.Indentation(bed, wk.Force(force)).solve()).standing is wk.Standing.OUTSIDE


def test_springs_of_a_height_map():
    """They give forces, not pressures: whatever the strength of what the map was pressed into, that is stated."""
    x = np.linspace(-0.5, 0.5, 65)[:-1] + 1.0 / 128.0
    ball_map = wk.Topography(-0.5 * (x[:, None] ** 2 + x**2), [1.0, 1.0])
    bed = wk.ReducedBed(ball_map, wk.HalfSpace(wk.Elastic(1.0, 0.3, 1e-9)), 0.05)
    note = statement(wk.Indentation(bed, wk.Depth(0.02)).solve())
    assert note.standing is wk.Standing.APPROXIMATE
    assert "does not define the outline" in note.statement
