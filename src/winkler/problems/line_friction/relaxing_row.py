r"""A sheared line contact of bodies that relax: the boundary elements, moved by tractions that have crept.

The surfaces of half-planes, and of layers that relax alike, move along each other as those of elastic bodies under

.. math:: c(x,t) = \int C(t-t')\,\frac{\partial q(x,t')}{\partial t'}\,\mathrm dt'

in the place of the traction q over E*, with the creep C of the normal contact.  Over a step q is taken as straight, so
that c at its end is a part that has crept already and an effective compliance times q: what sticks and what slips is
found as on elastic bodies.  On layers that relax each by a law of its own every term of the creep has its own
compliance of the elements (`winkler.numerics.springs.rate_fit`).  The pressures are those of
`winkler.problems.line_viscoelastic.indentation`.  Steps begin short after each point of the path, where rates have
changed, and grow fourfold until they are as long as those of elastic elements; none is halved.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import Any

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.laws.friction import Coulomb
from winkler.materials.elastic import Rigid
from winkler.media.relaxing.at_rate import half_space_creep
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.springs.exponential_sums import CreepSeries
from winkler.numerics.springs.rate_fit import RateFit
from winkler.numerics.surfaces.strip_grid import StuckStrip
from winkler.numerics.types import Array
from winkler.problems.line_friction.element_row import (
    ROUNDING,
    STEPS,
    STEPS_BESIDE,
    ElementRow,
    LineCells,
    LineGoal,
    Response,
    refuse_sliding,
    stuck_compliance,
)
from winkler.problems.line_friction.elements import LineElements, elements_for, pressures_of
from winkler.problems.line_friction.marched_states import LineMarchedState, marched_state
from winkler.problems.line_friction.path import LinePath
from winkler.problems.line_viscoelastic.indentation import LineViscoelasticIndentation
from winkler.problems.line_viscoelastic.layered_strips import elastic_line
from winkler.problems.line_viscoelastic.path import LineForcePath
from winkler.problems.line_viscoelastic.states import LineViscoelasticState
from winkler.problems.method import Method
from winkler.problems.row import Reached, follow
from winkler.values.errors import InvalidInput, OutsideValidity

FIRST_SPAN, LEAST_STEPS = 0.1, 8
"""The first step after a point of the path, over the shortest time of the creep; and steps between two points."""
SPRINGS = 250
"""Flat strips the pressures are made of."""
GAUSS, WEIGHTS = np.polynomial.legendre.leggauss(2)


class ElementsAlike:
    """What elements remember on bodies that relax by one function of time: one compliance, times numbers.

    Parameters
    ----------
    elements : LineElements
    line : LineBed
        The bodies as if they were elastic.
    creep : CreepSeries
        By what their compliance is multiplied.
    """

    def __init__(self, elements: LineElements, line: LineBed, creep: CreepSeries) -> None:
        self.elements, self.line, self.factors = elements, line, _factors(creep)
        self.grid = StuckStrip(elements.compliance, elements.widths)

    def effective(self, shares: Array) -> tuple[StuckStrip, float]:
        """Return elements, and a factor of their compliance, where parts of each term have crept ``(2 + k,)``."""
        return self.grid, float(self.factors @ shares)

    def moved(self, parts: Array) -> Array:
        """Return how far tractions have moved the elements that have crept by each term ``(2 + k, n)``."""
        return np.asarray(self.elements.compliance @ (self.factors @ parts))

    def stuck(self, half_width: float) -> Array:
        """Return the compliances of a strip that sticks, of each term ``(2 + k,)``."""
        return self.factors * stuck_compliance(self.line, half_width, self.elements.scale)


class ElementsApart:
    """What elements remember on layers that relax each by a law of its own: each term has a compliance.

    Parameters
    ----------
    elements : LineElements
    line : LineBed
        The layers after all time.
    medium : RelaxingByWaves
    """

    def __init__(self, elements: LineElements, line: Any, medium: Any) -> None:
        self.elements, modulus = elements, line.medium.modulus
        self.fit: RateFit = medium.rates
        beds = [dataclasses.replace(line, medium=medium.elastic_at(rate)) for rate in self.fit.rates.tolist()]
        self.lines = [(bed, modulus / bed.medium.modulus) for bed in beds]
        edges = elements.scale * elements.edges
        self.terms = self._terms(lambda bed: bed.shear_compliance(edges))

    def _terms(self, answer: Callable[[LayeredLineFoundation], Array | float]) -> Array:
        """Return the terms of what elastic lines answer to forces over their modulus; what flows is zero."""
        answers = np.stack([share * np.asarray(answer(bed)) for bed, share in self.lines])
        found = self.fit.terms(answers)
        return np.insert(found, 1, 0.0, axis=0)

    def effective(self, shares: Array) -> tuple[StuckStrip, float]:
        """As of `ElementsAlike`."""
        return StuckStrip(np.tensordot(shares, self.terms, 1), self.elements.widths), 1.0

    def moved(self, parts: Array) -> Array:
        """As of `ElementsAlike`."""
        return np.asarray(np.matmul(self.terms, parts[:, :, None]).sum(axis=(0, 2)))

    def stuck(self, half_width: float) -> Array:
        """As of `ElementsAlike`."""
        return self._terms(lambda bed: stuck_compliance(bed, half_width, self.elements.scale))


class RelaxingElementRow(ElementRow):
    """Elements on bodies that relax; units as of `ElementRow`, on the bodies as if they were elastic.

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
        On a medium that relaxes.
    friction : float
        mu [-].
    path : LinePath
        With a time.
    """

    def __init__(self, bed: LineFoundation | LayeredLineFoundation, friction: float, path: LinePath) -> None:
        medium: Any = bed.medium
        self.own = bed
        self.bed, self.friction = elastic_line(bed), friction
        alike = medium.in_proportion
        self.creep = (
            medium.creep if alike else CreepSeries(1.0, 0.0, np.ones(medium.rates.times.size), medium.rates.times)
        )
        self.path, self.modulus = path, self.bed.medium.modulus
        self.most = friction * float(np.max(path.across))
        if self.most <= 0.0:
            raise OutsideValidity("LineTangential: the bodies never touch along this path; press them.")
        rows = [self._times(n) for n in range(path.moments.size)]
        ends, flat, across = self._laid(rows)
        self.pressed = self._pressed(bed, flat, across)
        half_widths = np.array([state.half_width for state in self.pressed])
        self.elements = elements_for(self.bed, half_widths[ends])
        self.unit = self.modulus * self.elements.scale
        self.sheared = (
            ElementsAlike(self.elements, self.bed, self.creep)
            if alike
            else ElementsApart(self.elements, self.bed, medium)
        )
        arriving = self._arriving(rows, half_widths)
        if [row.size for row in arriving] != [row.size for row in rows]:  # the edge of the contact moves
            ends, flat, across = self._laid(arriving)
            self.pressed = self._pressed(bed, flat, across)
        self.ends, self.across, self.times = ends, across, flat
        self.along, self.bulk = (np.interp(flat, path.moments, row) for row in (path.along, path.bulk))
        self.along[ends], self.bulk[ends] = path.along, path.bulk
        if isinstance(medium, ViscoelasticHalfSpace):
            strain, strains = half_space_creep(medium.first), 1.0
        elif alike:
            strain, strains = self.creep, self.bed.strain_per_stress
        else:
            strain, strains = half_space_creep(medium.on), 1.0
        self.strains = strains * _factors(strain) @ self._parts(strain, self.bulk)
        self.shears = self._parts(self.creep, self.along) / self.unit
        self.goals = [LineGoal(*row) for row in zip(path.across / self.unit, *np.zeros((3, ends.size)), strict=True)]

    @staticmethod
    def _pressed(
        bed: LineFoundation | LayeredLineFoundation, times: Array, forces: Array
    ) -> list[LineViscoelasticState]:
        """Return the contact without friction at all moments."""
        problem, unit = LineViscoelasticIndentation(bed, LineForcePath(times, forces), SPRINGS), np.max(forces) or 1.0

        def key(time: float, force: float) -> tuple[float, float]:  # cells bear a force to rounding
            return time, round(force / unit, 9)

        found = {key(state.time, state.force_per_length): state for state in problem.steps()}  # sudden ones: the last
        return [found[key(*pair)] for pair in zip(times.tolist(), np.asarray(forces).tolist(), strict=True)]

    def _laid(self, rows: list[Array]) -> tuple[Array, Array, Array]:
        """Return which steps reach the points of the path, and times [s] and normal forces [N/m] of all steps."""
        path, flat = self.path, np.concatenate(rows)
        across = np.interp(flat, path.moments, path.across)
        ends = np.cumsum([row.size for row in rows]) - 1
        across[ends], flat[ends] = path.across, path.moments
        return ends, flat, across

    def _times(self, n: int) -> Array:
        """Return when the steps to a point of the path end [s]."""
        if n == 0 or self.path.moments[n] == self.path.moments[n - 1]:
            return self.path.moments[n : n + 1]
        start, end = self.path.moments[n - 1 : n + 1].tolist()
        change = [abs(float(row[n] - row[n - 1])) for row in (self.path.across, self.path.along)]
        size = max(self.friction * change[0], change[1]) / self.most
        steps = max(math.ceil((STEPS_BESIDE if change[0] else STEPS) * size), LEAST_STEPS)
        shares = np.arange(1, steps + 1) / steps
        if self.creep.times.size:
            first = FIRST_SPAN * float(np.min(self.creep.times)) / (end - start)
            growing = 0.25 ** np.arange(1.0, 0.5 * max(math.log2(1.0 / first), 0.0) + 1.0)
            shares = np.union1d(shares, growing[growing < shares[0]])
        return np.append(start + (end - start) * shares[:-1], end)

    def _arriving(self, rows: list[Array], half_widths: Array) -> list[Array]:
        """Return the times with those at which the edge of the contact is that of an element."""
        edges = self.elements.scale * self.elements.edges[self.elements.edges > 0.0]
        start, found = 0, [rows[0]]
        for before, row in pairwise(rows):
            start += before.size
            times = np.append(before[-1], row)
            widths = half_widths[start - 1 : start + row.size]
            if times[-1] == times[0] or abs(widths[-1] - widths[0]) <= ROUNDING * self.elements.scale:
                found.append(row)
                continue
            crossed = [
                np.interp(edges[(edges > one) & (edges < two)], (one, two), span)
                for (one, span_one), (two, span_two) in map(sorted, pairwise(zip(widths, times, strict=True)))
                if one != two
                for span in ((span_one, span_two),)
            ]
            inner = np.union1d(row, np.concatenate(crossed)) if crossed else row
            apart = np.append(np.diff(inner) > ROUNDING * (times[-1] - times[0]), True)
            found.append(np.append(inner[apart][inner[apart] < row[-1]], row[-1]))
        return found

    def _parts(self, creep: CreepSeries, loads: Array) -> Array:
        """Return loads at all moments, how they have flowed, and are delayed by each term ``(2 + k, moments)``."""
        found = np.zeros((2 + creep.times.size, loads.size))
        found[0], before = loads, 0.0
        for i, (load, dt) in enumerate(zip(loads.tolist(), np.diff(self.times, prepend=self.times[0]), strict=True)):
            gone, share = _faded(creep, dt)
            found[1, i] = found[1, i - 1] + 0.5 * dt * (before + load)
            found[2:, i] = (1.0 - gone) * found[2:, i - 1] + (gone - share) * before + share * load
            before = load
        return found

    def states(self, law: Coulomb) -> Iterator[LineMarchedState]:
        """Yield the contact at every point of the path."""
        path = self.path
        rows = zip(path.across.tolist(), path.along.tolist(), path.bulk.tolist(), self.ends.tolist(), strict=True)
        for (force, shear, bulk, end), (reached, _, lost) in zip(rows, follow(self, self.goals), strict=True):
            pressed, energy = self.pressed[end], self.lost_per_length(lost)
            touching = self.touching(reached)
            yield marched_state(self.own, law, touching, force, pressed.half_width, shear, bulk, energy, pressed)

    def begin(self, goal: LineGoal) -> Reached[LineCells]:
        """Return the elements at the first point, which comes suddenly, the normal force first."""
        return self.step(self._rest(self.creep.times.size), goal)

    def step(self, state: LineCells, goal: LineGoal) -> Reached[LineCells]:
        """Return the elements after forces and strain have changed in proportion."""
        point = 0 if state.number < 0 else int(np.searchsorted(self.ends, state.number)) + 1
        refuse_sliding(self.friction, goal.force, float(self.path.along[point]) / self.unit, self.unit)
        reached = Reached(state._replace(last=np.zeros(self.elements.x.size)), 0.0, 0.0)
        for number in range(state.number + 1, int(self.ends[point]) + 1):
            reached = reached.then(self._onto(reached.state, number))
        return reached

    def _onto(self, cells: LineCells, number: int) -> Reached[LineCells]:
        """Return the elements at the end of one step."""
        state, unit = self.pressed[number], self.unit
        dt = float(self.times[number] - self.times[number - 1]) if number else 0.0
        response = self._carried(cells, dt)
        force, shear, strain = (float(row[number]) for row in (self.across, self.along, self.strains))
        goal, a = LineGoal(force / unit, shear / unit, strain, 0.0), state.half_width / self.elements.scale
        if a == 0.0 and shear != 0.0:
            raise self._sudden(number)
        if a > 0.0 and response[1] == 0.0:
            if goal.force == cells.goal.force and self.along[number] == self.along[number - 1]:
                return Reached(cells._replace(number=number), math.nan, 0.0)
            raise self._sudden(number)
        bound = self.friction * self._pressures(state, a) if a > 0.0 else np.zeros(cells.bound.size)
        # loads change in proportion over a step: what friction bears in the middle is the mean
        reached = self._moved(cells, goal, bound, 0.5 * (cells.bound + bound), a, response)
        new = reached.state._replace(number=number, crept=self._kept(cells, reached.state.traction, dt))
        return reached._replace(state=new)

    def _sudden(self, number: int) -> OutsideValidity:
        """Return the refusal of a step that takes no time."""
        return OutsideValidity(
            f"the forces change suddenly at {self.times[number]:.6g} s, which a dashpot alongside responds to with an "
            "infinite traction; give the step some time."
        )

    def _carried(self, cells: LineCells, dt: float) -> Response:
        """Return elements and effective compliance of a step, and how far they have crept already at its end ``(n,)``.

        What is carried has flowed, and is delayed by each term.
        """
        share = _faded(self.creep, dt)[1]
        flowed, delayed = self._kept(cells, np.zeros(cells.traction.size), dt)
        grid, compliance = self.sheared.effective(np.concatenate([[1.0, 0.5 * dt], share]))
        return grid, compliance, self.sheared.moved(np.vstack([0.0 * flowed, flowed, delayed]))

    def _kept(self, cells: LineCells, after: Array, dt: float) -> tuple[Array, Array]:
        """Return what of the tractions has flowed and is delayed after a step that ends with those."""
        (flowed, delayed), before = cells.crept, cells.traction
        gone, share = (row[:, None] for row in _faded(self.creep, dt))
        rising = (gone - share) * before + share * after
        return flowed + 0.5 * dt * (before + after), (1.0 - gone) * delayed + rising

    def _if_stuck(self, cells: LineCells) -> float:
        """Return the shift over A of a strip as wide that sticks."""
        return float(self.sheared.stuck(cells.half_width * self.elements.scale) @ self.shears[:, cells.number])

    def _pressures(self, state: LineViscoelasticState, a: float) -> Array:
        """Return the mean pressures on all elements over E*."""
        elements = self.elements
        edges = elements.scale * elements.edges[elements.x.size // 2 :]
        half = 0.5 * np.diff(np.minimum(edges, state.half_width))
        places = edges[:-1, None] + half[:, None] * (1.0 + GAUSS)
        found = state.pressure(places)  # infinite at the very edge, beside a rim or a dashpot
        sums = half * (np.where((half[:, None] > 0.0) & np.isfinite(found), found, 0.0) @ WEIGHTS)
        mean = sums / np.diff(edges) / self.modulus
        if not np.any(mean > 0.0):  # narrower than the first of the strips that make up the pressure
            mean[0] = 1.0
        return pressures_of(elements, mean, state.force_per_length / self.unit, a)


def refuse_timeless(bed: LineFoundation | LayeredLineFoundation, path: LinePath, method: Method) -> None:
    """Refuse a path without time, and what is not followed on bodies that relax.

    Raises
    ------
    InvalidInput
    """
    medium: Any = bed.medium
    if not (medium.in_proportion or medium.rates):
        raise InvalidInput(
            f"LineTangential: {medium.reason} The response to shear during the flow is not implemented. Give "
            f"{medium.alike}."
        )
    if method is Method.EXACT:
        raise InvalidInput(
            f"LineTangential: the method {method} adds up earlier contacts of elastic bodies, and these relax; leave "
            "the method out."
        )
    if path.across.size > 1 and np.ndim(path.time) == 0:
        raise InvalidInput(
            "LineTangential: the bodies relax over time, and the path states none; give LinePath(force_per_length, "
            "shear_force_per_length, time=[...])."
        )
    first = medium.first if isinstance(medium, ViscoelasticHalfSpace) else elastic_line(bed).strained
    if np.any(path.bulk_stress) and isinstance(first, Rigid):
        raise InvalidInput(
            "LineTangential: the first body is rigid and carries no bulk stress; give the other one first."
        )


def _factors(creep: CreepSeries) -> Array:
    """Return by what loads, what of them has flowed, and is delayed by each term creep ``(2 + k,)``."""
    return np.array([creep.glassy, creep.fluidity, *creep.compliances])


def _faded(creep: CreepSeries, dt: float) -> tuple[Array, Array]:
    """Return which part of each term is forgotten in a step, and which part of a straight rise has crept, ``(k,)``."""
    spans = dt / creep.times
    gone = -np.expm1(-spans)
    return gone, np.where(spans > 0.0, 1.0 - gone / np.where(spans > 0.0, spans, 1.0), 0.0)
