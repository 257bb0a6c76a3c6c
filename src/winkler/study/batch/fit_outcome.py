"""The outcome of the fits of a study: one fit, or one reason for its failure, for every curve.

::

    outcome.study            the `FitStudy`
    outcome.results          one `Fitted` or `Refused` per curve, in their order
    outcome.fitted, .refused the same, apart
    outcome.independent      those fitted, of copies the first
    outcome.batch, .doubts   median and scatter of the curves; which stand out, or are copies
    outcome.left             number of files or curves that were not reached before a stop
    outcome.table()          `Column` after `Column`, one row per curve
    outcome.provenance       version, hash of the study with its curves, time, versions of what computed
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.fitting.compare import AnyFit
from winkler.fitting.several.joint import JointFit
from winkler.fitting.several.standing_out import BatchQuantity, copies, doubts_of_batch
from winkler.numerics.types import Array
from winkler.study.batch.fit_further import CONTACT_POINT, NOTHING, Further, further_columns
from winkler.study.batch.outcome import Provenance, ResultColumn
from winkler.study.language.fit_study import FitStudy, Free
from winkler.values.validity import Note, Standing, topic_of, worst_of_each
from winkler.values.value import value
from winkler.values.vocabulary import Word

CONFIDENCE = 0.95
MOST_NAMES = 8
"""Curves that a note on many curves names; fit.csv holds all."""
FIT_COLUMNS = {
    "chi_square": Word(r"\chi^2", "", "squared misfit over the noise"),
    "chi_square_in_contact": Word(r"\chi^2", "", "squared misfit over the noise, of the points in contact alone"),
    "effective_count": Word("", "", "independent points"),
    "slow_share": Word("", "", "part of the noise's variance that is slow"),
    "largest_depth": Word("d", "m", "largest fitted depth"),
    "largest_radius": Word("a", "m", "largest fitted contact radius"),
}


@value
class Fitted:
    """A curve that was fitted.

    Parameters
    ----------
    name
        The file, relative to the study; within a map also the number of the curve.
    x, y : float
        Place on the sample [m]; nan where the file does not state it.
    steps : tuple of str
        Corrections of the curve before the fit, as sentences.
    fit : Fit, ViscoelasticFit or CreepFit
    notes : tuple of Note
        Validity of the fitted contact at its largest depth.
    further : Further
        Calibration shares, depths and other models, where the study asks for them.
    """

    name: str
    x: float
    y: float
    steps: tuple[str, ...]
    fit: AnyFit
    notes: tuple[Note, ...]
    further: Further = NOTHING


@value
class Refused:
    """A curve without an answer.

    Parameters
    ----------
    name, x, y
        As for `Fitted`.
    reason
        One sentence.
    code
        Exit code of the command line: 2 input, 3 not converged, 4 outside validity.
    """

    name: str
    x: float
    y: float
    reason: str
    code: int


def interval_of(result: Fitted, free: Free) -> tuple[float, float]:
    """Return the interval of 95 % of a number, with the error of the calibration where it is stated."""
    if result.further.shares:
        return result.further.shares[0].interval(result.fit, free.path, CONFIDENCE)
    return result.fit.interval(free.path, CONFIDENCE)


@value
class FitOutcome:
    """The outcome of the fits of a study; see the module for its parts."""

    study: FitStudy
    results: tuple[Fitted | Refused, ...]
    provenance: Provenance
    left: int = 0
    joint: tuple[JointFit, ...] = ()
    joint_failure: str = ""

    @property
    def fitted(self) -> tuple[Fitted, ...]:
        """The curves that were fitted."""
        return tuple(result for result in self.results if isinstance(result, Fitted))

    @property
    def refused(self) -> tuple[Refused, ...]:
        """The curves without an answer."""
        return tuple(result for result in self.results if isinstance(result, Refused))

    @functools.cached_property
    def _first(self) -> tuple[int, ...]:
        return copies(result.fit.curve for result in self.fitted)

    @functools.cached_property
    def independent(self) -> tuple[Fitted, ...]:
        """The curves that were fitted, of copies the first."""
        fitted = self.fitted
        return tuple(fitted[place] for place in dict.fromkeys(self._first))

    @functools.cached_property
    def batch(self) -> tuple[BatchQuantity, ...]:
        """Numbers of the problem, depth at the peak, touch and misfit of the independent curves."""
        fits = [result.fit for result in self.independent]

        def quantity(free: Free) -> BatchQuantity:
            numbers, errors = np.array([[fit.value(free.path), fit.error(free.path)] for fit in fits]).reshape(-1, 2).T
            is_place = free.key == CONTACT_POINT
            unit = self.study.word(free.key).unit or ""
            return BatchQuantity("first touch" if is_place else free.label, unit, numbers, errors, is_place)

        touch = [free for free in self.study.free if free.key == CONTACT_POINT]
        return (
            *(quantity(free) for free in self.study.own_numbers),
            BatchQuantity("depth at the peak", "m", np.array([float(np.max(fit.depth)) for fit in fits])),
            *(quantity(free) for free in touch),
            BatchQuantity("chi-square in contact", "", np.array([fit.chi_square_in_contact for fit in fits])),
        )

    @functools.cached_property
    def doubts(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """Names of the curves that stand out of the others or are copies, and what was found."""
        names = [result.name for result in self.fitted]
        found = zip(names, doubts_of_batch(names, self._first, self.batch), strict=True)
        return tuple((name, doubts) for name, doubts in found if doubts)

    @functools.cached_property
    def validity(self) -> tuple[Note, ...]:
        """The notes of all fits; of statements that differ in their numbers only, the worst, with its curves."""
        notes = worst_of_each(note for result in self.fitted for note in result.notes)
        return notes if len(self.fitted) == 1 else tuple(self._with_curves(note) for note in notes)

    def _with_curves(self, note: Note) -> Note:
        """Return a note with the curves on whose subject nothing worse is stated, in front of its statement."""
        topic = topic_of(note)
        names = [
            result.name
            for result in self.fitted
            if any(topic_of(other) == topic and other.standing is note.standing for other in result.notes)
        ]
        first = f"{', '.join(names[:MOST_NAMES])}{f' and {len(names) - MOST_NAMES} more' * (len(names) > MOST_NAMES)}"
        every = len(names) == len(self.fitted)
        which = f"all {len(names)} curves" if every else f"{len(names)} of {len(self.fitted)} curves ({first})"
        return dataclasses.replace(note, statement=f"{which}: {note.statement}")

    def numbers(self, free: Free) -> Array:
        """Return a fitted number of every curve, NaN where there is none ``(curves,)``, SI."""
        return self._of(lambda fit: fit.value(free.path))

    def errors(self, free: Free) -> Array:
        """Return the standard error of a fitted number of every curve ``(curves,)``, SI."""
        return self._of(lambda fit: fit.error(free.path))

    def intervals(self, free: Free) -> Array:
        """Return the interval of 95 % of every curve ``(curves, 2)``, SI."""
        nothing = (np.nan, np.nan)
        return np.array([interval_of(one, free) if isinstance(one, Fitted) else nothing for one in self.results])

    def flags(self, separator: str, nothing: str) -> list[str]:
        """Return the names of the flags of every curve, `nothing` where there is no fit."""
        return list(self._of(lambda fit: separator.join(flag.name for flag in fit.flags), nothing))

    def table(self) -> tuple[ResultColumn, ...]:
        """Return one row per curve: name, place, every free number with its error and interval, misfit, flags."""
        names = np.array([result.name for result in self.results])
        columns = [ResultColumn("curve", Word("", None, "where the curve comes from"), names)]
        for axis in ("x", "y"):
            place = np.array([getattr(result, axis) for result in self.results])
            if np.isfinite(place).any():
                columns.append(ResultColumn(axis, Word(axis, "m", "place on the sample"), place))
        for free in self.study.free:
            stated = self.study.word(free.key)
            low, high = self.intervals(free).T
            parts = (
                ("", "", self.numbers(free)),
                ("_error", "standard error: ", self.errors(free)),
                ("_low", "lower end of the 95 % interval: ", low),
                ("_high", "upper end of the 95 % interval: ", high),
            )
            columns += [
                ResultColumn(f"{free.key}{end}", stated._replace(meaning=f"{lead}{stated.meaning}"), content)
                for end, lead, content in parts
            ]
        columns += [
            ResultColumn(name, word, self._largest(name.removeprefix("largest_")))
            for name, word in ({"noise": self.study.spread} | FIT_COLUMNS).items()
        ]
        fits = [one.fit if isinstance(one, Fitted) else one.reason for one in self.results]
        furthers = [one.further if isinstance(one, Fitted) else NOTHING for one in self.results]
        columns += further_columns(self.study, fits, furthers)
        reasons = np.array([result.reason if isinstance(result, Refused) else "" for result in self.results])
        flags = np.array(self.flags("; ", ""))
        columns.append(ResultColumn("flags", Word("", None, "what speaks against the numbers"), flags))
        outside = np.array([_outside(result) for result in self.results])
        said = {name: " ".join(each) for name, each in self.doubts}
        doubts = np.array([said.get(result.name, "") for result in self.results])
        columns.append(ResultColumn("doubts", Word("", None, "what sets the curve apart from the others"), doubts))
        columns.append(ResultColumn("outside", Word("", None, "subjects on which validity does not hold"), outside))
        columns.append(ResultColumn("failure", Word("", None, "why a curve has no answer"), reasons))
        return tuple(columns)

    def _of(self, stated: Callable[[AnyFit], Any], nothing: Any = np.nan) -> Array:
        """Return something of every fit, `nothing` where there is none."""
        return np.array([stated(result.fit) if isinstance(result, Fitted) else nothing for result in self.results])

    def _largest(self, name: str) -> Array:
        return self._of(lambda fit: float(np.max(getattr(fit, name))))


def _outside(result: Fitted | Refused) -> str:
    """Return the topics of the notes that are outside, in one line."""
    notes = result.notes if isinstance(result, Fitted) else ()
    return "; ".join(dict.fromkeys(topic_of(note) for note in notes if note.standing is Standing.OUTSIDE))
