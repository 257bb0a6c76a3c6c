r"""Sections across long bodies: heights f(x) along a surface, neither even nor of one crest.

A section states f and f' between `start` and `end`, the places where its slope or curvature jumps, and the walls at
which the body ends.  `Section` is the contract of `winkler.problems.line_strips.profile_contact.LineProfileContact`.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array
from winkler.values.checks.number_checks import FiniteRow, PositiveRow
from winkler.values.errors import InvalidInput
from winkler.values.validity import Note
from winkler.values.value import value, words

MOST_BODIES = 200
SIDE = 1e-9
"""Distance from a kink at which the curvature on either side is taken, over its place."""


class Section:
    """The contract of a section, and what most have in common."""

    @property
    def start(self) -> float:
        """First place of what is known [m]; minus infinity if all of it is."""
        return -math.inf

    @property
    def end(self) -> float:
        """Last place of what is known [m]; infinite if all of it is."""
        return math.inf

    @property
    def carrying(self) -> tuple[float, float]:
        """Places [m] between which a force can act on a body that is free to tilt."""
        return self.start, self.end

    @property
    def pads(self) -> tuple[tuple[float, float], ...]:
        """From wall to wall, where the body ends vertically [m]; empty if it has no walls."""
        return ()

    @property
    def breaks(self) -> tuple[tuple[float, float, float], ...]:
        """``(place, jump of the slope, jump of the curvature)``, ascending."""
        return ()

    @property
    def smooth(self) -> bool:
        """Whether slopes mean something between the places, as not those of points joined by straight lines."""
        return True

    @property
    def notes(self) -> tuple[Note, ...]:
        """What must be stated about the section."""
        return ()

    def window(self, load: float) -> tuple[float, float]:
        """Return places [m] between which the contact under a load per length over E* [m] is sought first."""
        return self.start, self.end

    def grid(self, start: float, end: float, count: int) -> Array:
        """Return evenly spaced places [m] on which the contact is sought."""
        return np.linspace(start, end, count)

    def height(self, x: Array) -> Array:
        """f(x) [m], of the gap: it grows away from what touches first."""
        raise NotImplementedError(f"{type(self).__name__} must give height(x).")

    def slope(self, x: Array) -> Array:
        """f'(x) [-]; at a corner the slope on its right."""
        raise NotImplementedError(f"{type(self).__name__} must give slope(x).")


@value
class CylinderRow(Section):
    """Cylinders side by side on one rigid carrier, or the rounded crests of a surface.

    Parameters
    ----------
    curvature_radii : ndarray, (n,)
        R_i [m]: 1/R_i is the sum of the curvatures of a cylinder and the opposite body.
    places : ndarray, (n,)
        Positions of their lowest lines [m], ascending.
    drops : ndarray, (n,)
        Distances from a common plane away from the other body [m].

    Raises
    ------
    InvalidInput
        If the rows are not of one length, the places do not ascend, or a cylinder is hidden behind its neighbours.
    """

    __words__ = words(
        curvature_radii=("R_i", "m", "radii of the cylinders: 1/R_i is the sum of the curvatures of both bodies"),
        places=("x_i", "m", "where the lowest lines of the cylinders are"),
        drops=("h_i", "m", "distances of the lowest lines from a common plane"),
    )

    curvature_radii: PositiveRow
    places: FiniteRow
    drops: FiniteRow

    def __post_init__(self) -> None:
        n = self.places.size
        if n == 0 or n > MOST_BODIES or self.curvature_radii.size != n or self.drops.size != n:
            raise InvalidInput(
                f"CylinderRow: there are {self.curvature_radii.size} radii, {n} places and {self.drops.size} drops; "
                f"give one of each for up to {MOST_BODIES} cylinders."
            )
        ascending("CylinderRow", self.places)

    @property
    def carrying(self) -> tuple[float, float]:
        """As in `Section`: beyond the radius of the last cylinder there is no place on it to roll to [m]."""
        return float(self.places[0] - self.curvature_radii[0]), float(self.places[-1] + self.curvature_radii[-1])

    def window(self, load: float) -> tuple[float, float]:
        """Return the range [m] around all cylinders that may be in contact under the load."""
        beside = 3.0 * math.sqrt(4.0 / math.pi * load * float(np.max(self.curvature_radii)))
        return float(self.places[0]) - beside, float(self.places[-1]) + beside

    @property
    def breaks(self) -> tuple[tuple[float, float, float], ...]:
        """The valleys where one cylinder meets the next."""
        x, h, k = self.places, self.drops, 1.0 / self.curvature_radii
        first, second = np.triu_indices(x.size, 1)
        # h_i + k_i (x - x_i)^2/2 of both, equal: (k_j - k_i) t^2/2 + b t + c = 0 from the place of the first
        apart = x[second] - x[first]
        a, b = 0.5 * (k[second] - k[first]), -k[second] * apart
        c = h[second] - h[first] + 0.5 * k[second] * apart**2
        with np.errstate(all="ignore"):
            q = -0.5 * (b - np.sqrt(b * b - 4.0 * a * c))  # b is negative
            crossings = np.concatenate([x[first] + q / a, x[first] + c / q])
        crossings = np.unique(crossings[np.isfinite(crossings)])
        beside = SIDE * (np.abs(crossings) + self.curvature_radii.min())
        jump = self.slope(crossings + beside) - self.slope(crossings - beside)
        found = jump < -4.0 * beside * k.max()
        return tuple(
            (float(place), float(step), 0.0) for place, step in zip(crossings[found], jump[found], strict=True)
        )

    def height(self, x: Array) -> Array:
        """f(x) [m]: of the lowest cylinder at each place."""
        return np.asarray(np.min(self._parabolas(x), axis=0))

    def slope(self, x: Array) -> Array:
        """f'(x) [-]."""
        lowest = np.argmin(self._parabolas(x), axis=0)
        return np.asarray((x - self.places[lowest]) / self.curvature_radii[lowest])

    def _parabolas(self, x: Array) -> Array:
        shape = (-1,) + (1,) * np.ndim(x)
        away = np.asarray(x) - self.places.reshape(shape)
        return np.asarray(self.drops.reshape(shape) + away**2 / (2.0 * self.curvature_radii.reshape(shape)))


@value
class PunchRow(Section):
    """Flat punches side by side on one rigid carrier, their edges sharp.

    Parameters
    ----------
    starts, ends : ndarray, (n,)
        Left and right edges of the punches [m], ascending and apart from each other.
    drops : ndarray, (n,)
        Distances from a common plane away from the other body [m].

    Raises
    ------
    InvalidInput
        If the rows are not of one length, or punches overlap.
    """

    __words__ = words(
        starts=("a_i", "m", "left edges of the punches"),
        ends=("b_i", "m", "right edges of the punches"),
        drops=("h_i", "m", "distances of the punches from a common plane"),
    )

    starts: FiniteRow
    ends: FiniteRow
    drops: FiniteRow

    def __post_init__(self) -> None:
        n = self.starts.size
        if n == 0 or n > MOST_BODIES or self.ends.size != n or self.drops.size != n:
            raise InvalidInput(
                f"PunchRow: there are {n} starts, {self.ends.size} ends and {self.drops.size} drops; give one of "
                f"each for up to {MOST_BODIES} punches."
            )
        ascending("PunchRow", np.stack([self.starts, self.ends], axis=1).ravel())

    @property
    def start(self) -> float:
        """Left edge of the first punch [m]."""
        return float(self.starts[0])

    @property
    def end(self) -> float:
        """Right edge of the last punch [m]."""
        return float(self.ends[-1])

    @property
    def pads(self) -> tuple[tuple[float, float], ...]:
        """The punches."""
        return tuple(zip(self.starts.tolist(), self.ends.tolist(), strict=True))

    def height(self, x: Array) -> Array:
        """f(x) [m]; between the punches it is that of the nearest one on the left."""
        return np.asarray(self.drops[np.maximum(np.searchsorted(self.starts, x, side="right") - 1, 0)])

    def slope(self, x: Array) -> Array:
        """f'(x) = 0."""
        return np.zeros(np.shape(x))


def ascending(owner: str, places: Array) -> None:
    """Refuse places that do not ascend."""
    wrong = np.flatnonzero(np.diff(places) <= 0.0)
    if wrong.size:
        raise InvalidInput(
            f"{owner}: after the place {places[wrong[0]]:.6g} m comes {places[wrong[0] + 1]:.6g} m; give places in "
            "ascending order, each once."
        )
