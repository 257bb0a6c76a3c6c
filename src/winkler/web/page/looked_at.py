"""What an uploaded file is taken for: its columns, what is doubtful, and a button that begins the study."""

from __future__ import annotations

from collections.abc import Callable

from nicegui import ui

from winkler.web.pictures.replies import InspectedFile

__all__ = ["LookedAt"]


class LookedAt:
    """The window that says what a file is.

    Parameters
    ----------
    take
        Takes a study by its text; returns its mistakes.
    """

    def __init__(self, take: Callable[[str], str]) -> None:
        self.take = take
        self.file: InspectedFile | None = None
        with ui.dialog() as self.window, ui.card().classes("looked-at"):
            self.page = ui.html("", sanitize=False).classes("paper")
            with ui.row():
                self.begin = ui.button("Begin the study", icon="play_arrow", on_click=self._begin).props("no-caps")
                self.begin.props["data-look"] = "begin"
                self.save = ui.button("Save the study", icon="description", on_click=self._save).props("flat no-caps")
                self.save.props["data-look"] = "save"
                ui.button("Close", on_click=self.window.close).props("flat no-caps")

    def show(self, file: InspectedFile) -> None:
        """Show what a file is taken for."""
        self.file = file
        self.page.set_content(file.html)
        self.begin.set_visibility(file.shown)
        self.save.set_visibility(bool(file.study))
        self.window.open()

    def _begin(self) -> None:
        if self.file is None:
            return
        self.window.close()
        if mistakes := self.take(self.file.study):
            ui.notify(mistakes, type="negative")

    def _save(self) -> None:
        if self.file is not None:
            ui.download.content(self.file.study.encode(), "study.toml")
