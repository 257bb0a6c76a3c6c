"""Dissimilar cylinders that roll, pressure and traction coupled: CONTACT, limits, and the integral equations."""

from __future__ import annotations

import tomllib

import numpy as np
import pytest
from scipy.optimize import brentq

import winkler as wk
from winkler.problems.line_rolling.rolled_strip import creepage_error, rolled_strip

FORCE = 16201.9
ALUMINIUM = wk.Elastic(young=2.0 * 1.31 * 23e9, poisson=0.31)
STEEL = wk.Elastic(young=2.0 * 1.28 * 82e9, poisson=0.28)


def rolled(mu, drive=None, pair=(ALUMINIUM, STEEL), coupled=True):
    bed = wk.LineFoundation(wk.Paraboloid(25e-3), wk.HalfSpace.between(*pair))
    drive = wk.LineShearForce(0.0) if drive is None else drive
    return wk.LineRolling(bed, wk.Coulomb(mu), drive, wk.LineForce(FORCE), coupled=coupled).solve()


@pytest.mark.parametrize(("number", "creep", "lost"), [(2, 1.5e-3, 2e-3), (4, 3e-4, 3e-3)])
def test_free_rolling_is_that_of_contact(shared_data, number, creep, lost):
    """Creepage, greatest pressure, loss and the zones, of which CONTACT has 200 elements."""
    table = tomllib.loads((shared_data / "reference" / "contact" / "bentall_line.toml").read_text(encoding="utf-8"))
    case = next(case for case in table["case"] if case["case"] == number)
    found = rolled(case["friction"])
    assert found.longitudinal_creepage == pytest.approx(case["creep_x"], rel=creep)
    assert found.loss_per_area == pytest.approx(-case["friction_power_W"], rel=lost)
    assert np.max(found.pressure(np.linspace(-1e-4, 1e-4, 801))) == pytest.approx(case["peak_pressure_Pa"], rel=1e-3)
    if number == 4:
        (strip,) = found.strips
        sticks = strip.slips[::-1] == 0.0
        ends = np.flatnonzero(np.diff(sticks)) + 1
        places = np.concatenate([strip.x[-1:], strip.x[::-1][ends], strip.x[:1]])
        lengths = -np.diff(places) / (strip.x[-1] - strip.x[0])
        stated = case["runs_from_leading_edge"]
        elements = sum(theirs for _, theirs in stated)
        names = ["stick" if sticks[place] else "slip" for place in (0, *ends)]
        assert names == [name for name, _ in stated]
        assert all(abs(elements * ours - theirs) <= 2.0 for ours, (_, theirs) in zip(lengths, stated, strict=True))


def coupled_strip(beta, friction, slope, **drive):
    """Of half-planes with this constant: one of them is rigid."""
    soft = wk.Elastic(1.0, (0.5 - abs(beta)) / (1.0 - abs(beta)))
    pair = (soft, wk.Rigid()) if beta > 0.0 else (wk.Rigid(), soft)
    bed = wk.LineFoundation(wk.Paraboloid(1.0 / slope), wk.HalfSpace(*pair))
    return rolled_strip(bed, 1.0, friction, **drive)


def stuck(beta, slope):
    """Creepage and half-width over a of similar bodies where all sticks, by the index of the complex equation."""
    eta = np.arctanh(beta) / np.pi
    half = 1.0 / np.sqrt(1.0 + 4.0 * eta**2)
    return 2.0 * eta * half * slope, half


def test_rollers_that_stick_creep_as_in_closed_form():
    """xi = 2 eta a / R of the Bentall roller, which came out as 3.6274e-4 with a friction of 10."""
    assert rolled(10.0).longitudinal_creepage == pytest.approx(3.6727e-4, rel=5e-5)


@pytest.mark.few(2)
@pytest.mark.parametrize("seed", range(8))
def test_the_creepage_of_random_strips_that_stick_is_within_the_stated_error(seed):
    """Slip zones at the edges reach as far as p and q turn there: they change it by less than 4e-4."""
    rng = np.random.default_rng(seed)
    beta, slope = rng.uniform(-0.5, 0.5), 10.0 ** rng.uniform(-5.0, -1.0)
    friction = 20.0 * 10.0 ** rng.uniform(0.0, 2.0)
    strip = coupled_strip(beta, friction, slope, force=0.0)
    creepage, half = stuck(beta, slope)
    assert strip.creepage == pytest.approx(creepage, rel=creepage_error(strip))
    assert 0.5 * (strip.x[-1] - strip.x[0]) == pytest.approx(half, rel=2e-4)


def test_strongly_coupled_rollers_with_much_friction_are_found():
    """Dundurs' constant .5, friction 5: the slip zones of 8e-4 of the half-width are few elements."""
    strip = coupled_strip(0.5, 5.0, 0.01, force=0.0)
    assert strip.creepage == pytest.approx(stuck(0.5, 0.01)[0], rel=3e-4)


@pytest.mark.slow
def test_the_stated_error_of_random_strips_holds_against_finer_elements():
    """Of twelve with all coefficients of friction and all forces none misses it."""
    rng = np.random.default_rng(37)
    for _ in range(12):
        beta, friction = rng.uniform(-0.5, 0.5), 10.0 ** rng.uniform(-3.0, 0.7)
        force = rng.choice([0.0, rng.uniform(-1.0, 1.0)]) * friction * 0.25 * np.pi * 0.01
        strip, finer = (coupled_strip(beta, friction, 0.01, force=force, count=count) for count in (400, 800))
        off = abs(strip.creepage - finer.creepage) * 4.0 / 3.0  # of the second order
        assert off <= creepage_error(strip) * max(abs(finer.creepage), stuck(abs(beta), 0.01)[0]), (
            beta,
            friction,
            force,
        )


def test_bodies_in_the_other_order_creep_the_other_way():
    one, other = rolled(0.05), rolled(0.05, pair=(STEEL, ALUMINIUM))
    assert other.longitudinal_creepage == pytest.approx(-one.longitudinal_creepage, rel=1e-6)


def test_with_hardly_any_friction_half_of_the_load_slips_to_either_side():
    """Where the pressure is above that at +-sin(t), which bears half of the load: xi = beta a/R cos(t)."""
    angle = brentq(lambda t: t + np.sin(t) * np.cos(t) - 0.25 * np.pi, 0.0, 1.5)
    strip = coupled_strip(0.3, 1e-3, 0.01, force=0.0)
    assert strip.creepage == pytest.approx(0.3 * 0.01 * np.cos(angle), rel=2e-3)  # friction alone leaves 1.5e-3


@pytest.mark.parametrize("used", [0.05, 0.6])
def test_almost_similar_bodies_are_carters(used):
    """What is lost is the creepage times the force."""
    force, creepage = used * 0.3 * 0.25 * np.pi * 0.01, 0.3 * 0.01 * (1.0 - np.sqrt(1.0 - used))
    strip = coupled_strip(1e-9, 0.3, 0.01, force=force)
    assert strip.creepage == pytest.approx(creepage, rel=creepage_error(strip))
    assert strip.loss == pytest.approx(creepage * force, rel=3e-4)


@pytest.mark.parametrize("used", [0.3, -0.6])
def test_what_coupled_bodies_lose_is_what_drives_them(used):
    """The creepage times the force, and the moment of the pressure: by both integral equations."""
    strip = coupled_strip(0.3, 0.3, 0.01, force=used * 0.3 * 0.25 * np.pi * 0.01)
    moment = np.trapezoid(strip.pressure * strip.x, strip.x)
    assert strip.loss == pytest.approx(strip.creepage * strip.force + 0.01 * moment, rel=1e-4)


@pytest.mark.parametrize(("mu", "drive"), [(0.05, wk.LineShearForce(0.0)), (0.3, wk.LineShearForce([2000.0, -900.0]))])
def test_the_stated_error_of_the_loss_holds_against_what_drives_the_rollers(mu, drive):
    """The moment of the pressure and the creepage times the force, by both integral equations."""
    found = rolled(mu, drive)
    modulus, a = found.problem.bed.medium.modulus, float(found.contact.half_width)
    turned = [modulus * a * a / 25e-3 * np.trapezoid(strip.pressure * strip.x, strip.x) for strip in found.strips]
    driven = np.asarray(found.longitudinal_creepage) * np.asarray(found.shear_force_per_length) + turned
    assert np.shape(found.loss_error) == np.shape(found.loss_per_area)
    assert np.all(np.abs(np.asarray(found.loss_per_area) - driven) <= found.loss_error)
    assert np.all(np.asarray(found.loss_error) < 0.02 * np.asarray(found.loss_per_area))
    assert any("The error of the dissipated energy is at most" in note.statement for note in found.validity)
    assert any("too small to be resolved by these elements" in note.statement for note in rolled(0.3).validity)
    assert rolled(mu, drive, coupled=False).loss_error == pytest.approx(0.0, abs=0.0)


def test_similar_bodies_are_not_coupled():
    similar = rolled(0.3, wk.LineShearForce(1000.0), pair=(STEEL, STEEL))
    assert similar.strips == ()
    assert similar.stick_share == rolled(0.3, wk.LineShearForce(1000.0), (STEEL, STEEL), coupled=False).stick_share


def test_pressure_and_traction_satisfy_the_integral_equations():
    """Halfway between nodes, with logarithms of straight pieces: both slopes, of a strongly coupled pair."""
    beta, mu, slope = 0.4, 0.3, 0.01
    strip = coupled_strip(beta, mu, slope, force=0.3 * mu * 0.25 * np.pi * slope)
    nodes, h = strip.x, np.diff(strip.x)
    x = 0.5 * (strip.x[1:] + strip.x[:-1])

    def transform(row):
        """Integral of row(s)/(x - s)."""
        steep = np.diff(row) / h
        far = np.log(np.abs((x[:, None] - nodes[:-1]) / (x[:, None] - nodes[1:])))
        at = row[:-1] + steep * (x[:, None] - nodes[:-1])
        return np.sum(at * far - steep * h, axis=1)

    mean = [0.5 * (row[1:] + row[:-1]) for row in (strip.pressure, strip.traction)]
    gap = 2.0 / np.pi * transform(strip.pressure) - 2.0 * beta * mean[1] - slope * x
    slip = strip.creepage - 2.0 / np.pi * transform(strip.traction) - 2.0 * beta * mean[0]
    inner = slice(1, None)  # the element at the trailing edge has no condition of its own
    assert np.sqrt(np.mean(gap[inner] ** 2)) < 1e-9 * slope
    assert np.sqrt(np.mean((slip - strip.slip)[inner] ** 2)) < 1e-9 * mu * slope
    assert np.all(strip.slip * mean[1] >= 0.0)
    assert np.all(np.abs(strip.traction) <= mu * strip.pressure * (1.0 + 1e-9))


@pytest.mark.slow
def test_a_creepage_makes_the_force_that_makes_it():
    pulled = rolled(0.3, wk.LineShearForce(np.array([-1500.0, 2000.0])))
    back = rolled(0.3, wk.Creepage(pulled.longitudinal_creepage))
    np.testing.assert_allclose(back.shear_force_per_length, [-1500.0, 2000.0], rtol=1e-7)
    assert pulled.shear_force_per_length.tolist() == [-1500.0, 2000.0]
    assert rolled(0.2).shear_force_per_length == 0.0
    slid = rolled(0.3, wk.LineShearForce(0.3 * FORCE))
    assert slid.stick_share == 0.0
    assert slid.traction_ratio == pytest.approx(1.0, rel=1e-9)


def test_the_stresses_below_are_those_of_its_pressure_and_traction():
    state = rolled(0.3, wk.LineShearForce(3000.0))
    x = np.linspace(-0.8e-4, 0.8e-4, 9)
    fields = state.stresses(x, 0.0)
    np.testing.assert_allclose(fields.zz_stress, -state.pressure(x), rtol=1e-9)
    np.testing.assert_allclose(fields.xz_stress, -state.traction(x), rtol=1e-9, atol=1.0)
    np.testing.assert_allclose(state.stresses(x, -0.0).xz_stress, state.traction(x), rtol=1e-9, atol=1.0)
    like = rolled(0.3, wk.LineShearForce(3000.0), coupled=False)
    assert state.stresses(0.0, 1e-4).von_mises == pytest.approx(float(like.stresses(0.0, 1e-4).von_mises), rel=0.03)


def test_what_is_assumed_is_stated():
    weak = wk.Elastic(ALUMINIUM.young, 0.31, 10e6)
    notes = rolled(0.05, pair=(weak, STEEL)).validity
    assert any("are coupled in both directions" in note.statement for note in notes)
    assert any(note.assumption is wk.Assumption.ELASTIC and note.standing is wk.Standing.OUTSIDE for note in notes)


WOOD = wk.TransverselyIsotropic(11e9, 4e9, 4e9, 20e9, 3e9)


def test_anisotropic_rollers_that_stick_creep_as_in_closed_form():
    """With t of the compliance along over that across, q over sqrt t obeys the equations of beta / sqrt t."""
    bed = wk.LineFoundation(wk.Paraboloid(25e-3), wk.TransverselyIsotropicHalfSpace(WOOD))
    along = np.sqrt(11e9 / 20e9) ** -1  # sqrt(C33 / C11)
    mean = np.sqrt(11e9 * 20e9)
    total = np.sqrt((mean - 4e9) * (mean + 4e9 + 2 * 3e9) / (20e9 * 3e9))
    beta = (np.sqrt(11e9 / 20e9) - 4e9 / 20e9) / (total * np.sqrt(11e9 / 20e9))
    found = wk.LineRolling(bed, wk.Coulomb(20.0), wk.LineShearForce(0.0), wk.LineForce(1e4), coupled=True).solve()
    creepage, _ = stuck(beta / np.sqrt(along), float(found.contact.half_width) / 25e-3)
    assert found.longitudinal_creepage == pytest.approx(np.sqrt(along) * creepage, rel=3e-4)


def test_anisotropic_bodies_are_moved_along_by_their_own_compliance():
    """Hertz's pressure as a traction strains the surface by mu x/R times the root of C33/C11."""
    bed = wk.LineFoundation(wk.Paraboloid(25e-3), wk.TransverselyIsotropicHalfSpace(WOOD))
    drive = wk.LineShearForce(0.75 * 0.3 * 1e4)
    found = wk.LineRolling(bed, wk.Coulomb(0.3), drive, wk.LineForce(1e4)).solve()
    carter = 0.5 * 0.3 * float(found.contact.half_width) / 25e-3
    assert found.longitudinal_creepage == pytest.approx(np.sqrt(20e9 / 11e9) * carter, rel=1e-12)
    begun = wk.LineRollingStart(bed, wk.Coulomb(0.3), drive, wk.LineForce(1e4), distance=1e-3, points=1, count=40)
    assert begun.steady.longitudinal_creepage == found.longitudinal_creepage


@pytest.mark.slow
@pytest.mark.parametrize(("beta", "friction", "ratio"), [(0.361, 4.24, -1.45), (-0.265, 14.79, 13.53)])
def test_rollers_pulled_against_their_coupling_with_much_friction_are_found(beta, friction, ratio):
    """Up to |Q/P| = 13; the search ran in circles.  One zone of slip, and the loss is what drives them."""
    slope = 0.01
    strip = coupled_strip(beta, friction, slope, force=ratio * 0.25 * np.pi * slope)
    moment = np.trapezoid(strip.pressure * strip.x, strip.x)
    assert np.count_nonzero(np.diff(strip.slips)) == 1
    assert strip.loss == pytest.approx(strip.creepage * strip.force + slope * moment, rel=2e-3)
    assert np.all(np.abs(strip.traction) <= friction * strip.pressure * (1.0 + 1e-9))
