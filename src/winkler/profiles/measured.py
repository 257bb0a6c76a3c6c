r"""Measured profiles: points (r, f) with scatter, turned into one smooth curve.

The curve is a cubic spline, and the data decide which: cross-validation compares how well points are predicted by the
others.  Clean data get the spline through all points; noisy data a least-squares spline with as few pieces as predict
best.  A round apex, f'(0) = 0, is imposed where the data do not contradict it.  What was chosen is stated in the
profile's notes.  The transform of a cubic spline is known in closed form, with :math:`J_j` the jumps of f''':

.. math:: f' = f'_0 + f''_0 r + \tfrac12 f'''_0 r^2 + \sum_j \tfrac12 J_j (r-b_j)_+^2 ,\qquad
          g = x\sum (\dots)\,W_m(x, b_j)

(see `winkler.profiles.pieces`).  It is evaluated on the nodes of adaptive panels, to 1e-11 of the steepest slope, and
read from those: the cost does not grow with the number of points.
"""

from __future__ import annotations

import functools
from typing import Annotated

import numpy as np

from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.types import Array
from winkler.profiles.profile import Shape
from winkler.profiles.smoothing import Spline, choose
from winkler.values.checks.number_checks import NON_NEGATIVE, Advice, Numbers
from winkler.values.errors import InvalidInput
from winkler.values.limits import MEASURED_PLACES
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

TOLERANCE = 1e-11
"""Error of g' on its panels, relative to the steepest slope."""
FEWEST_POINTS = 6


FOLDING_ADVICE = Advice("give distances from the axis, or let read_profile fold a scan across the apex")


@value
class Measured(Shape):
    """A profile known at points.

    Parameters
    ----------
    radii : ndarray, (n,)
        Distances from the axis [m], zero or positive, in any order; at least six different ones.
    heights : ndarray, (n,)
        Heights [m] there; the height of the apex is subtracted.

    Raises
    ------
    InvalidInput
        If the points are too few, not finite, do not include the apex, or decrease with the radius by more than their
        scatter.

    See Also
    --------
    winkler.read_profile : reads a file with units, and folds a scan that crosses the apex.
    """

    __words__ = words(
        radii=("r_i", "m", "measured distances from the axis"), heights=("f_i", "m", "measured heights above the apex")
    )

    radii: Annotated[Array, Numbers(NON_NEGATIVE, fewest=0, most=4 * MEASURED_PLACES), FOLDING_ADVICE]
    heights: Annotated[Array, Numbers(fewest=0, most=4 * MEASURED_PLACES), Advice("remove these points")]

    def __post_init__(self) -> None:
        if self.radii.size != self.heights.size:
            raise InvalidInput(
                f"Measured: there are {self.radii.size} radii and {self.heights.size} heights; give two "
                "one-dimensional arrays of equal length."
            )
        _curve(self)

    @property
    def curve(self) -> Spline:
        """The spline that represents the points."""
        return _curve(self)

    @property
    def reach(self) -> float:
        """The outermost point [m]."""
        return float(self.curve.knots[-1])

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """The knots of the spline, where f''' jumps; integrals are computed from knot to knot."""
        return tuple((float(knot), 0.0) for knot in self.curve.knots[1:-1])

    @property
    def rising(self) -> bool:
        """Whether g of the curve rises everywhere."""
        slope = _panels(self)[1](_samples(self))
        return bool(np.min(slope) >= -1e-10 * np.max(slope))

    @property
    def notes(self) -> tuple[Note, ...]:
        """The curve that represents the points, and its distance from them."""
        curve = self.curve
        apex = ", with a round apex" if curve.rounded else ""
        if curve.through:
            text = f"The shape is the cubic spline through {self.radii.size} points{apex}; its transform is exact."
            return (Note(Assumption.SHAPE, Standing.ASYMPTOTIC, text, "cross-validation found no scatter to smooth"),)
        text = (
            f"The {self.radii.size} points were smoothed by a cubic spline of {curve.pieces} pieces{apex}; they "
            f"scatter about it by {curve.residual:.3g} m (root mean square). Pressure and stress follow the "
            "curvature of the spline and are less accurate than depth and force."
        )
        return (Note(Assumption.SHAPE, Standing.APPROXIMATE, text, "number of pieces by generalised cross-validation"),)

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        above: Array = self.curve.evaluate(np.asarray(r, dtype=float)) - self.curve.derivatives[0, 0]
        return above

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        return self.curve.evaluate(np.asarray(r, dtype=float), 1)

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        return self.curve.evaluate(np.asarray(r, dtype=float), 2)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return _panels(self)[0](np.asarray(x, dtype=float))

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return _panels(self)[1](np.asarray(x, dtype=float))

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        return _panels(self)[2](np.asarray(x, dtype=float))


def _samples(profile: Measured) -> Array:
    edges = _panels(profile)[1].edges
    inner = np.linspace(0.0, 1.0, 8, endpoint=False)
    return np.append((edges[:-1, None] + np.diff(edges)[:, None] * inner).ravel(), edges[-1])


@functools.lru_cache(maxsize=64)
def _curve(profile: Measured) -> Spline:
    """Return the curve of a profile: sort, merge, choose, and refuse what is no tip."""
    order = np.argsort(profile.radii, kind="stable")
    r, start, counts = np.unique(profile.radii[order], return_index=True, return_counts=True)
    heights = profile.heights[order]
    f = np.add.reduceat(heights, start) / counts if r.size else r
    if r.size < FEWEST_POINTS:
        raise InvalidInput(f"Measured: {r.size} different radii were given; a profile needs at least {FEWEST_POINTS}.")
    spread = np.maximum.reduceat(heights, start) - np.minimum.reduceat(heights, start)
    if np.max(spread) > 0.2 * np.ptp(f) > 0.0:
        raise InvalidInput(
            f"Measured: at the radius {r[np.argmax(spread)]:.6g} m the heights differ by {np.max(spread):.3g} m, like "
            "a vertical wall; cut the data there and give CappedCylinder(radius, cap), or remove the wrong points."
        )
    if r[0] > 0.1 * r[-1]:
        raise InvalidInput(
            f"Measured: the innermost point is at {r[0]:.6g} m of {r[-1]:.6g} m; the apex must be measured too: radii "
            "are distances from the axis and must begin near zero."
        )
    curve = choose(r, f)
    dense = np.linspace(0.0, r[-1], 2001)
    heights = curve.evaluate(dense)
    drop = np.maximum.accumulate(heights) - heights
    # a spline overshoots a little where a flat end meets a flank
    allowed = 4.0 * curve.scatter + 2e-3 * np.ptp(heights)
    if np.max(drop) > allowed:
        raise InvalidInput(
            f"Measured: the height falls by {np.max(drop):.3g} m towards the radius {dense[np.argmax(drop)]:.6g} m, "
            f"more than the scatter of {curve.scatter:.2g} m; heights must rise from the apex at r = 0 outwards "
            "(turn the sign if depths were given)."
        )
    return curve


@functools.lru_cache(maxsize=64)
def _panels(profile: Measured) -> tuple[Panels, Panels, Panels]:
    """Return g, g' and the integral of g on adaptive panels."""
    curve = _curve(profile)
    steepest = float(np.max(np.abs(curve.evaluate(np.linspace(0.0, curve.knots[-1], 1001), 1))))
    # where f''' jumps much, as at a sampled corner, rounding leaves less than that
    rounding = 2.0 * np.finfo(float).eps * curve.knots[-1] ** 2 * float(np.sum(np.abs(np.diff(curve.derivatives[3]))))
    slope = fit_panels(lambda x: _gap_slope(curve, x), curve.knots, max(TOLERANCE * steepest, rounding))
    gap = slope.integral
    return gap, slope, gap.integral


def _gap_slope(curve: Spline, x: Array) -> Array:
    """Return g' of a cubic spline in closed form, term by term of its truncated powers."""
    flat = x.ravel()
    _, first, second, third = curve.derivatives[:, 0]
    total = 0.5 * np.pi * first + 2.0 * second * flat + 0.375 * np.pi * third * flat**2
    inner = curve.knots[1:-1]
    half_jumps = 0.5 * np.diff(curve.derivatives[3])
    chunk = max(1, 2_000_000 // max(inner.size, 1))
    for start in range(0, flat.size if inner.size else 0, chunk):
        part = slice(start, start + chunk)
        total[part] += _slope_beyond(flat[part, None], inner) @ half_jumps
    result: Array = total.reshape(x.shape)
    return result


def _slope_beyond(x: Array, b: Array) -> Array:
    """Return what a slope (r - b)^2 beyond b adds to g'(x).

    With s = sqrt(x^2 - b^2) and A = arccos(b/x): 3 W2 - 4 b W1 + b^2 W0 = (1.5 x^2 + b^2) A - 2.5 b s; the inverse
    square roots b^3 - 2 b^3 + b^3 cancel.
    """
    root = root_difference(x, b)
    added: Array = (1.5 * x * x + b * b) * np.arctan2(root, b) - 2.5 * b * root
    return added
