r"""Measured loops of friction: coefficient of friction, stiffness of the contact, loss and slip.

The first loading of the contact has the shear force :math:`f(s)`; this is the backbone curve.  With a compliance
:math:`C` in series, the drive is at :math:`x = s + C f(s)`.  Behind a turning point all differences double (Masing),

.. math:: F = F_t \mp 2 f(s), \quad \tfrac12|x - x_t| = s + C f(s), \quad f(s) = \mu\,g(s/\mu) ,

where :math:`g` is that of a coefficient of one.  The coefficient, :math:`C`, and the middle of the force are fitted to
each cycle; what all cycles behind running-in say together has the error of their scatter.
"""

from __future__ import annotations

import functools
import math
from typing import Any, ClassVar, NamedTuple

import numpy as np

from winkler.fitting.logs.estimated import Estimate, inflation, mean_of
from winkler.fitting.logs.friction_log import FrictionLog, noise_of
from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Shift
from winkler.loading.path import OneNormal
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import SHEARED
from winkler.problems.friction.damping import FrictionDamping
from winkler.values.checks.number_checks import NonNegative
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.readable import with_unit
from winkler.values.validity import Assumption, Note, Standing, standing_of
from winkler.values.value import value, words

CURVE_POINTS = 160
"""Points of the contact's curve up to sliding, between which it is interpolated."""
MOST_FITTED = 200
"""Cycles that are fitted; of more, as many of the second half, evenly spread."""
FEWEST_SCATTERED = 6
"""Cycles from which on their scatter, and not the residuals of each, tells the error of their mean."""
SMALL_MISFIT, LARGE_MISFIT = 0.02, 0.1
"""Residuals over the amplitude of the force."""
MOST_LEVER = 0.9
"""Most of a residual that its own point is taken to have fitted away."""
NEAR_NORMAL = 0.05
TURN_BLUR = 3.0
"""How far turning points may lie from the outermost points of noise, over that noise."""
SOURCE = (
    "least squares of each cycle; scatter between cycles with the correlation of neighbours, Student's distribution"
)


class Loop(NamedTuple):
    """A fitted cycle: coefficient, compliance in series [m/N], and loss [J], their errors, misfit, freedom,
    stroke [m], middle of the force [N].
    """

    numbers: Array
    errors: Array
    misfit: float
    freedom: float
    stroke: float
    middle: float


@value
class FrictionLoops:
    """Measured friction loops and the contact that is assumed to have produced them.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium) or another bed.
    normal : Depth or Force
        The steady normal load, one number.
    log : FrictionLog
        Displacement and shear force.
    frame_compliance : float, optional
        Compliance of the machine between contact and displacement sensor [m/N], not negative. Zero (default) if the
        displacement was measured at the contact.

    Raises
    ------
    InvalidInput
        If an argument has the wrong type, or the log holds no whole cycle.

    References
    ----------
    R. D. Mindlin, H. Deresiewicz, J. Appl. Mech. 20 (1953) 327-344, doi:10.1115/1.4010702

    Examples
    --------
    >>> import numpy as np
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.flat import FlatPunch
    >>> bed = Foundation(FlatPunch(1e-3), HalfSpace(Elastic(young=210e9, poisson=0.3)))
    >>> drive = 5e-6 * np.sin(np.linspace(-0.5 * np.pi, 6.5 * np.pi, 1401))
    >>> force = np.zeros(1401)
    >>> for at in range(1, 1401):  # a spring of 50 N/um that slides at 30 N
    ...     force[at] = np.clip(force[at - 1] + 50e6 * (drive[at] - drive[at - 1]), -30.0, 30.0)
    >>> found = FrictionLoops(bed, Force(100.0), FrictionLog(drive, force)).solve()
    >>> round(found.coefficient, 3), round(found.contact_stiffness / 1e6, 1)
    (0.3, 50.0)
    """

    __words__ = words(
        log=("", None, "measured displacement and shear force"),
        frame_compliance=("C_f", "m/N", "compliance of the machine between contact and sensor of the displacement"),
    )

    bed: Bed
    normal: OneNormal
    log: FrictionLog
    frame_compliance: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = ("mindlin_deresiewicz_1953", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED | {Assumption.INERTIA, Assumption.CURVE}
    needs_round: ClassVar[str] = ""

    @property
    def curve(self) -> BackboneCurve:
        """The shear force of the contact under its first loading, with a coefficient of friction of one."""
        return _backbone(self.bed, self.normal)

    def solve(self) -> FrictionLoopsSolution:
        """Return friction, stiffness, dissipated energy and slip from the loops.

        Returns
        -------
        FrictionLoopsSolution

        Raises
        ------
        OutsideValidity
            If the bodies do not touch, or the machine alone is more compliant than the measurement.
        NotConverged
            If no cycle can be fitted.
        """
        log, curve = self.log, self.curve
        late = np.arange(len(log.cycles) // 2, len(log.cycles))
        if late.size > MOST_FITTED:
            late = late[np.linspace(0, late.size - 1, MOST_FITTED).round().astype(int)]
        found = [loop for place in late.tolist() if (loop := curve.fitted(log, place)) is not None]
        if not found:
            raise NotConverged(
                "FrictionLoops: no cycle is described by a contact that sticks and slides; look at the loops with "
                "winkler show, and check normal load and units."
            )
        pressed = log.normal_of_cycles
        scale = curve.force / float(np.mean(pressed[late])) if pressed.size else 1.0
        coefficient, series, loss = (_together(found, place) for place in range(3))
        compliance = 1.0 / curve.stiffness + series.value - self.frame_compliance
        if not compliance > 0.0:
            whole, frame = compliance + self.frame_compliance, self.frame_compliance
            raise OutsideValidity(
                f"FrictionLoops: the branches have a compliance of {with_unit(whole, 'm/N', 3)}, less than the machine "
                f"alone, {with_unit(frame, 'm/N', 3)}; give a smaller frame_compliance."
            )
        strokes = [curve.sliding(loop.numbers, loop.stroke) for loop in found]
        return FrictionLoopsSolution(
            problem=self,
            coefficient=scale * coefficient.value,
            coefficient_error=scale * coefficient.error,
            contact_stiffness=1.0 / compliance,
            contact_stiffness_error=series.error / compliance**2,
            expected_stiffness=curve.stiffness,
            series_compliance=series.value,
            series_compliance_error=series.error,
            loss_per_cycle=loss.value,
            loss_error=loss.error,
            contact_stroke=float(np.mean(strokes)),
            misfit=float(np.mean([loop.misfit for loop in found])),
            freedom=coefficient.freedom,
            fitted=float(len(found)),
        )


class BackboneCurve:
    """The shear force under first loading, with a coefficient of friction of one, and fits of cycles by it."""

    def __init__(self, bed: Bed, normal: Any) -> None:
        """Follow the contact up to sliding."""
        stuck = FrictionDamping(bed, Coulomb(1.0), normal, Shift(0.0)).solve()
        self.force, self.stiffness = float(stuck.contact.force), float(stuck.secant_stiffness)
        reach = self.force / self.stiffness
        while (
            float(FrictionDamping(bed, Coulomb(1.0), normal, Shift(reach)).solve().shear_force)
            < (1.0 - 1e-9) * self.force
        ):
            reach *= 1.3
        self.shift = np.append(reach * np.linspace(0.0, 1.0, CURVE_POINTS), 1e6 * reach)
        swing = FrictionDamping(bed, Coulomb(1.0), normal, Shift(self.shift)).solve()
        self.shear = np.asarray(swing.shear_force)

    def branch(self, numbers: Array, half: Array) -> Array:
        """Return the shear force [N] at half of the distance of the drive from a turning point."""
        coefficient, series = float(numbers[0]), float(numbers[1])
        reduced: Array = np.interp(half / coefficient, self.shift + series * self.shear, self.shear)
        return coefficient * reduced

    def sliding(self, numbers: Array, stroke: float) -> float:
        """Return the peak-to-peak displacement of the contact [m]: of the drive, less the compliance in series."""
        end = float(self.branch(numbers, np.array([0.5 * stroke]))[0])
        return float(stroke - 2.0 * numbers[1] * end)

    def fitted(self, log: FrictionLog, place: int) -> Loop | None:
        """Return the fit of one cycle; None where there is none."""
        from scipy.optimize import least_squares

        low, high, end = log.cycles[place]
        there, back = slice(low, high + 1), slice(high, end + 1)
        x, f = log.displacement, log.force
        most, amplitude = 0.5 * float(x[high] - x[low]), 0.5 * float(np.ptp(f[low : end + 1]))
        if not (amplitude > 0.0 and most > 0.0):
            return None
        slope = log.slope_of(log.cycles[place])
        start = max(1.0 / slope - 1.0 / self.stiffness, 0.0) if slope > 0.0 else 0.0
        unit = np.array([amplitude / self.force, 1.0 / self.stiffness + start, amplitude])
        middle = 0.5 * float(np.max(f[low : end + 1]) + np.min(f[low : end + 1]))
        blurred, noise = noise_of(x[low : end + 1]), noise_of(f[low : end + 1]) / amplitude

        def left(scaled: Array) -> Array:
            numbers, moved = scaled[:3] * unit, TURN_BLUR * blurred * scaled[3:]
            least, greatest = x[low] + moved[0], x[high] + moved[1]
            top = float(self.branch(numbers, np.array([max(0.5 * (greatest - least), 0.0)]))[0])
            up = self.branch(numbers, np.clip(0.5 * (x[there] - least), 0.0, None))
            down = self.branch(numbers, np.clip(0.5 * (greatest - x[back]), 0.0, None))
            parts = [numbers[2] + (2.0 * up - top) - f[there], numbers[2] - (2.0 * down - top) - f[back]]
            return np.concatenate([*(part / amplitude for part in parts), noise * scaled[3:]])

        bounds = (
            np.array([1e-3, -0.9 / self.stiffness / unit[1], -10.0, -10.0, -10.0]),
            np.array([1e3, 1e3, *3 * [10.0]]),
        )
        begun = np.array([1.0, start / unit[1], middle / amplitude, 0.0, 0.0])
        found = least_squares(left, np.maximum(begun, bounds[0] + 1e-6), bounds=bounds, xtol=1e-12)
        rest, count = found.fun[:-2], found.fun.size - 2
        slopes = found.jac if noise > 0.0 and blurred > 0.0 else found.jac[:, :3]
        square = slopes.T @ slopes
        if not found.success or not np.linalg.cond(square) < 1e12:
            return None
        wide, inverse = inflation(rest, 3), np.linalg.inv(square)
        lever = np.sum((slopes[:-2] @ inverse) * slopes[:-2], axis=1)
        left_out = np.append(rest / (1.0 - np.minimum(lever, MOST_LEVER)), [noise, noise])  # larger on steep parts
        variance = inverse @ ((slopes.T * left_out**2) @ slopes) @ inverse * wide
        error = np.sqrt(np.diag(variance)[:3]) * unit
        spread = amplitude**2 * float(rest @ rest) / (count - 3) * wide
        steps = [float(np.sum(np.gradient(part[low : end + 1]) ** 2)) for part in (x, f)]
        lost = math.sqrt(spread * steps[0] + blurred**2 * steps[1])
        numbers = found.x[:3] * unit
        return Loop(
            np.array([numbers[0], numbers[1], log.loss_per_cycle[place]]),
            np.array([error[0], error[1], lost]),
            math.sqrt(float(rest @ rest) / count),
            max((count - 3) / wide, 1.0),
            2.0 * most,
            float(numbers[2]),
        )


@functools.lru_cache(maxsize=16)
def _backbone(bed: Bed, normal: Any) -> BackboneCurve:
    return BackboneCurve(bed, normal)


def _together(loops: list[Loop], place: int) -> Estimate:
    """Return the mean of a number over cycles, with the error of their scatter, or of few cycles of their residuals."""
    numbers = np.array([loop.numbers[place] for loop in loops])
    if numbers.size >= FEWEST_SCATTERED:
        return mean_of(numbers)
    errors = np.array([loop.errors[place] for loop in loops])
    own = math.sqrt(float(np.sum(errors**2))) / errors.size
    apart = float(np.std(numbers, ddof=1)) / math.sqrt(errors.size) if errors.size > 1 else 0.0
    return Estimate(float(np.mean(numbers)), max(own, apart), sum(loop.freedom for loop in loops))


@value
class FrictionLoopsSolution:
    """The solution of a `FrictionLoops`; all numbers are those of the second half of the cycles.

    Parameters
    ----------
    problem : FrictionLoops
        The problem that was solved.
    coefficient, coefficient_error : float
        mu [-] and its standard error.
    contact_stiffness, contact_stiffness_error : float
        Of the contact along the surface without slip [N/m]: of the branches, less the compliance of the frame.
    expected_stiffness : float
        The same stiffness, computed for the foundation [N/m].
    series_compliance, series_compliance_error : float
        Additional compliance in series with the foundation [m/N]: the frame, and any other cause of a contact softer
        than computed.
    loss_per_cycle, loss_error : float
        Area of the loop [J].
    contact_stroke : float
        Peak-to-peak displacement of one body along the other [m], including the elastic displacement of the contact.
    misfit : float
        Residuals over the amplitude of the force [-], root of the mean square.
    freedom : float
        Number of independent rows from which the errors are computed.
    fitted : float
        Number of fitted cycles.
    """

    __words__ = words(
        coefficient=(r"\mu", "", "coefficient of friction"),
        coefficient_error=("", "", "standard error of the coefficient of friction"),
        contact_stiffness=("k_x", "N/m", "stiffness of the contact along the surface, as measured"),
        contact_stiffness_error=("", "N/m", "standard error of that stiffness"),
        expected_stiffness=("k_x", "N/m", "stiffness of the bed along the surface"),
        series_compliance=("C", "m/N", "compliance in series with the bed"),
        series_compliance_error=("", "m/N", "standard error of that compliance"),
        loss_per_cycle=("W", "J", "mean area of the loops"),
        loss_error=("", "J", "standard error of the loss"),
        contact_stroke=("", "m", "peak-to-peak displacement of one body along the other"),
        misfit=("", "", "residuals over the amplitude of the force"),
        freedom=("", "", "independent rows behind the errors"),
        fitted=("", "", "number of fitted cycles"),
    )

    problem: FrictionLoops
    coefficient: float
    coefficient_error: float
    contact_stiffness: float
    contact_stiffness_error: float
    expected_stiffness: float
    series_compliance: float
    series_compliance_error: float
    loss_per_cycle: float
    loss_error: float
    contact_stroke: float
    misfit: float
    freedom: float
    fitted: float

    @property
    def interval(self) -> tuple[float, float]:
        """The coefficient's interval of 95 % [-]."""
        return Estimate(self.coefficient, self.coefficient_error, self.freedom).interval

    @functools.cached_property
    def loop(self) -> tuple[Array, Array]:
        """Displacement [m] and shear force [N] of the last fitted cycle, from its minimum displacement, ``(k,)``."""
        log, curve = self.problem.log, self.problem.curve
        low, high, _ = log.cycles[-1]
        found = curve.fitted(log, len(log.cycles) - 1)
        if found is None:
            return np.zeros(0), np.zeros(0)
        part = np.linspace(0.0, 1.0, 101)
        stroke = float(log.displacement[high] - log.displacement[low])
        top = float(curve.branch(found.numbers, np.array([0.5 * stroke]))[0])
        up = 2.0 * curve.branch(found.numbers, 0.5 * stroke * part) - top
        middle = found.middle
        there = log.displacement[low] + stroke * part
        return np.concatenate([there, there[::-1]]), middle + np.concatenate([up, -up])

    @property
    def validity(self) -> tuple[Note, ...]:
        """Assumptions and doubts about the results; then the notes of the contact itself."""
        problem = self.problem
        law, swing = Coulomb(self.coefficient), Shift(0.5 * max(self.contact_stroke, 0.0))
        return (*self._notes(), *FrictionDamping(problem.bed, law, problem.normal, swing).solve().validity)

    def _notes(self) -> list[Note]:
        low, high = self.interval
        log, load = self.problem.log, self.problem.curve.force
        notes = [
            Note(
                Assumption.CURVE,
                standing_of(self.misfit, SMALL_MISFIT, LARGE_MISFIT),
                f"The residuals of {self.fitted:.0f} of {len(log.cycles)} cycles are {100 * self.misfit:.2g} % of "
                f"the force amplitude. The coefficient of friction lies between {low:.4g} and {high:.4g} (95 %), "
                "if it is the same at all places and speeds.",
                SOURCE,
            )
        ]
        pressed = log.normal_of_cycles
        part = log.late(log.shear_amplitude).value / (
            self.coefficient * (float(np.mean(pressed)) if pressed.size else load)
        )
        if low <= 0.0 or high > 2.0 * self.coefficient:
            notes.append(
                Note(
                    Assumption.SLIP,
                    Standing.OUTSIDE,
                    f"The loops are nearly closed: the shear force reaches {100 * part:.3g} % of the sliding "
                    "force. The coefficient is not determined; use a larger amplitude.",
                    SOURCE,
                )
            )
        more = 1.0 / self.expected_stiffness
        rest = self.series_compliance - self.problem.frame_compliance
        if abs(rest) > 2.0 * self.series_compliance_error + 0.1 * more:
            softer = "softer" if rest > 0.0 else "stiffer"
            frame = f"A frame compliance of {with_unit(max(self.series_compliance, 0.0), 'm/N', 3)}"
            why = f"{frame} would explain this" if self.series_compliance > 0.0 else "No frame compliance explains this"
            if rest > 0.0:
                why += ", or rough bodies"
            notes.append(
                Note(
                    Assumption.RESPONSE,
                    Standing.APPROXIMATE,
                    f"The contact appears {softer} than the foundation: {with_unit(self.contact_stiffness, 'N/m', 3)} "
                    f"instead of {with_unit(self.expected_stiffness, 'N/m', 3)}. {why}.",
                    SOURCE,
                )
            )
        if pressed.size and abs(float(np.mean(pressed)) / load - 1.0) > NEAR_NORMAL:
            notes.append(
                Note(
                    Assumption.CURVE,
                    Standing.APPROXIMATE,
                    f"The normal force is {with_unit(float(np.mean(pressed)), 'N', 3)} in the log and "
                    f"{with_unit(load, 'N', 3)} in the study. The coefficient is that of the log, the stiffness "
                    "that of the study.",
                    SOURCE,
                )
            )
        return notes
