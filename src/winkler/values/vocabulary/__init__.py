"""The glossary: each physical name once, with symbol, unit and one line.

Axis labels, result attributes, study files, forms and the manual read it; a test refuses a public field that is
not in it.  Each chapter has a module; here are the names that mean the same everywhere.  A class for which a name
means something else (the exponent of a shape, of a grading) states that itself, in ``__words__``, which comes first.
A unit of ``None`` marks a field that is no quantity.
"""

from __future__ import annotations

from winkler.values.vocabulary.contact import CONTACT
from winkler.values.vocabulary.entry import Word
from winkler.values.vocabulary.motion import MOTION
from winkler.values.vocabulary.rubbing import RUBBING
from winkler.values.vocabulary.surfaces import SURFACES

__all__ = ["CHAPTERS", "GLOSSARY", "Word", "own_word", "word"]

CHAPTERS = (CONTACT, MOTION, RUBBING, SURFACES)
GLOSSARY: dict[str, Word] = {name: entry for chapter in CHAPTERS for name, entry in chapter.items()}


def own_word(owner: type, field: str) -> Word | None:
    """Return the entry that `owner` or the nearest of its bases has for `field` in its ``__words__``, None without."""
    return next((found[field] for cls in owner.__mro__ if field in (found := vars(cls).get("__words__", ()))), None)


def word(owner: type, field: str) -> Word:
    """Return the entry for `field` of the class `owner`: its own, or the shared one.

    Raises
    ------
    KeyError
        If neither the class nor the glossary knows the field: a test keeps that from happening.
    """
    return own_word(owner, field) or GLOSSARY[field]
