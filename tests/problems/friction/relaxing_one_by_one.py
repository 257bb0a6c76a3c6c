"""Relaxing springs that are pressed and dragged, one by one: from event to event, in closed form between them.

A second derivation of what `Tangential` answers on a half-space of a standard solid.  Of the package it takes the
places, gaps and weights of the springs alone.  A spring bears q = E u + S with S' = H u' - S/tau across, and k times
the like of its displacement v along the surface.  While depth and shift change at steady rates, all modes are sums of a
constant, a straight line and one exponential:

- free: u and v fade by exp(-t/l) with l = tau (E + H)/E, and bear nothing;
- stuck: u and v follow the bodies;
- sliding: v = s (mu/k) u + w, of which w fades as a free spring does, since both directions relax alike.

Modes change where such a sum passes zero: q_z, mu q_z - |q_x|, the rate of slip, the gap under a free spring.  So
paths in depth and shift are solved to rounding, and their losses to that of a quadrature.  Forces are met at the ends
of steps within which the rates are steady; steps grow from each point of the path on, are halved twice, and
extrapolated.

`python tests/problems/friction/relaxing_one_by_one.py` follows the golden histories in this way and writes what they
end at to `relaxing_one_by_one.json`; `test_relaxing_one_by_one.py` compares.
"""

from __future__ import annotations

import json
import sys
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

import winkler as wk
from winkler.foundation.springs import Springs
from winkler.problems.normal.solve_contact import at_depth

FOUND = Path(__file__).with_name("relaxing_one_by_one.json")
GOLDEN = Path(__file__).parents[2] / "golden"
NUMBERS = GOLDEN / "numbers" / "20-history.json"
STEPS = 200
"""Steps between two points of the path, of the coarsest of three runs; each is doubled once."""
NAMES = (
    "depth", "force", "radius", "shift", "shear_force", "stick_radius", "stored_energy", "friction_loss", "bulk_loss",
    "work", "dissipation",
)  # fmt: skip
ACROSS_ALONG = ("across", "along")
FREE, STUCK, FORTH, BACK = range(4)
SIDE = np.array([0.0, 0.0, 1.0, -1.0])
ROUNDING = 1e-13
MOST_EVENTS, MOST_TRIALS, HALVINGS = 60, 200, 200
NODES, PARTS = np.polynomial.legendre.leggauss(6)
NODES, PARTS = 0.5 * (NODES + 1.0), 0.5 * PARTS
Array = np.ndarray


def value_at(t: Array, sum_: tuple[Array, ...]) -> Array:
    """Return start + slope t + size (exp(-t/span) - 1)."""
    start, slope, size, span = sum_
    return np.asarray(start + slope * t + size * np.expm1(-t / span))


def first_zero(start: Array, slope: Array, size: Array, span: Array, limit: Array, little: Array) -> Array:
    """Return when start + slope t + size (exp(-t/span) - 1) falls below zero, infinite where not before the limit."""
    rate = slope - size / span
    steep = 1e-11 * (np.abs(slope) + np.abs(size) / span)
    at_once = (start < -little) | ((start <= little) & (rate < -steep))
    with np.errstate(divide="ignore", invalid="ignore"):
        turn = -span * np.log(slope * span / size)
    inner = (turn > 0.0) & (turn < limit)
    low = np.where(inner & (size < 0.0), turn, 0.0)
    high = np.where(inner & (size > 0.0), turn, limit)
    low, high = np.minimum(low, limit), np.minimum(high, limit)
    falls = ~at_once & (value_at(high, (start, slope, size, span)) < -little)
    found = np.where(at_once, 0.0, np.inf)
    (some,) = np.nonzero(falls)
    if some.size:
        mine = (start[some], slope[some], size[some], span[some])
        left, right = low[some], high[some]
        for _ in range(HALVINGS):
            middle = 0.5 * (left + right)
            if np.all((middle <= left) | (middle >= right)):
                break
            below = value_at(middle, mine) < 0.0
            left, right = np.where(below, left, middle), np.where(below, middle, right)
        found[some] = right
    return found


class Rows:
    """Springs of many contacts at one time, (contacts x springs,)."""

    def __init__(self, problems: list[Any]) -> None:
        columns = []
        for problem in problems:
            bed, path, solid = problem.bed, problem.path, problem.bed.medium.first
            elastic = wk.Foundation(bed.profile, bed.medium.elastic)
            deepest = wk.ViscoelasticIndentation(bed, wk.Path(path.time, path.normal))._deepest
            springs = Springs.of(elastic, float(at_depth(elastic, np.array([deepest]))[1][0]), problem.count)
            part = 2.0 / (1.0 - solid.poisson)
            ratio = (1.0 - solid.poisson) / (1.0 - 0.5 * solid.poisson)
            single = (part * solid.relaxed_shear, part * solid.shear, solid.relaxation_time, ratio)
            columns.append((springs, single, problem.law.coefficient, deepest))
        self.place, self.gap, self.weight = (
            np.array([getattr(each[0], name) for each in columns]) for name in ("position", "gap", "stiffness")
        )
        self.count, self.springs = self.gap.shape
        spread = [np.repeat(column, self.springs) for column in np.array([each[1] for each in columns]).T]
        self.soft, self.hard, self.tau, self.ratio = spread
        self.fade = self.tau * (self.soft + self.hard) / self.soft
        self.mu = np.repeat([each[2] for each in columns], self.springs)
        self.bound = self.mu / self.ratio
        self.deep = np.repeat([each[3] for each in columns], self.springs)
        self.gaps, self.weights = self.gap.ravel(), self.weight.ravel()
        size = self.gaps.size
        self.mode = np.full(size, FREE)
        self.u, self.s, self.v, self.p = np.zeros((4, size))
        self.lost = np.zeros((3, size))
        """To friction, in dashpots, and the work, over weights."""
        self.sudden = np.zeros(self.count)
        self.most = [np.max(np.abs([getattr(each.path, name) for each in problems]), axis=1) for name in ACROSS_ALONG]
        self.depth, self.shift = np.zeros((2, self.count))
        self.rising = np.ones(self.count, dtype=bool)

    def each(self, numbers: Array) -> Array:
        """Return numbers of contacts, spring by spring."""
        return np.repeat(numbers, self.springs)

    def summed(self, numbers: Array) -> Array:
        """Return weighted sums over the springs of each contact."""
        return np.sum((self.weights * numbers).reshape(self.count, -1), axis=1)

    def press(self, depth: Array) -> None:
        """Press all at once, before anything else."""
        self.u = np.maximum(self.each(depth) - self.gaps, 0.0)
        self.s = self.hard * self.u
        self.mode = np.where(self.u > 0.0, STUCK, FREE)
        self.depth = depth.copy()
        self.sudden = self.summed(0.5 * (self.soft + self.hard) * self.u**2)

    def events(self, at: Array, u: Array, s: Array, v: Array, p: Array, depth: Array, left: Array, across: Array,
               along: Array, mode: Array, pushed: bool) -> tuple[Array, Array]:  # fmt: skip
        """Return when the mode of springs changes next, and into which."""
        soft, hard, tau, fade, bound = (x[at] for x in (self.soft, self.hard, self.tau, self.fade, self.bound))
        free = mode == FREE
        little = ROUNDING * self.deep[at]
        force = little * (soft + hard)
        load = (soft * u + s, soft * across, s - hard * tau * across)
        gap = (u + self.gaps[at] - depth, -across, u)
        first = [np.where(free, x, y) for x, y in zip(gap, load, strict=True)]
        when = first_zero(*first, np.where(free, fade, tau), left, np.where(free, little, force))
        into = np.where(free, STUCK, FREE)
        if not pushed:
            return when, into
        side = SIDE[mode]
        drag = (soft * v + p, soft * along, p - hard * tau * along)
        for sign, other in ((1.0, FORTH), (-1.0, BACK)):
            least = [bound * x - sign * y for x, y in zip(load, drag, strict=True)]
            slips = first_zero(*least, tau, left, bound * force)
            slips = np.where(mode == STUCK, slips, np.inf)
            into = np.where(slips < when, other, into)
            when = np.minimum(when, slips)
        apart = side * (v - side * bound * u) / fade
        start = side * along - bound * across + apart
        fast = np.abs(along) + bound * np.abs(across) + np.abs(apart)
        stops = first_zero(start, np.zeros(at.size), apart, fade, left, ROUNDING * fast)
        stops = np.where(side != 0.0, stops, np.inf)
        into = np.where(stops < when, STUCK, into)
        return np.minimum(when, stops), into

    def after(self, at: Array, u: Array, s: Array, v: Array, p: Array, across: Array, along: Array, mode: Array,
              t: Array) -> tuple[Array, ...]:  # fmt: skip
        """Return displacements and loads of dashpots after a time in which the mode stays; t (n,) or (m, n)."""
        soft, hard, tau, fade, bound = (x[at] for x in (self.soft, self.hard, self.tau, self.fade, self.bound))
        free, side = mode == FREE, SIDE[mode]
        e, f = np.expm1(-t / tau), np.exp(-t / fade)
        u1 = np.where(free, u * f, u + across * t)
        s1 = np.where(free, -soft * u1, s + (s - hard * tau * across) * e)
        w = np.where(free, v, v - side * bound * u) * f
        away = side != 0.0
        v1 = np.where(free | away, w + side * bound * u1, v + along * t)
        p1 = np.where(free | away, -soft * w + side * bound * s1, p + (p - hard * tau * along) * e)
        p1 = np.where(free, -soft * w, p1)
        return u1, s1, v1, p1

    def go(self, h: float, across: Array, along: Array, pushed: bool, keep: bool) -> tuple[Array, ...]:
        """Return springs after a step at steady rates: u, s, v, p and modes; keep them and their losses if wanted."""
        a, b = self.each(across), self.each(along)
        now = [self.u.copy(), self.s.copy(), self.v.copy(), self.p.copy()]
        mode, depth, left = self.mode.copy(), self.each(self.depth), np.full(self.u.size, h)
        at = np.arange(self.u.size)
        for _ in range(MOST_EVENTS):
            mine, own = [x[at] for x in now], mode[at]
            when, into = self.events(at, *mine, depth[at], left[at], a[at], b[at], own, pushed)
            span = np.minimum(when, left[at])
            if keep:
                self.lose(at, mine, a[at], b[at], own, span)
            ends = self.after(at, *mine, a[at], b[at], own, span)
            for x, end in zip(now, ends, strict=True):
                x[at] = end
            depth[at] += a[at] * span
            left[at] -= span
            changed = when <= span
            mode[at] = np.where(changed, into, own)
            at = at[changed & (left[at] > 0.0)]
            if not at.size:
                break
        else:
            raise RuntimeError(f"{at} change their modes for ever")
        if keep:
            self.u, self.s, self.v, self.p = now
            self.mode = mode
            self.depth, self.shift = self.depth + h * across, self.shift + h * along
            self.rising = np.where(across == 0.0, self.rising, across > 0.0)
        return (*now, mode)

    def lose(self, at: Array, mine: list[Array], a: Array, b: Array, mode: Array, span: Array) -> None:
        """Add to what is lost and to the work, by quadrature over a stretch of one mode."""
        (some,) = np.nonzero((mode != FREE) | (mine[0] != 0.0) | (mine[2] != 0.0))
        if not some.size:
            return
        at, a, b, mode, span = at[some], a[some], b[some], mode[some], span[some]
        u, s, v, p = (x[some] for x in mine)
        t = NODES[:, None] * span
        u1, s1, v1, p1 = self.after(at, u, s, v, p, a, b, mode, t)
        side = SIDE[mode]
        part = PARTS[:, None] * span
        load = self.soft[at] * u1 + s1
        slip = side * b - self.bound[at] * a + side * (v1 - side * self.bound[at] * u1) / self.fade[at]
        rubbed = np.where(side != 0.0, self.mu[at] * load * slip, 0.0)
        damped = (s1**2 + self.ratio[at] * p1**2) / (self.hard[at] * self.tau[at])
        work = np.where(mode == FREE, 0.0, load * a + self.ratio[at] * (self.soft[at] * v1 + p1) * b)
        for place, rate in enumerate((rubbed, damped, work)):
            self.lost[place, at] += np.sum(part * rate, axis=0)

    def rates(self, h: float, target: Array, guess: Array, across: Array | None) -> Array:
        """Return at which rates springs bear forces at the end of a step; along the surface if `across` is known."""
        pushed = across is not None
        low, high, rate = np.full(self.count, -np.inf), np.full(self.count, np.inf), guess.copy()
        stiff = self.soft * h + self.hard * self.tau * -np.expm1(-h / self.tau)
        stiff = stiff * self.ratio if pushed else stiff
        still = np.zeros(self.count)
        for turn in range(MOST_TRIALS):
            u, s, v, p, mode = self.go(h, across if pushed else rate, rate if pushed else still, pushed, False)
            borne = self.ratio * (self.soft * v + p) if pushed else self.soft * u + s
            missed = target - self.summed(np.where(mode == FREE, 0.0, borne))
            close = np.abs(missed) <= 1e-12 * self.most[int(pushed)]
            if np.all(close):
                break
            low = np.where(missed > 0.0, np.maximum(low, rate), low)
            high = np.where(missed < 0.0, np.minimum(high, rate), high)
            holds = self.summed(np.where(mode == STUCK, stiff, 0.0) if pushed else np.where(mode == FREE, 0.0, stiff))
            holds = np.where(holds > 0.0, holds, self.summed(stiff))
            ahead = rate + missed / holds
            inside = (low < ahead) & (ahead < high)
            bracketed = np.isfinite(low) & np.isfinite(high)
            middle = np.where(bracketed, 0.5 * (np.where(bracketed, low, 0.0) + np.where(bracketed, high, 0.0)), ahead)
            ahead = np.where(inside & (turn % 4 != 3), ahead, middle)
            ahead = np.where(close | ~np.isfinite(ahead), rate, ahead)
            if np.all(close | (ahead == rate)):
                break
            rate = ahead
        else:
            raise RuntimeError(f"no rates: {missed / self.most[int(pushed)]}")
        return rate

    def answer(self) -> Array:
        """Return the numbers of `NAMES`, contact by contact."""
        touches = self.mode != FREE
        load = np.where(touches, self.soft * self.u + self.s, 0.0)
        drag = np.where(touches, self.soft * self.v + self.p, 0.0)
        stored = 0.5 * (self.soft * (self.u**2 + self.ratio * self.v**2))
        stored += 0.5 * (self.s**2 + self.ratio * self.p**2) / self.hard
        friction, bulk, work = (self.summed(each) for each in self.lost)
        rows = [each.reshape(self.count, -1) for each in (touches, load, drag, self.bound * load, self.u)]
        radii = np.array([self.radii(row, *(each[row] for each in rows)) for row in range(self.count)])
        kept = self.summed(stored)
        return np.column_stack((
            self.depth, self.summed(load), radii[:, 0], self.shift, self.summed(self.ratio * drag), radii[:, 1], kept,
            friction, bulk, work + self.sudden, friction + bulk,
        ))  # fmt: skip

    def radii(self, row: int, touches: Array, load: Array, drag: Array, bound: Array, u: Array) -> tuple[float, float]:
        """Return contact and stick radius between springs, as `Tangential` reads them: straight lines over the gap."""
        gap, x = self.gap[row], self.place[row]
        inside = int(np.count_nonzero(touches))
        assert np.all(touches[:inside])
        if inside in (0, gap.size):
            radius = float(x[-1]) if inside else 0.0
        else:
            low, high = gap[inside - 1], gap[inside]
            if self.rising[row] or inside < 2:
                lack = gap + u - self.depth[row]
                line = lack[inside : inside + 2]
                slope = np.diff(line)[0] / np.diff(gap[inside : inside + 2])[0] if line.size > 1 else 1.0
                edge = high - line[0] / slope if slope > 0.0 else low
            else:
                fall = load[inside - 2] - load[inside - 1]
                edge = low + load[inside - 1] * (low - gap[inside - 2]) / fall if fall > 0.0 else high
            part = np.clip((edge - low) / (high - low), 0.0, 1.0)
            radius = float(np.sqrt(x[inside - 1] ** 2 + part * (x[inside] ** 2 - x[inside - 1] ** 2)))
        moving = np.flatnonzero(~(np.abs(drag) < (1.0 - 1e-9) * bound))
        first = int(moving[0]) if moving.size else x.size
        if first == 0 or x[first - 1] >= radius:
            return radius, radius if first else 0.0
        slack = bound - np.abs(drag)
        edge = 0.5 * (x[first - 1] + x[min(first, x.size - 1)])
        if first > 1 and slack[first - 2] > slack[first - 1]:
            fall = (slack[first - 2] - slack[first - 1]) / (x[first - 1] - x[first - 2])
            edge = min(x[first - 1] + slack[first - 1] / fall, x[min(first, x.size - 1)])
        return radius, float(min(edge, radius))


def followed(problems: list[Any], steps: int) -> Array:
    """Return the numbers of `NAMES` at the end of paths of one kind, (problems, names)."""
    rows = Rows(problems)
    path = problems[0].path
    forced, moved = isinstance(path.normal, wk.Force), isinstance(path.lateral, wk.Shift)
    across, along = (np.array([getattr(each.path, name) for each in problems]) for name in ACROSS_ALONG)
    assert np.all(along[:, 0] == 0.0)
    depth = across[:, 0].copy()
    if forced:
        glassy = (rows.soft + rows.hard).reshape(rows.count, -1)[:, 0]
        for row in range(rows.count):
            corners = [float(rows.weight[row] @ np.maximum(d - rows.gap[row], 0.0)) for d in rows.gap[row]]
            depth[row] = np.interp(across[row, 0] / glassy[row], corners, rows.gap[row])
    rows.press(depth)
    rates = [np.zeros(rows.count), np.zeros(rows.count)]
    for point in range(1, path.time.size):
        span = float(path.time[point] - path.time[point - 1])
        begin = rows.depth.copy(), rows.shift.copy()
        for step in range(1, steps + 1):
            part, h = (step / steps) ** 2, span * (2 * step - 1) / steps**2
            goal = [x[:, point - 1] + part * (x[:, point] - x[:, point - 1]) for x in (across, along)]
            if forced:
                rates[0] = rows.rates(h, goal[0], rates[0], None)
            else:
                rates[0] = (across[:, point] - begin[0]) / span
            if moved:
                rates[1] = (along[:, point] - begin[1]) / span
            else:
                rates[1] = rows.rates(h, goal[1], rates[1], rates[0])
            rows.go(h, *rates, True, True)
    return rows.answer()


def extrapolated(problems: list[Any], steps: int = STEPS) -> tuple[Array, Array]:
    """Return two limits of second order: of runs of so many steps and twice, and of twice and four times as many."""
    runs = [followed(problems, finer * steps) for finer in (1, 2, 4)]
    coarse, fine = (later + (later - former) / 3.0 for former, later in pairwise(runs))
    return coarse, fine


def golden() -> dict[str, Any]:
    """Return the golden numbers of relaxing springs, group by group."""
    return dict(json.loads(NUMBERS.read_text()))


def histories(name: str) -> list[Any]:
    """Return the problems of a group of golden numbers."""
    sys.path.insert(0, str(GOLDEN))
    from histories import GROUPS, SEEDS

    return [GROUPS[name.removeprefix("history/")](seed) for seed in range(SEEDS)]


def main() -> None:
    """Follow the golden histories and write both limits of what each ends at, ``(seeds, names)``."""
    found = {}
    for name in golden():
        found[name] = [limit.tolist() for limit in extrapolated(histories(name))]
        print(name, file=sys.stderr, flush=True)
    FOUND.write_text(json.dumps(found))


if __name__ == "__main__":
    main()
