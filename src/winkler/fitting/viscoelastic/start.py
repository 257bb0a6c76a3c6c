"""Start of a fit of a relaxing contact: trial contact points, times and exponents, moduli by linear least squares.

At a measured depth the force is proportional to each modulus, so that nonnegative moduli follow from
one linear problem for each trial; a few points suffice for the choice between trials.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np

from winkler.fitting.curves.checks import CurveOutline
from winkler.fitting.parameters import unit_of
from winkler.fitting.start import contact_points
from winkler.fitting.task import FitTask
from winkler.fitting.varied import Parameter
from winkler.fitting.viscoelastic.response import elastic_table, forces
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.march import elastic_like, relaxation_of

EXPONENT_TRIALS = (0.1, 0.3, 0.6)
SINGLE_TIME_SHARES = (0.003, 0.03, 0.3)
"""Trials of a single time, over the time in contact."""
TIME_SPREADS = ((0.003, 0.3), (0.001, 1.0), (0.01, 0.1))
"""Trials of the shortest and the longest of several times, over the time in contact."""
TIMES = ("relaxation_time", "relaxation_times", "retardation_times")
NEGLIGIBLE = 1e-6
FEWEST_FREE_POINTS = 10
LEAST_MODULUS_SHARE = 1e-3
"""Start of a modulus that vanishes in linear least squares, relative to the greatest."""


def window(task: FitTask) -> tuple[float, float]:
    """Return the sampling interval and the duration of approach and hold in contact [s].

    The curve does not determine times much shorter or longer.
    """
    curve = task.curve
    pressed = np.flatnonzero(task.weights > 0.0)
    early = curve.force[: max(3, curve.count // 50)]
    low = float(np.median(early)) if curve.direction[0] > 0.0 else float(curve.force.min())
    high = curve.force >= low + 0.1 * (float(curve.force.max()) - low)
    held = (curve.direction == 0.0) & (np.arange(curve.count) >= np.argmax(high))
    observed = np.flatnonzero((task.weights > 0.0) & (high | held))
    if observed.size < 2:
        observed = pressed
    steps = np.diff(curve.time)
    return float(np.median(steps[steps > 0.0])), float(curve.time[observed[-1]] - curve.time[observed[0]])


def starts(task: FitTask, rough_outline: CurveOutline | None) -> Iterator[Array]:
    """Yield the coordinates from which a fit may begin.

    Parameters
    ----------
    task : FitTask
    rough_outline : CurveOutline or None
        Rough outline of the approach; None without an approach.
    """
    for numbers in trials(task, rough_outline):
        yield _sized(task.coarse, numbers)


def trials(task: FitTask, rough_outline: CurveOutline | None) -> list[dict[str, float]]:
    """Return the parameters of all trials, with the moduli of the model."""
    begin = {p.name: p.start for p in task.parameters}
    choices: list[list[dict[str, float]]] = []
    by_name = {p.name: p for p in task.parameters}
    point = by_name.get("contact_point")
    if rough_outline is not None:
        if "baseline" in by_name and not by_name["baseline"].has_start:
            begin["baseline"] = rough_outline.baseline
        if point is not None and not point.has_start:
            places = dict.fromkeys(contact_points(task, point, rough_outline))
            choices.append([{"contact_point": point.inside(place)} for place in places])
    elif point is not None and not point.has_start:
        low = float(task.curve.depth(0.0).min())
        choices.append([{"contact_point": point.inside(low - share * point.scale)} for share in (0.1, 1.0, 5.0)])
    times = [p for p in task.parameters if not p.has_start and field_name(p.name) in TIMES]
    if times:
        _, duration = window(task)
        spans = [(one, one) for one in SINGLE_TIME_SHARES] if len(times) == 1 else list(TIME_SPREADS)
        rows = [np.geomspace(low, high, len(times)) * duration for low, high in spans]
        own = {p.name: p.start for p in times}
        trials = [{p.name: p.inside(number) for p, number in zip(times, row.tolist(), strict=True)} for row in rows]
        choices.append([own, *trials])
    solid = [p for p in task.parameters if not p.has_start and p.name.startswith("bed.medium.")]
    shapes = [p for p in solid if field_name(p.name) == "exponent"]
    if shapes:
        choices.append([{p.name: p.inside(number) for p in shapes} for number in EXPONENT_TRIALS])
    combined = []
    for many in itertools.product(*reversed(choices)):  # contact points last, so that the series is reused
        numbers = dict(begin)
        for one in many:
            numbers |= one
        combined.append(numbers)
    return combined


def field_name(name: str) -> str:
    """Return the last field of a path, without an index."""
    return name.rpartition(".")[2].partition("[")[0]


def _sized(task: FitTask, numbers: dict[str, float]) -> Array:
    """Return the coordinates of parameters with moduli of the right magnitude."""
    from scipy.optimize import nnls

    moduli = [p for p in task.parameters if not p.has_start and is_modulus(task, p)]
    if moduli:
        own = {p.name: numbers[p.name] for p in moduli}
        depth = task.place(numbers) - task.curve.compliance * (task.curve.force - task.line(numbers))
        early = np.arange(depth.size) < task.turn
        right_side = (task.curve.force - task.line(numbers))[early]
        unit = max(own.values())
        small = dict.fromkeys(own, NEGLIGIBLE * unit)
        nothing = _at_depth(task, numbers | small, depth)[early]
        columns = [(_at_depth(task, numbers | small | {name: unit}, depth)[early] - nothing) for name in own]
        matrix = np.stack(columns, axis=1)
        has_free_part = np.count_nonzero(depth[: task.turn] < 0.0) >= FEWEST_FREE_POINTS
        if "baseline" in numbers and task.turn and not has_free_part:
            matrix = np.column_stack([matrix, np.ones(right_side.size), -np.ones(right_side.size)])
        sizes = np.linalg.norm(matrix, axis=0)
        sizes[sizes == 0.0] = 1.0
        amounts = nnls(matrix / sizes, right_side - nothing)[0] / sizes
        if matrix.shape[1] > len(own):
            numbers = numbers | {"baseline": numbers["baseline"] + float(amounts[-2] - amounts[-1])}
            amounts = amounts[:-2]
        most = float(amounts.max()) or 1.0
        amounts = np.maximum(amounts, LEAST_MODULUS_SHARE * most)
        numbers = numbers | {p.name: p.inside(float(a) * unit) for p, a in zip(moduli, amounts, strict=True)}
    return np.array([p.inward(p.inside(numbers[p.name])) for p in task.parameters])


def is_modulus(task: FitTask, parameter: Parameter) -> bool:
    """Return whether the force at a given depth is proportional to it, or nearly so with an elastic second body."""
    own = parameter.name.startswith("bed.medium.") and field_name(parameter.name) not in ("young", "tolerance")
    return own and unit_of(task.model, parameter.name) in ("Pa", "Pa s")


def _at_depth(task: FitTask, numbers: dict[str, float], depth: Array) -> Array:
    """Return the forces at measured depths; as of a loading."""
    model = task.with_numbers(numbers)
    highest = max(float(depth.max()), 1e-30)
    table = elastic_table(elastic_like(model.bed), highest)
    return forces(table, relaxation_of("fit", model.bed), task.curve.time, depth, depth.size, 0.0).force
