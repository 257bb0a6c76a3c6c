"""Figures of shapes, contacts and answers: as SVG by itself, or with matplotlib.

``draw`` and the modules that register pictures are imported at the first use; a report of single pictures does not
load them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from winkler.numerics.cache_folders import with_fonts

if TYPE_CHECKING:
    from winkler.plot.dispatch import sheet_of
    from winkler.plot.drawing import draw
    from winkler.plot.rough.film import film

__all__ = ["draw", "film", "sheet_of"]

with_fonts()


def __getattr__(name: str) -> Any:
    """Load the functions of the package when they are first used."""
    if name not in __all__:
        raise AttributeError(f"module 'winkler.plot' has no attribute {name!r}")
    from winkler.plot import registered

    return getattr(registered.everything(), name)
