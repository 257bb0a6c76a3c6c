"""The study to start from for a file, with numbers that follow from its columns."""

from __future__ import annotations

import functools
import json
import math
import re
import tomllib
from collections.abc import Callable
from pathlib import Path

import numpy as np

from winkler.io.tables.grading_table import POISSON
from winkler.io.tables.header import names_columns
from winkler.study.inspection.file_kinds import ASSUMED_POISSON
from winkler.study.inspection.inspection import Inspection

PLACE = re.compile(r"<(\w+)\.(\w+)(?:\*([\d.e-]+))?>")
FILE = "<file>"
GRAVITY = 9.81
"""Acceleration of a body in flight [m/s^2]."""


@functools.cache
def _studies() -> dict[str, str]:
    return tomllib.loads((Path(__file__).parent / "studies.toml").read_text(encoding="utf-8"))


def starting_study(inspection: Inspection, name: str) -> str:
    """Return the study of a name with the numbers of a file; the file stands beside it, and empty without a study.

    Parameters
    ----------
    inspection : Inspection
    name : str
        As in ``studies.toml``.
    """
    text = _studies().get(name, "")

    def number(match: re.Match[str]) -> str:
        column, which, factor = match.groups()
        if column == "number":
            found = next(one for one in inspection.numbers if one.name == which)
            value, unit = found.value, found.unit
        else:
            of = inspection.column(column)
            value, unit = {"low": of.low, "high": of.high, "middle": 0.5 * (of.low + of.high),
                           "span": of.high - of.low}[which], of.unit  # fmt: skip
        return f"{float(factor or 1.0) * value:.4g} {unit}".strip()

    for mark, write in OPTIONS.items():
        text = text.replace(mark, write(inspection)) if mark in text else text
    return PLACE.sub(number, text)


def _down(inspection: Inspection) -> str:
    """Return the option for heights that count downwards: those in the middle are less than those at the ends."""
    z = inspection.column("z").values
    return ", down = true" if z[z.size // 2] < 0.5 * (z[0] + z[-1]) else ""


def _poisson(inspection: Inspection) -> str:
    """Return Poisson's ratio for a table without one."""
    return "" if names_columns(inspection.file, (POISSON,)) else f", poisson = {ASSUMED_POISSON}"


def _longest(inspection: Inspection) -> str:
    """Return the longest wave of a spectrum."""
    return f"{2.0 * math.pi / inspection.column('wave_numbers').low:.4g} m"


def _arc(inspection: Inspection) -> str:
    """Return the points of a parabola over the places of a profile, whose radius is a quarter of its width."""
    y = inspection.column("y")
    places = np.linspace(-1.0, 1.0, 9) * 0.5 * (y.high - y.low)
    heights = places**2 / (0.5 * (y.high - y.low))
    rows = (places + 0.5 * (y.low + y.high), heights)
    lists = (", ".join(f'"{1e3 * one:.4g} mm"' for one in row.tolist()) for row in rows)
    return "y = [{}], z = [{}]".format(*lists)


def _restitution(inspection: Inspection) -> str:
    """Return the coefficient of restitution of bounces with its standard error."""
    found = inspection.content.restitution
    return f"{found.value:.4g} ± {found.error:.2g}"


def _speed(inspection: Inspection) -> str:
    """Return the speed after the first bounce, by which the body flies as long as to the second."""
    times = inspection.column("bounce").values
    return f"{0.5 * GRAVITY * float(times[1] - times[0]):.4g} m/s"


def _test(inspection: Inspection) -> str:
    """Return the key for the first of several tests."""
    return ", test = 1" if inspection.count > 1 else ""


OPTIONS: dict[str, Callable[[Inspection], str]] = {
    "<down>": _down, "<poisson>": _poisson, "<longest>": _longest, "<arc>": _arc, "<restitution>": _restitution,
    "<speed>": _speed, "<test>": _test,
}  # fmt: skip
"""Marks of a study, and what is written there."""


def placed_study(inspection: Inspection, file: str) -> str:
    """Return the study of a file that stands at a path relative to the study.

    Parameters
    ----------
    inspection : Inspection
    file : str
        The path, or the name of a folder or a pattern.
    """
    return inspection.study.replace(FILE, json.dumps(file, ensure_ascii=False)[1:-1])
