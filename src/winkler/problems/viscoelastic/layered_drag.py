r"""Contacts on layers that relax each by a law of its own, pressed and dragged with friction: cells in both directions.

What is left of springs along the surface, as across it, is a line load whose waves move by a creep of their own
(`winkler.media.relaxing.layered`),

.. math:: q(x) = 2\int_x^a\frac{r\,\tau(r)}{\sqrt{r^2-x^2}}\,\mathrm dr \quad\text{of a push,}\qquad
          q(x) = 2x\int_x^a\frac{\tau(r)}{\sqrt{r^2-x^2}}\,\mathrm dr \quad\text{of a twist,}

and what turns or moves as a rigid disc has :math:`u = 2\varphi x` or :math:`u = U`.  Where rings slide up to the edge,
tractions are :math:`\mu p`, so that cells of a push bear :math:`\mu q_z`, and those of a twist

.. math:: b(x) = -\frac{2\mu}{\pi}\int_x^a q_z'(s)\,\frac xs\,K\!\left(\sqrt{1-x^2/s^2}\right)\mathrm ds .

A cell sticks where it stands while it bears less.  Each step of time is that of elastic cells which the earlier loads
have displaced already (`winkler.numerics.surfaces.strip_grid`).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Angle, Depth, Force, Shift
from winkler.loading.path import Path
from winkler.media.layered.pair_response import Mode
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.springs.coupled_cells import CoupledCells, LoadedCells
from winkler.numerics.surfaces.strip_grid import StuckStrip, strip_step
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.layered_march import LayeredMarch, MarchedPoint, TooNarrow, cells_of
from winkler.problems.viscoelastic.layered_path import MOST_WIDENINGS, WIDENED, contact_reach
from winkler.values.errors import NotConverged, OutsideValidity

STEPS, LEAST_STEPS, FIRST_SPAN = 48, 12, 0.1
"""Steps over a change of a load by its greatest value, between two points at least, and the first over the shortest
time of the creep."""
NODES = 6
ROUNDING = 1e-12
NO_SLIP = 1e12
"""A coefficient of friction under which nothing slides."""
SLIDING_TOLERANCE = 1e-9
"""A force beyond what friction bears by no more than this part of it is that of sliding."""


class DraggedLayers(NamedTuple):
    """The cells at one moment.

    Parameters
    ----------
    pressed
        Across the surface.
    dragged
        Along it, or around its axis.
    motion, load
        Shift [m] or angle [rad], and shear force [N] or torque [N m].
    ahead, rate
        How far the second body is ahead of each cell, as the motion ``(n,)``, and how fast it came so.
    bounds, slips
        Greatest load of the cells ``(n,)`` [N/m], and to which side they slip, 0 where they stick.
    friction, bulk, work
        Lost to friction, lost in the bodies by what drags, and spent by the motion [J].
    """

    pressed: MarchedPoint
    dragged: LoadedCells
    motion: float
    load: float
    ahead: Array
    rate: Array
    bounds: Array
    slips: Array
    friction: float
    bulk: float
    work: float


class LayeredDrag:
    """Cells that are carried along a path.

    Parameters
    ----------
    owner : str
        Kind of problem, for messages.
    bed : Bed
        On a medium `RelaxingByWaves`.
    friction : float
        mu [-].
    twisted : bool
        Whether the bodies turn about the axis.
    reach : float
        Up to which radius cells lie [m].
    count : int
        How many.
    tolerance : float
        Of the depth or force in a step, over the greatest so far.
    """

    def __init__(
        self, owner: str, bed: Bed, friction: float, *, twisted: bool, reach: float, count: int, tolerance: float
    ) -> None:
        assert offers(bed.medium, RelaxingByWaves)
        self.owner, self.bed, self.friction, self.twisted = owner, bed, min(friction, NO_SLIP), twisted
        self.cells = cells_of(bed, reach, count)
        width, self.place = self.cells.width, self.cells.middle
        creep = bed.medium.creep_of_waves(width, reach, Mode.ACROSS if twisted else Mode.TANGENTIAL)
        self.along = CoupledCells(creep.kernels(count, width), creep.times, width, np.zeros(count), odd=twisted)
        self.arm = 2.0 * self.place if twisted else np.ones(count)
        """Displacement of the cells over the motion of a rigid disc."""
        self.weights = 2.0 * width * self.arm
        self.shares = _twist_shares(self.place) if twisted else None
        self.march = LayeredMarch(owner, bed, self.cells, tolerance)
        self._grids: dict[float, StuckStrip] = {}

    def begin(self, time: float) -> DraggedLayers:
        """Return cells that nothing has pressed, from a time [s] on."""
        none = np.zeros(self.place.size)
        self.march.time = time
        rest = MarchedPoint(time, self.cells.at_rest, 0.0, 0.0, 0.0)
        return DraggedLayers(rest, self.along.at_rest, 0.0, 0.0, none, none, none, none, 0.0, 0.0, 0.0)

    def stored(self, state: DraggedLayers) -> float:
        """Return the energy that cells store in both directions [J]."""
        return state.pressed.stored + self.along.stored(state.dragged)

    def pushed(
        self, state: DraggedLayers, point: MarchedPoint, span: float, goal: float, *, by_force: bool
    ) -> DraggedLayers:
        """Return the cells after a time [s], pressed as they are at its end, and moved as far or as hard as a goal."""
        held, before = point.state.load, state.dragged.load
        bounds = self.friction * (held if self.shares is None else self.shares @ held)
        bounds = np.asarray(np.where(held > 0.0, np.maximum(bounds, 0.0), 0.0))
        touches = bounds > 0.0
        carried = self.along.carried(state.dragged, span) / self.arm
        met = self._met(state, point, span, touches)
        limit = float(self.weights @ bounds)
        if by_force and abs(goal) > limit * (1.0 + SLIDING_TOLERANCE):
            raise OutsideValidity(
                f"{self.owner}: {goal:.6g} {'N m' if self.twisted else 'N'} are prescribed at {point.time:.6g} s, but "
                f"friction carries {limit:.6g} at most, and the bodies would slide away; give less."
            )
        grid = self._grid(span)
        if not touches.any():
            none: Array = np.zeros(bounds.size)
            load, slips, moved = none, none, none
            motion = state.motion if by_force else goal
        elif by_force and abs(goal) >= limit * (1.0 - ROUNDING):
            side = math.copysign(1.0, goal)
            load, slips = side * bounds, side * touches
            moved = grid.compliance @ load
            motion = float(side * np.max(side * (moved + met + carried), where=touches, initial=-math.inf))
        else:
            given = {"total": goal} if by_force else {"shift": goal}
            load, slips, motion, moved = strip_step(
                grid, -met - carried, bounds, state.slips, rounding=ROUNDING, **given
            )
        ahead = np.where(touches & (slips == 0.0), met, motion - moved - carried)
        dragged = self.along.loaded(state.dragged, span, load)
        borne = float(self.weights @ load)
        return DraggedLayers(
            point, dragged, motion, borne, ahead, (ahead - state.ahead) / span if span > 0.0 else 0.0 * ahead, bounds,
            slips,
            state.friction + 0.5 * float((self.weights * (before + load)) @ (ahead - state.ahead)),
            state.bulk + self.along.lost(state.dragged, dragged, span),
            state.work + 0.5 * (state.load + borne) * (motion - state.motion),
        )  # fmt: skip

    def stiffness(self, held: int, frequency: float) -> complex:
        """Return the stiffness of so many cells that stick at an angular frequency [rad/s], in N/m or N m."""
        cells = self.along
        kernel = cells.kernels[0] + (1.0 / (1.0 + 1j * frequency * cells.times)) @ cells.kernels[1:]
        sides = np.asarray(cells.width * self.arm[:held], dtype=complex)
        return complex(2.0 * sides @ np.linalg.solve(cells.matrix(kernel)[:held, :held], sides))

    def _met(self, state: DraggedLayers, point: MarchedPoint, span: float, touches: Array) -> Array:
        """Return how far the second body is ahead, of cells that come into contact as when its edge reaches them."""
        came = touches & (state.bounds == 0.0)
        start, end = state.pressed.state.radius, point.state.radius
        if not came.any() or end <= start:
            return state.ahead
        gone = np.clip((self.place - start) / (end - start), 0.0, 1.0)
        return np.where(came, state.ahead + gone * span * state.rate, state.ahead)

    def _grid(self, span: float) -> StuckStrip:
        key = float(f"{span:.9e}")
        if key not in self._grids:
            if len(self._grids) > 12:
                self._grids.pop(next(iter(self._grids)))
            self._grids[key] = StuckStrip(self.along.effective(span) / self.arm[:, None], self.weights)
        return self._grids[key]

    def steps(self, start: float, end: float, size: float) -> Array:
        """Return when steps end that lead from one time [s] to another and change loads by a size [-]."""
        if end == start:
            return np.array([end])
        count = max(math.ceil(STEPS * size), LEAST_STEPS)
        shares = np.arange(1, count + 1) / count
        first = FIRST_SPAN * float(min(self.cells.times[0], self.along.times[0])) / (end - start)
        growing = 0.25 ** np.arange(1.0, 0.5 * max(math.log2(1.0 / first), 0.0) + 1.0)
        shares = np.union1d(shares, growing[growing < shares[0]])
        return np.append(start + (end - start) * shares[:-1], end)


def refuse_unknown_waves(bed: Bed, *, twisted: bool) -> None:
    """Refuse layers whose answer to a push, or a twist, is not known.

    Raises
    ------
    OutsideValidity
    """
    medium: Any = bed.medium
    medium.loaded_waves(Mode.ACROSS if twisted else Mode.TANGENTIAL, np.zeros(1, dtype=complex), np.ones(1))


def dragged_layers(
    owner: str, bed: Bed, law: Coulomb, path: Path, count: int, tolerance: float
) -> Iterator[tuple[LayeredDrag, DraggedLayers]]:
    """Yield the cells at every point of a path.

    Raises
    ------
    OutsideValidity
        If friction does not bear a prescribed force, or the contact is no disc, at that step.
    NotConverged
        If the contact grows without end.
    """
    most = np.maximum(np.max(np.abs([path.across, path.along]), axis=1), 1e-300)
    normal: Any = path.normal
    reach, done = contact_reach(owner, bed, normal, float(np.max(path.across))), 0
    twisted = owner == "Torsion"
    for _ in range(MOST_WIDENINGS):
        row = LayeredDrag(owner, bed, law.coefficient, twisted=twisted, reach=reach, count=count, tolerance=tolerance)
        try:
            for i, state in enumerate(_along(row, path, most)):
                if i >= done:
                    done += 1
                    yield row, state
            return
        except TooNarrow:
            reach *= WIDENED
    raise NotConverged(f"{owner}: the contact grows without end; press less, or end the path before.")


def _along(row: LayeredDrag, path: Path, most: Array) -> Iterator[DraggedLayers]:
    """Yield the cells at every point of a path whose greatest loads are given."""
    normal: Any = Depth(0.0) if isinstance(path.normal, Depth) else Force(0.0)
    by_force = not isinstance(path.lateral, Shift | Angle)
    state, before = row.begin(float(path.time[0])), np.zeros(2)
    for i, (time, *goal) in enumerate(zip(path.time.tolist(), path.across.tolist(), path.along.tolist(), strict=True)):
        start, after = float(path.time[max(i - 1, 0)]), np.array(goal)
        if time == start:  # what comes suddenly presses first
            point = row.march.go(time, normal, before[0], after[0])
            state = row.pushed(state, point, 0.0, before[1], by_force=by_force and before[1] == 0.0)
            state = row.pushed(state, point, 0.0, after[1], by_force=by_force)
        else:
            last = before
            for now in row.steps(start, time, float(np.max(np.abs(after - before) / most))).tolist():
                share = (now - start) / (time - start)
                at = before + share * (after - before) if now < time else after
                point = row.march.go(now, normal, float(last[0]), float(at[0]))
                span = now - state.pressed.time
                state, last = row.pushed(state, point, span, float(at[1]), by_force=by_force), at
        before = after
        yield state


def _twist_shares(place: Array) -> Array:
    """Return what cells bear under a twist where all rings slide, over mu, by the line loads that press ``(n, n)``."""
    from scipy.special import ellipk

    node, weight = gauss_legendre(NODES)
    width = place[1] - place[0]
    s = place[:, None] + width * node  # between the middles of cells
    ratio = np.minimum(place[:, None, None] / s, 1.0)
    kernel = (ratio * ellipk(1.0 - ratio**2)) @ weight * (2.0 / math.pi)
    kernel = np.triu(kernel)  # of the slope over each interval, times its width
    return np.asarray(kernel - np.concatenate([np.zeros((place.size, 1)), kernel[:, :-1]], axis=1))
