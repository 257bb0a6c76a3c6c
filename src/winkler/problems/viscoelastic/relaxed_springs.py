"""The springs of a viscoelastic contact at one moment, as smooth functions of g: fields are restored from them."""

from __future__ import annotations

import numpy as np
from numpy.polynomial import chebyshev

from winkler.foundation.bed import Bed, PressedSprings
from winkler.numerics.panels.chebyshev import Panels
from winkler.numerics.types import Array
from winkler.values.value import value, words

__all__ = ["RelaxedSprings", "SmoothSprings", "smooth"]

POLYNOMIAL_TERMS = 6
"""Of the polynomial on a stretch, besides the straight line between its ends."""
POLYNOMIAL_TOLERANCE = 1e-7
"""How near a polynomial must come to all springs, over the greatest displacement."""


@value
class SmoothSprings:
    """Springs displaced by a piecewise polynomial of g: a `Displacement`.

    Parameters
    ----------
    bed : Bed
    radius : float
        Where the displaced springs end [m].
    panels : Panels
        u [m] over g [m].
    joints : ndarray
        Radii where one polynomial meets the next [m].
    jump : float
        u(a-) [m].
    """

    __words__ = words(
        panels=("u", None, "how far springs are displaced, polynomials of g"),
        joints=("x_j", "m", "radii where one polynomial meets the next"),
        jump=("J", "m", "step at the last radius"),
    )

    bed: Bed
    radius: float
    panels: Panels
    joints: Array
    jump: float

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)``: those of the bed, and the joints."""
        own = {float(b): 0.0 for b in self.joints if 0.0 < b < self.radius}
        for b, strength in self.bed.kinks:
            if b < self.radius:
                falls = -float(self.panels.derivative(self.bed.gap(np.array([b])))[0])
                own[b] = strength * falls
        return tuple(sorted(own.items()))

    @property
    def edge(self) -> float:
        """u(a-) [m]."""
        return self.jump

    def value(self, x: Array) -> Array:
        """u(x) [m]."""
        return self.panels(self.bed.gap(x))

    def slope(self, x: Array) -> Array:
        """u'(x) [-]."""
        return np.asarray(self.panels.derivative(self.bed.gap(x)) * self.bed.gap_slope(x))


def smooth(
    bed: Bed, radii: Array, depths: Array, displaced: Array, parts: tuple[int, ...]
) -> tuple[SmoothSprings, ...]:
    """Return springs smoothly displaced between the ones given, none if there are none.

    Parameters
    ----------
    bed : Bed
    radii, depths, displaced : ndarray, (n,)
        x, g and u [m] of springs; the last one is the end.
    parts : tuple of int
        Springs at which u has a corner.
    """
    if radii.size == 0 or radii[-1] == 0.0:
        return ()
    if radii.size == 1:  # a flat end
        panels = Panels(np.array([0.0, 1.0]), np.array([[float(displaced[0])]]))
        return (SmoothSprings(bed, float(radii[0]), panels, np.empty(0), float(displaced[0])),)
    ends = sorted({0, *parts, radii.size - 1})
    little = POLYNOMIAL_TOLERANCE * float(np.max(displaced))
    waiting = list(zip(ends[:-1], ends[1:], strict=True))[::-1]
    firsts, rows = [], []
    while waiting:
        low, high = waiting.pop()
        row, error = _polynomial(depths[low : high + 1], displaced[low : high + 1])
        if error > little:
            middle = (low + high) // 2
            waiting.extend([(middle, high), (low, middle)])
            continue
        firsts.append(low)
        rows.append(row)
    panels = Panels(np.append(depths[firsts], depths[-1]), np.array(rows))
    return (SmoothSprings(bed, float(radii[-1]), panels, radii[firsts], float(displaced[-1])),)


def _polynomial(depths: Array, displaced: Array) -> tuple[Array, float]:
    """Return Chebyshev coefficients of a curve through both ends and near the springs between, and how near."""
    row = np.zeros(POLYNOMIAL_TERMS + 2)
    row[0], row[1] = 0.5 * (displaced[0] + displaced[-1]), 0.5 * (displaced[-1] - displaced[0])
    t = (2.0 * depths[1:-1] - depths[0] - depths[-1]) / (depths[-1] - depths[0])
    rest = displaced[1:-1] - row[0] - row[1] * t
    terms = min(POLYNOMIAL_TERMS, t.size // 2)
    if terms:
        shapes = (1.0 - t * t)[:, None] * chebyshev.chebvander(t, terms - 1)
        factors = np.linalg.lstsq(shapes, rest, rcond=None)[0]
        rest = rest - shapes @ factors
        bent = chebyshev.chebmul(np.array([0.5, 0.0, -0.5]), factors)
        row[: bent.size] += bent
    return row, float(np.max(np.abs(rest), initial=0.0))


@value
class RelaxedSprings(PressedSprings):
    """Springs that remember: those in contact are pressed to a depth, those outside may not have recovered yet.

    Parameters
    ----------
    bed : Bed
        Relaxing.
    depth : float
        d [m].
    radius : float
        Up to where springs are displaced [m].
    contact_radius : float
        a [m].
    recess : tuple of SmoothSprings
        u(x), one if any spring is displaced.
    borne : tuple of SmoothSprings
        The displacement of elastic springs that would bear the same, one if any spring is pressed.
    """

    __words__ = words(
        recess=("u", None, "how far springs are pressed in or have not yet recovered"),
        borne=("b", None, "how far elastic springs would be pressed in that bear the same"),
    )

    contact_radius: float
    recess: tuple[SmoothSprings, ...]
    borne: tuple[SmoothSprings, ...]

    @property
    def touching(self) -> float:
        """a [m]."""
        return self.contact_radius

    @property
    def blunted(self) -> RelaxedSprings:
        """The same springs."""
        return self

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)`` where u is not smooth."""
        return self.recess[0].kinks if self.recess else ()

    @property
    def edge(self) -> float:
        """The last jump of u [m]."""
        return self.recess[0].edge if self.recess else 0.0

    def value(self, x: Array) -> Array:
        """u(x) [m]."""
        return self.recess[0].value(x)

    def slope(self, x: Array) -> Array:
        """u'(x) [-]."""
        return self.recess[0].slope(x)
