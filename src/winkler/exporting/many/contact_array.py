"""Millions of contacts of one law, each with its memory, moved in place on all cores.

The file of a `ContactArray`: one line of JSON, the arrays as they are in memory, and a checksum.

Files of NumPy are read within limits that ten million contacts exceed; here the line and the size of the file state
what is read before it is.
"""

from __future__ import annotations

import json
import math
import os
import struct
import sys
import zlib
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import IO, Any

import numpy as np

from winkler.exporting.many.array_inputs import checked_depth_of, checked_entry
from winkler.exporting.many.contact_store import PRECISIONS, ContactStore
from winkler.exporting.many.stacked_laws import stacked_laws
from winkler.io.foreign import reader
from winkler.io.text_file import existing
from winkler.io.whole_file import written_whole
from winkler.numerics.threads import run_in_threads
from winkler.values.checks.number_checks import POSITIVE, Whole, checked
from winkler.values.errors import InvalidInput

TABLE_TOLERANCE = 1e-9
"""By how much tables of a law may differ from those in a file, which another machine may have computed."""


class ContactArray(ContactStore):
    """Many contacts of one law, stored in arrays that `step` changes in place, on all cores.

    A step uses the same kernel that `export` writes in other languages. In contrast to other winkler objects this one
    is mutable: a step of ten million contacts makes no copy.

    Parameters
    ----------
    law
        A problem that `export` supports: `Indentation`, `ContactLaw`, `Tangential`, `AdhesiveCycle`,
        `ElasticPlasticParticle`, `ViscoelasticIndentation` or `Contacts`.  A list of problems of one form, or
        `Contacts` with different properties, define several types of contacts.
    size : int, optional
        Number of contacts.
    kind : ndarray, (n,), optional
        Index of the law of each contact, from 0 on. Not needed if there is one law, or one for each contact.
    answers : tuple of str, optional
        Names of the results to store, from `names`; all by default.
    precision : str, optional
        Precision of the stored springs: "double", or "single" with half the memory. All other numbers are double.
    tolerance : float, optional
        Maximum error of a tabulated normal force, relative to the maximum force.
    count : int, optional
        Number of springs of a `Tangential` or `ViscoelasticIndentation`.

    Raises
    ------
    InvalidInput
        If the law is not supported, a number is out of range, or the contacts need more memory than is free.

    Examples
    --------
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.problems.particles.contacts import Contacts
    >>> glass = HalfSpace.between(Elastic(70e9, 0.22), Elastic(70e9, 0.22))
    >>> bead = Contacts.apart(glass, curvature_radius=1e-3, coefficient=0.3, reach=2e-6, count=8)
    >>> beads = ContactArray(bead, 3, answers=("force", "shear_x", "shear_y"))
    >>> beads.step([1e-6, 0.5e-6, -1e-6], motion=(0.5e-6, 0.0))
    >>> (beads.answer("shear_x") / np.maximum(beads.answer("force"), 1e-9)).round(3)
    array([0.3  , 0.302, 0.   ])
    >>> beads.bytes_for(10_000_000) / 10_000_000
    192.0000072
    """

    def __init__(
        self,
        law: Any,
        size: int = 0,
        *,
        kind: Any = None,
        answers: tuple[str, ...] | None = None,
        precision: str = "double",
        tolerance: float = 1e-6,
        count: int = 32,
    ) -> None:
        checked(POSITIVE, "ContactArray", "tolerance", tolerance)
        count = checked(Whole(2, what="springs"), "ContactArray", "count", count)
        laws = stacked_laws(law, tolerance=tolerance, count=count)
        super().__init__(laws, precision, answers)
        self._tables = laws.tables
        self.add(size, kind=kind)

    def step(
        self, depth: Any, *, motion: Any = None, twist: Any = None, roll: Any = None, duration: Any = None
    ) -> None:
        """Advance all contacts by one step, in which depth, motion, twist and roll change linearly in time.

        If an error is raised, nothing has changed.

        Parameters
        ----------
        depth : float or ndarray, (n,)
            Depth d [m] at the end of the step; zero or negative without contact.
        motion : ndarray, (n, 2) or (2,), optional
            Relative tangential displacement of the bodies in this step [m]; for laws with friction.
        twist : float or ndarray, (n,), optional
            Relative rotation about the normal in this step [rad]; for `Contacts`.
        roll : ndarray, (n, 2) or (2,), optional
            Relative rolling rotation in this step [rad]; for `Contacts`.
        duration : float or ndarray, (n,), optional
            Duration of the step [s], zero or at least 1e-60; required for viscoelastic bodies. Zero is a sudden step.
            For solids with a dashpot in parallel (Kelvin-Voigt), which cannot deform suddenly, the returned force is
            the static one.

        Raises
        ------
        InvalidInput
            If a shape does not agree, a number is not finite, or the law does not support an argument.
        OutsideValidity
            If a contact is pressed deeper than its law reaches; the message names it.
        """
        given = {"depth": depth, "motion": motion, "twist": twist, "roll": roll, "duration": duration}
        entries = self._laws.loop.entries
        for word, content in given.items():
            if content is not None and word not in entries:
                raise InvalidInput(f"ContactArray: this law has no input {word}; give {', '.join(entries)}.")
        if "duration" in entries and duration is None:
            raise InvalidInput("ContactArray: this law needs the duration of the step; give it in s, 0 if sudden.")
        columns = [checked_entry(word, 0.0 if given[word] is None else given[word], self.size) for word in entries]
        checked_depth_of(columns[0], self._laws.deepest, self._kind)
        loop, laws = self._laws.loop, self._laws
        kernel = loop.kernel.machine if loop.asks_for_memory else loop.kernel.uncounted
        state = list(self._state.values())

        def work(part: slice) -> None:
            scratch = [*laws.work(), *columns, np.zeros(len(laws.law.motion)), np.zeros(len(laws.law.answer))]
            kernel(part.start, part.stop, self._kind, *self._tables, *state, *scratch, self._kept, self._out)

        run_in_threads(work, self.size)

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Save all contacts with all digits. An existing file is replaced only after the new one is complete.

        Raises
        ------
        InvalidInput
            If there is no such folder, or its file cannot be written.
        """
        header = {
            "kernel": self._laws.law.kernel.__name__,
            "size": self.size,
            "precision": self.precision,
            "answers": self.answers,
            "shapes": [table.shape for table in self._tables],
        }
        return write_array_file(path, header, [*self._tables, self._kind, *self._state.values(), self._out])

    @classmethod
    @reader("a contact array")
    def restored(
        cls, law: Any, path: str | os.PathLike[str], *, tolerance: float = 1e-6, count: int = 32
    ) -> ContactArray:
        """Return the contacts of a file that `save` wrote; they continue with exactly the same numbers.

        Parameters
        ----------
        law, tolerance, count
            As in `ContactArray`; the same values as when the contacts were created.
        path : str or path

        Raises
        ------
        InvalidInput
            If the file is missing, broken, or holds contacts of another law.
        """
        file = ArrayFile(path)
        header = file.header
        size, kept = header.get("size"), header.get("answers")
        if not isinstance(size, int) or not 0 <= size < 2**40 or not isinstance(kept, list):
            raise file.refuse("its first line states no size or no answers")
        precision = header.get("precision")
        if precision not in PRECISIONS:
            raise file.refuse(f"its first line states the precision {precision!r}")
        made = cls(law, precision=precision, answers=tuple(map(str, kept)), tolerance=tolerance, count=count)
        shapes = [list(table.shape) for table in made._tables]
        other = InvalidInput(f"{file.path}: it holds contacts of another law; give the law that they were made with.")
        if header.get("kernel") != made._laws.law.kernel.__name__ or header.get("shapes") != shapes:
            raise other
        file.expect(made.bytes_for(size) + (made._kind.nbytes if made.kinds == 1 else 0))
        made.add(size, kind=0 if made.kinds > 1 else None)
        tables = tuple(np.zeros(table.shape) for table in made._tables)
        file.read_into([*tables, made._kind, *made._state.values(), made._out])
        if made._kind.size and not 0 <= made._kind.min() <= made._kind.max() < made.kinds:
            raise file.refuse("a contact is of a kind that is none")
        for mine, read in zip(made._tables, tables, strict=True):
            if not np.allclose(mine, read, rtol=TABLE_TOLERANCE, atol=0.0):
                raise other
        made._tables = tables
        return made


FORMAT = "winkler contact array 1"
HEADER_BYTES = 1_000_000
CHECKSUM = struct.Struct("<I")
PIECE_BYTES = 1 << 24
"""How much the checksum takes at once."""

Any_ = np.ndarray[Any, Any]


def write_array_file(path: str | os.PathLike[str], header: dict[str, Any], arrays: Sequence[Any_]) -> Path:
    """Write a header and arrays under a temporary name, which then replaces the file.

    Raises
    ------
    InvalidInput
        If it cannot be written.
    """
    line = {"format": FORMAT, "order": sys.byteorder, **header}
    with written_whole(Path(path)) as file:
        text = json.dumps(line).encode() + b"\n"
        file.write(text)
        total = zlib.crc32(text)
        for piece in _pieces(arrays):
            file.write(piece)
            total = zlib.crc32(piece, total)
        file.write(CHECKSUM.pack(total))
    return Path(path)


class ArrayFile:
    """A file that `write_array_file` wrote, opened: its header is checked, its arrays are not read yet.

    Parameters
    ----------
    path : str or path

    Raises
    ------
    InvalidInput
        If it is missing, or not such a file.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = existing(path, "a file of ContactArray.save")
        with self.path.open("rb") as file:
            self.line = file.readline(HEADER_BYTES)
        try:
            header = json.loads(self.line)
        except (ValueError, RecursionError):
            header = None
        if not isinstance(header, dict) or header.get("format") != FORMAT or header.get("order") != sys.byteorder:
            raise InvalidInput(f"{self.path}: it does not hold '{FORMAT}'; give a file of ContactArray.save.")
        self.header: dict[str, Any] = header

    def refuse(self, why: str) -> InvalidInput:
        """Return the sentence that refuses the file."""
        return InvalidInput(f"{self.path}: no contacts can be read from it ({why}); give a file of ContactArray.save.")

    def expect(self, byte_count: int) -> None:
        """Refuse the file if its arrays do not have so many bytes."""
        found = self.path.stat().st_size - len(self.line) - CHECKSUM.size
        if found != byte_count:
            raise self.refuse(f"its arrays have {max(found, 0)} bytes in place of {byte_count}")

    def read_into(self, arrays: Sequence[Any_]) -> None:
        """Fill arrays with those of the file; refuse it if the checksum does not agree."""
        self.expect(sum(array.nbytes for array in arrays))
        total = zlib.crc32(self.line)
        with self.path.open("rb") as file:
            file.seek(len(self.line))
            for piece in _pieces(arrays):
                _fill(file, piece)
                total = zlib.crc32(piece, total)
            if file.read(CHECKSUM.size) != CHECKSUM.pack(total):
                raise self.refuse("its checksum does not agree: it was changed or spoilt")


def _pieces(arrays: Iterable[Any_]) -> Iterable[memoryview]:
    """Return the bytes of arrays in memory, piece by piece."""
    for array in arrays:
        if math.prod(array.shape) == 0:
            continue
        whole = array.reshape(-1).view(np.uint8).data
        for start in range(0, len(whole), PIECE_BYTES):
            yield whole[start : start + PIECE_BYTES]


def _fill(file: IO[bytes], piece: memoryview) -> None:
    file.readinto(piece)  # type: ignore[attr-defined]
