"""Families of media, so that a medium can be recognised without the modules that solve for the others being loaded."""

from __future__ import annotations

from winkler.materials.elastic import Solid
from winkler.materials.layered import Layer
from winkler.media.medium import Displacement
from winkler.numerics.types import Curve

__all__ = ["CoatedBody", "DepthVaryingMedium", "PowerLawMedium", "SlidingBody"]


class PowerLawMedium:
    """A medium whose moduli follow one power of the depth."""

    @property
    def exponent(self) -> float:
        """k [-]."""
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


class CoatedBody(DepthVaryingMedium):
    """Layers on a half-space or a rigid base, against a homogeneous body."""

    layers: tuple[Layer, ...]
    on: Solid
    second: Solid


class SlidingBody(DepthVaryingMedium):
    """A layer on a half-space or a rigid base that bears no shear between them, against a homogeneous body."""

    layers: tuple[Layer, ...]
    on: Solid
    second: Solid
