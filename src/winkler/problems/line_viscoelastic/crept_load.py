r"""The load that crept: what a strip bears at a modulus of one, the hereditary integral of creep and force per length.

.. math:: \ell(t) = \int C(t-t')\,\frac{\mathrm dP}{\mathrm dt'}\,\mathrm dt' , \qquad
          C(t) = C_0 + \varphi t + \sum_k C_k\,(1-e^{-t/\lambda_k}) .

While P changes steadily every term is a line and an exponential.  A straight line between two moments at the distance h
is wrong by :math:`h^2|\ddot\ell|/8` at most; moments at equal steps of :math:`\int\sqrt{|\ddot\ell|}\,\mathrm dt`,
which is known in closed form, spread that evenly.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.springs.exponential_sums import CreepSeries
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import affordable

INTERPOLATED = 4
"""Places for each moment, between which the spacing is inverted."""
MOST_MOMENTS = 2_000_000
"""Moments of one straight part of the path."""


class Spacing:
    """How near moments must lie.

    Parameters
    ----------
    little : float
        Error of the load that crept [m] between two moments.
    viscosity, unbalanced : float
        Of a dashpot alongside [Pa s], and the error of its load [N/m], which grows with the error of the rate.
    """

    def __init__(self, little: float, viscosity: float = 0.0, unbalanced: float = math.inf) -> None:
        self.little, self.rate = little, viscosity / unbalanced

    def moments(self, duration: float, bends: Array, times: Array, flow: float) -> Array:
        """Return moments up to a duration [s], the end included.

        Parameters
        ----------
        duration : float
        bends, times : ndarray, (k,)
            Amplitudes [m] and times [s] of what decays.
        flow : float
            Second derivative of what does not decay [m/s^2].
        """

        def passed(t: Array) -> Array:
            root = math.sqrt(0.125 / self.little)
            fades = -np.expm1(-0.5 * t[:, None] / times)
            number = 2.0 * root * (fades @ np.sqrt(np.abs(bends))) + root * math.sqrt(abs(flow)) * t
            if self.rate > 0.0:
                faded = -np.expm1(-t[:, None] / times)
                number += 0.5 * self.rate * (faded @ np.abs(bends / times) + abs(flow) * t)
            return np.asarray(number)

        whole = float(passed(np.array([duration]))[0])
        if not math.isfinite(whole):
            raise FloatingPointError("the number of moments comes out undefined")
        number = math.ceil(whole)
        affordable(
            "LineViscoelasticIndentation",
            "moments of one step, which a greater tolerance makes fewer,",
            number,
            MOST_MOMENTS,
        )
        if number <= 1:
            return np.array([duration])
        early = min(float(np.min(times)), duration) / number if times.size else duration
        fine = np.union1d(
            np.geomspace(early, duration, INTERPOLATED * number), np.linspace(0.0, duration, INTERPOLATED * number)
        )
        inner = np.interp(np.arange(1, number) * (whole / number), passed(fine), fine)
        return np.append(inner, duration)


class CreptLoad:
    """The load that crept, carried along a path.

    Parameters
    ----------
    creep : CreepSeries
        Of 1/E*.
    """

    def __init__(self, creep: CreepSeries) -> None:
        self.creep = creep
        self.force, self.flowed, self.delayed = 0.0, 0.0, np.zeros(creep.times.size)

    def present(self) -> float:
        """Return its present value [m]."""
        return self.creep.glassy * self.force + self.flowed + float(np.sum(self.delayed))

    def jump(self, force: float) -> None:
        """Put another force per length [N/m] on, at once."""
        self.force = force

    def ramp(self, force: float, duration: float, spacing: Spacing | None = None) -> tuple[Array, Array]:
        """Let the force per length change steadily to another one [N/m]; return moments [s] and levels [m].

        Parameters
        ----------
        force, duration : float
        spacing : Spacing, optional
            How near the moments must lie; only the end is returned unless given.
        """
        creep, rate = self.creep, (force - self.force) / duration
        flow = creep.fluidity * rate
        t = np.array([duration])
        if spacing is not None:
            bends = self.delayed - creep.compliances * (self.force - rate * creep.times)
            t = spacing.moments(duration, bends, creep.times, flow)
        spans = t[:, None] / creep.times
        gone = -np.expm1(-spans)
        begun = creep.compliances * (self.force * gone + rate * creep.times * (spans - gone))
        delayed = self.delayed * (1.0 - gone) + begun
        flowed = self.flowed + creep.fluidity * t * (self.force + 0.5 * rate * t)
        levels = creep.glassy * (self.force + rate * t) + flowed + np.sum(delayed, axis=1)
        self.force, self.flowed, self.delayed = force, float(flowed[-1]), delayed[-1]
        return t, levels
