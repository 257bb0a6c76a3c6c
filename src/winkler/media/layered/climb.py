r"""How displacements and tractions of one wave number are passed on through a stack whose layers are bonded or slide.

What lies below a face is known by two states of displacements and tractions, the columns of :math:`(N_u, N_t)`, of
which all others are made: :math:`(Y, 1)` with the compliance Y of what the layer is bonded to, and, where it slides,
:math:`U` alone beside :math:`W=Y_{WW}S` without shear.  A thin layer is crossed by its propagator

.. math:: Y^\uparrow = (P_{uu}N_u+P_{ut}N_t)\,(P_{tu}N_u+P_{tt}N_t)^{-1} ,

a thick one by a field that decays downward from tractions a on its upper face, :math:`E\,a`, and one that decays upward
from tractions :math:`R\,E\,a` on its lower face: no exponential grows, and nothing cancels in thin layers.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.materials.elastic import Rigid
from winkler.materials.layered import Layer, StackLayer
from winkler.media.layered.blocks import Four, add, invert, scaled, times
from winkler.media.layered.faces import LEAST_WAVE, THIN_LAYER_LIMIT, above, compliance_of, face_of, mirrored, slid
from winkler.media.layered.wave_constants import Body, WaveConstants, constants_of
from winkler.numerics.types import ComplexArray

AnyLayer = Layer | StackLayer


class Support(NamedTuple):
    """What lies below a face: its compliance [1/Pa], and whether the layer above is bonded to it."""

    compliance: Four
    bonded: bool


class Crossing(NamedTuple):
    """Displacements and tractions, in a layer at some height, per traction on its upper face; in units of its C44."""

    moved: Four
    loaded: Four


def crossing(constants: WaveConstants, support: Support, x: ComplexArray, start: ComplexArray) -> Crossing:
    """Return the state in a layer.

    Parameters
    ----------
    constants : WaveConstants
        Its solid.
    support : Support
        What lies below it.
    x, start : ndarray, (m,)
        xi times its thickness, and times the depth of the place below its upper face.
    """
    thin = np.abs(x) * constants.steepest <= THIN_LAYER_LIMIT
    x = np.where(np.abs(x) < LEAST_WAVE, LEAST_WAVE, x)
    entries = [np.empty_like(x) for _ in range(8)]
    compliance = tuple(np.broadcast_to(constants.shear * entry, x.shape) for entry in support.compliance)
    for chosen, crossed in ((thin, _propagated), (~thin, _split)):
        if chosen.any():
            below = Support(tuple(entry[chosen] for entry in compliance), support.bonded)  # type: ignore[arg-type]
            found = crossed(constants, below, x[chosen], start[chosen])
            for entry, part in zip(entries, (*found.moved, *found.loaded), strict=True):
                entry[chosen] = part
    return Crossing(tuple(entries[:4]), tuple(entries[4:]))  # type: ignore[arg-type]


def _propagated(constants: WaveConstants, support: Support, x: ComplexArray, start: ComplexArray) -> Crossing:
    one, none = np.ones_like(x), np.zeros_like(x)
    moved, loaded = support.compliance, (one, none, none, one)
    if not support.bonded:
        moved, loaded = (one, none, none, moved[3]), (none, none, none, one)

    def lifted(height: ComplexArray) -> tuple[Four, Four]:
        uu, ut, tu, tt = constants.propagator(height)
        return add(times(uu, moved), times(ut, loaded)), add(times(tu, moved), times(tt, loaded))

    at_top = invert(lifted(x)[1])
    here_moved, here_loaded = lifted(x - start)
    return Crossing(times(here_moved, at_top), times(here_loaded, at_top))


def _split(constants: WaveConstants, support: Support, x: ComplexArray, start: ComplexArray) -> Crossing:
    own, rising, one = constants.half_space, constants.rising_half_space, (1.0, 0.0, 0.0, 1.0)

    def misfit(half_space: Four) -> Four:
        """What the states of a half-space leave of the conditions below the layer."""
        a, b, c, d = support.compliance
        if support.bonded:
            return half_space[0] - a, half_space[1] - b, half_space[2] - c, half_space[3] - d
        zero = np.zeros_like(x)
        return zero + 1.0, zero, zero + half_space[2], half_space[3] - d

    down = constants.decay(x)
    reflected = scaled(-1.0, times(invert(misfit(rising)), times(misfit(own), down)))
    amplitude = invert(add(one, times(mirrored(down), reflected)))  # type: ignore[arg-type]
    falling = times(constants.decay(start), amplitude)
    climbing = times(mirrored(constants.decay(x - start)), times(reflected, amplitude))
    return Crossing(add(times(own, falling), times(rising, climbing)), add(falling, climbing))


def support_of(on: Body) -> Four:
    """Return the compliance of what carries the stack [1/Pa]."""
    if isinstance(on, Rigid):
        nothing = np.array(0.0)
        return nothing, nothing, nothing, nothing
    constants = constants_of(on)
    return scaled(1.0 / constants.shear, constants.half_space)


def climbed(layers: tuple[AnyLayer, ...], on: Body, xi: ComplexArray) -> list[tuple[Support, Four]]:
    """Climb through a stack.

    Parameters
    ----------
    layers : tuple of Layer or StackLayer
        From the top.
    on : Elastic, TransverselyIsotropic or Rigid
        What carries them.
    xi : ndarray, (m,)
        Wave numbers [1/m].

    Returns
    -------
    list
        For every layer from the top what lies below it, and the compliance at its upper face [1/Pa].
    """
    zero = np.zeros_like(xi)
    face = face_of(tuple(zero + entry for entry in support_of(on)))  # type: ignore[arg-type]
    rungs = []
    for layer in reversed(layers):
        bonded = layer.bonded
        support = Support(compliance_of(face), bonded)
        face = above(constants_of(layer.solid), face if bonded else slid(face), xi * layer.thickness)
        rungs.append((support, compliance_of(face)))
    return rungs[::-1]
