"""Other models of the curves of a study: ``[fit.models]``, each stated by what differs from the problem.

::

    [fit.models.cone]
    "problem.bed.profile" = { kind = "cone", half_angle = "60 deg" }

    [fit.models.sticky]
    "problem.kind" = "adhesive_indentation"
    "problem.law" = { kind = "short_range", work = "1 mJ/m^2" }
    free = { "problem.bed.medium.first.young" = true, "problem.law.work" = true }

Free numbers of the curve are those of the study; those of the problem, too, unless `free` states others.
"""

from __future__ import annotations

import copy
import functools
import re
from collections.abc import Callable
from typing import Any

from winkler.study.language.fit_study import Alternative, FitStudy
from winkler.values.errors import InvalidInput, WinklerError

MOST_MODELS = 20
FREE = "free"


def alternatives(
    raw: dict[str, Any], study_of: Callable[[dict[str, Any]], FitStudy], at: str
) -> tuple[Alternative, ...]:
    """Return the other models of a study.

    Parameters
    ----------
    raw : dict
        The tables of the study.
    study_of : callable
        Returns the study that tables without other models state.
    at : str
        The file, for error sentences.

    Raises
    ------
    InvalidInput
        With one sentence, which begins with the name of the model.
    """
    models = raw["fit"].pop("models", {})
    if len(models) > MOST_MODELS:
        raise InvalidInput(f"{at}fit.models holds {len(models)} models; give at most {MOST_MODELS}.")
    found = []
    for name, changes in models.items():
        where = f"{at}fit.models.{name}: "
        if not name.strip():
            raise InvalidInput(f"{at}fit.models holds a model without a name; give it one, such as [fit.models.cone].")
        try:
            study = study_of(_changed(copy.deepcopy(raw), dict(changes)))
        except WinklerError as error:
            raise error.reworded(functools.partial(_in_model, where, at)) from None
        found.append(Alternative(name, study.problem, study.free))
    return tuple(found)


def _in_model(where: str, at: str, sentence: str) -> str:
    return f"{where}{sentence.removeprefix(at)}"


def _changed(raw: dict[str, Any], changes: dict[str, Any]) -> dict[str, Any]:
    """Return the tables of the study with the changes of one model."""
    for extra in ("over_depth", "shared"):
        raw["fit"].pop(extra, None)
    own = changes.pop(FREE, None)
    if own is not None:
        if not isinstance(own, dict):
            raise InvalidInput(f"free is {own!r}; give a table as [fit.free] is.")
        of_curve = {key: bounds for key, bounds in raw["fit"]["free"].items() if not key.startswith("problem.")}
        raw["fit"]["free"] = of_curve | own
    if not changes and own is None:
        raise InvalidInput("nothing is changed; give keys of the problem that differ, or free numbers.")
    for key, content in changes.items():
        if not key.startswith("problem."):
            raise InvalidInput(f"'{key}' is no key of the problem, as \"problem.load\" in quotes, and not 'free'.")
        _put(raw, re.sub(r"\[(\d+)\]", r".\1", key).split("."), content, key)
    return raw


def _put(owner: Any, steps: list[str], content: Any, key: str) -> None:
    """Put a content into nested tables and lists."""
    for step in steps[:-1]:
        owner = _part(owner, step, key)
    last = steps[-1]
    if isinstance(owner, list):
        _part(owner, last, key)
        owner[int(last)] = content
    elif isinstance(owner, dict):
        owner[last] = content
    else:
        raise InvalidInput(f"'{key}' leads nowhere: there is no table that holds '{last}'; give the table before it.")


def _part(owner: Any, step: str, key: str) -> Any:
    if isinstance(owner, dict) and step in owner:
        return owner[step]
    if isinstance(owner, list) and step.isdecimal() and int(step) < len(owner):
        return owner[int(step)]
    raise InvalidInput(f"'{key}' leads nowhere: the problem of the study has no '{step}' there; give a whole table.")
