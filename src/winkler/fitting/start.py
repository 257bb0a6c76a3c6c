"""Where a fit begins: a rough contact point, moduli and works of adhesion that meet the largest and the least force.

A force is proportional to all moduli at once, a pull-off nearly so to the work of adhesion, whatever the shape; so a
few divisions lead from any value of the model to the right size.  Which of several contact points is best, a coarse fit
to a part of the points decides.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.fitting.curves.checks import Outline, outline
from winkler.fitting.parameters import unit_of
from winkler.fitting.prediction import Model, runs_of, states_for
from winkler.fitting.response import Response, response
from winkler.fitting.search import Search
from winkler.fitting.task import OF_THE_CURVE, Parameter, Prediction, Task
from winkler.numerics.types import Array
from winkler.problems.adhesion.indentation import AdhesiveIndentation

__all__ = ["SHARES", "best_start", "bounds", "least", "solved"]

SHARES = (0.0, 0.1, 0.3, -0.1)
"""How far before the rough contact point a start lies, in parts of the rest."""
COARSE = 200
TRIED = 2
"""How many starts a coarse fit improves."""
FARTHEST = 30.0
"""How far a logarithm may stray from its start."""
ROUNDS = 6
HOPELESS = 10.0
"""Residual of numbers that the theory refuses, in the norm of the measured forces."""
SETTLED = 1e-10


def solved(
    task: Task, coordinates: Array, evaluations: int, search: Search, settled: float = SETTLED
) -> tuple[Array, float]:
    """Return the coordinates of least squares, and the sum there.

    Parameters
    ----------
    task : Task
    coordinates : ndarray, (p,)
        Where to begin.
    evaluations : int
        How many predictions are allowed at most.
    search : Search
        Counts them.
    settled : float
        Relative change of sum and coordinates at which to stop.

    Raises
    ------
    NotConverged
        If they do not suffice (unless `settled` is coarse), or the time of the search is over.
    """
    last: dict[bytes, Prediction] = {}

    def predicted(at: Array) -> Prediction:
        key = at.tobytes()
        if key not in last:
            last.clear()
            last[key] = task.prediction(at)
        return last[key]

    return least(
        task.numbers,
        lambda at: predicted(at).force,
        lambda at: task.jacobian(at, predicted(at)),
        task.curve.force,
        task.weights,
        coordinates,
        bounds(task.parameters, coordinates),
        evaluations,
        search,
        settled,
    )


def least(
    numbers: Callable[[Array], dict[str, float]],
    predicted: Callable[[Array], Array],
    jacobian: Callable[[Array], Array],
    measured: Array,
    weights: Array,
    coordinates: Array,
    ends: tuple[Array, Array],
    evaluations: int,
    search: Search,
    settled: float = SETTLED,
) -> tuple[Array, float]:
    """Return the coordinates of least squares within their ends, and the sum there.

    Parameters
    ----------
    numbers, predicted, jacobian : callable
        Of coordinates: the numbers by name, what the model says ``(n,)``, and its weighted derivatives ``(n, p)``.
    measured, weights : ndarray, (n,)
    coordinates : ndarray, (p,)
        Where to begin.
    ends : tuple of ndarray
        Lowest and highest coordinates.
    evaluations, search, settled
        As for `solved`.

    Raises
    ------
    NotConverged
        As `solved`.
    """
    from scipy.optimize import least_squares

    low, high = ends
    room = 1e-9 * (1.0 + np.abs(coordinates))
    inside = np.maximum(np.minimum(coordinates, high - room), low + room)
    size = float(np.linalg.norm(measured * weights)) or 1.0

    count = int(np.count_nonzero(weights))
    search.begin()

    def misfit(at: Array) -> Array:
        try:
            left = np.asarray((predicted(at) - measured) * weights / size)
        except OutsideValidity:
            if np.array_equal(at, inside):
                raise
            left = np.full(measured.size, HOPELESS)  # where the theory does not reach, nothing is explained
        search.seen(numbers(at), float(left @ left) * size**2, count)
        return left

    def slopes(at: Array) -> Array:
        search.check()
        return np.asarray(jacobian(at) / size)

    answer = least_squares(
        misfit,
        inside,
        jac=slopes,
        bounds=(low, high),
        x_scale="jac",
        max_nfev=evaluations,
        ftol=settled,
        xtol=settled,
        gtol=1e-15,
    )
    if not answer.success and settled == SETTLED:
        raise NotConverged(
            f"fit: least squares have not settled after {evaluations} predictions; give bounds or starts nearer to the "
            "answer, or fewer free numbers."
        )
    return np.asarray(answer.x), float(2.0 * answer.cost) * size**2


def bounds(parameters: tuple[Parameter, ...], coordinates: Array) -> tuple[Array, Array]:
    """Return the lowest and highest coordinates, logarithms not too far from where they begin."""
    low = np.array([parameter.inward(parameter.low) for parameter in parameters])
    high = np.array([parameter.inward(parameter.high) for parameter in parameters])
    wide = np.array([FARTHEST if parameter.logarithmic else np.inf for parameter in parameters])
    return np.maximum(low, coordinates - wide), np.minimum(high, coordinates + wide)


def best_start(task: Task, search: Search) -> Array:
    """Return the coordinates from which a fit should begin."""
    strokes = outline(task.curve)
    parameter = next((p for p in task.parameters if p.name == "contact_point"), None)
    origins = [0.0]
    if parameter is not None:
        rest = max(float(task.curve.position.max()) - strokes.contact_point, 1e-3 * parameter.scale)
        origins = [strokes.contact_point - share * rest for share in SHARES]
        origins = [parameter.start] if parameter.told else np.clip(origins, parameter.low, parameter.high).tolist()
    begins = [_sized(task, strokes, origin) for origin in dict.fromkeys(origins)]
    if len(begins) == 1:
        return begins[0]
    coarse = _coarse(task)
    starts = []
    for begin in begins:
        starts.append((begin, float(np.sum(coarse.residuals(begin) ** 2))))
        search.seen(coarse.numbers(begin), starts[-1][1], coarse.curve.count)
    starts.sort(key=lambda start: start[1])
    return min((solved(coarse, begin, 25, search, 1e-3) for begin, _ in starts[:TRIED]), key=lambda start: start[1])[0]


def _coarse(task: Task) -> Task:
    """Return the task on a part of the points."""
    count = task.curve.count
    if count <= COARSE:
        return task
    kept = np.zeros(count, dtype=bool)
    for run in task.runs:
        many = max(3, round(COARSE * (run.stop - run.start) / count))
        kept[np.linspace(run.start, run.stop - 1, min(many, run.stop - run.start)).astype(int)] = True
    curve = task.curve.chosen(kept)
    return task._replace(curve=curve, weights=task.weights[kept], runs=runs_of(curve))


def _sized(task: Task, strokes: Outline, origin: float) -> Array:
    """Return coordinates with moduli and works of the right size for a contact point."""
    numbers: dict[str, float] = {p.name: p.start for p in task.parameters}
    told = {p.name for p in task.parameters if p.told}
    if "contact_point" in numbers and "contact_point" not in told:
        numbers["contact_point"] = origin
    if "baseline" in numbers and "baseline" not in told:
        numbers["baseline"] = strokes.baseline
    moduli = _named(task, told, "Pa", ("strength",))
    works = _named(task, told, "J/m^2", ())
    if moduli or works:
        _scale(task, strokes, numbers, moduli, works)
    low = {p.name: p for p in task.parameters}
    coordinates = [low[name].inward(float(np.clip(n, low[name].low, low[name].high))) for name, n in numbers.items()]
    return np.array(coordinates)


def _possible(task: Task, numbers: dict[str, float], works: list[str], depth: float) -> tuple[Model, Response]:
    """Return the model and what it answers, the works taken back until the theory allows them."""
    for _ in range(ROUNDS if works else 0):
        model = task.with_numbers(numbers)
        try:
            return model, response(states_for(model), 0.0, depth)
        except OutsideValidity:
            numbers.update({name: 0.05 * numbers[name] for name in works})
    model = task.with_numbers(numbers)
    return model, response(states_for(model), 0.0, depth)


def _named(task: Task, told: set[str], unit: str, without: tuple[str, ...]) -> list[str]:
    return [
        p.name
        for p in task.parameters
        if p.name not in told
        and p.name not in OF_THE_CURVE
        and p.name.rpartition(".")[2] not in without
        and unit_of(task.model, p.name) == unit
    ]


def _scale(task: Task, strokes: Outline, numbers: dict[str, float], moduli: list[str], works: list[str]) -> None:
    """Multiply moduli and works until the largest force and the pull-off have the right size."""
    origin = numbers.get("contact_point", 0.0)
    travel = float(task.curve.position.max()) - origin
    top = max(strokes.top, 1e-3 * float(np.ptp(task.curve.force)))
    depth = travel - task.curve.compliance * top
    depth = depth if depth > 1e-3 * abs(travel) else 1e-3 * abs(travel) + 1e-9 * float(np.ptp(task.curve.position))
    for _ in range(ROUNDS):
        worst = 1.0
        model, answer = _possible(task, numbers, works, depth)
        if moduli:
            force = float(answer.opening(np.array([depth]), np.inf).force[0])
            pull = -min(0.0, answer.loss()[1])
            share = float(np.clip((top + pull) / max(force + pull, 1e-6 * top), 1e-3, 1e3))
            worst = max(worst, share, 1.0 / share)
            numbers.update({name: numbers[name] * share for name in moduli})
        if works and isinstance(model, AdhesiveIndentation):
            wanted = max(strokes.pull, 2.0 * strokes.noise, 1e-4 * top)
            pull = -answer.loss()[1]
            share = float(np.clip(wanted / max(pull, 1e-6 * wanted), 1e-3, 1e3))
            worst = max(worst, share, 1.0 / share)
            numbers.update({name: numbers[name] * share for name in works})
        if worst < 1.2:
            return
