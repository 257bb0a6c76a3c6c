"""One moment of a viscoelastic contact, with its springs."""

from __future__ import annotations

import numpy as np
from numpy.polynomial import chebyshev

from winkler.foundation.bed import Bed, PressedSprings
from winkler.foundation.on_medium import OnMedium
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.panels.chebyshev import Panels
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.round_march import RoundPress
from winkler.values.checks.outline import refuse_unless_round
from winkler.values.errors import OutsideValidity
from winkler.values.value import value, words


@value
class ViscoelasticState(RoundPress[float]):
    """A viscoelastic contact at one moment; its numbers are those of `RoundPress`.

    Parameters
    ----------
    bed : Bed
        The relaxing springs.
    position : ndarray, (n,)
        Places x of the springs [m].
    line_load : ndarray, (n,)
        q(x) [N/m], zero where the spring is free.
    recess : ndarray, (n,)
        u(x) [m]: how far every spring is pressed in, or has not yet recovered; on layers that relax each by a law of
        its own also how far the loads of others move it.
    """

    bed: Bed
    position: Array
    line_load: Array
    recess: Array

    @property
    def pressed(self) -> RelaxedSprings:
        """The springs, from which the fields are restored; a smooth function of g between them."""
        assert isinstance(self.bed, OnMedium)
        assert offers(self.bed.medium, RelaxingMedium)
        if offers(self.bed.medium, RelaxingByWaves):
            raise OutsideValidity(
                f"ViscoelasticState: on a {type(self.bed.medium).__name__} the pressure is restored alone, no field "
                "inside and no surface outside; request the pressure."
            )
        elastic = self.bed.with_medium(self.bed.medium.elastic)
        x, u = self.position, self.recess
        gaps = np.maximum(elastic.gap(x), 0.0)
        held, free = self.line_load > 0.0, (self.line_load == 0.0) & (u > 0.0) & (x > self.radius)
        stiffness = elastic.normal_stiffness(np.where(x > 0.0, x, 0.5 * x[min(1, x.size - 1)]))
        radii, depths, loads = x[held], gaps[held], self.line_load[held] / stiffness[held]
        rest_at_edge = float(elastic.gap(np.array([self.radius]))[0])
        if held.any() and rest_at_edge > depths[-1]:
            radii, depths = np.append(radii, self.radius), np.append(depths, rest_at_edge)
            loads = np.append(loads, 0.0)
        elif held.any() and self.radius < elastic.rim:
            loads[-1] = 0.0
        # within the contact u = d - g is one ramp
        places = np.concatenate([radii[-1:], x[free]])
        rest = np.concatenate([depths[-1:], gaps[free]])
        sunk = np.concatenate([np.maximum(self.depth - depths[-1:], 0.0), u[free]])
        beyond = int(np.searchsorted(x, np.max(places, initial=0.0), side="right"))
        if sunk.size and sunk[-1] > 0.0 and beyond < x.size:
            places, rest, sunk = np.append(places, x[beyond]), np.append(rest, gaps[beyond]), np.append(sunk, 0.0)
        elif sunk.size and places[-1] < elastic.rim:
            sunk[-1] = 0.0
        if held.any() and gaps[0] < depths[-1]:
            places, rest = np.append(x[0], places), np.append(gaps[0], rest)
            sunk = np.append(self.depth - gaps[0], sunk)
        # the edge of the contact is a corner of u
        recess = smooth(
            self.bed, places, rest, sunk, (int(np.count_nonzero(places < self.radius)),) if held.any() else ()
        )
        borne = smooth(self.bed, radii, depths, loads, ())
        outermost = float(places[-1]) if recess else 0.0
        return RelaxedSprings(self.bed, self.depth, outermost, self.radius, recess, borne)

    def pressure(self, r: ArrayLike) -> Array:
        """Return the contact pressure.

        Parameters
        ----------
        r : array_like
            Distances from the axis [m], not negative.

        Returns
        -------
        ndarray
            p(r) [Pa], zero outside the contact, infinite at an edge that is pinned.
        """
        refuse_unless_round(self, "pressure", "the pressure")
        places = np.asarray(r, dtype=float)
        medium = self.bed.medium
        layered = offers(medium, RelaxingByWaves)
        if not (layered or (offers(medium, RelaxingMedium) and isinstance(medium.elastic, HomogeneousMedium))):
            return medium.pressure(self.pressed, places)
        edges, loads = self._edges
        # parabolas between the springs: much faster, and of the same order
        out = np.zeros(places.size)
        climbs = 2.0 * np.diff(loads) / np.diff(edges**2)
        for i, at in enumerate(np.ravel(places).tolist()):
            if at < edges[-1]:
                root = np.sqrt(np.maximum((edges - at) * (edges + at), 0.0))
                out[i] = (loads[-1] / root[-1] - climbs @ np.diff(root)) / np.pi
        return out.reshape(places.shape)

    @property
    def _edges(self) -> tuple[Array, Array]:
        """Places and line loads from the axis to the edge of the contact; the load at the edge is its jump."""
        inside = self.line_load > 0.0
        if not np.any(inside):
            return np.array([0.0]), np.array([0.0])
        x, q = self.position[inside], self.line_load[inside]
        if x[0] > 0.0:
            # a parabola up to the axis
            rise = (q[0] - q[1]) * x[0] ** 2 / (x[1] ** 2 - x[0] ** 2) if x.size > 1 else 0.0
            x, q = np.concatenate([[0.0], x]), np.concatenate([[q[0] + rise], q])
        if self.radius > x[-1]:
            x, q = np.append(x, self.radius), np.append(q, 0.0)
        return x, q


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
