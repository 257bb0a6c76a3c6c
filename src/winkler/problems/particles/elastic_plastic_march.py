r"""The march of an elastic-plastic particle that is pressed against a plane and let go, again and again.

The edge of the contact follows three rules: it advances when it gains more than closing needs, it
recedes when parting is paid for, else it rests.  The work of each such stretch is a difference of potentials, and so is
that of yielding: no step is too long.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.roots import between
from winkler.problems.particles.elastic_plastic_springs import (
    DEPTH_LIMIT,
    Material,
    ParticleSprings,
)
from winkler.problems.particles.particle_edge import potential
from winkler.problems.particles.particle_rules import particle_depth
from winkler.values.errors import OutsideValidity


class ParticleHistory(NamedTuple):
    """The memory of a particle.

    Parameters
    ----------
    largest : float
        Its greatest depth so far [m].
    compression : float
        By how much its springs are compressed now [m].
    angle : float
        Where the edge is; zero where the bodies are apart.
    touching : bool
        Whether they touch.
    work : float
        What was spent on it [J].
    """

    largest: float
    compression: float
    angle: float
    touching: bool
    work: float


class ParticleMarch(NamedTuple):
    """A particle and the works of adhesion.

    Parameters
    ----------
    material : Material
        The particle.
    closing, opening : float
        Works of adhesion [J/m^2].
    """

    material: Material
    closing: float
    opening: float

    def fresh(self) -> ParticleHistory:
        """Return a particle that was never touched."""
        return ParticleHistory(0.0, -np.inf, 0.0, False, 0.0)

    def potential(self, springs: ParticleSprings, angle: float, compression: float, work: float) -> float:
        """Return elastic and surface energy, at a prescribed depth [J]."""
        return potential(springs, angle, compression, work)

    def energy(self, state: ParticleHistory) -> float:
        """Return what is stored, less what closing has gained [J]."""
        if not state.touching:
            return 0.0
        return self.potential(self.material.springs(state.largest), state.angle, state.compression, self.closing)

    def to_depth(self, state: ParticleHistory, depth: float) -> ParticleHistory:
        """Return the particle at a depth."""
        if depth > DEPTH_LIMIT * self.material.radius:
            raise OutsideValidity(
                f"ElasticPlasticParticle: a depth of {depth:g} m is beyond {DEPTH_LIMIT:g} of the radius; there "
                "the particle is compressed as a whole, which this law of one contact neglects; stay below it."
            )
        particle = self.material.particle(self.closing, self.opening)
        return ParticleHistory(*particle_depth(particle, state, depth))

    def to_force(self, state: ParticleHistory, force: float) -> ParticleHistory:
        """Return the particle under a dead load."""
        springs = self.material.springs(state.largest)
        if not state.touching:
            # brought to touch without a force, where attraction holds it
            angle = springs.edge_under(0.0, self.closing)
            state = state._replace(compression=springs.balanced(angle, self.closing), angle=angle, touching=True)
        return self.to_depth(state, self._depth_under(springs, state, force))

    def _depth_under(self, springs: ParticleSprings, state: ParticleHistory, force: float) -> float:
        material = self.material
        roof = max(state.largest, material.yield_depth)
        deepest = DEPTH_LIMIT * material.radius
        angle = state.angle
        if force > springs.edge_force(angle, self.closing):
            angle = springs.edge_under(force, self.closing)
            compression = self._compression(springs, angle, self.closing, force)
            if springs.depth(compression) <= min(roof, deepest):
                return springs.depth(compression)
            if roof > deepest or force > material.force(deepest):
                raise OutsideValidity(
                    f"ElasticPlasticParticle: a force of {force:g} N presses the particle deeper than "
                    f"{DEPTH_LIMIT:g} of its radius, beyond which this law of one contact is not valid; give a "
                    "smaller one."
                )
            if force <= material.force(roof):
                return roof
            return between(lambda depth: material.force(depth) - force, roof, deepest)
        if force < springs.edge_force(angle, self.opening):
            least = springs.critical(self.opening, 1.5)
            if angle <= least or force < springs.edge_force(least, self.opening):
                held = springs.edge_force(min(angle, least), self.opening)
                raise OutsideValidity(
                    f"ElasticPlasticParticle: a force of {force:g} N pulls the particle off, whose pull-off force "
                    f"is {held:g} N; prescribe depths to follow it beyond, or stay above."
                )
            angle = springs.edge_under(force, self.opening)
            return springs.depth(self._compression(springs, angle, self.opening, force))
        return springs.depth(self._compression(springs, angle, self.opening, force))

    def _compression(self, springs: ParticleSprings, angle: float, work: float, force: float) -> float:
        """Return the compression of the springs under a force with the edge at an angle [m]."""
        held = springs.balanced(angle, work)
        if angle == 0.0:
            return held
        return held + (force - springs.force(angle, held)) / (2.0 * springs.modulus * springs.radius(angle))
