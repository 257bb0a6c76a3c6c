r"""The transform of a two-dimensional profile: from f(x) to the load per length of a line contact.

A symmetric profile f(|x|), endless along y and pressed into a half-plane until it touches from -a to a, bears the load
per length :math:`P = E^* w(a)` with

.. math:: w(a) = \int_0^a \frac{x\,f'(x)}{\sqrt{a^2-x^2}}\,\mathrm dx .

This is the transform T1 of `winkler.numerics.transforms.abel`, of the shape whose slope is :math:`x f'(x)`, over a: a
`Shape` of powers keeps its closed form.  Above a jump j of the slope at b, w' holds :math:`b\,j/\sqrt{a^2-b^2}`, as g'
does for a body of revolution.
"""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.panels.log_panels import Octaves
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array, Curve
from winkler.profiles.designed import Designed
from winkler.profiles.flat import CappedCylinder, FlatPunch
from winkler.profiles.measured import Measured
from winkler.profiles.pieces import PowerPieces, Term
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.profile import Profile, Sum
from winkler.profiles.rounded import RoundedPunch, excess
from winkler.profiles.smoothing import Spline
from winkler.profiles.wavy import Wavy

TABLE_TOLERANCE = 1e-12
"""Error of w' of a profile of many pieces, over its greatest value: its integral is as good as the quadrature."""


MANY = 32
"""From how many places on tables are used."""
TOWARDS_WALL, AT_WALL = 0.875, 1e-4
"""Parts of the reach: from which on the distance from its end counts, at which a wall may stand, and down to which."""


class _Raised(PowerPieces):
    """The shape whose slope is r times that of another one of powers."""

    def __init__(self, terms: tuple[Term, ...]) -> None:
        self.raised = tuple((b, m + 1, c) for b, m, c in terms)

    @property
    def terms(self) -> tuple[Term, ...]:
        """Those of the other one, their exponents one higher."""
        return self.raised


def line_load(profile: Profile, a: Array) -> Array:
    """Return w(a) [m]: the load per length over E* when the contact reaches from -a to a.

    Parameters
    ----------
    profile : Profile
        Read as f(|x|).
    a : ndarray
        Half-widths [m], not negative.
    """
    a = np.asarray(a, dtype=float)
    match profile:
        case FlatPunch():
            return np.zeros(a.shape)
        case CappedCylinder(cap=cap):
            return line_load(cap, a)
        case Sum(parts=parts):
            return np.asarray(sum(line_load(part, a) for part in parts))
        case RoundedPunch(flat_radius=b, edge_radius=edge):
            t = root_difference(a, b) / b
            return np.asarray(b * b / edge * (t**3 / 3.0 - excess(t)[1]))
        case Wavy(amplitude=h, wavelength=length):
            return _of_wave(h, 2.0 * np.pi / length, a)[0]
        case Measured() | Designed():
            return _tables(profile)[0](a)
    raised = _raised(profile)
    return _many(profile, a, slope=False) if raised is None else _over(raised.gap(a), a, 0.0)


def line_load_slope(profile: Profile, a: Array) -> Array:
    """Return w'(a) [-]; at a kink, the value just below it.

    Raises
    ------
    NotImplementedError
        If a `Shape` does not give its curvature.
    """
    a = np.asarray(a, dtype=float)
    match profile:
        case FlatPunch():
            return np.zeros(a.shape)
        case CappedCylinder(cap=cap):
            return line_load_slope(cap, a)
        case Sum(parts=parts):
            return np.asarray(sum(line_load_slope(part, a) for part in parts))
        case RoundedPunch(flat_radius=b, edge_radius=edge):
            return np.asarray(a / edge * np.arctan2(root_difference(a, b), b))
        case Wavy(amplitude=h, wavelength=length):
            return _of_wave(h, 2.0 * np.pi / length, a)[1]
        case Measured() | Designed():
            return _tables(profile)[1](a)
    raised = _raised(profile)
    if raised is None:
        return _many(profile, a, slope=True)
    tip = float(profile.slope(np.zeros(1))[0])
    return _over(raised.gap_slope(a) - _over(raised.gap(a), a, 0.0), a, tip)


def _of_wave(h: float, k: float, a: Array) -> tuple[Array, Array]:
    """Return w = pi h k a J1(k a)/2 and w' = pi h k^2 a J0(k a)/2 of a slope h k sin(k x)."""
    from scipy.special import j0, j1

    t = k * a
    return np.asarray(0.5 * np.pi * h * t * j1(t)), np.asarray(0.5 * np.pi * h * k * t * j0(t))


def _raised(profile: Profile) -> Profile | None:
    """Return the shape whose slope is r f'(r), where it has a closed form."""
    match profile:
        case Paraboloid(curvature_radius=radius):
            return PowerLaw(1.0 / (3.0 * radius), 3.0)
        case PowerLaw(coefficient=c, exponent=n):
            return PowerLaw(c * n / (n + 1.0), n + 1.0)
        case PowerPieces():
            return _Raised(profile.terms)
    return None


def _raised_slope(profile: Profile) -> Curve:
    def slope(r: Array) -> Array:
        with np.errstate(invalid="ignore"):
            return np.where(r > 0.0, r * profile.slope(r), 0.0)

    return slope


def _edges(profile: Profile) -> tuple[float, ...]:
    return tuple(b for b, _ in profile.kinks)


def _over(content: Array, a: Array, at_zero: float) -> Array:
    """Return content / a, and what it becomes where a vanishes."""
    return np.where(a > 0.0, content / np.where(a > 0.0, a, 1.0), at_zero)


def _many(profile: Any, a: Array, *, slope: bool) -> Array:
    """Return w, or w', at places of any shape, many of them from tables, which are of the same error."""
    function, wall = _by_quadrature if slope else _load_by_quadrature, profile.reach
    if a.size < MANY or profile.kinks:
        return function(profile, a)
    flat = np.ravel(a)
    near = (flat >= TOWARDS_WALL * wall) & (flat < (1.0 - AT_WALL) * wall)
    far = (flat > 0.0) & (flat < TOWARDS_WALL * wall)
    rest, found = ~(near | far), np.empty(flat.size)
    along, back = _octaves(profile, slope)
    found[far], found[near] = along(flat[far]), back(wall - flat[near])
    if rest.any():
        found[rest] = function(profile, flat[rest])
    return found.reshape(a.shape)


@functools.lru_cache(maxsize=64)
def _octaves(profile: Profile, slope: bool) -> tuple[Octaves, Octaves]:
    """Return tables of w, or w', over the half-width, and over its distance from where the profile ends."""
    function = functools.partial(_by_quadrature if slope else _load_by_quadrature, profile)
    wall, unit = profile.reach, TOWARDS_WALL * profile.reach if np.isfinite(profile.reach) else 1.0
    along = Octaves(function, unit, 0.0, unit if np.isfinite(wall) else np.inf)
    return along, Octaves(lambda d: function(wall - d), wall - unit, AT_WALL * wall, wall - unit)


def _load_by_quadrature(profile: Any, a: Array) -> Array:
    return _over(abel.gap(_raised_slope(profile), _edges(profile), a), a, 0.0)


def _by_quadrature(profile: Any, a: Array) -> Array:
    """Return w' as (1/a) times the integral of r (r f')' / sqrt(a^2 - r^2), the kinks by themselves."""
    jumps = [(b, b * jump) for b, jump in profile.kinks]

    def curvature(r: Array) -> Array:
        return np.asarray(profile.slope(r) + r * profile.curvature(r))

    whole = abel.gap_slope(_raised_slope(profile), curvature, jumps, a)
    return _over(whole - _load_by_quadrature(profile, a), a, float(profile.slope(np.zeros(1))[0]))


@functools.lru_cache(maxsize=64)
def _tables(profile: Measured | Designed) -> tuple[Panels, Panels]:
    """Return w and w' of a profile of many pieces."""
    edges = np.unique([0.0, *(b for b, _ in profile.kinks), profile.reach])
    steepest = float(np.max(np.abs(profile.slope(np.linspace(0.0, profile.reach, 1001)))))

    def derivative(a: Array) -> Array:
        if isinstance(profile, Measured):
            return _of_spline(profile.curve, a.ravel()).reshape(a.shape)
        return _by_quadrature(profile, a.ravel()).reshape(a.shape)

    found = fit_panels(derivative, edges, TABLE_TOLERANCE * steepest)
    return found.integral, found


def _of_spline(curve: Spline, a: Array) -> Array:
    """Return w' of a cubic spline: a slope (r - b)^2 beyond b adds 2 a (s - b arccos(b/a)), s = sqrt(a^2 - b^2)."""
    _, first, second, third = curve.derivatives[:, 0]
    total = first + 0.5 * np.pi * second * a + third * a * a
    inner, half_jumps = curve.knots[1:-1], 0.5 * np.diff(curve.derivatives[3])
    chunk = max(1, 2_000_000 // max(inner.size, 1))
    for start in range(0, a.size if inner.size else 0, chunk):
        place = a[start : start + chunk, None]
        root = root_difference(place, inner)
        total[start : start + chunk] += 2.0 * place[:, 0] * ((root - inner * np.arctan2(root, inner)) @ half_jumps)
    return np.asarray(total)
