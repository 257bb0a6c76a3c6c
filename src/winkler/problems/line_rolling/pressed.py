"""The cylinder that rolls: its bed, its normal load, its contact, and how it yields under pressure and traction."""

from __future__ import annotations

import functools
from typing import Annotated, TypeAlias

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.loading.loads import HalfWidth, LineForce, LineShearForce, MeanPressure
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.numerics.types import Array
from winkler.problems.line.greatest_stress import greatest
from winkler.problems.line.indentation import LineIndentation, LineSolution
from winkler.problems.line.stress import LineContact, LineFields, Strip, fields_of, potential_of
from winkler.problems.line.yield_statement import nearest_to_strength
from winkler.problems.normal.strong_parts import strong_parts
from winkler.problems.normal.yield_statement import elastic_note
from winkler.problems.rolling.creepage import Creepage
from winkler.profiles.power import Paraboloid
from winkler.values.checks.field_checks import Condition
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Note, Standing
from winkler.values.value import value


def _one(load: object) -> bool:
    return all(np.ndim(getattr(load, name)) == 0 for name in getattr(load, "__dataclass_fields__", ()))


OneLineLoad: TypeAlias = Annotated[
    LineForce[float] | HalfWidth[float] | MeanPressure[float],
    Condition(_one, "give LineForce, HalfWidth or MeanPressure with one number, and sweep over several"),
]


def refuse_unless_round(owner: str, bed: LineBed) -> None:
    """Refuse profiles that do not stay as they are while they roll.

    Raises
    ------
    InvalidInput
    """
    if not isinstance(bed.profile, Paraboloid):
        raise InvalidInput(
            f"{owner}: the profile is a {type(bed.profile).__name__}; give Paraboloid(curvature_radius): only a round "
            "body keeps its profile while it rolls."
        )


def touching_strip(owner: str, bed: LineBed, load: OneLineLoad) -> LineSolution[float]:
    """Return the contact under its normal load.

    Raises
    ------
    OutsideValidity
        If the bodies do not touch.
    """
    contact = LineIndentation(bed, load).solve()  # type: ignore[arg-type]
    if float(contact.half_width) == 0.0:
        raise OutsideValidity(f"{owner}: the bodies do not touch under this load; press them together.")
    return contact


def rolling_stresses(contact: LineContact, stick_half_width: float, x: Array, z: Array) -> LineFields:
    """Return the stresses below a pressed strip with Carter's traction.

    Parameters
    ----------
    contact : LineContact
        Its friction is mu where the body is dragged along +x, -mu against it.
    stick_half_width : float
        c [m]: the zone of stick reaches from the leading edge a back to a - 2 c.
    x, z : ndarray
        In the axes of the body [m], z not negative.

    The traction is that of sliding less that of the same cylinder in a strip of half-width c about a - c.
    """
    x, z = np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(z, dtype=float))
    pressed = slid = potential_of(contact.bed, Strip(contact.half_width, 0.0), x, z)
    if stick_half_width > 0.0:
        shifted = x - (contact.half_width - stick_half_width)
        slid = slid - potential_of(contact.bed, Strip(stick_half_width, 0.0), shifted, z)
    return fields_of(x, z, pressed, contact.poisson, contact.friction * slid)


@value
class RollingMises:
    """Von Mises' stress below a rolling cylinder, from the fields of one that slides.

    Parameters
    ----------
    stick_share, poisson, friction : float
        c/a, nu and mu [-], mu negative where the body is dragged against x.
    """

    stick_share: float
    poisson: float
    friction: float

    def __call__(self, fields: LineFields) -> Array:
        """Return it [Pa] for E* a / R = 1 Pa at the places of `fields` over a."""
        contact = LineContact(_unit_bed(), 1.0, 0.0, self.poisson, self.friction)
        return rolling_stresses(contact, self.stick_share, fields.x, fields.z).von_mises


@functools.cache
def _unit_bed() -> LineFoundation:
    return LineFoundation(Paraboloid(1.0), HalfSpace(Elastic(1.0, 0.0)))


def rolling_yield_notes(contact: LineSolution, friction: float, stick_share: float) -> tuple[Note, ...]:
    """Return whether the body that comes nearest to its strength stays elastic.

    Parameters
    ----------
    contact : LineSolution
        Of one load.
    friction : float
        mu [-], negative where the traction drags the first body along -x.
    stick_share : float
        c/a [-].
    """
    bed, a = contact.problem.bed, float(contact.half_width)
    found = []
    for part in strong_parts(bed.medium):
        mu = friction if part.first else -friction
        measure = RollingMises(stick_share, part.solid.poisson, mu)
        place = greatest(LineContact(bed, a, 0.0, part.solid.poisson, mu), measure)
        found.append((place if part.first else place._replace(z=-place.z), part))
    return (elastic_note(*nearest_to_strength(found), Standing.EXACT),) if found else ()


def refuse_unless_along(owner: str, drive: LineShearForce | Creepage) -> None:
    """Refuse creepages that plane strain does not know.

    Raises
    ------
    OutsideValidity
    """
    if isinstance(drive, Creepage) and (np.any(np.asarray(drive.lateral) != 0.0) or np.any(np.asarray(drive.spin))):
        raise OutsideValidity(
            f"{owner}: the creepage has a lateral part or a spin, and a cylinder in plane strain has neither; give "
            "Creepage(longitudinal=...)."
        )
