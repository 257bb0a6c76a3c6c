r"""A body that strikes metal: how it bounces, and which dent it leaves.

The contact force is that of slow motion, so that energy decides: the body is stopped at the depth at which the curve
of first loading has taken its energy, and leaves with what the dent gives back,

.. math:: W(d_{max}) = \tfrac12 m v^2, \qquad e = \sqrt{U(d_{max})/W(d_{max})} .

Both are sums along known curves, and so is the time,

.. math:: T = \int_0^{d_{max}}\frac{\mathrm dd}{\sqrt{2(W(d_{max})-W(d))/m}}
              + \int_{d_0}^{d_{max}}\frac{\mathrm dd}{\sqrt{2(U(d_{max})-U(d))/m}} .

Nothing is marched: e is one up to the velocity at which a body begins to yield.  Only the motion along the surface is
(`winkler.problems.plastic.rubbed`).
"""

from __future__ import annotations

import dataclasses
import itertools
import math
from typing import Annotated, Any, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.foundation import Foundation
from winkler.foundation.on_medium import UnderProfile
from winkler.laws.friction import Coulomb
from winkler.numerics.equations.roots import invert
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array, PerLoad, Q, like, shaped
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.assumptions.inertia import wave_loss, wave_note
from winkler.problems.impact.validity import gravity_note, refuse_unlikely_spin
from winkler.problems.normal.force_curve import rough_depth
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.one_load import single
from winkler.problems.plastic.first_loading import (
    START_SHARE,
    FirstLoading,
    GreatestLoad,
    LoadingTable,
    first_loading,
    refuse_unknown,
    stored_energy,
)
from winkler.problems.plastic.indentation import law_notes, refuse_other_shapes
from winkler.problems.plastic.release import Release
from winkler.problems.plastic.rubbed import NormalMotion, Sheared, sheared
from winkler.problems.ring_slip.sliding_springs import sliding_springs
from winkler.values.checks.number_checks import (
    FINITE_QUANTITY,
    POSITIVE_QUANTITY,
    Finite,
    NonNegative,
    PositiveNotTiny,
    PositiveOrInfinite,
)
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

TIME_NODES = 24
"""Nodes of the sums over time between two places where the curve bends."""
AT_ONCE = 2000
"""Velocities that are computed together, each at the square of these nodes."""
OBLIQUE_STEPS, OBLIQUE_AT_ONCE = 300, 100
"""Steps of the approach, and as many of the rebound; blows that are marched together."""
SHEAR_LEFT_OUT = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "Tangential forces are assumed not to affect plastic deformation: the normal motion is that of a normal "
    "impact. Friction lowers the pressure at which metals yield; this is neglected. Tractions are assumed "
    "parallel to the motion, and spin about the normal is neglected.",
    "K. L. Johnson, Contact Mechanics, Cambridge 1985, section 7.1, doi:10.1017/CBO9781139171731",
)
TABOR = "D. Tabor, Proc. R. Soc. Lond. A 192 (1948) 247-274, doi:10.1098/rspa.1948.0008"


@value
class PlasticImpact(PerLoad[Q]):
    """Normal or oblique impact of bodies of revolution; at least one body yields.

    Parameters
    ----------
    bed : Foundation or EllipticFoundation
        As in `PlasticIndentation`: a profile without a flat end over a `HalfSpace`; at least one body has a strength,
        which applies at the strain rate of the impact.  On layers the restitution is one up to the velocity at which
        one of them yields; greater velocities are not supported.
    mass : float
        m [kg] of the body; for two free bodies m1 m2 / (m1 + m2).
    velocity : float or ndarray
        v [m/s] of approach at first touch, positive; the results have its shape.
    law : Coulomb, optional
        Coulomb(coefficient); without friction by default.
    lateral_velocity : float or ndarray, optional
        v_x [m/s] of the centre of mass along the surface at first touch: one number, or an array of the shape of the
        velocity.
    angular_velocity, inertia, lever : float, optional
        As in `Impact`: omega [rad/s] at first touch, I [kg m^2], and the distance from the centre of mass to the
        surface [m].

    Raises
    ------
    InvalidInput
        If a number has the wrong sign or type, as in `PlasticIndentation` for the foundation and as in `Impact` for
        friction and spin. If the number of lateral velocities is neither one nor that of the velocities.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, section 11.5, doi:10.1017/CBO9781139171731;
    N. Maw, J. R. Barber, J. N. Fawcett, Wear 38 (1976) 101-114, doi:10.1016/0043-1648(76)90201-5;
    D. Tabor, Proc. R. Soc. Lond. A 192 (1948) 247-274, doi:10.1098/rspa.1948.0008

    Examples
    --------
    A steel ball of 10 mm that drops on a plate of mild steel from a tenth of a millimetre, and from half a metre.

    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> plate = Elastic(young=210e9, poisson=0.3, strength=300e6)
    >>> bed = Foundation(Paraboloid(5e-3), HalfSpace(plate, Elastic(210e9, 0.3)))
    >>> drops = PlasticImpact(bed, mass=4.1e-3, velocity=np.sqrt(2.0 * 9.81 * np.array([1e-4, 0.5]))).solve()
    >>> drops.restitution.round(3), (drops.residual_depth * 1e6).round(2)
    (array([0.904, 0.469]), array([ 0.17, 30.37]))
    >>> round(drops.yield_velocity * 1e3, 2)
    6.82
    """

    __words__ = words(bed=("", None, "profile and bodies of the contact"))

    bed: Bed
    mass: PositiveNotTiny
    velocity: Annotated[Q, POSITIVE_QUANTITY]
    law: Coulomb = Coulomb(0.0)
    lateral_velocity: Annotated[Q, FINITE_QUANTITY] = 0.0  # type: ignore[assignment]
    angular_velocity: Finite = 0.0
    inertia: PositiveOrInfinite = math.inf
    lever: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = ("johnson_1985", "popov_hess_2015", "tabor_1948")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED | {Assumption.INERTIA}
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        owner = type(self).__name__
        refuse_unknown(owner, self.bed, layers=True)
        refuse_unlikely_spin(owner, self.law, self.mass, self.angular_velocity, self.inertia, self.lever)
        if np.shape(self.lateral_velocity) not in ((), np.shape(self.velocity)):
            raise InvalidInput(
                f"{owner}: the lateral velocities have the shape {np.shape(self.lateral_velocity)}, the velocities "
                f"{np.shape(self.velocity)}; give one for all, or one for each."
            )

    @property
    def sliding_velocity(self) -> Q:
        """Relative tangential velocity of the contact points at first touch, v_x - lever omega [m/s]."""
        sliding = np.asarray(self.lateral_velocity) - self.lever * self.angular_velocity
        return shaped(np.broadcast_to(sliding, np.shape(self.velocity)).copy())

    @property
    def mobility(self) -> float:
        """Change of the tangential velocity of the contact points per tangential impulse, 1/m + lever^2 / I [1/kg]."""
        return 1.0 / self.mass + self.lever**2 / self.inertia

    @property
    def _loading(self) -> FirstLoading:
        assert isinstance(self.bed, UnderProfile)
        return first_loading(self.bed)

    @property
    def yield_velocity(self) -> float:
        """Velocity above which one of the bodies yields [m/s]; zero for a sharp tip, infinite without yield."""
        return math.sqrt(2.0 * _onset_energy(self._loading) / self.mass)

    def solve(self) -> PlasticImpactSolution[Q]:
        """Return restitution, dent and duration at every velocity.

        Returns
        -------
        PlasticImpactSolution

        Raises
        ------
        OutsideValidity
            If the contact exceeds the known range of the profile, or reaches a part much blunter than a paraboloid or
            sharper than a cone. If a layered body yields.
        """
        given = np.ravel(np.asarray(self.velocity, dtype=float))
        velocity, place = np.unique(given, return_inverse=True)
        curve, energy = self._loading, 0.5 * self.mass * velocity**2
        parts = [_struck(curve, energy[start : start + AT_ONCE]) for start in range(0, energy.size, AT_ONCE)]
        columns = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
        columns["duration"] *= math.sqrt(0.5 * self.mass)
        sliding = np.ravel(np.asarray(self.sliding_velocity))
        every = {name: column[place] for name, column in columns.items()}
        every["sliding_velocity"] = self._after(given, sliding, every["largest_radius"])
        return PlasticImpactSolution(
            self, self.velocity, **{name: like(column, self.velocity) for name, column in every.items()}
        )

    def _after(self, velocity: Array, sliding: Array, radius: Array) -> Array:
        """Return the velocities of the touching points after the impact [m/s]."""
        if self.law.coefficient == 0.0 or not np.any(sliding):
            return sliding
        curve, widest = self._loading, float(np.max(radius))
        ratio, _ = sliding_springs(type(self).__name__, curve.bed, self.law.coefficient, widest)
        law = Sheared(ratio, self.law.coefficient, self.mobility)
        after = np.empty_like(sliding)
        order = np.argsort(velocity)
        for start in range(0, order.size, OBLIQUE_AT_ONCE):
            here = order[start : start + OBLIQUE_AT_ONCE]
            blow = _Blows(curve, 0.5 * self.mass * velocity[here] ** 2)
            after[here] = sheared(curve, blow.states, blow.motion(self.mass), law, sliding[here])
        return after


@value
class PlasticImpactSolution(PerLoad[Q]):
    """The solution of a `PlasticImpact`; every quantity has the shape of the velocity.

    Parameters
    ----------
    problem : PlasticImpact
        The problem that was solved.
    velocity : float or ndarray
        v [m/s] of approach at first touch.
    restitution : float or ndarray
        Rebound velocity over approach velocity [-].
    greatest_depth, greatest_force, largest_radius : float or ndarray
        d_max [m], F_max [N] and a [m] at the maximum depth; the last is the radius of the dent.
    residual_depth : float or ndarray
        d0 [m], the depth of the dent: the approach at which the bodies just touch after the impact.
    energy, dissipation : float or ndarray
        Recovered and dissipated energy [J]; part of the latter remains in the bodies as residual stress.
    duration : float or ndarray
        Contact time [s].
    sliding_velocity : float or ndarray
        Tangential velocity w [m/s] of the contact points after the impact.
    """

    __words__ = words(
        friction_loss=("W_f", "J", "energy dissipated by friction"),
        impulse_ratio=("f", "", "impulse along the surface over the normal one"),
        energy=("U", "J", "energy that the bodies give back"),
        largest_radius=("a_m", "m", "contact radius at the moment of rest, that of the dent"),
        dented=("", None, "bed on which the contact is elastic after the impact"),
    )

    problem: PlasticImpact[Q]
    velocity: Q
    restitution: Q
    greatest_depth: Q
    greatest_force: Q
    largest_radius: Q
    residual_depth: Q
    energy: Q
    dissipation: Q
    duration: Q
    sliding_velocity: Q

    per_load: ClassVar[str] = "restitution"

    @property
    def yield_velocity(self) -> float:
        """As in the problem [m/s]."""
        return self.problem.yield_velocity

    @property
    def _impulse(self) -> Array:
        """What the shear force has transferred [N s]."""
        change: Array = np.asarray(self.problem.sliding_velocity) - np.asarray(self.sliding_velocity)
        return change / self.problem.mobility

    @property
    def lateral_velocity(self) -> Q:
        """v_x [m/s] of the centre of mass after the impact."""
        return shaped(np.asarray(self.problem.lateral_velocity) - self._impulse / self.problem.mass)

    @property
    def angular_velocity(self) -> Q:
        """omega [rad/s] after the impact."""
        return shaped(self.problem.angular_velocity + self.problem.lever / self.problem.inertia * self._impulse)

    @property
    def impulse_ratio(self) -> Q:
        """Tangential over normal impulse [-]: the coefficient of friction for full sliding."""
        normal = self.problem.mass * np.asarray(self.velocity) * (1.0 + np.asarray(self.restitution))
        return shaped(self._impulse / normal)

    @property
    def friction_loss(self) -> Q:
        """Energy dissipated by friction, in addition to `dissipation` [J]."""
        before, after = np.asarray(self.problem.sliding_velocity), np.asarray(self.sliding_velocity)
        return shaped(0.5 * (before**2 - after**2) / self.problem.mobility)

    @property
    def mean_pressure(self) -> Q:
        """F_max over the area [Pa], at the maximum depth."""
        area = self.problem.bed.footprint.area(np.asarray(self.largest_radius))
        return shaped(np.asarray(self.greatest_force) / area)

    @property
    def dented(self) -> Foundation:
        """The elastic foundation after the impact, valid up to its maximum force; for one velocity, not for an array.
        Its depths are counted from `residual_depth`.
        """
        depth = np.array([single(self.greatest_depth, "dent")])
        curve = self.problem._loading
        return curve.springs("PlasticImpactSolution", curve.at_level(depth, by_force=False)[0], 0)

    def at(self, index: int | tuple[int, ...]) -> PlasticImpactSolution[float]:
        """Return the solution at one velocity of an array.

        Parameters
        ----------
        index : int or tuple of int
            Which one.

        Raises
        ------
        InvalidInput
            If there is no such velocity.
        """
        fields = [item.name for item in dataclasses.fields(self) if item.name != "problem"]
        try:
            numbers = {name: float(np.asarray(getattr(self, name))[index]) for name in fields}
        except (IndexError, TypeError):
            raise InvalidInput(
                f"solution.at: there is no velocity {index!r} in a solution of shape {np.shape(self.velocity)}."
            ) from None
        lateral = np.broadcast_to(np.asarray(self.problem.lateral_velocity), np.shape(self.velocity))[index]
        problem: Any = self.problem
        one = dataclasses.replace(problem, velocity=numbers["velocity"], lateral_velocity=float(lateral))
        return PlasticImpactSolution(one, **numbers)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: the law of yielding, rate, waves, gravity."""
        problem, radius = self.problem, np.ravel(self.largest_radius)
        curve, widest = problem._loading, float(np.max(radius))
        bed, fastest = curve.bed, float(np.max(self.velocity))
        modulus = float(bed.normal_stiffness(np.array([widest]))[0])
        share = wave_loss(modulus=modulus, mass=problem.mass, size=bed.size, velocity=fastest)
        notes = [*law_notes(curve, widest), wave_note(share), gravity_note(np.asarray(self.greatest_force))]
        if widest > curve.onset:
            rate = float(np.max(0.2 * bed.slope(radius) / np.ravel(self.duration)))
            notes.append(_rate_note(rate))
        if (coefficient := problem.law.coefficient) > 0.0:
            notes += [sticking_note(bed.medium, coefficient), *direction_notes(bed)]
            if np.any(np.asarray(problem.sliding_velocity)):
                notes.append(SHEAR_LEFT_OUT)
        return tuple(notes)


def _struck(curve: FirstLoading, energy: Array) -> dict[str, Array]:
    """Return the numbers of `PlasticImpactSolution` at rising energies [J]; the duration of the mass 2 kg."""
    blow = _Blows(curve, energy)
    state = blow.states
    if not curve.where:
        refuse_other_shapes("PlasticImpact", curve.bed, state.radius)
    yields = state.radius > curve.onset
    kept = np.where(yields, np.minimum(curve.stored(state), energy), energy)
    return {
        "restitution": np.where(yields, np.sqrt(kept / energy), 1.0),
        "greatest_depth": state.depth,
        "greatest_force": state.force,
        "largest_radius": state.radius,
        "residual_depth": np.where(yields, state.depth - state.recovery, 0.0),
        "energy": kept,
        "dissipation": energy - kept,
        "duration": blow.approach() + blow.rebound(kept),
    }


def _rate_note(rate: float) -> Note:
    """Return what the rate of strain [1/s] means for a strength that is one number."""
    return Note(
        Assumption.RESPONSE,
        Standing.APPROXIMATE,
        f"The metal is strained at up to {rate:.1g} 1/s (strain: 0.2 times the slope at the edge of the dent), "
        "but only one strength was given. Many metals are stronger at such rates and rebound faster. Give the "
        "strength at this rate.",
        TABOR,
    )


def _onset_energy(curve: FirstLoading) -> float:
    """Return the energy at which one of the bodies begins to yield [J]."""
    if not 0.0 < curve.onset < math.inf:
        return curve.onset
    radius = np.array([curve.onset])
    return float(stored_energy(curve.bed, curve.bed.gap(radius), radius)[0])


class _Blows:
    """Where bodies of some energies [J], rising, are stopped, and how long that takes."""

    def __init__(self, curve: FirstLoading, energy: Array) -> None:
        self.curve, self.energy = curve, energy
        self.first = curve.onset
        self.table: LoadingTable | None = None
        yielding = energy > _onset_energy(curve)
        if yielding.any():
            curve.refuse_yielded_layers("PlasticImpact")
        radius = np.zeros_like(energy)
        if not yielding.all():
            radius[~yielding] = self._elastic_radii(energy[~yielding])
        bed = curve.bed
        depth = bed.gap(radius)
        force = bed.stiffness(radius) * depth - bed.gap_load(radius)
        self.states = GreatestLoad(radius, depth, force, depth.copy(), np.ones_like(depth))
        if yielding.any():
            self.table = self._table(energy[yielding])
            self.first = float(self.table.states.radius[0])
            found = self.table.at(self._radii(self.table, energy[yielding]))
            for whole, part in zip(self.states, found, strict=True):
                whole[yielding] = part

    def _elastic_radii(self, energy: Array) -> Array:
        bed = self.curve.bed
        most = np.array([min(bed.reach, self.curve.onset)])
        if math.isfinite(most[0]) and self._elastic_work(most)[0] < energy[-1]:
            raise _beyond(bed, float(energy[-1]))
        rough = _rough_radius(bed, float(energy[-1])) * (energy / energy[-1]) ** 0.2  # as of a ball
        guess = np.minimum(rough, (1.0 - 1e-9) * most[0])

        def work(radius: Array) -> tuple[Array, Array]:
            force = bed.stiffness(radius) * bed.gap(radius) - bed.gap_load(radius)
            return self._elastic_work(radius), force * bed.gap_slope(radius)

        return invert(work, energy, lower=0.0, upper=(1.0 + 1e-9) * float(most[0]), guess=guess)

    def _elastic_work(self, radius: Array) -> Array:
        return stored_energy(self.curve.bed, self.curve.bed.gap(radius), radius)

    def _table(self, energy: Array) -> LoadingTable:
        """Return the curve of first loading up to beyond the greatest energy."""
        curve, most = self.curve, float(energy[-1])
        first = curve.onset or START_SHARE * _rough_radius(curve.bed, float(energy[0]))
        start = max(WIDER * first, min(_rough_radius(curve.bed, most), curve.bed.reach))
        for last in curve.wider(start):
            table = LoadingTable(curve, first, last)
            if table.works[-1] > most:
                return table
        raise _beyond(curve.bed, most)

    @staticmethod
    def _radii(table: LoadingTable, energy: Array) -> Array:
        first, last = math.exp(table.places[0]), math.exp(table.places[-1])

        def work(radius: Array) -> tuple[Array, Array]:
            place = np.log(radius)
            rate = np.exp(table.log_force(place) + table.log_depth(place)) * table.log_depth(place, 1)
            return table.work(radius), rate / radius

        guess = np.exp(np.interp(np.log(energy), np.log(table.works), table.places))
        guess = np.clip(guess, first * (1.0 + 1e-15), last * (1.0 - 1e-15))
        return invert(work, energy, lower=0.0, upper=last, guess=guess)

    def _work(self, radius: Array) -> tuple[Array, Array]:
        """Return what loading to radii takes [J], and the rise of the depth with them [-]."""
        elastic = radius <= self.first
        work, rise = np.zeros_like(radius), self.curve.bed.gap_slope(np.where(elastic, radius, 0.0))
        work[elastic] = self._elastic_work(radius[elastic])
        if self.table is not None and not elastic.all():
            place = np.log(radius[~elastic])
            work[~elastic] = self.table.work(radius[~elastic])
            rise[~elastic] = np.exp(self.table.log_depth(place) - place) * self.table.log_depth(place, 1)
        return work, rise

    def approach(self) -> Array:
        """Return the sums of dd / sqrt(W(d_max) - W(d)) until rest [m / J^(1/2)]."""
        greatest = self.states.radius
        begin = np.zeros_like(greatest)
        total = np.zeros_like(greatest)
        if self.table is not None and self.curve.onset == 0.0:  # nothing slows a sharp tip before the curve begins
            begin += self.first
            total += float(self.table.states.depth[0]) / np.sqrt(self.energy)
        nodes, weights = gauss_legendre(TIME_NODES)
        bends = [b for b, _ in self.curve.bed.kinks if b > 0.0] + ([self.curve.onset] if self.curve.onset > 0.0 else [])
        cuts = [np.clip(bend, begin, greatest) for bend in sorted(bends) if math.isfinite(bend)]
        for low, high in itertools.pairwise([begin, *cuts, greatest]):
            # a = a_max (1 - s^2): the root at rest is not left in s
            start, end = (np.sqrt(1.0 - place / greatest)[:, None] for place in (high, low))
            s = start + (end - start) * nodes
            radius = greatest[:, None] * (1.0 - s * s)
            work, rise = (part.reshape(s.shape) for part in self._work(radius.ravel()))
            left = np.maximum(self.energy[:, None] - work, np.finfo(float).tiny)
            total += (2.0 * greatest[:, None] * s * rise / np.sqrt(left) * (end - start)) @ weights
        return total

    def motion(self, mass: float) -> NormalMotion:
        """Return the normal motion of bodies of a mass [kg] in steps, even in the root of what is left to rest."""
        greatest, states, curve = self.states.radius, self.states, self.curve
        share = np.linspace(1.0, 0.0, OBLIQUE_STEPS + 1)
        ends = [self._at(greatest * (1.0 - s * s)) for s in share[1:]]
        s = 0.5 * (share[:-1] + share[1:])[:, None]
        work, rise = (part.reshape(s.size, -1) for part in self._work((greatest * (1.0 - s * s)).ravel()))
        left = np.maximum(self.energy - work, np.finfo(float).tiny)
        into = 2.0 * greatest * s * rise / (np.sqrt(2.0 * left / mass) * OBLIQUE_STEPS)
        if self.table is not None and curve.onset == 0.0:  # nothing slows a sharp tip before the curve begins
            into[greatest * (1.0 - s * s) < self.first] = 0.0
        kept = np.where(greatest > curve.onset, np.minimum(curve.stored(states), self.energy), self.energy)
        depth = states.recovery * (1.0 - s[::-1] ** 2)
        stored = self._stored(depth)
        out = 2.0 * states.recovery * s[::-1] / (np.sqrt(2.0 * (kept - stored) / mass) * OBLIQUE_STEPS)
        return NormalMotion(np.concatenate([into, out]), ends, states.recovery * (1.0 - share[::-1][1:, None] ** 2))

    def _at(self, radius: Array) -> GreatestLoad:
        """Return the states of first loading at a radius of each body; none before the curve of a sharp tip begins."""
        elastic, bed = radius <= self.first, self.curve.bed
        depth = np.where(elastic & (self.curve.onset > 0.0), bed.gap(radius), 0.0)
        state = GreatestLoad(radius, depth, depth, depth.copy(), np.ones_like(depth))
        if self.table is not None and not elastic.all():
            found = self.table.at(radius[~elastic])
            for whole, part in zip(state, found, strict=True):
                whole[~elastic] = part
        return state

    def rebound(self, kept: Array) -> Array:
        """Return the sums of dd / sqrt(U(d_max) - U(d)) from rest on [m / J^(1/2)], with the energies kept [J]."""
        nodes, weights = gauss_legendre(TIME_NODES)
        stored = self._stored(np.outer(1.0 - nodes * nodes, self.states.recovery)).T
        return np.asarray(2.0 * self.states.recovery * ((nodes / np.sqrt(kept[:, None] - stored)) @ weights))

    def _stored(self, depths: Array) -> Array:
        """Return the elastic energies [J] at depths from where each of n dents would just touch `(m, n)` [m]."""
        states, curve = self.states, self.curve
        index = np.broadcast_to(np.arange(depths.shape[1]), depths.shape).ravel()
        depth = depths.ravel()
        radius, stored = np.zeros_like(depth), np.zeros_like(depth)
        dented = (states.radius > curve.onset)[index]
        if dented.any():
            release = Release(curve.bed, states)
            radius[dented] = release.at(depth[dented], index[dented], by_force=False)[1]
            stored[dented] = release.energy(depth[dented], radius[dented], index[dented])
        if not dented.all():
            radius[~dented] = at_depth(curve.bed, depth[~dented])[1]
            stored[~dented] = stored_energy(curve.bed, depth[~dented], radius[~dented])
        return stored.reshape(depths.shape)


WIDER = 1.01
"""By how much a curve that is looked at is wider than where it begins, at least."""


def _rough_radius(bed: UnderProfile, energy: float) -> float:
    """Return a contact radius [m] of the order of that at which a bed has stored an energy [J]."""
    return float(at_depth(bed, np.array([rough_depth(bed, energy)]))[1][0])


def _beyond(bed: UnderProfile, energy: float) -> OutsideValidity:
    return OutsideValidity(
        f"PlasticImpact: {energy:.6g} J press the body beyond its reach ({bed.reach:.6g} m); describe more of the "
        "profile, or give a slower or lighter body."
    )
