"""The closed list of the assumptions on which a result may rest."""

from __future__ import annotations

from enum import Enum


class Assumption(Enum):
    """An assumption on which a result may rest.

    Assumptions with a number that is compared with a limit are `checked`: a violation has the standing "outside", or
    raises `OutsideValidity`. Notes on the others state a bound of the error, or that the error is not known.
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
    ENERGY = "energy balance"
    CONDUCTION = "flow of heat and current"
    CONTINUUM = "contact wide against the free path of carriers"
    TEMPERATURE = "properties that do not change with temperature"
    WEAR = "law of wear"
    ROUGHNESS = "roughness on a line of springs"
    CURVE = "measured curve"

    @property
    def checked(self) -> bool:
        """Whether a violation is detected by a number and flagged."""
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
