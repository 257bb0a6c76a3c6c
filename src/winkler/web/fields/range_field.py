"""The fields of a range: how the values follow each other, two ends and a count, or a list of values."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from typing import Any, Protocol

from nicegui import ui

from winkler.web.form.form import FormEntry

BOXES = {"from": "from", "to": "to", "count": "how many", "values": "values, with commas between"}
"""Name of a box of a range -> its label."""


class RangeActions(Protocol):
    """Changes of the range of a key."""

    def give_range(self, entry: FormEntry, spacing: str, texts: dict[str, str], *, anew: bool) -> None:
        """Set the range of a key."""

    def give_one(self, path: str) -> None:
        """Replace the range of a key by one number."""


class BoxMaker(Protocol):
    """Draws a box of a range."""

    def box(self, path: str, text: str, label: str, spoken: str, placeholder: str | None = None) -> Any:
        """Draw and return the box."""


def draw_range_boxes(
    fields: BoxMaker,
    path: str,
    label: str,
    shown: tuple[str, Mapping[str, str], Mapping[str, str]],
    give: Callable[[str, dict[str, str], bool], None],
    completed: Callable[[], Mapping[str, str]],
) -> None:
    """Draw the fields of a range.

    Parameters
    ----------
    fields
        Draw the boxes.
    path, label
        Of the number that varies.
    shown
        The spacing, all spacings with their labels, and the contents of the boxes by name.
    give
        Called with spacing, contents, and whether this needs other fields.
    completed
        Returns the contents as the study has them.
    """
    spacing, spacings, texts = shown
    choice = ui.select(dict(spacings), value=spacing if spacing in spacings else None, label="how")
    choice.props("outlined dense options-dense").classes("choice").props["data-choice"] = path
    with ui.element("div").classes("bounds" if len(texts) < 3 else "bounds three"):
        boxes = {name: fields.box(f"{path}.{name}", text, BOXES[name], label) for name, text in texts.items()}

    def entered_texts() -> dict[str, str]:
        return {name: str(box.value or "") for name, box in boxes.items()}

    choice.on_value_change(lambda event: give(event.value, entered_texts(), True))
    for name, box in boxes.items():
        box.on_value_change(lambda _: give(spacing, entered_texts(), False))
        complete_when_left(box, functools.partial(_one_of, completed, name))


def _one_of(completed: Callable[[], Mapping[str, str]], name: str) -> str:
    return completed().get(name, "")


def complete_when_left(field: Any, content: Callable[[], str]) -> None:
    """Show in a field, once it is left, what was made of the typed text."""

    def left() -> None:
        text = content()
        if text and text != str(field.value or ""):
            field.set_value(text)

    field.on("blur", left)
