"""Torsion and partial slip on layers and power laws: another route, limits, tractions, energies, refusals."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from layer_waves import Stack, sliding_disc

import winkler as wk
from winkler.foundation.bed import PressedSprings
from winkler.foundation.torsion_bound import PressedState, twist_bound
from winkler.materials.graded import PowerLawGraded
from winkler.media.twisting.kernels import bound_shape

MU, D = 0.3, 1e-3
SOLID = wk.Elastic(2.6, 0.3)  # G = 1
LAYERS = {"hard": ([(1.0, 0.3, 0.02)], (0.1, 0.3)), "soft": ([(1.0, 0.3, 0.02)], (10.0, 0.3))}
BALL = wk.Paraboloid(1.0)


def coated(name):
    (shear, poisson, thickness), on = LAYERS[name][0][0], LAYERS[name][1]
    layer = wk.Layer(wk.Elastic(2.0 * shear * (1.0 + poisson), poisson), thickness)
    return wk.CoatedHalfSpace([layer], on=wk.Elastic(2.0 * on[0] * (1.0 + on[1]), on[1]))


def pressed(bed, depth=D):
    contact = wk.Indentation(bed, wk.Depth(depth)).solve()
    return contact, float(contact.radius), float(contact.force)


def smooth_pressure(bed, contact):
    """p(r) through its values at 60 places: over sqrt(a^2 - r^2) it is a polynomial of r^2/a^2."""
    a = float(contact.radius)
    place = 0.5 + 0.5 * np.polynomial.chebyshev.chebpts1(60)
    values = bed.medium.pressure(PressedSprings(bed, float(contact.depth), a), a * np.sqrt(place))
    fit = np.polynomial.Chebyshev.fit(place, values / np.sqrt(1.0 - place), 59, domain=[0.0, 1.0])

    def pressure(r):
        inner = np.minimum((r / a) ** 2, 1.0)
        return np.sqrt(1.0 - inner) * fit(inner)

    return pressure


def steady(bed, law, values, lateral):
    time = np.arange(len(values), dtype=float)
    return wk.Path(time, wk.Depth(np.full(time.size, D)), lateral(values)), law


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", LAYERS)
@pytest.mark.parametrize("order", [1, 0])
def test_partial_slip_by_least_energy_inside_the_stick_zone(name, order):
    """A twist (order 1) and a push (order 0): the motion and the load that belong to one stick radius."""
    bed = wk.Foundation(BALL, coated(name))
    contact, a, force = pressed(bed)
    stiffness = bed.medium.punch_torsional_stiffness if order else bed.medium.punch_shear_stiffness
    motion = 0.8 * MU * force * a**order / float(stiffness(np.array([a]))[0])
    path, law = steady(bed, wk.Coulomb(MU), [0.0, motion], wk.Angle if order else wk.Shift)
    found = (wk.Torsion if order else wk.Tangential)(bed, law, path).solve().at(1)
    assert 0.2 < found.stick_radius / a < 0.95
    stack = Stack(*LAYERS[name], longest_disc=a)
    want = sliding_disc(stack, smooth_pressure(bed, contact), a, found.stick_radius, order)
    load = found.torque if order else found.shear_force
    assert motion == pytest.approx(MU * want[0], rel=2e-6)
    assert load == pytest.approx(MU * want[1], rel=2e-6)


@pytest.mark.few(1)
@pytest.mark.parametrize("name", LAYERS)
@pytest.mark.parametrize("problem", [wk.Torsion, wk.Tangential])
def test_rings_that_slide_bear_their_own_pressure_and_others_less(name, problem):
    bed, twist = wk.Foundation(BALL, coated(name)), problem is wk.Torsion
    contact, a, force = pressed(bed)
    stiffness = bed.medium.punch_torsional_stiffness if twist else bed.medium.punch_shear_stiffness
    motion = 0.8 * MU * force * (a if twist else 1.0) / float(stiffness(np.array([a]))[0])
    path, law = steady(bed, wk.Coulomb(MU), [0.0, motion, -motion, motion], wk.Angle if twist else wk.Shift)
    solution = problem(bed, law, path).solve()
    assert solution.nested.all()
    r = a * np.linspace(0.02, 0.98, 40)
    state, borne = solution.at(1), MU * wk.restore(contact, r).pressure
    slides = r > state.stick_radius
    traction = state.traction(r)
    np.testing.assert_allclose(traction[slides], borne[slides], rtol=1e-7)
    assert np.all(traction[~slides] < borne[~slides])
    np.testing.assert_allclose(solution.at(3).traction(r), traction, rtol=1e-6)  # the loop closes
    missed = solution.work - solution.stored_energy - solution.dissipation
    assert np.max(np.abs(missed)) < 1e-10 * solution.work[-1]


@pytest.mark.parametrize("k", [-0.4, 0.3, 0.7])
def test_torsion_on_a_power_law(k):
    bed = wk.Foundation(BALL, wk.GradedHalfSpace.between(PowerLawGraded(2.6, 0.5, exponent=k, poisson=0.3)))
    contact, a, force = pressed(bed)
    angle = 0.8 * MU * force * a / float(bed.medium.punch_torsional_stiffness(np.array([a]))[0])
    path, law = steady(bed, wk.Coulomb(MU), [0.0, angle], wk.Angle)
    state = wk.Torsion(bed, law, path).solve().at(1)
    r = a * np.linspace(0.02, 0.98, 40)
    slides, borne = r > state.stick_radius, MU * wk.restore(contact, r).pressure
    np.testing.assert_allclose(state.traction(r)[slides], borne[slides], rtol=1e-7)
    # the greatest torque is that of the pressure: mu int p r 2 pi r dr, p = p_0 (1 - r^2/a^2)^((1+k)/2)
    mean = mp.beta(1.5, 0.5 * (3.0 + k)) / mp.beta(1.0, 0.5 * (3.0 + k))
    assert state.torque_limit == pytest.approx(MU * force * a * float(mean), rel=1e-9)
    # where it sticks the angle is constant: phi = mu (1+k) c^k / (2 G_0) int_c^a p (r^2 - c^2)^(-(1+k)/2) dr
    c, top = state.stick_radius, 0.5 * (3.0 + k) * force / (np.pi * a * a)
    n = 0.5 * (1.0 + k)
    free, root = a * a - c * c, 1.0 / (1.0 - n)  # r^2 = c^2 + free s^root
    share = mp.quad(lambda s: (1 - s**root) ** n / mp.sqrt(c * c + free * s**root), [0, 0.5, 1])
    integral = 0.5 * free * a ** (-2.0 * n) * root * share
    assert angle == pytest.approx(MU * (1.0 + k) * 0.5**k / 2.0 * top * float(integral), rel=1e-8)


@pytest.mark.parametrize("k", [-0.9, -0.3, -2e-5, 1e-5, 3e-4, 0.5, 0.99])
def test_the_function_of_the_bound(k):
    z = np.array([1e-12, 1e-3, 0.24, 0.26, 1.5, 3.9])
    with mp.workdps(40):
        want = [float(mp.hyp2f1(0.5, 0.5 * (1.0 + mp.mpf(k)), 1, 1 - mp.mpf(each))) for each in z]
    np.testing.assert_allclose(bound_shape(k, z), want, rtol=2e-9)


@pytest.mark.slow
def test_the_greatest_torque_is_that_of_the_pressure_on_a_stack():
    stack = [wk.Layer(wk.Elastic(8.0, 0.2), 0.01), wk.Layer(wk.Elastic(0.5, 0.45), 0.01)]
    bed = wk.Foundation(BALL, wk.CoatedHalfSpace(stack, on=SOLID))
    contact, a, _ = pressed(bed)
    bound = twist_bound(bed, MU, a, False)
    nodes, weights = np.polynomial.legendre.leggauss(200)
    angle = 0.25 * np.pi * (nodes + 1.0)
    r = a * np.sin(angle)
    whole = (
        2.0
        * np.pi
        * float(np.sum(0.25 * np.pi * weights * a * np.cos(angle) * r * r * wk.restore(contact, r).pressure))
    )
    assert bound.most(PressedState(D, a, 0.0)) == pytest.approx(MU * whole, rel=1e-8)


def test_springs_of_similar_kernels_miss_the_slip_on_a_hard_coating():
    """The scaling of the normal solution (Jaeger, Ciavarella) is off by a sixth of the friction there."""
    bed = wk.Foundation(BALL, coated("hard"))
    _, a, force = pressed(bed)
    shift = 1.2 * MU * force / float(bed.medium.punch_shear_stiffness(np.array([a]))[0])
    path, law = steady(bed, wk.Coulomb(MU), [0.0, shift], wk.Shift)
    right = wk.Tangential(bed, law, path).solve()
    scaled = wk.Tangential(bed, law, path, wk.Method.SPRINGS).solve()
    missed = float(scaled.shear_force[1] - right.shear_force[1]) / (MU * force)
    assert -0.25 < missed < -0.05
    note = next(note for note in right.validity if "lowers the stiffness without slip" in note.statement)
    assert note.standing is wk.Standing.APPROXIMATE


@pytest.mark.parametrize("force", [0.05, pytest.param([0.02, 0.05, 0.05], marks=pytest.mark.slow)])
def test_a_force_of_all_friction_slides_as_on_a_half_space(force):
    steel, most = wk.Elastic(210e9, 0.3), MU * 0.05
    path = wk.Path([0.0, 1.0, 2.0], wk.Force(force), wk.ShearForce([0.0, most, -most]))
    coating = wk.CoatedHalfSpace([wk.Layer(steel, 2e-6)], on=steel)
    layers = wk.Tangential(wk.Foundation(wk.Paraboloid(1e-3), coating), wk.Coulomb(MU), path).solve()
    alike = wk.Tangential(wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(steel)), wk.Coulomb(MU), path).solve()
    np.testing.assert_allclose(layers.shear_force, alike.shear_force, rtol=1e-11)
    np.testing.assert_allclose(layers.shift, alike.shift, rtol=1e-7)
    np.testing.assert_allclose(layers.dissipation, alike.dissipation, rtol=1e-8 if force == 0.05 else 2e-4)
    assert np.all(layers.stick_radius[1:] < 1e-4 * layers.radius[1:])


def test_what_is_refused():
    bed = wk.Foundation(BALL, coated("hard"))
    plane = wk.Path([0.0, 1.0], wk.Depth([D, D]), wk.Shift([[0.0, 0.0], [1e-6, 1e-6]]))
    with pytest.raises(wk.InvalidInput, match="along one line"):
        wk.Tangential(bed, wk.Coulomb(MU), plane, wk.Method.RINGS)
    line = wk.Path([0.0, 1.0], wk.Depth([D, D]), wk.ShearForce([0.0, 1.0]))
    with pytest.raises(wk.OutsideValidity, match="leave the method out, or give springs, for other media"):
        wk.Tangential(wk.Foundation(BALL, wk.HalfSpace.between(SOLID)), wk.Coulomb(MU), line, wk.Method.RINGS)
    with pytest.raises(wk.OutsideValidity, match="the shear force of 1 N exceeds the friction limit"):
        wk.Tangential(bed, wk.Coulomb(MU), line).solve()
    thin = wk.CoatedHalfSpace([wk.Layer(SOLID, 1e-5)], on=wk.Elastic(26.0, 0.3))
    with pytest.raises(wk.OutsideValidity, match="too wide against the length"):
        twist_bound(wk.Foundation(BALL, thin), MU, 0.03, False)
    state = wk.Torsion(bed, wk.Coulomb(MU), wk.Path([0.0], wk.Depth([D]), wk.Angle([1e-9]))).solve().at(0)
    with pytest.raises(wk.OutsideValidity, match="displacement of the surface around the axis"):
        state.turning(0.01)
    with pytest.raises(wk.OutsideValidity, match="stresses of a twist inside"):
        state.below(0.01, 0.01)


@pytest.mark.slow
def test_a_method_is_taken_or_refused_with_the_nearest():
    """On a hard coating springs lose more than rings; what no method follows is refused, with what does."""
    bed, half = wk.Foundation(BALL, coated("hard")), wk.Foundation(BALL, wk.HalfSpace.between(SOLID))
    flat = wk.Foundation(wk.FlatPunch(1e-3), coated("hard"))
    _, a, force = pressed(bed)
    shift = 0.8 * MU * force / float(bed.medium.punch_shear_stiffness(np.array([a]))[0])
    path = wk.Path.through(wk.Depth(D), wk.Shift([0.0, shift, -shift, shift]))

    def losses(on, method=wk.Method.AUTO):
        loop = wk.Tangential(on, wk.Coulomb(MU), path, method).solve()
        swing = wk.FrictionDamping(on, wk.Coulomb(MU), wk.Depth(D), wk.Shift(shift), method).solve()
        assert swing.loss_factor == pytest.approx(loop.loss_factor, rel=1e-4)
        return [loop.loss_per_cycle, swing.loss_per_cycle]

    assert losses(bed) == losses(bed, wk.Method.RINGS)
    assert losses(bed, wk.Method.SPRINGS) > [1.1 * each for each in losses(bed)]
    assert losses(half, wk.Method.EXACT) == losses(half)
    swing = wk.FrictionDamping(bed, wk.Coulomb(MU), wk.Depth(D), wk.Shift(shift), wk.Method.EXACT)
    for problem in (wk.Tangential(bed, wk.Coulomb(MU), path, wk.Method.EXACT), swing):
        with pytest.raises(wk.OutsideValidity, match="exact needs one ratio: give the method rings"):
            problem.solve()
    with pytest.raises(
        wk.OutsideValidity, match="no annulus slips before full sliding of this contact; give the method spr"
    ):
        wk.FrictionDamping(flat, wk.Coulomb(MU), wk.Depth(D), wk.Shift(shift), wk.Method.RINGS).solve()
    with pytest.raises(wk.InvalidInput, match="exact follows Coulomb's law .* give the method springs"):
        wk.Tangential(half, wk.StaticKinetic(0.4, MU), path, wk.Method.EXACT)
