r"""A line contact of bodies that relax at one moment: pressure, and how far the bodies have come together.

The strips that make up the pressure of an elastic contact, each with the pressure of a flat punch, relax one by one:

.. math:: p(x,t) = \frac1\pi\int_{|x|}^a\frac{m(c,t)}{\sqrt{c^2-x^2}}\,\mathrm dc , \qquad
          m = -\frac{\partial q}{\partial c} , \qquad \int C\,\mathrm dm = -\frac{\partial u}{\partial c} .

q(c) is what the strips wider than c bear, and u(c) its hereditary integral with the creep.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.numerics.chunks import chunks
from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.line.approach import Place
from winkler.problems.line.peak_pressure import peak_pressure
from winkler.problems.line.pressing_load import OfWidth
from winkler.problems.line.stress import Strip
from winkler.problems.line_viscoelastic.layered_strips import (
    elastic_line,
    layered_pressure,
    shares_of,
)
from winkler.problems.line_viscoelastic.sinking import approach_of_strips
from winkler.values.checks.place_checks import finite_places
from winkler.values.value import value, words

BLOCK = 2**20
"""Pairs of places and strips in one go."""


@value
class LineViscoelasticState(OfWidth[float]):
    """A line contact of bodies that relax at one moment.

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
        Profile and bodies.
    time : float
        [s].
    force_per_length, half_width : float
        P [N/m], a [m].
    crept_load : float
        Hereditary integral of creep function and force per length [m]; it equals w(a) while the strip grows.  For
        layers with separate relaxation functions, the creep function is that of the uppermost layer.
    edge_load : float
        What the edge bears like that of a flat punch [N/m]: at a rim, or where a dashpot alongside is caught.
    position : ndarray, (n,)
        Half-widths c of flat strips [m].
    line_load : ndarray, (n,)
        What wider strips bear [N/m], zero outside of the contact.
    recess : ndarray, (n,)
        Hereditary integral of creep and what wider strips have borne [m].
    """

    __words__ = words(
        edge_load=("", "N/m", "load at the edge, as of a flat punch"),
        position=("c", "m", "half-widths of the flat strips that make up the pressure"),
        line_load=("q", "N/m", "load on wider strips"),
        recess=("u", "m", "hereditary integral of creep function and load on wider strips"),
    )

    bed: LineFoundation | LayeredLineFoundation
    time: float
    force_per_length: float
    half_width: float
    crept_load: float
    edge_load: float
    position: Array
    line_load: Array
    recess: Array

    @property
    def peak_pressure(self) -> float:
        """The greatest pressure [Pa], zero without contact.

        Infinite at a sharp tip, kink or rim, and at the edge of a strip that widens on a dashpot alongside.
        """
        return peak_pressure(self.bed, Strip(self.half_width, self.edge_load), self._pressures())

    def pressure(self, x: ArrayLike) -> Array:
        """Return the pressure [Pa], zero outside of the contact.

        Parameters
        ----------
        x : array_like
            Places on the surface [m], on either side of the middle.
        """
        places = np.abs(finite_places("LineViscoelasticState.pressure", "x", x))
        return self._pressures()(places)

    def _pressures(self) -> Callable[[Array], Array]:
        """Return the pressure over places that are not negative, with all prepared that is the same at each."""
        if self.half_width == 0.0:
            return np.zeros_like
        edges, borne = self._strips
        line = elastic_line(self.bed)
        loads, edge_load = -np.diff(borne), self.edge_load
        added: Callable[[Array], Array] = np.zeros_like
        if isinstance(line, LayeredLineFoundation) and not offers(self.bed.medium, RelaxingByWaves):
            shares, edge_load = shares_of(line, edges, borne), 0.0
            loads = line.medium.modulus * shares * np.diff(line.half_plane.load_profile(edges))
            added = layered_pressure(line, edges, shares, self.edge_load)
        densities = self._densities(edges, loads)

        def pressures(places: Array) -> Array:
            flat, found = places.ravel(), np.empty(places.size)
            for part in chunks(flat.size, edges.size, BLOCK):
                found[part] = self._pressure(flat[part], edges, densities, edge_load) + added(flat[part])
            return found.reshape(places.shape)

        return pressures

    def _pressure(self, x: Array, edges: Array, densities: tuple[Array, Array], edge_load: float) -> Array:
        """Sum the strips between edges, whose load density is that of the profile times what is left of it."""
        middle, steep = densities
        inside = x[:, None] < edges
        roots = np.where(inside, root_difference(np.maximum(edges, x[:, None]), x[:, None]), 0.0)
        total = np.diff(roots, axis=1) @ steep
        if np.any(middle):
            with np.errstate(divide="ignore"):
                logs = np.log(np.maximum(edges, x[:, None]) + roots)
            steps = np.where(middle != 0.0, np.diff(logs, axis=1), 0.0)
            total = total + np.where(middle != 0.0, steps * middle, 0.0).sum(axis=1)
        if edge_load > 0.0:
            with np.errstate(divide="ignore"):
                total = total + np.where(x <= self.half_width, edge_load / roots[:, -1], 0.0)
        return np.asarray(total / np.pi)

    def _densities(self, edges: Array, loads: Array) -> tuple[Array, Array]:
        """Return A [N/m^2] and B [N/m^3] of the load densities A + B c between edges, as straight as w' there."""
        low, high = edges[:-1], edges[1:]
        rise = self.bed.half_plane.load_profile_slope(edges)
        known = np.isfinite(rise[:-1]) & np.isfinite(rise[1:]) & (rise[:-1] + rise[1:] > 0.0)
        first, last = np.where(known, rise[:-1], 1.0), np.where(known, rise[1:], 1.0)
        factor = loads / (0.5 * (first + last) * (high - low))
        steep = (last - first) / (high - low)
        return factor * (first - steep * low), factor * steep

    @property
    def _strips(self) -> tuple[Array, Array]:
        """Half-widths up to the edge, and what wider strips bear there [N/m]."""
        inside = (self.position < self.half_width) & (self.line_load > self.edge_load)
        c, q = self.position[inside], self.line_load[inside]
        return np.append(c, self.half_width), np.append(q, self.edge_load)

    def approach(self, first: Place = None, second: Place = None) -> float:
        """Return the approach of two points on the axis since the beginning [m], one in each body.

        Parameters
        ----------
        first, second : float, RollerCentre or PlateBase
            Depths of the points below the surfaces of half-planes or layers [m], or finite bodies; that in a rigid
            body, and below layers on a rigid base, may be left out.

        Raises
        ------
        InvalidInput
            If a reference point is missing: the approach of a line contact depends on the reference points.
        OutsideValidity
            If the strip is wider than a fifth of a finite body, or bodies or layers relax, and not in proportion.
        """
        strips = self.position, self.line_load[None], self.recess[None]
        return float(approach_of_strips(self.bed, self.half_width, strips, (first, second))[0])
