r"""Cylinders that roll steadily on half-planes or layers: pressure, traction and slip of the strip, node by node.

Within the strip the slope of the gap and the slip over the speed of rolling are (Bentall and Johnson)

.. math:: \frac{x-m}R = \int N(x-s)\,p(s)\,\mathrm ds - \int C(x-s)\,q(s)\,\mathrm ds , \qquad
          s(x) = \xi - \int A(x-s)\,q(s)\,\mathrm ds - \int C(x-s)\,p(s)\,\mathrm ds ,

with kernels of the bed (`LineBed.slopes`): on half-planes N is :math:`2/(\pi E^*x)`, A that of shear, and C the delta
function times :math:`2\beta/E^*`, with Dundurs' constant of the first body less the second.  Layers answer pressure,
shear and their coupling each in a manner of its own.  Bodies that are not coupled have C = 0, and the pressure of the
contact without friction.

Lengths are counted in the half-width of the strip: the pressure follows from the traction, with the middle m as one
unknown more, and the load gives the half-width, which on layers is searched for.  Pressure and traction are linear
between nodes that are dense at both edges, and both equations hold at the middles of the elements.  Where everything
sticks on half-planes,

.. math:: a^2 = \frac{4PR}{\pi E^*(1+4\eta^2)} , \qquad \xi = \frac{2\eta a}R , \qquad
          \eta = \frac{\operatorname{artanh}\beta}\pi .

Without friction to speak of all slips, and the free cylinder creeps by :math:`0.9140\,\beta a/R`.

References
----------
R. H. Bentall, K. L. Johnson, Int. J. Mech. Sci. 9 (1967) 389-404, doi:10.1016/0020-7403(67)90043-4
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.media.layered.wave_constants import Wave
from winkler.numerics.surfaces.strip_grid import first_to_stick
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

COUNT = 400
"""Elements of the strip."""
ALL_AT_ONCE, MOST_ROUNDS, MOST_WIDTHS = 30, 60, 60
"""Rounds in which all nodes change that are wrong, rounds in all, and widths that are tried under a creepage."""
ACCEPTED = 1e-5
"""Part of the load on nodes that break Coulomb's law, with which the search may end: zones of few edge elements."""
STEPS = (1, 4)
"""Steps in which the coupling is brought up from none."""
ELEMENT_ERROR, ZONE_ERROR = 5e-5, 3e-3
"""Of the creepage on all elements, and by the elements that stick: twice what random strips miss with finer ones."""
SLIP_LOSS, STICK_LOSS, LEAST_LOSS = 32.0, 6e-3, 1e-7
"""Of the loss over it, by the elements that slip squared and those that stick; over the load times a/R: likewise."""
ROUNDING, WIDE = 1e-12, 1e-10
"""Of nodes, and of the width that is searched for."""


class RolledStrip(NamedTuple):
    """The strip of cylinders that roll under one drive; lengths over a without friction, stresses over E*.

    Parameters
    ----------
    x, pressure, traction
        At the nodes ``(m,)``, ascending, with both edges: the leading edge is last.
    slip
        Over the speed of rolling, of the second surface over the first ``(m - 1,)``, in the middle of each element.
    slips
        -1, 0 or 1 where it slips backwards, sticks, slips forwards ``(m - 1,)``, of each element.
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
        """Width of the stick zone over that of the contact [-]."""
        return float(np.diff(self.x) @ (self.slips == 0.0)) / float(self.x[-1] - self.x[0])

    @property
    def loss(self) -> float:
        """What friction loses per distance rolled, over E* a, with the mean traction of each element."""
        mean = 0.5 * (self.traction[1:] + self.traction[:-1])
        return float(np.diff(self.x) @ np.abs(mean * self.slip))


def creepage_error(strip: RolledStrip) -> float:
    """Return the bound of the error of a creepage, over it or that of a free strip that sticks, if that is greater."""
    return ELEMENT_ERROR + ZONE_ERROR / max(1, int(np.count_nonzero(strip.slips == 0.0)))


def loss_error(strip: RolledStrip, slope: float) -> float:
    """Return the bound of the error of a loss, over E* a, under a slope a/R [-]."""
    sticking = int(np.count_nonzero(strip.slips == 0.0))
    slipping = strip.slips.size - sticking
    share = min(1.0, SLIP_LOSS / max(1, slipping) ** 2 + STICK_LOSS / max(1, sticking))
    return share * strip.loss + LEAST_LOSS * slope * float(np.trapezoid(strip.pressure, strip.x))


class _EdgeDenseGrid(NamedTuple):
    """A strip from -1 to 1: the equations at the middles of its elements, the unknowns at the nodes inside.

    Parameters
    ----------
    nodes, weights
        ``(n + 1,)``; widths of the nodes inside ``(n - 1,)``.
    normal, along, coupling
        Slopes at the middles by tractions at the nodes ``(n, n - 1)``, as of `LineBed.slopes`.
    alone, follows
        Pressure without traction ``(n - 1,)``, and by what a traction raises it ``(n - 1, n - 1)``.
    """

    nodes: Array
    weights: Array
    normal: Array
    along: Array
    coupling: Array
    alone: Array
    follows: Array


@functools.lru_cache(maxsize=8)
def _grid(bed: LineBed, half_width: float, coupled: bool, count: int) -> _EdgeDenseGrid:
    """Return the equations of a strip of this half-width [m], which half-planes do not feel."""
    nodes = -np.cos(np.pi * np.arange(count + 1) / count)
    widths, middles = np.diff(nodes), 0.5 * (nodes[1:] + nodes[:-1])
    scale = 1.0 if bed.hertzian else half_width
    normal, along = (bed.slopes(part, scale * nodes, scale * middles) for part in (Wave.NORMAL, Wave.ALONG))
    weights = 0.5 * (widths[1:] + widths[:-1])
    if not coupled:
        radius = bed.profile.curvature_radius  # type: ignore[attr-defined]
        alone = bed.pressure(half_width * nodes[1:-1], half_width, 0.0) * radius / (bed.medium.modulus * half_width)
        return _EdgeDenseGrid(nodes, weights, normal, along, np.zeros_like(along), alone, np.zeros((count - 1,) * 2))
    coupling = bed.slopes(Wave.COUPLING, scale * nodes, scale * middles)
    solved = np.linalg.solve(np.hstack([normal, -np.ones((count, 1))]), np.column_stack([middles, coupling]))[:-1]
    return _EdgeDenseGrid(nodes, weights, normal, along, coupling, solved[:, 0], solved[:, 1:])


class _UnitStrip(NamedTuple):
    """A strip from -1 to 1 with a slope of the gap of one: at nodes inside; slip at elements, the last one first."""

    traction: Array
    pressure: Array
    slip: Array
    slips: Array
    creepage: float


class _StripEquations:
    """The strip under one coefficient of friction and a part of the coupling.

    Of each element but the one at the trailing edge the node behind it sticks or slips as the element does.
    """

    def __init__(self, grid: _EdgeDenseGrid, part: float, friction: float) -> None:
        self.grid, self.friction = grid, friction
        self.follows = part * grid.follows
        self.passing = grid.along + part * grid.coupling @ self.follows
        self.drawn = -part * grid.coupling @ grid.alone

    def state(self, slips: Array, ratio: float | None, creepage: float) -> _UnitStrip:
        """Return the strip whose nodes stick or slip so, under a force of this part of the load or with a creepage."""
        grid, sticks = self.grid, slips == 0.0
        rubs = (slips * self.friction)[:, None]
        system = np.where(sticks[:, None], self.passing[1:], np.eye(slips.size) - rubs * self.follows)
        right = np.where(sticks, self.drawn[1:], rubs[:, 0] * grid.alone)
        if ratio is None:
            traction = np.linalg.solve(system, right + creepage * sticks)
        else:
            sums = grid.weights - ratio * (grid.weights @ self.follows)
            bordered = np.block([[system, -1.0 * sticks[:, None]], [sums[None, :], np.zeros((1, 1))]])
            *rest, creepage = np.linalg.solve(bordered, np.append(right, ratio * float(grid.weights @ grid.alone)))
            traction = np.array(rest)
        slip = creepage + self.drawn - self.passing @ traction
        slip[1:][sticks] = 0.0
        return _UnitStrip(traction, grid.alone + self.follows @ traction, slip, slips, float(creepage))

    def sliding(self, side: float) -> _UnitStrip:
        """Return the strip that slips everywhere to one side, with the least creepage at which it does."""
        slips = np.full(self.grid.alone.size, side)
        free = self.state(slips, None, 0.0)
        least = float(side * np.max(-side * free.slip[1:]))
        return free._replace(slip=free.slip + least, creepage=least)

    def settled(self, slips: Array, ratio: float | None, creepage: float) -> _UnitStrip | None:
        """Return the strip that obeys Coulomb's law, from a guess of what slips; None if it is not found."""
        least, best = math.inf, None
        for turn in range(MOST_ROUNDS):
            if ratio is not None and slips.all():
                slips = self._resting(slips, ratio)
            found = self.state(slips, ratio, creepage)
            load = float(self.grid.weights @ found.pressure)
            bound, slip = self.friction * found.pressure, found.slip[1:]
            allowed = np.maximum(bound, 0.0)
            broken = np.abs(found.traction - np.clip(found.traction + slip, -allowed, allowed))
            share = float(self.grid.weights @ broken) / (min(self.friction, 1.0) * load) if load > 0.0 else math.inf
            if share < least:
                least, best = share, found
            rounding = ROUNDING * float(np.max(np.abs(self.passing @ found.traction)))
            over = np.where(np.abs(found.traction) > bound * (1.0 + ROUNDING), np.sign(found.traction), 0.0)
            better = np.where(slips == 0.0, over, np.where(slip * slips < -rounding, 0.0, slips))
            wrong = np.flatnonzero(better != slips)
            if wrong.size == 0 and load > 0.0:
                return found
            if turn >= ALL_AT_ONCE and least < ACCEPTED:
                return best
            changed = wrong if turn < ALL_AT_ONCE else wrong[-1:]
            slips = slips.copy()
            slips[changed] = better[changed]
        return None

    def trailing(self, side: float, ratio: float | None, creepage: float) -> Array:
        """Return the strip that slips to one side from its trailing edge up to where friction bears the traction."""
        low, high = 0, self.grid.alone.size
        while high - low > 1:
            count = (low + high) // 2
            slips = np.where(np.arange(self.grid.alone.size) < count, side, 0.0)
            found = self.state(slips, ratio, creepage)
            borne = abs(found.traction[count]) <= self.friction * found.pressure[count] * (1.0 + ROUNDING)
            low, high = (low, count) if borne else (count, high)
        return np.where(np.arange(self.grid.alone.size) < high, side, 0.0)

    def _resting(self, slips: Array, ratio: float) -> Array:
        """Return a strip that slips everywhere with the node at rest that comes to rest first."""
        moving = self.state(slips, None, 0.0)
        surplus = float(self.grid.weights @ (moving.traction - ratio * moving.pressure))
        slips = slips.copy()
        slips[first_to_stick(slips, moving.slip[1:], surplus)] = 0.0
        return slips


class _Rollers(NamedTuple):
    """Cylinders under a load: their bed, the half-width without friction [m], and whether they are coupled."""

    bed: LineBed
    half_width: float
    coupled: bool
    elements: int

    @property
    def slope(self) -> float:
        """a/R [-]."""
        return self.half_width / float(self.bed.profile.curvature_radius)  # type: ignore[attr-defined]

    @property
    def load(self) -> float:
        """P R / (E* a^2) [-]."""
        return float(self.bed.load_profile(np.array([self.half_width]))[0]) / (self.half_width * self.slope)

    @property
    def growth(self) -> float:
        """By which power of the half-width the load grows."""
        return load_growth(self.bed, self.half_width)

    def grid(self, half: float) -> _EdgeDenseGrid:
        """Return the equations of a strip of this half-width, over that without friction."""
        return _grid(self.bed, self.half_width * (1.0 if self.bed.hertzian else half), self.coupled, self.elements)


def load_growth(bed: LineBed, half_width: float) -> float:
    """Return by which power of the half-width [m] the load of a cylinder grows: two of half-planes."""
    if bed.hertzian:
        return 2.0
    one = np.array([half_width])
    return float((half_width * bed.load_profile_slope(one) / bed.load_profile(one))[0])


def sliding_creepage(bed: LineBed, half_width: float, friction: float) -> float:
    """Return the creepage from which all of a pressed cylinder slides if it is not coupled [-].

    Parameters
    ----------
    bed : LineBed
        Of a round profile.
    half_width : float
        a [m].
    friction : float
        mu [-].
    """
    rollers = _Rollers(bed, half_width, False, COUNT)
    if bed.sheared_as_pressed:
        return friction * bed.along_share * rollers.slope
    return friction * rollers.slope * _StripEquations(rollers.grid(1.0), 0.0, 1.0).sliding(1.0).creepage


def rolled_strip(
    bed: LineBed,
    half_width: float,
    friction: float,
    *,
    force: float | None = None,
    creepage: float = 0.0,
    coupled: bool = True,
    count: int = COUNT,
) -> RolledStrip:
    """Return the strip under a force, or with a creepage.

    Parameters
    ----------
    bed : LineBed
        Of a round profile.
    half_width : float
        a [m] of the contact under the same load without friction.
    friction : float
        mu [-].
    force : float, optional
        Q over E* a.
    creepage : float, optional
        xi [-], where no force is given.
    coupled : bool, optional
        Whether pressure and traction act on each other.
    count : int, optional
        Elements.

    Raises
    ------
    NotConverged
        If pressure and traction are not found.
    """
    rollers = _Rollers(bed, half_width, coupled, count)
    slope = rollers.slope
    ratio = None if force is None else force / (rollers.load * slope)
    found = next(filter(None, (_searched(rollers, friction, steps, ratio, creepage / slope) for steps in STEPS)), None)
    if found is None:
        raise NotConverged(
            f"LineRolling: pressure and traction of the cylinders (Dundurs' beta {bed.mismatch:.3g}, friction "
            f"{friction:.3g}) were not found; give less friction, or leave the coupling out."
        )
    half, strip = found
    grid, middle = rollers.grid(half), _middle(rollers, half, strip)
    pressure, traction = (slope * half * np.pad(row, 1) for row in (strip.pressure, strip.traction))
    slips = np.append(strip.slips[:1], strip.slips)
    return RolledStrip(
        half * (grid.nodes + middle), pressure, traction, np.where(slips == 0.0, 0.0, slope * half * strip.slip), slips,
        slope * half * strip.creepage, slope * half**2 * float(grid.weights @ strip.traction),
    )  # fmt: skip


def _searched(
    rollers: _Rollers, friction: float, steps: int, ratio: float | None, creepage: float
) -> tuple[float, _UnitStrip] | None:
    """Return half-width and strip of a slope of one under Q/P or a creepage, from Carter's zones or one that sticks."""
    drive = creepage if ratio is None else ratio
    side, used = math.copysign(1.0, drive), abs(drive) / friction
    nodes = rollers.grid(1.0).nodes
    share = max(1.0 - used, 0.0) if ratio is None else math.sqrt(max(1.0 - used, 0.0))
    carter = np.where(nodes[1:-1] < 1.0 - 2.0 * share, side, 0.0)
    trailing = functools.partial(_StripEquations(rollers.grid(1.0), 1.0, friction).trailing, side, ratio, creepage)
    for guess in (lambda: carter, lambda: np.zeros(carter.size), trailing):
        slips = guess()
        found: tuple[float, _UnitStrip] | None = None
        for step in range(1, steps + 1):
            begin = slips if found is None else found[1].slips
            found = _wide(rollers, step / steps, friction, begin, ratio, creepage)
            if found is None:
                break
        if found is not None:
            return found
    return None


def _wide(
    rollers: _Rollers, part: float, friction: float, slips: Array, ratio: float | None, creepage: float
) -> tuple[float, _UnitStrip] | None:
    """Return a strip at its own half-width, at which it bears the load: by secants of the logarithms of both."""
    half, growth = 1.0, rollers.growth
    before: tuple[float, float] | None = None
    for _ in range(MOST_WIDTHS):
        strip = _StripEquations(rollers.grid(half), part, friction)
        if ratio is not None and abs(ratio) >= friction * (1.0 - ROUNDING):
            found: _UnitStrip | None = strip.sliding(math.copysign(1.0, ratio))
        else:
            found = strip.settled(slips, ratio, creepage / half)
        if found is None or not rollers.coupled:
            return None if found is None else (half, found)
        borne = float(strip.grid.weights @ found.pressure) / rollers.load
        if rollers.bed.hertzian and ratio is not None:
            return 1.0 / math.sqrt(borne), found
        excess = math.log(half**2 * borne)
        if abs(excess) <= WIDE * growth:
            return half, found
        if before is not None and before[1] != excess:
            growth = (excess - before[1]) / (math.log(half) - before[0])
        before, slips = (math.log(half), excess), found.slips
        half *= math.exp(-excess / growth)
    return None


def _middle(rollers: _Rollers, half: float, found: _UnitStrip) -> float:
    """Return how far ahead of the axis the middle of the strip is, over its half-width."""
    if not rollers.coupled:
        return 0.0
    grid = rollers.grid(half)
    sloped = grid.normal[0] @ found.pressure - grid.coupling[0] @ found.traction
    return float(sloped) - 0.5 * float(grid.nodes[0] + grid.nodes[1])
