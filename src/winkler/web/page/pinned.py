"""A pinned answer A: the next ones are compared with it, in a table and in the pictures."""

from __future__ import annotations

from collections.abc import Callable

from nicegui import ui

from winkler.web.pictures.comparison import comparison
from winkler.web.pictures.replies import AnswerText

__all__ = ["PinnedAnswer"]

DRAWN = "Dotted curves in the pictures are A."


class PinnedAnswer:
    """The button that pins an answer, and the comparison with it.

    Parameters
    ----------
    redraw
        Called when the pinned pictures have changed.
    """

    def __init__(self, redraw: Callable[[], None]) -> None:
        self.redraw = redraw
        self.answer: AnswerText | None = None
        self.charts: dict[str, str] = {}
        self.current: tuple[AnswerText | None, dict[str, str]] = (None, {})
        with ui.element("section").classes("pinned").props('aria-label="Comparison"'):
            with ui.row().classes("pin-line"):
                self.button = ui.button("Pin as A, to compare", icon="push_pin", on_click=self._toggle)
                self.button.props("outline dense no-caps").props["data-pin"] = "pin"
            self.table = ui.html("", sanitize=False).classes("paper compared")
        self.table.set_visibility(False)

    def _toggle(self) -> None:
        answer, charts = self.current
        self._pin(*((None, {}) if self.answer else (answer, dict(charts))))

    def drop(self) -> None:
        """Forget both answers, as the next ones are of another task."""
        self.current = (None, {})
        self._pin(None, {})

    def _pin(self, answer: AnswerText | None, charts: dict[str, str]) -> None:
        self.answer, self.charts = answer, charts
        self.button.text = "Unpin A" if self.answer else "Pin as A, to compare"
        self.show(*self.current)
        self.redraw()

    def show(self, answer: AnswerText | None, charts: dict[str, str]) -> None:
        """Compare an answer, and remember it with its pictures as what may be pinned."""
        self.current = (answer, charts)
        self.table.set_visibility(self.answer is not None)
        if self.answer is not None and answer is not None:
            pair = ((self.answer.text, self.answer.numbers), (answer.text, answer.numbers))
            self.table.set_content(f"<h3>A against B</h3>{comparison(*pair)}<p class='small'>{DRAWN}</p>")
