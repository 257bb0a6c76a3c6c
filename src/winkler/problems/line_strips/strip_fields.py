"""Stresses below the strips of one section: in half-planes, or in layers by the waves of the pressure."""

from __future__ import annotations

import dataclasses
from typing import cast

import numpy as np

from winkler.media.halfspace import HomogeneousMedium
from winkler.media.layered.coated import CoatedHalfSpace, SlidingFilm, StackedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.layered.depth_response import GradedBody
from winkler.media.layered.plane_interior import PlaneWaves, plane_waves
from winkler.media.mapped import layers_of
from winkler.media.offers import LayerStack, PlaneMedium, PowerOfDepth, offers
from winkler.numerics.pixels.power_law import PowerLawSurface
from winkler.numerics.surfaces.found_strips import FoundStrips
from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.types import Array
from winkler.problems.line.layered_stress import in_layers
from winkler.problems.line.stress import LineFields, fields_of, poisson_of
from winkler.values.errors import OutsideValidity

LineMedium = (
    HomogeneousMedium
    | CoatedHalfSpace
    | StackedHalfSpace
    | SlidingFilm
    | DepthGradedHalfSpace
    | PlaneMedium
    | PowerOfDepth
)


def layers_below(medium: LineMedium) -> PlaneMedium | None:
    """Return a medium whose moduli depend on the depth by layers or a grading of finite moduli, or none."""
    if isinstance(medium, HomogeneousMedium) or offers(medium, PowerOfDepth):
        return None
    return cast(PlaneMedium, medium)


def response_below(medium: LineMedium) -> WaveResponse | PowerLawSurface | None:
    """Return how a medium differs from a half-plane under pressures; none of a homogeneous one.

    Raises
    ------
    OutsideValidity
        If the modulus of a power law is proportional to the depth.
    """
    if offers(medium, PowerOfDepth):
        return cast(PowerLawSurface, layers_of(medium))
    layered = layers_below(medium)
    return None if layered is None else layered.response


def strip_fields(
    medium: LineMedium,
    found: FoundStrips,
    x: Array,
    z: Array,
    below: bool,
    friction: float = 0.0,
    waves: PlaneWaves | None = None,
) -> LineFields:
    """Return the stresses at places of one shape, z as requested.

    Parameters
    ----------
    medium : HomogeneousMedium or PlaneMedium
    found : FoundStrips
    x, z : ndarray
        [m].
    below : bool
        In the first body.
    friction : float
        Traction on the body along x over the pressure [-].
    waves : PlaneWaves, optional
        From `strip_waves`, for places as far away as these.

    Raises
    ------
    OutsideValidity
        If the body has no stresses that are known.
    """
    layered = layers_below(medium)
    if layered is None:
        return dataclasses.replace(_fields(found, x, np.abs(z), poisson_of(medium, below), friction), z=z)
    if isinstance(layered.response.first, GradedBody):
        raise OutsideValidity(
            "Stresses below strips are known in layers and homogeneous bodies; in the place of the grading give a "
            "CoatedHalfSpace of layers that follow it."
        )
    if friction != 0.0:
        _ = layered.along_modulus  # refused where a layer slides on what lies below it
    layers = cast(LayerStack, layered)
    middle = middle_of(found)

    def own(across: Array, deep: Array, poisson: float) -> LineFields:
        return _fields(found, across + middle, deep, poisson, friction)

    def waves_below(farthest: float) -> PlaneWaves:
        return strip_waves(layers, found, farthest) if waves is None else waves

    return dataclasses.replace(in_layers(layers, own, waves_below, x - middle, z, below, friction), x=x)


def _fields(found: FoundStrips, x: Array, z: Array, poisson: float, friction: float) -> LineFields:
    """Return the stresses below strips on half-planes, z >= 0."""
    whole, slope = found.potential(x, z)
    pressed = np.array([whole, z * slope])
    return fields_of(x, z, pressed, poisson, friction * pressed if friction != 0.0 else None)


def strip_waves(medium: LayerStack, found: FoundStrips, farthest: float) -> PlaneWaves:
    """Return the pressure as waves, for places up to a distance from the middle of all strips [m]."""
    middle, widths = middle_of(found), np.diff(found.edges, axis=1)
    extent = max(0.5 * float(found.edges[-1, 1] - found.edges[0, 0]), farthest)
    narrowest = 0.5 * float(np.min(widths))
    return plane_waves(medium, narrowest, extent + farthest, lambda k: found.transform(k, middle))


def middle_of(found: FoundStrips) -> float:
    """Return the middle between the outermost edges [m]."""
    return 0.5 * float(found.edges[0, 0] + found.edges[-1, 1])
