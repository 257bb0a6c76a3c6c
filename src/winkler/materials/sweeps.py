"""Moduli measured at several temperatures, from which a master curve is made (`winkler.MasterCurve`)."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from winkler.numerics.springs.spectrum_response import Measurements, Response
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import POSITIVE, Numbers, PoissonRatio
from winkler.values.errors import InvalidInput
from winkler.values.limits import MEASURED_TIMES
from winkler.values.value import value, words

FEWEST_ROWS = 4
ROWS = Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES)


class RowsOfOneLength:
    """Measurements whose rows have as many numbers each."""

    def __post_init__(self) -> None:
        (first, content), *others = ((name, row) for name, row in vars(self).items() if isinstance(row, np.ndarray))
        for name, row in others:
            if row.size != content.size:
                raise InvalidInput(
                    f"{type(self).__name__}: {first} has {content.size} numbers and {name} {row.size}; give as many."
                )


@value
class DynamicSweeps(RowsOfOneLength):
    """Storage and loss moduli over frequency and temperature: isothermal or isochronal sweeps, rows in any order.

    Parameters
    ----------
    temperature : ndarray, (n,)
        T [K], positive.
    angular_frequency : ndarray, (n,)
        omega [rad/s], positive.
    storage_shear, loss_shear : ndarray, (n,)
        G' and G'' [Pa], positive.
    poisson : float, optional
        nu [-].
    reading : str, optional
        How the file was read: rows that were left out.

    Raises
    ------
    InvalidInput
        If the rows differ in length, are too short, or contain a number that is not positive.

    Examples
    --------
    >>> omega = np.tile([1.0, 10.0, 100.0], 2)
    >>> power = 1e3 * (1j * omega) ** 0.2
    >>> DynamicSweeps(np.repeat([300.0, 320.0], 3), omega, power.real, power.imag).temperature.size
    6
    """

    __words__ = words(temperature=("T", "K", "temperature of each row"), reading=("", None, "how the file was read"))

    temperature: Annotated[Array, ROWS]
    angular_frequency: Annotated[Array, ROWS]
    storage_shear: Annotated[Array, ROWS]
    loss_shear: Annotated[Array, ROWS]
    poisson: PoissonRatio = 0.5
    reading: str = ""

    def measured(self, group: Array) -> tuple[Measurements, ...]:
        """Return storage and loss with the index of their temperature ``(n,)``."""
        return (
            Measurements(Response.STORAGE, self.angular_frequency, group, self.storage_shear),
            Measurements(Response.LOSS, self.angular_frequency, group, self.loss_shear),
        )


@value
class RelaxationSweeps(RowsOfOneLength):
    """Relaxation moduli over time at several temperatures, rows in any order.

    Parameters
    ----------
    temperature : ndarray, (n,)
        T [K], positive.
    time : ndarray, (n,)
        Since the step of strain [s], positive.
    shear : ndarray, (n,)
        G(t) [Pa], positive.
    poisson : float, optional
        nu [-].

    Raises
    ------
    InvalidInput
        If the rows differ in length, are too short, or contain a number that is not positive.

    Examples
    --------
    >>> t = np.tile([0.1, 1.0, 10.0], 2)
    >>> RelaxationSweeps(np.repeat([300.0, 320.0], 3), t, 1e6 * t**-0.1).poisson
    0.5
    """

    __words__ = words(
        temperature=("T", "K", "temperature of each row"),
        time=("t", "s", "time since the step of strain"),
        shear=("G(t)", "Pa", "relaxation modulus of each row"),
    )

    temperature: Annotated[Array, ROWS]
    time: Annotated[Array, ROWS]
    shear: Annotated[Array, ROWS]
    poisson: PoissonRatio = 0.5

    def measured(self, group: Array) -> tuple[Measurements, ...]:
        """Return the relaxation with the index of its temperature ``(n,)``."""
        return (Measurements(Response.RELAXATION, self.time, group, self.shear),)
