r"""The bed of a line contact: a two-dimensional profile on two half-planes, per length.

With w(a) of `winkler.profiles.line_transform`,

.. math:: P(a) = E^* w(a) , \qquad p(x) = \frac{E^*}\pi\int_{|x|}^a\frac{w'(c)}{\sqrt{c^2-x^2}}\,\mathrm dc .

A growing contact is a pile of flat punches of half-widths c, each of which adds the load :math:`\mathrm dP = E^* w'
\mathrm dc` with the pressure :math:`\mathrm dP/(\pi\sqrt{c^2-x^2})`.  So the pressure is that of a body of revolution
whose equivalent plane profile is w: the transforms of `winkler.numerics.transforms` serve both.  A rim at b bears the
rest of the load as a flat punch.  Beside the contact the distance of the surfaces opens with the slope

.. math:: h'(x) = \frac2\pi\int_a^x\frac{w'(c)}{\sqrt{x^2-c^2}}\,\mathrm dc , \qquad
          h(x) = \frac2\pi\int_a^x w'(c)\,\mathrm{arcosh}\frac xc\,\mathrm dc ,

from one place where w' is not smooth to the next; with :math:`c^2 = b^2 + y^2` above each, and y over its greatest
value a sine, both square roots at the ends of the second integral are gone.  A parabolic cylinder has closed forms.

Beside a strip to which a constant stress :math:`-\sigma_0` pulls from a to c, the flat punches go on beyond it.  With
:math:`l = \sqrt{c^2-a^2}` its potential below the surface, and the distance of the surfaces at c, are

.. math:: F(\zeta) = -\frac{2\sigma_0}\pi\ln\frac{l+\sqrt{\zeta^2-a^2}}{\sqrt{\zeta^2-c^2}} , \qquad
          h(c) = \frac2\pi\int_a^c w'(s)\,\mathrm{arcosh}\frac cs\,\mathrm ds
          + \frac{4\sigma_0}{\pi E^*}\Big[l\,\mathrm{arcosh}\frac ca - c\ln\frac ca\Big] .

For a cylinder the integral is :math:`\frac1{2R}\big[cl - a^2\,\mathrm{arcosh}\frac ca\big]` (Baney and Hui).
"""

from __future__ import annotations

import functools
import math
from itertools import pairwise
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.line_bed import LineBed, Zone
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.fields.half_plane import Pile, potential
from winkler.numerics.integrals.adaptive_quadrature import settled
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.panels.abel_intervals import noise, root_difference
from winkler.numerics.panels.chebyshev import fit_panels
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array, Curve
from winkler.profiles.flat import CappedCylinder
from winkler.profiles.line_transform import line_load, line_load_slope
from winkler.profiles.power import Paraboloid
from winkler.profiles.profile import Profile
from winkler.values.checks.number_checks import Advice
from winkler.values.value import value

DENSITY_TOLERANCE = 1e-13
"""Error of w' over its greatest value, where the stresses below are computed from it."""
ZONE_NODES = 64
NODES, PIECE = 16, 1.5
"""Nodes on each piece of the integral over arcosh(c/s)."""
FARTHEST = 40.0
"""Greatest arcosh(c/s): nearer to the middle nothing is left of the integral."""


@value
class LineFoundation(LineBed):
    """A cylindrical body under a two-dimensional profile, endless along y, on two elastic half-planes.

    Parameters
    ----------
    profile : Profile
        The gap f between the undeformed bodies at the distance of x from the middle. `Paraboloid` is a parabolic
        cylinder, `Cone` a wedge, `FlatPunch` a flat punch of half-width `radius`, `RoundedPunch` a flat punch with
        rounded edges.
    medium : HalfSpace or TransverselyIsotropicHalfSpace
        Both bodies, homogeneous, in plane strain.

    Raises
    ------
    InvalidInput
        If the profile is an `AreaFunction`, which belongs to a tip of revolution.

    References
    ----------
    J. Jaeger, Arch. Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661
    """

    profile: Profile
    medium: Annotated[
        HomogeneousMedium,
        Advice("layers go into a LayeredLineFoundation, and other media are not implemented for line contacts"),
    ]

    sheared_as_pressed: ClassVar[bool] = True

    @property
    def hertz_radius(self) -> float:
        """R of a parabolic cylinder [m]; infinite for other profiles."""
        return self.profile.curvature_radius if isinstance(self.profile, Paraboloid) else math.inf

    @property
    def _round(self) -> float:
        """R of a parabolic cylinder [m], whose closed forms hold; infinite for other profiles."""
        shape = self.profile.cap if isinstance(self.profile, CappedCylinder) else self.profile
        return shape.curvature_radius if isinstance(shape, Paraboloid) else math.inf

    def half_width(self, load: Array) -> Array | None:
        """Return the half-widths [m] under loads per length over E* [m], of a parabolic cylinder."""
        return np.sqrt(4.0 * self._round * load / math.pi) if self.hertzian else None

    def load_profile(self, half_width: Array) -> Array:
        """w(a) [m], the load per length over E*."""
        return line_load(self.profile, half_width)

    def load_profile_slope(self, half_width: Array) -> Array:
        """w'(a) [-]."""
        return line_load_slope(self.profile, half_width)

    def repeated(self, profile: Profile, pitch: float) -> LineFoundation:
        """Return the foundation of strips at a pitch [m] with a given profile over u."""
        return LineFoundation(profile, self.medium)

    def zoned(self, strength: float, half_width: float, outer: float) -> ZonedBed:
        """Return the bed with the attraction beside a strip, as in `LineBed.zoned`."""
        return ZonedBed(self.profile, self.medium, strength, half_width, outer)

    def zone_start(self, half_width: Array, reach: float, strength: float) -> Array:
        """Return at least how far an attraction with a range `reach` [m] goes on beside strips, the span l [m]."""
        factor = 4.0 * strength / (math.pi * self.medium.modulus)
        span = np.full(half_width.shape, reach / factor)
        while np.any(short := factor * _pulled(half_width, span)[0] < reach):
            span = np.where(short, 2.0 * span, span)
        return span

    def zone_gap(self, half_width: Array, span: Array, strength: float) -> tuple[Array, Array]:
        """Return the distance of the surfaces where an attraction ends, as in `LineBed.zone_gap`."""
        apart, opening = _apart(self, half_width, span)
        whole, by_end = _pulled(half_width, span)
        factor = 4.0 * strength / (math.pi * self.medium.modulus)
        return apart + factor * whole, (opening + factor * by_end) * span / np.hypot(half_width, span)

    def zone_load(self, half_width: Array, span: Array, strength: float) -> Array:
        """Return the load per length over E* of strip and attraction, as in `LineBed.zone_load`."""
        return np.asarray(self.load_profile(half_width) - 2.0 * strength / self.medium.modulus * span)

    def zone_load_slope(self, half_width: Array, span: Array, strength: float) -> Array:
        """Return its derivative by the half-width, as in `LineBed.zone_load_slope`."""
        a, growth = half_width, self.load_profile_slope(half_width)
        factor = 4.0 * strength / (math.pi * self.medium.modulus)
        opening, by_end = _apart(self, a, span)[1], _pulled(a, span)[1]
        closing = 2.0 / math.pi * growth * np.where(a > 0.0, _arcosh(a, span), 0.0)
        # l l' = c c' - a, put together so that nothing cancels where the attraction ends close to the strip
        whole = np.hypot(a, span) * closing - a * opening + factor * a * _log_ratio(a, span)
        span_slope = whole / ((opening + factor * by_end) * span)
        return np.asarray(growth - 2.0 * strength / self.medium.modulus * span_slope)

    def pressure(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the pressure of a contact.

        Parameters
        ----------
        x : ndarray
            Positions on the surface [m], on either side.
        half_width : float
            a [m].
        rim_load : float
            Load per length over E* of the edge in addition to w(a) [m]: positive at a rim, negative under adhesion.

        Returns
        -------
        ndarray
            p [Pa]; zero outside; infinite at a rim, a kink and a sharp tip.
        """
        if math.isfinite(self._round) and rim_load == 0.0:
            root = np.sqrt(np.maximum((half_width - x) * (half_width + x), 0.0))
            return np.asarray(self.medium.modulus / (2.0 * self._round) * root)
        kinks = tuple((b, strength) for b, strength in self.kinks if b < half_width)
        part = abel.pressure(lambda c: -self.load_profile_slope(c), kinks, rim_load, half_width, np.abs(x))
        return np.asarray(self.medium.modulus * part)

    def mean_pressures(self, edges: Array, half_width: float, rim_load: float) -> Array:
        """Return the mean pressure [Pa] between places, as in `LineBed.mean_pressures`."""
        if not self.hertzian:
            return LineBed.mean_pressures(self, edges, half_width, rim_load)
        angles = np.arcsin(np.minimum(edges / half_width, 1.0))
        share = self.medium.modulus * half_width**2 / (4.0 * self._round)
        return np.asarray(share * np.diff(0.5 * np.sin(2.0 * angles) + angles) / np.diff(edges))

    def separation(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the distance of the surfaces [m] at places x >= 0, zero inside."""
        beside = np.maximum(np.ravel(np.asarray(x, dtype=float)), half_width)
        if half_width == 0.0:
            return np.asarray(self.profile.height(x))
        root = root_difference(beside, half_width)
        if self.hertzian:
            apart = (beside * root - half_width**2 * np.arcsinh(root / half_width)) / (2.0 * self._round)
        else:
            apart = _beside(self, half_width, beside)
        logarithm = np.log1p((beside - half_width + root) / half_width) if rim_load else 0.0
        return np.asarray((apart - 2.0 / math.pi * rim_load * logarithm).reshape(np.shape(x)))

    def drawn(self, x: Array, half_width: float) -> Array:
        """Return how far the pressure moves the first surface beyond the second [m], as in `LineBed.drawn`."""
        if not self.hertzian:
            return LineBed.drawn(self, x, half_width)
        level = -self.mismatch * half_width**2 / (2.0 * self._round)  # 2 beta p0 a / E* times 1/2
        t = np.clip(x / half_width, -1.0, 1.0)
        return np.asarray(level * (t * np.sqrt(1.0 - t * t) + np.arcsin(t)))

    def opening(self, x: Array, half_width: float) -> Array:
        """Return the slope h'(x) [-] of the distance of the surfaces at x > a."""
        edges = [b for b, _ in self.kinks]
        inner = abel.surface(self.load_profile_slope, edges, x, half_width)
        return np.asarray(self.slope(x) - inner)

    def surface_potential(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return F(x) [Pa] of `potential` on the surface itself, at x >= 0: its imaginary part is -p."""
        edges = [b for b, _ in self.kinks]
        along = 0.5 * abel.surface(self.load_profile_slope, edges, x, half_width)
        outside = x > half_width
        along[outside] += rim_load / (np.pi * root_difference(x[outside], half_width))
        found = np.empty(x.shape, dtype=complex)
        found.real, found.imag = self.medium.modulus * along, -self.pressure(x, half_width, rim_load)
        return found

    def potential(self, x: Array, z: Array, half_width: float, rim_load: float) -> tuple[Array, Array]:
        """Return the potential F [Pa] of the pressure and F' [Pa/m], below the surface (`numerics.fields.half_plane`).

        Parameters
        ----------
        x, z : ndarray, (m,)
            Positions [m], x not negative, z positive.
        half_width, rim_load : float
            As in `pressure`.
        """
        zeta = x + 1j * z
        root = np.sqrt(zeta - half_width) * np.sqrt(zeta + half_width)
        if math.isfinite(self._round):  # McEwen
            share = half_width / (2.0 * self._round)
            whole = share * half_width / (zeta + root)
            slope = -whole / root
        else:
            whole, slope = potential(_piles(self, half_width), x, z)
        if rim_load != 0.0:
            rim = rim_load / (np.pi * root)
            whole, slope = whole + rim, slope - rim * zeta / root**2
        return self.medium.modulus * whole, self.medium.modulus * slope


@functools.lru_cache(maxsize=16)
def _piles(bed: LineFoundation, half_width: float) -> tuple[Pile, ...]:
    """Return the flat punches of the contact, from kink to kink."""
    edges = [0.0, *(b for b, _ in bed.kinks if b < half_width), half_width]
    sample = np.abs(bed.load_profile_slope(half_width * np.linspace(0.02, 1.0, 33)))
    tolerance = DENSITY_TOLERANCE * float(np.max(sample[np.isfinite(sample)]))
    return tuple(
        Pile(low, fit_panels(_density(bed, low, high), np.array([0.0, top]), tolerance))
        for low, high in pairwise(edges)
        if (top := float(root_difference(np.array(high), low))) > 0.0
    )


def _density(bed: LineFoundation, low: float, high: float) -> Curve:
    first = np.nextafter(low, np.inf) if low > 0.0 else 0.0

    def density(y: Array) -> Array:
        c = np.clip(np.hypot(low, y), first, high)
        return np.asarray(bed.load_profile_slope(c) * (root_difference(c, low) / c if low > 0.0 else 1.0))

    return density


def _beside(bed: LineFoundation, half_width: float, x: Array) -> Array:
    """Return the distance of the surfaces [m] beside a strip that no rim pins, at places x >= a."""
    total = np.zeros(x.size)
    for low, high in pairwise([half_width, *(b for b, _ in bed.kinks if b > half_width), math.inf]):
        (active,) = np.nonzero(x > low)
        if active.size:
            total[active] += _between(bed, low, high, x[active])
    return 2.0 / math.pi * total


def _between(bed: LineFoundation, low: float, high: float, x: Array) -> Array:
    span = root_difference(x, low)
    width = np.full(x.shape, 0.5 * math.pi)
    if high < math.inf:
        last = np.arctan2(root_difference(np.asarray(high), low), root_difference(x, high))
        width = np.where(x <= high, width, last)
    first = np.nextafter(low, math.inf)

    def integrand(node: Array, index: Array) -> Array:
        angle = width[index, None] * node
        reach = span[index, None]
        y, rest = reach * np.sin(angle), reach * np.cos(angle)
        c = np.clip(np.hypot(low, y), first, np.minimum(x[index, None], high))
        slope = bed.load_profile_slope(c.ravel()).reshape(c.shape)
        grown: Array = slope * np.arcsinh(rest / c) * (y / c) * rest * width[index, None]
        return grown

    return settled(integrand, x.size, "the distance beside a strip", noise(x, low))


def _apart(bed: LineFoundation, a: Array, span: Array) -> tuple[Array, Array]:
    """Return the distance [m] of the surfaces at c beside a contact without attraction, and its slope [-]."""
    c = np.hypot(a, span)
    wide = np.minimum(_arcosh(a, span), FARTHEST)
    if bed.hertzian:
        twice = 2.0 * bed.hertz_radius
        return (c * span - a * a * wide) / twice, 2.0 * span / twice
    pieces = max(1, math.ceil(float(np.max(wide)) / PIECE))
    nodes, weights = gauss_legendre(NODES)
    share = (np.arange(pieces)[:, None] + nodes).ravel() / pieces
    v = wide[:, None] * share
    s = c[:, None] / np.cosh(v)
    density = bed.load_profile_slope(s) * s * np.tile(weights, pieces) / pieces * wide[:, None]
    apart = 2.0 / math.pi * np.sum(density * v * np.tanh(v), axis=1)
    return apart, 2.0 / math.pi * np.sum(density, axis=1) / c


def _arcosh(a: Array, span: Array) -> Array:
    """Return arcosh(c/a), infinite at a = 0."""
    with np.errstate(divide="ignore"):
        return np.asarray(np.arcsinh(np.divide(span, a, out=np.full(a.shape, np.inf), where=a > 0.0)))


def _pulled(a: Array, span: Array) -> tuple[Array, Array]:
    """Return l arcosh(c/a) - c ln(c/a) [m] and its derivative by c [-]; l > 0."""
    c = np.hypot(a, span)
    ratio = _log_ratio(a, span)
    rest = np.log1p(span / c)  # ln((l + c)/c)
    whole = span * rest - a * a / (span + c) * ratio
    by_c = c / span * rest + a * a / (span * (span + c)) * ratio
    return whole, by_c


def _log_ratio(a: Array, span: Array) -> Array:
    """Return ln(c/a), zero at a = 0."""
    return np.asarray(0.5 * np.log1p(np.divide(span, a, out=np.zeros(a.shape), where=a > 0.0) ** 2))


@value
class ZonedBed(Zone, LineFoundation):
    """A line contact and the attraction beside one strip of it."""

    @property
    def hertz_radius(self) -> float:
        """Infinite: the attraction alters the pressure."""
        return math.inf

    def beside(self, half_width: float) -> tuple[Array, Array]:
        """Return half-widths [m] of the flat punches beside the strip, and their loads over E* [m]."""
        y, weights = gauss_legendre(ZONE_NODES)
        widths = np.sqrt(self.outer**2 - (self.span * y) ** 2)
        return widths, -2.0 * self.strength / self.medium.modulus * self.span * weights

    def pressure(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the pressure [Pa], negative where the surfaces attract each other."""
        away = np.abs(x)
        inside = np.sqrt(np.maximum((half_width - away) * (half_width + away), 0.0))
        pull = np.where(away < self.outer, 2.0 * self.strength / math.pi * np.arctan2(self.span, inside), 0.0)
        return np.asarray(LineFoundation.pressure(self, x, half_width, rim_load) - pull)

    def surface_potential(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return F [Pa] on the surface."""
        with np.errstate(divide="ignore"):
            zone, _ = self._zone(np.asarray(x) + 0j)
        along = LineFoundation.surface_potential(self, x, half_width, rim_load).real + zone.real
        return np.asarray(along - 1j * self.pressure(x, half_width, rim_load))

    def potential(self, x: Array, z: Array, half_width: float, rim_load: float) -> tuple[Array, Array]:
        """Return F [Pa] and F' [Pa/m] below the surface."""
        whole, slope = LineFoundation.potential(self, x, z, half_width, rim_load)
        zone, grown = self._zone(x + 1j * z)
        return whole + zone, slope + grown

    def separation(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the distance of the surfaces [m] at places x >= 0, lifted by the attraction."""
        lifted = self.pulled_apart(np.ravel(np.maximum(x, half_width))).reshape(x.shape)
        return LineFoundation.separation(self, x, half_width, rim_load) + np.where(x > half_width, lifted, 0.0)

    def _zone(self, zeta: Array) -> tuple[Array, Array]:
        a, c = self.contact, self.outer
        inner = np.sqrt(zeta - a) * np.sqrt(zeta + a)
        outer = np.sqrt(zeta - c) * np.sqrt(zeta + c)
        factor = -2.0 * self.strength / math.pi
        with np.errstate(divide="ignore", invalid="ignore"):
            whole = factor * np.log((self.span + inner) / outer)
            slope = factor * zeta * (1.0 / (inner * (self.span + inner)) - 1.0 / outer**2)
        return whole, slope

    def pulled_apart(self, x: Array) -> Array:
        """Return by how much the attraction lifts the surfaces at places x >= a [m]: they end at less than without."""
        t, weights = gauss_legendre(ZONE_NODES)
        first = np.sqrt(np.maximum((self.outer - x) * (self.outer + x), 0.0)) / self.span
        y = first[:, None] + (1.0 - first[:, None]) * t**2
        widths = np.sqrt(np.maximum(self.outer**2 - (self.span * y) ** 2, self.contact**2))
        ratio = np.maximum(x[:, None] / np.maximum(widths, 1e-300), 1.0)
        lifted = np.sum(np.arccosh(ratio) * 2.0 * t * weights, axis=1) * (1.0 - first)
        return np.asarray(4.0 * self.strength / (math.pi * self.medium.modulus) * self.span * lifted)
