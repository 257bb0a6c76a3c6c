"""The fields of a sweep: varied numbers, their ranges, and the design."""

from __future__ import annotations

from nicegui import ui

from winkler.web.fields.fields import FormFields
from winkler.web.fields.range_field import draw_range_boxes
from winkler.web.form import sweep_form
from winkler.web.form.ranges import SPACINGS, range_texts
from winkler.web.form.study_form import StudyForm
from winkler.web.form.sweep_form import DESIGN_LABELS, VariedNumber
from winkler.web.session.worker import MOST_POINTS

MEANING = (
    f"Solve for many values of a number, or of several. At most {MOST_POINTS} points here, millions with winkler run."
)


def draw_sweep(fields: FormFields, entered: StudyForm) -> None:
    """Draw the fields of the sweep."""
    varied, others = sweep_form.rows(entered.table)
    with ui.expansion("Vary", value="sweep" in entered.table).classes("astext vary") as fold:
        fold.props["data-fold"] = "sweep"
        ui.label(MEANING).classes("meaning")
        fields.reserve_message("sweep")
        for row in varied:
            _row(fields, entered, row)
        fields.more("sweep", others, "vary also" if varied else "vary", entered.vary)
        if varied:
            _design(fields, entered)


def _row(fields: FormFields, entered: StudyForm, row: VariedNumber) -> None:
    path = f"sweep.{row.key}"

    def give(spacing: str, texts: dict[str, str], anew: bool) -> None:
        entered.vary_over(row.key, spacing, texts, anew=anew)
        if not anew:
            fields.mark(path)

    with fields.marked(path, ui.element("section").classes("part free")):
        fields.line(path, row.label, row.entry.word, "do not vary", lambda: entered.hold_constant(row.key))
        draw_range_boxes(
            fields,
            path,
            row.label,
            (row.spacing, {spacing: SPACINGS[spacing] for spacing in row.spacings}, row.texts),
            give,
            lambda: range_texts(entered.table["sweep"][row.key]),
        )


def _design(fields: FormFields, entered: StudyForm) -> None:
    now = sweep_form.design_kind(entered.table)
    with ui.element("div").classes("entry wide"):
        pick = ui.select(DESIGN_LABELS, value=now if now in DESIGN_LABELS else None, label="which points are solved")
        pick.props("outlined dense options-dense hide-bottom-space no-error-icon")
        pick.classes("choice").props["data-choice"] = "sweep.design"
        pick.on_value_change(lambda event: entered.choose_design(event.value) if event.value else None)
        fields.inputs["sweep.design"] = pick
    for entry in sweep_form.design_entries(entered.table):
        fields.entry(entry, slides=False)
