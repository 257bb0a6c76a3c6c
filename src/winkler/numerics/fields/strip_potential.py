r"""The potential of strips of pressure on a half-plane, in closed form, strip by strip.

On a strip of the middle m and half-width h, with :math:`t=(x-m)/h=\cos\theta`, the pressure over E*/2 is

.. math:: d = \sqrt{1-t^2}\sum_k c_kU_k(t) + \frac{s_0+s_1t}{\sqrt{1-t^2}}
            + \sum_i\frac{J_i}\pi
            \ln\Big|\frac{\sin\frac12(\theta+\theta_i)}{\sin\frac12(\theta-\theta_i)}\Big| + \dots ,

series, walls, and corners at :math:`t_i=\cos\theta_i` where the slope of the profile jumps by J (and terms of the same
kind where its curvature jumps).  With :math:`w = z-\sqrt{z^2-1}`, :math:`z=(\zeta-m)/h`, the potential
:math:`F(\zeta)=\frac1\pi\int d(s)/(\zeta-s)\,\mathrm ds` is

.. math:: F = \sum_kc_kw^{k+1} + \frac{s_0+s_1z}{\sqrt{z^2-1}} - s_1
            + \sum_i\frac{J_i}{\pi\mathrm i}
            \ln\frac{1-w\mathrm e^{-\mathrm i\theta_i}}{1-w\mathrm e^{\mathrm i\theta_i}} .

On the surface its real part is the slope by which the surfaces are bent, :math:`-\Im F=d`, and the integral of it along
x is elementary as well.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

AT_EDGE = 1e-14
"""Distance over the half-width within which a place is the edge: near walls the integral grows as its square root."""


class StripTerms(NamedTuple):
    """The pressure of one strip, over E*/2.

    Parameters
    ----------
    start, end
        Edges [m].
    series
        c_k.
    walls
        s_0, s_1: infinite pressures at edges that are walls of the body.
    corners
        (place, J, jump of the curvature) inside of the strip, (k, 3).
    """

    start: float
    end: float
    series: Array
    walls: tuple[float, float] = (0.0, 0.0)
    corners: Array = np.zeros((0, 3))

    @property
    def middle(self) -> float:
        """m [m]."""
        return 0.5 * (self.start + self.end)

    @property
    def half(self) -> float:
        """h [m]."""
        return 0.5 * (self.end - self.start)

    @property
    def force(self) -> float:
        """The integral of d [m]."""
        whole = 0.5 * math.pi * float(self.series[0]) + math.pi * self.walls[0]
        for place, jump, bend in self.corners:
            t, sine = self._angle(place)
            whole += jump * sine - 0.5 * bend * self.half * t * sine
        return self.half * whole

    @property
    def moment(self) -> float:
        """The integral of d x [m^2], about x = 0."""
        second = float(self.series[1]) if self.series.size > 1 else 0.0
        turned = 0.25 * math.pi * second + 0.5 * math.pi * self.walls[1]
        for place, jump, bend in self.corners:
            t, sine = self._angle(place)
            turned += 0.5 * jump * sine * t + bend * self.half * sine * (1.0 - 4.0 * t * t) / 24.0
        return self.half**2 * turned + self.middle * self.force

    def _angle(self, place: float) -> tuple[float, float]:
        """Return t and sin(theta) of a corner."""
        t = min(max((place - self.middle) / self.half, -1.0), 1.0)
        return t, math.sqrt((1.0 - t) * (1.0 + t))

    def potential(self, zeta: Array) -> Array:
        """Return F at complex places [m], not above the surface; at its edges and corners it may be infinite."""
        z, w, root = in_circle((zeta - self.middle) / self.half)
        found = w * _horner(self.series, w)
        s0, s1 = self.walls
        with np.errstate(all="ignore"):
            if s0 != 0.0 or s1 != 0.0:
                found = found + (s0 + s1 * z) / root - s1
            for place, jump, bend in self.corners:
                t, sine = self._angle(place)
                bent = _bent(w, math.acos(t), jump)
                if bend != 0.0:
                    curved = _bent(w, math.acos(t), bend)
                    bent = bent + self.half * ((z - t) * curved - bend / math.pi * sine * (0.5 * w * w + 1.0))
                found = found + bent
        return np.asarray(found)

    def gradient(self, zeta: Array) -> Array:
        """Return F' [1/m] below the surface or beside the strip."""
        z, w, root = in_circle((zeta - self.middle) / self.half)
        order = np.arange(1.0, self.series.size + 1.0)
        found = -w * _horner(order * self.series, w) / root
        s0, s1 = self.walls
        if s0 != 0.0 or s1 != 0.0:
            found = found - (s0 * z + s1) / root**3
        for place, jump, bend in self.corners:
            t, sine = self._angle(place)
            found = found - jump / math.pi * sine / ((z - t) * root)
            if bend != 0.0:
                part = _bent(w, math.acos(t), bend) - bend / math.pi * sine * (1.0 - w * w) / root
                found = found + self.half * part
        return np.asarray(found / self.half)

    def raised(self, x: Array) -> Array:
        """Return the integral of Re F along x on the surface [m], beside the strip or at its edges."""
        place = (np.asarray(x, dtype=float) - self.middle) / self.half
        place = np.where(np.abs(np.abs(place) - 1.0) < AT_EDGE, np.sign(place), place)
        z, w, root = (part.real for part in in_circle(place))
        log = np.log(np.abs(w))
        found = np.zeros(z.shape)
        power = w.copy()  # w^k of the series
        for k, c in enumerate(self.series):
            if k == 0:
                found += c * (0.25 * w * w - 0.5 * log)
            else:
                found += c * power * (w * w / (2.0 * (k + 2.0)) - 0.5 / k)
                power = power * w
        found -= self.walls[0] * log + self.walls[1] * w
        for place, jump, bend in self.corners:
            t, sine = self._angle(place)
            found += (z - t) * _bent(w + 0.0j, math.acos(t), jump).real - jump / math.pi * sine * log
            if bend != 0.0:
                curved = 0.5 * (z - t) ** 2 * _bent(w + 0.0j, math.acos(t), bend).real
                rest = 0.5 * (root + t * log) - 0.5 * (w**3 / 6.0 - 0.5 * w) - z
                found += self.half * (curved + bend / math.pi * sine * rest)
        return np.asarray(self.half * found)

    def polynomial(self, x: Array) -> Array:
        """Return by how much Re F of the corners differs on the strip from their jumps: J H(x-x_i) and J2 (x-x_i)_+."""
        t = (x - self.middle) / self.half
        found = np.zeros(x.shape)
        for place, jump, bend in self.corners:
            at, sine = self._angle(place)
            angle = math.acos(at) / math.pi
            found -= jump * angle + bend * (x - place) * angle
            found -= bend * self.half / math.pi * sine * (t * t + 0.5)
        return found


def in_circle(z: Array) -> tuple[Array, Array, Array]:
    """Return z, w = z - sqrt(z^2 - 1), of which |w| <= 1, and the square root."""
    z = np.asarray(z, dtype=complex)
    z = np.where(z.imag == 0.0, z.real + 0.0j, z)
    root = np.sqrt(z - 1.0) * np.sqrt(z + 1.0)
    return z, 1.0 / (z + root), root


def powers(w: Array, count: int) -> Array:
    """Return w, w^2, ... w^count in columns."""
    return np.asarray(np.cumprod(np.broadcast_to(w[:, None], (w.size, count)), axis=1))


def _horner(series: Array, w: Array) -> Array:
    found = np.zeros(w.shape, dtype=complex)
    for c in series[::-1]:
        found = found * w + c
    return found


def _bent(w: Array, angle: float, jump: float) -> Array:
    turn = complex(math.cos(angle), math.sin(angle))
    with np.errstate(all="ignore"):
        return np.asarray(-1j * jump / math.pi * (np.log(1.0 - w / turn) - np.log(1.0 - w * turn)))
