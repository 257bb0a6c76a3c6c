"""Forces that a rolling pair transmits, for problems that seek its creepages: along, across, and turning."""

from __future__ import annotations

from typing import Annotated, Any, NamedTuple

import numpy as np

from winkler.loading.loads import ShearForce, Torque
from winkler.numerics.types import ZERO, Array, PerLoad, Q
from winkler.problems.rolling.creepage import Creepage
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import FINITE_QUANTITY
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words


@value
class Spin(PerLoad[Q]):
    """A prescribed spin of a rolling pair, in addition to given forces.

    Parameters
    ----------
    spin : float or ndarray
        phi [1/m], rotation of the second body over the first about the normal, per distance rolled.
    """

    __words__ = words(spin=(r"\varphi", "1/m", "rotation about the normal per distance rolled"))

    spin: Annotated[Q, FINITE_QUANTITY]


NO_SPIN: Any = Spin(0.0)


@value
class CreepForce(PerLoad[Q]):
    """Prescribed forces on a rolling pair, for which the creepages are computed.

    Parameters
    ----------
    longitudinal : float or ndarray, optional
        F_x [N] on the first body along the rolling direction +x.
    lateral : float or ndarray, optional
        F_y [N], across it.
    twist : Spin or Torque, optional
        Rotation of the pair about the normal: a given spin, or a moment M_z [N m] about the middle of the map whose
        spin is computed.

    All arguments may be arrays whose shapes broadcast; the results have the common shape.

    Raises
    ------
    InvalidInput
        If a number is not finite, or the shapes do not broadcast.

    Examples
    --------
    A wheel that pulls with 10 kN, guides with 2 kN and spins:

    >>> CreepForce(10e3, 2e3, Spin(0.2)).shape
    ()
    """

    __words__ = words(
        longitudinal=("F_x", "N", "creep force along the direction of rolling"),
        lateral=("F_y", "N", "creep force across the direction of rolling"),
        twist=("", None, "the spin, or the moment about the normal"),
        shape=("", None, "the common shape of the three"),
    )

    longitudinal: Annotated[Q, FINITE_QUANTITY] = ZERO
    lateral: Annotated[Q, FINITE_QUANTITY] = ZERO
    twist: Spin[Q] | Torque[Q] = NO_SPIN

    def __post_init__(self) -> None:
        try:
            _ = self.shape
        except ValueError:
            shapes = ", ".join(str(np.shape(part)) for part in self._parts)
            raise InvalidInput(
                f"CreepForce: the shapes of F_x, F_y and the twist do not fit each other: {shapes}; give one shape."
            ) from None

    @property
    def _parts(self) -> tuple[Q, Q, Q]:
        turned = self.twist.spin if isinstance(self.twist, Spin) else self.twist.torque
        return self.longitudinal, self.lateral, turned

    @property
    def shape(self) -> tuple[int, ...]:
        """The common shape; empty for one pair of forces."""
        return np.broadcast_shapes(*(np.shape(part) for part in self._parts))

    def broadcast(self) -> tuple[Array, Array, Array]:
        """Return F_x, F_y and the spin or the moment, each ``(m,)``: the common shape, flattened."""
        along, across, turning = np.broadcast_arrays(*(np.asarray(part, dtype=float) for part in self._parts))
        return along.ravel(), across.ravel(), turning.ravel()


def _one_push(drive: object) -> bool:
    return not isinstance(drive, ShearForce) or np.shape(drive.shear_force) in ((), (2,))


ONE_PUSH = Condition(
    _one_push, "give ShearForce(F_x) or ShearForce([F_x, F_y]), and several forces as CreepForce(F_x, F_y)"
)

OneRollingDrive = Annotated[
    ShearForce | CreepForce | Creepage,
    Condition(
        lambda drive: given_of(drive).shape == () if _one_push(drive) else False,
        "give ShearForce(F_x) or ShearForce([F_x, F_y]), one CreepForce, or one Creepage",
    ),
]
"""What is prescribed of a pair that begins to roll."""


class Given(NamedTuple):
    """What is prescribed, case by case.

    Parameters
    ----------
    numbers
        xi, eta, phi [1/m], or instead F_x, F_y [N], M_z [N m], (cases, 3).
    by_force
        Which of the three is a force, (3,).
    shape
        That of the results.
    """

    numbers: Array
    by_force: Array
    shape: tuple[int, ...]


def given_of(drive: Creepage | CreepForce | ShearForce) -> Given:
    """Return what a drive prescribes."""
    drive = _sorted(drive)
    forced = isinstance(drive, CreepForce)
    turned = isinstance(drive, CreepForce) and isinstance(drive.twist, Torque)
    return Given(np.stack(drive.broadcast(), axis=1), np.array([forced, forced, turned]), drive.shape)


def first_of(drive: Creepage | CreepForce | ShearForce, count: int) -> Creepage | CreepForce:
    """Return the first of many creepages or forces."""
    drive = _sorted(drive)
    along, across, turning = (part[:count] for part in drive.broadcast())
    if isinstance(drive, Creepage):
        return Creepage(along, across, turning)
    return CreepForce(along, across, Torque(turning) if isinstance(drive.twist, Torque) else Spin(turning))


def _sorted(drive: Creepage | CreepForce | ShearForce) -> Creepage | CreepForce:
    """Return the creep force that a shear force stands for: without spin."""
    if isinstance(drive, ShearForce):
        return CreepForce(*np.ravel(np.asarray(drive.shear_force, dtype=float)).tolist())
    return drive
