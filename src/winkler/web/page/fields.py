"""The form on the page: a tree of parts becomes fields, lists of kinds and sliders, each with room for its mistake."""

from __future__ import annotations

from typing import Any, Protocol

from nicegui import ui

from winkler.plot.series import pretty_unit
from winkler.study.language.explain import plain_symbol
from winkler.study.report.markup import safe
from winkler.web.form.form import Entry, Many, Part, Slot
from winkler.web.form.sliders import STEPS, span_of
from winkler.web.form.typed import SWITCH
from winkler.web.pictures.words import marked

__all__ = ["FieldActions", "Fields"]

NONE = "—"
NUMBERS = "numbers below"


class FieldActions(Protocol):
    """What a form does to its study."""

    def change(self, path: str, text: str, takes: str) -> None:
        """Put what was typed at a key."""
        ...

    def choose(self, path: str, kind: str) -> None:
        """Put a kind at a place; an empty one leaves it out."""
        ...

    def add(self, path: str, kind: str) -> None:
        """Add a kind to a list."""
        ...

    def read(self, path: str, name: str) -> None:
        """Take a file in place of numbers; an empty name goes back to numbers."""
        ...

    def pick(self, path: str) -> None:
        """Say that the next upload belongs to a place."""
        ...


class Fields:
    """The elements of a form, found by the path of their key.

    Parameters
    ----------
    hands
        What happens when a person changes something.
    files
        Names of what was uploaded.
    picker
        Script that opens the choice of a file.
    """

    def __init__(self, actions: FieldActions, files: tuple[str, ...], picker: str) -> None:
        self.actions, self.files, self.picker = actions, files, picker
        self.inputs: dict[str, Any] = {}
        self.remarks: dict[str, ui.label] = {}

    def draw(self, part: Part) -> None:
        """Draw a part, and those inside it."""
        self.remark(part.path)
        if part.takes_file:
            self._file(part)
        for child in part.children:
            match child:
                case Entry():
                    self.entry(child)
                case Slot():
                    self._slot(child)
                case Many():
                    self._many(child)

    def remark(self, path: str) -> None:
        """Leave room for what is wrong at a path."""
        told = ui.label().classes("wrong").props('role="alert"')
        told.set_visibility(False)
        self.remarks[path] = told

    def heading(self, path: str, title: str, meaning: str) -> None:
        """Draw what stands over some fields, with room for what is wrong with them."""
        ui.label(title).classes("many")
        ui.label(meaning).classes("meaning")
        self.remark(path)

    def say(self, path: str, sentence: str) -> bool:
        """Show a sentence beside the field at a path, or at the nearest part around it; tell whether there is one."""
        field = self.inputs.get(path)
        if field is not None:
            field.props["error"] = True
            field.props["error-message"] = sentence
            field.update()
            return True
        while path:
            if path in self.remarks:
                told = self.remarks[path]
                told.text = f"{told.text} {sentence}".strip()
                told.set_visibility(True)
                return True
            path = path.rpartition(".")[0]
        return False

    def clear(self) -> None:
        """Take back every sentence."""
        for field in self.inputs.values():
            if field.props.get("error"):
                field.props["error"] = False
                field.update()
        for told in self.remarks.values():
            if told.text:
                told.text = ""
                told.set_visibility(False)

    def entry(self, entry: Entry, *, slides: bool = True) -> None:
        """Draw one key; with a slider, unless it counts something."""
        if entry.takes == SWITCH:
            box = ui.checkbox(entry.label, value=entry.text == "true").tooltip(entry.hint)
            box.on_value_change(lambda event: self.actions.change(entry.path, str(event.value).lower(), entry.takes))
            return
        with ui.element("div").classes("entry"):
            field = ui.input(value=entry.text, placeholder="" if entry.required else "left out")
            unit = f" [{safe(pretty_unit(entry.unit))}]" if entry.unit else ""
            with field.add_slot("label"):
                ui.html(f"{safe(entry.label)} {marked(entry.symbol)}{unit}", sanitize=False, tag="span")
            field.props["aria-label"] = f"{entry.label} {plain_symbol(entry.symbol)}{unit}"
            field.props("outlined dense label-slot debounce=250 no-error-icon hide-bottom-space").props["hint"] = (
                entry.hint
            )
            field.props("hide-hint").classes("field").mark(entry.path)
            field.props["data-path"] = entry.path
            if not entry.required:
                field.props("stack-label")
            self.inputs[entry.path] = field
            if not slides:
                field.on_value_change(
                    lambda event: self.actions.change(entry.path, str(event.value or ""), entry.takes)
                )
                return
            slider = self._slider(entry, field)
            field.on_value_change(lambda event: self._typed(entry, str(event.value or ""), slider))

    def _slider(self, entry: Entry, field: Any) -> Any:
        """Return a slider beside a number, hidden where it would tell nothing."""
        slider: Any = ui.slider(min=-STEPS, max=STEPS, step=1, value=0).classes("slide")
        slider.props["aria-label"] = f"{entry.label}, slider"
        slider.props["data-slide"] = entry.path
        slider.held = span_of(entry.path.rpartition(".")[2], entry.text) if _may_slide(entry) else None
        if slider.held:
            slider.set_value(slider.held[1])
        else:
            slider.classes("unseen")
            slider.disable()

        def slide(event: Any) -> None:
            if slider.held is None or event.value == slider.held[1]:
                return
            slider.held = (slider.held[0], event.value)
            field.set_value(slider.held[0].text(event.value))

        slider.on_value_change(slide)
        return slider

    def _typed(self, entry: Entry, text: str, slider: Any) -> None:
        held = slider.held
        if held is None or held[0].text(held[1]) != text:  # typed, not slid
            slider.held = span_of(entry.path.rpartition(".")[2], text) if _may_slide(entry) else None
            slider.set_enabled(slider.held is not None)
            slider.classes(**({"remove": "unseen"} if slider.held else {"add": "unseen"}))
            if slider.held:
                slider.set_value(slider.held[1])
        self.actions.change(entry.path, text, entry.takes)

    def _slot(self, slot: Slot) -> None:
        names = {kind: kind.replace("_", " ") for kind in slot.allowed}
        if not slot.required:
            names = {"": NONE, **names}
        kind = slot.part.kind if slot.part else ""
        single = len(names) == 1
        with ui.element("section").classes("part" if slot.part else "part empty"):
            choice = ui.select(names, value=kind if kind in names else None, label=slot.label)
            choice.props("outlined dense options-dense").props["hint"] = slot.part.meaning if slot.part else slot.hint
            choice.props("hide-hint hide-bottom-space").classes("choice")
            choice.props["data-choice"] = slot.path
            if single:
                choice.props("readonly hide-dropdown-icon")
            choice.on_value_change(lambda event: self.actions.choose(slot.path, event.value or ""))
            if slot.part:
                self.draw(slot.part)

    def _many(self, many: Many) -> None:
        with ui.element("section").classes("part"):
            ui.label(many.label).classes("many")
            for place, part in enumerate(many.parts):
                with ui.element("section").classes("part"):
                    with ui.row().classes("one"):
                        ui.label(f"{place + 1}. {part.kind.replace('_', ' ')}").tooltip(part.meaning)
                        take = ui.button(icon="close", on_click=lambda path=part.path: self.actions.choose(path, ""))
                        take.props("flat dense round size=sm").props["aria-label"] = f"remove {part.kind} {place + 1}"
                    self.draw(part)
            names = {kind: kind.replace("_", " ") for kind in many.allowed}
            more = ui.select(names, label=f"add to {many.label}", value=None).props("outlined dense options-dense")
            more.classes("choice").on_value_change(
                lambda event: self.actions.add(many.path, event.value) if event.value else None
            )

    def _file(self, part: Part) -> None:
        with ui.element("div").classes("entry file"):
            names = {"": NUMBERS, **{name: name for name in dict.fromkeys((*self.files, *filter(None, [part.file])))}}
            choice = ui.select(names, value=part.file, label="from").props("outlined dense options-dense")
            choice.on_value_change(lambda event: self.actions.read(part.path, event.value or ""))
            self.upload(part.path)

    def upload(self, path: str) -> None:
        """Draw the button that uploads a file for a place."""
        button = ui.button("Upload", icon="upload_file").props("outline dense no-caps")
        button.props["data-upload"] = path
        button.on("click", lambda: self.actions.pick(path))
        button.on("click", js_handler=self.picker)


def _may_slide(entry: Entry) -> bool:
    return entry.takes.startswith(("quantity", "number"))
