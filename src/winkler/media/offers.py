"""What a medium may offer beside the contract `winkler.media.medium.Medium`: problems ask by name, never for a class.

Whoever writes a medium gives it those members that its physics has.  A member that exists for some media of a class
only raises `OutsideValidity` with the reason, as the push of layers of which one slides.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol, TypeGuard, TypeVar

from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.materials.layered import Layer, StackLayer
from winkler.media.medium import Displacement, Medium
from winkler.numerics.types import Array, Curve
from winkler.values.checks.contract import keeps, offered

if TYPE_CHECKING:  # numerics of layers are loaded with layers
    from winkler.materials.depth_grading import DepthGrading
    from winkler.media.interior.shear_field_punch import ShearField
    from winkler.numerics.pixels.layered import GridResponse
    from winkler.numerics.transforms.cosine_transform import SurfaceResponse, WaveResponse

    class PairWaves(SurfaceResponse, GridResponse, Protocol):
        """The response of two bodies to a load, on a disc and on pixels; the second is a homogeneous half-space."""

        @property
        def first(self) -> Any:
            """The body that is not homogeneous, as `winkler.media.layered.stack.Layered`."""

        @property
        def second(self) -> Any:
            """The homogeneous one."""


Offer = TypeVar("Offer")


def offers(medium: object, what: Callable[..., Offer]) -> TypeGuard[Offer]:
    """Return whether a medium has each member of a protocol of this module, without evaluating any of them."""
    return isinstance(what, type) and keeps(medium, what)


class TwistModuli(Medium, Protocol):
    """The moduli of a pressure and of a twist."""

    @property
    def modulus(self) -> float:
        """E* [Pa]."""

    @property
    def torsional_modulus(self) -> float:
        """G_t [Pa]."""


@offered("one whose modulus follows a power of the depth, such as GradedHalfSpace(first, second)")
class PowerOfDepth(TwistModuli, Protocol):
    """Moduli that follow one power of the depth."""

    @property
    def exponent(self) -> float:
        """k [-]."""

    @property
    def depth_scale(self) -> float:
        """c_0 [m]."""

    @property
    def shear_modulus(self) -> float:
        """G* [Pa]."""


INSIDE_FROM = 0.02
"""Depth, in contact radii, from which on stresses in a `PowerOfDepth` are computed: above it too many waves count."""


class ByWaves(Protocol):
    """A body whose moduli depend on the depth alone, against a homogeneous body, by its response to waves."""

    @property
    def modulus(self) -> float:
        """E* [Pa] of the surface, or the uppermost layer, and the other body."""

    @property
    def thickness(self) -> float:
        """Depth below which nothing changes any more [m]: of all layers together."""

    @property
    def response(self) -> PairWaves:
        """The response of the pair to a pressure."""


class PressedWaves(ByWaves, Medium, Protocol):
    """Layers, or a grading down to some depth, by their response to waves of pressure."""

    def transformed_slope(self, imprint: Displacement) -> Curve:
        """Return h'(x) [-] as a function of 0 <= x <= a (`winkler.media.body_of`)."""


class TwistedWaves(PressedWaves, TwistModuli, Protocol):
    """The responses of layers to a pressure and to a twist."""

    @property
    def across_response(self) -> PairWaves:
        """The response of the pair to shear across its wave, and to a twist."""


@offered("layers or a grading, such as CoatedHalfSpace(layers, on) or DepthGradedHalfSpace(grading)")
class PushedWaves(TwistedWaves, Protocol):
    """The responses of layers to all loads: rings may slide around the axis, or along the surface."""

    @property
    def tangential_response(self) -> PairWaves:
        """The response of the pair to a shear load, averaged over its angle with the wave."""

    @property
    def shear_modulus(self) -> float:
        """G* [Pa] of the surface and the other body."""

    @property
    def turning_response(self) -> PairWaves:
        """Of a shear load, the part that turns with twice the angle between it and the wave."""

    def punch_shear_stiffness(self, radius: Array) -> Array:
        """k_x(a) [N/m] of a flat punch that is pushed along the surface."""

    def punch_torsional_stiffness(self, radius: Array) -> Array:
        """k_phi(a) [N m] of a flat punch that is twisted about its axis."""

    def dragged_interior(self, displacement: Displacement, x: Array, y: Array, z: Array, *, below: bool) -> ShearField:
        """Return stresses and displacements where the surface is dragged along +x by a traction of the pressure."""

    def pushed_interior(self, moved: Displacement, x: Array, y: Array, z: Array, *, below: bool) -> ShearField:
        """Return stresses and displacements where the surface is dragged along +x by springs that move it."""


@offered(
    "a medium of layers or graded with depth, such as CoatedHalfSpace(layers, on) or DepthGradedHalfSpace(grading)"
)
class PlaneMedium(ByWaves, Protocol):
    """The responses of such a body to plane waves."""

    @property
    def second(self) -> Elastic | TransverselyIsotropic | Rigid:
        """The other body."""

    @property
    def along_modulus(self) -> float:
        """m_L [Pa] of the same, for shear along a wave; refused where shear does not reach the base."""

    @property
    def along_response(self) -> PairWaves:
        """Of the pair to shear along its wave; refused where it does not reach the base."""

    @property
    def coupling_response(self) -> WaveResponse:
        """Of the first body: how much farther than its uppermost layer alone a pressure draws its surface along."""


class LayerStack(PlaneMedium, Protocol):
    """Layers on a half-space or a rigid base, bonded or sliding on each other, against a homogeneous body."""

    @property
    def layers(self) -> tuple[Layer | StackLayer, ...]:
        """From the surface down."""

    @property
    def stack(self) -> tuple[Layer | StackLayer, ...]:
        """The same, with what they are bonded to."""

    @property
    def on(self) -> Elastic | TransverselyIsotropic | Rigid:
        """What carries them."""

    @property
    def spans(self) -> tuple[tuple[float, float], ...]:
        """Depths between which each layer lies, and what carries them if it deforms [m]: stresses jump between them."""


class GradedInDepth(PushedWaves, Protocol):
    """A modulus that changes with depth by any law, followed to a tolerance."""

    @property
    def grading(self) -> DepthGrading:
        """E(z) and nu(z)."""

    @property
    def tolerance(self) -> float:
        """Relative error of every k(a) [-]."""
