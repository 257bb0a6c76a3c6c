"""A poroelastic film: against Biot's equations at 30 digits, elastic films, Terzaghi, and a punch in Laplace space."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp, mpc, mpf

import winkler as wk
from winkler.media.relaxing.poroelastic_waves import drained_waves, film_creep, undrained_waves
from winkler.values.errors import InvalidInput, OutsideValidity

BALL = wk.Paraboloid(1.0)
RELAXING = wk.StandardSolid(relaxed_shear=1.0, shear=3.0, relaxation_time=1.0, poisson=0.3)


def bed(film, shape=BALL):
    return wk.Foundation(shape, film)


def through_the_depth(rate, x, poisson):
    """Return c G by the exponential of Biot's equations as a system of first order, from the base to the surface.

    For displacements W (outward) and U, total tractions S and T, pore pressure P and its slope, G = h = D = 1.
    """
    k, nu, q = mpf(x), mpf(poisson), mpc(rate)
    stiff = 2 * (1 - nu) / (1 - 2 * nu)
    side = stiff - 2
    rows = mp.zeros(6)
    rows[0, 1], rows[0, 2], rows[0, 4] = -side * k / stiff, 1 / stiff, 1 / stiff
    rows[1, 0], rows[1, 3] = k, 1
    rows[2, 3] = -k
    widened = rows[0, :].copy()  # the dilatation
    widened[0, 1] += k
    rows[3, :] = k * side * widened
    rows[3, 1] += 2 * k * k
    rows[3, 4] -= k
    rows[4, 5] = 1
    rows[5, :] = q * stiff * widened
    rows[5, 4] += k * k
    through = mp.expm(rows, method="taylor")
    free = [2, 3, 4]  # tractions and pressure of the base
    system = mp.matrix([[through[i, j] for j in free] for i in (2, 3, 4)])
    found = mp.lu_solve(system, mp.matrix([-1, 0, 0]))
    return complex(-k / 2 * sum(through[0, j] * found[n] for n, j in enumerate(free)))


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("poisson", [-0.5, 0.0, 0.3, 0.49])
def test_waves_are_those_of_biot_to_eleven_digits(poisson):
    with mp.workdps(60):
        for x in (1e-3, 0.3, 1.7, 19.0):
            for rate in (1e-7j, 0.2j, 3.0 + 1.0j, 400j):
                known = through_the_depth(rate, x, poisson)
                found = drained_waves(np.array([rate]), np.array([x]), poisson)[0]
                assert found == pytest.approx(known, rel=1e-11), (x, rate)
        known = through_the_depth(1e-40, 0.7, poisson)
        assert drained_waves(np.zeros(1, dtype=complex), np.array([0.7]), poisson)[0] == pytest.approx(known)


def test_waves_of_elastic_films_without_end_and_of_half_spaces():
    x = np.array([1e-3, 0.1, 1.0, 3.0, 15.0, 30.0])
    for found, poisson in ((undrained_waves(x), 0.5), (drained_waves(np.zeros(1, dtype=complex), x, 0.2).real, 0.2)):
        film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(2.0 * (1.0 + poisson), poisson), 1.0)], on=wk.Rigid())
        elastic = film.response.whole(x.astype(complex)).real / film.response.modulus
        assert found == pytest.approx(elastic, rel=1e-10)
    # Terzaghi's consolidation under a wave without end, at rates for which it is deep and shallow
    rates = np.array([1e-3, 1.0, 30.0, 1e4]) * 1j
    uniaxial = 2.0 * 0.8 / 0.6
    consolidated = 0.5e-9 / uniaxial * np.tanh(np.sqrt(rates)) / np.sqrt(rates)
    assert drained_waves(rates, np.array([1e-9]), 0.2) == pytest.approx(consolidated, rel=1e-11)
    # McNamee and Gibson's half-space: K = eta (m + k) / (eta (m + k) - k)
    deep = np.array([18.0, 24.0, 1e3])
    both = 0.5 * uniaxial * (np.sqrt(deep**2 + 700j) + deep)
    found = drained_waves(np.array([700j]), deep, 0.2)
    assert found == pytest.approx(0.25 * both / (both - deep), rel=1e-11)


@pytest.mark.parametrize("octave", [-30, -8, 0, 4])
def test_creep_of_waves_is_terzaghis(octave):
    """At times of diffusion beyond a quarter of a cell; at first waves are those of the incompressible film."""
    creep, width = film_creep(0.3, octave, False), 2.0**octave
    assert creep.error < 1e-6
    x = np.array([1e-6, 1e-3])
    time = np.maximum(np.array([0.01, 0.1, 1.0]), 0.25 * width**2)
    odd = (np.arange(200) + 0.5) ** 2 * math.pi**2
    share = 1.0 - 2.0 * np.exp(-np.outer(time, odd)) @ (1.0 / odd)
    uniaxial = 2.0 * 0.7 / 0.4
    assert creep.after(x, time) == pytest.approx(0.5 * x[:, None] / uniaxial * share, rel=2e-4)
    waves = np.array([0.1, 1.0, 3.0])
    assert creep.after(waves, np.zeros(1))[:, 0] == pytest.approx(undrained_waves(waves), rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("thickness", [0.03, pytest.param(10.0, marks=pytest.mark.slow)])
def test_at_first_the_film_is_incompressible_and_at_last_the_drained_network(thickness):
    """Under a body that relaxes from 4 to 1."""
    film = wk.PoroelasticFilm(2.0, 0.2, diffusivity=3.0, thickness=thickness, second=wk.StandardSolid(1.0, 3.0, 1e-3))
    found = wk.RelaxationTest(bed(film), 5e-3, [1e-14, 1e6]).solve()
    for at, stack in ((0, film.glassy), (1, film.relaxed)):
        elastic = wk.Indentation(bed(stack), wk.Depth(5e-3)).solve()
        assert found.force[at] == pytest.approx(elastic.force, rel=1e-4)
        assert found.radius[at] == pytest.approx(elastic.radius, rel=1e-3)


@pytest.mark.slow
def test_a_film_far_thinner_than_the_contact_consolidates_as_terzaghi_says():
    """F = pi R M d^2 / h (1 + 2 sum exp(-n^2 pi^2 D t / h^2)); what flows sideways counts like (h / a)^2."""
    h, d, diffusivity = 1e-4, 1e-4, 1e-8
    film = wk.PoroelasticFilm(1.0, 0.2, diffusivity, h)
    time = np.array([1e-4, 1e-3, 0.03, 0.1, 0.3, 1.0]) * film.diffusion_time
    found = wk.RelaxationTest(bed(film), d, time).solve()
    decay = np.exp(-np.outer(time / film.diffusion_time, (np.pi * np.arange(1, 400)) ** 2)).sum(axis=1)
    uniaxial = 2.0 * 0.8 / 0.6
    wanted = np.pi * uniaxial * d**2 / h * (1.0 + 2.0 * decay)
    assert found.force[2:] == pytest.approx(wanted[2:], rel=4e-4)
    assert found.force[:2] / wanted[:2] - 1.0 == pytest.approx([0.03, 0.003], rel=0.2)  # as its note states


def punch_forces(waves, local, time, second, count=160):
    """Return the force of a flat punch, a = d = G = D = 1, held from t = 0 on, by Fredholm's equation in Laplace space.

    `waves` is c(s, xi), `local` its limit for short waves, `second` is added to both; inverted by Abate and Whitt's.
    """
    node, weight = np.polynomial.legendre.leggauss(10)
    edges = np.concatenate([[0.0], np.geomspace(1e-3, 2.0, 12), np.geomspace(2.0, 4e3, 250)[1:]])
    xi = (0.5 * np.diff(edges)[:, None] * (node + 1.0) + edges[:-1, None]).ravel()
    w = (0.5 * np.diff(edges)[:, None] * weight).ravel()
    x = (np.arange(count) + 0.5) / count
    cosines = np.cos(np.outer(xi, x))
    forces = []
    for t in time:
        terms = []
        for number in range(30):
            s = (9.2 + 1j * np.pi * number) / t
            matrix = (cosines.T * (w * (waves(s, xi) - local))) @ cosines * (2.0 / np.pi / count)
            matrix += (local + second(s)) * np.eye(count)
            borne = 2.0 / count * np.linalg.solve(matrix, np.ones(count)).sum() / s
            terms.append((-1.0) ** number * borne.real / (1.0 if number else 2.0))
        sums = math.exp(9.2) / t * np.cumsum(terms)
        forces.append(sum(math.comb(11, j) * sums[18 + j] for j in range(12)) / 2.0**11)
    return np.array(forces)


@pytest.mark.slow
@pytest.mark.parametrize(("thickness", "second"), [(1.0, wk.Rigid()), (2e5, wk.Rigid()), (1.0, RELAXING)])
def test_a_flat_punch_relaxes_as_in_laplace_space(thickness, second):
    """On a film as thick as the punch is wide, and on one so thick that it is McNamee and Gibson's half-space.

    Below a body that relaxes, (1 - nu) / (2 G(s)) is added to all waves.
    """
    poisson = 0.3
    time = np.array([0.01, 0.05, 0.2, 1.0, 5.0])

    def film_waves(s, xi):
        return drained_waves(np.array([s]) * thickness**2, xi * thickness, poisson)

    def half_space(s, xi):
        both = (1.0 - poisson) / (1.0 - 2.0 * poisson) * (np.sqrt(xi**2 + s) + xi)
        return 0.25 * both / (both - xi)

    waves = film_waves if thickness == 1.0 else half_space

    def crept(s):
        return 0.5 * (1.0 - 0.3) / (1.0 + 3.0 * s / (1.0 + s)) if second == RELAXING else 0.0

    film = wk.PoroelasticFilm(1.0, poisson, 1.0, thickness, second)
    found = wk.RelaxationTest(bed(film, wk.FlatPunch(1.0)), 1.0, time).solve()
    assert found.force == pytest.approx(punch_forces(waves, 0.5 * (1.0 - poisson), time, crept), rel=1e-4)


FILM = wk.PoroelasticFilm(1.0, 0.2, 1.0, 0.1)
"""About as thick as contacts are wide."""


@pytest.mark.slow
def test_cells_and_steps_converge_with_the_square_of_the_count():
    times = [0.0, *np.linspace(1e-4, 1e-2, 9), 0.02, 0.1]
    depths = [0.0, *np.linspace(1e-4, 1e-2, 9), 1e-2, 4e-3]
    path = wk.Path(times, wk.Depth(depths))
    forces = [wk.ViscoelasticIndentation(bed(FILM), path, count=count).solve().force for count in (50, 100, 200, 400)]
    changes = [np.max(np.abs(one - other)) / np.max(other) for one, other in zip(forces[:-1], forces[1:], strict=True)]
    assert changes[0] > 3.0 * changes[1] > 9.0 * changes[2]
    assert changes[2] < 1e-4


@pytest.mark.slow
def test_work_is_stored_or_lost_and_the_notes_state_what_is_assumed():
    path = wk.Path([0.0, 1e-3, 2e-2, 3e-2], wk.Depth([0.0, 1e-2, 1e-2, 7e-3]))
    found = wk.ViscoelasticIndentation(bed(FILM), path, count=100).solve()
    left = found.work - found.stored_energy - found.dissipation
    assert np.max(np.abs(left)) < 2e-3 * np.max(found.work)
    assert found.dissipation[-1] > 0.1 * np.max(found.work)
    notes = [note.statement for note in found.validity]
    assert any("Liquid passes freely through the surface" in note for note in notes)
    state = list(found.problem.steps())[2]
    assert state.pressure([0.0])[0] > 0.0
    with pytest.raises(OutsideValidity, match="on a PoroelasticFilm the pressure is restored alone"):
        _ = state.pressed


@pytest.mark.slow
def test_under_a_force_and_shaken_it_goes_from_one_elastic_film_to_the_other():
    sunk = wk.CreepTest(bed(FILM), 0.05, [1e-12, 1e4]).solve()
    for at, stack in ((0, FILM.glassy), (1, FILM.relaxed)):
        assert sunk.depth[at] == pytest.approx(wk.Indentation(bed(stack), wk.Force(0.05)).solve().depth, rel=1e-4)
    shaken = wk.HarmonicIndentation(bed(FILM), wk.Depth(5e-3), [1e-6, 1e2, 1e15]).solve()
    for at, stack in ((0, FILM.relaxed), (2, FILM.glassy)):
        punch = stack.punch_stiffness(np.array([shaken.radius]))[0]
        assert shaken.storage_stiffness[at] == pytest.approx(punch, rel=1e-4)
        assert abs(shaken.loss_stiffness[at]) < 1e-3 * punch
    assert shaken.loss_tangent[1] > 0.1


@pytest.mark.slow
def test_adhesion_takes_the_film_as_drained():
    law, path = wk.RateDependentWork(1e-4, 1e-6, 0.5), wk.Path([0.0, 1e3], wk.Depth([1e-3, 5e-4]))
    one, other = (wk.ViscoelasticAdhesion(bed(medium), law, path).solve() for medium in (FILM, FILM.relaxed))
    assert one.force == pytest.approx(other.force, rel=1e-12)


def test_what_does_not_fit_is_refused():
    for wrong in (
        {"poisson": 0.5},
        {"poisson": -1.0},
        {"diffusivity": 0.0},
        {"diffusivity": -1e-9},
        {"shear": 0.0},
        {"thickness": 0.0},
    ):
        with pytest.raises(InvalidInput, match=f"PoroelasticFilm: {next(iter(wrong))}"):
            wk.PoroelasticFilm(**{"shear": 1e3, "poisson": 0.3, "diffusivity": 1e-9, "thickness": 1e-4, **wrong})
    with pytest.raises(OutsideValidity, match="tangential forces is not implemented"):
        wk.FrictionDamping(bed(FILM), wk.Coulomb(0.3), wk.Depth(1e-3), wk.Shift(1e-6), frequency=1.0)
    with pytest.raises(InvalidInput, match="a PoroelasticFilm needs Foundation"):
        wk.CreepTest(wk.PlaneFoundation(BALL, FILM), 1.0, [1.0])
    with pytest.raises(OutsideValidity, match="PoroelasticFilm: its stiffness and its equivalent profile change"):
        wk.Indentation(bed(FILM), wk.Depth(1e-3)).solve()
