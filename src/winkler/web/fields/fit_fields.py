"""The fields of a fit: the uploaded curve, the free parameters, and the measurement."""

from __future__ import annotations

import functools
from collections.abc import Callable

from nicegui import ui

from winkler.study.language.explain import plain_symbol
from winkler.web.fields.fields import FormFields
from winkler.web.form import fit_form, form, measurement_form
from winkler.web.form.fit_form import CURVE
from winkler.web.form.measurement_form import Choice
from winkler.web.form.sample_curve import SAMPLE_REMARKS
from winkler.web.form.sample_folder import FOLDER_REMARK
from winkler.web.form.study_form import StudyForm
from winkler.web.session.files import Files
from winkler.web.session.upload_folder import CURVES, SAMPLE_CURVES

FILE_HINT = (
    "A table with columns such as ‘piezo [nm], force [nN]’, a file of a force microscope, also with a whole force map, "
    "or many files that are fitted one after the other."
)
REMARKS = SAMPLE_REMARKS | {SAMPLE_CURVES: FOLDER_REMARK}
OF_TABLES = ("fit.units", "fit.columns", "fit.models", "fit.shared")
BOUNDS_HINT = "Parameters are free between two bounds, from a start value in the first box, or without either."


def draw_curve(fields: FormFields, entered: StudyForm, files: Files, drop: Callable[[], None]) -> None:
    """Draw the file of the curve or the folder of curves, and the choice of the fitted part.

    Parameters
    ----------
    fields, entered
        The form and its study.
    files
        Uploads of the page.
    drop
        Removes the uploaded folder of curves.
    """
    fields.heading(CURVE, "The measured curve", FILE_HINT)
    with ui.element("div").classes("entry file"):
        fields.curves = choice = ui.select({}, label="file, or folder of curves").props("outlined dense options-dense")
        choice.props["data-choice"] = CURVE
        fields.upload(CURVE)
    with ui.element("div").classes("several"):
        for label, icon, script, name in (
            ("Several files", "upload_file", files.curves_picker, "several"),
            ("A whole folder", "drive_folder_upload", files.folder_picker, "folder"),
        ):
            button = ui.button(label, icon=icon).props("flat dense no-caps")
            button.props["data-upload"] = f"{CURVE}.{name}"
            button.on("click", lambda: entered.pick(CURVE))
            button.on("click", js_handler=script)
        fields.drop_curves = ui.button("Remove them", icon="close", on_click=lambda: drop()).props("flat dense no-caps")
    fields.sample = ui.label().classes("meaning")
    show_curve(fields, entered)
    choice.on_value_change(lambda event: _chosen(fields, entered, event.value))
    for one in measurement_form.choices(entered.table):
        _choice(fields, entered, one)


def show_curve(fields: FormFields, entered: StudyForm) -> None:
    """Show the chosen file among those that were uploaded; the other fields stay as they are."""
    chosen = str(form.at(entered.table, CURVE) or "")
    names = {name: name for name in dict.fromkeys((*fields.files, *filter(None, [chosen])))}
    names |= {name: f"{name}: a folder of {count} files" for name, count in fields.folders.items()}
    fields.drop_curves.set_visibility(CURVES in fields.folders)
    if fields.curves is not None:
        fields.curves.set_options(names, value=chosen or None)
        _remark(fields, chosen)


def _remark(fields: FormFields, curve: str) -> None:
    fields.sample.text = REMARKS.get(curve, "")
    fields.sample.set_visibility(curve in REMARKS)


def _chosen(fields: FormFields, entered: StudyForm, name: str | None) -> None:
    if name and name != form.at(entered.table, CURVE):
        _remark(fields, name)
        entered.read_curve(name)


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
    """Draw the entries that the file may lack, and what else is asked of the curve."""
    for group in measurement_form.groups(entered.table):
        with ui.expansion(group.title, value=group.is_used).classes("astext"):
            for entry in group.entries:
                fields.entry(entry, slides=entry.takes.startswith("quantity"))
            for path in OF_TABLES:
                if any(entry.path.startswith(path) for entry in group.entries):
                    fields.reserve_message(path)  # for sentences about what they hold
            for one in group.choices:
                _choice(fields, entered, one)


def _choice(fields: FormFields, entered: StudyForm, one: Choice) -> None:
    with ui.element("div").classes("entry wide"):
        pick = ui.select(one.names, value=one.chosen if one.chosen in one.names else None, label=one.label)
        pick.props("outlined dense options-dense hide-hint hide-bottom-space no-error-icon").props["hint"] = one.hint
        pick.props["data-choice"] = one.path
        pick.on_value_change(
            lambda event: entered.choose_option(one.path, event.value) if event.value is not None else None
        )
        fields.inputs[one.path] = pick
