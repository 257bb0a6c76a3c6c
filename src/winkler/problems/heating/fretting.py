r"""Fretting heat: how warm a contact gets that is pushed to and fro.

Where the surfaces slip by :math:`\mathrm d\mathbf s` under the traction :math:`\boldsymbol\tau`, each cycle turns
:math:`w(r)=\oint\boldsymbol\tau\cdot\mathrm d\mathbf s` into heat per area: in partial slip a ring.  At f cycles per
second the mean flux is f w(r).  The source stays in its place, so that both bodies are at rest, take the heat in
proportion to their conductivities, and have one temperature everywhere on the contact.

About that mean the temperature swings, twice in every cycle.  Of a flux that varies as 1 + cos the swing is less than
the mean itself; where heat reaches less far in a cycle, :math:`\sqrt{\kappa/(2\pi f)}`, than the source is wide, it is
that of a plane, :math:`fw/\bigl((e_1+e_2)\sqrt{4\pi f}\bigr)` with the effusivities :math:`e=\lambda/\sqrt\kappa`.  The
smaller of both is the estimate.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.foundation.sheared_fields import sheared_surface
from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.fields.line_source import LineSource
from winkler.numerics.fields.round_source import projected
from winkler.numerics.panels.cosine_pieces import RoundFlux, round_flux
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.assumptions.declared import BALANCED, HEATED, SHEARED
from winkler.problems.assumptions.temperature import temperature_note
from winkler.problems.friction.pushed import PushedState
from winkler.problems.friction.tangential import State, Tangential, TangentialSolution
from winkler.problems.heating.input_checks import RubbingBodies
from winkler.problems.heating.validity import oscillation_notes, swing_of
from winkler.problems.viscoelastic.tangential import DraggedState
from winkler.values.checks.number_checks import Positive
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

CLOSURE_TOLERANCE = 1e-6
"""Part of the greatest shift, or force, by which two ends of a closed cycle may differ."""
SAMPLES = 513
STEADY = 1e-12
"""Part of the depth by which it may vary and count as steady."""
NARROWEST_RING = 1e-9
"""Part of the contact radius below which a ring is none."""
NARROWEST_SLIP = 2e-6
"""Part of the contact radius below which the heat of a ring that slips is lost in rounding."""
LOSS_TOLERANCE = 0.01
"""Part of the loss by which the sum over the steps may miss it before a note gives more than the number."""
JAEGER = "J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224"


@value
class FrettingHeat(RubbingBodies):
    """Heating of a contact under oscillating tangential displacement.

    Parameters
    ----------
    contact : Tangential
        The mechanical contact. Its path must end with a closed cycle, which is then repeated without end.  Two cycles
        of an oscillation, `Path.oscillation(cycles=2, ...)`, are enough: the first one differs.
    frequency : float
        Frequency of the cycle [Hz]; the times of the path are not used.
    conductors : HeatConductors
        Thermal conductors of the bodies: two thick bodies of ThermalConductor, in perfect thermal contact.

    Raises
    ------
    InvalidInput
        If the contact is no Tangential, the frequency not positive, or a body does not conduct heat.

    References
    ----------
    J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224; R. D. Mindlin, H. Deresiewicz, J. Appl. Mech. 20
    (1953) 327-344, doi:10.1115/1.4010702

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.materials.conductor import ThermalConductor
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.loading.path import Path
    >>> from winkler.profiles.power import Paraboloid
    >>> elastic, steel = Elastic(210e9, 0.3), ThermalConductor(45.0, 12e-6)
    >>> bed = Foundation(Paraboloid(10e-3), HalfSpace.between(elastic, elastic))
    >>> pushed = Tangential(bed, Coulomb(0.5), Path.oscillation(force=100.0, amplitude=1e-6, cycles=2))
    >>> warm = FrettingHeat(pushed, 100.0, HeatConductors(steel, steel)).solve()
    >>> round(warm.heat_rate / (100.0 * warm.loss_per_cycle), 12), warm.max_temperature < 1.0
    (1.0, True)
    """

    __words__ = words(contact=("", None, "contact under oscillating tangential displacement"))

    contact: Tangential
    frequency: Positive
    conductors: HeatConductors

    references: ClassVar[tuple[str, ...]] = ("jaeger_1942", "mindlin_deresiewicz_1953", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = HEATED | SHEARED | {Assumption.STEADY} | BALANCED
    needs_round: ClassVar[str] = "the heat of friction, which follows pressure and slip from place to place,"

    def __post_init__(self) -> None:
        if self.contact.relaxes:
            raise OutsideValidity(
                "FrettingHeat: the bodies of the motion are viscoelastic and heated inside, too; only frictional "
                "heat is implemented: give elastic bodies."
            )
        super().__post_init__()

    def solve(self) -> FrettingHeatSolution:
        """Return the temperature of the contact, after many cycles.

        Returns
        -------
        FrettingHeatSolution

        Raises
        ------
        InvalidInput
            If the path does not end with a closed cycle.
        OutsideValidity
            If nothing slips, if the slip annulus is too narrow, or if the traction is not known in this medium;
            otherwise as `Tangential`.
        """
        march = self.contact.solve()
        begin = _begin(march)
        loss = float(march.dissipation[-1] - march.dissipation[begin])
        if loss <= 0.0:
            raise OutsideValidity(
                "FrettingHeat: nothing slips in the last cycle of the path, so there is no heat; increase the "
                "amplitude, or reduce the load."
            )
        end = float(np.max(march.radius[begin:]))
        narrow = float(np.min(march.radius[begin:]))
        joints = [float(np.min(march.stick_radius[begin:])), narrow]
        joints = [joint for joint in joints if joint < end * (1.0 - NARROWEST_RING)]
        if joints and min(joints) > end * (1.0 - NARROWEST_SLIP):
            raise OutsideValidity(
                f"FrettingHeat: in the last cycle of the path a ring slips that is {1.0 - min(joints) / end:.1g} of "
                f"the contact radius wide, at least {NARROWEST_SLIP:.0g} are needed to resolve its heat; move further, "
                "or press less."
            )
        flux = round_flux(lambda r: _losses(march, begin, r), joints, end)
        source = projected(flux.at, joints, end)
        entries = source.heat
        scale = self.frequency * loss / entries
        heated = LineSource(end, source.scale * scale, source.joints, source.curve)
        return FrettingHeatSolution(self, march, loss, abs(entries / loss - 1.0), flux.scaled(scale), heated)


def _begin(march: TangentialSolution) -> int:
    """Return where the cycle begins that the path ends with."""
    same = np.ones(march.time.size - 1, dtype=bool)
    for column in (march.shift, march.shear_force, march.depth):
        apart = np.abs(column[:-1] - column[-1]).reshape(march.time.size - 1, -1)
        same &= np.all(apart <= CLOSURE_TOLERANCE * np.max(np.abs(column)), axis=1)
    moved = np.abs(np.diff(march.shift, axis=0)).reshape(march.time.size - 1, -1).sum(axis=1)
    entries = [i for i in np.flatnonzero(same) if moved[i:].sum() > CLOSURE_TOLERANCE * np.max(np.abs(march.shift))]
    if not entries:
        raise InvalidInput(
            "FrettingHeat: the path does not come back to where it has been, with the same depth, shift and shear "
            "force; let it end with a closed cycle, as two cycles of an oscillation do."
        )
    return int(entries[-1])


def _losses(march: TangentialSolution, begin: int, r: Array) -> Array:
    r"""Return the heat per area of the cycle [J/m^2] at distances r.

    Under a steady load a ring slides only at its bound, and to one side between two turning points of the motion, so
    that a cycle releases :math:`\mu\,p(r)\sum|\Delta s(r)|` over these points, without error of the steps.
    """
    states, depth = march.states[begin:], march.depth[begin:]
    rings = [state for state in states if isinstance(state, PushedState)]
    if not rings or np.ptp(depth) > STEADY * np.max(depth):
        return _trapezoids(states, r)
    moves = np.diff(march.shift[begin:])
    moving = np.flatnonzero(moves) + 1
    turns = moving[:-1][np.diff(np.sign(moves[moving - 1])) != 0.0]
    slips = np.stack([rings[index].slip(r) for index in (0, *turns.tolist(), len(rings) - 1)])
    bed, coefficient = rings[0].springs.bed, rings[0].springs.coefficient
    pressure = bed.medium.pressure(PressedSprings(bed, float(depth[0]), rings[0].radius), r)
    return np.asarray(coefficient * pressure * np.sum(np.abs(np.diff(slips, axis=0)), axis=0))


def _trapezoids(states: Sequence[State], r: Array) -> Array:
    """Return the heat per area of the cycle [J/m^2] at distances r, by the trapezoidal rule over its points."""
    total = np.zeros(r.shape)
    before = None
    for state in states:
        assert not isinstance(state, DraggedState)  # bodies that relax are refused
        fields = state.surface_fields(r) if isinstance(state, PushedState) else sheared_surface(state.sheared, r)
        now = (fields.traction.reshape(*r.shape, -1), fields.slip.reshape(*r.shape, -1))
        if before is not None:
            total += np.sum(0.5 * (now[0] + before[0]) * (now[1] - before[1]), axis=-1)
        before = now
    return np.maximum(total, 0.0)


@value
class FrettingHeatSolution:
    """The solution of a `FrettingHeat`: means over a cycle, after many cycles; rises above that far away.

    Parameters
    ----------
    problem : FrettingHeat
        The problem that was solved.
    march : TangentialSolution
        The motion.
    loss_per_cycle : float
        Dissipated energy per cycle [J].
    misfit : float
        Relative difference between the heat summed over the surface and the dissipated energy, before scaling [-].
    flux : RoundFlux
        Mean heat per area and time, at any distance from the axis: ``flux.at(r)`` [W/m^2].
    source : LineSource
        The same as a line load.
    """

    __words__ = words(
        flux=("q", None, "mean heat per area and time"),
        max_temperature=(r"T_\mathrm{max}", "K", "greatest mean rise of temperature in the contact"),
    )

    problem: FrettingHeat
    march: TangentialSolution
    loss_per_cycle: float
    misfit: float
    flux: RoundFlux
    source: LineSource

    @property
    def heat_rate(self) -> float:
        """Mean heat per time [W]."""
        return self.problem.frequency * self.loss_per_cycle

    @property
    def first_share(self) -> float:
        """Part of it that goes into the first body [-]."""
        return self.problem._bodies[0].conductivity / self._conductivity

    @property
    def _conductivity(self) -> float:
        return sum(body.conductivity for body in self.problem._bodies)

    @property
    def max_temperature(self) -> float:
        """Maximum mean temperature [K]."""
        return self.source.peak(0.0).height / self._conductivity

    @property
    def mean_temperature(self) -> float:
        """Mean temperature over contact and time [K]."""
        return self.source.mean(0.0) / self._conductivity

    @property
    def swing(self) -> float:
        """Estimate of the maximum temperature amplitude about the mean [K]."""
        most = float(np.max(self.flux.at(np.linspace(0.0, self.source.radius, SAMPLES))))
        return swing_of(self.problem._bodies, self.problem.frequency, most, self.max_temperature)

    def temperature(self, r: ArrayLike) -> Array:
        """Return the mean temperature of the surface [K] at distances r [m] from the axis."""
        places = np.asarray(r, dtype=float)
        return np.asarray(self.source.surface(0.0, places, np.zeros(places.shape)) / self._conductivity)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        stroke = 0.5 * float(np.max(np.ptp(self.march.shift, axis=0))) / self.source.radius
        moved, swings = oscillation_notes(self.problem._bodies, self.problem.frequency, self.swing, stroke)
        return (
            *self.march.validity,
            Note(
                Assumption.CONDUCTION,
                Standing.EXACT,
                "Mean temperatures of half-spaces with a stationary heat source. A heat partition proportional "
                "to the conductivities gives equal temperatures of both bodies everywhere.",
                JAEGER,
            ),
            moved,
            Note(
                Assumption.RESOLUTION,
                Standing.APPROXIMATE if self.misfit > LOSS_TOLERANCE else Standing.ASYMPTOTIC,
                "Traction times slip, summed over the points of the path, differs from the dissipated energy by "
                f"{100 * self.misfit:.2g} %. The flux was scaled to the dissipated energy. More points in every "
                "cycle reduce the difference.",
                "the solution itself",
            ),
            swings,
            temperature_note(float(self.max_temperature) + float(self.swing)),
        )
