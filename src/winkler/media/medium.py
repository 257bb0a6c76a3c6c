"""What a medium is: the translator between a body and its springs."""

from __future__ import annotations

from typing import Protocol

from winkler.media.punch_field import BodyField
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile
from winkler.validity import Note

__all__ = ["Displacement", "Medium"]


class Displacement(Protocol):
    """The displacement u(x) of the springs: d - g(x) in contact, nothing outside; even in x.

    Methods take an array of x >= 0 [m].  `kinks` lists ``(x, strength)`` where u is not smooth: just above x the
    slope behaves like ``-strength / sqrt(x**2 - x_kink**2)`` (strength zero where it does not diverge).
    """

    @property
    def radius(self) -> float:
        """Contact radius a [m]."""
        ...

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)`` of every non-smooth point inside the contact, ascending."""
        ...

    @property
    def edge(self) -> float:
        """u(a-) [m], the jump at the edge of the contact; zero where the contact closes smoothly."""
        ...

    def value(self, x: Array) -> Array:
        """u(x) [m] for x <= a."""
        ...

    def slope(self, x: Array) -> Array:
        """u'(x) [-] for x <= a."""
        ...


class Medium(Protocol):
    """A linear elastic, axisymmetric half-space, or a pair of them; spoken to its implementer.

    Two functions are enough, the stiffness k(a) of a flat punch and the equivalent plane profile g(x); the rest
    follows (theory, section 0.2).  Lengths [m], moduli [Pa], stiffness [N/m]; arrays in, arrays out.
    """

    def gap(self, profile: Profile, x: Array) -> Array:
        """g(x) [m], the equivalent plane profile of `profile` in this medium."""
        ...

    def gap_slope(self, profile: Profile, x: Array) -> Array:
        """g'(x) [-]."""
        ...

    def gap_load(self, profile: Profile, radius: Array) -> Array:
        """The integral of k'(x) g(x) from 0 to `radius` [N]."""
        ...

    def punch_stiffness(self, radius: Array) -> Array:
        """k(a) [N/m], the stiffness of a flat cylindrical punch."""
        ...

    def normal_stiffness(self, x: Array) -> Array:
        """c_N(x) = k'(x)/2 [Pa], the stiffness of the springs per length."""
        ...

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T(x) [Pa], the same for tangential motion."""
        ...

    def pressure(self, displacement: Displacement, r: Array) -> Array:
        """p(r) [Pa], the superposition of flat punches that the springs' displacement asks for."""
        ...

    def displacement(self, displacement: Displacement, r: Array) -> Array:
        """The normal displacement of the surface [m], inside and outside the contact, sum over both bodies."""
        ...

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Stresses and displacements inside the first body (`below`) or the second, at depths z >= 0 into it.

        Raises `OutsideValidity` where they are not known, or the body is rigid.
        """
        ...

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is assumed about the medium."""
        ...
