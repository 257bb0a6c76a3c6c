"""Questions about numbers of a study that are possible, but unlikely: a slip of a unit, a forgotten sign.

The answer to such a study is as exact as to any other, so that no note on its validity says anything.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from winkler.profiles.curved_pair import CurvedPair
from winkler.readable import with_unit
from winkler.study.batch.outcome import Outcome
from winkler.vocabulary import GLOSSARY, own_word

__all__ = ["questions_of"]


class Unlikely(NamedTuple):
    """Numbers of one kind that are hardly meant.

    Parameters
    ----------
    name
        What the name of the argument ends in.
    unit
        Its unit in SI.
    above
        The least number that is asked about, in SI.
    usual
        What is usual, as a clause.
    slip
        What the number is multiplied with for the question.
    """

    name: str
    unit: str
    above: float
    usual: str
    slip: float


UNLIKELY = (
    Unlikely("coefficient", "", 5.0, "dry solids have coefficients of friction of 0.05 to 1.5", 1e-2),
    Unlikely("radius", "m", 100.0, "balls, rollers and wheels are smaller", 1e-3),
    Unlikely("work", "J/m^2", 5.0, "clean solids adhere with 0.02 to 2 J/m^2", 1e-3),
)
STIFF = 1e9
"""Effective modulus [Pa] above which bodies are hard: metals, ceramics, glasses, hard polymers."""
HARD_SHARE = 0.05
"""Peak pressure over the effective modulus that hard bodies do not bear elastically: static ratings of bearings, 4.0 to
4.6 GPa of steel (ISO 76), are 0.04 of it."""


def questions_of(outcome: Outcome) -> tuple[str, ...]:
    """Return a question about each unlikely number of a study, and about a peak pressure that nothing bears."""
    return (*dict.fromkeys(_asked(outcome.study.problem)), *_hollow(outcome))


def _asked(content: Any) -> Iterator[str]:
    if isinstance(content, tuple):
        for item in content:
            yield from _asked(item)
    if not dataclasses.is_dataclass(content) or isinstance(content, type):
        return
    for field in dataclasses.fields(content):
        item = getattr(content, field.name)
        if isinstance(item, float) and math.isfinite(item):
            entry = own_word(type(content), field.name) or GLOSSARY.get(field.name)
            for one in UNLIKELY:
                named = field.name == one.name or field.name.endswith(f"_{one.name}")
                if named and entry is not None and entry.unit == one.unit and abs(item) >= one.above:
                    name = field.name.replace("_", " ")
                    yield (
                        f"The {name} is {with_unit(item, one.unit)}, and {one.usual}: did you mean "
                        f"{with_unit(item * one.slip, one.unit)}?"
                    )
        yield from _asked(item)


def _hollow(outcome: Outcome) -> Iterator[str]:
    problem = outcome.study.problem
    pair, modulus = getattr(problem, "bodies", None), getattr(getattr(problem, "medium", None), "modulus", math.nan)
    if not isinstance(pair, CurvedPair) or "peak_pressure" not in outcome.answers:
        return
    peak = float(np.nanmax(outcome.answer("peak_pressure"), initial=0.0))
    radii = [getattr(pair, field.name) for field in dataclasses.fields(pair) if field.name.endswith("_radius")]
    if min(radii) > 0.0 and modulus > STIFF and peak > HARD_SHARE * modulus:
        yield (
            f"The peak pressure is {with_unit(peak, 'Pa')}, {peak / modulus:.0%} of the effective modulus, and no "
            "surface is hollow: did you mean a groove or raceway, whose radius is negative?"
        )
