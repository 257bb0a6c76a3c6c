"""Figures: ``draw(anything)`` returns a matplotlib figure."""

from winkler.plot.draw import draw

__all__ = ["draw"]
