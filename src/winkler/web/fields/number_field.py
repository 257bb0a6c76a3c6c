"""The unit beside the field of a number: a menu of other units, and bare numbers taken in the shown one."""

from __future__ import annotations

import re
from typing import Any

from nicegui import ui

from winkler.values.readable import pretty_unit
from winkler.web.fields.range_field import RangeActions, complete_when_left
from winkler.web.form.field_units import completed_text, in_unit, offered_units, shown_unit
from winkler.web.form.form import FormEntry
from winkler.web.form.ranges import EVEN, first_range, takes_range

POWER = re.compile(r"\de-?\d")
ITEM = 'role="menuitem"'


class UnitMenu:
    """The unit beside a number, as a button that opens a menu.

    Parameters
    ----------
    entry
        The key.
    field
        Its field.
    actions
        Change its range.
    """

    def __init__(self, entry: FormEntry, field: Any, actions: RangeActions) -> None:
        self.entry, self.field, self.actions = entry, field, actions
        self.units = offered_units(entry.unit, entry.path)
        self.unit = shown_unit(entry.text, entry.unit) if self.units else ""
        self.text = entry.text
        self.button: Any = None
        if len(self.units) > 1 or takes_range(entry):
            with field.add_slot("append"):
                self.button = ui.button(on_click=self._fill).props(
                    "flat dense no-caps size=sm icon-right=arrow_drop_down"
                )
                self.button.classes("unit").props["data-unit"] = entry.path
                with self.button:
                    self.menu = ui.menu().props('auto-close role="menu"')
            self._label()
        complete_when_left(field, lambda: self.text)

    def _label(self) -> None:
        """Show the unit where the text has none; where it has one, the arrow alone."""
        if self.button is None:
            return
        bare = bool(self.units) and not shown_unit(str(self.field.value or ""), "")
        self.button.text = _pretty(self.unit) if bare else ""
        spoken = f"unit of {self.entry.label}: {self.unit}" if self.units else "a range"
        if self.button.props.get("aria-label") != spoken:  # setting it makes the whole page look for what has changed
            self.button.props["aria-label"] = spoken

    def completed(self, text: str) -> str:
        """Return a typed text with its unit and decimal points, and show its unit from now on."""
        self.text = completed_text(text, self.entry.takes, self.unit)
        if self.units:
            self.unit = shown_unit(self.text, self.unit)
        self._label()
        return self.text

    def _fill(self) -> None:
        """Fill the menu with the same quantity in other units."""
        self.menu.clear()
        items = [item.strip() for item in self.text.split(", ")]
        with self.menu:
            for unit in self.units if len(self.units) > 1 else ():
                converted = [in_unit(item, unit, self.entry.unit) for item in items]
                same = ", ".join(one for one in converted if one) if all(converted) else ""
                if POWER.search(same):
                    continue  # nobody counts steel in 10⁸ nN
                shown = _pretty(same or unit)
                ui.menu_item(shown, lambda unit=unit, same=same: self._choose(unit, same)).props(ITEM)
            if takes_range(self.entry):
                ui.menu_item("a range: from, to, how many", self._vary).props(ITEM)

    def _vary(self) -> None:
        start = self.entry._replace(text=self.text)
        texts = {"values": self.text} if "," in self.text else first_range(start)
        self.actions.give_range(start, EVEN, texts, anew=True)

    def _choose(self, unit: str, same: str) -> None:
        self.unit = unit
        if same:
            self.field.set_value(same)
        self._label()


def _pretty(text: str) -> str:
    return pretty_unit(re.sub(r"\bu(?=[A-Za-z])", "µ", text))
