r"""Dissimilar cylinders that roll steadily: pressure drags the surfaces, and traction changes the pressure.

With Dundurs' constant beta both act on each other within the strip, where the slope of the gap and the slip over the
speed of rolling are (Bentall and Johnson)

.. math:: \frac xR = \frac2{\pi E^*}\int\frac{p(s)}{x-s}\,\mathrm ds - \frac{2\beta}{E^*}q , \qquad
          s(x) = \xi - \frac2{\pi E^*}\int\frac{q(s)}{x-s}\,\mathrm ds - \frac{2\beta}{E^*}p .

On boundary elements pressure and traction are found in turn until both stay.  Without friction to speak of all slips,
and the free cylinder creeps by :math:`0.9140\,\beta a/R`.

References
----------
R. H. Bentall, K. L. Johnson, Int. J. Mech. Sci. 9 (1967) 389-404, doi:10.1016/0020-7403(67)90043-4
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged
from winkler.numerics.surfaces.strip_grid import StripStep, strip_compliance, strip_step
from winkler.numerics.types import Array

__all__ = ["CoupledStrip", "coupled_strip"]

COUNT = 200
"""Elements on half of the contact of similar bodies."""
BESIDE = 1.4
"""Half of the grid over the half-width."""
SETTLED, ACCEPTED, MOST_ROUNDS, MOST_TRIES = 1e-9, 1e-6, 60, 200
"""Change of pressure and traction over their greatest values at which the search ends, and with which it may."""
ROUNDING = 1e-12


class CoupledStrip(NamedTuple):
    """The strip of dissimilar cylinders under one drive; lengths over a of similar bodies, stresses over E*.

    Parameters
    ----------
    x, pressure, traction
        At the nodes that touch ``(m,)``, ascending: the leading edge is last.
    slip
        Over the speed of rolling, of the second surface over the first ``(m,)``, halfway ahead of each node.
    slips
        -1, 0 or 1 where it slips backwards, sticks, slips forwards ``(m,)``.
    creepage, force
        xi [-], Q over E* a.
    """

    x: Array
    pressure: Array
    traction: Array
    slip: Array
    slips: Array
    creepage: float
    force: float

    @property
    def stick_share(self) -> float:
        """Part of the width that sticks [-]."""
        return float(np.mean(self.slips == 0.0))

    @property
    def loss(self) -> float:
        """What friction loses per distance rolled, over E* a.

        Halfway between two nodes the traction is their mean; behind the last one it falls to zero.
        """
        halfway = 0.5 * (self.traction + np.append(self.traction[1:], 0.0))
        behind = 0.5 * self.traction[0] * self.slip[0]
        return float(np.sum(np.abs(halfway * self.slip)) + abs(behind)) / COUNT


def coupled_strip(
    beta: float, friction: float, slope: float, *, force: float | None = None, creepage: float = 0.0
) -> CoupledStrip:
    """Return the strip under a force, or with a creepage.

    Parameters
    ----------
    beta : float
        Dundurs' second constant [-], positive where the first surface is drawn in.
    friction : float
        mu [-].
    slope : float
        a/R [-].
    force : float, optional
        Q over E* a.
    creepage : float, optional
        xi [-], where no force is given.

    Raises
    ------
    NotConverged
        If pressure and traction are not found.
    """
    h = 1.0 / COUNT
    x = h * np.arange(-round(BESIDE * COUNT), round(BESIDE * COUNT) + 1)
    near = h * strip_compliance(x.size, 1.0, 1.0)
    away = np.arange(x.size)
    compliance, earlier = near[np.abs(away[:, None] - away)], near[np.abs(away[:, None] + 1 - away)]
    load = 0.25 * np.pi * slope
    pressure, traction, slips = 0.5 * slope * np.sqrt(np.maximum(1.0 - x * x, 0.0)), np.zeros(x.size), np.zeros(x.size)
    change = np.inf
    for _ in range(MOST_ROUNDS):
        borne = np.append(0.0, np.cumsum(0.5 * (traction[1:] + traction[:-1]))) * h
        found = _pressed(compliance, 0.5 * slope * x * x + 2.0 * beta * borne, load / h, pressure > 0.0)
        rows = np.flatnonzero(found)
        rows = np.arange(rows[0], rows[-1] + 1)
        drawn = -beta * h * (found + np.append(found[1:], 0.0))[rows]
        step = _rubbed((compliance - earlier)[np.ix_(rows, rows)], drawn, friction * found[rows], slips[rows],
                       force, creepage)  # fmt: skip
        before, traction, slips = traction, np.zeros(x.size), np.zeros(x.size)
        traction[rows], slips[rows] = step.traction, step.slips
        change = max(
            float(np.max(np.abs(traction - before))) / friction, float(np.max(np.abs(found - pressure)))
        ) / float(np.max(found))
        pressure = found
        if change < SETTLED:
            break
    if change > ACCEPTED or rows[0] == 0 or rows[-1] == x.size - 1:
        raise NotConverged(
            f"LineRolling: pressure and traction of dissimilar cylinders (Dundurs' beta {beta:.3g}, friction "
            f"{friction:.3g}) were not found; give less friction, or leave the coupling out."
        )
    slip = (step.shift + drawn - (compliance - earlier)[np.ix_(rows, rows)] @ step.traction) / h
    slip[step.slips == 0.0] = 0.0
    return CoupledStrip(
        x[rows], found[rows], step.traction, slip, step.slips, step.shift / h, h * float(np.sum(step.traction))
    )


def _pressed(compliance: Array, gap: Array, total: float, touching: Array) -> Array:
    """Return the pressure of a sum at nodes with this gap before they are pressed; nothing pulls, nothing overlaps."""
    for _ in range(MOST_TRIES):
        rows = np.flatnonzero(touching)
        edge = np.ones((rows.size, 1))
        system = np.block([[compliance[np.ix_(rows, rows)], -edge], [edge.T, np.zeros((1, 1))]])
        found = np.linalg.solve(system, np.append(-gap[rows], total))
        pressure = np.zeros(gap.size)
        pressure[rows] = found[:-1]
        apart = compliance @ pressure + gap - found[-1]
        pulls = touching & (pressure < 0.0)
        overlaps = ~touching & (apart < -ROUNDING * np.max(np.abs(gap)))
        if not (pulls.any() or overlaps.any()):
            return pressure
        touching = (touching & ~pulls) | overlaps
    raise NotConverged("LineRolling: the strip of dissimilar cylinders was not found; give less friction.")


def _rubbed(
    passing: Array, drawn: Array, bound: Array, slips: Array, force: float | None, creepage: float
) -> StripStep:
    """Return traction, slip and creepage times the spacing under a steady pressure."""
    if force is None:
        return strip_step(passing, drawn, bound, slips, shift=creepage / COUNT, rounding=ROUNDING)
    total = force * COUNT
    if abs(total) < float(np.sum(bound)) * (1.0 - ROUNDING):
        return strip_step(passing, drawn, bound, slips, total=total, rounding=ROUNDING)
    side = np.copysign(1.0, force)
    free = drawn - passing @ (side * bound)
    return StripStep(side * bound, np.full(bound.size, side), float(side * np.max(-side * free)))
