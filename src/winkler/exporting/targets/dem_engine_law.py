"""A contact law as the text of a force model for DEM-Engine: functions for its device code, and what it does a contact.

DEM-Engine keeps what a contact remembers as single numbers that begin with zero, at most sixteen; a double number is
kept as the sum of two of them.
"""

from __future__ import annotations

import math
import re

from winkler.exporting.step_law import StatePart, StepLaw
from winkler.exporting.targets.c_law import law_parts
from winkler.exporting.targets.heading import heading_lines
from winkler.exporting.targets.one_export import MARK, marked
from winkler.values.errors import InvalidInput

MOST_REMEMBERED = 16
"""Numbers that DEM-Engine keeps for a contact, unless it is built for more."""
MOTIONS = {"depth": "{share}(double)overlapDepth", "duration": "(double)ts", "curvature_radius": "law_R{whole}"}
RADIUS_TOLERANCE = "1e-5"
"""Radii are single numbers there."""


def dem_engine_law(law: StepLaw, name: str) -> dict[str, str]:
    """Return the files: functions that stand before the model, and the model.

    Raises
    ------
    InvalidInput
        If the law takes another motion than depth and time, or remembers more than DEM-Engine keeps.
    """
    unknown = [one.name for one in law.motion if one.name not in MOTIONS]
    if unknown:
        raise InvalidInput(
            f"export: laws for DEM-Engine have no friction, but this one needs {unknown[0]}; export it to c, "
            "or the problem without friction."
        )
    kept = [(part, k) for part in law.state if part.meaning != "work space" for k in range(part.begin.size)]
    words = _words(kept, name)
    if len(words) > MOST_REMEMBERED:
        raise InvalidInput(
            f"export: the law stores {len(words)} single-precision values per contact, DEM-Engine at most "
            f"{MOST_REMEMBERED}; give fewer springs (count), or a law with less memory."
        )
    model = f'static_assert({name}_export == 0x{MARK}, "both files must be of one export");\n{_model(law, name, kept)}'
    return marked({f"{name}_prerequisites.cu": _prerequisites(law, name, words), f"{name}_model.cu": model})


def _words(kept: list[tuple[StatePart, int]], name: str) -> list[str]:
    """Return the names of what DEM-Engine keeps."""
    if not kept:
        return []
    parts = [f"{name}_{part.name}_{k}_{half}" for part, k in kept for half in _halves(part)]
    return [f"{name}_begun", *parts]


def _halves(part: StatePart) -> str:
    return "hl" if part.begin.dtype.kind == "f" else "h"


def _prerequisites(law: StepLaw, name: str, words: list[str]) -> str:
    """Return the functions."""
    use = [
        "Use, with both files as text:",
        f'  auto model = solver.DefineContactForceModel(text of "{name}_model.cu");',
        f'  model->DefineCustomModelPrerequisites(text of "{name}_prerequisites.cu");',
    ]
    if words:
        names = ", ".join(f'"{word}"' for word in words)
        use.append(f"  model->SetPerContactWildcards({{{names}}});")
        use.append("Bodies that attract each other beyond the touch need an extra margin of their families.")
    use.append("Lengths in m, forces in N, time in s. A force that is no number: the law does not hold there.")
    heading = "\n".join(f" * {line}".rstrip() for line in [*heading_lines(law), "", *use]).replace("*/", "* /")
    code = "\n\n".join(law_parts(law, name))
    code = re.sub(r"^static inline ", "__device__ inline ", code, flags=re.MULTILINE)
    code = re.sub(r"^static const ", "__device__ const ", code, flags=re.MULTILINE)
    return f"""/*
 * {heading.strip().removeprefix("* ")}
 */
#ifndef INFINITY
#define INFINITY (1.0 / 0.0)
#endif
#ifndef NAN
#define NAN (0.0 / 0.0)
#endif

constexpr unsigned long long {name}_export = 0x{MARK};

{code}
"""


def _model(law: StepLaw, name: str, kept: list[tuple[StatePart, int]]) -> str:
    """Return what is done for a contact; without lines of the preprocessor, as DEM-Engine joins all lines."""
    share = "law_share * " if law.against_plane else ""
    lines = [f"{name}_state law_state;", f"{name}_motion law_motion;", f"{name}_answer law_answer;"]
    lines += [f"{name}_begin(&law_state);"]
    lines += ["const double law_R = (double)ARadius * (double)BRadius / ((double)ARadius + (double)BRadius);"]
    if law.against_plane:
        lines += ["const double law_share = law_R > 0.999 * (double)ARadius ? 1.0 : 0.5;"]
    if kept:
        recalled = " ".join(f"law_state.{part.name}[{k}] = {_recalled(part, k, name)};" for part, k in kept)
        lines += [f"if ({name}_begun > 0.5f) {{ {recalled} }}"]
        active = f"overlapDepth > 0 || {name}_begun > 0.5f"
    else:
        active = "overlapDepth > 0"
    words = {"share": share, "whole": " / law_share" if share else ""}
    inner = [f"law_motion.{one.name} = {MOTIONS[one.name].format(**words)};" for one in law.motion]
    inner += [f"{name}_step(&law_state, &law_motion, &law_answer);"]
    if not math.isnan(law.curvature_radius) and not law.every_radius:
        given = f"{'law_share * ' if law.against_plane else ''}{law.curvature_radius!r}"
        inner += [
            f"if (overlapDepth > 0 && fabs(law_R - {given}) > {RADIUS_TOLERANCE} * law_R) law_answer.force = NAN;"
        ]
    inner += ["force += (float)law_answer.force * B2A;"]
    if kept:
        inner += [f"{name}_begun = 1.0f;"]
        for part, k in kept:
            word = f"{name}_{part.name}_{k}"
            inner += [f"{word}_h = (float)law_state.{part.name}[{k}];"]
            if _halves(part) == "hl":
                inner += [f"{word}_l = (float)(law_state.{part.name}[{k}] - (double){word}_h);"]
    body = "\n    ".join(inner)
    return "\n".join([*lines, f"if ({active}) {{\n    {body}\n}}"]) + "\n"


def _recalled(part: StatePart, k: int, name: str) -> str:
    """Return a number of the state out of what DEM-Engine keeps."""
    word = f"{name}_{part.name}_{k}"
    match part.begin.dtype.kind:
        case "f":
            return f"(double){word}_h + (double){word}_l"
        case "b":
            return f"{word}_h > 0.5f"
        case _:
            return f"(int64_t){word}_h"
