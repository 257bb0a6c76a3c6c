r"""Two homogeneous, isotropic, elastic half-spaces: the medium of Hertz, Galin and Sneddon.

A flat punch has the stiffness :math:`k(a) = 2E^*a`, so the springs have the constant stiffness E* per length, and g
is the profile's own Abel transform.  Everything is exact for frictionless contact, and with friction if the
bodies are elastically similar.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from winkler.materials.elastic import RIGID, Elastic, Rigid, Solid
from winkler.media.interior import subsurface
from winkler.media.medium import Displacement, PunchFacts, exact_response, rigid_body
from winkler.media.punch_field import BodyField
from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile
from winkler.values.checks.contract import offered
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Note
from winkler.values.value import value

GALIN = "V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6"


@offered("a homogeneous medium, such as HalfSpace(first, second)")
class HomogeneousMedium:
    """What every homogeneous pair of half-spaces shares, once its two effective moduli are known."""

    first: Any
    second: Any
    """The bodies: this class knows the moduli of elastic ones, isotropic or transversely isotropic, and rigid ones."""

    def _compliance(self, part: str) -> float:
        """Return what both answer to waves of a name, times xi / 2 [1/Pa]."""
        from winkler.media.layered.wave_constants import Wave, half_space_compliance  # not loaded for isotropic bodies

        if not hasattr(self, "first"):  # a medium of a user's own, by its moduli
            raise OutsideValidity(
                f"{type(self).__name__} states no bodies `first` and `second` from which this modulus would follow; "
                "give its class `modulus`, `shear_modulus`, `torsional_modulus` and, for lines that are sheared, "
                "`along_modulus`."
            )
        return sum(half_space_compliance(body, Wave[part]) for body in (self.first, self.second))

    def _refuse_rigid(self, elastic: str) -> None:
        if isinstance(self.first, Rigid) and isinstance(self.second, Rigid):
            raise InvalidInput(f"{type(self).__name__}: both bodies are rigid; at least one must be {elastic}.")

    @functools.cached_property
    def modulus(self) -> float:
        """E* [Pa]."""
        return 1.0 / self._compliance("NORMAL")

    @functools.cached_property
    def shear_modulus(self) -> float:
        """G* [Pa]."""
        return 2.0 / (self._compliance("ALONG") + self._compliance("ACROSS"))

    @functools.cached_property
    def torsional_modulus(self) -> float:
        """G_t [Pa], 1/G_t = sum of 1/sqrt(C44 C66)."""
        return 0.5 / self._compliance("ACROSS")

    @functools.cached_property
    def along_modulus(self) -> float:
        """m_L [Pa] of shear along a wave, as in plane strain."""
        return 1.0 / self._compliance("ALONG")

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is assumed."""
        raise NotImplementedError

    def gap(self, profile: Profile, x: Array) -> Array:
        """g(x) [m]: the profile's own transform."""
        return profile.gap(x)

    def gap_slope(self, profile: Profile, x: Array) -> Array:
        """g'(x) [-]."""
        return profile.gap_slope(x)

    def kinks(self, profile: Profile) -> tuple[tuple[float, float], ...]:
        """``(b, b jump)``: above a jump of f' at b, g' holds b jump / sqrt(x^2 - b^2)."""
        return tuple((b, b * jump) for b, jump in profile.kinks)

    def gap_load(self, profile: Profile, radius: Array) -> Array:
        """2 E* times the integral of g from 0 to `radius` [N]."""
        return 2.0 * self.modulus * profile.gap_integral(radius)

    def punch_stiffness(self, radius: Array) -> Array:
        """k(a) = 2 E* a [N/m]."""
        return 2.0 * self.modulus * radius

    def punch_shear_stiffness(self, radius: Array) -> Array:
        """k_x(a) = 2 G* a [N/m]."""
        return np.asarray(2.0 * self.shear_modulus * np.asarray(radius, dtype=float))

    def punch_torsional_stiffness(self, radius: Array) -> Array:
        """k_phi(a) = 16 G_t a^3 / 3 [N m]."""
        return np.asarray(16.0 / 3.0 * self.torsional_modulus * np.asarray(radius, dtype=float) ** 3)

    def punch_pressure(self, r: Array, radius: Array) -> Array:
        """p1(r; a) = E* / (pi sqrt(a^2 - r^2)) [Pa/m]."""
        return np.asarray(self.modulus / (np.pi * root_difference(radius, r)))

    def punch_facts(self, radius: float) -> PunchFacts:
        """No flat punch pulls, or lifts the surface, or sinks it beyond its own depth."""
        return PunchFacts(pulls=False, least=0.0, most=1.0, gives_separation=True)

    def normal_stiffness(self, x: Array) -> Array:
        """c_N = E* [Pa], the same for every spring."""
        return np.full(np.shape(x), self.modulus)

    def normal_stiffness_slope(self, x: Array) -> Array:
        """c_N' = 0 [Pa/m]."""
        return np.zeros(np.shape(x))

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T = G* [Pa], the same for every spring."""
        return np.full(np.shape(x), self.shear_modulus)

    def pressure(self, displacement: Displacement, r: Array) -> Array:
        """p(r) [Pa] by T4."""
        return self.modulus * abel.pressure(
            displacement.slope, displacement.kinks, displacement.edge, displacement.radius, r
        )

    def displacement(self, displacement: Displacement, r: Array) -> Array:
        """The displacement of the surface [m] by T3, inside and outside the contact, sum over both bodies."""
        edges = [b for b, _ in displacement.kinks]
        return abel.surface(displacement.value, edges, r, displacement.radius)


@value
class HalfSpace(HomogeneousMedium):
    """Two homogeneous, isotropic half-spaces in contact.

    Parameters
    ----------
    first : Elastic or Rigid
        The body below, z > 0.
    second : Elastic or Rigid, optional
        The body above, z < 0; rigid by default.

    Raises
    ------
    InvalidInput
        If both bodies are rigid.

    Examples
    --------
    >>> steel = Elastic(young=210e9, poisson=0.3)
    >>> round(HalfSpace.between(steel, steel).modulus / 1e9, 6)
    115.384615
    """

    first: Solid
    second: Solid = RIGID

    def __post_init__(self) -> None:
        self._refuse_rigid("Elastic(young, poisson)")

    @classmethod
    def between(cls, first: Solid, second: Solid = RIGID) -> HalfSpace:
        """Return the medium between two bodies; the second is rigid by default."""
        return cls(first, second)

    @property
    def _elastic(self) -> list[Elastic]:
        return [body for body in (self.first, self.second) if isinstance(body, Elastic)]

    @functools.cached_property
    def modulus(self) -> float:
        """E* [Pa], 1/E* = sum of (1 - nu^2) / E."""
        return self.modulus_with({})

    def modulus_with(self, numbers: Mapping[str, float]) -> float:
        """Return E* [Pa] with other numbers of the bodies, as "first.young", without a new medium."""
        return 1.0 / sum(
            (1.0 - numbers.get(f"{name}.poisson", body.poisson) ** 2) / numbers.get(f"{name}.young", body.young)
            for name, body in (("first", self.first), ("second", self.second))
            if isinstance(body, Elastic)
        )

    @functools.cached_property
    def shear_modulus(self) -> float:
        """G* [Pa], 1/G* = sum of (2 - nu) / (4 G)."""
        return 1.0 / sum((2.0 - body.poisson) / (4.0 * body.shear) for body in self._elastic)

    @functools.cached_property
    def torsional_modulus(self) -> float:
        """G_t [Pa], 1/G_t = sum of 1/G."""
        return 1.0 / sum(1.0 / body.shear for body in self._elastic)

    @functools.cached_property
    def along_modulus(self) -> float:
        """m_L [Pa]: E*."""
        return self.modulus

    @property
    def mismatch(self) -> float:
        """Dundurs' second constant beta [-]; zero for elastically similar bodies."""
        first, second = (
            (1.0 - 2.0 * body.poisson) / body.shear if isinstance(body, Elastic) else 0.0
            for body in (self.first, self.second)
        )
        return self.modulus * 0.25 * (first - second)

    notes = exact_response(
        "Homogeneous, isotropic, linear elastic half-spaces. For one round contact the springs give the "
        "exact normal force, depth and pressure of the three-dimensional solution.",
        GALIN,
    )
    """What is assumed of the half-spaces."""

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Stresses and displacements inside the first body (`below`) or the second, at depths z >= 0 into it."""
        body = self.first if below else self.second
        if not isinstance(body, Elastic):
            raise rigid_body(below)
        return subsurface.field(displacement, r, z, modulus=self.modulus, poisson=body.poisson, shear=body.shear)

    @property
    def strengths(self) -> tuple[float, float]:
        """Yield strength of the first and the second body [Pa]; infinite where not given."""
        first, second = (body.strength if isinstance(body, Elastic) else math.inf for body in (self.first, self.second))
        return first, second
