r"""Contacts that are let go, many at once: each is elastic on the dent that its own greatest load has left.

With :math:`x = a\sin\varphi` in a dent of the radius a the depth and the force are smooth in :math:`\varphi` up to its
edge, where the slope over x is infinite.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.on_medium import UnderProfile
from winkler.numerics.equations.roots import invert
from winkler.numerics.types import Array
from winkler.problems.plastic.dent import dimple_integral
from winkler.problems.plastic.first_loading import GreatestLoad, integral_of_square

EDGE = 0.5 * math.pi
INSIDE = 1.0 - 1e-12


class Release(NamedTuple):
    """The springs that greatest loads have left.

    Parameters
    ----------
    bed : Foundation or EllipticFoundation
        The bed before it yielded.
    greatest : GreatestLoad
        The loads, all of bodies that have yielded.
    """

    bed: UnderProfile
    greatest: GreatestLoad

    def _parts(self, index: Array) -> tuple[Array, Array, Array]:
        """Return radii of the dents, the part of the profile in each, and the depth of its dimple [m]."""
        load = self.greatest
        radius, recovery, share = load.radius[index], load.recovery[index], load.elastic_share[index]
        return radius, recovery * share / self.bed.gap(radius), recovery * (1.0 - share)

    def at(self, level: Array, index: Array, *, by_force: bool) -> tuple[Array, Array]:
        """Return depths from where the bodies just touch [m], and contact radii [m].

        Parameters
        ----------
        level : ndarray, (n,)
            Depths [m], from there, or forces [N], not above the greatest; no contact where they are not positive.
        index : ndarray of int, (n,)
            Which of the greatest loads each of them follows.
        """
        depth, radius = level.copy(), np.zeros_like(level)
        if by_force:
            depth[:] = 0.0
        pressed = level > 0.0
        if not pressed.any():
            return depth, radius
        level, index = level[pressed], index[pressed]
        edge, profile, dimple = self._parts(index)
        bed = self.bed

        def with_slope(angle: Array) -> tuple[Array, Array]:
            x = edge * np.sin(angle)
            value = self._gap(x, angle, profile, dimple)
            slope = profile * bed.gap_slope(x) * edge * np.cos(angle) + dimple * np.sin(angle)
            if not by_force:
                return value, slope
            stiffness = bed.stiffness(x)
            return stiffness * value - self._gap_load(x, edge, profile, dimple), stiffness * slope

        load = self.greatest
        most = load.force[index] if by_force else load.recovery[index]
        share = np.clip(level / most, 0.0, 1.0) ** (1.0 / 3.0 if by_force else 0.5)
        guess = np.minimum(np.arcsin(share), INSIDE * EDGE)
        angle = invert(with_slope, level, lower=0.0, upper=EDGE, guess=guess)
        radius[pressed] = edge * np.sin(angle)
        if by_force:
            x = radius[pressed]
            depth[pressed] = (level + self._gap_load(x, edge, profile, dimple)) / bed.stiffness(x)
        return depth, radius

    def _gap(self, x: Array, angle: Array, profile: Array, dimple: Array) -> Array:
        return np.asarray(profile * self.bed.gap(x) + 2.0 * dimple * np.sin(0.5 * angle) ** 2)

    def _gap_load(self, x: Array, edge: Array, profile: Array, dimple: Array) -> Array:
        along = edge * dimple * dimple_integral(np.minimum(x / edge, 1.0))
        return np.asarray(profile * self.bed.gap_load(x) + self.bed.stiffness(x) / x * along)

    def force(self, depth: Array, radius: Array, index: Array) -> Array:
        """Return the forces [N] at depths from where the bodies just touch and contact radii [m] `(n,)`."""
        force = np.zeros_like(depth)
        pressed = radius > 0.0
        x = radius[pressed]
        force[pressed] = self.bed.stiffness(x) * depth[pressed] - self._gap_load(x, *self._parts(index[pressed]))
        return force

    def energy(self, depth: Array, radius: Array, index: Array) -> Array:
        """Return the elastic energies [J] there."""
        energy = np.zeros_like(depth)
        pressed = radius > 0.0
        d, a, here = depth[pressed], radius[pressed], index[pressed]
        edge, profile, dimple = self._parts(here)

        def gap(x: Array, row: Array) -> Array:
            y = np.minimum((x / edge[row]) ** 2, 1.0)
            return np.asarray(profile[row] * self.bed.gap(x) + dimple[row] * y / (1.0 + np.sqrt(1.0 - y)))

        squares = integral_of_square(gap, self.bed, edge, a)
        modulus = self.bed.medium.modulus  # type: ignore[attr-defined]
        energy[pressed] = modulus * (d * d * a + squares) - d * self._gap_load(a, edge, profile, dimple)
        return energy
