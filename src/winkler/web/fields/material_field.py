"""The choice of a material of the table, with its numbers and where they stand."""

from __future__ import annotations

import json
from typing import Any, Protocol

from nicegui import ui

from winkler.study.report.markup import safe
from winkler.web.form.form import FormEntry
from winkler.web.form.materials_menu import material_lines, tabulated

OPTION = """
<q-item v-bind="props.itemProps" :aria-label="props.opt.label">
  <q-item-section><q-item-label v-text="props.opt.label"></q-item-label></q-item-section>
  <q-item-section side class="chapter" v-text="({})[props.opt.label]"></q-item-section>
</q-item>
"""
"""A material in the list, with its most telling numbers."""


class MaterialActions(Protocol):
    """The change of the name of a material."""

    def change(self, path: str, text: str, takes: str) -> None:
        """Set the content of a key."""


class MaterialForm(Protocol):
    """A form with the changes that it makes, and its fields by path."""

    @property
    def actions(self) -> MaterialActions:
        """Changes of the study."""

    inputs: dict[str, Any]

    def mark(self, path: str) -> None:
        """Show whether what stands at a path is an example's."""


def draw_material(fields: MaterialForm, kind: str, entry: FormEntry) -> None:
    """Draw the menu of the materials that can be a body of a kind, and the numbers of the chosen one."""
    numbers = tabulated(kind)
    choice = ui.select([*numbers], value=entry.text if entry.text in numbers else None, label="material")
    choice.props("outlined dense options-dense hide-bottom-space no-error-icon").classes("choice material")
    choice.props["data-choice"] = entry.path
    choice.add_slot("option", OPTION.format(safe(json.dumps(numbers))))
    fields.inputs[entry.path] = choice
    lines = ui.html(_lines(kind, entry.text), sanitize=False).classes("material-lines")

    def chosen(event: Any) -> None:
        if event.value:
            lines.set_content(_lines(kind, event.value))
            fields.actions.change(entry.path, event.value, entry.takes)
            fields.mark(entry.path)

    choice.on_value_change(chosen)


def _lines(kind: str, name: str) -> str:
    """Return the numbers of a material, with their sources below each other."""
    found = material_lines(kind, name)
    numbers = "; ".join(f"{safe(line.name)} {safe(line.number)}" for line in found)
    sources = "".join(f"<li>{safe(line.name)}: {safe(line.source)}</li>" for line in found)
    return f"<p>{numbers}</p><details><summary>Sources</summary><ul>{sources}</ul></details>" if found else ""
