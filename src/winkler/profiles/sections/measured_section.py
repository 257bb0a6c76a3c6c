r"""Sections that were measured, or are written as a formula.

Where straight lines join the points of a profilometer, the slope jumps at each of them, so that the pressure under a
crest grows without bound as elements become finer: elements are as wide as the points are apart.  A spline may be
cut into finer ones.  Peak pressures belong to the spacing of the points either way.
"""

from __future__ import annotations

import functools
from collections.abc import Iterable, Mapping
from typing import Annotated, Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from winkler.numerics.equations.expression import Expression
from winkler.numerics.types import Array
from winkler.profiles.formula_parts import constants_of
from winkler.profiles.sections.mirrored_section import MirroredSection
from winkler.profiles.sections.section import CylinderRow, PunchRow, Section, ascending
from winkler.values.checks.number_checks import Advice, FiniteRow, Positive
from winkler.values.errors import InvalidInput
from winkler.values.limits import MEASURED_PLACES
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

FEWEST_POINTS, EVEN = 16, 1e-4
"""Points of a measured section; how uneven their spacing may be to count as even, over the spacing."""
TRIED = 1025
SIDE = 1e-7
"""Distance from a corner at which slope and curvature on either side are taken, over the width."""
CUT_OFF = ("", None, "whether the body ends vertically at both ends of the section")


@value
class MeasuredSection(Section):
    """A section known at points, joined by straight lines or a spline: the trace of a profilometer.

    Parameters
    ----------
    places : ndarray, (n,)
        Positions along the surface [m], ascending; at least 16.
    heights : ndarray, (n,)
        Heights of the gap there [m]; the lowest points touch first.  For a trace with peaks pointing upwards change
        the sign, or read it with ``read_section(path, peak=True)``.

    cut_off : bool, optional
        Whether the body ends vertically at the first and at the last point. Otherwise the continuation of the body is
        unknown, and the contact must not reach it.
    curved : bool, optional
        Whether a cubic spline joins the points instead of straight lines; use it if the points are closer than the
        features of the trace.

    Raises
    ------
    InvalidInput
        If the points are too few or their places do not ascend.

    See Also
    --------
    winkler.read_section : reads a file with units.
    """

    __words__ = words(
        places=("x_i", "m", "measured places along the surface"),
        heights=("f_i", "m", "measured heights of the gap, the lowest of which touch first"),
        cut_off=CUT_OFF,
        curved=("", None, "whether a cubic spline joins the points instead of straight lines"),
    )

    places: FiniteRow
    heights: FiniteRow
    cut_off: bool = False
    curved: bool = False

    def __post_init__(self) -> None:
        n = self.places.size
        if n != self.heights.size or not FEWEST_POINTS <= n <= MEASURED_PLACES:
            raise InvalidInput(
                f"MeasuredSection: there are {n} places and {self.heights.size} heights; give as many of both, from "
                f"{FEWEST_POINTS} to {MEASURED_PLACES}."
            )
        ascending("MeasuredSection", self.places)

    @property
    def start(self) -> float:
        """The first point [m]."""
        return float(self.places[0])

    @property
    def end(self) -> float:
        """The last point [m]."""
        return float(self.places[-1])

    @property
    def pads(self) -> tuple[tuple[float, float], ...]:
        """The range from end to end, for a body that is cut off there."""
        return ((self.start, self.end),) if self.cut_off else ()

    @property
    def smooth(self) -> bool:
        """False: the slope, or a higher derivative, jumps at each point."""
        return False

    @property
    def even(self) -> bool:
        """Whether the points are evenly spaced."""
        spacing = (self.end - self.start) / (self.places.size - 1)
        return bool(np.max(np.abs(np.diff(self.places) - spacing)) <= EVEN * spacing)

    @property
    def notes(self) -> tuple[Note, ...]:
        """A note on the interpolation between the points."""
        joined = "a cubic spline" if self.curved else "straight lines"
        text = (
            f"The section consists of {self.places.size} points joined by {joined}. Maximum pressures depend on "
            "the point spacing and the scatter of the heights. They are less accurate than forces, gaps and "
            "contact lengths."
        )
        return (Note(Assumption.SHAPE, Standing.APPROXIMATE, text, "as measured"),)

    def grid(self, start: float, end: float, count: int) -> Array:
        """Return the measured points if they are evenly spaced and joined by lines, otherwise an even grid."""
        return self.places if self.even and not self.curved else np.linspace(start, end, count)

    def height(self, x: Array) -> Array:
        """f(x) [m] over the lowest point."""
        lowest = float(np.min(self.heights))
        if self.curved:
            return np.asarray(_spline(self)(x)) - lowest
        return np.asarray(np.interp(x, self.places, self.heights - lowest))

    def slope(self, x: Array) -> Array:
        """f'(x) [-]."""
        if self.curved:
            return np.asarray(_spline(self)(x, 1))
        after = np.clip(np.searchsorted(self.places, x, side="right"), 1, self.places.size - 1)
        return np.asarray((np.diff(self.heights) / np.diff(self.places))[after - 1])


@functools.lru_cache(maxsize=16)
def _spline(section: MeasuredSection) -> Any:
    """Return the cubic spline through the points."""
    from scipy.interpolate import CubicSpline

    return CubicSpline(section.places, section.heights, bc_type="natural")


@value
class FormulaSection(Section):
    """A section defined by a formula of the position x, from 0 to a given width.

    Parameters
    ----------
    expression : str
        The height of the gap [m] in terms of ``x`` [m] and of named constants, as ``"h*cos(2*pi*x/l) + x**2/(2*R)"``;
        what `Formula` allows.  Only differences of heights count.
    width : float
        Upper limit of x [m].
    corners : tuple of float, optional
        Positions at which the slope or the curvature jumps [m].
    cut_off : bool, optional
        As in `MeasuredSection`.
    constants : mapping or tuple of (name, number), optional
        The constants in SI units; they may also be keyword arguments, ``FormulaSection("x**2/R", 0.01, R=0.1)``.

    Raises
    ------
    InvalidInput
        If the text is not a valid formula, or a height is not finite.
    """

    __words__ = words(
        expression=("f(x)", None, "formula of the height in terms of x [m] and the constants"),
        width=("L", "m", "up to which place the formula holds"),
        corners=("b_i", "m", "places at which the slope of the formula jumps"),
        cut_off=CUT_OFF,
    )

    expression: Annotated[str, Advice("a formula such as 'h*cos(2*pi*x/l)'")]
    width: Positive
    constants: tuple[tuple[str, float], ...] = ()
    corners: tuple[float, ...] = ()
    cut_off: bool = False

    def __init__(
        self,
        expression: str,
        width: float,
        *,
        cut_off: bool = False,
        corners: ArrayLike = (),
        constants: Mapping[str, float] | Iterable[tuple[str, float]] = (),
        **named: float,
    ) -> None:
        object.__setattr__(self, "expression", expression)
        object.__setattr__(self, "width", width)
        object.__setattr__(self, "constants", constants_of("FormulaSection", constants, named))
        object.__setattr__(self, "corners", corners)
        object.__setattr__(self, "cut_off", cut_off)
        self.__post_init__()

    def __post_init__(self) -> None:
        for corner in self.corners:
            if not 0.0 < corner < self.width:
                raise InvalidInput(
                    f"FormulaSection: the corner {corner!r} must be a place in m between 0 and the width."
                )
        object.__setattr__(self, "corners", tuple(sorted({float(corner) for corner in self.corners})))
        x = np.linspace(0.0, self.width, TRIED)
        beside = x[~np.isin(x, self.corners)]
        values = np.array(self._law.taylor(beside)[:2])
        if not np.all(np.isfinite(values)):
            where = float(beside[np.argmax(~np.isfinite(values).all(axis=0))])
            raise InvalidInput(
                f"FormulaSection: height or slope of {self.expression[:60]!r} is not finite at x = {where:.6g} m; give "
                "a formula that is finite from x = 0 to the width."
            )

    @property
    def start(self) -> float:
        """x = 0."""
        return 0.0

    @property
    def end(self) -> float:
        """The width [m]."""
        return self.width

    @property
    def pads(self) -> tuple[tuple[float, float], ...]:
        """The range from end to end, for a body that is cut off there."""
        return ((0.0, self.width),) if self.cut_off else ()

    @property
    def breaks(self) -> tuple[tuple[float, float, float], ...]:
        """The corners, with the jumps of slope and curvature there."""
        found = []
        for corner in self.corners:
            sides = np.clip(corner + SIDE * self.width * np.array([-2.0, -1.0, 1.0, 2.0]), 0.0, self.width)
            _, slope, curvature = self._law.taylor(sides)
            ends = 2.0 * slope[[1, 2]] - slope[[0, 3]]
            found.append((corner, float(ends[1] - ends[0]), float(curvature[2] - curvature[1])))
        return tuple(found)

    @property
    def _law(self) -> Expression:
        return Expression(self.expression, "x", self.constants)

    def height(self, x: Array) -> Array:
        """f(x) [m]."""
        return np.asarray(self._law.taylor(np.clip(x, 0.0, self.width))[0])

    def slope(self, x: Array) -> Array:
        """f'(x) [-]; at a corner the slope on its right."""
        x = np.asarray(x, dtype=float)
        at = np.isin(x, self.corners)
        return np.asarray(self._law.taylor(np.clip(np.where(at, x + SIDE * self.width, x), 0.0, self.width))[1])


AnySection: TypeAlias = CylinderRow | PunchRow | MirroredSection | FormulaSection | MeasuredSection
