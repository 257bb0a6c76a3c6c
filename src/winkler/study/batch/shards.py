"""Shards of a sweep: parts that are solved by themselves, such as the jobs of an array, and put together later.

The points of a shard are recorded in a journal of its own beside the folder of results.  Put together, the lines of all
journals are those of one run that was stopped at its end.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from winkler.numerics.types import Array
from winkler.study.batch.journal import Journal
from winkler.study.language.study import Study
from winkler.values.errors import InvalidInput
from winkler.values.value import value

MOST_SHARDS = 100_000
WRITTEN = re.compile(r"\s*(\d{1,6})\s*/\s*(\d{1,6})\s*", re.ASCII)


@value
class Shard:
    """One of equal parts of a sweep.

    Parameters
    ----------
    number, count
        Which part, from one, and how many there are.
    """

    number: int
    count: int

    def __post_init__(self) -> None:
        if not 1 <= self.number <= self.count <= MOST_SHARDS:
            raise InvalidInput(
                f"shard: {self.number}/{self.count} is no part; give its number from 1 and how many there are, such as "
                f"2/8, at most {MOST_SHARDS}."
            )

    @classmethod
    def read(cls, text: str) -> Shard:
        """Return the shard that a text such as ``2/8`` means.

        Raises
        ------
        InvalidInput
            If it is none.
        """
        match = WRITTEN.fullmatch(text)
        if match is None:
            raise InvalidInput(f"shard: '{text}' is no part of a sweep; give its number and how many, such as 2/8.")
        return cls(int(match[1]), int(match[2]))

    def others(self, size: int) -> Array:
        """Return which of the points of a sweep belong to other shards, ``(size,)`` of bool.

        A shard has each `count`-th point, so that costly ends of an axis are shared.
        """
        others: Array = np.arange(size) % self.count != self.number - 1
        return others

    def beside(self, results: Path) -> Path:
        """Return the folder beside which its records lie."""
        return results.with_name(f"{results.name}.shard-{self.number}-of-{self.count}")


def shards_beside(results: Path) -> list[Path]:
    """Return the folders beside which the journals of shards lie, in the order of their names."""
    found = results.parent.glob("*.journal") if results.parent.is_dir() else ()
    name = re.compile(rf"\.({re.escape(results.name)}\.shard-\d+-of-\d+)\.journal")
    return sorted(path.with_name(match[1]) for path in found if (match := name.fullmatch(path.name)))


def put_together(study: Study, results: Path) -> list[Journal]:
    """Record in the journal of a study what its shards have solved.

    Parameters
    ----------
    study
        The study.
    results
        Folder of its results.

    Returns
    -------
    list of Journal
        Those of the shards, which are to be removed when the results are written.

    Raises
    ------
    InvalidInput
        If points are in no shard, or a shard is of another study or still being solved.
    """
    parts = [Journal.beside(one, study) for one in shards_beside(results)]
    with Journal.beside(results, study) as whole:
        known = {place for place, _ in _lines(study, whole)}
        before = set(known)
        for part in parts:
            with part:
                known |= {place for place, _ in _lines(study, part)}
        if missing := study.size - len(known):
            first = next(place for place in range(study.size) if place not in known)
            raise InvalidInput(
                f"merge: {missing} of {study.size} points are in none of the {len(parts)} shards beside '{results}'; "
                f"solve the others first: the first of these points is that of --shard {_asked(parts, first)}."
            )
        for part in parts:
            with part:
                for place, line in _lines(study, part):
                    if place not in before:
                        before.add(place)
                        whole.write(line)
    return parts


def _lines(study: Study, journal: Journal) -> Iterator[tuple[int, str]]:
    """Yield the places of recorded points, and their lines."""
    for content in journal.recalled():
        place = int(np.ravel_multi_index(content["at"], study.shape)) if study.shape else 0
        yield place, json.dumps(content, separators=(",", ":"), ensure_ascii=False)


def _asked(parts: list[Journal], place: int) -> str:
    """Return the shard of a point, as it is asked for."""
    counts = [int(part.path.name.removesuffix(".journal").rpartition("-")[2]) for part in parts]
    return f"{place % counts[-1] + 1}/{counts[-1]}" if counts else "1/8, 2/8 and so on"
