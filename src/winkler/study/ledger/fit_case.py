"""Literature cases that fit a curve: a study with ``[fit]``, and ``[[expect]]`` for its fitted numbers.

The quantity of an expectation is the key of a free number, ``problem.bed.medium.first.young``.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

from winkler.study.batch.fit_outcome import Fitted
from winkler.study.batch.fit_run import fit_study
from winkler.study.batch.outcome import ComparedNumber
from winkler.study.batch.verdicts import deviation
from winkler.study.language.compared.expectations import expectations
from winkler.study.language.fit_reading import parse_fit_study
from winkler.study.language.fit_study import FitStudy
from winkler.study.language.reading import parsed, read_text
from winkler.study.language.study import Expectation
from winkler.values.errors import InvalidInput

__all__ = ["FitCase", "fit_verdicts", "read_fit_case"]


class FitCase(NamedTuple):
    """A study with ``[fit]``, its expected numbers, and their source."""

    study: FitStudy
    source: str
    grade: str
    expect: tuple[Expectation, ...]

    @property
    def title(self) -> str:
        """Title of the study."""
        return self.study.title


def read_fit_case(path: Path) -> FitCase:
    """Read a case with ``[fit]``.

    Raises
    ------
    InvalidInput
        With one sentence for every mistake.
    """
    import tomli_w

    raw = parsed(read_text(path), path.name)
    source, grade = str(raw.pop("source", "")), str(raw.pop("grade", ""))
    expected = expectations(raw.pop("expect", []), path.name)
    study = parse_fit_study(tomli_w.dumps(raw), file=path.name, folder=path.parent)
    free = [line.key for line in study.free]
    for item in expected:
        if item.quantity not in free:
            raise InvalidInput(
                f"{path.name}: expect asks for '{item.quantity}', which is not free; give one of {', '.join(free)}."
            )
    return FitCase(study, source, grade, expected)


def fit_verdicts(case: FitCase) -> tuple[ComparedNumber, ...]:
    """Return the verdicts on the fitted numbers of a case, curve by curve.

    Raises
    ------
    InvalidInput, NotConverged, OutsideValidity
        If no curve can be fitted.
    """
    paths = {line.key: line.path for line in case.study.free}
    verdicts = []
    for place, result in enumerate(fit_study(case.study).results):
        for item in case.expect:
            got = result.fit.value(paths[item.quantity]) if isinstance(result, Fitted) else np.nan
            verdicts.append(ComparedNumber((place,), item, got, deviation(got, item)))
    return tuple(verdicts)
