"""The load of the springs of a contact that is pushed on a coating, and its traction."""

from __future__ import annotations

import numpy as np

from winkler.foundation.torsion_bound import TwistBound
from winkler.media.interior.twist_field import clean_slope
from winkler.media.layered import coated_load
from winkler.media.twisting.surface import summed_discs, table_rounding
from winkler.numerics.types import Array
from winkler.problems.friction.torsion_states import TwistedSprings
from winkler.problems.ring_slip.push_bound import push_bound, pushed_body
from winkler.values import value, words

__all__ = ["MovedSprings", "PushedSprings"]


@value
class PushedSprings(TwistedSprings):
    """The springs of a pushed contact: what `TwistedSprings` holds, h = G* u in place of 8 G_t phi."""

    @property
    def bound(self) -> TwistBound:
        """What they bear at most."""
        return push_bound(self.bed, self.coefficient, self.widest, self.forced)

    def displacement(self, r: Array) -> Array:
        """Return u_x(r) [m] of both surfaces together, inside and outside the contact."""
        body = pushed_body(self.bed)
        return coated_load.surface(MovedSprings(self, body.shear_modulus), body.tangential_response, r)

    def body(self, x: Array, y: Array, z: Array, *, below: bool) -> Array:
        """Return what the traction adds to the rows of `BodyFields` inside one body, ``(9, n)``.

        Parameters
        ----------
        x, y, z : ndarray, (n,)
            Places [m], z >= 0 into that body.
        below : bool
            Whether in the layers and their base, or in the other body, on which the traction acts to the other side.
        """
        body = pushed_body(self.bed)
        moved = MovedSprings(self, body.shear_modulus)
        with np.errstate(invalid="ignore"):  # stresses are infinite at an edge
            rows = body.pushed_interior(moved, x, y, z, below=below)
        return (1.0 if below else -1.0) * np.array(rows)

    def traction(self, r: Array) -> Array:
        """Return tau(r) [Pa] along the motion: rigidly pushed discs of all radii, superposed."""
        return summed_discs(pushed_body(self.bed).tangential_response, self, r)


@value
class MovedSprings:
    """How far the springs of a pushed contact are displaced along the surface.

    Parameters
    ----------
    springs : PushedSprings
    modulus : float
        G* [Pa].
    """

    __words__ = words(springs=("", None, "springs of a pushed contact"), modulus=("G^*", "Pa", "shear modulus"))

    springs: PushedSprings
    modulus: float

    @property
    def radius(self) -> float:
        """Contact radius [m]."""
        return self.springs.radius

    @property
    def edge(self) -> float:
        """u(a-) [m]; zero where the contact closes smoothly."""
        return self.springs.edge / self.modulus

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)``: just above x the slope of u holds -strength / sqrt(x^2 - x_kink^2)."""
        return tuple((x, strength / self.modulus) for x, strength in self.springs.kinks)

    def value(self, x: Array) -> Array:
        """u(x) [m] for 0 < x <= a."""
        return self.springs.value(x) / self.modulus

    def slope(self, x: Array) -> Array:
        """u'(x) [-] for 0 < x < a, without rounding near the axis, which would seem to be an apex."""
        return clean_slope(self.springs, table_rounding(self.springs.bound.logarithmic))(x) / self.modulus
