"""Tables of d(a) and F(a) for the models of one fit, which differ in their free numbers only."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from winkler.fitting.elastic.panels import PanelSeries, resolved
from winkler.fitting.elastic.reach import kinks_between, machine_curves, radius_range
from winkler.fitting.elastic.response import MachineResponse, end_at, of_table, response
from winkler.fitting.elastic.rising import RadiusTable, table_of
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
    """One table for a profile on homogeneous half-spaces of any modulus: d(a) does not depend on it, F/E* neither."""

    def __init__(self) -> None:
        self._series: PanelSeries | None = None
        self._range, self._highest, self._modulus = (0.0, 0.0), -np.inf, 1.0

    def response(self, states: EdgeStates, compliance: float, highest: float) -> MachineResponse:
        """Return the response."""
        if self._series is None or highest > self._highest:
            self._tabulate(states, highest)
        assert self._series is not None
        if self._range[1] <= self._range[0]:
            return response(states, compliance, highest)
        share = states.bed.medium.modulus / self._modulus  # type: ignore[attr-defined]
        depth, force = self._series.levels, self._series.others * share
        table = table_of(self._series._replace(levels=depth + compliance * force, others=force))
        return of_table(table, states, compliance, end_at(states, compliance, self._range[1]))

    def _tabulate(self, states: EdgeStates, highest: float) -> None:
        self._highest = MARGIN * highest
        self._modulus = states.bed.medium.modulus  # type: ignore[attr-defined]
        self._range = low, high = radius_range(states, 0.0, self._highest)
        nothing = np.zeros((0, 1))
        self._series = PanelSeries(*nothing.T, *nothing.T, *nothing.T, nothing, nothing)
        if high > low:
            self._series = resolved(machine_curves(states, 0.0), low, high, kinks_between(states.bed, low, high))
