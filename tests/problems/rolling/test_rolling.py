"""Steady rolling on a line: the cubic law, Kalker's slopes, CONTACT's curves, other profiles, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from winkler.foundation.foundation import Foundation
from winkler.foundation.plane import PlaneFoundation
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Depth, Force, Radius
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.normal.indentation import Indentation
from winkler.problems.rolling.calibration import Kalker, Uncalibrated
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.rolling.kalker import creep_coefficients, rolling_pair
from winkler.problems.rolling.steady import Rolling
from winkler.profiles.conical import Cone
from winkler.profiles.flat import FlatPunch
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.profile import Sum
from winkler.profiles.sphere import Sphere
from winkler.profiles.wavy import Wavy
from winkler.reference.rolling import cubic_creep_force
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

MU = 0.3
FRICTION = Coulomb(MU)
CONTACT = Path(__file__).parents[3] / "examples" / "data" / "contact_creep_circle.csv"


def ball(poisson: float = 0.25, profile=None) -> Foundation:
    """A body on its like, modulus of shear 1 Pa."""
    solid = Elastic(2.0 * (1.0 + poisson), poisson)
    return Foundation(profile or Paraboloid(1.0), HalfSpace.between(solid, solid))


def curve(mode: str, poisson: float, cells: int) -> np.ndarray:
    """CONTACT's creepages, F_x, F_y and M_z, one row each."""
    lines = CONTACT.read_text().splitlines()
    rows = [line.split(",") for line in lines if line.startswith(f"{mode},{poisson:g},{cells},")]
    return np.array([[float(number) for number in row[3:]] for row in rows]).T


def brute_force(bound, rate: float, radius: float, count: int = 40_001) -> tuple[float, np.ndarray, np.ndarray]:
    """March from the leading edge, spring after spring: the force, and what each bears."""
    x = np.linspace(radius, -radius, count)
    most = bound(np.abs(x))
    step = x[0] - x[1]
    load, now = np.zeros(count), 0.0
    for k in range(1, count):
        now = min(now + rate * step, most[k])
        load[k] = now
    return float(np.sum(0.5 * (load[1:] + load[:-1])) * step), x, load


def slack(bed: Foundation, radius: float) -> tuple[float, float]:
    contact = Indentation(bed, Radius(radius)).solve()
    return float(contact.force), float(contact.depth)


class TestBall:
    @pytest.mark.parametrize("calibration", [Kalker(), Uncalibrated()])
    @pytest.mark.parametrize("poisson", [0.0, 0.25, 0.5])
    def test_follows_the_cubic_law(self, calibration, poisson):
        bed = ball(poisson)
        force, _ = slack(bed, 0.01)
        stiffness = calibration.stiffness(bed, 0.01)
        tau = np.linspace(-4.0, 4.0, 161)
        for word, kappa in zip(("longitudinal", "lateral"), stiffness, strict=True):
            creepage = Creepage(**{word: tau * MU * force / (2.0 * kappa * 0.01**2)})
            rolled = Rolling(bed, FRICTION, creepage, Radius(0.01), calibration).solve()
            ratio = getattr(rolled, f"{word}_force") / (MU * force)
            np.testing.assert_allclose(ratio, cubic_creep_force(tau), atol=2e-15)
            # at tau = 3 itself sticking springs touch the bound: a double root, known to the root of rounding
            wanted, touches = np.clip(1.0 - np.abs(tau) / 3.0, 0.0, 1.0), np.isclose(np.abs(tau), 3.0)
            np.testing.assert_allclose(rolled.stick_share[~touches], wanted[~touches], atol=1e-12)
            assert np.max(rolled.stick_share[touches]) < 1e-7

    def test_begins_as_kalker_wants(self):
        bed = ball(0.5)
        known = creep_coefficients(1.0, 0.5)
        small = Creepage(longitudinal=1e-12, lateral=1e-12)
        rolled = Rolling(bed, FRICTION, small, Radius(0.01)).solve()
        assert rolled.longitudinal_force == pytest.approx(known.longitudinal * 0.01**2 * 1e-12, rel=1e-6)
        assert rolled.lateral_force == pytest.approx(known.lateral * 0.01**2 * 1e-12, rel=1e-6)

    @pytest.mark.parametrize(
        ("poisson", "along", "across"), [(0.0, 0.588, 0.588), (0.25, 0.555, 0.623), (0.5, 0.513, 0.670)]
    )
    def test_is_too_soft_without_calibration(self, poisson, along, across):
        bed = ball(poisson)
        raw = Uncalibrated().stiffness(bed, 0.01)[0]
        wanted = Kalker().stiffness(bed, 0.01)
        assert raw / wanted[0] == pytest.approx(along, abs=6e-4)
        assert raw / wanted[1] == pytest.approx(across, abs=6e-4)
        assert raw == pytest.approx(2.0 / (2.0 - poisson), rel=1e-14)

    @pytest.mark.parametrize(
        ("mode", "poisson", "cells", "apart", "raw"),
        [
            ("longitudinal", 0.0, 96, 0.024, 0.255),
            ("longitudinal", 0.25, 96, 0.0265, 0.281),
            ("lateral", 0.0, 48, 0.0285, 0.26),
        ],
    )
    def test_distance_from_contact(self, mode, poisson, cells, apart, raw):
        """CONTACT on 48 cells is itself 0.4 % of mu F_N off its finer grid."""
        bed = ball(poisson)
        force, _ = slack(bed, 0.01)
        u, *forces = curve(mode, poisson, cells)
        assert u.size > 20
        creepage = Creepage(**{mode: u * MU * force / 0.01**2})
        for calibration, most in ((Kalker(), apart), (Uncalibrated(), raw)):
            rolled = Rolling(bed, FRICTION, creepage, Radius(0.01), calibration).solve()
            off = np.hypot(
                rolled.longitudinal_force / (MU * force) - forces[0], rolled.lateral_force / (MU * force) - forces[1]
            )
            assert 0.5 * most < np.max(off) < most

    def test_both_creepages_together(self):
        bed = ball(0.3)
        force, _ = slack(bed, 0.01)
        along, across = Kalker().stiffness(bed, 0.01)
        xi, eta = np.meshgrid(np.linspace(-2.0, 2.0, 9), np.linspace(-2.0, 2.0, 9))
        unit = MU * force / (2.0 * 0.01**2)
        rolled = Rolling(bed, FRICTION, Creepage(xi * unit / along, eta * unit / across), Radius(0.01)).solve()
        np.testing.assert_allclose(rolled.saturation, cubic_creep_force(np.hypot(xi, eta)), atol=1e-14)
        np.testing.assert_allclose(rolled.longitudinal_force * eta, rolled.lateral_force * xi, atol=1e-14 * MU * force)
        assert np.min(rolled.loss_per_distance) >= 0.0
        np.testing.assert_array_equal(rolled.longitudinal_force, -rolled.longitudinal_force[::-1, ::-1])

    def test_a_locked_wheel(self):
        """However fast it slips, it drags with what friction bears."""
        rolled = Rolling(ball(), FRICTION, Creepage([1e9, 0.0], [0.0, -1e9]), Radius(0.01)).solve()
        np.testing.assert_allclose(rolled.saturation, 1.0, rtol=1e-12)
        np.testing.assert_allclose(rolled.stick_share, 0.0, atol=1e-9)

    def test_no_creepage_no_force(self):
        rolled = Rolling(ball(), FRICTION, Creepage(), Radius(0.01)).solve()
        assert (rolled.longitudinal_force, rolled.lateral_force, rolled.stick_share) == (0.0, 0.0, 1.0)
        assert rolled.loss_per_distance == 0.0

    def test_scales(self):
        """Lengths twice, moduli three times: the same share at the same creepage."""
        small = Rolling(ball(), FRICTION, Creepage(1e-3, 5e-4), Depth(1e-4)).solve()
        solid = Elastic(7.5, 0.25)
        bed = Foundation(Paraboloid(2.0), HalfSpace.between(solid, solid))
        large = Rolling(bed, FRICTION, Creepage(1e-3, 5e-4), Depth(2e-4)).solve()
        assert large.longitudinal_force == pytest.approx(12.0 * small.longitudinal_force, rel=1e-12)
        assert large.lateral_force == pytest.approx(12.0 * small.lateral_force, rel=1e-12)


class TestProfiles:
    @pytest.mark.parametrize("share", [0.05, 0.3, 0.7, 0.95])
    @pytest.mark.parametrize("profile", [Cone(half_angle=1.5), Sphere(curvature_radius=0.02), Paraboloid(1.0)])
    def test_any_convex_profile_against_a_march(self, profile, share):
        bed = ball(0.25, profile)
        _, depth = slack(bed, 0.01)
        kappa = Uncalibrated().stiffness(bed, 0.01)[0]
        slope = float(bed.gap_slope(np.array([0.01]))[0])
        creepage = share * MU * bed.medium.modulus * slope / kappa
        rolled = Rolling(bed, FRICTION, Creepage(creepage), Radius(0.01), Uncalibrated()).solve()
        wanted, x, load = brute_force(lambda r: MU * bed.medium.modulus * (depth - bed.gap(r)), kappa * creepage, 0.01)
        assert rolled.longitudinal_force == pytest.approx(wanted, rel=1e-7)
        np.testing.assert_allclose(rolled.shear_load(x), load, atol=2e-4 * np.max(load))

    @pytest.mark.parametrize("creepage", [0.002, 0.01, 0.02, 0.03, 0.05, 0.1])
    def test_springs_that_stick_again(self, creepage):
        """A wavy ball: behind each crest the bound may grow faster than sticking springs are stretched."""
        bed = ball(0.25, Sum([Paraboloid(1.0), Wavy(amplitude=2e-6, wavelength=3e-3)]))
        _, depth = slack(bed, 0.01)
        kappa = Kalker().stiffness(bed, 0.01)[0]
        wanted, x, load = brute_force(lambda r: MU * bed.medium.modulus * (depth - bed.gap(r)), kappa * creepage, 0.01)
        rolled = Rolling(bed, FRICTION, Creepage(creepage), Radius(0.01)).solve()
        assert rolled.longitudinal_force == pytest.approx(wanted, rel=2e-6)
        np.testing.assert_allclose(rolled.shear_load(x), load, atol=2e-3 * np.max(load))
        sticks = load < MU * bed.medium.modulus * (depth - bed.gap(np.abs(x))) * (1.0 - 1e-9)
        assert rolled.stick_share == pytest.approx(np.mean(sticks), abs=2e-3)

    def test_a_flat_punch(self):
        """The bound is the same everywhere: q = min(kappa s (a - x), mu E* d)."""
        bed = ball(0.25, FlatPunch(radius=0.01))
        kappa, bound = Kalker().stiffness(bed, 0.01)[0], MU * bed.medium.modulus * 1e-5
        force = bound * 0.02
        for share in (0.2, 1.0, 5.0):
            s = share * bound / (kappa * 0.02)
            rolled = Rolling(bed, FRICTION, Creepage(s), Depth(1e-5)).solve()
            wanted = 0.5 * share if share <= 1.0 else 1.0 - 0.5 / share
            assert rolled.longitudinal_force == pytest.approx(wanted * force, rel=1e-12)

    def test_a_plane_profile(self):
        """g = x^2 / R is what a paraboloid comes to."""
        bed = ball()
        line = PlaneFoundation(PowerLaw(1.0, 2.0), bed.medium)
        given, built = (Rolling(b, FRICTION, Creepage(1e-3), Radius(0.01)).solve() for b in (line, bed))
        assert given.longitudinal_force == pytest.approx(built.longitudinal_force, rel=1e-13)

    def test_what_is_not_hertzian_is_labelled(self):
        notes = Rolling(ball(0.25, Cone(half_angle=1.5)), FRICTION, Creepage(1e-3), Radius(0.01)).solve().validity
        assert any("not Hertzian" in note.statement for note in notes)
        notes = Rolling(ball(), FRICTION, Creepage(1e-3), Radius(0.01)).solve().validity
        assert any("0.04 mu F_N" in note.statement for note in notes)
        notes = Rolling(ball(), FRICTION, Creepage(1e-3, 1e-3), Radius(0.01), Uncalibrated()).solve().validity
        assert any(note.standing is Standing.OUTSIDE and "49 %" in note.statement for note in notes)
        assert any("keeps the direction" in note.statement for note in notes)


class TestRefused:
    def test_spin(self):
        with pytest.raises(OutsideValidity, match="no counterpart"):
            Rolling(ball(), FRICTION, Creepage(1e-3, spin=0.1), Radius(0.01))

    @pytest.mark.parametrize("friction", [Coulomb(0.0), Coulomb(np.inf), "dry"])
    def test_friction(self, friction):
        with pytest.raises(InvalidInput, match="positive, finite coefficient"):
            Rolling(ball(), friction, Creepage(1e-3), Radius(0.01))

    @pytest.mark.parametrize("load", [Force([1.0, 2.0]), 3.0])
    def test_loads(self, load):
        with pytest.raises(InvalidInput, match="one number"):
            Rolling(ball(), FRICTION, Creepage(1e-3), load)

    def test_apart(self):
        with pytest.raises(OutsideValidity, match="do not touch"):
            Rolling(ball(), FRICTION, Creepage(1e-3), Depth(-1e-6)).solve()

    def test_arrays_where_one_is_drawn(self):
        rolled = Rolling(ball(), FRICTION, Creepage([1e-3, 2e-3]), Radius(0.01)).solve()
        with pytest.raises(InvalidInput, match="one creepage"):
            rolled.shear_load(np.zeros(3))

    @pytest.mark.parametrize(
        "creepage",
        [
            {"longitudinal": np.nan},
            {"longitudinal": 1e10},
            {"lateral": "fast"},
            {"spin": []},
            {"longitudinal": [1.0, 2.0], "lateral": [1.0] * 3},
        ],
    )
    def test_creepages(self, creepage):
        with pytest.raises(InvalidInput, match="Creepage"):
            Creepage(**creepage)


class TestKalker:
    def test_the_pair_of_a_rigid_body(self):
        """One body on a rigid one is twice as stiff as two of it."""
        solid = Elastic(2.5, 0.25)
        assert rolling_pair(HalfSpace.between(solid)).shear == pytest.approx(2.0)
        assert rolling_pair(HalfSpace.between(solid)).poisson == pytest.approx(0.25)

    def test_prints_its_own_entries(self):
        assert creep_coefficients(0.3, 0.25).lateral == pytest.approx(2.75, rel=1e-14)
        assert creep_coefficients(1.0 / 0.3, 0.5).spin == pytest.approx(5.01, rel=1e-12)
        assert creep_coefficients(1.0, 0.0).longitudinal == pytest.approx(3.40, rel=1e-14)
        assert creep_coefficients(10.0, 0.0).spin == pytest.approx(12.2, rel=1e-12)

    def test_is_continuous_through_the_circle(self):
        before, after = creep_coefficients(1.0 - 1e-12, 0.3), creep_coefficients(1.0 + 1e-12, 0.3)
        assert before.spin == pytest.approx(after.spin, rel=1e-10)

    @pytest.mark.parametrize(
        ("ratio", "poisson", "known"),
        [
            (1.0, 0.3, (4.318, 3.752, 1.508)),
            (0.2, 0.25, (3.404, 2.656, 0.610)),
            (0.5, 0.25, (3.657, 3.041, 0.939)),
            (2.0, 0.25, (5.151, 4.964, 2.659)),
        ],
    )
    def test_against_contact(self, ratio, poisson, known):
        """CONTACT on its finest grids lies 0.4 to 1.5 % above the table."""
        result = creep_coefficients(ratio, poisson)
        assert (result.longitudinal, result.lateral, result.spin) == pytest.approx(known, rel=0.02)

    @pytest.mark.parametrize(("ratio", "poisson"), [(0.09, 0.3), (10.1, 0.3), (1.0, -0.1), (1.0, 0.51), (np.nan, 0.3)])
    def test_ends_with_the_table(self, ratio, poisson):
        with pytest.raises(OutsideValidity, match="Kalker's table"):
            creep_coefficients(ratio, poisson)
