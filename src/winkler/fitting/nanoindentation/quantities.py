r"""The quantities of ISO 14577-1 of one indentation, each with its standard uncertainty.

=================  ==========================================================================================
HM                 Martens hardness, :math:`F_{max}/A_s(h)` with the surface of the pyramid below the depth h
HMs                Martens hardness from the slope of the loading, :math:`1/(m^2 A_s/h^2)`, :math:`h = m\sqrt F`
HIT                indentation hardness, :math:`F_{max}/A_p(h_c)`
EIT                indentation modulus from the reduced modulus and Poisson's ratio
HV*                Vickers hardness as HIT converts to it: HIT/g times 24.50/26.43, 0.0945 HIT in MPa
CIT                creep under constant force, :math:`(h_2-h_1)/h_1`
RIT                relaxation at constant depth, :math:`(F_1-F_2)/F_1`
W, W_e, W_p        work of the loading :math:`\int F\,dh`, of the unloading (elastic), and their difference
eta_IT             elastic part, :math:`W_e/W`
=================  ==========================================================================================

The surface follows from the projected area function by the ratio 26.43/24.50 of Vickers' pyramid, and of the Berkovich
pyramid with the same ratio of surface to depth.

References
----------
ISO 14577-1:2015, Metallic materials - Instrumented indentation test for hardness and materials parameters - Part 1
"""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.nanoindentation.measurement import Nanoindentation, NanoindentationSolution
from winkler.fitting.nanoindentation.readings import area_of, factors_of
from winkler.fitting.nanoindentation.thermal_drift import ThermalDrift
from winkler.fitting.nanoindentation.touch import white_noise
from winkler.fitting.nanoindentation.zero_point import ZeroPoint
from winkler.numerics.types import Array
from winkler.values.value import value, words

SURFACE_RATIO = 26.43 / 24.50
"""Surface over projected area of Vickers' pyramid."""
GRAVITY = 9.80665
SLOPE_RANGE = (0.5, 0.9)
"""Parts of the greatest force between which the slope of the loading is taken."""
STEP, ROUNDING = 1e-3, 1e-9
HELD_FORCE, HELD_DEPTH = 0.01, 0.001
"""Greatest relative changes during a hold of constant force, and of constant depth."""


@value
class IndentationQuantities:
    """Quantities of ISO 14577-1 with standard uncertainties; a number that the curve does not contain is nan.

    Parameters
    ----------
    names : tuple of str
        HM, HMs, HIT, EIT, HV*, CIT, RIT, W, W_e, W_p, eta_IT.
    units : tuple of str
        Pa, "" (HV*, in kgf/mm^2, is stated without unit), J.
    values, errors : ndarray, (11,)
        Numbers and standard uncertainties; nan if not known.
    """

    __words__ = words(
        names=("", None, "names of ISO 14577-1"),
        units=("", None, "their units"),
        values=("", None, "the quantities, each in its unit"),
        errors=("u", None, "standard uncertainties, each in its unit"),
    )

    names: tuple[str, ...]
    units: tuple[str, ...]
    values: Array
    errors: Array

    def value(self, name: str) -> float:
        """Return a quantity."""
        return float(self.values[self.names.index(name)])

    def error(self, name: str) -> float:
        """Return the standard uncertainty of a quantity."""
        return float(self.errors[self.names.index(name)])


UNITS = {
    "HM": "Pa", "HMs": "Pa", "HIT": "Pa", "EIT": "Pa", "HV*": "", "CIT": "", "RIT": "",
    "W": "J", "W_e": "J", "W_p": "J", "eta_IT": "",
}  # fmt: skip


def indentation_quantities(solution: NanoindentationSolution) -> IndentationQuantities:
    """Return the quantities of ISO 14577-1 at the maximum force of an evaluated indentation.

    Parameters
    ----------
    solution : NanoindentationSolution
        The evaluated indentation. For quantities without power-law fit the uncertainty follows from zero point, drift
        and calibration.
    """
    problem = solution.problem
    curve = _placed(problem, solution.zero_point, solution.drift, problem.indenter)
    middle = _of_path(curve, problem.indenter)
    squares = np.zeros(middle.size)
    for change in _changed(solution):
        squares += np.square((_of_path(*change) - middle) / STEP)
    squares[1] += _slope_error(curve, problem.indenter) ** 2
    squares[2] += _creep_error(curve) ** 2
    squares[4:] += _work_errors(curve, middle[4:]) ** 2
    place = solution.deepest
    hardness, hardness_error = float(solution.hardness[place]), float(solution.hardness_errors[place])
    vickers = 1e-6 / GRAVITY / SURFACE_RATIO
    values = [*middle[:2], hardness, float(solution.young[place]), hardness * vickers, *middle[2:]]
    rest = np.sqrt(squares)
    errors = [*rest[:2], hardness_error, float(solution.young_errors[place]), hardness_error * vickers, *rest[2:]]
    numbers, uncertain = np.array(values), np.array(errors)
    uncertain[~(uncertain > ROUNDING * np.abs(numbers))] = np.nan  # nothing is known of it
    return IndentationQuantities(tuple(UNITS), tuple(UNITS.values()), numbers, uncertain)


def _placed(problem: Nanoindentation, zero: ZeroPoint, drift: ThermalDrift, indenter: CalibratedIndenter) -> ForceCurve:
    from winkler.fitting.curves.corrections import on_frame, without_drift

    stiff = on_frame(problem.curve, indenter.frame_compliance)
    steady = without_drift(stiff, drift.rate) if drift.rate else stiff
    return dataclasses.replace(steady, position=steady.position - zero.position, force=steady.force - zero.baseline)


def _changed(solution: NanoindentationSolution) -> list[tuple[ForceCurve, CalibratedIndenter]]:
    """Return curves and indenters moved by a small part of each standard uncertainty."""
    problem, zero, drift = solution.problem, solution.zero_point, solution.drift
    indenter = problem.indenter
    moved = dataclasses.replace(zero, position=zero.position + STEP * zero.error)
    changes = [(_placed(problem, moved, drift, indenter), indenter)]
    if drift.error:
        faster = dataclasses.replace(drift, rate=drift.rate + STEP * drift.error)
        changes.append((_placed(problem, zero, faster, indenter), indenter))
    if problem.force_error:
        curve = _placed(problem, zero, drift, indenter)
        changes.append((dataclasses.replace(curve, force=curve.force * (1.0 + STEP * problem.force_error)), indenter))
    if problem.depth_error:
        curve = _placed(problem, zero, drift, indenter)
        longer = curve.position * (1.0 + STEP * problem.depth_error)
        changes.append((dataclasses.replace(curve, position=longer), indenter))
    if indenter.calibrated:
        for column in factors_of(indenter.covariance).T:
            numbers = indenter.numbers + STEP * column
            area = dataclasses.replace(indenter.area, coefficients=tuple(numbers[1:].tolist()))
            other = dataclasses.replace(indenter, area=area, frame_compliance=max(float(numbers[0]), 0.0))
            changes.append((_placed(problem, zero, drift, other), other))
    return changes


def _of_path(curve: ForceCurve, indenter: CalibratedIndenter) -> Array:
    """Return HM, HMs, CIT, RIT, W, W_e, W_p and eta_IT."""
    depth, force = curve.depth(0.0), curve.force
    last, hold = _last_unloading(curve)
    peak = max(int(last[0]) - 1, 0) if last.size else int(np.argmax(force))
    end = hold[-max(1, hold.size // 10) :] if hold.size else np.array([peak])
    deepest, highest = float(np.median(depth[end])), float(np.median(force[end]))
    martens = highest / (SURFACE_RATIO * float(area_of(indenter.area.coefficients, np.array(deepest))))
    creep, relaxed = _during(depth, force, hold)
    total = float(np.trapezoid(force[: peak + 1], depth[: peak + 1]))
    elastic = -float(np.trapezoid(force[peak:], depth[peak:])) if last.size else np.nan
    slope = _slope(curve, indenter)[0]
    return np.array([martens, slope, creep, relaxed, total, elastic, total - elastic, elastic / total])


def _last_unloading(curve: ForceCurve) -> tuple[Array, Array]:
    """Return the indices of the last unloading, and of the hold before it."""
    parts = [part for part in curve.segments if part.kind is SegmentKind.LAST_UNLOADING]
    if not parts:
        return np.arange(0), np.arange(0)
    first = parts[0].first
    held = [part for part in curve.segments if part.kind is SegmentKind.HOLD and part.last == first - 1]
    hold = np.arange(held[0].first, held[0].last + 1) if held else np.arange(0)
    return np.concatenate([np.arange(part.first, part.last + 1) for part in parts]), hold


def _during(depth: Array, force: Array, hold: Array) -> tuple[float, float]:
    """Return creep and relaxation of a hold, nan where it has none."""
    if hold.size < 10:
        return np.nan, np.nan
    edge = max(2, hold.size // 50)
    start, end = hold[:edge], hold[-edge:]
    d1, d2 = float(np.mean(depth[start])), float(np.mean(depth[end]))
    f1, f2 = float(np.mean(force[start])), float(np.mean(force[end]))
    constant_force, constant_depth = abs(f2 / f1 - 1.0) < HELD_FORCE, abs(d2 / d1 - 1.0) < HELD_DEPTH
    creep = d2 / d1 - 1.0 if constant_force else np.nan
    return creep, (1.0 - f2 / f1 if constant_depth and not constant_force else np.nan)


def _creep_error(curve: ForceCurve) -> float:
    """Return the standard error of the creep by noise."""
    _, hold = _last_unloading(curve)
    if hold.size < 10:
        return 0.0
    depth = curve.depth(0.0)[hold]
    return white_noise(depth) * float(np.sqrt(2.0 / max(2, hold.size // 50))) / float(depth[0])


def _work_errors(curve: ForceCurve, works: Array) -> Array:
    """Return the standard errors of W, W_e, W_p and eta_IT by white noise of force and depth."""
    last, _ = _last_unloading(curve)
    depth, force = curve.depth(0.0), curve.force
    peak = max(int(last[0]) - 1, 0) if last.size else int(np.argmax(force))
    by_force, by_depth = white_noise(force), white_noise(depth)

    def inner(part: slice) -> float:
        """Return the error of the integral, without the noise of the depths of its ends."""
        if depth[part].size < 3:
            return 0.0
        heights = np.gradient(force[part])[1:-1]
        by_noise = by_force * np.linalg.norm(np.gradient(depth[part])), by_depth * np.linalg.norm(heights)
        return float(np.hypot(*by_noise))

    total, elastic, ends = inner(slice(0, peak + 1)), inner(slice(peak, None)), by_depth * np.abs(force[[0, peak, -1]])
    share = works[3]
    parts = (total * share, elastic, ends[1] * (1.0 - share), ends[2], ends[0] * share)  # the peak ends both works
    return np.array(
        [
            np.linalg.norm((total, *ends[:2])),
            np.linalg.norm((elastic, *ends[1:])),
            np.linalg.norm((total, elastic, ends[0], ends[2])),
            np.linalg.norm(parts) / works[0],
        ]
    )


def _slope(curve: ForceCurve, indenter: CalibratedIndenter) -> tuple[float, float]:
    """Return HMs and its relative standard error by noise."""
    depth, force = curve.depth(0.0), curve.force
    last, hold = _last_unloading(curve)
    end = int(hold[0]) if hold.size else int(last[0]) if last.size else int(np.argmax(force))
    envelope = np.maximum.accumulate(force[:end]) if end else force[:0]
    top = float(envelope[-1]) if envelope.size else 0.0
    inside = (force[:end] >= envelope) & (envelope > SLOPE_RANGE[0] * top) & (envelope < SLOPE_RANGE[1] * top)
    if np.count_nonzero(inside) < 10:
        return np.nan, np.nan
    x, y = np.sqrt(force[:end][inside]), depth[:end][inside]
    rows = np.stack([x, np.ones_like(x)], axis=1)
    numbers, *_ = np.linalg.lstsq(rows, y, rcond=None)
    scatter = float(np.std(y - rows @ numbers))
    error = scatter / (float(np.std(x)) * np.sqrt(x.size)) / float(numbers[0])
    deepest = float(depth[:end][inside].max())
    surface = SURFACE_RATIO * float(area_of(indenter.area.coefficients, np.array(deepest))) / deepest**2
    return 1.0 / (float(numbers[0]) ** 2 * surface), 2.0 * abs(error)


def _slope_error(curve: ForceCurve, indenter: CalibratedIndenter) -> float:
    middle, relative = _slope(curve, indenter)
    return middle * relative
