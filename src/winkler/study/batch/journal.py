"""The journal of a sweep, or of a batch of fits: its results, recorded beside the folder of results while it runs.

A text file to which lines are only appended: first one that identifies the study, then one for each point of a sweep,
or for each file or curve of a batch, each with a checksum in front.  A run that was killed leaves it behind; the same
study is continued from it, without solving a point twice.  An incomplete last line is dropped.  The journal is removed
when the results are written.
"""

from __future__ import annotations

import contextlib
import hashlib
import itertools
import json
import os
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.io.processes.locking import lock
from winkler.io.software import software
from winkler.io.whole_file import unwritable
from winkler.study.batch.checkpoint import refuse_other_software
from winkler.study.language.canonical import digest, how_fitted, plain
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis
from winkler.values.errors import InvalidInput

if TYPE_CHECKING:
    from winkler.study.language.fit_study import FitStudy


ENDING = ".journal"


class Journal:
    """The journal of one study.

    Parameters
    ----------
    path
        The file; it is made when the first line is written.
    study
        What is solved, or fitted.
    """

    def __init__(self, path: Path, study: Study | FitStudy) -> None:
        self.path = path
        self.count = 0
        """Number of recorded lines, without those of points that are tried again: see `is_final`."""
        self.complete = True
        """Whether nothing is left to do; else a later run continues from here."""
        self._head = _head(study)
        self._file = -1
        self._recorded = 0

    @classmethod
    def beside(cls, results: Path, study: Study | FitStudy) -> Journal:
        """Return the journal beside a folder of results."""
        return cls(results.parent / f".{results.name}{ENDING}", study)

    def __enter__(self) -> Journal:
        """Read the lines of an earlier run, and prepare to append to them.

        Raises
        ------
        InvalidInput
            If the journal is of another study, is damaged, or another run is writing it.
        """
        if self.path.exists():
            self._open(os.O_RDWR)
            self._read()
        return self

    def __exit__(self, *_: object) -> None:
        """Leave the journal for a later run, unless it was removed."""
        self._close()

    def recalled(self) -> Iterator[dict[str, Any]]:
        """Yield the content of the lines of an earlier run."""
        recorded, self._recorded = self._recorded, 0
        if recorded:
            with self.path.open("rb") as file:
                for line in itertools.islice(file, 1, recorded + 1):
                    yield _content(line)

    def _read(self) -> None:
        with self.path.open("rb") as file:
            valid_bytes = 0
            for number, line in enumerate(file):
                content = _content(line)
                if content is None:
                    if file.read(1):
                        raise self._unusable(f"is spoilt in line {number + 1}")
                    break
                if number == 0:
                    self._refuse_other(content)
                valid_bytes += len(line)
                self._recorded = number
                self.count += number > 0 and is_final(content)
        os.ftruncate(self._file, valid_bytes)
        os.lseek(self._file, 0, os.SEEK_END)
        if not valid_bytes:
            self._write(json.dumps(self._head))

    def _refuse_other(self, head: Any) -> None:
        """Refuse the journal of other software, or of another study."""
        try:
            refuse_other_software(f"journal: '{self.path}'", head.get("software") if isinstance(head, dict) else None)
        except InvalidInput:
            self._close()
            raise
        if head != self._head:
            what = "curves" if "fit" in head else "points"
            raise self._unusable(f"holds {what} of another study, or of another version of this one")

    def write(self, text: str, *, final: bool = True) -> None:
        """Append the result of one point, or of one file or curve; a point that is not `final` is tried again later."""
        if self._file < 0:
            self._open(os.O_RDWR | os.O_CREAT | os.O_EXCL)
            self._write(json.dumps(self._head))
        self._write(text)
        self.count += final

    def remove(self) -> None:
        """Remove the journal; nothing happens if there is none.

        Raises
        ------
        InvalidInput
            If another run is writing it.
        """
        if self._file < 0 and self.path.exists():
            self._open(os.O_RDWR)
        self._close()
        self.count = 0
        with contextlib.suppress(OSError):
            self.path.unlink(missing_ok=True)

    @property
    def size(self) -> int:
        """How much of the disk it takes [bytes]."""
        return os.fstat(self._file).st_size if self._file >= 0 else 0

    def _close(self) -> None:
        if self._file >= 0:
            os.close(self._file)
            self._file = -1

    def _open(self, flags: int) -> None:
        try:
            self._file = os.open(self.path, flags | getattr(os, "O_BINARY", 0), 0o644)
        except FileExistsError:
            raise self._in_use() from None
        except OSError as error:
            why = (error.strerror or type(error).__name__).lower()
            raise InvalidInput(f"journal: '{self.path}' cannot be opened ({why}); give another folder.") from None
        try:
            lock(self._file)
        except BlockingIOError:
            self._close()
            raise self._in_use() from None

    def _write(self, text: str) -> None:
        data = text.encode()
        line = b"%08x %s\n" % (zlib.crc32(data), data)
        try:
            while line:
                line = line[os.write(self._file, line) :]
        except OSError as error:
            raise unwritable(self.path, error, option="folder with --output") from None

    def _in_use(self) -> InvalidInput:
        return InvalidInput(
            f"journal: another run is writing '{self.path}'; wait for its end, or give another folder with --output."
        )

    def _unusable(self, why: str) -> InvalidInput:
        self._close()
        return InvalidInput(
            f"journal: '{self.path}' {why}; add --anew to begin again without it, or give another folder with --output."
        )


def is_final(content: dict[str, Any]) -> bool:
    """Return whether the result of a line is final: a point with an unexpected error is tried again."""
    return "traceback" not in content


def _content(line: bytes) -> Any:
    """Return the content of a line; None if it is incomplete."""
    mark, _, data = line.partition(b" ")
    if not line.endswith(b"\n") or mark != b"%08x" % zlib.crc32(data[:-1]):
        return None
    return json.loads(data)


def _head(study: Study | FitStudy) -> dict[str, Any]:
    """Return the content of the first line: equal heads mean equal points, expectations and numbers."""
    made = {"journal of": "winkler", "software": software()}
    if not isinstance(study, Study):
        return {**made, "fit": _hash([how_fitted(study), str(study.time_limit)])}
    drawn_points = [_drawn(axis) for axis in study.axes] if study.design.draws else []
    return {
        **made,
        "question": digest(study),
        "points": _hash(drawn_points),
        "expect": _hash([plain(item) for item in study.expect]),
    }


def _drawn(axis: Axis) -> Any:
    """Return the values of an axis, or if there may be a million numbers, the hash of all their digits."""
    if not axis.numeric:
        return plain(axis)
    return [axis.key, hashlib.sha256(np.array(axis.values, dtype="<f8").tobytes()).hexdigest()]


def _hash(content: Any) -> str:
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
