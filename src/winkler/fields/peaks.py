"""The greatest equivalent stress in a body under a contact, and its place."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, overload

import numpy as np

from winkler.fields.restoration import below_surface, is_twisted, springs_of
from winkler.foundation.sheared import ShearedSprings
from winkler.foundation.sheared_fields import BodyFields, body_of_sheared
from winkler.media.interior.peak import greatest, greatest_around
from winkler.media.offers import LayerStack, offers
from winkler.numerics.types import Array
from winkler.problems.answer import Dragged, Restorable, SelfRestoring, is_dragged, is_self_restoring
from winkler.problems.normal.greatest_stress import INTERFACE_OFFSET, least_depth
from winkler.values.checks.outline import refuse_unless_round
from winkler.values.value import value

if TYPE_CHECKING:
    from winkler.problems.friction.torsion_states import TorsionState

LEAST_JUMP_RATIO = 1e-9
"""Jump of the springs at the edge over their greatest displacement that is rounding."""
LEAST_DEPTH_RATIO = 1e-3
"""Stresses of a twist are searched for below this depth, in contact radii."""


@value
class PeakStress:
    """The maximum equivalent stress below a contact, and its place.

    Parameters
    ----------
    von_mises : float
        [Pa].
    r, z : float
        Coordinates [m].
    """

    von_mises: float
    r: float
    z: float


@value
class PlacedStress:
    """The maximum equivalent stress in a body under a sheared contact, and its place.

    Parameters
    ----------
    von_mises : float
        [Pa].
    x, y, z : float
        Coordinates [m].
    """

    von_mises: float
    x: float
    y: float
    z: float


@overload
def peak_stress(solution: Restorable, *, below: bool = True) -> PeakStress: ...
@overload
def peak_stress(solution: Dragged | SelfRestoring | TorsionState, *, below: bool = True) -> PlacedStress: ...
def peak_stress(
    solution: Restorable | Dragged | SelfRestoring | TorsionState, *, below: bool = True
) -> PeakStress | PlacedStress:
    """Return the maximum von Mises stress and its position; in layers on both sides of each interface.

    Parameters
    ----------
    solution
        The solution of a problem, for one load.
    below
        Whether to search in the first body (z > 0, default) or in the second (False).

    Returns
    -------
    PeakStress or PlacedStress
        PlacedStress for a sheared or twisted contact. In a twisted contact the search begins at a thousandth of the
        contact radius below the surface. Infinite at a sharp kink, edge or apex.
    """
    if is_twisted(solution):
        return _twisted_peak(solution, 1.0 if below else -1.0)
    if is_self_restoring(solution):
        sign = 1.0 if below else -1.0
        spans = _spans(solution.medium, sign)
        return _placed_peak(solution.body_fields, solution.radius, solution.sharp_places(), sign, spans)
    if is_dragged(solution):
        return _sheared_peak(solution.sheared, 1.0 if below else -1.0)
    pressed = springs_of(solution)
    if pressed.radius == 0.0:
        return PeakStress(0.0, 0.0, 0.0)
    sharp = [b for b, strength in pressed.kinks if strength != 0.0]
    if abs(pressed.edge) > LEAST_JUMP_RATIO * float(np.max(np.abs(pressed.value(np.array([0.0, pressed.radius]))))):
        sharp.append(pressed.radius)
    if sharp:
        return PeakStress(float("inf"), sharp[0], 0.0)
    sign = 1.0 if below else -1.0

    def field(r: Array, z: Array) -> Array:
        return below_surface(pressed, r, sign * z, below).von_mises

    spans = _spans(pressed.bed.medium, sign)
    least = least_depth(pressed)
    place = max(greatest(field, pressed.radius, top=max(top, least), bottom=bottom) for top, bottom in spans)
    return PeakStress(place.value, place.r, sign * place.z)


def _spans(medium: object, sign: float) -> tuple[tuple[float, float], ...]:
    """Return the depths between which stresses are continuous [m]: those of layers, or of all of the body."""
    if sign < 0.0 or not offers(medium, LayerStack):
        return ((0.0, math.inf),)
    return tuple((top * (1.0 + INTERFACE_OFFSET), bottom) for top, bottom in medium.spans)


def _sheared_peak(sheared: ShearedSprings, sign: float) -> PlacedStress:
    pressed = sheared.pressed
    refuse_unless_round(pressed, "peak_stress", "the stress below the surface")
    sharp = [b for b, strength in pressed.kinks if strength != 0.0]
    sharp += [part.radius for parts in sheared.components for part in parts if part.edge != 0.0]
    spans = _spans(pressed.bed.medium, sign)
    return _placed_peak(lambda x, y, z: body_of_sheared(sheared, x, y, z), pressed.radius, sharp, sign, spans)


def _placed_peak(
    body: Callable[..., BodyFields],
    radius: float,
    sharp: Sequence[float],
    sign: float,
    spans: tuple[tuple[float, float], ...],
) -> PlacedStress:
    """Return the greatest stress in one body; z = 0 belongs to the second one if that is requested."""
    if radius == 0.0:
        return PlacedStress(0.0, 0.0, 0.0, 0.0)
    if sharp:
        return PlacedStress(float("inf"), sharp[0], 0.0, 0.0)
    tiny = np.finfo(float).tiny
    found = []
    for top, bottom in spans:
        thickness = bottom - top
        scale = min(1.0, thickness / radius)  # in a thin layer the depths of the search are shares of it

        def depth(z: Array, top: float = top, thickness: float = thickness, scale: float = scale) -> Array:
            return np.asarray(top + np.minimum(scale * radius * z, thickness))

        def field(x: Array, y: Array, z: Array, depth: Callable[[Array], Array] = depth) -> Array:
            deep = depth(z) if sign > 0.0 else -np.maximum(radius * z, tiny)
            return body(radius * x, radius * y, deep).von_mises

        place = greatest_around(field)
        z = float(depth(np.array(place.z)))
        found.append(PlacedStress(place.value, radius * place.x, radius * place.y, sign * z))
    return max(found, key=lambda one: one.von_mises)


def _twisted_peak(state: TorsionState, sign: float) -> PlacedStress:
    if state.radius == 0.0:
        return PlacedStress(0.0, 0.0, 0.0, 0.0)
    if any(strength != 0.0 for _, strength in state.springs.kinks) or state.springs.edge != 0.0:
        return PlacedStress(float("inf"), state.radius, 0.0, 0.0)
    from winkler.problems.friction.torsion_fields import body_of_twisted

    place = greatest(
        lambda r, z: body_of_twisted(state, r, np.zeros(r.shape), sign * _off(z, state.radius)).von_mises, state.radius
    )
    return PlacedStress(place.value, place.r, 0.0, sign * float(_off(np.array(place.z), state.radius)))


def _off(z: Array, radius: float) -> Array:
    """Return depths kept off the surface, where the field of a twist is not known."""
    return np.maximum(z, LEAST_DEPTH_RATIO * radius)
