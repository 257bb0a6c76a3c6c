"""The table of a study that was opened, typed as text, or found in an address."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.fit_study import FITTED
from winkler.study.language.reading import parsed
from winkler.web.form import form

ASSUMED = "# of an example, given by nobody: "
"""Beginning of the last line of a study that is kept in an address."""


def with_assumed(text: str, paths: Iterable[str]) -> str:
    """Return the text of a study with the paths of what nobody has given, in a comment.

    Examples
    --------
    >>> assumed_in(with_assumed("title = 'x'", ["problem.load.force", "problem.law.coefficient"]))
    ('problem.load.force', 'problem.law.coefficient')
    """
    line = " ".join(paths)
    return f"{text.rstrip()}\n{ASSUMED}{line}\n" if line else text


def assumed_in(text: str) -> tuple[str, ...]:
    """Return the paths that `with_assumed` has written into a text."""
    last = text.rstrip().rpartition("\n")[2]
    return tuple(last.removeprefix(ASSUMED).split()) if last.startswith(ASSUMED) else ()


def taken(text: str, folder: Path) -> dict[str, Any]:
    """Return the table of a study whose problem the form can show; other mistakes are shown beside their fields.

    Parameters
    ----------
    text
        A study file.
    folder
        Where its files are.

    Raises
    ------
    InvalidInput
        If it is no study, or its problem is unknown.
    """
    table = parsed(text, "")
    known = FITTED if "fit" in table else CATALOGUE["problem"]
    problem = table.get("problem")
    if not isinstance(problem, dict) or str(problem.get("kind")) not in known:
        _raise_mistakes(text, folder, fits="fit" in table)
    if not isinstance(table.get("fit", {}), dict) or not isinstance(form.at(table, "fit.free") or {}, dict):
        _raise_mistakes(text, folder, fits=True)
    return table


def _raise_mistakes(text: str, folder: Path, *, fits: bool) -> None:
    """Raise the mistakes that the checks of the study find."""
    from winkler.study.language.fit_reading import parse_fit_study
    from winkler.study.language.reading import parse_study

    (parse_fit_study if fits else parse_study)(text, folder=folder)
