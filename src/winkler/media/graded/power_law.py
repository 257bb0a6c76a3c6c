r"""Half-spaces whose modulus follows a power of the depth: springs that stiffen or soften away from the middle.

With :math:`E(z) = E_0 (z/c_0)^k` in one body, or in both with the same k, the springs have the stiffness

.. math:: c_N(x) = E^*\Big(\frac x{c_0}\Big)^k , \qquad k(a) = \frac{2E^*a^{1+k}}{(1+k)\,c_0^k} , \qquad
          \frac1{E^*} = \sum_i\frac{1-\nu_i^2}{h_N(k,\nu_i)\,E_{0,i}}

per length, and everything the method does for a homogeneous half-space stays exact with the exponents of
`winkler.numerics.transforms.graded_abel`.  With :math:`\beta = \sqrt{(1+k)(1-k\nu/(1-\nu))}`

.. math:: h_N = \frac{2(1+k)\cos(k\pi/2)\,\Gamma(1+\frac k2)}
                {\sqrt\pi\,C\,\beta\sin(\beta\pi/2)\,\Gamma(\frac{1+k}2)} , \qquad
          C = \frac{2^{1+k}\,\Gamma(\frac{3+k+\beta}2)\,\Gamma(\frac{3+k-\beta}2)}{\pi\,\Gamma(2+k)} .

Gibson's limit k = 1, nu = 1/2 is included: h_N = pi/2, p = (2/3)(E_0/c_0) u at every point, Winkler's foundation.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.materials.elastic import RIGID, Rigid
from winkler.materials.graded import PowerLawGraded
from winkler.media.graded import power_law_interior
from winkler.media.graded.profile import transform
from winkler.media.medium import Displacement, PunchFacts, exact_response, rigid_body
from winkler.media.punch_field import BodyField
from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.transforms import graded_abel
from winkler.numerics.transforms.graded_pressure import pressure as graded_pressure
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

Body = PowerLawGraded | Rigid
BOOKER = "J. R. Booker, N. P. Balaam, E. H. Davis, Int. J. Numer. Anal. Methods Geomech. 9 (1985) 369-381"


@value
class GradedHalfSpace:
    """Two half-spaces with a Young's modulus proportional to the same power of the depth, or one of them and a rigid
    body.

    Parameters
    ----------
    first : PowerLawGraded or Rigid
        The body below, z > 0.
    second : PowerLawGraded or Rigid, optional
        The body above, z < 0; rigid by default.

    Raises
    ------
    InvalidInput
        If both bodies are rigid, one is of another kind, or the exponents differ.

    References
    ----------
    A. E. Giannakopoulos, S. Suresh, Int. J. Solids Struct. 34 (1997) 2357-2428 (parts I and II)

    Examples
    --------
    >>> soil = PowerLawGraded(young=30e6, depth_scale=1.0, exponent=0.5, poisson=0.3)
    >>> round(GradedHalfSpace.between(soil).modulus / 1e6, 6)  # E_0 h_N / (1 - nu^2)
    37.628857
    """

    first: Body
    second: Body = RIGID

    def __post_init__(self) -> None:
        if not self._graded:
            raise InvalidInput("GradedHalfSpace: both bodies are rigid; at least one must be a PowerLawGraded.")
        if len({body.exponent for body in self._graded}) > 1:
            first, second = (body.exponent for body in self._graded)
            raise InvalidInput(
                f"GradedHalfSpace: the bodies have the exponents {first:g} and {second:g}; their springs are known "
                "only if both exponents are the same, or one body is rigid."
            )

    @classmethod
    def between(cls, first: Body, second: Body = RIGID) -> GradedHalfSpace:
        """Return the medium between two bodies; the second is rigid by default."""
        return cls(first, second)

    @property
    def _graded(self) -> list[PowerLawGraded]:
        return [body for body in (self.first, self.second) if isinstance(body, PowerLawGraded)]

    @functools.cached_property
    def exponent(self) -> float:
        """k [-], of both bodies."""
        return self._graded[0].exponent

    @property
    def depth_scale(self) -> float:
        """c_0 [m] to which the moduli refer: that of the first graded body."""
        return self._graded[0].depth_scale

    def _young(self, body: PowerLawGraded) -> float:
        """Return E_0 [Pa] of a body at the common depth scale; exact for equal exponents."""
        return float(body.young * (self.depth_scale / body.depth_scale) ** self.exponent)

    def _normal(self, body: PowerLawGraded) -> float:
        """Return (1 - nu^2) / (h_N E_0) of a body [1/Pa]."""
        factor = normal_factor(self.exponent, body.poisson)
        return (1.0 - body.poisson) * (1.0 + body.poisson) / (factor * self._young(body))

    def _along(self, body: PowerLawGraded) -> float:
        """Return (1 + k)^2 (1 - nu^2) / (beta^2 h_N E_0) of a body [1/Pa]."""
        return (1.0 + self.exponent) ** 2 * self._normal(body) / root_squared(self.exponent, body.poisson)

    def _across(self, body: PowerLawGraded) -> float:
        """Return (1 + nu) / (E_0 cos(k pi/2)) of a body [1/Pa]."""
        return (1.0 + body.poisson) / (graded_abel.right_cosine(self.exponent) * self._young(body))

    def _refuse_gibson(self) -> None:
        if self.exponent == 1.0:
            raise OutsideValidity(
                "GradedHalfSpace: Gibson's solid (exponent 1) has no tangential stiffness at all and does not resist a "
                "twist, its surface has no modulus; give an exponent below 1 for tangential problems and for torsion."
            )

    @functools.cached_property
    def modulus(self) -> float:
        """E* [Pa], 1/E* = sum of (1 - nu^2) / (h_N E_0)."""
        return 1.0 / math.fsum(map(self._normal, self._graded))

    @functools.cached_property
    def shear_modulus(self) -> float:
        """G* [Pa], 1/G* = sum of [(1+k)^2 (1-nu^2) / (beta^2 h_N E_0) + (1+nu) / (E_0 cos(k pi/2))] / 2."""
        self._refuse_gibson()
        return 2.0 / math.fsum(part(body) for body in self._graded for part in (self._along, self._across))

    @functools.cached_property
    def along_modulus(self) -> float:
        """m_L [Pa] of a shear along its wave, as under a line: 1/m_L = sum of (1+k)^2 (1-nu^2) / (beta^2 h_N E_0)."""
        self._refuse_gibson()
        return 1.0 / math.fsum(map(self._along, self._graded))

    @property
    def mismatch(self) -> float:
        """Zero for two equal bodies, in which the pressure causes equal tangential displacements; otherwise nan."""
        alike = len(self._graded) > 1 and len({(self._young(body), body.poisson) for body in self._graded}) == 1
        return 0.0 if alike else math.nan

    @functools.cached_property
    def torsional_modulus(self) -> float:
        """G_t [Pa], 1/G_t = sum of 2 (1+nu) (1+k)^2 / (E_0 cos(k pi/2)). The torsional spring stiffness is 8 G_t
        (x/c_0)^k x.
        """
        self._refuse_gibson()
        return 0.5 / ((1.0 + self.exponent) ** 2 * math.fsum(map(self._across, self._graded)))

    @property
    def notes(self) -> tuple[Note, ...]:
        """The assumptions."""
        return (
            *exact_response(
                "Frictionless contact of half-spaces whose modulus follows a power of the depth with constant "
                "Poisson's ratio. For one round contact the springs are equal to the three-dimensional solution.",
                BOOKER,
            ),
            Note(
                Assumption.RESPONSE,
                Standing.ASYMPTOTIC,
                "According to the power law the modulus at the surface itself is "
                + ("zero" if self.exponent > 0.0 else "infinite" if self.exponent < 0.0 else "that of the bulk")
                + ". A real graded body follows the law over a range of depths, which must contain the contact radius.",
                "A. E. Giannakopoulos, S. Suresh, Int. J. Solids Struct. 34 (1997) 2357-2392",
            ),
        )

    def gap(self, profile: Profile, x: Array) -> Array:
        """g(x) [m]."""
        return transform(profile, self.exponent).gap(np.asarray(x, dtype=float))

    def gap_slope(self, profile: Profile, x: Array) -> Array:
        """g'(x) [-]; above a kink of f at b it contains b jump x^-k (x^2 - b^2)^((k-1)/2)."""
        return transform(profile, self.exponent).gap_slope(np.asarray(x, dtype=float))

    def kinks(self, profile: Profile) -> tuple[tuple[float, float], ...]:
        """``(b, b jump)``: the strength b jump is the same for every k, the power above the kink is not."""
        return tuple((b, b * jump) for b, jump in profile.kinks)

    def gap_load(self, profile: Profile, radius: Array) -> Array:
        """2 E* / c_0^k times the integral of x^k g from 0 to `radius` [N]."""
        whole = transform(profile, self.exponent).gap_integral(np.asarray(radius, dtype=float))
        return 2.0 * self._surface_modulus * whole

    @property
    def _surface_modulus(self) -> float:
        """E* / c_0^k [Pa m^-k]."""
        return float(self.modulus / self.depth_scale**self.exponent)

    def punch_stiffness(self, radius: Array) -> Array:
        """k(a) = 2 E* a^(1+k) / ((1+k) c_0^k) [N/m]."""
        n = 1.0 + self.exponent
        return np.asarray(2.0 * self._surface_modulus * np.asarray(radius, dtype=float) ** n / n)

    def punch_shear_stiffness(self, radius: Array) -> Array:
        """k_x(a) = 2 G* a^(1+k) / ((1+k) c_0^k) [N/m]."""
        n = 1.0 + self.exponent
        scale = self.shear_modulus * self.depth_scale**-self.exponent
        return np.asarray(2.0 * scale * np.asarray(radius, dtype=float) ** n / n)

    def punch_torsional_stiffness(self, radius: Array) -> Array:
        """k_phi(a) = 16 G_t a^(3+k) / ((3+k) c_0^k) [N m]."""
        n = 3.0 + self.exponent
        scale = self.torsional_modulus * self.depth_scale**-self.exponent
        return np.asarray(16.0 * scale * np.asarray(radius, dtype=float) ** n / n)

    def punch_pressure(self, r: Array, radius: Array) -> Array:
        """p1(r; a) = (E* / c_0^k) (a^2 - r^2)^((k-1)/2) / pi [Pa/m]."""
        return np.asarray(self._surface_modulus / np.pi * root_difference(radius, r) ** (self.exponent - 1.0))

    def punch_facts(self, radius: float) -> PunchFacts:
        """Flat punches have no tension, and displace the surface outside the contact by less than their depth."""
        return PunchFacts(pulls=False, least=0.0, most=1.0, gives_separation=True)

    def _stiffness(self, modulus: float, x: Array) -> Array:
        x, k = np.asarray(x, dtype=float), self.exponent
        if k >= 0.0:
            return np.asarray(modulus * (x / self.depth_scale) ** k)
        safe = np.where(x > 0.0, x, 1.0)
        return np.where(x > 0.0, modulus * (safe / self.depth_scale) ** k, math.inf)

    def normal_stiffness(self, x: Array) -> Array:
        """c_N(x) = E* (x/c_0)^k [Pa]; infinite at x = 0 if k < 0."""
        return self._stiffness(self.modulus, x)

    def normal_stiffness_slope(self, x: Array) -> Array:
        """c_N'(x) = k c_N / x [Pa/m], for x > 0."""
        return np.asarray(self.exponent * self.normal_stiffness(x) / np.asarray(x, dtype=float))

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T(x) = G* (x/c_0)^k [Pa]; infinite at x = 0 if k < 0."""
        return self._stiffness(self.shear_modulus, x)

    def pressure(self, displacement: Displacement, r: Array) -> Array:
        """p(r) [Pa]: flat punches with the pressure (a^2 - r^2)^((k-1)/2), superposed.

        For a kink of the displacement only position and strength are used. In every graded medium the slope just above
        the kink contains -strength x^-k (x^2 - b^2)^((k-1)/2); the strength is b times the jump of f'.
        """
        return self._surface_modulus * graded_pressure(
            displacement.slope, displacement.kinks, displacement.edge, displacement.radius, self.exponent, r
        )

    def displacement(self, displacement: Displacement, r: Array) -> Array:
        """The displacement of the surface [m], inside and outside the contact, sum over both bodies."""
        edges = [b for b, _ in displacement.kinks]
        return graded_abel.surface(displacement.value, edges, self.exponent, r, displacement.radius)

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Stresses and displacements inside the first body (`below`) or the second, at depths z > 0 into it."""
        body = self.first if below else self.second
        if isinstance(body, Rigid):
            raise rigid_body(below)
        return power_law_interior.field(displacement, body, self._surface_modulus, r, z)


def root_squared(k: float, poisson: float) -> float:
    """Return beta^2 = (1 + k)(1 - k nu / (1 - nu))."""
    # written so that nothing cancels at nu = 1/2, k -> 1
    return (1.0 + k) * ((1.0 - k) * poisson + (1.0 - 2.0 * poisson)) / (1.0 - poisson)


def normal_factor(k: float, poisson: float) -> float:
    """Return h_N(k, nu): how much stiffer than a homogeneous body with E_0; one for k = 0."""
    if k == 1.0:
        return 0.5 * math.pi  # nu = 1/2: beta and cos(k pi/2) vanish together
    beta = math.sqrt(root_squared(k, poisson))
    lgamma = math.lgamma
    growth = (
        lgamma(1.0 + 0.5 * k)
        + lgamma(2.0 + k)
        - lgamma(0.5 * (1.0 + k))
        - lgamma(0.5 * (3.0 + k + beta))
        - lgamma(0.5 * (3.0 + k - beta))
    )
    shape = 2.0 * (1.0 + k) * graded_abel.right_cosine(k) * math.pi / (math.sqrt(math.pi) * 2.0 ** (1.0 + k))
    return float(shape) * math.exp(growth) / (beta * math.sin(0.5 * math.pi * beta))
