"""The speed of rolling, which matters where friction falls with the velocity of slip."""

from __future__ import annotations

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import FallingFriction
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing

NO_SPEED = Note(
    Assumption.SLIP,
    Standing.EXACT,
    "Coulomb's friction does not depend on the slip velocity, so the speed has no effect on forces and creepages.",
    "the law of friction",
)


def refuse_rest(who: str, friction: Coulomb | FallingFriction, speed: float) -> None:
    """Refuse friction that depends on the velocity of slip where no speed is given.

    Raises
    ------
    InvalidInput
        If the speed is zero.
    """
    if isinstance(friction, FallingFriction) and speed == 0.0:
        raise InvalidInput(
            f"{who}: FallingFriction depends on the velocity of slip, creepage times speed, and no speed is given; "
            "give the speed of rolling in m/s, or Coulomb."
        )


def idle_speed_notes(friction: Coulomb | FallingFriction, speed: float) -> tuple[Note, ...]:
    """Return that a speed [m/s] has no effect, where one is given and friction does not depend on it."""
    return (NO_SPEED,) if speed > 0.0 and isinstance(friction, Coulomb) else ()
