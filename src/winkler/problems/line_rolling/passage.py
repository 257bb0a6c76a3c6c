"""The strip of a cylinder that passes over bodies which creep, at one speed under one load."""

from __future__ import annotations

import functools
import math
from typing import Any, NamedTuple

import numpy as np

from winkler.loading.loads import HalfWidth, LineForce, MeanPressure
from winkler.media.layered.wave_constants import Wave
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.springs.exponential_sums import CreepSeries, of_creep
from winkler.numerics.transforms.passing_strip import PassingStrip, passing_strip
from winkler.numerics.transforms.strips.passing_waves import PassingModes, passing_modes
from winkler.numerics.types import Array, ComplexArray
from winkler.problems.line_viscoelastic.layered_strips import RelaxingBed
from winkler.values.errors import OutsideValidity

IMMEDIATE = 1e-8
"""Retardation time over the time of passing half of the strip, below which a body creeps at once."""
FASTEST = 1e-9
"""Relaxation time over that time, below which it counts as well."""
MOST_IMMEDIATE = 1e-7
"""Greatest retardation time over that time that may count as none."""
PLACES_INSIDE, PULL = np.linspace(-0.99, 0.99, 67), 1e-4
"""Places at which it is examined whether layers pull, over the half-width, and how much may be the error of modes."""
WIDENED = 1.0
"""Logarithm of the factor between half-widths on layers that are tried before a search begins."""
MARGIN = 1e-6
"""By which a half-width may miss those of the glassy and the relaxed bodies, as a logarithm."""
NEWTON_STEPS = 6


class Passage(NamedTuple):
    """The strip at one speed.

    Parameters
    ----------
    half_width
        Half of the width from edge to edge [m].
    middle
        Middle of the strip, from the lowest point of the cylinder [m].
    level
        E* ell / (2 R) [Pa] of the relaxed half-planes; ell / R with modes in 1/Pa on layers.
    strip
        That under a parabola, all lengths over the half-width.
    first, second
        g_1 and g_2 of `winkler.numerics.transforms.passing_strip`, or of `strips.passing_waves` on layers.
    curvature_radius
        R [m].
    delayed
        Moment over force of creep that is as good as immediate [m].
    """

    half_width: float
    middle: float
    level: float
    strip: PassingStrip | PassingModes
    first: float
    second: float
    curvature_radius: float
    delayed: float

    @property
    def leading_edge(self) -> float:
        """Where the contact begins [m]."""
        return self.middle + self.half_width

    @property
    def trailing_edge(self) -> float:
        """Where it ends [m]."""
        return self.middle - self.half_width

    @property
    def force_per_length(self) -> float:
        """P [N/m]."""
        return 0.5 * math.pi * self.level * self.half_width * self.first

    @property
    def shear_force_per_length(self) -> float:
        """Q [N/m] that resists."""
        skew = 0.25 * math.pi * self.level * self.half_width**2 * self.second
        return (self.force_per_length * (self.middle + self.delayed) + skew) / self.curvature_radius

    @property
    def peak_pressure(self) -> float:
        """The greatest pressure [Pa]."""
        from scipy.fft import dst

        waves = self.strip.waves()
        n, count = np.arange(1.0, waves.size + 1.0), 4 * waves.size
        samples = dst(np.append(waves, np.zeros(count - 1 - waves.size)), type=1)  # at pi k / count
        angle = math.pi * (1 + int(np.argmax(samples))) / count
        for _ in range(NEWTON_STEPS):
            slope, bend = waves * n @ np.cos(n * angle), -waves * n * n @ np.sin(n * angle)
            angle -= float(slope / bend)
        return self.level * float(waves @ np.sin(n * angle))

    def pressure(self, x: Array) -> Array:
        """Return p [Pa] at places from the lowest point of the cylinder [m]."""
        t = (x - self.middle) / self.half_width
        inside = np.abs(t) < 1.0
        return np.where(inside, self.level * self._pressure(np.where(inside, t, 1.0)), 0.0)

    def _pressure(self, t: Array) -> Array:
        """Return sqrt(1 - t^2) times the sum of g_n U_{n-1}(t), by Clenshaw's recurrence."""
        later, latest = np.zeros(t.shape), np.zeros(t.shape)
        for wave in self.strip.waves()[::-1].tolist():
            later, latest = wave + 2.0 * t * later - latest, later
        return np.sqrt((1.0 - t) * (1.0 + t)) * later


def passage(bed: RelaxingBed, load: LineForce | HalfWidth | MeanPressure, speed: float) -> Passage:
    """Return the strip under a positive load at a speed [m/s].

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
        A Paraboloid on a ViscoelasticHalfSpace or on layers that relax, with finite moduli at all times.
    load : LineForce, HalfWidth or MeanPressure
    speed : float

    Raises
    ------
    OutsideValidity
        If the solid relaxes so fast that the contact cannot be resolved.
    """
    medium: Any = bed.medium
    radius = float(bed.size)
    if isinstance(load, HalfWidth):
        return _strip(medium, radius, float(load.half_width), speed)
    from scipy.optimize import brentq

    mean = isinstance(load, MeanPressure)
    wanted = float(load.mean_pressure if isinstance(load, MeanPressure) else load.force_per_length)

    def missing(logarithm: float) -> float:
        strip = _strip(medium, radius, math.exp(logarithm), speed)
        carried = strip.force_per_length / (2.0 * strip.half_width if mean else 1.0)
        return math.log(carried / wanted)

    def on_half_planes(compliance: float) -> float:
        # P / (2 ell) = pi ell / (8 R C) of an elastic body
        wide = 8.0 * radius * wanted * compliance / math.pi
        return math.log(wide if mean else math.sqrt(0.5 * wide))

    if isinstance(medium, ViscoelasticHalfSpace):
        creep = medium.creep
        low, high = (on_half_planes(each) for each in (creep.glassy, creep.glassy + float(np.sum(creep.compliances))))
        low, high = low - MARGIN, high + MARGIN
    else:
        surface = medium.waves(Wave.NORMAL, np.array([np.inf]), np.zeros(1, dtype=complex))
        low = high = on_half_planes(float(surface[0].real))
        while missing(low) > 0.0:
            low -= WIDENED
        while missing(high) < 0.0:
            high += WIDENED
    found = brentq(missing, low, high, xtol=1e-15, rtol=8.9e-16)
    return _strip(medium, radius, math.exp(found), speed)


@functools.lru_cache(maxsize=256)
def _strip(medium: RelaxingMedium, radius: float, half_width: float, speed: float) -> Passage:
    """Return the strip of a half-width."""
    if isinstance(medium, ViscoelasticHalfSpace):
        return _on_half_planes(medium.creep, radius, half_width, speed)

    def response(kappa: Array) -> ComplexArray:
        k = kappa / half_width
        return np.conj(medium.waves(Wave.NORMAL, k, 1j * speed * k))  # particles come from ahead

    strip = passing_modes(response)
    if strip is None:
        raise OutsideValidity(
            f"LineRollingResistance: at {speed:.6g} m/s, half of the contact passes in {half_width / speed:.3g} s; "
            "layers relax so much faster, liquid leaves them so much more slowly, or they are so much thinner, that "
            "the edge is not resolved: use a speed nearer to that of the greatest resistance, or press less."
        )
    first, second = strip.waves(2).tolist()
    found = Passage(half_width, strip.middle * half_width, half_width / radius, strip, first, second, radius, 0.0)
    pressure = found.pressure(found.middle + half_width * PLACES_INSIDE)
    if np.min(pressure) < -PULL * np.max(pressure):
        raise OutsideValidity(
            f"LineRollingResistance: at {speed:.6g} m/s the layers are pulled inside the strip, so that the contact is "
            "no single one; press less, or use softer or thicker layers."
        )
    return found


def _on_half_planes(creep: CreepSeries, radius: float, half_width: float, speed: float) -> Passage:
    """Return the strip of a half-width."""
    soft = creep.glassy + float(np.sum(creep.compliances))
    passing = speed / half_width
    delays = creep.times * passing
    slow = (delays > IMMEDIATE) & (_relaxation_times(creep) * passing > FASTEST)  # one after the other they alternate
    if np.max(delays[~slow], initial=0.0) > MOST_IMMEDIATE:
        raise OutsideValidity(
            f"LineRollingResistance: at {speed:.6g} m/s, half of the contact passes in {1.0 / passing:.3g} s; the "
            "solid relaxes so much faster, and creeps so much more slowly, that the edge is not resolved: give a "
            "smaller glassy modulus."
        )
    glassy = creep.glassy + float(np.sum(creep.compliances[~slow]))
    kept = CreepSeries(glassy, 0.0, creep.compliances[slow], creep.times[slow])
    relaxing = _relaxation_times(kept) * passing
    strip = passing_strip(glassy / soft, kept.compliances / soft, delays[slow], relaxing)
    late = float(creep.compliances[~slow] @ creep.times[~slow]) * speed / soft
    level = half_width / (2.0 * radius * soft)
    first, second = strip.waves(2).tolist()
    return Passage(half_width, half_width * (strip.leading - 1.0), level, strip, first, second, radius, late)


@functools.lru_cache(maxsize=64)
def _relaxation_times(creep: CreepSeries) -> Array:
    """Return the relaxation times [s] of a solid that creeps so."""
    return of_creep(creep).times
