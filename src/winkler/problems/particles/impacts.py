r"""Many balls that strike at once, straight or obliquely, each with its own velocities.

The equations are those of one `Impact`, integrated by Verlet's steps; the springs of every contact follow each step
exactly along its straight line.  Energy is conserved to second order in the steps.
"""

from __future__ import annotations

from typing import Annotated, ClassVar

import numpy as np

from winkler.media.halfspace import HalfSpace
from winkler.numerics.springs.contact_kernels import impact_balls
from winkler.numerics.threads import run_in_threads
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.declared import BALANCED, SHEARED
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.assumptions.inertia import wave_loss, wave_note
from winkler.problems.normal.validity import steepness_note
from winkler.problems.particles.trace import PLANE, SPRINGS
from winkler.values.checks.number_checks import NOT_TINY, Count, NonNegativeQuantity, Numbers, PositiveQuantity, Whole
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

HERTZ_DEPTH = (15.0 / 16.0) ** 0.4
HERTZ_DURATION = 2.868265699
"""Of Hertz' impact: d_max and the duration in terms of m, v, E* and R."""
REACH_MARGIN = 1e-3
"""By which the springs reach further than Hertz' greatest depth."""
EXTRA_STEPS = 5
"""Steps beyond Hertz' duration."""


@value
class BallImpacts:
    """Impacts of balls on surfaces or on each other; arrays are ``(contacts,)``, or one number for all.

    Parameters
    ----------
    medium : HalfSpace
        The pair of solids.
    curvature_radius : float or ndarray
        R [m].
    coefficient : float or ndarray
        Friction coefficient mu [-], zero or positive.
    mass : float or ndarray
        m [kg] of the ball; of two free ones m1 m2 / (m1 + m2).
    mobility : float or ndarray
        kappa [1/kg]: change of the tangential velocity of the touching points per tangential impulse, 1/m + R^2/I; for
        a solid ball 3.5/m.
    velocity : float or ndarray
        Velocity of approach [m/s], positive.
    sliding_velocity : ndarray, (contacts, 2)
        Relative tangential velocity of the contact points [m/s].
    steps : int, optional
        Number of steps of an impact.
    count : int, optional
        Number of springs of each contact.

    Raises
    ------
    InvalidInput
        If the shapes do not agree, or a number has the wrong sign.

    References
    ----------
    N. Maw, J. R. Barber, J. N. Fawcett, Wear 38 (1976) 101-114, doi:10.1016/0043-1648(76)90201-5

    Examples
    --------
    >>> from winkler.materials.elastic import Elastic
    >>> glass = HalfSpace.between(Elastic(70e9, 0.22), Elastic(70e9, 0.22))
    >>> mass = 2500.0 * 4.0 / 3.0 * np.pi * 1e-9
    >>> thrown = BallImpacts(glass, curvature_radius=1e-3, coefficient=0.3, mass=mass, mobility=3.5 / mass,
    ...                      velocity=1.0, sliding_velocity=[[0.2, 0.0], [1.0, 1.0]]).solve()
    >>> thrown.sliding_velocity.round(3)
    array([[ 0.035,  0.   ],
           [-0.361, -0.361]])
    """

    __words__ = words(coefficient=(r"\mu", "", "friction coefficient"))

    medium: HalfSpace
    curvature_radius: Annotated[Array | float, Numbers(NOT_TINY, any_shape=True)]
    coefficient: NonNegativeQuantity
    mass: Annotated[Array | float, Numbers(NOT_TINY, any_shape=True)]
    mobility: PositiveQuantity
    velocity: PositiveQuantity
    sliding_velocity: Annotated[Array, Numbers(fewest=0, any_shape=True)]
    steps: Annotated[int, Whole(10)] = 200
    count: Count = 32

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "hertz_1882", "maw_barber_fawcett_1976")
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED | BALANCED | {Assumption.INERTIA}

    def __post_init__(self) -> None:
        shape = np.shape(self.sliding_velocity)
        if len(shape) != 2 or shape[1] != 2:
            raise InvalidInput(
                f"BallImpacts: sliding_velocity has the shape {shape}; give finite numbers, (contacts, 2)."
            )
        for name in ("curvature_radius", "coefficient", "mass", "mobility", "velocity"):
            shape_ = np.shape(getattr(self, name))
            if shape_ not in ((), shape[:1]):
                raise InvalidInput(
                    f"BallImpacts: {name} has the shape {shape_} for {shape[0]} contacts; give one number for each, "
                    "or one for all."
                )

    def solve(self) -> BallImpactsSolution:
        """Return the velocities of all balls after the impact.

        Returns
        -------
        BallImpactsSolution
        """
        sliding = np.array(self.sliding_velocity)
        many = sliding.shape[0]
        radius, coefficient, mass, mobility, velocity = (
            np.array(np.broadcast_to(np.asarray(numbers, dtype=float), many))
            for numbers in (self.curvature_radius, self.coefficient, self.mass, self.mobility, self.velocity)
        )
        normal, shear = np.full(many, self.medium.modulus), np.full(many, self.medium.shear_modulus)
        scale = (mass / normal) ** 0.4 / radius**0.2
        deepest = HERTZ_DEPTH * scale * velocity**0.8
        interval = HERTZ_DURATION * scale / velocity**0.2 / self.steps
        slope = coefficient * normal / shear
        loss, peak, time = np.zeros((3, many))
        after = velocity.copy()

        def work(part: slice) -> None:
            impact_balls(
                np.zeros((self.count, 2)),
                radius[part],
                normal[part],
                shear[part],
                slope[part],
                mass[part],
                mobility[part],
                interval[part],
                (1.0 + REACH_MARGIN) * deepest[part],
                self.steps + EXTRA_STEPS,
                after[part],
                sliding[part],
                loss[part],
                peak[part],
                time[part],
            )

        run_in_threads(work, many)
        return BallImpactsSolution(self, after, sliding, loss, deepest, peak, time)


@value
class BallImpactsSolution:
    """The solution of `BallImpacts`, after the separation of the last ball.

    Parameters
    ----------
    problem : BallImpacts
        The problem that was solved.
    velocity : ndarray, (contacts,)
        Velocity after the impact [m/s], approach positive: negative, because the balls separate.
    sliding_velocity : ndarray, (contacts, 2)
        Relative tangential velocity of the contact points [m/s].
    dissipation : ndarray, (contacts,)
        Dissipated energy of each impact [J].
    greatest_depth : ndarray, (contacts,)
        Hertz' maximum depth [m].
    greatest_shear_force : ndarray, (contacts,)
        Maximum shear force during the impact [N].
    duration : ndarray, (contacts,)
        Contact time [s], a whole number of steps.
    """

    problem: BallImpacts
    velocity: Array
    sliding_velocity: Array
    dissipation: Array
    greatest_depth: Array
    greatest_shear_force: Array
    duration: Array

    @property
    def balance(self) -> Array:
        """Kinetic, elastic and dissipated energy over the energy at first touch, ``(contacts,)``; should be one."""
        problem = self.problem

        def kinetic(velocity: Array, sliding: Array) -> Array:
            along = np.sum(np.asarray(sliding) ** 2, axis=1) / np.asarray(problem.mobility)
            return np.asarray(0.5 * (np.asarray(problem.mass) * np.asarray(velocity) ** 2 + along))

        before = kinetic(np.asarray(problem.velocity), problem.sliding_velocity)
        return np.asarray((kinetic(self.velocity, self.sliding_velocity) + self.dissipation) / before)

    @property
    def restitution(self) -> Array:
        """Rebound velocity over approach velocity [-], ``(contacts,)``."""
        return np.asarray(-self.velocity / np.asarray(self.problem.velocity))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        size, medium = np.asarray(problem.curvature_radius), problem.medium
        share = wave_loss(modulus=medium.modulus, mass=problem.mass, size=size, velocity=problem.velocity)
        slope = float(np.max(np.sqrt(self.greatest_depth / size)))
        coupled = sticking_note(medium, float(np.min(problem.coefficient)))
        balance = energy_note(np.ones(self.velocity.size), self.balance, 0.0)
        return (*medium.notes, steepness_note(slope), balance, wave_note(share), coupled, SPRINGS, PLANE)
