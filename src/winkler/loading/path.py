"""A path: the normal and the lateral loads of two bodies, point after point.

Between two points everything that is prescribed changes in proportion to time.  Before the first point the bodies are
pressed straight down according to its normal load, and then moved along the surface according to its lateral load.  A
path that is stated in steps (go there, wait, oscillate) is a `winkler.loading.program.Program`.

Loads of which a problem takes one number, not an array, are types of fields here (`OneLoad`, `OnePositiveNormal`, ...).
"""

from __future__ import annotations

import math
from typing import Annotated, TypeAlias

import numpy as np

from winkler.loading.loads import (
    Angle,
    Depth,
    Force,
    Lateral,
    LineForce,
    LineShearForce,
    Load,
    Normal,
    Radius,
    ShearForce,
    Shift,
    Torque,
)
from winkler.numerics.equations.oscillation_times import oscillation_moments, sine
from winkler.numerics.types import Array, Quantity
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import Numbers
from winkler.values.errors import InvalidInput
from winkler.values.value import frozen_array, value

POINTS_PER_CYCLE = 40
"""Points of one oscillation."""


@value
class Path:
    """A normal load and a lateral load over time.

    Parameters
    ----------
    time : ndarray, (steps,)
        Times of the points [s], never decreasing.
    normal : Depth or Force
        ``(steps,)``, or one constant number.
    lateral : Shift, ShearForce, Angle or Torque, optional
        Lateral load ``(steps,)``, in planar motion ``(steps, 2)``, or one constant number; none by default.

    Raises
    ------
    InvalidInput
        If the lengths differ, or time falls.

    Examples
    --------
    >>> Path([0.0, 1.0, 2.0], Force(100.0), Shift([0.0, 1e-6, -1e-6])).across
    array([100., 100., 100.])
    """

    time: Annotated[Array, Numbers(order="never falling")]
    normal: Normal
    lateral: Lateral = Shift(0.0)

    def __post_init__(self) -> None:
        for name in ("normal", "lateral"):
            object.__setattr__(self, name, _spread(name, getattr(self, name), self.time.size))

    @classmethod
    def through(cls, normal: Normal, lateral: Lateral) -> Path:
        """Return the path through points that are reached one second after the other.

        Nothing that is computed from friction alone depends on how fast the points are reached.

        Parameters
        ----------
        normal : Depth or Force
            ``(steps,)``, or one constant number.
        lateral : Shift, ShearForce, Angle or Torque
            ``(steps,)``, in planar motion ``(steps, 2)``, or one constant number.

        Returns
        -------
        Path

        Raises
        ------
        InvalidInput
            If the lengths differ.

        Examples
        --------
        >>> Path.through(Depth([1e-6, 2e-6, 1e-6]), Shift(0.0)).time
        array([0., 1., 2.])
        """
        counts = [len(row) for row in (np.atleast_1d(numbers_of(normal)), np.atleast_1d(numbers_of(lateral)))]
        return Path(np.arange(max(counts), dtype=float), normal, lateral)

    @classmethod
    def oscillation(
        cls,
        *,
        depth: float = math.nan,
        force: float = math.nan,
        amplitude: float | Lateral,
        cycles: float = 1.0,
        frequency: float = 1.0,
        count: int = POINTS_PER_CYCLE,
    ) -> Path:
        """Return a harmonic oscillation along the surface under constant normal load, from its middle position.

        Parameters
        ----------
        depth, force : float
            The steady normal load, a depth [m] or a force [N]: one of both.
        amplitude : float, Shift, ShearForce, Angle or Torque
            Amplitude of the oscillation; a plain number is a displacement [m].
        cycles : float, optional
            How many.
        frequency : float, optional
            Frequency [Hz].
        count : int, optional
            Points per cycle, evenly spaced in time, in addition to the reversals.

        Returns
        -------
        Path

        Raises
        ------
        InvalidInput
            If a number is missing, not positive where it must be, or both depth and force are given.

        Examples
        --------
        >>> Path.oscillation(depth=1e-6, amplitude=0.5, cycles=1, count=4).along
        array([ 0. ,  0.5,  0. , -0.5,  0. ])
        """
        if math.isnan(depth) == math.isnan(force):
            raise InvalidInput("Path: an oscillation takes one steady normal load; give either depth or force.")
        swing = amplitude if isinstance(amplitude, Shift | ShearForce | Angle | Torque) else Shift(amplitude)
        size = numbers_of(swing)
        if size.ndim != 0:
            raise InvalidInput(
                f"Path: the amplitude of an oscillation has the shape {size.shape}; give one number, or in the plane a "
                "Program with Oscillate."
            )
        turns = oscillation_moments(cycles, count)
        if not (math.isfinite(frequency) and frequency > 0.0):
            raise InvalidInput(f"Path: the frequency is {frequency!r}; it must be positive and finite, in Hz.")
        normal = Force(force) if math.isnan(depth) else Depth(depth)
        return Path(turns / frequency, normal, type(swing)(size * sine(turns)))

    @property
    def across(self) -> Array:
        """What is prescribed across the surface, ``(steps,)``: depths [m] or forces [N]."""
        return numbers_of(self.normal)

    @property
    def along(self) -> Array:
        """What is prescribed along the surface, ``(steps,)`` or ``(steps, 2)``: [m], [N], [rad] or [N m]."""
        return numbers_of(self.lateral)

    @property
    def in_plane(self) -> bool:
        """Whether the lateral load has two components."""
        return self.along.ndim == 2


def numbers_of(load: Normal | Lateral) -> Array:
    """Return the numbers of a load [SI].

    Parameters
    ----------
    load : Depth, Force, Shift, ShearForce, Angle or Torque
        Any of them.

    Returns
    -------
    ndarray
        In the shape in which they were given.
    """
    match load:
        case Depth(numbers) | Force(numbers) | Shift(numbers) | ShearForce(numbers) | Angle(numbers) | Torque(numbers):
            return np.asarray(numbers, dtype=float)


def _spread(word: str, load: Normal | Lateral, steps: int) -> Normal | Lateral:
    numbers = numbers_of(load)
    planar = isinstance(load, Shift | ShearForce) and numbers.shape == (steps, 2)
    if not planar and numbers.shape not in ((), (steps,)):
        raise InvalidInput(
            f"Path: {word} has the shape {numbers.shape} for {steps} points in time; give one number for each, or one "
            "for all."
        )
    return type(load)(frozen_array(numbers if numbers.ndim else np.full(steps, float(numbers))))


def load_number(load: Load) -> Quantity:
    """Return what a load prescribes."""
    match load:
        case Depth(number) | Force(number) | Radius(number):
            return number


def _positive_per_length(load: LineForce | LineShearForce) -> bool:
    number = load.force_per_length if isinstance(load, LineForce) else load.shear_force_per_length
    return np.ndim(number) == 0 and float(number) > 0.0


def _one(load: Normal | Lateral | Radius) -> bool:
    return np.ndim(load.radius if isinstance(load, Radius) else numbers_of(load)) == 0


def _positive(load: Normal | Lateral) -> bool:
    return _one(load) and 0.0 < float(numbers_of(load)) < math.inf


OneLoad: TypeAlias = Annotated[
    Force[float] | Depth[float] | Radius[float],
    Condition(_one, "give Force, Depth or Radius with one number, and sweep over several"),
]
OneNormal: TypeAlias = Annotated[
    Depth[float] | Force[float], Condition(_one, "give Depth(d) or Force(F) with one number, and sweep over several")
]
OnePositiveNormal: TypeAlias = Annotated[
    Depth[float] | Force[float],
    Condition(_positive, "give Depth(d) or Force(F) with one positive number, and sweep over several"),
]
SWING = Condition(
    lambda load: bool(np.all(numbers_of(load) >= 0.0)),
    "give Shift(U) in m or ShearForce(F_x) in N, how far to each side, zero or more",
)
OnePositiveSwing: TypeAlias = Annotated[
    Shift[float] | ShearForce[float],
    Condition(_positive, "give Shift(U) in m or ShearForce(F_x) in N with one positive number, how far to each side"),
]
OnePositiveLineForce: TypeAlias = Annotated[
    LineForce[float],
    Condition(_positive_per_length, "give LineForce(P) in N/m with one positive number, and sweep over several"),
]
OnePositiveLineSwing: TypeAlias = Annotated[
    LineShearForce,
    Condition(_positive_per_length, "give LineShearForce(Q) in N/m with one positive number, how far to each side"),
]
