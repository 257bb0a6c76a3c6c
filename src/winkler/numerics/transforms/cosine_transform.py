r"""The cosine transform of a response, :math:`C(x) = \frac2\pi\int_0^\infty M(\xi)\cos(\xi x)\,\mathrm d\xi`.

Far away, :math:`x` beyond the length over which M decays, the path is turned into the complex plane,
:math:`\xi = s\,e^{i\theta}`, where :math:`e^{i\xi x}` dies out before it oscillates much: the work per octave of x is
the same however far.  M is analytic there (the resonances of elastic layers stay above 30 degrees: a plate on a thin
incompressible film has :math:`\xi^6=-1`); a second angle checks it.  C is kept as Chebyshev polynomials, octave by
octave.
"""

from __future__ import annotations

import math
from typing import Protocol, cast

import numpy as np

from winkler.numerics.caching import cached_by_value
from winkler.numerics.integrals.quadrature import growing, panel_nodes
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import NotConverged
from winkler.values.value import value

PATH_ANGLES = (math.pi / 12.0, math.pi / 17.0)
"""Of the turned path, and of the one that checks it."""
NODES = 24
DECAY_SPAN = 21.0
"""Where exp(-2 xi length) has vanished, xi in units of 1 / length."""
FIRST_WAVE_NUMBER = 1e-3
"""First panel of wave numbers, in units of 1 / span: M is a power series there."""
ROUNDING_RATIO = 1e-14
"""Rounding of M, what C may be wrong by, times x."""
LARGEST_PHASE = 8.0
"""Over one panel of a wave on the turned path."""
SPENT = 160.0
"""Phase at which a wave on the turned path has died out."""
LEAST_RESPONSE = 0.03
"""An M smaller than this need not be any more precise."""
AGREEMENT_RATIO = 300.0
"""How well both angles must agree, in units of the precision of M, relative to the largest M over x."""


class WaveResponse(Protocol):
    """What an integral equation needs of a medium: a value that can be a key of a cache.

    One that also has `own`, the same response in a unit of length of its own and that unit [m], shares all that is
    computed with those that differ from it by their unit alone.  One that also has `long_wave_kernel` leaves a part
    out of `excess`, which grows for long waves, and has the transform C(x) of that part.
    """

    @property
    def length(self) -> float:
        """M decays like exp(-2 xi length) [m]."""

    @property
    def smooth(self) -> float:
        """C is smooth on this length [m], but for a logarithm rounded off over `length`; `length` if it has none."""

    @property
    def span(self) -> float:
        """M is a power series in xi below the inverse of this length [m]."""

    @property
    def precision(self) -> float:
        """Error of M, relative to its largest value or to 0.03: it is smooth down to that."""

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-], analytic near the positive axis, ``(m,)``."""


class SurfaceResponse(WaveResponse, Protocol):
    """A response with the modulus of the shortest waves."""

    @property
    def modulus(self) -> float:
        """E*, G*, m_L or m_T [Pa] of the surface and the other body: C = 2 (1 + M) / (modulus xi)."""


@value
class ScaledResponse:
    """A response that has its own unit of length, in m: what of it depends on the unit, but not on the moduli.

    Parameters
    ----------
    response : WaveResponse
        In its own unit.
    unit : float
        [m].
    """

    response: WaveResponse
    unit: float

    @property
    def own(self) -> tuple[WaveResponse, float]:
        """Both."""
        return self.response, self.unit

    @property
    def length(self) -> float:
        """M decays like exp(-2 xi length) [m]."""
        return self.response.length * self.unit

    @property
    def smooth(self) -> float:
        """C is smooth on this length [m]."""
        return self.response.smooth * self.unit

    @property
    def span(self) -> float:
        """M is a power series in xi below the inverse of this length [m]."""
        return self.response.span * self.unit

    @property
    def precision(self) -> float:
        """Error of M."""
        return self.response.precision

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-]."""
        return self.response.excess(xi * self.unit)


@cached_by_value(1024)
def scaled_response(response: WaveResponse, unit: float) -> ScaledResponse:
    """Return the response of `ScaledResponse`, the same object for the same content: caches find it sooner."""
    return ScaledResponse(response, unit)


@cached_by_value(256)
def in_own_lengths(response: WaveResponse) -> tuple[WaveResponse, float]:
    """Return a response in its own unit of length, and the unit [m]; itself and one if it has none."""
    return cast(tuple[WaveResponse, float], getattr(response, "own", (response, 1.0)))


def wave_numbers(lowest: float, widest: float, end: float) -> tuple[Array, Array]:
    """Return nodes and weights on [0, end]: panels that double from `lowest` until they are `widest`."""
    edges = [0.0, min(lowest, widest, end)]
    while edges[-1] < end and edges[-1] < widest:
        edges.append(min(2.0 * edges[-1], end))
    if edges[-1] < end:
        count = math.ceil((end - edges[-1]) / widest)
        edges += [edges[-1] + (end - edges[-1]) * part / count for part in range(1, count + 1)]
    return panel_nodes(np.array(edges), NODES)


def faded(response: WaveResponse, distance: float) -> float:
    r"""Return the integral of :math:`M(\xi)\,(1-\cos\xi d)/\xi` at a distance d [m], on the turned path.

    It is by how much less a line load moves the surface there than at itself, beyond what a half-plane does.
    """
    own, unit = in_own_lengths(response)
    away, turn = distance / unit, np.exp(1j * PATH_ANGLES[0])
    longest = DECAY_SPAN / own.length
    spent = min(SPENT / away, longest)
    near, shares = wave_numbers(FIRST_WAVE_NUMBER / max(own.span, away), LARGEST_PHASE / away, spent)
    edges = np.minimum(spent * 2.0 ** np.arange(math.ceil(math.log2(longest / spent)) + 1.0), longest)
    s, weight = (np.append(*parts) for parts in zip((near, shares), panel_nodes(edges, NODES), strict=True))
    parts = own.excess(s * turn) * -np.expm1(1j * s * turn * away) / s
    return float(np.real(parts @ weight))


def transform(response: WaveResponse, end: float) -> Panels:
    """Return C(x) on 0 <= x <= end or a little farther; cached by value.

    Raises
    ------
    NotConverged
        If the turned path gives another result than the one that checks it.
    """
    own, unit = in_own_lengths(response)
    octave = max(0, math.ceil(math.log2(end / unit / own.length)))
    return _stretched(own, octave, unit)


def sine_transform(response: WaveResponse, end: float) -> Panels:
    r"""Return :math:`\frac2\pi\int M(\xi)\sin(\xi x)\,\mathrm d\xi` as `transform` returns C(x).

    Raises
    ------
    NotConverged
        As of `transform`.
    """
    own, unit = in_own_lengths(response)
    return _stretched(own, max(0, math.ceil(math.log2(end / unit / own.length))), unit, odd=True)


@cached_by_value(256)
def _stretched(response: WaveResponse, octave: int, unit: float, odd: bool = False) -> Panels:
    """Return C(x), or the transform of sines, with x in m, of a response in units of a length [m]."""
    panels = _joined(response, octave, odd)
    return panels if unit == 1.0 else Panels(panels.edges * unit, panels.coefficients / unit)


@cached_by_value(256)
def _joined(response: WaveResponse, octave: int, odd: bool) -> Panels:
    last = _octave(response, octave, odd)
    if octave == 0:
        return last
    before = _joined(response, octave - 1, odd)
    return Panels(
        np.concatenate([before.edges, last.edges[1:]]), np.concatenate([before.coefficients, last.coefficients])
    )


def _path(response: WaveResponse, low: float, high: float, angle: float) -> tuple[ComplexArray, ComplexArray]:
    """Return wave numbers and weights times M for x between `low` and `high`; on the real axis for angle zero."""
    end = DECAY_SPAN / response.length
    if angle > 0.0:
        end = min(end / math.cos(angle), 40.0 / (low * math.sin(angle)))
    s, weights = wave_numbers(FIRST_WAVE_NUMBER / response.span, 10.0 / high, end)
    turn = complex(math.cos(angle), math.sin(angle)) if angle > 0.0 else 1.0
    return s * turn, _ray(response, angle)(s) * (weights * turn * (2.0 / math.pi))


@cached_by_value(256)
def _ray(response: WaveResponse, angle: float) -> Panels:
    """Return M along a ray from the origin: the recursion through many layers runs once, not once for every octave."""
    turn = complex(math.cos(angle), math.sin(angle)) if angle > 0.0 else 1.0
    end = DECAY_SPAN / (response.length * math.cos(angle))
    edges = np.array([0.0, *growing(FIRST_WAVE_NUMBER / response.span, end, 2.0), end])
    size = float(np.max(np.abs(response.excess(edges * turn))))

    def along(s: Array) -> ComplexArray:
        return response.excess((s * turn).ravel()).reshape(s.shape)

    return fit_panels(along, edges, response.precision * (size + LEAST_RESPONSE))


def has_tail(response: WaveResponse) -> bool:
    """Return whether M falls like 1 / xi, and its kernel has a logarithm."""
    return response.smooth > response.length


def on_axis(response: WaveResponse, xi: Array) -> Array:
    """Return M at real wave numbers of any shape, to its precision, from polynomials; zero where it has vanished."""
    own, unit = in_own_lengths(response)
    panels, xi = _ray(own, 0.0), xi * unit
    return np.where(xi <= panels.edges[-1], np.real(panels(xi)), 0.0)


def _sum(xi: ComplexArray, weights: ComplexArray, x: Array) -> Array:
    """Return the real part of the sum of weights exp(i xi x)."""
    flat = np.ravel(x)
    parts = [np.real(np.exp(1j * np.outer(flat[i : i + 64], xi)) @ weights) for i in range(0, flat.size, 64)]
    return np.concatenate(parts).reshape(np.shape(x))


@cached_by_value(1024)
def _octave(response: WaveResponse, octave: int, odd: bool) -> Panels:
    high = response.length * 2.0**octave
    low = 0.5 * high if octave else 0.0
    turned = -1j if odd else 1.0  # sin y is the real part of -i exp(iy)
    xi, weights = _path(response, low, high, PATH_ANGLES[0] if octave else 0.0)
    weights = turned * weights
    size = float(np.sum(np.abs(weights * np.exp(1j * xi * low))))
    floor = max(ROUNDING_RATIO, LEAST_RESPONSE * response.precision) / high
    if octave:
        x = np.array([low])
        check, others = _path(response, low, low, PATH_ANGLES[1])
        misfit = float(np.abs(_sum(xi, weights, x) - _sum(check, turned * others, x))[0])
        if misfit > AGREEMENT_RATIO * response.precision * size + 100.0 * floor:
            raise NotConverged(
                f"The kernel of the stack is not resolved at {low:.3g} m: two paths differ by {misfit / size:.1e}; "
                "its contrasts are beyond what winkler can carry."
            )
    split_off = getattr(response, "long_wave_kernel", np.zeros_like)
    return fit_panels(lambda x: _sum(xi, weights, x) + split_off(x), np.array([low, high]), max(1e-14 * size, floor))
