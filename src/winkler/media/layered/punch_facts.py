r"""Flat punches of all sizes on a layered medium: whether one pulls, and the surface displacement outside it.

On a homogeneous half-space a flat punch presses everywhere, and the surface outside sinks less than it does.  On
layers neither goes without saying: a hard coating carries a wide punch at its edge and lifts off in the middle, an
incompressible film is squeezed out and rises around it.  Under the punch :math:`\sigma(r;a)` of
`winkler.numerics.transforms.fredholm` computes; outside

.. math:: 1 - u_1(r;a) = \frac2\pi\int_a^r \frac{\psi(x;a)}{\sqrt{r^2-x^2}}\,\mathrm dx , \qquad
          \psi(x;a) = 1 - \int_0^a K(x,t)\,\varphi(t;a)\,\mathrm dt .

Both are sampled, octave by octave, and cached by value.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.media.medium import LEAST_SURFACE_RISE, PunchFacts
from winkler.numerics.caching import cached_by_value
from winkler.numerics.integrals.quadrature import panel_nodes
from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.transforms import fredholm, punch_tables
from winkler.numerics.transforms.cosine_transform import WaveResponse, in_own_lengths, transform
from winkler.numerics.transforms.punch_tables import Punches

RADII_PER_TABLE = 16
"""Radii of a table at which sigma is sampled."""
POINTS_PER_PANEL = 17
"""Places of a panel of r/a at which it is."""
LEAST_PULL_RATIO = 1e-9
"""A pull of this part of the greatest push is none."""
SMALL_KERNEL_INTEGRAL = 0.05
"""Where the integral of K cannot be more than this, phi and sigma differ from one by little, and no punch pulls."""
OUTER_POINTS = 160
OUTER_DISTANCE = 16.0
"""Distance up to which the surface outside is evaluated, in radii or lengths of the response of the stack."""


def facts(response: WaveResponse, radius: float) -> PunchFacts:
    """Return what is known of all flat punches up to a radius [m]."""
    response, unit = in_own_lengths(response)
    radius /= unit
    pull, least, most, flat_beyond = math.inf, LEAST_SURFACE_RISE, 1.0, 0.0
    for octave in range(max(int(punch_tables.octave_of(response, np.array([radius]))[0]), 0), -1, -1):
        if _weight_of_octave(response, octave) < SMALL_KERNEL_INTEGRAL:
            break  # and so are all narrower ones
        first, low, high, far = _octave(response, octave)
        pull, least, most, flat_beyond = min(pull, first), min(least, low), max(most, high), max(flat_beyond, far)
    return PunchFacts(
        pulls=bool(pull < radius), least=least, most=most, gives_separation=False, flat_beyond=unit * flat_beyond
    )


@cached_by_value(512)
def _octave(response: WaveResponse, octave: int) -> tuple[float, float, float, float]:
    """Return up to which radius no punch of an octave pulls, and what `_outside` returns for its widest."""
    tables = punch_tables.tables(response, octave)
    pull = min(_first_pull(table) for table in tables)
    return pull, *_outside(response, tables[-1])


@cached_by_value(512)
def _weight_of_octave(response: WaveResponse, octave: int) -> float:
    """Return the weight of the widest punch of an octave of radii."""
    return _weight(response, punch_tables.first_radius(response) * 2.0**octave)


def _weight(response: WaveResponse, a: float) -> float:
    """Return the radius a of a punch times the largest |C| on it."""
    return a * float(np.max(np.abs(transform(response, 2.0 * a)(np.linspace(0.0, 2.0 * a, 65)))))


def _first_pull(table: Punches) -> float:
    """Return the last sampled radius before one whose punch pulls; infinite if none does."""
    cheb = np.polynomial.chebyshev
    s = np.linspace(-1.0, 1.0, RADII_PER_TABLE + 1)
    inner = cheb.chebvander(np.cos(np.linspace(0.0, math.pi, POINTS_PER_PANEL)), table.push.shape[2] - 1)
    sigma = np.einsum("ak,kpi,ri->apr", cheb.chebvander(s, table.push.shape[0] - 1), table.push, inner)
    pulling = np.min(sigma, axis=(1, 2)) < -LEAST_PULL_RATIO * np.max(np.abs(sigma), axis=(1, 2))
    if not pulling.any():
        return math.inf
    before = max(int(np.argmax(pulling)) - 1, 0)
    return float(table.low + (table.high - table.low) * 0.5 * (1.0 + s[before]))


def _outside(response: WaveResponse, table: Punches) -> tuple[float, float, float]:
    """Return least and greatest displacement outside a table's widest punch, and the distance where it is flat."""
    a = table.high
    t, weights = (a * part for part in panel_nodes(table.panels, 24))
    phi = fredholm.punches(response, t, np.full(t.size, a))
    if _weight(response, a) * np.max(np.abs(phi)) < -LEAST_SURFACE_RISE:
        return LEAST_SURFACE_RISE, 1.0, 0.0
    far = OUTER_DISTANCE * max(a, response.span)
    x = a + np.concatenate([[0.0], np.geomspace(1e-3 * min(a, response.length), far, OUTER_POINTS)])
    kernel = transform(response, far + 2.0 * a)
    both = 0.5 * (kernel(x[:, None] - t) + kernel(x[:, None] + t))
    psi = 1.0 - both @ (weights * phi)
    # in y = sqrt(x^2 - a^2) what stands over sqrt(r^2 - x^2) is nearly straight between the samples
    y = root_difference(x, np.full(x.shape, a))
    v = psi * y / x
    rise = np.diff(v) / np.diff(y)
    start, stop = (np.minimum(side / y[1:, None], 1.0) for side in (y[:-1], y[1:]))
    shares = np.arcsin(stop) - np.arcsin(start)
    legs = y[1:, None] * (np.sqrt((1.0 - start) * (1.0 + start)) - np.sqrt((1.0 - stop) * (1.0 + stop)))
    moved = 1.0 - (2.0 / math.pi) * (shares @ (v[:-1] - rise * y[:-1]) + legs @ rise)
    heaved = np.flatnonzero(moved < LEAST_SURFACE_RISE)
    flat_beyond = 0.0
    if heaved.size:  # moved[i] stands at x[i + 1]
        flat_beyond = float(x[heaved[-1] + 2]) - a if heaved[-1] + 2 < x.size else math.inf
    return float(np.min(moved)), float(np.max(moved)), flat_beyond
