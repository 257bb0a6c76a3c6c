"""What a file is taken for, as the terminal and the app show it: columns, what was done, what is doubtful."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.rough.plausibility import without_marks
from winkler.values.readable import with_unit
from winkler.values.value import value
from winkler.values.vocabulary import GLOSSARY, Word, own_word

BARS = "▁▂▃▄▅▆▇█"
SPARKLINE_POINTS = 32
"""Numbers of a column in its sparkline."""
DRAWN_POINTS = 200
"""Numbers of a column in a picture."""
SPIKE_NOISES, SPIKE_SHARE = 30.0, 0.2
"""Least distance of a spike from both neighbours, in standard deviations of such distances and in parts of the range
of the column without it."""
FEWEST_FOR_SPIKES = 20
GAP_STEPS, FEWEST_FOR_GAPS = 100.0, 50
"""Least gap of a time in median steps, and fewest rows among which one is named."""
DEEPEST_LEVEL = 3
"""How many values within each other are looked through for columns."""
NOT_SHOWN = ("direction", "marks")


def thinned(samples: Array, most: int) -> Array:
    """Return at most so many samples ``(m,)``, spread evenly."""
    if samples.size <= most:
        return samples
    return np.asarray(samples[np.linspace(0, samples.size - 1, most).round().astype(int)])


@value
class InspectedColumn:
    """One column of a file.

    Parameters
    ----------
    name : str
        As its class calls it.
    symbol, unit, meaning : str
        Of the glossary; the unit is that of SI.
    values : ndarray, (n,)
        In SI units.
    """

    name: str
    symbol: str
    unit: str
    meaning: str
    values: Array

    @property
    def finite(self) -> Array:
        """The values that are numbers."""
        return np.asarray(self.values[np.isfinite(self.values)])

    @property
    def low(self) -> float:
        """The least value; nan without one."""
        return float(self.finite.min()) if self.finite.size else float("nan")

    @property
    def high(self) -> float:
        """The greatest value; nan without one."""
        return float(self.finite.max()) if self.finite.size else float("nan")

    @property
    def range(self) -> str:
        """The least and the greatest value as text."""
        return f"{with_unit(self.low, self.unit, 4)} to {with_unit(self.high, self.unit, 4)}"

    @property
    def sparkline(self) -> str:
        """The values in the order of the file, as bars of eight heights; blank where there is no number."""
        shown = thinned(self.values, SPARKLINE_POINTS)
        span = self.high - self.low
        if not np.isfinite(span):
            return ""
        level = (shown - self.low) / span if span > 0.0 else np.full(shown.size, 0.5)
        return "".join(BARS[min(int(8.0 * one), 7)] if np.isfinite(one) else " " for one in level.tolist())

    def doubts(self, *, recorded: bool) -> Iterator[str]:
        """Yield what its numbers can hardly be, one sentence each.

        Parameters
        ----------
        recorded : bool
            Whether its rows were taken one after the other, so that spikes and gaps are sought as well.
        """
        if self.values.size > self.finite.size:
            yield f"{self.name}: {self.values.size - self.finite.size} of {self.values.size} numbers are missing."
        numbers = self.finite
        if numbers.size < 2:
            return
        if float(np.ptp(numbers)) == 0.0:
            yield f"{self.name}: all {numbers.size} numbers are {with_unit(self.low, self.unit, 4)}."
            return
        _, marks = without_marks(numbers)
        for mark in marks.tolist():
            count = int(np.count_nonzero(numbers == mark))
            yield (
                f"{self.name}: {count} of {numbers.size} numbers are {with_unit(mark, self.unit, 5)}, which "
                "instruments write for a missing one; delete these rows, or write nan."
            )
        if not recorded:
            return
        yield from self._spikes(numbers if not marks.size else numbers[~np.isin(numbers, marks)])
        if self.unit == "s" and numbers.size >= FEWEST_FOR_GAPS:
            steps = np.diff(numbers)
            usual, longest = float(np.median(steps)), int(np.argmax(steps))
            if usual > 0.0 and steps[longest] > GAP_STEPS * usual:
                yield (
                    f"{self.name}: a gap of {with_unit(float(steps[longest]), 's', 3)} behind row {longest + 1}, where "
                    f"steps are {with_unit(usual, 's', 3)}."
                )

    def _spikes(self, numbers: Array) -> Iterator[str]:
        if numbers.size < FEWEST_FOR_SPIKES:
            return
        middle = np.median(np.stack([numbers[:-2], numbers[1:-1], numbers[2:]]), axis=0)
        off = np.abs(numbers[1:-1] - middle)
        noise = 1.4826 * float(np.median(off))
        others = float(np.ptp(middle))
        spikes = np.flatnonzero((off > SPIKE_NOISES * noise) & (off > SPIKE_SHARE * others)) + 1
        if spikes.size:
            rows = ", ".join(str(one + 1) for one in spikes[:5].tolist()) + " ..." * (spikes.size > 5)
            yield (
                f"{self.name}: {spikes.size} single number{'s' * (spikes.size > 1)} far from both neighbours (row "
                f"{rows}), the first {with_unit(float(numbers[spikes[0]]), self.unit, 4)}."
            )

    def table(self) -> dict[str, Any]:
        """Return it as a table for JSON, without its values."""
        words = {"name": self.name, "symbol": self.symbol, "unit": self.unit, "meaning": self.meaning}
        return {**words, "count": self.values.size, "low": _or_none(self.low), "high": _or_none(self.high),
                "sparkline": self.sparkline}  # fmt: skip


@value
class InspectedNumber:
    """One number that a file gives as a whole, such as the roughness of a map, in SI units."""

    name: str
    symbol: str
    value: float
    unit: str
    meaning: str

    def table(self) -> dict[str, Any]:
        """Return it as a table for JSON."""
        return {"symbol": self.symbol, "value": self.value, "unit": self.unit, "meaning": self.meaning}


@value
class Inspection:
    """What one file is taken for.

    Parameters
    ----------
    file : str
        Its path.
    taken_for : str
        A kind of file, such as "force curve"; empty where it cannot be read.
    reason : str
        Why it is taken for that, and how it was read; of a file that cannot be read, what is missing.
    count : int
        How many curves, maps or tables it holds.
    columns : tuple of InspectedColumn
        Of the first of these.
    numbers : tuple of InspectedNumber
    done : tuple of str
        What was done to it: segments, events, drift, touch, one line each.
    doubts : tuple of str
        What is doubtful, one sentence each.
    study : str
        A study to start from, whose file stands beside it; empty where there is none.
    content : object
        What was read; None where it cannot be read, and in lists of files.
    """

    file: str
    taken_for: str
    reason: str
    count: int = 1
    columns: tuple[InspectedColumn, ...] = ()
    numbers: tuple[InspectedNumber, ...] = ()
    done: tuple[str, ...] = ()
    doubts: tuple[str, ...] = ()
    study: str = ""
    content: Any = None

    @property
    def is_read(self) -> bool:
        """Whether it could be read."""
        return bool(self.taken_for)

    def column(self, name: str) -> InspectedColumn:
        """Return a column by its name."""
        return next(one for one in self.columns if one.name == name)

    def table(self) -> dict[str, Any]:
        """Return it as a table for JSON."""
        return {
            "file": self.file,
            "taken_for": self.taken_for,
            "reason": self.reason,
            "count": self.count,
            "columns": [one.table() for one in self.columns],
            "statistics": {one.name: one.table() for one in self.numbers},
            "done": list(self.done),
            "remarks": list(self.doubts),
            "study": self.study,
        }


def columns_of(content: Any, level: int = 0) -> tuple[InspectedColumn, ...]:
    """Return the columns of a value: its rows of numbers, and those of the values in it; of a map its middle row.

    Parameters
    ----------
    content
        A value of the package.
    """
    found: list[InspectedColumn] = []
    if level > DEEPEST_LEVEL or not dataclasses.is_dataclass(content) or isinstance(content, type):
        return ()
    for field in dataclasses.fields(content):
        part = getattr(content, field.name)
        if isinstance(part, np.ndarray) and part.size > 1 and part.dtype.kind == "f" and field.name not in NOT_SHOWN:
            word = own_word(type(content), field.name) or GLOSSARY.get(field.name, Word("", "", ""))
            row = part[part.shape[0] // 2] if part.ndim > 1 else part
            if part.ndim <= 2 and word.unit is not None and row.size > 2 * (level == 0):
                meaning = word.meaning + ", its middle row" * (part.ndim > 1)
                found.append(InspectedColumn(field.name, word.symbol, word.unit, meaning, row.astype(float)))
        else:
            found += columns_of(part, level + 1)
    return tuple(found)


def _or_none(number: float) -> float | None:
    return number if np.isfinite(number) else None
