r"""By how much the cone that stands for a pyramid is wrong on a layer.

The cone has the force of the pyramid on a homogeneous half-space.  On a layer it has not: over a thin, compressible
layer on a rigid base the force is proportional to the volume inside the layer, and the cone's is greater by
:math:`\pi(\tfrac\pi2C_N)^2/(N\tan\tfrac\pi N)-1`, 5.4 % of four faces and 16 % of three.  What lies between was
computed by boundary elements, with the kernel of one layer bonded to a half-space (tests/profiles/pyramids).
"""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.on_medium import UnderProfile
from winkler.materials.elastic import Elastic, TransverselyIsotropic
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.medium import Medium
from winkler.media.offers import LayerStack, offers
from winkler.numerics.types import Array
from winkler.profiles.pyramids.pyramid import FORCE_CONSTANTS, PyramidShape, cross_section_constant
from winkler.profiles.pyramids.rounded_pyramid import RoundedPyramid
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing, standing_of

RADII = np.array([0.1, 0.3, 1.0, 3.0, 10.0])
"""Radii of contact over the thickness, the columns."""
CONTRASTS = np.array([0.1, 0.3, 1.0, 3.0, 10.0, 1000.0])
"""E / (1 - nu^2) of the base over that of the layer, the rows; the last is that of a rigid base."""
POISSONS = (0.3, 0.5)
"""Poisson's ratio of the layer; that of the base is 0.3."""
ERRORS: dict[int, Array] = {
    3: np.array(
        [
            [
                [-0.0004, -0.0051, -0.0807, -0.1269, -0.0350],
                [-0.0003, -0.0038, -0.0454, -0.0611, -0.0170],
                [0.0, 0.0, 0.0, 0.0, 0.0],
                [0.0000, 0.0029, 0.0380, 0.0507, 0.0238],
                [0.0000, 0.0046, 0.0646, 0.1019, 0.0638],
                [0.0001, 0.0055, 0.0818, 0.1570, 0.1614],
            ],
            [
                [-0.0004, -0.0052, -0.0792, -0.1250, -0.0354],
                [-0.0003, -0.0035, -0.0408, -0.0571, -0.0198],
                [0.0, 0.0, 0.0, 0.0, 0.0],
                [0.0001, 0.0053, 0.0657, 0.0635, 0.0031],
                [0.0002, 0.0077, 0.1088, 0.1448, 0.0321],
                [0.0003, 0.0089, 0.1399, 0.3365, 0.4867],
            ],
        ]
    ),
    4: np.array(
        [
            [
                [-0.0001, -0.0016, -0.0311, -0.0690, -0.0165],
                [-0.0001, -0.0011, -0.0165, -0.0280, -0.0076],
                [0.0, 0.0, 0.0, 0.0, 0.0],
                [0.0000, 0.0009, 0.0126, 0.0185, 0.0094],
                [0.0000, 0.0014, 0.0213, 0.0352, 0.0233],
                [0.0000, 0.0016, 0.0269, 0.0525, 0.0543],
            ],
            [
                [-0.0002, -0.0016, -0.0305, -0.0676, -0.0167],
                [-0.0001, -0.0010, -0.0147, -0.0257, -0.0086],
                [0.0, 0.0, 0.0, 0.0, 0.0],
                [0.0000, 0.0016, 0.0217, 0.0230, 0.0022],
                [0.0001, 0.0023, 0.0355, 0.0477, 0.0138],
                [0.0001, 0.0027, 0.0455, 0.1046, 0.1392],
            ],
        ]
    ),
}
"""Force of the cone over that of the pyramid, less one: Poisson's ratio, rows, columns."""
SMALL_ERROR, LARGE_ERROR = 0.01, 0.15
SOURCE = "own boundary elements of pyramids on a bonded layer (tests/profiles/pyramids)"


def _thin(sides: int) -> float:
    """Return the error over a thin, compressible layer on a rigid base [-]."""
    return math.pi * (0.5 * math.pi * FORCE_CONSTANTS[sides]) ** 2 / cross_section_constant(sides) - 1.0


def pyramid_layer_error(sides: int, radius: float, contrast: float, poisson: float) -> float:
    """Return the force of the cone over that of the pyramid, less one, on a bonded layer; interpolated.

    Parameters
    ----------
    sides : int
        Number of faces; for more than four faces, the error is scaled by that of thin layers.
    radius : float
        Radius of contact over the thickness of the layer [-].
    contrast : float
        E / (1 - nu^2) of the base over that of the layer [-]; infinite of a rigid base.
    poisson : float
        Of the layer [-].

    Returns
    -------
    float
        Relative error of the force [-].

    Raises
    ------
    InvalidInput
        If there are fewer than three faces, or radius or contrast is not positive.

    Examples
    --------
    A contact as wide as the layer is thick, on a rigid base.

    >>> round(pyramid_layer_error(4, 1.0, float("inf"), 0.5), 3)
    0.045
    """
    if sides < 3 or not radius > 0.0 or not contrast > 0.0:
        raise InvalidInput(
            f"pyramid_layer_error: sides {sides!r}, radius {radius!r}, contrast {contrast!r}; give at least three "
            "faces, and positive numbers."
        )
    table = ERRORS[min(sides, 4)] * (_thin(sides) / _thin(4) if sides > 4 else 1.0)
    share = float(np.clip((poisson - POISSONS[0]) / (POISSONS[1] - POISSONS[0]), 0.0, 1.0))
    rows = (1.0 - share) * table[0] + share * table[1]
    column = [np.interp(math.log(radius), np.log(RADII), row) for row in rows]
    return float(np.interp(math.log(min(contrast, CONTRASTS[-1])), np.log(CONTRASTS), column))


def pyramid_notes(bed: Bed, medium: Medium, radius: float) -> tuple[Note, ...]:
    """Return what a pyramid on a medium that is not homogeneous misses; nothing for other bodies.

    Parameters
    ----------
    bed : Bed
    medium : Medium
        That of the bed, elastic.
    radius : float
        a [m] of the deepest contact, positive.
    """
    if not isinstance(bed, UnderProfile) or isinstance(medium, HomogeneousMedium) or radius <= 0.0:
        return ()
    tip = bed.profile
    if not isinstance(tip, PyramidShape | RoundedPyramid):
        return ()
    cone = "The cone that replaces the pyramid has the same force on a homogeneous half-space."
    if not offers(medium, LayerStack) or not _is_coating(medium):
        text = f"{cone} On this body its error is not known; on layers it is up to 7 % with four faces."
        return (Note(Assumption.SHAPE, Standing.APPROXIMATE, text, SOURCE),)
    top, base, contrast = medium.layers[0].solid, medium.on, math.inf
    assert isinstance(top, Elastic)
    if isinstance(base, Elastic):
        contrast = base.young / (1.0 - base.poisson**2) / top.young * (1.0 - top.poisson**2)
    wide = radius / medium.thickness
    error = pyramid_layer_error(tip.sides, wide, contrast, top.poisson)
    several = "" if len(medium.layers) == 1 else " (computed for one layer with the modulus of the uppermost layer)"
    standing = standing_of(abs(error), SMALL_ERROR, LARGE_ERROR)
    advice = "" if standing is Standing.ASYMPTOTIC else ", and fitted moduli have the same error"
    text = (
        f"{cone} Here the contact radius is {wide:.3g} of the thickness of the layers. The force of the cone "
        f"differs from that of the pyramid by about {error:+.2%}{several}{advice}. Below 0.3 of the thickness the "
        "difference is less than 1 %."
    )
    return (Note(Assumption.SHAPE, standing, text, SOURCE),)


def _is_coating(medium: LayerStack) -> bool:
    """Return whether all layers are bonded and isotropic."""
    solids = [layer.solid for layer in medium.stack if layer.bonded]
    return len(solids) == len(medium.stack) and not any(
        isinstance(solid, TransverselyIsotropic) for solid in (*solids, medium.on)
    )
