"""Setup of the fit of a relaxing contact: free parameters, input, and weights."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fitting.curves.checks import CurveOutline, Flag, outline, refuse
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.outline import FEWEST
from winkler.fitting.parameters import each
from winkler.fitting.task import even_weights
from winkler.fitting.varied import NATURAL_BOUNDS, parameters_of
from winkler.fitting.viscoelastic.acceleration import tip_acceleration
from winkler.fitting.viscoelastic.creep import FORCE_FIT_SHARE, LEAST_NOISE, UnderForce
from winkler.fitting.viscoelastic.cycles import UnderCycles, goes_in_again
from winkler.fitting.viscoelastic.layered_task import LayeredForce, LayeredMotion, refuse_stack_numbers
from winkler.fitting.viscoelastic.motion import UnderMotion
from winkler.fitting.viscoelastic.task import RelaxingTask
from winkler.loading.loads import Depth
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.errors import InvalidInput

__all__ = ["driven_task", "examined_stroke"]

STEADY_CHANGE = 0.05
"""Greatest relative change of a constant force."""
EXPONENT_BOUNDS = (1e-3, 0.999)
"""Bounds of the exponent of a solid."""
SMOOTHING_DIVISOR = 100
"""The velocity is smoothed over this part of the points."""
SOFT_SHARE = 0.2
"""Greatest deflection of the machine relative to its travel with which repeated cycles are fitted."""
SIGNAL_TO_NOISE = 5.0
"""Least force over its noise from which on positions are fitted."""


def examined_stroke(curve: ForceCurve) -> tuple[CurveOutline | None, tuple[Flag, ...]]:
    """Return the rough outline of the approach, if there is one, and its flags.

    Raises
    ------
    InvalidInput
        If the curve has no times, begins with the retraction, or is refused (see `winkler.fitting.curves.checks`).
    """
    if not curve.timed:
        raise InvalidInput(f"fit: curve '{curve.name}' has no times, and a solid that relaxes needs them.")
    rough_outline = curve.direction[np.concatenate([[True], np.diff(curve.direction) != 0.0])]
    out = np.flatnonzero(rough_outline < 0.0)
    if out.size and out[0] == 0:
        raise InvalidInput(
            f"fit: curve '{curve.name}' begins with the retraction; fit an approach, with what follows it."
        )
    first_out = np.flatnonzero(curve.direction < 0.0)
    inward = curve.direction > 0.0
    if first_out.size:
        inward[first_out[0] :] = False  # of repeated cycles the first approach
    if np.count_nonzero(inward) < FEWEST:
        return None, ()
    force = curve.force[inward]
    if np.ptp(force) < STEADY_CHANGE * np.abs(force).max():  # a constant weight
        return None, ()
    approach = curve.chosen(inward)
    flags = refuse(approach, but=("saturated",))  # a constant force is not a saturated detector
    return outline(approach), flags


def _velocity(curve: ForceCurve) -> Array:
    """Return the velocity of the machine [m/s], smoothed within each part of one direction, zero during holds."""
    velocity = np.zeros(curve.count)
    turns = np.flatnonzero(np.diff(curve.direction)) + 1
    for stretch in np.split(np.arange(curve.count), turns):
        time, position = curve.time[stretch], curve.position[stretch]
        if curve.direction[stretch[0]] == 0.0 or stretch.size < 3 or not np.all(np.diff(time) > 0.0):
            continue
        wide = max(1, stretch.size // SMOOTHING_DIVISOR)
        high = np.minimum(np.arange(stretch.size) + wide, stretch.size - 1)
        low = np.maximum(np.arange(stretch.size) - wide, 0)
        velocity[stretch] = (position[high] - position[low]) / (time[high] - time[low])
    return velocity


def driven_task(
    curve: ForceCurve,
    model: ViscoelasticIndentation,
    free: dict[str, Any],
    noise: Array,
    rough_outline: CurveOutline | None,
) -> RelaxingTask:
    """Return the task of a fit.

    Parameters
    ----------
    curve : ForceCurve
        With times: an approach, holds, retractions, and further cycles.
    model : ViscoelasticIndentation
        Its path is a placeholder: of depths for a fit of forces; of forces for a fit of positions.
    free : dict
        As for `winkler.fitting.elastic.task.elastic_task`; the name of an array means each of its numbers.
    noise : ndarray
        Standard deviation of the fitted quantity, ``()`` or ``(n,)``; zero if unknown.
    rough_outline : CurveOutline or None
        Rough outline of the approach; None without an approach.

    Raises
    ------
    InvalidInput
        If a path does not exist, its bounds are inconsistent, or a retraction is to be fitted under forces.
    """
    strength = float(np.ptp(curve.force))
    span = float(np.ptp(curve.position)) or float(np.abs(curve.position).max())
    duration = float(np.ptp(curve.time))
    if not (strength > 0.0 or span > 0.0) or not duration > 0.0:
        raise InvalidInput(f"fit: the curve '{curve.name}' has no range of forces or times; nothing can be fitted.")
    strength = strength or float(np.abs(curve.force).max())
    velocity = _velocity(curve)
    fastest = float(np.abs(velocity).max()) or span / duration
    scales = {
        "contact_point": 0.1 * span,
        "baseline": strength,
        "tilt": strength / span,
        "drift": span / duration,
        "drag": strength / fastest,
        "inertia": 1.0,
    }
    free_paths = {
        path: stated for name, stated in free.items() for path in (each(model, name) if "." in name else (name,))
    }
    acceleration = tip_acceleration(curve) if "inertia" in free_paths else None
    if acceleration is not None:
        scales["inertia"] = strength / (float(np.abs(acceleration).max()) or 1.0)
    weights = even_weights(curve, noise)
    exponents = {
        name: EXPONENT_BOUNDS for name in free_paths if name.startswith("bed.medium.") and name.endswith(".exponent")
    }
    parameters = parameters_of(model, free_paths, scales, NATURAL_BOUNDS | exponents)
    zeros = np.zeros(curve.count)
    layered = isinstance(model.bed.medium, ViscoelasticCoatedHalfSpace)
    if layered:
        refuse_stack_numbers(model.bed, tuple(parameter.name for parameter in parameters))
    if isinstance(model.path.normal, Depth) and goes_in_again(curve) and not layered:
        bent = curve.compliance * strength
        if bent > SOFT_SHARE * span:
            raise InvalidInput(
                f"fit: curve '{curve.name}' goes in again, and the machine bends by {bent:.3g} m of {span:.3g} "
                f"m; cycles "
                "are fitted along the measured depth of a stiff machine only: fit one approach and its retraction."
            )
        return UnderCycles(curve, model, parameters, weights, velocity, zeros, acceleration=acceleration)
    if isinstance(model.path.normal, Depth):
        along = LayeredMotion if layered else UnderMotion
        return along(curve, model, parameters, weights, velocity, zeros, acceleration=acceleration)
    if acceleration is not None:
        raise InvalidInput(
            "fit: 'inertia' acts on the force, and here positions are fitted; leave it out, or fit forces."
        )
    if np.any(curve.direction < 0.0):
        raise InvalidInput(
            "fit: positions follow from forces only while a contact grows; leave out the retraction, or fit forces."
        )
    under = LayeredForce if layered else UnderForce
    task = under(curve, model, parameters, weights, velocity, zeros)
    return task if rough_outline is None else _with_approach(task, rough_outline, noise)


def _with_approach(task: UnderForce, rough_outline: CurveOutline, noise: Array) -> UnderForce:
    """Return the task with forces fitted at small loads, with approximate weights."""
    curve = task.curve
    borne = curve.force - rough_outline.baseline
    little = borne < max(FORCE_FIT_SHARE * float(borne.max()), SIGNAL_TO_NOISE * rough_outline.noise)
    many = np.count_nonzero(little[: 1 + int(np.argmax(borne))])  # their number, independent of their noise
    early = np.arange(curve.count) < many
    late = np.flatnonzero(~early)
    rough = np.abs(np.diff(curve.position[late], 2)) if late.size > 2 else np.zeros(1)
    own = float(np.mean(noise)) or float(np.median(rough)) / (0.6745 * np.sqrt(6.0))
    own = max(own, LEAST_NOISE * float(np.ptp(curve.position)))
    of_force = max(rough_outline.noise, LEAST_NOISE * float(np.ptp(curve.force)))
    return task._replace(weights=np.where(early, 1.0, task.weights), per_force=np.where(early, own / of_force, 0.0))
