r"""The bed of a line contact on bodies whose modulus follows a power of the depth: flat punches of all half-widths.

A load per length moves the surface by :math:`B\,|x|^{-k}`, the integral of :math:`r^{-1-k}` of a point load along y.
Under a flat punch the pressure is :math:`q\propto(a^2-x^2)^{(k-1)/2}`, and beside it the surface falls like
:math:`-u' = kB\,(x^2-a^2)^{-(1+k)/2}` per load.  Punches of half-widths c with the loads :math:`P'\,\mathrm dc`
follow a profile if

.. math:: P(a) = \frac{E^*}{c_0^k}\frac{\Gamma(\frac{1+k}2)}{\sqrt\pi\,\Gamma(1+\frac k2)}
          \int_0^a\frac{x\,f'(x)\,\mathrm dx}{(a^2-x^2)^{(1-k)/2}} , \qquad
          p(x) = \int_{|x|}^a\frac{P'(c)\,\mathrm dc}{c^k\,\mathrm B(\frac12,\frac{1+k}2)\,(c^2-x^2)^{(1-k)/2}} .

For k > 0 the surface comes to rest far away, and the bodies approach by
:math:`\delta = P/K + \bar f` with the stiffness of the punch,
:math:`K = \frac k2E^*\frac{a^k}{c_0^k}\,\Gamma(\frac{1+k}2)^2/\Gamma(1+\frac k2)^2`, and the mean of f, weighted
like its pressure (Betti).  K vanishes with k: on a half-plane there is no approach.
"""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.graded.profile import transform
from winkler.media.layered.wave_constants import Wave
from winkler.numerics.integrals.jacobi_quadrature import gauss_jacobi
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.surfaces.strip_elements import element_compliance, linear_slope
from winkler.numerics.surfaces.strip_grid import strip_compliance
from winkler.numerics.transforms import graded_abel
from winkler.numerics.transforms.graded_pressure import pressure as graded_pressure
from winkler.numerics.transforms.strips.strip_transforms import StripTransforms
from winkler.numerics.types import Array
from winkler.profiles.conical import power_of
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.profile import Profile
from winkler.values.checks.number_checks import Advice
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.value import value

NODES = 48


@value
class PowerLawLineFoundation(LineBed):
    """A cylindrical body under a two-dimensional profile, endless along y, on bodies graded by a power; plane strain.

    Parameters
    ----------
    profile : Profile
        The gap f between the undeformed bodies, as in `LineFoundation`.
    medium : GradedHalfSpace
        Both bodies, E = E_0 (z/c_0)^k.

    Raises
    ------
    InvalidInput
        If the profile is an `AreaFunction`.

    References
    ----------
    A. E. Giannakopoulos, P. Pallot, J. Mech. Phys. Solids 48 (2000) 1597-1631, doi:10.1016/S0022-5096(99)00068-X

    Examples
    --------
    >>> from winkler.materials.graded import PowerLawGraded
    >>> soil = GradedHalfSpace(PowerLawGraded(young=30e6, depth_scale=1.0, exponent=0.5, poisson=0.3))
    >>> roller = PowerLawLineFoundation(Paraboloid(curvature_radius=0.6), soil)
    >>> round(float(roller.half_width(np.array([1e5 / soil.modulus]))[0]), 5)  # m, under 100 kN/m
    0.11373
    """

    profile: Profile
    medium: Annotated[
        GradedHalfSpace, Advice("homogeneous bodies go into a LineFoundation, layers into a LayeredLineFoundation")
    ]

    search_step: ClassVar[float] = 4.0

    sheared_as_pressed: ClassVar[bool] = True

    @property
    def exponent(self) -> float:
        """k [-]."""
        return self.medium.exponent

    @property
    def strained(self) -> Any:
        """Not supported: a bulk stress bends a body whose modulus changes with depth."""
        raise OutsideValidity(
            "A bulk stress in a body graded by a power of the depth is not even; give homogeneous bodies or layers."
        )

    @property
    def mismatch(self) -> float:
        """Zero for equal bodies; otherwise nan, and the coupling of the bodies is neglected."""
        return self.medium.mismatch

    def _stiffer(self, unit: float) -> float:
        """Return how far a line load moves the surface, with lengths over a unit [m], over half-planes [-]."""
        k = self.exponent
        length = math.exp(k * math.log(self.medium.depth_scale / unit))
        return 0.5 * math.pi * graded_abel.right_cosine(k) / graded_abel.half_beta(k) * length

    def shear_compliance(self, edges: Array) -> Array:
        """As `LineBed.shear_compliance`."""
        unit = float(edges[-1])
        return self.along_share * self._stiffer(unit) * element_compliance(edges / unit, self.exponent)

    def hat_compliance(self, count: int, spacing: float, reference: float) -> Array:
        """As `LineBed.hat_compliance`."""
        unit = strip_compliance(count, 1.0, reference / spacing, self.exponent)
        return self.along_share * self._stiffer(reference) * spacing * unit

    def slopes(self, part: Wave, nodes: Array, x: Array) -> Array:
        """As `LineBed.slopes`; coupling of different bodies is not supported."""
        if part is Wave.COUPLING:
            if not self.similar:
                raise OutsideValidity(
                    "Coupling of pressure and traction on a GradedHalfSpace of two different bodies is not "
                    "implemented: give coupled = False."
                )
            return np.zeros((x.size, nodes.size - 2))
        share, unit = self.along_share if part is Wave.ALONG else 1.0, float(nodes[-1] - nodes[0])
        slope = linear_slope(nodes / unit, x / unit, self.exponent)
        return 2.0 * share * self._stiffer(unit) * slope

    def drawn(self, x: Array, half_width: float) -> Array:
        """Zero: equal bodies have no coupling, and that of others is neglected."""
        return np.zeros(x.shape)

    def edge_share(self, half_width: Array) -> Array:
        r"""Return by how much less tension at the edges of a flat punch releases an energy than on half-planes [-].

        A load P of the edges releases :math:`-\tfrac14P^2\,\mathrm dK^{-1}/\mathrm da` per area, K the stiffness of the
        punch.
        """
        return np.sqrt(0.5 * math.pi * self.punch_softening(half_width))

    def edge_share_slope(self, half_width: Array) -> Array:
        """Return its derivative by the half-width [1/m]."""
        return np.asarray(-0.5 * self.exponent / half_width * self.edge_share(half_width))

    def zone_start(self, half_width: Array, reach: float, strength: float) -> Array:
        """Refused, as `zone_gap`."""
        return self.zone_gap(half_width, half_width, strength)[0]

    def zone_gap(self, half_width: Array, span: Array, strength: float) -> tuple[Array, Array]:
        """Not supported: an attraction with a range is not known here."""
        raise OutsideValidity(
            "An attraction with a range beside a strip on a GradedHalfSpace is not implemented; give ShortRange(work)."
        )

    def grid_transforms(self, nodes: Array) -> StripTransforms:
        """Return the transforms of worn contacts between nodes [m]."""
        return StripTransforms(nodes, self.exponent, self._scale, self._lifted)

    def punch_softening(self, half_width: Array) -> Array:
        """As `LineBed.punch_softening`: k E* over the stiffness of the punch."""
        k = self.exponent
        return np.asarray(0.5 * math.pi / graded_abel.half_beta(k) ** 2 * (self.medium.depth_scale / half_width) ** k)

    def stuck_compliance(self, half_width: float, unit: float) -> float:
        """As `LineBed.stuck_compliance`."""
        k = self.exponent
        if k == 0.0:
            return LineBed.stuck_compliance(self, half_width, unit)
        punch = 0.5 * math.pi / (graded_abel.half_beta(k) * graded_abel.right_cosine(k))
        under_punch = math.log(punch) - k * math.log(half_width / unit)
        return 2.0 / math.pi * self.along_share * self._stiffer(unit) * math.expm1(under_punch) / k

    @property
    def single(self) -> bool:
        """Whether every contact is known to be one strip: true for a profile that is one power."""
        return isinstance(self.profile, Paraboloid | PowerLaw)

    @property
    def _scale(self) -> float:
        """P / E* over the integral of x f' (a^2 - x^2)^((k-1)/2) [m^-k]."""
        return float(2.0 / math.pi * graded_abel.half_beta(self.exponent) * self.medium.depth_scale**-self.exponent)

    @property
    def _spread(self) -> float:
        """Integral of (1 - t^2)^((k-1)/2) over -1 < t < 1 [-]."""
        return 2.0 * graded_abel.half_beta(self.exponent)

    def _raised(self, a: Array, rate: bool) -> Array:
        """Return the integral of x f' (a^2 - x^2)^((k-1)/2) over a^(k-1), or its derivative by a: a g of slope x f'."""
        profile, k = self.profile, self.exponent
        c, n = power_of(profile)
        if n:
            power = transform(PowerLaw(c * n / (n + 1.0), n + 1.0), k)
            return power.gap_slope(a) if rate else power.gap(a)
        if not rate:
            return graded_abel.gap(lambda x: x * profile.slope(x), [b for b, _ in profile.kinks], k, a)
        curvature = getattr(profile, "curvature", None)
        if curvature is None:
            raise InvalidInput(
                f"PowerLawLineFoundation: the profile {type(profile).__name__} has no curvature(r), which its "
                "transform in a graded medium needs; subclass winkler.Shape and give it."
            )
        kinks = [(b, b * jump) for b, jump in profile.kinks]
        return graded_abel.gap_slope(
            lambda x: x * profile.slope(x), lambda x: profile.slope(x) + x * curvature(x), kinks, k, a
        )

    def half_width(self, load: Array) -> Array | None:
        """Return the half-widths [m] under loads per length over E* [m], of a parabolic cylinder: a^(2+k) bears P."""
        if not isinstance(self.profile, Paraboloid):
            return None
        whole = float(self.load_profile(np.ones(1))[0])
        return np.asarray((load / whole) ** (1.0 / (2.0 + self.exponent)))

    def load_profile(self, half_width: Array) -> Array:
        """Return the load per length over E* [m]."""
        a = np.asarray(half_width, dtype=float)
        with np.errstate(divide="ignore", invalid="ignore"):
            found = self._scale * a ** (self.exponent - 1.0) * self._raised(a, rate=False)
        return np.where(a > 0.0, found, 0.0)

    def load_profile_slope(self, half_width: Array) -> Array:
        """Return its derivative by the half-width [-]."""
        a, k = np.asarray(half_width, dtype=float), self.exponent
        safe = np.where(a > 0.0, a, 1.0)
        found = (k - 1.0) / safe * self._raised(safe, rate=False) + self._raised(safe, rate=True)
        return np.where(a > 0.0, self._scale * safe ** (k - 1.0) * found, 0.0)

    def punch_stiffness(self, half_width: Array) -> Array:
        """Return the load per length over the depth of a flat punch [Pa], for k > 0."""
        k = self.exponent
        ratio = 2.0 / math.sqrt(math.pi) * graded_abel.half_beta(k)
        return np.asarray(0.5 * k * ratio**2 * self.medium.modulus * (half_width / self.medium.depth_scale) ** k)

    def depth(self, half_width: Array, rim_load: Array) -> Array:
        """Return the approach of the bodies [m], counted from places far away.

        Parameters
        ----------
        half_width, rim_load : ndarray
            As in `pressure`.

        Raises
        ------
        OutsideValidity
            If k is not positive: then the surface displacement is infinite.
        """
        k, a = self.exponent, np.asarray(half_width, dtype=float)
        if k <= 0.0:
            raise OutsideValidity(
                f"Under a line contact the surface sinks without bound where the modulus does not grow with the depth "
                f"(exponent {k:g}): there is no depth; give an exponent above 0, or read half-width and pressure."
            )
        touching = np.where(a > 0.0, a, 1.0)
        load = self.medium.modulus * (self.load_profile(touching) + rim_load)
        kinks = [b for b, _ in self.profile.kinks]
        mean = graded_abel.gap(self.profile.height, kinks, k, touching) / (touching * graded_abel.half_beta(k))
        return np.where(a > 0.0, load / self.punch_stiffness(touching) + mean, 0.0)

    def pressure(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the pressure [Pa], as in `LineBed.pressure`; finite at a kink if k > 0."""
        k, away = self.exponent, np.abs(np.asarray(x, dtype=float))
        if isinstance(self.profile, Paraboloid) and rim_load == 0.0:
            # P' = (2 + k) P(1) c^(1+k), of which c alone is left over c^k
            whole = (2.0 + k) / (1.0 + k) * float(self.load_profile(np.ones(1))[0]) / self._spread
            inside = np.maximum((half_width - away) * (half_width + away), 0.0)
            return np.asarray(self.medium.modulus * whole * inside ** (0.5 * (1.0 + k)))
        factor = math.pi / self._spread
        kinks = [(b, factor * self._scale * b * jump) for b, jump in self.profile.kinks]
        part = graded_pressure(
            lambda c: -factor * self.load_profile_slope(c) * c**-k,
            kinks,
            factor * rim_load * half_width**-k,
            half_width,
            k,
            away,
        )
        return np.asarray(self.medium.modulus * part)

    def opening(self, x: Array, half_width: float) -> Array:
        """Return the slope h'(x) [-] of the distance of the surfaces at x > a: of the punches from a to x."""
        k, x = self.exponent, np.asarray(x, dtype=float)
        if k == 1.0:
            return self.profile.slope(x)
        # h' = 2 cos(k pi/2) / (pi scale) int P' (x^2 - c^2)^(-(1+k)/2) dc, with c^2 = x^2 - (x^2 - a^2) v
        node, weight = gauss_jacobi(NODES, -0.5 * (1.0 + k))
        inside = (x - half_width) * (x + half_width)
        c = np.sqrt(x[..., None] ** 2 - inside[..., None] * node)
        punches = (self.load_profile_slope(c.ravel()).reshape(c.shape) / c) @ weight
        return np.asarray(0.5 * self._lifted * inside ** (0.5 * (1.0 - k)) * punches)

    @property
    def _lifted(self) -> float:
        """Slope of the surface at x beside a flat punch of a unit load, times (x^2 - a^2)^((1+k)/2) [m^k]."""
        return graded_abel.right_cosine(self.exponent) / (0.5 * math.pi * self._scale)

    def separation(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the distance of the surfaces [m] at places x >= 0, zero inside; negative where they would overlap."""
        x = np.asarray(x, dtype=float)
        node, weight = gauss_legendre(NODES)
        beyond = np.maximum(x - half_width, 0.0)[..., None]
        places = half_width + beyond * node**2
        slope = self.opening(places, half_width) if half_width > 0.0 else self.profile.slope(places)
        apart = np.asarray((slope * 2.0 * node * beyond) @ weight)
        if rim_load != 0.0:  # what the edges bear as a flat punch, with t = a + (x - a) v
            power = -0.5 * (1.0 + self.exponent)
            node, weight = gauss_jacobi(NODES, power)
            fallen = beyond[..., 0] ** (1.0 + power) * ((2.0 * half_width + beyond * node) ** power @ weight)
            apart = apart - rim_load * self._lifted * fallen
        return apart
