"""A contact pressed and pushed in one direction: closed forms, an independent code, energy, shapes."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import winkler as wk
from winkler.reference.friction import (
    mindlin_shear_force,
    mindlin_traction,
)

MU = 0.4
MEDIUM = wk.HalfSpace(wk.Elastic(1.68, 0.4))  # E* = 2, G* = 1.5
BALL = wk.Foundation(wk.Paraboloid(3.0), MEDIUM)
RATIO = 0.75
BETA = MU / RATIO
DEPTH = 0.48  # a = 1.2
FORCE = 4.0 / 3.0 * 2.0 * 1.2**3 / 3.0


def run(path, bed=BALL, law=None):
    return wk.Tangential(bed, wk.Coulomb(MU) if law is None else law, path).solve()


def through(normal, lateral):
    return wk.Path.through(normal, lateral)


def work_done(solution):
    """Work of the shear force by trapezoids over the points of the path."""
    mean = 0.5 * (solution.shear_force[1:] + solution.shear_force[:-1])
    return np.concatenate([[0.0], np.cumsum(mean * np.diff(solution.shift))])


def test_the_medium_is_what_the_numbers_are_for():
    assert MEDIUM.modulus == pytest.approx(2.0, rel=1e-15)
    assert MEDIUM.shear_modulus == pytest.approx(1.5, rel=1e-15)


def test_depth_drawn_back_at_a_held_shift():
    shift = BETA * (1.2**2 - 0.7**2) / 3.0
    parts = np.array([1.0, 0.9, 0.7, 0.5, 0.3])
    solution = run(through(wk.Depth(DEPTH * parts), wk.Shift(shift)))
    expected = [0.492444444, 0.4522200744, 0.3548642550, 0.2172232032, 0.1009562218]
    np.testing.assert_allclose(solution.shear_force, expected, rtol=2e-10, atol=6e-10)
    assert solution.stick_radius[0] == pytest.approx(0.7, rel=1e-13)
    assert solution.stick_radius[1] ** 2 == pytest.approx(0.7**2 - 3.0 * 0.1 * DEPTH, rel=1e-12)
    assert list(solution.stick_radius[3:]) == [0.0, 0.0]


def test_the_peer_code_agrees(shared_data):
    table = np.genfromtxt(shared_data / "reference" / "tangential_shift_circle.csv", delimiter=",", skip_header=1)
    for poisson in (0.0, 0.25):
        rows = table[table[:, 0] == poisson]
        body = wk.Elastic(2.0 * (1.0 + poisson), poisson)  # G = 1
        bed = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(body, body))
        contact = wk.Indentation(bed, wk.Depth(0.01)).solve()
        shift = np.sort(rows[:, 2])
        expected = rows[np.argsort(rows[:, 2]), 3]
        solution = run(through(wk.Depth(0.01), wk.Shift(shift * MU * contact.force / contact.radius)), bed)
        fine = np.sort(rows[:, 1])[-1] == rows[np.argsort(rows[:, 2]), 1]
        # where nu is not zero, the code sees slip that is not quite parallel
        close = 2e-4 if poisson == 0.0 else 3e-4
        np.testing.assert_allclose(solution.shear_force[fine] / (MU * contact.force), expected[fine], atol=close)
        np.testing.assert_allclose(solution.shear_force / (MU * contact.force), expected, atol=2e-3)


def test_small_loops_lose_the_cube_of_their_amplitude():
    for part in (1e-2, 1e-3, 1e-4):
        amplitude = part * BETA * DEPTH
        solution = run(through(wk.Depth(DEPTH), wk.Shift([amplitude, -amplitude, amplitude])))
        loss = solution.dissipation[2] - solution.dissipation[0]
        q = solution.shear_force[2]
        y = q / (MU * FORCE)
        # the bracket of the closed form cancels to nothing: its series in y
        series = y**3 * (5.0 / 162.0) * (1.0 + y * (2.0 / 3.0) + y**2 * (4.0 / 9.0) + y**3 * (26.0 / 81.0))
        expected = 18.0 * (MU * FORCE) ** 2 / (5.0 * 1.2 * 1.5) * series
        assert loss == pytest.approx(expected, rel=max(3e-8 * (1e-4 / part), 1.0 * y**4, 1e-10))


def test_gross_slip_costs_friction_times_distance():
    most = BETA * DEPTH
    just, more = (run(through(wk.Depth(DEPTH), wk.Shift([u, -u, u]))) for u in (most, 1.7 * most))
    gain = np.diff(more.dissipation[[0, 2]])[0] - np.diff(just.dissipation[[0, 2]])[0]
    assert gain == pytest.approx(4.0 * MU * FORCE * 0.7 * most, rel=1e-13)
    assert more.shear_force[0] == pytest.approx(MU * FORCE, rel=1e-14)


def test_what_is_wiped_out_does_not_matter():
    end = 0.9 * BETA * DEPTH
    direct = run(through(wk.Depth(DEPTH), wk.Shift(end)))
    for depths, shifts in (
        ([0.2, 0.3, DEPTH, DEPTH], [0.02, -0.03, 0.02, end]),
        ([0.6 * DEPTH, DEPTH, DEPTH, DEPTH], [0.0, 0.05, -0.04, end]),
    ):
        solution = run(through(wk.Depth(depths), wk.Shift(shifts)))
        assert solution.shear_force[-1] == pytest.approx(direct.shear_force[-1], rel=1e-14)


def test_oblique_pressing_below_friction_sticks_for_ever():
    solution = run(through(wk.Force([0.0, 0.5, 2.0]), wk.ShearForce([0.0, 0.15, 0.6])))
    np.testing.assert_allclose(solution.stick_radius, solution.radius, rtol=1e-12)
    np.testing.assert_allclose(solution.shift[1:], 0.3 / RATIO * solution.depth[1:], rtol=1e-12)
    np.testing.assert_allclose(solution.dissipation, 0.0, atol=1e-15)


def test_steps_curved_by_a_force_are_followed():
    forces, shifts = [0.01, 1.0, 0.4, 0.8], [0.0, 0.15, -0.05, 0.1]
    solution = run(through(wk.Force(forces), wk.Shift(shifts)))
    fine_force = np.concatenate(
        [np.linspace(a, b, 500, endpoint=False) for a, b in zip(forces, forces[1:], strict=False)]
    )
    fine_shift = np.concatenate(
        [np.linspace(a, b, 500, endpoint=False) for a, b in zip(shifts, shifts[1:], strict=False)]
    )
    depth = wk.Indentation(BALL, wk.Force(np.append(fine_force, forces[-1]))).solve().depth
    springs = wk.Tangential(
        BALL, wk.Coulomb(MU), through(wk.Depth(depth), wk.Shift(np.append(fine_shift, 0.1))), wk.Method.SPRINGS, 2000
    )
    trace = springs.solve()
    np.testing.assert_allclose(solution.shear_force, trace.shear_force[::500], atol=5e-6 * MU)
    np.testing.assert_allclose(solution.dissipation, trace.dissipation[::500], atol=5e-6 * MU)


@pytest.mark.parametrize(
    "normal", [wk.Depth(np.linspace(0.3, 0.6, 9)), wk.Depth([0.5, 0.2, 0.45, 0.4, 0.6, 0.1, 0.3, 0.5, 0.5])]
)
def test_a_shear_force_is_met(normal):
    force = wk.Indentation(BALL, normal).solve().force
    prescribed = MU * force * np.array([0.1, 0.5, -0.3, 0.8, 0.2, -0.7, 0.0, 0.9, 1.0])
    solution = run(through(normal, wk.ShearForce(prescribed)))
    np.testing.assert_allclose(solution.shear_force, prescribed, rtol=1e-12, atol=1e-14)
    assert solution.stick_radius[-1] == 0.0


def test_a_contact_that_was_lost_begins_anew():
    depths, shifts = [0.3, 0.3, -0.1, 0.3, 0.3], [0.0, 0.08, 0.3, 0.3, 0.38]
    solution = run(through(wk.Depth(depths), wk.Shift(shifts)))
    assert solution.shear_force[2] == solution.stored_energy[2] == solution.radius[2] == 0.0
    assert solution.shear_force[3] == 0.0
    assert solution.shear_force[4] == pytest.approx(solution.shear_force[1], rel=1e-13)


def test_bodies_that_never_touch_are_solved():
    for mu in (MU, np.inf):
        solution = run(through(wk.Depth([-0.1, -0.2]), wk.Shift([0.0, 0.3])), law=wk.Coulomb(mu))
        for name in ("radius", "stick_radius", "shear_force", "stored_energy", "dissipation"):
            assert list(getattr(solution, name)) == [0.0, 0.0]


def test_nothing_slides_where_friction_is_endless():
    solution = run(through(wk.Depth([DEPTH, DEPTH, DEPTH / 4.0]), wk.Shift([0.0, 0.1, 0.1])), law=wk.Coulomb(np.inf))
    np.testing.assert_allclose(
        solution.shear_force, [0.0, 2.0 * 1.5 * 1.2 * 0.1, 2.0 * 1.5 * 0.6 * 0.1], rtol=1e-13, atol=0.0
    )
    np.testing.assert_allclose(solution.dissipation[2], 1.5 * 0.6 * 0.1**2, rtol=1e-13)  # G* u^2 per length, let go
    pulled = run(through(wk.Depth(DEPTH), wk.ShearForce([0.0, 0.36])), law=wk.Coulomb(np.inf))
    assert pulled.shift[1] == pytest.approx(0.1, rel=1e-13)


def test_nothing_is_dragged_without_friction():
    solution = run(through(wk.Depth([0.1, 0.3]), wk.Shift([0.0, 0.5])), law=wk.Coulomb(0.0))
    for column in (solution.shear_force, solution.dissipation, solution.stick_radius):
        assert not np.any(column)


def shapes():
    x = np.linspace(0.0, 0.6, 61)[1:]
    return {
        "cone": wk.Foundation(wk.Cone(1.2), MEDIUM),
        "sphere": wk.Foundation(wk.Sphere(3.0), MEDIUM),
        "rounded punch": wk.Foundation(wk.RoundedPunch(0.3, 2.0), MEDIUM),
        "truncated cone": wk.Foundation(wk.TruncatedCone(0.3, 1.2), MEDIUM),
        "measured bed": wk.MeasuredBed(x, 4.0 * x, x**2 / 3.0, mindlin_ratio=RATIO),
    }


@pytest.mark.parametrize("name", list(shapes()))
def test_shear_force_is_the_difference_of_two_contacts(name):
    bed = shapes()[name]
    depth = 0.08
    shift = BETA * depth * np.array([0.0, 0.1, 0.5, 0.9, 1.0, 1.3])
    solution = run(through(wk.Depth(depth), wk.Shift(shift)), bed)
    inner = wk.Indentation(bed, wk.Depth(np.maximum(depth - shift / BETA, 0.0))).solve().force
    expected = MU * (solution.force - inner)
    np.testing.assert_allclose(solution.shear_force, expected, rtol=1e-9, atol=1e-12 * MU * solution.force[0])
    depths, shifts = depth * np.array([1.0, 1.0, 0.5, 1.1, 1.0]), BETA * depth * np.array([0.0, 0.6, -0.4, 0.5, -0.1])
    swing = run(through(wk.Depth(depths), wk.Shift(shifts)), bed)
    assert np.all(np.diff(swing.dissipation) >= 0.0)


def test_a_flat_punch_sticks_until_all_slides():
    bed = wk.Foundation(wk.FlatPunch(0.5), MEDIUM)
    solution = run(through(wk.Depth(0.01), wk.Shift(BETA * 0.01 * np.array([0.5, 0.999, 1.001, 0.5]))), bed)
    assert list(solution.stick_radius) == [0.5, 0.5, 0.0, 0.5]
    np.testing.assert_allclose(solution.shear_force[:3] / (MU * solution.force[0]), [0.5, 0.999, 1.0], rtol=1e-13)
    assert solution.shear_force[3] == pytest.approx(MU * solution.force[0] * (1.0 - 0.501), rel=1e-12)


@pytest.mark.parametrize("exponent", [-0.3, 0.25, 0.5])
def test_graded_media_are_exact_too(exponent):
    medium = wk.GradedHalfSpace(wk.PowerLawGraded(2.0, 0.3, exponent, 0.1))
    bed = wk.Foundation(wk.Paraboloid(1.0), medium)
    ratio = float(bed.tangential_stiffness(np.array([0.3]))[0] / bed.normal_stiffness(np.array([0.3]))[0])
    depth, part = 0.01, 0.4
    solution = run(through(wk.Depth(depth), wk.Shift(part * MU / ratio * depth)), bed)
    # F ~ d^((k+3)/2)
    expected = 1.0 - (1.0 - part) ** (0.5 * (exponent + 3.0))
    assert solution.shear_force[0] == pytest.approx(MU * solution.force[0] * expected, rel=1e-11)
    assert solution.at(0).mindlin_ratio == pytest.approx(ratio, rel=1e-12)


points = st.lists(st.tuples(st.floats(-0.1, 0.6), st.floats(-0.6, 0.6)), min_size=2, max_size=8)


@pytest.mark.slow
@given(points)
@settings(max_examples=25, deadline=None)
def test_no_history_creates_energy_or_more_traction_than_friction(history):
    depths, shifts = np.array(history).T
    depths[0] = abs(depths[0]) + 0.01
    answer = run(through(wk.Depth(depths), wk.Shift(shifts)))
    assert np.all(np.diff(answer.dissipation, prepend=0.0) >= 0.0)
    assert np.all(np.abs(answer.shear_force) <= MU * answer.force * (1.0 + 1e-12) + 1e-15)
    for index in range(depths.size):
        state = answer.at(index)
        if state.depth <= 0.0:
            continue
        r = np.linspace(0.0, 1.0, 40) * state.radius
        gaps, factors = state.memory.corners

        def pressure(depth, r=r):
            return 4.0 / (np.pi * 3.0) * np.sqrt(np.maximum(3.0 * depth - r**2, 0.0))

        traction = RATIO * sum((b * pressure(gap) for gap, b in zip(gaps, factors, strict=True)), np.zeros(r.size))
        peak = pressure(state.depth)[0]
        assert np.all(np.abs(traction) <= MU * pressure(state.depth) + 1e-7 * peak)


@pytest.mark.slow
@given(points)
@settings(max_examples=6, deadline=None)
def test_work_is_stored_or_lost(history):
    depths, shifts = np.array(history).T
    depths[0] = abs(depths[0]) + 0.01
    errors = []
    for count in (60, 240):
        share = np.linspace(0.0, depths.size - 1.0, count * (depths.size - 1) + 1)
        fine = [np.interp(share, np.arange(depths.size), q) for q in (depths, shifts - shifts[0])]
        answer = run(through(wk.Depth(fine[0]), wk.Shift(fine[1])))
        errors.append(np.max(np.abs(work_done(answer) - answer.work)))
    assert errors[1] <= max(errors[0] / 6.0, 1e-9)  # trapezoids: second order, if the rest is exact


def test_the_traction_of_a_state_is_mindlins():
    state = run(through(wk.Depth(DEPTH), wk.Shift(BETA * (1.2**2 - 0.7**2) / 3.0))).at(-1)
    fields = wk.restore(state, np.linspace(0.0, 1.19, 30))
    expected = mindlin_traction(MU * 4.0 * 1.2 / (np.pi * 3.0), 1.2, 0.7, np.linspace(0.0, 1.19, 30))
    np.testing.assert_allclose(fields.traction, expected, rtol=1e-9, atol=1e-12)


def test_steps_and_solve_are_the_same():
    path = through(wk.Depth([0.2, 0.4, 0.3, 0.35]), wk.Shift([0.01, 0.1, -0.05, 0.0]))
    solution = run(path)
    for index, state in enumerate(wk.Tangential(BALL, wk.Coulomb(MU), path).steps()):
        assert state == solution.at(index)
        for name in ("time", "depth", "force", "radius", "shift", "shear_force", "stored_energy", "dissipation"):
            assert getattr(state, name) == getattr(solution, name)[index]
        assert state.stick_radius == pytest.approx(solution.stick_radius[index], rel=1e-14)


def test_what_has_no_exact_rule_goes_to_the_springs():
    path = through(wk.Depth(0.3), wk.Shift([[0.0, 0.0], [0.05, 0.0], [0.05, 0.05]]))
    plane = run(path)
    assert plane.shear_force.shape == (3, 2)
    assert any("In planar motion" in note.statement for note in plane.validity)
    line = through(wk.Depth(0.3), wk.Shift([0.0, 0.05, 0.3]))
    dropping = run(line, law=wk.StaticKinetic(0.5, MU))
    assert dropping.shear_force[-1] == pytest.approx(MU * dropping.force[-1], rel=1e-3)


def test_validity_is_exact_in_one_direction():
    solution = run(through(wk.Depth(0.3), wk.Shift(0.05)))
    assert any(n.standing is wk.Standing.EXACT and "One direction" in n.statement for n in solution.validity)
    assert any("deviates by up to about 7.2 degrees" in n.statement for n in solution.validity)


def waves_along_and_across(c11, c12, c13, c33, c44):
    """Return surface displacements under waves of traction along and across them, from the equations of equilibrium."""
    mixed = c13 + c44
    middle = mixed**2 - c11 * c33 - c44**2
    q = np.sqrt(np.roots([c44 * c33, middle, c11 * c44]).astype(complex))  # exp(-q z), with real parts above zero
    ratio = -(c44 * q**2 - c11) / (mixed * q)  # of the displacement across the surface to i times that along it
    pressed = c13 - c33 * q * ratio
    parts = np.array([-pressed[1], pressed[0]])  # no pressure on the surface
    along = np.sum(parts) / np.sum(c44 * (q + ratio) * parts)
    return along.real, 1.0 / np.sqrt(c44 * 0.5 * (c11 - c12))


@pytest.mark.parametrize("constants", [(10.0, 4.0, 3.5, 12.0, 3.0), (5.0, 2.0, 2.2, 20.0, 1.2)])
def test_slip_deviates_on_transversely_isotropic_bodies_too(constants):
    """In isotropic bodies tractions along their wave move it by 1 - nu of what those across do: nu/(4 - 2 nu)."""
    alike = wk.TransverselyIsotropicHalfSpace(wk.Elastic(1.68, 0.4))
    body = wk.TransverselyIsotropic(*constants)
    along, across = waves_along_and_across(*constants)
    poisson = 1.0 - along / across
    for medium, expected in ((alike, 0.4), (wk.TransverselyIsotropicHalfSpace(body), poisson)):
        bed = wk.Foundation(wk.Paraboloid(3.0), medium)
        notes = [note.statement for note in run(through(wk.Depth(0.3), wk.Shift(0.05)), bed).validity]
        (found,) = [note for note in notes if "the true direction deviates" in note]
        angle = np.degrees(abs(expected / (4.0 - 2.0 * expected)))
        assert f"{expected:.3g} the true direction deviates by up to about {angle:.2g} degrees" in found


def test_input_is_checked():
    path = through(wk.Depth(0.3), wk.Shift(0.05))
    with pytest.raises(wk.InvalidInput, match="law is a float; give Coulomb"):
        wk.Tangential(BALL, 0.3, path)
    with pytest.raises(wk.InvalidInput, match=r"give Path\(time, normal\)"):
        wk.Tangential(BALL, wk.Coulomb(0.3), wk.Depth(1.0))
    with pytest.raises(wk.InvalidInput, match="Angle; give Shift or ShearForce, or"):
        wk.Tangential(BALL, wk.Coulomb(0.3), through(wk.Depth(0.3), wk.Angle(0.1)))
    with pytest.raises(wk.InvalidInput, match="no point 7 on a path of 1 points"):
        wk.Tangential(BALL, wk.Coulomb(0.3), path).solve().at(7)


def test_one_shear_force_is_mindlins():
    for u in (0.02, 0.1, 0.5):
        result = run(through(wk.Depth(DEPTH), wk.Shift(u))).shear_force[0]
        assert result == pytest.approx(float(mindlin_shear_force(MU * FORCE, 1.5, 1.2, u)), rel=1e-13)
