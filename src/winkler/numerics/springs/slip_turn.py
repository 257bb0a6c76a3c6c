r"""One spring that is dragged in the plane under a bound: the onset of slip, and the rotation of its load in slip."""

from __future__ import annotations

import math

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.jit import compiled

NODES, WEIGHTS = (tuple(map(float, row)) for row in gauss_legendre(12))
MOST_DROPS = 64
"""How often a spring may drop from its static to its kinetic bound within one step."""


@compiled
def _turn(
    ux: float, uy: float, bound: float, last: float, mx: float, my: float, distance: float
) -> tuple[float, float, float]:
    """Let a spring slip on a circle that goes from radius `bound` to `last` while the bodies move by m."""
    mean = 0.5 * (bound + last)
    loss = mean * (distance + bound - last)
    if distance == 0.0 or bound == 0.0:
        share = last / bound if bound > 0.0 else 0.0
        return ux * share, uy * share, loss
    ex, ey = mx / distance, my / distance
    cosine = (ux * ex + uy * ey) / bound
    cosine = min(max(cosine, -1.0), 1.0)
    sine = (ex * uy - ey * ux) / bound
    # the logarithmic mean of the bound on the path
    change = last / bound - 1.0
    middle = bound * change / math.log1p(change) if change != 0.0 and last > 0.0 else last
    shrink = math.exp(-distance / middle) if middle > 0.0 else 0.0
    square = shrink * shrink
    half = (1.0 + cosine) + (1.0 - cosine) * square
    angle_turned = 0.0
    ahead = -1.0
    if half > 0.0:
        angle_turned = 2.0 * shrink * sine / half
        ahead = ((1.0 + cosine) - (1.0 - cosine) * square) / half
    if abs(bound - last) <= 1e-12 * bound:
        loss -= mean * middle * math.log(2.0 / half)
    elif distance < 4.0 * abs(bound - last):
        # what is not lost because the spring does not yet point ahead, by Gauss-Legendre quadrature over the path
        power = 2.0 * distance / (bound - last)
        for k in range(len(NODES)):
            radius = bound + NODES[k] * (last - bound)
            left = (1.0 - cosine) * math.exp(power * math.log(radius / bound))
            loss -= WEIGHTS[k] * distance * radius * 2.0 * left / ((1.0 + cosine) + left)
    elif cosine <= -1.0:
        loss -= 2.0 * mean * distance
    else:
        # the same of b^2 over ln(1 + tan^2(theta / 2)), where b changes little, as exp((b_1 - b_0) y / |dU|)
        slope = (1.0 - cosine) / (1.0 + cosine)
        end = math.log1p(slope * square)
        width = math.log1p(slope) - end
        power = (bound - last) / distance
        for k in range(len(NODES)):
            so_far = slope / math.expm1(end + NODES[k] * width) if width > 0.0 else 1.0
            loss -= WEIGHTS[k] * width * bound * bound * so_far**-power
    return last * (ahead * ex - angle_turned * ey), last * (ahead * ey + angle_turned * ex), loss


@compiled
def slip_onset(ux: float, uy: float, bound: float, last: float, mx: float, my: float) -> float:
    """Return the part of the path after which a spring that moves by m reaches a circle that goes to radius `last`."""
    scale = max(bound, last, abs(ux), abs(uy), abs(mx), abs(my))
    x, y, dx, dy = ux / scale, uy / scale, mx / scale, my / scale
    b, db = bound / scale, (last - bound) / scale
    square = dx * dx + dy * dy - db * db
    slope = x * dx + y * dy - b * db
    inside = x * x + y * y - b * b
    root = math.sqrt(max(slope * slope - square * inside, 0.0))
    part = -inside / (slope + root) if slope > 0.0 else (root - slope) / square
    return min(max(part, 0.0), 1.0)


@compiled
def travel(
    ux: float, uy: float, bound: float, last: float, mx: float, my: float, hold: float, slips: bool
) -> tuple[float, float, float, bool]:
    """Move a spring that is in contact; return where it is, what it lost, and whether it slips at the end."""
    loss = 0.0
    left = 1.0
    fall = last - bound
    for _ in range(MOST_DROPS):
        if slips and hold > 1.0 and ux * mx + uy * my < fall * bound:
            slips = False
        if not slips or hold == 1.0:
            tx, ty = ux + left * mx, uy + left * my
            rim = hold * last
            if tx * tx + ty * ty <= rim * rim:
                return tx, ty, loss, False
            part = slip_onset(ux, uy, hold * bound, rim, left * mx, left * my)
            ux, uy = ux + part * left * mx, uy + part * left * my
            left *= 1.0 - part
            size = math.sqrt(ux * ux + uy * uy)
            bound = size / hold
            if hold > 1.0:
                loss += 0.5 * (size * size - bound * bound)
                ux, uy = ux / hold, uy / hold
                if ux * mx + uy * my < fall * bound:
                    continue
        distance = left * math.sqrt(mx * mx + my * my)
        tx, ty, waste = _turn(ux, uy, bound, last, left * mx, left * my, distance)
        return tx, ty, loss + waste, True
    # a static bound that closes upon a spring lets it drop again and again: what is left of it is let go
    size = math.sqrt(ux * ux + uy * uy)
    share = min(last / size, 1.0) if size > 0.0 else 0.0
    return share * ux, share * uy, loss + 0.5 * (1.0 - share * share) * size * size, True
