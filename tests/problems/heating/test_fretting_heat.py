"""Fretting heat: the loss of a cycle, where it is released, and how warm that makes the contact."""

import math

import numpy as np
import pytest

import winkler as wk
from winkler.reference.heating import hertz_heat_temperature

STEEL = wk.Elastic(210e9, 0.3)
IRON = wk.ThermalConductor(conductivity=45.0, diffusivity=12e-6)
COPPER = wk.ThermalConductor(conductivity=200.0, diffusivity=90e-6)
PAIR = wk.HeatConductors(IRON, COPPER)
BALL = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(STEEL, STEEL))
FORCE, MU = 100.0, 0.5


def motion(amplitude, count=40, cycles=2.0, bed=BALL):
    path = wk.Path.oscillation(force=FORCE, amplitude=amplitude, cycles=cycles, count=count)
    return wk.Tangential(bed, wk.Coulomb(MU), path)


@pytest.fixture(scope="module")
def partial():
    return wk.FrettingHeat(motion(1e-6, count=80), 50.0, PAIR).solve()


def closed_flux(r):
    """Each half cycle slips twice as far as the first push did (Masing): 4 mu p s in all, 50 times a second."""
    state = (
        wk.Tangential(BALL, wk.Coulomb(MU), wk.Path([0.0, 1.0], wk.Force(FORCE), wk.Shift([0.0, 1e-6]))).solve().at(1)
    )
    fields = wk.restore(state, r)
    return 50.0 * 4.0 * MU * fields.pressure * fields.slip


def test_the_heat_is_the_loss_of_every_cycle(partial):
    loss = wk.FrictionDamping(BALL, wk.Coulomb(MU), wk.Force(FORCE), wk.Shift(1e-6)).solve().loss_per_cycle
    assert partial.loss_per_cycle == pytest.approx(loss, rel=1e-9)
    assert partial.heat_rate == pytest.approx(50.0 * loss, rel=1e-9)
    assert partial.first_share == pytest.approx(45.0 / 245.0)
    assert partial.misfit < 2e-3
    assert partial.source.heat == pytest.approx(partial.heat_rate, rel=1e-9)


def test_the_heat_is_released_where_the_surfaces_slip(partial):
    stick = float(np.min(partial.march.stick_radius[-81:]))
    r = np.linspace(0.0, 0.9999, 200) * partial.source.radius
    flux = partial.flux.at(r)
    assert np.max(np.abs(flux[r < 0.99 * stick])) < 1e-6 * np.max(flux)
    assert partial.flux.at(np.array([1.2 * partial.source.radius]))[0] == 0.0
    wanted = closed_flux(r)
    np.testing.assert_allclose(flux, wanted, rtol=0.0, atol=5e-3 * np.max(wanted))


def test_the_temperature_is_that_of_the_rings(partial):
    """Every ring of heat, at rest: its potential by elliptic integrals, summed."""
    from scipy.special import ellipk

    end = partial.source.radius
    ring = end * (np.arange(4000) + 0.5) / 4000.0
    flux = closed_flux(ring)
    for place in (0.0, 0.55 * end, 1.6 * end):
        kernel = 2.0 / math.pi / (ring + place) * ellipk(4.0 * ring * place / (ring + place) ** 2)
        wanted = np.sum(flux * ring * kernel) * end / 4000.0 / 245.0
        assert partial.temperature(place) == pytest.approx(wanted, rel=3e-3)
    assert partial.max_temperature >= float(np.max(partial.temperature(np.linspace(0.0, end, 30))))
    assert 0.0 < partial.mean_temperature < partial.max_temperature
    assert partial.swing <= partial.max_temperature


def test_gross_slip_is_a_slow_slider():
    """Far beyond sliding the flux is that of sliding: its mean speed is four strokes in every cycle."""
    amplitude = 1e-4
    warm = wk.FrettingHeat(motion(amplitude), 2.0, wk.HeatConductors(IRON, IRON)).solve()
    radius = float(warm.march.radius[-1])
    sliding = hertz_heat_temperature(MU * FORCE * 4.0 * amplitude * 2.0, radius, 90.0, 0.0)
    assert warm.max_temperature == pytest.approx(float(sliding), rel=0.05)
    assert any("to each side" in note.statement for note in warm.validity)


def test_the_swing_of_a_quick_motion_is_that_of_a_plane():
    quick = wk.FrettingHeat(motion(3e-6), 1e6, wk.HeatConductors(IRON, IRON)).solve()
    r = np.linspace(0.0, quick.source.radius, 513)
    effusivity = 2.0 * 45.0 / math.sqrt(12e-6)
    assert quick.swing == pytest.approx(np.max(quick.flux.at(r)) / (effusivity * math.sqrt(4e6 * math.pi)), rel=1e-12)
    assert quick.swing < quick.max_temperature


def test_what_is_refused():
    with pytest.raises(wk.InvalidInput, match="closed cycle"):
        wk.FrettingHeat(motion(1e-6, cycles=1.0), 50.0, PAIR).solve()
    stuck = wk.Tangential(BALL, wk.Coulomb(math.inf), wk.Path.oscillation(force=FORCE, amplitude=1e-6, cycles=2))
    with pytest.raises(wk.OutsideValidity, match="nothing slips"):
        wk.FrettingHeat(stuck, 50.0, PAIR).solve()
    with pytest.raises(wk.OutsideValidity, match="a ring slips that is .* of the contact radius wide, at least 2e-06"):
        wk.FrettingHeat(motion(1e-14), 50.0, PAIR).solve()
    with pytest.raises(wk.InvalidInput, match="frequency"):
        wk.FrettingHeat(motion(1e-6), 0.0, PAIR)
    with pytest.raises(wk.InvalidInput, match="give Tangential"):
        wk.FrettingHeat(wk.Indentation(BALL, wk.Force(1.0)), 50.0, PAIR)


def coated(solid, path, thickness=50e-6):
    bed = wk.Foundation(wk.Paraboloid(10e-3), wk.CoatedHalfSpace([wk.Layer(solid, thickness)], on=STEEL, second=STEEL))
    return wk.FrettingHeat(wk.Tangential(bed, wk.Coulomb(MU), path), 50.0, PAIR).solve()


@pytest.mark.slow
@pytest.mark.parametrize("young", [pytest.param(420e9, marks=pytest.mark.slow), 42e9], ids=["hard", "soft"])
def test_traction_times_slip_on_a_coating_is_the_loss_of_the_springs(young):
    """The area of the loop, from the memory of the springs; the same over the surface, ring by ring."""
    path = wk.Path.oscillation(depth=1e-6, amplitude=0.4e-6, cycles=2, count=8)
    warm = coated(wk.Elastic(young, 0.3), path)
    assert warm.misfit < 1e-9
    loop = warm.march.dissipation[-1] - warm.march.dissipation[-9]
    assert warm.source.heat == pytest.approx(50.0 * loop, rel=1e-9)
    stick = float(np.min(warm.march.stick_radius[-9:]))
    assert np.max(warm.flux.at(np.linspace(0.0, 0.999 * stick, 20))) < 1e-9 * 50.0 * loop / stick**2


@pytest.mark.slow
def test_a_coating_of_the_same_solid_is_as_warm_as_a_half_space():
    path = wk.Path.oscillation(force=FORCE, amplitude=1e-6, cycles=2, count=8)
    one = coated(STEEL, path)
    r = np.linspace(0.0, 0.99, 7) * one.source.radius
    state = wk.Tangential(
        wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(STEEL, STEEL)), wk.Coulomb(MU),
        wk.Path([0.0, 1.0], wk.Force(FORCE), wk.Shift([0.0, 1e-6])),
    ).solve().at(1)  # fmt: skip
    fields = wk.restore(state, r)
    wanted = 50.0 * 4.0 * MU * fields.pressure * fields.slip
    np.testing.assert_allclose(one.flux.at(r), wanted, rtol=1e-7, atol=1e-7 * np.max(wanted))
