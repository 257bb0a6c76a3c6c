r"""How far two points come together in a line contact of bodies that relax.

A flat strip of the half-width c brings a point at the depth d of an elastic body nearer by

.. math:: \frac{1-\nu^2}{\pi E}\Bigl[2\operatorname{arsinh}\frac dc - \frac1{1-\nu}\frac d{\sqrt{c^2+d^2}}\Bigr]

under a unit of load; in a body that relaxes the load is replaced by its hereditary integral with the creep of the
body.
"""

from __future__ import annotations

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.materials.elastic import Elastic, Rigid
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace, share_of_creep
from winkler.numerics.types import Array
from winkler.problems.line.approach import Place, depth_of, nearing
from winkler.problems.line.references import PlateBase, RollerCentre
from winkler.problems.line_viscoelastic.layered_strips import RelaxingBed, elastic_line, layered_approaches
from winkler.values.errors import OutsideValidity

NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)


def approach_of_strips(
    bed: RelaxingBed,
    half_width: float,
    strips: tuple[Array, Array, Array],
    places: tuple[Place, Place],
) -> Array:
    """Return how far two points have come together at every moment ``(m,)`` [m], one in each body.

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
    half_width : float
        Greatest half-width [m].
    strips : tuple of ndarray
        Half-widths c [m] ``(n,)``, loads q that wider strips bear [N/m] ``(m, n)``, and their hereditary integrals with
        the creep [m] ``(m, n)``.
    places : tuple
        As of `winkler.problems.line.approach.approach`.
    """
    c, borne, sunk = strips
    medium = bed.medium
    if offers(medium, RelaxingByWaves):
        raise OutsideValidity(
            f"LineViscoelasticIndentation: {medium.reason} The approach of points inside the medium is therefore "
            "not known. Read half-width and pressure."
        )
    if isinstance(bed, LayeredLineFoundation):
        line = elastic_line(bed)
        return layered_approaches(line, c, line.medium.modulus * sunk, places)
    assert isinstance(medium, ViscoelasticHalfSpace)
    bodies, total = (medium.first, medium.second), np.zeros(len(borne))
    for body, other, place, name in zip(bodies, bodies[::-1], places, ("first", "second"), strict=True):
        if isinstance(body, Rigid):
            continue
        depth = depth_of(place, name, half_width)
        if isinstance(body, Elastic):
            own = borne * (1.0 - body.poisson**2) / body.young
        elif isinstance(other, Elastic):
            own = sunk - borne * (1.0 - other.poisson**2) / other.young
        elif isinstance(other, ViscoelasticSolid):
            own = sunk * share_of_creep(body, other)
        else:
            own = sunk
        added = place.added(body.poisson) if isinstance(place, RollerCentre | PlateBase) else 0.0
        near = _mean_nearing(bed, c, depth, body.poisson)
        total += -np.diff(own, axis=1) @ near + own[:, -1] * nearing(c[-1:], depth, body.poisson)
        total += added / np.pi * own[:, 0]
    return total


def _mean_nearing(bed: LineFoundation, c: Array, depth: float, poisson: float) -> Array:
    """Return the mean of `nearing` over w between the half-widths."""
    part = 0.5 * (1.0 + NODES)
    within = c[:-1, None] + np.diff(c)[:, None] * part**2
    weight = WEIGHTS * part * bed.load_profile_slope(within.ravel()).reshape(within.shape)
    mean = np.sum(weight * nearing(within, depth, poisson), axis=1) / np.sum(weight, axis=1)
    return np.asarray(mean)
