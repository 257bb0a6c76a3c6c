"""The greatest stress of each kind in one part of the bodies below a round contact, and how deep it lies."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from winkler.media.interior import tensor
from winkler.problems.normal.greatest_stress import greatest_stress, least_depth
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.normal.strong_parts import StrongPart
from winkler.values.errors import OutsideValidity

NO_CONTACT = "ContactStress: the bodies do not touch, so there are no stresses; press harder."


class Deepest(NamedTuple):
    """A stress [Pa], how deep it is the greatest [m], below zero in the second body, and its relative error."""

    value: float
    depth: float
    error: float = 0.0


Search = Callable[[StrongPart, tensor.Measure], Deepest]


def below_disc(contact: IndentationSolution) -> Search:
    """Return the search below the disc of a round contact under one load.

    Raises
    ------
    OutsideValidity
        If the bodies do not touch; by the search, if the stress is infinite or not known.
    """
    pressed = contact.pressed
    if pressed.radius == 0.0:
        raise OutsideValidity(NO_CONTACT)

    def find(part: StrongPart, measure: tensor.Measure) -> Deepest:
        place = greatest_stress(pressed, part, fine=True, measure=measure)
        if place.sharp:
            raise OutsideValidity(f"ContactStress: {place.sharp}; round it off, or restore the fields beside it.")
        if place.z < 1.001 * least_depth(pressed):
            raise OutsideValidity(
                f"ContactStress: the greatest {measure.__name__} in the {part.name} lies less than {place.z:.3g} m "
                "below the surface, where stresses in a power law are not implemented; request the stresses at given "
                "depths, or give a DepthGradedHalfSpace."
            )
        return Deepest(place.value, place.z if part.first else -place.z)

    return find
