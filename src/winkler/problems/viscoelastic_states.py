"""One moment of a viscoelastic contact, with its springs."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.values import value

__all__ = ["ViscoelasticState"]


@value
class ViscoelasticState:
    """A viscoelastic contact at one moment.

    Parameters
    ----------
    time : float
        [s].
    depth, radius : float
        d and a [m].
    force : float
        F_N [N].
    stored_energy, dissipation : float
        What all springs store, and what has been lost since the beginning [J].
    position : ndarray, (n,)
        Places x of the springs [m].
    line_load : ndarray, (n,)
        q(x) [N/m], zero where the spring is free.
    recess : ndarray, (n,)
        u(x) [m]: how far every spring is pressed in, or has not yet recovered.
    """

    time: float
    depth: float
    force: float
    radius: float
    stored_energy: float
    dissipation: float
    position: Array
    line_load: Array
    recess: Array

    def pressure(self, r: ArrayLike) -> Array:
        """Return the contact pressure, of line loads taken as parabolas between the springs.

        Parameters
        ----------
        r : array_like
            Distances from the axis [m], not negative.

        Returns
        -------
        ndarray
            p(r) [Pa], zero outside the contact, infinite at an edge that is pinned.
        """
        places = np.asarray(r, dtype=float)
        edges, loads = self._edges
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
            x, q = np.concatenate([[0.0], x]), np.concatenate([q[:1], q])
        if self.radius > x[-1]:
            x, q = np.append(x, self.radius), np.append(q, 0.0)
        return x, q
