r"""The springs of a body of revolution on a layered medium: the moments of its homogeneous transform with flat punches.

With h the transform of the profile for a homogeneous half-space, and rho, phi the flat punches of
`winkler.numerics.transforms.fredholm`

.. math:: g(a)\,\varphi(a;a) = h(a) - \int_0^a \rho(x;a)\,h(x)\,\mathrm dx, \qquad
          \int_0^a k'\,g\,\mathrm dx = 2E^*\int_0^a \varphi(x;a)\,h(x)\,\mathrm dx .

Both integrals are kept as polynomials of a, octave by octave and from kink to kink, cached by value.  A power of the
radius has no length of its own: its integrals are kept for a layer of thickness one and serve all thicknesses.

Where h is a polynomial on [0, a], to rounding, its samples at fixed parts of a suffice,

.. math:: \int_0^a \rho(x;a)\,h(x)\,\mathrm dx = \sum_j R_j(a)\,h(a\xi_j) , \qquad
          R_j(a) = \int_0^1 a\rho(a\xi;a)\,\ell_j(\xi)\,\mathrm d\xi ,

with Lagrange's polynomials :math:`\ell_j`.  R and the same of phi belong to the medium, so that a new profile
before costs nothing but its samples.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.media.layered.coated_load import settled_sums
from winkler.numerics.caching import cached_by_value
from winkler.numerics.chunks import chunks
from winkler.numerics.integrals.quadrature import gauss_legendre, panel_nodes
from winkler.numerics.panels.sqrt_panels import RootPanels, doubled, fit, nodes
from winkler.numerics.transforms import fredholm, punch_tables
from winkler.numerics.transforms.cosine_transform import WaveResponse, in_own_lengths, scaled_response
from winkler.numerics.types import Array
from winkler.profiles.conical import power_of
from winkler.profiles.power import PowerLaw
from winkler.profiles.profile import Profile

LOWEST_OCTAVE = -60
"""Octaves below this are the uppermost layer alone."""
RULE_NODES = (16, 32, 64, 128)
SETTLED_TOLERANCE = 2e-13
LAST_TOLERANCE = 1e-9
PAIRS_AT_ONCE = 200_000
SAMPLES = 32
LAST_COEFFICIENTS = 4
"""Coefficients at the end of a Legendre series that must have vanished."""
VANISHED_RATIO = 1e-14
"""The same, relative to the largest sample."""


def gap(response: WaveResponse, profile: Profile, x: Array) -> Array:
    """Return g(x) [m]; infinite where the homogeneous transform is, at the end of a profile that is vertical there."""
    x = np.asarray(x, dtype=float)
    own = np.array(profile.gap(x))
    finite = np.isfinite(own)
    here = x[finite]
    own[finite] = (own[finite] - _moments(response, profile, here)[0]) / fredholm.edge(
        response, _within_profile(profile, here)
    )
    return own


def gap_slope(response: WaveResponse, profile: Profile, x: Array) -> Array:
    """Return g'(x) [-]; infinite where that of the homogeneous transform is."""
    x = np.asarray(x, dtype=float)
    own = np.array(profile.gap_slope(x))
    finite = np.isfinite(own)
    here = x[finite]
    lost, lost_slope, _ = _moments(response, profile, here)
    place = _within_profile(profile, here)
    edge, edge_slope = fredholm.edge(response, place), fredholm.edge_slope(response, place)
    g = (profile.gap(here) - lost) / edge
    falling = np.where(edge_slope == 0.0, 0.0, g * edge_slope)
    own[finite] = (own[finite] - lost_slope - falling) / edge
    return own


def kinks(response: WaveResponse, profile: Profile) -> tuple[tuple[float, float], ...]:
    """Return ``(x, strength)`` where g is not smooth: the moments are, so that only the edge divides b jump."""
    return tuple(
        (b, b * jump / float(fredholm.edge(response, _within_profile(profile, np.asarray(b)))) if jump else 0.0)
        for b, jump in profile.kinks
    )


def gap_load(response: WaveResponse, profile: Profile, x: Array) -> Array:
    """Return the integral of k' g from 0 to x, over 2 E* [m^2]."""
    return np.asarray(_moments(response, profile, np.asarray(x, dtype=float))[2])


def _end(profile: Profile) -> float:
    return min(profile.reach, profile.rim)


def _within_profile(profile: Profile, x: Array) -> Array:
    return np.minimum(x, _end(profile))


def _moments(response: WaveResponse, profile: Profile, x: Array) -> Array:
    """Return the integral of rho h, its derivative, and that of phi h, ``(3, *x.shape)``."""
    own, unit = in_own_lengths(response)
    coefficient, exponent = power_of(profile)
    if exponent == 0.0:
        return _moments_of(response if unit == 1.0 else scaled_response(own, unit), profile, x)
    height = coefficient * unit**exponent
    scales = np.array([height, height / unit, height * unit]).reshape(3, *([1] * x.ndim))
    return np.asarray(scales * _moments_of(own, _unit_power(exponent), x / unit))


@functools.lru_cache(maxsize=64)
def _unit_power(exponent: float) -> PowerLaw:
    return PowerLaw(1.0, exponent)


def _moments_of(response: WaveResponse, profile: Profile, x: Array) -> Array:
    """Return the same of a profile in the lengths of the response."""
    flat = _within_profile(profile, x).ravel()
    octaves = np.maximum(punch_tables.octave_of(response, flat), LOWEST_OCTAVE)
    result = np.zeros((3, flat.size))
    waiting = np.ones(flat.size, dtype=bool)
    whole = (octaves > LOWEST_OCTAVE) & (flat <= min((b for b, _ in profile.kinks), default=math.inf))
    tabled = np.maximum(octaves, 0)  # all narrower contacts are in the lowest of the tables
    for octave in np.unique(tabled[whole]):
        (members,) = np.nonzero(whole & (tabled == octave))
        table_moments, holds = _smooth_moments(response, profile, int(octave), flat[members])
        result[:, members[holds]] = table_moments[:, holds]
        waiting[members[holds]] = False
    for octave in np.unique(octaves[waiting]):
        (members,) = np.nonzero(waiting & (octaves == octave))
        if octave == LOWEST_OCTAVE:
            result[2, members] = profile.gap_integral(flat[members])
            continue
        steep = flat[members] > _table_end(profile)
        if steep.any():
            panels = punch_tables.tables(response, int(octave))[-1].panels
            result[:, members[steep]] = _integrated(response, profile, flat[members[steep]], panels)
        if not steep.all():
            result[:, members[~steep]] = _octave(response, profile, int(octave))(flat[members[~steep]])
    return result.reshape(3, *x.shape)


@cached_by_value(256)
def _table_end(profile: Profile) -> float:
    """Return up to where the moments are tabulated: not quite to the equator of a sphere, where it is vertical."""
    end = _end(profile)
    if not math.isfinite(end):
        return end
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = float(profile.gap_slope(np.array([end]))[0])
    return end if math.isfinite(slope) else 0.97 * end


@cached_by_value(512)
def _octave(response: WaveResponse, profile: Profile, octave: int) -> RootPanels:
    high = punch_tables.first_radius(response) * 2.0**octave
    low, high = 0.5 * high, min(high, _table_end(profile))
    kinks = np.array([b for b, _ in profile.kinks if b < high])
    steps = [table.high for table in punch_tables.tables(response, octave) if low < table.high < high]
    edges = np.unique(np.concatenate([[low, high], kinks[kinks > low], steps]))
    noise = _noise(profile) / SETTLED_TOLERANCE

    def tolerances(values: Array) -> Array:
        size = float(np.max(np.abs(profile.gap(edges[:-1])))) + float(np.max(np.abs(values[0]))) + noise
        whole = np.max(np.abs(values[2])) + noise * high
        return (
            np.array([SETTLED_TOLERANCE * size, 10.0 * SETTLED_TOLERANCE * size / low, SETTLED_TOLERANCE * whole])
            + 1e-300
        )

    panels = punch_tables.tables(response, octave)[-1].panels
    return fit(lambda a: _integrated(response, profile, a, panels), edges, kinks, tolerances)


def _noise(profile: Profile) -> float:
    """Return what rounding may do to g [m]: a shape of many pieces has the g of its first piece to rounding."""
    if not profile.kinks:
        return 0.0
    return 4.0 * float(np.finfo(float).eps * np.abs(profile.gap(np.array([profile.kinks[0][0]]))[0]))


def _integrated(response: WaveResponse, profile: Profile, a: Array, panels: Array) -> Array:
    """Integrate over the springs of contacts with radii a ``(m,)`` of one octave, which has these panels of x/a."""
    kinks = np.array([b for b, _ in profile.kinks if b < np.max(a)])
    inner, end = doubled(list(kinks), float(np.max(a))), _end(profile)
    if np.max(a) > 0.5 * end > 0.5 * _table_end(profile):  # where the profile ends it is vertical
        inner = np.concatenate([inner, end * (1.0 - 0.5 ** np.arange(1, 49))])
    edges = np.concatenate([np.minimum(inner, a[:, None]), a[:, None] * panels], axis=1)
    edges.sort(axis=1)
    most = (
        float(np.max(np.abs(profile.gap(np.minimum(a, np.nextafter(end, 0.0)))))) + _noise(profile) / SETTLED_TOLERANCE
    )

    def sums(count: int) -> Array:
        parts = chunks(a.size, edges.shape[1] * count, PAIRS_AT_ONCE)
        return np.concatenate([_sums(response, profile, a[i], edges[i], kinks, count) for i in parts], axis=1)

    widest, noise = float(np.max(a)), _noise(profile) / SETTLED_TOLERANCE
    refusal = (
        f"The transform of the profile for this medium still moves by {{:.1e}} at a contact radius of {widest:.3g} m: "
        "the shape is not smooth between its stated kinks: state them."
    )
    least = np.array([most, most / np.min(a), noise * widest])
    return settled_sums(sums, least, SETTLED_TOLERANCE, LAST_TOLERANCE, refusal, rules=RULE_NODES)


def _sums(response: WaveResponse, profile: Profile, a: Array, edges: Array, kinks: Array, count: int) -> Array:
    x, weights = nodes(edges, kinks, count)
    x = np.minimum(x, np.nextafter(_end(profile), 0.0))
    h, slope = profile.gap(x), profile.gap_slope(x)
    ratio, ends = x / a[:, None], edges / a[:, None]
    first = x.shape[1] - (edges.shape[1] - 2) * count
    pieces = [(ratio[:, None, :first], ends[:, :2])]
    if edges.shape[1] > 2:
        pieces.append((ratio[:, first:].reshape(a.size, -1, count), ends[:, 1:]))
    parts = [
        fredholm.on_pieces(response, a, places, bounds[:, :-1], bounds[:, 1:]).reshape(3, a.size, -1)
        for places, bounds in pieces
    ]
    moment, by_a, phi = np.concatenate(parts, axis=2)
    lost = np.sum(weights * moment * h, axis=1) / a
    moved = (np.sum(weights * by_a * h, axis=1) - lost) / a
    moved += np.sum(weights * moment * x * slope, axis=1) / a**2
    return np.array([lost, lost / a + moved, np.sum(weights * phi * h, axis=1)])


class MomentRule(NamedTuple):
    """Chebyshev series in the radius ``(k, n)`` of the weights of rho and phi at the samples."""

    rho: Array
    phi: Array


def _smooth_moments(response: WaveResponse, profile: Profile, octave: int, a: Array) -> tuple[Array, Array]:
    """Return the integral of rho h, its derivative, and that of phi h; and where they hold.

    Parameters
    ----------
    response : WaveResponse
    profile : Profile
        Without a kink below the radii.
    octave : int
        In which all radii lie.
    a : ndarray, (m,)
        Radii [m].

    Returns
    -------
    moments : ndarray, (3, m)
    holds : ndarray of bool, (m,)
        Where h is smooth enough; elsewhere the moments mean nothing.
    """
    own, _ = in_own_lengths(response)
    xi, _ = gauss_legendre(SAMPLES)
    x = a[:, None] * xi
    with np.errstate(all="ignore"):
        h, slope = profile.gap(x), profile.gap_slope(x)
        holds = _resolved(h) & _resolved(slope)
    result = np.zeros((3, a.size))
    if not holds.any():
        return result, holds
    rules, octave_tables = _rules(own, max(octave, 0)), punch_tables.tables(response, octave)
    which = np.searchsorted([table.high for table in octave_tables[:-1]], a)
    for index, (table, rule) in enumerate(zip(octave_tables, rules, strict=True)):
        (mine,) = np.nonzero((which == index) & holds)
        if not mine.size:
            continue
        radius = a[mine]
        s = (2.0 * radius - table.low - table.high) / (table.high - table.low)
        powers = np.polynomial.chebyshev.chebvander(s, len(rule.rho) - 1)
        by_radius = fredholm.slopes(powers, s) * (2.0 / (table.high - table.low))
        weights = powers @ rule.rho
        own_h, own_slope = h[mine], slope[mine]
        result[0, mine] = np.sum(weights * own_h, axis=1)
        result[1, mine] = np.sum((by_radius @ rule.rho) * own_h + weights * xi * own_slope, axis=1)
        result[2, mine] = radius * np.sum((powers @ rule.phi) * own_h, axis=1)
    return result, holds


def _resolved(values: Array) -> Array:
    """Return which rows are samples of polynomials."""
    tail = np.max(np.abs(values @ _tail()), axis=1)
    return np.asarray(tail <= VANISHED_RATIO * np.max(np.abs(values), axis=1))


@functools.cache
def _tail() -> Array:
    """Return the matrix from samples to the last coefficients of their Legendre series."""
    xi, weights = gauss_legendre(SAMPLES)
    order = np.arange(SAMPLES - LAST_COEFFICIENTS, SAMPLES)
    basis = np.polynomial.legendre.legvander(2.0 * xi - 1.0, SAMPLES - 1)[:, order]
    return np.asarray(weights[:, None] * basis * (2.0 * order + 1.0))


@cached_by_value(256)
def _rules(key: WaveResponse, octave: int) -> tuple[MomentRule, ...]:
    """Return the rules of an octave of radii, for all parts of its tables."""
    legendre, chebyshev = np.polynomial.legendre, np.polynomial.chebyshev
    xi, weights = gauss_legendre(SAMPLES)
    order = np.arange(SAMPLES)
    to_series = (weights[:, None] * legendre.legvander(2.0 * xi - 1.0, SAMPLES - 1) * (2.0 * order + 1.0)).T
    rules = []
    for table in punch_tables.tables(key, octave):
        degree = table.rho.shape[2]
        count = (degree + SAMPLES) // 2 + 1  # exact for both polynomials
        ratio, shares = panel_nodes(table.panels, count)
        nodes, _ = gauss_legendre(count)
        basis = chebyshev.chebvander(2.0 * nodes - 1.0, degree - 1)
        lagrange = legendre.legvander(2.0 * ratio - 1.0, SAMPLES - 1) @ to_series
        parts = [
            np.einsum("kpi,ni->kpn", series, basis).reshape(len(series), -1) @ (shares[:, None] * lagrange)
            for series in (table.rho, table.phi)
        ]
        rules.append(MomentRule(*parts))
    return tuple(rules)
