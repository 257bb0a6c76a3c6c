"""One step of an elastic-plastic, adhesive particle, or of any ball that attracts: the function for other programs."""

from __future__ import annotations

import math

from winkler.numerics.types import Array
from winkler.problems.particles.particle_edge import spring_sums, with_surface
from winkler.problems.particles.particle_rules import particle_depth, particle_springs


def step_particle(law: Array, memory: Array, motion: Array, answer: Array) -> None:
    """Move one particle by one step of its depth.

    Parameters
    ----------
    law : ndarray, (11,)
        The numbers of `Particle`, and the greatest depth [m].
    memory : ndarray, (5,)
        `ParticleMemory`; whether it touches as 0 or 1.
    motion : ndarray, (1,)
        Depth at the end of the step [m].
    answer : ndarray, (5,)
        Force [N], contact radius [m], residual depth [m], energy [J], what has been lost so far [J].
    """
    depth = motion[0]
    if not depth <= law[10]:  # nor not-a-number
        for k in range(answer.size):
            answer[k] = math.nan
        return
    particle = (law[0], law[1], law[2], law[3], law[4], law[5], law[6], law[7], law[8], law[9])
    before = (memory[0], memory[1], memory[2], memory[3] > 0.5, memory[4])
    largest, compression, angle, touching, work = particle_depth(particle, before, depth)
    memory[0] = largest
    memory[1] = compression
    memory[2] = angle
    memory[3] = 1.0 if touching else 0.0
    memory[4] = work
    springs = particle_springs(particle, largest)
    force = 0.0
    energy = 0.0
    if touching:
        force, energy = spring_sums(springs, angle, compression)
        energy = with_surface(springs, angle, energy, law[8])
    answer[0] = force
    answer[1] = springs[2] * math.sin(angle)
    answer[2] = springs[3]
    answer[3] = energy
    answer[4] = work - energy
