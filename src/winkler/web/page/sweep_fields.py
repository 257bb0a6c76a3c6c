"""The fields of a sweep: which numbers vary, from where to where, and which points are solved."""

from __future__ import annotations

from typing import Any

from nicegui import ui

from winkler.plot.series import pretty_unit
from winkler.study.report.markup import safe
from winkler.web.form import sweep_form
from winkler.web.form.study_form import StudyForm
from winkler.web.form.sweep_form import PLANS, WAYS, Row
from winkler.web.page.fields import Fields
from winkler.web.pictures.words import marked
from winkler.web.session.worker import POINTS

__all__ = ["draw_sweep"]

MEANING = f"Solve for many values of a number, or of several. At most {POINTS} points here, millions with winkler run."
BOXES = {"from": "from", "to": "to", "count": "how many", "values": "values, with commas between"}


def draw_sweep(fields: Fields, entered: StudyForm) -> None:
    """Draw what varies."""
    found, others = sweep_form.rows(entered.table)
    with ui.expansion("Vary", value="sweep" in entered.table).classes("astext vary") as fold:
        fold.props["data-fold"] = "sweep"
        ui.label(MEANING).classes("meaning")
        fields.remark("sweep")
        for row in found:
            _row(fields, entered, row)
        more = ui.select(others, label="vary also" if found else "vary", value=None)
        more.props("outlined dense options-dense").props["data-choice"] = "sweep"
        more.classes("choice").on_value_change(lambda event: entered.vary(event.value) if event.value else None)
        if found:
            _design(fields, entered)


def _row(fields: Fields, entered: StudyForm, row: Row) -> None:
    with ui.element("section").classes("part free"):
        with ui.row().classes("one"):
            unit = f" [{safe(pretty_unit(row.entry.unit))}]" if row.entry.unit else ""
            told = f"{safe(row.label)} {marked(row.entry.symbol)}{unit}"
            ui.html(told, sanitize=False, tag="span").tooltip(row.entry.hint)
            take = ui.button(icon="close", on_click=lambda: entered.still(row.key))
            take.props("flat dense round size=sm").props["aria-label"] = f"do not vary {row.label}"
        fields.remark(f"sweep.{row.key}")
        ways = {way: WAYS[way] for way in row.ways}
        way = ui.select(ways, value=row.way if row.way in ways else None, label="how")
        way.props("outlined dense options-dense").classes("choice").props["data-choice"] = f"sweep.{row.key}"
        boxes: dict[str, Any] = {}
        with ui.element("div").classes("bounds" if len(row.texts) < 3 else "bounds three"):
            for name, text in row.texts.items():
                box = ui.input(value=text, label=BOXES[name])
                box.props("outlined dense stack-label debounce=400 no-error-icon hide-bottom-space").classes("field")
                box.props["aria-label"] = f"{row.label}, {BOXES[name]}"
                box.props["data-path"] = f"sweep.{row.key}.{name}"
                boxes[name] = fields.inputs[f"sweep.{row.key}.{name}"] = box

        def said() -> dict[str, str]:
            return {name: str(box.value or "") for name, box in boxes.items()}

        way.on_value_change(lambda event: entered.vary_over(row.key, event.value, said(), anew=True))
        for box in boxes.values():
            box.on_value_change(lambda _: entered.vary_over(row.key, row.way, said(), anew=False))


def _design(fields: Fields, entered: StudyForm) -> None:
    now = sweep_form.plan(entered.table)
    with ui.element("div").classes("entry wide"):
        pick = ui.select(PLANS, value=now if now in PLANS else None, label="which points are solved")
        pick.props("outlined dense options-dense hide-bottom-space no-error-icon")
        pick.classes("choice").props["data-choice"] = "sweep.design"
        pick.on_value_change(lambda event: entered.redesign(event.value) if event.value else None)
        fields.inputs["sweep.design"] = pick
    for entry in sweep_form.design_entries(entered.table):
        fields.entry(entry, slides=False)
