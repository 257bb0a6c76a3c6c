r"""A measured bed that yields differently along x and along y: springs of a contact that is no disc.

Of each depth the stiffness of the whole contact is known where nothing slips, :math:`K_x` and :math:`K_y`; springs that
touch at the radius a have the part of it that comes with them,

.. math:: c_T(a) = \frac12\frac{\mathrm d K_x}{\mathrm d a} , \qquad K_x = r_x\,k ,

so that partial slip, which shrinks to contacts of less depth, meets their stiffnesses (Ciavarella, Jaeger).  Where all
that touched since a depth d* slips, the tractions are those of the pressures since, whose sum dF shifts by
:math:`\mu\,\mathrm dF/K_x`: springs slide at

.. math:: u_x = \mu\,(D(d)-D(\gamma)) , \qquad D(d) = \int_0^d\frac{k}{K_x}\,\mathrm d\gamma ,

as those of a bed of the stiffness :math:`K_x` and the depth D would, which bears the same normal force.
"""

from __future__ import annotations

import dataclasses
import functools
from typing import Annotated, Any

import numpy as np

from winkler.foundation.force_curve import FEWEST_POINTS
from winkler.foundation.measured import BARBER, MeasuredBed
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import POSITIVE, NonNegative, Numbers
from winkler.values.errors import InvalidInput
from winkler.values.limits import MEASURED_PLACES
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

LAYERED_DISCS = Note(
    Assumption.SHAPE,
    Standing.ASYMPTOTIC,
    "Radii are those of discs with the same stiffness on the same layers. The outline, pressure and conductance "
    "of the real contact differ from those of a disc.",
    BARBER,
)
PARTS = np.arange(1, 17) / 16.0
"""Of the way from a radius to the next, where the depth of slipping springs is summed."""


@value
class DirectionalBed(MeasuredBed):
    """Springs of known stiffness and gap, and of known stiffness along the surface in two directions.

    Parameters
    ----------
    radii, stiffnesses, depths, scatter, mindlin_ratio, disc
        As of `MeasuredBed`; the ratio is that of a disc.
    ratios_along, ratios_across : array_like, (n,)
        K_x/k and K_y/k [-] at these radii, of the whole contact without slip.  A shear force or shift is along x;
        `turned` has it along y.
    homogeneous : bool, optional
        Whether radii are those of discs on homogeneous half-spaces, which conduct as they are stiff; otherwise on the
        layers that the springs were computed for.
    shift_error, loss_error : float, optional
        Greatest differences from boundary elements with friction: of shifts over the greatest shift, of losses over the
        greatest loss.  Zero if they were not compared.

    Raises
    ------
    InvalidInput
        If the arrays do not fit one another, or do not rise.
    """

    __words__ = words(
        ratios_along=("K_x/k", "", "tangential over normal stiffness of the contact, along x"),
        ratios_across=("K_y/k", "", "tangential over normal stiffness of the contact, along y"),
        directional=("", "", "greatest difference of both ratios, over the lesser of them"),
        shift_error=("", "", "greatest difference of a shift from boundary elements, over the greatest shift"),
        homogeneous=("", None, "whether radii are those of discs on homogeneous half-spaces"),
        loss_error=("", "", "greatest difference of a loss from boundary elements, over the greatest loss"),
    )

    ratios_along: Annotated[Array, Numbers(POSITIVE, FEWEST_POINTS, MEASURED_PLACES)] = dataclasses.field(kw_only=True)
    ratios_across: Annotated[Array, Numbers(POSITIVE, FEWEST_POINTS, MEASURED_PLACES)] = dataclasses.field(kw_only=True)
    shift_error: NonNegative = 0.0
    loss_error: NonNegative = 0.0
    homogeneous: bool = True

    def __post_init__(self) -> None:
        super().__post_init__()
        if not self.ratios_along.size == self.ratios_across.size == self.radii.size:
            raise InvalidInput(
                f"DirectionalBed: there are {self.radii.size} radii, {self.ratios_along.size} ratios along and "
                f"{self.ratios_across.size} across; give one of each for each radius."
            )
        for ratios in (self.ratios_along, self.ratios_across):
            if np.any(np.diff(ratios * self.stiffnesses) <= 0.0):
                raise InvalidInput(
                    "DirectionalBed: the stiffness along the surface falls where the contact grows; give ratios that "
                    "fall less than the stiffness rises."
                )

    @property
    def notes(self) -> tuple[Note, ...]:
        """What the points are, and what their radii mean on layers."""
        return super().notes if self.homogeneous else (super().notes[0], LAYERED_DISCS)

    @property
    def turned(self) -> DirectionalBed:
        """The same springs sheared along y."""
        return dataclasses.replace(self, ratios_along=self.ratios_across, ratios_across=self.ratios_along)

    @property
    def pressed(self) -> MeasuredBed:
        """The same springs for what is pressed only: equal for both directions."""
        return MeasuredBed(self.radii, self.stiffnesses, self.depths, self.scatter, self.mindlin_ratio, self.disc)

    @property
    def sheared(self) -> MeasuredBed:
        """Springs of the stiffness K_x under the depth D, for what slips: as stiff along the surface as across it.

        At the same radius they bear the same normal force.  These springs themselves where the ratio is constant.
        """
        return _sheared(self) if np.ptp(self.ratios_along) > 0.0 else self

    @property
    def directional(self) -> float:
        """Greatest difference of both ratios, over the lesser of them [-]."""
        return float(np.max(np.abs(np.log(self.ratios_along / self.ratios_across))))

    def tangential_stiffness(self, x: Array) -> Array:
        """Tangential stiffness of the springs per length c_T(x) [Pa], for shear along x."""
        ratio, rise = _ratio(self, np.asarray(x, dtype=float))
        return np.asarray(ratio * self.normal_stiffness(x) + 0.5 * rise * self.stiffness(x))


def _ratio(bed: DirectionalBed, x: Array) -> tuple[Array, Array]:
    """Return K_x/k and its slope [1/m]; constant below the first radius that is not zero."""
    if np.ptp(bed.ratios_along) == 0.0:
        return np.full(x.shape, bed.ratios_along[0]), np.zeros(x.shape)
    first = float(bed.radii[0] if bed.radii[0] > 0.0 else bed.radii[1])
    curve = _curve(bed)
    place = np.log(np.maximum(x, first))
    return curve(place), np.where(x > first, curve(place, 1) / np.maximum(x, first), 0.0)


@functools.lru_cache(maxsize=64)
def _curve(bed: DirectionalBed) -> Any:
    from scipy.interpolate import PchipInterpolator

    inner = bed.radii > 0.0
    return PchipInterpolator(np.log(bed.radii[inner]), bed.ratios_along[inner])


@functools.lru_cache(maxsize=64)
def _sheared(bed: DirectionalBed) -> MeasuredBed:
    radii = bed.radii
    fine = np.concatenate([radii[:1], (radii[:-1, None] + np.diff(radii)[:, None] * PARTS).ravel()])
    depth, softness = bed.gap(fine), 1.0 / _ratio(bed, fine)[0]
    steps = (0.5 * (softness[1:] + softness[:-1]) * np.diff(depth)).reshape(-1, PARTS.size)
    depths = bed.depths[0] * softness[0] + np.concatenate([[0.0], np.cumsum(np.sum(steps, axis=1))])
    return MeasuredBed(radii, bed.ratios_along * bed.stiffnesses, depths, bed.scatter, 1.0, bed.disc)
