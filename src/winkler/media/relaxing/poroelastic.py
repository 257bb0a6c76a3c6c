r"""A film of a network and its liquid, such as a gel or cartilage, which the liquid leaves through the surface.

By Biot's theory with incompressible constituents a wave of pressure meets at the rate s the compliance of
`winkler.media.relaxing.poroelastic_waves`, and after a step of load a sum of exponentials: at first that of an
incompressible film of the shear modulus G, at last that of the drained network.  The times are those of diffusion,
:math:`1/(D\xi^2)` of short waves and :math:`4h^2/(\pi^2D)` of long ones, so that a wide contact relaxes later than a
small one, up to the time of the thickness.
"""

from __future__ import annotations

import functools
import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.materials.elastic import RIGID, Elastic, Rigid
from winkler.materials.layered import Layer
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.pair_response import Mode
from winkler.media.layered.wave_constants import Wave
from winkler.media.medium import exact_response
from winkler.media.relaxing.at_rate import (
    GLASSY,
    RELAXED,
    ShearOf,
    both,
    elastic_with,
    half_space_creep,
    refuse_unbounded,
    solid_at,
)
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.poroelastic_waves import drained_waves, film_creep
from winkler.numerics.caching import cached_by_value
from winkler.numerics.springs.exponential_sums import of_relaxation
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, FIRST_WAVE_NUMBER
from winkler.numerics.transforms.wave_creep import WaveCreep, fit_wave_creep
from winkler.numerics.types import Array, ComplexArray
from winkler.values.checks.number_checks import Advice, Number, Positive, PositiveNotTiny
from winkler.values.errors import OutsideValidity
from winkler.values.value import value, words

GREATEST_POISSON = 0.49
LEAST_POISSON = -0.9
WIDE = 50.0
"""Cells that reach so many thicknesses leave the peak of the undrained film out: it is over before forces count."""
MOST_WIDTHS = 1e9
"""A film thicker than so many cells is taken as so thick: the base adds less than 1e-5 to the stiffness."""
BIOT = (
    "M. A. Biot, J. Appl. Phys. 12 (1941) 155-164, doi:10.1063/1.1712886; J. McNamee, R. E. Gibson, Q. J. Mech. Appl. "
    "Math. 13 (1960) 98-111, doi:10.1093/qjmam/13.1.98"
)


@value
class PoroelasticFilm(RelaxingByWaves):
    """A liquid-filled network, bonded to a rigid, impermeable base and drained at its surface.

    Liquid also passes into the indenter. For contacts wider than about 40 thicknesses the creep within the time 1e-5
    h^2/D is treated as instantaneous. The force peak of the undrained film, hundreds of times the later force, is much
    shorter than this time. The force is therefore 3 % too high at the time 1e-4 h^2/D, and 0.3 % at 1e-3 h^2/D.

    The response depends on time. `ViscoelasticIndentation`, `CreepTest`, `RelaxationTest`, `HarmonicIndentation` and
    `ViscoelasticImpact` support it, `Torsion`, and `LineViscoelasticIndentation` in line contact.

    Parameters
    ----------
    shear : float
        G [Pa], positive, of the network and of the film as a whole.
    poisson : float
        nu [-] of the drained network, -0.9 to 0.49.
    diffusivity : float
        D [m^2/s], positive: 2 G (1 - nu)/(1 - 2 nu) times permeability over viscosity.
    thickness : float
        h [m], positive.
    second : Rigid, Elastic or ViscoelasticSolid, optional
        The body that is pressed in, z < 0; rigid by default.

    Raises
    ------
    InvalidInput
        If a number is outside its range, or the second body is a liquid at long times or has an infinite modulus at
        short times.

    References
    ----------
    M. A. Biot, J. Appl. Phys. 12 (1941) 155-164, doi:10.1063/1.1712886; J. McNamee, R. E. Gibson, Q. J. Mech. Appl.
    Math. 13 (1960) 98-111, doi:10.1093/qjmam/13.1.98

    Examples
    --------
    A gel of 100 um; at first it is incompressible, at last it is the drained network.

    >>> gel = PoroelasticFilm(shear=5e3, poisson=0.3, diffusivity=1e-10, thickness=100e-6)
    >>> gel.glassy.layers[0].solid.young, gel.relaxed.layers[0].solid.young
    (15000.0, 13000.0)
    """

    __words__ = words(
        diffusivity=("D", "m^2/s", "effective diffusivity of the liquid in the network"),
        poisson=(r"\nu", "", "Poisson's ratio of the drained network"),
    )

    described: ClassVar[str] = (
        "A film by Biot's linear theory, bonded to a rigid base and drained all over its surface,"
    )
    reason: ClassVar[str] = "the liquid leaves the film more slowly under wider contacts."
    alike: ClassVar[str] = (
        "an elastic CoatedHalfSpace: with the drained Poisson's ratio for long times, or poisson=0.5 for short times"
    )

    shear: Positive
    poisson: Annotated[
        float,
        Number(
            f"give Poisson's ratio of the drained network, {LEAST_POISSON} to {GREATEST_POISSON}",
            LEAST_POISSON,
            GREATEST_POISSON,
        ),
        Advice("an incompressible network holds its liquid: then take CoatedHalfSpace"),
    ]
    diffusivity: Positive
    thickness: PositiveNotTiny
    second: ViscoelasticSolid | Elastic | Rigid = RIGID

    def __post_init__(self) -> None:
        refuse_unbounded("PoroelasticFilm", (self.second,))

    @property
    def on(self) -> Rigid:
        """The base of the film."""
        return RIGID

    @property
    def glassy(self) -> CoatedHalfSpace:
        """The elastic film that responds to a sudden step: incompressible."""
        return self._film(0.5, GLASSY)

    @property
    def relaxed(self) -> CoatedHalfSpace:
        """The elastic film that is left when the liquid is at rest: the drained network."""
        return self._film(self.poisson, RELAXED)

    def _film(self, poisson: float, modulus: ShearOf) -> CoatedHalfSpace:
        solid = Elastic(2.0 * (1.0 + poisson) * self.shear, poisson)
        return CoatedHalfSpace((Layer(solid, self.thickness),), RIGID, elastic_with(self.second, modulus))

    @property
    def diffusion_time(self) -> float:
        """h^2 / D, of diffusion through the thickness [s]."""
        return self.thickness**2 / self.diffusivity

    @property
    def span(self) -> tuple[float, float]:
        """Range of times [s] in which the response is valid: all times, unless a viscoelastic second body limits it."""
        return self.second.span if isinstance(self.second, ViscoelasticSolid) else (0.0, math.inf)

    def waves(self, part: Wave, xi: Array, s: ComplexArray) -> ComplexArray:
        """Response of both surfaces to harmonic pressures, as in `RelaxingMedium.waves`.

        Raises
        ------
        OutsideValidity
            For shear, because the effect of the liquid on shear is not implemented.
        """
        if part is Wave.ACROSS:  # which moves no liquid
            film = np.tanh(xi * self.thickness) / (2.0 * self.shear)
            shape = np.broadcast_shapes(np.shape(xi), np.shape(s))
            return both(part, np.broadcast_to(film, shape), solid_at(self.second, np.broadcast_to(s, shape)))
        if part is not Wave.NORMAL:
            raise OutsideValidity(
                "PoroelasticFilm: the response of its surface to tangential forces is not implemented, only that to "
                "pressure and to a twist. Leave friction out, or give an elastic CoatedHalfSpace, with the drained "
                "Poisson's ratio for long times or poisson=0.5 for short times."
            )
        found = drained_waves(np.asarray(s) * self.diffusion_time, xi * self.thickness, self.poisson)
        return both(part, found / self.shear, solid_at(self.second, s))

    def creep_of_waves(self, width: float, reach: float, mode: Mode = Mode.NORMAL) -> WaveCreep:
        """Return how waves of line load sink after a step, those that cells of a width [m] tell apart.

        Raises
        ------
        OutsideValidity
            Of a push, whose waves along their direction meet the liquid.
        """
        if mode is not Mode.NORMAL:
            return _pushed_or_twisted(self, mode)
        thickness = min(self.thickness, MOST_WIDTHS * width)
        unit = film_creep(self.poisson, math.floor(math.log2(width / thickness)), reach > WIDE * thickness)
        film = WaveCreep(
            unit.times * (thickness**2 / self.diffusivity),
            unit.local / self.shear,
            unit.edges / thickness,
            unit.series / self.shear,
            unit.error,
        )
        return film if isinstance(self.second, Rigid) else film.plus(half_space_creep(self.second))

    notes = exact_response(
        "Frictionless contact with a film bonded to a rigid base, by Biot's linear theory with "
        "incompressible constituents and without inertia. Liquid passes freely through the surface, also "
        "into the indenter, but not into the base. Under a sealed indenter the force would decrease later. "
        "For contacts wider than 40 thicknesses the flow within 1e-5 h^2/D is taken as instantaneous. After "
        "a step the force is 3 % too high at 1e-4 h^2/D, 0.3 % at 1e-3 h^2/D, and less later.",
        BIOT,
    )
    """What is assumed."""


@cached_by_value(32)
def _pushed_or_twisted(film: PoroelasticFilm, mode: Mode) -> WaveCreep:
    """Return the creep under a load that moves no liquid: only the second body may relax."""
    second, times = film.second, (1.0, 1.0)
    if isinstance(second, ViscoelasticSolid):
        times = float(np.min(second.series.times)), float(np.max(of_relaxation(second.series).times))

    def share(s: ComplexArray) -> Array:
        if not isinstance(second, ViscoelasticSolid):
            return np.ones(s.size)
        return np.asarray(second.series.relaxed / np.abs(solid_at(second, s).shear))

    waves = FIRST_WAVE_NUMBER / film.thickness, DECAY_SPAN / film.thickness
    return fit_wave_creep(functools.partial(film.loaded_waves, mode), share, times, waves)
