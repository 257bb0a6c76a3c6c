"""What many contacts remember, in arrays: how much memory it takes, and how contacts come, go and change places."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.exporting.many.array_inputs import checked_places, whole_numbers
from winkler.exporting.many.stacked_laws import StackedLaws
from winkler.numerics.types import Array
from winkler.values.checks.free_memory import free_memory
from winkler.values.checks.number_checks import Whole, checked
from winkler.values.errors import InvalidInput, suggest

PRECISIONS = ("double", "single")
GIB = 2.0**30
Numbers = np.ndarray[Any, np.dtype[np.int64]]


class ContactStore:
    """The arrays of a `ContactArray`.

    Parameters
    ----------
    laws : StackedLaws
    precision : str
    answers : tuple of str, optional
        As of `ContactArray`.

    Raises
    ------
    InvalidInput
        If there is no such precision or answer.
    """

    def __init__(self, laws: StackedLaws, precision: str, answers: tuple[str, ...] | None) -> None:
        self._laws = laws
        if precision not in PRECISIONS or (precision == "single" and not laws.loop.springs):
            allowed = PRECISIONS if laws.loop.springs else PRECISIONS[:1]
            raise InvalidInput(f"ContactArray: there is no precision {precision!r} here; give {' or '.join(allowed)}.")
        self.precision = precision
        self.names: tuple[str, ...] = tuple(number.name for number in self._laws.law.answer)
        self.answers: tuple[str, ...] = (
            self.names if answers is None else (answers,) if isinstance(answers, str) else tuple(answers)
        )
        for name in self.answers:
            self._checked_name(name, self.names)
        self._kept = np.array([self.names.index(name) for name in self.answers], dtype=np.int64)
        self._begin = self._laws.parts(single=precision == "single")
        self._kind = np.zeros(0 if self._laws.kinds > 1 else 1, dtype=np.int64)
        self._state = {name: np.zeros((0, *part.shape), part.dtype) for name, part in self._begin.items()}
        self._out = np.zeros((0, len(self.answers)))
        self._size = 0

    def __repr__(self) -> str:
        """Return in a line how many contacts of which law these are."""
        return f"<{type(self).__name__} of {self.size} contacts: {self.title}>"

    @property
    def size(self) -> int:
        """How many contacts there are."""
        return self._size

    @property
    def kinds(self) -> int:
        """How many laws there are."""
        return self._laws.kinds

    @property
    def title(self) -> str:
        """What the law is."""
        return self._laws.law.title

    @property
    def notes(self) -> tuple[str, ...]:
        """What is assumed, and how far the law holds, in sentences."""
        return self._laws.law.notes

    def bytes_for(self, size: int) -> int:
        """Return how many bytes so many contacts take: memory, answers and kind of each, and the tables of the law.

        What goes into a step is an array of the caller, and is not counted.

        Parameters
        ----------
        size : int
        """
        size = checked(Whole(0, what="contacts"), "ContactArray", "size", size)
        each = sum(part.nbytes for part in self._begin.values()) + 8 * len(self.answers) + 8 * (self.kinds > 1)
        return size * each + sum(table.nbytes for table in self._laws.tables)

    def answer(self, name: str) -> Array:
        """Return one number of every contact after the last step, ``(size,)``; zero of those that made none.

        Parameters
        ----------
        name : str
            One of `answers`.

        Returns
        -------
        ndarray
            A view that the next step changes, and that cannot be written to.

        Raises
        ------
        InvalidInput
            If it is not kept.
        """
        self._checked_name(name, self.answers)
        return _read_only(self._out[:, self.answers.index(name)])

    def memory(self, name: str) -> Array:
        """Return what every contact remembers, ``(size, ...)``, as a view that cannot be written to.

        Parameters
        ----------
        name : str
            Such as "displaced" of the springs of `Contacts`; a wrong one is answered by all.
        """
        self._checked_name(name, tuple(self._state))
        return _read_only(self._state[name])

    def add(self, size: int = 1, *, kind: Any = None) -> Array:
        """Add contacts that do not touch yet, after all others; return their numbers.

        Parameters
        ----------
        size : int, optional
            How many.
        kind : int or ndarray, (size,), optional
            As of `ContactArray`.
        """
        size = checked(Whole(0, what="contacts"), "ContactArray", "size", size)
        before = self.size
        self._refuse_too_many(before + size)
        kinds = self._new_kinds(kind, size)
        self._take(np.concatenate([np.arange(before), np.full(size, -1)]), kinds)
        return np.arange(before, self.size)

    def remove(self, which: Any) -> Array:
        """Forget contacts; the others move up. Return the former numbers of those that remain, in their new order.

        Parameters
        ----------
        which : ndarray, (size,) of bool, or whole numbers
            Those that are forgotten.
        """
        remain = np.flatnonzero(~checked_places("which", which, self.size))
        self._take(remain, np.zeros(0, dtype=np.int64))
        return remain

    def renumber(self, order: Any, *, kind: Any = None) -> None:
        """Put contacts into another order, forget some, and make new ones: what follows a new list of neighbours.

        Parameters
        ----------
        order : ndarray of int
            The former number of every contact from now on; -1 where it is new.  Who is not in it is forgotten.
        kind : int or ndarray, (new ones,), optional
            As of `ContactArray`, of those that are new.

        Raises
        ------
        InvalidInput
            If a number is no contact, or stands there twice.
        """
        order = whole_numbers("order", order, -1, self.size)
        old = order[order >= 0]
        if old.size and int(np.bincount(old).max()) > 1:
            raise InvalidInput(
                f"ContactArray: order holds {int(np.argmax(np.bincount(old) > 1))} twice; give each contact once."
            )
        self._take(order, self._new_kinds(kind, order.size - old.size))

    def reset(self, which: Any) -> None:
        """Let contacts forget all that was: as if they had never touched.

        Parameters
        ----------
        which : ndarray, (size,) of bool, or whole numbers
        """
        meant = checked_places("which", which, self.size)
        for name, part in self._state.items():
            part[meant] = self._begin[name]
        self._out[meant] = 0.0

    def _new_kinds(self, kind: Any, size: int) -> Numbers:
        """Return the kinds of so many new contacts."""
        if self.kinds == 1:
            if kind is not None and np.any(np.asarray(kind) != 0):
                raise InvalidInput("ContactArray: there is one law, of the kind 0; leave kind out.")
            return np.zeros(size, dtype=np.int64)
        if kind is None and size not in (0, self.kinds):
            raise InvalidInput(
                f"ContactArray: there are {self.kinds} laws and {size} new contacts; give kind, the number of its law "
                "for each."
            )
        chosen = whole_numbers("kind", np.arange(size) if kind is None else np.atleast_1d(kind), 0, self.kinds)
        if chosen.size not in (1, size):
            raise InvalidInput(f"ContactArray: kind has the shape {chosen.shape} for {size} new contacts.")
        return np.array(np.broadcast_to(chosen, (size,))) if size else chosen[:0]

    def _take(self, order: Numbers, kinds: Numbers) -> None:
        """Put contacts into an order, with new ones of these kinds where it is -1."""
        self._refuse_too_many(order.size)
        new = np.flatnonzero(order < 0)
        for name, part in self._state.items():
            self._state[name] = _taken(part, order, new, self._begin[name])
        self._out = _taken(self._out, order, new, np.zeros(1))
        if self.kinds > 1:
            self._kind = _taken(self._kind, order, new, kinds)
        self._size = order.size

    def _refuse_too_many(self, size: int) -> None:
        """Refuse more contacts than the free memory holds, before any is taken."""
        largest = max((math.prod(part.shape[1:]) * part.itemsize for part in self._state.values()), default=0)
        needed, free = self.bytes_for(size) - self.bytes_for(self.size) + largest * self.size, free_memory()
        if needed > free:
            raise InvalidInput(
                f"ContactArray: {size} contacts take {self.bytes_for(size) / GIB:.3g} GiB, and {free / GIB:.3g} GiB of "
                "memory are free; give fewer of them, fewer springs, fewer answers, or the precision single."
            )

    @staticmethod
    def _checked_name(name: str, known: tuple[str, ...]) -> None:
        if name not in known:
            raise InvalidInput(
                f"ContactArray: there is no {name!r}{suggest(str(name), known)}; give {', '.join(known)}."
            )


def _taken(part: np.ndarray[Any, Any], order: Numbers, new: Numbers, begin: Any) -> np.ndarray[Any, Any]:
    """Return rows in an order, and what new ones begin with."""
    rows = np.zeros((order.size, *part.shape[1:]), part.dtype)
    if len(part) and new.size < order.size:
        np.take(part, order, axis=0, out=rows, mode="clip")  # without a copy in between; -1 is replaced below
    if np.any(begin) or len(part):
        rows[new] = begin
    return rows


def _read_only(array: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    view = array[:]
    view.flags.writeable = False
    return view
