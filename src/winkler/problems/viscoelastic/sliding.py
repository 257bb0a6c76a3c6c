r"""The resistance of a viscoelastic body to a rigid one that slides or rolls over it at a steady speed.

In the frame of the rigid body every spring is pressed in from the leading edge on, relaxes meanwhile, and lets go
behind the middle where it would pull,

.. math:: q(x) = \int_x^a E^*\!\left(\frac{x'-x}{v}\right) g'(x')\,\mathrm dx', \qquad
          F = \int q\,\mathrm dx, \qquad F_x = \int q\,g'\,\mathrm dx ,

so that the front bears more than the back.  Sliding breaks the symmetry of revolution, and the line of springs is an
approximation: for any body of revolution it gives twice the true resistance at low speed and the true one at high
speed.

A spring of a viscoelastic line under a body that passes over it at a steady speed.

In the frame of the body the spring is pressed in from the leading edge on, relaxes meanwhile, and lets go where it
would pull.

How much of the sliding resistance of a line of relaxing springs a body in three dimensions has.

A pressure that moves along a surface at the speed v is a sum of waves in all directions; one with the wave number k
in the direction :math:`\varphi` shakes the body with the frequency :math:`v k\cos\varphi`.  For a pressure of
revolution, whose transform is that of its line load,

.. math:: F_x = \frac1\pi\int_0^\infty k\,|\hat q(k)|^2\,\bar J''(vk)\,\mathrm dk , \qquad
          \bar J''(\omega) = \frac2\pi\int_0^{\pi/2}\cos\varphi\;J''(\omega\cos\varphi)\,\mathrm d\varphi .

On the line all waves go straight ahead and :math:`J''` itself stands there.  For a retardation time :math:`\lambda`
and :math:`w=\omega\lambda` that is :math:`(1-1/\sqrt{1+w^2})/w` against :math:`w/(1+w^2)`: half of it when slow, all of
it when fast.
"""

from __future__ import annotations

import functools
import math
from typing import Annotated, ClassVar, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import Depth, Force
from winkler.loading.path import OnePositiveNormal
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.equations.roots import between
from winkler.numerics.integrals.quadrature import gauss_legendre, panel_nodes
from winkler.numerics.springs.exponential_sums import CreepSeries
from winkler.numerics.springs.free_relaxation import Recovery
from winkler.numerics.springs.spring_pass import pass_over
from winkler.numerics.types import Array, PerLoad, Q, like, shaped
from winkler.problems.assumptions.declared import RELAXING
from winkler.problems.assumptions.times import times_notes
from winkler.problems.normal.solve_contact import at_depth, at_end, at_force
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.problems.normal.validity import contact_notes
from winkler.problems.viscoelastic.march import elastic_like, relaxation_of
from winkler.values.checks.number_checks import POSITIVE_QUANTITY, Whole
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.limits import RELAXING_SPRINGS
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words


@value
class SlidingResistance(PerLoad[Q]):
    """A rigid body that slides without friction, or rolls, over a viscoelastic body at a steady speed.

    A freely rolling ball leaves the same trace as a sliding one, and has the same resistance at its axle. Other
    contributions to rolling resistance (slip, adhesion) are not included.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, ViscoelasticHalfSpace(solid)), for profiles whose contact does not reach a rim.
    normal : Depth or Force
        The steady load, one positive number.
    speed : float or ndarray
        v [m/s], positive; the results have its shape.
    count : int, optional
        Number of elements across the widest contact. The error is of second order; for a paraboloid and a cone it is
        zero.

    Raises
    ------
    InvalidInput
        If the medium is not viscoelastic or a number is out of range.

    References
    ----------
    V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6;
    N. V. Brilliantov, T. Poeschel, Europhys. Lett. 42 (1998) 511-516, doi:10.1209/epl/i1998-00281-7

    Examples
    --------
    Slowly, a ball meets the resistance tau v F / R (E* = 1 Pa, tau = 1 s), half of that of the line.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.loading.loads import Depth
    >>> from winkler.materials.spring_and_dashpot import KelvinVoigt
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), ViscoelasticHalfSpace(KelvinVoigt(shear=0.25, viscosity=0.25)))
    >>> rolling = SlidingResistance(bed, Depth(0.01), [1e-6, 1e-3, 1e-2]).solve()
    >>> (rolling.coefficient / rolling.speed).round(3)
    array([1.   , 0.995, 0.965])
    """

    __words__ = words(count=("n", "", "into how many parts the contact is cut"))

    bed: Bed
    normal: OnePositiveNormal
    speed: Annotated[Q, POSITIVE_QUANTITY]
    count: Annotated[int, Whole(10, RELAXING_SPRINGS)] = 1000

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "brilliantov_poschel_1998")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING
    needs_round: ClassVar[str] = "sliding over a solid that relaxes behind the contact"

    def __post_init__(self) -> None:
        if not isinstance(self.bed.medium, ViscoelasticHalfSpace):
            raise InvalidInput(
                f"SlidingResistance: the bed stands on a {type(self.bed.medium).__name__}; the error of the "
                "springs for sliding contacts is known for half-spaces only. Give Foundation(profile, "
                "ViscoelasticHalfSpace(solid))."
            )
        relaxation_of("SlidingResistance", self.bed)

    def solve(self) -> SlidingResistanceSolution[Q]:
        """Return the resistance at every speed.

        Returns
        -------
        SlidingResistanceSolution

        Raises
        ------
        OutsideValidity
            If the load exceeds the known range of the profile, the contact reaches a rim or is not a disc, or the body
            touches again behind the contact.
        NotConverged
            If the depth under a force is not found.
        """
        medium = self.bed.medium
        assert isinstance(medium, ViscoelasticHalfSpace)
        rows = []
        for speed in np.ravel(np.asarray(self.speed, dtype=float)).tolist():
            done = pass_under_load(self.bed, self.normal, self.count, speed)
            share = share_of_line(medium.creep, speed, *done.touching)
            sums = done.depth, done.force, done.radius, done.trailing_edge, done.shear_force
            rows.append((*sums, share * done.shear_force))
        columns: list[Q] = [like(np.array(column), self.speed) for column in zip(*rows, strict=True)]
        return SlidingResistanceSolution(self, self.speed, *columns)


@value
class SlidingLine:
    """The springs under a body that slides towards +x, in its frame.

    Parameters
    ----------
    position : ndarray, (n,)
        x [m], from the leading edge to where the body is as far above the surface again.
    line_load : ndarray, (n,)
        q(x) [N/m], zero behind the trailing edge.
    """

    position: Array
    line_load: Array


@value
class SlidingResistanceSolution(PerLoad[Q]):
    """The solution of a `SlidingResistance`; every quantity has the shape of the speed.

    Parameters
    ----------
    problem : SlidingResistance
        The problem that was solved.
    speed : float or ndarray
        v [m/s].
    depth, force : float or ndarray
        d [m], F_N [N].
    radius : float or ndarray
        a [m], from the middle to the leading edge.
    trailing_edge : float or ndarray
        Position x [m] at which the springs separate, negative behind the middle.
    line_shear_force : float or ndarray
        F_x [N] of the one-dimensional foundation, positive against the motion.
    shear_force : float or ndarray
        F_x [N] of the body: the force of the foundation, corrected for the three-dimensional deformation.
    """

    __words__ = words(coefficient=(r"\mu", "", "resistance over normal force"))

    problem: SlidingResistance[Q]
    speed: Q
    depth: Q
    force: Q
    radius: Q
    trailing_edge: Q
    line_shear_force: Q
    shear_force: Q

    @property
    def coefficient(self) -> Q:
        """F_x / F_N [-] of the body, its coefficient of friction."""
        return shaped(np.asarray(self.shear_force) / self.force)

    def line(self, index: int | tuple[int, ...] = ()) -> SlidingLine:
        """Return the springs at one speed.

        Parameters
        ----------
        index : int or tuple of int, optional
            Index of the load; not needed if there is only one.

        Raises
        ------
        InvalidInput
            If there is no such speed.
        """
        try:
            speed, depth = (float(np.asarray(each)[index]) for each in (self.speed, self.depth))
        except (IndexError, TypeError):
            raise InvalidInput(
                f"solution.line: there is no speed {index!r} in a solution of shape {np.shape(self.speed)}."
            ) from None
        done = pass_at_depth(self.problem.bed, self.problem.count, depth, speed)
        return SlidingLine(done.place, done.loads)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bed = self.problem.bed
        depth, radius = (np.ravel(np.asarray(column)) for column in (self.depth, self.radius))
        passing = (2.0 * radius / np.ravel(np.asarray(self.speed)))[radius > 0.0]
        times = times_notes(bed.medium, float(np.min(passing)), float(np.max(passing))) if passing.size else ()
        return (
            *bed.notes,
            APPROXIMATE,
            *times,
            *contact_notes(elastic_like(bed), depth, radius),
            *relaxing_yield(bed.medium),
        )


APPROXIMATE = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "The pressure of a sliding contact is not axisymmetric. For every body of revolution the resistance computed with "
    "springs is twice the true one at low speed, and correct at high speed. In `shear_force` the resistance of the "
    "springs is corrected under the assumption of an axisymmetric pressure. Compared with pressures computed in "
    "three dimensions, the corrected force is too high by 7, 23 and 38 % near its maximum over speed. These values "
    "apply to glassy moduli of 2, 10 and 100 times the relaxed modulus. Away from this maximum the error is smaller.",
    "energy of the moving pressure, compared with the half-space's hereditary integral on a grid",
)


DOUBLINGS = 200
NODES = 8
"""For what fades within an interval by no more than e: exact to rounding."""
RECONTACT_MARGIN = 1e-6
"""A spring behind the contact is touched again when the body is this part of the depth below it."""


class SlidPast(NamedTuple):
    """What a spring has met under a body at one depth, place by place, with force, resistance and trailing edge."""

    depth: float
    radius: float
    place: Array
    loads: Array
    force: float
    shear_force: float
    trailing_edge: float

    @property
    def touching(self) -> tuple[Array, Array]:
        """Places and loads from the trailing to the leading edge."""
        inside = self.place > self.trailing_edge
        place = np.append(self.place[inside], self.trailing_edge)
        return place[::-1], np.append(self.loads[inside], 0.0)[::-1]


def pass_under_load(bed: Bed, normal: Depth | Force, count: int, speed: float) -> SlidPast:
    """Return what the springs have met at the depth that is prescribed, or that gives the force."""
    if isinstance(normal, Depth):
        return pass_at_depth(bed, count, float(normal.depth), speed)
    wanted = float(normal.force)
    elastic = elastic_like(bed)
    series = relaxation_of("", bed)
    finite = [modulus for modulus in (series.relaxed, series.glassy) if 0.0 < modulus < math.inf]
    modulus = finite[0] if finite else float(series.viscosity / np.max(series.times, initial=1.0))
    end, most = at_end(elastic)
    high = low = end if wanted / modulus >= most else float(at_force(elastic, np.array([wanted / modulus]))[0][0])
    for _ in range(DOUBLINGS):
        if pass_at_depth(bed, count, low, speed).force <= wanted:
            break
        high, low = low, 0.5 * low
    for _ in range(DOUBLINGS):
        if pass_at_depth(bed, count, high, speed).force >= wanted:
            break
        if high == end:
            raise OutsideValidity(
                f"SlidingResistance: at {speed:.6g} m/s the force {wanted:.6g} N presses the body beyond what is "
                "known of its profile; give less."
            )
        low, high = high, min(2.0 * high, end)
    else:
        raise NotConverged(f"SlidingResistance: at {speed:.6g} m/s no depth carries the force {wanted:.6g} N.")
    depth = high
    if high > low:

        def missing(logarithm: float) -> float:
            return pass_at_depth(bed, count, math.exp(logarithm), speed).force / wanted - 1.0

        depth = math.exp(between(missing, math.log(low), math.log(high), absolute=1e-15))
    return pass_at_depth(bed, count, depth, speed)


def pass_at_depth(bed: Bed, count: int, depth: float, speed: float) -> SlidPast:
    """Return what a spring meets when the body passes over it at a depth [m]."""
    elastic = elastic_like(bed)
    _, radii = at_depth(elastic, np.array([depth]))
    radius = float(radii[0])
    if radius >= elastic.rim:
        raise OutsideValidity(
            f"SlidingResistance: at the depth {depth:.6g} m the contact fills the body up to its rim, whose "
            "leading corner would cut into the other one; give a rounded body, or less load."
        )
    x = np.linspace(radius, 0.0, count // 2 + 1)
    x = np.unique(np.concatenate([x, [b for b, _ in elastic.kinks if b < radius]]))
    before, after = _slopes(elastic, x)
    gaps = elastic.gap(x)
    recess = np.concatenate([depth - gaps[::-1], depth - gaps[1:]])
    recess[0] = recess[-1] = 0.0
    place = np.concatenate([radius - x[::-1], radius + x[1:]])
    series = relaxation_of("", bed)
    memory, loads, sums = np.zeros(series.moduli.size), np.empty(place.size), np.empty(3)
    pass_over(
        series.relaxed, series.viscosity * speed, series.moduli, series.times * speed, place, recess,
        np.concatenate([after[::-1], -before]), np.concatenate([before[::-1], -after]), memory, loads,
        gauss_legendre(NODES), sums,
    )  # fmt: skip
    force, work, let_go = sums.tolist()
    _refuse_again(bed, place, recess, memory, let_go, depth, speed)
    return SlidPast(depth, radius, radius - place, loads, force, work, radius - let_go)


def _refuse_again(
    bed: Bed, place: Array, recess: Array, memory: Array, let_go: float, depth: float, speed: float
) -> None:
    """Refuse bodies that touch the spring again after it has let go."""
    behind = place > let_go
    recovery = Recovery.of(relaxation_of("", bed))
    left = depth - float(bed.gap(np.abs(np.array([0.5 * float(place[-1]) - let_go])))[0])
    weights = recovery.from_displacement * left + recovery.from_memory @ memory
    free = np.exp(-(place[behind, None] - let_go) / speed * recovery.rates) @ weights
    if np.any(recess[behind] - free > RECONTACT_MARGIN * depth):
        raise OutsideValidity(
            f"SlidingResistance: at {speed:.6g} m/s the body touches the surface again behind the contact, which "
            "is no disc then; give a body whose flanks grow steeper, or another speed."
        )


def _slopes(bed: Bed, x: Array) -> tuple[Array, Array]:
    """Return g' at the near and at the far end of every interval between places (n,), with their mean as it is."""
    mean = np.diff(bed.gap(x)) / np.diff(x)
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = bed.gap_slope(x)
    near = np.where(np.isfinite(slope[:-1]), slope[:-1], mean)
    far = np.where(np.isfinite(slope[1:]), slope[1:], mean)
    excess = mean - 0.5 * (near + far)
    return near + excess, far + excess


LINE_PIECES = 256
"""Straight pieces that stand for a load."""
LEAST_WAVE_NUMBER = 1e-9
"""Least wave number, times half of the width."""
GREATEST_WAVE_NUMBER = 200.0
"""Greatest one: a load that ends straight has |q^|^2 ~ k^-4."""


@functools.lru_cache(maxsize=1)
def _waves() -> tuple[Array, Array, Array]:
    """Return wave numbers, their weights, and what every corner of a load between -1 and 1 gives to them."""
    corner = np.linspace(-1.0, 1.0, LINE_PIECES + 1)
    edges = np.concatenate([np.geomspace(LEAST_WAVE_NUMBER, 1.0, 37), np.arange(3.0, GREATEST_WAVE_NUMBER + 1.0, 2.0)])
    number, weight = panel_nodes(edges, 8)
    # a load that is straight between corners is a sum of hats, all with the same transform but for their place
    step = 2.0 / LINE_PIECES
    hat = step * np.sinc(number * step / (2.0 * np.pi)) ** 2
    angle = number[:, None] * corner
    return number, weight * hat**2, np.stack([np.cos(angle), np.sin(angle)])


def share_of_line(creep: CreepSeries, speed: float, position: Array, loads: Array) -> float:
    """Return the resistance of the body over that of the line [-], between 1/2 and 1.

    Parameters
    ----------
    creep : CreepSeries
        1/E* as it grows [1/Pa].
    speed : float
        v [m/s].
    position, loads : ndarray, (n,)
        x [m], ascending from edge to edge, and q [N/m] there.
    """
    number, weight, turns = _waves()
    half = 0.5 * float(position[-1] - position[0])
    load = np.interp(np.linspace(position[0], position[-1], LINE_PIECES + 1), position, loads)
    energy = np.sum((turns @ load) ** 2, axis=0) * weight
    turn = number[:, None] * (speed / half) * creep.times
    root = np.sqrt(1.0 + turn * turn)
    # k J'' of both, but for v; 1 - 1/root without cancelling
    ahead = (turn * turn / (1.0 + turn * turn)) @ (creep.compliances / creep.times)
    around = (turn * turn / (root * (1.0 + root))) @ (creep.compliances / creep.times)
    return float(energy @ (around + creep.fluidity) / (energy @ (ahead + creep.fluidity)))
