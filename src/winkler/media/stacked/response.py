"""The surface compliances of a stack whose layers may be transversely isotropic, and may slide on each other."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple, Self

import numpy as np

from winkler.materials.elastic import RIGID, Elastic, Rigid, TransverselyIsotropic
from winkler.materials.layered import StackLayer
from winkler.media.layered.across import climbed_across, impedance
from winkler.media.layered.climb import AnyLayer, climbed, is_bonded
from winkler.media.layered.layers import rounded
from winkler.media.layered.wave_constants import (
    Body,
    across_compliance,
    along_compliance,
    constants_of,
    normal_compliance,
    stiffness_scale,
)
from winkler.numerics.types import ComplexArray
from winkler.values import value

__all__ = ["StackAcross", "StackAlong", "StackNormal", "StackResponse", "StackTangential", "in_units_of_top"]


def _in_units(solid: Elastic | TransverselyIsotropic, unit: float) -> Elastic | TransverselyIsotropic:
    if isinstance(solid, Elastic):
        return Elastic(rounded(solid.young / unit), solid.poisson)
    constants = (solid.c11, solid.c12, solid.c13, solid.c33, solid.c44)
    return TransverselyIsotropic(*(rounded(each / unit) for each in constants))


def in_units_of_top(
    layers: tuple[AnyLayer, ...], on: Body, second: Body, of_body: Callable[[Body], float]
) -> tuple[tuple[StackLayer, ...], Body, Body, float]:
    """Return a stack in units of thickness and modulus of its uppermost layer, and that thickness [m].

    Of the second body only what it adds to the compliance, by `of_body`, is kept.
    """
    top, length = layers[0].solid, layers[0].thickness
    unit = top.young if isinstance(top, Elastic) else top.c44
    own = tuple(
        StackLayer(_in_units(layer.solid, unit), rounded(layer.thickness / length), is_bonded(layer))
        for layer in layers
    )
    added = unit * of_body(second)
    other = Elastic(rounded(of_body(Elastic(1.0, 0.0)) / added), 0.0) if added else RIGID
    return own, on if isinstance(on, Rigid) else _in_units(on, unit), other, length


class StackResponse:
    """What all responses of a stack share."""

    layers: tuple[AnyLayer, ...]
    on: Body
    second: Body

    @staticmethod
    def of_body(body: Body) -> float:
        """What a half-space adds to the compliance [1/Pa]."""
        raise NotImplementedError

    def relative(self, xi: ComplexArray) -> ComplexArray:
        """Compliance of the stack over that of a half-space of its uppermost layer."""
        raise NotImplementedError

    @property
    def own(self) -> tuple[Self, float]:
        """The same in units of thickness and modulus of its uppermost layer; and that thickness [m]."""
        layers, on, second, length = in_units_of_top(self.layers, self.on, self.second, self.of_body)
        return type(self)(layers, on, second), length  # type: ignore[call-arg]

    @property
    def modulus(self) -> float:
        """E*, G*, m_L or m_T [Pa] of the uppermost layer and the second body."""
        return 1.0 / (self.of_body(self.layers[0].solid) + self.of_body(self.second))

    @property
    def length(self) -> float:
        """M tends to zero like exp(-2 xi length) [m]."""
        top = self.layers[0]
        return top.thickness * constants_of(top.solid).slowest

    @property
    def smooth(self) -> float:
        """The same: the kernel has no logarithm [m]."""
        return self.length

    precision = 3e-14
    """Rounding of M, relative to its largest value."""

    @property
    def span(self) -> float:
        """Length [m] beyond which the stack is only its base."""
        solids = [layer.solid for layer in self.layers] + ([] if isinstance(self.on, Rigid) else [self.on])
        scales = [stiffness_scale(solid) for solid in solids]
        contrast = max(high for _, high in scales) / min(low for low, _ in scales)
        return sum(layer.thickness for layer in self.layers) * contrast

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        return np.asarray((self.relative(xi) - 1.0) * self._share)

    def whole(self, xi: ComplexArray) -> ComplexArray:
        """1 + M(xi) [-], to all digits where it is small, too."""
        return np.asarray(self.relative(xi) * self._share + (1.0 - self._share))

    @property
    def _share(self) -> float:
        """Compliance of the uppermost layer in that of the pair."""
        return self.modulus * self.of_body(self.layers[0].solid) if not isinstance(self.second, Rigid) else 1.0


@value
class StackNormal(StackResponse):
    """The response to a pressure.

    Parameters
    ----------
    layers : tuple of Layer or StackLayer
        From the top.
    on, second : Elastic, TransverselyIsotropic or Rigid
        What carries them, and the other body.
    """

    layers: tuple[AnyLayer, ...]
    on: Body
    second: Body = RIGID

    @staticmethod
    def of_body(body: Body) -> float:
        """1/E* [1/Pa]."""
        return normal_compliance(body)

    def relative(self, xi: ComplexArray) -> ComplexArray:
        """Compliance of the stack over that of a half-space of its uppermost layer."""
        return np.asarray(-0.5 * climbed(self.layers, self.on, xi)[0][1][3] / normal_compliance(self.layers[0].solid))

    @property
    def compressed(self) -> float:
        """The limit of (1 + M) / xi for long waves [m]; infinite if one of the bodies is a half-space."""
        if not isinstance(self.on, Rigid) or not isinstance(self.second, Rigid):
            return math.inf
        return 0.5 * self.modulus * sum(_yielding(group) for group in _groups(self.layers))


class _Group(NamedTuple):
    """Layers bonded to each other, and whether the lowest one is held by the rigid base."""

    layers: tuple[AnyLayer, ...]
    held: bool


def _groups(layers: tuple[AnyLayer, ...]) -> list[_Group]:
    groups, members = [], []
    for layer in layers:
        members.append(layer)
        if not is_bonded(layer):
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


@value
class StackAlong(StackResponse):
    """The response of a bonded stack to a shear traction along its wave; parameters as of `StackNormal`."""

    layers: tuple[AnyLayer, ...]
    on: Body
    second: Body = RIGID

    @staticmethod
    def of_body(body: Body) -> float:
        """1/m_L [1/Pa]."""
        return along_compliance(body)

    def relative(self, xi: ComplexArray) -> ComplexArray:
        """Compliance of the stack over that of a half-space of its uppermost layer."""
        return np.asarray(-0.5 * climbed(self.layers, self.on, xi)[0][1][0] / along_compliance(self.layers[0].solid))


@value
class StackAcross(StackResponse):
    """The response of a bonded stack to shear across its wave, and to a twist; parameters as of `StackNormal`.

    Waves across the depth of a transversely isotropic layer are those of an isotropic one with the modulus
    sqrt(C44 C66), sqrt(C66 / C44) times as thick.
    """

    layers: tuple[AnyLayer, ...]
    on: Body
    second: Body = RIGID

    @staticmethod
    def of_body(body: Body) -> float:
        """1/m_T [1/Pa]."""
        return across_compliance(body)

    @property
    def length(self) -> float:
        """M tends to zero like exp(-2 xi length) [m]."""
        top = self.layers[0]
        return top.thickness * math.sqrt(constants_of(top.solid).twist)

    def relative(self, xi: ComplexArray) -> ComplexArray:
        """Compliance of the stack over that of a half-space of its uppermost layer."""
        return np.asarray(climbed_across(self.layers, self.on, xi)[0] * impedance(self.layers[0].solid)[0])


@value
class StackTangential(StackResponse):
    """The mean of both responses to shear over the angle with the wave; parameters as of `StackNormal`."""

    layers: tuple[AnyLayer, ...]
    on: Body
    second: Body = RIGID

    @staticmethod
    def of_body(body: Body) -> float:
        """1/G* [1/Pa]."""
        return 0.5 * (along_compliance(body) + across_compliance(body))

    @property
    def length(self) -> float:
        """M tends to zero like exp(-2 xi length) [m]."""
        return min(each.length for each in self._parts)

    @property
    def _parts(self) -> tuple[StackAlong, StackAcross]:
        return StackAlong(self.layers, self.on, self.second), StackAcross(self.layers, self.on, self.second)

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        return np.asarray(sum(0.5 * self.modulus / each.modulus * each.excess(xi) for each in self._parts))

    @property
    def compressed(self) -> float:
        """The limit of (1 + M) / xi for long waves [m]; infinite if one of the bodies is a half-space."""
        if not isinstance(self.on, Rigid) or not isinstance(self.second, Rigid):
            return math.inf
        return 0.5 * self.modulus * sum(layer.thickness / constants_of(layer.solid).shear for layer in self.layers)
