r"""An elastic-plastic, adhesive particle against a rigid plane, as discrete element codes press their powders.

The springs are those of half an ellipse: a ball's while the particle is elastic; once it has yielded, the ones that the
greatest depth so far has left (`winkler.problems.particles.elastic_plastic_springs`).  Attraction holds the edge of
the contact as in Johnson, Kendall and Roberts, with different works for closing and opening:

.. math:: F = E_c\int_{-a}^{a}(d_e-g(x))\,\mathrm dx, \qquad g(a)-d_e = \sqrt{2\pi a w/E_c}
          \ \text{ while the edge moves.}

Two equal spheres meet in their plane of symmetry: each is such a particle, with half of the approach and half of the
work of adhesion.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import ClassVar

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.loading.path import numbers_of
from winkler.materials.elastic import Elastic
from winkler.materials.hardening import Hardening
from winkler.numerics.types import Array, PerLoad, Q
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import BALANCED
from winkler.problems.last_cycle import Looped, PathLoop
from winkler.problems.particles.elastic_plastic_march import ParticleHistory, ParticleMarch
from winkler.problems.particles.elastic_plastic_springs import material_of
from winkler.values.checks.number_checks import NonNegative, PositiveNotTiny
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

ZUNKER = "W. Zunker, K. Kamrin, J. Mech. Phys. Solids 183 (2024) 105492, doi:10.1016/j.jmps.2023.105492"
ENGINEERING = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "An engineering law with a yield pressure fitted to finite elements. At the onset of yield the force jumps "
    "by d/13R, and the elastic part of the depth by 15 %. Lateral growth of the particle is neglected (1.7 % of "
    "the force at d = R/10), and so is the interaction of several contacts.",
    ZUNKER,
)
ELASTIC = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "The springs under half an ellipse yield Hertz's force less the fraction 3d/40R: neither the paraboloid nor "
    "the exact sphere.",
    ZUNKER,
)


@value
class ElasticPlasticParticle:
    """An adhesive, elastic-plastic ball pressed against a rigid plane.

    Parameters
    ----------
    curvature_radius : float
        R [m], positive.
    solid : Elastic
        Modulus, Poisson's ratio and yield strength of a solid without hardening. An infinite strength means no yield.
    path : Depth or Force
        Depths [m] relative to the plane (at most R/2), or dead loads [N], in sequence, ``(steps,)``.
    work_opening : float, optional
        Work of separation [J/m^2]; zero (default) without adhesion.
    work_closing : float, optional
        Work gained on closing [J/m^2], at most `work_opening`. Zero (default) is the model of Zunker and Kamrin; the
        value of `work_opening` is that of Johnson, Kendall and Roberts.

    Raises
    ------
    InvalidInput
        If a number is out of range, or the path is not a one-dimensional array.

    References
    ----------
    W. Zunker, K. Kamrin, J. Mech. Phys. Solids 183 (2024) 105492, doi:10.1016/j.jmps.2023.105492, and 105493,
    doi:10.1016/j.jmps.2023.105493

    Examples
    --------
    >>> powder = Elastic(young=1e9, poisson=0.3, strength=20e6)
    >>> pressed = ElasticPlasticParticle(1e-3, powder, Depth([50e-6, 40e-6, 0.0])).solve()
    >>> pressed.force.round(4)
    array([12.7994,  4.7161,  0.    ])
    >>> round(pressed.yield_depth * 1e6, 3)
    12.944
    """

    __words__ = words(
        solid=("", None, "what the particle is made of"), curvature_radius=("R", "m", "radius of the particle")
    )

    curvature_radius: PositiveNotTiny
    solid: Elastic
    path: Depth | Force
    work_opening: NonNegative = 0.0
    work_closing: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = (
        "zunker_kamrin_2024",
        "zunker_kamrin_bulk_2024",
        "johnson_kendall_roberts_1971",
        "popov_hess_2015",
    )
    assumptions: ClassVar[frozenset[Assumption]] = BALANCED | {Assumption.RESPONSE}

    def __post_init__(self) -> None:
        owner = "ElasticPlasticParticle"
        if self.work_closing > self.work_opening:
            raise InvalidInput(
                f"{owner}: work_closing ({self.work_closing:g} J/m^2) exceeds work_opening ({self.work_opening:g}), so "
                "that every cycle would give energy away; closing gains at most what opening costs."
            )
        if isinstance(self.solid, Hardening):
            raise InvalidInput(
                f"{owner}: the solid is a {type(self.solid).__name__}; the law of particles is that of a metal which "
                "does not harden: give Elastic(young, poisson, strength), or use PlasticIndentation."
            )
        if self._levels.ndim != 1:
            raise InvalidInput(
                f"{owner}: the path has the shape {self._levels.shape}; give its points one after the other in one row."
            )

    @property
    def _levels(self) -> Array:
        return numbers_of(self.path)

    @property
    def yield_depth(self) -> float:
        """Depth at the onset of yield [m]; infinite if the particle does not yield up to R/2."""
        return material_of(self.curvature_radius, self.solid).yield_depth

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every point of the path."""
        return int(self._levels.size)

    def steps(self) -> Iterator[ParticleState]:
        """Yield the state at every point of the path.

        Raises
        ------
        OutsideValidity
            If the particle is pressed in by more than R/2, or a dead load pulls it off. The error is raised at that
            step, after all earlier states.
        """
        march = ParticleMarch(
            material_of(self.curvature_radius, self.solid), float(self.work_closing), float(self.work_opening)
        )
        state = march.fresh()
        for level in self._levels.tolist():
            state = march.to_depth(state, level) if isinstance(self.path, Depth) else march.to_force(state, level)
            yield _state_of(march, state, self.path, level)

    def gathered(self, states: Iterable[ParticleState]) -> ParticleSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        return gather(ParticleSolution, self, states)

    def solve(self) -> ParticleSolution:
        """Return the whole path.

        Returns
        -------
        ParticleSolution

        Raises
        ------
        OutsideValidity
            As `steps`.
        """
        return self.gathered(self.steps())


def _state_of(march: ParticleMarch, state: ParticleHistory, path: Depth | Force, level: float) -> ParticleState:
    springs = march.material.springs(state.largest)
    force = springs.force(state.angle, state.compression) if state.touching else 0.0
    energy = march.energy(state)
    held = isinstance(path, Force)
    return ParticleState(
        depth=springs.depth(state.compression) if held else level,
        force=level if held else force,
        radius=springs.radius(state.angle),
        residual_depth=springs.origin,
        energy=energy,
        dissipation=state.work - energy,
    )


@value
class ParticlePress(PerLoad[Q]):
    """A particle at a moment, or at the points of its path.

    Parameters
    ----------
    depth : float or ndarray, (steps,)
        d [m].
    force : float or ndarray, (steps,)
        F_N [N], compression positive; a prescribed one that falls into the jump where yield begins is held at that
        depth.
    radius : float or ndarray, (steps,)
        a [m], zero without contact.
    residual_depth : float or ndarray, (steps,)
        d0 [m], the depth at which the unloaded particle would just touch the plane.
    energy : float or ndarray, (steps,)
        Stored in the particle, less what closing its surfaces has gained [J].
    dissipation : float or ndarray, (steps,)
        Energy lost since the beginning [J], in yielding and in jumps of the edge.
    """

    __words__ = words(energy=("U", "J", "stored in the particle, less what closing its surfaces has gained"))

    depth: Q
    force: Q
    radius: Q
    residual_depth: Q
    energy: Q
    dissipation: Q


@value
class ParticleState(ParticlePress[float]):
    """A particle at one point of its path; its numbers are those of `ParticlePress`."""


@value
class ParticleSolution(ParticlePress[Array], Looped):
    """The solution of an `ElasticPlasticParticle`, point by point; its numbers are those of `ParticlePress`.

    Parameters
    ----------
    problem : ElasticPlasticParticle
        The problem that was solved.
    """

    __words__ = words(work=("W", "J", "what was spent since the beginning"))

    problem: ElasticPlasticParticle

    @property
    def _loop(self) -> PathLoop:
        return PathLoop((self.problem._levels,), self.depth, self.force, self.dissipation)

    @property
    def work(self) -> Array:
        """Work since the beginning: the integral of the force over the depth [J], ``(steps,)``."""
        return np.asarray(self.energy + self.dissipation)

    @property
    def yield_depth(self) -> float:
        """Depth at the onset of yield [m]; infinite if the particle does not yield up to R/2."""
        return self.problem.yield_depth

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        notes = [ELASTIC]
        if float(np.max(self.depth)) > self.problem.yield_depth:
            notes.append(ENGINEERING)
        return (*notes, *self._cycle_notes)
