"""What to do about the worst statement on the validity of a result: one sentence for each assumption.

The statement itself says what was found.  Where the limit of a round elastic contact follows from its springs, the
advice names the greatest load that keeps it.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.problems.normal.validity import shape_notes
from winkler.values.readable import with_unit
from winkler.values.validity import Assumption, Note, Standing, worst_note

ADVICE = {
    Assumption.RESPONSE: "allow for this error",
    Assumption.SHAPE: "press less deep, or give the shape as far as it was measured",
    Assumption.HALF_SPACE: "press less, use a larger body, or allow for this error",
    Assumption.FILM: "press less, or use a thicker film",
    Assumption.SMALL_SLOPES: "press less, or use a blunter shape",
    Assumption.ELASTIC: "set a lower load or a greater strength, and expect a wider contact",
    Assumption.KNOWN_TIMES: "ask for times within the data of the solid, or give data of longer ones",
    Assumption.SINGLE_CONTACT: "press more, or solve the height map as surface_contact",
    Assumption.EQUILIBRIUM: "see which of several states is meant, or give the history as a cycle",
    Assumption.ADHESION: "use another law of adhesion where one is named, or allow for this error",
    Assumption.UNCOUPLED: "use bodies of equal elasticity, or more friction, or allow for this error",
    Assumption.SLIP: "allow for this error, or solve the contact on a grid",
    Assumption.CALIBRATION: "calibrate the springs by Kalker's coefficients",
    Assumption.INERTIA: "use a slower impact, or allow for this error",
    Assumption.STEADY: "solve the start as well, to see when it is over",
    Assumption.RESOLUTION: "use a finer grid or map, and compare",
    Assumption.ENERGY: "use finer steps or a smaller tolerance, and compare",
    Assumption.CONDUCTION: "allow for this error",
    Assumption.CONTINUUM: "press more, or add the resistance of Sharvin",
    Assumption.TEMPERATURE: "give the properties at that temperature",
    Assumption.WEAR: "compare with a measured wear of the same pair",
    Assumption.ROUGHNESS: "solve the height map itself as surface_contact",
    Assumption.CURVE: "look at the residuals, and measure again if they have a trend",
}
"""Assumption -> what to do where it does not hold."""
WITHIN_AN_ERROR = {
    Assumption.CALIBRATION: "allow for this error, or solve the contact as surface_rolling",
    Assumption.ELASTIC: "press less, until the contact stays elastic in any case",
    Assumption.SHAPE: "compare with another description of the shape, or allow for this error",
}
"""The same where it holds within an error that is stated, if that is something else."""
NOTABLE = 0.01
"""Least error of a good result that is explained."""
NEXT_BETTER = {Standing.OUTSIDE: Standing.APPROXIMATE, Standing.APPROXIMATE: Standing.ASYMPTOTIC}
OF_SIZE = (Assumption.HALF_SPACE, Assumption.SMALL_SLOPES)
"""Assumptions whose check follows from the contact radius alone."""
HALVINGS = 40


class Doubt(NamedTuple):
    """The worst statement on a result.

    Parameters
    ----------
    standing
        The worst standing.
    statement
        The statement, a sentence; empty where nothing is doubtful and the error is below one per cent.
    advice
        What to do about it, a sentence; empty where nothing is to be done.
    """

    standing: Standing
    statement: str
    advice: str


def worst_doubt(notes: tuple[Note, ...], contact: Any = None) -> Doubt:
    """Return the worst of all notes with what to do about it.

    Parameters
    ----------
    notes
        Of a solution.
    contact
        The round elastic contact of the answer, if there is one: the advice then names the load that its size allows.
    """
    note = worst_note(notes)
    if note is None or note.standing is Standing.EXACT:
        return Doubt(Standing.EXACT, "", "")
    if note.standing is Standing.ASYMPTOTIC:
        return Doubt(note.standing, note.statement if (note.error or 0.0) >= NOTABLE else "", "")
    is_close = note.standing is Standing.APPROXIMATE
    advice = (is_close and WITHIN_AN_ERROR.get(note.assumption)) or ADVICE[note.assumption]
    load = load_within(contact, NEXT_BETTER[note.standing]) if note.assumption in OF_SIZE else math.nan
    if not math.isnan(load):
        advice = f"{advice}: use at most {with_unit(load, 'N', 3)}"
    return Doubt(note.standing, note.statement, f"What to do: {advice}.")


def load_within(contact: Any, standing: Standing) -> float:
    """Return the greatest force [N] at which slopes and size of a round contact are of a standing or better.

    Not a number where that is not known, or where no force keeps it, as under a cone.

    Parameters
    ----------
    contact
        An elastic contact with springs, or anything else.
    standing
        Asymptotic or approximate.
    """
    pressed = getattr(contact, "pressed", None)
    bed, order = getattr(pressed, "bed", None), list(Standing)
    if bed is None or type(pressed) is not PressedSprings or not pressed.radius > 0.0:  # adhesion takes another load
        return math.nan

    def keeps(radius: float) -> bool:
        return all(order.index(note.standing) <= order.index(standing) for note in shape_notes(bed, radius))

    low, high = 1e-6 * pressed.radius, pressed.radius
    if keeps(high) or not keeps(low):
        return math.nan
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if keeps(middle) else (low, middle)
    at = np.array([low])
    force = float((bed.stiffness(at) * bed.gap(at) - bed.gap_load(at))[0])
    rounded = float(f"{force:.2e}")  # down to three digits, so that the advice keeps its word
    return rounded if rounded <= force else rounded - 10.0 ** (math.floor(math.log10(force)) - 2)
