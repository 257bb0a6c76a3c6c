"""The curves of a study of nanoindentations as a stream, and their outcome; one that fails does not stop the others."""

from __future__ import annotations

import functools
import hashlib
import math
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.nanoindentation.calibration import calibrate_indenter
from winkler.fitting.nanoindentation.calibration_solution import IndenterCalibration
from winkler.fitting.nanoindentation.measurement import Nanoindentation, NanoindentationSolution
from winkler.fitting.nanoindentation.pop_ins import PopInStatistics
from winkler.fitting.nanoindentation.quantities import IndentationQuantities, indentation_quantities
from winkler.fitting.nanoindentation.repetition import RepeatedMean, compared_quantities, repeated_mean
from winkler.fitting.nanoindentation.thermal_drift import ThermalDrift
from winkler.fitting.nanoindentation.zero_point import ZeroPoint
from winkler.fitting.several.standing_out import BatchQuantity, copies, doubts_of_batch
from winkler.io.curves import UnreadCurve, try_curves
from winkler.io.placed_curves import PlacedCurve
from winkler.study.batch.outcome import ComparedNumber, Provenance
from winkler.study.batch.run import provenance
from winkler.study.language.segmenting import segmented
from winkler.study.nanoindentation.continuous_curve import EvaluatedContinuously, evaluated_continuously
from winkler.study.nanoindentation.expected import verdicts_of
from winkler.study.nanoindentation.first_yield import first_pop_in, first_yield
from winkler.study.nanoindentation.reading import NanoindentationStudy
from winkler.values.errors import InvalidInput, Mistake, WinklerError
from winkler.values.validity import Note, worst_of_each
from winkler.values.value import value

__all__ = ["Evaluated", "NanoindentationOutcome", "Unevaluated", "evaluated_files", "gathered", "read_references"]


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
