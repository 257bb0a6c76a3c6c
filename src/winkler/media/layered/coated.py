r"""Coated bodies: any number of bonded layers on a half-space or a rigid base.

A stack responds to a pressure wave :math:`\hat p\,J_0(\xi r)` with the compliance
:math:`C(\xi) = \frac{2}{E^*\xi}(1+M(\xi))`, :math:`M\to0` for short waves, which feel the uppermost layer alone.  M is
all that the method needs: from it follow the flat punches (`winkler.numerics.transforms.fredholm`), from these
:math:`k(a) = 2E^*\int_0^a\varphi\,\mathrm dx`, the springs :math:`c_N = E^*\varphi(a;a)^2` and g(a).  The equations
are exact, the numbers good to about ten digits, whatever the thickness; films squeezed to many times their thickness
lose some of them.

A rigid shift of a disc moves its surface by (U, 0).  With the traction written as
:math:`\tau_x+i\tau_y = \tau_0(r)+\tau_2(r)\,e^{2i\theta}`, a wave of it has the amplitudes :math:`T_0-T_2` along and
:math:`T_0+T_2` across its direction.  That the surface moves by U alone, without a part that turns with
:math:`2\theta`, leaves two equations for the cosine transforms :math:`p_L, p_T` of these amplitudes on the disc,

.. math:: p_L + K_L\,p_L = \text{const} ,\qquad p_T + K_T\,p_T = \text{const} ,\qquad
          \int_0^a p_L\,\mathrm dx = \int_0^a p_T\,\mathrm dx = \frac{F_x}{2\pi} ,

each that of a flat punch pressed into a medium with the compliance :math:`C_L`, or :math:`C_T`: the pair of coupled
dual integral equations falls apart, and the compliances are averaged,

.. math:: \frac1{k_x} = \frac12\Big(\frac1{k_L}+\frac1{k_T}\Big) .

The disc does not press (no normal traction); its surface may rise and sink.  A twist needs the waves across alone:
:math:`k_\varphi = 16\,G_t\int_0^a x\,\theta\,\mathrm dx` (`winkler.numerics.transforms.odd_response`).
"""

from __future__ import annotations

import functools
import itertools
import math
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from winkler.materials.elastic import RIGID, Elastic, Rigid, Solid, TransverselyIsotropic
from winkler.materials.layered import Layer, StackLayer
from winkler.media.interior import shear_field
from winkler.media.interior.shear_field_punch import ShearField
from winkler.media.layered import coated_interior, coated_load, flat_punch, punch_facts, sheared_interior
from winkler.media.layered.climb import AnyLayer
from winkler.media.layered.coated_load import CarriedLoad, spread
from winkler.media.layered.floating import FloatingAcross
from winkler.media.layered.pair_response import Mode, PairResponse
from winkler.media.layered.solid_field import solid_field
from winkler.media.layered.stack import StackBody
from winkler.media.layered.wave_constants import Body
from winkler.media.medium import Displacement, PunchFacts, exact_response, rigid_body
from winkler.media.punch_field import BodyField
from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.transforms import abel, fredholm
from winkler.numerics.transforms.cosine_transform import SurfaceResponse, WaveResponse
from winkler.numerics.transforms.odd_response import OddResponse
from winkler.numerics.types import Array, Curve
from winkler.profiles.profile import Profile
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Note
from winkler.values.value import value

if TYPE_CHECKING:
    from winkler.media.offers import PairWaves

BARBER = "J. R. Barber, Determining the contact area in elastic-indentation problems, J. Strain Anal. 9 (1974) 230-232"


class LayeredMedium:
    """What all media with a known surface compliance have in common: subclasses state it, and what is inside."""

    second: Body

    def responding(self, mode: Mode) -> PairWaves:
        """The response of the pair to a load."""
        raise NotImplementedError

    @functools.cached_property
    def response(self) -> PairWaves:
        """The response of the pair to a pressure."""
        return self.responding(Mode.NORMAL)

    @functools.cached_property
    def tangential_response(self) -> PairWaves:
        """The response of the pair to a shear load, averaged over its angle with the wave."""
        return self.responding(Mode.TANGENTIAL)

    @functools.cached_property
    def along_response(self) -> PairWaves:
        """The response of the pair to shear along its wave."""
        return self.responding(Mode.ALONG)

    @functools.cached_property
    def across_response(self) -> PairWaves:
        """The response of the pair to shear across its wave, and to a twist."""
        return self.responding(Mode.ACROSS)

    @functools.cached_property
    def turning_response(self) -> PairWaves:
        """Of a shear load, the part that turns with twice the angle between it and the wave."""
        return self.responding(Mode.TURNING)

    @functools.cached_property
    def coupling_response(self) -> WaveResponse:
        """By how much farther pressures draw the first surface along than on a half-space of what lies at it."""
        return self.responding(Mode.COUPLING)

    def inside(self, load: CarriedLoad, r: Array, z: Array) -> BodyField:
        """Stresses and displacements in the first body; arrays of one shape."""
        raise NotImplementedError

    @property
    def modulus(self) -> float:
        """E* [Pa] of the uppermost layer and the other body: what the narrowest contacts feel."""
        return self.response.modulus

    def gap(self, profile: Profile, x: Array) -> Array:
        """g(x) [m]."""
        return flat_punch.gap(self.response, profile, x)

    def gap_slope(self, profile: Profile, x: Array) -> Array:
        """g'(x) [-]."""
        return flat_punch.gap_slope(self.response, profile, x)

    def kinks(self, profile: Profile) -> tuple[tuple[float, float], ...]:
        """``(b, b jump / phi(b; b))``: above a jump of f' at b, g' holds strength / sqrt(x^2 - b^2)."""
        return flat_punch.kinks(self.response, profile)

    def gap_load(self, profile: Profile, radius: Array) -> Array:
        """The integral of k'(x) g(x) from 0 to `radius` [N]."""
        return 2.0 * self.modulus * flat_punch.gap_load(self.response, profile, radius)

    def punch_stiffness(self, radius: Array) -> Array:
        """k(a) [N/m]."""
        return _stiffness(self.response, radius)

    def punch_pressure(self, r: Array, radius: Array) -> Array:
        """p1(r; a) [Pa/m]."""
        return np.asarray(self.modulus / np.pi * fredholm.push(self.response, r, radius) / root_difference(radius, r))

    def punch_facts(self, radius: float) -> PunchFacts:
        """Whether a flat punch up to this radius [m] pulls, and how the surface moves outside; sampled."""
        return punch_facts.facts(self.response, radius)

    def normal_stiffness(self, x: Array) -> Array:
        """c_N(x) = k'(x)/2 [Pa]."""
        return self.modulus * fredholm.edge(self.response, x) ** 2

    def normal_stiffness_slope(self, x: Array) -> Array:
        """c_N'(x) [Pa/m]."""
        return 2.0 * self.modulus * fredholm.edge(self.response, x) * fredholm.edge_slope(self.response, x)

    @property
    def shear_modulus(self) -> float:
        """G* [Pa] of the uppermost layer and the other body: what the narrowest contacts feel."""
        return self.tangential_response.modulus

    @property
    def along_modulus(self) -> float:
        """m_L [Pa] of the uppermost layer and the other body, of shear along a wave, as in plane strain."""
        return self.along_response.modulus

    @property
    def torsional_modulus(self) -> float:
        """G_t [Pa] of the uppermost layer and the other body."""
        return 0.5 * self.across_response.modulus

    def punch_shear_stiffness(self, radius: Array) -> Array:
        """k_x(a) [N/m] of a flat punch that is pushed along the surface and does not press, without tilt."""
        along, across = (_stiffness(each, radius) for each in (self.along_response, self.across_response))
        whole = along + across
        return np.asarray(2.0 * along * across / np.where(whole > 0.0, whole, 1.0))

    def punch_torsional_stiffness(self, radius: Array) -> Array:
        """k_phi(a) [N m] of a flat punch that is twisted about its axis."""
        radius = np.asarray(radius, dtype=float)
        mean = fredholm.area(OddResponse(self.across_response), radius)
        return np.asarray(16.0 / 3.0 * self.torsional_modulus * radius**2 * mean)

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T(x) = k_x'(x)/2 [Pa]."""
        along, across = self.along_response, self.across_response
        first, second = (each.modulus * fredholm.mean(each, x) for each in (along, across))
        of_along, of_across = (each.modulus * fredholm.edge(each, x) ** 2 for each in (along, across))
        return np.asarray(2.0 * (second**2 * of_along + first**2 * of_across) / (first + second) ** 2)

    def pressure(self, displacement: Displacement, r: Array) -> Array:
        """p(r) [Pa]: flat punches superposed."""
        response = self.response
        return self.modulus * abel.pressure(
            displacement.slope,
            displacement.kinks,
            displacement.edge,
            displacement.radius,
            r,
            lambda r, x: fredholm.push(response, r, x),
            response.precision,
        )

    def displacement(self, displacement: Displacement, r: Array) -> Array:
        """The displacement of the surface [m], inside and outside the contact, sum over both bodies."""
        return coated_load.surface(displacement, self.response, r)

    def transformed_slope(self, imprint: Displacement) -> Curve:
        """Return h'(x) [-] as a function of 0 <= x <= a (`winkler.media.body_of`)."""
        load = CarriedLoad(imprint, self.response)
        own_share = spread(load, 0, 1)

        def rise(x: Array) -> Array:
            x = np.asarray(x, dtype=float)
            return np.asarray(load.slope(x) + own_share(x)[0])

        return rise

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Stresses and displacements in the layers and their base (`below`), or in the other body."""
        load = CarriedLoad(displacement, self.response)
        r, z = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(z, dtype=float))
        if below:
            return self.inside(load, r, z)
        if isinstance(self.second, Rigid):
            raise rigid_body(below=False)
        return solid_field(load, r, z, modulus=self.modulus, solid=self.second)

    def inside_dragged(self, load: CarriedLoad, modulus: float, x: Array, y: Array, z: Array) -> ShearField:
        """Stresses and displacements in the first body under a traction along +x: that of a load times a modulus."""
        raise OutsideValidity(
            f"{type(self).__name__}: the stresses of a traction on the surface are computed in bonded layers "
            "only; leave out the friction, or give a CoatedHalfSpace."
        )

    def dragged_interior(self, displacement: Displacement, x: Array, y: Array, z: Array, *, below: bool) -> ShearField:
        """Return stresses and displacements where the surface is dragged along +x by a traction equal to the pressure.

        Parameters
        ----------
        displacement : Displacement
            u(x) of the springs that press.
        x, y, z : ndarray
            Of one shape [m], z >= 0 into the body.
        below : bool
            Whether in the layers and their base, or in the other body.
        """
        return self._under_traction(CarriedLoad(displacement, self.response), self.modulus, x, y, z, below)

    def pushed_interior(self, moved: Displacement, x: Array, y: Array, z: Array, *, below: bool) -> ShearField:
        """Return stresses and displacements where the surface is dragged along +x by springs that move it.

        Parameters
        ----------
        moved : Displacement
            u(x) of the springs along the surface [m], of both bodies together.
        x, y, z, below
            As in `dragged_interior`.
        """
        return self._under_traction(CarriedLoad(moved, self.tangential_response), self.shear_modulus, x, y, z, below)

    def _under_traction(
        self, load: CarriedLoad, modulus: float, x: Array, y: Array, z: Array, below: bool
    ) -> ShearField:
        if below:
            return self.inside_dragged(load, modulus, x, y, z)
        second = self.second
        if isinstance(second, Rigid):
            raise rigid_body(below=False)
        if isinstance(second, TransverselyIsotropic):
            raise OutsideValidity(
                f"{type(self).__name__}: the stresses of a traction inside a transversely isotropic second body are "
                "not implemented; request the pressure alone, or points in the layers."
            )
        return shear_field.field(load, x, y, z, modulus=modulus, poisson=second.poisson, shear=second.shear)


class StackMedium(LayeredMedium):
    """Layers, bonded or sliding, isotropic or not: the three below are one, with other arguments and notes."""

    layers: tuple[AnyLayer, ...]
    on: Body
    notes: ClassVar[tuple[Note, ...]]
    """What is assumed."""

    def __post_init__(self) -> None:
        if not self.layers:
            raise InvalidInput(
                f"{type(self).__name__}: layers must be a list of at least one Layer or StackLayer(solid, thickness); "
                "for a body without layers give HalfSpace or TransverselyIsotropicHalfSpace."
            )

    @property
    def stack(self) -> tuple[AnyLayer, ...]:
        """The layers, with what they are bonded to."""
        return self.layers

    @property
    def thickness(self) -> float:
        """Of all layers together [m]."""
        return sum(layer.thickness for layer in self.layers)

    @property
    def spans(self) -> tuple[tuple[float, float], ...]:
        """Depths between which each layer lies, and what carries them if it deforms [m]: stresses jump between them."""
        ends = [0.0, *itertools.accumulate(layer.thickness for layer in self.layers)]
        if not isinstance(self.on, Rigid):
            ends.append(math.inf)
        return tuple(itertools.pairwise(ends))

    def responding(self, mode: Mode) -> PairResponse:
        """The response of the pair to a load: to a twist and a pressure, if a layer slides."""
        slides = next((number for number, layer in enumerate(self.stack, 1) if not layer.bonded), 0)
        if not slides or mode in (Mode.NORMAL, Mode.COUPLING):
            return PairResponse(mode, StackBody(self.stack, self.on), self.second)
        if mode is Mode.ACROSS:
            return FloatingAcross(mode, StackBody(self.stack[:slides], RIGID), self.second)
        raise OutsideValidity(
            f"{type(self).__name__}: layer {slides} slides on its base and carries no shear there. Under a "
            "tangential load it would slide away. Give bonded layers."
        )

    def inside(self, load: CarriedLoad, r: Array, z: Array) -> BodyField:
        """Stresses and displacements in the layers and their base; arrays of one shape."""
        return coated_interior.field(load, StackBody(self.stack, self.on), self.modulus, r, z)

    def inside_dragged(self, load: CarriedLoad, modulus: float, x: Array, y: Array, z: Array) -> ShearField:
        """Stresses and displacements under a traction along +x: that of a load times a modulus; no layer slides."""
        _ = self.tangential_response
        return sheared_interior.field(load, StackBody(self.stack, self.on), modulus, x, y, z)


def _stiffness(response: SurfaceResponse, radius: Array) -> Array:
    """Return the stiffness [N/m] of a flat punch on a medium with this response."""
    return 2.0 * response.modulus * fredholm.area(response, radius)


@value
class CoatedHalfSpace(StackMedium):
    """Bonded, isotropic layers on a half-space or a rigid base, against a homogeneous body.

    Parameters
    ----------
    layers : sequence of Layer
        At least one layer, in order from the surface down.
    on : Elastic or Rigid
        The body below the layers: an infinitely deep substrate, or a rigid base.
    second : Elastic or Rigid, optional
        The other body, z < 0; rigid by default.

    Raises
    ------
    InvalidInput
        If there is no layer, or something is not of these kinds.

    References
    ----------
    J. R. Barber, Determining the contact area in elastic-indentation problems, J. Strain Anal. 9 (1974) 230-232;
    M. Hess, Machines 11 (2023) 474.

    Examples
    --------
    >>> from winkler.materials.elastic import Rigid
    >>> rubber = Elastic(young=1e6, poisson=0.5)
    >>> film = CoatedHalfSpace([Layer(rubber, thickness=1e-3)], on=Rigid())
    >>> round(float(film.punch_stiffness(np.array(1e-3)) / (2 * film.modulus * 1e-3)), 4)  # Hayes 1972: 3.609
    3.6187
    """

    layers: tuple[Layer, ...]
    on: Solid
    second: Solid = RIGID

    notes = exact_response(
        "Frictionless contact of perfectly bonded, isotropic, linear elastic layers. For one round contact k "
        "and g follow exactly from flat punches on the layers.",
        BARBER,
    )
    """What is assumed."""


@value
class StackedHalfSpace(StackMedium):
    r"""Layers on a base, each bonded to the material below or sliding on it.

    Layers are isotropic or transversely isotropic. For bonded isotropic layers results are those of `CoatedHalfSpace`,
    which more problems support. A sliding interface has no friction and does not open.

    Parameters
    ----------
    layers : sequence of StackLayer or Layer
        At least one layer, in order from the surface down.  A `Layer` is bonded.
    on : Elastic, TransverselyIsotropic or Rigid
        The body below the layers: an infinitely deep substrate, or a rigid base.
    second : Elastic, TransverselyIsotropic or Rigid, optional
        The other body, z < 0; rigid by default.

    Raises
    ------
    InvalidInput
        If there is no layer, or something is not of these kinds.
    OutsideValidity
        Where shear on the surface is requested although a layer slides, or stresses of tractions inside a transversely
        isotropic uppermost layer or second body.

    References
    ----------
    J. R. Barber, Determining the contact area in elastic-indentation problems, J. Strain Anal. 9 (1974) 230-232;
    H. A. Elliott, Proc. Camb. Phil. Soc. 45 (1949) 621-630, doi:10.1017/S0305004100025305 (transversely isotropic
    solids).

    Examples
    --------
    A glass cover slip on a polymer: bonded to it, and sliding on it.

    >>> import numpy as np
    >>> glass, polymer = Elastic(young=70e9, poisson=0.2), Elastic(young=3e9, poisson=0.35)
    >>> for bonded in (True, False):
    ...     cover = StackedHalfSpace([StackLayer(glass, 10e-6, bonded)], on=polymer)
    ...     print(f"{float(cover.punch_stiffness(np.array(10e-6))) / 1e6:.4f} MN/m")
    0.1687 MN/m
    0.1525 MN/m
    """

    layers: tuple[StackLayer | Layer, ...]
    on: Elastic | TransverselyIsotropic | Rigid
    second: Elastic | TransverselyIsotropic | Rigid = RIGID

    notes = exact_response(
        "Frictionless contact of linear elastic layers, isotropic or transversely isotropic about the "
        "surface normal. Each layer is bonded to the material below, or slides on it without friction or "
        "gap. For one round contact k and g follow exactly from flat punches on the layers.",
        BARBER,
    )
    """What is assumed."""


@value
class SlidingFilm(StackMedium):
    r"""An isotropic layer on a half-space or a rigid base, without shear between them and without a gap.

    It is a `StackedHalfSpace` of one layer that is not bonded.  With x = xi h and gamma = E* / E*_b of layer and base

    .. math:: 1+M = \frac{\sinh^2x+\gamma\,(\sinh x\cosh x+x)}{\sinh x\cosh x+x+\gamma\,(\sinh^2x-x^2)} .

    The solid appears by E* alone: Poisson's ratio has no other effect.

    The layer is not bonded: it expands laterally under a pressure, also if it is incompressible, so that a thin film is
    far softer than the bonded one of `CoatedHalfSpace`.  It may slide, but it does not lift off.

    Parameters
    ----------
    layers : sequence of Layer
        One layer.
    on : Elastic or Rigid
        The body below the layer: an infinitely deep substrate, or a rigid base.
    second : Elastic or Rigid, optional
        The other body, z < 0; rigid by default.

    Raises
    ------
    InvalidInput
        If there is not one layer, or something is not of these kinds.
    OutsideValidity
        Where shear on the surface is requested.

    References
    ----------
    J. R. Barber, Determining the contact area in elastic-indentation problems, J. Strain Anal. 9 (1974) 230-232;
    E. K. Dimitriadis et al., Biophys. J. 82 (2002) 2798-2810, doi:10.1016/S0006-3495(02)75620-8 (samples not bonded).

    Examples
    --------
    >>> from winkler.materials.elastic import Elastic, Rigid
    >>> import numpy as np
    >>> film = SlidingFilm([Layer(Elastic(young=1e6, poisson=0.5), thickness=1e-3)], on=Rigid())
    >>> round(float(film.punch_stiffness(np.array(0.1)) / (np.pi * 0.1**2 * film.modulus / 1e-3)), 3)
    1.004
    """

    layers: tuple[Layer, ...]
    on: Solid
    second: Solid = RIGID

    def __post_init__(self) -> None:
        if len(self.layers) != 1:
            raise InvalidInput(
                f"SlidingFilm: layers has {len(self.layers)} layers; give one Layer(solid, thickness). "
                "StackedHalfSpace takes several layers, bonded or sliding; CoatedHalfSpace several bonded ones."
            )

    @property
    def stack(self) -> tuple[StackLayer, ...]:
        """The layer, which slides on its base."""
        return tuple(StackLayer(layer.solid, layer.thickness, bonded=False) for layer in self.layers)

    notes = exact_response(
        "Frictionless contact of an isotropic, linear elastic layer that slides on its base without friction "
        "and does not lift off. For one round contact k and g follow exactly from flat punches on the layer.",
        BARBER,
    )
    """What is assumed."""
