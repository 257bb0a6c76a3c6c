"""Figures: ``draw(anything)`` returns a matplotlib figure.

``draw`` is loaded with all pictures that it knows when it is first used; a report that draws single pictures starts
without them.
"""

from __future__ import annotations

import sys
from types import ModuleType
from typing import TYPE_CHECKING, Any

from winkler.caches import with_fonts

if TYPE_CHECKING:
    from winkler.plot.draw import draw, sheet_of

__all__ = ["draw", "sheet_of"]

with_fonts()


class _Package(ModuleType):
    """A package with the functions `draw` and `sheet_of`; the module of the first name does not replace it."""

    @property
    def draw(self) -> Any:
        from winkler.plot.registered import draw

        return draw

    @draw.setter
    def draw(self, module: ModuleType) -> None:
        """Take the module ``winkler.plot.draw``, which Python sets as an attribute when it is imported."""

    @property
    def sheet_of(self) -> Any:
        from winkler.plot.registered import sheet_of

        return sheet_of


if not TYPE_CHECKING:
    sys.modules[__name__].__class__ = _Package
