r"""Fretting wear of a line contact: sheared to and fro under a steady load, it wears where it slips.

In every cycle each place slips four times its amplitude s, the one that the narrower contact under the load
:math:`\gamma = P - Q/\mu` of the profile as it is then leaves (`winkler.problems.wear.strip_grid`),

.. math:: \frac{\mathrm df}{\mathrm dn} = 4\,\kappa\,p(x)\,s(x) , \qquad s(x) = \mu\,h(x;\gamma) .

On half-planes what sticks stays as wide as it was, whatever wears outside; on layers it moves
(`winkler.problems.wear.stuck_core`).  It bears everything in the end (`winkler.problems.wear.line_limiting_profile`).
"""

from __future__ import annotations

import functools
from collections.abc import Iterable, Iterator
from typing import ClassVar, NamedTuple

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.laws.friction import Sliding
from winkler.laws.wear import WearLaw
from winkler.loading.path import OnePositiveLineForce, OnePositiveLineSwing
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import WORN
from winkler.problems.line_friction.path import LinePath
from winkler.problems.line_friction.tangential import LineTangential
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.input_checks import Cells, WearTolerance
from winkler.problems.wear.line_states import LineFrettingState
from winkler.problems.wear.line_validity import line_fretting_notes
from winkler.problems.wear.march import WearMoment
from winkler.problems.wear.nodes import graded_nodes, halved, nodes_about
from winkler.problems.wear.strip_grid import RubbedStrip, StripGrid
from winkler.problems.wear.stuck_core import stuck_core
from winkler.problems.wear.validity import slip_grid_note
from winkler.problems.wear.worn_grid import WornContact
from winkler.problems.wear.worn_layers import layer_loses
from winkler.problems.wear.worn_states import AtGoals, pressed_moment, unworn, worn_history, worn_states
from winkler.values.checks.number_checks import FiniteQuantity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

SAMPLES = 65
LONGER = 1.1
"""Length of the grid, over that of what can wear at all."""


@value
class LineFrettingWear(AtGoals):
    """Wear of a line contact under oscillating tangential displacement.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        Profile and bodies before wear: homogeneous, or layers through which shear reaches the base.
    wear : Archard, PairWear or OwnWear
        Law of wear.
    law : Coulomb
        Friction; its coefficient must be positive and finite.
    normal : LineForce
        The steady normal force per length, one positive number.
    amplitude : LineShearForce
        Amplitude of the shear force per length: one positive number, below the friction limit. A tangential
        displacement cannot be prescribed: on half-planes it grows without limit with their size.
    cycles : float or ndarray, (steps,)
        Numbers of cycles after which the contact is returned; one number gives 41 states up to it.
    count : int, optional
        Number of grid cells on one side of the middle.
    tolerance : float, optional
        Error of the worn depth in one jump over many cycles, over the maximum final worn depth.
    layer_wears : bool, optional
        For a medium with layers and one law of wear: whether the uppermost layer wears. By default the other body
        wears. With a PairWear both wear, the layer by the first law.

    Raises
    ------
    InvalidInput
        If a law, a force or a number has the wrong type, or wear of a layer is requested on a medium without layers.
    OutsideValidity
        If a layer slides on the material below, or the bodies are viscoelastic.

    Notes
    -----
    On layers pressure, friction limit and slip follow from the responses to pressure and to shear along x. The stick
    zone changes while its surroundings wear. The elastic response of a worn layer is assumed unchanged, up to 5 % of
    its thickness.

    References
    ----------
    J. F. Archard, J. Appl. Phys. 24 (1953) 981-988, doi:10.1063/1.1721448;
    M. Ciavarella, D. A. Hills, Eur. J. Mech. A Solids 18 (1999) 491-497

    Examples
    --------
    What sticks is as wide after a million cycles as after the first one, and bears everything.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.laws.wear import Archard
    >>> from winkler.loading.loads import LineForce, LineShearForce
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(210e9, 0.3)
    >>> bed = LineFoundation(Paraboloid(10e-3), HalfSpace.between(steel, steel))
    >>> swing, cycles = LineShearForce(37.5e3), [0.0, 1e4, 1e7]
    >>> rig = LineFrettingWear(bed, Archard(1e-14), Coulomb(0.5), LineForce(100e3), swing, cycles, count=80)
    >>> worn = rig.solve()
    >>> (worn.stick_half_width * 1e6).round(2), (worn.half_width * 1e6).round(0)  # micrometres
    (array([52.52, 52.52, 52.52]), array([105., 107., 139.]))
    """

    __words__ = words(
        bed=("", None, "profile and bodies of the line contact"),
        goals=("n", "", "after how many cycles the contact is returned"),
        normal=("", None, "the steady normal force per length"),
        amplitude=("", None, "amplitude of the shear force per length"),
        count=("n", "", "cells of the grid of places on one side"),
        tolerance=(r"\epsilon", "", "error of the worn depth in one jump, over the greatest one in the end"),
        layer_wears=("", None, "whether the uppermost layer wears, and not the other body"),
    )

    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation
    wear: WearLaw
    law: Sliding
    normal: OnePositiveLineForce
    amplitude: OnePositiveLineSwing
    cycles: FiniteQuantity
    count: Cells = 400
    tolerance: WearTolerance = 1e-3
    layer_wears: bool = False

    references: ClassVar[tuple[str, ...]] = ("archard_1953", "ciavarella_hills_1999", "dimaki_2014")
    assumptions: ClassVar[frozenset[Assumption]] = WORN

    def __post_init__(self) -> None:
        _ = self.bed.along_share
        super().__post_init__()

    def _rubbed(self, grid: StripGrid, contact: WornContact) -> RubbedStrip:
        return grid.rub(contact, self.law.coefficient, float(self.amplitude.shear_force_per_length))

    @property
    def most_worn(self) -> float:
        """Final maximum worn depth [m]; infinite if nothing slips."""
        return _end_of_wear(self).depth

    def slipped(self, grid: StripGrid, contact: WornContact) -> Array:
        """Return the slip distance per cycle at the nodes [m]."""
        return 4.0 * self._rubbed(grid, contact).slip

    def _nodes(self) -> Array:
        """Return places up to where wear ends at last, closest beside what sticks."""
        end = _end_of_wear(self)
        if end.core == 0.0:
            return graded_nodes(0.0, end.reach, end.reach, self.count)
        return nodes_about(end.core, end.reach, self.count)

    def steps(self, start: LineFrettingState | None = None) -> Iterator[LineFrettingState]:
        """Yield the contact at every requested number of cycles.

        Parameters
        ----------
        start : LineFrettingState, optional
            A state of this problem from an earlier, possibly interrupted run. The computation continues from it, with
            the same numbers as without interruption.

        Raises
        ------
        OutsideValidity
            If the shear force exceeds the friction limit, the bodies touch in several strips, or wear exceeds the known
            range of the profile.
        NotConverged
            If jumps become too short.
        """
        return worn_states(self, start, self._nodes, everywhere=False)

    def state(self, moment: WearMoment) -> LineFrettingState:
        """Return the validity notes of the contact."""
        contact, touching, common = pressed_moment(self, moment)
        grid = wear_grid(self.bed, moment.nodes)
        rubbed = self._rubbed(grid, contact)
        lost = 4.0 * self.law.coefficient * float(grid.transforms.areas @ (contact.pressure * rubbed.slip))
        return LineFrettingState(
            **common, places=moment.nodes, force_per_length=contact.force, half_width=touching,
            shear_force_per_length=float(self.amplitude.shear_force_per_length),
            stick_half_width=rubbed.stick_half_width, slip=rubbed.slip, dissipation_per_length=lost,
        )  # fmt: skip

    def gathered(self, states: Iterable[LineFrettingState]) -> LineFrettingSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        return worn_history(LineFrettingSolution, self, states)

    def solve(self) -> LineFrettingSolution:
        """Return the contact over all cycles.

        Returns
        -------
        LineFrettingSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


class _EndOfWear(NamedTuple):
    """What sticks, zero if that is all up to a rim, up to where the grid goes, and the greatest worn depth [m]."""

    core: float
    reach: float
    depth: float


@functools.lru_cache(maxsize=8)
def _end_of_wear(problem: LineFrettingWear) -> _EndOfWear:
    bed = problem.bed
    core = stuck_core("LineFrettingWear", bed, problem.law, problem.normal, problem.amplitude)
    if core.half_width >= bed.rim:
        return _EndOfWear(0.0, bed.rim, np.inf)
    end = core.outer_half_width()
    beside = core.half_width + (end - core.half_width) * np.linspace(0.0, 1.0, SAMPLES) ** 2
    return _EndOfWear(core.half_width, min(LONGER * end, bed.reach, bed.rim), float(np.max(core.worn(beside))))


@value
class LineFrettingSolution:
    """The solution of a `LineFrettingWear`, state by state.

    Parameters
    ----------
    problem : LineFrettingWear
        The problem that was solved.
    cycles : ndarray, (steps,)
        n [-].
    force_per_length, half_width, stick_half_width : ndarray, (steps,)
        P [N/m], a [m], c [m].
    worn_depth : ndarray, (steps,)
        Maximum worn depth [m], of both bodies together.
    worn_volume_per_length, first_volume_per_length, second_volume_per_length : ndarray, (steps,)
        Wear volume of both bodies together and of each body, per length of the line [m^2].
    dissipation_per_length : ndarray, (steps,)
        Dissipated energy per cycle and length [J/m].
    states : tuple of LineFrettingState
        The states themselves, with the worn profiles.
    """

    __words__ = words(dissipation_per_length=("W_d", "J/m", "energy per length lost in every cycle"))

    problem: LineFrettingWear
    cycles: Array
    force_per_length: Array
    half_width: Array
    stick_half_width: Array
    worn_depth: Array
    worn_volume_per_length: Array
    first_volume_per_length: Array
    second_volume_per_length: Array
    dissipation_per_length: Array
    states: tuple[LineFrettingState, ...]

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        stated, nodes = self.problem, self.states[0].nodes
        found = stated.state(unworn(nodes)).dissipation_per_length
        force, shear = float(stated.normal.force_per_length), float(stated.amplitude.shear_force_per_length)
        if stated.bed.sheared_as_pressed:
            path = LinePath(force, shear * np.array([0.0, 1.0, -1.0, 1.0]))
            strips = LineTangential(stated.bed, stated.law, path).solve()
            expected = float(strips.dissipation_per_length[-1] - strips.dissipation_per_length[1])
        else:
            coarse = stated.state(unworn(halved(nodes))).dissipation_per_length
            expected = found + (found - coarse) / 3.0
        wears = layer_loses(stated.bed.medium, stated.wear, layer_wears=stated.layer_wears)
        return (
            *line_fretting_notes(stated.bed, stated.law.coefficient, stated.tolerance, self.states, layer_wears=wears),
            *slip_grid_note(found, expected, shear / (stated.law.coefficient * force)),
        )
