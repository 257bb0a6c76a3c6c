r"""Periodic line contacts: strips side by side at one pitch, as one strip of another profile.

With :math:`u = \frac\lambda\pi\sin\frac{\pi x}\lambda` the equation between the slope and the pressure of strips at the
pitch :math:`\lambda` is that of a single one,

.. math:: \int p(s)\,\frac\pi\lambda\cot\frac{\pi(x-s)}\lambda\,\mathrm ds = \pi E^*\,\frac{f'(x)}2
          \quad\Longleftrightarrow\quad
          \int \frac{\tilde p(v)}{u-v}\,\mathrm dv = \pi E^*\,\frac{\tilde f'(u)}2 , \qquad
          \tilde f(u) = f(x), \quad \tilde p = \frac{p}{\cos(\pi x/\lambda)} ,

with the same force per strip.  A sinusoidal wave :math:`h(1-\cos 2\pi x/\lambda)` is :math:`2\pi^2 h\,u^2/\lambda^2`, a
parabola: Westergaard's wavy half-plane is Hertz' cylinder.  All is in contact at :math:`u = \lambda/\pi`, the rim of a
flat punch whose pressure :math:`\cos(\pi x/\lambda)/\sqrt{1-\sin^2(\pi x/\lambda)}` is even.

References
----------
H. M. Westergaard, J. Appl. Mech. 6 (1939) A49-A53
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from winkler.foundation.line_bed import LineBed, PressedPair
from winkler.numerics.types import Array
from winkler.profiles.flat import CappedCylinder
from winkler.profiles.power import Paraboloid
from winkler.profiles.profile import Profile, Shape, Sum
from winkler.profiles.wavy import Wavy
from winkler.values.checks.number_checks import Positive
from winkler.values.value import value, words

if TYPE_CHECKING:  # numerics of layers are loaded with layers
    from winkler.media.layered.plane_interior import PlaneWaves
    from winkler.media.offers import LayerStack

DEEP = 4.0
"""Depth over the pitch from which the stresses are even, to about 1e-11."""
MOST_HARMONICS = 8
WALL = 1e-6
"""Part of the rim that is left out before a sharp valley."""
ROUNDING = 1e-9
"""Slope of a valley, over the steepest one, that counts as none."""
CREST_SAMPLES, ZOOMS, LEVEL = 257, 5, 1e-12
"""Places at which other crests are sought, refinements beside the highest, height over the greatest that is none."""


def to_line(x: Array, pitch: float) -> Array:
    """Return u [m] at places 0 <= x <= pitch/2."""
    return np.asarray(pitch / math.pi * np.sin(math.pi * x / pitch))


def from_line(u: Array, pitch: float) -> Array:
    """Return x [m] at u <= pitch/pi."""
    inner = pitch / math.pi * np.arcsin(np.minimum(math.pi * u / pitch, 1.0))
    return np.asarray(np.where(u >= pitch / math.pi, 0.5 * pitch, inner))


def as_high(profile: Profile, pitch: float) -> float | None:
    """Return a place [m] beside x = 0, up to the valley, that is as high as the crest or higher; None without one."""
    x = 0.5 * pitch * np.linspace(0.0, 1.0, CREST_SAMPLES)
    height = profile.height(x)
    most = float(np.max(height))
    rivals = 1 + np.flatnonzero((height[1:] <= height[:-1]) & (height[1:] <= np.append(height[2:], np.inf)))
    if rivals.size == 0 or most == 0.0:
        return None
    best = rivals[np.argmin(height[rivals])]
    if height[best - 1] == 0.0:  # a flat crest goes on
        return None
    for _ in range(ZOOMS):
        x = np.linspace(x[best - 1], x[min(best + 1, x.size - 1)], CREST_SAMPLES)
        height = profile.height(x)
        best = max(int(np.argmin(height)), 1)
    return float(x[best]) if height[best] <= LEVEL * most else None


@value
class Unrolled(Shape):
    """A profile between two valleys, over u.

    Parameters
    ----------
    profile : Profile
        f(|x|), known up to half of the pitch.
    pitch : float
        [m].
    """

    profile: Profile
    pitch: Positive

    @property
    def reach(self) -> float:
        """Close to the rim if the valleys are sharp, which no load closes [m]; infinite elsewhere."""
        slopes = np.abs(self.profile.slope(0.5 * self.pitch * np.linspace(0.0, 1.0, 9)))
        sharp = slopes[-1] > ROUNDING * np.max(slopes)
        return self.pitch / math.pi * (1.0 - WALL) if sharp else math.inf

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Those of the profile within the pitch."""
        half = 0.5 * self.pitch
        return tuple(
            (float(to_line(np.array(b), self.pitch)), jump / math.cos(math.pi * b / self.pitch))
            for b, jump in self.profile.kinks
            if b < half
        )

    @property
    def rising(self) -> bool:
        """Whether u df/du never falls, at many places: then w of a half-plane does not."""
        u = self.pitch / math.pi * np.sin(0.5 * math.pi * np.linspace(0.0, 1.0, CREST_SAMPLES)[:-1])
        turned = u * self.slope(u)
        return bool(np.all(np.diff(turned) >= -ROUNDING * np.max(np.abs(turned)))) and all(
            jump >= 0.0 for _, jump in self.kinks
        )

    def height(self, r: Array) -> Array:
        """f [m]."""
        return np.asarray(self.profile.height(from_line(np.asarray(r), self.pitch)))

    def slope(self, r: Array) -> Array:
        """df/du [-]."""
        x = from_line(np.asarray(r), self.pitch)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(self.profile.slope(x) / np.cos(math.pi * x / self.pitch))

    def curvature(self, r: Array) -> Array:
        """d2f/du2 [1/m]."""
        x = from_line(np.asarray(r), self.pitch)
        k = math.pi / self.pitch
        cosine, sine = np.cos(k * x), np.sin(k * x)
        shape = self.profile
        if not isinstance(shape, Shape):
            raise NotImplementedError(f"A {type(shape).__name__} has no curvature.")
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray((shape.curvature(x) * cosine + k * shape.slope(x) * sine) / cosine**3)


@value
class Harmonic(Shape):
    """A wave of which a whole number fit between two valleys, over u: h (1 - cos 2 n t) = 2 h sin^2(n t), u ~ sin t.

    Parameters
    ----------
    amplitude : float
        h [m].
    pitch : float
        [m].
    number : int
        n.
    """

    __words__ = words(number=("n", "", "waves between two valleys"))

    amplitude: Positive
    pitch: Positive
    number: int

    @property
    def _series(self) -> np.polynomial.Polynomial:
        """The height over (u/pitch)^2: 1 - cos 2 n t is 1 - T_n(1 - 2 sin^2 t)."""
        chebyshev = np.polynomial.chebyshev.Chebyshev.basis(self.number).convert(kind=np.polynomial.Polynomial)
        square = np.polynomial.Polynomial([1.0, -2.0 * math.pi**2])
        return self.amplitude * (1.0 - chebyshev(square))

    def height(self, r: Array) -> Array:
        """f [m]."""
        return np.asarray(self._series((np.asarray(r) / self.pitch) ** 2))

    def slope(self, r: Array) -> Array:
        """df/du [-]."""
        t = np.asarray(r) / self.pitch
        return np.asarray(2.0 * t / self.pitch * self._series.deriv()(t * t))

    def curvature(self, r: Array) -> Array:
        """d2f/du2 [1/m]."""
        t = np.asarray(r) / self.pitch
        first, second = self._series.deriv(), self._series.deriv(2)
        return np.asarray((2.0 * first(t * t) + 4.0 * t * t * second(t * t)) / self.pitch**2)


def unrolled(profile: Profile, pitch: float) -> Profile:
    """Return a periodic profile over u, with its rim at u = pitch/pi, or without one if the valleys are sharp."""
    part = _part(profile, pitch)
    return part if math.isfinite(part.reach) else CappedCylinder(pitch / math.pi, part)


def in_closed_form(profile: Profile) -> bool:
    """Return whether all of an unrolled profile is waves that fit into the pitch."""
    match profile:
        case CappedCylinder(cap=cap):
            return in_closed_form(cap)
        case Sum(parts=parts):
            return all(map(in_closed_form, parts))
    return not isinstance(profile, Unrolled)


def _part(profile: Profile, pitch: float) -> Profile:
    match profile:
        case Sum(parts=parts):
            return Sum(tuple(_part(part, pitch) for part in parts))
        case Wavy(amplitude=h, wavelength=length):
            number = round(pitch / length)
            if abs(pitch / length - number) > 1e-12 * number or number > MOST_HARMONICS:
                return Unrolled(profile, pitch)
            return Paraboloid(pitch**2 / (4.0 * math.pi**2 * h)) if number == 1 else Harmonic(h, pitch, number)
    return Unrolled(profile, pitch)


@value
class PeriodicBed:
    """What the stresses below periodic strips need, in the coordinates of the bodies.

    Parameters
    ----------
    line : LineFoundation or PeriodicLayers
        Over u.
    pitch : float
        [m].
    """

    line: LineBed
    pitch: Positive
    edges_bear: ClassVar[bool] = False
    """What closes the contact and more presses evenly."""
    hertzian: ClassVar[bool] = False
    """Crests press on one another's gaps: their pressure is Hertz's under no load."""

    @property
    def profile(self) -> Profile:
        """The profile over u."""
        return self.line.profile

    @property
    def medium(self) -> PressedPair:
        """Both bodies."""
        return self.line.medium

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Places [m] and strengths over u."""
        return tuple((float(from_line(np.array(b), self.pitch)), strength) for b, strength in self.line.kinks)

    @property
    def layered(self) -> LayerStack:
        """The medium, if it has layers."""
        return self.line.layered

    def slope(self, x: Array) -> Array:
        """df/du [-]."""
        return self.line.slope(to_line(x, self.pitch))

    def refuse_dragged(self, friction: float) -> None:
        """Refuse friction [-] where a layer slides on what lies below it."""
        self.line.refuse_dragged(friction)

    def waves_below(self, half_width: float, extra: float, farthest: float) -> PlaneWaves:
        """Return the pressure as waves that layers feel."""
        return self.line.waves_below(float(to_line(np.array(half_width), self.pitch)), extra, farthest)

    def pressure(self, x: Array, half_width: float, extra: float) -> Array:
        """Return the pressure [Pa]; `extra` is the load per strip over E* beyond that which closes the contact [m]."""
        place, _ = self._folded(x)
        contact = float(to_line(np.array(half_width), self.pitch))
        cosine = np.cos(math.pi * place / self.pitch)
        with np.errstate(invalid="ignore"):
            inner = self.line.pressure(to_line(place, self.pitch), contact, 0.0) * cosine
        return np.asarray(inner + self.medium.modulus * extra / self.pitch)

    def surface_potential(self, x: Array, half_width: float, extra: float) -> Array:
        """Return F [Pa] on the surface."""
        place, turned = self._folded(x)
        contact = float(to_line(np.array(half_width), self.pitch))
        whole = self.line.surface_potential(to_line(place, self.pitch), contact, 0.0)
        found = whole * np.cos(math.pi * place / self.pitch) - 1j * self.medium.modulus * extra / self.pitch
        return np.asarray(np.where(turned, -np.conj(found), found))

    def potential(self, x: Array, z: Array, half_width: float, extra: float) -> tuple[Array, Array]:
        """Return F [Pa] and F' [Pa/m] below the surface: that over u times cos(pi zeta/pitch)."""
        place, turned = self._folded(x)
        contact = np.array([to_line(np.array(half_width), self.pitch)])
        k = math.pi / self.pitch
        zeta = place + 1j * np.minimum(z, DEEP * self.pitch)
        sine, cosine = np.sin(k * zeta), np.cos(k * zeta)
        mapped = sine / k
        inner, slope = self.line.potential(mapped.real, np.maximum(mapped.imag, 0.0), float(contact[0]), 0.0)
        whole, grown = cosine * inner, cosine**2 * slope - k * sine * inner
        grown = np.where(z < DEEP * self.pitch, grown, 0.0)
        whole = whole - 1j * self.medium.modulus * extra / self.pitch
        return np.where(turned, -np.conj(whole), whole), np.where(turned, np.conj(grown), grown)

    def _folded(self, x: Array) -> tuple[Array, Array]:
        """Return the distance from the middle of the nearest strip, and where that lies to the right."""
        beside = np.asarray(x, dtype=float) - self.pitch * np.round(np.asarray(x, dtype=float) / self.pitch)
        return np.abs(beside), beside < 0.0
