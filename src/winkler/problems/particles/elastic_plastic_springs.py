r"""The springs of an elastic-plastic particle: what it is pressed like at present, and how it came to be like that.

A particle against a rigid plane has springs of the stiffness :math:`E_c=E/(1-\nu^2)` under half an ellipse,

.. math:: g(x) = A\sin^2\tfrac\varphi2, \qquad x = b\sin\varphi .

While it is elastic, :math:`A=4R`, :math:`b=R`: a ball.  Once its mean pressure has passed the yield pressure
:math:`p_Y(d)=Y(1.75\,e^{-4.4\,d/R}+1)` at the depth :math:`d_Y`, the greatest depth :math:`D` so far shapes it:

.. math:: b^2 = 2DR - D^2 + d_Y^2 - d_YR, \qquad A = 4p_Y(D)\,b/E_c ,

fully pressed in at :math:`D`, which means the uniform pressure :math:`p_Y`.  The springs then have the depth
:math:`(d-d_0)/s`, where :math:`s-1` is the share by which the rest of the particle yields, and :math:`d_0` is what
remains when it is let go.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from winkler.materials.elastic import Elastic
from winkler.numerics.equations.roots import between
from winkler.problems.particles.particle_edge import (
    FULL_CONTACT_ANGLE,
    balanced,
    critical_angle,
    held_edge,
    spring_sums,
)
from winkler.problems.particles.particle_rules import (
    Particle,
    particle_springs,
    yield_force,
    yield_pressure,
    yield_work,
)

__all__ = ["DEPTH_LIMIT", "FULL_CONTACT_ANGLE", "Material", "ParticleSprings", "material_of"]

DEPTH_LIMIT = 0.5
"""Depth over radius up to which the law is followed."""


class ParticleSprings(NamedTuple):
    """Springs under half an ellipse; the edge of the contact is given by an angle, a = b sin(angle).

    Parameters
    ----------
    modulus : float
        E_c [Pa].
    height : float
        A [m], twice the depth at which all springs are pressed.
    half_width : float
        b [m].
    origin, stretch : float
        d0 [m] and s [-]: the springs are compressed by (d - d0) / s.
    """

    modulus: float
    height: float
    half_width: float
    origin: float
    stretch: float

    def compression(self, depth: float) -> float:
        """Return by how much a depth compresses the springs [m]."""
        return (depth - self.origin) / self.stretch

    def depth(self, compression: float) -> float:
        """Return the depth that compresses the springs so much [m]."""
        return self.origin + self.stretch * compression

    def radius(self, angle: float) -> float:
        """Return the radius of the contact [m]."""
        return self.half_width * math.sin(angle)

    def sums(self, angle: float, compression: float) -> tuple[float, float]:
        """Return force [N] and elastic energy of the springs [J], from quadrature that is exact to rounding."""
        return spring_sums(self, angle, compression)

    def force(self, angle: float, compression: float) -> float:
        """Return the force [N]."""
        return self.sums(angle, compression)[0]

    def balanced(self, angle: float, work: float) -> float:
        """Return the compression of the springs when an edge at the angle is just held by a work of adhesion [m]."""
        return balanced(self, angle, work)

    def critical(self, work: float, factor: float) -> float:
        """Return the angle where a g' is `factor` times the stretch of the last spring: the end of stability.

        1/2 under a prescribed depth, 3/2 under a dead load.
        """
        return critical_angle(self, work, factor)

    def edge(self, compression: float, work: float) -> float:
        """Return the angle of the stable edge; zero if there is none."""
        return held_edge(self, compression, work, 0.0)

    def edge_force(self, angle: float, work: float) -> float:
        """Return the force while the edge is just held [N]."""
        return self.force(angle, self.balanced(angle, work))

    def edge_under(self, force: float, work: float) -> float:
        """Return the angle of the stable edge under a dead load that is not below the least one."""
        least = self.critical(work, 1.5)
        if force >= self.edge_force(FULL_CONTACT_ANGLE, work):
            return FULL_CONTACT_ANGLE
        if force <= self.edge_force(least, work):
            return least
        return between(lambda angle: self.edge_force(angle, work) - force, least, FULL_CONTACT_ANGLE)


class Material(NamedTuple):
    """What a particle is made of, and where it yields.

    Parameters
    ----------
    radius : float
        R [m].
    solid : Elastic
        With its yield strength.
    modulus : float
        E_c [Pa].
    yield_depth : float
        d_Y [m]; infinite if it does not yield up to half its radius.
    """

    radius: float
    solid: Elastic
    modulus: float
    yield_depth: float

    def yield_pressure(self, depth: float) -> float:
        """Return p_Y [Pa] at a depth."""
        return yield_pressure(self.radius, self.solid.strength, depth)

    def particle(self, closing: float = 0.0, opening: float = 0.0) -> Particle:
        """Return the numbers of the particle, with works of adhesion [J/m^2]."""
        solid = self.solid
        return (
            self.radius, solid.strength, solid.shear, solid.poisson, self.modulus, self.yield_depth, 4.0 * self.radius,
            self.radius, closing, opening,
        )  # fmt: skip

    def force(self, depth: float) -> float:
        """Return the force that presses the particle deeper than ever before, beyond yield [N]."""
        return yield_force(self.particle(), depth)

    def work(self, depth: float) -> float:
        """Return the integral of that force over the depth, up to a constant [J]."""
        return yield_work(self.particle(), depth)

    def springs(self, largest: float) -> ParticleSprings:
        """Return the springs after the particle was once pressed to a depth."""
        return ParticleSprings(*particle_springs(self.particle(), largest))


def material_of(radius: float, solid: Elastic) -> Material:
    """Return the particle's material, with the depth at which it begins to yield."""
    modulus = solid.young / (1.0 - solid.poisson**2)
    material = Material(radius, solid, modulus, math.inf)

    def excess(depth: float) -> float:
        return 4.0 * modulus * math.sqrt(depth / radius) / (3.0 * math.pi) - material.yield_pressure(depth)

    if math.isinf(solid.strength) or excess(DEPTH_LIMIT * radius) <= 0.0:
        return material
    return material._replace(yield_depth=between(excess, 0.0, DEPTH_LIMIT * radius))
