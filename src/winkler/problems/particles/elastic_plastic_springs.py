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

import numpy as np

from winkler.materials.elastic import Elastic
from winkler.numerics.equations.roots import between

__all__ = ["DEPTH_LIMIT", "FULL_CONTACT_ANGLE", "Material", "ParticleSprings", "material_of"]

NODES, WEIGHTS = np.polynomial.legendre.leggauss(16)
FULL_CONTACT_ANGLE = 0.5 * math.pi
"""The angle at which all springs are in contact."""
DEPTH_LIMIT = 0.5
"""Depth over radius up to which the law is followed."""
YIELD_PRESSURE_RISE, YIELD_PRESSURE_FALL = 1.75, 4.4
"""Of the yield pressure, fitted by Zunker and Kamrin to finite elements."""


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

    def gap(self, angle: float) -> float:
        """Return g at the edge of the contact [m]."""
        return self.height * math.sin(0.5 * angle) ** 2

    def sums(self, angle: float, compression: float) -> tuple[float, float]:
        """Return force [N] and elastic energy of the springs [J], from quadrature that is exact to rounding."""
        theta = 0.5 * angle * (NODES + 1.0)
        pressed = compression - self.height * np.sin(0.5 * theta) ** 2
        weight = self.modulus * self.half_width * angle * WEIGHTS * np.cos(theta)
        return float(weight @ pressed), 0.5 * float(weight @ pressed**2)

    def force(self, angle: float, compression: float) -> float:
        """Return the force [N]."""
        return self.sums(angle, compression)[0]

    def balanced(self, angle: float, work: float) -> float:
        """Return the compression of the springs when an edge at the angle is just held by a work of adhesion [m]."""
        return self.gap(angle) - math.sqrt(2.0 * math.pi * self.radius(angle) * work / self.modulus)

    def critical(self, work: float, factor: float) -> float:
        """Return the angle where a g' is `factor` times the stretch of the last spring: the end of stability.

        1/2 under a prescribed depth, 3/2 under a dead load.
        """
        if work == 0.0:
            return 0.0
        number = 2.0 * factor * math.sqrt(2.0 * math.pi * self.half_width * work / self.modulus) / self.height
        return between(lambda angle: math.sin(angle) ** 1.5 - number * math.cos(angle), 0.0, FULL_CONTACT_ANGLE)

    def edge(self, compression: float, work: float) -> float:
        """Return the angle of the stable edge; zero if there is none."""
        if work == 0.0:
            return 2.0 * math.asin(math.sqrt(min(max(compression, 0.0) / self.height, 0.5)))
        least = self.critical(work, 0.5)
        if compression < self.balanced(least, work):
            return 0.0
        if compression >= self.balanced(FULL_CONTACT_ANGLE, work):
            return FULL_CONTACT_ANGLE
        return between(lambda angle: self.balanced(angle, work) - compression, least, FULL_CONTACT_ANGLE)

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
        return self.solid.strength * (YIELD_PRESSURE_RISE * math.exp(-YIELD_PRESSURE_FALL * depth / self.radius) + 1.0)

    def _square(self, depth: float) -> float:
        """Return b^2 [m^2]: that of Hertz where yield begins, then that of a ball cut off at the depth."""
        onset = self.yield_depth
        return depth * (2.0 * self.radius - depth) - onset * (self.radius - onset)

    def force(self, depth: float) -> float:
        """Return the force that presses the particle deeper than ever before, beyond yield [N]."""
        return math.pi * self._square(depth) * self.yield_pressure(depth)

    def work(self, depth: float) -> float:
        """Return the integral of that force over the depth, up to a constant [J]."""
        radius, onset = self.radius, self.yield_depth
        offset = onset * (onset - radius)
        rate = YIELD_PRESSURE_FALL / radius
        plain = depth * (offset + depth * (radius - depth / 3.0))
        falling = self._square(depth) / rate + 2.0 * (radius - depth) / rate**2 - 2.0 / rate**3
        return math.pi * self.solid.strength * (plain - YIELD_PRESSURE_RISE * math.exp(-rate * depth) * falling)

    def springs(self, largest: float) -> ParticleSprings:
        """Return the springs after the particle was once pressed to a depth."""
        if largest <= self.yield_depth:
            return ParticleSprings(self.modulus, 4.0 * self.radius, self.radius, 0.0, 1.0)
        square = self._square(largest)
        b = math.sqrt(square)
        height = 4.0 * self.yield_pressure(largest) * b / self.modulus
        compression = 0.5 * height
        centre = self.radius - (largest - compression)
        far = math.hypot(b, centre)
        nu = self.solid.poisson
        # how far the centre of the particle moves under the uniform pressure, against its surface far away
        bent = 2.0 * square * (nu - 1.0) - (2.0 * nu - 1.0) * centre * (far - centre)
        bulk = self.force(largest) * bent / (2.0 * math.pi * self.solid.shear * square * far)
        return ParticleSprings(self.modulus, height, b, largest - compression - bulk, 1.0 + bulk / compression)


def material_of(radius: float, solid: Elastic) -> Material:
    """Return the particle's material, with the depth at which it begins to yield."""
    modulus = solid.young / (1.0 - solid.poisson**2)
    material = Material(radius, solid, modulus, math.inf)

    def excess(depth: float) -> float:
        return 4.0 * modulus * math.sqrt(depth / radius) / (3.0 * math.pi) - material.yield_pressure(depth)

    if math.isinf(solid.strength) or excess(DEPTH_LIMIT * radius) <= 0.0:
        return material
    return material._replace(yield_depth=between(excess, 0.0, DEPTH_LIMIT * radius))
