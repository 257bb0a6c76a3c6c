r"""Stresses below a line contact on layers, in plane strain, by Fourier integrals.

For each wave number the plane wave :math:`\hat p\cos kx` decays through the layers as the round one
:math:`\hat p\,J_0(kr)` does (`winkler.media.layered.climb`), with :math:`\cos kx, \sin kx` in the places of
:math:`J_0, J_1`:

.. math:: \sigma_z = \frac1\pi\int S\,\hat p\cos kx\,\mathrm dk , \quad
          \tau_{xz} = \frac1\pi\int T\,\hat p\sin kx\,\mathrm dk , \quad
          \sigma_x = \frac1\pi\int\frac{2G\,kU + \nu S}{1-\nu}\,\hat p\cos kx\,\mathrm dk ,
          \quad \sigma_y = \sigma_x - 2C_{66}\,\varepsilon_x ,

with :math:`C_{11}-C_{13}^2/C_{33}` and :math:`C_{13}/C_{33}` for :math:`2G/(1-\nu)` and :math:`\nu/(1-\nu)` in a
transversely isotropic layer.

A traction along x is the same wave a quarter of its length ahead: :math:`-\sin kx, \cos kx` stand for
:math:`\cos kx, \sin kx`.  In the uppermost layer they are what the interfaces add to the field of a half-plane.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from winkler.media.layered.coated_interior import refuse_base, wave_states
from winkler.media.layered.hankel_waves import SHORTEST_WAVES, fading
from winkler.media.layered.stack import StackBody
from winkler.media.offers import LayerStack
from winkler.numerics.chunks import chunks
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, wave_numbers
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import OutsideValidity

FIRST_WAVE_NUMBER = 0.1
"""First panel of wave numbers, in units of 1 / span."""
LARGEST_PHASE = 12.0
MOST_WAVES = 200_000
IS_SHEAR = np.array([False, False, False, True])[:, None]


class PlaneWaves(NamedTuple):
    """Wave numbers k [1/m], and quadrature weights times the transform of the pressure over pi.

    Of a pressure that is not even the transform is that of p exp(-ikx).
    """

    k: Array
    weights: ComplexArray


def plane_waves(
    medium: LayerStack, half_width: float, farthest: float, transform: Callable[[Array], ComplexArray]
) -> PlaneWaves:
    """Return the pressure of a strip as waves, for places up to a distance from the middle.

    Parameters
    ----------
    medium : LayerStack
    half_width, farthest : float
        [m].
    transform
        Of the pressure: takes wave numbers [1/m], returns [N/m].

    Raises
    ------
    OutsideValidity
        If too many waves are needed.
    """
    response = medium.response
    end = min(2.0 * DECAY_SPAN / response.length, SHORTEST_WAVES / half_width)
    widest = LARGEST_PHASE / (half_width + farthest)
    if 24.0 * end / widest > MOST_WAVES:
        raise OutsideValidity(
            f"Stresses at x = {farthest:.6g} m below a strip of the half-width {half_width:.6g} m would need too many "
            f"waves on an uppermost layer of {response.length:.6g} m; request places nearer to it."
        )
    k, weights = wave_numbers(FIRST_WAVE_NUMBER / response.span, widest, end)
    return PlaneWaves(k, weights * fading(k, response.length, half_width) * transform(k) / np.pi)


def added_stresses(medium: LayerStack, waves: PlaneWaves, x: Array, z: Array, friction: float) -> Array:
    """Return sigma_x, sigma_y, sigma_z and tau_xz [Pa] ``(4, m)``, in the uppermost layer without the half-plane's.

    Parameters
    ----------
    medium : LayerStack
    waves : PlaneWaves
    x, z : ndarray, (m,)
        Places [m]; a point on an interface belongs to the upper layer.
    friction : float
        Traction along +x over the pressure [-].

    Raises
    ------
    OutsideValidity
        If a point lies in a rigid base.
    """
    body = StackBody(medium.stack, medium.on)
    refuse_base(body, z)
    result, side = np.zeros((4, x.size)), np.where(x < 0.0, -1.0, 1.0)
    depths, depth_of = np.unique(z, return_inverse=True)
    for some in chunks(depths.size, 8 * waves.k.size):
        (members,) = np.nonzero((depth_of >= some.start) & (depth_of < some.stop))
        places, place_of = np.unique(np.abs(x[members]), return_inverse=True)
        levels = list(_amplitudes(body, depths[some], waves, friction))
        for part in chunks(places.size, waves.k.size):
            phase = np.outer(waves.k, places[part])
            cosine, sine, whole = np.cos(phase), np.sin(phase), np.arange(phase.shape[1])  # once for all depths
            for number, (even, odd) in enumerate(levels, some.start):
                there = (depth_of[members] == number) & (place_of >= part.start) & (place_of < part.stop)
                own, (columns, back) = members[there], np.unique(place_of[there] - part.start, return_inverse=True)
                chosen = slice(None) if np.array_equal(columns, whole) else columns
                even_part, odd_part = (of @ one[: of.shape[1], chosen] for of, one in ((even, cosine), (odd, sine)))
                result[:, own] = even_part[:, back] + side[own] * odd_part[:, back]
    return result


def _amplitudes(body: StackBody, depths: Array, waves: PlaneWaves, friction: float) -> Iterator[tuple[Array, Array]]:
    """Yield, depth by depth, what multiplies cos kx and sin kx in each stress ``(4, k)``."""
    dragged = wave_states(body, depths, waves.k, dragged=True) if friction != 0.0 else itertools.repeat(None)
    for (_, state, end), drag in zip(wave_states(body, depths, waves.k), dragged, strict=False):
        weights = waves.weights[:end]
        level, ahead = np.real(weights), np.imag(weights)
        pressed = np.stack(state.weighted(np.ones(end))[:4])
        even, odd = pressed * level, -pressed * ahead
        even[3], odd[3] = pressed[3] * ahead, pressed[3] * level
        if drag is not None:
            along = friction * np.stack(drag[1].weighted(np.ones(end))[:4])
            even += along * np.where(IS_SHEAR, level, -ahead)
            odd -= along * np.where(IS_SHEAR, ahead, level)
        yield even, odd
