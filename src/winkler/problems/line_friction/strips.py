r"""The strips that add up to the traction of a sheared line contact.

What springs numbered by their load remember is a chain of straight pieces (`winkler.problems.friction.slip_memory`), so
that the traction is a sum of pressures of earlier, narrower contacts (Ciavarella, Jaeger), and what has slipped the sum
of the distances that those would leave open beside them:

.. math:: q(x) = \sum_j B_j\,p(x;\gamma_j) , \qquad s(x) = -\frac{E^*}{m_L}\sum_j B_j\,h(x;\gamma_j) .

A bulk stress in phase tilts the profile of each of them, which shifts that of a cylinder as a whole.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.numerics.types import Array
from winkler.problems.friction.slip_memory import SlipMemory
from winkler.problems.line.half_width import under_force
from winkler.problems.line.peak_pressure import rim_load

ROUNDING = 1e-13
"""Part of the factors that their sum may miss zero by."""


class EarlierStrip(NamedTuple):
    """An earlier contact, and how much of its pressure acts along the surface.

    Parameters
    ----------
    factor
        B [-].
    load
        gamma, its load per length over E* [m].
    half_width, rim_load
        As of `LineBed.pressure` [m].
    middle
        Where its middle is [m].
    """

    factor: float
    load: float
    half_width: float
    rim_load: float
    middle: float


def strips_of(bed: LineBed, memory: SlipMemory, lean: float) -> tuple[EarlierStrip, ...]:
    """Return the strips, from the narrowest, which may be a line of first touch, to the contact itself.

    Parameters
    ----------
    bed : LineBed
    memory : SlipMemory
        Over loads per length over E* [m].
    lean : float
        Shift of the middle of a strip over the load that it lacks [-], by a bulk stress.
    """
    if not memory.size:
        return ()
    loads, factors = memory.corners
    rest = -float(np.sum(factors))
    if abs(rest) > ROUNDING * float(np.max(np.abs(factors))):  # bodies that met while they were sheared, or slide
        loads, factors = np.append(0.0, loads), np.append(rest, factors)
    widths = under_force(bed, loads)
    modulus = bed.medium.modulus
    return tuple(
        EarlierStrip(factor, load, width, rim_load(bed, modulus * load, width), lean * (memory.depth - load))
        for factor, load, width in zip(factors.tolist(), loads.tolist(), widths.tolist(), strict=True)
    )


def traction(bed: LineBed, strips: tuple[EarlierStrip, ...], x: Array) -> Array:
    """Return q [Pa] at places [m], along x on the first body."""
    total = np.zeros(x.shape)
    for strip in strips:
        if strip.factor != 0.0 and strip.half_width > 0.0:
            total += strip.factor * bed.pressure(x - strip.middle, strip.half_width, strip.rim_load)
    return total


def slipped(bed: LineBed, strips: tuple[EarlierStrip, ...], x: Array) -> Array:
    """Return how far the second body is ahead of the first [m] at places inside the contact, against its middle."""
    total = np.zeros(x.shape)
    for strip in strips[:-1]:  # beside the last one is no contact
        beside = np.abs(x - strip.middle) > strip.half_width
        if strip.factor != 0.0 and beside.any():
            total[beside] -= strip.factor * opened(bed, strip, x[beside] - strip.middle)
    return bed.along_share * total


def opened(bed: LineBed, strip: EarlierStrip, x: Array) -> Array:
    """Return the distance of the surfaces beside a strip at places of its body [m]; zero if a rim pins it."""
    if strip.half_width >= bed.rim:
        return np.zeros(x.shape)
    return bed.separation(np.abs(x), strip.half_width, 0.0)
