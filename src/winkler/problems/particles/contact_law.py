r"""A frictionless contact as a table for other programs: force, stiffnesses and radius over the depth.

Between two rows the force is the cubic through both forces and both stiffnesses (Hermite),

.. math:: F(d) = h_{00}F_0 + h_{10}\,\Delta\,k_0 + h_{01}F_1 + h_{11}\,\Delta\,k_1 ,

or, more simply, a straight line.  The stiffness of a growing contact never falls: the curve then lies below its chords
and above its tangents, and a straight line errs by no more than the height of the triangle between them.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import Depth
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.solve_contact import flat_radius
from winkler.problems.normal.stiffness_ratio import common_ratio
from winkler.values.checks.number_checks import Number, Positive
from winkler.values.errors import NotConverged
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

FIRST_INTERVALS = 8
"""Intervals at the beginning, closer towards the touch."""
MOST_HALVINGS, MOST_ROWS = 24, 100_000
"""Halvings of an interval, and rows, at most."""
CHECK_POSITIONS = np.array([0.15, 0.35, 0.5, 0.65, 0.85])
"""Where an interval is checked, as parts of it."""
SAFETY_FACTOR = 0.7
"""The error there stays below this part of what is allowed: it may be a little greater elsewhere."""
ONE_RATIO = (
    "no single number describes it: give a homogeneous or power-law medium, or march along a path with Tangential"
)


@value
class ContactLaw:
    """A table of a contact over depth, for discrete element or multibody programs.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium) or another one.
    deepest : float
        Maximum depth of the table [m], positive.
    tolerance : float, optional
        Maximum error of the force by cubic Hermite interpolation between two rows, over the maximum force.

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(10e-3), HalfSpace(Elastic(210e9, 0.3)))
    >>> law = ContactLaw(bed, deepest=5e-6, tolerance=1e-3).solve()
    >>> law.depth.size, bool(law.hermite_error < 1e-3)
    (9, True)
    """

    __words__ = words(deepest=("d", "m", "greatest depth of the table"))

    bed: Bed
    deepest: Positive
    tolerance: Annotated[float, Number("give a positive number below 0.1", 0.0, 0.1, (0.0, 0.1))] = 1e-6

    references: ClassVar[tuple[str, ...]] = Indentation.references
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def solve(self) -> ContactLawSolution:
        """Return the table, with rows at the depths that the tolerance requires.

        Raises
        ------
        OutsideValidity
            If the foundation does not reach so deep. If the ratio of tangential to normal stiffness varies between
            springs, so that no single number describes it.
        NotConverged
            If the tolerance would need more than 100 000 rows.
        """
        flat = first_radius(self.bed)
        depth = self.deepest * np.linspace(0.0, 1.0, FIRST_INTERVALS + 1) ** 2
        for _ in range(MOST_HALVINGS):
            pressed_ = Indentation(self.bed, Depth(depth)).solve()
            force, radius, stiffness = (
                np.array(part) for part in (pressed_.force, pressed_.radius, pressed_.stiffness)
            )
            radius[0], stiffness[0] = flat, float(self.bed.stiffness(np.array([flat]))[0])  # as it begins to touch
            errors = self._errors(depth, force, stiffness) / force[-1]
            coarse = np.flatnonzero(np.max(errors, axis=1) > SAFETY_FACTOR * self.tolerance)
            if not coarse.size:
                break
            if depth.size + coarse.size > MOST_ROWS:
                raise NotConverged(f"ContactLaw: more than {MOST_ROWS} rows would be needed; give a greater tolerance.")
            depth = np.sort(np.concatenate([depth, 0.5 * (depth[coarse] + depth[coarse + 1])]))
        else:
            raise NotConverged(
                f"ContactLaw: {depth.size} rows leave an error of {np.max(errors):.3g}; give a greater tolerance."
            )
        ratio = common_ratio("ContactLaw", self.bed, float(np.max(radius)), ONE_RATIO)
        return ContactLawSolution(
            self,
            depth,
            force,
            radius,
            stiffness,
            ratio * stiffness,
            np.asarray(pressed_.energy),
            float(np.max(errors)) / SAFETY_FACTOR,
            float(np.max(_triangles(depth, force, stiffness)) / force[-1]),
        )

    def _errors(self, depth: Array, force: Array, stiffness: Array) -> Array:
        """Return the error of the cubic between the rows [N], ``(intervals, places)``."""
        places = depth[:-1, None] + np.diff(depth)[:, None] * CHECK_POSITIONS
        true = np.asarray(Indentation(self.bed, Depth(places.ravel())).solve().force).reshape(places.shape)
        return np.asarray(np.abs(_cubic(depth, force, stiffness) - true))


def first_radius(bed: Bed) -> float:
    """Return the radius of the contact at first touch: that of a flat end, or zero."""
    if math.isfinite(bed.rim) and bed.rim <= bed.reach and float(bed.gap(np.array([bed.rim]))[0]) == 0.0:
        return float(bed.rim)
    return flat_radius(bed)


def _cubic(depth: Array, force: Array, stiffness: Array) -> Array:
    """Return Hermite's cubic at `CHECK_POSITIONS` in every interval."""
    t, step = CHECK_POSITIONS, np.diff(depth)[:, None]
    return np.asarray(
        (1.0 + 2.0 * t) * (1.0 - t) ** 2 * force[:-1, None]
        + t * (1.0 - t) ** 2 * step * stiffness[:-1, None]
        + t**2 * (3.0 - 2.0 * t) * force[1:, None]
        - t**2 * (1.0 - t) * step * stiffness[1:, None]
    )


def _triangles(depth: Array, force: Array, stiffness: Array) -> Array:
    """Return how high the chord of every interval is above the crossing of the tangents at its ends [N]."""
    step, rise = np.diff(depth), np.diff(force)
    first, second = stiffness[:-1], stiffness[1:]
    bend = second - first
    crossing = np.divide(second * step - rise, bend, out=np.zeros(step.shape), where=bend > 0.0)
    crossing = np.clip(crossing, 0.0, step)
    return np.asarray(np.maximum(crossing * (rise / step - first), 0.0))


@value
class ContactLawSolution:
    """The solution of a `ContactLaw`: force, radius, stiffness and energy over depth.

    Parameters
    ----------
    problem : ContactLaw
        The problem that was solved.
    depth, force, radius : ndarray, (rows,)
        d [m] from zero on, F_N [N], a [m].
    stiffness : ndarray, (rows,)
        dF/dd [N/m].
    shear_stiffness : ndarray, (rows,)
        Tangential stiffness without slip, at constant normal force [N/m].
    energy : ndarray, (rows,)
        Elastic energy [J].
    hermite_error : float
        Maximum error of the force by cubic Hermite interpolation, evaluated between the rows, over the maximum force.
    linear_error : float
        Bound of the error by linear interpolation, over the maximum force; for a contact that grows with depth.
    """

    __words__ = words(
        hermite_error=("", "", "error of the force by cubics, over the greatest force"),
        linear_error=("", "", "error by straight lines, over the greatest force, at most"),
    )

    problem: ContactLaw
    depth: Array
    force: Array
    radius: Array
    stiffness: Array
    shear_stiffness: Array
    energy: Array
    hermite_error: float
    linear_error: float

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed."""
        return Indentation(self.problem.bed, Depth(self.problem.deepest)).solve().validity
