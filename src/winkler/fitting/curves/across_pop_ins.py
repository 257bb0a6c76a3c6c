"""Pop-ins within the fitted part of a curve: a smooth law of contact fitted across one is biased."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.fitting.curves.checks import Flag
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.directions import IN
from winkler.fitting.curves.events.popins import pop_ins
from winkler.fitting.curves.events.stated import MARKS
from winkler.numerics.types import Array
from winkler.values.readable import with_unit

MOST_NAMED = 3


def across_pop_ins(curve: ForceCurve, fitted: ForceCurve, touched: Array) -> Iterator[Flag]:
    """Yield `pop_in` for a curve with sudden steps of depth, or drops of force, while the tip is pressed in.

    Parameters
    ----------
    curve : ForceCurve
        With its holds.
    fitted : ForceCurve
        The m points that were fitted.
    touched : ndarray of bool, (m,)
        Which of them are in contact.
    """
    inside = np.flatnonzero(touched & (fitted.direction == IN))
    if not inside.size:
        return
    moving = np.flatnonzero(curve.direction != 0.0)
    begins = (curve.position[moving] == fitted.position[inside[0]]) & (curve.force[moving] == fitted.force[inside[0]])
    inward = moving[begins & (curve.direction[moving] == IN)]
    if curve.marks.size:
        stated = np.flatnonzero(curve.marks == MARKS["pop-in"])
        places = stated[np.diff(stated, prepend=-2) > 1].tolist()
    else:
        # a snap-in is no pop-in: the contact goes on from its greatest tension
        going = moving[curve.direction[moving] == IN]
        first = max(int(inward[0]), int(going[np.argmin(curve.force[going])]))
        places = [found.place for found in pop_ins(curve.record, first)]
    if places:
        forces = [with_unit(float(curve.force[max(place - 1, 0)]), "N") for place in places[:MOST_NAMED]]
        more = f" and {len(places) - MOST_NAMED} more" if len(places) > MOST_NAMED else ""
        many = f"{len(places)} pop-ins" if len(places) > 1 else "a pop-in"
        yield Flag(
            "pop_in",
            f"The loading has {many}, at a force of {', '.join(forces)}{more}: a smooth law of contact that is fitted "
            "across it is biased; fit the part before the first one.",
        )
