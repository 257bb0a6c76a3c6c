"""The study as text: everything on the page is one study file, to be read, changed and used."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import tomli_w
from nicegui import ui

__all__ = ["AsText"]


class AsText:
    """A study as text that opens below the form.

    Parameters
    ----------
    table
        Returns the table of the study as it stands.
    take
        Called with the text that a person wants to use; returns what is wrong with it, if anything is.
    """

    def __init__(self, table: Callable[[], dict[str, Any]], take: Callable[[str], str]) -> None:
        self.table, self.take = table, take
        with ui.expansion("The study as text", on_value_change=self.show).classes("astext") as self.fold:
            self.area = ui.textarea().props("outlined input-class=code autogrow").classes("text")
            self.area.props["aria-label"] = "The study as text"
            self.wrong = ui.label().classes("wrong").props('role="alert"')
            ui.button("Use this text", on_click=lambda: self.use(str(self.area.value))).props("outline no-caps")

    def show(self) -> None:
        """Write the study where it is read, if it is."""
        if self.fold.value:
            self.area.set_value(tomli_w.dumps(self.table()))

    def use(self, text: str) -> None:
        """Take a study from its text; say what is wrong with it below the text."""
        self.wrong.text = self.take(text)
        if self.wrong.text:
            self.area.set_value(text)

    def open(self, text: str) -> None:
        """Take a study that was opened, and show it."""
        self.fold.open()
        self.use(text)
