"""A height map that is pressed, under one load."""

from __future__ import annotations

from winkler.numerics.types import Array
from winkler.values.value import value, words


@value
class SurfaceState:
    """A height map under one load.

    Parameters
    ----------
    depth : float
        d [m] since the highest point touched; of a periodic map by how much the mean planes have approached since then.
    force : float
        F_N [N]; for a periodic map on one period.
    stiffness : float
        Of a flat punch of the shape of the contact [N/m]: of elastic bodies dF/dd, with a hardness that of unloading.
        Infinite where a periodic map touches everywhere.
    area : float
        Of the contact [m^2], pixels counted and the excess along its edge taken off.
    area_error : float
        Estimated error of the area that the grid leaves [m^2]: a quarter of a pixel all along the edge, within which
        circles of three pixels and more lie; a straight edge along the grid may be half a pixel off.
    hardened_share : float
        Part of the pixels in contact that bear the hardness; zero of elastic bodies.
    mean_gap : float
        Mean distance of the surfaces over the map [m].
    penetration : float
        Greatest overlap that the solver left, over the depth.
    misfit : float
        Sum of pressure times gap that it left, over F d.
    pressure : ndarray, (nx, ny)
        p [Pa] in every pixel.
    separation : ndarray, (nx, ny)
        Distance of the surfaces [m].
    """

    __words__ = words(misfit=("", "", "pressure times gap that is left, over force times depth"))

    depth: float
    force: float
    stiffness: float
    area: float
    area_error: float
    hardened_share: float
    mean_gap: float
    penetration: float
    misfit: float
    pressure: Array
    separation: Array
