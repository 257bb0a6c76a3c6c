r"""Fretting wear: a contact pushed to and fro wears where it slips, cycle after cycle.

In every cycle each point slips four times its amplitude s,

.. math:: \frac{\mathrm df}{\mathrm dn} = 4\,\kappa\,p(r)\,s(r) , \qquad s = U - u_x(r) ,

with pressure and slip of the profile as it is then (`winkler.problems.wear.round_grid`): the rapid procedure of
Dimaki and co-workers.  Under partial slip the core that sticks does not wear; the slipping ring wears until it bears
nothing any more (`winkler.problems.wear.limiting_profile`).  In gross slip the contact grows without end.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import ClassVar

from winkler.foundation.foundation import Foundation
from winkler.laws.friction import Sliding
from winkler.laws.wear import WearLaw
from winkler.loading.loads import ShearForce
from winkler.loading.path import OnePositiveNormal, OnePositiveSwing, numbers_of
from winkler.media.offers import PressedWaves, offers
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import WORN
from winkler.problems.friction.damping import FrictionDamping
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.input_checks import Cells, WearTolerance, refuse_unless_rubbed
from winkler.problems.wear.march import WearMoment
from winkler.problems.wear.round_core import expected_loss, fretting_nodes
from winkler.problems.wear.round_grid import RoundGrid, RubbedContact
from winkler.problems.wear.states import FrettingState
from winkler.problems.wear.validity import fretting_notes, slip_grid_note
from winkler.problems.wear.worn_grid import WornContact
from winkler.problems.wear.worn_layers import (
    cells_note,
    layer_loses,
    layer_notes,
)
from winkler.problems.wear.worn_states import AtGoals, pressed_moment, unworn, worn_history, worn_states
from winkler.values.checks.number_checks import FiniteQuantity
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words


@value
class FrettingWear(AtGoals):
    """Wear of a contact under oscillating tangential displacement.

    Parameters
    ----------
    bed : Foundation
        Foundation(profile, medium) before wear; the bodies are elastic, with or without bonded layers.
    wear : Archard, PairWear or OwnWear
        Law of wear.
    law : Coulomb
        Friction; its coefficient must be positive and finite.
    normal : Depth or Force
        The steady normal load, one positive number.
    amplitude : Shift or ShearForce
        Amplitude (half of the stroke), one positive number.
    cycles : float or ndarray, (steps,)
        Numbers of cycles after which the contact is returned; one number gives 41 states up to it.
    count : int, optional
        Number of grid cells along the radius.
    tolerance : float, optional
        Error of the worn depth in one jump over many cycles, over the depth of the springs.
    layer_wears : bool, optional
        For a medium with layers and one law of wear: whether the uppermost layer wears. By default the other body
        wears. With a PairWear both wear, the layer by the first law.

    Raises
    ------
    InvalidInput
        If a law, a load or a number has the wrong type, or wear of a layer is requested on a medium without layers.
    OutsideValidity
        If the medium relaxes, or a layer slides on the material below.

    Notes
    -----
    On layers and graded bodies pressure, friction limit and slip follow from the normal and shear kernels of the
    layers, as in `Tangential`. The stick zone changes while its surroundings wear. The elastic response of a worn
    layer is assumed unchanged, up to 5 % of its thickness.

    References
    ----------
    A. V. Dimaki, A. I. Dmitriev, Y. S. Chai, V. L. Popov, Int. J. Solids Struct. 51 (2014) 4215-4220;
    V. L. Popov, Sci. Rep. 4 (2014) 3749, doi:10.1038/srep03749

    Examples
    --------
    A ball that sticks within half of its contact wears no deeper than this; what bears in the end is the core alone.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.laws.wear import Archard
    >>> from winkler.loading.loads import Depth
    >>> from winkler.loading.loads import Shift
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> medium = HalfSpace(Elastic(young=1.0, poisson=0.0))
    >>> bed = Foundation(Paraboloid(1.0), medium)
    >>> swing = Shift(0.5 * 0.75e-2 * medium.modulus / medium.shear_modulus)
    >>> fretting = FrettingWear(bed, Archard(0.1), Coulomb(0.5), Depth(0.01), swing, [0.0, 1e2, 1e6], count=80)
    >>> worn = fretting.solve()
    >>> (worn.force / (medium.modulus * 0.1 * 0.01)).round(2)  # from 4/3 to 11/12
    array([1.33, 1.21, 0.92])
    """

    __words__ = words(
        goals=("n", "", "after how many cycles the contact is returned"),
        amplitude=("", None, "amplitude of the shift or of the shear force"),
        count=("n", "", "cells of the grid of radii"),
        tolerance=(r"\epsilon", "", "error of the worn depth in one jump, over the depth"),
        layer_wears=("", None, "whether the uppermost layer wears, and not the other body"),
    )

    bed: Foundation
    wear: WearLaw
    law: Sliding
    normal: OnePositiveNormal
    amplitude: OnePositiveSwing
    cycles: FiniteQuantity
    count: Cells = 400
    tolerance: WearTolerance = 1e-3
    layer_wears: bool = False

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "dimaki_2014", "popov_2014", "archard_1953")
    assumptions: ClassVar[frozenset[Assumption]] = WORN
    needs_round: ClassVar[str] = "wear, which follows pressure and slip from place to place,"

    def __post_init__(self) -> None:
        refuse_unless_rubbed("FrettingWear", self.bed)
        super().__post_init__()

    def rubbed(self, grid: RoundGrid, contact: WornContact) -> RubbedContact:
        """Return the contact under the oscillating displacement."""
        coefficient, size = self.law.coefficient, float(numbers_of(self.amplitude))
        if isinstance(self.amplitude, ShearForce):
            size = grid.shift_under(contact, coefficient, size)
        return grid.rub(contact, coefficient, size)

    def slipped(self, grid: RoundGrid, contact: WornContact) -> Array:
        """Return the slip distance per cycle at the nodes [m]."""
        return 4.0 * self.rubbed(grid, contact).slip

    def refuse(self, contact: WornContact, elapsed: float) -> None:
        """Refuse a contact that slides away under a prescribed shear force, and to wear much of a layer."""
        super().refuse(contact, elapsed)
        most = self.law.coefficient * contact.force
        if isinstance(self.amplitude, ShearForce) and float(self.amplitude.shear_force) >= most:
            raise OutsideValidity(
                f"FrettingWear: after {elapsed:.6g} cycles friction carries {most:.6g} N, and the bodies slide away "
                f"under a shear force of {float(self.amplitude.shear_force):.6g} N; give less, or prescribe a Shift."
            )

    def steps(self, start: FrettingState | None = None) -> Iterator[FrettingState]:
        """Yield the contact at every requested number of cycles.

        Parameters
        ----------
        start : FrettingState, optional
            A state of this problem from an earlier, possibly interrupted run. The computation continues from it, with
            the same numbers as without interruption.

        Raises
        ------
        OutsideValidity
            If the bodies do not touch or slide, or the contact exceeds the profile. The error is raised at that step,
            after all earlier states.
        NotConverged
            If jumps become too short.
        """
        return worn_states(self, start, lambda: fretting_nodes(self), everywhere=False)

    def state(self, moment: WearMoment) -> FrettingState:
        """Return the validity notes of the contact."""
        contact, touching, common = pressed_moment(self, moment)
        grid = wear_grid(self.bed, moment.nodes)
        rubbed = self.rubbed(grid, contact)
        lost = 4.0 * self.law.coefficient * float(grid.rings.areas @ (contact.pressure * rubbed.slip))
        return FrettingState(
            **common, radii=moment.nodes, depth=contact.depth, force=contact.force, radius=touching,
            shift=rubbed.shift, stick_radius=rubbed.stick_radius, slip=rubbed.slip,
            shear_force=grid.shear_force(contact, self.law.coefficient, rubbed.shift), loss_per_cycle=lost,
        )  # fmt: skip

    def gathered(self, states: Iterable[FrettingState]) -> FrettingSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        return worn_history(FrettingSolution, self, states)

    def solve(self) -> FrettingSolution:
        """Return the contact over all cycles.

        Returns
        -------
        FrettingSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class FrettingSolution:
    """The solution of a `FrettingWear`, state by state.

    Parameters
    ----------
    problem : FrettingWear
        The problem that was solved.
    cycles : ndarray, (steps,)
        n [-].
    depth, force, radius : ndarray, (steps,)
        d [m], F_N [N], a [m].
    stick_radius : ndarray, (steps,)
        c [m].
    shift, shear_force : ndarray, (steps,)
        Amplitudes [m], [N].
    worn_depth : ndarray, (steps,)
        Maximum worn depth [m], of both bodies together.
    worn_volume, first_volume, second_volume : ndarray, (steps,)
        Wear volume of both bodies together and of each body [m^3].
    loss_per_cycle : ndarray, (steps,)
        Dissipated energy per cycle [J].
    states : tuple of FrettingState
        The states themselves, with the worn profiles.
    """

    __words__ = words(
        shift=("U", "m", "amplitude of the shift"), shear_force=("F_x", "N", "amplitude of the shear force")
    )

    problem: FrettingWear
    cycles: Array
    depth: Array
    force: Array
    radius: Array
    stick_radius: Array
    shift: Array
    shear_force: Array
    worn_depth: Array
    worn_volume: Array
    first_volume: Array
    second_volume: Array
    loss_per_cycle: Array
    states: tuple[FrettingState, ...]

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        stated = self.problem
        first = stated.state(unworn(self.states[0].nodes))
        found, given = first.loss_per_cycle, stated.amplitude
        shear_force = float(given.shear_force) if isinstance(given, ShearForce) else first.shear_force
        share = shear_force / (stated.law.coefficient * first.force)
        notes = fretting_notes(stated.bed, stated.law.coefficient, stated.tolerance, self.states)
        medium = stated.bed.medium
        if not offers(medium, PressedWaves):
            springs = FrictionDamping(stated.bed, stated.law, stated.normal, stated.amplitude).solve()
            return (*notes, *slip_grid_note(found, float(springs.loss_per_cycle), share))
        wears = layer_loses(medium, stated.wear, layer_wears=stated.layer_wears)
        expected = expected_loss(stated, self.states[0].nodes, found)
        layers = layer_notes(medium, self.states, cells_note(self.states[0]), layer_wears=wears)
        return (*notes, *slip_grid_note(found, expected, share), *layers)
