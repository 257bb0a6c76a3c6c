r"""Jaeger's superposition: a round contact as a staircase of flat punches of growing radius.

A flat punch of radius b that sinks by :math:`\delta` has the closed form

.. math:: p = \frac{E^*\,\delta}{\pi\sqrt{b^2-r^2}}\ (r<b), \qquad u = \frac{2\delta}{\pi}\arcsin\frac br\ (r>b),
          \qquad F = 2E^*b\,\delta .

Pressing a body in is pressing one such punch after the other, each a little wider: the increment dg = g'(x) dx of the
depth belongs to the punch of radius x.  Where `winkler.fields.restoration.restore` evaluates the integral
over all punches, the staircase adds up finitely many of them; it uses no Abel transforms, and so it is an independent
check of pressure and displacement, and the shortest explanation why independent springs can be exact.

References
----------
J. Jaeger, Arch. Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661
"""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.answer import Restorable
from winkler.values.checks.number_checks import Whole, checked
from winkler.values.checks.outline import refuse_unless_round
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.value import value, words

PAIRS_PER_CHUNK = 1 << 20
"""Largest number of pairs of places and punches at once."""


@value
class Staircase:
    """A stack of flat punches of increasing radius with the pressure of the body.

    Parameters
    ----------
    radii : ndarray, (n,)
        Of the punches [m], ascending.
    increments : ndarray, (n,)
        Depth of each punch [m].
    modulus : float
        Effective modulus E* of the medium [Pa].
    pressed : PressedSprings
        The springs of the contact.
    """

    __words__ = words(radii=("b", "m", "radii of the punches"), increments=(r"\Delta g", "m", "depth of each punch"))

    radii: Array
    increments: Array
    modulus: float
    pressed: PressedSprings

    @property
    def depth(self) -> float:
        """Depth d [m]: the sum of all increments."""
        return float(np.sum(self.increments))

    @property
    def force(self) -> float:
        """The sum of the punches' forces, 2 E* b delta each [N]."""
        return float(2.0 * self.modulus * np.sum(self.radii * self.increments))

    def pressure(self, r: ArrayLike) -> Array:
        """Return the pressure of all punches together.

        Parameters
        ----------
        r : array_like
            Distances from the axis [m], not negative.

        Returns
        -------
        ndarray
            p [Pa]; infinite at the edge of every punch.  Between the edges the error of the pressure falls as
            1/sqrt(count). At 0.3027 of a step below an edge, where the Hurwitz zeta function of order 1/2 vanishes, it
            falls as count^(-3/2).
        """

        def kernel(r: Array, b: Array) -> Array:
            inside = r < b
            root = np.sqrt(np.where(inside, (b - r) * (b + r), 1.0))
            return np.where(inside, 1.0 / root, np.where(r == b, np.inf, 0.0))

        return self.modulus / np.pi * self._sum(kernel, r)

    def displacement(self, r: ArrayLike) -> Array:
        """Return the displacement of the surface under all punches together.

        Parameters
        ----------
        r : array_like
            Distances from the axis [m], not negative.

        Returns
        -------
        ndarray
            u_z [m], into the bodies positive; its error falls as 1/count^2 outside the contact, as count^(-3/2) inside.
        """

        def kernel(r: Array, b: Array) -> Array:
            outside = r > b
            return np.where(
                outside, 2.0 / np.pi * np.arcsin(np.where(outside, b, 1.0) / np.where(outside, r, 1.0)), 1.0
            )

        return self._sum(kernel, r)

    def force_within(self, r: ArrayLike) -> Array:
        """Return the force within a circle: the integral of the pressure over its area.

        Parameters
        ----------
        r : array_like
            Radius of the circle [m], not negative.

        Returns
        -------
        ndarray
            [N].
        """

        def kernel(r: Array, b: Array) -> Array:
            c: Array = np.minimum(r, b)
            return np.asarray(c * c / (b + np.sqrt((b - c) * (b + c))))

        return 2.0 * self.modulus * self._sum(kernel, r)

    def _sum(self, kernel: Callable[[Array, Array], Array], r: ArrayLike) -> Array:
        places = np.asarray(r, dtype=float)
        if not np.all(np.isfinite(places) & (places >= 0.0)):
            raise InvalidInput(
                "staircase: r holds values that are negative or not finite; give distances from the axis in m."
            )
        flat = places.ravel()
        block = max(1, PAIRS_PER_CHUNK // max(1, self.radii.size))
        parts = [
            kernel(flat[start : start + block, None], self.radii[None, :]) @ self.increments
            for start in range(0, flat.size, block)
        ]
        return np.concatenate(parts).reshape(places.shape) if parts else np.zeros(places.shape)


def staircase(solution: Restorable, count: int) -> Staircase:
    """Return the stack of flat punches whose sum gives the contact.

    Parameters
    ----------
    solution
        The solution of a problem, for one load, on a homogeneous half-space.
    count : int
        Number of punches along the shape of the body; one more represents the flat end of a body pinned at its rim.
        The depth is exact; the errors of force and outside displacement are proportional to 1/count^2.

    Returns
    -------
    Staircase

    Raises
    ------
    InvalidInput
        If the count is no positive whole number, or smaller than the number of pieces the shape consists of.
    OutsideValidity
        If flat punches have no closed form on this medium.

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.loading.loads import Radius
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.problems.normal.indentation import Indentation
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), HalfSpace(Elastic(1.0, 0.0)))
    >>> contact = Indentation(bed, Radius(0.5)).solve()
    >>> round(contact.force, 9), round(staircase(contact, 10).force, 9), round(staircase(contact, 100).force, 9)
    (0.166666667, 0.16625, 0.1666625)
    """
    count = checked(Whole(1, 1_000_000, "punches"), "staircase", "count", count)
    pressed = solution.pressed
    refuse_unless_round(pressed, "staircase", "a staircase of punches")
    medium = pressed.bed.medium
    if not isinstance(medium, HomogeneousMedium):
        raise OutsideValidity(
            f"staircase: flat punches have no closed form on a {type(medium).__name__}; use a homogeneous half-space."
        )
    edges = _treads(pressed, count)
    g = np.asarray(pressed.bed.gap(edges), dtype=float) if edges.size else np.zeros(0)
    radii, increments = 0.5 * (edges[1:] + edges[:-1]), np.diff(g)
    if pressed.edge != 0.0:
        radii, increments = np.append(radii, pressed.radius), np.append(increments, pressed.edge)
    rising = increments != 0.0
    return Staircase(radii[rising], increments[rising], medium.modulus, pressed)


def _treads(pressed: PressedSprings, count: int) -> Array:
    """Return the radii between which the punches stand; beyond a kink s even in sqrt(x^2 - s^2), where g is smooth."""
    a = pressed.radius
    if a == 0.0:
        return np.zeros(0)
    bounds = np.unique([0.0, *(b for b, strength in pressed.kinks if strength != 0.0), a])
    pieces = [
        (low, high)
        for low, high in itertools.pairwise(bounds)
        if np.ptp(pressed.bed.gap(np.linspace(low, high, 9))) > 0.0
    ]
    if count < len(pieces):
        raise InvalidInput(
            f"staircase: count is {count}, but the shape has {len(pieces)} pieces between its kinks; give at least one "
            "punch for each."
        )
    if not pieces:
        return np.zeros(0)
    widths = np.array([high - low for low, high in pieces])
    shares = np.maximum(1, np.floor(count * widths / widths.sum()).astype(int))
    while shares.sum() > count:
        shares[np.argmax(shares)] -= 1
    while shares.sum() < count:
        shares[np.argmax(widths / shares)] += 1
    edges = [
        np.sqrt(low * low + (high - low) * (high + low) * np.linspace(0.0, 1.0, share + 1) ** 2)
        for (low, high), share in zip(pieces, shares, strict=True)
    ]
    for part, (low, high) in zip(edges, pieces, strict=True):
        part[0], part[-1] = low, high
    return np.unique(np.concatenate(edges))
