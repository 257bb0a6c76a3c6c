"""Flat punches and cylinders with a shaped end: contacts that are pinned at a rim."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.pieces import PowerPieces
from winkler.profiles.profile import Profile, Shape
from winkler.values.checks.number_checks import Positive
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Note
from winkler.values.value import value, words


class _Pinned(Shape):
    """A body with a vertical wall at its radius."""

    radius: float

    @property
    def reach(self) -> float:
        """The rim [m]."""
        return self.radius

    @property
    def rim(self) -> float:
        """The rim [m]."""
        return self.radius


@value
class FlatPunch(_Pinned, PowerPieces):
    """A flat-ended circular cylinder.

    Parameters
    ----------
    radius : float
        b [m], positive; the contact has this radius at every load.

    References
    ----------
    J. Boussinesq, Application des potentiels, Gauthier-Villars, Paris 1885.
    """

    __words__ = words(radius=("b", "m", "radius of the punch"))

    radius: Positive

    terms = ()
    """None: the slope is zero."""


@value
class CappedCylinder(_Pinned):
    """A circular cylinder with an end of another profile; the contact is pinned at the rim once it fills the end.

    Parameters
    ----------
    radius : float
        b [m], of the cylinder, positive.
    cap : Profile
        Shape of the end; must be known up to the rim.
    """

    __words__ = words(radius=("b", "m", "radius of the cylinder, where the contact is pinned"))

    radius: Positive
    cap: Profile

    def __post_init__(self) -> None:
        if self.cap.reach < self.radius or self.cap.rim < self.radius:
            raise InvalidInput(
                f"CappedCylinder: the cap is known up to {min(self.cap.reach, self.cap.rim):g} m but the cylinder has "
                f"the radius {self.radius:g} m; give a cap that reaches the rim."
            )
        with np.errstate(divide="ignore"):
            closes = self.cap.size > self.radius or np.isfinite(self.cap.gap(np.array([self.radius]))[0])
        if not closes:
            raise InvalidInput(
                f"CappedCylinder: the cap is vertical at the rim (radius {self.radius:g} m); give a cylinder that is "
                "thinner than its cap."
            )

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Those of the cap within the rim."""
        return tuple((b, jump) for b, jump in self.cap.kinks if b < self.radius)

    @property
    def rising(self) -> bool:
        """As the cap."""
        return self.cap.rising

    @property
    def notes(self) -> tuple[Note, ...]:
        """As the cap."""
        return self.cap.notes

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        return self.cap.height(r)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        return self.cap.slope(r)

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        if not isinstance(self.cap, Shape):
            raise OutsideValidity(
                f"CappedCylinder: the cap, {type(self.cap).__name__}, has no curvature, which its contact needs here; "
                "give a cap that is a formula."
            )
        return self.cap.curvature(r)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return self.cap.gap(x)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return self.cap.gap_slope(x)

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        return self.cap.gap_integral(x)


@value
class Cylinder(Shape):
    """A cylinder lying on its side; it raises an error that states the reason.

    Parameters
    ----------
    curvature_radius : float
        R [m].

    Raises
    ------
    OutsideValidity
        Always.
    """

    curvature_radius: float

    def __post_init__(self) -> None:
        raise OutsideValidity(
            "Cylinder: a cylinder on its side makes a line contact, which is not a body of revolution about the "
            "load. Its depth on a half-space is infinite (it grows with the logarithm of the body's size), so that "
            "no springs can represent it. Give LineIndentation with LineFoundation(Paraboloid(R), medium), or "
            "CappedCylinder for a cylinder standing on end."
        )
