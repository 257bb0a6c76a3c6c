"""The curves of a study of nanoindentations as a stream, and their outcome; one that fails does not stop the others.

Expected numbers of nanoindentations: ``[[expect]]`` in studies with ``[indentation]`` or ``[calibration]``.

Of an indentation the quantities are its answers (young, hardness, stiffness, contact_depth, modulus, ...), at the
greatest force of each curve; with a number behind the name, at that unloading, ``young.0`` the first.  A calibration
has frame_compliance, and by their number what it has of each unloading.
"""

from __future__ import annotations

import dataclasses
import functools
import hashlib
import math
import time
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.nanoindentation.calibration import calibrate_indenter
from winkler.fitting.nanoindentation.calibration_solution import IndenterCalibration
from winkler.fitting.nanoindentation.continuous import (
    ContinuousIndentation,
    ContinuousIndentationSolution,
    WindowMean,
)
from winkler.fitting.nanoindentation.measurement import Nanoindentation, NanoindentationSolution
from winkler.fitting.nanoindentation.pop_ins import PopInStatistics, pop_in_statistics
from winkler.fitting.nanoindentation.quantities import IndentationQuantities, indentation_quantities
from winkler.fitting.nanoindentation.repetition import RepeatedMean, compared_quantities, repeated_mean
from winkler.fitting.nanoindentation.thermal_drift import ThermalDrift
from winkler.fitting.nanoindentation.zero_point import ZeroPoint
from winkler.fitting.several.standing_out import BatchQuantity, copies, doubts_of_batch
from winkler.io.curves import UnreadCurve, try_curves
from winkler.io.placed_curves import PlacedCurve
from winkler.study.batch.outcome import Provenance, answers_of
from winkler.study.batch.points import ComparedNumber
from winkler.study.batch.run import provenance
from winkler.study.batch.verdicts import deviation
from winkler.study.language.segmenting import segmented
from winkler.study.language.study import Expectation
from winkler.study.nanoindentation.reading import NanoindentationStudy
from winkler.values.errors import InvalidInput, Mistake, WinklerError, suggest
from winkler.values.readable import with_unit
from winkler.values.validity import Note, worst_of_each
from winkler.values.value import value

DEEPER = 0.5
"""Part of the greatest depth from which on a curve is averaged where no depths are stated."""
MOST_ERRORS = 2.0
"""Greatest difference to the instrument's own result, in standard uncertainties, that is not named."""


@value
class EvaluatedContinuously:
    """A curve with modulus and hardness at every depth.

    Parameters
    ----------
    name : str
        Origin of the curve.
    solution : ContinuousIndentationSolution
        Its readings.
    own_touch : bool
        Whether the touch was found or given; else depth is as the instrument states it.
    window : tuple of float
        Depths [m] between which means are taken: those of the study, else the deeper half.
    mean : WindowMean
        Means of E and H there.
    stated : tuple of float
        The instrument's own E and H [Pa] there; nan where the file has none.
    """

    name: str
    solution: ContinuousIndentationSolution
    own_touch: bool
    window: tuple[float, float]
    mean: WindowMean
    stated: tuple[float, float] = (math.nan, math.nan)

    @property
    def doubts(self) -> tuple[str, ...]:
        """Sentences on results of the instrument that differ by more than the uncertainty."""
        mean, found = self.mean, []
        ours = (
            ("E", mean.young, mean.young_error, mean.young_scatter),
            ("H", mean.hardness, mean.hardness_error, mean.hardness_scatter),
        )
        for (word, number, error, scatter), theirs in zip(ours, self.stated, strict=True):
            whole = math.hypot(error, scatter / math.sqrt(mean.points))
            if abs(number - theirs) > MOST_ERRORS * whole:
                texts = [with_unit(one, "Pa", 3) for one in (theirs, number, whole)]
                found.append(f"{word} {texts[0]}, here {texts[1]}, uncertain by {texts[2]}")
        if not found:
            return ()
        low, high = (with_unit(end, "m", 3) for end in self.window)
        return (
            f"Instrument: its own results at {low} to {high} differ ({'; '.join(found)}): compare area function, "
            "frame, touch and Poisson's ratio.",
        )


def evaluated_continuously(
    study: NanoindentationStudy, placed: PlacedCurve, name: str, unloadings: NanoindentationSolution | None
) -> EvaluatedContinuously | str:
    """Return E and H over depth, or the reason why there are none.

    Touch and drift of the unloadings of the same curve correct the depth, or a given touch; without them it stays as
    the file states it.
    """
    data, given = placed.continuous, study.given
    assert data is not None
    error = given.get("contact_point_error", 0.0)
    if unloadings is not None:
        zero, drift = unloadings.zero_point, unloadings.drift
        steady = drift.rate * (data.time - unloadings.problem.curve.time[0]) if data.time.size else 0.0
        data = dataclasses.replace(
            data, depth=data.depth - zero.position - np.asarray(steady), force=data.force - zero.baseline
        )
        error = zero.error
    elif "contact_point" in given:
        data = dataclasses.replace(data, depth=data.depth - given["contact_point"])
    try:
        found = ContinuousIndentation(
            data,
            study.indenter,
            given["poisson"],
            depth_offset_error=error,
            stiffness_error=given.get("stiffness_error", 0.0),
        ).solve()
        deepest = float(found.depth.max())
        low, high = study.window or (DEEPER * deepest, deepest)
        mean = found.mean(low, high)
    except WinklerError as failure:
        return f"continuous stiffness: {failure}"
    stated = placed.stated.mean(low, high) if placed.stated is not None else (math.nan, math.nan)
    own_touch = unloadings is not None or "contact_point" in given
    return EvaluatedContinuously(name, found, own_touch, (low, high), mean, stated)


UNLOADINGS = (SegmentKind.PARTIAL_UNLOADING, SegmentKind.LAST_UNLOADING)


@value
class Evaluated:
    """A curve with its readings, the quantities of ISO 14577, and the force [N] at its first pop-in, where sought."""

    name: str
    solution: NanoindentationSolution
    quantities: IndentationQuantities
    pop_in: float = math.nan


@value
class Unevaluated:
    """A curve without an answer, the reason, and the exit code."""

    name: str
    reason: str
    code: int


@value
class NanoindentationOutcome:
    """The outcome of a study: evaluated and other curves, or the calibration."""

    study: NanoindentationStudy
    evaluated: tuple[Evaluated, ...]
    unevaluated: tuple[Unevaluated, ...]
    calibration: tuple[IndenterCalibration, ...]
    provenance: Provenance
    left: int = 0
    continuous: tuple[EvaluatedContinuously, ...] = ()

    @property
    def first_yield(self) -> PopInStatistics | None:
        """Statistics of first yield; None where it was not sought, or fewer than three curves have a pop-in."""
        given = self.study.given
        if "tip_radius" not in given:
            return None
        solutions, forces = [one.solution for one in self.evaluated], [one.pop_in for one in self.evaluated]
        return first_yield(solutions, forces, given["tip_radius"], given.get("tip_radius_error", 0.0))

    @functools.cached_property
    def verdicts(self) -> tuple[tuple[ComparedNumber, str], ...]:
        """Verdicts on the expected numbers, with the name of the curve of each."""
        found: list[tuple[str, Any]] = [("", one) for one in self.calibration]
        found += [(one.name, one.solution) for one in self.evaluated]
        found += [(one.name, None) for one in self.unevaluated if not self.calibration]
        return verdicts_of(self.study.expect, found)

    @functools.cached_property
    def _first(self) -> tuple[int, ...]:
        return copies(one.solution.problem.curve for one in self.evaluated)

    @property
    def independent(self) -> tuple[Evaluated, ...]:
        """The evaluated curves, of copies the first."""
        return tuple(self.evaluated[place] for place in dict.fromkeys(self._first))

    @functools.cached_property
    def batch(self) -> tuple[BatchQuantity, ...]:
        """Modulus, hardness, depth at the peak, touch and noise of the independent curves."""
        return compared_quantities([one.solution for one in self.independent])

    @functools.cached_property
    def doubts(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """Names of the curves with doubts, and these: of each alone, and what sets it apart from the others."""
        apart = doubts_of_batch([one.name for one in self.evaluated], self._first, self.batch)
        found: dict[str, tuple[str, ...]] = {}
        own = [(one.name, (*one.solution.doubts, *more)) for one, more in zip(self.evaluated, apart, strict=True)]
        for name, doubts in (*own, *((one.name, one.doubts) for one in self.continuous)):
            found[name] = (*found.get(name, ()), *doubts)
        return tuple((name, doubts) for name, doubts in found.items() if doubts)

    @property
    def validity(self) -> tuple[Note, ...]:
        """Notes on the calibration and on the evaluations of all curves; of statements on one subject the worst."""
        found: tuple[Any, ...] = (
            *self.calibration,
            *(one.solution for one in self.evaluated),
            *(one.solution for one in self.continuous),
        )
        return worst_of_each(note for one in found for note in one.validity)

    @property
    def means(self) -> dict[str, RepeatedMean]:
        """Means of Young's modulus and hardness over the curves; of copies one counts."""
        solutions = [one.solution for one in self.independent]
        return {name: repeated_mean(solutions, name) for name in ("young", "hardness")} if solutions else {}


def evaluated_files(
    study: NanoindentationStudy,
) -> Iterator[tuple[Evaluated | Unevaluated | EvaluatedContinuously, ...]]:
    """Yield the results of each file of the study, in their order."""
    for path in study.sources:
        name = _name(study, path)
        yield tuple(
            result
            for one in _curves(study, path)
            for result in (
                (Unevaluated(name, one.reason.removeprefix(f"{path}: "), InvalidInput.exit_code),)
                if isinstance(one, UnreadCurve)
                else _both(study, one, name)
            )
        )


def _both(
    study: NanoindentationStudy, placed: PlacedCurve, file: str
) -> tuple[Evaluated | Unevaluated | EvaluatedContinuously, ...]:
    """Return the unloadings of a curve and its continuous stiffness, where it was measured."""
    own = placed.curve.name
    name = file if own in ("", Path(file).name, Path(file).stem) or file.endswith(own) else f"{file}: {own}"
    found = _evaluated(study, placed.curve, name)
    if placed.continuous is None:
        return (found,)
    over_depth = evaluated_continuously(study, placed, name, found.solution if isinstance(found, Evaluated) else None)
    if isinstance(over_depth, str):
        return found, Unevaluated(name, over_depth, InvalidInput.exit_code)
    unloads = any(part.kind in UNLOADINGS for part in placed.curve.segments)
    return (found, over_depth) if unloads or isinstance(found, Evaluated) else (over_depth,)


def _evaluated(study: NanoindentationStudy, curve: ForceCurve, name: str) -> Evaluated | Unevaluated:
    given = study.given
    try:
        touch = given.get("contact_point")
        zero = () if touch is None else ZeroPoint(touch, given["contact_point_error"], 0.0, extrapolated=False)
        names = ("poisson_error", "force_error", "depth_error", "upper", "lower")
        more: dict[str, Any] = {key: given[key] for key in names if key in given}
        if "drift" in given:
            more["drift"] = ThermalDrift(given["drift"], given.get("drift_error", 0.0))
        curve = segmented(curve, study.segments) if study.segments else curve
        solution = Nanoindentation(curve, study.indenter, given["poisson"], zero_point=zero, **more).solve()
        pop_in = first_pop_in(solution) if "tip_radius" in given else math.nan
        return Evaluated(name, solution, indentation_quantities(solution), pop_in)
    except WinklerError as error:
        return Unevaluated(name, str(error), error.exit_code)
    except Exception as error:  # this curve fails, not the batch
        reason = " ".join(str(error).split())
        return Unevaluated(name, f"an unexpected error, {type(error).__name__}: {reason}", Mistake.exit_code)


def _curves(study: NanoindentationStudy, path: str) -> Iterator[PlacedCurve | UnreadCurve]:
    """Yield the curves of a file, whose positions are those of the tip."""
    return try_curves(path, units=dict(study.units), columns=dict(study.columns), rigid=True)


def read_references(study: NanoindentationStudy) -> Iterator[tuple[ForceCurve, Any] | Unevaluated]:
    """Yield the curves of a calibration with their references, and those that cannot be read."""
    for path, reference in zip(study.sources, study.references, strict=True):
        for one in _curves(study, path):
            if isinstance(one, UnreadCurve):
                yield Unevaluated(_name(study, path), one.reason.removeprefix(f"{path}: "), InvalidInput.exit_code)
            else:
                yield one.curve, reference


def gathered(
    study: NanoindentationStudy, found: Iterable[Any], *, started: float, source: str = "", left: int = 0
) -> NanoindentationOutcome:
    """Return the outcome of what `evaluated_files` or `read_references` yielded.

    Raises
    ------
    InvalidInput, NotConverged, OutsideValidity
        If no curve has an answer: the reason of the first.
    """
    each = [one for many in found for one in (many if isinstance(many, tuple) and not study.calibrates else (many,))]
    failed = tuple(one for one in each if isinstance(one, Unevaluated))
    good = tuple(one for one in each if isinstance(one, Evaluated))
    continuous = tuple(one for one in each if isinstance(one, EvaluatedContinuously))
    calibration: tuple[IndenterCalibration, ...] = ()
    if study.calibrates:
        curves = [one for one in each if isinstance(one, tuple)]
        if not curves:
            raise InvalidInput(f"no curve can be read; the first: {failed[0].name}: {failed[0].reason}")
        given, indenter = study.given, study.indenter
        stiffness = given.get("frame_stiffness")
        calibration = (
            calibrate_indenter(
                curves,
                terms=int(given["terms"]),
                solid=indenter.solid,
                shape_factor=indenter.shape_factor,
                frame_compliance=None if stiffness is None else 1.0 / stiffness,
            ),
        )
        failed += tuple(
            Unevaluated(line.partition(": ")[0], line.partition(": ")[2], InvalidInput.exit_code)
            for line in calibration[0].skipped
        )
    elif not good and not continuous:
        first = failed[0]
        many = f"none of the {len(failed)} curves can be evaluated; the first: " if len(failed) > 1 else ""
        raise InvalidInput(f"{many}{first.name}: {first.reason}")
    made = provenance(_hash(study), time.perf_counter() - started, source)
    return NanoindentationOutcome(study, good, failed, calibration, made, left, continuous)


def _name(study: NanoindentationStudy, path: str) -> str:
    try:
        return Path(path).relative_to(study.folder).as_posix()
    except ValueError:
        return Path(path).name


def _hash(study: NanoindentationStudy) -> str:
    """Return the SHA-256 of study, indenter and the bytes of the curves."""
    whole = hashlib.sha256(study.text.encode())
    whole.update(np.ascontiguousarray(study.indenter.numbers).tobytes())
    for path in study.sources:
        whole.update(Path(path).read_bytes())
    return whole.hexdigest()


def verdicts_of(
    expect: tuple[Expectation, ...], found: Sequence[tuple[str, Any]]
) -> tuple[tuple[ComparedNumber, str], ...]:
    """Return the verdicts on expectations, with the names of the curves.

    Parameters
    ----------
    expect : tuple of Expectation
    found : sequence of (str, solution)
        Name and evaluation of each curve; None where there is none, and its numbers are missed.

    Raises
    ------
    InvalidInput
        If an evaluation has no such number.
    """
    verdicts = []
    for place, (name, solution) in enumerate(found):
        for item in expect:
            got = np.nan if solution is None else _number(solution, item)
            verdicts.append((ComparedNumber((place,), item, got, deviation(got, item)), name))
    return tuple(verdicts)


def _number(solution: Any, item: Expectation) -> float:
    if item.place or np.ndim(item.expected):
        raise InvalidInput(
            f"expect: {item.quantity} is one number of a curve; give one value without a place, and the number of an "
            f"unloading behind the name, as {item.quantity}.0."
        )
    answers = answers_of(solution)
    whole, _, last = item.quantity.rpartition(".")
    index = int(last) if whole and last.removeprefix("-").isdecimal() else None
    name = item.quantity if index is None else whole
    if name not in answers:
        raise InvalidInput(f"expect: '{name}' is no answer{suggest(name, answers)}; there are {', '.join(answers)}.")
    numbers = np.ravel(answers[name])
    if np.ndim(answers[name]) == 0:
        return float(numbers[0])
    if index is None and not hasattr(solution, "deepest"):
        raise InvalidInput(f"expect: {name} has {numbers.size} values; name one, as {name}.0.")
    index = solution.deepest if index is None else index
    if not -numbers.size <= index < numbers.size:
        raise InvalidInput(f"expect: {item.quantity} asks for one of {numbers.size} unloadings; count from 0.")
    return float(numbers[index])


FEWEST = 3
"""Curves with a pop-in of which statistics are made."""


def first_pop_in(solution: NanoindentationSolution) -> float:
    """Return the force [N] at the first pop-in of the first loading; nan where there is none."""
    curve = solution.problem.curve
    loading = next((part for part in curve.segments if part.kind is SegmentKind.LOADING), None)
    for event in curve.events.of("pop-in"):
        force = float(curve.force[max(event.first - 1, 0)]) - solution.zero_point.baseline
        if (loading is None or event.first <= loading.last) and force > 0.0:
            return force
    return math.nan


def first_yield(
    solutions: Sequence[NanoindentationSolution], forces: Sequence[float], tip_radius: float, tip_radius_error: float
) -> PopInStatistics | None:
    """Return the statistics of first yield with the mean reduced modulus of the curves; None with fewer than three."""
    known = [one for one in forces if math.isfinite(one)]
    if len(known) < FEWEST:
        return None
    modulus = float(np.mean([one.modulus[one.deepest] for one in solutions]))
    return pop_in_statistics(known, modulus, tip_radius, tip_radius_error=tip_radius_error)
