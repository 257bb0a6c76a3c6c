r"""Least squares of several curves at once, first plain, then under the noise of each.

With the residuals :math:`r_i` of curve i the plain sum is :math:`\sum n_i \ln|r_i|^2`, so that each curve is weighed by
its own scatter.  Then every curve has its own white and slow noise (`winkler.fitting.noise`), of which its information
follows; combinations of numbers that one curve does not determine have none, and may be determined by the others.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from winkler.fitting.generalised import Generalised
from winkler.fitting.least_squares import bounds
from winkler.fitting.noise.estimate import noise_of
from winkler.fitting.search import Search
from winkler.fitting.several.arrowhead import CurveBlock, reduced, solved_blocks
from winkler.fitting.several.same_task import SameTask
from winkler.fitting.task import FitTask
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged, OutsideValidity

MOST_STEPS = 60
SETTLED = 1e-9
"""Relative decrease of the sum at which plain least squares stop."""
FIRST_DAMPING, GREATEST_DAMPING = 1e-3, 1e8
MOST_GENERALISED_STEPS, SETTLED_ERRORS, LONGEST_STEP = 6, 0.02, 1.0
LEAST_DIRECTION = 1e-6
"""Least effect of a combination of numbers, relative to the greatest, that counts as information of one curve."""
SINGULAR = 1e-12


class Joined(NamedTuple):
    """Curves at their joint numbers: fits, blocks, covariance of the shared numbers and of each curve."""

    states: list[Generalised]
    blocks: list[CurveBlock]
    shared: Array
    covariances: list[Array]


def joined(begun: Sequence[SameTask], names: Sequence[str], search: Search) -> Joined:
    """Return the joint fit of tasks whose shared numbers have the same coordinates.

    Parameters
    ----------
    begun : sequence of SameTask
    names : sequence of str
        Shared numbers.
    search : Search
        For its time limit.

    Raises
    ------
    NotConverged
        If least squares do not settle.
    OutsideValidity
        If the curves together do not determine the shared numbers.
    """
    tasks = [one.task for one in begun]
    places = [np.array([[p.name for p in task.parameters].index(name) for name in names]) for task in tasks]
    coordinates = _plain(tasks, places, [one.coordinates for one in begun], search)
    limits = [bounds(task.parameters, start) for task, start in zip(tasks, coordinates, strict=True)]
    for count in range(MOST_GENERALISED_STEPS + 1):
        search.check()
        made = [_block(task, at, place) for task, at, place in zip(tasks, coordinates, places, strict=True)]
        states, blocks = [one[0] for one in made], [one[1] for one in made]
        _refuse_singular(blocks, names)
        shared, steps, covariances = solved_blocks(blocks)
        relative = [
            float(np.max(np.abs(step) / np.sqrt(np.diag(covariance))))
            for step, covariance in zip(steps, covariances, strict=True)
        ]
        if max(relative) <= SETTLED_ERRORS or count == MOST_GENERALISED_STEPS:
            break
        longest = max(float(np.max(np.abs(step))) for step in steps)
        factor = min(1.0, LONGEST_STEP / longest)
        moved = [np.clip(at + factor * s, *limit) for at, s, limit in zip(coordinates, steps, limits, strict=True)]
        try:
            for task, at in zip(tasks, moved, strict=True):
                task.predicted(at)
        except OutsideValidity:
            break
        coordinates = moved
    return Joined(states, blocks, shared, covariances)


def _plain(tasks: list[FitTask], places: list[Array], coordinates: list[Array], search: Search) -> list[Array]:
    """Return coordinates of plain least squares, each curve weighed by its scatter."""
    limits = [bounds(task.parameters, start) for task, start in zip(tasks, coordinates, strict=True)]
    margins = [1e-9 * (1.0 + np.abs(start)) for start in coordinates]
    limits = [(low + margin, high - margin) for (low, high), margin in zip(limits, margins, strict=True)]
    coordinates = [np.clip(start, *limit) for start, limit in zip(coordinates, limits, strict=True)]
    sums = [float(np.sum(task.residuals(at) ** 2)) for task, at in zip(tasks, coordinates, strict=True)]
    counts = [int(np.count_nonzero(task.weights)) for task in tasks]
    damping = FIRST_DAMPING
    for _ in range(MOST_STEPS):
        search.check()
        blocks = []
        for task, at, place, total, count in zip(tasks, coordinates, places, sums, counts, strict=True):
            jacobian = task.slopes(at)
            residuals = (task.measured - task.predicted(at).fitted) * task.weights
            variance = max(total / count, np.finfo(float).tiny)
            blocks.append(CurveBlock(jacobian.T @ jacobian / variance, jacobian.T @ residuals / variance, place))
        while damping < GREATEST_DAMPING:
            search.check()
            steps = solved_blocks([_damped(block, damping) for block in blocks])[1]
            moved = [np.clip(at + step, *limit) for at, step, limit in zip(coordinates, steps, limits, strict=True)]
            try:
                after = [float(np.sum(task.residuals(at) ** 2)) for task, at in zip(tasks, moved, strict=True)]
            except OutsideValidity:
                damping *= 10.0
                continue
            gain = sum(n * np.log(max(s, 1e-300) / max(a, 1e-300)) for n, s, a in zip(counts, sums, after, strict=True))
            if gain > 0.0:
                break
            damping *= 10.0
        else:
            return coordinates
        coordinates, sums, damping = moved, after, 0.1 * damping
        if gain <= SETTLED * sum(counts):
            return coordinates
    raise NotConverged(
        f"fit: least squares of {len(tasks)} curves have not converged after {MOST_STEPS} steps; give bounds or "
        "starts nearer to the answer, or share fewer numbers."
    )


def _damped(block: CurveBlock, damping: float) -> CurveBlock:
    """Return a block with its diagonal enlarged, also where the curve does not determine a number."""
    diagonal = np.diag(block.information)
    size = np.maximum(diagonal, 1e-12 * diagonal.max())
    return block._replace(information=block.information + damping * np.diag(size))


def _block(task: FitTask, coordinates: Array, place: Array) -> tuple[Generalised, CurveBlock]:
    """Return a curve at its coordinates, and its information under its own noise."""
    prediction = task.predicted(coordinates)
    jacobian = task.instrument(coordinates, prediction)
    residuals = (task.measured - prediction.fitted) * task.weights
    size = np.maximum(np.linalg.norm(jacobian, axis=0), 1e-12 * float(np.linalg.norm(jacobian)))
    left, lengths, rows = np.linalg.svd(jacobian / size, full_matrices=False)
    kept = lengths > LEAST_DIRECTION * lengths[0]
    noise = noise_of(residuals, left[:, kept], task.disturbances, white=task.curve.has_white_noise)
    outward = (lengths[:, None] * rows)[kept] * size
    inverse = np.linalg.inv(noise.covariance)
    block = CurveBlock(outward.T @ inverse @ outward, outward.T @ (inverse @ noise.step), place)
    return Generalised(coordinates, prediction, residuals, noise), block


def _refuse_singular(blocks: list[CurveBlock], names: Sequence[str]) -> None:
    """Raise OutsideValidity if the curves together do not determine the shared numbers, or one its own."""
    sentence = "fit: the curves together do not determine {}; fix all but one of them."
    for block in blocks:
        own = block.information[np.ix_(block.own, block.own)]
        if own.size and _is_singular(own):
            raise OutsideValidity("fit: a curve does not determine its own numbers; share or fix more of them.")
    whole = np.sum([reduced(block).information for block in blocks], axis=0)
    if _is_singular(whole):
        raise OutsideValidity(sentence.format(" and ".join(names)))


def _is_singular(information: Array) -> bool:
    size = np.sqrt(np.diag(information))
    if not np.all(size > 0.0):
        return True
    return bool(np.linalg.eigvalsh(information / np.outer(size, size))[0] <= SINGULAR)
