"""Cylinders that roll on layers: independent numbers, half-planes as limits, the substrate, energy, refinement."""

from __future__ import annotations

import functools

import numpy as np
import pytest
from layer_waves import excesses
from rolling_of_layers import RollingCylinder, coupling, free_creepage

import winkler as wk
from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.problems.line_rolling.rolled_strip import creepage_error, loss_error, rolled_strip

MU, NU = 0.4, 0.3
SHEAR = 0.5 * (1.0 - NU)
"""E* = 1 of the layer under a rigid body."""
CYLINDER = wk.Paraboloid(1.0)


def solid(share=1.0):
    return wk.Elastic(2.0 * SHEAR * (1.0 + NU) * share, NU)


def coated(contrast, thickness=1.0, second=None):
    medium = wk.CoatedHalfSpace([wk.Layer(solid(), thickness)], solid(contrast), second or wk.Rigid())
    return wk.LayeredLineFoundation(CYLINDER, medium)


def rolled(bed, a, used, mu=MU, coupled=False):
    """Under this share of what friction bears."""
    load = bed.medium.modulus * float(bed.load_profile(np.array([a]))[0])
    drive = wk.LineShearForce(np.asarray(used) * mu * load)
    return wk.LineRolling(bed, wk.Coulomb(mu), drive, wk.HalfWidth(a), coupled=coupled).solve()


@functools.cache
def by_equations(contrast, a, share=0.6):
    return RollingCylinder([(SHEAR, NU, 1.0)], (contrast * SHEAR, NU), a, share * a)


LAYERS = [(contrast, a) for contrast in (0.1, 10.0) for a in (0.3, 3.0, 10.0)]


@pytest.mark.few(3)
@pytest.mark.parametrize(("contrast", "a"), LAYERS)
def test_a_cylinder_rolls_as_singular_integral_equations_say(contrast, a):
    """Creepage, stick, and the force of a creepage: 0.31 to 1.95 times Carter's creepage of the same stick."""
    expected = by_equations(contrast, a)
    bed = coated(contrast)
    found = rolled(bed, a, expected.force / expected.load)
    assert found.contact.force_per_length == pytest.approx(expected.load, rel=1e-11)
    assert found.longitudinal_creepage == pytest.approx(MU * expected.creepage, rel=creepage_error(found.strips[0]))
    assert found.stick_share == pytest.approx(0.6, abs=3e-3)
    back = wk.LineRolling(bed, wk.Coulomb(MU), wk.Creepage(MU * expected.creepage), wk.HalfWidth(a)).solve()
    assert back.shear_force_per_length == pytest.approx(MU * expected.force, rel=1e-4)


def test_the_creepage_is_carters_only_if_layers_answer_shear_as_pressures():
    """At a / h = 3 on a base ten times as soft: 0.311 mu (a - c)/R, and mu (a - c)/R with responses in proportion."""
    layers, on = [(SHEAR, NU, 1.0)], (0.1 * SHEAR, NU)
    expected, other = by_equations(0.1, 3.0), RollingCylinder(layers, on, 3.0, 1.8, proportional=True)
    found = rolled(coated(0.1), 3.0, expected.force / expected.load).longitudinal_creepage / MU
    assert other.creepage == pytest.approx(3.0 - 1.8, rel=1e-9)
    assert found / other.creepage == pytest.approx(0.311, abs=1e-3)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("contrast", "a"), LAYERS)
def test_free_cylinders_creep_as_the_coupling_of_the_layers_says(contrast, a):
    """With hardly any friction, steadily and after some widths: half of the load slips to either side."""
    expected = free_creepage([(SHEAR, NU, 1.0)], (contrast * SHEAR, NU), a)
    assert rolled(coated(contrast), a, 0.0, 1e-4, coupled=True).longitudinal_creepage == pytest.approx(
        expected, rel=2e-3
    )
    begun = wk.LineRollingStart(
        coated(contrast), wk.Coulomb(1e-4), wk.LineShearForce(0.0), wk.HalfWidth(a), distance=6.0 * a, points=1
    )
    assert begun.solve().longitudinal_creepage[-1] == pytest.approx(expected, rel=5e-3)


@pytest.mark.slow
@pytest.mark.parametrize("used", [0.0, -0.5])
def test_pressure_and_traction_on_layers_satisfy_the_integral_equations(used):
    """With an elastic second body: half-planes by logarithms of straight pieces, layers by matrix exponentials."""
    other, mu, a = wk.Elastic(0.7, 0.45), 0.3, 2.0
    bed = coated(0.2, second=other)
    (strip,) = rolled(bed, a, used, mu, coupled=True).strips
    modulus = bed.medium.modulus
    slope, own = a, modulus * (1.0 - NU) / (2.0 * SHEAR)
    beta = own * 0.5 * (1.0 - 2.0 * NU) / (1.0 - NU) - modulus * (1.0 - 0.9) / (4.0 * 0.7 / 2.9)
    x = 0.5 * (strip.x[1:] + strip.x[:-1])
    k, weights = waves_up_to(22.0 / 1.0)
    normal, along = excesses([(SHEAR, NU, 1.0)], (0.2 * SHEAR, NU), k)
    drawn = coupling([(SHEAR, NU, 1.0)], (0.2 * SHEAR, NU), k) - 0.5 * (1.0 - 2.0 * NU) / (1.0 - NU)
    k = k * a

    def felt(excess, row, *, even=False):
        """2/pi times the integral of M (sin or cos) k(x - s) row(s), lengths over a."""
        fine = np.linspace(0.0, 1.0, 9)[:-1]
        s = np.append((strip.x[:-1, None] + np.diff(strip.x)[:, None] * fine).ravel(), strip.x[-1])
        values = np.interp(s, strip.x, row)
        cos, sin = (np.trapezoid(values * wave(np.outer(k, s)), s) for wave in (np.cos, np.sin))
        shares = 2.0 / np.pi * own * excess * weights * a
        if even:
            return np.cos(np.outer(x, k)) @ (shares * cos) + np.sin(np.outer(x, k)) @ (shares * sin)
        return np.sin(np.outer(x, k)) @ (shares * cos) - np.cos(np.outer(x, k)) @ (shares * sin)

    def hilbert(row):
        h = np.diff(strip.x)
        far = np.log(np.abs((x[:, None] - strip.x[:-1]) / (x[:, None] - strip.x[1:])))
        steep = np.diff(row) / h
        return 2.0 / np.pi * np.sum((row[:-1] + steep * (x[:, None] - strip.x[:-1])) * far - steep * h, axis=1)

    p, q = strip.pressure, strip.traction
    means = [0.5 * (row[1:] + row[:-1]) for row in (p, q)]
    gap = hilbert(p) + felt(normal, p) - 2.0 * beta * means[1] - felt(drawn, q, even=True) - slope * x
    slip = strip.creepage - hilbert(q) - felt(along, q) - 2.0 * beta * means[0] - felt(drawn, p, even=True)
    inner = slice(1, None)  # the element at the trailing edge has no condition of its own
    assert np.max(np.abs(gap[inner])) < 1e-5 * slope  # the trapezoids of this test
    assert np.max(np.abs((slip - strip.slip)[inner])) < 1e-5 * mu * slope
    assert np.all(strip.slip * means[1] >= 0.0)
    assert np.all(np.abs(q) <= mu * p * (1.0 + 1e-9))
    load = bed.load_profile(np.array([a]))[0] / a
    assert np.trapezoid(p, strip.x) == pytest.approx(float(load), rel=1e-8)


def waves_up_to(longest):
    edges = np.concatenate([[0.0], 0.3 * 2.0 ** -np.arange(12.0, 0.0, -1.0), np.arange(0.3, longest, 0.3)])
    node, weight = np.polynomial.legendre.leggauss(12)
    return (
        (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (node + 1.0)).ravel(),
        (0.5 * np.diff(edges)[:, None] * weight).ravel(),
    )


@pytest.mark.parametrize("coupled", [False, True])
def test_layers_of_one_solid_roll_as_a_half_plane(coupled):
    """Against an elastic body; half-planes have Carter's closed form, or elements without a wave of the layers."""
    other = wk.Elastic(0.5, 0.1)
    plain = wk.LineFoundation(CYLINDER, wk.HalfSpace(solid(), other))
    layered, half = (rolled(bed, 2.0, [0.3, -0.8], coupled=coupled) for bed in (coated(1.0, second=other), plain))
    close = 1e-9 if coupled else 5e-5
    np.testing.assert_allclose(layered.longitudinal_creepage, half.longitudinal_creepage, rtol=close)
    np.testing.assert_allclose(layered.stick_share, half.stick_share, atol=1e-9 if coupled else 4e-3)
    np.testing.assert_allclose(layered.loss_per_area, half.loss_per_area, rtol=close)


@pytest.mark.slow
def test_the_substrate_is_felt_and_decides_under_a_thin_layer():
    """At a / h = 3 a base ten times as soft; what differs from the base's own half-plane falls as h ln(1/h)."""

    def creepage(bed):
        return rolled(bed, 1.0, 0.5).longitudinal_creepage

    assert creepage(coated(0.1, 1.0 / 3.0)) < 0.6 * creepage(coated(0.5, 1.0 / 3.0))
    base = 0.5 * MU * (1.0 - np.sqrt(0.5)) / 0.5
    away = [abs(creepage(coated(0.8, thickness)) / base - 1.0) for thickness in (0.04, 0.02, 0.01)]
    assert away[2] < 0.7 * away[1] < 0.5 * away[0] < 0.03


@pytest.mark.parametrize(("coupled", "used"), [(False, 0.5), (True, 0.5), (True, -0.5)])
def test_what_layers_lose_is_what_drives_them(coupled, used):
    """The creepage times the force, and the moment of the pressure: by the integral equations."""
    found = rolled(coated(0.1), 3.0, used, coupled=coupled)
    (strip,) = found.strips
    moment = 3.0 * np.trapezoid(strip.pressure * strip.x, strip.x)
    assert strip.loss == pytest.approx(strip.creepage * strip.force + moment, abs=loss_error(strip, 3.0))
    assert strip.loss == pytest.approx(strip.creepage * strip.force + moment, rel=1e-4)


def test_the_creepage_converges_with_the_second_order():
    expected = by_equations(10.0, 3.0)
    used = expected.force * MU / 3.0
    errors = [
        abs(
            rolled_strip(coated(10.0), 3.0, MU, force=used, coupled=False, count=count).creepage / MU
            - expected.creepage
        )
        for count in (50, 100, 200)
    ]
    assert errors[2] < 0.4 * errors[1] < 0.16 * errors[0]
    assert errors[2] < 1e-4 * expected.creepage


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
def test_the_stated_error_on_layers_holds_against_finer_elements(seed):
    rng = np.random.default_rng(seed)
    layers = [wk.Layer(wk.Elastic(1.0, rng.uniform(0.0, 0.5)), 1.0)]
    on = wk.Elastic(10.0 ** rng.uniform(-1.5, 1.5), rng.uniform(0.0, 0.5))
    bed = wk.LayeredLineFoundation(CYLINDER, wk.CoatedHalfSpace(layers, on, wk.Elastic(2.0, 0.1)))
    a, mu, coupled = 10.0 ** rng.uniform(-1.0, 1.0), 10.0 ** rng.uniform(-2.0, 0.3), bool(rng.integers(2))
    force = rng.uniform(-1.0, 1.0) * mu * float(bed.load_profile(np.array([a]))[0]) / a
    strip, finer = (rolled_strip(bed, a, mu, force=force, coupled=coupled, count=count) for count in (400, 800))
    assert abs(strip.creepage - finer.creepage) * 4.0 / 3.0 <= creepage_error(strip) * abs(finer.creepage)
    assert abs(strip.loss - finer.loss) * 4.0 / 3.0 <= loss_error(strip, a)


@pytest.mark.few(2)
@pytest.mark.parametrize(("contrast", "a"), LAYERS)
def test_it_begins_to_roll_and_comes_to_the_steady_state_of_the_equations(monkeypatch, contrast, a):
    """Without what the pressure drags, which the equations leave out: within what is stated of 80 elements."""
    monkeypatch.setattr(LayeredLineFoundation, "drawn", lambda self, x, half_width: np.zeros(x.shape))
    expected, bed = by_equations(contrast, a), coated(contrast)
    pull = wk.LineShearForce(MU * expected.force)
    begun = wk.LineRollingStart(bed, wk.Coulomb(MU), pull, wk.HalfWidth(a), distance=8.0 * a, points=1)
    assert begun.solve().longitudinal_creepage[-1] == pytest.approx(MU * expected.creepage, rel=4e-3)


def test_a_creepage_counts_from_its_reference_on_layers_too():
    """Of one solid the half-plane's course, near and far; a stiff base brings the force sooner than a soft one."""

    def forces(bed, reference):
        drive = wk.Creepage(0.05)
        start = wk.LineRollingStart(
            bed, wk.Coulomb(MU), drive, wk.HalfWidth(1.0), distance=2.0, reference=reference, points=4, count=20
        )
        return start.solve().shear_force_per_length / bed.load_profile(np.array([1.0]))

    plain = wk.LineFoundation(CYLINDER, wk.HalfSpace(solid()))
    for reference in (3.0, 500.0):
        np.testing.assert_allclose(forces(coated(1.0), reference), forces(plain, reference), rtol=1e-9, atol=1e-12)
    soft, stiff = (forces(coated(contrast), 500.0) for contrast in (0.1, 10.0))
    assert np.all(soft[1:] < stiff[1:])


@pytest.mark.parametrize("sliding", ["film", "stack"])
def test_a_layer_that_slides_is_rolled_away(sliding):
    if sliding == "film":
        medium = wk.SlidingFilm([wk.Layer(solid(), 1.0)], solid(2.0))
    else:
        layers = [wk.StackLayer(solid(), 1.0), wk.StackLayer(solid(3.0), 1.0, bonded=False)]
        medium = wk.StackedHalfSpace(layers, solid(2.0))
    bed = wk.LayeredLineFoundation(CYLINDER, medium)
    with pytest.raises(wk.OutsideValidity, match="slide away"):
        wk.LineRolling(bed, wk.Coulomb(MU), wk.LineShearForce(0.0), wk.LineForce(0.1))
    with pytest.raises(wk.OutsideValidity, match="slide away"):
        wk.LineRollingStart(bed, wk.Coulomb(MU), wk.LineShearForce(0.0), wk.LineForce(0.1), distance=1.0)


@pytest.mark.slow
def test_notes_and_fields_of_a_cylinder_that_rolls_on_layers():
    strong = wk.Elastic(2.0 * SHEAR * (1.0 + NU), NU, strength=5.0)
    bed = wk.LayeredLineFoundation(CYLINDER, wk.CoatedHalfSpace([wk.Layer(strong, 1.0)], solid(0.1)))
    found = rolled(bed, 1.0, 0.5)
    texts = " ".join(note.statement for note in found.validity)
    assert "Fourier response of the stack" in texts
    assert "half-planes" not in texts
    assert "were all of it to slide" in texts
    x = np.linspace(-1.2, 1.2, 7)
    np.testing.assert_allclose(found.pressure(x), found.contact.pressure(x), rtol=1e-12)
    assert np.all(np.abs(found.traction(x)) <= MU * found.pressure(x) * (1.0 + 1e-3))
    with pytest.raises(wk.OutsideValidity, match="inside layers"):
        found.stresses(0.0, 0.5)
    free = rolled(bed, 1.0, 0.0, coupled=True)
    assert "are coupled in both directions" in " ".join(note.statement for note in free.validity)
    assert free.longitudinal_creepage != 0.0


def test_a_narrow_contact_on_a_layer_feels_no_base_that_is_ten_thousand_times_as_soft():
    """Sums of waves round at 1e-10 there, and were asked to be exact to 1e-12: `NotConverged`."""
    found = rolled(coated(1e-4), 1e-3, 0.5)
    assert found.longitudinal_creepage == pytest.approx(MU * 1e-3 * (1.0 - np.sqrt(0.5)), rel=1e-4)
