"""The sought numbers of an outcome, those that were prescribed last."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.study.batch.outcome import Outcome
from winkler.study.chapters.contents import answer_of
from winkler.study.report.describe import inputs, settings_text
from winkler.values.readable import name_in_words, with_unit
from winkler.values.vocabulary import Word

FAR = 1e3
"""Ratio of two numbers of a sentence from which on each has a unit of its own."""
ALIKE = 1e-3
"""Relative difference below which the greatest number is that of the end."""
ALONG_A_PATH = ("time", "distance", "cycles", "cycle", "position")
"""Answers of paths and histories."""
AFTER = {"time": "", "distance": "", "cycles": " cycles"}
"""Those that have passed at the end -> what follows the number."""
MOST_PLACES = 2
"""Varied keys of a sweep that are named beside its least and greatest number."""


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
        Where the last number holds: ``at the end`` or ``after 10 s``, or ``at the last force, 2 N,`` of many.
    places
        Where the least and the greatest number of a sweep are; empty where that is not stated.
    trend
        ``rises`` or ``falls``, of a sweep over one number without a turn between.
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
    places: tuple[str, ...] = ()
    trend: str = ""

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
        return self.swept and self._of(self.low) != self._of(self.high)

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
            return f"the {self.extreme_name}; {self._of(0.0)} {self.end.rstrip(',')}"
        return f"{self.extreme_name} {self._of(self.extreme)}"

    def sentence(self, event: str = "", clause: str = "") -> str:
        """Return the number with its unit in a sentence, without its full stop.

        Parameters
        ----------
        event
            What the number belongs to.
        clause
            What is said of a single number in place of its name.
        """
        label = f"{self.label} {event}".rstrip()
        if self.is_range:
            low, high = self._of(self.low), self._of(self.high)
            if self.trend:
                ends = [f"{low} at {self.places[0]}", f"{high} at {self.places[1]}"]
                first, last = ends if self.trend == "rises" else reversed(ends)
                return f"the {label} {self.trend} from {first} to {last}"
            where = [f" ({place})" if place else "" for place in self.places or ("", "")]
            return f"the {label} is between {low}{where[0]} and {high}{where[1]}"
        if self.ends_at_zero:
            return f"the {self.extreme_name} {label} is {self.text}, and {self._of(0.0)} {self.end.rstrip(',')}"
        extreme = f"{self.extreme_name} {self.label}" if clause else self.extreme_name
        beside = f" ({extreme}: {self._of(self.extreme, beside=self.last)})" if self.varies else ""
        said = clause or f"the {label} is {self.text}"
        return f"{f'{self.end} ' if self.many and not self.swept else ''}{said}{beside}"

    @property
    def varies(self) -> bool:
        """Whether another number than the last is farther from zero."""
        return self.many and abs(self.extreme) > (1.0 + ALIKE) * abs(self.last)

    @property
    def extreme_name(self) -> str:
        """What the number is called that is farthest from zero."""
        return "lowest" if self.extreme < 0.0 else "greatest"

    def _of(self, number: float, beside: float | None = None) -> str:
        if self.is_share:
            return as_share(number)
        near = beside if beside and 1.0 / FAR < abs(number / beside) < FAR else None
        return with_unit(number, self.word.unit, beside=near)

    @property
    def is_share(self) -> bool:
        """Whether it is a part of a whole, which is shown in per cent."""
        return self.word.unit == "" and self.name.endswith("_share")


def as_share(number: float) -> str:
    """Return a part of a whole in per cent."""
    return f"{with_unit(100.0 * number, '', 3)} %"


def sought_numbers(outcome: Outcome) -> tuple[SoughtNumber, ...]:
    """Return the numbers of the headline: what is most often sought first, what was prescribed last.

    Where only a whole curve is an answer, they are the ranges of all its numbers, the last of the table first.

    Parameters
    ----------
    outcome
        Outcome of a study.
    """
    study, record = outcome.study, answer_of(outcome.study.problem)
    names = record.headline or tuple(reversed([name for name in outcome.answers if outcome.word(name).unit]))
    varied = {axis.key.rpartition(".")[2] for axis in study.sweep}
    words = {name: outcome.word(name) for name in names if name in outcome.answers and name not in varied}
    found = numbers_named(outcome, words, [point.readable for point in outcome.solved])
    return tuple(sorted(found, key=lambda one: one.prescribed))


def numbers_named(
    outcome: Outcome, words: Mapping[str, Word], answers: Sequence[Mapping[str, Array]]
) -> Iterator[SoughtNumber]:
    """Yield numbers of an outcome by their names, those that no point has left out.

    Parameters
    ----------
    outcome
        Outcome of a study.
    words
        Name -> symbol, unit and meaning, in their order.
    answers
        Name -> numbers along the loads of a point, for each solved point.
    """
    study = outcome.study
    one_each = bool(answer_of(study.problem).headline)
    given = {one.name for one in inputs(study)}
    swept = bool(study.axes) or not one_each
    end = _end(outcome, given)
    for name, entry in words.items():
        each = [np.ravel(one[name]) for one in answers if name in one]
        if not each:
            continue
        # of each point of a sweep that at its end
        numbers = np.array([_last(one) for one in each]) if study.axes and one_each else np.concatenate(each)
        finite = numbers[~np.isnan(numbers)]
        if not finite.size or (np.isnan(numbers[-1]) and not swept):
            continue
        low, high = float(np.min(finite)), float(np.max(finite))
        prescribed = name_in_words(name) in given
        places: tuple[str, ...] = ()
        trend = ""
        if study.axes and finite.size == len(outcome.solved):
            places, trend = _places(outcome, numbers)
        last, many = float(finite[-1]), low != high
        yield SoughtNumber(name, entry, last, low, high, prescribed, many, swept, end, places, trend)


def _last(numbers: Array) -> float:
    """Return the last number of a point; of what returns to zero the one that is farthest from it."""
    finite = numbers[~np.isnan(numbers)]
    if not finite.size:
        return math.nan
    return float(finite[-1] if finite[-1] != 0.0 else finite[np.argmax(np.abs(finite))])


def _end(outcome: Outcome, given: set[str]) -> str:
    """Return where the last number of a single point holds."""
    answers = outcome.solved[-1].answers if outcome.solved else {}
    for name in ALONG_A_PATH:
        if name in answers:
            passed = float(np.ravel(answers[name])[-1])
            return f"after {with_unit(passed, outcome.word(name).unit)}{AFTER[name]}" if name in AFTER else "at the end"
    for name, numbers in answers.items():
        many = np.ravel(numbers)
        if name_in_words(name) in given and many.size > 1 and np.min(many) < np.max(many):
            if many[-1] == 0.0 or any(np.ravel(one.answers[name])[-1] != many[-1] for one in outcome.solved):
                return "at the end"
            return f"at the last {name_in_words(name)}, {with_unit(float(many[-1]), outcome.word(name).unit)},"
    return f"at the last of {max(map(np.size, answers.values()), default=0)} points"


def _places(outcome: Outcome, numbers: Array) -> tuple[tuple[str, ...], str]:
    """Return where the least and the greatest number of a sweep are, and whether they rise or fall between the ends."""
    study, solved = outcome.study, outcome.solved
    if study.design.draws or len(study.axes) > MOST_PLACES:
        return (), ""
    least, most = int(np.argmin(numbers)), int(np.argmax(numbers))
    places = tuple(settings_text(study, solved[place].settings) for place in (least, most))
    numeric = len(study.axes) == 1 and all(isinstance(one.settings[0], int | float) for one in solved)
    if not numeric:
        return places, ""
    return places, "rises" if np.all(numbers[1:] >= numbers[:-1]) else "falls" if np.all(
        numbers[1:] <= numbers[:-1]
    ) else ""
