"""A sheared line contact at one point of a path that was marched along on boundary elements."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.laws.friction import Coulomb
from winkler.numerics.surfaces.strip_elements import linear_potential
from winkler.numerics.types import Array, ArrayLike, ComplexArray
from winkler.problems.line_friction.element_row import TouchingElements
from winkler.problems.line_friction.sheared_strip import ShearedStrip
from winkler.problems.line_viscoelastic.states import LineViscoelasticState
from winkler.values.checks.place_checks import finite_places
from winkler.values.errors import OutsideValidity
from winkler.values.value import value, words

PLACES = 400
"""Places between the edges at which the traction below which stresses are computed is sampled, besides the elements."""


@value
class LineMarchedState(ShearedStrip):
    """A sheared line contact at one point of a path that was marched along on boundary elements.

    Its numbers are those of `LineSlip`.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        Profile and bodies.
    law : Coulomb
        Law of friction.
    stick_half_width, stick_middle : float
        Half-width and middle of the widest strip that does not slip [m].  Where the traction stays within some 0.2 % of
        what friction bears the strip may be wrong by a tenth of its width.
    places, used_friction, ahead, rubbed : ndarray, (elements,)
        Middles of the elements that touch [m]; traction over mu times the pressure [-]; how far the second body is
        ahead of the first there [m]; what friction has lost there since the beginning, per area [J/m^2].
    """

    __words__ = words(
        sliding=("", None, "whether all of the contact slides"),
        places=("x", "m", "middles of the elements that touch"),
        used_friction=("q/(mu p)", "", "traction over mu times the pressure, element by element"),
        ahead=("s", "m", "how far the second body is ahead of the first, element by element"),
        rubbed=("", "J/m^2", "what friction has lost per area, element by element"),
    )

    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation
    law: Coulomb
    stick_half_width: float
    stick_middle: float
    places: Array
    used_friction: Array
    ahead: Array
    rubbed: Array

    @property
    def sliding(self) -> bool:
        """Whether all of the contact slides."""
        return self.half_width > 0.0 and self.stick_half_width == 0.0

    def traction(self, x: ArrayLike) -> Array:
        """Return the traction q [Pa] along x on the first body.

        Parameters
        ----------
        x : array_like
            Places on the surface [m].
        """
        x = finite_places("LineMarchedState.traction", "x", x)
        if self.half_width == 0.0:
            return np.zeros(x.shape)
        borne = self.law.coefficient * self.pressure(x)
        used = np.interp(x, self.places, self.used_friction)
        return np.asarray(used * np.where((borne == np.inf) & (used == 0.0), 0.0, borne))

    def slip(self, x: ArrayLike) -> Array:
        """Return how far the second body is ahead of the first at places of the contact [m].

        Differences between two points of the path are what has slipped, at places that touched in the meantime; what
        came into contact later brings with it how far it was ahead then.

        Parameters
        ----------
        x : array_like
            Places on the surface [m]; not a number outside of the contact.
        """
        return self._of_elements(self.ahead, x)

    def friction_work(self, x: ArrayLike) -> Array:
        """Return what friction has lost since the beginning at places of the surface, per area [J/m^2]."""
        return np.nan_to_num(self._of_elements(self.rubbed, x))

    def _of_elements(self, row: Array, x: ArrayLike) -> Array:
        """Return a row by place: straight between the middles of the elements, and on to both edges."""
        x = finite_places("LineMarchedState.slip", "x", x)
        inside = np.abs(x) <= self.half_width
        found = np.full(x.shape, np.nan)
        if self.half_width == 0.0 or row.size < 2:
            found[inside & (self.half_width > 0.0)] = row[0] if row.size else 0.0
            return found
        at, here = self.places, x[inside]
        cell = np.clip(np.searchsorted(at, here) - 1, 0, row.size - 2)
        share = (here - at[cell]) / (at[cell + 1] - at[cell])
        found[inside] = row[cell] + share * (row[cell + 1] - row[cell])
        return found

    def _refuse_stresses(self) -> None:
        if not self.bed.sheared_as_pressed:
            raise OutsideValidity(
                "LineTangential: stresses inside layers that a contact shears while it slips in part are not computed; "
                "LineIndentation(bed, load).solve().stresses(x, z, friction) has those of a contact that slides."
            )

    def _dragged(self, x: Array, deep: Array, pressed: ComplexArray) -> ComplexArray:
        # as if the mean of what both edges use were used everywhere, and the rest of the traction beside it
        common = 0.5 * float(self.used_friction[0] + self.used_friction[-1])
        rest = np.array(linear_potential(*self._rest(common), x.ravel(), deep.ravel())).reshape(2, *x.shape)
        return rest + common * self.law.coefficient * pressed if common else rest

    def _rest(self, common: float) -> tuple[Array, Array]:
        """Return places, and the traction [Pa] there less that of a contact that uses `common` of its friction."""
        a = self.half_width
        nodes = a * np.sin(0.5 * np.pi * np.linspace(-1.0, 1.0, PLACES))
        nodes = np.union1d(nodes[1:-1], self.places[np.abs(self.places) < a])
        used = np.interp(nodes, self.places, self.used_friction) - common
        borne = self.law.coefficient * self.pressure(nodes)
        finite = np.isfinite(borne)
        ends = np.array([-a]), np.array([a])
        values = np.concatenate([[0.0], (used * borne)[finite], [0.0]])
        return np.concatenate([ends[0], nodes[finite], ends[1]]), values


@value
class LineDraggedState(LineMarchedState):
    """A sheared line contact of bodies that relax, at one moment; what it has besides those that do not relax.

    Parameters
    ----------
    pressed : LineViscoelasticState
        The contact without friction.
    """

    __words__ = words(pressed=("", None, "the contact without friction"))

    pressed: LineViscoelasticState

    def pressure(self, x: ArrayLike) -> Array:
        """Return the pressure [Pa] at places x [m], zero outside of the contact."""
        return self.pressed.pressure(x)

    def _refuse_stresses(self) -> None:
        raise OutsideValidity(
            "LineTangential: stresses inside bodies that relax are not computed for a line; read pressure(x) and "
            "traction(x)."
        )


def marched_state(
    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation,
    law: Coulomb,
    row: TouchingElements,
    force: float,
    half_width: float,
    shear: float,
    bulk: float,
    lost: float,
    pressed: LineViscoelasticState | None = None,
) -> LineMarchedState:
    """Return the state of elements under these forces [N/m], this bulk stress [Pa] and after this loss [J/m].

    Of bodies that relax it holds their contact without friction.
    """
    used = row.traction / row.bound
    middle, half = stuck_strip(row, used, half_width)
    numbers = force, half_width, shear, bulk, row.slip_shift, lost
    of_elements = half, middle, row.x, used, row.ahead, row.rubbed
    if pressed is not None:
        return LineDraggedState(*numbers, bed, law, *of_elements, pressed)
    return LineMarchedState(*numbers, bed, law, *of_elements)


def stuck_strip(row: TouchingElements, used: Array, half_width: float) -> tuple[float, float]:
    """Return the middle and the half-width of the widest strip that sticks [m].

    Where it ends the traction departs from what friction bears by the square root of the distance: the square of what
    is left to it is continued to zero over the two outermost elements, within the element beside them.  What slips
    between two strips that stick divides them only where it is wider than the wider element beside it: less than that
    elements do not tell.
    """
    sticks, edges = row.slips == 0.0, np.concatenate([[0.0], np.cumsum(row.widths)])
    turns = np.flatnonzero(np.diff(sticks)) + 1
    for start, end in pairwise(turns.tolist()):
        if not sticks[start] and edges[end] - edges[start] < max(row.widths[start - 1], row.widths[end]):
            sticks[start:end] = True
    stuck = np.flatnonzero(np.diff(np.concatenate([[0], sticks, [0]])))
    if not stuck.size:
        return 0.0, 0.0
    runs = stuck.reshape(-1, 2)
    first, after = max(runs.tolist(), key=lambda run: float(np.sum(row.widths[run[0] : run[1]])))
    ends = []
    for last, inward, side in ((first, 1, -1.0), (after - 1, -1, 1.0)):
        beside = last - inward
        if not 0 <= beside < row.x.size:
            ends.append(side * half_width)
            continue
        middle, next_to = row.x[last], row.x[last + inward] if after - first > 1 else row.x[last]
        left = (1.0 - row.slips[beside] * used[[last, last + inward if after - first > 1 else last]]) ** 2
        falls = left[1] - left[0]
        beyond = left[0] * abs(next_to - middle) / falls if falls > 0.0 else 0.5 * row.widths[last]
        ends.append(float(middle + side * min(beyond, abs(row.x[beside] - middle))))
    return 0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0])
