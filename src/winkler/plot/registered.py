"""The modules that hold pictures: they register them for ``draw`` as they are loaded."""

from __future__ import annotations

import functools
import pkgutil
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from winkler.plot.dispatch import sheet_of
from winkler.plot.panel import Sheet


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


def is_drawn(item: Any) -> bool:
    """Return whether the class of `item` has a picture of its own; those are loaded that name it."""
    for kind in type(item).__mro__[:-1]:
        if kind not in sheet_of.registry:
            for module in modules_naming(kind):
                import_module(module)
        if kind in sheet_of.registry:
            return True
    return False


def sheet_of_kind(item: Any) -> Sheet:
    """Return the panels that show `item`; of the pictures those are loaded that name its class, else all."""
    if not is_drawn(item):
        everything()
    return sheet_of(item)


def modules_naming(kind: type) -> list[str]:
    """Return the modules of pictures that import a class, as their sources say."""
    line, name = f"from {kind.__module__} import ".encode(), kind.__name__.encode()
    root, found = Path(__file__).parent, []
    for page in sorted(root.rglob("*.py")):
        source = page.read_bytes()
        if line in source and name in source:
            found.append(".".join(["winkler.plot", *page.relative_to(root).with_suffix("").parts]))
    return found


def _load(package: str) -> None:
    found = import_module(package)
    for module in pkgutil.walk_packages(getattr(found, "__path__", ()), f"{package}."):
        import_module(module.name)
