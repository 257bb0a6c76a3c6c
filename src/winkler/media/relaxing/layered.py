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

import math
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np

from winkler.errors import InvalidInput
from winkler.materials.elastic import RIGID, Elastic, Rigid
from winkler.materials.layered import Layer
from winkler.materials.relaxing_layer import ViscoelasticLayer
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.faces import Face, above, compliance_of, face_of, rescaled
from winkler.media.layered.wave_constants import WaveConstants, constants_of
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.relaxing_medium import LEE
from winkler.numerics.caching import cached_by_value
from winkler.numerics.springs.exponential_sums import of_relaxation
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, FIRST_WAVE_NUMBER
from winkler.numerics.transforms.wave_creep import WaveCreep, fit_wave_creep
from winkler.numerics.types import Array, ComplexArray
from winkler.validity import Assumption, Note, Standing
from winkler.values import value

__all__ = ["ViscoelasticCoatedHalfSpace"]

VANISHED_DEPTH = 44.0
"""A layer whose top lies this deep, times xi, has no effect."""


@value
class ViscoelasticCoatedHalfSpace(RelaxingByWaves):
    """Bonded layers on a half-space or a rigid base, of which each may relax by a law of its own.

    Its response depends on time, and not in proportion: `ViscoelasticIndentation`, `CreepTest`, `RelaxationTest` and
    `HarmonicIndentation` know it.

    Parameters
    ----------
    layers : sequence of Layer and ViscoelasticLayer
        From the surface down, at least one.
    on : Elastic, Rigid or ViscoelasticSolid
        What carries them: an infinitely deep substrate, or a base that does not deform.
    second : Elastic, Rigid or ViscoelasticSolid, optional
        The other body, z < 0; rigid unless given.

    Raises
    ------
    InvalidInput
        If there is no layer, nothing relaxes, or a solid flows for ever or has an infinite modulus at first.

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

    reason: ClassVar[str] = "the layers of the bed relax each by a law of its own,"
    alike: ClassVar[str] = "RelaxingInProportion(medium, solid, shear) of layers that relax alike"

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
        for solid in self.relaxing_solids:
            series = solid.series
            if series.relaxed == 0.0 or math.isinf(series.glassy):
                what = "flows for ever" if series.relaxed == 0.0 else "resists a step with an infinite modulus"
                raise InvalidInput(
                    f"ViscoelasticCoatedHalfSpace: a {type(solid).__name__} {what}; give a solid with a positive "
                    "relaxed modulus and without a dashpot alongside, such as StandardSolid or Prony."
                )

    @property
    def relaxing_solids(self) -> tuple[ViscoelasticSolid, ...]:
        """The viscoelastic solids of layers, base and second body."""
        solids = (*(layer.solid for layer in self.layers), self.on, self.second)
        return tuple(solid for solid in solids if isinstance(solid, ViscoelasticSolid))

    @property
    def glassy(self) -> CoatedHalfSpace:
        """The elastic stack that responds to a sudden step."""
        return self.elastic_with(lambda solid: solid.series.glassy)

    @property
    def relaxed(self) -> CoatedHalfSpace:
        """The elastic stack that is left after all time."""
        return self.elastic_with(lambda solid: solid.series.relaxed)

    def elastic_with(self, shear: Callable[[ViscoelasticSolid], float]) -> CoatedHalfSpace:
        """Return the elastic stack in which the solids that relax have shear moduli [Pa]."""

        def elastic(solid: Any) -> Any:
            if not isinstance(solid, ViscoelasticSolid):
                return solid
            return Elastic(2.0 * (1.0 + solid.poisson) * shear(solid), solid.poisson)

        layers = tuple(Layer(elastic(layer.solid), layer.thickness) for layer in self.layers)
        return CoatedHalfSpace(layers, elastic(self.on), elastic(self.second))

    @property
    def span(self) -> tuple[float, float]:
        """From which time on and up to which the series of all solids are the solids [s]."""
        spans = [solid.span for solid in self.relaxing_solids]
        return max(shortest for shortest, _ in spans), min(longest for _, longest in spans)

    def creep_of_waves(self, width: float, reach: float) -> WaveCreep:
        """Return how all waves of line load sink after a step, of any length; cached by value."""
        return _wave_creep(self)

    def compliance(self, s: ComplexArray, xi: Array) -> ComplexArray:
        """Return c(s, xi) [1/Pa] of the pair at complex rates (S,) [1/s] and wave numbers (m,) [1/m], ``(S, m)``."""
        return self.compliance_of(lambda solid: _shear(solid, s), s.size, xi)

    def compliance_at_modulus(self, shear: ComplexArray, xi: Array) -> ComplexArray:
        """Return c [1/Pa] of waves [1/m] ``(m,)`` if all solids that relax had a shear modulus [Pa] ``(S,)``."""

        def own(solid: ViscoelasticSolid | Elastic) -> ComplexArray:
            return np.full(shear.shape, solid.shear, dtype=complex) if isinstance(solid, Elastic) else shear

        return self.compliance_of(own, shear.size, xi)

    def compliance_of(self, shear: Callable[[Any], ComplexArray], count: int, xi: Array) -> ComplexArray:
        """Return c [1/Pa] of waves [1/m] ``(m,)`` for `count` shear moduli of every solid, ``(count, m)``."""
        finite = np.isfinite(xi)
        x = np.tile(xi[finite], count).astype(complex)

        def moduli(solid: ViscoelasticSolid | Elastic) -> ComplexArray:
            return np.repeat(shear(solid), finite.sum())

        def half_space(solid: ViscoelasticSolid | Elastic) -> Face:
            a, b, c, d = _of_one(solid).half_space
            return rescaled(face_of((a + 0.0 * x, b + 0.0 * x, c + 0.0 * x, d + 0.0 * x)), 1.0 / moduli(solid))

        rigid = np.zeros_like(x)
        face = face_of((rigid, rigid, rigid, rigid)) if isinstance(self.on, Rigid) else half_space(self.on)
        bottom = sum(layer.thickness for layer in self.layers)
        for layer in reversed(self.layers):
            bottom -= layer.thickness
            reached = np.real(x) * bottom < VANISHED_DEPTH
            modulus, upper = moduli(layer.solid)[reached], half_space(layer.solid)
            below: Face = tuple(minor[reached] for minor in face)  # type: ignore[assignment]
            risen = above(_of_one(layer.solid), rescaled(below, modulus), x[reached] * layer.thickness)
            for minor, found in zip(upper, rescaled(risen, 1.0 / modulus), strict=True):
                minor[reached] = found
            face = upper
        result = np.empty((count, xi.size), dtype=complex)
        result[:, finite] = -0.5 * compliance_of(face)[3].reshape(count, -1)
        top = self.layers[0].solid
        result[:, ~finite] = _own(top, shear(top))[:, None]
        if isinstance(self.second, Rigid):
            return result
        return np.asarray(result + _own(self.second, shear(self.second))[:, None])

    notes = (
        Note(
            Assumption.RESPONSE,
            Standing.EXACT,
            "Frictionless contact of perfectly bonded, isotropic, linear viscoelastic layers with Poisson's ratios "
            "that do not change in time, without inertia: tractions are superposed over the history, wave by wave.",
            LEE,
        ),
    )
    """What is assumed."""


def _of_one(solid: ViscoelasticSolid | Elastic) -> WaveConstants:
    """Return the constants of a solid with a shear modulus of one."""
    return constants_of(Elastic(2.0 * (1.0 + solid.poisson), solid.poisson))


def _shear(solid: ViscoelasticSolid | Elastic, s: ComplexArray) -> ComplexArray:
    """Return the shear modulus at complex rates [Pa]."""
    if isinstance(solid, Elastic):
        return np.full(s.shape, solid.shear, dtype=complex)
    series = solid.series
    last = np.isinf(np.abs(s))
    return np.asarray(np.where(last, series.glassy, series.dynamic(np.where(last, 0.0, s.imag))))


def _own(solid: ViscoelasticSolid | Elastic, shear: ComplexArray) -> ComplexArray:
    """Return 1 / E* of a half-space of a solid with shear moduli [Pa] [1/Pa]."""
    return np.asarray(0.5 * (1.0 - solid.poisson) / shear)


@cached_by_value(32)
def _wave_creep(medium: ViscoelasticCoatedHalfSpace) -> WaveCreep:
    solids = medium.relaxing_solids

    def share(s: ComplexArray) -> Array:
        return np.asarray(np.min([solid.series.relaxed / np.abs(_shear(solid, s)) for solid in solids], axis=0))

    times = (
        min(float(np.min(solid.series.times)) for solid in solids),
        max(float(np.max(of_relaxation(solid.series).times)) for solid in solids),
    )
    stacks = [stack.response for stack in (medium.glassy, medium.relaxed)]
    waves = FIRST_WAVE_NUMBER / max(stack.span for stack in stacks), DECAY_SPAN / stacks[0].length
    return fit_wave_creep(medium.compliance, share, times, waves)
