"""How far a result can be trusted: the assumptions behind it, what a check of each one says, and the source.

`Assumption` is the closed list.  Every problem declares in ``assumptions`` those that its answer rests on; every
solution carries a tuple of `Note`, each of which states one of them, and its `Standing`.  The standing of an answer is
the worst of its notes.  docs/validity.md says for every assumption how it is tested and what violating it costs.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import Enum

from winkler.values import value

__all__ = ["Assumption", "Note", "Standing", "worst"]


class Assumption(Enum):
    """What an answer may rest on.

    Those with a number that is compared with a limit are `checked`: a violation has the standing "outside", or raises
    `OutsideValidity`.  The others are stated with their error, which has a bound, or is not known and said to be so.
    """

    RESPONSE = "response of the bodies"
    SHAPE = "shape of the bodies"
    HALF_SPACE = "bodies large against the contact"
    FILM = "indentation small against the film"
    SMALL_SLOPES = "small slopes"
    ELASTIC = "no yield"
    KNOWN_TIMES = "times at which the solid is known"
    SINGLE_CONTACT = "one round contact"
    EQUILIBRIUM = "state of equilibrium"
    ADHESION = "range and law of adhesion"
    UNCOUPLED = "pressure and traction do not act on each other"
    SLIP = "law and direction of slip"
    CALIBRATION = "calibrated springs of rolling"
    INERTIA = "inertia, waves and weight left out"
    STEADY = "steady state"
    RESOLUTION = "numerical resolution"
    CONDUCTION = "flow of heat and current"
    CONTINUUM = "contact wide against the free path of carriers"
    TEMPERATURE = "properties that do not change with temperature"
    WEAR = "law of wear"
    ROUGHNESS = "roughness on a line of springs"
    CURVE = "measured curve"

    @property
    def checked(self) -> bool:
        """Whether a violation is found by a number and flagged."""
        return self not in _STATED


_STATED = frozenset(
    (
        Assumption.RESPONSE,
        Assumption.EQUILIBRIUM,
        Assumption.SLIP,
        Assumption.STEADY,
        Assumption.CONDUCTION,
        Assumption.WEAR,
        Assumption.CURVE,
    )
)


class Standing(Enum):
    """What a note says about the result, from best to worst."""

    EXACT = "exact"
    ASYMPTOTIC = "asymptotic"
    APPROXIMATE = "approximate"
    OUTSIDE = "outside"


@value
class Note:
    """One statement about the validity of a result.

    Parameters
    ----------
    assumption
        Which assumption it speaks of.
    standing
        exact; asymptotic (right in a limit, the deviation is stated); approximate (the error is stated);
        outside (the number is not to be trusted).
    statement
        One sentence in plain words.
    source
        Where the statement comes from: a citation with DOI, or the check that was made.
    """

    assumption: Assumption
    standing: Standing
    statement: str
    source: str

    def __str__(self) -> str:
        return f"{self.standing.value}: {self.statement} [{self.source}]"


def worst(notes: Iterable[Note]) -> Standing:
    """Return the worst standing among `notes`; exact if there are none."""
    order = list(Standing)
    return max((note.standing for note in notes), key=order.index, default=Standing.EXACT)
