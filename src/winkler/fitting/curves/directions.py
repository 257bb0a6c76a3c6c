r"""Detection of the parts of a force curve in which the tip goes in, is held, and comes out.

One of position and force is driven by the machine, and its rate is steadier: its samples are evenly distributed
over its levels.  The driven signal turns where it returns from an extreme by more than its noise; it is held where far
more samples lie about one level than during a steady motion,

.. math:: n(L,\,2w) > K\,\nu\,2w, \qquad n(L,\,8w) < 1.7\,n(L,\,2w),

with the samples :math:`\nu` per unit of level while it moves.  The second condition separates a hold, which ends
sharply, from a smooth turn, where four times the band holds twice the samples.  All widths are parts of the whole
span, or multiples of the noise; times are not needed.

Holds at a turn of a noisy signal that are too short for their density of samples to stand out.

About the turn, two straight lines joined by a level are compared with two parabolas that meet in a point, and with a
polynomial: the hold is one if it leaves clearly less, although it has fewer numbers.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

IN, HELD, OUT = 1.0, 0.0, -1.0
MOST_CELLS = 2000
"""Most block averages in the search for turns."""
TURN_SHARE, TURN_TO_NOISE = 0.01, 8.0
"""Least return at a turn, in parts of the span and in multiples of the noise."""
HOLD_BANDS = (5e-4, 1.5e-3, 5e-3)
"""Widths of a hold about its level, in parts of the span."""
HOLD_DENSITY_RATIO, FEWEST_HOLD_POINTS, WIDE_BAND_RATIO = 6.0, 5, 1.7
"""Least density of samples in a hold over that of a motion, fewest samples, and greatest ratio in a wider band."""
MOST_STRAYS = 4
"""Most points beside a hold that belong to it, although they lead to the turn."""
MOST_AVERAGED, POINTS_PER_AVERAGED = 5, 60
"""Most averaged neighbours under noise, and samples required for each."""
LEVEL_COUNT, SAMPLES_PER_LEVEL = 25, 8
"""Most levels, and samples in each, by which the evenness of a signal is measured."""
FREE_FORCE_SHARE = 0.05
"""Part of the span of the force below which the tip may be out of contact."""
CREEP_SPEED_RATIO = 1.0 / 3.0
"""Greatest speed during a hold under a steady force, relative to the usual speed."""


class _Signal(NamedTuple):
    """Samples in parts of their span, their noise, and the indices of turns."""

    level: Array
    noise: float
    turns: list[int]


class _Plateau(NamedTuple):
    first: int
    last: int


def found_directions(position: Array, force: Array) -> Array:
    """Return +1 where the tip goes in, 0 where it is held and -1 where it comes out ``(n,)``.

    A point at which the tip turns without a hold belongs to the part before it.

    Parameters
    ----------
    position, force : ndarray, (n,)
        [m] and [N], in the order in which they were measured.
    """
    spans = np.ptp(position), np.ptp(force)
    if not spans[0] > 0.0:
        return np.full(position.size, HELD if spans[1] > 0.0 else OUT)
    place = _signal(position, spans[0])
    if not spans[1] > 0.0:
        return _with_holds(_directions_between_turns(place), _plateaus(place))
    load = _signal(force, spans[1])
    base = float(np.median(load.level[place.level <= np.quantile(place.level, FREE_FORCE_SHARE)]))
    is_loaded = load.level > base + FREE_FORCE_SHARE
    if _unevenness(place) <= _unevenness(load):
        speed, holds = 1.0 / _samples_per_level(place), _plateaus(place)
        for part in _plateaus(load):
            is_separate = all(part.last < other.first or other.last < part.first for other in holds)
            if is_separate and _held_by_force(part, place.level, is_loaded, speed):
                holds.append(part)
        return _with_holds(_directions_between_turns(place), holds)
    return _by_force(place.level, load, is_loaded)


def _held_by_force(part: _Plateau, place: Array, is_loaded: Array, speed: float) -> bool:
    """Return whether a steady force belongs to a hold: in contact, at a nearly constant position."""
    travel = abs(place[part.last] - place[part.first])
    return bool(np.mean(is_loaded[part.first : part.last + 1]) > 0.5) and travel < CREEP_SPEED_RATIO * speed * (
        part.last - part.first
    )


def _by_force(place: Array, load: _Signal, is_loaded: Array) -> Array:
    """Return the directions of a force-controlled curve."""
    direction = _directions_between_turns(load)
    edges = [0, *(turn + 1 for turn in load.turns[1:-1]), place.size]
    for first, end in zip(edges[:-1], edges[1:], strict=True):
        travel = place[end - 1] - place[first]
        if abs(travel) > TURN_SHARE and travel * direction[first] < 0.0:  # snapped in, or pulled off
            direction[first:end] = np.sign(travel)
    for part in _plateaus(load):
        own_points = slice(part.first, part.last + 1)
        travel = place[part.last] - place[part.first]
        free = np.mean(is_loaded[own_points]) <= 0.5 and abs(travel) > FREE_FORCE_SHARE
        direction[own_points] = np.sign(travel) if free else HELD
    return _without_strays(direction)


def _with_holds(direction: Array, holds: list[_Plateau]) -> Array:
    for part in holds:
        direction[part.first : part.last + 1] = HELD
    return _without_strays(direction)


def _without_strays(direction: Array) -> Array:
    """Return directions in which a few points between a hold and a motion the other way belong to the hold."""
    edges = [0, *(np.flatnonzero(np.diff(direction)) + 1).tolist(), direction.size]
    for before, first, end, behind in zip(edges[:-3], edges[1:-2], edges[2:-1], edges[3:], strict=True):
        neighbours = {float(direction[before]), float(direction[end])}
        is_stray = end - first <= MOST_STRAYS and min(first - before, behind - end) > MOST_STRAYS
        if is_stray and direction[first] != HELD and neighbours == {HELD, -float(direction[first])}:
            direction[first:end] = HELD
    return direction


def _trimmed(level: Array, parts: list[_Plateau]) -> list[_Plateau]:
    """Return holds limited to their own scatter; overlapping ones are merged."""
    is_held = np.zeros(level.size, dtype=bool)
    for part in parts:
        is_held[part.first : part.last + 1] = True
    edges = np.flatnonzero(np.diff(np.concatenate([[False], is_held, [False]]).astype(int)))
    result = []
    for first, end in edges.reshape(-1, 2):
        deviation = np.abs(level[first:end] - np.median(level[first:end]))
        (within,) = np.nonzero(deviation <= max(2.0 * HOLD_BANDS[0], 9.0 * float(np.median(deviation))))
        result.append(_Plateau(int(first + within[0]), int(first + within[-1])))
    return result


def _signal(samples: Array, span: float) -> _Signal:
    level = (samples - samples.min()) / span
    bends = np.abs(np.diff(level, 2))
    noise = float(np.median(bends)) / (0.6745 * np.sqrt(6.0)) if bends.size > FEWEST_HOLD_POINTS else 0.0
    return _Signal(level, noise, _turns(level, max(TURN_SHARE, TURN_TO_NOISE * noise)))


def _turns(level: Array, least: float) -> list[int]:
    """Return the ends, and the extremes from which the signal returns by more than `least`."""
    size = -(-level.size // MOST_CELLS)
    starts = np.arange(0, level.size, size)
    cells = (np.add.reduceat(level, starts) / np.diff(np.append(starts, level.size))).tolist()
    result: list[tuple[int, float]] = []
    highest = lowest = trend = 0
    top = bottom = cells[0]
    for index, cell in enumerate(cells):
        if cell > top:
            highest, top = index, cell
        elif cell < bottom:
            lowest, bottom = index, cell
        if trend >= 0 and cell < top - least:
            result, lowest, bottom, trend = [*result, (highest, IN)], index, cell, -1
        elif trend <= 0 and cell > bottom + least:
            result, highest, top, trend = [*result, (lowest, OUT)], index, cell, 1
    if result and abs(cells[result[0][0]] - cells[0]) <= least:  # the first extreme is noise about the start
        result = result[1:]
    turns = [0]
    for cell, sign in result:
        first = max(int(starts[cell]) - size, turns[-1])
        turn = first + int(np.argmax(sign * level[first : starts[cell] + 2 * size]))
        turns += [turn] if turns[-1] < turn < level.size - 1 else []
    return [*turns, level.size - 1]


def _directions_between_turns(signal: _Signal) -> Array:
    """Return the direction between turns; a turn belongs to the part before it."""
    level, turns = signal.level, signal.turns
    direction = np.empty(level.size)
    for first, last in zip(turns[:-1], turns[1:], strict=True):
        direction[first + (first > 0) : last + 1] = IN if level[last] > level[first] else OUT
    return direction


def _stretches(signal: _Signal) -> list[Array]:
    return [signal.level[a : b + 1] for a, b in zip(signal.turns[:-1], signal.turns[1:], strict=True) if b > a]


def _counts(samples: Array, levels: int = LEVEL_COUNT) -> Array:
    """Return the number of samples in each level; all in one where they differ by rounding alone."""
    if not np.ptp(samples) > levels * np.spacing(np.abs(samples).max()):
        return np.bincount([levels // 2], [float(samples.size)], levels)
    return np.asarray(np.histogram(samples, bins=levels)[0])


def _unevenness(signal: _Signal) -> float:
    """Return the unevenness of samples over the levels: interquartile range over median."""
    parts = [samples for samples in _stretches(signal) if samples.size >= 2 * FEWEST_HOLD_POINTS]
    travels = np.array([np.ptp(samples) for samples in parts])
    if not travels.size or not travels.sum() > 0.0:
        return 0.0
    quartiles = np.array([np.quantile(_counts(samples, _levels(samples.size)), (0.25, 0.5, 0.75)) for samples in parts])
    spread = (quartiles[:, 2] - quartiles[:, 0]) / np.maximum(quartiles[:, 1], 1.0)
    return float(spread @ travels / travels.sum())


def _levels(count: int) -> int:
    """Return a number of levels that hold enough of `count` samples for their numbers to be compared."""
    return max(min(LEVEL_COUNT, count // SAMPLES_PER_LEVEL), FEWEST_HOLD_POINTS)


def _density(samples: Array) -> float:
    """Return the samples per unit of level while the signal moves."""
    travel = float(np.ptp(samples))
    if not travel:
        return 0.0
    least = 0.5 * samples.size / LEVEL_COUNT / LEVEL_COUNT
    return max(float(np.median(_counts(samples))), least) * LEVEL_COUNT / travel


def _samples_per_level(signal: _Signal) -> float:
    parts = _stretches(signal)
    return max(float(np.median([_density(samples) for samples in parts])), 1e-300)


def _averaged(signal: _Signal) -> int:
    """Return the odd number of averaged neighbours that reduces the noise enough to detect holds."""
    if 4.0 * signal.noise <= HOLD_BANDS[0]:
        return 1
    return max(1, min(MOST_AVERAGED, signal.level.size // POINTS_PER_AVERAGED) // 2 * 2 + 1)


def _plateaus(signal: _Signal) -> list[_Plateau]:
    """Return the holds of a signal, at its turns and between them."""
    turns, size = signal.turns, _averaged(signal)
    level = np.convolve(np.pad(signal.level, size // 2, mode="edge"), np.full(size, 1.0 / size), mode="valid")
    least = 4.0 * signal.noise / float(np.sqrt(size))
    densities = [0.0, *(_density(level[a : b + 1]) for a, b in zip(turns[:-1], turns[1:], strict=True)), 0.0]
    result: list[_Plateau] = []
    for width in dict.fromkeys(max(band, least) for band in HOLD_BANDS):
        for place, turn in enumerate(turns):
            rate = densities[place] + densities[place + 1]
            part = _run(level, turn, width, *_reach(turns, place))
            wide = _run(level, turn, 4.0 * width, *_reach(turns, place))
            if _is_hold(part, wide, rate * 2.0 * width):
                result.append(part)
        for place, (first, last) in enumerate(zip(turns[:-1], turns[1:], strict=True)):
            result += _within(level, first, last, width, densities[place + 1])
    return [*_trimmed(level, result), *_short(signal, result)]


def _short(signal: _Signal, found: list[_Plateau]) -> list[_Plateau]:
    """Return the short holds at turns under noise, where none was found."""
    turns, result = signal.turns, list[_Plateau]()
    for before, turn, behind in zip(turns[:-2], turns[1:-1], turns[2:], strict=True):
        if any(part.first - FEWEST_HOLD_POINTS <= turn <= part.last + FEWEST_HOLD_POINTS for part in found):
            continue
        hold = turn_hold(signal.level, signal.noise, before, turn, behind) if _averaged(signal) > 1 else None
        result += [_Plateau(*hold)] if hold else []
    return result


def _reach(turns: list[int], place: int) -> tuple[int, int]:
    return turns[max(place - 1, 0)], turns[min(place + 1, len(turns) - 1)]


def _is_hold(part: _Plateau, wide: _Plateau, expected: float) -> bool:
    count = part.last - part.first + 1
    is_sharp = wide.last - wide.first + 1 < WIDE_BAND_RATIO * count
    return is_sharp and count >= max(FEWEST_HOLD_POINTS, HOLD_DENSITY_RATIO * expected)


def _run(level: Array, turn: int, width: float, first: int, last: int) -> _Plateau:
    """Return the samples about a turn that stay within 2 `width` of it."""
    deviation = np.flatnonzero(np.abs(level[first : last + 1] - level[turn]) > 2.0 * width) + first
    before, behind = deviation[deviation < turn], deviation[deviation > turn]
    return _Plateau(int(before[-1]) + 1 if before.size else first, int(behind[0]) - 1 if behind.size else last)


def _within(level: Array, first: int, last: int, width: float, density: float) -> list[_Plateau]:
    """Return the holds between two turns: bands with many samples."""
    samples = level[first : last + 1]
    ordered = np.sort(samples)
    counts = np.searchsorted(ordered, ordered + 2.0 * width, side="right") - np.arange(ordered.size)
    counts[(ordered - ordered[0] < 3.0 * width) | (ordered[-1] - ordered < 5.0 * width)] = 0  # near a turn
    result: list[_Plateau] = []
    while True:
        start = int(np.argmax(counts))
        if counts[start] < max(FEWEST_HOLD_POINTS, HOLD_DENSITY_RATIO * density * 2.0 * width):
            return result
        low = ordered[start]
        inside = np.flatnonzero((samples >= low) & (samples <= low + 2.0 * width)) + first
        near = np.flatnonzero((samples >= low - 3.0 * width) & (samples <= low + 5.0 * width)) + first
        part = _Plateau(int(inside[0]), int(inside[-1]))
        if _is_hold(part, _Plateau(int(near[0]), int(near[-1])), density * 2.0 * width):
            result.append(part)
        counts[np.abs(ordered - low) <= 4.0 * width] = 0


MOST_REACH, FEWEST_REACH = 240, 12
"""Most and fewest points on each side of a turn."""
FEWEST_HELD, SMOOTH_DEGREE = 5, 6
"""Fewest points of a hold, and degree of the polynomial of a smooth turn."""
TRIALS = 17
"""Trial places of each end of the level; refined once."""
LEAST_GAIN = 30.0
"""Least difference of the squares left, over the variance of the noise."""
LEAST_RISE_TO_NOISE = 5.0
"""Least change along either side over the noise."""


def turn_hold(level: Array, noise: float, before: int, turn: int, behind: int) -> tuple[int, int] | None:
    """Return first and last point of the hold at a turn; None if there is none.

    Parameters
    ----------
    level : ndarray, (n,)
        The signal that the machine drives.
    noise : float
        Its standard deviation.
    before, turn, behind : int
        The turn, and those before and behind it.
    """
    reach = min(turn - before, behind - turn, MOST_REACH)
    if reach < FEWEST_REACH or not noise > 0.0:
        return None
    y = level[turn - reach : turn + reach + 1]
    x = np.arange(-reach, reach + 1.0)
    ends = np.linspace(-0.8 * reach, 0.8 * reach, TRIALS)
    start, stop, left = _best_level(x, y, ends, ends)
    fine = np.linspace(-1.0, 1.0, TRIALS) * 1.6 * reach / (TRIALS - 1)
    start, stop, left = _best_level(x, y, start + fine, stop + fine)
    variance = max(noise**2, left / max(x.size - 5, 1))
    peaked = _least_left(_peaks(x, np.linspace(-0.3 * reach, 0.3 * reach, TRIALS)), y)
    peaked = min(peaked, _left(np.polynomial.legendre.legvander(x / reach, SMOOTH_DEGREE), y))
    if stop - start < FEWEST_HELD or peaked - left < LEAST_GAIN * variance:
        return None
    columns = _flat(x, start, stop)
    _, rise, fall = np.linalg.lstsq(columns, y, rcond=None)[0]
    least = LEAST_RISE_TO_NOISE * noise
    if rise * fall >= 0.0 or abs(rise) * (start + reach) < least or abs(fall) * (reach - stop) < least:
        return None
    return turn + int(np.ceil(start)), turn + int(np.floor(stop))


def _best_level(x: Array, y: Array, starts: Array, stops: Array) -> tuple[float, float, float]:
    """Return the ends of the level that leaves least, and the squares that it leaves."""
    of_start, of_stop = (
        grid.ravel() for grid in np.meshgrid(np.arange(starts.size), np.arange(stops.size), indexing="ij")
    )
    first, last = starts[of_start], stops[of_stop]
    possible = (last >= first) & (first > x[0] + 2.0) & (last < x[-1] - 2.0)
    first, last, of_start, of_stop = (one[possible] for one in (first, last, of_start, of_stop))
    if not first.size:
        return 0.0, 0.0, float("inf")
    centred = y - y.mean()
    before, behind = np.minimum(x - starts[:, None], 0.0), np.maximum(x - stops[:, None], 0.0)
    products = np.zeros((first.size, 3, 3))  # the sides share no point
    products[:, 0, 0] = x.size
    for place, side, chosen in ((1, before, of_start), (2, behind, of_stop)):
        products[:, 0, place] = products[:, place, 0] = side.sum(axis=1)[chosen]
        products[:, place, place] = np.sum(side**2, axis=1)[chosen]
    right = np.stack(
        [np.full(first.size, centred.sum()), (before @ centred)[of_start], (behind @ centred)[of_stop]], axis=1
    )
    numbers = np.linalg.solve(products, right[..., None])[..., 0]
    left = float(centred @ centred) - np.einsum("gi,gi->g", numbers, right)
    best = int(np.argmin(left))
    return float(first[best]), float(last[best]), float(left[best])


def _flat(x: Array, start: float, stop: float) -> Array:
    return np.stack([np.ones(x.size), np.minimum(x - start, 0.0), np.maximum(x - stop, 0.0)], axis=1)


def _peaks(x: Array, places: Array) -> Array:
    """Return the columns of two parabolas that meet at each of the places, below each other ``(m, 5, n)``."""
    beside = (x - places[:, None]) / x[-1]
    before, behind = np.minimum(beside, 0.0), np.maximum(beside, 0.0)
    return np.stack([np.ones_like(beside), before, before**2, behind, behind**2], axis=1)


def _least_left(columns: Array, y: Array) -> float:
    """Return the least squares that any of several sets of columns ``(m, k, n)`` leaves."""
    centred = y - y.mean()  # every set holds a constant
    numbers = np.linalg.solve(columns @ columns.swapaxes(1, 2), (columns @ centred)[..., None])
    rest = centred - (numbers.swapaxes(1, 2) @ columns)[:, 0]
    return float(np.min(np.sum(rest**2, axis=1)))


def _left(columns: Array, y: Array) -> float:
    rest = y - columns @ np.linalg.lstsq(columns, y, rcond=None)[0]
    return float(rest @ rest)
