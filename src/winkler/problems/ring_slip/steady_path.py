r"""A whole history under a steady normal load at once: of a contact that is twisted, or pushed on a coating.

The bound b of the springs falls from the axis to the edge.  Fresh springs that have moved by s slide outside of the
radius c at which :math:`b(c)=s`, and bear, and lose

.. math:: F = 2\Big[s\int_0^c e^2\,\mathrm dx + \int_c^a e^2 b\,\mathrm dx\Big] , \qquad
          L = \int_c^a e^2\,b\,(s-b)\,\mathrm dx ;

all other states follow from the turning points of the motion (`winkler.problems.ring_slip.play`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from winkler.foundation.torsion_bound import PressedState, TwistBound
from winkler.numerics.panels.kink_panels import LOCAL_NODES, TO_COEFFICIENTS, WEIGHTS
from winkler.numerics.types import Array
from winkler.problems.ring_slip.play import Branches, followed
from winkler.problems.ring_slip.torsion_pieces import TurnedTwist, TurnHistory, TwistMemory

CHUNK = 2048
"""So many places are read at a time."""
BOUND_ROUNDING = 1e-13
"""Part of the greatest bound that is rounding."""
HALVINGS = 60
"""Of the interval in which a place is sought."""
MOST_TRIALS = 60
"""Of the amplitude that a load needs."""
LOAD_ROUNDING = 1e-15
"""Part of the greatest load by which a load is missed."""


class HistoryPoint(NamedTuple):
    """A point of a history: motion [Pa] as in `TwistMemory`, load, radius of the part that sticks [m], and energies.

    `work` and `lost` are the sums of those of `TorsionStep`, `stored` is
    `winkler.problems.ring_slip.torsion_march.square`, `nested` that of `TorsionStep`.
    """

    motion: float
    load: float
    stick_radius: float
    work: float
    stored: float
    lost: float
    nested: bool
    memory: TwistMemory | TurnedTwist


class Moved(NamedTuple):
    """Fresh springs, for many amplitudes: c [m], F, the integral of F over s, and L."""

    front: Array
    load: Array
    work: Array
    lost: Array


def falls(bound: TwistBound, press: PressedState) -> bool:
    """Return whether springs bear the less the farther out they are, so that those which slide are an outer ring."""
    limit = bound.at(press).ravel()
    top = float(np.max(limit))
    return (
        press.radius == bound.widest
        and top > 0.0
        and bool(np.all(np.diff(limit) < (BOUND_ROUNDING + bound.miss) * top))
    )


class FreshSprings:
    """The rings of a twist, or of a push on layers, that came into contact at rest; amplitudes in Pa.

    Parameters
    ----------
    bound : TwistBound
    press : PressedState
        Of which `falls` is true.
    """

    def __init__(self, bound: TwistBound, press: PressedState) -> None:
        self._bound, panels, limit = bound, bound.panels, bound.at(press)
        self._fits: Array = (limit @ TO_COEFFICIENTS.T).T
        """Coefficients of Legendre's polynomials in every panel."""
        self._weights: Array = (bound.weight @ TO_COEFFICIENTS.T).T
        whole = np.array([np.sum(panels.weights * bound.weight * limit**power, axis=1) for power in range(3)])
        beyond = np.cumsum(whole[:, ::-1], axis=1)[:, ::-1]
        self._beyond: Array = np.append(beyond[:, 1:], np.zeros((3, 1)), axis=1)
        """The integrals of e^2 b^n from the upper end of each panel to the edge."""
        self.rim, self.whole = press.radius, beyond[:, 0]
        """a [m], and the integrals of e^2 b^n over all springs."""
        self._nodes: Array = np.maximum.accumulate(limit.ravel()[::-1])
        """Rising amplitudes between which that of a load is sought; the last one lets all slide that can."""
        self.inertia = 2.0 * float(self.whole[0])
        """As `TwistBound.inertia` of the whole contact."""

    def tails(self, front: Array) -> Array:
        """Return the integrals of e^2 b^n from these radii to the edge, n = 0, 1, 2: ``(3, m)``."""
        parts = [self._tails(part)[0] for part in _chunks(front)]
        return np.concatenate(parts, axis=1) if parts else np.zeros((3, 0))

    def curve(self, amplitude: Array) -> Moved:
        """Return what they bear that have moved by these amplitudes."""
        parts = [self._curve(part) for part in _chunks(amplitude)]
        columns = zip(*parts, strict=True) if parts else [()] * 4
        return Moved(*(np.concatenate([*column, np.zeros(0)]) for column in columns))

    def amplitude(self, load: Array) -> Array:
        """Return the amplitudes under which they bear these loads, less than what friction bears."""
        known = self.curve(self._nodes)
        least = load / (2.0 * self.whole[0])
        found = np.maximum(np.interp(load, np.append(0.0, known.load), np.append(0.0, self._nodes)), least)
        top = self._nodes[-1]
        found = np.where(load >= known.load[-1], top, np.minimum(found, top))
        active = np.flatnonzero(load < known.load[-1])
        for _ in range(MOST_TRIALS):  # the load is a concave function of the amplitude: Newton's steps settle
            if active.size == 0:
                break
            now = self.curve(found[active])
            miss = load[active] - now.load
            stiffness = 2.0 * (self.whole[0] - self.tails(now.front)[0])
            ahead = found[active] + miss / np.where(stiffness > 0.0, stiffness, np.inf)
            ahead = np.clip(ahead, least[active], max(top, float(np.max(least[active]))))
            late = (np.abs(miss) > LOAD_ROUNDING * 2.0 * self.whole[1]) & (ahead != found[active])
            found[active] = ahead
            active = active[late]
        return np.asarray(found)

    def _curve(self, amplitude: Array) -> Moved:
        front = self._front(amplitude)
        tails, weights, limit = self._tails(front)
        k = self._bound.panels.panel(front)
        lost = np.sum(weights * limit * np.maximum(amplitude[:, None] - limit, 0.0), axis=1)
        lost = lost + np.maximum(amplitude * self._beyond[1, k] - self._beyond[2, k], 0.0)
        stuck, lost = self.whole[0] - tails[0], np.where(amplitude > 0.0, np.maximum(lost, 0.0), 0.0)
        load = np.where(amplitude > 0.0, 2.0 * (amplitude * stuck + tails[1]), 0.0)
        return Moved(front, load, amplitude**2 * stuck + tails[2] + 2.0 * lost, lost)

    def _front(self, amplitude: Array) -> Array:
        panels = self._bound.panels
        at_low = np.minimum.accumulate(self._fits.T @ (-1.0) ** np.arange(self._fits.shape[0]))
        k = at_low.size - 1 - np.searchsorted(at_low[::-1], amplitude, side="left")
        some, k = k >= 0, np.maximum(k, 0)
        low, high = np.full(amplitude.shape, -1.0), np.ones(amplitude.shape)
        fits = self._fits[:, k]
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            sticks = np.polynomial.legendre.legval(middle, fits, tensor=False) >= amplitude
            low, high = np.where(sticks, middle, low), np.where(sticks, high, middle)
        sticks = np.polynomial.legendre.legval(np.ones(amplitude.shape), fits, tensor=False) >= amplitude
        y = panels.low[k] + panels.half[k] * (1.0 + np.where(sticks, 1.0, low))
        return np.where(some, np.hypot(panels.base[k], y), 0.0)

    def _tails(self, front: Array) -> tuple[Array, Array, Array]:
        """Return `tails`, and between each radius and the upper end of its panel: weights e^2 dx, and bounds."""
        panels = self._bound.panels
        k = panels.panel(front)
        base = panels.base[k]
        start = np.sqrt(np.maximum((front - base) * (front + base), 0.0))
        width = np.maximum(panels.high[k] - start, 0.0)[:, None]
        y = start[:, None] + 0.5 * width * (1.0 + LOCAL_NODES)
        local = (y - panels.low[k][:, None]) / panels.half[k][:, None] - 1.0
        limit, weight = (
            np.polynomial.legendre.legval(local, fits[:, k, None], tensor=False) for fits in (self._fits, self._weights)
        )
        weights = width * WEIGHTS * y / np.hypot(base[:, None], y) * weight
        own = np.array([np.sum(weights * limit**power, axis=1) for power in range(3)])
        return own + self._beyond[:, k], weights, limit


def steady_points(bound: TwistBound, press: PressedState, values: Sequence[float], by_load: bool) -> list[HistoryPoint]:
    """Return a whole history of springs that came into contact at rest, under a steady load.

    Parameters
    ----------
    bound : TwistBound
    press : PressedState
        Of which `falls` is true.
    values : sequence of float
        The motion [Pa] as in `TwistMemory`, or the load, less than what friction bears.
    by_load : bool
        Which of both is prescribed.
    """
    springs = FreshSprings(bound, press)
    history = steady_history(springs, values, by_load)
    columns = (each.tolist() for each in history[:-1])
    return [
        HistoryPoint(motion, load, front, work, stored, lost, True, TurnedTwist(press, history, point))
        for point, (motion, load, front, work, stored, lost) in enumerate(zip(*columns, strict=True))
    ]


def steady_history(springs: FreshSprings, values: Sequence[float], by_load: bool) -> TurnHistory:
    """Return a whole history of springs that came into contact at rest; its time and its memory are those of its turns.

    Parameters
    ----------
    springs : FreshSprings
    values : sequence of float
        The motion, or the load, less than what friction bears.
    by_load : bool
        Which of both is prescribed.
    """
    branches = followed(values)
    stretches, count = branches.stretches, len(values)
    ends = np.array([[stretch.start, stretch.end] for stretch in stretches]).reshape(-1, 2)
    if by_load:
        amplitudes, which = np.unique(ends, return_inverse=True)
        ends = springs.amplitude(amplitudes)[which.reshape(ends.shape)]
    curves, start = springs.curve(ends[:, 1]), springs.curve(ends[:, 0])
    gains = (ends[:, 1] - ends[:, 0], curves.work - start.work, curves.lost - start.lost)
    rows = zip(stretches, *(each.tolist() for each in (ends[:, 1], curves.load, curves.front, *gains)), strict=True)
    motion, load, front, work, lost = np.zeros((5, count)).tolist()
    here, done = (0.0, 0.0, springs.rim), 0
    for (point, turn, fold, sign, _, _), end, bears, reaches, moved, work_gain, loss_gain in rows:
        for each in range(done, point):
            motion[each], load[each], front[each] = here
        done = point
        at, borne = (motion[turn], load[turn]) if fold == 2 else (0.0, 0.0)
        here = at + sign * fold * end, borne + sign * fold * bears, reaches
        work[point] += 0.5 * (sign * fold * moved * borne + fold**2 * work_gain)
        lost[point] += fold * loss_gain
    for each in range(done, count):
        motion[each], load[each], front[each] = here
    moved, fronts = np.array(motion), np.array(front)
    stored = _stored(springs, branches, moved, fronts)
    return TurnHistory(moved, np.array(load), fronts, np.cumsum(work), stored, np.cumsum(lost), branches)


def _stored(springs: FreshSprings, branches: Branches, motion: Array, front: Array) -> Array:
    r"""Return the integral of the square of the springs' load at each point.

    The springs of the ring between two turns bear :math:`m-m_t+\sigma_t b` at a motion m: a square in m, of which the
    coefficients are summed up from the axis to each turn once.
    """
    beyond, sides = springs.tails(front), np.array(branches.directions)
    heads, inner = np.array(branches.heads, dtype=int), np.array(branches.inner, dtype=int)

    def rings(turn: Array, until: Array) -> Array:
        """Return the coefficients of m^2, 2 m and 1 of rings from turns, or the axis, to the fronts of points."""
        still = turn < 0
        low = np.where(still, springs.whole[:, None], beyond[:, turn])
        zeroth, first, second = low - beyond[:, until]
        at, side = np.where(still, 0.0, motion[turn]), np.where(still, 0.0, sides[turn])
        return np.array(
            [zeroth, side * first - at * zeroth, at * at * zeroth - 2.0 * at * side * first + side**2 * second]
        )

    points = np.arange(motion.size)
    own: list[list[float]] = rings(inner, points).T.tolist()
    sums: list[list[float]] = []
    for turn, before in enumerate(branches.inner):
        sums.append([a + b for a, b in zip(own[turn], sums[before], strict=True)] if before >= 0 else own[turn])
    a, b, c = rings(heads, points) + np.where(heads < 0, 0.0, np.array(sums).reshape(-1, 3).T[:, heads])
    return np.asarray(np.maximum(motion * (a * motion + 2.0 * b) + c + sides**2 * beyond[2], 0.0))


def _chunks(values: Array) -> list[Array]:
    """Return numbers in parts that are read at a time, lest arrays over their places become long."""
    return [values[low : low + CHUNK] for low in range(0, values.size, CHUNK)]
