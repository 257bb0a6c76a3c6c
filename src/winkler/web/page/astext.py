"""The study as text: the study file of the page, to be read, edited and used."""

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
    take, edit
        Called with the text of another study, and with the edited one; return its mistakes, empty if there are none.
    """

    def __init__(
        self, table: Callable[[], dict[str, Any]], take: Callable[[str], str], edit: Callable[[str], str]
    ) -> None:
        self.table, self.take, self.edit = table, take, edit
        with ui.expansion("The study as text", on_value_change=self.show).classes("astext") as self.fold:
            self.area = ui.textarea().props("outlined input-class=code autogrow").classes("text")
            self.area.props["aria-label"] = "The study as text"
            self.wrong = ui.label().classes("wrong").props('role="alert"')
            ui.button("Use this text", on_click=lambda: self._use(str(self.area.value), self.edit)).props(
                "outline no-caps"
            )

    def show(self) -> None:
        """Update the text, if it is open."""
        if self.fold.value:
            self.area.set_value(tomli_w.dumps(self.table()))

    def _use(self, text: str, take: Callable[[str], str]) -> None:
        """Take a study from its text, and show its mistakes below the text."""
        self.wrong.text = take(text)
        if self.wrong.text:
            self.area.set_value(text)

    def open(self, text: str) -> None:
        """Take and show an opened study file."""
        self.fold.open()
        self._use(text, self.take)
