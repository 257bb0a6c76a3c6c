"""What came of the curves of a batch as lines of text, from which it comes back to the last digit.

A line belongs to one file, or to one curve of the only file, by the hash of its bytes or numbers: a curve that was
changed since is fitted again.  Of the model of a fit only the fitted numbers and the load are kept.
"""

from __future__ import annotations

import dataclasses
import hashlib
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from winkler.errors import InvalidInput, Mistake
from winkler.fitting.compare import AnyFit
from winkler.fitting.curves.checks import Flag
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.outcome import CreepFit, Fit, ViscoelasticFit
from winkler.fitting.parameters import changed
from winkler.io.curves import PlacedCurve, UnreadCurve
from winkler.loading import Depth, Force
from winkler.path import Path as MotionPath
from winkler.study.batch.fit_outcome import Fitted, Refused
from winkler.study.batch.journal import Journal
from winkler.study.batch.lossless import packed, unpacked
from winkler.study.batch.recording import notes_of, plain_notes
from winkler.study.language.fit_study import FitStudy

__all__ = ["Piece", "Results", "fingerprint", "recalled_fits", "results_of", "seen_from", "written_fits"]

Piece = str | PlacedCurve | UnreadCurve
"""A file of many, or a curve of one file."""
Results = tuple[Fitted | Refused, ...]
"""What came of the curves of a piece."""

FITS = {cls.__name__: cls for cls in (Fit, ViscoelasticFit, CreepFit)}
RESTORED = {cls.__name__: cls for cls in (ForceCurve, Flag, Depth, Force)}


def seen_from(study: FitStudy, path: str) -> str:
    """Return a file as seen from the study; file systems hold names that no text can, which are written as escapes."""
    try:
        seen = Path(path).relative_to(study.folder).as_posix()
    except ValueError:
        seen = Path(path).as_posix()
    return seen.encode("utf-8", "backslashreplace").decode()


def fingerprint(study: FitStudy, piece: Piece) -> str:
    """Return the SHA-256 of a piece, name and numbers; empty if it cannot be read: then nothing is known of it."""
    if not isinstance(piece, str):
        content = json.dumps([[seen_from(study, path) for path in study.sources], packed(piece)])
        return hashlib.sha256(content.encode()).hexdigest()
    try:
        with Path(piece).open("rb") as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
    except OSError:
        return ""
    return hashlib.sha256(f"{seen_from(study, piece)}\n{digest}".encode()).hexdigest()


def written_fits(mark: str, results: Results) -> str:
    """Return what came of a piece as one line of JSON; `mark` is its fingerprint."""
    return json.dumps({"of": mark, "curves": [_written(result) for result in results]}, separators=(",", ":"))


def results_of(study: FitStudy, line: dict[str, Any]) -> Results:
    """Return what came of a piece from the line that `written_fits` made of it, taken apart by ``json.loads``."""
    return tuple(_recalled(study, content) for content in line["curves"])


def recalled_fits(study: FitStudy, todo: Sequence[Piece], journal: Journal) -> dict[int, Results]:
    """Return what a journal knows of pieces, by their place among them; an unexpected error may be gone the next time.

    Raises
    ------
    InvalidInput
        If a line does not fit the study.
    """
    if not journal.count:
        return {}
    places = {mark: place for place, piece in enumerate(todo) if (mark := fingerprint(study, piece))}
    try:
        return {
            places[line["of"]]: results_of(study, line)
            for line in journal.recalled()
            if line["of"] in places and all(curve.get("code") != Mistake.exit_code for curve in line["curves"])
        }
    except (KeyError, TypeError, ValueError) as error:
        raise InvalidInput(
            f"journal: '{journal.path}' holds a line that does not fit the study ({error}); add --anew to begin again "
            "without it."
        ) from None


def _written(result: Fitted | Refused) -> dict[str, Any]:
    content = {"name": result.name, "x": packed(result.x), "y": packed(result.y)}
    if isinstance(result, Refused):
        return {**content, "reason": result.reason, "code": result.code}
    return {**content, "steps": result.steps, "notes": plain_notes(result.notes), "fit": _written_fit(result.fit)}


def _written_fit(found: AnyFit) -> dict[str, Any]:
    load = found.model.load if isinstance(found, Fit) else found.model.path.normal
    fields = {field.name: getattr(found, field.name) for field in dataclasses.fields(found) if field.name != "model"}
    content = {name: packed(field) for name, field in fields.items()}
    return {"kind": type(found).__name__, "load": packed(load), **content}


def _recalled(study: FitStudy, content: dict[str, Any]) -> Fitted | Refused:
    name, x, y = content["name"], unpacked(content["x"], {}), unpacked(content["y"], {})
    if "reason" in content:
        return Refused(name, x, y, content["reason"], content["code"])
    found = _recalled_fit(study, content["fit"])
    return Fitted(name, x, y, tuple(content["steps"]), found, notes_of(content["notes"]))


def _recalled_fit(study: FitStudy, content: dict[str, Any]) -> AnyFit:
    parts = {name: unpacked(item, RESTORED) for name, item in content.items() if name != "kind"}
    load, kind = parts.pop("load"), FITS[content["kind"]]
    own = {free.path for free in study.free if free.key.startswith("problem.")}
    numbers = {
        name: number for name, number in zip(parts["names"], parts["values"].tolist(), strict=True) if name in own
    }
    model = changed(study.problem, numbers) if numbers else study.problem
    if kind is Fit:
        return Fit(model=dataclasses.replace(model, load=load), **parts)
    found: AnyFit = kind(model=dataclasses.replace(model, path=MotionPath(parts["curve"].time, load)), **parts)
    return found
