r"""The contacts of a film of any modulus in a fit: d(a) and F(a) of a few moduli, and polynomials between them.

With the modulus E of one layer, or of the substrate, :math:`\ln d(a)` and :math:`\ln F(a)` at a fixed radius are
analytic functions of :math:`\ln E` with singularities no nearer than :math:`\pm i\pi`, where the ratio of two moduli
is -1.  In a window of a factor 7 to both sides, `NODES` Chebyshev nodes give them to about 1e-6, which the last
coefficients check.  The flat punches of one modulus are solved once for each node, not once for each step of a fit.
"""

from __future__ import annotations

import math
from typing import NamedTuple, cast

import numpy as np

from winkler.fitting.elastic.model_tables import EachAnew, Response
from winkler.fitting.elastic.panels import PanelSeries, panel_nodes
from winkler.fitting.elastic.response import MachineResponse, ResponseValues, of_table
from winkler.fitting.elastic.rising import table_of
from winkler.fitting.parameters import changed, number_at
from winkler.foundation.foundation import Foundation
from winkler.media.layered.coated import LayeredMedium
from winkler.media.layered.direct_punch import depth_and_force, nodes_for
from winkler.numerics.equations.roots import rough_root
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import EdgeStates
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.solve_contact import end_of

NODES = 12
"""Moduli of a window."""
HALF_WIDTH, OVERLAP = 2.0, 0.05
"""Half-width of a window in ln E, and how far beyond it may be used."""
RADII, OCTAVES = 8, 7
"""Contact radii on an octave, and octaves; below is one more panel."""
RESOLVED = 1e-5
"""Greatest last coefficient of a series in ln E or in the radius, in parts of d and F; else tables are made anew."""
MARGIN = 1.3
"""Greatest depth of the tables relative to the greatest requested one."""
WIDENING, MOST_WIDENINGS = 1.2, 60
MOST_REACH = 0.9
"""Widest contact relative to the end of a profile, where it may be vertical."""
ROUGH_STEPS, ROUGH_TOLERANCE = 6, 0.03


class ModulusWindow(NamedTuple):
    """Chebyshev series in ln E around `centre`: of ln d and ln F over those of the first layer alone.

    `series` has the shape (NODES, 2, panels, nodes).
    """

    centre: float
    series: Array


class FilmTables(EachAnew):
    """Tables of a film for one free modulus.

    Parameters
    ----------
    model : Indentation
        A profile without kinks on a `CoatedHalfSpace`, a `SlidingFilm` or a `StackedHalfSpace`.
    name : str
        Path of the free modulus.
    """

    most_starts = 2

    def __init__(self, model: Indentation, name: str) -> None:
        self.model, self.name = model, name
        self.profile = cast(Foundation, model.bed).profile
        self.start = math.log(number_at(model, name))
        self._windows: list[ModulusWindow] = []
        self._highest = -math.inf
        self._is_used = True
        self._edges = np.zeros(0)

    def response(self, states: EdgeStates, compliance: float, highest: float) -> Response:
        """Return the response."""
        if highest > self._highest:
            self._choose_radii(states, highest)
        columns = self._columns(states)
        if columns is None:
            return super().response(states, compliance, highest)
        depth, force = columns
        matrix = panel_nodes()[1]
        levels, others = (depth + compliance * force) @ matrix.T, force @ matrix.T
        left, right = self._edges[:-1], self._edges[1:]
        table = table_of(PanelSeries(np.zeros(left.size), left, right, levels, others))
        last = table.places(np.array([float(left.size)]))
        ending, slope = table.read(last)
        end = float(table.level(last)[0]), float(ending[0]), float(slope[0]), float(right[-1])
        return of_table(table, states, compliance, end)

    def rough(self, states: EdgeStates, depth: float) -> tuple[float, float]:
        """Return the forces; without adhesion that at pull-off is zero."""
        bed, widest = cast(Foundation, states.bed), MOST_REACH * end_of(states.bed)
        if math.isfinite(widest) and float(states.bed.gap(np.array([widest]))[0]) < 2.0 * depth:
            return super().rough(states, depth)
        a = _radius_at(bed, depth)
        for _ in range(ROUGH_STEPS):
            reached, force = depth_and_force(cast(LayeredMedium, bed.medium), bed.profile, np.array([a]))
            if abs(float(reached[0]) - depth) < ROUGH_TOLERANCE * depth:
                break
            a = _radius_at(bed, float(bed.profile.gap(np.array([a]))[0]) * depth / float(reached[0]))
        return float(force[0]) * (depth / float(reached[0])), 0.0

    def differences(self, held: Response, states: EdgeStates, compliance: float, values: ResponseValues) -> Array:
        """Return the differences."""
        assert isinstance(held, MachineResponse)
        table = held.table
        columns = self._columns(states) if table.left.size == self._edges.size - 1 else None
        if columns is None:
            return super().differences(held, states, compliance, values)
        depth, force = columns
        both = (depth + compliance * force).ravel(), force.ravel()
        return table.differences(lambda _: both, table.places_of(values.radius))

    def _choose_radii(self, states: EdgeStates, highest: float) -> None:
        """Choose the radii of all tables, so that the contact at the position `highest` lies within them."""
        bed = cast(Foundation, states.bed)
        self._highest, self._windows = MARGIN * highest, []
        widest = MOST_REACH * end_of(bed)
        self._is_used = math.isinf(widest) or float(bed.profile.gap(np.array([widest]))[0]) > self._highest
        if not self._is_used:
            return
        high = _radius_at(bed, self._highest)
        for _ in range(MOST_WIDENINGS):
            # of the stiffest and the softest body of a window, both deeper than requested
            bodies = [self._medium(self._logarithm(states) + far) for far in (-HALF_WIDTH, HALF_WIDTH)]
            depths = [float(depth_and_force(body, bed.profile, np.array([high]))[0][0]) for body in bodies]
            if min(depths) >= self._highest or high * WIDENING > widest:
                break
            high *= WIDENING
        self._edges = np.concatenate([[0.0], high * 2.0 ** np.arange(-OCTAVES, 1.0)])
        self._is_used = min(depths) >= self._highest

    def _medium(self, logarithm: float) -> LayeredMedium:
        """Return the film with a modulus, given as the logarithm of its ratio to the start."""
        other = changed(self.model, {self.name: math.exp(self.start + logarithm)})
        return cast(LayeredMedium, other.bed.medium)

    def _logarithm(self, states: EdgeStates) -> float:
        return math.log(number_at(Indentation(states.bed, self.model.load), self.name)) - self.start

    def _homogeneous(self) -> Array:
        """Return d and F over E* of the profile on a half-space ``(2, panels, nodes)``."""
        radius = self._radii(panel_nodes()[0])
        depth = self.profile.gap(radius)
        return np.stack([depth, 2.0 * (radius * depth - self.profile.gap_integral(radius))])

    def _radii(self, nodes: Array) -> Array:
        """Return radii at nodes from -1 to 1 of all panels ``(panels, nodes)``."""
        left, right = self._edges[:-1, None], self._edges[1:, None]
        return np.asarray(0.5 * (left + right) + 0.5 * (right - left) * nodes)

    def _columns(self, states: EdgeStates) -> Array | None:
        """Return d [m] and F [N] at the nodes of all panels ``(2, panels, nodes)``; None if they are not resolved."""
        x = self._logarithm(states)
        if not self._is_used:
            return None
        window = next((one for one in self._windows if abs(x - one.centre) <= HALF_WIDTH * (1.0 + OVERLAP)), None)
        if window is None:
            window = self._solved(x)
            self._windows.insert(0, window)
            self._is_used = self._is_used and float(np.max(np.abs(window.series[-2:]))) < RESOLVED
            if not self._is_used:
                return None
        weights = np.polynomial.chebyshev.chebvander(np.array([(x - window.centre) / HALF_WIDTH]), NODES - 1)[0]
        modulus = np.array([1.0, states.bed.medium.modulus])[:, None, None]  # type: ignore[attr-defined]
        return np.asarray(np.exp(np.tensordot(weights, window.series, 1)) * self._homogeneous() * modulus)

    def _solved(self, centre: float) -> ModulusWindow:
        """Return the window around a modulus."""
        cheb = np.polynomial.chebyshev
        at, moduli = cheb.chebpts1(RADII), cheb.chebpts1(NODES)
        radii, profile = self._radii(at), self.profile
        ends = [self._medium(centre + far) for far in (-HALF_WIDTH, HALF_WIDTH)]
        count = max(nodes_for(end, float(radii.max())) for end in ends)
        rows = []
        for place in moduli.tolist():
            medium = self._medium(centre + HALF_WIDTH * place)
            depth, force = depth_and_force(medium, profile, radii.ravel(), count)
            alone = profile.gap(radii.ravel())
            whole = 2.0 * medium.modulus * (radii.ravel() * alone - profile.gap_integral(radii.ravel()))
            rows.append(np.log([depth / alone, force / whole]).reshape(2, *radii.shape))
        in_radius = np.array(rows) @ np.linalg.inv(cheb.chebvander(at, RADII - 1)).T
        share = np.square(self._edges[1:] / self._edges[-1])  # of the greatest depth
        self._is_used = float(np.max(np.abs(in_radius[..., -1]) * share)) < RESOLVED
        to_series = np.linalg.inv(cheb.chebvander(moduli, NODES - 1))
        return ModulusWindow(
            centre, np.tensordot(to_series, in_radius @ cheb.chebvander(panel_nodes()[0], RADII - 1).T, 1)
        )


def _radius_at(bed: Foundation, depth: float) -> float:
    """Return the radius [m] at which the profile alone has a depth [m], at most nearly its end."""
    from scipy.optimize import brentq

    widest = MOST_REACH * end_of(bed)
    if math.isinf(widest):
        return rough_root(bed.profile.gap, depth)
    if float(bed.profile.gap(np.array([widest]))[0]) <= depth:
        return widest
    return float(brentq(lambda a: float(bed.profile.gap(np.array([a]))[0]) - depth, 0.0, widest))
