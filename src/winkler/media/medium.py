"""The contract of a medium: the transforms between a body and its springs."""

from __future__ import annotations

from typing import NamedTuple, Protocol

from winkler.media.punch_field import BodyField
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile
from winkler.values.checks.contract import offered
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing


class PunchFacts(NamedTuple):
    """What is known of all flat punches up to some radius, pressed to unit depth.

    Where none `pulls` and g never falls, no contact needs tension, since its pressure is a sum of flat punches'.

    `gives_separation` is whether springs beyond the edge give the separation: it is then an integral of g - d with a
    positive kernel.  In other media the separation at r is that of :math:`g'(x)(1-u_1(r;x))` from the edge to r, u1
    the displacement of the surface outside a flat punch of radius x, which lies between `least` and `most`.  Farther
    than `flat_beyond` [m] from the edge of the punch it lies above `LEAST_SURFACE_RISE`.
    """

    pulls: bool
    least: float
    most: float
    gives_separation: bool
    flat_beyond: float = 0.0


LEAST_SURFACE_RISE = -0.25
"""A surface that rises by less than this part of the depth of a punch is not tested for contact with the body."""


def rigid_body(below: bool) -> OutsideValidity:
    """Return the refusal of a field inside a rigid body: the first one (`below`), or the second."""
    side = "first body (z > 0)" if below else "second body (z < 0)"
    return OutsideValidity(f"The {side} is rigid; there is no stress field in it: request the other side.")


def exact_response(text: str, source: str) -> tuple[Note, ...]:
    """Return what an exact medium assumes: one note on how its bodies respond."""
    return (Note(Assumption.RESPONSE, Standing.EXACT, text, source),)


class Displacement(Protocol):
    """The displacement u(x) of the springs: d - g(x) in contact, nothing outside; even in x.

    Methods take an array of x >= 0 [m].  `kinks` lists ``(x, strength)`` where u is not smooth: just above x the
    slope behaves like ``-strength / sqrt(x**2 - x_kink**2)``, or as `Medium.kinks` states for the medium (strength zero
    where it does not diverge).
    """

    @property
    def radius(self) -> float:
        """Contact radius a [m]."""

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)`` of every non-smooth point inside the contact, ascending."""

    @property
    def edge(self) -> float:
        """u(a-) [m], the jump at the edge of the contact; zero where the contact closes smoothly."""

    def value(self, x: Array) -> Array:
        """u(x) [m] for x <= a."""

    def slope(self, x: Array) -> Array:
        """u'(x) [-] for x <= a."""


@offered("a medium, such as HalfSpace(first, second)")
class Medium(Protocol):
    """A linear elastic, axisymmetric half-space, or a pair of them; written for its implementer.

    Two functions are enough, the stiffness k(a) of a flat punch and the equivalent plane profile g(x); the rest
    follows (theory, section 0.2).  Lengths [m], moduli [Pa], stiffness [N/m]; arrays in, arrays out.
    """

    def gap(self, profile: Profile, x: Array) -> Array:
        """g(x) [m], the equivalent plane profile of `profile` in this medium."""

    def gap_slope(self, profile: Profile, x: Array) -> Array:
        """g'(x) [-]."""

    def kinks(self, profile: Profile) -> tuple[tuple[float, float], ...]:
        """``(x, strength)`` of every place where g of this profile is not smooth, ascending.

        Above a jump of f' at b, g' diverges like strength / sqrt(x^2 - b^2).  Power-law media have another power
        there, x^-k (x^2 - b^2)^((k-1)/2), and the factor of that is the strength.
        """

    def gap_load(self, profile: Profile, radius: Array) -> Array:
        """The integral of k'(x) g(x) from 0 to `radius` [N]."""

    def punch_stiffness(self, radius: Array) -> Array:
        """k(a) [N/m], the stiffness of a flat cylindrical punch."""

    def punch_pressure(self, r: Array, radius: Array) -> Array:
        """p1(r; a) [Pa/m], the pressure of a flat punch at unit depth; r and radii of one shape, r < a."""

    def punch_facts(self, radius: float) -> PunchFacts:
        """What is known of all flat punches up to this radius [m]."""

    def normal_stiffness(self, x: Array) -> Array:
        """c_N(x) = k'(x)/2 [Pa], the stiffness of the springs per length."""

    def normal_stiffness_slope(self, x: Array) -> Array:
        """c_N'(x) [Pa/m], for x > 0: what decides whether an adhesive edge is stable."""

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T(x) [Pa], the same for tangential motion."""

    def pressure(self, displacement: Displacement, r: Array) -> Array:
        """p(r) [Pa], the superposition of flat punches that belongs to the springs' displacement."""

    def displacement(self, displacement: Displacement, r: Array) -> Array:
        """The normal displacement of the surface [m], inside and outside the contact, sum over both bodies."""

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Stresses and displacements inside the first body (`below`) or the second, at depths z >= 0 into it.

        Raises `OutsideValidity` where they are not known, or the body is rigid.
        """

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is assumed about the medium."""
