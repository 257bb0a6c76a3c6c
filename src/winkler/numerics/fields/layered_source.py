r"""Kernels: the temperature that an echo of layers adds under a round source, direction by direction.

As in `winkler.numerics.fields.moving_source` the temperature is a mean over directions of line loads; here each line
load is folded with the echo along its direction, which is smooth over the thickness of the top layer.
"""

from __future__ import annotations

import math

from winkler.numerics.fields.moving_source import line_load, panel_value
from winkler.numerics.jit import compiled
from winkler.numerics.types import Array


@compiled
def _folded(
    s: float,
    width: float,
    load: tuple[Array, Array, Array],
    marks: Array,
    rows: Array,
    rule: tuple[Array, Array],
) -> float:
    """Return the integral of q(s - z) times the echo over z, in widths; `rows` (2, panels, n) as powers."""
    joints, edges, table = load
    nodes, weights = rule
    total = 0.0
    for side in range(2):
        sign = 1.0 if side == 0 else -1.0
        # z = sign d, and -1 < s - z < 1
        nearest, farthest = max(sign * s - 1.0, 0.0), sign * s + 1.0
        for p in range(marks.size - 1):
            low, high = max(marks[p] / width, nearest), min(marks[p + 1] / width, farthest)
            while low < high:
                end = high
                for joint in joints[:-1]:
                    for place in (sign * (s - joint), sign * (s + joint)):
                        if low < place < end:
                            end = place
                part = 0.0
                for n in range(nodes.size):
                    d = low + (end - low) * nodes[n]
                    echo = panel_value(width * d, marks[p : p + 2], rows[side, p : p + 1])
                    part += weights[n] * echo * line_load(s - sign * d, joints, edges, table)
                total += (end - low) * part
                low = end
    return total


@compiled
def echoed_points(
    x: Array,
    y: Array,
    directions: Array,
    shares: Array,
    widths: Array,
    load: tuple[Array, Array, Array],
    marks: Array,
    rows: Array,
    rule: tuple[Array, Array],
    result: Array,
) -> None:
    """Write what the echo adds to lambda T, over the scale of q, into `result`, at x and y, (n,), in radii of the ball.

    `directions` and `shares` are nodes and weights of a rule from 0 to a quarter turn, `rows` the echo on each, and
    `widths`, (2, m), those of the line loads at either side of the motion.
    """
    for i in range(x.size):
        total = 0.0
        for j in range(directions.size):
            along, across = math.cos(directions[j]) * x[i], math.sin(directions[j]) * y[i]
            left, right = widths[0, j], widths[1, j]
            part = _folded((along + across) / left, left, load, marks, rows[j], rule)
            if across == 0.0 and left == right:
                part += part
            else:
                part += _folded((along - across) / right, right, load, marks, rows[j], rule)
            total += shares[j] * part
        result[i] = total / (2.0 * math.pi)
