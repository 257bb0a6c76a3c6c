r"""Force over the position of a machine, for a contact without adhesion on a homogeneous half-space.

The force is the modulus times a function of the depth alone, :math:`F = E^*\varphi(d)`, so that one table of
:math:`\varphi` serves all moduli and machines.  It consists of polynomials on panels, some in each octave of the depth,
and of a power law below them; the panel of a depth follows from its exponent.  The radius is that of the stiffness,
:math:`a = \varphi'(d)/2`.

With the compliance c of the machine, the depth at a position D solves :math:`d + c\,E^*\varphi(d) = D`.  The left side
is convex, so that Newton's method converges from any start.
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from winkler.fitting.elastic.response import MachineResponse, ResponseValues
from winkler.numerics.types import Array

OCTAVES, IN_OCTAVE, DEGREE = 20, 8, 8
"""Octaves of the depth, panels in each, and degree of their polynomials."""
RESOLUTION = 1e-10
"""Greatest last coefficient of a panel relative to its values."""
MOST_STEPS = 60
SETTLED = 1e-7
"""Last but one step of Newton's method in parts of the depth; the next one is its square."""


class DepthTable(NamedTuple):
    """The force over the depth for one modulus.

    Parameters
    ----------
    edges, forces : ndarray, (panels + 1,)
        Depths at which panels begin and end [m], and F there [N].
    series : ndarray, (degree + 1, panels)
        Power series of F in the panel's own variable, from -1 to 1.
    exponent : float
        Of the power law below the first panel.
    """

    edges: Array
    forces: Array
    series: Array
    exponent: float

    def read(self, depth: Array) -> tuple[Array, Array]:
        """Return F [N] and dF/dd [N/m] at depths above zero."""
        lowest = float(self.edges[0])
        ratio = depth / lowest
        octave = np.minimum(np.maximum(np.frexp(ratio)[1] - 1, 0), OCTAVES - 1)
        share = (np.ldexp(ratio, -octave) - 1.0) * IN_OCTAVE
        inner = np.minimum(np.maximum(share.astype(int), 0), IN_OCTAVE - 1)
        t = 2.0 * (share - inner) - 1.0
        rows = self.series.take(octave * IN_OCTAVE + inner, axis=1)
        value, slope = rows[-1].copy(), np.zeros(depth.shape)
        for row in rows[-2::-1]:
            slope *= t
            slope += value
            value *= t
            value += row
        slope *= np.ldexp(2.0 * IN_OCTAVE / lowest, -octave)
        below = ratio < 1.0
        if below.any():
            value[below] = self.forces[0] * ratio[below] ** self.exponent
            slope[below] = self.exponent * value[below] / depth[below]
        return value, slope


class HomogeneousResponse(NamedTuple):
    """Response of a contact without adhesion to its machine, as that of `winkler.fitting.elastic.response`.

    Parameters
    ----------
    table : DepthTable
    share : float
        The modulus relative to that of the table.
    stiffness : float
        k(a)/a of the table's half-space [Pa].
    compliance : float
        Of the machine [m/N].
    """

    table: DepthTable
    share: float
    stiffness: float
    compliance: float

    def change(self, other: HomogeneousResponse, values: ResponseValues) -> Array:
        """Return by how much the forces of another modulus differ at the same positions, to first order [N].

        At the depth of this one the force differs by a part of itself, and the machine yields to it.
        """
        return np.asarray((other.share / self.share - 1.0) * values.force * (1.0 - self.compliance * values.slope))

    def least(self) -> float:
        """Return the least force [N]: nothing pulls."""
        return 0.0

    def loss(self) -> tuple[float, float]:
        """Return D [m] and F [N] where the contact ends."""
        return 0.0, 0.0

    def closing(self, position: Array) -> ResponseValues:
        """Return the response of an advancing contact."""
        return self.on(self.narrowest(position), position)

    def opening(self, position: Array, turn: float) -> ResponseValues:
        """Return the response of a receding contact, which is that of an advancing one."""
        return self.on(self.widest(position, turn), position)

    def narrowest(self, position: Array) -> Array:
        """Return the index of the branch: there is one."""
        return np.zeros(position.shape, dtype=int)

    def widest(self, position: Array, turn: float) -> Array:
        """Return the index of the branch of a receding contact: there is one."""
        del turn
        return self.narrowest(position)

    def on(self, which: Array, position: Array) -> ResponseValues:
        """Return the response; zero where nothing touches."""
        del which
        columns = np.zeros((4, position.size))
        touches = position > 0.0
        depth, yielding = position[touches], self.compliance * self.share
        if yielding:
            target, edges = depth, self.table.edges
            depth = np.interp(target, edges + yielding * self.table.forces, edges)
            small = target < edges[0] + yielding * self.table.forces[0]
            depth[small] = target[small]
            for _ in range(MOST_STEPS):
                force, rise = self.table.read(depth)
                step = (depth + yielding * force - target) / (1.0 + yielding * rise)
                depth = np.where(step < depth, depth - step, 0.5 * depth)
                if np.all(np.abs(step) <= SETTLED * depth):
                    break
        force, rise = self.table.read(depth)
        slope = self.share * rise / (1.0 + yielding * rise)
        columns[:, touches] = self.share * force, slope, rise / self.stiffness, np.ones(depth.shape)
        return ResponseValues(*columns)


@functools.lru_cache(maxsize=1)
def _panels() -> tuple[Array, Array, Array]:
    """Return nodes from -1 to 1, the matrix from values there to powers, and the panels' ends from 2^-OCTAVES to 1."""
    cheb = np.polynomial.chebyshev
    nodes, powers = cheb.chebpts1(DEGREE + 1), np.zeros((DEGREE + 1, DEGREE + 1))
    for k in range(DEGREE + 1):
        row = cheb.cheb2poly(np.eye(DEGREE + 1)[k])
        powers[k, : row.size] = row
    edges = (1.0 + np.arange(IN_OCTAVE) / IN_OCTAVE) * 2.0 ** np.arange(-OCTAVES, 0.0)[:, None]
    return nodes, np.linalg.inv(cheb.chebvander(nodes, DEGREE)).T @ powers, np.append(edges, 1.0)


def depth_table(whole: MachineResponse) -> DepthTable | None:
    """Return the table of a response without a machine; None where the force is not smooth over the depth.

    Parameters
    ----------
    whole : MachineResponse
        Of a contact without adhesion, from the surface to the end of its table.
    """
    if len(whole.table.pieces) != 1:
        return None
    nodes, to_powers, edges = _panels()
    edges = edges * float(whole.table.pieces[0].levels[-1])
    depth = 0.5 * (edges[:-1] + edges[1:])[:, None] + 0.5 * np.diff(edges)[:, None] * nodes
    places = np.append(depth.ravel(), edges)
    found = whole.on(np.zeros(places.shape, dtype=int), places)
    series, forces = found.force[: depth.size].reshape(depth.shape) @ to_powers, found.force[depth.size :]
    last = 0.5 ** (DEGREE - 1) * np.abs(series[:, -1])  # the coefficient of the last Chebyshev polynomial
    if np.any(last > RESOLUTION * np.maximum(forces[1:], 1e-9 * forces[-1])):
        return None
    exponent = float(found.slope[depth.size]) * float(edges[0]) / float(forces[0])
    return DepthTable(edges, forces, series.T.copy(), exponent)
