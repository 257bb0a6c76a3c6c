r"""A contact that is pushed on layers or a grading, followed ring by ring: its springs, its states, their notes.

On a homogeneous half-space a stuck contact drags with the same distribution as a flat punch presses, so that the
difference of two normal contacts solves partial slip (Cattaneo, Mindlin, Jaeger, Ciavarella).  Layers answer to shear
otherwise than to pressure, and that rule fails.  What holds are springs of another weight and another bound
(`winkler.problems.ring_slip.push_bound`): a ring that slides bears :math:`\mu p(r)`, one that sticks follows the body.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.sheared_fields import BodyFields, ShearedFields, body_of_pressed, body_under
from winkler.laws.friction import Coulomb
from winkler.loading.path import Path
from winkler.media.interior.twist_field import clean_slope
from winkler.media.layered import coated_load
from winkler.media.medium import Medium
from winkler.media.twisting.surface import summed_discs, table_rounding
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.normal.validity import indentation_notes
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.problems.ring_slip.push_bound import push_bound, pushed_body
from winkler.problems.ring_slip.push_notes import push_note, tables_note
from winkler.problems.ring_slip.ring_notes import ring_notes
from winkler.problems.ring_slip.ring_path import ring_points
from winkler.problems.ring_slip.ring_states import RingState, TwistedSprings
from winkler.problems.round_march import RoundSlip
from winkler.values.validity import Note
from winkler.values.value import value, words

PATH_SAMPLES, RADIUS_SAMPLES = 6, 25
"""At so many states of a path the traction is examined, at so many radii."""


@value
class PushedSprings(TwistedSprings):
    """The springs of a pushed contact: what `TwistedSprings` holds, h = G* u in place of 8 G_t phi."""

    bound_of = staticmethod(push_bound)

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


@value
class PushedState(RingState, RoundSlip[float]):
    """A pushed contact on layers, or a grading, at one moment; its numbers are those of `RoundSlip` and `RingState`.

    Parameters
    ----------
    stick_radius : float
        c [m]: rings within stick; a where all do, zero where the bodies slide or are apart.
    """

    stick_radius: float
    springs: PushedSprings

    def slip(self, r: ArrayLike) -> Array:
        """Return how far the surfaces stand displaced against each other [m], mean over the circle.

        Where they have touched all the time that is how far they have slipped.

        Parameters
        ----------
        r : array_like
            Distance from the axis [m], not negative.
        """
        r = np.asarray(r, dtype=float)
        return self.shift - (np.zeros(r.shape) if self._still else self.springs.displacement(r))

    @property
    def _still(self) -> bool:
        """Whether nothing acts along the surface."""
        return self.radius == 0.0 or (self.shear_force == 0.0 and self.shift == 0.0)

    @property
    def medium(self) -> Medium:
        """The bodies."""
        return self.springs.bed.medium

    def sharp_places(self) -> tuple[float, ...]:
        """Return distances from the axis at which stresses on the surface are infinite [m]."""
        springs = self._pressed, self.springs
        kinks = [b for part in springs for b, strength in part.kinks if strength != 0.0]
        return (*kinks, *([self.radius] if any(part.edge != 0.0 for part in springs) else []))

    def surface_fields(self, r: Array) -> ShearedFields:
        """Return pressure, traction, displacement along the surface and slip (`winkler.restore`).

        Parameters
        ----------
        r : ndarray
            Distance from the axis [m], not negative.
        """
        pressed, slip = self._pressed, self.slip(r)
        pressure = pressed.bed.medium.pressure(pressed, r) if self.radius > 0.0 else np.zeros(r.shape)
        return ShearedFields(r, pressure, self.traction(r), self.shift - slip, slip)

    def body_fields(self, x: Array, y: Array, z: Array) -> BodyFields:
        """Return stresses and displacements under pressure and traction (`winkler.restore_body`).

        Parameters
        ----------
        x, y, z : ndarray
            Places [m]; z > 0 in the layers and their base, z < 0 in the other body.

        Raises
        ------
        OutsideValidity
            If the body there is rigid, or stresses in this medium are not known.
        """
        if self._still:
            return body_of_pressed(self._pressed, x, y, z)
        return body_under(self._pressed, self.springs.body, x, y, z)


def pushed_states(bed: Bed, coefficient: float, path: Path) -> Iterator[PushedState]:
    """Yield the contact at every point of a path along one line.

    Parameters
    ----------
    bed : Bed
        Its medium one of `winkler.problems.ring_slip.push_bound.layers_of_rings`.
    coefficient : float
        mu [-].
    path : Path

    Raises
    ------
    OutsideValidity
        If friction does not bear a prescribed shear force, at that step, or the contact is too wide against the
        uppermost layer.
    NotConverged
        If a step is too long for the shift or the loss to settle.
    """
    for normal, at, _, springs in ring_points(bed, coefficient, path, pushed_body(bed).shear_modulus, PushedSprings):
        energies = at.work, at.stored, at.lost
        yield PushedState(*normal, at.motion, at.load, *energies, at.nested, springs, at.stick_radius)


def pushed_notes(bed: Bed, law: Coulomb, states: Sequence[PushedState], by_force: bool) -> Iterator[Note]:
    """Yield how far a path of states can be trusted.

    Parameters
    ----------
    bed : Bed
    law : Coulomb
    states : sequence of PushedState
    by_force : bool
        Whether the shear force is prescribed and the shift computed.
    """
    depth, radius = (np.array([getattr(state, word) for state in states]) for word in ("depth", "radius"))
    yield from indentation_notes(bed, depth, radius, SurfaceFriction(law.coefficient))
    yield sticking_note(bed.medium, law.coefficient)
    yield push_note(bed, float(np.max(radius)))
    bound = states[0].springs.bound
    yield from tables_note(bound)
    pressed = [index for index, state in enumerate(states) if state.radius > 0.0 and state.shear_force != 0.0]
    examined = pressed[:: max(1, -(-len(pressed) // PATH_SAMPLES))]
    words = ("shift", "shear force")
    yield from ring_notes(bed, law.coefficient, states, examined, RADIUS_SAMPLES, words, by_force, bound.logarithmic)
