"""What the fits of a study came to: one answer or one reason for every curve.

::

    outcome.study            the `FitStudy`
    outcome.results          one `Fitted` or `Refused` per curve, in their order
    outcome.fitted, .refused the same, apart
    outcome.left             how many files or curves of the study were not reached before a stop
    outcome.table()          `Column` after `Column`, one row per curve
    outcome.provenance       version, hash of the question with its curves, time, versions of what computed
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from winkler.fitting.compare import AnyFit
from winkler.numerics.types import Array
from winkler.study.batch.outcome import Column, Provenance
from winkler.study.language.fit_study import FitStudy, Free
from winkler.validity import Note, worst
from winkler.values import value
from winkler.vocabulary import Word

__all__ = ["CONFIDENCE", "FitOutcome", "Fitted", "Refused"]

CONFIDENCE = 0.95


@value
class Fitted:
    """A curve that was fitted.

    Parameters
    ----------
    name
        The file as seen from the study; within a map also the number of the curve.
    x, y : float
        Place on the sample [m]; nan where the file does not tell it.
    steps : tuple of str
        What was done to the curve before.
    fit : Fit, ViscoelasticFit or CreepFit
    notes : tuple of Note
        How far the fitted contact can be trusted, at its largest depth.
    """

    name: str
    x: float
    y: float
    steps: tuple[str, ...]
    fit: AnyFit
    notes: tuple[Note, ...]


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
        What the command line returns for it: 2 input, 3 not converged, 4 outside validity.
    """

    name: str
    x: float
    y: float
    reason: str
    code: int


@value
class FitOutcome:
    """What the fits of a study came to; see the module for its parts."""

    study: FitStudy
    results: tuple[Fitted | Refused, ...]
    provenance: Provenance
    left: int = 0

    @property
    def fitted(self) -> tuple[Fitted, ...]:
        """The curves that were fitted."""
        return tuple(result for result in self.results if isinstance(result, Fitted))

    @property
    def refused(self) -> tuple[Refused, ...]:
        """The curves without an answer."""
        return tuple(result for result in self.results if isinstance(result, Refused))

    @property
    def validity(self) -> tuple[Note, ...]:
        """The notes of all fits; of statements that differ in their numbers only, the worst."""
        found: dict[str, Note] = {}
        for note in (note for result in self.fitted for note in result.notes):
            topic = re.sub(r"[-+]?\d[-+.\de]*", "#", note.statement).partition(":")[0]
            if topic not in found or worst((found[topic], note)) is note.standing:
                found[topic] = note
        return tuple(found.values())

    def numbers(self, free: Free) -> Array:
        """Return a fitted number of every curve, NaN where there is none ``(curves,)``, SI."""
        return np.array(
            [result.fit.value(free.path) if isinstance(result, Fitted) else np.nan for result in self.results]
        )

    def errors(self, free: Free) -> Array:
        """Return the standard error of a fitted number of every curve ``(curves,)``, SI."""
        return np.array(
            [result.fit.error(free.path) if isinstance(result, Fitted) else np.nan for result in self.results]
        )

    def intervals(self, free: Free) -> Array:
        """Return the interval of 95 % of every curve ``(curves, 2)``, SI."""
        return np.array(
            [
                result.fit.interval(free.path, CONFIDENCE) if isinstance(result, Fitted) else (np.nan, np.nan)
                for result in self.results
            ]
        )

    def table(self) -> tuple[Column, ...]:
        """Return one row per curve: name, place, every free number with its error and interval, misfit, flags."""
        names = [result.name for result in self.results]
        columns = [Column("curve", Word("", None, "where the curve comes from"), np.array(names))]
        for axis in ("x", "y"):
            place = np.array([getattr(result, axis) for result in self.results])
            if np.isfinite(place).any():
                columns.append(Column(axis, Word(axis, "m", "place on the sample"), place))
        for free in self.study.free:
            told = self.study.word(free.key)
            limits = self.intervals(free)
            parts = (
                ("", "", self.numbers(free)),
                ("_error", "standard error: ", self.errors(free)),
                ("_low", "lower end of the 95 % interval: ", limits[:, 0]),
                ("_high", "upper end of the 95 % interval: ", limits[:, 1]),
            )
            columns += [
                Column(f"{free.key}{end}", told._replace(meaning=f"{lead}{told.meaning}"), content)
                for end, lead, content in parts
            ]
        columns += [
            Column("noise", self.study.spread, self._each("noise")),
            Column("chi_square", Word(r"\chi^2", "", "squared misfit over the noise"), self._each("chi_square")),
            Column(
                "chi_square_in_contact",
                Word(r"\chi^2", "", "squared misfit over the noise, of the points in contact alone"),
                self._each("chi_square_in_contact"),
            ),
            Column("effective_count", Word("", "", "independent points"), self._each("effective_count")),
            Column("largest_depth", Word("d", "m", "largest fitted depth"), self._largest("depth")),
            Column("largest_radius", Word("a", "m", "largest fitted contact radius"), self._largest("radius")),
        ]
        flags = [
            "; ".join(flag.name for flag in result.fit.flags) if isinstance(result, Fitted) else ""
            for result in self.results
        ]
        reasons = [result.reason if isinstance(result, Refused) else "" for result in self.results]
        columns.append(Column("flags", Word("", None, "what speaks against the numbers"), np.array(flags)))
        columns.append(Column("failure", Word("", None, "why a curve has no answer"), np.array(reasons)))
        return tuple(columns)

    def _each(self, name: str) -> Array:
        return np.array([_number(result, name) for result in self.results])

    def _largest(self, name: str) -> Array:
        return np.array(
            [np.max(getattr(result.fit, name)) if isinstance(result, Fitted) else np.nan for result in self.results]
        )


def _number(result: Any, name: str) -> float:
    return float(getattr(result.fit, name)) if isinstance(result, Fitted) else np.nan
