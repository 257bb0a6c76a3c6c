r"""Modes of strips at one pitch, and sums over the waves of the pitch.

Of a strip whose edges lie at the phases :math:`\pm\theta = \pm\pi x/\lambda` a mode over u (`winkler.foundation.
periodic`) has at the wave :math:`k = 2\pi m/\lambda` the transform

.. math:: B_n(m) = \frac2\pi\int_0^{\pi/2}\cos(2n\phi)\,\cos\big(2m\arcsin(\sin\theta\cos\phi)\big)\,\mathrm d\phi ,

zero for n > m: sin^2 of the places is a polynomial of u.  Sums over all m stand for the integrals of a single strip.

Where M falls like 1/xi they go on far beyond the modes.  A product of two transforms has a slow part and one that turns
with :math:`4m\theta`: once the waves are many, every second one tells both as well as all do, then every fourth, and
where the phase is large the slow part alone is integrated.  The passages are as smooth as erfc.  With the stationary
phases :math:`\sin\phi_0 = n\cos\theta/(\sin\theta\sqrt{m^2-n^2})`

.. math:: B_n \approx \sqrt{\frac{\cos\theta}{\pi m\sin\theta\cos\phi_0}}\Big(1-\frac{n^2}{m^2}\Big)^{-3/4}
          \cos\big(2m\arcsin(\sin\theta\cos\phi_0) + 2n\phi_0 - \tfrac\pi4\big) .
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, NODES, WaveResponse, wave_numbers
from winkler.numerics.transforms.strips.strip_equation import LEAST_PHASE, PHASE_PER_MODE, Waves, excess_at, kept_share
from winkler.numerics.types import Array

STEADY, MOST_STEADY = 48.0, 1500.0
"""Waves times the phase of half of the gap between strips, and at most: the shorter ones feel no narrower gap."""
PASSAGE = 128
"""Waves of a stride up to which it is left for the next."""
MARGIN, AIRY = 32, 8.0
"""Orders beyond those of a wave at which nothing is left, and the same over the third root of these."""
POINTS_PER_BLOCK = 2_000_000


def harmonic_rows(phase: float, count: int, numbers: Array) -> Array:
    """Return B_n(m) of so many modes for whole numbers m, ascending ``(m,)``, at edges of a phase ``(n, m)``."""
    found, first, sine = np.empty((count, numbers.size)), 0, math.sin(phase)
    while first < numbers.size:
        last = int(np.searchsorted(numbers, max(2.0 * numbers[first], MARGIN), side="right"))
        most = _points(sine, count, float(numbers[last - 1]))
        last = min(last, first + max(1, POINTS_PER_BLOCK // most))
        angle = 0.5 * math.pi * (np.arange(most) + 0.5) / most
        turned = 2.0 * np.arcsin(sine * np.cos(angle))
        orders = np.cos(2.0 * np.outer(np.arange(count), angle)) / most
        found[:, first:last] = orders @ np.cos(np.outer(turned, numbers[first:last]))
        first = last
    return np.where(np.arange(count)[:, None] > numbers, 0.0, found)


def _points(sine: float, count: int, number: float) -> int:
    """Return how many angles tell the orders of a mode and a wave from all others."""
    wide = sine * number
    orders = min(number + 1.0, wide + AIRY * math.cbrt(wide) + MARGIN)
    return math.ceil(0.5 * (count + orders)) + 1


def harmonics(response: WaveResponse, pitch: float, phase: float, across: float, count: int) -> Waves:
    """Return waves of a pitch where M falls like 1 / xi, and their shares of the sum of M / m.

    Parameters
    ----------
    response : WaveResponse
    pitch : float
        lambda [m].
    phase, across : float
        theta of the edges, and the greatest phase of a place that feels the waves, up to pi/2.
    count : int
        Modes that are told apart.

    Returns
    -------
    Waves
        k [1/m] of the waves that are summed, and of those of which the slow part is integrated.
    """
    unit, most = 2.0 * math.pi / pitch, 0.5 * DECAY_SPAN * pitch / (math.pi * response.length)
    end = max(LEAST_PHASE, PHASE_PER_MODE * count) / (2.0 * phase)
    end = max(end, min(STEADY / max(0.5 * math.pi - across, 1e-300), MOST_STEADY))
    numbers, shares, stride, begun = [], [], 1, 0.0
    while begun < end:
        top = end if 8.0 * stride * across > math.pi else min(end, float(PASSAGE * stride))
        found = stride * np.arange(max(1, math.ceil(0.5 * begun / stride)), math.floor(top / stride) + 1.0)
        share = stride * kept_share(found / top)
        numbers.append(found)
        shares.append(share * (1.0 - kept_share(found / begun)) if begun else share)
        stride, begun = 2 * stride, top
    number = np.concatenate(numbers)
    shorter, rest = (part[NODES:] for part in wave_numbers(0.5 * end, math.inf, max(most, end)))
    rest = rest * (1.0 - kept_share(shorter / end)) * excess_at(response, unit * shorter) / shorter
    return Waves(
        unit * number, np.concatenate(shares) * excess_at(response, unit * number) / number, unit * shorter, rest
    )


def resolves(gap: float) -> bool:
    """Return whether the waves that are summed tell what happens in a gap, of which the half has a phase."""
    return gap * MOST_STEADY > STEADY


def far_harmonics(phase: float, count: int, numbers: Array) -> tuple[Array, Array]:
    """Return the sides of B_n far out, as of `strip_modes.far_sides`, and those of what closes at the edge.

    Parameters
    ----------
    phase : float
        theta of the edges.
    count : int
    numbers : ndarray, (m,)
        Above the orders over sin theta.

    Returns
    -------
    modes : ndarray, (2, n, m)
        c and s [-].
    closing : ndarray, (2, m)
        Of a pressure that closes with the slope w' = 1 over u, over the pitch [-].
    """
    sine, cosine = math.sin(phase), math.cos(phase)
    order = np.arange(count)[:, None]
    ratio = order / numbers
    square = (1.0 - ratio) * (1.0 + ratio)
    turned = np.arcsin(ratio * cosine / (sine * np.sqrt(square)))
    level = np.sqrt(cosine / (2.0 * math.pi * sine * numbers * np.cos(turned))) * square**-0.75
    lag = 2.0 * numbers * (np.arcsin(sine * np.cos(turned)) - phase) + 2.0 * order * turned
    sides = np.stack([level * np.cos(lag), level * np.sin(lag)])
    return sides, np.stack([np.zeros(numbers.size), -cosine / (2.0 * math.pi * numbers) * sides[0, 0]])
