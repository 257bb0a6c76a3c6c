"""Stresses in layers below a line contact: the fields at places, and the greatest of each layer."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.materials.elastic import Elastic, Rigid
from winkler.media.layered.plane_interior import PlaneWaves, added_stresses
from winkler.media.layered.wave_constants import Body
from winkler.media.medium import rigid_body
from winkler.media.offers import LayerStack, PlaneMedium, offers
from winkler.numerics.equations.highest import MOST_ROUNDS, highest
from winkler.numerics.types import Array
from winkler.problems.line.greatest_stress import Measure, Placed, greatest, sought, von_mises
from winkler.problems.line.peak_pressure import is_sharp
from winkler.problems.line.stress import LineContact, LineFields, Strip, poisson_of, stresses
from winkler.problems.normal.strong_parts import StrongPart
from winkler.values.errors import OutsideValidity
from winkler.values.value import value, words

PLACES, DEPTHS = 25, 13
"""Places and depths of the first grid in each layer."""
STARTS = 2
"""Places of the grid from which the greatest is sought."""
WIDTHS_SEARCHED, DEEPEST_SEARCHED = 2.0, 4.0
"""How far beside the middle and below its upper face the maximum in a layer is sought, over the width of its load."""
CLOSEST = 1e-4
NEAR = 0.05
"""Distance below a sharp place at which the search begins, over the half-width."""
INTERFACE_PLACES = 65


@value
class LayerStress:
    """The maximum stresses of one layer under a line contact.

    Parameters
    ----------
    layer : int
        Number of the layer from the surface, 1 the uppermost; the body under the layers comes last.
    von_mises, x, z : float
        Maximum von Mises stress [Pa] and its place [m]; without friction the place in the right half of the layer.
    interface_shear, interface_x : float
        Maximum shear stress on its lower face [Pa], positive, and its place [m]; nan below the last interface.
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


def waves_for_search(bed: LayeredLineFoundation, strip: Strip, deepest: float) -> PlaneWaves:
    """Return the pressure of a strip as waves, for `greatest_within` layers that begin at most so deep [m]."""
    return bed.waves_below(*strip, WIDTHS_SEARCHED * _spread(strip, deepest))


def _spread(strip: Strip, depth: float) -> float:
    """Return half of the width over which the load is spread at a depth [m]."""
    return math.hypot(strip.half_width, depth)


def fields_below(
    bed: Any,
    strip: Strip,
    x: Array,
    z: Array,
    below: bool,
    friction: float = 0.0,
    waves: PlaneWaves | None = None,
) -> LineFields:
    """Return the stresses at places of one shape, z as requested.

    Parameters
    ----------
    bed : LineBed or PeriodicBed
    strip : Strip
    x, z : ndarray
        [m].
    below : bool
        In the first body, which may have layers.
    friction : float
        Traction on the body along x over the pressure [-].
    waves : PlaneWaves, optional
        Of this strip on layers, for places as far away as these.
    """

    def own(across: Array, deep: Array, poisson: float) -> LineFields:
        return stresses(LineContact(bed, *strip, poisson, friction), across, deep)

    def waves_below(farthest: float) -> PlaneWaves:
        return bed.waves_below(*strip, farthest) if waves is None else waves

    if not offers(bed.medium, PlaneMedium):
        return dataclasses.replace(own(x, np.abs(z), poisson_of(bed.medium, below)), z=z)
    bed.refuse_dragged(friction)
    return in_layers(bed.layered, own, waves_below, x, z, below, friction)


def in_layers(
    medium: LayerStack,
    own: Callable[[Array, Array, float], LineFields],
    waves_below: Callable[[float], PlaneWaves],
    x: Array,
    z: Array,
    below: bool,
    friction: float,
) -> LineFields:
    """Return the stresses of one pressure at places of one shape, z as requested.

    Parameters
    ----------
    medium : LayerStack
    own
        Of the half-plane that carries the surface: takes places, depths [m] and Poisson's ratio.
    waves_below
        Takes the farthest place [m], and returns the pressure as waves.
    x, z : ndarray
        [m].
    below : bool
        In the layered body.
    friction : float
        Traction on the body along x over the pressure [-].
    """
    x, z = np.broadcast_arrays(x, z)
    across, deep = x.ravel(), np.abs(z).ravel()
    top = medium.layers[0].thickness if below else math.inf
    parts = np.zeros((4, across.size))
    upper = deep <= top
    if upper.any():
        body = medium.layers[0].solid if below else medium.second
        found = own(across[upper], deep[upper], _isotropic(body, below))
        parts[:, upper] = found.xx_stress, found.yy_stress, found.zz_stress, found.xz_stress
    if below and across.size:
        waves = waves_below(float(np.max(np.abs(across))))
        parts += added_stresses(medium, waves, across, deep, friction)
    return LineFields(x, z, *(part.reshape(x.shape) for part in parts))


def _isotropic(body: Body, below: bool) -> float:
    """Return Poisson's ratio of the body or layer that carries the surface; refuse one without stresses."""
    if isinstance(body, Rigid):
        raise rigid_body(below)
    if not isinstance(body, Elastic):
        raise OutsideValidity(
            "The stresses inside a transversely isotropic uppermost layer or second body are not implemented; "
            "request places in the layers below it."
        )
    return body.poisson


def layer_stresses(bed: LayeredLineFoundation, strip: Strip, friction: float) -> tuple[LayerStress, ...]:
    """Return the greatest stresses of each layer, and of an elastic body under them.

    Parameters
    ----------
    bed : LayeredLineFoundation
    strip : Strip
    friction : float
        Traction on the body along x over the pressure [-].
    """
    waves = waves_for_search(bed, strip, bed.layered.thickness)
    found = []
    for number, (top, bottom) in enumerate(bed.layered.spans, 1):
        shear, place = _interface(bed, strip, bottom, friction) if math.isfinite(bottom) else (math.nan, math.nan)
        worst = greatest_within(bed, strip, (top, bottom), waves, friction)
        found.append(LayerStress(number, *worst, shear, place))
    return tuple(found)


def greatest_in_part(
    bed: Any,
    strip: Strip,
    part: StrongPart,
    friction: float,
    rounds: int = MOST_ROUNDS,
    measure: Measure = von_mises,
) -> Placed:
    """Return the greatest stress of a kind in a part, away from sharp places, and its place; z < 0 in the second body.

    Parameters
    ----------
    bed : LayeredLineFoundation
    strip : Strip
    part : StrongPart
    friction : float
        Traction over pressure [-].
    rounds : int
        As in `winkler.numerics.equations.highest.highest`.
    measure
        Of which kind; von Mises' by default.
    """
    shallowest = NEAR * strip.half_width if part.top == 0.0 and is_sharp(bed, *strip) else 0.0
    if not (part.first and offers(bed.medium, PlaneMedium)):
        contact = LineContact(bed, *strip, part.solid.poisson, friction)
        place = sought(contact, measure, shallowest=shallowest) if shallowest else greatest(contact, measure)
        return place if part.first else place._replace(z=-place.z)
    top = max(part.top, min(shallowest, 0.5 * part.bottom))
    waves = waves_for_search(bed, strip, part.top)
    return greatest_within(bed, strip, (top, part.bottom), waves, friction, rounds, measure)


def greatest_within(
    bed: LayeredLineFoundation,
    strip: Strip,
    span: tuple[float, float],
    waves: PlaneWaves,
    friction: float,
    rounds: int = MOST_ROUNDS,
    measure: Measure = von_mises,
) -> Placed:
    """Return the greatest stress of a kind between two depths and its place.

    Parameters
    ----------
    bed : LayeredLineFoundation
    strip : Strip
    span : tuple of float
        Depths of one layer [m], or of the body under the layers, which ends at infinity.
    waves : PlaneWaves
        Of the strip, from `waves_for_search`.
    friction : float
        Traction on the body along x over the pressure [-].
    rounds : int
        As in `winkler.numerics.equations.highest.highest`.
    measure
        Of which kind; von Mises' by default.
    """
    top, bottom = span
    wide = _spread(strip, top)
    if top > 0.0:  # an interface belongs to the upper layer
        top = float(np.nextafter(top, math.inf))
    bottom = min(bottom, top + DEEPEST_SEARCHED * wide) if math.isinf(bottom) else bottom
    near = strip.half_width * np.array([1.0 - CLOSEST, 1.0])
    x = np.unique(np.concatenate([wide * np.linspace(0.0, WIDTHS_SEARCHED, PLACES), near]))
    lower = min(bottom, top + DEEPEST_SEARCHED * wide)
    below = np.geomspace(CLOSEST, 1.0, DEPTHS)
    z = np.unique(np.concatenate([[top], top + (lower - top) * below, np.linspace(top, lower, DEPTHS), [bottom]]))
    even = friction == 0.0

    def field(across: Array, depth: Array) -> Array:
        places = np.abs(across) if even else across
        return measure(fields_below(bed, strip, places, depth, True, friction, waves))

    found = highest(
        field, [_both_sides(x, even), z[z <= bottom]], [(-x[-1], x[-1]), (top, bottom)], starts=STARTS, rounds=rounds
    )
    across, depth = found.place
    return Placed(found.value, abs(across) if even else across, depth)


def _both_sides(x: Array, even: bool) -> Array:
    """Return places x >= 0, and where stresses are not `even` also those on the other side."""
    return x if even else np.concatenate([-x[:0:-1], x])


def _interface(bed: LayeredLineFoundation, strip: Strip, depth: float, friction: float) -> tuple[float, float]:
    """Return the greatest shear stress at one depth, and its place."""
    x = np.linspace(0.0, WIDTHS_SEARCHED * (strip.half_width + depth), INTERFACE_PLACES)
    waves = bed.waves_below(*strip, float(x[-1]))

    def shear(across: Array) -> Array:
        fields = fields_below(bed, strip, across, np.full(across.shape, depth), True, friction, waves)
        return np.abs(fields.xz_stress)

    found = highest(shear, [_both_sides(x, friction == 0.0)])
    return found.value, found.place[0]
