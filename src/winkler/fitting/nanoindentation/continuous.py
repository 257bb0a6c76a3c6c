"""Modulus and hardness over depth from continuously measured stiffness."""

from __future__ import annotations

import math
from typing import Any, ClassVar, NamedTuple

import numpy as np

from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.nanoindentation.notes import calibration_note
from winkler.fitting.nanoindentation.readings import Peaks, factors_of, moved_by, readings_of
from winkler.fitting.unloading.continuous_stiffness import ContinuousStiffness
from winkler.fitting.unloading.unloading_notes import PILE_UP
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import NonNegative, PoissonRatio
from winkler.values.errors import InvalidInput
from winkler.values.readable import with_unit
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

INTERCEPT = 0.75
UNSEEN = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "Pile-up: a continuous stiffness without unloading does not show how much of the depth remains. For material "
    "that piles up at the edge hardness and modulus are too large.",
    PILE_UP,
)


@value
class ContinuousIndentation:
    """Continuously measured stiffness, the calibrated indenter, and Poisson's ratio of the sample.

    Parameters
    ----------
    data : ContinuousStiffness
    indenter : CalibratedIndenter
        Its frame compliance is subtracted from depth and stiffness, with that of the data.
    poisson : float
        nu of the sample [-].
    shallowest : float, optional
        Minimum evaluated depth [m]. By default (zero) the evaluation begins at the first depth at which it is
        possible.
    depth_offset_error : float, optional
        Standard uncertainty of the point of first touch [m].
    stiffness_error : float, optional
        Relative standard uncertainty of the stiffness scale [-].

    References
    ----------
    X. Li, B. Bhushan, Mater. Charact. 48 (2002) 11-36, doi:10.1016/S1044-5803(02)00192-4
    """

    assumptions: ClassVar[frozenset[Assumption]] = frozenset((Assumption.CURVE, Assumption.SHAPE, Assumption.RESPONSE))

    __words__ = words(
        data=("", None, "continuously measured stiffness"),
        indenter=("", None, "calibrated indenter on its frame"),
        shallowest=("h", "m", "least depth that is evaluated"),
        depth_offset_error=("u(D_0)", "m", "standard uncertainty of the point of first touch"),
        stiffness_error=("u(S)/S", "", "relative standard uncertainty of the stiffness scale"),
    )

    data: ContinuousStiffness
    indenter: CalibratedIndenter
    poisson: PoissonRatio
    shallowest: NonNegative = 0.0
    depth_offset_error: NonNegative = 0.0
    stiffness_error: NonNegative = 0.0

    def solve(self) -> ContinuousIndentationSolution:
        """Return modulus and hardness at every depth at which they can be evaluated.

        Raises
        ------
        InvalidInput
            If no depth is left.
        """
        data, frame = self.data, self.indenter.numbers[0]
        extra = 1.0 / data.machine_stiffness if math.isfinite(data.machine_stiffness) else 0.0
        with np.errstate(divide="ignore", invalid="ignore"):
            compliance = 1.0 / data.stiffness - extra
            depth = data.depth - extra * data.force
            contact = depth - frame * data.force - INTERCEPT * data.force * (compliance - frame)
            area = sum(
                c * np.maximum(contact, 0.0) ** (2.0 ** (1 - n)) for n, c in enumerate(self.indenter.numbers[1:])
            )
            modulus = 0.5 * np.sqrt(np.pi / area) / (self.indenter.shape_factor * (compliance - frame))
        stiffest = self.indenter.solid.young / (1.0 - self.indenter.solid.poisson**2)
        good = (data.stiffness > 0.0) & (compliance > frame) & (contact > 0.0) & (area > 0.0) & (data.force > 0.0)
        chosen = np.flatnonzero(good & (depth >= self.shallowest) & (modulus < stiffest))
        if not chosen.size:
            raise InvalidInput(
                f"ContinuousIndentation: '{data.name}' has no depth at which force, stiffness and contact depth are "
                "positive; check signs, frame compliance and shallowest."
            )
        peaks = Peaks(data.force[chosen], depth[chosen], compliance[chosen], np.full(chosen.size, INTERCEPT))
        base = readings_of(peaks, self.indenter.numbers, self.indenter, self.poisson)
        moved = [
            moved_by(peaks, self.indenter, self.poisson, depth=self.depth_offset_error),
            moved_by(peaks, self.indenter, self.poisson, compliance=self.stiffness_error * peaks.compliance),
            *self._calibration(peaks),
        ]
        young = np.sqrt(sum(np.square(one.young) for one in moved))
        hardness = np.sqrt(sum(np.square(one.hardness) for one in moved))
        return ContinuousIndentationSolution(
            problem=self, points=chosen, depth=depth[chosen] - frame * peaks.force, force=peaks.force,
            contact_depth=base.contact_depth, modulus=base.modulus, young=base.young, hardness=base.hardness,
            young_errors=young, hardness_errors=hardness,
        )  # fmt: skip

    def _calibration(self, peaks: Peaks) -> list[Any]:
        if not self.indenter.calibrated:
            return []
        return [
            moved_by(peaks, self.indenter, self.poisson, numbers=column)
            for column in factors_of(self.indenter.covariance).T
        ]


@value
class ContinuousIndentationSolution:
    """Modulus and hardness over depth.

    Parameters
    ----------
    problem : ContinuousIndentation
        The problem that was solved.
    points : ndarray, (n,)
        Indices of the evaluated points of the data.
    depth, force, contact_depth, modulus, young, hardness : ndarray, (n,)
        Depth [m], force [N], contact depth [m], reduced modulus, modulus of the sample and hardness [Pa].
    young_errors, hardness_errors : ndarray, (n,)
        Standard uncertainties due to calibration, zero point and stiffness scale, common to all depths [Pa]. They do
        not include noise, which is visible as the scatter of neighbouring points.
    """

    __words__ = words(
        points=("", None, "indices of the evaluated points"),
        modulus=("E_r", "Pa", "reduced modulus, that of the pair"),
        young_errors=("u(E)", "Pa", "standard uncertainty of Young's modulus"),
        hardness_errors=("u(H)", "Pa", "standard uncertainty of the hardness"),
    )

    problem: ContinuousIndentation
    points: Array
    depth: Array
    force: Array
    contact_depth: Array
    modulus: Array
    young: Array
    hardness: Array
    young_errors: Array
    hardness_errors: Array

    @property
    def validity(self) -> tuple[Note, ...]:
        """Whether the contact depths are within the calibration, and which errors are not included."""
        return (calibration_note(self.problem.indenter, self.contact_depth), UNSEEN)

    def mean(self, low: float, high: float) -> WindowMean:
        """Return the means of E and H [Pa] over a range of depths [m].

        Raises
        ------
        InvalidInput
            If fewer than two points lie between the depths.
        """
        inside = (self.depth >= low) & (self.depth <= high)
        count = int(np.count_nonzero(inside))
        if count < 2:
            ends = (low, high, float(self.depth.min()), float(self.depth.max()))
            asked, deepest = (" to ".join(with_unit(end, "m", 3) for end in part) for part in (ends[:2], ends[2:]))
            raise InvalidInput(f"mean: {count} points lie at {asked}; the data are from {deepest}.")
        numbers = [(float(np.mean(x[inside])), float(np.std(x[inside], ddof=1))) for x in (self.young, self.hardness)]
        errors = [float(np.mean(x[inside])) for x in (self.young_errors, self.hardness_errors)]
        return WindowMean(count, *numbers[0], errors[0], *numbers[1], errors[1])


class WindowMean(NamedTuple):
    """Means of E and H over a range of depths of one curve.

    Parameters
    ----------
    points : int
        Number of points.
    young, young_scatter, young_error : float
        Mean, standard deviation of the points, and standard uncertainty by what all depths share [Pa].
    hardness, hardness_scatter, hardness_error : float
        The same of the hardness [Pa].
    """

    points: int
    young: float
    young_scatter: float
    young_error: float
    hardness: float
    hardness_scatter: float
    hardness_error: float
