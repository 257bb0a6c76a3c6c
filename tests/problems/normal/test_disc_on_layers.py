"""Is a contact on layers one disc?  Hard coatings pull and bend away; what is accepted and refused must be right.

The reference solution takes the pressure as that of the load which the same pressure puts on a homogeneous
half-space (`CarriedLoad`), without the flat punches' own pressures.
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.foundation.bed import PressedSprings
from winkler.media.layered.coated_load import CarriedLoad
from winkler.numerics.transforms import abel, fredholm

SOLID = wk.Elastic(1.0, 0.3)


def coated(young: float) -> wk.CoatedHalfSpace:
    """One layer of thickness 1 on a half-space of modulus 1."""
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, 0.3), 1.0)], on=SOLID)


SOFT, HARD, HARDER = coated(0.1), coated(10.0), coated(1e3)
FILM = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0, 0.5), 1.0)], on=wk.Rigid())
GRADED = wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 1.0, 0.4, 0.3))
HALF = wk.HalfSpace.between(SOLID)
STEEP = wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 1.0, -0.6, 0.3))
MEDIA = {"half": HALF, "graded": GRADED, "skin": STEEP, "soft": SOFT, "hard": HARD, "harder": HARDER, "film": FILM}


def pushes(bed: wk.Foundation, a: float) -> bool:
    """Whether the other method to restore the pressure finds none that pulls."""
    load = CarriedLoad(PressedSprings(bed, float(bed.gap(np.array([a]))[0]), a), bed.medium.response)
    r = a * np.concatenate([np.linspace(0.01, 0.96, 30), [0.98, 0.99]])
    pressure = abel.pressure(load.slope, load.kinks, load.edge, a, r)
    return bool(np.min(pressure) > 0.0)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    ("medium", "shape", "a", "disc"),
    [
        (HARD, wk.Paraboloid(1.0), 2.0, True),
        (HARD, wk.PowerLaw(1.0, 4.0), 1.0, True),
        (HARD, wk.PowerLaw(1.0, 4.0), 2.0, False),
        pytest.param(HARD, wk.PowerLaw(1.0, 4.0), 5.0, True, marks=pytest.mark.slow),
        pytest.param(HARDER, wk.Paraboloid(1.0), 2.0, True, marks=pytest.mark.slow),
        (HARDER, wk.PowerLaw(1.0, 4.0), 0.7, True),
        pytest.param(HARDER, wk.PowerLaw(1.0, 4.0), 1.0, False, marks=pytest.mark.slow),
        pytest.param(HARDER, wk.Cone(1.2), 0.3, True, marks=pytest.mark.slow),
        pytest.param(HARDER, wk.Cone(1.2), 1.0, False, marks=pytest.mark.slow),
    ],
)
def test_the_verdict_on_hard_coatings(medium, shape, a, disc):
    bed = wk.Foundation(shape, medium)
    assert pushes(bed, a) is disc
    if disc:
        assert wk.Indentation(bed, wk.Radius(a)).solve().radius == a
        return
    with pytest.raises(wk.OutsideValidity, match="would need tension at r = .* the layers bend away from the body"):
        wk.Indentation(bed, wk.Radius(a)).solve()


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize(
    ("young", "a"),
    [(10.0, 0.5), (10.0, 2.0), (10.0, 20.0), (1e2, 0.1), (1e2, 1.0), (1e2, 5.0), (1e3, 0.5), (1e3, 2.0), (1e4, 0.1),
     (1e4, 1.0)],
)  # fmt: skip
@pytest.mark.parametrize("shape", [wk.Paraboloid(1.0), wk.PowerLaw(1.0, 4.0)], ids=["ball", "quartic"])
def test_the_verdict_everywhere(young, a, shape):
    bed = wk.Foundation(shape, coated(young))
    try:
        wk.Indentation(bed, wk.Radius(a)).solve()
        accepted = True
    except wk.OutsideValidity:
        accepted = False
    assert pushes(bed, a) is accepted


@pytest.mark.slow
def test_the_refused_load_of_an_array_is_named():
    bed = wk.Foundation(wk.PowerLaw(1.0, 4.0), HARD)
    with pytest.raises(wk.OutsideValidity, match="load at index 1"):
        wk.Indentation(bed, wk.Radius(np.array([1.0, 2.0, 5.0]))).solve()
    depths = wk.Indentation(bed, wk.Radius(np.array([0.5, 1.0, 5.0]))).solve().depth
    result = wk.Indentation(bed, wk.Depth(depths)).solve()
    np.testing.assert_allclose(result.radius, [0.5, 1.0, 5.0], rtol=1e-11)
    again = wk.Indentation(bed, wk.Force(result.force)).solve()
    np.testing.assert_allclose(again.depth, depths, rtol=1e-11)


@pytest.mark.slow
def test_a_stiff_plate_is_touched_outside_first():
    """A plate on a soft base bends so little that a cone reaches it in a ring before the disc would pull."""
    with pytest.raises(wk.OutsideValidity, match="begun as a ring"):
        wk.Indentation(wk.Foundation(wk.Cone(1.2), HARDER), wk.Radius(0.7)).solve()


def test_what_was_checked_is_stated():
    def statements(shape, medium, a):
        notes = wk.Indentation(wk.Foundation(shape, medium), wk.Radius(a)).solve().validity
        return [note.statement for note in notes if "checked that the contact is one disc" in note.statement]

    assert statements(wk.Paraboloid(1.0), HALF, 0.5) == []
    (calm,) = statements(wk.Paraboloid(1.0), HARD, 0.5)
    assert "flat punches up to this radius have no tension" in calm
    (pulling,) = statements(wk.Paraboloid(1.0), HARD, 2.0)
    assert "so the pressure was examined" in pulling
    (graded,) = statements(wk.Paraboloid(1.0), GRADED, 0.5)
    assert "increases at all examined places" in graded


@pytest.mark.parametrize("name", ["half", "soft", "hard", "harder", "film"])
def test_the_pressure_of_a_flat_punch_carries_its_stiffness(name):
    """k = Int p1 2 pi r dr, with r = a sin(t)."""
    medium = MEDIA[name]
    s, w = np.polynomial.legendre.leggauss(100)
    t = 0.25 * np.pi * (s + 1.0)
    for radius in (0.3, 1.0, 4.0):
        r = radius * np.sin(t)
        p = medium.punch_pressure(r, np.full(r.shape, radius))
        force = 0.25 * np.pi * np.sum(w * 2.0 * np.pi * r * p * radius * np.cos(t))
        assert force == pytest.approx(float(medium.punch_stiffness(np.array(radius))), rel=1e-10)


@pytest.mark.parametrize("name", ["graded", "skin"])
def test_the_pressure_of_a_flat_punch_in_graded_media(name):
    """p1 = (1+k) k(a) (a^2 - r^2)^((k-1)/2) / (2 pi a^(1+k))."""
    medium, r, a = MEDIA[name], np.array([0.0, 0.3, 0.69]), 0.7
    n = 1.0 + medium.exponent
    exact = n * float(medium.punch_stiffness(np.array(a))) * (a**2 - r**2) ** (0.5 * n - 1.0) / (2.0 * np.pi * a**n)
    np.testing.assert_allclose(medium.punch_pressure(r, np.full(3, a)), exact, rtol=1e-12)


@pytest.mark.slow
def test_incompressible_films_rise_around_a_punch():
    """And never sink deeper than it: what the check of overlap rests on."""
    facts = FILM.punch_facts(20.0)
    assert facts.least < -3.0
    assert facts.most == 1.0
    assert not facts.pulls
    assert not HARD.punch_facts(0.5).pulls
    assert HARD.punch_facts(2.0).pulls
    # the surface itself, by the full restoring of a flat punch
    contact = wk.Indentation(wk.Foundation(wk.FlatPunch(2.0), FILM), wk.Depth(1.0)).solve()
    outside = wk.restore(contact, 2.0 + np.geomspace(0.01, 6.0, 40)).displacement
    facts = FILM.punch_facts(2.0)
    assert facts.least <= float(np.min(outside)) < -0.2
    assert float(np.max(outside)) < 1.0


@pytest.mark.parametrize("name", MEDIA)
def test_the_strength_of_a_kink_is_that_of_the_medium(name):
    """g' times the root above a truncated cone's kink, with a quadratic fit down to the kink."""
    medium, shape, b = MEDIA[name], wk.TruncatedCone(1.2, flat_radius=0.4), 0.4
    k = getattr(medium, "exponent", 0.0)
    y = 1e-2 * np.sqrt(np.arange(1, 13) / 12.0)
    x = np.hypot(b, y)
    scaled = medium.gap_slope(shape, x) * x**k * np.sqrt((x - b) * (x + b)) ** (1.0 - k)
    steps = np.vander(y, 8) if k == 0.0 else np.stack([y ** (1.0 - k), y**2, np.ones(12)], axis=1)
    limit = float(np.linalg.lstsq(steps / np.max(steps, axis=0), scaled, rcond=None)[0][-1])
    ((place, strength),) = [kink for kink in medium.kinks(shape) if kink[1] != 0.0]
    assert place == b
    assert strength == pytest.approx(limit, rel=1e-7 if k == 0.0 else 1e-4)
    if name == "hard":
        assert strength == pytest.approx(0.4 / np.tan(1.2) / float(fredholm.edge(medium.response, np.array(b))))


# ------------------------------------------------------------------------------------------- every shape, every medium

POINTS = np.linspace(0.0, 2.0, 9)
SHAPES = {
    "sphere": wk.Sphere(1.0),
    "ellipsoid": wk.Ellipsoid(1.0, 2.0),
    "area function": wk.AreaFunction((24.5,)),
    "formula": wk.Formula("r**2/(2*R) + c*r**4", R=1.0, c=0.1, reach=2.0),
    "two spheres": wk.Sphere(1.0) + wk.Sphere(3.0),
    "capped cylinder": wk.CappedCylinder(0.5, wk.Paraboloid(1.0)),
    "gentle waves": wk.Paraboloid(1.0) + wk.Wavy(5e-4, 0.2),
    "hyperboloid": wk.Hyperboloid(0.5, 1.0),
    "sharpened tip": wk.CappedParaboloid(1.0, 0.9, 0.2),
    "measured": wk.Measured(POINTS, POINTS**2 / 2.0 + 0.1 * POINTS**3),
}


def solved_and_restored(shape, medium) -> None:
    bed = wk.Foundation(shape, medium)
    contact = wk.Indentation(bed, wk.Radius(0.4)).solve()
    for load in (wk.Depth(contact.depth), wk.Force(contact.force)):
        again = wk.Indentation(bed, load).solve()
        assert (again.depth, again.force, again.radius) == pytest.approx(
            (contact.depth, contact.force, contact.radius), rel=1e-8
        )
    r = np.array([0.1, 0.25, 0.39])
    fields = wk.restore(contact, r)
    np.testing.assert_allclose(fields.displacement, contact.depth - shape.height(r), rtol=0, atol=1e-7 * contact.depth)
    assert np.all(fields.pressure > 0.0)


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ["sphere", "formula", "capped cylinder"])
@pytest.mark.parametrize("medium", ["hard", "graded"])
def test_shapes_that_end(name, medium):
    solved_and_restored(SHAPES[name], MEDIA[medium])


@pytest.mark.few(0, slow=6)
@pytest.mark.parametrize(
    ("name", "medium"),
    [(name, medium) for place, name in enumerate(SHAPES)
     for number, medium in enumerate(["soft", "hard", "film", "graded"]) if (place + number) % 2]
)  # fmt: skip
def test_all_shapes(name, medium):
    """Each shape on two of the four media, each medium under half of the shapes."""
    solved_and_restored(SHAPES[name], MEDIA[medium])


@pytest.mark.slow
def test_a_sphere_pressed_to_its_equator():
    """g is infinite there on every layered medium: any force is carried before it."""
    bed = wk.Foundation(wk.Sphere(1.0), SOFT)
    contact = wk.Indentation(bed, wk.Force(2.0)).solve()
    assert 0.9 < contact.radius < 1.0
    with pytest.raises(wk.OutsideValidity, match="beyond"):
        wk.Indentation(bed, wk.Radius(1.0)).solve()


# ---------------------------------------------------------------------------------------------------------- energy


@pytest.mark.parametrize("k", [-0.95, -0.7, -0.5, 0.0, 0.5, 0.95])
@pytest.mark.parametrize("n", [0.7, 1.0, 2.0, 5.5])
def test_energy_of_powers_in_graded_media(k, n):
    """F grows like a^(n+k+1) and d like a^n, so U = F d n / (2 n + k + 1)."""
    medium = wk.GradedHalfSpace(wk.PowerLawGraded(1e9, 1e-3, k, 0.3))
    contact = wk.Indentation(wk.Foundation(wk.PowerLaw(3.0, n), medium), wk.Radius(2e-3)).solve()
    assert contact.energy == pytest.approx(contact.force * contact.depth * n / (2 * n + k + 1), rel=1e-11)


@pytest.mark.few(7)
@pytest.mark.parametrize(
    ("name", "shape"),
    [(name, wk.Paraboloid(1.0)) for name in MEDIA]
    + [(name, wk.TruncatedCone(1.2, 0.4)) for name in MEDIA if name != "harder"],  # where it bends away
)
def test_energy_is_the_work_done(name, shape):
    """U(d2) - U(d1) = Int F dd, between loads that lie beyond every kink."""
    bed = wk.Foundation(shape, MEDIA[name])
    low, high = bed.gap(np.array([0.5, 0.7]))
    s, w = np.polynomial.legendre.leggauss(14)
    between = wk.Indentation(bed, wk.Depth(low + 0.5 * (high - low) * (s + 1.0))).solve()
    ends = wk.Indentation(bed, wk.Depth(np.array([low, high]))).solve()
    work = 0.5 * (high - low) * float(w @ between.force)
    assert ends.energy[1] - ends.energy[0] == pytest.approx(work, rel=1e-9)
