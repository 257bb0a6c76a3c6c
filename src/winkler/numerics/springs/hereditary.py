r"""A contact with memory, from its elastic response: forces of a motion, and motions of a force.

With :math:`\Phi(d)` the force of the bed at :math:`E^*=1`, a contact that does not shrink (Lee and Radok), and one that
shrinks after it has grown (Ting), bear

.. math:: F(t) = \int_0^{t_1} E^*(t-s)\,\mathrm d\Phi(d(s)) , \qquad \int_{t_1}^{t} E^*(t-s)\,\mathrm dd(s) = 0 ,

where :math:`t_1=t` while it grows.  Sums of exponentials carry both integrals along, so that n moments with m
terms cost n m; :math:`\Phi` and d change evenly between two moments.  A compliant machine, :math:`d=D-cF`, is solved
in every step.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.integrals.exponential_integrals import first, second
from winkler.numerics.jit import compiled
from winkler.numerics.types import Array

MOST_TERMS = 60
ROOT_TOLERANCE = 1e-13
STEP_TOLERANCE = 1e-10
"""Steps that differ by less share what is computed for one of them."""


@compiled
def _shape(depth: float, deepest: float, table: Array, slopes: Array) -> tuple[float, float]:
    """Return Phi and its slope, from cubics in the root of the depth over the deepest."""
    if depth <= 0.0:
        return 0.0, 0.0
    pieces = table.size - 1
    root = math.sqrt(depth / deepest)
    j = min(int(root * pieces), pieces - 1)
    u = root * pieces - j
    h = 1.0 / pieces
    a, b, m, n = table[j], table[j + 1], slopes[j] * h, slopes[j + 1] * h
    c2, c3 = 3.0 * (b - a) - 2.0 * m - n, m + n - 2.0 * (b - a)
    phi = a + u * (m + u * (c2 + u * c3))
    rise = (m + u * (2.0 * c2 + 3.0 * u * c3)) * pieces
    return phi, rise * 0.5 / (deepest * root)


@compiled
def _past(
    at: int,
    part: float,
    now: int,
    time: Array,
    depth: Array,
    phi: Array,
    times: Array,
    moduli: Array,
    relaxed: float,
    drift: Array,
    load: Array,
) -> tuple[float, float, float]:
    """Return what is left at moment `now` of all that happened until a part of the stretch after moment `at`.

    The force that it bears, what it adds to the second integral, and the depth then.
    """
    dt = time[at + 1] - time[at]
    rise, rise_phi = depth[at + 1] - depth[at], phi[at + 1] - phi[at]
    elapsed = time[now] - time[at] - part * dt
    d1, phi1 = depth[at] + part * rise, phi[at] + part * rise_phi
    force, moved = relaxed * phi1, relaxed * d1
    for i in range(times.size):
        fade = math.exp(-part * dt / times[i])
        fresh = part * first(part * dt / times[i])
        left = moduli[i] * math.exp(-elapsed / times[i])
        force += left * (load[at, i] * fade + rise_phi * fresh)
        moved += left * (drift[at, i] * fade + rise * fresh)
    return force, moved, d1


@compiled
def forces_of_motion(
    time: Array, place: Array, turn: int, compliance: float, relaxed: float, viscosity: float, moduli: Array,
    times: Array, deepest: float, table: Array, slopes: Array, force: Array, depth: Array, edge: Array, drift: Array,
    load: Array, phi: Array,
) -> None:  # fmt: skip
    """Find the forces and depths of a contact that is moved in, and after the moment `turn` out.

    Parameters
    ----------
    time, place : ndarray, (n,)
        [s] and D [m] from first touch.
    turn : int
        From this moment on it may shrink; n if it never does.
    compliance : float
        c [m/N].
    relaxed, viscosity, moduli, times
        E*(t).
    deepest, table, slopes
        Phi at roots of d / deepest evenly spaced from 0 to 1, and its slope over them.
    force, depth, edge : ndarray, (n,)
        F [N], d and the depth at which an elastic contact is as wide [m]; written.
    drift, load : ndarray, (n, m)
        The memories of the terms of d and of Phi; work space.
    phi : ndarray, (n,)
        Work space.
    """
    count, terms = time.size, times.size
    fade, fresh = np.empty(terms), np.empty(terms)
    top, at, part, shrinking, last = 0, 0, 0.0, False, -1.0
    for n in range(count):
        dt = time[n] - time[n - 1] if n > 0 else 0.0
        d0 = depth[n - 1] if n > 0 else min(place[0], 0.0)
        phi0 = phi[n - 1] if n > 0 else 0.0
        stiff, rest = relaxed, 0.0
        if not abs(dt - last) <= STEP_TOLERANCE * dt:
            last = dt
            for i in range(terms):
                fade[i] = math.exp(-dt / times[i])
                fresh[i] = first(dt / times[i])
        for i in range(terms):
            before = load[n - 1, i] if n > 0 else 0.0
            stiff += moduli[i] * fresh[i]
            rest += moduli[i] * (fade[i] * before - fresh[i] * phi0)
        damp = viscosity / dt if dt > 0.0 else 0.0
        if not shrinking:
            d, low, high = place[n], -1e300, place[n]
            f, p = 0.0, 0.0
            for _ in range(MOST_TERMS):
                p, s = _shape(d, deepest, table, slopes)
                f = stiff * p + rest + damp * s * (d - d0)
                steep = (stiff + damp) * s
                if f < 0.0:
                    f, steep = 0.0, 0.0
                excess = d - place[n] + compliance * f
                if compliance == 0.0 or abs(excess) <= ROOT_TOLERANCE * deepest:
                    break
                if excess > 0.0:
                    high = min(high, d)
                else:
                    low = max(low, d)
                d = d - excess / (1.0 + compliance * steep)
                if d >= high:
                    d = 0.5 * (low + high) if low > -1e300 else high - 1e-9 * deepest
                elif d <= low:
                    d = 0.5 * (low + high)
            if n < turn or d >= depth[top]:
                depth[n], edge[n], force[n], phi[n] = d, d, f, p
                for i in range(terms):
                    before, memory = (load[n - 1, i], drift[n - 1, i]) if n > 0 else (0.0, 0.0)
                    load[n, i] = fade[i] * before + fresh[i] * (p - phi0)
                    drift[n, i] = fade[i] * memory + fresh[i] * (d - d0)
                top = n
                continue
            shrinking, at, part = True, top - 1, 1.0
        # Ting: until which moment t1 does the past bear the load
        coefficient = relaxed + damp
        carried = -damp * d0
        for i in range(terms):
            coefficient += moduli[i] * fresh[i]
            carried += moduli[i] * (fade[i] * drift[n - 1, i] - fresh[i] * d0)
        bracketed = False
        f, d1 = 0.0, 0.0
        if top > 0:
            here = -1.0
            while at >= 0:
                f, moved, d1 = _past(at, 0.0, n, time, depth, phi, times, moduli, relaxed, drift, load)
                here = coefficient * (place[n] - compliance * f) + carried - moved
                if here >= 0.0 or (d1 <= 0.0 and phi[at] == 0.0):
                    break
                at -= 1
            if at >= 0 and here >= 0.0:
                next_ = -1.0
                while True:
                    f, moved, d1 = _past(at, 1.0, n, time, depth, phi, times, moduli, relaxed, drift, load)
                    next_ = coefficient * (place[n] - compliance * f) + carried - moved
                    if next_ < 0.0 or at + 1 >= top:
                        break
                    at, here = at + 1, next_
                low, high, g_low, g_high = 0.0, 1.0, here, next_
                part = 1.0
                if next_ < 0.0:
                    side = 0
                    for _ in range(MOST_TERMS):
                        part = (low * g_high - high * g_low) / (g_high - g_low)
                        f, moved, d1 = _past(at, part, n, time, depth, phi, times, moduli, relaxed, drift, load)
                        g = coefficient * (place[n] - compliance * f) + carried - moved
                        if abs(g) <= ROOT_TOLERANCE * coefficient * deepest or high - low < 1e-14:
                            break
                        if g < 0.0:
                            high, g_high = part, g
                            if side == -1:
                                g_low *= 0.5
                            side = -1
                        else:
                            low, g_low = part, g
                            if side == 1:
                                g_high *= 0.5
                            side = 1
                bracketed = True
        if not bracketed or f <= 0.0:
            f, d1 = 0.0, 0.0
        at = max(at, 0)
        d = place[n] - compliance * f
        force[n], depth[n], edge[n], phi[n] = f, d, d1, phi[top]
        for i in range(terms):
            drift[n, i] = fade[i] * drift[n - 1, i] + fresh[i] * (d - d0)
            load[n, i] = 0.0


@compiled
def motion_of_forces(
    time: Array, force: Array, glassy: float, fluidity: float, compliances: Array, times: Array, deepest: float,
    table: Array, slopes: Array, depth: Array,
) -> None:  # fmt: skip
    """Find the depths [m] of a contact under forces [N], while it does not shrink; beyond the table not a number.

    Parameters
    ----------
    time, force : ndarray, (n,)
        [s] and [N].
    glassy, fluidity, compliances, times
        The creep C(t).
    deepest, table, slopes
        As for `forces_of_motion`.
    depth : ndarray, (n,)
        Written.
    """
    terms = times.size
    crept, fade, old, new = np.zeros(terms), np.empty(terms), np.empty(terms), np.empty(terms)
    flowed, before, last = 0.0, 0.0, -1.0
    pieces = table.size - 1
    for n in range(time.size):
        dt = time[n] - time[n - 1] if n > 0 else 0.0
        flowed += 0.5 * dt * (force[n] + before)
        phi = glassy * force[n] + fluidity * flowed
        if not abs(dt - last) <= STEP_TOLERANCE * dt:
            last = dt
            for k in range(terms):
                x = dt / times[k]
                fade[k], old[k], new[k] = math.exp(-x), x * first(x), x * second(x)
        for k in range(terms):
            crept[k] = fade[k] * crept[k] + old[k] * before + new[k] * (force[n] - before)
            phi += compliances[k] * crept[k]
        before = force[n]
        if phi <= 0.0:
            depth[n] = 0.0
            continue
        if phi > table[pieces]:
            depth[n] = math.nan
            continue
        j = min(max(np.searchsorted(table, phi) - 1, 0), pieces - 1)
        low, high = j / pieces, (j + 1) / pieces
        root = low + (high - low) * (phi - table[j]) / (table[j + 1] - table[j])
        for _ in range(MOST_TERMS):
            p, s = _shape(root * root * deepest, deepest, table, slopes)
            if p > phi:
                high = root
            else:
                low = root
            steep = s * 2.0 * root * deepest
            step = (p - phi) / steep if steep > 0.0 else 0.0
            root -= step
            if not low <= root <= high:
                root = 0.5 * (low + high)
            if abs(step) <= 1e-14:
                break
        depth[n] = root * root * deepest
