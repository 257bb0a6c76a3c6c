r"""The greatest von Mises stress in one part of a body under a contact, without friction or where all of it slides.

A contact that slides along x under the pressure p carries the traction :math:`\mu p`: its stresses are those of the
pressure, plus :math:`\mu` times those of the same springs directed along the surface.  They are sought in the plane
of the load.  Of a paraboloid on a half-space only the factor
:math:`\max\sigma_\mathrm{vM}/p_0 = H(\nu,\mu)` has to be found (Hamilton), once for all loads.

Where the elastic stress is infinite (a sharp rim, a pointed apex, a jump of slope, an edge that pulls) the greatest
stress outside a tenth of the contact radius around that place is found, and the place named.

References
----------
G. M. Hamilton, Proc. Inst. Mech. Eng. C 197 (1983) 53-59, doi:10.1243/PIME_PROC_1983_197_076_02
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.bed import PressedSprings, StretchedSprings
from winkler.foundation.footprint import EllipticOutline
from winkler.foundation.foundation import Foundation
from winkler.materials.elastic import Elastic
from winkler.media.body_of import exponent_of
from winkler.media.halfspace import HalfSpace
from winkler.media.interior import shear_field
from winkler.media.interior.peak import greatest
from winkler.media.interior.tensor import Measure, Tensor, von_mises
from winkler.media.offers import INSIDE_FROM, PowerOfDepth, PressedWaves, offers
from winkler.media.punch_field import BodyField
from winkler.numerics.types import Array
from winkler.problems.normal.elliptic_stress import greatest_under_ellipse
from winkler.problems.normal.strong_parts import StrongPart
from winkler.profiles.power import Paraboloid
from winkler.values.checks.outline import refuse_unless_round

EXCLUDED_DISTANCE = 0.1
"""Distance from a sharp place within which stresses do not count, in contact radii."""
INFINITE = ", so the elastic stress is infinite there and it yields there"
UNRESOLVED = ", where the von Mises stress of an incompressible body is finite but was not sought"
STARTS_IN_LAYERS = 2
ROUNDS_IN_LAYERS = 4
"""Starts and rounds of the search in layers, whose stresses are Hankel integrals: good to about a per mille."""
FINE_ROUNDS_IN_LAYERS = 7
"""The same where it is asked for: good to 1e-7."""
INTERFACE_OFFSET = 1e-9
"""How far below an interface the lower layer begins, of its depth."""


class GreatestStress(NamedTuple):
    """A von Mises stress [Pa] and its place along the load and below the surface [m]; why it is infinite elsewhere."""

    value: float
    x: float
    z: float
    sharp: str


@functools.lru_cache(maxsize=256)
def greatest_stress(
    pressed: PressedSprings,
    part: StrongPart,
    friction: float = 0.0,
    *,
    fine: bool = False,
    measure: Measure = von_mises,
) -> GreatestStress:
    """Return the greatest stress of a kind in a part of the bodies.

    Parameters
    ----------
    pressed : PressedSprings
        The springs of the contact.
    part : StrongPart
    friction : float
        Traction over pressure; more than zero on a `HalfSpace` and on bonded layers.
    fine : bool
        Whether the place is sought as precisely in layers as in a half-space, which takes longer.
    measure : callable
        What is compared: the von Mises stress, unless given; of an ellipse with friction no other.

    Raises
    ------
    OutsideValidity
        If the stresses in this part are not known.
    """
    bed = pressed.bed
    if isinstance(bed.footprint, EllipticOutline):
        return _under_ellipse(pressed, bed.footprint, part, friction, measure)
    refuse_unless_round(bed, "yield", "the stress below the surface")
    if type(pressed) is PressedSprings and _is_ball(pressed):
        largest = _ball(part.solid.poisson, friction, measure)
        peak = 2.0 * bed.medium.modulus * pressed.depth / (math.pi * pressed.radius)  # type: ignore[attr-defined]
        return GreatestStress(largest.value * peak, largest.x * pressed.radius, largest.z * pressed.radius, "")
    sharp = list(sharp_places(pressed, getattr(part.solid, "poisson", 0.0), friction)) if part.top == 0.0 else []
    off, least = EXCLUDED_DISTANCE * pressed.radius, least_depth(pressed)

    def field(x: Array, z: Array) -> Array:
        stress = np.full(x.shape, -math.inf)
        regular = z >= least
        for place, _ in sharp:
            regular &= np.hypot(np.abs(x) - place, z) >= off
        if regular.any():
            stress[regular] = stress_in_plane(pressed, part, friction, x[regular], z[regular], measure)
        return stress

    layered = offers(bed.medium, PressedWaves) or least > 0.0
    costly = {"starts": STARTS_IN_LAYERS, "rounds": FINE_ROUNDS_IN_LAYERS if fine else ROUNDS_IN_LAYERS}
    place = greatest(
        field,
        pressed.radius,
        top=part.top * (1.0 + INTERFACE_OFFSET),
        bottom=part.bottom,
        both_sides=friction > 0.0,
        **(costly if layered else {}),
    )
    return GreatestStress(place.value, place.r, place.z, sharp[0][1] if sharp else "")


def least_depth(pressed: PressedSprings) -> float:
    """Return above which depth the stresses below a contact are not known [m]."""
    return INSIDE_FROM * pressed.radius if offers(pressed.bed.medium, PowerOfDepth) else 0.0


def _under_ellipse(
    pressed: PressedSprings, outline: EllipticOutline, part: StrongPart, friction: float, measure: Measure
) -> GreatestStress:
    """Return the greatest stress under Hertz's ellipse, dragged along x; its springs are those of a disc as stiff."""
    radius = np.array([pressed.radius])
    force = float((pressed.bed.stiffness(radius) * pressed.depth - pressed.bed.gap_load(radius))[0])
    a, b = (float(axis[0]) for axis in outline.semi_axes(radius))
    smaller, pressure = min(a, b), 1.5 * force / (math.pi * a * b)
    if friction > 0.0 or measure is not von_mises:
        from winkler.media.interior import half_ellipsoid as below  # not loaded for numbers of round contacts

        rubbed = below.greatest_in_half_ellipsoid(measure, b / a, part.solid.poisson, (friction, 0.0))
        return GreatestStress(rubbed.value * pressure, rubbed.x * a, rubbed.z * smaller, "")
    largest = greatest_under_ellipse(smaller / max(a, b), part.solid.poisson)
    return GreatestStress(largest.value * pressure, 0.0, largest.depth * smaller, "")


def sharp_places(pressed: PressedSprings, poisson: float, friction: float) -> Iterator[tuple[float, str]]:
    """Yield where the von Mises stress at the surface is infinite or not resolved [m], and why.

    The pressure grows like a logarithm towards a pointed apex or a jump of slope.  In an incompressible body it is
    then all but hydrostatic, and the deviator stays finite, as long as there is no friction: under a cone of slope m
    it is 3/4 E* m at most.
    """
    if isinstance(pressed, StretchedSprings) and pressed.edge < 0.0:
        yield pressed.radius, f"attraction without range pulls the edge{INFINITE}"
    elif pressed.edge > 0.0:
        yield pressed.radius, f"the rim is sharp{INFINITE}"
    if exponent_of(pressed.bed.medium) > 0.0:
        return  # towards the surface the modulus vanishes: the pressure at a tip or kink is finite
    bounded = poisson == 0.5 and friction == 0.0
    near, far = np.abs(pressed.slope(pressed.radius * np.array([1e-8, 1e-6])))
    if near > (1.05 if bounded else 0.95) * far > 0.0:
        yield 0.0, f"the apex is pointed{INFINITE}"
    for place, strength in pressed.kinks:
        if strength != 0.0:
            yield place, f"the slope of the profile jumps{UNRESOLVED if bounded else INFINITE}"


def stress_in_plane(
    pressed: PressedSprings, part: StrongPart, friction: float, x: Array, z: Array, measure: Measure = von_mises
) -> Array:
    """Return the stress of a kind [Pa] in the plane y = 0 of a contact that is dragged along x by `friction` times p.

    Parameters
    ----------
    pressed : PressedSprings
        The springs of the contact.
    part : StrongPart
        Of the body in which the places lie; of a `HalfSpace` its solid counts.
    friction : float
        Traction over pressure [-].
    x, z : ndarray
        Of one shape [m], z >= 0 into that body.
    measure : callable
        Of which kind; von Mises' unless given.
    """
    medium, springs = pressed.bed.medium, pressed.blunted
    with np.errstate(invalid="ignore"):  # stresses are infinite in points of the surface
        across = _across(springs, part.first, np.abs(x).tobytes(), z.tobytes())
    if friction == 0.0:
        none = np.zeros(x.shape)
        alone = (across.radial_stress, across.hoop_stress, across.axial_stress, none, across.shear_stress, none)
        return measure(Tensor(*alone))
    y, solid = np.zeros(x.shape), part.solid
    with np.errstate(invalid="ignore"):
        if isinstance(medium, HalfSpace):
            along = shear_field.field(
                springs, x, y, z, modulus=medium.modulus, poisson=solid.poisson, shear=solid.shear
            )
        else:
            along = medium.dragged_interior(springs, x, y, z, below=part.first)  # type: ignore[attr-defined]
    return measure(
        Tensor(
            across.radial_stress + friction * along.xx_stress,
            across.hoop_stress + friction * along.yy_stress,
            across.axial_stress + friction * along.zz_stress,
            friction * along.xy_stress,
            np.sign(x) * across.shear_stress + friction * along.xz_stress,
            friction * along.yz_stress,
        )
    )


@functools.lru_cache(maxsize=16)
def _across(springs: Any, first: bool, r: bytes, z: bytes) -> BodyField:
    """Return the stresses of the pressure alone in places ``(n,)``; all kinds of stress are sought from one grid on."""
    return springs.bed.medium.interior(springs, np.frombuffer(r), np.frombuffer(z), below=first)  # type: ignore[no-any-return]


def _is_ball(pressed: PressedSprings) -> bool:
    bed = pressed.bed
    return isinstance(bed, Foundation) and isinstance(bed.profile, Paraboloid) and isinstance(bed.medium, HalfSpace)


@functools.lru_cache(maxsize=1024)
def _ball(poisson: float, friction: float, measure: Measure) -> GreatestStress:
    """Return the greatest stress over the greatest pressure, and its place over the contact radius."""
    solid = Elastic(1.0, poisson)
    medium = HalfSpace(solid)
    unit, part = PressedSprings(Foundation(Paraboloid(1.0), medium), 1.0, 1.0), StrongPart("", solid, True)
    peak = 2.0 * medium.modulus / math.pi
    largest = greatest(
        lambda x, z: stress_in_plane(unit, part, friction, x, z, measure) / peak, 1.0, both_sides=friction > 0.0
    )
    return GreatestStress(largest.value, largest.r, largest.z, "")
