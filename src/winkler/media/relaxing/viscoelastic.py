r"""Two homogeneous half-spaces of which at least one is viscoelastic.

Poisson's ratios do not change in time, so the equivalent profile g of an elastic half-space stays, and every spring
relaxes by the same function,

.. math:: q(x,t) = \int E^*(t-t')\,\frac{\partial u(x,t')}{\partial t'}\,\mathrm dt' , \qquad
          \frac{1}{s^2\,\hat E^*(s)} = \sum_\text{bodies}\frac{1-\nu}{2}\,\hat J(s) :

bodies bear the same pressure, so their creep adds up.
"""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from winkler.materials.elastic import RIGID, Elastic, Rigid
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.media.interior import subsurface
from winkler.media.layered.wave_constants import Wave, half_space_compliance
from winkler.media.medium import Displacement, exact_response, rigid_body
from winkler.media.punch_field import BodyField
from winkler.media.relaxing.at_rate import both, half_space_creep, solid_at
from winkler.media.relaxing.relaxing_medium import LEE, RelaxingMedium
from winkler.numerics.springs.exponential_sums import CreepSeries, RelaxationSeries, of_creep
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.value import value

UNIT_HALF_SPACE = HalfSpace(Elastic(0.75, 0.5))
"""E* = 1 Pa."""


@value
class ViscoelasticHalfSpace(RelaxingMedium, HomogeneousMedium):
    """Two homogeneous half-spaces in contact, at least one of them viscoelastic.

    The response depends on time; use problems for viscoelastic bodies such as `ViscoelasticIndentation`. The moduli at
    short and long times are `relaxation.glassy` and `relaxation.relaxed`.

    Parameters
    ----------
    first : ViscoelasticSolid, Elastic or Rigid
        The body below, z > 0.
    second : ViscoelasticSolid, Elastic or Rigid, optional
        The body above, z < 0; rigid by default.

    Raises
    ------
    InvalidInput
        If neither of them is viscoelastic.

    References
    ----------
    E. H. Lee, J. R. M. Radok, J. Appl. Mech. 27 (1960) 438-444, doi:10.1115/1.3644020

    Examples
    --------
    >>> from winkler.materials.spring_and_dashpot import StandardSolid
    >>> gel = ViscoelasticHalfSpace(StandardSolid(relaxed_shear=1e3, shear=4e3, relaxation_time=2.0))
    >>> gel.relaxation.relaxed, gel.relaxation.glassy
    (4000.0, 20000.0)
    """

    first: ViscoelasticSolid | Elastic | Rigid
    second: ViscoelasticSolid | Elastic | Rigid = RIGID

    def __post_init__(self) -> None:
        if not any(isinstance(body, ViscoelasticSolid) for body in (self.first, self.second)):
            raise InvalidInput(
                "ViscoelasticHalfSpace: neither of the bodies is viscoelastic; give Maxwell, Prony or another one, or "
                "use HalfSpace."
            )

    @property
    def elastic(self) -> HalfSpace:
        """Half-spaces with E* = 1 Pa: g does not depend on the modulus."""
        return UNIT_HALF_SPACE

    @property
    def creep(self) -> CreepSeries:
        """Creep function of the pair: 1/E* as a function of the time after a step of load [1/Pa]."""
        return _creep(self)

    @property
    def relaxation(self) -> RelaxationSeries:
        """E*(t) of the pair [Pa]."""
        return _relaxation(self)

    @property
    def span(self) -> tuple[float, float]:
        """Shortest and longest time [s] between which the series of both bodies are valid."""
        spans = [body.span for body in (self.first, self.second) if isinstance(body, ViscoelasticSolid)]
        return max(shortest for shortest, _ in spans), min(longest for _, longest in spans)

    modulus = shear_modulus = torsional_modulus = along_modulus = property(RelaxingMedium._changing)

    def waves(self, part: Wave, xi: Array, s: ComplexArray) -> ComplexArray:
        """Response of both surfaces to harmonic pressures, as in `RelaxingMedium.waves`: of all lengths the same."""
        xi, s = np.broadcast_arrays(xi, s)
        own = half_space_compliance(solid_at(self.first, s), part)
        return both(part, np.full(xi.shape, own, dtype=complex), solid_at(self.second, s))

    notes = exact_response(
        "Linear viscoelastic half-spaces with constant Poisson's ratios, without friction and inertia. While "
        "the contact is one disc, the springs are equal to the three-dimensional solution.",
        LEE,
    )
    """What is assumed."""

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Stresses and displacements inside the first body (`below`) or the second, at depths z >= 0 into it.

        Raises
        ------
        OutsideValidity
            If the body is rigid, or both bodies creep by different functions, so that their shares of the displacement
            are not known.
        """
        borne = self.elastic_parts(displacement)
        body, other = (self.first, self.second) if below else (self.second, self.first)
        if isinstance(body, Rigid):
            raise rigid_body(below)
        shear = body.shear if isinstance(body, Elastic) else 0.5 * (1.0 - body.poisson)
        stresses = [subsurface.field(part, r, z, modulus=1.0, poisson=body.poisson, shear=shear) for part in borne]
        if isinstance(body, Elastic):
            still = BodyField(*np.zeros((6, *np.broadcast_shapes(np.shape(r), np.shape(z)))))
            return stresses[0] if stresses else still
        moved = np.array(subsurface.field(displacement, r, z, modulus=1.0, poisson=body.poisson, shear=shear))
        if isinstance(other, Elastic):
            # the other body's part of the displacement is that of elastic springs
            for part in stresses:
                moved -= np.array(part) * (1.0 - other.poisson**2) / other.young
        elif isinstance(other, ViscoelasticSolid):
            moved *= share_of_creep(body, other)
        loaded = np.array(stresses[0]) if stresses else np.zeros(moved.shape)
        return BodyField(*loaded[:4], *moved[4:])


def creep_ratio(body: Any, other: Any) -> float | None:
    """Return the modulus of one body over that of another, nothing unless both relax in proportion."""
    if not (isinstance(body, ViscoelasticSolid) and isinstance(other, ViscoelasticSolid)):
        return None
    own, its = body.series, other.series
    ratio = own.viscosity / its.viscosity if its.viscosity > 0.0 else own.glassy / its.glassy
    alike = np.array_equal(own.times, its.times) and np.allclose(own.moduli, ratio * its.moduli, rtol=1e-12, atol=0.0)
    return float(ratio) if alike and np.isclose(own.relaxed, ratio * its.relaxed, rtol=1e-12, atol=0.0) else None


def share_of_creep(body: ViscoelasticSolid, other: ViscoelasticSolid) -> float:
    """Return how much of a common displacement is a body's; refuse two that do not creep in proportion."""
    ratio = creep_ratio(body, other)
    if ratio is None:
        raise OutsideValidity(
            "ViscoelasticHalfSpace: both bodies are viscoelastic with different relaxation functions, so the "
            "displacement of each is not known; request the surface (without z), or use one elastic or rigid "
            "body."
        )
    return float((1.0 - body.poisson) / (1.0 - body.poisson + (1.0 - other.poisson) * ratio))


@functools.lru_cache(maxsize=64)
def _creep(medium: ViscoelasticHalfSpace) -> CreepSeries:
    total = CreepSeries(0.0, 0.0, np.empty(0), np.empty(0))
    for body in (medium.first, medium.second):
        total = total.plus(half_space_creep(body))
    return total


@functools.lru_cache(maxsize=64)
def _relaxation(medium: ViscoelasticHalfSpace) -> RelaxationSeries:
    bodies = [body for body in (medium.first, medium.second) if not isinstance(body, Rigid)]
    if len(bodies) == 1 and isinstance(bodies[0], ViscoelasticSolid):
        return bodies[0].series.scaled(2.0 / (1.0 - bodies[0].poisson))
    return of_creep(_creep(medium))
