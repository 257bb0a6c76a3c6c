"""Families of media, so that a medium can be recognised without the modules that solve for the others being loaded."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING

from winkler.materials.elastic import Rigid, Solid, TransverselyIsotropic
from winkler.materials.layered import Layer, StackLayer
from winkler.media.medium import Displacement
from winkler.numerics.types import Array, Curve

if TYPE_CHECKING:  # numerics of layers are loaded with layers
    from winkler.media.interior.shear_field_punch import ShearField
    from winkler.numerics.transforms.cosine_transform import SurfaceResponse

__all__ = [
    "CoatedBody",
    "DepthVaryingMedium",
    "LayeredBody",
    "PowerLawMedium",
    "PushedLayers",
    "StackedBody",
    "TwistedLayers",
    "TwistedMedium",
]


class TwistedMedium:
    """A medium on which it is known what springs bear whose rings slide around the axis."""

    @property
    def modulus(self) -> float:
        """E* [Pa]."""
        raise NotImplementedError

    @property
    def torsional_modulus(self) -> float:
        """G_t [Pa]."""
        raise NotImplementedError


class PowerLawMedium(TwistedMedium):
    """A medium whose moduli follow one power of the depth."""

    @property
    def exponent(self) -> float:
        """k [-]."""
        raise NotImplementedError

    @property
    def depth_scale(self) -> float:
        """c_0 [m]."""
        raise NotImplementedError


class DepthVaryingMedium:
    """A medium of layers, or graded down to some depth."""

    @property
    def thickness(self) -> float:
        """Depth below which nothing changes any more [m]."""
        raise NotImplementedError

    def transformed_slope(self, imprint: Displacement) -> Curve:
        """Return h'(x) [-] as a function of 0 <= x <= a (`winkler.media.body_of`)."""
        raise NotImplementedError


class LayeredBody(DepthVaryingMedium):
    """Layers on a half-space or a rigid base, against a homogeneous body."""

    @property
    def thickness(self) -> float:
        """Of all layers together [m]."""
        layers: tuple[Layer | StackLayer, ...] = self.layers  # type: ignore[attr-defined]
        return sum(layer.thickness for layer in layers)

    @property
    def spans(self) -> tuple[tuple[float, float], ...]:
        """Depths between which each layer lies, and what carries them if it deforms [m]: stresses jump between them."""
        layers: tuple[Layer | StackLayer, ...] = self.layers  # type: ignore[attr-defined]
        ends = [0.0, *itertools.accumulate(layer.thickness for layer in layers)]
        if not isinstance(self.on, Rigid):  # type: ignore[attr-defined]
            ends.append(math.inf)
        return tuple(itertools.pairwise(ends))


class TwistedLayers(TwistedMedium):
    """A body of layers whose responses to a pressure and to a twist are known."""

    @property
    def response(self) -> SurfaceResponse:
        """The response of the pair to a pressure."""
        raise NotImplementedError

    @property
    def across_response(self) -> SurfaceResponse:
        """The response of the pair to shear across its wave, and to a twist."""
        raise NotImplementedError


class PushedLayers(TwistedLayers):
    """A body of layers whose responses are known: its rings may slide around the axis, or along the surface."""

    @property
    def tangential_response(self) -> SurfaceResponse:
        """The response of the pair to a shear load, averaged over its angle with the wave."""
        raise NotImplementedError

    @property
    def shear_modulus(self) -> float:
        """G* [Pa] of the uppermost layer and the other body."""
        raise NotImplementedError

    def punch_shear_stiffness(self, radius: Array) -> Array:
        """k_x(a) [N/m] of a flat punch that is pushed along the surface."""
        raise NotImplementedError

    def pushed_interior(self, moved: Displacement, x: Array, y: Array, z: Array, *, below: bool) -> ShearField:
        """Return stresses and displacements where the surface is dragged along +x by springs that move it."""
        raise NotImplementedError


class CoatedBody(LayeredBody, PushedLayers):
    """Bonded, isotropic layers."""

    layers: tuple[Layer, ...]
    on: Solid
    second: Solid

    @property
    def stack(self) -> tuple[Layer | StackLayer, ...]:
        """The layers, with what they are bonded to."""
        return self.layers


class StackedBody(LayeredBody, PushedLayers):
    """Layers that may be transversely isotropic, and need not be bonded: what slides there bears no push."""

    @property
    def stack(self) -> tuple[Layer | StackLayer, ...]:
        """The layers, with what they are bonded to."""
        raise NotImplementedError

    layers: tuple[Layer | StackLayer, ...]
    on: Solid | TransverselyIsotropic
    second: Solid | TransverselyIsotropic
