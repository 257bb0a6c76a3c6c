r"""Fit of the positions of a relaxing contact under measured forces; of forces during approach.

Out of contact a force determines the baseline, but no position; near first touch a little noise of the force is a
large distance.  At points of the approach with less than a tenth of the greatest force, the force at the measured
position is therefore fitted, and at all others the position under the measured force.  Both are weighted by the noise,

.. math:: \sigma_{D,i}^2 = \sigma_D^2 + (\sigma_F/k_i)^2, \qquad \sigma_{F,i}^2 = \sigma_F^2 + (k_i\,\sigma_D)^2 ,

with the stiffness :math:`k_i` of contact and machine in series: a point has the same weight in either form.
"""

from __future__ import annotations

import dataclasses
import functools
from typing import Any

import numpy as np

from winkler.fitting.curves.checks import CurveOutline
from winkler.fitting.noise.disturbances import disturbances_of
from winkler.fitting.outcome import CreepFit
from winkler.fitting.task import Prediction
from winkler.fitting.viscoelastic.corners import Corners, corners_of, with_corners
from winkler.fitting.viscoelastic.response import ContactHistory, ElasticTable, elastic_table, forces, positions
from winkler.fitting.viscoelastic.task import RelaxingTask
from winkler.loading.loads import Force
from winkler.loading.path import Path
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.springs.exponential_sums import CreepSeries
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import elastic_like, relaxation_of
from winkler.values.errors import OutsideValidity

FORCE_FIT_SHARE = 0.1
"""Part of the greatest force from which on positions are fitted."""
LEAST_NOISE = 1e-6
"""Least noise relative to the range."""
SMOOTHING_DIVISOR = 100
"""Points over the half-width of smoothing."""
BIAS_STEPS = 2
"""Steps of the correction of bias."""
LEAST_POSITION_SHARE = 0.1
"""Least noise of positions relative to their scatter."""


class UnderForce(RelaxingTask):
    """Positions fitted under measured forces; forces during approach."""

    @property
    def measured(self) -> Array:
        """The positions [m]."""
        return self.curve.position

    @property
    def by_force(self) -> Array:
        """Points at which the force is fitted ``(n,)``."""
        return np.asarray(self.per_force > 0.0)

    def slope(self, name: str, numbers: dict[str, float], prediction: Prediction) -> Any:
        """Return None: no derivative of a position has a closed form."""
        return None

    @functools.cached_property
    def disturbances(self) -> Array:
        """The drift of a position, weighted ``(n, 1)``; none where the force is fitted."""
        return disturbances_of(self.curve, of_force=False) * np.where(self.by_force, 0.0, self.weights)[:, None]

    def courses(self, jacobian: Array) -> Array:
        """Return the drift of a position, also in the forces at the points where these are fitted ``(n, 1)``.

        It moves these forces as a contact point does that drifts.
        """
        names = [parameter.name for parameter in self.parameters]
        late = ~self.by_force & (self.weights > 0.0)
        if "contact_point" not in names or not self.by_force.any() or not late.any():
            return self.disturbances
        shift = jacobian[:, names.index("contact_point")]
        unit = float(np.mean(shift[late] / self.weights[late]))
        return disturbances_of(self.curve, of_force=False) * (shift / unit)[:, None]

    def instrument(self, coordinates: Array, prediction: Prediction) -> Array:
        """Return the derivatives along the smoothed curve, which the noise of the input does not bias."""
        del prediction
        return self._steady.slopes(coordinates)

    def quiet(self, prediction: Prediction) -> Array:
        """Return the points at which positions are fitted ``(n,)``."""
        return ~self.by_force

    @functools.cached_property
    def _corners(self) -> Corners:
        """The turns of the force between the points at which positions are fitted."""
        found = corners_of(self.curve.time, self.curve.force, self.curve.direction)
        late = ~(self.by_force[found.before] | self.by_force[found.before + 1])
        return Corners(*(part[late] for part in found))

    def prediction(self, coordinates: Array) -> Prediction:
        """Return the positions [m] with drift and the deflection of the machine.

        Where the force is fitted, the position is the measured one, less the misfit of the force times `per_force`.
        """
        numbers = self.numbers(coordinates)
        borne, place = self.curve.force - self.line(numbers), self.place(numbers)
        contact, early = ContactHistory(borne, borne, borne), self.by_force
        if early.any():  # driven by the motion up to here
            last = int(np.flatnonzero(early)[-1]) + 1
            contact = self.moved(numbers, self.curve.time[:last], place[:last])
            contact = ContactHistory(*(np.concatenate([part, borne[last:]]) for part in contact))
        most = float(np.max(borne, where=early, initial=0.0))  # at most the measured force
        driving = np.where(early, np.minimum(contact.force, most), borne)
        time, driven, measured = with_corners(self._corners, self.curve.time, self.curve.force, driving)
        depth, edge = (part[measured] for part in self.loaded(numbers, time, driven))
        if not np.all(np.isfinite(depth)):
            raise OutsideValidity(
                "fit: the solid sinks in farther than twice the travel of the machine; give bounds or starts nearer to "
                "the answer."
            )
        beyond = self.curve.position - place
        fitted = np.where(
            early,
            self.curve.position - self.per_force * (borne - contact.force),
            beyond + depth + self.curve.compliance * borne,
        )
        contact = ContactHistory(driving, np.where(early, contact.depth, depth), np.where(early, contact.edge, edge))
        return Prediction(fitted, driving > 0.0, contact)

    def moved(self, numbers: dict[str, float], time: Array, place: Array) -> ContactHistory:
        """Return the response to a motion [m] that only goes in."""
        series = relaxation_of("fit", self.with_numbers(numbers).bed)
        return forces(self._table(numbers), series, time, place, time.size, self.curve.compliance)

    def loaded(self, numbers: dict[str, float], time: Array, driven: Array) -> tuple[Array, Array]:
        """Return depths [m] under forces [N], and the depths at which an elastic contact is as wide."""
        depth = positions(self._table(numbers), self._creep(numbers), time, driven)
        return depth, depth

    def contact_compliance(self, numbers: dict[str, float], depth: Array) -> Array:
        """Return the immediate compliance of contacts [m/N]; infinite without contact."""
        return np.asarray(self._creep(numbers).glassy * _contact_compliance(self._table(numbers), depth))

    def reweighed(self, coordinates: Array, rough_outline: CurveOutline | None, noise: Array) -> UnderForce | None:
        """Return the task with weights by the noise of positions and forces, at nearly converged coordinates.

        Parameters
        ----------
        coordinates : ndarray, (p,)
        rough_outline : CurveOutline or None
            Rough outline of the approach; its noise is that of the force out of contact [N].
        noise : ndarray
            Standard deviation of the positions [m], ``()`` or ``(n,)``; zero: estimated from the residuals.
        """
        if rough_outline is None:
            return None
        force_noise, early = rough_outline.noise, self.by_force
        if not early.any():
            return self
        numbers = self.numbers(coordinates)
        prediction = self.prediction(coordinates)
        # weights must not follow the noise, which would bias the fit
        depth = _smooth(np.maximum(prediction.contact.depth, 0.0))
        compliance = self.curve.compliance + self.contact_compliance(numbers, depth)
        position_noise = np.asarray(noise, dtype=float)
        if not position_noise.any():
            counted = ~early & (self.weights > 0.0)
            whole = np.mean((self.curve.position - prediction.fitted)[counted] ** 2)
            of_forces = np.mean((force_noise * compliance[counted]) ** 2)
            position_noise = np.sqrt(np.maximum(whole - of_forces, LEAST_POSITION_SHARE**2 * whole))
            position_noise = np.maximum(position_noise, LEAST_NOISE * np.ptp(self.curve.position))
        position_noise = np.broadcast_to(position_noise, early.shape)
        typical = float(np.mean(position_noise))
        with np.errstate(divide="ignore"):
            stiffness = 1.0 / compliance
        late = typical / np.hypot(position_noise, force_noise * np.where(early, 0.0, compliance))
        per_force = typical / np.hypot(force_noise, position_noise * np.where(early, stiffness, 0.0))
        return self._replace(
            weights=np.where(self.weights > 0.0, np.where(early, 1.0, late), 0.0),
            per_force=np.where(early, per_force, 0.0),
        )

    def final(self, coordinates: Array) -> Array:
        """Return unbiased coordinates, with terms sorted by their times."""
        return super().final(self._unbiased(coordinates))

    @functools.cached_property
    def _steady(self) -> UnderForce:
        """The task of the smoothed curve."""
        curve = self.curve
        smooth = dataclasses.replace(curve, position=_smooth(curve.position), force=_smooth(curve.force))
        return self._replace(curve=smooth)

    def _unbiased(self, coordinates: Array) -> Array:
        """Return coordinates without the bias by the noise of the input, from those of least squares.

        The noise of a force is in the position that it predicts and in its derivatives alike; their product does not
        vanish in the mean, and least squares are biased.  With the derivatives J' along the smoothed curve
        instead, :math:`J'^T r = 0` holds in the mean at the truth (an instrumental variable).
        """
        low = np.array([parameter.inward(parameter.low) for parameter in self.parameters])
        high = np.array([parameter.inward(parameter.high) for parameter in self.parameters])
        for _ in range(BIAS_STEPS):
            instrument = self._steady.slopes(coordinates)
            inner = instrument.T @ self.slopes(coordinates)
            right_side = instrument.T @ ((self.measured - self.predicted(coordinates).fitted) * self.weights)
            size = np.sqrt(np.maximum(np.abs(np.diag(inner)), np.finfo(float).tiny))
            step = np.linalg.lstsq(inner / np.outer(size, size), right_side / size, rcond=None)[0] / size
            coordinates = np.clip(coordinates + step, low, high)
        return coordinates

    def model_of(self, numbers: dict[str, float], prediction: Prediction) -> ViscoelasticIndentation:
        """Return the model with its numbers, under the forces of the contact."""
        path = Path(self.curve.time, Force(np.maximum(prediction.contact.force, 0.0)))
        model: ViscoelasticIndentation = self.with_numbers(numbers)
        return dataclasses.replace(model, path=path)

    def outcome(self, numbers: dict[str, float], prediction: Prediction, shared: dict[str, Any]) -> CreepFit:
        """Return the fit."""
        return CreepFit(**shared, **self.relaxing_fields(numbers, prediction))

    def _table(self, numbers: dict[str, float]) -> ElasticTable:
        travel = float(np.ptp(self.curve.position)) + float(np.max(np.abs(self.curve.depth(0.0))) * 1e-12)
        farthest = float(np.max(self.place(numbers), where=self.by_force, initial=0.0))
        return elastic_table(elastic_like(self.with_numbers(numbers).bed), max(2.0 * travel, farthest))

    def _creep(self, numbers: dict[str, float]) -> CreepSeries:
        medium = self.with_numbers(numbers).bed.medium
        assert offers(medium, RelaxingMedium)
        return medium.creep


def _smooth(numbers: Array) -> Array:
    wide = 1 + 2 * (numbers.size // SMOOTHING_DIVISOR)
    padded = np.pad(numbers, wide // 2, mode="edge")
    return np.convolve(padded, np.full(wide, 1.0 / wide), mode="valid")


def _contact_compliance(table: ElasticTable, depth: Array) -> Array:
    """Return the compliance of a contact at E* = 1 Pa [m/N]; infinite out of contact."""
    root = np.sqrt(np.maximum(depth, 0.0) / table.deepest)
    slope = np.interp(root, np.linspace(0.0, 1.0, table.slope.size), table.slope)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(root > 0.0, 2.0 * root * table.deepest / slope, np.inf)
