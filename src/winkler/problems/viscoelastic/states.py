"""One moment of a viscoelastic contact, with its springs."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.on_medium import OnMedium
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.round_march import RoundPress
from winkler.problems.viscoelastic.relaxed_springs import RelaxedSprings, smooth
from winkler.values.checks.outline import refuse_unless_round
from winkler.values.errors import OutsideValidity
from winkler.values.value import value

__all__ = ["ViscoelasticState"]


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
