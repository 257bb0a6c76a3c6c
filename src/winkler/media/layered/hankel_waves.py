r"""The waves of which the pressure under a round contact on layers consists, and their Bessel functions.

A wave of the wave number :math:`\xi` that the layers answer dies out like :math:`e^{-2\xi h}`.  Under a contact of a
hundred thicknesses and more the shortest of them fade out: what the interfaces add is that of a pressure whose edge is
rounded off over some thousandths of the radius.  Where the pressure is smooth nothing changes.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.media.layered.coated_load import CarriedLoad
from winkler.numerics.caching import cached_by_value
from winkler.numerics.chunks import wave_sums
from winkler.numerics.panels.sqrt_panels import doubled, nodes
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, FIRST_WAVE_NUMBER, NODES, wave_numbers
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

LARGEST_PHASE = 24.0
"""Largest phase of a wave over one panel of the quadrature: its 24 nodes err by (e/8)^48, 1e-22."""
TURNED_TOGETHER = 32
"""Panels of equal width whose waves differ from those of the first by the same turns."""
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
    return faded_out(2.0 * xi * (radius / SHORTEST_WAVES) - 1.0)


def faded_out(place: Array) -> Array:
    """Return a smooth step from one, up to 0, to zero, from 1 on."""
    t = np.clip(place, 1e-3, 1.0 - 1e-3)
    step = 1.0 / (1.0 + np.exp(np.clip(1.0 / (1.0 - t) - 1.0 / t, -700.0, 700.0)))
    return np.where(place <= 0.0, 1.0, np.where(place >= 1.0, 0.0, step))


def _cosines(xi: Array, x: Array, load: Array) -> Array:
    """Return the sums of load cos(xi x) at wave numbers that lie in panels, most of which are as wide as the last."""
    rows = xi.reshape(-1, NODES)
    beside = rows[-1] - rows[-1, 0]
    alike = np.abs(rows[:, -1] - rows[:, 0] - beside[-1]) < 1e-9 * beside[-1]
    found = np.empty(rows.shape)
    found[~alike] = wave_sums(np.cos, rows[~alike], x, load)
    within, starts = np.exp(1j * np.outer(x, beside)), rows[alike, 0]
    turned = np.exp(1j * np.outer(starts[:TURNED_TOGETHER] - starts[0], x))
    blocks = []
    for i in range(0, starts.size, TURNED_TOGETHER):
        turning = load * np.exp(1j * (starts[i] * x))
        blocks.append(np.real((turned[: starts.size - i] * turning) @ within))
    found[alike] = np.concatenate(blocks)
    return found.ravel()
