r"""The heat of friction as a source: its flux is the pressure times friction coefficient and sliding speed.

Where the bodies are homogeneous, the line load of the flux is the springs' displacement, up to a factor; in layers and
graded bodies, which conduct heat as if they were homogeneous, it is the projection T5 of the pressure.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.fields.line_source import LineSource
from winkler.numerics.fields.round_source import line_source, projected
from winkler.numerics.types import Array
from winkler.problems.normal.indentation import IndentationSolution
from winkler.values.value import value, words

__all__ = ["HeatSource", "heat_source", "heat_sources", "loads_over"]

FAST_PECLET = 1e6
"""V a / kappa at which the limit of fast sliding is taken: it is met to about 1e-6."""


@value
class HeatSource:
    """Frictional heat of one contact, 1 W in all.

    Parameters
    ----------
    pressed : PressedSprings
        The springs.
    source : LineSource
        Line load of the flux, whose integral is 1 W.
    """

    __words__ = words(fast=("", "W/m", "what conductivity, temperature and root of the speed tend to, for 1 W"))

    pressed: PressedSprings
    source: LineSource

    @property
    def fast(self) -> float:
        """What the greatest lambda T times sqrt(V a / kappa) tends to when the body moves fast [W/m].

        Heat then only flows into the body: behind every point of the rim the temperature grows as over a plane under
        the flux that has passed, and the greatest on the centre line counts.  Infinite behind a sharp edge.
        """
        if self.pressed.edge > 0.0:
            return math.inf  # behind the edge the flux, like an inverse square root, meets that of the lag
        return self.source.peak(FAST_PECLET / self.pressed.radius).height * math.sqrt(FAST_PECLET)


@functools.lru_cache(maxsize=256)
def heat_source(pressed: PressedSprings) -> HeatSource:
    """Return the source of 1 W that belongs to a pressed bed.

    Raises
    ------
    OutsideValidity
        If the pressure is not known in this medium.
    NotConverged
        If the shape is too rough.
    """
    joints = [b for b, _ in pressed.kinks]
    if isinstance(pressed.bed.medium, HomogeneousMedium):
        raw = line_source(lambda x: np.maximum(pressed.value(x), 0.0), joints, pressed.radius)
    else:

        def pressure(r: Array) -> Array:
            return pressed.bed.medium.pressure(pressed, r)

        raw = projected(pressure, joints, pressed.radius)
    return HeatSource(pressed, LineSource(raw.radius, raw.scale / raw.heat, raw.joints, raw.curve))


def loads_over(contact: IndentationSolution, shape: tuple[int, ...]) -> Array:
    """Return which load of a contact every result belongs to."""
    loads = np.shape(contact.radius)
    return np.broadcast_to(np.arange(math.prod(loads)).reshape(loads), shape)


def heat_sources(contact: IndentationSolution) -> list[HeatSource | None]:
    """Return the source of every load; None where there is no contact."""
    loads = np.shape(contact.radius)
    ones = (contact.at(index) if loads else contact for index in np.ndindex(loads))
    return [heat_source(one.pressed) if float(one.radius) > 0.0 else None for one in ones]
