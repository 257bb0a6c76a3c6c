r"""The springs of a sheared contact as a stack of straight pieces over their gap, and what a step does to them.

The springs of a rising profile can be numbered by :math:`\gamma=g(x)`, from 0 on the axis to the depth d at the edge.
On a straight step in depth and shift a spring that sticks is displaced by the shift, one that slides stays on its
bound :math:`\beta(d-\gamma)`, and one that comes into contact begins within the step.  All of that is linear in
:math:`\gamma`, so the displacement of the springs stays a chain of straight pieces without end, one for each turning
point that is not yet forgotten: no grid, and no error but rounding.

Slip begins at the edge: in a row of pieces the inner ones stick while the outer ones slide.  So pieces are stacked from
the axis outwards, and a step replaces those at the edge alone.  What sticks is dragged as a whole: it is the same stack
before and after, displaced by one number, and all states of a path share it.  A path costs what its steps replace.

The functions here run as they are, on lists and on sums of any kind, and as one kernel on arrays
(`winkler.problems.friction.tangential_march`); functions at the end stand for what is different there.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from winkler.problems.row import Reached, over
from winkler.values.errors import NotConverged, OutsideValidity

LEAST_DEPTH = 1e-150
"""Depths below this [m] are none, and springs whose gaps differ by less lose alike: their squares are no numbers."""
BOUND_TOLERANCE = 1e-12
"""A spring that is displaced by all but this part of its bound slides."""
CUT_TOLERANCE = 1e-14
"""A cut this close to the end of a piece, in parts of the depth, is at the end."""
SLOPE_TOLERANCE = 1e-13
"""Pieces that meet, and whose slopes differ by less than this part of the slopes there are, become one."""
ROUNDING = 1e-15
"""Of a displacement, relative to how far the stack was dragged."""
SLIDING_TOLERANCE = 1e-12
"""A shear force beyond what friction bears by no more than this part of it is that of sliding."""
FORCE_TOLERANCE = 4e-15
"""A shear force is met to this part of what friction bears."""
MOST_NEWTON_STEPS = 200
"""Steps of Newton's method, halving where that leads astray."""
MOST_ROOT_STEPS = 20
"""Of Newton's method for a gap, from that of a power of the depth."""
ROOM = 64
"""Pieces for which room is made at once."""

Moments = tuple[float, float, float]
"""Sums over springs of 1 [N/m], of a length [N] and of its square [J]."""


class SlipStack(NamedTuple):
    """Pieces that never change, each on top of those within it: lists, or arrays in a kernel.

    Parameters
    ----------
    start, stop : list of float
        Gaps of the springs of a piece [m].
    left, right : list of float
        u_t at both ends [m], beyond that of the stack as a whole.
    side : list of int
        Whether they are on their bound: on which side (1, -1), else 0.
    inner, outer : list of int
        The piece within, -1 on the axis; and that beyond it on the way inwards that was gone last, -1 at its beginning.
    count : list of int
        How many pieces there are from the axis to here.
    stuck : list of int
        Whether all of them stick.
    axis : list of float
        The displacement of the innermost spring [m].
    known : list of int
        Whether `zeroth`, `first` and `second`, as of `within`, are known.
    used : list of int, (1,)
        How many pieces have been put.
    """

    start: Any
    stop: Any
    left: Any
    right: Any
    side: Any
    inner: Any
    outer: Any
    count: Any
    stuck: Any
    axis: Any
    known: Any
    zeroth: Any
    first: Any
    second: Any
    used: Any


class SlipGoal(NamedTuple):
    """What is prescribed at a moment: d [m] with F_N [N], and U [m] or F_x [N], in the plane ``(2,)``."""

    depth: float
    force: float
    along: Any


class SlipState(NamedTuple):
    """The outermost piece, how far the stack was dragged [m], the depth [m], and the shift [m]."""

    top: int
    dragged: float
    depth: float
    shift: float


class SlipCells(NamedTuple):
    """Springs numbered by their gap, and how they are driven.

    Parameters
    ----------
    stack : SlipStack
    table
        With which they are summed up: as of `moments` and `normal_at`.
    bound, ratio, coefficient : float
        beta, c_T/c_N, mu [-].
    driven, pressed : bool
        As of `winkler.problems.friction.tangential_march.PressedRow`.
    near, cheap : float
        By how much displacements [m] and energies [J] may differ where a step is halved.
    """

    stack: SlipStack
    table: Any
    bound: float
    ratio: float
    coefficient: float
    driven: bool
    pressed: bool
    near: float
    cheap: float


def empty_stack() -> SlipStack:
    """Return a stack without pieces."""
    return SlipStack._make([*([] for _ in SlipStack._fields[:-1]), [0]])


def new_piece(stack: SlipStack, inner: int, start: float, stop: float, left: float, right: float, side: int) -> int:
    """Put a piece on another one, and return its number."""
    piece: int = stack.used[0]
    if piece == len(stack.start):
        make_room(stack)
    stack.start[piece], stack.stop[piece], stack.left[piece], stack.right[piece] = start, stop, left, right
    stack.side[piece], stack.inner[piece], stack.known[piece] = side, inner, 0
    if inner < 0:
        stack.count[piece], stack.axis[piece], stack.stuck[piece] = 1, left, 1 if side == 0 else 0
    else:
        stack.count[piece], stack.axis[piece] = stack.count[inner] + 1, stack.axis[inner]
        stack.stuck[piece] = stack.stuck[inner] if side == 0 else 0
    stack.used[0] = piece + 1
    return piece


def _joined(
    stack: SlipStack, top: int, dragged: float, start: float, stop: float, left: float, right: float, side: int
) -> int:
    """Return the stack with one more piece on it [m], as one with the last if they go on in a straight line."""
    if top >= 0 and stack.side[top] == side:
        low, at_low, at_high = stack.start[top], stack.left[top], stack.right[top]
        before, behind = (at_high - at_low) / (stack.stop[top] - low), (right - left) / (stop - start)
        most = max(abs(at_low + dragged), abs(at_high + dragged), abs(left), abs(right))
        straight = side != 0 or abs(behind - before) <= SLOPE_TOLERANCE * max(abs(before), abs(behind))
        if straight and abs(left - dragged - at_high) <= SLOPE_TOLERANCE * most + ROUNDING * abs(dragged):
            return new_piece(stack, stack.inner[top], low, stop, at_low, right - dragged, side)
    return new_piece(stack, top, start, stop, left - dragged, right - dragged, side)


def _product(width: float, sums: Moments, one: float, one_last: float, two: float, two_last: float) -> Any:
    """Return the sum over springs of the product of two straight lines over their gap, from both ends of each."""
    if width < LEAST_DEPTH:  # a flat end may still be among them
        return one * two * sums[0]
    first, second = (one - one_last) / width, (two - two_last) / width
    linear = first * two_last + second * one_last
    return one_last * two_last * sums[0] + linear * sums[1] + first * second * sums[2]


def _slid(
    width: float,
    sums: Moments,
    slid: tuple[float, float],
    ends: tuple[float, float],
    moved: float,
    fall: float,
    came: bool,
) -> tuple[Any, Any]:
    """Return the loss of springs that slide until they bear `ends`, and what they do not resist of the work.

    `moved` is the shift to the side to which they slide, `fall` by how much their bound grows.
    """
    if slid[0] == 0.0 and slid[1] == 0.0:
        return 0.0, 0.0
    if came:  # the bound of a coming spring grows from zero
        return _product(width, sums, slid[0], slid[1], 0.5 * ends[0], 0.5 * ends[1]), 0.0
    # the bound changes in proportion to the distance that is slid
    closing = moved - fall
    share = 0.5 * fall / closing if closing > 0.0 else 0.0
    lost = _product(width, sums, slid[0], slid[1], ends[0] - share * slid[0], ends[1] - share * slid[1])
    if closing > 0.0:
        return lost, 0.5 * moved / closing * _product(width, sums, slid[0], slid[1], slid[0], slid[1])
    return lost, 0.0


def _drag(
    cells: tuple[SlipStack, Any, float, bool],
    step: tuple[float, float, float],
    stacked: tuple[int, float],
    springs: tuple[float, float, float, float],
    came: bool,
) -> tuple[int, Any, Any]:
    """Move springs from a gap to another, from u_t to u_t, of which those beyond their bound slide.

    `step` are the depth at its end, its rise and the shift; `stacked` what is within, and how far it is dragged.
    Returns the stack, and what the springs have lost and what was spent on them.
    """
    stack, table, bound, summed = cells
    after, rise, change = step
    top, dragged = stacked
    start, stop, left, right = springs
    lost, work, half, endless = 0.0, 0.0, 0.5 * change, math.isinf(bound)
    cuts, x1, u1, x2, u2 = 0, stop, right, stop, right
    if not endless:
        first, last = bound * (after - start), bound * (after - stop)
        for sign in (1.0, -1.0):
            one, two = sign * left - first, sign * right - last
            if one * two < 0.0:
                at = start + (stop - start) * (one / (one - two))
                if min(at - start, stop - at) > CUT_TOLERANCE * after:
                    u = sign * bound * (after - at)
                    if cuts == 0:
                        x1, u1 = at, u
                    elif at < x1:
                        x1, u1, x2, u2 = at, u, x1, u1
                    else:
                        x2, u2 = at, u
                    cuts += 1
    for part in range(cuts + 1):
        low, at_low = (start, left) if part == 0 else (x1, u1) if part == 1 else (x2, u2)
        high, at_high = (stop, right) if part == cuts else (x1, u1) if part == 0 else (x2, u2)
        if not (high > low or endless):
            continue
        side, end_low, end_high = 0, at_low, at_high
        if not endless:
            trial, limit = 0.5 * (at_low + at_high), bound * (after - 0.5 * (low + high))
            if not abs(trial) < limit * (1.0 - BOUND_TOLERANCE):
                side = 1 if trial > 0.0 else -1
                end_low, end_high = side * (bound * (after - low)), side * (bound * (after - high))
        top = _joined(stack, top, dragged, low, high, end_low, end_high, side)
        if not summed:
            continue
        width, sums = high - low, moments(table, low, high)
        if came:
            work += _product(width, sums, at_low, at_high, 0.5 * end_low, 0.5 * end_high)
        elif change != 0.0:
            work += _product(width, sums, change, change, at_low - half, at_high - half)
        if side != 0:
            ends = (side * end_low, side * end_high)
            slid = (max(side * at_low - ends[0], 0.0), max(side * at_high - ends[1], 0.0))
            loss, less = _slid(width, sums, slid, ends, side * change, bound * rise, came)
            lost += loss
            work -= less
    return top, lost, work


def _leave(
    cells: tuple[SlipStack, Any, float, bool],
    step: tuple[float, float, float],
    before: float,
    springs: tuple[float, float, float, float],
) -> tuple[Any, Any]:
    """Let springs go: they slide back until nothing presses them, or fall back at once if nothing slides."""
    _, table, bound, _ = cells
    _, rise, change = step
    start, stop, left, right = springs
    per = change / rise
    begin, end = (start - before) * per, (stop - before) * per
    # displaced by so much when they lose contact, had they stuck until then
    left, right = left + begin, right + end
    sums, lost = moments(table, start, stop), 0.0
    work = _product(stop - start, sums, begin, end, left - 0.5 * begin, right - 0.5 * end)
    if math.isinf(bound):
        return _product(stop - start, sums, left, right, 0.5 * left, 0.5 * right), work
    turns = left * right < 0.0
    middle = start + (stop - start) * (left / (left - right)) if turns else stop
    for part in range(2 if turns else 1):
        low, at_low = (start, left) if part == 0 else (middle, 0.0)
        high, at_high = (middle, 0.0) if turns and part == 0 else (stop, right)
        if high > low:
            side = 1 if at_low + at_high > 0.0 else -1
            slid = (max(side * at_low, 0.0), max(side * at_high, 0.0))
            part_sums = moments(table, low, high)
            loss, less = _slid(high - low, part_sums, slid, (0.0, 0.0), side * change, bound * rise, False)
            lost += loss
            work -= less
    return lost, work


def move(
    stack: SlipStack, table: Any, bound: float, state: SlipState, depth: float, change: float, summed: bool
) -> tuple[int, float, float, Any, Any]:
    """Go a straight step in depth and shift.

    Parameters
    ----------
    stack : SlipStack
    table
        As of `SlipCells`; of no matter unless energies are `summed`.
    bound : float
        beta = mu E* / G* [-]: a spring of gap gamma slides at u_t = beta (d - gamma); infinite if none ever does.
    state : SlipState
    depth, change : float
        d at the end, and by how much the bodies shift [m].
    summed : bool
        Whether energies are.

    Returns
    -------
    top, dragged, depth, lost, work
        As of `SlipState`, and what sliding has cost, and what the bodies have spent [J], over the ratio of stiffnesses.
    """
    if 0.0 < depth < LEAST_DEPTH:
        depth = 0.0
    before, dragged = state.depth, state.dragged
    common, pulled = max(min(before, depth), 0.0), dragged + change
    sticking = bound * (1.0 - BOUND_TOLERANCE)
    last, ring = -1, state.top
    while ring >= 0:
        start, stop = stack.start[ring], stack.stop[ring]
        if (
            stack.stuck[ring]
            and stop <= common
            and abs(stack.right[ring] + pulled) < sticking * (depth - stop)
            and abs(stack.left[ring] + pulled) < sticking * (depth - start)
        ):
            break
        stack.outer[ring] = last
        last, ring = ring, stack.inner[ring]
    piece, top, base = last, ring, pulled if ring >= 0 else 0.0
    cells, step = (stack, table, bound, summed), (depth, depth - before, change)
    lost, work = 0.0, 0.0
    came = False
    while not came:
        came = piece < 0
        if came:
            # springs that come into contact within the step take part in what is left of it
            start, stop, at = common, max(depth, common), max(depth, common)
            left, right = 0.0, 0.0
            first, end = (depth - common) * change / (depth - before) if stop > start else 0.0, 0.0
        else:
            start, stop = stack.start[piece], stack.stop[piece]
            left, right = stack.left[piece] + dragged, stack.right[piece] + dragged
            at = min(stop, max(start, common))
            middle = right if at == stop else left
            if start < at < stop:
                middle = left + (right - left) * ((at - start) / (stop - start))
            first, end, left, piece = left + change, middle + change, middle, stack.outer[piece]
        if at > start:
            top, loss, spent = _drag(cells, step, (top, base), (start, at, first, end), came)
            lost += loss
            work += spent
        if at < stop and summed:
            loss, spent = _leave(cells, step, before, (at, stop, left, right))
            lost += loss
            work += spent
    if ring >= 0 and summed:  # springs that stick as a whole resist evenly
        zeroth, first_moment, _ = within(stack, table, ring)
        work += change * (first_moment + (stack.axis[ring] + dragged + 0.5 * change) * zeroth)
    return top, base, depth, lost, work


def within(stack: SlipStack, table: Any, top: int) -> tuple[Any, Any, Any]:
    """Return the sums of 1 [N/m], of u_t [N] and of u_t^2 [J] over a stack, u_t counted from that on the axis."""
    last, ring = -1, top
    while ring >= 0 and not stack.known[ring]:
        stack.outer[ring] = last
        last, ring = ring, stack.inner[ring]
    zeroth, first, second = 0.0, 0.0, 0.0
    if ring >= 0:
        zeroth, first, second = stack.zeroth[ring], stack.first[ring], stack.second[ring]
    while last >= 0:
        ring, last = last, stack.outer[last]
        start, stop, right = stack.start[ring], stack.stop[ring], stack.right[ring]
        sums = moments(table, start, stop)
        slope, end = (stack.left[ring] - right) / (stop - start), right - stack.axis[ring]
        zeroth = zeroth + sums[0]
        first = first + (end * sums[0] + slope * sums[1])
        second = second + (end * end * sums[0] + slope * (2.0 * end * sums[1] + slope * sums[2]))
        stack.zeroth[ring], stack.first[ring], stack.second[ring], stack.known[ring] = zeroth, first, second, 1
    return zeroth, first, second


def shear(stack: SlipStack, table: Any, top: int, dragged: float) -> float:
    """Return the integral of u_t dK [N]: the shear force over the ratio."""
    zeroth, first, _ = within(stack, table, top)
    total: float = first + (stack.axis[top] + dragged) * zeroth if top >= 0 else 0.0
    return total


def stored(stack: SlipStack, table: Any, top: int, dragged: float) -> float:
    """Return half the integral of u_t^2 dK [J]: the stored energy over the ratio."""
    zeroth, first, second = within(stack, table, top)
    middle = stack.axis[top] + dragged if top >= 0 else 0.0
    energy: float = 0.5 * (second + middle * (2.0 * first + middle * zeroth))
    return energy


def _stiffness(stack: SlipStack, table: Any, top: int, depth: float, before: float) -> float:
    """Return how the shear force after a step from a depth grows with the shift of that step, over the ratio [N/m].

    The stack has been summed up (`within`).
    """
    common, total, ring = max(min(before, depth), 0.0), 0.0, top
    while ring >= 0 and not (stack.stuck[ring] and stack.stop[ring] <= common):
        start, stop, inner = stack.start[ring], stack.stop[ring], stack.inner[ring]
        if stack.side[ring] == 0 and stop <= common:
            total += stack.zeroth[ring] - (stack.zeroth[inner] if inner >= 0 else 0.0)
        elif stack.side[ring] == 0:
            if start < common:
                total += moments(table, start, common)[0]
            # springs that came within the step take part in what was left of it
            sums = moments(table, max(start, common), stop)
            total += (sums[0] * (depth - stop) + sums[1]) / (depth - before)
        ring = inner
    return total + (stack.zeroth[ring] if ring >= 0 else 0.0)


def _steady_shift(cells: SlipCells, state: SlipState, more: float) -> float:
    r"""Return the shift that adds a shear force over the ratio [N], under a steady depth.

    Where slip comes from a gap in to another one, the bodies shift by what the springs lacked to their bound, and
    all within takes part: :math:`\int K\,\mathrm d\gamma=F` of the frictionless contact, times the slope of that lack.
    """
    stack, table, side = cells.stack, cells.table, 1.0 if more > 0.0 else -1.0
    rest, shift, front, ring = abs(more), 0.0, state.depth, state.top
    edge = normal_at(table, front)
    force = edge[1]
    while ring >= 0:
        start, span = stack.start[ring], stack.stop[ring] - stack.start[ring]
        rate, inner = cells.bound + side * (stack.right[ring] - stack.left[ring]) / span, normal_at(table, start)[1]
        if rate > 0.0 and rate * (force - inner) >= rest:
            sought, low, gap, high = force - rest / rate, start, front, front
            # of a power of the depth it is the root
            front = state.depth * max(sought / edge[1], 0.0) ** (edge[1] / (edge[0] * state.depth))
            for _ in range(MOST_ROOT_STEPS):
                gap = min(max(front, low), high)
                here = normal_at(table, gap)
                front = gap - (here[1] - sought) / here[0] if here[0] > 0.0 else gap
                if abs(here[1] - sought) <= FORCE_TOLERANCE * edge[1]:
                    break
            shift += rate * (high - gap)
            break
        rest, shift, force, front = rest - rate * (force - inner), shift + rate * (front - start), inner, start
        ring = stack.inner[ring]
    return side * shift


def slip_step(cells: SlipCells, state: SlipState, goal: SlipGoal) -> Reached[SlipState]:
    """Return the springs after a step that is straight in depth and shift, to a shift or to a shear force.

    Of the shifts under which all slides it is the smallest.
    """
    stack, table, bound, ratio = cells.stack, cells.table, cells.bound, cells.ratio
    depth, target, before = goal.depth, goal.along, state.depth
    change, most, end, found, steady = target - state.shift, 0.0, 0.0, cells.driven, False
    if not cells.driven:
        force = normal_at(table, depth)[1] if depth > 0.0 else 0.0
        most = cells.coefficient * force if force > 0.0 else 0.0
        if abs(target) > most * (1.0 + SLIDING_TOLERANCE):
            refuse(abs(target), most)
        change, found = 0.0, depth <= 0.0
        steady = depth == before and not (found or math.isinf(bound))
        # no spring is displaced by more than its bound
        end = 2.0 * bound * (max(depth, abs(depth - before)) + max(before, 0.0))
        if not found and abs(target) >= most * (1.0 - FORCE_TOLERANCE) and not math.isinf(bound):
            # what a spring lacks to its bound falls with its gap: the one on the axis is the last, or those that come
            side = 1.0 if target > 0.0 else -1.0
            axis = stack.axis[state.top] + state.dragged if state.top >= 0 else 0.0
            change, found = side * max(bound * depth - side * axis, bound * (depth - before), 0.0), True
        elif steady:
            change = _steady_shift(cells, state, target / ratio - shear(stack, table, state.top, state.dragged))
    low, high, short = -end, end, 0.0
    for _ in range(MOST_NEWTON_STEPS + 2):
        top, dragged, after, lost, work = move(stack, table, bound, state, depth, change, found or steady)
        if not found:
            short = target - ratio * shear(stack, table, top, dragged)
        if found or (steady and abs(short) <= FORCE_TOLERANCE * most):
            shift = target if cells.driven else state.shift + change
            return Reached(SlipState(top, dragged, after, shift), ratio * work, max(ratio * lost, 0.0))
        slope = ratio * _stiffness(stack, table, top, after, before)
        if math.isinf(bound):
            change, found = short / slope, True
        elif abs(short) <= FORCE_TOLERANCE * most or high - low <= FORCE_TOLERANCE * end:
            found = True
        else:
            low, high = (change, high) if short > 0.0 else (low, change)
            following = change + short / slope if slope > 0.0 else math.inf
            change = following if low < following < high else 0.5 * (low + high)
    missed(target, abs(short))
    return Reached(state, 0.0, 0.0)


def _beyond(stack: SlipStack, top: int, other: int) -> int:
    """Return the innermost of the pieces of a stack that are not pieces of another one; -1 for none."""
    last = -1
    while top != other and top >= 0:
        if other < 0 or stack.count[top] >= stack.count[other]:
            stack.outer[top] = last
            last, top = top, stack.inner[top]
        else:
            other = stack.inner[other]
    return last


def _displaced(stack: SlipStack, ring: int, state: SlipState, gap: float) -> float:
    """Return u_t of a spring at the edge of pieces, from an inner one outwards [m]; zero outside of the contact."""
    if ring < 0 or gap > state.depth:
        return 0.0
    while stack.outer[ring] >= 0 and stack.stop[ring] <= gap:
        ring = stack.outer[ring]
    share = (gap - stack.start[ring]) / (stack.stop[ring] - stack.start[ring])
    u: float = stack.left[ring] * (1.0 - share) + stack.right[ring] * share + state.dragged
    return u


def slip_apart(cells: SlipCells, one: Reached[SlipState], two: Reached[SlipState]) -> float:
    """Return by how much displacements and energies differ, over a small part of those on the path."""
    stack, here, there = cells.stack, one.state, two.state
    ours, theirs = _beyond(stack, here.top, there.top), _beyond(stack, there.top, here.top)
    most = abs(here.shift - there.shift)
    for pieces in (ours, theirs):
        ring = pieces
        while ring >= 0:
            for gap in (stack.start[ring], stack.stop[ring]):
                apart = _displaced(stack, ours, here, gap) - _displaced(stack, theirs, there, gap)
                most = max(most, abs(apart))
            ring = stack.outer[ring]
    # springs that all slide in the end forget how they came there, what it has cost does not
    return max(over(most, cells.near), over(abs(one.lost - two.lost), cells.cheap))


def settled(stack: SlipStack, top: int, mark: int) -> int:
    """Return a stack of which the pieces from a number on have moved there, all others of them being forgotten."""
    last = -1
    while top >= mark:
        stack.outer[top] = last
        last, top = top, stack.inner[top]
    while last >= 0:
        old, last = last, stack.outer[last]
        for column in stack_numbers(stack):
            column[mark] = column[old]
        for whole in stack_wholes(stack):
            whole[mark] = whole[old]
        stack.inner[mark] = top
        top, mark = mark, mark + 1
    stack.used[0] = mark
    return top


def stack_numbers(stack: SlipStack) -> tuple[Any, ...]:
    """Return the columns of a stack that hold numbers."""
    return (
        stack.start, stack.stop, stack.left, stack.right, stack.axis, stack.zeroth, stack.first, stack.second,
    )  # fmt: skip


def stack_wholes(stack: SlipStack) -> tuple[Any, ...]:
    """Return the columns of a stack that hold whole numbers."""
    return stack.side, stack.count, stack.stuck, stack.known


def moments(table: Any, start: float, stop: float) -> Moments:
    """Return the sums of 1 [N/m], of stop - gap [N] and of its square [J] over the springs between two gaps."""
    sums: Moments = table.ring(start, stop)
    return sums


def normal_at(table: Any, depth: float) -> Moments:
    """Return K [N/m], F [N] and W [J] at a depth [m]."""
    sums: Moments = table.at(depth)
    return sums


def make_room(stack: SlipStack) -> None:
    """Make room for more pieces."""
    for column in stack[:-1]:
        column.extend([0] * ROOM)


def refuse(force: float, most: float) -> None:
    """Refuse a shear force [N] above the friction limit [N]."""
    raise OutsideValidity(
        f"a shear force of {force:.6g} N is prescribed, but the friction limit is {most:.6g} N, and the bodies "
        "would slide away; give a smaller one, or a Shift."
    )


def missed(target: float, short: float) -> None:
    """Refuse a shear force [N] that is not met by as much [N]."""
    raise NotConverged(f"a shear force of {target:.6g} N is missed by {short:.3g} N; give more points.")
