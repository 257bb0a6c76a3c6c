"""The fields of a fit: the uploaded curve, the free parameters, and the measurement."""

from __future__ import annotations

import functools

from nicegui import ui

from winkler.study.language.explain import plain_symbol
from winkler.web.form import fit_form, form
from winkler.web.form.study_form import StudyForm
from winkler.web.page.fields import FormFields

__all__ = ["draw_curve", "draw_free", "draw_measurement"]

CURVE = "fit.curve"
FILE_HINT = "A table with columns such as ‘piezo [nm], force [nN]’, or a file of a force microscope."
BOUNDS_HINT = "Parameters are free between two bounds, from a start value in the first box, or without either."


def draw_curve(fields: FormFields, entered: StudyForm) -> None:
    """Draw the file of the curve, and the choice of its fitted part."""
    fields.heading("fit.curve", "The measured curve", FILE_HINT)
    with ui.element("div").classes("entry file"):
        chosen = str(form.at(entered.table, CURVE) or "")
        names = {name: name for name in dict.fromkeys((*fields.files, *filter(None, [chosen])))}
        choice = ui.select(names, value=chosen or None, label="file").props("outlined dense options-dense")
        choice.props["data-choice"] = CURVE
        choice.on_value_change(lambda event: entered.read(CURVE, event.value) if event.value else None)
        fields.upload(CURVE)
    for one in fit_form.choices(entered.table):
        with ui.element("div").classes("entry wide"):
            pick = ui.select(one.names, value=one.chosen if one.chosen in one.names else None, label=one.label)
            pick.props("outlined dense options-dense hide-hint hide-bottom-space no-error-icon").props["hint"] = (
                one.hint
            )
            pick.props["data-choice"] = one.path
            pick.on_value_change(
                lambda event, path=one.path: entered.choose_option(path, event.value) if event.value else None
            )
            fields.inputs[one.path] = pick


def draw_free(fields: FormFields, entered: StudyForm) -> None:
    """Draw the free parameters, each with its bounds."""
    free_numbers, others = fit_form.free_numbers(entered.table)
    fields.heading("fit.free", "Free parameters", BOUNDS_HINT)
    for line in free_numbers:
        with ui.element("section").classes("part free"):
            path, spoken = f"fit.free.{line.key}", f"{line.label} {plain_symbol(line.word.symbol)}"
            fields.line(path, line.label, line.word, "do not fit", functools.partial(entered.fix, line.key))
            with ui.element("div").classes("bounds"):
                low = fields.box(f"{path}.0", line.low, "from", spoken, "free, or start")
                high = fields.box(f"{path}.1", line.high, "to", spoken, "free")
            for end in (low, high):
                end.on_value_change(
                    lambda _, line=line, low=low, high=high: entered.bound(
                        line.key, str(low.value or ""), str(high.value or ""), line.word.unit or ""
                    )
                )
    fields.more("fit.free", others, "free also", entered.free)


def draw_measurement(fields: FormFields, entered: StudyForm) -> None:
    """Draw the entries of the measurement that the file may lack."""
    entries = fit_form.measurement(entered.table)
    title = any(entry.text for entry in entries)
    with ui.expansion("The measurement", value=title).classes("astext"):
        for entry in entries:
            fields.entry(entry)
