"""Stresses in layers below a line contact: the fields at places, and the greatest of each layer."""

from __future__ import annotations

import math

import numpy as np

from winkler.errors import OutsideValidity
from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.materials.elastic import Elastic
from winkler.media.layered.plane_interior import PlaneWaves, added_stresses, plane_waves
from winkler.media.medium import rigid_body
from winkler.numerics.types import Array
from winkler.problems.line.stress import LineContact, LineFields, stresses
from winkler.problems.line.strip import Strip
from winkler.values import value, words

__all__ = ["LayerStress", "greatest_within", "layer_stresses", "layered_fields", "refuse_friction", "waves_below"]

PLACES, DEPTHS = 25, 13
"""Places and depths of the first grid in each layer."""
FINE, REFINEMENTS = 7, 11
WIDTHS_SEARCHED, DEEPEST_SEARCHED = 2.0, 4.0
"""How far beside the middle and below the surface a maximum is sought, over the half-width or the thickness."""
CLOSEST = 1e-4
INTERFACE_PLACES = 65


@value
class LayerStress:
    """The greatest stresses of one layer under a line contact.

    Parameters
    ----------
    layer : int
        Number of the layer from the surface, 1 the uppermost; the body under the layers comes last.
    von_mises, x, z : float
        Greatest von Mises stress [Pa] and its place [m], beside the middle on the right, and below the surface.
    interface_shear, interface_x : float
        Greatest shear stress on its lower face [Pa], positive, and its place [m]; nan below the last interface.
    """

    __words__ = words(
        layer=("", "", "number of the layer from the surface"),
        x=("x", "m", "place along the surface"),
        interface_shear=(r"\tau_i", "Pa", "greatest shear stress on the lower face of the layer"),
        interface_x=("x_i", "m", "place of the greatest shear stress on the lower face"),
    )

    layer: int
    von_mises: float
    x: float
    z: float
    interface_shear: float
    interface_x: float


def refuse_friction(friction: float) -> None:
    """Refuse friction."""
    if np.ndim(friction) > 0 or friction != 0.0:
        raise OutsideValidity(
            "The stresses below a line contact that slides on layers are not known here: leave friction at zero, or "
            "give a LineFoundation of homogeneous bodies."
        )


def waves_below(bed: LayeredLineFoundation, strip: Strip, farthest: float) -> PlaneWaves:
    """Return the pressure of a strip as waves, for places up to a distance [m] from the middle."""
    carried = bed.carried(*strip)

    def transform(k: Array) -> Array:
        return bed.medium.modulus * bed.transform(k, carried)

    return plane_waves(bed.medium, strip.half_width, farthest, transform)


def layered_fields(
    bed: LayeredLineFoundation, strip: Strip, x: Array, z: Array, below: bool, waves: PlaneWaves | None = None
) -> LineFields:
    """Return the stresses at places of one shape, z as requested.

    Parameters
    ----------
    bed : LayeredLineFoundation
    strip : Strip
    x, z : ndarray
        [m].
    below : bool
        In the layered body.
    waves : PlaneWaves, optional
        Of this strip, for places as far away as these.
    """
    medium = bed.medium
    body = medium.layers[0].solid if below else medium.second
    if not isinstance(body, Elastic):
        raise rigid_body(below)
    x, z = np.broadcast_arrays(x, z)
    across, deep = x.ravel(), np.abs(z).ravel()
    top = medium.layers[0].thickness if below else math.inf
    parts = np.zeros((4, across.size))
    upper = deep <= top
    own = stresses(LineContact(bed, *strip, body.poisson, 0.0), across[upper], deep[upper])
    parts[:, upper] = own.xx_stress, own.yy_stress, own.zz_stress, own.xz_stress
    if below and across.size:
        if waves is None:
            waves = waves_below(bed, strip, float(np.max(np.abs(across))))
        parts += added_stresses(medium, waves, across, deep)
    return LineFields(x, z, *(part.reshape(x.shape) for part in parts))


def layer_stresses(bed: LayeredLineFoundation, strip: Strip) -> tuple[LayerStress, ...]:
    """Return the greatest stresses of each layer, and of an elastic body under them.

    Parameters
    ----------
    bed : LayeredLineFoundation
    strip : Strip
    """
    medium = bed.medium
    bottoms = np.cumsum([layer.thickness for layer in medium.layers]).tolist()
    waves = waves_below(bed, strip, WIDTHS_SEARCHED * strip.half_width)
    found, top = [], 0.0
    for number, bottom in enumerate(bottoms, 1):
        shear, place = _interface(bed, strip, bottom)
        found.append(LayerStress(number, *greatest_within(bed, strip, top, bottom, waves), shear, place))
        top = bottom
    if isinstance(medium.on, Elastic):
        greatest = greatest_within(bed, strip, top, math.inf, waves)
        found.append(LayerStress(len(bottoms) + 1, *greatest, math.nan, math.nan))
    return tuple(found)


def greatest_within(
    bed: LayeredLineFoundation,
    strip: Strip,
    top: float,
    bottom: float,
    waves: PlaneWaves,
    refinements: int = REFINEMENTS,
) -> tuple[float, float, float]:
    """Return the greatest von Mises stress between two depths and its place, on grids that close in on it.

    Parameters
    ----------
    bed : LayeredLineFoundation
    strip : Strip
    top, bottom : float
        Depths of one layer [m], or of the body under the layers, which ends at infinity.
    waves : PlaneWaves
        Of the strip, for places up to twice its half-width from the middle.
    refinements : int
        How often the grid is refined.
    """
    if math.isinf(bottom):
        top, bottom = np.nextafter(top, math.inf), top + DEEPEST_SEARCHED * max(strip.half_width, top)
    a = strip.half_width
    x = np.unique(np.concatenate([a * np.linspace(0.0, WIDTHS_SEARCHED, PLACES), [a * (1.0 - CLOSEST)]]))
    lower = min(bottom, top + DEEPEST_SEARCHED * a)
    below = np.geomspace(CLOSEST, 1.0, DEPTHS)
    z = np.unique(np.concatenate([[top], top + (lower - top) * below, np.linspace(top, lower, DEPTHS), [bottom]]))
    z = z[z <= bottom]
    first = top if top == 0.0 else np.nextafter(top, math.inf)
    best = (0.0, 0.0, 0.0)
    for _ in range(refinements + 1):
        depth = np.maximum(z, first)
        level = layered_fields(bed, strip, x[:, None], depth[None, :], True, waves).von_mises
        i, j = (int(index) for index in np.unravel_index(np.argmax(level), level.shape))
        if level[i, j] > best[0]:
            best = (float(level[i, j]), float(x[i]), float(depth[j]))
        x, z = (np.linspace(row[max(at - 1, 0)], row[min(at + 1, row.size - 1)], FINE) for row, at in ((x, i), (z, j)))
    return best


def _interface(bed: LayeredLineFoundation, strip: Strip, depth: float) -> tuple[float, float]:
    """Return the greatest shear stress at one depth, and its place."""
    x = np.linspace(0.0, WIDTHS_SEARCHED * (strip.half_width + depth), INTERFACE_PLACES)
    waves = waves_below(bed, strip, float(x[-1]))
    best = (0.0, 0.0)
    for _ in range(REFINEMENTS + 1):
        level = np.abs(layered_fields(bed, strip, x, np.full(x.shape, depth), True, waves).xz_stress)
        at = int(np.argmax(level))
        if level[at] > best[0]:
            best = (float(level[at]), float(x[at]))
        x = np.linspace(x[max(at - 1, 0)], x[min(at + 1, x.size - 1)], FINE)
    return best
