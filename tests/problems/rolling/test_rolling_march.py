"""Rolling that begins, and rolling to and fro: closed forms, exact integrals, the order, and the limit of shakedown."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from scipy.integrate import quad

from winkler.foundation.foundation import Foundation
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Radius, ShearForce
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.normal.indentation import Indentation
from winkler.problems.rolling.calibration import Kalker
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.rolling.oscillating import OscillatingRolling
from winkler.problems.rolling.start import RollingStart
from winkler.profiles.conical import Cone
from winkler.profiles.flat import FlatPunch
from winkler.profiles.power import Paraboloid
from winkler.reference.rolling import first_rolling_force, rocking_limit
from winkler.values.errors import InvalidInput, OutsideValidity

MU, RADIUS = 0.3, 0.01
SOLID = Elastic(2.5, 0.25)
MEDIUM = HalfSpace.between(SOLID, SOLID)
BALL = Foundation(Paraboloid(1.0), MEDIUM)
FORCE = float(Indentation(BALL, Radius(RADIUS)).solve().force)
KAPPA = Kalker().stiffness(BALL, 1.0)[0]
SLIDES = 3.0 * MU * FORCE / (2.0 * KAPPA * RADIUS**2)
"""The creepage from which the ball slides."""


def start(share: float = 0.4, held: float = 0.0, *, bed=BALL, far: float = 3.0, count: int = 400, points: int = 12):
    return RollingStart(
        bed,
        Coulomb(MU),
        Creepage(share * SLIDES),
        Radius(RADIUS),
        far * RADIUS,
        ShearForce(held),
        points=points,
        count=count,
    )


def exact(share: float, held: float, far: float) -> float:
    """The force of a ball after a travel: the bound is concave, so the least along a spring's path is at an end."""
    peak = MU * MEDIUM.modulus * RADIUS**2
    rate = share * SLIDES * KAPPA

    def bound(x):
        return peak * max(1.0 - (x / RADIUS) ** 2, 0.0)

    stuck = peak * (1.0 - (1.0 - held / (MU * FORCE)) ** (2.0 / 3.0))  # Cattaneo: b(0) - b(c)

    def load(x):
        if x + far >= RADIUS:
            return min(bound(x), rate * (RADIUS - x))
        return min(bound(x), min(stuck, bound(x + far)) + rate * far)

    marks = np.clip([RADIUS - far, -far, RADIUS * (2 * share - 1)], -RADIUS, RADIUS)
    edges = np.unique(np.concatenate([np.linspace(-RADIUS, RADIUS, 41), marks]))
    return sum(quad(load, low, high, epsabs=0.0, epsrel=1e-9)[0] for low, high in zip(edges, edges[1:], strict=False))


class TestStart:
    def test_without_slip(self):
        """Friction that bears all but the last springs."""
        begun = dataclasses.replace(start(1e-9), points=30).solve()
        wanted = first_rolling_force(KAPPA, RADIUS, 1e-9 * SLIDES, begun.distance)
        np.testing.assert_allclose(begun.shear_force, wanted, rtol=1e-5, atol=1e-6 * wanted[-1])

    @pytest.mark.parametrize(("share", "held"), [(0.4, 0.0), (0.4, 0.5), (0.1, 0.9), (0.9, 0.3)])
    def test_against_exact_integrals(self, share, held):
        begun = start(share, held * MU * FORCE).solve()
        wanted = [exact(share, held * MU * FORCE, far) for far in begun.distance[1:]]
        np.testing.assert_allclose(begun.shear_force[1:], wanted, rtol=2e-5)
        assert begun.shear_force[0] == pytest.approx(held * MU * FORCE, abs=1e-12 * MU * FORCE)

    def test_becomes_steady_after_one_width(self):
        begun = start(0.4, far=3.0, points=12).solve()
        after = begun.distance >= 2.0 * RADIUS
        assert np.count_nonzero(after) == 5
        np.testing.assert_allclose(begun.shear_force[after], begun.steady.longitudinal_force, rtol=1e-6)
        assert begun.stick_share[-1] == pytest.approx(begun.steady.stick_share, abs=3e-3)
        assert begun.stick_share[0] == pytest.approx(1.0, abs=3e-3)
        # the zone of stick reaches back to -0.2 a, and its springs of the beginning have left after 1.2 a
        settled = begun.distance >= 1.2 * RADIUS
        np.testing.assert_allclose(begun.shear_force[settled], begun.steady.longitudinal_force, rtol=1e-6)
        assert begun.shear_force[4] < 0.99 * begun.shear_force[5]

    def test_forgets_what_was_held_against_it(self):
        begun = start(0.4, -0.8 * MU * FORCE).solve()
        assert begun.shear_force[0] == pytest.approx(-0.8 * MU * FORCE)
        assert np.all(np.diff(begun.shear_force[:6]) > 0.0)
        assert begun.shear_force[-1] == pytest.approx(begun.steady.longitudinal_force, rel=1e-5)

    @pytest.mark.slow
    def test_order(self):
        """The error falls by more than ten for five times as many springs, over several places."""
        fine = start(0.5, 0.3 * MU * FORCE, count=12_800).solve().shear_force
        error = [
            np.sqrt(np.mean((start(0.5, 0.3 * MU * FORCE, count=n).solve().shear_force - fine) ** 2))
            for n in (50, 250, 1250)
        ]
        assert error[1] < error[0] / 10.0
        assert error[2] < error[1] / 10.0

    def test_a_flat_punch_keeps_its_edge(self):
        """Nothing slides: kappa s (2 a X - X^2 / 2), although the bound jumps at both ends."""
        bed = Foundation(FlatPunch(RADIUS), MEDIUM)
        problem = RollingStart(bed, Coulomb(MU), Creepage(1e-6), Radius(RADIUS), 0.03, points=7, count=300)
        problem = dataclasses.replace(problem, load=_depth(1e-3))
        begun = problem.solve()
        np.testing.assert_allclose(
            begun.shear_force, first_rolling_force(KAPPA, RADIUS, 1e-6, begun.distance), rtol=1e-5, atol=1e-15
        )

    @pytest.mark.parametrize("held", [-0.8, 0.0, 0.8])
    def test_loses_energy_all_the_time(self, held):
        """Work of the creep force, less what the springs store more than at rest."""
        begun = start(0.4, held * MU * FORCE, points=60).solve()
        step = begun.distance[1]
        work = 0.4 * SLIDES * np.cumsum(0.5 * (begun.shear_force[1:] + begun.shear_force[:-1])) * step
        stored = np.array([np.trapezoid(state.shear_load**2, state.x) for state in begun.states]) / (2.0 * KAPPA)
        lost = np.concatenate([[0.0], work - (stored[1:] - stored[0])])
        steady = 0.4 * SLIDES * begun.steady.longitudinal_force
        assert np.min(np.diff(lost)) > -1e-4 * steady * step
        assert lost[-1] - lost[-2] == pytest.approx(steady * step, rel=1e-4)

    def test_one_at_a_time(self):
        problem = start(0.4, 0.2 * MU * FORCE, count=100)
        states = list(problem.steps())
        whole = problem.solve()
        assert problem.gathered(states) == whole
        assert whole.states[5].shear_force == whole.shear_force[5]
        assert np.max(np.abs(states[0].shear_load - states[-1].shear_load)) > 0.0

    def test_lateral(self):
        along = start().solve().shear_force
        across, stiff = Kalker().stiffness(BALL, 1.0)[1], KAPPA
        turned = (
            dataclasses.replace(start(), creepage=Creepage(lateral=0.4 * SLIDES * stiff / across)).solve().shear_force
        )
        np.testing.assert_allclose(turned, along, rtol=1e-10, atol=1e-18)

    @pytest.mark.parametrize(
        ("change", "error", "message"),
        [
            ({"distance": 0.0}, InvalidInput, "positive"),
            ({"distance": np.inf}, InvalidInput, "positive"),
            ({"creepage": Creepage([1e-3, 2e-3])}, InvalidInput, "array"),
            ({"creepage": Creepage(spin=1.0)}, OutsideValidity, "no counterpart"),
            ({"start": ShearForce([1.0, 2.0])}, InvalidInput, "one number"),
            ({"points": 0}, InvalidInput, "points"),
            ({"count": 10}, InvalidInput, "count"),
        ],
    )
    def test_refuses(self, change, error, message):
        with pytest.raises(error, match=message):
            dataclasses.replace(start(), **change)

    def test_more_than_friction_bears(self):
        with pytest.raises(OutsideValidity, match="at rest"):
            start(0.4, 1.1 * MU * FORCE).solve()


def _depth(depth: float):
    from winkler.loading.loads import Depth

    return Depth(depth)


def rocked(share: float, *, track: float = 0.2, bed=BALL, cycles: int = 30, count: int = 200) -> OscillatingRolling:
    force = float(Indentation(bed, Radius(RADIUS)).solve().force)
    return OscillatingRolling(
        bed, Coulomb(MU), track * RADIUS, share * MU * force, Radius(RADIUS), cycles=cycles, count=count
    )


class TestRocking:
    def test_the_limit(self):
        for track in (0.01, 0.2, 0.7, 0.999, 1.0, 3.0):
            limit = rocked(0.1, track=track).shakedown_force / (MU * FORCE)
            assert limit == pytest.approx(float(rocking_limit(track)), abs=1e-14)
        assert float(rocking_limit(0.2)) == pytest.approx(0.704, abs=1e-15)

    @pytest.mark.parametrize(("share", "ratchets"), [(0.69, False), (0.71, True)])
    def test_both_sides_of_it(self, share, ratchets):
        solution = rocked(share, cycles=60).solve()
        assert solution.ratchets is ratchets
        steps = np.diff(solution.shift)
        assert np.all(steps > -1e-12 * steps[0])
        if ratchets:
            assert steps[-1] > 0.05 * steps[0] * (0.71 - 0.704)
            assert steps[-1] == pytest.approx(steps[-10], rel=1e-3)
        else:
            assert steps[-1] < 1e-9 * steps[0]

    @pytest.mark.parametrize("count", [100, 400])
    def test_the_simulation_finds_the_limit(self, count):
        """The greatest force under which the last of many cycles adds nothing, by bisection without the closed form."""
        low, high = 0.6, 0.8
        for _ in range(7):
            middle = 0.5 * (low + high)
            solution = rocked(middle, cycles=150, count=count).solve()
            grows = solution.shift_per_cycle > 1e-6 * solution.shift[0]
            low, high = (low, middle) if grows else (middle, high)
        assert 0.5 * (low + high) == pytest.approx(0.704, abs=0.004)

    def test_a_cone(self):
        """F_lim / (mu F_N) = (1 - w)^2: the load of the springs is a triangle."""
        bed = Foundation(Cone(half_angle=1.5), MEDIUM)
        problem = rocked(0.5, track=0.25, bed=bed)
        force = float(Indentation(bed, Radius(RADIUS)).solve().force)
        assert problem.shakedown_force == pytest.approx(0.75**2 * MU * force, rel=1e-12)
        assert not problem.solve().ratchets

    def test_what_is_left_is_borne_by_the_core(self):
        """At rest under the force, springs that leave the contact in a cycle bear only what they gain in it."""
        solution = rocked(0.69, cycles=60).solve()
        state = solution.states[-1]
        inner = np.abs(state.x) < 0.8 * RADIUS
        bound = MU * MEDIUM.modulus * (RADIUS**2 - (np.abs(state.x[inner]) + 0.2 * RADIUS) ** 2)
        assert np.all(state.shear_load[inner] <= bound * (1.0 + 1e-3) + 1e-4 * np.max(bound))
        # one spring stands for a little of both sides of this border
        outside = np.abs(state.x) > 0.81 * RADIUS
        assert np.max(np.abs(state.shear_load[outside])) < 1e-6 * np.max(bound)

    def test_order(self):
        def last(count: int) -> float:
            return rocked(0.75, cycles=8, count=count).solve().shift[-1]

        fine = last(3200)
        error = [abs(last(count) - fine) for count in (50, 200, 800)]
        assert error[1] < error[0] / 6.0
        assert error[2] < error[1] / 6.0

    def test_first_shift_is_cattaneos(self):
        """At rest the springs are those of Mindlin, with the stiffness they were given."""
        solution = rocked(0.5, count=1000, cycles=1).solve()
        wanted = MU * MEDIUM.modulus * RADIUS**2 * (1.0 - 0.5 ** (2.0 / 3.0)) / KAPPA
        assert solution.shift[0] == pytest.approx(wanted, rel=1e-5)

    def test_no_force_nothing_moves(self):
        assert np.all(rocked(0.0, cycles=3).solve().shift == 0.0)

    def test_one_at_a_time(self):
        problem = rocked(0.72, cycles=4, count=50)
        states = list(problem.steps())
        assert problem.gathered(states) == problem.solve()
        assert [state.cycle for state in states] == [0, 1, 2, 3, 4]

    @pytest.mark.parametrize(
        ("change", "message"),
        [
            ({"amplitude": 0.0}, "amplitude"),
            ({"amplitude": np.nan}, "amplitude"),
            ({"shear_force": -1.0}, "shear_force"),
            ({"cycles": 0}, "cycles"),
            ({"count": 5}, "count"),
            ({"friction": Coulomb(0.0)}, "friction"),
        ],
    )
    def test_refuses(self, change, message):
        with pytest.raises(InvalidInput, match=message):
            dataclasses.replace(rocked(0.5), **change)

    def test_more_than_friction_bears(self):
        with pytest.raises(OutsideValidity, match="friction carries"):
            rocked(1.0).solve()
