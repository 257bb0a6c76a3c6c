r"""Restoring the body from the springs: pressure and displacement of the surface, stresses below it.

``restore(solution, r)`` gives the fields on the surface, ``restore(solution, r, z)`` those below it; both work on any
solution that holds the displacement of its springs.  Of a sheared contact `restore` gives traction and slip on the
surface; the field below it is not symmetric about the axis any more, and ``restore_body(solution, x, y, z)`` gives it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeGuard, overload

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.foundation.sheared import ShearedSprings
from winkler.foundation.sheared_fields import (
    BodyFields,
    ShearedFields,
    body_of_pressed,
    body_of_sheared,
    sheared_surface,
    shift_of_surface,
)
from winkler.media.interior.stress import max_shear, principal, von_mises
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.answer import Dragged, Restorable, SelfRestoring, is_dragged, is_restorable, is_self_restoring
from winkler.values.checks.contract import is_a
from winkler.values.checks.float_range import guarded_result
from winkler.values.checks.outline import refuse_unless_round
from winkler.values.checks.place_checks import common_places, finite_places
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

if TYPE_CHECKING:
    from winkler.problems.friction.torsion_fields import TwistedFields
    from winkler.problems.friction.torsion_states import TorsionState

FIELD_ADVICE = "the field"


@value
class SurfaceFields:
    """Pressure, displacement and gap of the surface at distances r from the axis.

    Parameters
    ----------
    r : ndarray
        [m].
    pressure : ndarray
        p [Pa], compression positive, zero outside the contact; infinite at a sharp edge, kink or apex.
    displacement : ndarray
        u_z [m], of both surfaces together, into the bodies positive.
    gap : ndarray
        Distance of the deformed surfaces [m]: zero in contact; infinite beyond the reach of the profile.
    """

    __words__ = words(gap=("h", "m", "distance of the deformed surfaces"))

    r: Array
    pressure: Array
    displacement: Array
    gap: Array


@value
class SubsurfaceFields:
    """Stresses and displacements inside one body, in its own axes: r outward, z into the body.

    Parameters
    ----------
    r, z : ndarray
        Coordinates [m]; z as requested: positive in the first body, negative in the second.
    radial_stress, hoop_stress, axial_stress, shear_stress : ndarray
        [Pa], tension positive; shear in the planes that contain the axis.
    radial_displacement, axial_displacement : ndarray
        Of this body alone [m], outward and into the body positive.
    """

    r: Array
    z: Array
    radial_stress: Array
    hoop_stress: Array
    axial_stress: Array
    shear_stress: Array
    radial_displacement: Array
    axial_displacement: Array

    @property
    def von_mises(self) -> Array:
        """Equivalent stress after von Mises [Pa]."""
        return von_mises(self.radial_stress, self.hoop_stress, self.axial_stress, self.shear_stress)

    @property
    def principal(self) -> Array:
        """Principal stresses [Pa], largest first, along a last axis of length 3."""
        return principal(self.radial_stress, self.hoop_stress, self.axial_stress, self.shear_stress)

    @property
    def max_shear(self) -> Array:
        """Maximum shear stress [Pa]."""
        return max_shear(self.radial_stress, self.hoop_stress, self.axial_stress, self.shear_stress)


@overload
def restore(solution: Restorable, r: ArrayLike) -> SurfaceFields: ...
@overload
def restore(solution: Restorable, r: ArrayLike, z: ArrayLike) -> SubsurfaceFields: ...
@overload
def restore(solution: Dragged | SelfRestoring, r: ArrayLike) -> ShearedFields: ...
@overload
def restore(solution: TorsionState, r: ArrayLike) -> TwistedFields: ...
@guarded_result
def restore(
    solution: Restorable | Dragged | SelfRestoring | TorsionState, r: ArrayLike, z: ArrayLike | None = None
) -> SurfaceFields | SubsurfaceFields | ShearedFields | TwistedFields:
    """Return the three-dimensional fields of a contact.

    Parameters
    ----------
    solution
        The solution of a problem, for one load.
    r : array_like
        Distances from the axis [m], not negative.
    z : array_like, optional
        Depths below the surface [m], broadcast against r: positive in the first body, negative in the second, zero
        just below the surface of the first. Without it the fields on the surface are returned.

    Returns
    -------
    SurfaceFields, SubsurfaceFields, ShearedFields or TwistedFields
        The last two on the surface of a sheared or twisted contact.

    Raises
    ------
    InvalidInput
        If r is negative or not finite, if r and z do not fit each other, the solution holds many loads, or z is given
        for a sheared or twisted contact.
    OutsideValidity
        If the field below the surface is not known for this medium, or the body there is rigid.
    """
    radii = finite_places("restore", "r", r)
    if z is not None:
        common_places("restore", r=r, z=z)
    if np.any(radii < 0.0):
        raise InvalidInput(f"restore: r = {np.min(radii):.6g} m is negative; distances from the axis are positive.")
    if is_self_restoring(solution) or is_dragged(solution) or is_twisted(solution):
        if z is not None:
            raise InvalidInput(
                "restore: below a sheared or twisted contact the stress has all six components; use "
                "restore_body(solution, x, y, z)."
            )
        if is_twisted(solution):
            from winkler.problems.friction.torsion_fields import twisted_surface

            return twisted_surface(solution, radii)
        if is_dragged(solution):
            refuse_unless_round(solution.sheared.pressed, "restore", FIELD_ADVICE)
            return sheared_surface(solution.sheared, radii)
        assert is_self_restoring(solution)
        return solution.surface_fields(radii)
    pressed = springs_of(solution)
    return _surface(pressed, radii) if z is None else below_surface(pressed, radii, finite_places("restore", "z", z))


@guarded_result
def restore_body(
    solution: Restorable | Dragged | SelfRestoring | TorsionState, x: ArrayLike, y: ArrayLike, z: ArrayLike
) -> BodyFields:
    """Return stresses and displacements inside the bodies, in the axes x, y, z.

    Parameters
    ----------
    solution
        The solution of a problem, for one load; sheared, twisted or neither.
    x, y, z : array_like
        Places [m], broadcast against each other: x along the first component of a shear force, z positive in the first
        body, negative in the second, zero just below the surface of the first.

    Returns
    -------
    BodyFields

    Raises
    ------
    InvalidInput
        If a place is not finite, or the solution holds many loads; if a place lies on a twisted surface.
    OutsideValidity
        If the body is rigid, or the field is not implemented for this medium. Fields of tractions are implemented for
        a `HalfSpace`, and with annular elements for bonded layers.

    Notes
    -----
    The traction is that of the springs and acts along x everywhere; the stresses due to this traction are exact. The
    predicted slip is exact on half-spaces with nu = 0; otherwise the displacement perpendicular to the load is
    neglected.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sections 3.6 and 7.2, doi:10.1017/CBO9781139171731
    """
    places = common_places("restore_body", x=x, y=y, z=z)
    if is_twisted(solution):
        from winkler.problems.friction.torsion_fields import body_of_twisted

        return body_of_twisted(solution, *places)
    if is_self_restoring(solution):
        return solution.body_fields(*places)
    springs = solution.sheared if is_dragged(solution) else springs_of(solution)
    if isinstance(springs, ShearedSprings):
        refuse_unless_round(springs.pressed, "restore_body", FIELD_ADVICE)
        return body_of_sheared(springs, *places)
    refuse_unless_round(springs, "restore_body", FIELD_ADVICE)
    return body_of_pressed(springs, *places)


@guarded_result
def restore_shift(solution: Dragged, x: ArrayLike, y: ArrayLike) -> Array:
    """Return the tangential surface displacement of a sheared contact, summed over both bodies.

    Parameters
    ----------
    solution
        The solution of a problem with a tangential load, at one point of its path.
    x, y : array_like
        Positions on the surface [m].

    Returns
    -------
    ndarray, (..., 2)
        u_x and u_y [m].  For Poisson's ratios above zero the displacements depend on the direction; only their mean
        over each circle equals that of the springs.

    Raises
    ------
    InvalidInput
        If a place is not finite, or the solution has no tangential load.
    OutsideValidity
        If the medium is not a homogeneous isotropic half-space.
    """
    places = common_places("restore_shift", x=x, y=y)
    if not is_dragged(solution):
        raise InvalidInput(
            f"restore_shift: a {type(solution).__name__} has no tangential displacement of the surfaces; give the "
            "solution of a problem with a tangential load, at one point of its path."
        )
    refuse_unless_round(solution.sheared.pressed, "restore_shift", FIELD_ADVICE)
    return shift_of_surface(solution.sheared, *places)


def is_twisted(solution: Any) -> TypeGuard[TorsionState]:
    """Return whether a solution is a state of a twisted contact."""
    return is_a(solution, "winkler.problems.friction.torsion_states:TorsionState")


def springs_of(solution: Restorable | Dragged | SelfRestoring | TorsionState) -> PressedSprings:
    """Return the springs of a solution; refuse what holds none, or many loads."""
    if not is_restorable(solution):
        raise InvalidInput(
            f"restore: a {type(solution).__name__} holds no springs; give a solution for one load, or one state of a "
            "path: solution.at(0), or one of the states that problem.steps() yields."
        )
    return solution.pressed


def _surface(pressed: PressedSprings, r: Array) -> SurfaceFields:
    refuse_unless_round(pressed, "restore", FIELD_ADVICE)
    if pressed.radius == 0.0:
        still = np.zeros(r.shape)
        return SurfaceFields(r, still, still, _height(pressed, r) - min(pressed.depth, 0.0))
    medium = pressed.bed.medium
    pressure = medium.pressure(pressed, r)
    displacement = medium.displacement(pressed, r)
    separation = _height(pressed, r) - pressed.depth + displacement
    return SurfaceFields(r, pressure, displacement, np.where(r <= pressed.touching, 0.0, separation))


def _height(pressed: PressedSprings, r: Array) -> Array:
    """Return f(r), infinite beyond what is known of the body."""
    covered = r <= pressed.bed.reach
    return np.where(covered, pressed.bed.height(np.where(covered, r, 0.0)), np.inf)


def below_surface(pressed: PressedSprings, r: Array, z: Array, surface_is_first: bool = True) -> SubsurfaceFields:
    """Return the fields at places of shapes that broadcast; the surface itself belongs to one of the bodies."""
    refuse_unless_round(pressed, "restore", FIELD_ADVICE)
    r, z = np.broadcast_arrays(r, z)
    first = (z >= 0.0) if surface_is_first else (z > 0.0)
    parts = np.zeros((6, *r.shape))
    for below, chosen in ((True, first), (False, ~first)):
        if chosen.any() and pressed.radius > 0.0:
            medium = pressed.bed.medium
            parts[:, chosen] = medium.interior(pressed.blunted, r[chosen], np.abs(z[chosen]), below=below)
    return SubsurfaceFields(r, z, *parts)
