"""A contact law for LAMMPS: a pair style that the command `plugin load` adds, over the C file."""

from __future__ import annotations

import math

import numpy as np

from winkler.exporting.step_law import StepLaw
from winkler.exporting.targets.c_law import c_law
from winkler.exporting.targets.lammps_contact import CONTACT, MADE
from winkler.exporting.targets.lammps_granular import granular_law
from winkler.exporting.targets.lammps_pair import PAIR
from winkler.exporting.targets.lammps_wall import WALL
from winkler.exporting.targets.one_export import marked
from winkler.exporting.translation.plain import plain
from winkler.values.errors import InvalidInput

__all__ = ["farthest_hold", "lammps_law"]

MOTIONS = {
    "depth": "depth",
    "duration": "step",
    "motion_x": "dot(slide, one)",
    "motion_y": "dot(slide, two)",
    "twist": "dot(turn, n)",
    "roll_x": "dot(turn, one)",
    "roll_y": "dot(turn, two)",
    "curvature_radius": "R",
}
"""What a law takes -> what it is in the pair style."""
MOMENTS = (("torque", "n"), ("rolling_x", "one"), ("rolling_y", "two"))
LOADS, HALVINGS, MARGIN = 10, 40, 1.2


def lammps_law(law: StepLaw, name: str) -> dict[str, str]:
    """Return the files: the pair style, the law in C, and, without friction, the sub-model for pair style granular.

    Raises
    ------
    InvalidInput
        If the law takes another motion than those of two balls.
    """
    unknown = [one.name for one in law.motion if one.name not in MOTIONS]
    if unknown:
        raise InvalidInput(f"export: LAMMPS knows no {unknown[0]} of two balls; export this law to c.")
    hold = farthest_hold(law)
    files = {f"pair_{name}.cpp": _filled(law, name, hold), f"{name}.h": c_law(law, name)}
    return marked(files | granular_law(law, name, hold, radii_of(law)) if is_normal(law) else files)


def radii_of(law: StepLaw) -> dict[str, str]:
    """Return R that every pair must have, and R of a law of all radii [m]; zero where there is none."""
    given = "0.0" if math.isnan(law.curvature_radius) else repr(law.curvature_radius)
    return {"radius": "0.0" if law.every_radius else given, "given": given if law.every_radius else "0.0"}


def is_normal(law: StepLaw) -> bool:
    """Return whether the law needs nothing but depth and time."""
    return {one.name for one in law.motion} <= {"depth", "duration", "curvature_radius"}


def farthest_hold(law: StepLaw) -> float:
    """Return how far apart the bodies still attract each other [m], after any load, with a margin; 0 if they do not."""
    names = [one.name for one in law.answer]
    if "radius" not in names or {one.name for one in law.motion} - {"curvature_radius"} != {"depth"}:
        return 0.0
    deepest = float(np.max(law.trial[:, 0]))
    if law.every_radius:
        deepest *= law.curvature_radius / float(law.trial[0, -1])
    farthest = 0.0
    for load in deepest * np.geomspace(1e-4, 1.0, LOADS):
        near, far = 0.0, 10.0 * deepest
        for _ in range(HALVINGS):
            middle = 0.5 * (near + far)
            if _holds(law, load, middle, names.index("radius")):
                near = middle
            else:
                far = middle
        farthest = max(farthest, near)
    return float(MARGIN * farthest)


def _holds(law: StepLaw, load: float, apart: float, column: int) -> bool:
    """Return whether the bodies still hold each other a distance apart, after a load."""
    tables = [np.array(table.numbers, dtype=float) for table in law.tables]
    state = [np.array(part.begin) for part in law.state]
    answer, step = np.zeros(len(law.answer)), plain(law.kernel)
    for depth in (load, -apart):
        step(*tables, *state, np.array([depth]), answer)
    return bool(answer[column] > 0.0)


def _filled(law: StepLaw, name: str, hold: float) -> str:
    """Return the pair style."""
    takes = [f"motion.{one.name} = {MOTIONS[one.name]};" for one in law.motion]
    given = {one.name for one in law.answer}
    adds = []
    if "shear_x" in given:
        adds.append("push[k] -= answer.shear_x * one[k] + answer.shear_y * two[k];")
    moments = [f"answer.{part} * {axis}[k]" for part, axis in MOMENTS if part in given]
    if moments:
        adds.append(f"moment[k] -= {' + '.join(moments)};")
    words = {
        "title": law.title.replace("*/", "* /"),
        "name": name,
        "takes": "\n    ".join(takes),
        "adds": "\n        ".join(adds),
        "slides": "false" if is_normal(law) else "true",
        "remembers": "true" if law.state else "false",
        "stored": "answer.energy" if not law.state else "0.0",
        "hold": repr(hold * (2.0 if law.against_plane else 1.0)),
        **radii_of(law),
        "shared": "0.5" if law.against_plane else "1.0",
    }
    text = CONTACT + PAIR + WALL + MADE
    for word, content in words.items():
        text = text.replace(f"@{word}@", content)
    return text
