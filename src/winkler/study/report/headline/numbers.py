"""The sought numbers of an outcome, those that were prescribed last."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.plot.series import name_in_words
from winkler.readable import with_unit
from winkler.study.batch.outcome import Outcome
from winkler.study.chapters.contents import answer_of
from winkler.study.report.describe import inputs
from winkler.vocabulary import Word

__all__ = ["SoughtNumber", "sought_numbers"]

ALIKE = 1e-3
"""Relative difference below which the greatest number is that of the end."""
ALONG_A_PATH = ("time", "distance", "cycles", "cycle", "position")
"""Answers of paths and histories."""


class SoughtNumber(NamedTuple):
    """One number of the headline.

    Parameters
    ----------
    name
        Of the answer.
    word
        Symbol, unit and meaning.
    last
        The number, SI; of a path, of a history or of many loads that at the end.
    low, high
        The least and the greatest of all loads and points.
    prescribed
        Whether the study gives it.
    many
        Whether it differs along a path, a history or many loads.
    swept
        Whether it is of the points of a sweep.
    end
        Where the last number holds: ``at the end`` of a path or a history, or ``at the last value``.
    """

    name: str
    word: Word
    last: float
    low: float
    high: float
    prescribed: bool
    many: bool
    swept: bool
    end: str

    @property
    def label(self) -> str:
        """Its name in words."""
        return name_in_words(self.name)

    @property
    def extreme(self) -> float:
        """The number that is farthest from zero."""
        return self.high if abs(self.high) >= abs(self.low) else self.low

    @property
    def ends_at_zero(self) -> bool:
        """Whether it has returned to zero at the end, as the force on a body that was lifted off."""
        return self.many and self.last == 0.0 != self.extreme

    @property
    def is_range(self) -> bool:
        """Whether a range is shown: of the points of a sweep, and where no single number is sought."""
        return self.swept and self.low != self.high

    @property
    def text(self) -> str:
        """The number with its unit."""
        if self.is_range:
            return f"{self._of(self.low)} … {self._of(self.high)}"
        return self._of(self.extreme if self.ends_at_zero else self.last)

    @property
    def remark(self) -> str:
        """How the number differs along a path, a history or many loads; empty where it does not."""
        if self.is_range or not self.varies:
            return ""
        if self.ends_at_zero:
            return f"the {self.extreme_name}; {self._of(0.0)} {self.end}"
        return f"{self.extreme_name} {self._of(self.extreme)}"

    def sentence(self, event: str = "") -> str:
        """Return the number with its unit in a sentence, without its full stop; `event` is what it belongs to."""
        label = f"{self.label} {event}".rstrip()
        if self.is_range:
            return f"the {label} is between {self._of(self.low)} and {self._of(self.high)}"
        if self.ends_at_zero:
            return f"the {self.extreme_name} {label} is {self.text}, and {self._of(0.0)} {self.end}"
        beside = f", and the {self.extreme_name} {self._of(self.extreme)}" if self.varies else ""
        return f"{f'{self.end} ' if self.many else ''}the {label} is {self.text}{beside}"

    @property
    def varies(self) -> bool:
        """Whether another number than the last is farther from zero."""
        return self.many and abs(self.extreme) > (1.0 + ALIKE) * abs(self.last)

    @property
    def extreme_name(self) -> str:
        """What the number is called that is farthest from zero."""
        return "lowest" if self.extreme < 0.0 else "greatest"

    def _of(self, number: float) -> str:
        return with_unit(number, self.word.unit)


def sought_numbers(outcome: Outcome) -> tuple[SoughtNumber, ...]:
    """Return the numbers of the headline: what is most often sought first, what was prescribed last.

    Where only a whole curve is an answer, they are the ranges of all its numbers, the last of the table first.

    Parameters
    ----------
    outcome
        Outcome of a study.
    """
    study, record = outcome.study, answer_of(outcome.study.problem)
    given = {one.name for one in inputs(study)}
    names = record.headline or tuple(reversed([name for name in outcome.answers if outcome.word(name).unit]))
    swept = bool(study.axes) or not record.headline
    varied = {axis.key.rpartition(".")[2] for axis in study.sweep}
    end = "at the end" if any(name in outcome.answers for name in ALONG_A_PATH) else "at the last value"
    found = []
    for name in names:
        if name not in outcome.answers or name in varied:
            continue
        numbers = np.asarray(outcome.answer(name), dtype=float).ravel()
        finite = numbers[~np.isnan(numbers)]
        if not finite.size or (np.isnan(numbers[-1]) and not swept):
            continue
        low, high = float(np.min(finite)), float(np.max(finite))
        prescribed = name_in_words(name) in given
        found.append(
            SoughtNumber(name, outcome.word(name), float(finite[-1]), low, high, prescribed, low != high, swept, end)
        )
    return tuple(sorted(found, key=lambda one: one.prescribed))
