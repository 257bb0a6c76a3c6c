r"""Stresses below a line contact, pressed and rubbed: the potential F of the pressure gives all of them.

With the traction :math:`q = \mu p` along x on the surface, and z into the body,

.. math::

    \sigma_x &= \Im F + z\,\Re F' - \mu\,(2\,\Re F - z\,\Im F') , \\
    \sigma_z &= \Im F - z\,\Re F' - \mu z\,\Im F' , \\
    \tau_{xz} &= -z\,\Im F' + \mu\,(\Im F + z\,\Re F') , \qquad \sigma_y = \nu(\sigma_x+\sigma_z) .

These are Flamant's line loads summed over the strip; for a cylinder F is McEwen's closed form.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from winkler.errors import OutsideValidity
from winkler.foundation.line import LineFoundation
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.numerics.types import Array
from winkler.values import value

__all__ = ["LineContact", "LineFields", "Placed", "greatest", "poisson_of", "stresses"]

PLACES_BESIDE, DEPTHS = 10, 24
CLOSEST = 1e-4
"""Nearest places to a mark, and depth, over the half-width."""
MOST_PEAKS = 3
"""Local maxima of the coarse grid from which the greatest is sought."""
NEIGHBOURS, FINE, REFINEMENTS = 2, 13, 20
"""Points kept on either side of the best one, points of the finer grid between them, and how often."""
ROUNDING = 1e-14
POLISHING, POLISHED_SHARE = 9, 0.1
"""Nodes of the polynomial about the greatest stress, and its reach over the distance to the next singular place."""
WIDTHS_SEARCHED = 1.6
DEEPEST_SEARCHED = 2.5
"""How far from the middle and how deep the greatest stress is sought, in half-widths."""


@value
class LineFields:
    """Stresses inside one body under a line contact, in its own axes: x along the surface, y endless, z into the body.

    Parameters
    ----------
    x, z : ndarray
        Where [m]; z as requested: positive in the first body, negative in the second.
    xx_stress, yy_stress, zz_stress, xz_stress : ndarray
        [Pa], tension positive.
    """

    x: Array
    z: Array
    xx_stress: Array
    yy_stress: Array
    zz_stress: Array
    xz_stress: Array

    @property
    def von_mises(self) -> Array:
        """Equivalent stress after von Mises [Pa]."""
        x, y, z = self.xx_stress, self.yy_stress, self.zz_stress
        normal = 0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2)
        return np.asarray(np.sqrt(normal + 3.0 * self.xz_stress**2))

    @property
    def max_shear(self) -> Array:
        """Greatest shear stress in the plane of x and z [Pa], half the difference of the principal stresses there."""
        return np.asarray(np.hypot(0.5 * (self.xx_stress - self.zz_stress), self.xz_stress))


class LineContact(NamedTuple):
    """What the stresses below one contact need.

    Parameters
    ----------
    bed
        Profile and bodies.
    half_width
        a [m].
    rim_load
        Load per length over E* that a rim bears beyond w(a) [m].
    poisson
        Of the body.
    friction
        Traction on the body along x over the pressure [-].
    """

    bed: LineFoundation
    half_width: float
    rim_load: float
    poisson: float
    friction: float


class Placed(NamedTuple):
    """The greatest of a stress, and its place in the axes of the body."""

    value: float
    x: float
    z: float


def poisson_of(bed: LineFoundation, below: bool) -> float:
    """Return Poisson's ratio of the first body (`below`) or the second; refuse one without stresses."""
    medium = bed.medium
    body = getattr(medium, "first" if below else "second", None) if isinstance(medium, HalfSpace) else None
    if not isinstance(body, Elastic):
        raise OutsideValidity(
            f"The {'first body (z >= 0)' if below else 'second body (z < 0)'} is rigid or not isotropic; the stresses "
            "below a line contact are known in the isotropic bodies of a HalfSpace: request the other one."
        )
    return body.poisson


def stresses(contact: LineContact, x: Array, z: Array) -> LineFields:
    """Return the stresses at places in the axes of the body, z >= 0, of one shape."""
    x, z = np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(z, dtype=float))
    whole, slope = np.zeros((2, x.size), dtype=complex)
    away, deep = np.abs(x).ravel(), z.ravel()
    below = deep > 0.0
    bed, a, rim_load = contact.bed, contact.half_width, contact.rim_load
    whole[below], slope[below] = bed.potential(away[below], deep[below], a, rim_load)
    whole[~below] = bed.surface_potential(away[~below], a, rim_load)
    side = np.where(x.ravel() < 0.0, -1.0, 1.0)  # F(-conj(zeta)) = -conj(F(zeta))
    u, v = side * whole.real, whole.imag
    du, dv = deep * slope.real, side * deep * slope.imag
    mu = contact.friction
    along = v + du - mu * (2.0 * u - dv)
    across = v - du - mu * dv
    shear = -dv + mu * (v + du)
    parts = (along, contact.poisson * (along + across), across, shear)
    return LineFields(x, z, *(part.reshape(x.shape) for part in parts))


def greatest(contact: LineContact, measure: Callable[[LineFields], Array]) -> Placed:
    """Return the greatest of a stress and its place, sought on grids that close in on it.

    Parameters
    ----------
    contact : LineContact
    measure
        Takes the fields, returns what is compared [Pa].
    """
    from scipy.ndimage import maximum_filter

    x, z = _grid(contact)
    coarse = measure(stresses(contact, x[:, None], z[None, :]))
    peaks = np.argwhere(coarse >= maximum_filter(coarse, size=3, mode="nearest"))
    highest = peaks[np.argsort(-coarse[tuple(peaks.T)], kind="stable")][:MOST_PEAKS]
    best = max((_refined(contact, measure, _around(x, i), _around(z, j)) for i, j in highest), key=_value)
    for place in (best._replace(x=0.0), best._replace(z=0.0)):  # on the axis or the surface, up to rounding
        if float(measure(stresses(contact, np.array(place.x), np.array(place.z)))) >= (1.0 - ROUNDING) * best.value:
            best = place
    return _polished(contact, measure, best)


def _value(place: Placed) -> float:
    return place.value


def _polished(contact: LineContact, measure: Callable[[LineFields], Array], best: Placed) -> Placed:
    """Return the place with the digits that a value near its maximum does not show: where a polynomial is level."""
    marks = np.array([contact.half_width, *(b for b, _ in contact.bed.kinks)])
    near = float(np.min(np.abs(abs(best.x) - marks)))
    reach = POLISHED_SHARE * (best.z if best.z > 0.0 else near)
    if reach == 0.0:
        return best
    nodes = np.cos(np.pi * (np.arange(POLISHING) + 0.5) / POLISHING)
    fit = np.linalg.inv(chebyshev.chebvander(nodes, POLISHING - 1))
    free = np.array([True, best.z > 0.0])
    across, down = best.x + reach * nodes, best.z + reach * free[1] * nodes
    values = measure(stresses(contact, across[:, None], down[None, :]))
    surface = fit @ (values / best.value) @ fit.T
    first = [chebyshev.chebder(surface, axis=axis) for axis in (0, 1)]
    second = [[chebyshev.chebder(part, axis=axis) for axis in (0, 1)] for part in first]
    place = np.zeros(2)
    for _ in range(POLISHING):
        level = np.array([_at(part, place) for part in first])
        bend = np.array([[_at(part, place) for part in row] for row in second])[np.ix_(free, free)]
        if not np.all(np.linalg.eigvalsh(bend) < 0.0):
            return best
        place[free] -= np.linalg.solve(bend, level[free])
        if np.max(np.abs(place)) > 1.0:
            return best
    return best._replace(x=best.x + reach * float(place[0]), z=best.z + reach * float(place[1]))


def _at(series: Array, place: Array) -> float:
    return float(chebyshev.chebval2d(float(place[0]), float(place[1]), series))


def _around(places: Array, index: int) -> Array:
    """Return a finer grid about one of ascending places."""
    low, high = max(index - NEIGHBOURS, 0), min(index + NEIGHBOURS, places.size - 1)
    return np.linspace(places[low], places[high], FINE)


def _refined(contact: LineContact, measure: Callable[[LineFields], Array], x: Array, z: Array) -> Placed:
    for _ in range(REFINEMENTS):
        found = measure(stresses(contact, x[:, None], z[None, :]))
        i, j = (int(index) for index in np.unravel_index(np.argmax(found), found.shape))
        best = Placed(float(found[i, j]), float(x[i]), float(z[j]))
        x, z = _around(x, i), _around(z, j)
    return best


def _grid(contact: LineContact) -> tuple[Array, Array]:
    """Return places and depths, dense towards the edge, the kinks and the surface."""
    a = contact.half_width
    beside = np.geomspace(CLOSEST, 1.0, PLACES_BESIDE)
    marks = np.array([0.0, a, *(b for b, _ in contact.bed.kinks if b < a)])
    x = np.unique(
        np.abs(np.concatenate([marks, *(mark + sign * a * beside for mark in marks for sign in (-1.0, 1.0))]))
    )
    x = x[x <= WIDTHS_SEARCHED * a]
    if contact.friction != 0.0:
        x = np.concatenate([-x[:0:-1], x])
    return x, np.append(0.0, a * np.geomspace(CLOSEST, DEEPEST_SEARCHED, DEPTHS))
