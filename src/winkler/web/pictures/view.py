"""How far pictures go: a frame that stays while a contact moves in it, so that pressing is seen as pressing."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from winkler.plot.extent import around

__all__ = ["NOTHING", "View", "fitting"]

ROOM = 3.0
"""A frame is kept while what it shows fills at least so many parts of it."""


@dataclasses.dataclass(frozen=True)
class View:
    """A frame.

    Parameters
    ----------
    extent
        Greatest distance from the axis [m].
    sunk
        Greatest depth [m].
    """

    extent: float
    sunk: float


NOTHING = View(0.0, 0.0)


def fitting(pressed: Any, held: View = NOTHING) -> View:
    """Return the frame for a contact: the one that is held if it fits, else one of its own.

    Parameters
    ----------
    pressed
        Springs of a contact.
    held
        The frame of the picture before.
    """
    wide, deep = around(pressed, None), _moved(pressed)
    extent = held.extent if held.extent / ROOM <= wide <= 1.02 * held.extent else 1.15 * wide
    sunk = held.sunk if held.sunk / (2.0 * ROOM) <= deep <= 1.02 * held.sunk else 1.2 * deep
    known = pressed.bed.reach if pressed.bed.reach < pressed.bed.rim else math.inf  # beyond a wall all is known
    return View(min(extent, known), sunk)


def _moved(pressed: Any) -> float:
    """Return how far springs are moved at most [m]; a hundredth of the picture where none is."""
    deep = max(float(pressed.depth), 0.0)
    if pressed.radius > 0.0:
        x = np.linspace(0.02, 1.0, 60) * float(pressed.radius)
        deep = max(deep, -float(np.min(pressed.value(x))))
    return deep if deep > 0.0 else 0.01 * around(pressed, None)
