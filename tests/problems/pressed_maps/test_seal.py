"""Seals: closed forms through the contact, turned maps, percolation, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.loading.loads import Depth, Force
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.pressed_maps.seal import Seal
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.profiles.rough.random_rough import random_topography
from winkler.profiles.rough.spectrum import SelfAffine
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Standing

UNIT = HalfSpace(Elastic(1.0, 0.0))
STEEL = HalfSpace(Elastic(210e9, 0.3))
SPECTRUM = SelfAffine(0.8, 1e-6, 1e-3, 6e-5, roll_off=2.5e-4)


def rough(seed=1, count=64):
    return random_topography(SPECTRUM, (count, count), [1e-3, 1e-3], seed=seed)


def grooves(count=256, rows=8, height=0.01):
    x = np.arange(count) / count
    return Topography(np.repeat(height * np.cos(2.0 * np.pi * x)[None, :], rows, 0), [1.0, 1.0], periodic=True)


def test_grooves_of_westergaards_wave():
    """Along them flows the integral of the cube of the gap, which Westergaard's contact has in closed form.

    With the pressure p = 2 q cos(t) sqrt(sin(b)^2 - sin(t)^2) / sin(b)^2, t = pi x, b = pi a, the slope of the gap
    beyond the edge is 2 pi D sin(2t) sqrt(1 - sin(b)^2 / sin(t)^2), D the height (H. M. Westergaard, J. Appl. Mech. 6
    (1939) 49-53): it is integrated here from the edge.
    """
    height, share = 0.01, 0.3
    seal = Seal(SurfaceContact(grooves(), UNIT, Force(share * np.pi * height)), viscosity=0.5, pressure_drop=3.0)
    found = seal.solve()
    b = np.arcsin(np.sqrt(share))
    t = b + (np.pi / 2.0 - b) * (np.arange(40000) + 0.5) / 40000
    step = t[1] - t[0]
    slope = 2.0 * np.pi * height * np.sin(2.0 * t) * np.sqrt(np.maximum(1.0 - np.sin(b) ** 2 / np.sin(t) ** 2, 0.0))
    gap = (np.cumsum(slope) - 0.5 * slope) * step / np.pi
    mean, cube = (float(np.sum(gap**power)) * step * 2.0 / np.pi for power in (1, 3))
    assert found.mean_gap == pytest.approx(mean, rel=2e-3)
    assert found.leak_rate == pytest.approx(3.0 / (12.0 * 0.5) * cube, rel=2e-3)
    assert found.flow_factor == pytest.approx(cube / mean**3, rel=5e-3)
    assert found.critical_gap == pytest.approx(float(gap[-1]), rel=2e-3)
    assert found.lateral_leak_rate == found.lateral_critical_gap == found.lateral_flow_factor == 0.0
    assert found.leak_rate_error < 0.02 * found.leak_rate


def test_turned_maps_and_loads():
    contact = SurfaceContact(rough(), STEEL, Force([30.0, 300.0]))
    found = Seal(contact, 1e-3, 1e5).solve()
    turned = Topography(contact.topography.heights.T, [1e-3, 1e-3], periodic=True)
    across = Seal(SurfaceContact(turned, STEEL, Force(300.0)), 2e-3, 1e5).solve()
    assert found.leak_rate.shape == (2,)
    assert found.leak_rate[0] > found.leak_rate[1] > 0.0
    assert across.leak_rate == pytest.approx(0.5 * found.lateral_leak_rate[1], rel=1e-4)
    assert across.lateral_flow_factor == pytest.approx(found.flow_factor[1], rel=1e-4)
    assert across.lateral_critical_gap == pytest.approx(found.critical_gap[1], rel=1e-4)
    assert np.all(found.imbalance < 1e-12)
    # between the bounds of all networks
    gap = np.where(found.contact.last.pressure > 0.0, 0.0, found.contact.last.separation)
    assert found.leak_rate[1] < 1e5 / 12e-3 * np.mean(gap**3)
    assert found.leak_rate[1] == pytest.approx(found.medium_leak_rate[1], rel=0.35)
    pressure = found.fluid_pressure()
    assert 0.0 <= np.nanmin(pressure) < np.nanmax(pressure) <= 1e5
    np.testing.assert_allclose(1e5 / 12e-3 * found.last_flow().along.sum(axis=1), found.leak_rate[1], rtol=1e-10)
    place = found.last_passage().way.place
    assert gap[place] == found.critical_gap[1]


def test_a_tight_seal_says_so():
    found = Seal(SurfaceContact(rough(), STEEL, Force([30.0, 20e3])), 1e-3, 1e5).solve()
    assert found.leak_rate[1] == found.critical_gap[1] == found.flow_factor[1] == 0.0
    assert any("1 of 2 loads no path" in note.statement for note in found.validity)


def test_fluid_that_would_lift_the_body_is_flagged():
    contact = SurfaceContact(rough(), STEEL, Force(30.0))
    notes = {drop: Seal(contact, 1e-3, drop).solve().validity for drop in (1e5, 1e8)}
    standing = {
        drop: next(note.standing for note in found if note.assumption is Assumption.EQUILIBRIUM)
        for drop, found in notes.items()
    }
    assert standing == {1e5: Standing.ASYMPTOTIC, 1e8: Standing.OUTSIDE}


def test_a_map_that_stands_alone_has_closed_sides():
    x = np.linspace(-1.0, 1.0, 32)
    stamp = Topography(-0.1 * np.abs(x)[None, :] - 1e-3 * np.abs(x)[:, None], [1.0, 1.0])
    found = Seal(SurfaceContact(stamp, UNIT, Depth(1e-3)), 1.0, 1.0).solve()
    assert any("closed" in note.statement for note in found.validity)
    assert found.leak_rate > 0.0


@pytest.mark.parametrize(
    ("contact", "words"),
    [
        (lambda: SurfaceContact(rough(count=63), STEEL, Force(1.0)), "even numbers"),
        (lambda: SurfaceContact(Topography(np.eye(4), [1.0, 1.0]), STEEL, Force(1.0)), "every second point"),
        (lambda: SurfaceContact(Topography([[1.0]], [1.0, 1.0]), STEEL, Force(1.0)), "2 x 2"),
        (lambda: SurfaceContact(Topography(np.full((8, 8), np.nan), [1.0, 1.0]), STEEL, Force(1.0)), "missing"),
    ],
)
def test_bad_maps_get_one_sentence(contact, words):
    with pytest.raises(InvalidInput, match=words) as caught:
        Seal(contact(), 1e-3, 1e5)
    assert "\n" not in str(caught.value)


def test_bad_numbers_and_rough_pixels():
    contact = SurfaceContact(rough(), STEEL, Force(1.0))
    for numbers in ((0.0, 1e5), (1e-3, -1.0), (np.nan, 1.0)):
        with pytest.raises(InvalidInput, match="positive"):
            Seal(contact, *numbers)
    i, j = np.indices((16, 16))
    chess = Topography(1e-6 * ((i % 2) | (j % 2)), [1e-3, 1e-3], periodic=True)
    with pytest.raises(InvalidInput, match="one pixel wide"):
        Seal(SurfaceContact(chess, STEEL, Force(1.0)), 1e-3, 1e5).solve()
    with pytest.raises(OutsideValidity, match="closes"):
        Seal(SurfaceContact(rough(), STEEL, Depth(1.0)), 1e-3, 1e5)


@pytest.mark.slow
def test_seals_close_at_some_forty_per_cent_of_contact():
    """0.415: A. Wang, M. H. Mueser, Tribol. Lett. 68 (2020) 95, doi:10.1007/s11249-020-01378-7.

    Of large isotropic surfaces; small ones scatter.
    """
    spectrum = SelfAffine(0.8, 1e-6, 1e-3, 6.2e-5, roll_off=2.5e-4)  # eight pixels to the shortest wave
    shares = []
    for seed in range(4):
        surface = random_topography(spectrum, (128, 128), [1e-3, 1e-3], seed=seed)
        loads = 1e-6 * STEEL.modulus * surface.rms_slope * np.array([0.18, 0.22, 0.24, 0.26, 0.28, 0.3, 0.33, 0.36])
        found = Seal(SurfaceContact(surface, STEEL, Force(loads), tolerance=1e-4), 1e-3, 1e5).solve()
        for leak in (found.leak_rate, found.lateral_leak_rate):
            tight = np.flatnonzero(leak == 0.0)
            assert tight.size
            assert tight[0] > 0
            shares.append(0.5 * (found.area[tight[0] - 1] + found.area[tight[0]]) / surface.area)
    assert np.mean(shares) == pytest.approx(0.415, abs=0.03)


def test_between_which_shares_a_seal_closes():
    """Isotropic maps close near 0.42 of contact: between two loads, whose shares of contact are stated."""
    found = Seal(SurfaceContact(rough(), STEEL, Force([300.0, 1000.0, 3000.0])), 1e-3, 1e5).solve()
    open_share, closed_share = found.closing_share()
    shares = np.asarray(found.area) / 1e-6
    assert open_share == max(shares[np.asarray(found.leak_rate) > 0.0])
    assert closed_share == min(shares[np.asarray(found.leak_rate) == 0.0])
    assert 0.2 < open_share < closed_share < 0.6
    always = Seal(SurfaceContact(rough(), STEEL, Force(30.0)), 1e-3, 1e5).solve()
    assert always.closing_share()[1] == 1.0
