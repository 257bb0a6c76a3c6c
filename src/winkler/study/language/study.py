"""A study: a problem in a text file, with what to vary, what to restore, what to write and what to expect.

A study is a value like everything else: read from TOML (`winkler.study.language.reading.read_study`), or made in
Python, it runs to the same numbers.  ``[sweep]`` varies keys of the problem, ``[fields]`` requests pressures and
stresses, ``[output]`` states what is written, ``[[expect]]`` the expected numbers.
"""

from __future__ import annotations

import math
import re
from typing import Annotated, Any, ClassVar

import numpy as np

from winkler.numerics.types import Array
from winkler.study.language.designs import POINT, Crossed, Design, Zipped, axes_of
from winkler.study.language.varied import Axis, Range
from winkler.values.checks.number_checks import FiniteQuantity, NonNegative, Numbers, affordable
from winkler.values.errors import InvalidInput
from winkler.values.limits import FIELD_PLACES, KEY_LETTERS
from winkler.values.value import value
from winkler.values.vocabulary import GLOSSARY

PICTURES = ("svg", "png", "pdf")
"""Formats that figures can be written in."""

GRADES = ("analytical", "cross-code", "independent implementation", "published table", "measured")
"""Grades of independence of a literature case."""

OF_THE_GLOSSARY = "of the glossary"
"""In place of a unit: the one that the name has in the glossary."""


@value
class Places:
    """Places where fields are restored.

    Parameters
    ----------
    values : ndarray, shape (n,)
        Distances [m], or multiples of the contact radius if `relative`; empty: none.
    relative
        Whether the values are multiples of the contact radius of each solution.
    """

    values: Annotated[Array, Numbers(fewest=0)]
    relative: bool = False

    section: ClassVar[str] = "fields"

    def within(self, radius: float) -> Array:
        """Return the places in [m] for a contact of the given `radius` [m]."""
        return self.values * radius if self.relative else self.values


@value
class Fields:
    """The fields of ``[fields]``: on the surface at `r`, and below it on the grid of `r` and `z`.

    Parameters
    ----------
    r
        Distances from the axis, not negative; empty for no fields.
    z
        Depths below the surface, positive in the first body, negative in the second; empty for surface fields only.
    """

    r: Places = Places(np.empty(0))
    z: Places = Places(np.empty(0))

    def __post_init__(self) -> None:
        if self.z.values.size and not self.r.values.size:
            raise InvalidInput("fields: z is given without r; add r, the distances from the axis.")
        affordable("fields", "places", self.r.values.size * max(1, self.z.values.size), FIELD_PLACES)
        if np.any(self.r.values < 0.0):
            raise InvalidInput(
                f"fields: r contains {np.min(self.r.values):g}; distances from the axis are not negative."
            )


@value
class Output:
    """The output of ``[output]``.

    Parameters
    ----------
    folder
        Folder of the results, relative to the working directory; empty for ``results/<name of the study file>``.
    figures
        Formats of the figures as files: any of svg, png, pdf; empty for none.  The report holds them in any case.
    report
        Whether a report.html is written.
    workbook
        Whether the tables are also written as a workbook, tables.xlsx.
    """

    folder: str = ""
    figures: tuple[str, ...] = ("svg",)
    report: bool = True
    workbook: bool = False

    def __post_init__(self) -> None:
        for picture in self.figures:
            if picture not in PICTURES:
                raise InvalidInput(
                    f"output: figures cannot be written as '{picture}'; give some of {', '.join(PICTURES)}."
                )
        if self.workbook:
            try:
                import openpyxl  # noqa: F401  (missed before anything is computed)
            except ImportError:
                raise InvalidInput(
                    "output: workbook needs openpyxl; install it with pip install 'winkler[xlsx]', or leave workbook "
                    "out."
                ) from None


def named(quantity: str) -> str:
    """Return the glossary name at the end of a path; numbers behind it are indices among many answers.

    Examples
    --------
    >>> named("problem.bed.medium.modulus"), named("shear_force.-1")
    ('modulus', 'shear_force')
    """
    if len(quantity) > KEY_LETTERS:
        raise InvalidInput(f"quantity is '{quantity[:40]}...'; give a name of at most {KEY_LETTERS} letters.")
    return re.sub(r"(\.-?\d+)+$", "", quantity).rpartition(".")[2]


@value
class Expectation:
    """One ``[[expect]]``: an expected number.

    Parameters
    ----------
    quantity
        Name of an answer (``depth``) or, with `place`, of a restored field (``pressure``, ``von_mises``) or of a
        function of the solution (``line_load``); or a path inside the solution (``problem.bed.medium.modulus``).
    expected : float or ndarray
        The number in SI units; an array where the load is one, or of a sweep one number for each of its points.
    tolerance
        Largest allowed deviation, relative to `scale`.
    place
        ``()`` for an answer; ``(("r", r),)`` for the surface, ``(("r", r), ("z", z))`` below it, ``(("x", x),)`` along
        the line of springs, ``(("x", x), ("y", y), ("z", z))`` in the axes of the bodies [m].
    scale
        What deviations are relative to, in the unit of the quantity; zero (the default) for the expected number itself.
    unit
        Of the quantity, of a path that of its end, in SI; by default that of the glossary.
    """

    quantity: str
    expected: FiniteQuantity
    tolerance: NonNegative
    place: tuple[tuple[str, float], ...] = ()
    scale: NonNegative = 0.0
    unit: str = OF_THE_GLOSSARY

    section: ClassVar[str] = "expect"

    def __post_init__(self) -> None:
        if self.unit == OF_THE_GLOSSARY:
            if named(self.quantity) not in GLOSSARY:
                raise InvalidInput(f"expect: '{self.quantity}' is no quantity of the glossary; give its unit.")
            object.__setattr__(self, "unit", GLOSSARY[named(self.quantity)].unit or "")
        if self.scale == 0.0 and np.any(np.asarray(self.expected) == 0.0):
            raise InvalidInput(
                f"expect: the expected {self.quantity} is zero, so that no deviation is small against it; add scale."
            )


@value
class Study:
    """A problem with its sweep, fields, output and expected numbers.

    Parameters
    ----------
    title
        One line for tables, figures and the report.
    problem
        The problem: a value with a method ``solve()``.
    sweep
        The keys that vary.
    design
        Choice of the points: every combination by default.
    fields
        Where fields are restored.
    output
        Files that are written.
    expect
        Expected numbers; compared at every point of the study.
    source, grade
        Of a literature case: where the expected numbers come from, and how independent they are (analytical,
        cross-code, published table, measured).
    """

    title: str
    problem: Any
    sweep: tuple[Axis | Range, ...] = ()
    design: Design = Crossed()
    fields: Fields = Fields()
    output: Output = Output()
    expect: tuple[Expectation, ...] = ()
    source: str = ""
    grade: str = ""

    def __post_init__(self) -> None:
        keys = [line.key for line in self.sweep]
        for key in keys:
            if keys.count(key) > 1:
                raise InvalidInput(f"sweep: '{key}' is there twice; give each key once.")
        if self.sweep or not isinstance(self.design, Crossed | Zipped):
            axes_of(self.design, self.sweep)
        if self.grade and self.grade not in GRADES:
            raise InvalidInput(f"grade: '{self.grade}' is not known; give one of {', '.join(GRADES)}.")

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The keys that vary, each with its values: of a design that is not crossed, one for each point."""
        return axes_of(self.design, self.sweep)

    @property
    def dims(self) -> tuple[str, ...]:
        """Names of the dimensions of the answers: the keys of a crossed sweep, else ``point``; none without a sweep."""
        if isinstance(self.design, Crossed):
            return tuple(line.key for line in self.sweep)
        return (POINT,) if self.sweep else ()

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of points along each dimension; ``()`` without a sweep."""
        return tuple(len(axis.values) for axis in self.axes)[: len(self.dims)]

    @property
    def size(self) -> int:
        """Number of points; one without a sweep."""
        return math.prod(self.shape)

    def setting(self, place: int) -> tuple[tuple[int, ...], tuple[Any, ...]]:
        """Return index and values of the point at a place in the order of the sweep; the values in that of its keys."""
        index: list[int] = []
        left = place
        for count in reversed(self.shape):
            left, along = divmod(left, count)
            index.insert(0, along)
        axes = self.axes
        places = index if isinstance(self.design, Crossed) else index * len(axes)
        return tuple(index), tuple(axis.values[at] for axis, at in zip(axes, places, strict=True))
