r"""Predicted force of a model at all positions of a measured curve, in contact and out of it.

The model gives the force in contact.  Without adhesion there is contact where D > 0.  With adhesion, jump-in and
pull-off are taken from the curve: vibration and noise separate a contact before its limit, and forces of long range
close one before first touch.  In each run the transition is therefore placed at the least squared misfit, and the
branch of the contact is continued a little beyond its limit, as if its edge were pinned.
"""

from __future__ import annotations

from typing import Any, NamedTuple, cast

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.elastic.model_tables import EACH_ANEW, ModelTables, Response
from winkler.fitting.elastic.response import ResponseValues, response
from winkler.fitting.validity import Model
from winkler.foundation.bed import Bed
from winkler.laws.adhesion import ShortRange
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import EdgeStates, FarStates, ShortStates
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.adhesion.law_states import states_of
from winkler.problems.normal.indentation import Indentation
from winkler.values.errors import InvalidInput

MOST_PULLS_BEYOND = 2.0
"""Greatest tension of the continued branch, in multiples of the pull-off force."""


class DirectionRun(NamedTuple):
    """Points from `start` to `stop` of one direction; `turn` is the largest position [m] before the retraction."""

    start: int
    stop: int
    inward: bool
    turn: float


class HeldContact(NamedTuple):
    """The contact continued to all points.

    Parameters
    ----------
    force, slope, radius : ndarray, (n,)
        [N], dF/dD [N/m], a [m].
    balanced : ndarray of bool, (n,)
        Where the edge is in the equilibrium of `response`; elsewhere it is pinned.
    response : MachineResponse or HomogeneousResponse
        Of the receding contact.
    adhesive : bool
        Whether it is adhesive.
    """

    force: Array
    slope: Array
    radius: Array
    balanced: Array
    response: Response
    adhesive: bool


def runs_of(curve: ForceCurve) -> tuple[DirectionRun, ...]:
    """Return the runs of one direction."""
    turns = np.flatnonzero(np.diff(curve.direction)) + 1
    edges = [0, *turns.tolist(), curve.count]
    runs: list[DirectionRun] = []
    for start, stop in zip(edges[:-1], edges[1:], strict=True):
        inward = bool(curve.direction[start] > 0.0)
        top = np.inf
        if not inward and runs and runs[-1].inward:
            top = max(float(curve.position[runs[-1].start : runs[-1].stop].max()), float(curve.position[start]))
        runs.append(DirectionRun(start, stop, inward, top))
    return tuple(runs)


def states_for(model: Model) -> EdgeStates:
    """Return the states of a model's contact, of a receding edge where that matters.

    Raises
    ------
    InvalidInput
        If this kind of model cannot be fitted.
    """
    match model:
        case Indentation():
            return FarStates(model.bed, 0.0)
        case AdhesiveIndentation():
            return states_of(model.bed, model.law)
        case _:
            raise InvalidInput(
                f"fit: the model is a {type(model).__name__}; give Indentation(bed, Depth(0.0)) or "
                "AdhesiveIndentation(bed, law, Depth(0.0))."
            )


def highest_of(position: Array) -> float:
    """Return the position [m] up to which a response is needed."""
    return max(float(position.max()), 1e-3 * float(np.ptp(position)))


def held_contact(
    model: Model,
    compliance: float,
    position: Array,
    runs: tuple[DirectionRun, ...],
    origin: float,
    tables: ModelTables = EACH_ANEW,
) -> HeldContact:
    """Return the contact continued to all positions D from first touch.

    Parameters
    ----------
    model : Indentation or AdhesiveIndentation
    compliance : float
        Of the machine [m/N].
    position : ndarray, (n,)
        D [m].
    runs : tuple of Run
        Its parts.
    origin : float
        The contact point [m], from which the turns of the runs count.
    tables : ModelTables, optional
        What models that differ in the free numbers share; nothing unless given.
    """
    highest = highest_of(position)
    receding = tables.response(states_for(model), compliance, highest)
    advancing: Response = receding
    law = cast(Any, model).law if isinstance(model, AdhesiveIndentation) else None
    hysteresis = isinstance(law, ShortRange) and law.work_closing != law.work_opening
    if isinstance(law, ShortRange) and hysteresis:
        closing = law.work_closing
        states = ShortStates(model.bed, closing) if closing > 0.0 else FarStates(model.bed, 0.0)
        advancing = response(states, compliance, highest)
    adhesive = isinstance(model, AdhesiveIndentation)
    if hysteresis:
        columns = np.empty((4, position.size))
        for run in runs:
            part = slice(run.start, run.stop)
            if run.inward:
                columns[:, part] = advancing.closing(position[part])
            elif np.isfinite(run.turn):
                columns[:, part] = _unloaded(
                    model.bed, advancing, receding, compliance, position[part], run.turn - origin
                )
            else:
                columns[:, part] = receding.opening(position[part], run.turn - origin)
        columns[3] = 0.0
    else:
        which = np.empty(position.shape, dtype=int)
        for run in runs:
            part = slice(run.start, run.stop)
            places = position[part]
            which[part] = receding.narrowest(places) if run.inward else receding.widest(places, run.turn - origin)
        columns = np.array(receding.on(which, position))
    if not adhesive:
        columns[:3, position <= 0.0] = 0.0
    force, slope, radius, balanced = columns
    return HeldContact(force, slope, radius, balanced > 0.0, receding, adhesive)


def moved_force(
    held: HeldContact, other: Model, compliance: float, where: Array, tables: ModelTables = EACH_ANEW
) -> Array:
    r"""Return the difference of force of a slightly changed model at the same positions ``(m,)``.

    With D(a) and F(a) of both, at the radius of the first, :math:`\delta F|_D = \delta F|_a - F'(D)\,\delta D|_a`.

    Parameters
    ----------
    held : HeldContact
        Prediction of the model.
    other : Indentation or AdhesiveIndentation
        The other model, `comparable` with the one of `held`.
    compliance : float
        Of the machine [m/N].
    where : ndarray of bool, (n,)
        The m points, all balanced.
    tables : ModelTables, optional
        As for `held_contact`.
    """
    values = ResponseValues(*(column[where] for column in (held.force, held.slope, held.radius, held.balanced)))
    level, force = tables.differences(held.response, states_for(other), compliance, values)
    return np.asarray(force - values.slope * level)


def comparable(model: Model, other: Model) -> bool:
    """Return whether `moved_force` may compare two models: equal kinks, reach and rim."""
    bed, other_bed = model.bed, other.bed
    return (bed.kinks, bed.reach, bed.rim) == (other_bed.kinks, other_bed.reach, other_bed.rim)


def _unloaded(
    bed: Bed, advancing: Response, receding: Response, compliance: float, position: Array, turn: float
) -> ResponseValues:
    """Return the response of a contact whose edge is at rest after the turn until it recedes."""
    top = advancing.closing(np.array([turn]))
    stiffness = bed.stiffness(top.radius)
    stiffness = stiffness / (1.0 + compliance * stiffness)
    pinned = top.force + stiffness * (position - turn)
    opened = receding.opening(position, turn)
    rests = opened.radius > top.radius
    return ResponseValues(
        np.where(rests, pinned, opened.force),
        np.where(rests, stiffness, opened.slope),
        np.where(rests, top.radius, opened.radius),
        opened.balanced,
    )


def attached(held: HeldContact, measured: Array, runs: tuple[DirectionRun, ...], weights: Array) -> Array:
    """Return the points in contact.

    Parameters
    ----------
    held : HeldContact
    measured : ndarray, (n,)
        Forces without the baseline, times the weights.
    runs : tuple of Run
    weights : ndarray, (n,)

    Returns
    -------
    ndarray of bool, (n,)
    """
    if not held.adhesive:
        return np.asarray(held.radius > 0.0)
    gain = measured**2 - (measured - weights * held.force) ** 2  # misfit explained by contact
    pull = min(held.response.least(), 0.0)
    gain[~held.balanced & (held.force < MOST_PULLS_BEYOND * pull)] = -np.inf
    result = np.zeros(measured.shape, dtype=bool)
    for run in runs:
        part = gain[run.start : run.stop]
        if run.inward:
            count = int(np.argmax(np.concatenate([[0.0], np.cumsum(part[::-1])])))
            result[run.stop - count : run.stop] = True
        else:
            count = int(np.argmax(np.concatenate([[0.0], np.cumsum(part)])))
            result[run.start : run.start + count] = True
    return result
