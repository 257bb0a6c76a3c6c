r"""The temperature of a surface under the elliptic flux of heat of Hertz' pressure, at rest or moving in any direction.

The flux :math:`\frac{3Q}{2\pi ab}\sqrt{1-x^2/a^2-y^2/b^2}` has the line load of a ball in each direction
:math:`\theta`, as wide as the ellipse is seen from there,

.. math:: q_\theta(s) = \frac{3Q}{4h}\Bigl(1-\frac{s^2}{h^2}\Bigr) , \qquad
          h(\theta) = \sqrt{a^2\cos^2\theta+b^2\sin^2\theta} .

Temperature is the mean of line loads over all directions, each changed by the motion as in
`winkler.numerics.fields.moving_source`; here in closed form.  With :math:`E(z)=e^{-z}I_0(z)`, the speed V at the angle
:math:`\psi` and :math:`b=\frac V\kappa\cos(\theta-\psi)`,

.. math:: \lambda T = \frac1{2\pi}\int_{\psi-\pi/2}^{\psi+\pi/2} q_b(x\cos\theta+y\sin\theta)\,\mathrm d\theta , \qquad
          q_b(s) = \frac{3Q}{2h^3}\int_s^h t\,E\bigl(\tfrac b2(t-s)\bigr)\,\mathrm dt .

Within the ellipse :math:`q_b''<0` in all directions: the temperature is concave there, and Newton's method finds its
greatest value.
"""

from __future__ import annotations

import dataclasses
import functools
import math

import numpy as np

from winkler.numerics.chunks import chunks
from winkler.numerics.fields.line_source import LineSource
from winkler.numerics.fields.round_source import line_source
from winkler.numerics.fields.warmest_place import PeakTemperature
from winkler.numerics.integrals.quadrature import gauss_legendre, growing, panel_nodes
from winkler.numerics.types import Array
from winkler.values.value import value

FAST_HEIGHT = 1.2346198309610955
"""Greatest integral of sqrt(1 - s^2)/sqrt(pi (t - s)) from -1 to t, at t = 0.652: Hertz' flux in fast motion."""
NODES = 20
LENGTH_RATIO = 3.0
"""Ratio of the widths of consecutive pieces beside a direction in which the integrand changes fast."""
MEAN_NODES = 16
NEWTON_STEPS = 60
SETTLED = 1e-9
"""Step over the semi-axes at which the place of the greatest temperature is known: its height to the square of it."""
CHUNK = 200_000
"""Directions times places that are computed at once."""


@value
class EllipticSource:
    """1 W on an ellipse, distributed like the pressure of Hertz.

    Parameters
    ----------
    along, across : float
        Semi-axes a along x and b along y [m].
    """

    along: float
    across: float

    @functools.cached_property
    def ball(self) -> LineSource:
        """The round source whose line load, stretched, is that of every direction."""
        unit, radius = _hertz(), max(self.along, self.across)
        return dataclasses.replace(unit, radius=radius, scale=unit.scale / radius)

    def half_length(self, angle: float) -> float:
        """Return how far the source reaches at an angle [rad] from its middle [m]."""
        a, b = self.along, self.across
        return a * b / math.hypot(b * math.cos(angle), a * math.sin(angle))

    def half_width(self, angle: Array) -> Array:
        """Return half the width [m] of the line loads in directions [rad]."""
        return np.hypot(self.along * np.cos(angle), self.across * np.sin(angle))

    def narrow_directions(self, angle: float) -> list[float]:
        """Return directions near which line loads change fast, from that of the motion on, up to a quarter turn."""
        away = (angle + (0.0 if self.along < self.across else 0.5 * math.pi)) % math.pi
        middle, slim = min(away, math.pi - away), min(self.along, self.across) / max(self.along, self.across)
        gaps = (0.0, *growing(slim, 0.5 * math.pi, LENGTH_RATIO))
        near = (middle + sign * gap for gap in gaps for sign in (-1.0, 1.0))
        return [direction for direction in near if 0.0 < direction < 0.5 * math.pi]

    def surface(self, wave: float, x: Array, y: Array, angle: float = 0.0) -> Array:
        """Return lambda T [W/m] on the surface.

        Parameters
        ----------
        wave : float
            V / kappa [1/m], of either sign; zero at rest.
        x, y : ndarray
            Places [m], of one shape.
        angle : float
            Direction of V [rad], from x.
        """
        flat_x, flat_y = np.ravel(np.asarray(x, dtype=float)), np.ravel(np.asarray(y, dtype=float))
        inside = (flat_x / self.along) ** 2 + (flat_y / self.across) ** 2 <= 1.0
        result = np.empty(flat_x.size)
        theta, share = self._directions(wave, angle)
        (within,), (beside,) = np.nonzero(inside), np.nonzero(~inside)
        for here in (within[part] for part in chunks(within.size, theta.size, CHUNK)):
            result[here] = self._sums(wave, angle, theta, flat_x[here], flat_y[here])[0] @ share
        for place in beside:
            theta, share = self._directions(wave, angle, (flat_x[place], flat_y[place]))
            result[place] = self._sums(wave, angle, theta, flat_x[[place]], flat_y[[place]])[0][0] @ share
        return result.reshape(np.shape(x))

    def peak(self, wave: float, angle: float = 0.0) -> PeakTemperature:
        """Return the greatest lambda T and its place; parameters as of `surface`."""
        theta, share = self._directions(wave, angle)
        scale, place = np.array([self.along, self.across]), np.zeros(2)
        unit = np.stack([np.cos(theta), np.sin(theta)]) * scale[:, None]

        def height(at: Array) -> float:
            value, _, _ = self._sums(wave, angle, theta, *(scale * at)[:, None])
            return float(value[0] @ share)

        if wave == 0.0:
            return PeakTemperature(height(place), 0.0, 0.0)
        best = height(place)
        for _ in range(NEWTON_STEPS):
            _, slope, bend = self._sums(wave, angle, theta, *(scale * place)[:, None])
            gradient = unit @ (slope[0] * share)
            hessian = (unit * (bend[0] * share)) @ unit.T
            step = -np.linalg.solve(hessian, gradient)
            part = min(1.0, 0.9 * _steps_to_border(place, step))
            while (there := height(place + part * step)) < best and part > SETTLED:
                part *= 0.5
            if there < best:
                break
            best, place = there, place + part * step
            if float(np.hypot(*(part * step))) < SETTLED:
                break
        return PeakTemperature(best, float(scale[0] * place[0]), float(scale[1] * place[1]))

    def fast(self, angle: float = 0.0) -> float:
        """Return what the greatest lambda T times the root of V / kappa tends to in fast motion [W m^-3/2]."""
        return FAST_HEIGHT * 1.5 / (math.pi * self.along * self.across) * math.sqrt(self.half_length(angle))

    def mean(self, wave: float, angle: float = 0.0) -> float:
        """Return the mean of lambda T over the ellipse [W/m]; parameters as of `surface`."""
        theta, share = self._directions(wave, angle)
        width, rate = self._seen(wave, angle, theta)
        strongest = float(np.max(rate * width))
        cuts = np.array([0.0, *growing(1.0 / max(strongest, 1.0), 1.0, LENGTH_RATIO), 1.0])
        # s = h cos(turn), turn from 0 at the front edge: chords of the ellipse are as sin(turn)
        turn, part = (np.pi * each for each in panel_nodes(cuts, MEAN_NODES))
        ahead = 2.0 * np.sin(0.5 * turn) ** 2
        load = _lagged(0.5 * (rate * width)[:, None] * ahead, ahead, 1.0 - ahead)[0]
        chord = 2.0 / math.pi * np.sin(turn) ** 2 * part
        return float(share @ ((load @ chord) / width))

    def risen(self, length: float, x: Array, y: Array | float = 0.0) -> Array:
        """Return lambda T [W/m] on a body at rest whose source has been on for a time; as of `LineSource.risen`."""
        along, across = (np.ravel(place) for place in np.broadcast_arrays(x / self.along, y / self.across))
        far, turn = np.hypot(along, across), np.arctan2(across, along)
        found = np.empty(far.size)
        for place, (distance, angle) in enumerate(zip(far, turn, strict=True)):
            tangent = math.acos(1.0 / distance) if distance > 1.0 else 0.5 * math.pi
            phi, reach, share = self._stretched({angle + sign * tangent for sign in (-1.0, 1.0)})
            loads = _hertz().spread(length / reach, np.abs(distance * np.cos(phi - angle)))
            found[place] = loads @ share
        return found.reshape(np.broadcast_shapes(np.shape(x), np.shape(y)))

    def risen_peak(self, length: float) -> float:
        """Return the greatest lambda T [W/m] of `risen`, that in the middle."""
        return float(self.risen(length, np.zeros(1))[0])

    def risen_mean(self, length: float) -> float:
        """Return the mean of lambda T over the ellipse [W/m], of `risen`."""
        _, reach, share = self._stretched(set())
        turn, weight = (0.5 * math.pi * part for part in gauss_legendre(NODES))
        lengths, places = np.repeat(length / reach, NODES), np.tile(np.sin(turn), reach.size)
        loads = _hertz().spread(lengths, places).reshape(reach.size, NODES)
        return float(share @ (loads @ (4.0 / math.pi * np.cos(turn) ** 2 * weight)))

    def _stretched(self, cuts: set[float]) -> tuple[Array, Array, Array]:
        """Return directions phi of the ellipse stretched to a circle, h [m] in them, and weights of a mean [1/m].

        There a place is seen at the part rho cos(phi - phi_0) of h, and the mean over directions is that of
        q h^2/(a b).  Pieces grow from the direction of the longer axis, and end at the `cuts`.
        """
        slim = min(self.along, self.across) / max(self.along, self.across)
        centres = [0.5 * k * math.pi for k in (range(0, 3, 2) if self.along > self.across else range(1, 2))]
        gaps = (0.0, *growing(slim, math.pi, LENGTH_RATIO))
        near = (centre + sign * gap for centre in centres for gap in gaps for sign in (-1, 1))
        every = {0.0, 0.5 * math.pi, *(cut % math.pi for cut in cuts), *(cut for cut in near if 0.0 < cut < math.pi)}
        phi, share = panel_nodes(np.array([*sorted(every), math.pi]), NODES)
        reach = 1.0 / np.hypot(np.cos(phi) / self.along, np.sin(phi) / self.across)
        return phi, reach, share * reach / (2.0 * math.pi * self.along * self.across)

    def _seen(self, wave: float, angle: float, theta: Array) -> tuple[Array, Array]:
        """Return h [m] and b [1/m] in directions."""
        return self.half_width(theta), np.abs(wave * np.cos(theta - angle))

    def _directions(self, wave: float, angle: float, place: tuple[float, float] | None = None) -> tuple[Array, Array]:
        """Return directions over half a turn, those of the motion in the middle, and weights of a mean over them.

        Pieces grow from the directions across the motion, where diffusion counts, and from that in which the ellipse
        is seen narrowest; outside of it they end where its tangents through the place are met.
        """
        low, high = angle - 0.5 * math.pi, angle + 0.5 * math.pi
        longest, slim = max(self.along, self.across), min(self.along, self.across) / max(self.along, self.across)
        cuts = {low, high}
        for gap in growing(1.0 / max(abs(wave) * longest, 1.0), math.pi, LENGTH_RATIO):
            cuts |= {low + gap, high - gap}
        narrow = 0.5 * math.pi if self.along >= self.across else 0.0
        centres = [narrow + k * math.pi for k in range(-3, 4)]
        for centre in centres:
            cuts |= {centre, *(centre + sign * gap for gap in growing(slim, math.pi, LENGTH_RATIO) for sign in (-1, 1))}
        if place is not None:
            cuts |= {tangent + k * math.pi for tangent in self._tangents(*place) for k in range(-3, 4)}
        theta, share = panel_nodes(np.array(sorted(cut for cut in cuts if low <= cut <= high)), NODES)
        return theta, share / (2.0 * math.pi)

    def _tangents(self, x: float, y: float) -> list[float]:
        """Return the directions in which a place beside the ellipse is seen at its edge, x cos + y sin = +-h."""
        a, b = self.along, self.across
        root = a * b * math.sqrt(max((x / a) ** 2 + (y / b) ** 2 - 1.0, 0.0))
        found = []
        for signed in (root, -root):
            both = ((-x * y + signed, y * y - b * b), (x * x - a * a, -x * y - signed))
            found.append(math.atan2(*max(both, key=lambda pair: math.hypot(*pair))))
        return found

    def _sums(self, wave: float, angle: float, theta: Array, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Return q_b and its first two derivatives along its line, at places ``(m,)`` in directions ``(n,)``."""
        width, rate = self._seen(wave, angle, theta)
        forth = math.copysign(1.0, wave)
        part = forth * (x[:, None] * np.cos(theta) + y[:, None] * np.sin(theta)) / width
        ahead = np.maximum(1.0 - part, 0.0)
        load, slope, bend = _lagged(0.5 * rate * width * ahead, ahead, part)
        behind = np.maximum(-1.0 - part, 0.0)
        if np.any(behind > 0.0):
            load = load - _lagged(0.5 * rate * width * behind, behind, part)[0]
        return load / width, forth * slope / width**2, bend / width**3


@functools.cache
def _hertz() -> LineSource:
    """Return 1 W under Hertz' pressure on the disc of 1 m."""
    return line_source(lambda x: 0.75 * (1.0 - x**2), [], 1.0)


def _lagged(z: Array, ahead: Array, part: Array) -> tuple[Array, Array, Array]:
    """Return 3/2 of the integral of t E(b h (t - s)/2) from s to s + ahead, and its derivatives by s.

    Parameters
    ----------
    z : ndarray
        b h ahead / 2.
    ahead : ndarray
        How far the edge lies ahead, over h.
    part : ndarray
        s over h.
    """
    from scipy.special import i0e, i1e

    zero, one = i0e(z), i1e(z)
    first = zero + one  # the integral of E over z
    second = (z * first + one) / 3.0  # that of z E, over z
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(z > 0.0, second / np.where(z > 0.0, z, 1.0), 0.5)
    load = 1.5 * ahead * (part * first + ahead * ratio)
    slope = 1.5 * (ahead * first - zero * (part + ahead))
    over = np.where(ahead > 0.0, z / np.where(ahead > 0.0, ahead, 1.0), 0.0)
    bend = -1.5 * (zero + (part + ahead) * over * (zero - one))
    return load, slope, bend


def _steps_to_border(place: Array, step: Array) -> float:
    """Return how often a step fits between a place and the unit circle."""
    square, along, left = float(step @ step), float(place @ step), 1.0 - float(place @ place)
    return left / (along + math.sqrt(along * along + square * left)) if square > 0.0 else math.inf
