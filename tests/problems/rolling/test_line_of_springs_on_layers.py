"""A line of springs that rolls on layers, gradings, power laws and woven bodies: stick, strips, slip, and refusals."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.special import j0, jv

import winkler as wk
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.problems.rolling import rolled_disc as discs
from winkler.problems.rolling.distances import ON_LAYERS
from winkler.problems.rolling.kalker import rolling_pair
from winkler.problems.rolling.line import SpringLoad, strip_load
from winkler.problems.rolling.rolled_disc import rolled_disc

MU = 0.3
BASE, NU = wk.Elastic(1.0, 0.3), 0.3
FRICTION = wk.Coulomb(MU)
WEAVE = wk.TransverselyIsotropic(10.0, 4.0, 3.0, 6.0, 2.0)
POWER = wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 1.0, 0.4, 0.3))


def coating(contrast, thickness, on=BASE):
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(contrast, NU), thickness)], on)


def plane(modulus, q):
    """Return the matrix of waves in plane strain: d/dz of u_x / i, u_z, sigma_xz / i and sigma_zz."""
    m = modulus / (2.0 * (1.0 + NU))
    rest = 2.0 * m * NU / (1.0 - 2.0 * NU)
    whole = rest + 2.0 * m
    return np.array([
        [0.0, -q, 1.0 / m, 0.0],
        [rest * q / whole, 0.0, 0.0, 1.0 / whole],
        [(whole - rest**2 / whole) * q * q, 0.0, 0.0, -q * rest / whole],
        [0.0, 0.0, q, 0.0],
    ])  # fmt: skip


def compliances(contrast, thickness, q):
    """Return what tractions along a wave and across it displace a layer on the base, by solutions of the equations."""
    still = plane(1.0, q) + q * np.eye(4)
    fading = np.linalg.svd(still @ still)[2][2:].T
    state = expm(-thickness * plane(contrast, q)) @ fading
    along = -(state[:2] @ np.linalg.inv(state[2:]))[0, 0]
    m, below, t = contrast / 2.6, 1.0 / 2.6, np.tanh(q * thickness)
    return along, (m + below * t) / (m * t + below) / (m * q)


def layered_displacements(contrast, thickness, x, y, side):
    """Return xx, xy and yy at places under a unit traction on a square around the origin."""
    node, weight = gauss_legendre(400)
    q, weight = 9.0 / thickness * node, 9.0 / thickness * weight
    along, across = np.array([compliances(contrast, thickness, one) for one in q]).T
    first, second = along - 2.0 * (1.0 - NU**2) / (contrast * q), across - 2.6 / (contrast * q)
    r = np.linspace(0.0, 3.0, 1500)
    even = j0(np.outer(r, q)) @ (weight * q * (first + second)) / (4.0 * np.pi)
    turned = jv(2, np.outer(r, q)) @ (weight * q * (second - first)) / (4.0 * np.pi)
    found, spread = np.zeros((3, *x.shape)), side * (gauss_legendre(4)[0] - 0.5)
    share = gauss_legendre(4)[1]
    for dx, one in zip(spread, share, strict=True):
        for dy, other in zip(spread, share, strict=True):
            a, b = x + dx, y + dy
            far = np.hypot(a, b)
            k, turn = np.interp(far, r, even), np.interp(far, r, turned) / np.maximum(far, 1e-9) ** 2
            cosine, sine = turn * (a * a - b * b), 2.0 * turn * a * b
            found += one * other * side**2 * np.stack([k + cosine, sine, k - cosine])
    corners = [(sx * sy, x + 0.5 * sx * side, y + 0.5 * sy * side) for sx in (1, -1) for sy in (1, -1)]
    one = sum(s * (a * np.arcsinh(b / np.abs(a))) for s, a, b in corners)
    two = sum(s * (b * np.arcsinh(a / np.abs(b))) for s, a, b in corners)
    mixed = -sum(s * np.hypot(a, b) for s, a, b in corners)
    unit = 1.3 / (np.pi * contrast)  # Cerruti: (1 + nu) / (pi E) of (1 - nu) / r + nu x x / r^3
    return found + unit * np.stack([(1.0 - NU) * one + two, NU * mixed, one + (1.0 - NU) * two])


def stuck_forces(displaced, count):
    """Return F_x and F_y over creepage on the unit disc: tractions zero at the leading edge, and k(y) on each row."""
    side = 2.0 / count
    middle = side * (np.arange(count) - 0.5 * (count - 1))
    i, j = np.nonzero(np.hypot(middle[:, None], middle) < 1.0)
    far = np.arange(1 - count, count) * side
    xx, xy, yy = displaced(*np.meshgrid(far, far, indexing="ij"), side)
    pick = np.subtract.outer(i, i) + count - 1, np.subtract.outer(j, j) + count - 1
    matrix = np.block([[xx[pick], xy[pick]], [xy[pick], yy[pick]]])
    leading = np.array([np.max(i[j == row]) for row in range(count)])[j] == i
    rows = np.eye(count)[j]
    free = np.tile(~leading, 2)
    unknown = np.block([[rows, 0.0 * rows], [0.0 * rows, rows]])
    system = np.hstack([matrix[:, free], -unknown])
    forces = []
    for axis in range(2):
        rigid = np.zeros((2, i.size))
        rigid[axis] = -middle[i]
        solved = np.linalg.solve(system, rigid.ravel())[: np.count_nonzero(free)]
        traction = np.zeros(2 * i.size)
        traction[free] = solved
        forces.append(side**2 * traction.reshape(2, -1)[axis].sum())
    return np.abs(forces)


def ratios(one, other):
    """Return the forces of one medium over those of another, from two numbers of pixels."""
    coarse, fine = (stuck_forces(one, count) / stuck_forces(other, count) for count in (16, 32))
    return 2.0 * fine - coarse


def power_displacements(k, x, y, side):
    """Return the same for E = z^k: in each place the closed form (delta even + along r r / r^2) / r^(1 + k)."""
    law = wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 1.0, k, NU))
    push, turn = 2.0 / law.shear_modulus, 0.5 / law.torsional_modulus / (1.0 + k) ** 2
    along = (2.0 * turn - push) * (1.0 + k) / (1.0 - k)
    even = turn - along / (1.0 + k)
    strength = np.cos(0.5 * np.pi * k) / np.pi
    node, weight = gauss_legendre(24)
    found = np.zeros((3, *x.shape))
    for dx, one in zip(side * (node - 0.5), weight, strict=True):
        for dy, other in zip(side * (node - 0.5), weight, strict=True):
            a, b = x + dx, y + dy
            r = np.hypot(a, b)
            part = one * other * side**2 * strength / r ** (1.0 + k)
            found += part * np.stack([even + along * (a / r) ** 2, along * a * b / r**2, even + along * (b / r) ** 2])
    angle = 0.25 * np.pi * node
    own = 8.0 * strength * 0.25 * np.pi * (weight @ (0.5 * side / np.cos(angle)) ** (1.0 - k)) / (1.0 - k)
    here = (np.abs(x) < 1e-9) & (np.abs(y) < 1e-9)
    found[:, here] = np.array([[even + 0.5 * along], [0.0], [even + 0.5 * along]]) * own
    return found


@pytest.mark.slow
@pytest.mark.parametrize(("contrast", "width"), [(c, width) for c in (0.1, 10.0) for width in (0.3, 3.0, 10.0)])
def test_a_disc_sticks_as_by_a_dense_system_of_another_kind(contrast, width):
    """Waves by matrix exponentials, J_0 and J_2 by quadrature, and an unknown displacement of each row."""
    found, plain = (rolled_disc(coating(contrast, thickness), 1.0) for thickness in (1.0 / width, 1e3))
    want = ratios(
        lambda *at: layered_displacements(contrast, 1.0 / width, *at),
        lambda *at: layered_displacements(contrast, 1e3, *at),
    )
    assert want == pytest.approx([found.longitudinal / plain.longitudinal, found.lateral / plain.lateral], rel=6e-3)


@pytest.mark.slow
@pytest.mark.parametrize("k", [0.4, -0.3])
def test_a_disc_on_a_power_law_sticks_as_by_a_dense_system_of_another_kind(k):
    found = rolled_disc(wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 1.0, k, NU)), 1.0)
    plain = rolled_disc(coating(1.0, 1e3), 1.0)
    want = ratios(lambda *at: power_displacements(k, *at), lambda *at: power_displacements(0.0, *at))
    assert want == pytest.approx([found.longitudinal / plain.longitudinal, found.lateral / plain.lateral], rel=6e-3)


@pytest.mark.slow
def test_a_thick_layer_sticks_as_kalker_says_and_a_thin_one_as_its_base():
    thick = rolled_disc(coating(10.0, 1e3), 1.0)
    known = wk.linear_creep_coefficients(1.0, NU)
    pair = rolling_pair(wk.HalfSpace(wk.Elastic(10.0, NU)))
    want = [pair.shear * known.longitudinal, pair.shear * known.lateral]
    assert [thick.longitudinal, thick.lateral] == pytest.approx(want, rel=1e-6)
    base = 0.1 * np.array(want)
    away = []
    for thickness in (0.04, 0.02, 0.01):
        thin = rolled_disc(coating(0.5, thickness), 1.0)
        away.append(1.0 - np.array([thin.longitudinal, thin.lateral]) / base)
    for one, half in itertools.pairwise(away):  # as h ln(1/h), since tractions are singular at the trailing edge
        assert np.all((half / one > 0.5) & (half / one < 0.65))
    assert np.all(away[-1] < 0.07)


@pytest.mark.slow
@pytest.mark.parametrize("thickness", [0.1, 0.02])
def test_a_thin_film_on_a_rigid_base_is_a_bed_of_springs(thickness):
    """G/h under each place: the force over creepage is 8/3 a^3 G/h, but for edges as wide as the film is thick."""
    film = rolled_disc(coating(1.0, thickness, wk.Rigid()), 1.0)
    want = 8.0 / 3.0 / 2.6 / thickness
    for found in (film.longitudinal, film.lateral):
        assert 0.5 * thickness < found / want - 1.0 < 2.0 * thickness


@pytest.mark.slow
@pytest.mark.parametrize("medium", [coating(10.0, 0.1), coating(0.1, 0.1), POWER])
def test_twice_the_pixels_change_less_than_the_error_stated(medium, monkeypatch):
    before = rolled_disc(medium, 1.0)
    monkeypatch.setattr(discs, "PIXELS", 2 * discs.PIXELS)
    after = discs.rolled_disc.__wrapped__(medium, 1.0)
    assert after.longitudinal == pytest.approx(before.longitudinal, rel=before.error)
    assert after.lateral == pytest.approx(before.lateral, rel=before.error)
    assert after.error < before.error < 1e-2


def test_a_power_law_sticks_alike_at_all_scales():
    """Forces over creepage and a^2 grow as a^k, and the depth to which the modulus refers does not matter."""
    one = rolled_disc(POWER, 1.0)
    wide = rolled_disc(POWER, 100.0)
    other = rolled_disc(wk.GradedHalfSpace(wk.PowerLawGraded(1e4**0.4, 1e4, 0.4, 0.3)), 1.0)
    assert wide.longitudinal == pytest.approx(100.0**0.4 * one.longitudinal, rel=1e-6)
    assert [other.longitudinal, other.lateral] == pytest.approx([one.longitudinal, one.lateral], rel=1e-6)


@pytest.mark.parametrize(
    "medium",
    [wk.HalfSpace(BASE), coating(10.0, 1e-3), coating(0.1, 3e-3), POWER, wk.TransverselyIsotropicHalfSpace(WEAVE)],
)
@pytest.mark.parametrize("profile", [wk.Paraboloid(1.0), wk.PowerLaw(2.0, 4.0)])
def test_strips_bear_the_force_together(medium, profile):
    contact = wk.Indentation(wk.Foundation(profile, medium), wk.Radius(0.01)).solve()
    strips = strip_load(contact)
    assert 2.0 * strips.before(np.array([0.01]))[0] == pytest.approx(contact.force, rel=1e-7)
    if not isinstance(medium, wk.HalfSpace):
        return
    x, springs = np.linspace(0.0, 0.0099, 34), SpringLoad(contact)
    size = springs.load(np.zeros(1))[0]
    assert strips.load(x) == pytest.approx(springs.load(x), abs=1e-6 * size)
    assert strips.before(x) == pytest.approx(springs.before(x), abs=1e-7 * contact.force)
    assert strips.slope(x) == pytest.approx(springs.slope(x), abs=1e-4 * size / 0.01)


@pytest.mark.slow
def test_a_force_begins_as_the_disc_and_ends_in_sliding():
    bed = wk.Foundation(wk.Paraboloid(1.0), coating(10.0, 0.01 / 3.0))
    disc = rolled_disc(bed.medium, 0.01)
    creepage = wk.Creepage([1e-9, 10.0, 0.0], [0.0, 0.0, 1e-9])
    rolled = wk.Rolling(bed, FRICTION, creepage, wk.Radius(0.01)).solve()
    assert rolled.longitudinal_force[0] == pytest.approx(disc.longitudinal * 1e-13, rel=1e-4)
    assert rolled.lateral_force[2] == pytest.approx(disc.lateral * 1e-13, rel=1e-4)
    assert rolled.saturation[1] == pytest.approx(1.0, rel=1e-9)
    softer = wk.Foundation(wk.Paraboloid(1.0), coating(10.0, 0.01 / 3.0, wk.Elastic(0.5, NU)))
    other = wk.Rolling(softer, FRICTION, wk.Creepage(1e-9), wk.Radius(0.01)).solve()
    assert other.longitudinal_force < 0.92 * rolled.longitudinal_force[0]
    assert np.min(rolled.loss_per_distance) > 0.0


MEDIA = {
    "hard": lambda a: coating(10.0, a / 3.0),
    "hard and thin": lambda a: coating(10.0, a / 10.0),
    "soft": lambda a: coating(0.1, a / 3.0),
    "thick": lambda a: coating(10.0, a / 0.3),
    "grading": lambda a: wk.DepthGradedHalfSpace(wk.ExponentialGrading(1.0, 10.0, a, NU), tolerance=1e-4),
    "power law": lambda a: wk.GradedHalfSpace(wk.PowerLawGraded(1.0, a, 0.4, 0.3)),
    "woven": lambda a: wk.TransverselyIsotropicHalfSpace(WEAVE),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", MEDIA)
def test_distance_from_boundary_elements(name):
    a, count = 0.01, 32
    bed = wk.Foundation(wk.Paraboloid(1.0), MEDIA[name](a))
    load = wk.Force(float(wk.Indentation(bed, wk.Radius(a)).solve().force))
    unit = 1.5 * MU * load.force / (a * a * np.array(wk.Kalker().stiffness(bed, a)))
    ball = wk.SampledProfile([2.25 * a] * 2, wk.Paraboloid(1.0), (count + 4, count + 4))
    for most, angles in zip(ON_LAYERS, ((0.0, 0.5 * np.pi), (0.25 * np.pi,)), strict=True):
        amount, angle = np.meshgrid([0.3, 0.5, 0.7, 1.2], angles)
        creepage = wk.Creepage(amount * np.cos(angle) * unit[0], amount * np.sin(angle) * unit[1])
        line = wk.Rolling(bed, FRICTION, creepage, load).solve()
        exact = wk.SurfaceRolling(ball, bed.medium, load, FRICTION, creepage).solve()
        off = np.hypot(line.longitudinal_force - exact.longitudinal_force, line.lateral_force - exact.lateral_force)
        assert np.max(off) < most * MU * load.force
        assert 0.4 < np.min(exact.saturation) < 0.9


def test_woven_bodies_roll_as_the_isotropic_pair_that_tractions_move_alike():
    woven = wk.TransverselyIsotropicHalfSpace(WEAVE, WEAVE)
    pair = rolling_pair(woven)
    alike = wk.HalfSpace.between(*[wk.Elastic(2.0 * (1.0 + pair.poisson) * pair.shear, pair.poisson)] * 2)
    assert alike.shear_modulus == pytest.approx(woven.shear_modulus, rel=1e-12)
    stuck = [wk.Kalker().stiffness(wk.Foundation(wk.Paraboloid(1.0), medium), 1.0) for medium in (woven, alike)]
    assert stuck[0] == pytest.approx(stuck[1], rel=1e-12)
    spun, ellipse = wk.Creepage(1e-3, 5e-4, 1.0), wk.ContactEllipse(2e-3, 1e-3)
    forces = [
        (rolled.longitudinal_force, rolled.lateral_force, rolled.moment)
        for medium in (woven, alike)
        for rolled in [wk.SimplifiedRolling(ellipse, medium, FRICTION, spun, wk.Force(1e-6)).solve()]
    ]
    assert forces[0] == pytest.approx(forces[1], rel=1e-12)
    disc = rolled_disc(woven, 1.0)
    assert [0.5 * disc.longitudinal, 0.5 * disc.lateral] == pytest.approx(stuck[0], rel=3e-3)


@pytest.mark.parametrize(("profile", "unknown"), [(wk.Paraboloid(1.0), False), (wk.PowerLaw(2.0, 4.0), True)])
def test_a_body_that_is_no_ball_is_labelled(profile, unknown):
    bed = wk.Foundation(profile, POWER)
    notes = wk.Rolling(bed, FRICTION, wk.Creepage(1e-3), wk.Radius(0.01)).solve().validity
    stated = next(note.statement for note in notes if "at most 0.08 mu F_N" in note.statement)
    assert stated.endswith("This body is not a ball; the error is not known.") == unknown


def test_what_does_not_roll_on_a_line():
    shape, load = wk.Paraboloid(1.0), wk.Radius(0.01)
    slides = wk.StackedHalfSpace([wk.StackLayer(BASE, 0.01, bonded=False)], BASE)
    gibson = wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 1.0, 1.0, 0.5))
    for medium, why in ((slides, "slides on its base"), (gibson, "no tangential stiffness")):
        with pytest.raises(wk.OutsideValidity, match=why):
            wk.Rolling(wk.Foundation(shape, medium), FRICTION, wk.Creepage(1e-3), load)
    bed = wk.Foundation(shape, coating(10.0, 0.01))
    with pytest.raises(wk.InvalidInput, match=r"differ between middle and edge.*leave out Uncalibrated"):
        wk.OscillatingRolling(bed, FRICTION, 1e-3, 0.0, load, wk.Uncalibrated())
