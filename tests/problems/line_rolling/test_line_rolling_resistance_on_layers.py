"""A cylinder that passes over layers which relax: its surface, its losses and its limits by other routes."""

from __future__ import annotations

import dataclasses

import layer_waves
import numpy as np
import pytest
from scipy.optimize import brentq

import winkler as wk
from winkler.media.layered.wave_constants import Wave
from winkler.numerics.transforms.strips.passing_waves import passing_modes

FILM = wk.StandardSolid(relaxed_shear=1.0, shear=4.0, relaxation_time=0.1, poisson=0.4)
BASE = wk.StandardSolid(relaxed_shear=2.0, shear=1.0, relaxation_time=1.0, poisson=0.3)


def at(solid, s):
    """G(s) and Poisson's ratio of a standard solid, or of an elastic one."""
    if isinstance(solid, wk.Elastic):
        return 0.5 * solid.young / (1.0 + solid.poisson), solid.poisson
    turn = s * solid.relaxation_time
    return solid.relaxed_shear + solid.shear * turn / (1.0 + turn), solid.poisson


def layered(film, on, thickness):
    """The medium, and its waves at k and s by matrix exponentials."""
    medium = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(film, thickness)], on=on)

    def waves(k, s):
        found = np.empty(k.size, dtype=complex)
        for i, (one, rate) in enumerate(zip(k, s, strict=True)):
            shear, poisson = at(film, rate)
            scale = np.array([1.0, 1.0, shear, shear])[:, None]
            fields = layer_waves.base(None if isinstance(on, wk.Rigid) else (*at(on, rate),)) / scale
            crossed = layer_waves.crossed(poisson, np.array([min(one * thickness, 40.0)]))[0]
            fields = scale * (crossed @ fields)
            found[i] = -0.5 * (fields[:2] @ np.linalg.inv(fields[2:]))[1, 1]
        return found

    return medium, waves


def contrasted(contrast):
    """A base that is so many times stiffer than the relaxed film."""
    return wk.Elastic(contrast * 2.0 * 1.4, 0.3)


def passed(medium, half_width, speed):
    bed = wk.LayeredLineFoundation(wk.Paraboloid(1.0), medium)
    return wk.LineRollingResistance(bed, wk.HalfWidth(half_width), speed).solve()


def checked(medium, waves, a, speed, short, tolerance):
    """Check that the surface follows the cylinder, and that the waves lose what resists it."""
    found = passed(medium, a, speed)
    count, middle = 1024, 0.5 * (found.leading_edge + found.trailing_edge)
    angle = np.pi * (np.arange(count) + 0.5) / count
    t, share = np.cos(angle), np.pi / count * a * np.sin(angle)
    pressure = found.pressure(middle + a * t)
    order = np.arange(1, 200)
    modes = 2.0 / count * np.sin(np.outer(order, angle)) @ pressure
    edges = np.concatenate([[0.0], np.geomspace(1e-6, 3.0, 40), np.arange(6.0, 600.0, 3.0)]) / a
    node, weight = np.polynomial.legendre.leggauss(6)
    k = (edges[:-1, None] + 0.5 * np.diff(edges)[:, None] * (node + 1.0)).ravel()
    weights = (0.5 * np.diff(edges)[:, None] * weight).ravel()
    answer = np.conj(waves(k, 1j * speed * k))
    borne = np.exp(-1j * a * np.outer(k, t)) @ (pressure * share)
    places = np.linspace(-0.97, 0.97, 9)
    slope = -2.0 * short * np.cos(np.outer(np.arccos(places), order)) @ modes
    parts = np.exp(1j * a * np.outer(places, k)) @ (weights * 1j * (answer - short) * borne)
    slope = slope + 2.0 / np.pi * parts.real
    assert slope == pytest.approx(-(middle + a * places), abs=tolerance * a)
    lost = 2.0 / np.pi * weights @ (np.abs(borne) ** 2 * answer.imag)
    assert found.shear_force_per_length == pytest.approx(lost, rel=2.0 * tolerance)
    x = middle + a * t
    assert found.force_per_length == pytest.approx(share @ pressure, rel=1e-6)
    assert found.shear_force_per_length == pytest.approx(share @ (pressure * x), rel=1e-6)
    return found


SLOW = pytest.mark.slow


@pytest.mark.parametrize(
    ("contrast", "ratio"),
    [(0.1, 3.0), (10.0, 3.0)] + [pytest.param(c, r, marks=SLOW) for c in (0.1, 10.0) for r in (0.3, 10.0)],
)
def test_the_surface_follows_the_cylinder_and_its_waves_lose_what_resists(contrast, ratio):
    a = 0.05
    medium, waves = layered(FILM, contrasted(contrast), a / ratio)
    short = 0.5 * (1.0 - 0.4) / 5.0
    checked(medium, waves, a, 0.4, short, 2e-5)


@pytest.mark.slow
def test_where_the_base_relaxes_too_and_on_a_film_that_loses_its_liquid():
    checked(*layered(FILM, BASE, 0.02), 0.05, 0.4, 0.5 * 0.6 / 5.0, 2e-5)
    film = wk.PoroelasticFilm(1.0, 0.2, diffusivity=2e-3, thickness=0.03)
    modulus = 2.0 * 0.8 / 0.6

    def waves(k, s):
        """Of a half-space (McNamee and Gibson): exact where the base is not felt."""
        both = 0.5 * modulus * (np.sqrt(k**2 + s / 2e-3) + k)
        return 0.25 * both / (both - k)

    thick = dataclasses.replace(film, thickness=30.0)
    found = checked(thick, waves, 0.05, 0.1, 0.4, 2e-4)
    assert found.coefficient > 1e-3
    slow, fast = (passed(film, 0.05, speed) for speed in (1e-4, 50.0))
    for one, stack, near in ((slow, film.relaxed, 1e-3), (fast, film.glassy, 5e-2)):
        elastic = wk.LineIndentation(wk.LayeredLineFoundation(wk.Paraboloid(1.0), stack), wk.HalfWidth(0.05)).solve()
        assert one.force_per_length == pytest.approx(elastic.force_per_length, rel=near)


@pytest.mark.parametrize("speed", [0.5, 10.0, 300.0])
def test_waves_of_a_half_plane_pass_as_hunter_says(speed):
    bed = wk.LineFoundation(wk.Paraboloid(1.0), wk.ViscoelasticHalfSpace(FILM, BASE))
    known = wk.LineRollingResistance(bed, wk.HalfWidth(0.5), speed).solve()
    strip = passing_modes(lambda k: np.conj(bed.medium.waves(Wave.NORMAL, 2.0 * k, 2j * speed * k)))
    assert strip is not None
    assert 0.5 * strip.middle == pytest.approx(0.5 * (known.leading_edge + known.trailing_edge), rel=1e-7)
    assert 0.125 * np.pi * strip.modes[0] == pytest.approx(known.force_per_length, rel=1e-8)


def test_a_thin_film_that_relaxes_is_a_row_of_springs():
    """p = (1/h) int M(t - t') dw, w = (l^2 - x^2) / 2R from the leading edge l on; to the order of h/a."""
    bed = {}
    for thickness in (4e-3, 2e-3):
        medium, _ = layered(FILM, wk.Rigid(), thickness)
        bed[thickness] = wk.LineRollingResistance(
            wk.LayeredLineFoundation(wk.Paraboloid(1.0), medium), wk.HalfWidth(0.2), 2.0
        ).solve()
    lag = 2.0 * 0.1

    def springs(lead, x):
        """p h / M of the relaxed film, five times as stiff at first."""
        # int_x^l exp(-(y - x)/lag) y dy
        integral = lag * ((x + lag) - (lead + lag) * np.exp(-(lead - x) / lag))
        return 0.5 * (lead**2 - x**2) + 4.0 * integral

    lead = brentq(lambda lead: springs(lead, lead - 0.4), 0.21, 0.399)
    x = np.linspace(lead - 0.4, lead, 20001)
    p = springs(lead, x)
    coefficient = np.trapezoid(p * x, x) / np.trapezoid(p, x)
    errors = [bed[h].coefficient / coefficient - 1.0 for h in (4e-3, 2e-3)]
    assert abs(errors[1]) < 0.6 * abs(errors[0]) < 0.02
    force = 2.0 * 1.0 * 0.6 / 0.2 * np.trapezoid(p, x)  # M = 2 G (1 - nu) / (1 - 2 nu)
    assert bed[2e-3].force_per_length * 2e-3 == pytest.approx(force, rel=0.02)


def test_slowly_and_fast_layers_are_elastic_and_relax_as_one_where_they_relax_alike():
    medium, _ = layered(FILM, contrasted(10.0), 0.02)
    for speed, stack in ((2e-3, medium.relaxed), (1e5, medium.glassy)):
        found = passed(medium, 0.05, speed)
        bed = wk.LayeredLineFoundation(wk.Paraboloid(1.0), stack)
        elastic = wk.LineIndentation(bed, wk.HalfWidth(0.05)).solve()
        assert found.force_per_length == pytest.approx(elastic.force_per_length, rel=3e-2)
        assert 0.0 < found.coefficient < 2e-3
    alike = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(FILM, 0.02)], on=wk.Rigid())
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(2.8, 0.4), 0.02)], on=wk.Rigid())
    one, other = (passed(each, 0.05, 0.4) for each in (alike, wk.RelaxingInProportion(film, FILM, shear=1.0)))
    for name in ("force_per_length", "leading_edge", "coefficient", "peak_pressure"):
        assert getattr(one, name) == pytest.approx(getattr(other, name), rel=1e-9)
    bed = other.problem.bed
    by_force = wk.LineRollingResistance(bed, wk.LineForce(other.force_per_length), 0.4).solve()
    by_mean = wk.LineRollingResistance(bed, wk.MeanPressure(other.mean_pressure), np.array([0.4])).solve()
    assert by_force.half_width == pytest.approx(0.05, rel=1e-9)
    assert by_mean.half_width == pytest.approx([0.05], rel=1e-9)
    notes = [note.statement for note in one.validity]
    assert notes[0].startswith("Perfectly bonded, isotropic, linear viscoelastic layers in plane strain")
    assert not any("half-plane" in note for note in notes)


def test_what_is_refused():
    medium, _ = layered(FILM, contrasted(10.0), 0.02)
    with pytest.raises(wk.OutsideValidity, match="layers relax so much faster"):
        passed(medium, 0.05, 1e-6)
    elastic = wk.LayeredLineFoundation(wk.Paraboloid(1.0), medium.relaxed)
    with pytest.raises(wk.InvalidInput, match="an elastic body does not resist rolling"):
        wk.LineRollingResistance(elastic, wk.HalfWidth(0.05), 1.0)
    hard = wk.ViscoelasticCoatedHalfSpace(
        [wk.ViscoelasticLayer(wk.StandardSolid(1e3, 4e3, 0.1, poisson=0.3), 0.02)], on=wk.Elastic(1.0, 0.3)
    )
    with pytest.raises(wk.OutsideValidity, match="pulled inside the strip"):
        passed(hard, 0.2, 1.0)
