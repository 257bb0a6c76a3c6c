"""Springs that stand for an ellipse: results against mpmath and Mindlin, and refusals of what needs a disc."""

from __future__ import annotations

import dataclasses

import mpmath
import numpy as np
import pytest

import winkler as wk
from winkler.foundation.footprint import EllipticOutline, RoundOutline, UnknownOutline
from winkler.foundation.measured_profile import MeasuredPlaneProfile
from winkler.media.layered.coated import Layer
from winkler.plot import draw

STEEL = wk.Elastic(208e9, 0.3, strength=1.2e9)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
BEARING = wk.EllipticIndentation(wk.CurvedBodies(124e-3, 3.77e-3), PAIR, wk.Force(1500.0))
SLENDER = wk.EllipticFoundation(wk.CurvedBodies(10e-3, 1e-3), PAIR)
GEL = wk.ViscoelasticHalfSpace(wk.Maxwell(1e6, 0.1, 0.45))


def hertz(ratio: float) -> mpmath.mpf:
    """Return m = 1 - b^2/a^2 under curvature radii of this ratio, from Hertz's condition with K and E."""

    def missing(m: mpmath.mpf) -> mpmath.mpf:
        k, e = mpmath.ellipk(m), mpmath.ellipe(m)
        return (e / (1 - m) - k) / (k - e) - ratio

    return mpmath.findroot(missing, (mpmath.mpf("0.3"), mpmath.mpf("0.999")), solver="anderson", tol=1e-25)


def sheared_ratio(m: mpmath.mpf, poisson: float, *, along: bool) -> float:
    """Return c_T/c_N by Cerruti's solution, summed over all directions from the middle of the ellipse."""

    def reach(angle: mpmath.mpf) -> mpmath.mpf:
        c, s = mpmath.cos(angle), mpmath.sin(angle)
        return 1 / mpmath.sqrt(c**2 + s**2 / (1 - m))

    def weighed(angle: mpmath.mpf) -> mpmath.mpf:
        part = mpmath.cos(angle) if along else mpmath.sin(angle)
        return (1 - poisson + poisson * part**2) * reach(angle)

    quarter = [0, mpmath.pi / 4, mpmath.pi / 2]
    return float((1 - poisson) * mpmath.quad(reach, quarter) / mpmath.quad(weighed, quarter))


def test_the_ratio_of_an_ellipse_depends_on_the_direction():
    """Radii of 1:10, nu = 0.3: 0.777 along, 0.876 across; a disc has 0.8235."""
    with mpmath.workdps(30):
        m = hertz(10.0)
        expected = [sheared_ratio(m, 0.3, along=along) for along in (True, False)]
    assert expected == pytest.approx([0.777, 0.876], abs=5e-4)
    one = np.ones(1)
    for bed, ratio in zip((SLENDER, SLENDER.turned), expected, strict=True):
        assert bed.tangential_stiffness(one)[0] / bed.normal_stiffness(one)[0] == pytest.approx(ratio, rel=1e-12)
    assert dataclasses.replace(SLENDER, bodies=wk.CurvedBodies(1e-3, 10e-3)) == SLENDER.turned


def test_compliances_of_dissimilar_bodies_add_up():
    """1/G_s adds up body by body: (1 - nu + nu s) / (2 G) of each."""
    rubber = wk.Elastic(1e9, 0.45)
    mixed = dataclasses.replace(SLENDER, medium=wk.HalfSpace.between(STEEL, rubber))
    with mpmath.workdps(30):
        m = hertz(10.0)
        share = float((mpmath.ellipk(m) - mpmath.ellipe(m)) / (m * mpmath.ellipk(m)))
    compliance = sum((1.0 - body.poisson + body.poisson * share) / (2.0 * body.shear) for body in (STEEL, rubber))
    assert mixed.tangential_stiffness(np.ones(1))[0] == pytest.approx(1.0 / compliance, rel=1e-12)


@pytest.mark.parametrize("along", [True, False])
def test_partial_slip_of_an_ellipse(along):
    """Mindlin, Deresiewicz (Johnson 7.44): the shift is that of full slip times 1 - (1 - Q / mu P)^(2/3)."""
    bed = SLENDER if along else SLENDER.turned
    mu, force = 0.2, 300.0
    with mpmath.workdps(30):
        ratio = sheared_ratio(hertz(10.0), 0.3, along=along)
    depth = wk.Indentation(bed, wk.Force(force)).solve().depth
    parts = np.array([0.2, 0.5, 0.9])
    shift = mu * depth / ratio * (1.0 - (1.0 - parts) ** (2.0 / 3.0))
    path = wk.Path([0.0, 1.0, 2.0, 3.0], wk.Force(force), wk.Shift(np.append(0.0, shift)))
    pushed = wk.Tangential(bed, wk.Coulomb(mu), path).solve()
    assert pushed.shear_force[1:] == pytest.approx(mu * force * parts, rel=1e-9)


@pytest.mark.slow
def test_a_relaxing_ellipse_sticks_with_the_stiffness_of_its_direction():
    """A step of depth and a small shift under stick: the shear force falls as c_T/c_N of the ellipse, times k."""
    bed = wk.EllipticFoundation(wk.CurvedBodies(10e-3, 1e-3), GEL)
    path = wk.Path([0.0, 0.01], wk.Depth(1e-5), wk.Shift([0.0, 1e-9]))
    moved = [wk.Tangential(one, wk.Coulomb(10.0), path).solve().shear_force[-1] for one in (bed, bed.turned)]
    with mpmath.workdps(30):
        along, across = (sheared_ratio(hertz(10.0), 0.45, along=which) for which in (True, False))
    assert moved[0] / moved[1] == pytest.approx(along / across, rel=1e-3)


def test_pressure_and_area_are_those_of_the_ellipse():
    """Steel, 3.77 mm x 124 mm, 1500 N: p0 = 2.62 GPa, where the round body of equal stiffness has 1.49 GPa."""
    ellipse = BEARING.solve()
    springs = wk.Indentation(BEARING.bed, wk.Force(1500.0)).solve()
    assert ellipse.peak_pressure == pytest.approx(2.62e9, rel=1e-3)
    assert springs.depth == pytest.approx(ellipse.depth, rel=1e-12)
    assert springs.stiffness == pytest.approx(ellipse.stiffness, rel=1e-12)
    assert 1.5 * springs.mean_pressure == pytest.approx(ellipse.peak_pressure, rel=1e-12)
    axes = BEARING.bed.footprint.semi_axes(np.array([springs.radius]))
    assert np.ravel(axes) == pytest.approx([ellipse.longitudinal_semi_axis, ellipse.lateral_semi_axis], rel=1e-12)


def test_a_film_counts_by_the_true_area():
    """The film has 1.72 times the resistance that the disc of equal stiffness would give: 146 against 85 microohm."""
    copper = wk.ElectricalConductor(1.7e-8)
    pair = wk.ElectricalConductors(copper, copper, wk.SurfaceFilm(1.25e-10))
    found = wk.Constriction(wk.Indentation(BEARING.bed, wk.Force(1500.0)), pair).solve()
    with mpmath.workdps(30):
        m = hertz(124 / 3.77)
        k, e = mpmath.ellipk(m), mpmath.ellipe(m)
        a = (3 * 1500 * (k - e) / (2 * mpmath.pi * PAIR.modulus * m) * 2 * mpmath.mpf("0.124")) ** (mpmath.mpf(1) / 3)
        film = 1.25e-10 / (mpmath.pi * a**2 * mpmath.sqrt(1 - m))
    assert found.film_resistance == pytest.approx(float(film), rel=1e-10)
    assert found.film_resistance == pytest.approx(146e-6, rel=0.01)
    disc = wk.Constriction(
        wk.Indentation(wk.Foundation(wk.Paraboloid(BEARING.equivalent_radius), PAIR), wk.Force(1500.0)), pair
    )
    assert disc.solve().film_resistance == pytest.approx(85e-6, rel=0.03)
    plated = wk.ElectricalConductors(copper, wk.Plated(copper, 1e-6, on=copper))
    with pytest.raises(wk.OutsideValidity, match="a plating needs a round contact"):
        wk.Constriction(wk.Indentation(BEARING.bed, wk.Force(1500.0)), plated).solve()


def test_what_needs_a_disc_is_refused():
    bed = BEARING.bed
    contact = wk.Indentation(bed, wk.Force(1500.0)).solve()
    pushed = wk.Tangential(bed, wk.Coulomb(0.2), wk.Path([0.0, 1.0], wk.Force(10.0), wk.Shift([0.0, 1e-8]))).solve()
    heat = wk.ThermalConductor(45.0, 12e-6)
    path = wk.Path([0.0, 1.0], wk.Force(10.0), wk.Shift([0.0, 1e-8]))
    for requested in (
        lambda: wk.PullOff(bed, wk.ShortRange(0.1)),
        lambda: wk.AdhesiveIndentation(bed, wk.ShortRange(0.1), wk.Force(0.0)),
        lambda: wk.SlidingWear(bed, wk.Archard(1e-14), wk.Force(10.0), 10.0),
        lambda: wk.FrictionHeating(contact.problem, wk.Coulomb(0.1), wk.HeatConductors(heat, heat), 1.0),
        lambda: wk.FrettingHeat(wk.Tangential(bed, wk.Coulomb(0.1), path), 10.0, wk.HeatConductors(heat, heat)),
        lambda: wk.restore(contact, 0.0),
        lambda: wk.restore(contact, 0.0, 1e-4),
        lambda: wk.restore_body(contact, 0.0, 0.0, 1e-4),
        lambda: wk.restore(pushed.at(-1), 0.0),
        lambda: wk.restore_body(pushed.at(-1), 0.0, 0.0, 1e-4),
        lambda: wk.restore_shift(pushed.at(-1), 0.0, 0.0),
        lambda: wk.peak_stress(contact),
        lambda: wk.peak_stress(pushed.at(-1)),
        lambda: wk.staircase(contact, 5),
    ):
        with pytest.raises(wk.OutsideValidity, match="needs a round contact, .*b/a = 0.1066.*use EllipticIndent"):
            requested()


def test_what_needs_force_and_depth_alone_is_solved():
    """Impact takes Hertz's time with F = c d^(3/2) of the ellipse; a solid that relaxes bears its part of F."""
    bed = BEARING.bed
    with mpmath.workdps(30):
        m = hertz(124 / 3.77)
        k, e = mpmath.ellipk(m), mpmath.ellipe(m)
        a = (3 * (k - e) / (2 * mpmath.pi * PAIR.modulus * m) * 2 * mpmath.mpf("0.124")) ** (mpmath.mpf(1) / 3)
        stiff = float((3 * k / (2 * mpmath.pi * PAIR.modulus * a)) ** (-1.5))
        part = mpmath.sqrt(mpmath.pi) * mpmath.gamma(1.4) / mpmath.gamma(0.9)
    time = 2.0 * float(part) * (1.25 * 0.05 / stiff) ** 0.4 * 0.1**-0.2
    assert wk.Impact(bed, wk.Coulomb(0.0), mass=0.05, velocity=0.1).solve().duration == pytest.approx(time, rel=1e-6)
    soft = wk.ViscoelasticIndentation(bed.with_medium(GEL), wk.Path([0.0, 0.1], wk.Depth([1e-5, 1e-5])))
    relaxed = 2.0 * 1e6 / (1.0 - 0.45) * np.exp(-1.0)
    assert soft.solve().force[-1] == pytest.approx(stiff / PAIR.modulus * relaxed * 1e-5**1.5, rel=1e-4)
    with pytest.raises(wk.OutsideValidity, match="the pressure needs a round contact"):
        list(soft.steps())[-1].pressure(0.0)


def test_beds_know_their_footprint():
    ball = wk.Foundation(wk.Paraboloid(1e-2), PAIR)
    a = np.geomspace(1e-6, 1e-4, 7)
    measured = wk.MeasuredBed(a, a, a**2)
    assert isinstance(ball.footprint, RoundOutline)
    assert isinstance(SLENDER.footprint, EllipticOutline)
    assert isinstance(measured.footprint, UnknownOutline)
    assert isinstance(dataclasses.replace(measured, disc=True).footprint, RoundOutline)
    equal = wk.EllipticFoundation(wk.CurvedBodies(1e-2, 1e-2), PAIR)
    assert isinstance(equal.footprint, RoundOutline)  # a ball: all is known of it
    assert wk.restore(wk.Indentation(equal, wk.Force(10.0)).solve(), 0.0).pressure == pytest.approx(
        wk.restore(wk.Indentation(ball, wk.Force(10.0)).solve(), 0.0).pressure, rel=1e-12
    )


def test_yield_begins_under_the_ellipse_not_under_the_ball():
    """Steel, 3.77 mm x 124 mm: 766 N, where the ball gives 3261 N; 1502 MPa at 0.123 mm (a flat maximum) at 1500 N."""
    onset = wk.YieldOnset(BEARING.bed).solve()
    assert onset.force == pytest.approx(766.0, rel=3e-3)
    grown = (1500.0 / onset.force) ** (1.0 / 3.0)
    assert 1.2e9 * grown == pytest.approx(1502e6, rel=1e-3)
    assert onset.z * grown == pytest.approx(0.123e-3, rel=1e-2)
    yields = wk.Indentation(BEARING.bed, wk.Force(1500.0)).solve().validity
    note = next(note for note in yields if note.assumption is wk.Assumption.ELASTIC)
    assert note.standing is wk.Standing.OUTSIDE
    assert f"yielding began at {onset.force:.4g} N" in note.statement
    below = wk.Tangential(BEARING.bed, wk.Coulomb(0.3), wk.Path([0.0, 1.0], wk.Force(500.0), wk.Shift([0.0, 1e-7])))
    note = next(note for note in below.solve().validity if note.assumption is wk.Assumption.ELASTIC)
    assert note.standing is wk.Standing.EXACT
    assert "would if all of it slid with the coefficient 0.3" in note.statement
    assert "Sackfield" in note.source
    a = np.geomspace(1e-6, 1e-3, 12)
    spots = MeasuredPlaneProfile(wk.MeasuredBed(a, 2.0 * PAIR.modulus * a, a**2 / 1e-2))
    with pytest.raises(wk.OutsideValidity, match="the stress below the surface needs a round contact"):
        wk.YieldOnset(wk.PlaneFoundation(spots, PAIR)).solve()


def test_a_path_in_the_plane_is_refused():
    path = wk.Path([0.0, 1.0], wk.Force(10.0), wk.Shift([[0.0, 0.0], [1e-8, 1e-8]]))
    with pytest.raises(wk.OutsideValidity, match="the path leaves its line, and an ellipse yields differently"):
        wk.Tangential(SLENDER, wk.Coulomb(0.2), path)


def test_media_that_know_no_ellipse_are_refused():
    coated = wk.CoatedHalfSpace([Layer(STEEL, 1e-6)], on=STEEL)
    with pytest.raises(wk.InvalidInput, match="homogeneous half-spaces only"):
        wk.EllipticFoundation(wk.CurvedBodies(1e-2, 1e-3), coated)
    with pytest.raises(wk.InvalidInput, match="bodies is a float"):
        wk.EllipticFoundation(1.0, PAIR)
    with pytest.raises(wk.InvalidInput, match="the contact is a line"):
        wk.EllipticFoundation(wk.CurvedBodies(1e20, 1e-3), PAIR)
    zinc = wk.TransverselyIsotropic(162e9, 92e9, 69e9, 181e9, 47e9)
    crystal = wk.EllipticFoundation(wk.CurvedBodies(1e-2, 1e-3), wk.TransverselyIsotropicHalfSpace(zinc))
    with pytest.raises(wk.OutsideValidity, match="along an ellipse is not implemented"):
        crystal.tangential_stiffness(np.ones(1))


def test_the_direction_of_a_stiffness_is_stated():
    """On an ellipse the direction, on an unknown outline that the ratio is a mean."""
    a = np.geomspace(1e-6, 1e-3, 12)
    spots = wk.MeasuredBed(a, 2.0 * PAIR.modulus * a, a**2 / 1e-2, mindlin_ratio=0.8)
    path = wk.Path([0.0, 1.0], wk.Force(1.0), wk.Shift([0.0, 1e-9]))
    for bed, text in (
        (SLENDER, "The shear force acts along x; the semi-axis along x is 4.5 times"),
        (spots, "ratio of tangential to normal stiffness is that of a disc. The outline of the contact is not known"),
    ):
        notes = wk.Tangential(bed, wk.Coulomb(0.3), path).solve().validity
        assert any(text in note.statement for note in notes)
        swing = wk.FrictionDamping(bed, wk.Coulomb(0.3), wk.Force(1.0), wk.Shift(1e-9)).solve()
        assert any(text in note.statement for note in swing.validity)
        assert not any(text in note.statement for note in wk.Indentation(bed, wk.Force(1.0)).solve().validity)


def test_pictures_show_springs_and_no_ball():
    """Of bed, contact and sheared contact what springs give is drawn: no body, no pressure, no traction."""
    path = wk.Path([0.0, 1.0], wk.Force(1.0), wk.Shift([0.0, 1e-9]))
    pushed = wk.Tangential(SLENDER, wk.Coulomb(0.3), path).solve()
    for item, titles in (
        (wk.Indentation(SLENDER, wk.Force(1.0)).solve(), ["stiffness", "springs", "load of the springs", "force over"]),
        (pushed.at(-1), ["springs"]),
    ):
        shown = [axes.get_title(loc="left") for axes in draw(item).axes]
        assert all(found.startswith(title) for found, title in zip(shown, titles, strict=True))
    assert draw(SLENDER).axes[0].get_title(loc="left") == "stiffness"
    assert draw(pushed).axes
