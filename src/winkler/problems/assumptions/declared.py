"""Which assumptions the solutions of each class of problems rest on.

A problem names its set in ``assumptions``; a note of its solution about another one is a mistake, which a test
over all kinds finds.
"""

from __future__ import annotations

from typing import Final

from winkler.values.validity import Assumption

BALANCED: Final = frozenset((Assumption.ENERGY,))
"""A march whose energies are checked against each other, or at both ends of its last cycle, beside all else that it
assumes."""

PRESSED: Final = frozenset(
    (
        Assumption.RESPONSE,
        Assumption.SHAPE,
        Assumption.HALF_SPACE,
        Assumption.FILM,
        Assumption.SMALL_SLOPES,
        Assumption.ELASTIC,
        Assumption.SINGLE_CONTACT,
        Assumption.EQUILIBRIUM,
        Assumption.RESOLUTION,
    )
)
"""Normal contact without friction or adhesion."""

MAPPED: Final = frozenset(
    (Assumption.RESPONSE, Assumption.SMALL_SLOPES, Assumption.ELASTIC, Assumption.RESOLUTION, Assumption.EQUILIBRIUM)
)
"""Normal contact of height maps by boundary elements."""

ATTRACTED: Final = MAPPED | {Assumption.ADHESION}
"""Height maps that attract each other."""

ADHESIVE: Final = PRESSED | {Assumption.ADHESION}
"""Normal contact of bodies that attract each other."""

SHEARED: Final = PRESSED | {Assumption.UNCOUPLED, Assumption.SLIP}
"""Contact with friction, sticking or slipping in parts."""

ROLLING: Final = SHEARED | {Assumption.CALIBRATION}
"""Contact that rolls."""

RELAXING: Final = PRESSED | {Assumption.KNOWN_TIMES}
"""Contact of viscoelastic bodies."""

CONDUCTING: Final = PRESSED | {Assumption.CONDUCTION, Assumption.CONTINUUM}
"""Flow of current or heat through a pressed contact."""

HEATED: Final = PRESSED | {Assumption.CONDUCTION, Assumption.TEMPERATURE, Assumption.UNCOUPLED}
"""A contact that friction heats."""

WORN: Final = SHEARED | {Assumption.WEAR}
"""A contact that friction wears."""
