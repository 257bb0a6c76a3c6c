r"""Kernels: the surface temperature under a source of heat that moves, or was switched on, direction by direction.

In a body that moves along x past a steady flux, :math:`\hat T=\hat p/(\lambda\sqrt{k^2+\mathrm i k_xV/\kappa})`.  The
transform of an axisymmetric flux p(r) is that of its line load q(x), the projection T5, along every direction; so the
temperature is a mean over directions of line loads, as the one at rest is of one and the same (T3):

.. math:: T = \frac1{2\pi\lambda}\int_{-\pi/2}^{\pi/2} q_b(\rho\cos(\theta-\varphi))\,\mathrm d\theta, \qquad
          b = \frac V\kappa\cos\theta, \qquad
          q_b(s) = q(s) - \int_s^a q(t)\,\tfrac b2 D\bigl(\tfrac b2(t-s)\bigr)\,\mathrm dt .

:math:`\sqrt{k/(k+\mathrm ib)}`, the factor of a direction, is the transform of a one-sided kernel that does not
oscillate, :math:`D(z)=e^{-z}(I_0(z)-I_1(z))`.  Everything is counted in contact radii here.  Each piece between two
places where something is not smooth is mapped by a cosine, which makes square roots at its ends smooth.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array

LENGTH_RATIO = 4.0
"""Ratio of the lengths of consecutive pieces that leave a boundary layer."""
MOST_CUTS = 400
"""Places where one integral may be cut."""
Source = tuple[Array, Array, Array, Array, Array, Array, Array, Array]
"""Line load (joints, edges, rows), kernel (edges, rows, series of large arguments), rule (nodes, weights)."""


@compiled
def _spread(z: float, lags: bool, edges: Array, rows: Array, series: Array) -> float:
    """Return D(z) where the kernel lags, else Dawson's function over its argument."""
    if z < edges[-1]:
        return panel_value(z, edges, rows)
    inverse = 1.0 / z if lags else 1.0 / (z * z)
    total = 0.0
    for k in range(series.size - 1, -1, -1):
        total = total * inverse + series[k]
    return total * inverse * (math.sqrt(inverse) if lags else 1.0)


@compiled
def panel_value(x: float, edges: Array, rows: Array) -> float:
    """Return a piecewise polynomial at x; rows of 2 n coefficients of the panel's own variable from -1 to 1."""
    low, high = 0, edges.size - 1
    while high - low > 1:
        middle = (low + high) // 2
        if x < edges[middle]:
            high = middle
        else:
            low = middle
    t = (2.0 * x - edges[low] - edges[low + 1]) / (edges[low + 1] - edges[low])
    square = t * t
    even = 0.0
    odd = 0.0  # two chains, which the processor follows at the same time
    for k in range(rows.shape[1] - 2, -1, -2):
        even = even * square + rows[low, k]
        odd = odd * square + rows[low, k + 1]
    total: float = even + t * odd
    return total


@compiled
def line_load(x: float, joints: Array, edges: Array, rows: Array) -> float:
    """Return the line load at x, of either side; zero outside."""
    x = abs(x)
    if x > 1.0:
        return 0.0
    piece = 0
    while piece < joints.size - 2 and x >= joints[piece + 1]:
        piece += 1
    part = (x - joints[piece]) / (joints[piece + 1] - joints[piece])
    part = min(max(part, 0.0), 1.0)
    return panel_value(piece + math.acos(1.0 - 2.0 * part) / math.pi, edges, rows)


@compiled
def _summed(s: float, scale: float, lags: bool, source: Source, cuts: Array) -> float:
    """Return the integral of the line load times the kernel of the distance from s times a scale, between cuts."""
    joints, edges, rows, near, kernel, series, nodes, weights = source
    ordered = np.sort(cuts)
    total = 0.0
    for j in range(ordered.size - 1):
        width = ordered[j + 1] - ordered[j]
        if width <= 0.0:
            continue
        part = 0.0
        for k in range(nodes.size):
            t = ordered[j] + width * nodes[k]
            spread = _spread(scale * abs(t - s), lags, near, kernel, series)
            part += weights[k] * spread * line_load(t, joints, edges, rows)
        total += width * part
    return total


@compiled
def _lagged(s: float, b: float, source: Source, cuts: Array) -> float:
    """Return q_b(s)."""
    joints, edges, rows = source[0], source[1], source[2]
    if s >= 1.0:
        return 0.0
    start = max(s, -1.0)
    if b == 0.0:
        return line_load(s, joints, edges, rows)
    count = 2
    cuts[0] = start
    cuts[1] = 1.0
    for joint in joints[:-1]:
        for place in (joint, -joint):
            if start < place < 1.0:
                cuts[count] = place
                count += 1
    # the kernel starts at s with the length 2/b; the load may start just before s, at the edge or a joint
    step = 2.0 / b
    if s > -1.0:
        step = min(step, max(0.25 * (1.0 + s), 1e-3 * step))
    while s + step < 1.0 and count < cuts.size:
        if s + step > start:
            cuts[count] = s + step
            count += 1
        step *= LENGTH_RATIO
    return line_load(s, joints, edges, rows) - 0.5 * b * _summed(s, 0.5 * b, True, source, cuts[:count])


@compiled
def spread_loads(s: Array, lengths: Array, source: Source, result: Array) -> None:
    """Write q_t at places s, (n,), into `result`: at rest, on for a time, `lengths`, (n,), are sqrt(kappa t) over a."""
    joints, edges, rows = source[0], source[1], source[2]
    cuts = np.empty(MOST_CUTS)
    for i in range(s.size):
        length = lengths[i]
        count = 2
        cuts[0] = -1.0
        cuts[1] = 1.0
        for joint in joints[:-1]:
            cuts[count] = joint
            cuts[count + 1] = -joint
            count += 2
        step = 0.0
        while step < 1.0 + s[i] and count < cuts.size - 1:
            for place in (s[i] - step, s[i] + step):
                if -1.0 < place < 1.0:
                    cuts[count] = place
                    count += 1
            step = LENGTH_RATIO * step if step > 0.0 else 2.0 * length
        total = _summed(s[i], 0.5 / length, False, source, cuts[:count])
        result[i] = line_load(s[i], joints, edges, rows) - total / (length * math.pi**1.5)


@compiled
def _angle(turn: float, cuts: Array, count: int, low: float) -> int:
    """Add a direction to the cuts if it lies inside; return how many there are."""
    if turn > math.pi:
        turn -= 2.0 * math.pi
    if turn < -math.pi:
        turn += 2.0 * math.pi
    if low < turn < 0.5 * math.pi and count < cuts.size:
        cuts[count] = turn
        return count + 1
    return count


@compiled
def surface_points(x: Array, y: Array, wave: float, source: Source, result: Array) -> None:
    """Write lambda T over the scale of q into `result`, at x and y, (n,), in contact radii; `wave` is a V / kappa."""
    joints, nodes, weights = source[0], source[6], source[7]
    turns = np.empty(MOST_CUTS)
    cuts = np.empty(MOST_CUTS)
    for i in range(x.size):
        rho = math.hypot(x[i], y[i])
        phi = math.atan2(y[i], x[i])
        low = 0.0 if y[i] == 0.0 else -0.5 * math.pi
        turns[0] = low
        turns[1] = 0.5 * math.pi
        count = 2
        layer = 1.0 / max(wave * max(1.0, rho), 1e-9)
        while layer < 1.0 and wave > 0.0:
            count = _angle(0.5 * math.pi - layer, turns, count, low)
            count = _angle(layer - 0.5 * math.pi, turns, count, low)
            layer *= LENGTH_RATIO
        for joint in joints:
            if joint <= rho and rho > 0.0:
                first = math.acos(joint / rho)
                for turn in (first, -first, math.pi - first, first - math.pi):
                    count = _angle(phi + turn, turns, count, low)
            # nearly so: the line load's end lies just off the real directions
            if joint > 0.0 and rho > 0.0:
                off = math.sqrt(2.0 * abs(joint - rho) / rho)
                while 1e-6 < off < 1.0:
                    for turn in (off, -off, math.pi - off, off - math.pi):
                        count = _angle(phi + turn, turns, count, low)
                    off *= LENGTH_RATIO
        count = _angle(phi, turns, count, low)
        count = _angle(phi + math.pi, turns, count, low)
        ordered = np.sort(turns[:count])
        total = 0.0
        for j in range(count - 1):
            width = ordered[j + 1] - ordered[j]
            if width <= 0.0:
                continue
            part = 0.0
            for k in range(nodes.size):
                theta = ordered[j] + width * nodes[k]
                s = rho * math.cos(theta - phi)
                b = wave * math.cos(theta)
                part += weights[k] * _lagged(s, b, source, cuts)
            total += width * part
        result[i] = (2.0 if y[i] == 0.0 else 1.0) * total / (2.0 * math.pi)
