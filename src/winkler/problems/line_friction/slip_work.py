r"""The loss of a step, and the shift that slip allows.

Without a bulk stress both are sums over the memory.  With one the normal force is steady, so that what slips in a step
bears its final traction all the time,

.. math:: D = \int_{-a}^a q\,\Delta s\,\mathrm dx , \qquad U_s = \int_{-a}^a\frac{s}{\pi\sqrt{a^2-x^2}}\,\mathrm dx ,

the second by reciprocity with a flat punch: it is the shift of the bodies beyond that of a strip that sticks.
"""

from __future__ import annotations

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.numerics.types import Array
from winkler.problems.friction.slip_memory import SlipMemory
from winkler.problems.friction.slip_sums import SlipSums
from winkler.problems.line_friction.strips import EarlierStrip, slipped, traction

__all__ = ["shift_of_memory", "work_and_shift"]

ANGLES, STEPS = np.polynomial.legendre.leggauss(20)
PLACES, WEIGHTS = np.sin(0.5 * np.pi * ANGLES), 0.5 * np.pi * STEPS * np.cos(0.5 * np.pi * ANGLES)
"""Between the edges of two strips, from -1 to 1: roots at both ends are mapped away."""
ROUNDING = 1e-14
"""By which the factor of a strip that stays may differ after a step."""


def shift_of_memory(sums: SlipSums, memory: SlipMemory, modulus: float) -> float:
    """Return by how much the second body is shifted along x beyond a strip that sticks under this force [m].

    Parameters
    ----------
    sums : SlipSums
        Of the bed.
    memory : SlipMemory
    modulus : float
        E* [Pa].
    """
    return -sums.within(memory.outermost)[1] / modulus


def work_and_shift(
    bed: LineBed, before: tuple[EarlierStrip, ...], after: tuple[EarlierStrip, ...]
) -> tuple[float, float]:
    """Return the loss per length of a step under a steady normal force [J/m], and by how much the shift changes [m].

    Strips that stay lie inside of those that change, beside which alone there is slip: only the latter are summed.

    Parameters
    ----------
    bed : LineBed
    before, after : tuple of EarlierStrip
        At both ends of the step, each within the next; none before the first.
    """
    staying = 0
    for one, other in zip(before, after, strict=False):
        if one[1:] != other[1:] or abs(one.factor - other.factor) > ROUNDING:
            break
        staying += 1
    a = after[-1].half_width
    before, after = before[staying:], after[staying:]
    x, share = _over_contact((*before, *after), a)
    slip = slipped(bed, after, x) - slipped(bed, before, x)
    work = share @ (traction(bed, after, x) * slip)
    shift = share @ (slip / (np.pi * np.sqrt((a - x) * (a + x))))
    return max(float(work), 0.0), float(shift)


def _over_contact(strips: tuple[EarlierStrip, ...], a: float) -> tuple[Array, Array]:
    """Return places and weights [m] for integrals over the contact, piece by piece between the edges of all strips."""
    ends = [strip.middle + side * strip.half_width for strip in strips for side in (-1.0, 1.0)]
    edges = np.unique(np.clip([-a, *ends, a], -a, a))
    half, middle = 0.5 * np.diff(edges)[:, None], 0.5 * (edges[1:] + edges[:-1])[:, None]
    x, share = (middle + half * PLACES).ravel(), (half * WEIGHTS).ravel()
    inside = np.abs(x) < a
    return x[inside], share[inside]
