"""The chapters in their order, and the record of the answer to a problem."""

from __future__ import annotations

import functools
from typing import Any

from winkler.study.chapters.adhesion import ADHESION
from winkler.study.chapters.answer import Answer, Chapter, Equation
from winkler.study.chapters.conduction import CONDUCTION
from winkler.study.chapters.friction import FRICTION
from winkler.study.chapters.heating import HEATING
from winkler.study.chapters.impact import IMPACT
from winkler.study.chapters.kind import Kind
from winkler.study.chapters.lines.line import LINE
from winkler.study.chapters.lines.line_friction import LINE_FRICTION
from winkler.study.chapters.lines.line_profiles import LINE_PROFILES
from winkler.study.chapters.lines.line_rolling import LINE_ROLLING
from winkler.study.chapters.lines.line_viscoelastic import LINE_VISCOELASTIC
from winkler.study.chapters.lines.line_wear import LINE_WEAR
from winkler.study.chapters.maps.pressed_maps import PRESSED_MAPS
from winkler.study.chapters.maps.surface_current import SURFACE_CURRENT
from winkler.study.chapters.maps.surface_wear import SURFACE_WEAR
from winkler.study.chapters.materials.master_curves import MASTER_CURVES
from winkler.study.chapters.materials.plastic import PLASTIC
from winkler.study.chapters.materials.poroelastic import POROELASTIC
from winkler.study.chapters.normal import NORMAL, normal_formulas
from winkler.study.chapters.particles import PARTICLES
from winkler.study.chapters.profile_pair import PROFILE_PAIR
from winkler.study.chapters.rolling import ROLLING
from winkler.study.chapters.rough import ROUGH
from winkler.study.chapters.subsurface import SUBSURFACE
from winkler.study.chapters.surface_friction import SURFACE_FRICTION
from winkler.study.chapters.surface_heating import SURFACE_HEATING
from winkler.study.chapters.surface_rolling import SURFACE_ROLLING
from winkler.study.chapters.viscoelastic import VISCOELASTIC
from winkler.study.chapters.viscoelastic_surfaces import VISCOELASTIC_SURFACES
from winkler.study.chapters.wear import WEAR
from winkler.values.checks.contract import path_of

CHAPTERS: tuple[Chapter, ...] = (
    NORMAL,
    LINE,
    LINE_PROFILES,
    LINE_FRICTION,
    ADHESION,
    FRICTION,
    IMPACT,
    PARTICLES,
    PLASTIC,
    VISCOELASTIC,
    MASTER_CURVES,
    POROELASTIC,
    LINE_VISCOELASTIC,
    VISCOELASTIC_SURFACES,
    CONDUCTION,
    HEATING,
    ROLLING,
    LINE_ROLLING,
    WEAR,
    LINE_WEAR,
    ROUGH,
    PRESSED_MAPS,
    SURFACE_CURRENT,
    SURFACE_WEAR,
    SUBSURFACE,
    PROFILE_PAIR,
    SURFACE_FRICTION,
    SURFACE_ROLLING,
    SURFACE_HEATING,
)
"""In the order of the catalogue."""

DEFAULT_ANSWER = Answer(Kind("", {}), normal_formulas)
"""Record for a problem of no chapter, defined by a user."""


RELAXING = {answer.kind.path: answer for chapter in CHAPTERS for answer in chapter.relaxing.values()}
"""Path of a problem -> record of its answer on bodies that relax."""


@functools.cache
def answers() -> dict[str, Answer]:
    """Return the records of all answers, by the kind of the problem."""
    return {kind: answer for chapter in CHAPTERS for kind, answer in chapter.answers.items()}


@functools.cache
def _by_path() -> dict[str, Answer]:
    return {answer.kind.path: answer for answer in answers().values()}


def answer_of(problem: Any) -> Answer:
    """Return the record of the answer to a problem."""
    if getattr(problem, "relaxes", False):
        return RELAXING[path_of(type(problem))]
    return _by_path().get(path_of(type(problem)), DEFAULT_ANSWER)


def formulas_of(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of the answer to a problem; none if its bed is none of this package."""
    return answer_of(problem).formulas(problem)
