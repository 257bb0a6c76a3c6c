r"""The point of first touch of an indentation, with its standard error.

The first part of the first loading is fitted by :math:`F = F_0 + K\,(D-D_0)_+^n`, with an exponent between that of a
flat
punch, 1, and above that of a cone, 2: a blunt tip passes from 3/2 to 2.  Points without contact before the touch fix
the
baseline :math:`F_0`; without them it is zero, and the touch is extrapolated.  The change with the fitted range is
part of the error: ranges of growing force are fitted, and the largest is taken that agrees with all smaller ones
(Lepski's rule), so that the changing exponent of a blunt tip does not shift the touch.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.nanoindentation.touch import LEAST_POINTS, Touch, fitted_touch, white_noise
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

SMALLEST_WINDOW, WINDOW_RATIO, LARGEST_WINDOW = 25.0, 2.0, 0.25
"""Ranges of forces that are fitted: the smallest over the noise, the ratio, and the largest over the greatest force."""
AGREEMENT = 1.0
"""Greatest difference to the touch of a smaller range, in its standard errors, of a range that is taken."""
MOST_DOUBT = 3.0
"""Greatest contribution of the change with the range, in standard errors: small ranges may know nothing."""
MOST_POINTS = 3000
IN_CONTACT = 4.0
"""Force over that of the first points, in parts of its noise, of a point that is surely in contact."""
AIR_RATIO, LEAST_AIR_POINTS = 4.0, 50
"""Travel before contact that is fitted, in parts of that in contact, and fewest points of it: a long approach through
air must not decide how finely the contact is resolved."""


@value
class ZeroPoint:
    """Position of first touch.

    Parameters
    ----------
    position : float
        D_0 [m].
    error : float
        Standard error of the position [m], including the uncertainty due to the choice of the fitted range.
    baseline : float
        Force before contact [N]; zero if no point was measured before contact.
    extrapolated : bool
        Whether no point was measured before contact.
    """

    __words__ = words(
        position=("D_0", "m", "position of first touch"),
        error=("u(D_0)", "m", "standard error of the position of first touch"),
        extrapolated=("", None, "whether no point was taken before contact"),
    )

    position: float
    error: float
    baseline: float
    extrapolated: bool


def found_zero_point(curve: ForceCurve, area: Sequence[float] | Array = (), rim: float = 0.0) -> ZeroPoint:
    """Return the position of first touch of an indentation.

    Parameters
    ----------
    curve : ForceCurve
        A curve with its first loading, already corrected for drift and frame compliance.
    area : sequence of float, optional
        Coefficients of the area function of the tip, which determines the form of the force curve; by default a power
        of the depth.
    rim : float, optional
        With `area`: depth of the elastic rim over the root of the area, epsilon F/(S sqrt(A)) at a peak.

    Raises
    ------
    InvalidInput
        If the first loading has fewer than twelve points at low forces.
    """
    depth, force = curve.depth(0.0), curve.force
    first = next((one for one in curve.segments if one.kind is SegmentKind.LOADING), None)  # a hold may come before
    end = first.last if first is not None and first.count >= LEAST_POINTS else int(np.argmax(force))
    start = int(np.argmin(depth[: end + 1]))  # the tip may be lifted off before the loading
    depth, force = depth[start : end + 1], force[start : end + 1]
    coefficients = np.asarray(area, dtype=float) if rim > 0.0 else np.zeros(0)
    found: list[Touch] = []
    chosen = 0
    noise = white_noise(force)
    touching = float(np.median(force[:LEAST_POINTS])) + IN_CONTACT * noise
    for limit in _windows(float(force.max()), noise).tolist():
        count = int(np.argmax(force > limit)) or force.size
        if np.count_nonzero(force[:count] > touching) < LEAST_POINTS:
            continue
        fitted = slice(_begin(depth[:count], force[:count], touching), count, 1)
        step = -(-(count - fitted.start) // MOST_POINTS)
        touch = fitted_touch(depth[fitted][::step], force[fitted][::step], coefficients, rim)
        if not math.isfinite(touch.error):
            continue
        if any(abs(touch.position - one.position) > AGREEMENT * one.error for one in found):
            break
        chosen = count
        found.append(touch)
    if not found:
        raise InvalidInput(
            f"found_zero_point: curve '{curve.name}' has fewer than {LEAST_POINTS} points of contact at low forces "
            "of its first loading: give contact_point with its error."
        )
    taken = found[-1]
    doubt = min(max(abs(taken.position - one.position) for one in found), MOST_DOUBT * taken.error)
    error = math.hypot(taken.error, doubt)
    free = int(np.count_nonzero(depth[:chosen] < taken.position - 2.0 * error))
    position, baseline = taken.position, taken.baseline
    if free < 5:
        position, error = _not_before_the_first_point(depth, force, position, error)
    return ZeroPoint(position, error, baseline, free < 5)


def _begin(depth: Array, force: Array, touching: float) -> int:
    """Return the first point of the fitted range: of the approach as much as the contact asks for."""
    contact = min(int(np.flatnonzero(force <= touching)[-1]) + 1, force.size - 1) if force[0] <= touching else 0
    reach = AIR_RATIO * max(float(depth[-1] - depth[contact]), 0.0)
    near = int(np.argmax(depth >= depth[contact] - reach))
    return max(min(near, contact - LEAST_AIR_POINTS), 0)


def _not_before_the_first_point(depth: Array, force: Array, position: float, error: float) -> tuple[float, float]:
    """Return position and error of a touch from which the first force could have grown, as its power of at most 2."""
    least = 4.0 * max(float(force[0]), white_noise(force))
    next_one = int(np.argmax(force > least))
    step = max(float(depth[next_one] - depth[0]), 0.0)
    earliest, latest = float(depth[0]) - step, float(depth[0]) + step
    if earliest <= position <= latest:
        return position, error
    width = max(latest - earliest, white_noise(depth))
    bounded = min(max(position, earliest), latest)
    return bounded, max(width / math.sqrt(12.0), min(error, width))


def _windows(top: float, noise: float) -> Array:
    """Return the greatest forces of the ranges, growing."""
    largest = LARGEST_WINDOW * top
    smallest = min(max(SMALLEST_WINDOW * noise, 1e-4 * top), largest)
    count = 1 + round(math.log(largest / smallest) / math.log(WINDOW_RATIO))
    return np.geomspace(smallest, largest, max(count, 2))
