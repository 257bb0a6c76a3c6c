"""``draw`` with every picture: all modules of the package are loaded, and those that hold pictures register them."""

from __future__ import annotations

import pkgutil
from importlib import import_module

import winkler.plot
from winkler.plot.dispatch import sheet_of
from winkler.plot.drawing import draw
from winkler.plot.rough.film import film

__all__ = ["draw", "film", "sheet_of"]

for module in pkgutil.walk_packages(winkler.plot.__path__, "winkler.plot."):
    import_module(module.name)
