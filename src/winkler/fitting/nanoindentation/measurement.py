r"""Modulus and hardness of one indentation over depth, from all its unloadings, with a GUM budget of uncertainty.

The thermal drift is measured in a hold under a small force and subtracted, the point of first touch is found, all
unloadings are fitted, and Oliver and Pharr's equations give a reading for each.  The uncertainty of each reading has
the
sources

noise
    White and slow noise of the unloading and of the depth at its peak.
zero point
    Standard error of the point of first touch.
drift
    Standard error of the rate, times the time since first touch, and in the slope of the unloading.
calibration
    Covariance of frame compliance and area coefficients.
epsilon
    Half the distance between the factor of the fitted exponent and 3/4, uniformly distributed: conventions differ.
constants
    Poisson's ratio of the sample, and relative errors of the force and depth scales.

Noise, zero point and drift differ from one indentation to the next; the other sources are common to all.
"""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Iterator, Sequence
from typing import Any, ClassVar, NamedTuple

import numpy as np

from winkler.fitting.curves.corrections import on_frame, without_drift
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.events.kinds import EventKind
from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.nanoindentation.notes import nanoindentation_notes
from winkler.fitting.nanoindentation.readings import Peaks, Readings, area_of, factors_of, moved_by, readings_of
from winkler.fitting.nanoindentation.thermal_drift import ThermalDrift, found_drift
from winkler.fitting.nanoindentation.touch import white_noise
from winkler.fitting.nanoindentation.unloadings import FittedUnloadings, fitted_unloadings
from winkler.fitting.nanoindentation.zero_point import ZeroPoint, found_zero_point
from winkler.fitting.unloading.contact_reading import intercept_factor
from winkler.fitting.unloading.unloading_law import EXPONENT_BOUNDS, LEAST_FINAL_DEPTH
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import Fraction, NonNegative, PoissonRatio
from winkler.values.errors import InvalidInput
from winkler.values.readable import with_unit
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

INTERCEPT = 0.75
SECANT = (0.75, 0.95)
"""Parts of the peak between which an unloading is taken as straight: its compliance is needed to a few per cent."""
MOST_DOUBT = 3.0
"""Greatest contribution of the difference of the two laws, in standard errors of the better one."""


def touched(curve: ForceCurve, area: Sequence[float] | Array) -> ZeroPoint:
    """Return the touch by a power of the depth or, where it is known, by the area function of the tip.

    The two laws fail differently, the power where the exponent changes, the area function where the hardness
    does: their difference is taken as the half-width of a uniform distribution, and added to the error.
    """
    plain = found_zero_point(curve)
    rim = _rim(curve, plain, np.asarray(area, dtype=float)) if len(area) else 0.0
    if not rim > 0.0:
        return plain
    known = found_zero_point(curve, area, rim)
    doubt = min(abs(known.position - plain.position), MOST_DOUBT * known.error) / math.sqrt(3.0)
    return dataclasses.replace(known, error=math.hypot(known.error, doubt))


def _rim(curve: ForceCurve, touch: ZeroPoint, area: Array) -> float:
    """Return epsilon F/(S sqrt(A)) at the peak of the deepest unloading; zero if it cannot be read."""
    unloadings = [
        part for part in curve.segments if part.kind in (SegmentKind.PARTIAL_UNLOADING, SegmentKind.LAST_UNLOADING)
    ]
    if not unloadings:
        return 0.0
    part = max(unloadings, key=lambda one: float(curve.force[one.first : one.last + 1].max()))
    depth, force = (x[part.first : part.last + 1] for x in (curve.depth(touch.position), curve.force - touch.baseline))
    peak = float(force.max())
    chosen = (force > SECANT[0] * peak) & (force < SECANT[1] * peak)
    if np.count_nonzero(chosen) < 3:
        return 0.0
    elastic = INTERCEPT * peak * float(np.polyfit(force[chosen], depth[chosen], 1)[0])
    size = float(area_of(area, np.asarray(float(depth.max()) - elastic)))
    return elastic / math.sqrt(size) if size > 0.0 else 0.0


USUAL_INTERCEPT = 0.75
COMMON_SOURCES = ("calibration", "epsilon", "constants")
"""Sources that are the same in all indentations with one indenter."""


@value
class Nanoindentation:
    """An indentation curve, the calibrated indenter, and Poisson's ratio of the sample.

    Parameters
    ----------
    curve : ForceCurve
        The measured curve.  All unloadings of its `segments` are evaluated.
    indenter : CalibratedIndenter
        Its frame compliance is added to that of the curve.
    poisson : float
        nu of the sample [-].
    poisson_error : float, optional
        Its standard uncertainty [-]; zero by default.
    zero_point : ZeroPoint, optional
        Point of first touch; found by `found_zero_point` by default.
    drift : ThermalDrift, optional
        Thermal drift; found by `found_drift` by default.
    upper, lower : float, optional
        Fractions of the peak force between which an unloading is fitted.
    force_error, depth_error : float, optional
        Relative standard uncertainties of the scales of force and depth [-], as the machine's certificate states them.

    References
    ----------
    W. C. Oliver, G. M. Pharr, J. Mater. Res. 19 (2004) 3-20, doi:10.1557/jmr.2004.19.1.3
    """

    assumptions: ClassVar[frozenset[Assumption]] = frozenset((Assumption.CURVE, Assumption.SHAPE, Assumption.RESPONSE))

    __words__ = words(
        indenter=("", None, "calibrated indenter on its frame"),
        poisson_error=(r"u(\nu)", "", "standard uncertainty of Poisson's ratio"),
        zero_point=("D_0", None, "point of first touch"),
        drift=(r"\dot h_T", None, "thermal drift"),
        upper=("", "", "part of the force at the peak where the fitted part begins"),
        lower=("", "", "part of the force at the peak where the fitted part ends"),
        force_error=("u(F)/F", "", "relative standard uncertainty of the force scale"),
        depth_error=("u(h)/h", "", "relative standard uncertainty of the depth scale"),
    )

    curve: ForceCurve
    indenter: CalibratedIndenter
    poisson: PoissonRatio
    poisson_error: NonNegative = 0.0
    zero_point: ZeroPoint | tuple[()] = ()
    drift: ThermalDrift | tuple[()] = ()
    upper: Fraction = 0.98
    lower: Fraction = 0.4
    force_error: NonNegative = 0.0
    depth_error: NonNegative = 0.0

    def __post_init__(self) -> None:
        if not 0.0 <= self.lower < self.upper <= 1.0:
            raise InvalidInput(
                f"Nanoindentation: the limits of the fitted part are {self.upper!r} and {self.lower!r}; "
                "give 1 >= upper > lower >= 0, parts of the force at the peak."
            )

    def solve(self) -> NanoindentationSolution:
        """Return the results of all unloadings with their uncertainty budgets.

        Raises
        ------
        InvalidInput
            If no unloading can be evaluated, or no contact is found.
        OutsideValidity
            If a contact depth or an area is not positive.
        """
        ready = prepared(
            self.curve,
            self.indenter.frame_compliance,
            zero_point=self.zero_point,
            drift=self.drift,
            area=self.indenter.area.coefficients,
            upper=self.upper,
            lower=self.lower,
        )
        base = readings_of(ready.peaks, self.indenter.numbers, self.indenter, self.poisson)
        shares = {name: _root(changes) for name, changes in contributions(self, ready).items()}
        fits = ready.unloadings
        return NanoindentationSolution(
            problem=self,
            zero_point=ready.zero_point,
            drift=ready.drift,
            force=ready.peaks.force,
            depth=ready.peaks.depth - self.indenter.frame_compliance * ready.peaks.force,
            stiffness=1.0 / (ready.peaks.compliance - self.indenter.frame_compliance),
            exponent=fits.exponent,
            final_depth=fits.final_depth,
            contact_depth=base.contact_depth,
            area=base.area,
            modulus=base.modulus,
            young=base.young,
            hardness=base.hardness,
            sources=tuple(shares),
            young_shares=np.stack([share.young for share in shares.values()]),
            hardness_shares=np.stack([share.hardness for share in shares.values()]),
            depth_shares=np.stack([share.contact_depth for share in shares.values()]),
            skipped=fits.skipped,
        )


class Prepared(NamedTuple):
    """A curve after drift and zero point, its unloadings, and their peaks with the frame put back."""

    curve: ForceCurve
    zero_point: ZeroPoint
    drift: ThermalDrift
    unloadings: FittedUnloadings
    peaks: Peaks
    touched: float


def prepared(
    curve: ForceCurve,
    frame_compliance: float,
    *,
    zero_point: ZeroPoint | tuple[()] = (),
    drift: ThermalDrift | tuple[()] = (),
    area: Sequence[float] | Array = (),
    upper: float = 0.98,
    lower: float = 0.4,
) -> Prepared:
    """Return a curve corrected for drift, frame and zero point, with its unloadings.

    The power laws are fitted over the depth without the frame; the peaks contain the frame again, so that it can vary.
    """
    compliance = curve.compliance + frame_compliance
    stiff = dataclasses.replace(curve, machine_stiffness=1.0 / compliance if compliance > 0.0 else math.inf)
    rate = found_drift(stiff, zero_point) if isinstance(drift, tuple) else drift
    steady = without_drift(stiff, rate.rate) if rate.rate else stiff
    touch = touched(steady, area) if isinstance(zero_point, tuple) else zero_point
    placed = dataclasses.replace(steady, position=steady.position - touch.position, force=steady.force - touch.baseline)
    fits = fitted_unloadings(placed, upper=upper, lower=lower)
    peaks = Peaks(
        fits.force,
        fits.depth + frame_compliance * fits.force,
        fits.compliance + frame_compliance,
        np.array([intercept_factor(exponent) for exponent in fits.exponent.tolist()]),
    )
    at = int(np.argmax(placed.position > 0.0))
    return Prepared(placed, touch, rate, fits, peaks, float(placed.time[at]) if placed.timed else 0.0)


def contributions(problem: Nanoindentation, ready: Prepared) -> dict[str, list[Readings]]:
    """Return what one standard uncertainty of each source changes in the readings; its parts add in squares."""
    indenter, peaks, fits = problem.indenter, ready.peaks, ready.unloadings

    def moved(**inputs: Any) -> Readings:
        return moved_by(peaks, indenter, problem.poisson, **inputs)

    slopes = np.array([_intercept_slope(exponent) for exponent in fits.exponent.tolist()])
    noise = [
        moved(depth=root[:, 0], compliance=root[:, 1], intercept=slopes * root[:, 2])
        for root in np.moveaxis(factors_of(fits.covariance), 2, 0)
    ]
    waited = fits.time - ready.touched
    doubt = np.abs(peaks.intercept - USUAL_INTERCEPT) / math.sqrt(3.0)
    budget = {
        "noise": noise,
        "zero point": [moved(depth=-ready.zero_point.error)],
        "drift": [moved(depth=-waited * ready.drift.error, compliance=-fits.pace * ready.drift.error)],
        "calibration": [moved(numbers=column) for column in factors_of(indenter.covariance).T]
        if indenter.calibrated
        else [],
        "epsilon": [moved(intercept=doubt)],
        "constants": [
            _by_poisson(problem, peaks),
            moved(force=problem.force_error * peaks.force, compliance=-problem.force_error * peaks.compliance),
            moved(depth=problem.depth_error * peaks.depth, compliance=problem.depth_error * peaks.compliance),
        ],
    }
    zero = Readings(*(np.zeros(peaks.force.size) for _ in Readings._fields))
    return {name: changes or [zero] for name, changes in budget.items()}


def _by_poisson(problem: Nanoindentation, peaks: Peaks) -> Readings:
    base = readings_of(peaks, problem.indenter.numbers, problem.indenter, problem.poisson)
    nothing = np.zeros(peaks.force.size)
    slope = -2.0 * problem.poisson / (1.0 - problem.poisson**2) * problem.poisson_error
    return Readings(nothing, nothing, nothing, base.young * slope, nothing)


def _root(changes: list[Readings]) -> Readings:
    """Return the roots of the sums of squares."""
    return Readings(*(np.sqrt(sum(np.square(part) for part in parts)) for parts in zip(*changes, strict=True)))


def _intercept_slope(exponent: float) -> float:
    """Return the derivative of epsilon by the exponent."""
    step = 1e-4
    return (intercept_factor(exponent + step) - intercept_factor(max(exponent - step, 1.0))) / (2.0 * step)


@value
class NanoindentationSolution:
    """Modulus and hardness of n unloadings, in the order of measurement, with the standard uncertainty by each source.

    Parameters
    ----------
    problem : Nanoindentation
        The problem that was solved.
    zero_point : ZeroPoint
        Point of first touch.
    drift : ThermalDrift
        Thermal drift.
    force, depth, stiffness, exponent, final_depth : ndarray, (n,)
        At the peaks: force [N], depth [m], contact stiffness [N/m], exponent [-], and final depth [m] of the fitted
        unloading.
    contact_depth, area, modulus, young, hardness : ndarray, (n,)
        h_c [m], A [m^2], reduced modulus [Pa], Young's modulus of the sample [Pa], hardness [Pa].
    sources : tuple of str
        Sources of uncertainty.
    young_shares, hardness_shares, depth_shares : ndarray, (sources, n)
        Standard uncertainties [Pa], [Pa] and [m] (contact depth) by each source; their squares add.
    skipped : tuple of str
        Unloadings that were not evaluated, with the reason.
    """

    __words__ = words(
        zero_point=("D_0", None, "point of first touch"),
        drift=(r"\dot h_T", None, "thermal drift"),
        stiffness=("S", "N/m", "stiffness of the contact at the peak"),
        exponent=("m", "", "exponent of the unloading"),
        modulus=("E_r", "Pa", "reduced modulus, that of the pair"),
        sources=("", None, "sources of uncertainty"),
        young_shares=("u_i(E)", "Pa", "standard uncertainty of Young's modulus by each source"),
        hardness_shares=("u_i(H)", "Pa", "standard uncertainty of the hardness by each source"),
        depth_shares=("u_i(h_c)", "m", "standard uncertainty of the contact depth by each source"),
        skipped=("", None, "unloadings that were not evaluated"),
    )

    problem: Nanoindentation
    zero_point: ZeroPoint
    drift: ThermalDrift
    force: Array
    depth: Array
    stiffness: Array
    exponent: Array
    final_depth: Array
    contact_depth: Array
    area: Array
    modulus: Array
    young: Array
    hardness: Array
    sources: tuple[str, ...]
    young_shares: Array
    hardness_shares: Array
    depth_shares: Array
    skipped: tuple[str, ...] = ()

    @property
    def young_errors(self) -> Array:
        """Combined standard uncertainties of Young's modulus [Pa] ``(n,)``."""
        return np.asarray(np.sqrt(np.sum(np.square(self.young_shares), axis=0)))

    @property
    def hardness_errors(self) -> Array:
        """Combined standard uncertainties of the hardness [Pa] ``(n,)``."""
        return np.asarray(np.sqrt(np.sum(np.square(self.hardness_shares), axis=0)))

    def interval(self, name: str, confidence: float = 0.95) -> tuple[Array, Array]:
        """Return the lower and upper ends of the intervals of all unloadings, of the logarithm: none is below zero.

        Parameters
        ----------
        name : str
            "young" or "hardness".
        confidence : float
            Between 0 and 1.
        """
        from scipy.special import ndtri

        if name not in ("young", "hardness") or not 0.0 < confidence < 1.0:
            raise InvalidInput(
                f"interval: of {name!r} with the confidence {confidence!r}; give 'young' or 'hardness', and a "
                "confidence between 0 and 1."
            )
        width = float(ndtri(0.5 + 0.5 * confidence))
        middle, error = (self.young, self.young_errors) if name == "young" else (self.hardness, self.hardness_errors)
        return middle * np.exp(-width * error / middle), middle * np.exp(width * error / middle)

    @property
    def deepest(self) -> int:
        """Index of the unloading from the maximum force (the last one if several are equal)."""
        top = float(self.force.max())
        return int(np.flatnonzero(self.force >= 0.99 * top)[-1])

    @property
    def validity(self) -> tuple[Note, ...]:
        """Validity of the evaluation: pile-up, exponent, zero point, drift, calibration, omitted unloadings."""
        return nanoindentation_notes(self)

    @functools.cached_property
    def doubts(self) -> tuple[str, ...]:
        """Doubts about the results, such as two first contacts or a fit parameter at its bound; usually empty."""
        return doubts_of(self)

    @property
    def own_young_error(self) -> float:
        """Standard uncertainty of Young's modulus at the maximum force [Pa], without the shared calibration."""
        return self._own(self.young_shares)

    @property
    def own_hardness_error(self) -> float:
        """Standard uncertainty of the hardness at the maximum force [Pa], without the shared calibration."""
        return self._own(self.hardness_shares)

    def _own(self, shares: Array) -> float:
        own = [place for place, source in enumerate(self.sources) if source not in COMMON_SOURCES]
        return float(np.sqrt(np.sum(np.square(shares[own, self.deepest]))))


LEAST_ERRORS, LEAST_FORCE_TO_NOISE = 4.0, 20.0
"""Least distance of touch and baseline in standard errors, and least force between them over its noise, of a doubt."""
ON_BOUND = 1e-3
"""Relative distance from a bound of a number that ends on it."""


def doubts_of(solution: Any) -> tuple[str, ...]:
    """Return sentences on what makes the readings of an indentation doubtful; empty if nothing does.

    Parameters
    ----------
    solution : NanoindentationSolution
    """
    return (*_two_touches(solution), *_on_bounds(solution))


def _two_touches(solution: Any) -> Iterator[str]:
    """Yield whether the list of events ends the baseline elsewhere than at the point of first touch."""
    problem, zero = solution.problem, solution.zero_point
    curve = on_frame(problem.curve, problem.indenter.frame_compliance)
    baselines = [one for one in curve.events if one.kind is EventKind.BASELINE_BEFORE]
    if not baselines:
        return
    depth, force = curve.depth(zero.position), curve.force - zero.baseline
    begin, end = baselines[0].first, baselines[0].last
    noise = white_noise(force[begin : end + 1])
    ahead, rise = float(depth[end]), float(np.median(force[max(begin, end - 4) : end + 1]))
    if ahead > LEAST_ERRORS * zero.error and rise > LEAST_FORCE_TO_NOISE * noise:
        yield (
            f"Touch: two touches are seen. The first is taken, but {with_unit(rise, 'N', 2)} over "
            f"{with_unit(ahead, 'm', 2)} follow before the point where the list of events ends the baseline: dust, or "
            "a soft layer, may come before the sample; clean it, or give contact_point."
        )


def _on_bounds(solution: Any) -> Iterator[str]:
    """Yield which numbers of the fitted unloadings end on a bound."""
    least, most = (math.exp(end) for end in EXPONENT_BOUNDS)
    over = solution.exponent - 1.0
    for name, bound, reached in (
        (f"exponent of {1.0 + most:.4g}", "greatest", over >= most * (1.0 - ON_BOUND)),
        ("exponent of 1", "least", over <= least * (1.0 + ON_BOUND)),
        (
            f"final depth of {LEAST_FINAL_DEPTH:g} times that of the peak", "least",
            solution.final_depth <= LEAST_FINAL_DEPTH * solution.depth * (1.0 - ON_BOUND),
        ),
    ):  # fmt: skip
        if np.any(reached):
            which = ", ".join(str(place + 1) for place in np.flatnonzero(reached)[:5].tolist())
            yield (
                f"Bound: unloading {which} ends on the {bound} {name} that is tried, and its numbers have no meaning; "
                "check segments, drift and contact point, or fit another part of it (upper, lower)."
            )
