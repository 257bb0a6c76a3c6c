"""The canonical form of a study, and its hash: equal studies have equal hashes on every machine."""

from __future__ import annotations

import dataclasses
import hashlib
import json
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.study.language.catalogue import kind_of
from winkler.study.language.study import Places, Study

if TYPE_CHECKING:
    from winkler.study.language.fit_study import FitStudy


MOST_NUMBERS_WRITTEN = 4096
"""Maps with more numbers are represented by their hash."""


def canonical(study: Study) -> str:
    """Return all that determines the numbers of a study (problem, sweep, fields) as JSON with sorted keys.

    Quantities are SI numbers, written with the digits that distinguish a float from its neighbours; title, output and
    expectations do not matter, nor how the units were written.
    """
    content = {
        "problem": plain(study.problem),
        "sweep": [plain(line) for line in study.sweep],
        "design": plain(study.design),
        "fields": [_places(study.fields.r), _places(study.fields.z)],
    }
    return json.dumps(content, sort_keys=True, separators=(",", ":"), allow_nan=False)


def digest(study: Study) -> str:
    """Return the SHA-256 of the canonical form, as 64 hexadecimal digits."""
    return hashlib.sha256(canonical(study).encode()).hexdigest()


def digest_of(problem: Any) -> str:
    """Return the SHA-256 of the canonical form of a problem alone, as 64 hexadecimal digits."""
    content = json.dumps(plain(problem), sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(content.encode()).hexdigest()


def how_fitted(study: FitStudy) -> dict[str, Any]:
    """Return all that determines the numbers of a fit except its curves, for JSON."""
    return {
        "model": digest(Study("", study.problem)),
        "free": [[free.key, list(free.given)] for free in study.free],
        "how": [study.part, study.fitted, list(study.correct), *([list(study.segments)] if study.segments else [])],
        **({"events": list(study.events)} if study.events else {}),
        **({"units": [list(pair) for pair in study.units]} if study.units else {}),
        **({"columns": [list(pair) for pair in study.columns]} if study.columns else {}),
        "numbers": [
            str(number) for number in (study.spring_constant, study.sensitivity, study.frame_stiffness, study.noise)
        ],
        **({"noise_spectrum": study.noise_spectrum} if study.noise_spectrum != "unknown" else {}),
        **_examined(study),
    }


def _examined(study: FitStudy) -> dict[str, Any]:
    """Return how fits are examined further; nothing if they are not."""
    calibration = [study.spring_constant_error, study.sensitivity_error, study.spring_constant_by]
    models = [
        [one.name, digest(Study("", one.problem)), [[free.key, list(free.given)] for free in one.free]]
        for one in study.models
    ]
    content = {
        "calibration": calibration if study.is_calibrated else [],
        "over_depth": study.over_depth,
        "shared": list(study.shared),
        "models": [study.model, models] if models else [],
    }
    return {key: part for key, part in content.items() if part}


def _places(places: Places) -> Any:
    return [places.relative, plain(places.values)]


def plain(content: Any) -> Any:
    """Return a value as lists, tables, texts and floats."""
    if isinstance(content, str | bool):
        return content
    if isinstance(content, int | float):
        return float(content) + 0.0 if math.isfinite(content) else str(float(content))
    if isinstance(content, np.ndarray) and content.ndim == 2 and content.size > MOST_NUMBERS_WRITTEN:
        normalized = np.where(np.isnan(content), np.nan, content + 0.0)  # one nan, one zero
        stored = np.ascontiguousarray(normalized, dtype="<f8").tobytes()
        return {"shape": list(content.shape), "sha256": hashlib.sha256(stored).hexdigest()}
    if isinstance(content, np.ndarray):
        return plain(content.tolist())
    if isinstance(content, tuple | list):
        if {float}.issuperset(map(type, content)) and all(map(math.isfinite, content)):
            return [number + 0.0 for number in content]
        return [plain(item) for item in content]
    cls = type(content)
    fields = {field.name: plain(getattr(content, field.name)) for field in dataclasses.fields(content)}
    return {"kind": kind_of(cls) or cls.__name__, **fields}
