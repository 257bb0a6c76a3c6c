"""The outcome of a study, from which tables, archives, figures and the report are made.

::

    outcome.study                 the `Study` that was run (title, problem, sweep, design, fields, output, expect)
    outcome.points                one `Solved` or `Failed` per point of the sweep, in its order (one without a sweep);
                                  `Recalled` if the solution was not kept, which then is computed again on request
    outcome.solved, .failed       the same, apart
    outcome.verdicts              one `ComparedNumber` for every [[expect]] at every solved point
    outcome.provenance            `Provenance`: version, hash of the study, time, versions of what computed
    outcome.validity              the notes of all points, each kind of statement once, in its worst standing
    outcome.shape                 number of points along each dimension of the sweep
    outcome.table()               `Column` after `Column`: a long table with one row per load; swept keys, then answers
    outcome.readable_table()      the same as readers are shown it, with zero for what is rounding alone
    outcome.answers               names of the answers (depth, force, ...), as in the glossary
    outcome.indices               `Indices` of every answer, if the design is sensitivity: what makes it scatter
    outcome.answer("depth")       the same numbers as an array of shape ``shape + (loads,)``, NaN where a point failed

    point.index, point.settings   place in the sweep, and the values of its keys there (in the order of study.sweep)
    point.problem, point.solution
    point.answers                 name -> numbers of shape (loads,)
    point.readable                the same, with zero for what is rounding alone
    point.each                    the solution load by load: one scalar solution for every load
    point.surface                 SurfaceFields of every load, in the order of `each`; empty unless [fields] has r
    point.subsurface              SubsurfaceFields of every load; empty unless [fields] has r and z

Numbers are SI.  Symbols, units and meanings come from `winkler.values.vocabulary`.
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.numerics.types import Array, Quantity
from winkler.study.batch.points import ComparedNumber, Failed, Point, SolvedPoint
from winkler.study.language import keys
from winkler.study.language.designs import Sensitivity
from winkler.study.language.study import Study
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing, worst_of_each
from winkler.values.value import value
from winkler.values.vocabulary import Word, word

if TYPE_CHECKING:
    from winkler.study.batch.sensitivity import Indices


def answers_of(solution: Any) -> dict[str, Quantity]:
    """Return the numbers of a solution: every public field or property to which the glossary gives a unit.

    Returns
    -------
    dict
        Name -> float or array in SI units, in the order in which the class states them, without those that it names in
        ``other_axes`` (`winkler.problems.answer.Solution`) and those of another shape than the first;
        for these see `winkler.study.batch.events`.  A vector in the plane gives two
        answers: ``shift_x``, ``shift_y``.
    """
    answers: dict[str, Quantity] = {}
    rows: tuple[int, ...] | None = None
    for name in number_names(solution.__class__):
        try:
            content = getattr(solution, name)
        except OutsideValidity:  # a quantity that this medium does not have
            continue
        if isinstance(content, int | float):
            answers[name] = float(content) + 0.0  # no minus before a zero
        elif isinstance(content, np.ndarray) and content.dtype.kind in "bfiu":
            rows = content.shape if rows is None else rows
            if content.shape == rows:
                answers[name] = np.asarray(content, dtype=float) + 0.0
            elif content.shape == (*rows, 2) and _has_unit(solution.__class__, f"{name}_x"):
                answers |= {f"{name}_{axis}": content[..., place] + 0.0 for place, axis in enumerate("xy")}
    return answers


@functools.cache
def number_names(cls: type[Any]) -> tuple[str, ...]:
    """Return the names of the numbers of a class of solutions: its fields, then its properties."""
    names = [field.name for field in dataclasses.fields(cls)]
    for base in reversed(cls.__mro__):
        names += [name for name, member in vars(base).items() if isinstance(member, property)]
    others = getattr(cls, "other_axes", ())
    return tuple(name for name in dict.fromkeys(names) if name not in others and _has_unit(cls, name))


def _has_unit(cls: type, name: str) -> bool:
    try:
        return not name.startswith("_") and word(cls, name).unit is not None
    except KeyError:
        return False


@value
class ResultColumn:
    """A column of the table of answers.

    Parameters
    ----------
    name
        Key of the sweep (``problem.load.force``), name of an answer (``depth``), or ``failure``.
    word
        Symbol, unit and meaning; the unit is None for text.
    content : ndarray, shape (rows,)
        Numbers in SI units, or text.
    """

    name: str
    word: Word
    content: np.ndarray


@value
class Provenance:
    """Provenance of the numbers.

    Parameters
    ----------
    version
        Version of winkler.
    hash
        SHA-256 of the canonical form of problem, sweep, design and fields: equal hashes mean equal numbers.
    created
        Time of the run in UTC, ISO 8601.
    seconds
        Duration [s].
    packages
        ``(name, version)`` of Python and of the packages that computed.
    source
        Name of the study file, without its folder; empty for a study made in Python.
    sources
        Digest of the sources of winkler: the version alone does not tell what was changed.
    """

    version: str
    hash: str
    created: str
    seconds: float
    packages: tuple[tuple[str, str], ...]
    source: str = ""
    sources: str = ""

    def attributes(self, title: str, study: str) -> dict[str, Any]:
        """Return the attributes of a NetCDF file that state its origin, with the title and the text of the study."""
        return {
            "Conventions": CONVENTIONS,
            "title": title,
            "history": f"{self.created}: written by winkler {self.version}",
            "program": "winkler",
            "winkler_version": self.version,
            "winkler_sources": self.sources,
            "study_hash": self.hash,
            "study": study,
            "study_file": self.source,
            "created": self.created,
            "seconds": self.seconds,
            **{f"{name}_version": number for name, number in self.packages if name != "winkler"},
        }


CONVENTIONS = "CF-1.11"
"""Version of the conventions of climate and forecast (cfconventions.org) that NetCDF files follow."""


def _yields(note: Note) -> bool:
    return note.assumption is Assumption.ELASTIC and note.standing is Standing.OUTSIDE


@value
class Outcome:
    """The outcome of a study; see the module for its parts."""

    study: Study
    points: tuple[Point, ...]
    verdicts: tuple[ComparedNumber, ...]
    provenance: Provenance

    @functools.cached_property
    def solved(self) -> tuple[SolvedPoint, ...]:
        """The points that were solved, in the order of the sweep."""
        return tuple(point for point in self.points if not isinstance(point, Failed))

    @functools.cached_property
    def failed(self) -> tuple[Failed, ...]:
        """The points that have no answer, in the order of the sweep."""
        return tuple(point for point in self.points if isinstance(point, Failed))

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of points along each dimension of the sweep; ``()`` without a sweep."""
        return self.study.shape

    @functools.cached_property
    def validity(self) -> tuple[Note, ...]:
        """The notes of all points; of statements that differ in their numbers only, the worst.

        Where bodies yield at some points, it is not stated that they stay elastic at others.
        """
        yields = [any(_yields(note) for note in point.validity) for point in self.solved]
        each = {
            (note.standing, note.statement): note
            for point, yielded in zip(self.solved, yields, strict=True)
            for note in point.validity
            if yielded or not any(yields) or note.assumption is not Assumption.ELASTIC
        }
        return worst_of_each(each.values())

    @functools.cached_property
    def answers(self) -> tuple[str, ...]:
        """Names of the answers, in the order of the solution."""
        return tuple(dict.fromkeys(name for point in self.solved for name, _ in point.found))

    def answer(self, name: str) -> Array:
        """Return one answer, shape ``shape + (loads,)``, SI; NaN where a point failed or has fewer loads."""
        collected = [
            (point.index, numbers[name])
            for point, numbers in zip(self.points, self._numbers, strict=True)
            if name in numbers
        ]
        result = np.full((*self.shape, max((len(numbers) for _, numbers in collected), default=1)), np.nan)
        for index, numbers in collected:
            result[index][: len(numbers)] = numbers
        return result

    @functools.cached_property
    def indices(self) -> tuple[Indices, ...]:
        """Indices of Sobol of each answer for every key; none unless the design is a `Sensitivity`."""
        if not isinstance(self.study.design, Sensitivity):
            return ()
        from winkler.study.batch.sensitivity import sensitivity

        return sensitivity(self.study, {name: self.answer(name) for name in self.answers})

    @functools.cached_property
    def _numbers(self) -> tuple[dict[str, Array], ...]:
        """Answers of every point; none where there is no answer."""
        return tuple({} if isinstance(point, Failed) else point.answers for point in self.points)

    def word(self, name: str) -> Word:
        """Return symbol, unit and meaning of an answer or of a swept key."""
        if any(line.key == name for line in self.study.sweep):
            return keys.word_at(self.study, name)
        having = (point for point in self.solved if any(name == one for one, _ in point.found))
        owner = next((point.answer_type for point in having), type(None))
        return word(owner, name)

    def table(self) -> tuple[ResultColumn, ...]:
        """Return the long table, one row per point and load: swept keys, answers, and failures if there are any."""
        return self._table

    def readable_table(self) -> tuple[ResultColumn, ...]:
        """Return `table` as readers are shown it: with zero for what is rounding alone."""
        return self._columns([{} if isinstance(point, Failed) else point.readable for point in self.points])

    @functools.cached_property
    def _table(self) -> tuple[ResultColumn, ...]:
        return self._columns(self._numbers)

    def _columns(self, numbers: Sequence[dict[str, Array]]) -> tuple[ResultColumn, ...]:
        counts = [max((len(content) for content in collected.values()), default=1) for collected in numbers]
        columns = []
        for place, axis in enumerate(self.study.sweep):
            content = _repeated([point.settings[place] for point in self.points], counts)
            entry = self.word(axis.key)
            if all(isinstance(item, int | float) for item in content):
                columns.append(ResultColumn(axis.key, entry, np.array(content, dtype=float)))
            else:
                labels = np.array([keys.label(item, entry.unit) for item in content])
                columns.append(ResultColumn(axis.key, entry._replace(unit=None), labels))
        for name in self.answers:
            parts = [
                collected.get(name, np.full(count, np.nan)) for collected, count in zip(numbers, counts, strict=True)
            ]
            columns.append(ResultColumn(name, self.word(name), np.concatenate(parts)))
        if self.failed:
            reasons = [point.reason if isinstance(point, Failed) else "" for point in self.points]
            columns.append(
                ResultColumn(
                    "failure", Word("", None, "why a point has no answer"), np.array(_repeated(reasons, counts))
                )
            )
        return tuple(columns)


def _repeated(items: list[Any], counts: list[int]) -> list[Any]:
    return [item for item, count in zip(items, counts, strict=True) for _ in range(count)]
