r"""The pressure under displaced springs on a layered medium, as a load on a homogeneous half-space.

On layers the springs' load gives the force, not the pressure.  The pressure comes from

.. math:: \frac{q(x)}{E^*} = \varphi(x) = w(x) - \int_x^a \rho(x;t)\,w(t)\,\mathrm dt, \qquad
          w(t) = \varphi(t;t)\,u(t) ,

the superposition of flat punches that belongs to the displacement u(t) of the springs.  `CarriedLoad` holds it in the
form of a displacement of homogeneous springs, so that every transform of the homogeneous half-space made of the
uppermost layer can be used: T4 gives the pressure.  The layers' own share of the surface displacement is T3 of

.. math:: (K\varphi)(x) = \tfrac12\int_{-a}^{a} C(x-t)\,\varphi(t)\,\mathrm dt ,

which goes on beyond the contact.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from winkler.media.medium import Displacement
from winkler.numerics.caching import cached_by_value
from winkler.numerics.chunks import chunks
from winkler.numerics.panels.sqrt_panels import RootPanels, doubled, fit, nodes
from winkler.numerics.transforms import abel, fredholm
from winkler.numerics.transforms.cosine_transform import WaveResponse, transform
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged
from winkler.values.value import value

RULE_NODES = (16, 32, 64)
SETTLED_TOLERANCE = 1e-12
LAST_TOLERANCE = 1e-8
SLOPE_NOISE = 10.0
"""How much less well, than the integral, its slope is known where the kernel has a logarithm."""
NEAR_AXIS = 1e-4
"""Distance from the axis up to which an odd function is a straight line, over the length on which it changes."""
TABLE_TOLERANCE = 1e-13
"""How closely, relative to the greatest, the springs' displacement is tabulated for integrals over it."""
FIRST_DISTANCE = 2.0
"""First distance from where the kernel is sharp, in lengths of the kernel; the others double."""
PAIRS_AT_ONCE = 200_000


@value
class CarriedLoad:
    """q(x) / E* [m]: the springs' displacement of a homogeneous half-space that presses with the same pressure.

    Parameters
    ----------
    displacement : Displacement
        u(x) of the springs of the layered medium.
    response : WaveResponse
        Of the medium.
    """

    displacement: Displacement
    response: WaveResponse

    @property
    def radius(self) -> float:
        """Contact radius a [m]."""
        return self.displacement.radius

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Those of u, and the ends of the panels on which the edge of the contact is resolved."""
        a = self.radius
        own = {b: strength * float(self._edge_at(b)) for b, strength in self.displacement.kinks if b < a}
        panels = _panels(self)
        return tuple(sorted({**{float(x): 0.0 for x in panels.edges[1:-1] if x > 0.1 * a}, **own}.items()))

    @property
    def edge(self) -> float:
        """q(a-) / E* [m]."""
        jump = self.displacement.edge
        return jump * float(self._edge_at(self.radius)) if jump else 0.0

    def _edge_at(self, x: float) -> Array:
        return fredholm.edge(self.response, np.asarray(x))

    def value(self, x: Array) -> Array:
        """q(x) / E* [m] for x <= a."""
        x = np.asarray(x, dtype=float)
        return np.asarray(fredholm.edge(self.response, x) * self.displacement.value(x) - _panels(self)(x)[0])

    def slope(self, x: Array) -> Array:
        """Its derivative [-]."""
        x = np.asarray(x, dtype=float)
        own = fredholm.edge(self.response, x) * self.displacement.slope(x)
        # what the layers add is even in x, so its slope is odd: next to the axis only rounding would be left of it
        near = NEAR_AXIS * min(self.radius, self.response.length, self.response.smooth)
        beside = np.maximum(x, near)
        edge_part = fredholm.edge_slope(self.response, beside) * self.displacement.value(beside)
        return np.asarray(own + (edge_part - _panels(self)(beside)[1]) * (x / beside))


def surface(displacement: Displacement, response: WaveResponse, r: Array) -> Array:
    """Return the displacement of the surface [m], inside and outside the contact, sum over both bodies."""
    r = np.asarray(r, dtype=float)
    load = CarriedLoad(displacement, response)
    reach = max(float(np.max(r, initial=0.0)), load.radius)
    layers = spread(load, math.ceil(math.log2(reach / load.radius) - 1e-12))
    own = abel.surface(load.value, [b for b, _ in load.kinks], r, load.radius)
    return own + abel.surface(lambda x: np.asarray(layers(x)[0]), list(layers.edges[1:-1]), r)


def kernel_steps(response: WaveResponse, reach: float) -> Array:
    """Return the distances at which an integral over the kernel is cut."""
    first = FIRST_DISTANCE * response.length
    return np.asarray(first * 2.0 ** np.arange(max(1, math.ceil(math.log2(max(reach / first, 1.0))) + 1)))


def _rows(fixed: Array, moving: Array, low: Array, high: float) -> Array:
    """Return ascending edges between `low` ``(m,)`` and `high`, row by row."""
    m = low.size
    edges = np.concatenate(
        [low[:, None], np.broadcast_to(fixed, (m, fixed.size)), moving, np.full((m, 1), high)], axis=1
    )
    edges = np.clip(edges, low[:, None], high)
    edges.sort(axis=1)
    return np.asarray(edges)


def _size(load: CarriedLoad) -> float:
    """Return the largest displacement of the springs [m]."""
    return float(np.max(np.abs(load.displacement.value(load.radius * np.linspace(0.0, 1.0, 9)))))


@cached_by_value(64)
def _springs(displacement: Displacement) -> RootPanels:
    """Return u(x) on panels: the springs are evaluated at many more places than it takes to tabulate them."""
    a, kinks = displacement.radius, np.array([b for b, _ in displacement.kinks if b < displacement.radius])

    def tolerances(values: Array) -> Array:
        return np.asarray(TABLE_TOLERANCE * np.max(np.abs(values), axis=1))

    edges = np.concatenate([[0.0], kinks, [a]])
    return fit(lambda x: displacement.value(x)[None], np.unique(edges), kinks, tolerances)


@cached_by_value(128)
def _panels(load: CarriedLoad) -> RootPanels:
    """Return the integral over rho w and its derivative by x."""
    a, kinks = load.radius, np.array([b for b, _ in load.displacement.kinks if b < load.radius])
    near_edge = a - kernel_steps(load.response, a)
    edges = np.unique(np.concatenate([[0.0, a], doubled(list(kinks), a), near_edge[near_edge > 0.0]]))
    scale = _size(load)

    def tolerances(values: Array) -> Array:
        size = np.max(np.abs(values), axis=1)
        return _smooth(load) * np.array([max(size[0], scale), 10.0 * max(size[1], scale / a)])

    def sums(count: int, x: Array) -> Array:
        return _rho_sums(load, x, kinks, count)

    logarithm = load.response.smooth > load.response.length
    steep = np.array([1.0, SLOPE_NOISE if logarithm else 1.0])
    return fit(
        lambda x: _settled(sums, x, np.array([scale, scale / a]), _target_tolerance(load), steep),
        edges,
        kinks,
        tolerances,
    )


def _target_tolerance(load: CarriedLoad) -> float:
    """Return the relative error aimed at: not less than that of the response."""
    return max(SETTLED_TOLERANCE, load.response.precision)


def _smooth(load: CarriedLoad) -> float:
    """Return how smooth, relative to its size, what is tabulated can be expected to be."""
    return max(SETTLED_TOLERANCE, 1e-3 * load.response.precision)


def _settled(
    sums: Callable[[int, Array], Array], x: Array, least: Array, aim: float, noise: Array | float = 1.0
) -> Array:
    """Return sums as of `settled_sums`."""
    refusal = (
        "The pressure on the layers still moves by {:.1e}: the springs' displacement is not smooth between its kinks."
    )
    return settled_sums(lambda count: sums(count, x), least, aim, max(LAST_TOLERANCE, 100.0 * aim), refusal, noise)


def settled_sums(
    sums: Callable[[int], Array],
    least: Array,
    aim: float,
    last: float,
    refusal: str,
    noise: Array | float = 1.0,
    rules: tuple[int, ...] = RULE_NODES,
) -> Array:
    """Return sums ``(functions, n)`` by rules of so many nodes that another one changes them by less than `aim`.

    Parameters
    ----------
    sums : callable
        Takes a number of nodes.
    least : ndarray, (functions,)
        What the sums add to: changes count over that, or over their size where it is more.
    aim, last : float
        The change that is aimed at, and that of the finest rules above which they are refused.
    refusal : str
        With a place for the change.
    noise : ndarray or float, optional
        Changes count so many times less.
    rules : tuple of int, optional
    """
    found, change = sums(rules[0]), math.inf
    for count in rules[1:]:
        before, found = found, sums(count)
        size = np.maximum(np.max(np.abs(found), axis=1), least)
        change = float(np.max(np.max(np.abs(found - before), axis=1) / np.where(size > 0.0, size, 1.0) / noise))
        if change <= aim:
            return found
    if change > last:
        raise NotConverged(refusal.format(change))
    return found


def _rho_sums(load: CarriedLoad, x: Array, kinks: Array, count: int) -> Array:
    a, response, springs = load.radius, load.response, _springs(load.displacement)
    steps, fixed = kernel_steps(response, a), doubled(list(kinks), a)
    result = np.empty((2, x.size))
    for rows in chunks(x.size, count * (steps.size + fixed.size + 5), PAIRS_AT_ONCE):
        part = x[rows]
        t, weights = nodes(_rows(fixed, part[:, None] + steps, part, a), kinks, count)
        w = weights * fredholm.edge(response, t) * springs(t)[0]
        rho = fredholm.resolvent(response, np.broadcast_to(part[:, None], t.shape), t)
        result[:, rows] = np.sum(w * rho.value, axis=1), np.sum(w * rho.across, axis=1)
    own = fredholm.resolvent(response, x, x).value * fredholm.edge(response, x) * load.displacement.value(x)
    result[1] -= own
    return result


@cached_by_value(64)
def spread(load: CarriedLoad, octave: int, order: int = 0) -> RootPanels:
    """Return K phi, or its slope (order 1), from the axis to 2^octave contact radii."""
    a = load.radius
    end = a * 2.0**octave
    steps = kernel_steps(load.response, end)
    edges = np.concatenate([[0.0, a, end], a - steps, a + steps])
    edges = np.unique(edges[(edges >= 0.0) & (edges <= end)])
    kernel = transform(load.response, end + a)
    if order:
        kernel = kernel.derivative
    kinks = np.array([b for b, _ in load.kinks])
    panels = np.unique(np.concatenate([doubled(list(kinks), a), a - steps[steps < a]]))
    least = np.array([_size(load) / a**order])
    springs = _springs(load.displacement)

    def line_load(t: Array) -> Array:
        return np.asarray(fredholm.edge(load.response, t) * springs(t)[0] - _panels(load)(t)[0])

    def sums(count: int, x: Array) -> Array:
        result = np.empty((1, x.size))
        for rows in chunks(x.size, count * (4 * steps.size + panels.size + 5), PAIRS_AT_ONCE):
            part = x[rows, None]
            near = np.concatenate([part - steps, part, part + steps, steps - part], axis=1)
            t, weights = nodes(_rows(panels, near, np.zeros(part.size), a), kinks, count)
            towards = np.sign(part - t) if order else 1.0
            both = towards * kernel(np.abs(part - t)) + kernel(part + t)
            result[0, rows] = 0.5 * np.sum(weights * line_load(t) * both, axis=1)
        return result

    def tolerances(values: Array) -> Array:
        return np.asarray(_smooth(load) * np.maximum(np.max(np.abs(values), axis=1), least))

    return fit(lambda x: _settled(sums, x, least, _target_tolerance(load)), edges, np.zeros(0), tolerances)
