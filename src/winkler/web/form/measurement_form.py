"""The form of a measurement: fitted part, calibration with its errors, units, corrections, and what else is asked."""

from __future__ import annotations

from typing import Any, NamedTuple

from winkler.io.tables.given_units import KINDS, USUAL
from winkler.study.language.correcting import CORRECTIONS
from winkler.study.language.grammar import SECTIONS
from winkler.web.form import form
from winkler.web.form.fit_form import RELAXES
from winkler.web.form.form import FormEntry

CURVE_PARTS = {
    "approach": "the approach",
    "hold": "the approach and the hold",
    "retract": "the retraction",
    "both": "approach and retraction",
}
DRIVEN = {"force": "forces along the measured motion", "position": "positions under the measured forces"}
CALIBRATED = {"": "\u2014", "thermal": "thermal noise, with this sensitivity", "other": "another way"}
NOISE_SPECTRA = {"": "\u2014", "unknown": "unknown", "white": "white"}
CALIBRATION = {
    "spring_constant": "quantity [N/m]",
    "spring_constant_error": "text",
    "sensitivity": "quantity [m/V]",
    "sensitivity_error": "text",
    "frame_stiffness": "quantity [N/m]",
    "noise": "quantity [N]",
}
COLUMNS = {"columns": "table"}
CURVE_KEYS = {"segments": "list of text", "events": "list of text", "correct": "list of text"}
QUESTIONS = {
    "over_depth": "number",
    "shared": "list of text",
    "model": "text",
    "models": "table",
    "time_limit": "quantity [s]",
}
"""Keys of ``[fit]`` and what they take."""
WORDS = {"correct": "corrections", "over_depth": "number of depths", "shared": "shared by all curves",
         "columns": "columns by number", "model": "name of this model", "models": "other models"}  # fmt: skip
MODELS_EXAMPLE = 'such as { cone = { "problem.bed.profile" = { kind = "cone", half_angle = "60 deg" } } }'
OF_ONE_MODEL = ("part", "fitted", "free", "shared", "model", "models", "over_depth")
"""Keys that another model may not have."""


class Choice(NamedTuple):
    """A key of the measurement that takes one of a few words."""

    path: str
    label: str
    hint: str
    names: dict[str, str]
    chosen: str


class FormGroup(NamedTuple):
    """Entries and choices under one heading."""

    title: str
    entries: tuple[FormEntry, ...]
    choices: tuple[Choice, ...] = ()

    @property
    def is_used(self) -> bool:
        """Whether any of them is given."""
        return any(entry.text for entry in self.entries) or any(one.chosen for one in self.choices)


def choices(table: dict[str, Any]) -> tuple[Choice, ...]:
    """Return the choices of the fitted part and quantity of the curve."""
    relaxes = form.at(table, "problem.kind") == RELAXES
    parts = {name: CURVE_PARTS[name] for name in CURVE_PARTS if name != ("retract" if relaxes else "hold")}
    section_keys = SECTIONS["fit"]
    result = [Choice("fit.part", "part of the curve", section_keys["part"], parts, str(form.at(table, "fit.part")))]
    if relaxes:
        driven = str(form.at(table, "fit.fitted") or "force")
        result.append(Choice("fit.fitted", "what is fitted", section_keys["fitted"], DRIVEN, driven))
    return tuple(result)


def groups(table: dict[str, Any]) -> tuple[FormGroup, ...]:
    """Return the entries of the measurement, and of what else is asked of the curve, by subject."""
    by = Choice(
        "fit.spring_constant_by",
        "spring constant by",
        SECTIONS["fit"]["spring_constant_by"],
        CALIBRATED,
        str(form.at(table, "fit.spring_constant_by") or ""),
    )
    units = tuple(
        form.entry_at(
            table, f"fit.units.{name}", f"unit of {name}", f"if the file states none, such as {USUAL[name]}", "text"
        )
        for name in KINDS
    )
    spectrum = Choice(
        "fit.noise_spectrum",
        "spectrum of the noise",
        SECTIONS["fit"]["noise_spectrum"],
        NOISE_SPECTRA,
        str(form.at(table, "fit.noise_spectrum") or ""),
    )
    return (
        FormGroup("Calibration", _entries(table, CALIBRATION), (by, spectrum)),
        FormGroup("Units of columns", (*units, *_entries(table, COLUMNS))),
        FormGroup("What was done", _entries(table, CURVE_KEYS)),
        FormGroup("Depths and models", _entries(table, QUESTIONS)),
    )


def _entries(table: dict[str, Any], keys: dict[str, str]) -> tuple[FormEntry, ...]:
    hints = SECTIONS["fit"] | {
        "correct": f"in their order, any of {', '.join(CORRECTIONS)}; no other correction is applied",
        "models": f"each by what differs from this model, {MODELS_EXAMPLE}",
    }
    entries = []
    for name, takes in keys.items():
        if name == "noise" and form.at(table, "fit.fitted") == "position":
            takes = "quantity [m]"
        unit = takes.partition("[")[2].rstrip("]")
        label = WORDS.get(name) or name.replace("_", " ").replace("error", "standard error")
        entries.append(form.entry_at(table, f"fit.{name}", label, hints[name], takes, unit=unit))
    return tuple(entries)


def kept(table: dict[str, Any]) -> dict[str, Any]:
    """Return what ``[fit]`` holds of the measurement, which stays when the model changes."""
    return {name: content for name, content in table["fit"].items() if name not in OF_ONE_MODEL}
