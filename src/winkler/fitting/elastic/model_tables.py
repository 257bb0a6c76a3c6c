"""Tables of d(a) and F(a) for the models of one fit, which differ in their free numbers only."""

from __future__ import annotations

from typing import Protocol, cast

import numpy as np

from winkler.fitting.elastic.reach import machine_curves
from winkler.fitting.elastic.response import MachineResponse, end_at, of_table, response
from winkler.fitting.elastic.rising import RadiusTable
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import EdgeStates

__all__ = ["EACH_ANEW", "EachAnew", "HomogeneousTables", "ModelTables"]

MARGIN = 1.5
"""Greatest depth of a table relative to the greatest requested one."""


class ModelTables(Protocol):
    """The responses of the models of a fit."""

    most_starts: int
    """Number of contact points at which the fit may begin."""

    def response(self, states: EdgeStates, compliance: float, highest: float) -> MachineResponse:
        """Return the response up to the position `highest` [m]; see `winkler.fitting.elastic.response.response`."""
        ...

    def rough(self, states: EdgeStates, depth: float) -> tuple[float, float]:
        """Return F [N] at a depth [m], to a few per cent, and at pull-off."""
        ...

    def differences(self, table: RadiusTable, states: EdgeStates, compliance: float, radius: Array) -> Array:
        """Return the differences of D [m] and F [N] of slightly changed states from a table ``(2, m)``, at radii."""
        ...


class EachAnew:
    """A table for each model."""

    most_starts = 4

    def response(self, states: EdgeStates, compliance: float, highest: float) -> MachineResponse:
        """Return the response."""
        return response(states, compliance, highest)

    def rough(self, states: EdgeStates, depth: float) -> tuple[float, float]:
        """Return the forces."""
        found = self.response(states, 0.0, depth)
        return float(found.opening(np.array([depth]), np.inf).force[0]), found.loss()[1]

    def differences(self, table: RadiusTable, states: EdgeStates, compliance: float, radius: Array) -> Array:
        """Return the differences."""
        return table.differences(machine_curves(states, compliance), table.places_of(radius))


EACH_ANEW = EachAnew()


class HomogeneousTables(EachAnew):
    """One table for a profile on homogeneous half-spaces of any modulus.

    d(a) and F(a)/E* do not depend on the modulus, and D = d + F/k_m rises where d does, as dF = k(a) dd.
    """

    def __init__(self) -> None:
        self._highest, self._modulus = -np.inf, 1.0
        self._of_depth: MachineResponse | None = None
        self._forces: tuple[Array, ...] = ()

    def response(self, states: EdgeStates, compliance: float, highest: float) -> MachineResponse:
        """Return the response."""
        if self._of_depth is None or highest > self._highest:
            self._highest, self._modulus = MARGIN * highest, _modulus(states)
            self._of_depth = response(states, 0.0, self._highest)
            table = self._of_depth.table
            self._forces = tuple(table.read(table.places(piece.places))[0] for piece in table.pieces)
        share, whole = _modulus(states) / self._modulus, self._of_depth
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

    def differences(self, table: RadiusTable, states: EdgeStates, compliance: float, radius: Array) -> Array:
        """Return the differences."""
        assert self._of_depth is not None
        whole = self._of_depth.table.series[:, 1] * (_modulus(states) / self._modulus)
        force = table.read_series(whole - table.series[:, 1], table.places_of(radius))
        return np.stack([compliance * force, force])


def _modulus(states: EdgeStates) -> float:
    return float(cast(HomogeneousMedium, states.bed.medium).modulus)
