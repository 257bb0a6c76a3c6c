"""A cylinder that begins to roll: Cattaneo at rest, Carter in the end, and steps by brute force in between."""

from __future__ import annotations

import itertools
import tomllib

import numpy as np
import pytest
from scipy.integrate import quad

import winkler as wk

BED = wk.LineFoundation(wk.Paraboloid(10.0), wk.HalfSpace(wk.Elastic(0.75, 0.5)))
"""E* = 1 Pa; a = 1 m presses with P = pi/40 N/m."""
MU, LOAD = wk.Coulomb(0.3), wk.HalfWidth(1.0)
MOST = 0.3 * np.pi / 40.0


def begun(ratio=0.64, distance=4.0, count=40, **more):
    drive = wk.LineShearForce(ratio * MOST)
    return wk.LineRollingStart(BED, MU, drive, LOAD, distance=distance, count=count, **more).solve()


@pytest.mark.slow
def test_it_comes_to_carter_with_the_first_order():
    steady = 0.3 / 10.0 * (1.0 - np.sqrt(1.0 - 0.64))
    errors = [
        begun(distance=12.0, count=count, points=1).longitudinal_creepage[-1] / steady - 1.0 for count in (20, 40, 80)
    ]
    assert all(1.9 < coarse / fine < 2.4 for coarse, fine in itertools.pairwise(errors))
    assert abs(errors[-1]) < 1.3e-3
    assert abs(2.0 * errors[-1] - errors[-2]) < 2e-4
    assert begun().steady.longitudinal_creepage == pytest.approx(steady, rel=1e-12)


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize(("ratio", "error"), [(1e-6, 6e-3), (1e-2, 6e-3), (0.1, 2e-3), (0.9, 2e-3), (0.999, 6e-3)])
def test_the_stated_error_holds_from_small_forces_to_sliding(ratio, error):
    steady = 0.3 / 10.0 * ratio / (1.0 + np.sqrt(1.0 - ratio))
    found = begun(ratio, distance=6.0, count=80, points=1)
    assert found.longitudinal_creepage[-1] == pytest.approx(steady, rel=error)
    (stated,) = (note.statement for note in found.validity if "80 elements" in note.statement)
    assert "from Carter's by at most 0.2 %. This holds for shear forces of 10 to 90 % of mu P" in stated
    assert "outside this range the difference is 0.6 %" in stated


@pytest.mark.slow
def test_the_tractions_become_those_of_carter():
    found = begun(distance=12.0, count=80)
    state = found.states[-1]
    away = np.abs(state.x + 0.2) > 0.05  # but at the root where stick begins
    carter = found.steady.traction(state.x)
    np.testing.assert_allclose(state.traction[away], carter[away], atol=5e-3 * 0.3 * 0.05)
    np.testing.assert_allclose(found.shear_force_per_length, 0.64 * MOST, rtol=1e-12)
    assert state.stick_share == pytest.approx(0.6, abs=0.01)


def test_at_rest_it_is_cattaneo():
    """q = mu p0 [sqrt(1 - x^2) - c sqrt(1 - x^2/c^2)], c = sqrt(1 - Q/(mu P)) = 0.6."""
    state = begun(count=80, distance=0.1).states[0]
    inner = np.sqrt(np.maximum(0.36 - state.x**2, 0.0))
    exact = 0.3 * 0.05 * (np.sqrt(1.0 - state.x**2) - inner)
    away = np.abs(np.abs(state.x) - 0.6) > 0.03
    np.testing.assert_allclose(state.traction[away], exact[away], atol=4e-3 * 0.3 * 0.05)
    assert state.longitudinal_creepage == 0.0
    assert state.distance == 0.0


def by_brute_force(count, steps, creepage, reference):
    """Tractions by relaxation of one node after another, displacements by quadrature."""
    h = 1.0 / count
    x = h * np.arange(1 - count, count)
    bound = np.sqrt(1.0 - x**2)
    bound *= MOST / (h * np.sum(bound))

    def moved(away):
        def part(s):
            return (1.0 - abs(s) / h) * np.log(abs(away - s) / reference)

        cuts = sorted({-h, 0.0, h} | ({away} if abs(away) < h else set()))
        return -2.0 / np.pi * sum(quad(part, *pair)[0] for pair in itertools.pairwise(cuts))

    near = np.array([moved(k * h) for k in range(2 * count)])
    index = np.arange(x.size)
    now, ago = near[np.abs(index[:, None] - index)], near[np.abs(index[:, None] + 1 - index)]
    traction, forces = np.zeros(x.size), []
    for _ in range(steps):
        target = creepage * h + ago @ traction
        for _ in range(600):
            for i in index:
                step = (target[i] - now[i] @ traction) / now[i, i]
                traction[i] = np.clip(traction[i] + step, -bound[i], bound[i])
        forces.append(h * np.sum(traction))
    return traction, forces


def test_steps_are_those_of_relaxation_node_by_node():
    traction, forces = by_brute_force(5, 4, 0.012, 5.0)
    found = wk.LineRollingStart(
        BED, MU, wk.Creepage(0.012), LOAD, distance=0.8, reference=5.0, points=4, count=5
    ).solve()
    np.testing.assert_allclose(found.shear_force_per_length[1:], forces, rtol=1e-7)
    np.testing.assert_allclose(found.states[-1].traction, traction, atol=1e-7 * 0.015)


def test_a_creepage_brings_the_force_of_carter_the_later_the_farther_the_reference():
    near, far = (
        wk.LineRollingStart(BED, MU, wk.Creepage(0.012), LOAD, distance=16.0, reference=d, points=4, count=20).solve()
        for d in (10.0, 1000.0)
    )
    steady = near.steady.shear_force_per_length
    assert steady == pytest.approx(0.64 * MOST, rel=1e-12)
    assert near.shear_force_per_length[-1] == pytest.approx(steady, rel=5e-3)
    assert np.all(np.diff(far.shear_force_per_length) > 0.0)
    assert np.all(far.shear_force_per_length[1:] < near.shear_force_per_length[1:])
    back = wk.LineRollingStart(BED, MU, wk.Creepage(-0.012), LOAD, distance=16.0, reference=10.0, points=4, count=20)
    np.testing.assert_allclose(back.solve().shear_force_per_length, -near.shear_force_per_length, rtol=1e-12)
    slid = wk.LineRollingStart(
        BED, MU, wk.Creepage(1.0), LOAD, distance=3.0, reference=10.0, points=3, count=10
    ).solve()
    assert slid.stick_share[-1] == 0.0
    assert slid.shear_force_per_length[-1] == pytest.approx(MOST, rel=1e-12)


def test_the_course_is_like_that_of_a_ball(shared_data):
    """cattaneo_to_carter of CONTACT, 0.657 of the limit: the creepage begins low, and is steady after two widths."""
    file = shared_data / "reference" / "contact" / "cattaneo_to_carter.csv"
    rows = np.genfromtxt(file, delimiter=",", names=True, skip_header=1, usecols=(1, 5))
    ball = rows["creep_x"] / 3.101e-3
    line = begun(ratio=0.657, distance=4.0, count=40, points=160)
    line = line.longitudinal_creepage / line.steady.longitudinal_creepage
    assert 0.5 < line[1] < 0.6 < 1.001 * ball[2]
    assert ball[2] < 0.65
    assert abs(line[-1] - 1.0) < 0.01
    assert abs(ball[-1] - 1.0) < 0.02


def unlike(mu, count=100, reverse=False):
    aluminium, steel = wk.Elastic(2.0 * 1.31 * 23e9, 0.31), wk.Elastic(2.0 * 1.28 * 82e9, 0.28)
    pair = (steel, aluminium) if reverse else (aluminium, steel)
    bed = wk.LineFoundation(wk.Paraboloid(25e-3), wk.HalfSpace.between(*pair))
    load = wk.LineForce(16201.9)
    return wk.LineRollingStart(
        bed, wk.Coulomb(mu), wk.LineShearForce(0.0), load, distance=0.8e-3, count=count, points=4
    )


@pytest.mark.slow
def test_dissimilar_rollers_creep_freely_as_in_contact(shared_data):
    """Case 4 of bentall_line, 200 elements: 4.294e-4, and from the leading edge slip 32, stick 117, 35, 8, 8."""
    found = unlike(0.05).solve()
    assert found.longitudinal_creepage[-1] == pytest.approx(4.294e-4, rel=4e-3)
    assert unlike(0.05, reverse=True).solve().longitudinal_creepage[-1] == pytest.approx(-4.294e-4, rel=4e-3)
    table = tomllib.loads((shared_data / "reference" / "contact" / "bentall_line.toml").read_text(encoding="utf-8"))
    stated = next(case for case in table["case"] if case["case"] == 4)["runs_from_leading_edge"]
    bound = 0.05 * found.contact.pressure(found.states[-1].x)
    sticks = np.abs(found.states[-1].traction) < 0.995 * bound
    zones = [(key, len(list(group))) for key, group in itertools.groupby(sticks[::-1])]
    assert [("stick" if key else "slip") for key, _ in zones] == [name for name, _ in stated]
    assert all(abs(ours - theirs) <= 3 for (_, ours), (_, theirs) in zip(zones, stated, strict=True))
    assert any("Bentall" in note.source for note in found.validity)
    assert not any("Bentall" in note.source for note in begun(distance=0.1, points=1).validity)


def test_with_hardly_any_friction_they_creep_as_bentall_and_johnson():
    """All slips: forwards where the pressure is low, backwards over the middle that bears half of the force."""
    assert unlike(1e-3).solve().longitudinal_creepage[-1] == pytest.approx(5.259156e-4, rel=2e-3)


@pytest.mark.parametrize("ratio", [0.0, 1e-6, -0.64, 0.9999])
def test_other_forces(ratio):
    found = begun(ratio=ratio, distance=12.0, points=3, count=40)
    np.testing.assert_allclose(found.shear_force_per_length, ratio * MOST, rtol=1e-12, atol=1e-18)
    limit = found.steady.longitudinal_creepage
    assert found.longitudinal_creepage[-1] == pytest.approx(limit, rel=0.011, abs=1e-12)


def test_a_march_that_was_stopped_keeps_what_it_reached():
    problem = wk.LineRollingStart(BED, MU, wk.LineShearForce(0.5 * MOST), LOAD, distance=1.0, points=10, count=20)
    states = list(itertools.islice(problem.steps(), 4))
    part, whole = problem.gathered(states), problem.solve()
    assert problem.total == 11
    np.testing.assert_array_equal(part.longitudinal_creepage, whole.longitudinal_creepage[:4])
    np.testing.assert_allclose(whole.distance, np.arange(11) * 0.1, atol=1e-12)


@pytest.mark.parametrize(
    ("drive", "more", "error", "sentence"),
    [
        (wk.LineShearForce(MOST), {}, wk.OutsideValidity, "the friction limit at rest is"),
        (wk.LineShearForce(0.1 * MOST), {"distance": 1e6}, wk.OutsideValidity, "give a shorter one"),
        (wk.Creepage(1e-3), {}, wk.InvalidInput, "Give the distance `reference`"),
        (wk.Creepage(1e-3), {"reference": 1.5}, wk.OutsideValidity, "nearer than 2 half-widths"),
        (wk.Creepage([1e-3, 2e-3]), {"reference": 9.0}, wk.InvalidInput, "with one number"),
        (wk.Creepage(1e-3, spin=1.0), {"reference": 9.0}, wk.OutsideValidity, "a lateral part or a spin"),
    ],
)
def test_what_has_no_answer_is_refused(drive, more, error, sentence):
    with pytest.raises(error, match=sentence):
        wk.LineRollingStart(BED, MU, drive, LOAD, **({"distance": 1.0} | more)).solve()
