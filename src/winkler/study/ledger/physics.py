"""The physics of a study: the chapters of the validation ledger.

A problem belongs to the chapter that it stands in; a normal contact to the medium under it, or to its expected
fields.
"""

from __future__ import annotations

from typing import Any

from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.offers import LayerStack, offers
from winkler.study.chapters import contents
from winkler.study.language.catalogue import kind_of
from winkler.study.language.study import Study

NORMAL, FIELDS, COATINGS, GRADED, FITS = "normal contact", "fields", "coatings", "graded bodies", "fits"
OTHER_CONTACTS = "other contacts"
NON_ROUND_CONTACTS = dict.fromkeys(
    ("elliptic_indentation", "elliptic_yield_onset", "nearly_round_indentation"), "measured and rough surfaces"
)
"""Normal contacts that are listed with the surfaces of any shape."""
PHYSICS = {kind: chapter.physics for chapter in contents.CHAPTERS for kind in chapter.answers} | NON_ROUND_CONTACTS
"""Kind of problem -> its physics."""

CHAPTERS = tuple(
    dict.fromkeys(
        (NORMAL, FIELDS, COATINGS, GRADED, *(chapter.physics for chapter in contents.CHAPTERS), FITS, OTHER_CONTACTS)
    )
)
"""The physics, in the order of the ledger."""


def physics_of(study: Study) -> str:
    """Return the chapter that a study belongs to, one of `CHAPTERS`."""
    physics = PHYSICS.get(kind_of(type(study.problem)), OTHER_CONTACTS)
    return _normal(study) if physics == NORMAL else physics


def _normal(study: Study) -> str:
    medium: Any = getattr(study.problem.bed, "medium", None)
    if offers(medium, LayerStack):
        return COATINGS
    if isinstance(medium, GradedHalfSpace | DepthGradedHalfSpace):
        return GRADED
    return FIELDS if study.expect and all(item.place for item in study.expect) else NORMAL
