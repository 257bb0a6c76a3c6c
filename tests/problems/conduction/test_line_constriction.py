"""Constriction of current on a strip and on an ellipse: closed forms, and the potential of line sources."""

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import ellipk

import winkler as wk

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
ROLLER = wk.LineFoundation(wk.Paraboloid(10e-3), PAIR)
WIRE, LEAD = wk.ElectricalConductor(0.2e-6), wk.ElectricalConductor(0.3e-6)
FILM = wk.SurfaceFilm(2e-12)


def passed(load, first=5e-3, second=8e-3, film=FILM):
    return wk.LineConstriction(
        wk.LineIndentation(ROLLER, load), wk.ElectricalConductors(WIRE, LEAD, film), first, second
    ).solve()


def test_line_sources_on_a_strip_of_one_voltage():
    """1 A per length as 1/(pi sqrt(a^2 - s^2)): voltage -rho/pi ln(distance), the same on the strip."""
    a, found = 1e-4, passed(wk.HalfWidth(1e-4), film=wk.SurfaceFilm())

    def voltage(x, z):
        def source(angle):
            return -np.log(np.hypot(x - a * np.sin(angle), z)) / np.pi

        here = np.arcsin(x / a)
        return quad(source, -0.5 * np.pi, here)[0] + quad(source, here, 0.5 * np.pi)[0]

    for x in (0.0, 0.6 * a):
        drop = (voltage(x, 0.0) - voltage(0.0, 5e-3)) * 0.2e-6 / np.pi
        assert found.first_constriction_per_length == pytest.approx(drop, rel=1e-7)
    drop = (voltage(0.0, 0.0) - voltage(0.0, 8e-3)) * 0.3e-6 / np.pi
    assert found.second_constriction_per_length == pytest.approx(drop, rel=1e-7)
    assert found.resistance_per_length == pytest.approx(
        found.first_constriction_per_length + found.second_constriction_per_length
    )


def test_the_parts():
    loads = np.array([0.0, 10e3, 100e3])
    many = passed(wk.LineForce(loads))
    assert many.resistance_per_length[0] == np.inf
    a = np.sqrt(4.0 * loads[1:] * 10e-3 / (np.pi * PAIR.modulus))
    np.testing.assert_allclose(many.half_width[1:], a, rtol=1e-12)
    np.testing.assert_allclose(many.film_resistance_per_length[1:], 1e-12 / a, rtol=1e-12)
    np.testing.assert_allclose(
        many.first_constriction_per_length[1:], 0.2e-6 / np.pi * np.arcsinh(5e-3 / a), rtol=1e-12
    )
    assert many.at(2) == passed(wk.LineForce(100e3))


def test_what_the_film_may_add_is_stated():
    """An even current has the mean potential ln(1/a) + 3/2 - ln 2, a strip of one voltage ln(1/a) + ln 2."""
    even = quad(lambda t: -(1.0 - 0.5 * t) * np.log(t), 0.0, 2.0)[0]
    most = (even - np.log(2.0)) * 0.5e-6 / np.pi
    (note,) = [note for note in passed(wk.HalfWidth(1e-4)).validity if "film" in note.statement]
    assert f"at most {most:.3g} ohm m" in note.statement
    assert note.standing is wk.Standing.APPROXIMATE
    near = passed(wk.HalfWidth(1e-4), first=5e-5).validity
    assert any("more than the depth of the nearer point" in note.statement for note in near)


def test_what_is_refused():
    with pytest.raises(wk.InvalidInput, match="first_depth"):
        passed(wk.HalfWidth(1e-4), first=0.0)
    plated = wk.Plated(WIRE, 1e-6, LEAD)
    with pytest.raises(wk.InvalidInput, match="known for two thick bodies"):
        wk.LineConstriction(
            wk.LineIndentation(ROLLER, wk.HalfWidth(1e-4)), wk.ElectricalConductors(plated, LEAD), 1e-3, 1e-3
        )


@pytest.mark.parametrize("radii", [(20e-3, 5e-3), (1e-3, 90e-3)])
def test_an_ellipse_is_that_of_holm(radii):
    """(rho_1 + rho_2) K(m)/(2 pi alpha), and a thin film by the area of the ellipse."""
    bodies = wk.CurvedBodies(*radii)
    a, b = bodies.semi_axes(PAIR.modulus, 100.0)
    short, long = sorted((a, b))
    holm = 0.5e-6 * ellipk(1.0 - (short / long) ** 2) / (2.0 * np.pi * long)
    bed, clean = wk.EllipticFoundation(bodies, PAIR), wk.ElectricalConductors(WIRE, LEAD)
    assert wk.Constriction(wk.Indentation(bed, wk.Force(100.0)), clean).solve().resistance == pytest.approx(
        holm, rel=1e-10
    )
    thin = wk.ElectricalConductors(WIRE, LEAD, wk.SurfaceFilm(1e-15))
    filmed = wk.Constriction(wk.Indentation(bed, wk.Force(100.0)), thin).solve()
    assert filmed.film_resistance == pytest.approx(1e-15 / (np.pi * a * b), rel=1e-10)
