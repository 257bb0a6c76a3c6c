"""Tables of d(a) and F(a) for the models of one fit, which differ in their free numbers only."""

from __future__ import annotations

import functools
import math
from typing import NamedTuple, Protocol, cast

import numpy as np

from winkler.fitting.elastic.depth_response import DepthTable, HomogeneousResponse, depth_table
from winkler.fitting.elastic.reach import machine_curves
from winkler.fitting.elastic.response import MachineResponse, ResponseValues, end_at, of_table, response
from winkler.fitting.parameters import changed
from winkler.foundation.bed import Bed
from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.media.medium import Medium
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import EdgeStates, FarStates
from winkler.problems.normal.solve_contact import flat_radius

MARGIN, IN_OCTAVE = 1.2, 4
"""Least depth of a table relative to the greatest requested one, and the depths of tables in an octave."""
KEPT = 16
"""Tables of shapes that are kept for the next fits."""
MEDIUM = "bed.medium."


Response = MachineResponse | HomogeneousResponse


class ModelTables(Protocol):
    """The responses of the models of a fit."""

    most_starts: int
    """Number of contact points at which the fit may begin."""

    def response(self, states: EdgeStates, compliance: float, highest: float) -> Response:
        """Return the response up to the position `highest` [m]; see `winkler.fitting.elastic.response.response`."""

    def known(self, numbers: dict[str, float], compliance: float, highest: float) -> HomogeneousResponse | None:
        """Return the response at free numbers where it follows without a model of these numbers; else None."""

    def rough(self, states: EdgeStates, depth: float) -> tuple[float, float]:
        """Return F [N] at a depth [m], to a few per cent, and at pull-off."""

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


class EachAnew:
    """A table for each model."""

    most_starts = 4

    def response(self, states: EdgeStates, compliance: float, highest: float) -> Response:
        """Return the response."""
        return response(states, compliance, highest)

    def known(self, numbers: dict[str, float], compliance: float, highest: float) -> HomogeneousResponse | None:
        """Return None: each model is needed."""
        del numbers, compliance, highest
        return None

    def rough(self, states: EdgeStates, depth: float) -> tuple[float, float]:
        """Return the forces."""
        found = self.response(states, 0.0, depth)
        return float(found.opening(np.array([depth]), np.inf).force[0]), found.loss()[1]

    def differences(self, held: Response, states: EdgeStates, compliance: float, values: ResponseValues) -> Array:
        """Return the differences."""
        assert isinstance(held, MachineResponse)
        return held.table.differences(machine_curves(states, compliance), held.table.places_of(values.radius))


EACH_ANEW = EachAnew()


class _ShapeTables(NamedTuple):
    """Of one modulus [Pa], to a depth [m]: the response, forces at the ends of its pieces, and F over the depth.

    `smooth` is None where the profile is not smooth or ends before the depth; `stiffness` is k(a)/a [Pa].
    """

    modulus: float
    whole: MachineResponse
    forces: tuple[Array, ...]
    smooth: DepthTable | None
    stiffness: float


@functools.lru_cache(maxsize=KEPT)
def _shape_tables(bed: Bed, highest: float) -> _ShapeTables:
    """Return the tables of a profile on a homogeneous half-space to a depth [m]."""
    states = FarStates(bed, 0.0)
    whole = response(states, 0.0, highest)
    forces = tuple(whole.table.read(whole.table.places(piece.places))[0] for piece in whole.table.pieces)
    ends = not whole.end[0] > highest
    smooth = None if ends or bed.kinks or flat_radius(bed) > 0.0 else depth_table(whole)
    one = np.array([whole.end[3]])
    return _ShapeTables(_modulus(bed.medium), whole, forces, smooth, float(bed.stiffness(one)[0] / one[0]))


class HomogeneousTables(EachAnew):
    """One table for a profile on homogeneous half-spaces of any modulus.

    d(a) and F(a)/E* do not depend on the modulus, and D = d + F/k_m rises where d does, as dF = k(a) dd.  The depths of
    tables are fixed numbers, so that fits of one model share them, and no fit depends on those before it.

    Parameters
    ----------
    bed : Bed
        Of the model from which fits begin; the free numbers are those of its medium.
    """

    def __init__(self, bed: Bed) -> None:
        self._bed = bed
        self._highest = -np.inf
        self._shape: _ShapeTables

    def response(self, states: EdgeStates, compliance: float, highest: float) -> Response:
        """Return the response."""
        modulus, shape = _modulus(states.bed.medium), self._up_to(highest)
        if shape.smooth is not None:
            return HomogeneousResponse(shape.smooth, modulus / shape.modulus, shape.stiffness, compliance)
        share, whole = modulus / shape.modulus, shape.whole
        depth, force = whole.table.series[:, 0], whole.table.series[:, 1] * share
        pieces = tuple(
            piece._replace(levels=piece.levels + compliance * share * pressed)
            for piece, pressed in zip(whole.table.pieces, shape.forces, strict=True)
        )
        table = whole.table._replace(series=np.stack([depth + compliance * force, force], axis=1), pieces=pieces)
        if compliance:
            return of_table(table, states, compliance, end_at(states, compliance, whole.end[3]))
        held = tuple(one._replace(force=share * one.force, slope=share * one.slope) for one in whole.held)
        level, last, stiffness, high = whole.end
        return MachineResponse(table, (level, share * last, share * stiffness, high), held)

    def known(self, numbers: dict[str, float], compliance: float, highest: float) -> HomogeneousResponse | None:
        """Return the response of a smooth profile: only the modulus follows from the numbers."""
        shape = self._up_to(highest)
        if shape.smooth is None:
            return None
        own = {name.removeprefix(MEDIUM): number for name, number in numbers.items() if name.startswith(MEDIUM)}
        medium = self._bed.medium
        modulus = medium.modulus_with(own) if type(medium) is HalfSpace else _modulus(changed(medium, own))
        return HomogeneousResponse(shape.smooth, modulus / shape.modulus, shape.stiffness, compliance)

    def _up_to(self, highest: float) -> _ShapeTables:
        """Return the tables to a depth [m], or farther."""
        if highest > self._highest:
            self._highest = 2.0 ** (math.ceil(IN_OCTAVE * math.log2(MARGIN * highest)) / IN_OCTAVE)
            self._shape = _shape_tables(self._bed, self._highest)
        return self._shape

    def differences(self, held: Response, states: EdgeStates, compliance: float, values: ResponseValues) -> Array:
        """Return the differences."""
        assert isinstance(held, MachineResponse)
        shape = self._shape
        whole = shape.whole.table.series[:, 1] * (_modulus(states.bed.medium) / shape.modulus)
        force = held.table.read_series(whole - held.table.series[:, 1], held.table.places_of(values.radius))
        return np.stack([compliance * force, force])


def _modulus(medium: Medium) -> float:
    return float(cast(HomogeneousMedium, medium).modulus)
