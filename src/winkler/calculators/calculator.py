"""One calculator: its sliders, its numbers, the kernel between them, and the study of what it shows."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from winkler.values.units import scale

__all__ = ["AnswerNumber", "Calculator", "Slider"]


class Slider(NamedTuple):
    """A number that is given.

    Parameters
    ----------
    name : str
        As in a link.
    symbol, words : str
    unit : str
        In which it is shown and written to the study; empty for pure numbers.
    low, high, start : float
        In this unit.
    ratio : bool
        Whether equal steps of the slider are equal ratios.
    """

    name: str
    symbol: str
    words: str
    unit: str
    low: float
    high: float
    start: float
    ratio: bool = True


class AnswerNumber(NamedTuple):
    """A number that is found.

    Parameters
    ----------
    name, symbol, words : str
    unit : str
        In which it is shown.
    base : str
        Its unit in the SI, in which kernels compute.
    path : str
        Where it is in the solution of the study.
    """

    name: str
    symbol: str
    words: str
    unit: str
    base: str
    path: str

    @property
    def factor(self) -> float:
        """What a number in `base` is divided by to be one in `unit`."""
        return scale(self.unit, self.base) if self.unit != self.base else 1.0


class Calculator(NamedTuple):
    """One class of problem.

    Parameters
    ----------
    name, title, question : str
    kind : str
        Of the study.
    sliders : tuple of Slider
    numbers : tuple of AnswerNumber
        The first is what is asked.
    across, up : str
        Slider and number of the first curve.
    valid : str
        One sentence on how far it holds.
    page : str
        Of the manual, which describes the problem.
    study : str
        The body of a study file: ``{name}`` stands for a slider with its unit, ``{=name}`` for a number in SI units.
    kernel : callable
        Takes the sliders in SI units, its tables, and the array for the numbers.
    """

    name: str
    title: str
    question: str
    kind: str
    sliders: tuple[Slider, ...]
    numbers: tuple[AnswerNumber, ...]
    across: str
    up: str
    valid: str
    page: str
    study: str
    kernel: Callable[..., Any]

    @property
    def factors(self) -> tuple[float, ...]:
        """What numbers of the sliders are multiplied by to be in SI units."""
        return tuple(_si(slider.unit) for slider in self.sliders)


def _si(unit: str) -> float:
    from winkler.values.units import to_si

    return to_si(f"1 {unit}", what="slider") if unit else 1.0
