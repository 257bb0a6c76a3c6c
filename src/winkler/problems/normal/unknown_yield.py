"""The onset of yield is not known: the statement for bodies with a strength whose stresses are not computed."""

from __future__ import annotations

from winkler.problems.normal.strong_parts import strong_parts
from winkler.values.validity import Assumption, Note, Standing

MISES = "R. von Mises, Nachr. Ges. Wiss. Goettingen (1913) 582; largest von Mises stress of the restored field"


def relaxing_yield(medium: object) -> tuple[Note, ...]:
    """Return what is known of yield in bodies that relax; nothing where no part of them has a strength."""
    return unknown_yield(medium, "the stresses in bodies that relax follow the history of the load")


def unknown_yield(medium: object, why: str, addition: str = "") -> tuple[Note, ...]:
    """Return that the onset of yield is not known, if a part of the medium has a strength.

    Parameters
    ----------
    medium
        Any.
    why : str
        Why it is not known, the end of a sentence.
    addition : str
        What is certain nevertheless, a sentence.
    """
    if not strong_parts(medium):
        return ()
    statement = f"The onset of yield is not known because {why}. {addition}".rstrip()
    return (Note(Assumption.ELASTIC, Standing.APPROXIMATE, statement, MISES),)
