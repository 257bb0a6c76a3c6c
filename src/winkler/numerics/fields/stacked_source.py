"""The temperature of a layered body under a source of heat, round or elliptic, that it moves past."""

from __future__ import annotations

import dataclasses
import functools
import math

import numpy as np

from winkler.numerics.fields.elliptic_source import EllipticSource
from winkler.numerics.fields.layer_echo import LayerEcho, Stack
from winkler.numerics.fields.layered_source import echoed_points
from winkler.numerics.fields.line_source import LineSource, before_chords_end
from winkler.numerics.fields.source_tables import cosine_rule, powers
from winkler.numerics.fields.warmest_place import PeakTemperature, turned, warmest_place, warmest_within
from winkler.numerics.integrals.quadrature import growing, panel_nodes
from winkler.numerics.types import Array
from winkler.values.value import value

DIRECTION_NODES = 9
"""Of the rule on every piece of the quarter turn."""
FOLD_NODES = 10
ENDS = 61
"""Nodes of the double-exponential rule, where a load or a chord ends."""
LENGTH_RATIO = 4.0


@value
class StackedSource:
    """A source of heat on a layered body that moves past it.

    Parameters
    ----------
    source : LineSource or EllipticSource
        The source.
    stack : Stack
        The body.
    speed : float
        V [m/s]; negative if it moves backwards.
    direction : float
        Angle of the motion to x [rad].
    """

    source: LineSource | EllipticSource
    stack: Stack
    speed: float
    direction: float = 0.0

    @property
    def _wave(self) -> float:
        return self.speed / self.stack.diffusivities[0]

    @functools.cached_property
    def _rule(self) -> tuple[Array, Array]:
        """Directions from 0 to a quarter turn, and weights: finer where the motion has no part, and about the edge."""
        cuts = {0.0, 0.25 * math.pi, 0.5 * math.pi, *self.source.narrow_directions(self.direction)}
        a = self.source.ball.radius
        # long waves, which feel the whole stack, turn with the motion the closest to its normal
        layer = min(self.stack.diffusivities) / max(abs(self.speed) * a * max(2.0, self.stack.depth / a), 1e-300)
        cuts.update(0.5 * math.pi - away for away in growing(layer, 0.25 * math.pi, LENGTH_RATIO))
        cuts.update(growing(math.sqrt(self.stack.thicknesses[0] / a), 0.25 * math.pi, LENGTH_RATIO))
        return panel_nodes(np.array(sorted(cuts)), DIRECTION_NODES)

    def _echo(self, reach: float) -> LayerEcho:
        rates = abs(self.speed) * np.cos(self._rule[0])
        return LayerEcho(self.stack, self.source.ball.radius, rates, reach, round=True)

    @functools.cached_property
    def _widths(self) -> Array:
        """Half-widths of the line loads at either side of the motion, (2, directions), over the radius of the ball."""
        sides = np.stack([self.direction + self._rule[0], self.direction - self._rule[0]])
        return np.ascontiguousarray(self.source.half_width(sides) / self.source.ball.radius)

    @functools.cached_property
    def _inner(self) -> tuple[Array, Array]:
        """The echo within the contact: marks and rows."""
        echo = self._echo(2.0)
        return echo.marks, _powers(echo.rows)

    def surface(self, x: Array, y: Array) -> Array:
        """Return the temperature [K] under this source.

        Parameters
        ----------
        x, y : ndarray
            Places [m], of one shape.
        """
        ball, forth, (along, beside) = self.source.ball, math.copysign(1.0, self.speed), turned(x, y, -self.direction)
        flat, across = (np.ascontiguousarray(forth * np.ravel(place) / ball.radius) for place in (along, beside))
        farthest = float(np.max(np.hypot(flat, across), initial=0.0))
        if farthest <= 1.0:
            marks, rows = self._inner
        else:
            echo = self._echo(1.0 + farthest)
            marks, rows = echo.marks, _powers(echo.rows)
        added = np.empty(flat.size)
        echoed_points(flat, across, *self._rule, self._widths, ball.table, marks, rows, cosine_rule(FOLD_NODES), added)
        whole = self.source.surface(self._wave, x, y, self.direction) + ball.scale * added.reshape(np.shape(x))
        return np.asarray(whole / self.stack.conductivities[0])

    @functools.cached_property
    def peak(self) -> PeakTemperature:
        """The greatest temperature within the contact [K], and its place."""
        if not isinstance(self.source, LineSource):
            return warmest_within(self.surface, (self.source.along, self.source.across), rests=self.speed == 0.0)
        radius, fading = self.source.radius, self.source.fading
        if self.direction == 0.0:
            return warmest_place(self.surface, radius, fading, rests=self.speed == 0.0)
        return dataclasses.replace(self, direction=0.0).peak.turned(self.direction)

    @functools.cached_property
    def mean(self) -> float:
        """Mean temperature over the contact [K]."""
        echo, ball = self._echo(2.0), self.source.ball
        widths = np.unique(self._widths)
        along = np.zeros(self._widths.shape)
        if widths.size == 1:
            along[:] = self._folded(echo, 1.0)
        else:
            for side, j in np.ndindex(along.shape):
                one = dataclasses.replace(echo, rates=echo.rates[[j]])
                along[side, j] = self._folded(one, float(self._widths[side, j]))[0]
        added = float(np.sum(along @ self._rule[1])) / (2.0 * math.pi)
        whole = self.source.mean(self._wave, self.direction) + ball.scale * added
        return whole / self.stack.conductivities[0]

    def _folded(self, echo: LayerEcho, width: float) -> Array:
        """Return the mean of what the echoes add to line loads of a width, (directions,), over the scale of q."""
        marks = np.array([*(mark for mark in echo.marks / width if mark < 2.0), 2.0])
        places, shares = panel_nodes(marks, FOLD_NODES)
        return np.asarray((echo.at(width * places) + echo.at(-width * places)) @ (self._overlap(places) * shares))

    def _overlap(self, z: Array) -> Array:
        """Return the integrals (n,) of q(t) and the chord of the disc at t + z, over its area and the scale of q."""
        source = self.source.ball
        t, ahead, share = before_chords_end(z, source.joints, ENDS)
        chord = 2.0 / math.pi * np.sqrt(np.maximum(ahead * (1.0 + t + z[:, None, None]), 0.0))
        load = source.load(source.radius * t.ravel()).reshape(t.shape) / source.scale
        return np.asarray(np.sum(load * chord * share, axis=(1, 2)))


def _powers(rows: Array) -> Array:
    """Return Chebyshev coefficients (..., n) in powers, as the kernels take them."""
    flat = powers(rows.reshape(-1, rows.shape[-1]))
    return np.ascontiguousarray(flat.reshape(*rows.shape[:-1], flat.shape[-1]))
