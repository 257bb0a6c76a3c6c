"""Which physics a study belongs to: the chapters of the validation ledger.

A problem belongs to the table of kinds that it stands in; a normal contact to the medium under it, or to the fields
that are asked of it.
"""

from __future__ import annotations

from typing import Any

from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.study.chapters.kind import Kind
from winkler.study.chapters.kinds_of_conduction import CONDUCTION
from winkler.study.chapters.kinds_of_contacts import CONTACTS
from winkler.study.chapters.kinds_of_friction import FRICTION
from winkler.study.chapters.kinds_of_heating import HEATING
from winkler.study.chapters.kinds_of_rolling import ROLLING
from winkler.study.chapters.kinds_of_roughness import ROUGHNESS
from winkler.study.chapters.kinds_of_viscoelasticity import VISCOELASTICITY
from winkler.study.chapters.kinds_of_wear import WEAR
from winkler.study.language.catalogue import kind_of
from winkler.study.language.study import Study

__all__ = ["CHAPTERS", "FITS", "physics_of"]

NORMAL, FIELDS, COATINGS, GRADED, ADHESION, FITS = (
    "normal contact",
    "fields",
    "coatings",
    "graded bodies",
    "adhesion",
    "fits",
)
OTHER = "other contacts"
PLAIN = ("indentation", "yield_onset")
"""Normal contacts without adhesion."""

TABLES: dict[str, dict[str, dict[str, Kind]]] = {
    "friction and impacts": FRICTION,
    "bodies that relax": VISCOELASTICITY,
    "current and heat": CONDUCTION,
    "frictional heat": HEATING,
    "rolling": ROLLING,
    "wear": WEAR,
    "measured and rough surfaces": ROUGHNESS,
}
"""Physics -> the table of its kinds."""

CHAPTERS = (NORMAL, FIELDS, COATINGS, GRADED, ADHESION, *TABLES, FITS, OTHER)
"""The physics, in the order of the ledger."""


def physics_of(study: Study) -> str:
    """Return the chapter that a study belongs to, one of `CHAPTERS`."""
    name = kind_of(type(study.problem))
    for physics, table in TABLES.items():
        if name in table.get("problem", {}):
            return physics
    if name not in CONTACTS["problem"]:
        return OTHER
    return _normal(study) if name in PLAIN else ADHESION


def _normal(study: Study) -> str:
    medium: Any = getattr(study.problem.bed, "medium", None)
    if isinstance(medium, CoatedHalfSpace):
        return COATINGS
    if isinstance(medium, GradedHalfSpace | DepthGradedHalfSpace):
        return GRADED
    return FIELDS if study.expect and all(asked.place for asked in study.expect) else NORMAL
