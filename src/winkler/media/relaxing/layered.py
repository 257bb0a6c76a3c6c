r"""Coated bodies whose layers relax, each by a law of its own.

Poisson's ratios do not change in time, so that a wave of pressure meets, by the elastic-viscoelastic correspondence,
the compliance of the elastic stack with the moduli :math:`G_j(s)`, and after a step of load a sum of exponentials
(`winkler.numerics.transforms.wave_creep`).  The ratios of the moduli change in time, and with them the shape of g:
neither k(a) nor g(x) exists by itself.  What is left of the springs is their line load q(x), the Abel transform of the
pressure, and their displacement u(x); each wave of q moves its own wave of u,

.. math:: \hat u(\xi,t) = \int_0^t c(\xi,t-t')\,\frac{\partial\hat q(\xi,t')}{\partial t'}\,\mathrm dt' ,
          \qquad c = \tfrac12\,\xi\,C(\xi,t) ,

and the body asks for :math:`u(x,t) = d(t)-h(x)` where they touch, h the equivalent profile on a homogeneous body.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np

from winkler.materials.elastic import RIGID, Elastic, Rigid
from winkler.materials.layered import Layer
from winkler.materials.relaxing_layer import ViscoelasticLayer
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.pair_response import Mode
from winkler.media.layered.stack import stack_waves
from winkler.media.layered.wave_constants import IsotropicAt, Wave
from winkler.media.medium import exact_response
from winkler.media.relaxing.at_rate import (
    GLASSY,
    RELAXED,
    LayerAt,
    ShearOf,
    both,
    elastic_with,
    refuse_unbounded,
    solid_at,
)
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.relaxing_medium import LEE
from winkler.numerics.caching import cached_by_value
from winkler.numerics.springs.exponential_sums import of_relaxation
from winkler.numerics.springs.rate_fit import RateFit, fit_rates
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, FIRST_WAVE_NUMBER
from winkler.numerics.transforms.wave_creep import WaveCreep, fit_wave_creep
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import InvalidInput
from winkler.values.value import value

VANISHED_DEPTH = 44.0
"""What lies so deep, times xi, has no effect."""


@value
class ViscoelasticCoatedHalfSpace(RelaxingByWaves):
    """Bonded layers on a half-space or a rigid base, each with a separate relaxation function.

    The response depends on time, and is not proportional to one function. `ViscoelasticIndentation`, `CreepTest`,
    `RelaxationTest`, `HarmonicIndentation` and `ViscoelasticImpact` support it, with friction `Tangential`, `Torsion`,
    `FrictionDamping` and `BimodalDamping`, in line contact `LineViscoelasticIndentation` and `LineTangential`, and
    `SurfaceTangential` for height maps.

    Parameters
    ----------
    layers : sequence of Layer and ViscoelasticLayer
        At least one layer, in order from the surface down.
    on : Elastic, Rigid or ViscoelasticSolid
        The body below the layers: an infinitely deep substrate, or a rigid base.
    second : Elastic, Rigid or ViscoelasticSolid, optional
        The other body, z < 0; rigid by default.

    Raises
    ------
    InvalidInput
        If there is no layer, no part is viscoelastic, or a solid is a liquid at long times or has an infinite modulus
        at short times.

    References
    ----------
    E. H. Lee, J. R. M. Radok, J. Appl. Mech. 27 (1960) 438-444, doi:10.1115/1.3644020; J. R. Barber, J. Strain Anal. 9
    (1974) 230-232

    Examples
    --------
    A film of gel on glass, at first five times as stiff as after all time.

    >>> from winkler.materials.spring_and_dashpot import StandardSolid
    >>> gel = StandardSolid(relaxed_shear=1e3, shear=4e3, relaxation_time=2.0)
    >>> film = ViscoelasticCoatedHalfSpace([ViscoelasticLayer(gel, 50e-6)], on=Elastic(young=70e9, poisson=0.2))
    >>> film.glassy.layers[0].solid.young, film.relaxed.layers[0].solid.young
    (15000.0, 3000.0)
    """

    described: ClassVar[str] = "Perfectly bonded, isotropic, linear viscoelastic layers"
    reason: ClassVar[str] = "each layer of this medium has its own relaxation function."
    alike: ClassVar[str] = "RelaxingInProportion(medium, solid, shear) of layers with a common relaxation function"

    layers: tuple[Layer | ViscoelasticLayer, ...]
    on: ViscoelasticSolid | Elastic | Rigid
    second: ViscoelasticSolid | Elastic | Rigid = RIGID

    def __post_init__(self) -> None:
        if not self.layers:
            raise InvalidInput(
                "ViscoelasticCoatedHalfSpace: layers must be a list of at least one ViscoelasticLayer(solid, "
                "thickness); for a body without layers give ViscoelasticHalfSpace."
            )
        if not self.relaxing_solids:
            raise InvalidInput(
                "ViscoelasticCoatedHalfSpace: none of layers, on and second is viscoelastic; give one a Prony or "
                "another viscoelastic solid, or use CoatedHalfSpace."
            )
        refuse_unbounded("ViscoelasticCoatedHalfSpace", self.relaxing_solids)

    @property
    def relaxing_solids(self) -> tuple[ViscoelasticSolid, ...]:
        """The viscoelastic solids of layers, base and second body."""
        solids = (*(layer.solid for layer in self.layers), self.on, self.second)
        return tuple(solid for solid in solids if isinstance(solid, ViscoelasticSolid))

    @property
    def glassy(self) -> CoatedHalfSpace:
        """The elastic stack that responds to a sudden step."""
        return self.elastic_with(GLASSY)

    @property
    def relaxed(self) -> CoatedHalfSpace:
        """The elastic stack at long times."""
        return self.elastic_with(RELAXED)

    def elastic_with(self, shear: ShearOf) -> CoatedHalfSpace:
        """Return the elastic stack in which the solids that relax have shear moduli [Pa]."""
        layers = tuple(Layer(elastic_with(layer.solid, shear), layer.thickness) for layer in self.layers)
        return CoatedHalfSpace(layers, elastic_with(self.on, shear), elastic_with(self.second, shear))

    @property
    def span(self) -> tuple[float, float]:
        """Shortest and longest time [s] between which the series of all solids are valid."""
        spans = [solid.span for solid in self.relaxing_solids]
        return max(shortest for shortest, _ in spans), min(longest for _, longest in spans)

    def creep_of_waves(self, width: float, reach: float, mode: Mode = Mode.NORMAL) -> WaveCreep:
        """Return how all waves of line load sink or move along after a step, of any length; cached by value."""
        return _wave_creep(self, mode)

    @property
    def rates(self) -> RateFit:
        """At which rates the stack answers as elastic ones do."""
        return _rate_fit(self)

    def elastic_at(self, rate: float) -> CoatedHalfSpace:
        """Return the elastic stack that answers alike at a rate [1/s], infinite for a sudden step."""
        return self.elastic_with(lambda solid: float(np.real(solid_at(solid, np.array(rate)).shear)))

    def _least_share(self, s: Any) -> Array:
        """Return the smallest compliance of a solid at rates [1/s] over that after all time."""
        shares = [solid.series.relaxed / np.abs(solid_at(solid, s).shear) for solid in self.relaxing_solids]
        return np.asarray(np.min(shares, axis=0))

    @property
    def _retarded(self) -> tuple[float, float]:
        """Between which the retardation times of the stack lie [s]."""
        series = [solid.series for solid in self.relaxing_solids]
        longest = max(float(np.max(of_relaxation(each).times)) for each in series)
        return min(float(np.min(each.times)) for each in series), longest

    @property
    def thickness(self) -> float:
        """Depth below which the body is homogeneous [m]."""
        return float(self.bodies.thickness)

    def waves(self, part: Wave, xi: Array, s: ComplexArray) -> ComplexArray:
        """Response of both surfaces to harmonic pressures, as in `RelaxingMedium.waves`."""
        xi, s = np.broadcast_arrays(xi, s)
        rates = s.ravel()
        return self._waves_of(part, xi.ravel(), lambda solid: solid_at(solid, rates)).reshape(xi.shape)

    def waves_at_modulus(self, shear: ComplexArray, xi: Array) -> ComplexArray:
        """Return c [1/Pa] of waves [1/m] ``(m,)`` for shear moduli of the relaxing solids [Pa] ``(S,)``."""
        moduli = np.repeat(shear, xi.size)

        def own(solid: Any) -> Any:
            return IsotropicAt(moduli, solid.poisson) if isinstance(solid, ViscoelasticSolid) else solid

        return self._waves_of(Wave.NORMAL, np.tile(xi, shear.size), own).reshape(shear.size, xi.size)

    def _waves_of(self, part: Wave, xi: Array, own: Callable[[Any], Any]) -> ComplexArray:
        """Return what both surfaces answer if each solid is what `own` makes of it, which has a modulus for each xi."""
        layers = tuple(LayerAt(own(layer.solid), layer.thickness) for layer in self.layers)
        short = VANISHED_DEPTH / layers[0].thickness  # from here on waves feel the uppermost layer alone
        return both(part, stack_waves(layers, own(self.on), part, np.minimum(xi, short) + 0j), own(self.second))

    notes = exact_response(
        "Frictionless contact of perfectly bonded, isotropic, linear viscoelastic layers with constant "
        "Poisson's ratios, without inertia. The pressures are superposed over the history, separately for "
        "each wavelength.",
        LEE,
    )
    """What is assumed."""


@cached_by_value(32)
def _rate_fit(medium: ViscoelasticCoatedHalfSpace) -> RateFit:
    return fit_rates(medium._retarded, medium._least_share)


@cached_by_value(32)
def _wave_creep(medium: ViscoelasticCoatedHalfSpace, mode: Mode) -> WaveCreep:
    stacks = [stack.responding(mode) for stack in (medium.glassy, medium.relaxed)]
    waves = FIRST_WAVE_NUMBER / max(stack.span for stack in stacks), DECAY_SPAN / stacks[0].length
    answered = functools.partial(medium.loaded_waves, mode)
    return fit_wave_creep(answered, medium._least_share, medium._retarded, waves)
