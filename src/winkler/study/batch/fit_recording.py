"""Results of the curves of a batch as lines of JSON, from which they are restored to the last digit.

A line belongs to one file, or to one curve of the only file, by the hash of its bytes or numbers: a curve that was
changed since is fitted again.  Of the model of a fit only the fitted numbers and the load are stored.
"""

from __future__ import annotations

import dataclasses
import hashlib
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from winkler.fitting.compare import AnyFit
from winkler.fitting.curves.checks import Flag
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.examined.calibrated import CalibrationShares
from winkler.fitting.examined.over_depth import DepthSeries
from winkler.fitting.outcome import CreepFit, Fit, ViscoelasticFit
from winkler.fitting.parameters import changed
from winkler.fitting.validity import load_of, with_load
from winkler.io.curves import PlacedCurve, UnreadCurve
from winkler.loading.loads import Depth, Force
from winkler.loading.path import Path as MotionPath
from winkler.study.batch.fit_further import NOTHING, Further
from winkler.study.batch.fit_outcome import Fitted, Refused
from winkler.study.batch.journal import Journal
from winkler.study.batch.lossless import packed, unpacked
from winkler.study.batch.recording import notes_of, plain_notes
from winkler.study.language.fit_study import Alternative, FitStudy
from winkler.values.errors import InvalidInput, Mistake

Piece = str | PlacedCurve | UnreadCurve
"""A file of many, or a curve of one file."""
Results = tuple[Fitted | Refused, ...]
"""Results of the curves of a piece."""

FIT_CLASSES = {cls.__name__: cls for cls in (Fit, ViscoelasticFit, CreepFit)}
RESTORED_CLASSES = {cls.__name__: cls for cls in (ForceCurve, Flag, Depth, Force, CalibrationShares, DepthSeries)}


def path_from_study(study: FitStudy, path: str) -> str:
    """Return the path of a file relative to the study; names that cannot be encoded are written as escapes."""
    try:
        relative = Path(path).relative_to(study.folder).as_posix()
    except ValueError:
        relative = Path(path).as_posix()
    return relative.encode("utf-8", "backslashreplace").decode()


def fingerprint(study: FitStudy, piece: Piece) -> str:
    """Return the SHA-256 of a piece, name and numbers; empty if it cannot be read: then it has no earlier results."""
    if not isinstance(piece, str):
        content = json.dumps([[path_from_study(study, path) for path in study.sources], packed(piece)])
        return hashlib.sha256(content.encode()).hexdigest()
    try:
        with Path(piece).open("rb") as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
    except OSError:
        return ""
    return hashlib.sha256(f"{path_from_study(study, piece)}\n{digest}".encode()).hexdigest()


def written_fits(mark: str, results: Results) -> str:
    """Return the results of a piece as one line of JSON; `mark` is its fingerprint."""
    return json.dumps({"of": mark, "curves": [_written(result) for result in results]}, separators=(",", ":"))


def results_of(study: FitStudy, line: dict[str, Any]) -> Results:
    """Return the results of a piece from its line of JSON, parsed by ``json.loads``."""
    return tuple(_recalled(study, content) for content in line["curves"])


def recalled_fits(study: FitStudy, todo: Sequence[Piece], journal: Journal) -> dict[int, Results]:
    """Return the results of pieces in a journal, by their place; those with an unexpected error are left out.

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
    made = {"steps": result.steps, "notes": plain_notes(result.notes), "fit": _written_fit(result.fit)}
    return {**content, **made, **({"further": _written_further(result.further)} if result.further != NOTHING else {})}


def _written_further(further: Further) -> dict[str, Any]:
    plain = {name: packed(getattr(further, name)) for name in ("shares", "depths", "names", "refused")}
    return {**plain, "fits": [_written_fit(one) for one in further.fits]}


def _recalled_further(study: FitStudy, content: dict[str, Any]) -> Further:
    parts = {name: unpacked(part, RESTORED_CLASSES) for name, part in content.items() if name != "fits"}
    others = {one.name: one for one in study.models}
    of = [others[name] for name in parts["names"]]
    fits = tuple(_recalled_fit(one, fit) for one, fit in zip(of, content["fits"], strict=True))
    return Further(**parts, fits=fits)


def _written_fit(fitted_curve: AnyFit) -> dict[str, Any]:
    load = load_of(fitted_curve.model) if isinstance(fitted_curve, Fit) else fitted_curve.model.path.normal
    fields = {
        field.name: getattr(fitted_curve, field.name)
        for field in dataclasses.fields(fitted_curve)
        if field.name != "model"
    }
    content = {name: packed(field) for name, field in fields.items()}
    return {"kind": type(fitted_curve).__name__, "load": packed(load), **content}


def _recalled(study: FitStudy, content: dict[str, Any]) -> Fitted | Refused:
    name, x, y = content["name"], unpacked(content["x"], {}), unpacked(content["y"], {})
    if "reason" in content:
        return Refused(name, x, y, content["reason"], content["code"])
    fitted_curve = _recalled_fit(study, content["fit"])
    further = _recalled_further(study, content["further"]) if "further" in content else NOTHING
    return Fitted(name, x, y, tuple(content["steps"]), fitted_curve, notes_of(content["notes"]), further)


def _recalled_fit(study: FitStudy | Alternative, content: dict[str, Any]) -> AnyFit:
    parts = {name: unpacked(item, RESTORED_CLASSES) for name, item in content.items() if name != "kind"}
    load, kind = parts.pop("load"), FIT_CLASSES[content["kind"]]
    own = {free.path for free in study.free if free.key.startswith("problem.")}
    numbers = {
        name: number for name, number in zip(parts["names"], parts["values"].tolist(), strict=True) if name in own
    }
    model = changed(study.problem, numbers) if numbers else study.problem
    if kind is Fit:
        return Fit(model=with_load(model, load), **parts)
    fitted_curve: AnyFit = kind(model=dataclasses.replace(model, path=MotionPath(parts["curve"].time, load)), **parts)
    return fitted_curve
