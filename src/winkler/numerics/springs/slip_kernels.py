r"""Kernels: springs that stick and slip while the bodies move to and fro, step by step.

A spring under the gap :math:`\gamma` is in contact while the depth d exceeds it.  Displaced by u it bears
:math:`|u|\le b`; in one direction, with Coulomb friction, :math:`b=\beta(d-\gamma)`.  Over a step in which depth and
shift U change in proportion to each other it does the following, and this is followed exactly, however long the step:

- in contact all the time, it moves by the whole change of U, and is held back by the bound at the end of the step: a
  spring that reaches the bound stays on it, since both move at constant rates;
- coming into contact, it moves by what is left of the step from then on;
- leaving, its bound closes upon it; it ends at rest, and what it stored is lost, but for what it gives back before.

A spring that is held back by s loses :math:`s\,(b_1-\tfrac12\beta\,\Delta d\,s/\sigma)` per stiffness,
:math:`\sigma=|\Delta U|-\beta\,\Delta d` being the rate at which motion and bound close upon each other.

Springs stand in rising order of gap.  Arrays of a block: depth and shift have one point more than there are steps; what
comes out (force, energy stored at the end of a step, energy lost in it) one number for each step.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array

SPRINGS_PER_CHUNK = 1024
"""Springs that go through all steps of a block together: few enough to stay in the fastest memory."""
ZERO_SUBSTITUTE = 1e-300
"""Instead of nothing, below a fraction bar."""
FORCE_TOLERANCE = 1e-14
"""Relative error of a prescribed force."""
MOST_STEPS = 200
"""Steps of the search for the motion that gives it."""


@compiled
def _slide(
    u: Array, gap: Array, stiffness: Array, slope: Array, alike: bool, depth: float, moved: float
) -> tuple[float, float, float]:
    """Move springs at a constant depth; return their force, twice what they store, and what they lose.

    Their bounds rise as that of the first one if `alike`: whoever calls it says so by a constant.
    """
    pull = held = loss = 0.0
    first = slope[0]
    for i in range(u.size):
        bound = (first if alike else slope[i]) * (depth - gap[i])
        trial = u[i] + moved
        v = trial if trial < bound else bound
        v = v if v > -bound else -bound
        u[i] = v
        part = stiffness[i] * v
        pull += part
        held += part * v
        loss += stiffness[i] * abs(trial - v) * bound
    return pull, held, loss


@compiled
def _press(
    u: Array, gap: Array, stiffness: Array, slope: Array, alike: bool, depth: float, sunk: float, moved: float
) -> tuple[float, float, float]:
    """Move springs that stay in contact while the depth has changed by `sunk`; alike ones without a division each."""
    pull = held = loss = 0.0
    first = slope[0]
    up = 1.0 / max(moved - first * sunk, ZERO_SUBSTITUTE)
    down = 1.0 / max(-moved - first * sunk, ZERO_SUBSTITUTE)
    for i in range(u.size):
        rise = first if alike else slope[i]
        bound = rise * (depth - gap[i])
        closing = rise * sunk
        trial = u[i] + moved
        v = trial if trial < bound else bound
        v = v if v > -bound else -bound
        u[i] = v
        part = stiffness[i] * v
        pull += part
        held += part * v
        s = abs(trial - v)
        if alike:
            share = s * (up if trial > 0.0 else down)
            share = share if share < 1.0 else 1.0
        else:
            rate = (moved if trial > 0.0 else -moved) - closing
            rate = rate if rate > s else s + ZERO_SUBSTITUTE
            share = s / rate
        loss += stiffness[i] * s * (bound - 0.5 * closing * share)
    return pull, held, loss


@compiled
def _press_in(
    u: Array, gap: Array, stiffness: Array, slope: Array, depth: float, sunk: float, moved: float
) -> tuple[float, float, float]:
    """Move springs that come into contact: each by what is left of the step from then on."""
    pull = held = loss = 0.0
    for i in range(u.size):
        bound = slope[i] * (depth - gap[i])
        trial = moved * ((depth - gap[i]) / sunk)
        v = trial if trial < bound else bound
        v = v if v > -bound else -bound
        u[i] = v
        part = stiffness[i] * v
        pull += part
        held += part * v
        loss += 0.5 * stiffness[i] * abs(trial - v) * bound
    return pull, held, loss


@compiled
def _unload(u: Array, gap: Array, stiffness: Array, slope: Array, depth: float, sunk: float, moved: float) -> float:
    """Move springs that lose contact, from a depth on, and set them at rest; return what they lose."""
    loss = 0.0
    for i in range(u.size):
        closing = slope[i] * (gap[i] - depth)
        step = moved * ((gap[i] - depth) / sunk)
        trial = u[i] + step
        u[i] = 0.0
        s = abs(trial)
        rate = (step if trial > 0.0 else -step) - closing
        rate = rate if rate > s else s + ZERO_SUBSTITUTE
        loss -= 0.5 * stiffness[i] * closing * s * (s / rate)
    return loss


@compiled
def march_line(
    u: Array,
    gap: Array,
    stiffness: Array,
    slope: Array,
    depth: Array,
    shift: Array,
    force: Array,
    stored: Array,
    lost: Array,
) -> None:
    """Move springs along a line; u (n,) is changed in place.

    `slope` (n,) is beta of every spring: how fast its bound rises with the depth.
    """
    steps = force.size
    for t in range(steps):
        force[t] = 0.0
        stored[t] = 0.0
        lost[t] = 0.0
    for start in range(0, gap.size, SPRINGS_PER_CHUNK):
        end = min(start + SPRINGS_PER_CHUNK, gap.size)
        v, g, k, b = u[start:end], gap[start:end], stiffness[start:end], slope[start:end]
        before = np.searchsorted(g, depth[0])
        unlike = 0
        for i in range(b.size):
            unlike += 1 if b[i] != b[0] else 0
        alike = unlike == 0
        for t in range(steps):
            sunk = depth[t + 1] - depth[t]
            moved = shift[t + 1] - shift[t]
            if sunk == 0.0:
                if alike:
                    pull, held, loss = _slide(v[:before], g[:before], k[:before], b, True, depth[t], moved)
                else:
                    pull, held, loss = _slide(v[:before], g[:before], k[:before], b, False, depth[t], moved)
            else:
                after = np.searchsorted(g, depth[t + 1])
                stay = min(before, after)
                if alike:
                    pull, held, loss = _press(v[:stay], g[:stay], k[:stay], b, True, depth[t + 1], sunk, moved)
                else:
                    pull, held, loss = _press(v[:stay], g[:stay], k[:stay], b, False, depth[t + 1], sunk, moved)
                if after > before:
                    new = slice(before, after)
                    more, further, waste = _press_in(v[new], g[new], k[new], b[new], depth[t + 1], sunk, moved)
                    pull += more
                    held += further
                    loss += waste
                elif after < before:
                    old = slice(after, before)
                    loss += _unload(v[old], g[old], k[old], b[old], depth[t], sunk, moved)
                before = after
            force[t] += pull
            stored[t] += 0.5 * held
            lost[t] += loss
