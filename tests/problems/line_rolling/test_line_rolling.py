"""Steady rolling of a cylinder against Carter's closed forms at 30 digits, line loads summed, and CONTACT."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

import winkler as wk

STEEL = wk.Elastic(210e9, 0.3)
BED = wk.LineFoundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(STEEL, STEEL))
MU, LOAD = wk.Coulomb(0.3), wk.LineForce(100e3)
MOST = 0.3 * 100e3
MODULUS = mp.mpf(210e9) / (2 * (1 - mp.mpf(0.3) ** 2))
RATIOS = np.array([0.0, 1e-9, 0.1, 0.64, 0.999999, 1.0])


def half_width():
    return mp.sqrt(4 * mp.mpf(100e3) * mp.mpf(10e-3) / (mp.pi * MODULUS))


def pulled(ratio):
    return wk.LineRolling(BED, MU, wk.LineShearForce(ratio * MOST), LOAD).solve()


def test_a_force_makes_the_creepage_of_carter():
    with mp.workdps(30):
        shares = [mp.sqrt(1 - abs(mp.mpf(ratio))) for ratio in RATIOS]
        creepages = [float(mp.mpf(0.3) * half_width() * (1 - share) / mp.mpf(10e-3)) for share in shares]
    found = pulled(RATIOS)
    np.testing.assert_allclose(found.longitudinal_creepage, creepages, rtol=1e-11)
    np.testing.assert_allclose(found.stick_share, [float(share) for share in shares], rtol=1e-10, atol=1e-15)
    np.testing.assert_allclose(found.traction_ratio, RATIOS, rtol=1e-13)
    back = wk.LineRolling(BED, MU, wk.Creepage(found.longitudinal_creepage), LOAD).solve()
    np.testing.assert_allclose(back.shear_force_per_length, RATIOS * MOST, rtol=1e-12)
    np.testing.assert_allclose(back.stick_share, found.stick_share, atol=1e-12)
    against = pulled(-RATIOS)
    np.testing.assert_array_equal(against.longitudinal_creepage, -found.longitudinal_creepage)
    np.testing.assert_array_equal(against.loss_per_area, found.loss_per_area)


def test_it_slides_from_the_creepage_on_that_carter_gives():
    limit = float(pulled(1.0).longitudinal_creepage)
    beyond = wk.LineRolling(BED, MU, wk.Creepage([0.999 * limit, 1.001 * limit, -2.0 * limit]), LOAD).solve()
    np.testing.assert_allclose(beyond.shear_force_per_length[1:], [MOST, -MOST], rtol=1e-14)
    assert 0.0 < beyond.stick_share[0] < 1e-2
    assert not beyond.stick_share[1:].any()
    slid = wk.LineRolling(BED, MU, wk.Creepage(-2.0 * limit), LOAD).solve()
    a = float(slid.contact.half_width)
    np.testing.assert_allclose(
        slid.slip(np.array([-1.0, 0.0, 1.0]) * a), -limit * np.array([3.0, 2.0, 1.0]), rtol=1e-12
    )
    np.testing.assert_array_equal(slid.slip(np.array([-1.1, 1.1]) * a), 0.0)


@pytest.mark.parametrize("ratio", [0.2, 0.64, -0.95])
def test_traction_and_slip_are_those_of_carter_and_lose_what_the_creepage_does(ratio):
    one = pulled(ratio)
    a, c = float(half_width()), float(one.stick_share * half_width())
    peak = 0.3 * 2.0 * 100e3 / (np.pi * a)
    x = a * np.array([-1.2, -0.9, -0.3, 0.1, 0.5, 0.8, 0.99, 1.1])
    whole = np.sqrt(np.maximum(1.0 - (x / a) ** 2, 0.0))
    inner = np.sqrt(np.maximum(1.0 - ((x - a + c) / c) ** 2, 0.0))
    np.testing.assert_allclose(one.traction(x), np.sign(ratio) * peak * (whole - c / a * inner), atol=1e-12 * peak)
    sticks = (x > a - 2 * c) & (x < a)
    assert not one.slip(x[sticks]).any()
    node, weight = np.polynomial.legendre.leggauss(60)
    angle = 0.5 * np.pi * (node + 1.0)  # the slip zone, from -a to a - 2 c, with the root at each of its ends
    slips = -a + (a - c) * (1.0 - np.cos(angle))
    lost = 0.5 * np.pi * weight @ (one.traction(slips) * one.slip(slips) * (a - c) * np.sin(angle))
    assert lost == pytest.approx(one.loss_per_area, rel=1e-9)
    assert one.power(-20.0) == pytest.approx(20.0 * lost, rel=1e-9)


def test_the_creepage_strains_the_surface_where_it_sticks():
    """2/(pi E*) times the principal value of q/(x - s), by the rule that is exact for roots times polynomials."""
    one = pulled(0.64)
    a, c = float(one.contact.half_width), float(one.contact.half_width * one.stick_share)
    n = 400
    places = np.cos(np.pi * np.arange(1, n + 1) / (n + 1))
    weight = np.pi / (n + 1) * np.sin(np.pi * np.arange(1, n + 1) / (n + 1)) ** 2
    targets = np.cos(np.pi * (2 * np.arange(1, n + 2) - 1) / (2 * n + 2))

    def strain(middle, width, level):
        return level * np.sum(weight / (targets[:, None] - places), axis=1), middle + width * targets

    peak = 0.3 * float(one.contact.peak_pressure)
    outer, x = strain(0.0, a, peak)
    inside = (x > a - 2 * c) & (x < a)
    inner = np.interp(x[inside], *(part[::-1] for part in strain(a - c, c, peak * c / a)[::-1]))
    gradient = 2.0 / (np.pi * float(MODULUS)) * (outer[inside] - inner)
    np.testing.assert_allclose(gradient, one.longitudinal_creepage, rtol=1e-9)


def flamant(places, forces, x, z):
    """Stresses of line loads pressed and along x (Johnson 2.23, 2.30), compression of the body negative."""
    dx = x - places
    fourth = (dx**2 + z**2) ** 2
    pressed, dragged = forces
    along = -2.0 / np.pi * np.sum((pressed * dx**2 * z + dragged * dx**3) / fourth)
    across = -2.0 / np.pi * np.sum((pressed * z**3 + dragged * dx * z**2) / fourth)
    shear = -2.0 / np.pi * np.sum((pressed * dx * z**2 + dragged * dx**2 * z) / fourth)
    return along, across, shear


@pytest.mark.parametrize("below", [True, False])
def test_stresses_are_those_of_line_loads(below):
    one = pulled(0.64)
    a, c = float(one.contact.half_width), float(one.contact.half_width * one.stick_share)
    node, weight = np.polynomial.legendre.leggauss(200)
    places, loads = [], []
    for low, high in ((-a, a - 2 * c), (a - 2 * c, a)):
        angle = 0.5 * np.pi * (node + 1.0)
        s = 0.5 * (low + high) - 0.5 * (high - low) * np.cos(angle)
        w = 0.25 * np.pi * (high - low) * weight * np.sin(angle)
        places.append(s)
        loads.append(np.array([one.contact.pressure(s), (1.0 if below else -1.0) * one.traction(s)]) * w)
    places, loads = np.concatenate(places), np.concatenate(loads, axis=1)
    for x, z in a * np.array([[-0.7, 0.3], [0.2, 0.2], [0.9, 0.5], [1.4, 1.0]]):
        fields = one.stresses(x, z if below else -z)
        found = [fields.xx_stress, fields.zz_stress, fields.xz_stress]
        np.testing.assert_allclose(
            found, flamant(places, loads, x, z), rtol=1e-8, atol=1e-9 * one.contact.peak_pressure
        )


def test_a_locomotive_wheel_agrees_with_contact(shared_data):
    """carter_line of CONTACT: 1.3 % too much force, first order in the element; slips are those within an element."""
    steel = wk.Elastic(2.0 * 1.28 * 82e9, 0.28)
    bed = wk.LineFoundation(wk.Paraboloid(0.5), wk.HalfSpace.between(steel, steel))
    wheel = wk.LineRolling(bed, MU, wk.Creepage(2.4e-4), wk.LineForce(178.9e3)).solve()
    assert wheel.traction_ratio == pytest.approx(0.6399949669714525, rel=1e-12)
    assert wheel.stick_share * wheel.contact.half_width == pytest.approx(0.0006000104855494379, rel=1e-12)
    assert wheel.traction_ratio == pytest.approx(0.648, rel=0.014)
    assert wheel.power(30.0) * 0.2 == pytest.approx(47.62, rel=0.05)
    file = shared_data / "reference" / "contact" / "carter_line_tractions.csv"
    rows = np.genfromtxt(file, delimiter=",", names=True, skip_header=1)
    x = rows["x_m"]
    edges = (np.abs(x) < 0.93e-3) & (np.abs(x + 0.2e-3) > 0.05e-3)  # but at the roots
    np.testing.assert_allclose(rows["traction_Pa"][edges], wheel.traction(x[edges]), atol=0.013 * 0.3 * 1.139e8)
    np.testing.assert_allclose(rows["slip"], wheel.slip(x), atol=4e-5)


def test_yielding_counts_the_traction():
    """At the surface of a sliding cylinder von Mises reaches 2 mu p0 (1 - ...): more than without a force."""
    strong = wk.Elastic(210e9, 0.3, strength=350e6)
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(strong, STEEL))

    def standing(ratio):
        solved = wk.LineRolling(bed, wk.Coulomb(0.4), wk.LineShearForce(ratio * 40e3), LOAD).solve()
        return next(note for note in solved.validity if note.assumption is wk.Assumption.ELASTIC).standing

    assert standing(0.0) is wk.Standing.EXACT  # 0.5575 p0 = 338 MPa
    assert standing(1.0) is wk.Standing.OUTSIDE
    assert standing(-1.0) is wk.Standing.OUTSIDE


@pytest.mark.parametrize(
    ("drive", "bed", "load", "error", "sentence"),
    [
        (
            wk.LineShearForce(1.01 * MOST),
            BED,
            LOAD,
            wk.OutsideValidity,
            "the friction limit is 30000 N/m, less than the given 30300",
        ),
        (wk.Creepage(1e-3, lateral=1e-3), BED, LOAD, wk.OutsideValidity, "has a lateral part or a spin"),
        (wk.Creepage(1e-3), BED, wk.LineForce(0.0), wk.OutsideValidity, "the bodies do not touch"),
        (wk.Creepage(1e-3), BED, wk.LineForce([1.0, 2.0]), wk.InvalidInput, "with one number"),
        (
            wk.Creepage(1e-3),
            wk.LineFoundation(wk.Cone(1.4), BED.medium),
            LOAD,
            wk.InvalidInput,
            "only a round body keeps its profile",
        ),
    ],
)
def test_what_has_no_answer_is_refused(drive, bed, load, error, sentence):
    with pytest.raises(error, match=sentence):
        wk.LineRolling(bed, MU, drive, load).solve()


def test_a_force_of_sliding_may_be_rounded_up():
    slides = wk.LineRolling(BED, MU, wk.LineShearForce(-MOST * (1.0 + 1e-14)), LOAD).solve()
    assert slides.stick_share == 0.0
    assert slides.longitudinal_creepage == pytest.approx(-float(mp.mpf(0.3) * half_width() / mp.mpf(10e-3)), rel=1e-12)


def test_one_drive_at_a_time_has_tractions():
    many = pulled(np.array([0.1, 0.2]))
    with pytest.raises(wk.InvalidInput, match="solve for one of them"):
        many.traction(0.0)
    with pytest.raises(wk.InvalidInput, match="in both bodies"):
        pulled(0.1).stresses(0.0, np.array([1e-6, -1e-6]))
