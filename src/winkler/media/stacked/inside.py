"""Stresses and displacements inside a stack whose layers may slide on each other, below an isotropic uppermost one."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.errors import OutsideValidity
from winkler.materials.elastic import Elastic, Rigid
from winkler.media.interior import subsurface
from winkler.media.layered.blocks import Four, stacked, times
from winkler.media.layered.coated_interior import HankelWaves, WaveState, superposed, waves_of
from winkler.media.layered.coated_load import CarriedLoad
from winkler.media.layered.sheet import Body, sheet_of
from winkler.media.punch_field import BodyField
from winkler.media.stacked.climb import AnyLayer, climbed, crossing
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN
from winkler.numerics.types import Array

__all__ = ["field", "wave_states"]


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
        If a point lies in a rigid base, or in an uppermost layer that is transversely isotropic, or the contact is
        hundreds of times wider than the uppermost layer is thick.
    """
    shape, r, z = np.shape(r), np.ravel(r), np.ravel(z)
    bottoms = np.cumsum([layer.thickness for layer in layers])
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
    result = np.zeros((6, r.size))
    if load.radius > 0.0 and r.size:
        waves = waves_of(load, modulus, float(np.max(r)), 2.0 * DECAY_SPAN / load.response.length)
        if isinstance(top, Elastic) and upper.any():
            own = subsurface.field(load, r[upper], z[upper], modulus=modulus, poisson=top.poisson, shear=top.shear)
            result[:, upper] = own
        for depth, state in wave_states(layers, on, np.unique(z), waves.xi):
            (members,) = np.nonzero(z == depth)
            passed = _passed(layers, bottoms, depth)
            end = int(np.searchsorted(waves.xi, 2.0 * DECAY_SPAN / passed))
            result[:, members] += superposed(state, HankelWaves(*(part[:end] for part in waves)), r[members])
    return BodyField(*(part.reshape(shape) for part in result))


def _passed(layers: tuple[AnyLayer, ...], bottoms: Array, depth: float) -> float:
    """Return the distance over which waves at a depth have died out: there and back, in the uppermost layer."""
    if depth <= bottoms[0]:
        return float(2.0 * bottoms[0] - depth)
    above = zip(layers, bottoms, strict=True)
    return sum(
        float(min(layer.thickness, max(depth - bottom + layer.thickness, 0.0))) * sheet_of(layer.solid).slowest
        for layer, bottom in above
    )


def wave_states(
    layers: tuple[AnyLayer, ...], on: Body, depths: Array, xi: Array
) -> Iterator[tuple[float, WaveState]]:
    """Yield, depth by depth, the amplitudes; in the uppermost layer without those of a half-space made of it."""
    rungs = climbed(layers, on, xi)
    tops = np.concatenate([[0.0], np.cumsum([layer.thickness for layer in layers])])
    surface = np.zeros((xi.size, 2, 1))
    surface[:, 1] = -1.0
    arrived = [surface]
    for layer, (support, _) in zip(layers, rungs, strict=True):
        x = xi * layer.thickness
        arrived.append(_matrices(crossing(sheet_of(layer.solid), support, x, x).loaded, x) @ arrived[-1])
    for depth in depths:
        index = int(np.searchsorted(tops[1:], depth))
        start = xi * (depth - tops[index])
        if index == len(layers):
            assert not isinstance(on, Rigid)
            sheet, solid = sheet_of(on), on
            loaded = sheet.decay(start)
            moved = times(sheet.half_space, loaded)
        else:
            solid = layers[index].solid
            sheet = sheet_of(solid)
            moved, loaded = crossing(sheet, rungs[index][0], xi * layers[index].thickness, start)
        if index == 0:
            own = sheet.decay(start)
            loaded, moved = _less(loaded, own), _less(moved, times(sheet.half_space, own))
        states = (_matrices(part, xi) @ arrived[index] for part in (moved, loaded))
        displacement, traction = (state[..., 0] for state in states)
        yield float(depth), WaveState(displacement / sheet.shear, traction, solid)


def _less(one: Four, other: Four) -> Four:
    return one[0] - other[0], one[1] - other[1], one[2] - other[2], one[3] - other[3]


def _matrices(four: Four, like: Array) -> Array:
    return np.asarray(stacked(tuple(np.broadcast_to(entry, like.shape) for entry in four)))  # type: ignore[arg-type]
