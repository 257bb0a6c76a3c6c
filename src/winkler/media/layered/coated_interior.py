r"""Stresses and displacements inside a stack of layers, by Hankel integrals over what differs from a half-space.

The tractions on the surface, :math:`\hat p\,J_0(\xi r)`, decay through the layers as `winkler.media.layered.climb`
computes; where a layer slides, they pass on without shear.  In the uppermost layer the field of a homogeneous
half-space under the same pressure is known without an integral over waves (`winkler.media.interior.subsurface`); what
the interfaces add dies out like :math:`e^{-\xi(2h-z)}`, so that points on and just below the surface are as good as all
others.  Deeper layers lie at least h below the load and need no such help.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.media.layered.blocks import Four, add, scaled, times
from winkler.media.layered.climb import Support, climbed, crossing
from winkler.media.layered.coated_load import CarriedLoad
from winkler.media.layered.hankel_waves import HankelWaves, RadialWaves, reach_of, waves_of
from winkler.media.layered.solid_field import solid_field
from winkler.media.layered.stack import StackBody
from winkler.media.layered.wave_constants import constants_of
from winkler.media.punch_field import BodyField
from winkler.numerics.chunks import chunks
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity


class WaveState(NamedTuple):
    """Amplitudes at one depth per pressure of 1: displacements times xi, tractions; and the solid there."""

    moved: Array
    loaded: Array
    solid: Elastic | TransverselyIsotropic

    def weighted(self, weights: Array) -> tuple[Array, Array, Array, Array, Array, Array]:
        """Return stresses along, across, down and in shear, and displacements times xi, of the first waves."""
        solid = constants_of(self.solid)
        strain, lift = self.moved[: weights.size].T * weights
        shear, down = self.loaded[: weights.size].T * weights
        along = solid.shear * solid.plane * strain + solid.lateral * down
        return along, along - 2.0 * solid.shear * solid.twist * strain, down, shear, strain, lift


def field(load: CarriedLoad, body: StackBody, modulus: float, r: Array, z: Array) -> BodyField:
    """Return stresses and displacements inside the stack.

    Parameters
    ----------
    load : CarriedLoad
        The pressure.
    body : StackBody
        The stack.
    modulus : float
        E* of the uppermost layer and the counterpart [Pa].
    r, z : ndarray
        Of one shape [m]; a point on an interface belongs to the upper layer.

    Raises
    ------
    OutsideValidity
        If a point lies in a rigid base, or hundreds of contact radii away from the axis and near the surface.
    """
    shape, r, z = np.shape(r), np.ravel(r), np.ravel(z)
    refuse_base(body, z)
    upper = z <= body.bottoms[0]
    result = np.zeros((6, r.size))
    if load.radius > 0.0 and r.size:
        waves = waves_of(load, modulus, reach_of(load, r), 2.0 * DECAY_SPAN / load.response.length)
        if upper.any():
            result[:, upper] = solid_field(load, r[upper], z[upper], modulus=modulus, solid=body.layers[0].solid)
        depths = np.unique(z)
        waves = waves.up_to(max(reaching(body, depths, waves.xi)))
        radial = RadialWaves(waves.xi)
        for depth, state, end in wave_states(body, depths, waves.xi):
            (members,) = np.nonzero(z == depth)
            result[:, members] += superposed(state, waves, radial, r[members], end)
    return BodyField(*(part.reshape(shape) for part in result))


def refuse_base(body: StackBody, z: Array) -> None:
    """Refuse depths z [m] in a rigid base."""
    if isinstance(body.on, Rigid) and np.any(z > body.bottoms[-1]):
        raise OutsideValidity(
            f"z = {np.max(z):.6g} m lies in the rigid base below {body.bottoms[-1]:.6g} m of layers; request points in "
            "them."
        )


def refuse_unknown_places(body: StackBody, z: Array) -> None:
    """Refuse depths z [m] in a rigid base, or in a transversely isotropic uppermost layer."""
    refuse_base(body, z)
    if not isinstance(body.top, Elastic) and np.any(z <= body.bottoms[0]):
        raise OutsideValidity(
            f"z = {np.min(z):.6g} m lies in a transversely isotropic uppermost layer, in which stresses of "
            f"tractions and of height maps are not implemented; request points below {body.bottoms[0]:.6g} m."
        )


def wave_states(
    body: StackBody, depths: Array, xi: Array, *, dragged: bool = False
) -> Iterator[tuple[float, WaveState, int]]:
    """Yield, depth by depth, the amplitudes and how many wave numbers matter.

    In the uppermost layer the amplitudes are without those of a half-space made of it.

    Parameters
    ----------
    body : StackBody
        The stack.
    depths : ndarray
        Where, ascending [m].
    xi : ndarray, (m,)
        Wave numbers [1/m], ascending.
    dragged : bool
        Whether the traction on the surface is not a pressure but along the wave.
    """
    layers, on, bottoms = body.layers, body.on, body.bottoms
    supports, arrived = _arrived(body, xi.tobytes(), dragged)
    tops = np.concatenate([[0.0], bottoms])
    index_of = np.searchsorted(bottoms, depths)
    for index in np.unique(index_of):
        (members,) = np.nonzero(index_of == index)
        for some in chunks(members.size, 8 * xi.size):  # several depths at once: most stacks have few wave numbers
            part = depths[members[some]]
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
                (end,) = reaching(body, np.array([depth]), xi)
                yield float(depth), WaveState(moves / constants.shear, loads, solid), end


@functools.lru_cache(maxsize=4)
def _arrived(body: StackBody, wave_numbers: bytes, dragged: bool) -> tuple[list[Support], list[Array]]:
    """Return what lies below each layer, and the tractions on its upper face and on the base per traction of 1."""
    xi = np.frombuffer(wave_numbers)
    supports = [support for support, _ in climbed(body.layers, body.on, xi)]
    surface = np.zeros((xi.size, 2))
    surface[:, 0 if dragged else 1] = -1.0
    arrived = [surface]
    for layer, support in zip(body.layers, supports, strict=True):
        x = xi * layer.thickness
        arrived.append(_applied(crossing(constants_of(layer.solid), support, x, x).loaded, arrived[-1], 1)[0])
    return supports, arrived


def reaching(body: StackBody, depths: Array, xi: Array) -> list[int]:
    """Return how many of the wave numbers matter at each depth."""
    return [int(np.searchsorted(xi, 2.0 * DECAY_SPAN / _passed(body, depth))) for depth in depths]


def _applied(four: Four, arrived: Array, count: int) -> Array:
    """Return what matrices of several depths ``(count * m,)`` make of the tractions ``(m, 2)``."""
    shear, axial = arrived.T
    a, b, c, d = (np.reshape(np.broadcast_to(entry, (count * shear.size,)), (count, shear.size)) for entry in four)
    return np.stack([a * shear + b * axial, c * shear + d * axial], axis=-1)


def _passed(body: StackBody, depth: float) -> float:
    """Return the distance over which waves at a depth have died out: there and back, in the uppermost layer."""
    on, bottoms = body.on, body.bottoms
    if depth <= bottoms[0]:
        return float(2.0 * bottoms[0] - depth)
    above = [
        (float(min(layer.thickness, max(depth - bottom + layer.thickness, 0.0))), layer.solid)
        for layer, bottom in zip(body.layers, bottoms, strict=True)
    ]
    if depth > bottoms[-1] and not isinstance(on, Rigid):
        above.append((float(depth - bottoms[-1]), on))
    return sum(
        passed * min(constants_of(solid).slowest, math.sqrt(constants_of(solid).twist)) for passed, solid in above
    )


def superposed(state: WaveState, waves: HankelWaves, radial: RadialWaves, r: Array, end: int) -> Array:
    """Return the six parts of a `BodyField` at one depth, to which the first `end` of the waves reach."""
    constants = constants_of(state.solid)
    xi, twice = waves.xi[:end], 2.0 * constants.shear * constants.twist
    along, across, down, shear, strain, lift = state.weighted(waves.weights[:end])
    even = np.stack([along, across, down, lift / xi], axis=1)
    odd = np.stack([shear, strain / xi], axis=1)
    result = np.empty((6, r.size))
    for part in chunks(r.size, waves.xi.size):
        zeroth, first = (values[:, :end] for values in radial.at(r[part]))
        lengthwise, crosswise, normal, lifted = (zeroth @ even).T
        sheared, outward = (first @ odd).T
        # J_1(xi r)/(xi r), whose limit on the axis is a half
        near = r[part] * xi[-1] <= 1e-8
        bend = np.where(near, 0.5 * np.sum(twice * strain), twice * outward / np.where(near, 1.0, r[part]))
        result[:, part] = lengthwise - bend, crosswise + bend, normal, sheared, outward, lifted
    return result
