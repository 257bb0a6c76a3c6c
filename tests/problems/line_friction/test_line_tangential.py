"""Line contacts that slip in part: Cattaneo's cylinder, other profiles, histories, losses, stresses."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from half_plane_march import HalfPlaneMarch

import winkler as wk
from winkler.problems.line.stress import LineFields
from winkler.problems.line_friction import slip_work
from winkler.problems.line_friction.strips import slipped

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
MODULUS = 210e9 / (2 * 0.91)
UNIT = wk.HalfSpace.between(wk.Elastic(2.0, 0.0), wk.Elastic(2.0, 0.0))
"""E* = 1."""
CYLINDER = wk.LineFoundation(wk.Paraboloid(1.0), UNIT)
MU = 0.4
PROFILES = {
    "wedge": (wk.Cone(1.5), 200e3),
    "rounded punch": (wk.RoundedPunch(flat_radius=0.1e-3, edge_radius=10e-3), 100e3),
    "fourth power": (wk.PowerLaw(coefficient=1e8, exponent=4.0), 100e3),
    "rounded wedge": (wk.RoundedCone(curvature_radius=1e-3, half_angle=1.45), 300e3),
    "sphere": (wk.Sphere(10e-3), 100e3),
}


def sheared(profile, path, medium=PAIR, mu=MU):
    return wk.LineTangential(wk.LineFoundation(profile, medium), wk.Coulomb(mu), path).solve()


def pressed(profile, force, medium=PAIR):
    return wk.LineIndentation(wk.LineFoundation(profile, medium), wk.LineForce(force)).solve()


def over(low, high, count=400):
    """Return Gauss-Legendre places and weights from low to high, with roots at both ends mapped away."""
    node, weight = np.polynomial.legendre.leggauss(count)
    half = 0.5 * (high - low)
    return 0.5 * (low + high) + half * np.sin(0.5 * np.pi * node), 0.5 * np.pi * half * np.cos(
        0.5 * np.pi * node
    ) * weight


# --------------------------------------------------------------------------------------------- closed forms


def test_a_cylinder_slips_as_cattaneo_says():
    """E* = R = P = 1: a = sqrt(4/pi), c = a sqrt(1 - Q/(mu P)), traction, slip and loss at 30 digits."""
    state = sheared(wk.Paraboloid(1.0), wk.LinePath(1.0, [0.0, 0.25]), UNIT).at(-1)
    with mp.workdps(30):
        mu, shear = mp.mpf("0.4"), mp.mpf("0.25")
        a = mp.sqrt(4 / mp.pi)
        c = a * mp.sqrt(1 - shear / mu)

        def hertz(x, edge):
            return mp.sqrt(max(edge**2 - x**2, mp.mpf(0))) / 2

        def opened(x):
            return (x * mp.sqrt(x**2 - c**2) - c**2 * mp.acosh(x / c)) / 2

        lost = 2 * mu**2 * mp.quad(lambda x: hertz(x, a) * opened(x), [c, (a + c) / 2, a])
        places = [mp.mpf(k) / 20 for k in range(-22, 23)]
        tractions = [float(mu * (hertz(abs(x), a) - hertz(abs(x), c))) for x in places]
        slips = [float(mu * opened(abs(x))) if abs(x) > c else 0.0 for x in places]
        shift = float(2 * mu * mp.quad(lambda x: opened(x) / (mp.pi * mp.sqrt(a**2 - x**2)), [c, (a + c) / 2, a]))
    x = np.array([float(place) for place in places])
    assert state.stick_half_width == pytest.approx(float(c), rel=1e-13)
    assert state.traction(x) == pytest.approx(tractions, rel=1e-12, abs=1e-14)
    assert state.slip(x) == pytest.approx(slips, rel=1e-12, abs=1e-14)
    assert state.dissipation_per_length == pytest.approx(float(lost), rel=1e-12)
    assert state.slip_shift == pytest.approx(shift, rel=1e-12)


def test_a_closed_cycle_has_the_known_tractions_and_loss():
    """After Q, -Q: q = q(Q) - 2 mu [p - p(c2)], c2 = a sqrt(1 - Q/(mu P)); a cycle loses 4 times ... as computed."""
    path = wk.LinePath(1.0, [0.0, 0.25, -0.1, 0.25, -0.1])
    solution = sheared(wk.Paraboloid(1.0), path, UNIT)
    a, x = np.sqrt(4.0 / np.pi), np.linspace(-1.1, 1.1, 45)

    def hertz(share):
        return 0.5 * np.sqrt(np.maximum(share * a**2 - x**2, 0.0))

    expected = MU * (hertz(1.0) - hertz(1.0 - 0.25 / MU)) - 2.0 * MU * (hertz(1.0) - hertz(1.0 - 0.35 / (2.0 * MU)))
    assert solution.at(2).traction(x) == pytest.approx(expected, rel=1e-12, abs=1e-14)
    assert solution.at(4).traction(x) == pytest.approx(expected, rel=1e-12, abs=1e-14)
    assert solution.at(3).traction(x) == pytest.approx(solution.at(1).traction(x), rel=1e-12, abs=1e-14)
    half, other = np.diff(solution.dissipation_per_length)[-2:]
    assert half == pytest.approx(other, rel=1e-12)
    places, weights = over(np.sqrt(1.0 - 0.35 / (2.0 * MU)) * a, a)
    c = np.sqrt(1.0 - 0.35 / (2.0 * MU)) * a
    opened = 0.5 * (places * np.sqrt(places**2 - c**2) - c**2 * np.arccosh(places / c))
    rubbed = 2.0 * weights @ (MU * 0.5 * np.sqrt(a**2 - places**2) * 2.0 * MU * opened)
    assert half == pytest.approx(rubbed, rel=1e-11)


def test_sliding_is_reached_with_a_finite_loss():
    """The middle slips last: s = mu x^2/(2R), W = pi mu^2 p0 a^3/(16 R)."""
    solution = sheared(wk.Paraboloid(1.0), wk.LinePath(1.0, [0.0, MU, 0.0, -MU]), UNIT)
    a = np.sqrt(4.0 / np.pi)
    state = solution.at(1)
    assert state.sliding
    assert state.stick_half_width == 0.0
    assert state.slip(0.5) == pytest.approx(MU * 0.125, rel=1e-12)
    assert state.dissipation_per_length == pytest.approx(np.pi * MU**2 * 0.5 * a**4 / 16.0, rel=1e-12)
    assert solution.dissipation_per_length[3] == pytest.approx(3.0 * state.dissipation_per_length, rel=1e-12)


@pytest.mark.parametrize("name", PROFILES)
def test_other_profiles_are_pressed_contacts_less_narrower_ones(name):
    """Traction, slip and loss from LineIndentation at P and at P - Q/mu: nothing of the memory is in them."""
    profile, force = PROFILES[name]
    shear = 0.6 * MU * force
    state = sheared(profile, wk.LinePath(force, [0.0, shear])).at(-1)
    whole, core = pressed(profile, force), pressed(profile, force - shear / MU)
    a, c = whole.half_width, core.half_width
    x = np.array([-0.95, -0.3, 0.1, 0.62, 0.9, 1.2]) * a
    assert state.stick_half_width == pytest.approx(c, rel=1e-12)
    assert state.traction(x) == pytest.approx(MU * (whole.pressure(x) - core.pressure(x)), rel=1e-11)
    assert state.slip(x[:5]) == pytest.approx(MU * core.separation(x[:5]), rel=1e-11)
    marks = [c, *(b for b, _ in whole.problem.bed.kinks if c < b < a), a]
    lost = 0.0
    for low, high in zip(marks, marks[1:], strict=False):
        places, weights = over(low, high, 60)
        lost += 2.0 * weights @ (MU * whole.pressure(places) * MU * core.separation(places))
    assert state.dissipation_per_length == pytest.approx(lost, rel=1e-9)


# ------------------------------------------------------------------------------------------------ histories


PLACES = np.linspace(0.04, 0.96, 24)
"""Over the half-width."""


def marched(path_of, count, parts, bulk=0.0):
    """Return how far winkler is off from a march: loss, slip at places, and force per length borne inside of them."""
    forces, shears = (np.array(row) for row in path_of)
    solution = sheared(wk.Paraboloid(1.0), wk.LinePath(forces, shears, bulk_stress=bulk), UNIT)
    width, steady = np.sqrt(4.0 * np.max(forces) / np.pi), np.ptp(forces) == 0.0
    even = np.linspace(-1.0 if bulk else 0.0, 1.0, count + 1)
    march = HalfPlaneMarch(width * (np.sin(0.5 * np.pi * even) if steady else even), MU, forces[0])
    off, sizes = [], []
    for index in range(1, forces.size):
        for part in range(1, parts + 1):
            force, shear = (row[index - 1] + (row[index] - row[index - 1]) * part / parts for row in (forces, shears))
            march.go(force, shear, 0.5 * bulk * shear / np.max(np.abs(shears)), part == 1)
        state = solution.at(index)
        x = state.half_width * (np.concatenate([-PLACES[::-1], PLACES]) if bulk else PLACES)
        ahead = np.interp(x, march.x, march.ahead) - np.interp(0.0, march.x, march.ahead)
        node, weight = np.polynomial.legendre.leggauss(6)
        within = state.traction(march.x[:, None] + 0.5 * march.h[:, None] * node) @ (0.5 * weight)
        borne = [np.interp(x, march.edges, np.append(0.0, np.cumsum(march.h * q))) for q in (march.traction, within)]
        off.append([[march.lost / state.dissipation_per_length - 1.0], ahead - state.slip(x), borne[0] - borne[1]])
        sizes.append([1.0, np.max(np.abs(state.slip(x))), np.max(np.abs(borne[1]))])
    largest = np.max(sizes, axis=0)
    return [np.concatenate([row[k] / largest[k] for row in off]) for k in range(3)]


STEADY = ([1.0, 1.0, 1.0, 1.0], [0.0, 0.25, -0.2, 0.1])
VARYING = ([1.0, 1.0, 1.4, 0.8, 1.2], [0.0, 0.25, 0.1, -0.1, 0.15])


def test_a_history_under_steady_pressing_is_that_of_boundary_elements():
    for off in marched(STEADY, 300, 1):
        assert np.max(np.abs(off)) < 1e-4


def test_a_history_of_both_forces_is_near_that_of_boundary_elements():
    for off in marched(VARYING, 150, 80):
        assert np.sqrt(np.mean(off**2)) < 5e-4


@pytest.mark.slow
def test_a_history_of_both_forces_is_that_of_boundary_elements():
    """What is left is at the edge, where elements come into contact within a step, and falls with their size."""
    for off in marched(VARYING, 400, 160):
        assert np.sqrt(np.mean(off**2)) < 1e-4
        assert np.max(np.abs(off)) < 6e-4


@pytest.mark.parametrize("bulk", [0.1, 0.28])
def test_a_bulk_stress_is_that_of_boundary_elements(bulk):
    for off in marched(([1.0] * 4, [0.0, 0.25, -0.25, 0.1]), 500, 1, bulk):
        assert np.max(np.abs(off)) < 1e-4


def test_beside_a_bulk_stress_a_step_sums_only_the_strips_that_change(monkeypatch):
    """To and fro with ever smaller forces, all turning points are remembered."""
    summed = []

    def counted(bed, strips, x):
        summed.append(len(strips))
        return slipped(bed, strips, x)

    monkeypatch.setattr(slip_work, "slipped", counted)
    shears = 4e4 * (-1.0) ** np.arange(30) * np.linspace(1.0, 0.1, 30)
    solution = sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, shears, bulk_stress=1e8))
    assert len(solution.at(-1).strips) > 25
    assert max(summed) <= 3


@pytest.mark.slow
def test_beyond_the_limit_of_a_bulk_stress_an_edge_slips_back():
    """At 1.13 times the bulk stress at which it begins to."""
    for off in marched(([1.0] * 3, [0.0, 0.25, -0.25]), 300, 10, 0.32):
        assert np.max(np.abs(off)) < 3e-4


def test_bodies_that_are_pressed_and_sheared_in_proportion_stick():
    """dQ/dP below mu: the traction is the pressure times Q/P, nothing is lost; narrower strips were moved farther."""
    solution = sheared(wk.Paraboloid(10e-3), wk.LinePath([0.0, 1e5], [0.0, 3e4]))
    state, x = solution.at(-1), np.linspace(-1e-4, 1e-4, 21)
    assert state.stick_half_width == state.half_width
    assert state.traction(x) == pytest.approx(0.3 * state.pressure(x), rel=1e-13)
    assert state.dissipation_per_length == 0.0
    assert state.slip_shift == pytest.approx(3e4 / (np.pi * MODULUS), rel=1e-12)


def test_the_loop_encloses_the_loss():
    solution = sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, [0.0, 3e4, -3e4, 3e4], count=400))
    lost = solution.dissipation_per_length[-1] - solution.dissipation_per_length[400]
    area = np.trapezoid(solution.shear_force_per_length[400:], solution.slip_shift[400:])
    assert area == pytest.approx(lost, rel=1e-5)


def test_shear_force_and_bulk_stress_do_the_work_that_is_lost():
    """Over a cycle the loss is the work of Q on the shift less that of the moment of q on the strain."""
    solution = sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, [0.0, 3e4, -3e4, 3e4], bulk_stress=1.5e8, count=200))
    x, weight = over(-solution.half_width[0], solution.half_width[0], 400)
    moment = np.array([weight @ (x * state.traction(x)) for state in solution.states[200::10]])
    strain = solution.bulk_stress[200::10] * (1.0 - 0.3**2) / 210e9
    area = np.trapezoid(solution.shear_force_per_length[200:], solution.slip_shift[200:])
    lost = solution.dissipation_per_length[-1] - solution.dissipation_per_length[200]
    assert area < 0.85 * lost
    assert area - np.trapezoid(moment, strain) == pytest.approx(lost, rel=2e-3)


@pytest.mark.parametrize(("profile", "bulk"), [("cylinder", 0.0), ("cylinder", 60e6), ("rounded punch", 0.0)])
def test_the_loss_by_place_adds_up_to_the_loss(profile, bulk):
    """Between the edges of all earlier contacts, where it is smooth."""
    shape = wk.Paraboloid(10e-3) if profile == "cylinder" else PROFILES[profile][0]
    solution = sheared(shape, wk.LinePath(1e5, [0.0, 2e4, -1e4, 3e4, 1e4], bulk_stress=bulk))
    a = solution.half_width[0]
    edges = {s.middle + side * s.half_width for state in solution.states for s in state.strips for side in (-1.0, 1.0)}
    marks = sorted({-a, a, *(edge for edge in edges if abs(edge) < a), *((0.1e-3, -0.1e-3) if a > 0.1e-3 else ())})
    total = 0.0
    for low, high in zip(marks, marks[1:], strict=False):
        places, weights = over(low, high, 40)
        total += weights @ solution.friction_work(places)
    assert total == pytest.approx(solution.dissipation_per_length[-1], rel=1e-9)
    assert solution.friction_work([0.0, 2.0 * a]) == pytest.approx([0.0, 0.0], abs=1e-12)
    with pytest.raises(wk.OutsideValidity, match="the normal force changes"):
        sheared(shape, wk.LinePath([1e5, 2e5], [0.0, 1e4])).friction_work(0.0)


def test_a_flat_punch_sticks_until_it_slides():
    solution = sheared(wk.FlatPunch(1e-3), wk.LinePath(1e5, [0.0, 3.9e4, -4e4]))
    assert solution.stick_half_width[:2] == pytest.approx([1e-3, 1e-3])
    assert solution.stick_half_width[2] == 0.0
    assert np.all(solution.dissipation_per_length == 0.0)


# ---------------------------------------------------------------------------------------------- bulk stress


def test_a_bulk_stress_shifts_what_sticks_as_nowell_and_hills_say():
    """e = sigma a/(4 mu p0), c as without; the tractions at the peak and at the other end of the cycle."""
    shear, bulk = 0.25, 0.2
    solution = sheared(wk.Paraboloid(1.0), wk.LinePath(1.0, [0.0, shear, -shear], bulk_stress=bulk), UNIT)
    a = np.sqrt(4.0 / np.pi)
    c, e = a * np.sqrt(1.0 - shear / MU), bulk * a / (4.0 * MU * 0.5 * a)
    assert solution.stick_half_width[1] == pytest.approx(c, rel=1e-13)
    assert solution.stick_middle[1] == pytest.approx(e, rel=1e-13)
    assert solution.bulk_stress == pytest.approx([0.0, bulk, -bulk])
    x = np.linspace(-1.2, 1.2, 97)

    def ellipse(edge, middle=0.0):
        return 0.5 * np.sqrt(np.maximum(edge**2 - (x - middle) ** 2, 0.0))

    expected = MU * (ellipse(a) - ellipse(c, e))
    assert solution.at(1).traction(x) == pytest.approx(expected, rel=1e-12, abs=1e-14)
    assert solution.at(2).traction(x) == pytest.approx(-expected, rel=1e-12, abs=1e-14)


def test_a_small_bulk_stress_meets_none():
    """The loss of strips, and that of the memory, are computed in different ways."""
    forces, shears = 1e5, [0.0, 3e4, -1e4, 2e4, -3.5e4]
    none, small = (sheared(wk.Paraboloid(10e-3), wk.LinePath(forces, shears, bulk_stress=bulk)) for bulk in (0.0, 1e-3))
    assert small.dissipation_per_length == pytest.approx(none.dissipation_per_length, rel=1e-9)
    assert small.slip_shift == pytest.approx(none.slip_shift, rel=1e-8)


def test_beyond_the_bulk_stress_that_makes_an_edge_slip_back_elements_are_noted():
    """For similar bodies 4 Q/(pi a)."""
    a = np.sqrt(4.0 / np.pi)
    most = 4.0 * 0.25 / (np.pi * a)

    def standing(share, count=1):
        path = wk.LinePath(1.0, [0.0, 0.25], bulk_stress=share * most, count=count)
        notes = sheared(wk.Paraboloid(1.0), path, UNIT).validity
        return [note.standing for note in notes if note.assumption is wk.Assumption.SLIP]

    assert standing(0.999, 50) == [wk.Standing.EXACT]
    assert standing(1.01) == [wk.Standing.APPROXIMATE]


# --------------------------------------------------------------------------------------------------- stresses


def of_line_loads(state, x, z, side):
    """Flamant's stresses of pressure and traction, summed over the strip, in plane strain."""
    a = state.half_width
    marks = sorted({-a, a, *(s.middle + d * s.half_width for s in state.strips for d in (-1.0, 1.0))})
    xx = zz = xz = 0.0
    for low, high in zip(marks, marks[1:], strict=False):
        places, weights = over(low, high, 200)
        p, q = weights * state.pressure(places), weights * side * state.traction(places)
        far, square = x - places, (x - places) ** 2 + z**2
        pull = -2.0 / (np.pi * square**2) * (p * z + q * far)
        xx, zz, xz = xx + np.sum(pull * far**2), zz + np.sum(pull * z**2), xz + np.sum(pull * far * z)
    return np.array([xx, zz, xz])


@pytest.mark.few(2)
@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("bulk", [0.0, 80e6])
def test_stresses_are_those_of_line_loads(side, bulk):
    state = sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, [0.0, 3e4, -1e4], bulk_stress=bulk)).at(-1)
    here = bulk * (-1.0 / 3.0) if side > 0.0 else 0.0
    for x, z in ((0.3e-4, 0.5e-4), (-1.1e-4, 0.2e-4), (2e-4, 1e-4)):
        found = state.stresses(x, side * z)
        exact = of_line_loads(state, x, z, side) + np.array([here, 0.0, 0.0])
        assert np.array([found.xx_stress, found.zz_stress, found.xz_stress]) == pytest.approx(exact, rel=1e-9)
        assert found.yy_stress == pytest.approx(0.3 * (exact[0] + exact[1]), rel=1e-9)
        assert found.z == side * z
        assert isinstance(found, LineFields)


def test_the_trailing_edge_is_pulled_by_twice_the_friction():
    """Sliding: 2 mu p0 at x = -a; beside it 2 mu p0 (|x|/a - sqrt(x^2/a^2 - 1)), and the bulk stress adds."""
    slid = sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, [0.0, MU * 1e5])).at(-1)
    a, p0 = slid.half_width, MODULUS * slid.half_width / 20e-3
    assert slid.stresses(-a, 0.0).xx_stress == pytest.approx(2.0 * MU * p0, rel=1e-12)
    away = slid.stresses(-1.5 * a, 0.0).xx_stress
    assert away == pytest.approx(2.0 * MU * p0 * (1.5 - np.sqrt(1.25)), rel=1e-12)
    partial = sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, [0.0, 3e4], bulk_stress=50e6)).at(-1)
    c, e = partial.stick_half_width, partial.stick_middle
    root = np.sqrt((a + e) ** 2 - c**2)
    core = p0 * c / a * ((a + e) - root) / c
    assert partial.stresses(-a, 0.0).xx_stress == pytest.approx(2.0 * MU * (p0 - core) + 50e6, rel=1e-12)


# --------------------------------------------------------------------------------------------------- refusals


@pytest.mark.parametrize(
    ("profile", "path", "sentence"),
    [
        (wk.Paraboloid(10e-3), ([1e5, 1e5], [0.0, 5e4]), "index 1 .* friction limit is 40000 N/m"),
        (wk.Paraboloid(10e-3), ([1e5, 0.0], [0.0, 1.0]), "index 1 .* friction limit is 0 N/m"),
        (wk.Paraboloid(10e-3), ([1e5, 1e5], [0.0, 1e4, 0.0]), "give one number for each point"),
        (wk.Paraboloid(10e-3), ([1e5, 1e5], [0.0, 0.0], 1e6), "there is none"),
    ],
)
def test_what_cannot_be_is_refused(profile, path, sentence):
    with pytest.raises(wk.WinklerError, match=sentence):
        sheared(profile, wk.LinePath(*path))


def test_bodies_of_which_slip_or_bulk_stress_is_not_known_are_refused():
    relaxing = wk.ViscoelasticHalfSpace(wk.StandardSolid(1e9, 1e8, 0.01, 0.4))
    with pytest.raises(wk.InvalidInput, match="relax over time, and the path states none; give LinePath"):
        sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, [0.0, 1e4]), relaxing)
    with pytest.raises(wk.InvalidInput, match="first body is rigid"):
        sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, [0.0, 1e4], bulk_stress=1e6), wk.HalfSpace(wk.Rigid(), STEEL))


def test_anisotropic_bodies_move_along_by_another_factor_than_they_sink():
    """What slips is sqrt(C33 / C11) times that of an isotropic pair with the same E* (Elliott)."""
    wood = wk.TransverselyIsotropic(11e9, 4e9, 4e9, 20e9, 3e9)
    medium = wk.TransverselyIsotropicHalfSpace(wood)
    alike = wk.HalfSpace(wk.Elastic(medium.modulus, 0.0))
    path = wk.LinePath([1e5, 1e5, 1.2e5], [0.0, 2e4, -1e4])
    found, plain = (sheared(wk.Paraboloid(10e-3), path, each) for each in (medium, alike))
    ratio = np.sqrt(20.0 / 11.0)
    np.testing.assert_allclose(found.half_width, plain.half_width, rtol=1e-13)
    np.testing.assert_allclose(found.stick_half_width, plain.stick_half_width, rtol=1e-12)
    np.testing.assert_allclose(found.dissipation_per_length, ratio * plain.dissipation_per_length, rtol=1e-12)
    np.testing.assert_allclose(found.slip_shift, ratio * plain.slip_shift, rtol=1e-12)
    x = np.linspace(0.0, 1.0, 9) * found.half_width[1]
    np.testing.assert_allclose(found.at(1).slip(x), ratio * plain.at(1).slip(x), rtol=1e-12)
    pulled = wk.LinePath(1e5, [0.0, 2e4, -1e4], bulk_stress=2e6)
    found = sheared(wk.Paraboloid(10e-3), pulled, medium)
    out_of_phase = wk.LinePath(1e5, [0.0, 2e4, -1e4], bulk_stress=[0.0, 2e6, -1.0001e6])
    marched = sheared(wk.Paraboloid(10e-3), out_of_phase, medium)
    np.testing.assert_allclose(marched.stick_middle, found.stick_middle, atol=1e-3 * found.half_width[0])
    np.testing.assert_allclose(marched.dissipation_per_length[1:], found.dissipation_per_length[1:], rtol=1e-3)


def test_a_bulk_stress_beside_hardly_any_shear_force_is_that_of_the_bulk_stress_alone():
    """However small the force is: both edges slip, against each other."""
    alone = sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, 0.0, bulk_stress=[0.0, 1e8]))
    assert alone.stick_middle[-1] == pytest.approx(0.0, abs=1e-9 * alone.half_width[-1])
    for share in (1e-11, 1e-40):
        faint = sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, [0.0, share * MU * 1e5], bulk_stress=1e8))
        assert faint.stick_half_width[-1] == pytest.approx(alone.stick_half_width[-1], rel=1e-6)
        assert faint.dissipation_per_length[-1] == pytest.approx(alone.dissipation_per_length[-1], rel=1e-6)


def test_beside_a_bulk_stress_slip_is_counted_from_what_sticks():
    path = wk.LinePath(1e5, [0.0, 2e4, MU * 1e5], bulk_stress=5e7)
    stuck, slid = (sheared(wk.Paraboloid(10e-3), path).at(index) for index in (1, 2))
    assert float(stuck.slip(stuck.stick_middle)) == 0.0
    last = 5e7 * (1.0 - 0.3**2) / 210e9 * 10e-3 / MU  # e of Nowell and Hills, strain R / mu
    assert float(slid.slip(last)) == pytest.approx(0.0, abs=1e-15)
    assert float(slid.slip(0.0)) > 1e-12


def test_no_contact_has_no_traction_and_no_stresses():
    state = sheared(wk.Paraboloid(10e-3), wk.LinePath([1e5, 0.0], 0.0)).at(-1)
    assert state.traction([0.0]) == 0.0
    assert state.pressure([0.0]) == 0.0
    assert state.stick_half_width == 0.0
    with pytest.raises(wk.OutsideValidity, match="do not touch"):
        state.stresses(0.0, 1e-5)
    with pytest.raises(wk.InvalidInput, match="both bodies"):
        state.stresses(0.0, [1e-5, -1e-5])


@pytest.mark.parametrize(("strength", "standing"), [(2e9, "EXACT"), (370e6, "APPROXIMATE"), (300e6, "OUTSIDE")])
def test_yield_is_bounded_from_both_sides(strength, standing):
    """Without friction 0.558 p0 = 338 MPa; were all to slide, more at the surface."""
    medium = wk.HalfSpace.between(wk.Elastic(210e9, 0.3, strength), STEEL)
    notes = sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, [0.0, 3e4]), medium).validity
    (note,) = [note for note in notes if note.assumption is wk.Assumption.ELASTIC]
    assert note.standing is wk.Standing[standing]
