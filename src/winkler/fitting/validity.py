"""Validity of a fit: range of adhesion, coating and substrate, shape of the tip, free points.

The notes of the contact hold for given parameters; these state whether the curve determines the fitted ones.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.foundation.bed import Bed
from winkler.foundation.foundation import Foundation
from winkler.laws.adhesion import Dugdale, ShortRange
from winkler.loading.loads import Depth
from winkler.media.offers import LayerStack, offers
from winkler.numerics.types import Array
from winkler.problems.adhesion import griffith
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.adhesion.pull_off import PullOff
from winkler.problems.assumptions.adhesion_range import GREENWOOD, range_note
from winkler.problems.normal.indentation import Indentation
from winkler.problems.plastic.indentation import PlasticIndentation
from winkler.profiles.power import Paraboloid
from winkler.profiles.sphere import Sphere
from winkler.values.errors import OutsideValidity
from winkler.values.readable import with_unit
from winkler.values.validity import Assumption, Note, Standing

Model = Indentation | AdhesiveIndentation | PlasticIndentation
"""Models of fits without relaxation: a problem, whose load or path is a placeholder."""

LEAST_STIFFNESS_CHANGE = 0.01
"""Least relative change of stiffness by a body that affects the curve."""
TOP_LAYER, LOWER_SOLIDS = "bed.medium.layers[0].solid.", ("bed.medium.on.", "bed.medium.layers[")
FEW_FREE = 20
LEAST_FREE_SHARE = 0.1
"""Least free part of a direction for a zero of force independent of the model."""
BALL_TOLERANCE = 0.01
"""Greatest negligible difference between ball and paraboloid."""
PUNCHES = "stiffness of flat punches of the same width"
POINTS = "count of the points in and out of contact"
BALLS = "force of a ball and of a paraboloid at the same depth, without adhesion"


def load_of(model: Model) -> Any:
    """Return the load of a model, or its path where it has one."""
    return model.path if isinstance(model, PlasticIndentation) else model.load


def with_load(model: Model, load: Any) -> Model:
    """Return a model under another load, or along another path where it has one."""
    name = "path" if isinstance(model, PlasticIndentation) else "load"
    return dataclasses.replace(model, **{name: load})


def fit_notes(
    model: Model, curve: ForceCurve, names: tuple[str, ...], contact: Array, widest: float, error: float
) -> tuple[Note, ...]:
    """Return the notes on the validity of a fit.

    Parameters
    ----------
    model : Indentation, AdhesiveIndentation or PlasticIndentation
        With the fitted numbers, at the largest depth.
    curve : ForceCurve
    names : tuple of str
        Free parameters.
    contact : ndarray of bool, (n,)
        Where the tip is in contact.
    widest : float
        The largest contact radius [m].
    error : float
        Standard deviation of the forces over their range [-].
    """
    notes = [*coating_notes(model.bed, names, widest), *_tip_notes(model, names, widest)]
    if isinstance(model, AdhesiveIndentation):
        notes += _range_notes(model)
    return (*notes, *free_notes(curve, contact, error))


def coating_notes(bed: Bed, names: tuple[str, ...], widest: float) -> list[Note]:
    """Return the note on coating and substrate, by the stiffness of the widest contact."""
    medium = bed.medium
    if not offers(medium, LayerStack):
        return []
    thickness = medium.thickness
    place = np.array([widest])
    stiffness = float(bed.stiffness(place)[0])
    alone = 2.0 * medium.modulus * widest
    below = stiffness / alone - 1.0
    deep = [name for name in names if name.startswith(LOWER_SOLIDS) and not name.startswith(TOP_LAYER)]
    standing = Standing.APPROXIMATE
    if abs(below) < LEAST_STIFFNESS_CHANGE:
        standing = Standing.OUTSIDE if deep else Standing.ASYMPTOTIC
        measured = "the coating was measured like a half-space"
        conclusion = f"the curve hardly depends on {', '.join(deep)}" if deep else measured
    elif deep and any(name.startswith(TOP_LAYER) for name in names):
        conclusion = "coating and substrate are distinguished only by the increase of this effect with depth"
    else:
        conclusion = "the fitted parameters depend on the fixed parameters of coating and substrate"
    statement = (
        f"Coating: the widest contact is {widest / thickness:.3g} of the thickness "
        f"{with_unit(thickness, 'm', 3)}. The material below the top layer changes its stiffness by "
        f"{float(f'{100.0 * below:.3g}'):+g} %: {conclusion}."
    )
    return [Note(Assumption.CURVE, standing, statement, PUNCHES)]


def _tip_notes(model: Model, names: tuple[str, ...], widest: float) -> Iterator[Note]:
    """Yield the notes on the shape of the tip."""
    bed = model.bed
    if not isinstance(bed, Foundation):
        return
    corners = [b for b, _ in bed.kinks if 0.0 < b < math.inf]
    if corners and widest < corners[0]:
        statement = (
            f"Tip: the widest contact, {with_unit(widest, 'm', 3)}, stays within the first part of the tip, which "
            f"ends at {with_unit(float(corners[0]), 'm', 3)}; the curve does not depend on the other parts."
        )
        yield Note(Assumption.SHAPE, Standing.EXACT, statement, "corners of the profile")
    profile = bed.profile
    if not isinstance(profile, Paraboloid) or isinstance(model, PlasticIndentation):
        return
    radius = profile.curvature_radius
    deepest = float(np.max(model.load.depth)) if isinstance(model.load, Depth) else 0.0
    if widest >= radius:
        standing = Standing.OUTSIDE
        conclusion = "a paraboloid differs from a ball at this width; if the tip is a ball, give Sphere"
    elif deepest > 0.0:
        load = Depth(deepest)
        ball = Foundation(Sphere(radius), bed.medium)
        share = float(Indentation(ball, load).solve().force / Indentation(bed, load).solve().force) - 1.0
        good = abs(share) < BALL_TOLERANCE
        standing = Standing.ASYMPTOTIC if good else Standing.APPROXIMATE
        end = "" if good else "; if it is one, give Sphere"
        conclusion = f"a ball of that radius would change the force by {share:+.2%}{end}"
    else:
        return
    fact = f"Tip: the widest contact is {widest / radius:.3g} of the tip's radius {with_unit(radius, 'm', 3)}"
    yield Note(Assumption.SHAPE, standing, f"{fact}: {conclusion}.", BALLS)


def _range_notes(model: AdhesiveIndentation) -> list[Note]:
    """Return the note on the range of attraction of the law with the fitted parameters."""
    law = model.law
    if isinstance(law, Dugdale):
        return []
    try:
        edge = PullOff(model.bed, ShortRange(law.work)).solve().radius
    except OutsideValidity as error:
        statement = f"Range: it cannot be assessed without a pull-off. {error}"
        return [Note(Assumption.ADHESION, Standing.APPROXIMATE, statement, GREENWOOD)]
    stretch = float(griffith.stretch(model.bed, law.work, np.array([edge]))[0])
    return [range_note(law, stretch, "Range: with the fitted numbers, at the pull-off")]


def free_notes(curve: ForceCurve, contact: Array, error: float) -> list[Note]:
    """Return the note on the points out of contact.

    Parameters
    ----------
    curve : ForceCurve
    contact : ndarray of bool, (n,)
        Where the tip is in contact.
    error : float
        Standard deviation of the forces over their range [-].
    """
    parts, is_poor = [], False
    for word, direction in (("approach", 1.0), ("retract", -1.0)):
        selected = curve.direction == direction
        if not selected.any():
            continue
        free = selected & ~contact
        count = int(np.count_nonzero(free))
        along = float(np.ptp(curve.position[free])) if count else 0.0
        share = along / max(float(np.ptp(curve.position[selected])), 1e-300)
        parts.append(f"{count} points over {with_unit(along, 'm', 3)} ({share:.0%} of the travel) on {word}")
        is_poor |= count < FEW_FREE or share < LEAST_FREE_SHARE
    statement = (
        f"Baseline: out of contact are {' and '.join(parts)}; the scatter is {error:.2g} of the force range. This "
        f"is {'too few' if is_poor else 'enough'} for the zero of force{', which depends on the model' * is_poor}."
    )
    return [Note(Assumption.CURVE, Standing.APPROXIMATE if is_poor else Standing.EXACT, statement, POINTS)]
