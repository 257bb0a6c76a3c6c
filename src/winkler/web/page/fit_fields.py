"""The fields of a fit: the uploaded curve, the free parameters, and the measurement."""

from __future__ import annotations

from typing import Any

from nicegui import ui

from winkler.plot.series import pretty_unit
from winkler.study.language.explain import plain_symbol
from winkler.study.report.markup import safe
from winkler.web.form import fit_form, form
from winkler.web.form.study_form import StudyForm
from winkler.web.page.fields import FormFields
from winkler.web.pictures.words import symbol_html

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
            with ui.row().classes("one"):
                unit = f" [{safe(pretty_unit(line.word.unit))}]" if line.word.unit else ""
                title = f"{safe(line.label)} {symbol_html(line.word.symbol)}{unit}"
                ui.html(title, sanitize=False, tag="span").tooltip(line.word.meaning)
                take = ui.button(icon="close", on_click=lambda key=line.key: entered.fix(key))
                take.props("flat dense round size=sm").props["aria-label"] = f"do not fit {line.label}"
            fields.reserve_message(f"fit.free.{line.key}")
            with ui.element("div").classes("bounds"):
                ends = [_bound(fields, line, place) for place in (0, 1)]
            for end in ends:
                end.on_value_change(
                    lambda _, line=line, ends=ends: entered.bound(
                        line.key, str(ends[0].value or ""), str(ends[1].value or ""), line.word.unit or ""
                    )
                )
    more = ui.select(others, label="free also", value=None).props("outlined dense options-dense")
    more.props["data-choice"] = "fit.free"
    more.classes("choice").on_value_change(lambda event: entered.free(event.value) if event.value else None)


def _bound(fields: FormFields, line: fit_form.FreeNumber, place: int) -> Any:
    name, text = ("from", line.low) if place == 0 else ("to", line.high)
    field = ui.input(value=text, label=name, placeholder="free" if place else "free, or start")
    field.props("outlined dense stack-label debounce=400 no-error-icon hide-bottom-space").classes("field")
    symbol = plain_symbol(line.word.symbol)
    field.props["aria-label"] = f"{line.label} {symbol}, {name}"
    field.props["data-path"] = f"fit.free.{line.key}.{place}"
    fields.inputs[f"fit.free.{line.key}.{place}"] = field
    return field


def draw_measurement(fields: FormFields, entered: StudyForm) -> None:
    """Draw the entries of the measurement that the file may lack."""
    entries = fit_form.measurement(entered.table)
    title = any(entry.text for entry in entries)
    with ui.expansion("The measurement", value=title).classes("astext"):
        for entry in entries:
            fields.entry(entry)
