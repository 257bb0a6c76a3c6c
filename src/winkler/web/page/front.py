"""The cards of the examples, with which a page begins."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from nicegui import ui

from winkler.web.form.front_examples import FRONT_EXAMPLES, QUESTIONS

__all__ = ["Front"]


class Front:
    """Cards that begin a study.

    Parameters
    ----------
    take
        Called with the table of the chosen example.
    """

    def __init__(self, take: Callable[[dict[str, Any]], None]) -> None:
        self.take = take
        with ui.element("section").classes("front").props('aria-label="Examples"') as self.place:
            with ui.element("div").classes("front-head"):
                ui.label("Begin with a question or an example, or change the study on the left")
                close = ui.button(icon="close", on_click=lambda: self.show(visible=False)).props("flat dense round")
                close.props["aria-label"] = "close the examples"
            questions = ui.element("div").classes("front-cards front-questions")
            examples = ui.element("div").classes("front-cards")
            for place, one in enumerate(FRONT_EXAMPLES):
                with questions if place < len(QUESTIONS) else examples:
                    with ui.element("button").classes("front-card") as card:
                        ui.label(one.title).classes("front-title")
                        ui.label(one.question).classes("meaning")
                    card.props["type"] = "button"
                    card.props["data-example"] = str(place)
                    card.on("click", functools.partial(self._choose, place))
        self.show(visible=False)

    def _choose(self, place: int) -> None:
        self.show(visible=False)
        self.take(FRONT_EXAMPLES[place].table)

    def show(self, *, visible: bool) -> None:
        """Show or hide the cards."""
        self.place.set_visibility(visible)

    def toggle(self) -> None:
        """Show the cards, or hide them if they are shown."""
        self.show(visible=not self.place.visible)
