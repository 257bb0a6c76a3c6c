"""The laws of a row of cells that is moved and remembers, under every row that moves a round body, a line or a twist.

Closed forms of first loading, Masing's rule, mirrored and negated paths, energy, points in between, refusals; and each
row against every other where both hold.  One pair of bodies without Poisson's ratio stands for all rows: as it is, as
layers of its own solid, as a body that relaxes too slowly to be seen, and on pixels.
"""

from __future__ import annotations

import collections
import dataclasses
import itertools
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest

import winkler as wk
from winkler.problems.row import CURVED_STEP_TOLERANCE
from winkler.reference.friction import mindlin_returning_force, mindlin_shift, mindlin_stick_radius
from winkler.reference.torsion import ball_twist

SOLID = wk.Elastic(1.0, 0.0)
HALF = wk.HalfSpace.between(SOLID, SOLID)
LAYERS = wk.CoatedHalfSpace([wk.Layer(SOLID, 0.05)], SOLID, SOLID)
SLOW = wk.ViscoelasticHalfSpace(wk.StandardSolid(0.125, 0.125, 1e9, poisson=0.0))
RELAXED = wk.ViscoelasticHalfSpace(wk.StandardSolid(0.25, 0.25, 1e-9, poisson=0.0))
"""G = 0.25 under a rigid body, at once and in the end: E*, G* and G_t of the pair."""
SLOW_PAIR = wk.ViscoelasticHalfSpace(*2 * [wk.StandardSolid(0.25, 0.25, 1e9, poisson=0.0)])
RELAXED_PAIR = wk.ViscoelasticHalfSpace(*2 * [wk.StandardSolid(0.5, 0.5, 1e-9, poisson=0.0)])
"""The same of two bodies that are alike: pixels know that a rigid one is dissimilar."""
BALL, MU, A = wk.Paraboloid(1.0), 0.3, 0.1
DEPTH = A**2
FORCE = 4.0 / 3.0 * HALF.modulus * A**3
LINE = 0.25 * np.pi * HALF.modulus * A**2
"""Force per length at the half-width A [N/m]."""
LIMIT = 3.0 * np.pi / 16.0
"""Greatest torque over mu F a."""
FAR = MU * DEPTH * HALF.modulus / HALF.shear_modulus
TWIST = MU * FORCE / (HALF.torsional_modulus * A**2)


class Family(NamedTuple):
    """What moves, what it takes, what is lost; and what of each counts as much."""

    motion: str
    load: str
    lost: str
    far: float
    most: float


PUSH = Family("shift", "shear_force", "dissipation", FAR, MU * FORCE)
TURN = Family("angle", "torque", "dissipation", TWIST, LIMIT * MU * FORCE * A)
STRIP = Family("slip_shift", "shear_force_per_length", "dissipation_per_length", MU * A**2, MU * LINE)


class Row(NamedTuple):
    """A row: what it follows a path of loads with, and the error that it states or that its cells have.

    `error` is that of motion, load and loss over those of `Family` under a steady normal load, and as much as `curved`
    more where a prescribed force bends the steps.  Rows that are `steady` hold
    under a steady normal load alone.  `relaxes`: the friction loss is asked for, not all that is lost.
    """

    family: Family
    problem: Callable[[Any, Any], Any]
    error: float
    curved: float = 0.0
    steady: bool = False
    relaxes: bool = False


def pushed(medium, method=wk.Method.AUTO, in_plane=False, **more):
    def problem(normal, lateral):
        values = next(iter(vars(lateral).values()))
        if in_plane:
            lateral = type(lateral)(np.multiply.outer(values, [0.6, 0.8]))
        path = wk.Path(np.arange(len(values)), normal, lateral)
        return wk.Tangential(wk.Foundation(BALL, medium), wk.Coulomb(MU), path, method, **more)

    return problem


def turned(medium, **more):
    def problem(normal, lateral):
        path = wk.Path(np.arange(len(next(iter(vars(lateral).values())))), normal, lateral)
        return wk.Torsion(wk.Foundation(BALL, medium), wk.Coulomb(MU), path, **more)

    return problem


def on_a_map(medium):
    def problem(normal, lateral):
        heights = wk.SampledProfile([2.5 * A, 2.5 * A], BALL, (49, 49))
        path = wk.Path(np.arange(len(next(iter(vars(lateral).values())))), normal, lateral)
        return wk.SurfaceTangential(heights, medium, wk.Coulomb(MU), path)

    return problem


def on_a_line(medium, method=wk.Method.AUTO):
    def problem(normal, lateral, bulk=0.0):
        kind = wk.LayeredLineFoundation if medium is LAYERS else wk.LineFoundation
        time = {"time": np.arange(float(len(lateral)))} if medium in (SLOW, RELAXED) else {}
        path = wk.LinePath(normal, lateral, bulk_stress=bulk, **time)
        return wk.LineTangential(kind(BALL, medium), wk.Coulomb(MU), path, method)

    return problem


CURVED = 6 * CURVED_STEP_TOLERANCE
"""Of the five steps and the first of a random history."""
ROWS = {
    "springs by gap": Row(PUSH, pushed(HALF), 1e-12, CURVED),
    "springs one by one": Row(PUSH, pushed(HALF, wk.Method.SPRINGS, count=400), 2e-5, CURVED),
    "springs in the plane": Row(PUSH, pushed(HALF, in_plane=True, count=400), 2e-5, CURVED),
    "rings": Row(PUSH, pushed(LAYERS), 1e-12, CURVED),
    "relaxing springs": Row(PUSH, pushed(SLOW, count=400, tolerance=1e-5), 1e-4, relaxes=True),
    "relaxed springs": Row(PUSH, pushed(RELAXED, count=400, tolerance=1e-5), 1e-4, relaxes=True),
    "pixels": Row(PUSH, on_a_map(HALF), 1e-3, steady=True),
    "relaxing pixels": Row(PUSH, on_a_map(SLOW_PAIR), 1e-3, steady=True, relaxes=True),
    "relaxed pixels": Row(PUSH, on_a_map(RELAXED_PAIR), 1e-3, steady=True, relaxes=True),
    "a twist": Row(TURN, turned(HALF), 1e-12, CURVED),
    "a twist of rings": Row(TURN, turned(LAYERS), 1e-12, CURVED),
    "a twist of relaxing springs": Row(TURN, turned(SLOW, count=400, tolerance=1e-5), 1e-4, relaxes=True),
    "a twist of relaxed springs": Row(TURN, turned(RELAXED, count=400, tolerance=1e-5), 1e-4, relaxes=True),
    "a twist of pixels": Row(TURN, on_a_map(HALF), 1e-3, steady=True),
    "a twist of relaxing pixels": Row(TURN, on_a_map(SLOW_PAIR), 1e-3, steady=True, relaxes=True),
    "earlier strips": Row(STRIP, on_a_line(HALF), 1e-11),
    "elements of a line": Row(STRIP, on_a_line(HALF, wk.Method.ELEMENTS), 3e-4),
    "elements on layers": Row(STRIP, on_a_line(LAYERS), 3e-4),
    "relaxing elements": Row(STRIP, on_a_line(SLOW), 3e-4),
    "relaxed elements": Row(STRIP, on_a_line(RELAXED), 3e-4),
}
QUICK = {"springs by gap", "springs one by one", "rings", "a twist", "earlier strips"}
EACH = [pytest.param(name, marks=() if name in QUICK else pytest.mark.slow) for name in ROWS]


def answers(row: Row, problem: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return motion, load and loss over those of the family; what is in the plane along the direction of the path."""
    solution = problem.solve()
    lost = getattr(solution, "friction_loss" if row.relaxes else row.family.lost)
    columns = []
    for name in row.family[:2]:
        column = np.asarray(getattr(solution, name))
        if column.ndim == 2:
            direction = [0.6, 0.8] if isinstance(problem, wk.Tangential) else [1.0, 0.0]
            column = column @ direction
        columns.append(column)
    motion, load = columns
    return motion / row.family.far, load / row.family.most, np.asarray(lost) / (row.family.far * row.family.most)


def prescribed(family: Family, by_force: bool, normal: np.ndarray, by_load: bool, lateral: np.ndarray) -> Any:
    """Return loads: depths over DEPTH or the force that belongs to them, motions over `far` or loads over `most`."""
    if family is STRIP:
        return LINE * normal, MU * LINE * lateral
    across = wk.Force(FORCE * normal**1.5) if by_force else wk.Depth(DEPTH * normal)
    kinds = {PUSH: (wk.Shift, wk.ShearForce), TURN: (wk.Angle, wk.Torque)}[family]
    return across, kinds[by_load](lateral * (family.most if by_load else family.far))


def history(family: Family, seed: int, varying: bool, points: int = 6) -> tuple[np.ndarray, np.ndarray]:
    """Return a random history that friction bears, of depths and of motions or loads, over the greatest."""
    random = np.random.default_rng(seed)
    depth = random.uniform(0.5, 1.0, points) if varying else np.ones(points)
    return depth, np.append(0.0, random.uniform(-0.8, 0.8, points - 1)) * depth.min() ** (
        2.0 if family is TURN else 1.5
    )


LOADS = [
    pytest.param(
        family, varying, by_force, by_load, marks=() if (by_force, by_load) == (True, True) else pytest.mark.slow
    )
    for family, varying, by_force, by_load in itertools.product([PUSH, TURN, STRIP], *3 * [[False, True]])
    if family is not STRIP or (by_force and by_load)
]
SEEDS = [0, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(1, 20))]


def holding(family: Family, varying: bool) -> dict[str, Row]:
    """Return the rows of a family that hold where the normal load varies."""
    return {name: row for name, row in ROWS.items() if row.family is family and not (varying and row.steady)}


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(("family", "varying", "by_force", "by_load"), LOADS)
def test_each_row_as_every_other(family, varying, by_force, by_load, seed):
    depth, lateral = history(family, seed, varying)
    loads = prescribed(family, by_force, depth, by_load, lateral)
    rows = holding(family, varying)
    found = {name: answers(row, row.problem(*loads)) for name, row in rows.items()}
    assert len(found) > 3
    for one, two in itertools.combinations(found, 2):
        allowed = sum(rows[name].error + (rows[name].curved if varying else 0.0) for name in (one, two))
        np.testing.assert_allclose(found[one], found[two], rtol=0.0, atol=allowed, err_msg=f"{one}, {two}")


PARTS = np.array([0.1, 0.3, 0.5, 0.8, 0.95])
LUBKIN = np.array(
    [
        (0.9, 0.0385138791, 0.1763453815),
        (0.7, 0.1234362505, 0.4097384796),
        (0.5, 0.2257118580, 0.5285759656),
        (0.3, 0.3655699474, 0.5768680426),
    ]
)
"""Stick radius over a, angle over mu F / (G a^2), torque over mu F a: J. L. Lubkin, J. Appl. Mech. 18 (1951) 183."""


def first_loading(family: Family) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return motion, load, loss and stick radius of a first loading, over the greatest, in closed form."""
    if family is PUSH:
        shift = mindlin_shift(MU * FORCE, HALF.shear_modulus, A, PARTS) / FAR
        under = shift - 0.4 * (1.0 - (1.0 - shift) ** 2.5)  # integral of the load over the motion
        return shift, PARTS, 2.0 * under - PARTS * shift, mindlin_stick_radius(A, PARTS) / A
    if family is TURN:
        core, angle, torque = LUBKIN.T
        node, weight = np.polynomial.legendre.leggauss(40)
        half, middle = 0.5 * (1.0 - core[:, None]), 0.5 * (1.0 + core[:, None])
        place = middle + half * node  # what sticks is a rigid disc: dM = 16/3 c^3 dphi
        stored_twice = core**3 * angle**2 + 3.0 * np.sum(half * weight * place**2 * ball_twist(place) ** 2, axis=1)
        return angle, torque / LIMIT, (torque * angle - 16.0 / 3.0 * stored_twice) / LIMIT, core
    core = A * np.sqrt(1.0 - PARTS)
    node, weight = np.polynomial.legendre.leggauss(200)
    turn = 0.25 * np.pi * (node + 1.0)
    shift, lost = np.empty(PARTS.size), np.empty(PARTS.size)
    for k, c in enumerate(core):
        x = np.sqrt(c**2 + (A**2 - c**2) * np.sin(turn) ** 2)
        width = 0.25 * np.pi * weight * (A**2 - c**2) * np.sin(turn) * np.cos(turn) / x
        opened = 0.5 * (x * np.sqrt(x**2 - c**2) - c**2 * np.arccosh(x / c))
        shift[k] = 2.0 * MU * np.sum(width * opened / (np.pi * np.sqrt(A**2 - x**2)))
        lost[k] = 2.0 * MU**2 * np.sum(width * opened * 0.5 * HALF.modulus * np.sqrt(A**2 - x**2))
    return shift / STRIP.far, PARTS, lost / (STRIP.far * STRIP.most), core / A


def stuck(solution: Any) -> np.ndarray:
    """Return the size of what sticks over that of the contact."""
    if hasattr(solution, "stick_share"):
        return np.sqrt(solution.stick_share)
    if hasattr(solution, "stick_half_width"):
        return solution.stick_half_width / solution.half_width
    return solution.stick_radius / solution.radius


@pytest.mark.parametrize("by_load", [False, True])
@pytest.mark.parametrize("name", EACH)
def test_a_first_loading_is_that_of_cattaneo_mindlin_and_lubkin(name, by_load):
    row = ROWS[name]
    motion, load, lost, core = first_loading(row.family)
    lateral = load if by_load or row.family is STRIP else motion
    lateral = np.append(0.0, lateral)  # at a first point bodies that relax are pressed and moved suddenly
    problem = row.problem(*prescribed(row.family, False, np.ones(lateral.size), by_load, lateral))
    found = answers(row, problem)
    digits = 1e-9 if row.family is TURN else 0.0  # of the table
    for one, two in zip(found, (motion, load, lost), strict=True):
        np.testing.assert_allclose(one[1:], two, rtol=0.0, atol=row.error + digits)
    np.testing.assert_allclose(stuck(problem.solve())[1:], core, rtol=0.0, atol=3e-2 if row.steady else 5e-3)


@pytest.mark.parametrize("name", EACH)
def test_turned_back_a_row_follows_its_first_loading_twice_as_large(name):
    """Masing: on the way back and forth, and a cycle loses four times what the first loading does."""
    row, most = ROWS[name], 0.8
    by_load = row.family is STRIP
    way = np.array([0.7, 0.2, -0.1, -0.5, -1.0]) * most
    halves = 0.5 * (most - way)

    def followed(lateral):
        lateral = np.append(0.0, lateral)
        problem = row.problem(*prescribed(row.family, False, np.ones(lateral.size), by_load, lateral))
        return [column[1:] for column in answers(row, problem)]

    first = followed(halves)
    loop = followed(np.concatenate([[most], way, -way]))
    free = 0 if by_load else 1  # what is not prescribed
    top = first[free][-1]
    np.testing.assert_allclose(loop[free][1:6], top - 2.0 * first[free], rtol=0.0, atol=4.0 * row.error)
    np.testing.assert_allclose(loop[free][6:], 2.0 * first[free] - top, rtol=0.0, atol=4.0 * row.error)
    if row.family is PUSH:
        back = mindlin_returning_force(MU * FORCE, HALF.shear_modulus, A, most * FAR, way * FAR)
        np.testing.assert_allclose(loop[1][1:6], back / row.family.most, rtol=0.0, atol=2.0 * row.error)
    assert loop[2][-1] - loop[2][0] == pytest.approx(4.0 * first[2][-1], abs=8.0 * row.error)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", EACH)
def test_a_negated_path_bears_and_loses_the_same(name, seed):
    row = ROWS[name]
    by_force, by_load = divmod(seed % 4, 2)
    depth, lateral = history(row.family, seed, not row.steady)
    there, back = (
        answers(row, row.problem(*prescribed(row.family, bool(by_force), depth, bool(by_load), sign * lateral)))
        for sign in (1.0, -1.0)
    )
    for one, two, sign in zip(there, back, (-1.0, -1.0, 1.0), strict=True):
        np.testing.assert_allclose(two, sign * one, rtol=1e-9, atol=1e-9 if row.steady else 1e-11)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(20))
@pytest.mark.parametrize("name", ["springs in the plane", "pixels"])
def test_a_mirrored_path_in_the_plane_bears_the_mirrored_force(name, seed):
    row, mirror = ROWS[name], np.array([1.0, -1.0])
    depth, _ = history(PUSH, seed, not row.steady)
    lateral = FAR * np.random.default_rng(seed).uniform(-0.6, 0.6, (depth.size, 2))
    path = wk.Path(np.arange(depth.size), wk.Depth(DEPTH * depth), wk.Shift(lateral))
    one = row.problem(wk.Depth(DEPTH * depth), wk.Shift(lateral[:, 0]))
    one = dataclasses.replace(one, path=path)
    other = dataclasses.replace(one, path=wk.Path(path.time, path.normal, wk.Shift(lateral * mirror)))
    one, other = one.solve(), other.solve()
    np.testing.assert_allclose(other.shear_force, one.shear_force * mirror, rtol=0.0, atol=1e-9 * MU * FORCE)
    np.testing.assert_allclose(other.dissipation, one.dissipation, rtol=1e-7)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", [name for name in EACH if ROWS[name.values[0]].family is STRIP])
def test_a_mirrored_line_sticks_at_the_mirrored_place(name, seed):
    """A bulk stress is the same from the other side, a shear force is not."""
    depth, lateral = history(STRIP, seed, False)
    normal, lateral = prescribed(STRIP, True, depth, True, lateral)
    bulk = 0.3 * MU * HALF.modulus * A * np.random.default_rng(seed).uniform(-1.0, 1.0, lateral.size)
    one, other = (ROWS[name].problem(normal, sign * 0.5 * lateral, bulk).solve() for sign in (1.0, -1.0))
    np.testing.assert_allclose(other.stick_middle, -one.stick_middle, rtol=0.0, atol=1e-9 * A)
    np.testing.assert_allclose(other.dissipation_per_length, one.dissipation_per_length, rtol=1e-9)
    assert np.max(np.abs(one.stick_middle)) > 0.01 * A


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", EACH)
def test_work_is_stored_or_lost_and_no_loss_comes_back(name, seed):
    row = ROWS[name]
    by_force, by_load = divmod(seed % 4, 2)
    depth, lateral = history(row.family, seed, not row.steady)
    solution = row.problem(*prescribed(row.family, bool(by_force), depth, bool(by_load), lateral)).solve()
    lost = getattr(solution, row.family.lost)
    assert np.all(np.diff(lost) >= 0.0)
    assert lost[-1] > 0.0
    if row.steady or row.family is STRIP:
        return
    missed = solution.work - solution.stored_energy - lost
    assert np.max(np.abs(missed)) < 1e-9 * np.max(solution.work) + row.curved * row.family.far * row.family.most


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", EACH)
def test_points_in_between_change_nothing_beyond_the_stated_error(name, seed):
    row = ROWS[name]
    by_force, by_load = divmod(seed % 4, 2)
    depth, lateral = history(row.family, seed, not row.steady, points=4)
    loads = prescribed(row.family, bool(by_force), depth, bool(by_load), lateral)
    fine = np.linspace(0.0, 3.0, 10)

    def between(load):
        if isinstance(load, np.ndarray):
            return np.interp(fine, np.arange(4.0), load)
        (values,) = vars(load).values()
        return type(load)(np.interp(fine, np.arange(4.0), values))

    one = answers(row, row.problem(*loads))
    two = answers(row, row.problem(*map(between, loads)))
    for first, second in zip(one, two, strict=True):
        np.testing.assert_allclose(second[::3], first, rtol=0.0, atol=2.0 * (row.error + row.curved))


BEYOND, AT = np.array([0.0, 0.5, -0.4, 0.3, 1.5, 0.2]), 4
"""Parts of what friction bears; the last but one is more than all of it."""
VARYING = np.array([1.0, 1.2, 0.9, 1.1, 0.8, 1.0])


@pytest.mark.parametrize("varying", [False, True])
@pytest.mark.parametrize("name", EACH)
def test_more_than_friction_bears_is_refused_at_its_point_and_what_came_before_stands(name, varying):
    row, kept = ROWS[name], []
    normal = VARYING if varying else np.ones(6)
    borne = normal ** (2.0 if row.family is TURN else 1.5 if row.family is PUSH else 1.0)
    problem = row.problem(*prescribed(row.family, True, normal, True, BEYOND * borne))
    with pytest.raises(wk.OutsideValidity, match=rf"^{type(problem).__name__}: at index {AT} of the path"):
        collections.deque(map(kept.append, problem.steps()), maxlen=0)
    assert len(kept) == AT
    before = problem.gathered(kept)
    found = np.reshape(getattr(before, row.family.load), (AT, -1))
    found = found @ [0.6, 0.8] if "plane" in name else found[:, 0]
    np.testing.assert_allclose(found / row.family.most, (BEYOND * borne)[:AT], rtol=1e-7, atol=1e-7)
    assert all(note.statement for note in before.validity)
