r"""Stresses and displacements inside a stack of layers, by Hankel integrals over what differs from a half-space.

The tractions on the surface, :math:`\hat p\,J_0(\xi r)`, decay through the layers as `winkler.media.layered.climb`
computes; where a layer slides, they pass on without shear.  In the uppermost layer the field of a homogeneous
half-space under the same pressure is known without an integral over waves (`winkler.media.interior.subsurface`); what
the interfaces add dies out like :math:`e^{-\xi(2h-z)}`, so that points on and just below the surface are as good as all
others.  Deeper layers lie at least h below the load and need no such help.

Under a contact of a hundred thicknesses and more the shortest waves fade out: what the interfaces add is that of a
pressure whose edge is rounded off over some thousandths of the radius.  Where the pressure is smooth nothing changes.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.media.interior import subsurface
from winkler.media.layered import layers as stack
from winkler.media.layered.blocks import Four, add, scaled, stacked, times
from winkler.media.layered.climb import AnyLayer, Support, climbed, crossing
from winkler.media.layered.coated_load import CarriedLoad
from winkler.media.layered.wave_constants import Body, constants_of
from winkler.media.punch_field import BodyField
from winkler.numerics.caching import cached_by_value
from winkler.numerics.panels.sqrt_panels import doubled, nodes
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, FIRST_WAVE_NUMBER, NODES, wave_numbers
from winkler.numerics.types import Array

__all__ = [
    "SHORTEST_WAVES",
    "HankelWaves",
    "RadialWaves",
    "WaveState",
    "blurred",
    "fading",
    "field",
    "half_space_decay",
    "reach_of",
    "reaching",
    "refuse_unknown_places",
    "superposed",
    "wave_states",
    "waves_of",
]

LARGEST_PHASE = 10.0
"""Largest phase of a wave over one panel of the quadrature."""
PAIRS_PER_CHUNK = 1_000_000
LEAST_REACH = 1.25
"""Distance from the axis up to which waves are resolved at least, in contact radii."""
MOST_PAIRS = 1e9
"""More pairs of wave numbers and springs than this are refused: the places are too far away."""
SHORTEST_WAVES = 4200.0
"""Greatest wave number times the contact radius; from half of it on the waves of wider contacts fade out."""


class HankelWaves(NamedTuple):
    """Wave numbers, and quadrature weights times xi times the transform of the pressure."""

    xi: Array
    weights: Array

    def up_to(self, count: int) -> HankelWaves:
        """Return the longest of them."""
        return HankelWaves(self.xi[:count], self.weights[:count])


class WaveState(NamedTuple):
    """Amplitudes at one depth per pressure of 1: displacements times xi, tractions; and the solid there."""

    moved: Array
    loaded: Array
    solid: Elastic | TransverselyIsotropic


def field(load: CarriedLoad, layers: tuple[AnyLayer, ...], on: Body, modulus: float, r: Array, z: Array) -> BodyField:
    """Return stresses and displacements inside the stack.

    Parameters
    ----------
    load : CarriedLoad
        The pressure.
    layers, on
        The stack.
    modulus : float
        E* of the uppermost layer and the counterpart [Pa].
    r, z : ndarray
        Of one shape [m]; a point on an interface belongs to the upper layer.

    Raises
    ------
    OutsideValidity
        If a point lies in a rigid base, in an uppermost layer that is transversely isotropic, or hundreds of contact
        radii away from the axis and near the surface.
    """
    shape, r, z = np.shape(r), np.ravel(r), np.ravel(z)
    bottoms = np.cumsum([layer.thickness for layer in layers])
    refuse_unknown_places(layers, on, bottoms, z)
    top, upper = layers[0].solid, z <= bottoms[0]
    result = np.zeros((6, r.size))
    if load.radius > 0.0 and r.size:
        waves = waves_of(load, modulus, reach_of(load, r), 2.0 * DECAY_SPAN / load.response.length)
        if isinstance(top, Elastic) and upper.any():
            own = subsurface.field(load, r[upper], z[upper], modulus=modulus, poisson=top.poisson, shear=top.shear)
            result[:, upper] = own
        depths = np.unique(z)
        waves = waves.up_to(max(reaching(layers, on, bottoms, depths, waves.xi)))
        radial = RadialWaves(waves.xi)
        for depth, state, end in wave_states(layers, on, bottoms, depths, waves.xi):
            (members,) = np.nonzero(z == depth)
            result[:, members] += superposed(state, waves, radial, r[members], end)
    return BodyField(*(part.reshape(shape) for part in result))


def refuse_unknown_places(layers: tuple[AnyLayer, ...], on: Body, bottoms: Array, z: Array) -> None:
    """Refuse depths z [m] in a rigid base, or in a transversely isotropic uppermost layer."""
    top, upper = layers[0].solid, z <= bottoms[0]
    if isinstance(on, Rigid) and np.any(z > bottoms[-1]):
        raise OutsideValidity(
            f"z = {np.max(z):.6g} m lies in the rigid base below {bottoms[-1]:.6g} m of layers; request points in them."
        )
    if not isinstance(top, Elastic) and np.any(upper):
        raise OutsideValidity(
            f"z = {np.min(z):.6g} m lies in a transversely isotropic uppermost layer, in which stresses are not known "
            f"to winkler; request the surface (without z), or points below {bottoms[0]:.6g} m."
        )


def reach_of(load: CarriedLoad, r: Array) -> float:
    """Return a distance from the axis [m] within which all places lie; the same for most calls on one contact."""
    least = LEAST_REACH * load.radius
    return least * 2.0 ** max(0, math.ceil(math.log2(max(float(np.max(r)) / least, 1.0))))


@cached_by_value(8)
def waves_of(load: CarriedLoad, modulus: float, farthest: float, end: float) -> HankelWaves:
    """Return the pressure as a superposition of waves with wave numbers up to `end`, for radii up to `farthest`."""
    response, a = load.response, load.radius
    end = min(end, SHORTEST_WAVES / a)
    xi, weights = wave_numbers(FIRST_WAVE_NUMBER / response.span, LARGEST_PHASE / (a + farthest), end)
    kinks = np.array([b for b, strength in load.kinks if b < a])
    steps = np.arange(1.0, np.ceil(a * end / LARGEST_PHASE)) * (LARGEST_PHASE / end)
    edges = np.unique(np.concatenate([[0.0, a], doubled(list(kinks), a), steps[steps < a]]))
    x, shares = (part[0] for part in nodes(edges[None], kinks, NODES))
    if xi.size * x.size > MOST_PAIRS:
        raise OutsideValidity(
            f"Stresses up to {farthest:.3g} m from the axis of a contact of {a:.3g} m on an uppermost layer of "
            f"{response.length:.3g} m need too many waves; request places nearer to the contact, or the surface alone."
        )
    transform = fading(xi, response.length, a) * _cosines(xi, x, shares * load.value(x))
    return HankelWaves(xi, weights * xi * transform * (modulus / np.pi))


def blurred(length: float, radius: float) -> bool:
    """Return whether the shortest waves that an uppermost layer of a thickness feels fade out under a contact [m]."""
    return 2.0 * DECAY_SPAN / length > SHORTEST_WAVES / radius


def fading(xi: Array, length: float, radius: float) -> Array:
    """Return what is kept of waves [1/m]: a smooth step from one, at half of the greatest wave number, down to zero."""
    if not blurred(length, radius):
        return np.ones(xi.shape)
    ratio = xi * (radius / SHORTEST_WAVES)
    t = np.clip(2.0 * ratio - 1.0, 1e-3, 1.0 - 1e-3)
    step = 1.0 / (1.0 + np.exp(np.clip(1.0 / (1.0 - t) - 1.0 / t, -700.0, 700.0)))
    return np.where(ratio <= 0.5, 1.0, step)


def _cosines(xi: Array, x: Array, load: Array) -> Array:
    """Return the sums of load cos(xi x) at wave numbers that lie in panels, most of which are as wide as the last."""
    rows = xi.reshape(-1, NODES)
    beside = rows[-1] - rows[-1, 0]
    alike = np.abs(rows[:, -1] - rows[:, 0] - beside[-1]) < 1e-9 * beside[-1]
    found = np.empty(rows.shape)
    single = rows[~alike].ravel()
    step = max(1, PAIRS_PER_CHUNK // x.size)
    parts = [np.cos(np.outer(single[i : i + step], x)) @ load for i in range(0, single.size, step)]
    found[~alike] = np.concatenate([np.zeros(0), *parts]).reshape(-1, NODES)
    within, places = np.exp(1j * np.outer(x, beside)), np.flatnonzero(alike)
    for i in range(0, places.size, step):
        part = places[i : i + step]
        found[part] = np.real((np.exp(1j * np.outer(rows[part, 0], x)) * load) @ within)
    return found.ravel()


def wave_states(
    layers: tuple[AnyLayer, ...], on: Body, bottoms: Array, depths: Array, xi: Array, *, dragged: bool = False
) -> Iterator[tuple[float, WaveState, int]]:
    """Yield, depth by depth, the amplitudes and how many wave numbers matter.

    In the uppermost layer the amplitudes are without those of a half-space made of it.

    Parameters
    ----------
    layers, on
        The stack.
    bottoms : ndarray
        Depths of the lower faces of the layers [m].
    depths : ndarray
        Where, ascending [m].
    xi : ndarray, (m,)
        Wave numbers [1/m], ascending.
    dragged : bool
        Whether the traction on the surface is not a pressure but along the wave.
    """
    supports = [support for support, _ in climbed(layers, on, xi)]
    tops = np.concatenate([[0.0], bottoms])
    surface = np.zeros((xi.size, 2, 1))
    surface[:, 0 if dragged else 1] = -1.0
    arrived = [surface]
    for layer, support in zip(layers, supports, strict=True):
        x = xi * layer.thickness
        arrived.append(_matrices(crossing(constants_of(layer.solid), support, x, x).loaded, x) @ arrived[-1])
    index_of = np.searchsorted(bottoms, depths)
    most = max(1, PAIRS_PER_CHUNK // (8 * max(xi.size, 1)))
    for index in np.unique(index_of):
        (members,) = np.nonzero(index_of == index)
        for first in range(0, members.size, most):  # several depths at once: most stacks have few wave numbers
            part = depths[members[first : first + most]]
            start = (xi * (part[:, None] - tops[index])).ravel()
            if index == len(layers):
                assert not isinstance(on, Rigid)
                solid = on
                constants = constants_of(solid)
                loaded = constants.decay(start)
                moved = times(constants.half_space, loaded)
            else:
                solid = layers[index].solid
                constants = constants_of(solid)
                below = Support(
                    tuple(np.tile(np.broadcast_to(entry, xi.shape), part.size) for entry in supports[index].compliance),  # type: ignore[arg-type]
                    supports[index].bonded,
                )
                moved, loaded = crossing(constants, below, np.tile(xi * layers[index].thickness, part.size), start)
            if index == 0:
                own = scaled(-1.0, constants.decay(start))
                loaded, moved = add(loaded, own), add(moved, times(constants.half_space, own))
            displacement, traction = (_applied(four, arrived[index], part.size) for four in (moved, loaded))
            for depth, moves, loads in zip(part, displacement, traction, strict=True):
                (end,) = reaching(layers, on, bottoms, np.array([depth]), xi)
                yield float(depth), WaveState(moves / constants.shear, loads, solid), end


def reaching(layers: tuple[AnyLayer, ...], on: Body, bottoms: Array, depths: Array, xi: Array) -> list[int]:
    """Return how many of the wave numbers matter at each depth."""
    return [int(np.searchsorted(xi, 2.0 * DECAY_SPAN / _passed(layers, on, bottoms, depth))) for depth in depths]


def _applied(four: Four, arrived: Array, count: int) -> Array:
    """Return what matrices of several depths ``(count * m,)`` make of the tractions ``(m, 2, 1)``."""
    shear, axial = arrived[:, 0, 0], arrived[:, 1, 0]
    a, b, c, d = (np.reshape(np.broadcast_to(entry, (count * shear.size,)), (count, shear.size)) for entry in four)
    return np.stack([a * shear + b * axial, c * shear + d * axial], axis=-1)


def _passed(layers: tuple[AnyLayer, ...], on: Body, bottoms: Array, depth: float) -> float:
    """Return the distance over which waves at a depth have died out: there and back, in the uppermost layer."""
    if depth <= bottoms[0]:
        return float(2.0 * bottoms[0] - depth)
    above = [
        (float(min(layer.thickness, max(depth - bottom + layer.thickness, 0.0))), layer.solid)
        for layer, bottom in zip(layers, bottoms, strict=True)
    ]
    if depth > bottoms[-1] and not isinstance(on, Rigid):
        above.append((float(depth - bottoms[-1]), on))
    return sum(
        passed * min(constants_of(solid).slowest, math.sqrt(constants_of(solid).twist)) for passed, solid in above
    )


def _matrices(four: Four, like: Array) -> Array:
    return np.asarray(stacked(tuple(np.broadcast_to(entry, like.shape) for entry in four)))  # type: ignore[arg-type]


def half_space_decay(x: Array, poisson: float) -> Array:
    """Return the tractions at x below the surface of a half-space per tractions on it."""
    _, down = stack.decaying(x, poisson)
    _, top = stack.decaying(np.zeros(1), poisson)
    return np.asarray(np.exp(-x)[:, None, None] * (down @ np.linalg.inv(top)))


class RadialWaves:
    """J_0 and J_1 of waves at distances r, kept from depth to depth: on a grid they share their places."""

    def __init__(self, xi: Array) -> None:
        self.xi = xi
        self._r = np.zeros(0)
        self._kept = np.zeros((2, 0, xi.size))

    def at(self, r: Array) -> Array:
        """Return both at few distances [m], ``(2, r.size, xi.size)``."""
        if not np.array_equal(r, self._r):
            from scipy.special import j0, j1

            phase = np.outer(r, self.xi)
            self._r, self._kept = r, np.stack([j0(phase), j1(phase)])
        return self._kept


def superposed(state: WaveState, waves: HankelWaves, radial: RadialWaves, r: Array, end: int) -> Array:
    """Return the six parts of a `BodyField` at one depth, to which the first `end` of the waves reach."""
    constants = constants_of(state.solid)
    plane, twice = constants.shear * constants.plane, 2.0 * constants.shear * constants.twist
    xi, weights = waves.xi[:end], waves.weights[:end]
    strain, lift = state.moved[:end, 0] * weights, state.moved[:end, 1] * weights
    shear, axial = state.loaded[:end, 0] * weights, state.loaded[:end, 1] * weights
    common = constants.lateral * axial + (plane - twice) * strain
    even = np.stack([common + twice * strain, common, axial, lift / xi], axis=1)
    odd = np.stack([shear, strain / xi], axis=1)
    result = np.empty((6, r.size))
    step = max(1, PAIRS_PER_CHUNK // waves.xi.size)
    for start in range(0, r.size, step):
        part = slice(start, start + step)
        zeroth, first = (values[:, :end] for values in radial.at(r[part]))
        along, crosswise, normal, lifted = (zeroth @ even).T
        sheared, outward = (first @ odd).T
        # J_1(xi r)/(xi r), whose limit on the axis is a half
        near = r[part] * xi[-1] <= 1e-8
        bend = np.where(near, 0.5 * np.sum(twice * strain), twice * outward / np.where(near, 1.0, r[part]))
        result[:, part] = along - bend, crosswise + bend, normal, sheared, outward, lifted
    return result
