"""Contact laws as look-up tables for other programs: the conventions in words, then the rows.

``.csv`` has the conventions as comments behind #, ``.json`` as entries::

    {"conventions": [...], "asked": {...}, "hermite_error": ..., "linear_error": ...,
     "columns": {"depth": {"unit": "m", "meaning": "...", "values": [...]}, ...}}
"""

from __future__ import annotations

import json
import math
import os
from pathlib import Path

from winkler.io.traces import CONVENTIONS, inputs_of
from winkler.io.whole_file import write_whole_text
from winkler.problems.particles.contact_law import ContactLawSolution
from winkler.values.errors import InvalidInput
from winkler.values.vocabulary import word

COLUMNS = ("depth", "force", "radius", "stiffness", "shear_stiffness", "energy")
LAW_CONVENTIONS = (
    "One curve for loading and unloading: the contact has no friction, no adhesion and no memory; below depth 0 all "
    "columns are zero, beyond the last row the law is not known.",
    "Between two rows the force is the cubic with their forces and stiffnesses (Hermite), or a straight line; the "
    "errors of both, over the greatest force, are stated.",
    "The shear stiffness is that of the sticking contact under a constant normal force; it falls when the contact "
    "slips, and the shear force never exceeds the friction coefficient times the force.",
)


def write_law(law: ContactLawSolution, path: str | os.PathLike[str]) -> Path:
    """Write a contact law as a look-up table.

    Parameters
    ----------
    law : ContactLawSolution
        What ``ContactLaw(...).solve()`` returns.
    path : str or path
        The file; its ending, ``.csv`` or ``.json``, states its kind.

    Returns
    -------
    Path

    Raises
    ------
    InvalidInput
        If the ending is another one, the file cannot be written, or ``law`` is no contact law.
    """
    if not isinstance(law, ContactLawSolution):
        raise InvalidInput(f"write_law: a {type(law).__name__} is no contact law; give ContactLaw(...).solve().")
    target = Path(path)
    if target.suffix not in (".csv", ".json"):
        raise InvalidInput(f"{target}: the ending is {target.suffix!r}; give .csv or .json.")
    write_whole_text(target, _csv(law) if target.suffix == ".csv" else _json(law))
    return target


def _csv(law: ContactLawSolution) -> str:
    lines = [f"# {sentence}" for sentence in (*CONVENTIONS, *LAW_CONVENTIONS)]
    lines += [f"# {name} = {content!r}" for name, (content, _) in inputs_of(law.problem).items()]
    lines += [f"# {name} = {getattr(law, name)!r}" for name in ("hermite_error", "linear_error")]
    lines.append(",".join(f"{name} [{word(ContactLawSolution, name).unit}]" for name in COLUMNS))
    rows = zip(*(getattr(law, name).tolist() for name in COLUMNS), strict=True)
    return "\n".join([*lines, *(",".join(map(repr, row)) for row in rows)]) + "\n"


def _json(law: ContactLawSolution) -> str:
    content = {
        "conventions": [*CONVENTIONS, *LAW_CONVENTIONS],
        "asked": {name: "infinite" if part == math.inf else part for name, (part, _) in inputs_of(law.problem).items()},
        "hermite_error": law.hermite_error,
        "linear_error": law.linear_error,
        "columns": {
            name: {
                "unit": word(ContactLawSolution, name).unit,
                "meaning": word(ContactLawSolution, name).meaning,
                "values": getattr(law, name).tolist(),
            }
            for name in COLUMNS
        },
    }
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"
