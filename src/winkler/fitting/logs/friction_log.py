r"""Logs of loops of friction: displacement and shear force of cycle after cycle.

A cycle goes from one least displacement to the next one; turning points are those by more than a tenth of the whole
range, and by more than the noise.  The loss of a cycle is the area of its loop, which no elastic frame changes.
"""

from __future__ import annotations

import dataclasses
import functools
import math
from typing import Annotated

import numpy as np

from winkler.fitting.logs.estimated import Estimate, mean_of
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import FINITE, POSITIVE, Numbers
from winkler.values.errors import InvalidInput
from winkler.values.limits import PATH_POINTS
from winkler.values.value import value, words

TURN_SHARE, TURN_NOISES = 0.1, 12.0
"""Least way back behind a turning point, over the range of the displacement, and over its noise."""
FEWEST_POINTS = 16
"""Points of a cycle."""
STUCK_SHARE = 0.25
"""Part of the height of a branch, behind its turning point, over which its slope is taken."""

Cycle = tuple[int, int, int]


def _none() -> Array:
    return np.zeros(0)


@value
class FrictionLog:
    """Displacement and shear force of a contact over many cycles of oscillation.

    Parameters
    ----------
    displacement : ndarray, (n,)
        Tangential displacement of the drive [m], whose frame may deflect.
    shear_force : ndarray, (n,)
        Force with which the drive moves the contact [N]. If the log has the opposite sign, the sign is changed.
    normal_force : ndarray, (n,), optional
        F_N [N]; empty where it was not measured.

    Raises
    ------
    InvalidInput
        If the columns differ in length, or there is no whole cycle of sixteen points.
    """

    __words__ = words(
        displacement=("x", "m", "displacement of the drive along the surface"),
        shear_force=("F_x", "N", "force of the drive along the surface"),
        normal_force=("F_N", "N", "force that presses the bodies together"),
    )

    displacement: Annotated[Array, Numbers(FINITE, FEWEST_POINTS, PATH_POINTS)]
    shear_force: Annotated[Array, Numbers(FINITE, FEWEST_POINTS, PATH_POINTS)]
    normal_force: Annotated[Array, Numbers(POSITIVE, 0, PATH_POINTS)] = dataclasses.field(default_factory=_none)

    def __post_init__(self) -> None:
        sizes = {self.displacement.size, self.shear_force.size} | ({self.normal_force.size} - {0})
        if len(sizes) > 1:
            raise InvalidInput(
                "FrictionLog: displacement, shear_force and normal_force differ in length; give as many."
            )
        if not self.cycles:
            raise InvalidInput(
                f"FrictionLog: the displacement has no whole cycle of {FEWEST_POINTS} points or more; give a "
                "longer log, or more points per cycle."
            )

    @functools.cached_property
    def cycles(self) -> tuple[Cycle, ...]:
        """For each complete cycle the points of minimum, maximum, and again minimum displacement."""
        turns = _turns(self.displacement)
        lows = [place for place, is_low in turns if is_low]
        highs = [place for place, is_low in turns if not is_low]
        return _paired(lows, highs)

    @functools.cached_property
    def reversed(self) -> bool:
        """Whether the log contains the force on the drive, so that most loops have the opposite sense of rotation."""
        return float(np.sum(self._areas)) < 0.0

    @property
    def force(self) -> Array:
        """The shear force by which the drive moves the contact [N], ``(n,)``."""
        return -self.shear_force if self.reversed else self.shear_force

    @functools.cached_property
    def _areas(self) -> Array:
        areas = []
        for low, _, end in self.cycles:
            x, f = (np.append(part[low : end + 1], part[low]) for part in (self.displacement, self.shear_force))
            areas.append(float(np.sum(0.5 * (f[1:] + f[:-1]) * np.diff(x))))
        return np.array(areas)

    @property
    def loss_per_cycle(self) -> Array:
        """Work of the shear force in each cycle [J], ``(m,)``."""
        return np.asarray(-self._areas if self.reversed else self._areas)

    @property
    def stroke(self) -> Array:
        """Displacement of the drive from end to end in each cycle [m], ``(m,)``."""
        return np.array([self.displacement[high] - self.displacement[low] for low, high, _ in self.cycles])

    @property
    def shear_amplitude(self) -> Array:
        """Half the range of the shear force in each cycle [N], ``(m,)``."""
        return np.array([0.5 * float(np.ptp(self.shear_force[low : end + 1])) for low, _, end in self.cycles])

    @property
    def normal_of_cycles(self) -> Array:
        """Mean normal force of each cycle [N], ``(m,)``; empty where it was not measured."""
        if not self.normal_force.size:
            return self.normal_force
        return np.array([float(np.mean(self.normal_force[low : end + 1])) for low, _, end in self.cycles])

    @property
    def slope(self) -> Array:
        """Slope of the branches behind their turning points in each cycle [N/m], ``(m,)``: contact and frame in series.

        The slope is taken over the first quarter of a branch; a slipping ball already loses some stiffness there.
        """
        return np.array([self.slope_of(cycle) for cycle in self.cycles])

    def slope_of(self, cycle: Cycle) -> float:
        """Return the slope of one cycle [N/m]."""
        low, high, end = cycle
        return 0.5 * (self._slope(low, high) + self._slope(high, end))

    def _slope(self, first: int, last: int) -> float:
        x, f = self.displacement[first : last + 1], self.force[first : last + 1]
        part = np.abs(f - f[0]) <= STUCK_SHARE * float(np.ptp(f))
        part[np.argmin(part) :] = bool(np.all(part))
        part[:3] = True
        return float(np.polyfit(x[part] - x[0], f[part], 1)[0])

    def late(self, of_cycles: Array) -> Estimate:
        """Return the mean over the second half of the cycles, after running-in.

        Parameters
        ----------
        of_cycles : ndarray, (m,)
            A number of each cycle.
        """
        late = of_cycles[of_cycles.size // 2 :]
        if late.size < 3:
            return Estimate(float(np.mean(late)), float("nan"), 1.0)
        return mean_of(late)


def noise_of(samples: Array) -> float:
    """Return the standard deviation of white noise of samples ``(n,)`` that change slowly beside it."""
    fourth = np.diff(samples, 4)  # of a sinusoid of 16 points a period 0.4 % of its amplitude are left
    return 1.4826 * float(np.median(np.abs(fourth))) / math.sqrt(70.0) if fourth.size else 0.0


def _paired(lows: list[int], highs: list[int]) -> tuple[Cycle, ...]:
    """Return the cycles between neighbouring lows."""
    places = np.searchsorted(highs, lows[:-1], side="right")  # of the first high behind each low
    return tuple(
        (low, highs[place], end)
        for low, end, place in zip(lows[:-1], lows[1:], places.tolist(), strict=True)
        if place < len(highs) and low < highs[place] < end and end - low >= FEWEST_POINTS
    )


def _turns(displacement: Array) -> list[tuple[int, bool]]:
    """Return the turning points in their order, and whether they are low ones, without those of the ends."""
    noise, span = noise_of(displacement), float(np.ptp(displacement))
    least = max(TURN_SHARE * span, min(TURN_NOISES * noise, 0.5 * span))
    found: list[tuple[int, bool]] = []
    low = high = 0
    rising: bool | None = None
    numbers = displacement.tolist()
    for place, number in enumerate(numbers):
        if number < numbers[low]:
            low = place
        if number > numbers[high]:
            high = place
        if rising is not False and number < numbers[high] - least:
            if rising or high > 0:
                found.append((high, False))
            rising, low = False, place
        elif rising is not True and number > numbers[low] + least:
            if rising is False or low > 0:
                found.append((low, True))
            rising, high = True, place
    return found
