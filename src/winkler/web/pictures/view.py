"""Frame of pictures, kept constant while a contact changes within it, so that motion is visible."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from winkler.plot.extent import around

MOST_SHRINKAGE = 3.0
"""A frame is kept until it exceeds its contents by this factor."""


@dataclasses.dataclass(frozen=True)
class View:
    """A frame.

    Parameters
    ----------
    extent
        Greatest distance from the axis [m].
    sunk
        Greatest depth [m].
    radius
        Contact radius that scales the map of the stress [m].
    """

    extent: float
    sunk: float
    radius: float = 0.0


NO_VIEW = View(0.0, 0.0)


def fitting(pressed: Any, previous: View = NO_VIEW) -> View:
    """Return the frame for a contact: the previous one if it fits, else a new one.

    Parameters
    ----------
    pressed
        Springs of a contact.
    previous
        Frame of the previous picture.
    """
    width, depth = around(pressed, None), _greatest_displacement(pressed)
    extent = previous.extent if previous.extent / MOST_SHRINKAGE <= width <= 1.02 * previous.extent else 1.15 * width
    sunk = previous.sunk if previous.sunk / (2.0 * MOST_SHRINKAGE) <= depth <= 1.02 * previous.sunk else 1.2 * depth
    limit = pressed.bed.reach if pressed.bed.reach < pressed.bed.rim else math.inf  # beyond a wall nothing is limited
    return View(min(extent, limit), sunk, _radius(float(pressed.radius), previous.radius))


def of_history(pressed: Any, previous: View) -> View:
    """Return the frame for another moment of the same history: the previous one, with a map that holds the contact."""
    return dataclasses.replace(previous, radius=_radius(float(pressed.radius), previous.radius))


def _radius(radius: float, previous: float) -> float:
    """Return the radius that scales the map of the stress: the previous one if it fits, else with room to grow."""
    return previous if previous / MOST_SHRINKAGE <= radius <= previous else 1.15 * radius


def _greatest_displacement(pressed: Any) -> float:
    """Return the greatest displacement of the springs [m]; a hundredth of the extent if it is zero."""
    depth = max(float(pressed.depth), 0.0)
    if pressed.radius > 0.0:
        x = np.linspace(0.02, 1.0, 60) * float(pressed.radius)
        depth = max(depth, -float(np.min(pressed.value(x))))
    return depth if depth > 0.0 else 0.01 * around(pressed, None)
