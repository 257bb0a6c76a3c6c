r"""Acceleration of the tip of a probe, from its measured path.

A local polynomial of degree four, whose window is as wide as the path allows: up to the highest frequency at which the
path stands out of its own noise, the acceleration is that of a sinusoid to one per cent; above, it fades.

A. Savitzky, M. J. E. Golay, Anal. Chem. 36 (1964) 1627-1639, doi:10.1021/ac60214a047
"""

from __future__ import annotations

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

GREATEST_UNEVENNESS = 1.5
"""Greatest ratio of two steps of time."""
DEGREE = 4
NARROWEST, WIDEST_SHARE = 5, 4
"""Points of the narrowest window; the widest has this part of all points."""
SIGNAL_TO_NOISE = 30.0
"""Least ratio of the power of a frequency to the noise."""
ERROR = 0.01
"""Greatest relative error of the acceleration of a sinusoid within the band."""


def tip_acceleration(curve: ForceCurve) -> Array:
    """Return the acceleration of the tip into the body [m/s^2] ``(n,)``.

    Parameters
    ----------
    curve : ForceCurve
        With evenly spaced times; the path of the tip is the position less the deflection of the machine.

    Raises
    ------
    InvalidInput
        If the times are uneven, or there are too few points.
    """
    from scipy.signal import savgol_filter

    if not curve.timed:
        raise InvalidInput(f"fit: 'inertia' needs times, and curve '{curve.name}' has none; leave 'inertia' out.")
    steps = np.diff(curve.time)
    if curve.count < WIDEST_SHARE * NARROWEST or not steps.min() > 0.0:
        raise InvalidInput(
            f"fit: 'inertia' needs at least {WIDEST_SHARE * NARROWEST} points with growing times, and curve "
            f"'{curve.name}' has not; leave 'inertia' out."
        )
    if steps.max() > GREATEST_UNEVENNESS * steps.min():
        raise InvalidInput(
            f"fit: 'inertia' needs points evenly spaced in time; the steps of curve '{curve.name}' are between "
            f"{steps.min():.3g} s and {steps.max():.3g} s: interpolate the curve to even times."
        )
    even = np.linspace(curve.time[0], curve.time[-1], curve.count)
    path = np.interp(even, curve.time, curve.position - curve.compliance * curve.force)
    step = float(even[1] - even[0])
    window = _window(path)
    found = savgol_filter(path, window, DEGREE, deriv=2, delta=step, mode="interp")
    return np.asarray(np.interp(curve.time, even, found))


def _window(path: Array) -> int:
    """Return the number of points of the window of an evenly sampled path."""
    from scipy.signal import savgol_coeffs

    bent = np.diff(path, 2)
    angle = 2.0 * np.pi * np.fft.rfftfreq(bent.size)[1:]  # per point
    power = np.abs(np.fft.rfft(bent * np.hanning(bent.size))[1:]) ** 2 / (2.0 - 2.0 * np.cos(angle)) ** 2
    noise = np.median(power[power.size // 2 :])
    distinct = np.flatnonzero(power > SIGNAL_TO_NOISE * noise)
    widest = path.size // WIDEST_SHARE
    highest = angle[distinct[-1]] if distinct.size else np.pi / widest
    window = NARROWEST
    for wider in range(NARROWEST + 2, widest + 1, 2):
        places = np.arange(wider) - wider // 2
        response = savgol_coeffs(wider, DEGREE, deriv=2, use="dot") @ np.cos(highest * places)
        if abs(response / -(highest**2) - 1.0) > ERROR:
            break
        window = wider
    return window
