r"""Force over the position of a machine, for a contact with or without adhesion.

Depth and force are explicit functions of the contact radius a, and so is the position of the machine

.. math:: D(a) = d(a) + F(a)/k_m .

Stable are the branches on which D rises.  An advancing contact follows the first of them that reaches D, a receding one
the last; at the end of a branch it jumps to the next.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.elastic.reach import kinks_between, machine_curves, radius_range
from winkler.fitting.elastic.rising import RadiusTable, RisingBranch, tabulated
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import EdgeStates

MOST_RELATIVE_SLOPE = 100.0
"""Greatest slope of a force relative to the stiffness with a pinned edge; it diverges at the end of a branch.

Beyond it the force is continued linearly, so that a fit meets no kink.  In the last part of 1e-4 before pull-off the
force is wrong by up to a hundredth."""
HALVED_STEPS = 0.5 ** np.arange(1.0, 40.0)
NEGLIGIBLE_RADIUS_SHARE = 1e-2
"""Contact radius below which a contact is negligible, relative to the widest."""
PULL_TOLERANCE = 1e-9


class ResponseValues(NamedTuple):
    """Forces [N] at positions, what they change by per length [N/m], and the contact radii [m].

    `balanced` is 1 where the edge is in equilibrium, 0 where it is pinned: at an end, or beyond a limit.
    """

    force: Array
    slope: Array
    radius: Array
    balanced: Array


class Continuation(NamedTuple):
    """Linear continuation of a force below the position `level` [m], from `force` [N] with `slope` [N/m]."""

    level: float
    force: float
    slope: float


class MachineResponse(NamedTuple):
    """Response of a contact to its machine.

    Parameters
    ----------
    table : RadiusTable
        D [m] and F [N] over the contact radius.
    end : tuple of float
        D [m], F [N], dF/dD [N/m] and a [m] at the last radius; where the profile ends, the contact is pinned there.
    held : tuple of Continuation
        Continuation of each branch below its start.
    """

    table: RadiusTable
    end: tuple[float, float, float, float]
    held: tuple[Continuation, ...]

    def loss(self) -> tuple[float, float]:
        """Return D [m] and F [N] at pull-off of a receding contact."""
        if not self.table.pieces:
            return self.end[0], self.end[1]
        first = min(self.table.pieces, key=lambda piece: float(piece.levels[0]))
        return float(first.levels[0]), float(self.table.read(self.table.start(first))[0][0])

    def least(self) -> float:
        """Return the least force of all stable states [N], at the greatest tension."""
        table = self.table
        forces = [float(table.read(table.places(piece.places))[0].min()) for piece in table.pieces]
        return min(forces, default=self.end[1])

    def closing(self, position: Array) -> ResponseValues:
        """Return the response of an advancing contact: the narrowest of several states."""
        return self.on(self.narrowest(position), position)

    def opening(self, position: Array, turn: float) -> ResponseValues:
        """Return the response of a receding contact that turned at `turn` [m]: the widest of several states."""
        return self.on(self.widest(position, turn), position)

    def narrowest(self, position: Array) -> Array:
        """Return the index of the branch of an advancing contact."""
        return np.searchsorted(self._tops(), position, side="right")

    def widest(self, position: Array, turn: float) -> Array:
        """Return the index of the branch of a receding contact that turned at the position `turn`."""
        bottoms = np.array([piece.levels[0] for piece in self.table.pieces])
        reached = int(np.searchsorted(self._tops(), turn, side="right"))
        bottoms = bottoms[: reached + 1]
        holds = bottoms <= position[:, None]
        which = np.zeros(position.shape, dtype=int)
        if bottoms.size:
            which = np.where(holds.any(axis=1), bottoms.size - 1 - np.argmax(holds[:, ::-1], axis=1), 0)
        if reached >= len(self.table.pieces):
            which = np.where(position > self.end[0], len(self.table.pieces), which)
        return which

    def _tops(self) -> Array:
        return np.maximum.accumulate(np.array([piece.levels[-1] for piece in self.table.pieces]))

    def on(self, which: Array, position: Array) -> ResponseValues:
        """Return the response on branches given by index; past the last one that of the pinned contact."""
        columns = np.empty((4, position.size))
        for index in np.flatnonzero(np.bincount(which)):
            own_points = which == index
            columns[:, own_points] = self._on(int(index), position[own_points])
        return ResponseValues(*columns)

    def _on(self, index: int, position: Array) -> ResponseValues:
        """Return the response on one branch, with its continuation below."""
        level, force, stiffness, radius = self.end
        if index >= len(self.table.pieces):
            constants = np.full(position.shape, stiffness), np.full(position.shape, radius), np.zeros(position.shape)
            return ResponseValues(force + stiffness * (position - level), *constants)
        piece, held = self.table.pieces[index], self.held[index]
        above_start = position > piece.levels[0]
        columns = np.empty((4, position.size))
        columns[:, ~above_start] = self.table.radius(self.table.start(piece))
        places = self.table.where(piece, np.minimum(position[above_start], piece.levels[-1]))
        forces, slopes = self.table.read(places)
        slopes = np.clip(slopes, -MOST_RELATIVE_SLOPE * stiffness, MOST_RELATIVE_SLOPE * stiffness)
        columns[:, above_start] = forces, slopes, self.table.radius(places), np.ones(forces.shape)
        below = (position < held.level) | ~above_start
        columns[0, below] = held.force + held.slope * (position[below] - held.level)
        columns[1, below] = held.slope
        columns[3, below | (position > piece.levels[-1])] = 0.0
        return ResponseValues(*columns)


def response(states: EdgeStates, compliance: float, highest: float) -> MachineResponse:
    """Return the response of a contact to a machine, up to a position.

    Parameters
    ----------
    states : EdgeStates
        The bed and its attraction.
    compliance : float
        1/k_m [m/N].
    highest : float
        The largest requested position D, from first touch [m].

    Raises
    ------
    OutsideValidity
        If the contact closes without end before.
    """
    low, high = radius_range(states, compliance, highest)
    if high > low:
        table = tabulated(machine_curves(states, compliance), low, high, kinks_between(states.bed, low, high))
    else:
        nothing = np.zeros(0)
        table = RadiusTable(nothing, nothing, nothing, np.zeros((1, 2, 0)), ())
    return of_table(table, states, compliance, end_at(states, compliance, high))


def end_at(states: EdgeStates, compliance: float, high: float) -> tuple[float, float, float, float]:
    """Return D [m], F [N], dF/dD [N/m] of a pinned contact, and a [m] at a radius."""
    place = np.array([high])
    level, force = (float(column[0]) for column in machine_curves(states, compliance)(place))
    stiffness = float(states.bed.stiffness(place)[0])
    return level, force, stiffness / (1.0 + compliance * stiffness), high


def of_table(
    table: RadiusTable, states: EdgeStates, compliance: float, end: tuple[float, float, float, float]
) -> MachineResponse:
    """Return the response of states that are tabulated up to an end (see `MachineResponse`)."""
    held = tuple(_held(table, piece, states, compliance, end[2]) for piece in table.pieces)
    return MachineResponse(table, end, held)


def _held(
    table: RadiusTable, piece: RisingBranch, states: EdgeStates, compliance: float, widest: float
) -> Continuation:
    """Return the continuation of the force of a branch."""
    start = table.start(piece)
    radius = table.radius(start)
    if states.from_nothing() and radius[0] <= NEGLIGIBLE_RADIUS_SHARE * table.right[-1]:
        pull = float(table.read(start)[0][0])
        # without attraction the force is constant below; with it, a constant force would never end the contact
        pressed = float(table.read(table.where(piece, piece.levels[-1:]))[0][0])
        attracted = pull < -PULL_TOLERANCE * abs(pressed)
        return Continuation(float(piece.levels[0]), pull, widest if attracted else 0.0)
    stiffness = float(states.bed.stiffness(radius)[0])
    steepest = MOST_RELATIVE_SLOPE * stiffness / (1.0 + compliance * stiffness)
    steps = (piece.places[-1] - piece.places[0]) * HALVED_STEPS
    slopes = np.abs(table.read(table.places(piece.places[0] + steps))[1])
    steep = int(np.argmax(slopes > steepest)) if np.any(slopes > steepest) else steps.size - 1
    # D rises like the square of the distance from its least value, so the slope falls like its inverse
    distance = min(float(steps[steep]) * float(slopes[steep]) / steepest, float(piece.places[-1] - piece.places[0]))
    transition = table.places(piece.places[:1] + distance)
    force, slope = table.read(transition)
    return Continuation(float(table.level(transition)[0]), float(force[0]), float(slope[0]))
