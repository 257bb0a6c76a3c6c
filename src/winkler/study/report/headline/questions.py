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
from winkler.study.batch.outcome import Outcome
from winkler.values.readable import with_unit
from winkler.values.vocabulary import GLOSSARY, own_word


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
GROOVES = (1.005, 1.3)
"""Radius of a groove over that of the ball in it, least and greatest: 1.02 to 1.1 in bearings, more in guides."""
STIFF = 1e9
"""Effective modulus [Pa] above which bodies are hard: metals, ceramics, glasses, hard polymers."""
HARD_SHARE = 0.05
"""Peak pressure over the effective modulus that hard bodies do not bear elastically: static ratings of bearings, 4.0 to
4.6 GPa of steel (ISO 76), are 0.04 of it."""


def questions_of(outcome: Outcome) -> tuple[str, ...]:
    """Return a question about each unlikely number of a study, and about a peak pressure that nothing bears."""
    return (*dict.fromkeys(_asked(outcome.study.problem)), *(_hollow(outcome) or _groove(outcome.study.problem)))


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


def _radii(pair: CurvedPair) -> dict[str, float]:
    names = [field.name for field in dataclasses.fields(pair) if field.name.endswith("_radius")]
    return {name: getattr(pair, name) for name in names}


def _groove(problem: Any) -> tuple[str, ...]:
    """Return a question about a second body that is hardly wider than the first: a groove without its sign."""
    pair = getattr(problem, "bodies", None)
    if not isinstance(pair, CurvedPair):
        return ()
    radii = _radii(pair)
    for along in ("longitudinal", "lateral"):
        first, second = radii[f"first_{along}_radius"], radii[f"second_{along}_radius"]
        if first > 0.0 and GROOVES[0] < second / first < GROOVES[1]:
            name = f"second {along} radius"
            return (
                f"The {name} is {second / first:.3g} times that of the first body, as of a groove or raceway, and "
                f"positive: did you mean {with_unit(-second, 'm')}, which is hollow?",
            )
    return ()


def _hollow(outcome: Outcome) -> tuple[str, ...]:
    problem = outcome.study.problem
    pair = getattr(problem, "bodies", None)
    if not isinstance(pair, CurvedPair) or "peak_pressure" not in outcome.answers:
        return ()
    modulus = getattr(getattr(problem, "medium", None), "modulus", math.nan)
    peak = float(np.nanmax(outcome.answer("peak_pressure"), initial=0.0))
    if min(_radii(pair).values()) > 0.0 and modulus > STIFF and peak > HARD_SHARE * modulus:
        return (
            f"The peak pressure is {with_unit(peak, 'Pa')}, {peak / modulus:.0%} of the effective modulus, and no "
            "surface is hollow: did you mean a groove or raceway, whose radius is negative?",
        )
    return ()
