"""The modules that hold pictures: they register them for ``draw`` as they are loaded."""

from __future__ import annotations

import functools
import pkgutil
from importlib import import_module
from importlib.util import find_spec
from typing import Any, NamedTuple

from winkler.plot.dispatch import sheet_of
from winkler.plot.panel import Sheet

__all__ = ["everything", "sheet_of_kind"]


class _Everything(NamedTuple):
    """What draws, with every picture loaded."""

    draw: Any
    film: Any
    sheet_of: Any


@functools.cache
def everything() -> _Everything:
    """Load every picture, and return what draws them."""
    _load("winkler.plot")
    from winkler.plot.drawing import draw
    from winkler.plot.rough.film import film

    return _Everything(draw, film, sheet_of)


def sheet_of_kind(item: Any) -> Sheet:
    """Return the panels that show `item`, with the pictures of its own part of the package loaded.

    All are loaded where that part does not hold the very picture of this class.
    """
    kind = type(item)
    if kind not in sheet_of.registry:
        _, _, part, *_ = f"{kind.__module__}...".split(".")  # as heating, of winkler.problems.heating.steady
        if part and find_spec(f"winkler.plot.{part}") is not None:
            _load(f"winkler.plot.{part}")
        if kind not in sheet_of.registry:
            everything()
    return sheet_of(item)


def _load(package: str) -> None:
    found = import_module(package)
    for module in pkgutil.walk_packages(getattr(found, "__path__", ()), f"{package}."):
        import_module(module.name)
