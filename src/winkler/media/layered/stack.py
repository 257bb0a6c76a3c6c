"""Bodies as what they answer to waves: layers on a half-space or a rigid base, or a half-space without layers."""

from __future__ import annotations

import functools
import math
from typing import Any, NamedTuple, Protocol

import numpy as np

from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.materials.layered import StackLayer
from winkler.media.layered.across import climbed_across
from winkler.media.layered.climb import AnyLayer, climbed
from winkler.media.layered.wave_constants import (
    Body,
    Wave,
    constants_of,
    half_space_compliance,
    in_plane_share,
    stiffness_scale,
)
from winkler.numerics.caching import rounded
from winkler.numerics.types import Array, ComplexArray
from winkler.values.validity import Standing
from winkler.values.value import value


class Layered(Protocol):
    """A body that answers a traction on its surface wave by wave."""

    def waves(self, part: Wave, xi: ComplexArray) -> ComplexArray:
        """Compliance times xi / 2 [1/Pa] at real or complex wave numbers (m,) [1/m]."""

    def short(self, part: Wave) -> float:
        """Its limit for short waves [1/Pa]: that of a half-space of what lies at the surface."""

    @property
    def top(self) -> Body:
        """The solid at the surface."""

    @property
    def on(self) -> Body:
        """The solid far below, or a rigid base."""

    @property
    def in_plane(self) -> tuple[Standing, str]:
        """What is assumed of it in plane strain."""

    @property
    def unit(self) -> tuple[float, float]:
        """Modulus [Pa] and length [m] of what lies at the surface, in which other bodies may be the same."""


@value
class StackBody:
    """Layers on what carries them.

    Parameters
    ----------
    layers : tuple of Layer or StackLayer
        From the top; none for a homogeneous body.
    on : Elastic, TransverselyIsotropic or Rigid
        What carries them.
    """

    layers: tuple[AnyLayer, ...]
    on: Body

    @functools.cached_property
    def bottoms(self) -> Array:
        """Depths of the lower faces of the layers [m]."""
        return np.cumsum([layer.thickness for layer in self.layers])

    @property
    def top(self) -> Body:
        """The solid at the surface."""
        return self.layers[0].solid if self.layers else self.on

    in_plane = (
        Standing.EXACT,
        "Linear elastic layers in plane strain under normal load. Each layer is perfectly bonded to the material "
        "below or, where specified, slides on it without friction or gap. The solution uses the Fourier response "
        "of the stack",
    )
    """What is assumed of it in plane strain."""

    def waves(self, part: Wave, xi: ComplexArray) -> ComplexArray:
        """Compliance times xi / 2 [1/Pa] at real or complex wave numbers (m,) [1/m]: of a half-space, 1 / modulus."""
        if not self.layers:
            return np.full(xi.shape, self.short(part), dtype=xi.dtype)
        return stack_waves(self.layers, self.on, part, xi)

    def short(self, part: Wave) -> float:
        """The limit of `waves` for short waves [1/Pa]."""
        return half_space_compliance(self.top, part)

    def compressed(self, part: Wave) -> float:
        """The limit of `waves` over xi for long ones [m/Pa]; infinite if the layers lie on a half-space."""
        if not isinstance(self.on, Rigid):
            return math.inf
        if part is Wave.NORMAL:
            return 0.5 * sum(_yielding(group) for group in _groups(self.layers))
        if not all(layer.bonded for layer in self.layers):
            return math.inf
        return 0.5 * sum(layer.thickness / constants_of(layer.solid).shear for layer in self.layers)

    def decay_length(self, part: Wave) -> float:
        """`waves` tends to `short` like exp(-2 xi length) [m]."""
        layer = self.layers[0]
        constants = constants_of(layer.solid)
        return layer.thickness * (math.sqrt(constants.twist) if part is Wave.ACROSS else constants.slowest)

    @property
    def span(self) -> float:
        """Length [m] beyond which the stack is only its base."""
        solids = [layer.solid for layer in self.layers] + ([] if isinstance(self.on, Rigid) else [self.on])
        scales = [stiffness_scale(solid) for solid in solids]
        contrast = max(high for _, high in scales) / min(low for low, _ in scales)
        return sum(layer.thickness for layer in self.layers) * contrast

    @property
    def unit(self) -> tuple[float, float]:
        """Modulus [Pa] and thickness [m] of the uppermost layer, in which other stacks may be the same."""
        top, length = self.layers[0].solid, self.layers[0].thickness
        return top.young if isinstance(top, Elastic) else top.c44, length

    def in_own_units(self) -> StackBody:
        """Return the same stack in units of its uppermost layer."""
        modulus, length = self.unit
        layers = tuple(
            StackLayer(_in_units(layer.solid, modulus), rounded(layer.thickness / length), layer.bonded)
            for layer in self.layers
        )
        return StackBody(layers, self.on if isinstance(self.on, Rigid) else _in_units(self.on, modulus))


def stack_waves(layers: tuple[Any, ...], on: Any, part: Wave, xi: ComplexArray) -> ComplexArray:
    """Return the compliance of a stack times xi / 2 [1/Pa]; its solids may be `IsotropicAt`, xi is then complex."""
    if part is Wave.ACROSS:
        return np.asarray(0.5 * climbed_across(layers, on, xi)[0])
    return in_plane_share(part, climbed(layers, on, xi)[0][1])


def _in_units(solid: Elastic | TransverselyIsotropic, unit: float) -> Elastic | TransverselyIsotropic:
    if isinstance(solid, Elastic):
        return Elastic(rounded(solid.young / unit), solid.poisson)
    constants = (solid.c11, solid.c12, solid.c13, solid.c33, solid.c44)
    return TransverselyIsotropic(*(rounded(each / unit) for each in constants))


class _Group(NamedTuple):
    """Layers bonded to each other, and whether the lowest one is held by the rigid base."""

    layers: tuple[AnyLayer, ...]
    held: bool


def _groups(layers: tuple[AnyLayer, ...]) -> list[_Group]:
    groups, members = [], []
    for layer in layers:
        members.append(layer)
        if not layer.bonded:
            groups.append(_Group(tuple(members), held=False))
            members = []
    return [*groups, _Group(tuple(members), held=True)] if members else groups


def _yielding(group: _Group) -> float:
    """Return how much less thick a group gets under a uniform pressure of one [m/Pa]; if not held, it widens."""
    straight = widening = stretched = 0.0
    for layer in group.layers:
        constants, h = constants_of(layer.solid), layer.thickness
        straight += h * constants.axial / constants.shear
        widening += h * constants.lateral
        stretched += h * constants.plane * constants.shear
    return straight if group.held else straight + widening**2 / stretched
