r"""The approach of two bodies in a line contact, against points that are stated.

The surface of a half-plane sinks without bound under a force per length, so that a line contact has no depth as such.
Against a point at the depth d on the axis below the middle it sinks by

.. math:: \delta = \frac{1-\nu^2}{E}\Big[2I - \frac{d\,f(d)}{1-\nu}\Big] , \qquad
          f(z) = \frac{E^*}\pi\int_0^a\frac{w'(c)}{\sqrt{c^2+z^2}}\,\mathrm dc , \qquad I = \int_0^d f\,\mathrm dz ,

the compression of the axis by the stresses of `winkler.problems.line.stress`.  For a cylinder and :math:`d\gg a` it is
:math:`P(1-\nu^2)/(\pi E)\,[2\ln(2d/a) - \nu/(1-\nu)]`.

References
----------
K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 5.6, doi:10.1017/CBO9781139171731
"""

from __future__ import annotations

from numbers import Real

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array
from winkler.problems.line.references import PlateBase, Reference, RollerCentre
from winkler.values.errors import InvalidInput, OutsideValidity

Place = float | Reference | None
"""A point on the axis: its depth [m], a finite body, or none in a rigid body."""
WIDEST = 0.2
"""Greatest half-width over the size of a finite body: the error is of the order of its square."""


def approach(
    bed: LineFoundation,
    half_width: float,
    rim_load: float,
    first: Place,
    second: Place,
) -> float:
    """Return how far two points have come together [m], one in each body.

    Parameters
    ----------
    bed : LineFoundation
    half_width, rim_load : float
        As of `LineFoundation.pressure`.
    first, second : float, RollerCentre, PlateBase or None
        Depths [m] of the points in the elastic bodies, or finite bodies; of a rigid one it does not matter.
    """
    medium = bed.medium
    if not isinstance(medium, HalfSpace):
        raise OutsideValidity("The approach of a line contact needs isotropic bodies: give a HalfSpace.")
    total = 0.0
    for body, place, name in ((medium.first, first, "first"), (medium.second, second, "second")):
        if not isinstance(body, Elastic):
            continue
        depth = depth_of(place, name, half_width)
        if half_width > 0.0:
            total += _compression(bed, half_width, rim_load, body, depth)
        if half_width > 0.0 and isinstance(place, RollerCentre | PlateBase):
            total += _finite(bed, half_width, rim_load, body, place)
    return total


def depth_of(place: Place, name: str, half_width: float) -> float:
    """Return how far below the surface a point lies [m]; refuse one that is not stated, and a strip too wide for it.

    Parameters
    ----------
    place : float, RollerCentre, PlateBase or None
    name : str
        Which body it is in.
    half_width : float
        a [m].
    """
    depth = place.depth if isinstance(place, RollerCentre | PlateBase) else place
    if not isinstance(depth, Real) or not 0.0 < depth < np.inf:
        raise InvalidInput(
            "A line contact has no depth of its own, because the surface of a half-plane sinks without bound. Give "
            f"what it is counted against: a positive, finite depth below the {name} body's surface, "
            "RollerCentre(radius) or PlateBase(thickness)."
        )
    if depth is not place and half_width > WIDEST * depth:
        raise OutsideValidity(
            f"The half-width {half_width:.6g} m is more than {WIDEST:g} of the {name} body's radius or thickness "
            f"{depth:.6g} m, which must be large against it; press less, or give a depth."
        )
    return float(depth)


def nearing(c: Array, depth: float, poisson: float) -> Array:
    """Return how much nearer a point comes under a flat strip, over its load times (1 - nu^2)/E.

    Parameters
    ----------
    c : ndarray
        Half-width of the strip [m], positive.
    depth : float
        Depth of the point [m].
    poisson : float
        nu of its body.
    """
    return np.asarray((2.0 * np.arcsinh(depth / c) - depth / np.hypot(c, depth) / (1.0 - poisson)) / np.pi)


def _finite(bed: LineFoundation, half_width: float, rim_load: float, body: Elastic, place: Reference) -> float:
    borne = float(bed.load_profile(np.array([half_width]))[0]) + rim_load + float(np.sum(bed.beside(half_width)[1]))
    force = bed.medium.modulus * borne
    return force * (1.0 - body.poisson**2) / (np.pi * body.young) * place.added(body.poisson)


def _compression(bed: LineFoundation, half_width: float, rim_load: float, body: Elastic, depth: float) -> float:
    edges = [b for b, _ in bed.kinks]

    def share(c: Array) -> Array:
        return bed.load_profile_slope(c) * nearing(np.where(c > 0.0, c, half_width), depth, body.poisson)

    widths, loads = bed.beside(half_width)
    whole = float(abel.integral(share, edges, np.array(half_width)))
    whole += rim_load * float(nearing(np.array(half_width), depth, body.poisson))
    whole += float(loads @ nearing(widths, depth, body.poisson))
    return float(bed.medium.modulus * (1.0 - body.poisson**2) / body.young * whole)
