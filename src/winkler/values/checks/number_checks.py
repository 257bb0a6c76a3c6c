"""The numbers that a field of a value may hold, written as its type: ``young: Positive``, ``poisson: PoissonRatio``.

A type such as `Positive` is ``Annotated[float, Number(...)]``: a float for type checkers, and for `value` what contents
are compared with when a value is made.  The sentence of a refusal ends with the unit of the field, which the glossary
has, and with the `Advice` beside the type: ``Annotated[Positive, Advice("leave a layer of none out")]``.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from typing import Annotated, Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from winkler.values.checks.physical_size import LARGEST_NUMBER, SMALLEST_NUMBER, as_text, refuse_size
from winkler.values.checks.plain_numbers import REAL, Argument, plain
from winkler.values.errors import InvalidInput

COUNT_BITS = 40
"""Bits of a whole number: nothing that is counted is counted further."""

Check: TypeAlias = Callable[[Any], Any]
"""Takes the content of a field, returns it as it is stored, or raises InvalidInput."""


class Advice(NamedTuple):
    """What to do about a content that is refused; it ends the sentence, after a colon."""

    text: str


class Number(NamedTuple):
    """A number from `least` to `most`, none of the `excluded`, which are ends of the interval.

    The `demand` is the sentence for it, with ``{unit}`` for " in m"; `several` is the one for several numbers.  What is
    `sized` is a physical number, up to `LARGEST_NUMBER` in size, and zero or at least `smallest`.
    """

    demand: str
    least: float = -math.inf
    most: float = math.inf
    excluded: tuple[float, ...] = ()
    several: str = ""
    sized: bool = True
    smallest: float = 0.0

    def admits(self, content: Any) -> bool:
        """Return whether a content is a number, and no truth value, in the interval."""
        return type(content) in REAL and self.least <= content <= self.most and content not in self.excluded

    def check(self, argument: Argument) -> Check:
        """Return what refuses contents of a field that are no such number."""
        low, high = max(self.least, self.smallest or -LARGEST_NUMBER), min(self.most, LARGEST_NUMBER)
        low = math.nextafter(low, high) if low in self.excluded else low
        quick = self.admits(low) and self.admits(high)

        def checked(content: Any) -> Any:
            if quick and type(content) is float and low <= content <= high:
                return content
            number = plain(content, argument)
            if not self.admits(number):
                raise argument.refused(f"is {as_text(content)}", self.demand)
            if self.sized:
                refuse_size(argument.where, number, self.smallest)
            return number

        return checked


class Whole(NamedTuple):
    """A whole number from `least` to `most`; `what` names the counted things."""

    least: int
    most: float = math.inf
    what: str = ""

    @property
    def demand(self) -> str:
        """What is allowed, in words."""
        least = f"at least {self.least}" if self.least else "zero or positive"
        allowed = f", {least}" if self.most == math.inf else f" from {self.least} to {self.most}"
        return f"give a whole number{f' of {self.what}' if self.what else ''}{allowed}"

    def check(self, argument: Argument) -> Check:
        """Return what refuses contents of a field that are no such number."""

        def checked(content: Any) -> Any:
            number = plain(content, argument)
            if type(number) is not int or not self.least <= number <= self.most or number.bit_length() > COUNT_BITS:
                raise argument.refused(f"is {as_text(content)}", self.demand)
            return number

        return checked


FINITE = Number("give a finite number{unit}", excluded=(math.inf, -math.inf), several="finite numbers{unit}")
POSITIVE = Number(
    "it must be a positive, finite number{unit}",
    0.0,
    excluded=(0.0, math.inf),
    several="positive, finite numbers{unit}",
)
NOT_TINY = POSITIVE._replace(smallest=SMALLEST_NUMBER)
NON_NEGATIVE = Number(
    "give zero or a positive, finite number{unit}",
    0.0,
    excluded=(math.inf,),
    several="finite numbers{unit}, none of them negative",
)


POSITIVE_OR_INFINITE = Number("it must be a positive number{unit}, or infinite", 0.0, excluded=(0.0,))
POISSON = Number(
    "a Poisson ratio is above -1 and at most 0.5", -1.0, 0.5, (-1.0,), several="numbers above -1 and at most 0.5"
)


class ComplexNumbers(NamedTuple):
    """Numbers in any shape, real or complex."""

    def check(self, argument: Argument) -> Check:
        """Return what refuses contents of a field that are no such numbers."""

        def checked(content: Any) -> Any:
            if isinstance(content, np.ndarray) and content.dtype.kind in "fc":
                return content
            raise argument.refused(f"is {as_text(content)}", "give an array of numbers")

        return checked


ORDER_TEXTS = {"": "", "rising": ", each above the one before", "never falling": " that never fall"}

IN_ORDER = {"rising": operator.gt, "never falling": operator.ge}


class Numbers(NamedTuple):
    """Numbers of one sort in a row, ``"rising"``, ``"never falling"`` or of no order, or in any shape."""

    each: Number = FINITE
    fewest: int = 1
    most: float = math.inf
    order: str = ""
    any_shape: bool = False

    @property
    def demand(self) -> str:
        """What is allowed, in words."""
        if self.any_shape:
            return f"give a number or an array of {self.each.several}"
        count = f"at least {self.fewest} " if self.fewest > 1 else ""
        return f"give a row of {count}{self.each.several}{ORDER_TEXTS[self.order]}"

    def check(self, argument: Argument) -> Check:
        """Return what makes a read-only array of a content of a field, and refuses what is no such array."""
        single = self.each._replace(demand=self.demand).check(argument)

        def refused(what: str) -> InvalidInput:
            return argument.refused(what, self.demand)

        def checked(content: Any) -> Any:
            found = plain(content, argument)
            if self.any_shape and type(found) in REAL:
                return single(found)
            if type(found) in REAL:
                raise refused("has the shape ()")
            if not isinstance(found, np.ndarray) or found.dtype != float:
                raise refused(f"is {as_text(content)}")
            numbers: NDArray[Any] = found
            if numbers.ndim != 1 and not self.any_shape:
                raise refused(f"has the shape {numbers.shape}")
            if numbers.size < self.fewest:
                raise refused(f"has {numbers.size} number{'s' * (numbers.size > 1)}" if numbers.size else "is empty")
            affordable(argument.where, "numbers", numbers.size, self.most)
            if numbers.size:
                low, high = float(numbers.min()), float(numbers.max())
                if not (self.each.admits(low) and self.each.admits(high)):  # undefined ones included
                    raise refused(self._entries_refused(numbers))
                if max(-low, high) > LARGEST_NUMBER:
                    refuse_size(argument.where, numbers)
                if self.order and not (IN_ORDER[self.order](numbers[1:], numbers[:-1])).all():
                    raise refused(self._step_refused(numbers))
            return numbers

        return checked

    def _entries_refused(self, numbers: NDArray[Any]) -> str:
        bad = [place for place, number in enumerate(numbers.flat) if not self.each.admits(float(number))]
        place = f" at index {', '.join(map(str, bad[:5]))}" if numbers.ndim else ""
        return f"is {numbers.flat[bad[0]]}{place}{f' and {len(bad) - 5} more' if bad[5:] else ''}"

    def _step_refused(self, numbers: NDArray[Any]) -> str:
        place = int(np.argmin(IN_ORDER[self.order](numbers[1:], numbers[:-1])))
        verb = "does not rise" if self.order == "rising" else "falls"
        return f"{verb} from index {place} ({numbers[place]:.6g}) to the next ({numbers[place + 1]:.6g})"


def checked(
    kind: Number | Whole | Numbers, owner: str, name: str, content: Any, unit: str | None = "", advice: str = ""
) -> Any:
    """Return an argument of a function, compared with what it may be as a field is.

    Parameters
    ----------
    kind : Number, Whole or Numbers
        What is allowed, such as `POSITIVE`.
    owner, name : str
        Who takes it, and what it is called there.
    content
        What was given.
    unit : str, optional
        Its SI unit; empty for a plain number, None where a quantity has any.
    advice : str, optional
        What else to do about it.

    Returns
    -------
    object
        The content; of several numbers a read-only array.

    Raises
    ------
    InvalidInput
    """
    return kind.check(Argument(f"{owner}: {name}", lambda: unit, advice))(content)


def between(least: float, most: float) -> Number:
    """Return the sort of the numbers from `least` to `most`, both included."""
    ends = [f"{end:g}".replace("e-0", "e-") for end in (least, most)]
    return Number(f"give a number between {ends[0]} and {ends[1]}{{unit}}", least, most)


Finite: TypeAlias = Annotated[float, FINITE]
Positive: TypeAlias = Annotated[float, POSITIVE]
NonNegative: TypeAlias = Annotated[float, NON_NEGATIVE]
PositiveNotTiny: TypeAlias = Annotated[float, NOT_TINY]
"""A positive number whose tiniest values would keep solvers busy without end."""
PositiveOrInfinite: TypeAlias = Annotated[float, POSITIVE_OR_INFINITE]
PositiveOfAnySize: TypeAlias = Annotated[float, POSITIVE._replace(sized=False)]
"""A positive number whose unit is a power that other fields decide about, so that its size is not checked."""
PoissonRatio: TypeAlias = Annotated[float, POISSON]
Fraction: TypeAlias = Annotated[float, Number("give a number from 0 to 1", 0.0, 1.0)]
Count: TypeAlias = Annotated[int, Whole(1)]
Seed: TypeAlias = Annotated[int, Whole(0)]
FiniteRow: TypeAlias = Annotated[NDArray[Any], Numbers()]
PositiveRow: TypeAlias = Annotated[NDArray[Any], Numbers(POSITIVE)]
FINITE_QUANTITY = Numbers(any_shape=True)
POSITIVE_QUANTITY = Numbers(POSITIVE, any_shape=True)
NON_NEGATIVE_QUANTITY = Numbers(NON_NEGATIVE, any_shape=True)
FiniteQuantity: TypeAlias = Annotated[float | NDArray[Any], FINITE_QUANTITY]
PositiveQuantity: TypeAlias = Annotated[float | NDArray[Any], POSITIVE_QUANTITY]
NonNegativeQuantity: TypeAlias = Annotated[float | NDArray[Any], NON_NEGATIVE_QUANTITY]


def affordable(owner: str, what: str, count: int, most: float) -> None:
    """Refuse more of something than are computed with.

    Raises
    ------
    InvalidInput
    """
    if count > most:
        raise InvalidInput(f"{owner}: {count} {what} are too many; give at most {most}.")
