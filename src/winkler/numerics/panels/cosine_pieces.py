"""Functions of the distance from the axis on a disc, piece by piece, each piece turned like a cosine.

On the j-th piece, from e_j to e_(j+1), the place ``j + u`` lies at the part (1 - cos(pi u))/2: square roots at the ends
of a piece, as contacts have them at their edge and above kinks, become smooth functions of u.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from winkler.numerics.panels.chebyshev import Panels, fit_nodes, panels_from
from winkler.numerics.types import Array
from winkler.values.value import value


@value
class RoundFlux:
    """A flux that depends on the distance from the axis alone.

    Parameters
    ----------
    radius : float
        a [m], where it ends.
    ends : ndarray
        Where pieces begin and end, from 0 to 1 [a].
    curve : Panels
        The flux [W/m^2] as a function of j + u.
    """

    radius: float
    ends: Array
    curve: Panels

    def at(self, r: Array) -> Array:
        """Return the flux [W/m^2] at distances r [m]; zero outside."""
        part = np.asarray(r, dtype=float) / self.radius
        return np.where(part <= 1.0, self.curve(cosine_places(np.minimum(part, 1.0), self.ends)), 0.0)

    def scaled(self, factor: float) -> RoundFlux:
        """Return a flux so many times as strong."""
        return RoundFlux(self.radius, self.ends, Panels(self.curve.edges, factor * self.curve.coefficients))


def round_flux(flux: Callable[[Array], Array], joints: Sequence[float], radius: float) -> RoundFlux:
    """Return a flux known at any r, from few places on each of the pieces between `joints` [m]."""
    ends = pieces_of(joints, radius)
    edges = np.arange(ends.size, dtype=float)
    return RoundFlux(radius, ends, panels_from(edges, flux(radius * place_on(fit_nodes(edges), ends))))


def pieces_of(joints: Sequence[float], radius: float) -> Array:
    """Return where pieces begin and end, in contact radii."""
    inner = sorted({joint / radius for joint in joints if 0.0 < joint < radius * (1.0 - 1e-9)})
    return np.array([0.0, *inner, 1.0])


def place_on(place: Array, ends: Array) -> Array:
    """Return the place j + u in contact radii: on the j-th piece at the part (1 - cos(pi u))/2."""
    piece = np.minimum(place.astype(int), ends.size - 2)
    low, high = ends[piece], ends[piece + 1]
    return np.asarray(low + 0.5 * (high - low) * (1.0 - np.cos(np.pi * (place - piece))))


def cosine_places(part: Array, ends: Array) -> Array:
    """Return j + u of places in contact radii."""
    piece = np.clip(np.searchsorted(ends, part, side="right") - 1, 0, ends.size - 2)
    low, high = ends[piece], ends[piece + 1]
    return np.asarray(piece + np.arccos(np.clip(1.0 - 2.0 * (part - low) / (high - low), -1.0, 1.0)) / np.pi)
