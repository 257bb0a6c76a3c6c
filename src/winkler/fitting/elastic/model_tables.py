"""Tables of d(a) and F(a) for the models of one fit, which differ in their free numbers only."""

from __future__ import annotations

from typing import Protocol, cast

import numpy as np

from winkler.fitting.elastic.depth_response import DepthTable, HomogeneousResponse, depth_table
from winkler.fitting.elastic.reach import machine_curves
from winkler.fitting.elastic.response import MachineResponse, ResponseValues, end_at, of_table, response
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import EdgeStates
from winkler.problems.normal.solve_contact import flat_radius

__all__ = ["EACH_ANEW", "EachAnew", "HomogeneousTables", "ModelTables", "Response"]

MARGIN = 1.5
"""Greatest depth of a table relative to the greatest requested one."""


Response = MachineResponse | HomogeneousResponse


class ModelTables(Protocol):
    """The responses of the models of a fit."""

    most_starts: int
    """Number of contact points at which the fit may begin."""

    def response(self, states: EdgeStates, compliance: float, highest: float) -> Response:
        """Return the response up to the position `highest` [m]; see `winkler.fitting.elastic.response.response`."""
        ...

    def rough(self, states: EdgeStates, depth: float) -> tuple[float, float]:
        """Return F [N] at a depth [m], to a few per cent, and at pull-off."""
        ...

    def differences(self, held: Response, states: EdgeStates, compliance: float, values: ResponseValues) -> Array:
        """Return by how much D [m] and F [N] of slightly changed states differ at the same radii ``(2, m)``.

        Parameters
        ----------
        held : MachineResponse or HomogeneousResponse
            Of the other states.
        states : EdgeStates
        compliance : float
            Of the machine [m/N].
        values : ResponseValues, (m,)
            Of the other states.
        """
        ...


class EachAnew:
    """A table for each model."""

    most_starts = 4

    def response(self, states: EdgeStates, compliance: float, highest: float) -> Response:
        """Return the response."""
        return response(states, compliance, highest)

    def rough(self, states: EdgeStates, depth: float) -> tuple[float, float]:
        """Return the forces."""
        found = self.response(states, 0.0, depth)
        return float(found.opening(np.array([depth]), np.inf).force[0]), found.loss()[1]

    def differences(self, held: Response, states: EdgeStates, compliance: float, values: ResponseValues) -> Array:
        """Return the differences."""
        assert isinstance(held, MachineResponse)
        return held.table.differences(machine_curves(states, compliance), held.table.places_of(values.radius))


EACH_ANEW = EachAnew()


class HomogeneousTables(EachAnew):
    """One table for a profile on homogeneous half-spaces of any modulus.

    d(a) and F(a)/E* do not depend on the modulus, and D = d + F/k_m rises where d does, as dF = k(a) dd.
    """

    def __init__(self) -> None:
        self._highest, self._modulus = -np.inf, 1.0
        self._of_depth: MachineResponse | None = None
        self._forces: tuple[Array, ...] = ()
        self._smooth: DepthTable | None = None
        self._stiffness = 0.0

    def response(self, states: EdgeStates, compliance: float, highest: float) -> Response:
        """Return the response."""
        if self._of_depth is None or highest > self._highest:
            self._tabulate(states, MARGIN * highest)
        assert self._of_depth is not None
        share, whole = _modulus(states) / self._modulus, self._of_depth
        if self._smooth is not None:
            return HomogeneousResponse(self._smooth, share, self._stiffness, compliance)
        depth, force = whole.table.series[:, 0], whole.table.series[:, 1] * share
        pieces = tuple(
            piece._replace(levels=piece.levels + compliance * share * pressed)
            for piece, pressed in zip(whole.table.pieces, self._forces, strict=True)
        )
        table = whole.table._replace(series=np.stack([depth + compliance * force, force], axis=1), pieces=pieces)
        if compliance:
            return of_table(table, states, compliance, end_at(states, compliance, whole.end[3]))
        held = tuple(one._replace(force=share * one.force, slope=share * one.slope) for one in whole.held)
        level, last, stiffness, high = whole.end
        return MachineResponse(table, (level, share * last, share * stiffness, high), held)

    def _tabulate(self, states: EdgeStates, highest: float) -> None:
        """Make the tables up to a depth [m]: over the depth where the profile is smooth and does not end before."""
        self._highest, self._modulus = highest, _modulus(states)
        self._of_depth = whole = response(states, 0.0, highest)
        self._forces = tuple(whole.table.read(whole.table.places(piece.places))[0] for piece in whole.table.pieces)
        ends = not whole.end[0] > highest
        self._smooth = None if ends or states.bed.kinks or flat_radius(states.bed) > 0.0 else depth_table(whole)
        one = np.array([whole.end[3]])
        self._stiffness = float(states.bed.stiffness(one)[0] / one[0])

    def differences(self, held: Response, states: EdgeStates, compliance: float, values: ResponseValues) -> Array:
        """Return the differences."""
        share = _modulus(states) / self._modulus
        if isinstance(held, HomogeneousResponse):
            force = (share / held.share - 1.0) * values.force
        else:
            assert self._of_depth is not None
            whole = self._of_depth.table.series[:, 1] * share
            force = held.table.read_series(whole - held.table.series[:, 1], held.table.places_of(values.radius))
        return np.stack([compliance * force, force])


def _modulus(states: EdgeStates) -> float:
    return float(cast(HomogeneousMedium, states.bed.medium).modulus)
