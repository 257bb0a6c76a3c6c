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

import math

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.values.value import value

__all__ = ["EllipticSource", "PeakPlace"]

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
class PeakPlace:
    """The greatest temperature under an elliptic source, and its place.

    Parameters
    ----------
    height : float
        Conductivity times temperature [W/m].
    x, y : float
        Where [m], along and across the first semi-axis.
    """

    height: float
    x: float
    y: float


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

    def surface(self, wave: float, angle: float, x: Array, y: Array) -> Array:
        """Return lambda T [W/m] on the surface.

        Parameters
        ----------
        wave : float
            V / kappa [1/m], of either sign; zero at rest.
        angle : float
            Direction of V [rad], from x.
        x, y : ndarray
            Places [m], of one shape.
        """
        flat_x, flat_y = np.ravel(np.asarray(x, dtype=float)), np.ravel(np.asarray(y, dtype=float))
        inside = (flat_x / self.along) ** 2 + (flat_y / self.across) ** 2 <= 1.0
        result = np.empty(flat_x.size)
        theta, share = self._directions(wave, angle)
        rows = max(1, CHUNK // theta.size)
        (within,), (beside,) = np.nonzero(inside), np.nonzero(~inside)
        for start in range(0, within.size, rows):
            here = within[start : start + rows]
            result[here] = self._sums(wave, angle, theta, flat_x[here], flat_y[here])[0] @ share
        for place in beside:
            theta, share = self._directions(wave, angle, (flat_x[place], flat_y[place]))
            result[place] = self._sums(wave, angle, theta, flat_x[[place]], flat_y[[place]])[0][0] @ share
        return result.reshape(np.shape(x))

    def peak(self, wave: float, angle: float) -> PeakPlace:
        """Return the greatest lambda T and its place; parameters as of `surface`."""
        theta, share = self._directions(wave, angle)
        scale, place = np.array([self.along, self.across]), np.zeros(2)
        unit = np.stack([np.cos(theta), np.sin(theta)]) * scale[:, None]

        def height(at: Array) -> float:
            value, _, _ = self._sums(wave, angle, theta, *(scale * at)[:, None])
            return float(value[0] @ share)

        if wave == 0.0:
            return PeakPlace(height(place), 0.0, 0.0)
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
        return PeakPlace(best, float(scale[0] * place[0]), float(scale[1] * place[1]))

    def mean(self, wave: float, angle: float) -> float:
        """Return the mean of lambda T over the ellipse [W/m]; parameters as of `surface`."""
        theta, share = self._directions(wave, angle)
        width, rate = self._seen(wave, angle, theta)
        strongest = float(np.max(rate * width))
        cuts = np.array([0.0, *_growing(1.0 / max(strongest, 1.0), 1.0), 1.0])
        node, weight = gauss_legendre(MEAN_NODES)
        # s = h cos(turn), turn from 0 at the front edge: chords of the ellipse are as sin(turn)
        turn = (np.pi * (cuts[:-1, None] + np.diff(cuts)[:, None] * node)).ravel()
        part = (np.pi * np.diff(cuts)[:, None] * weight).ravel()
        ahead = 2.0 * np.sin(0.5 * turn) ** 2
        load = _lagged(0.5 * (rate * width)[:, None] * ahead, ahead, 1.0 - ahead)[0]
        chord = 2.0 / math.pi * np.sin(turn) ** 2 * part
        return float(share @ ((load @ chord) / width))

    def _seen(self, wave: float, angle: float, theta: Array) -> tuple[Array, Array]:
        """Return h [m] and b [1/m] in directions."""
        width = np.hypot(self.along * np.cos(theta), self.across * np.sin(theta))
        return width, np.abs(wave * np.cos(theta - angle))

    def _directions(self, wave: float, angle: float, place: tuple[float, float] | None = None) -> tuple[Array, Array]:
        """Return directions over half a turn, those of the motion in the middle, and weights of a mean over them.

        Pieces grow from the directions across the motion, where diffusion counts, and from that in which the ellipse
        is seen narrowest; outside of it they end where its tangents through the place are met.
        """
        low, high = angle - 0.5 * math.pi, angle + 0.5 * math.pi
        longest, slim = max(self.along, self.across), min(self.along, self.across) / max(self.along, self.across)
        cuts = {low, high}
        for gap in _growing(1.0 / max(abs(wave) * longest, 1.0), math.pi):
            cuts |= {low + gap, high - gap}
        narrow = 0.5 * math.pi if self.along >= self.across else 0.0
        centres = [narrow + k * math.pi for k in range(-3, 4)]
        for centre in centres:
            cuts |= {centre, *(centre + sign * gap for gap in _growing(slim, math.pi) for sign in (-1, 1))}
        if place is not None:
            cuts |= {tangent + k * math.pi for tangent in self._tangents(*place) for k in range(-3, 4)}
        ordered = np.array(sorted(cut for cut in cuts if low <= cut <= high))
        node, weight = gauss_legendre(NODES)
        width = np.diff(ordered)[:, None]
        theta = (ordered[:-1, None] + width * node).ravel()
        return theta, (width * weight).ravel() / (2.0 * math.pi)

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


def _growing(first: float, last: float) -> list[float]:
    """Return numbers that grow by the same ratio, from the first one on, below the last."""
    count = math.ceil(math.log(last / first) / math.log(LENGTH_RATIO)) if first < last else 0
    return [first * LENGTH_RATIO**k for k in range(count)]


def _steps_to_border(place: Array, step: Array) -> float:
    """Return how often a step fits between a place and the unit circle."""
    square, along, left = float(step @ step), float(place @ step), 1.0 - float(place @ place)
    return left / (along + math.sqrt(along * along + square * left)) if square > 0.0 else math.inf
