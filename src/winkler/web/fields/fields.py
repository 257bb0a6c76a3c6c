"""The form on the page: fields, lists of kinds and sliders for a tree of parts, each with a label for mistakes."""

from __future__ import annotations

import functools
import json
from collections.abc import Callable
from typing import Any, Protocol

from nicegui import ui
from nicegui.elements.mixins.disableable_element import DisableableElement
from nicegui.elements.mixins.value_element import ValueElement

from winkler.plot.series import pretty_unit
from winkler.study.language.explain import plain_symbol
from winkler.study.report.markup import safe
from winkler.values.vocabulary import Word
from winkler.web.fields.material_field import draw_material
from winkler.web.fields.number_field import UnitMenu
from winkler.web.fields.range_field import RangeActions, draw_range_boxes
from winkler.web.form.form import FormEntry, FormPart, Many, Slot
from winkler.web.form.materials_menu import NAMED
from winkler.web.form.ranges import SPACINGS, is_range, range_texts, spacing_of
from winkler.web.form.sliders import STEPS, span_of
from winkler.web.form.typed import CHOICE, SWITCH, typed
from winkler.web.pictures.words import symbol_html

NONE = "—"
PLAIN = {
    "problem.bed": "shape and bodies",
    "problem.contact": "how the bodies touch",
    "bed.profile": "what presses",
    "bed.medium": "the bodies",
    "medium.first": "into what",
    "medium.second": "of what the pressing body is made",
    "problem.load": "how hard",
    "problem.normal": "how hard",
}
"""End of a path -> plain words beside the name of the place."""
NUMBERS = "numbers below"
ASSUMED = "Of an example: nobody has given this."


class FormFields:
    """The elements of a form by the path of their key.

    Parameters
    ----------
    actions
        Changes of the study.
    files
        Names of the uploaded files.
    picker
        Script that opens the choice of a file.
    folders
        Folder of curves -> how many files are in it.
    """

    def __init__(self, actions: FieldActions, files: tuple[str, ...], picker: str, folders: dict[str, int]) -> None:
        self.actions, self.files, self.picker, self.folders = actions, files, picker, folders
        self.inputs: dict[str, Any] = {}
        self.curves: Any = None
        self.sample: Any = None
        self.drop_curves: Any = None
        self.messages: dict[str, ui.label] = {}
        self.frames: dict[str, ui.element] = {}

    def draw(self, part: FormPart) -> None:
        """Draw a part, and those inside it."""
        self.reserve_message(part.path)
        if part.takes_file:
            self._file(part)
        for child in part.children:
            match child:
                case FormEntry() if part.kind.startswith(NAMED) and child.label == "name":
                    with self.marked(child.path, ui.element("div").classes("entry wide")):
                        draw_material(self, part.kind, child)
                case FormEntry():
                    self.entry(child)
                case Slot():
                    self._slot(child)
                case Many():
                    self._many(child)

    def reserve_message(self, path: str) -> None:
        """Add an empty label for the mistake at a path."""
        label = ui.label().classes("wrong").props('role="alert"')
        label.set_visibility(False)
        self.messages[path] = label

    def heading(self, path: str, title: str, meaning: str) -> None:
        """Draw a heading of fields, with a label for their mistakes."""
        ui.label(title).classes("many")
        ui.label(meaning).classes("meaning")
        self.reserve_message(path)

    def line(self, path: str, label: str, word: Word, how: str, drop: Callable[[], None]) -> None:
        """Draw the name of one of several numbers, a button that drops it, and a label for its mistakes."""
        with ui.row().classes("one"):
            ui.html(_title(label, word), sanitize=False, tag="span").tooltip(word.meaning)
            _close(f"{how} {label}", drop)
        self.reserve_message(path)

    def box(self, path: str, text: str, label: str, spoken: str, placeholder: str | None = None) -> Any:
        """Draw and return the box of one end or count of a range; `spoken` names it for screen readers."""
        field = ui.input(value=text, label=label, placeholder=placeholder)
        field.props("outlined dense stack-label debounce=400 no-error-icon hide-bottom-space").classes("field")
        field.props["aria-label"] = f"{spoken}, {label}"
        field.props["data-path"] = path
        self.inputs[path] = field
        return field

    def more(self, path: str, names: dict[str, str], label: str, add: Callable[[str], None]) -> None:
        """Draw the choice of one more number or kind."""
        choice = ui.select(names, label=label, value=None).props("outlined dense options-dense").classes("choice")
        choice.props["data-choice"] = path
        choice.on_value_change(lambda event: add(event.value) if event.value else None)

    def show_mistake(self, path: str, sentence: str) -> bool:
        """Show a mistake beside the field at a path, or at the nearest enclosing part; return whether there is one."""
        field = self.inputs.get(path)
        if field is not None:
            field.props["error"] = True
            field.props["error-message"] = sentence
            field.update()
            return True
        while path:
            if path in self.messages:
                label = self.messages[path]
                label.text = f"{label.text} {sentence}".strip()
                label.set_visibility(True)
                return True
            path = path.rpartition(".")[0]
        return False

    def clear(self) -> None:
        """Remove all mistakes."""
        for field in self.inputs.values():
            if field.props.get("error"):
                field.props["error"] = False
                field.update()
        for label in self.messages.values():
            if label.text:
                label.text = ""
                label.set_visibility(False)

    def entry(self, entry: FormEntry, *, slides: bool = True) -> None:
        """Draw one key, with a slider if `slides`."""
        if entry.takes == SWITCH:
            box = ui.checkbox(entry.label, value=entry.text == "true").tooltip(entry.hint)
            box.on_value_change(lambda event: self.actions.change(entry.path, str(event.value).lower(), entry.takes))
            return
        if entry.takes.startswith(CHOICE):
            self._choice(entry)
            return
        if is_range(typed(entry.text, entry.takes)):
            self._range(entry)
            return
        with self.marked(entry.path, ui.element("div").classes("entry")):
            field = LiveInput(value=entry.text, placeholder="" if entry.required else "optional")
            menu = UnitMenu(entry, field, self.actions)
            unit = "" if menu.button else entry.unit
            with field.add_slot("label"):
                ui.html(_title(entry.label, entry.word._replace(unit=unit)), sanitize=False, tag="span")
            field.props["aria-label"] = f"{entry.label} {plain_symbol(entry.symbol)}{_unit(unit)}"
            field.props("outlined dense label-slot debounce=250 no-error-icon hide-bottom-space").props["hint"] = (
                entry.hint
            )
            field.props("hide-hint").classes("field").mark(entry.path)
            field.props["data-path"] = entry.path
            if not entry.required:
                field.props("stack-label")
            self.inputs[entry.path] = field
            if not slides:
                field.on_value_change(lambda event: self._give(entry, menu.completed(str(event.value or ""))))
                return
            slider = self._slider(entry, field)
            field.on_value_change(lambda event: self._typed(entry, menu.completed(str(event.value or "")), slider))

    def _choice(self, entry: FormEntry) -> None:
        """Draw a key that takes one of a few words."""
        words = entry.takes.removeprefix(CHOICE).split(", ")
        names = {word: word for word in words} if entry.required else {"": NONE, **{word: word for word in words}}
        with self.marked(entry.path, ui.element("div").classes("entry wide")):
            pick = ui.select(names, value=entry.text if entry.text in names else None, label=entry.label)
            pick.props("outlined dense options-dense hide-hint hide-bottom-space no-error-icon").props["hint"] = (
                entry.hint
            )
            pick.props["data-choice"] = entry.path
            pick.on_value_change(lambda event: self._give(entry, str(event.value or "")))
            self.inputs[entry.path] = pick

    def _range(self, entry: FormEntry) -> None:
        """Draw a key that holds a range."""
        content = typed(entry.text, entry.takes)
        texts = {"from": "", "to": "", "count": "", **range_texts(content)}
        with self.marked(entry.path, ui.element("section").classes("part free")):
            one = functools.partial(self.actions.give_one, entry.path)
            self.line(entry.path, entry.label, entry.word, "one value in place of the range of", one)
            draw_range_boxes(
                self,
                entry.path,
                entry.label,
                (spacing_of(content), SPACINGS, texts),
                functools.partial(self._give_range, entry),
                lambda: range_texts(self.actions.content(entry.path)),
            )

    def _give_range(self, entry: FormEntry, spacing: str, texts: dict[str, str], anew: bool) -> None:
        self.actions.give_range(entry, spacing, texts, anew=anew)
        if not anew:
            self.mark(entry.path)

    def _slider(self, entry: FormEntry, field: Any) -> Any:
        """Return a slider beside a number, hidden if the content has none."""
        slider: Any = PlaceSlider(STEPS).classes("slide")
        slider.props["aria-label"] = f"{entry.label}, slider"
        slider.props["data-slide"] = entry.path
        slider.span = span_of(entry.path.rpartition(".")[2], entry.text) if _may_slide(entry) else None
        if slider.span:
            slider.set_value(slider.span[1])
        else:
            slider.classes("unseen")
            slider.disable()

        def slide(event: Any) -> None:
            if slider.span is None or event.value == slider.span[1]:
                return
            slider.span = (slider.span[0], event.value)
            field.set_value(slider.span[0].text(event.value))

        slider.on_value_change(slide)
        return slider

    def _typed(self, entry: FormEntry, text: str, slider: Any) -> None:
        span = slider.span
        if span is None or span[0].text(span[1]) != text:  # typed, not slid
            slider.span = span_of(entry.path.rpartition(".")[2], text) if _may_slide(entry) else None
            slider.set_enabled(slider.span is not None)
            slider.classes(**({"remove": "unseen"} if slider.span else {"add": "unseen"}))
            if slider.span:
                slider.set_value(slider.span[1])
        self._give(entry, text)

    def _give(self, entry: FormEntry, text: str) -> None:
        """Set the content of a key, which is the user's from now on."""
        self.actions.change(entry.path, text, entry.takes)
        self.mark(entry.path)

    def marked(self, path: str, frame: ui.element) -> ui.element:
        """Return a frame that is marked as long as what stands at its path is an example's."""
        self.frames[path] = frame
        self.mark(path)
        return frame

    def mark(self, path: str) -> None:
        """Show around a field whether its number is an example's; the field itself is left alone while one types."""
        frame, is_assumed = self.frames[path], self.actions.is_assumed(path)
        if is_assumed != ("title" in frame.props):
            frame.classes(**{"add" if is_assumed else "remove": "assumed"})
            if is_assumed:
                frame.props["title"] = ASSUMED
            else:
                del frame.props["title"]

    def _slot(self, slot: Slot) -> None:
        names = {kind: _kind_in_words(kind) for kind in slot.allowed}
        if not slot.required:
            left_out = f"{NONE} {slot.otherwise.replace('_', ' ')}".rstrip()
            names = {"": left_out, **names}
        kind = slot.part.kind if slot.part else ""
        single = len(names) == 1
        with ui.element("section").classes("part" if slot.part else "part empty"):
            plain = next((f": {words}" for end, words in PLAIN.items() if slot.path.endswith(end)), "")
            choice = ui.select(names, value=kind if kind in names else None, label=f"{slot.label}{plain}")
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
                        _close(f"remove {part.kind} {place + 1}", functools.partial(self.actions.choose, part.path, ""))
                    self.draw(part)
            names = {kind: kind.replace("_", " ") for kind in many.allowed}
            self.more(many.path, names, f"add to {many.label}", lambda kind: self.actions.add(many.path, kind))

    def _file(self, part: FormPart) -> None:
        with ui.element("div").classes("entry file"):
            names = {"": NUMBERS, **{name: name for name in dict.fromkeys((*self.files, *filter(None, [part.file])))}}
            choice = ui.select(names, value=part.file, label="from").props("outlined dense options-dense")
            choice.on_value_change(lambda event: self.actions.read(part.path, event.value or ""))
            self.upload(part.path)

    def upload(self, path: str) -> None:
        """Draw the button that uploads a file for a path."""
        button = ui.button("Upload", icon="upload_file").props("outline dense no-caps")
        button.props["data-upload"] = path
        button.on("click", lambda: self.actions.pick(path))
        button.on("click", js_handler=self.picker)


def _kind_in_words(kind: str) -> str:
    return (
        f"{kind.removeprefix(NAMED).replace('_', ' ')}, material from the table"
        if kind.startswith(NAMED)
        else kind.replace("_", " ")
    )


def _unit(unit: str | None) -> str:
    return f" [{safe(pretty_unit(unit))}]" if unit else ""


def _title(label: str, word: Word) -> str:
    name = "" if label == word.symbol else f"{safe(label)} "
    return f"{name}{symbol_html(word.symbol)}{_unit(word.unit)}"


def _close(label: str, drop: Callable[[], None]) -> None:
    """Draw a button that drops something; `label` names it for screen readers."""
    take = ui.button(icon="close", on_click=lambda: drop())
    take.props("flat dense round size=sm").props["aria-label"] = label


def _may_slide(entry: FormEntry) -> bool:
    return entry.takes.startswith(("quantity", "number"))


class FieldActions(RangeActions, Protocol):
    """Changes that a form makes to its study."""

    def change(self, path: str, text: str, takes: str) -> None:
        """Set the typed content of a key."""

    def choose(self, path: str, kind: str) -> None:
        """Set a kind at a path; an empty one removes it."""

    def add(self, path: str, kind: str) -> None:
        """Add a kind to a list."""

    def read(self, path: str, name: str) -> None:
        """Replace numbers by a file; an empty name restores numbers."""

    def pick(self, path: str) -> None:
        """Set the path for which the next upload is meant."""

    def content(self, path: str) -> Any:
        """Return the content of a key."""

    def is_assumed(self, path: str) -> bool:
        """Return whether a key holds what an example says, and nobody has given."""


PUT = """
const field = getElement({id});
if (field && field.inputValue !== {text}) {{
  field.emitting = false;
  field.inputValue = {text};
  field.$nextTick(() => (field.emitting = true));
}}
"""
"""Writes into a field as its own script does; nothing is sent back."""


class PlaceSlider(ValueElement[float], DisableableElement, component="slide.js"):
    """A slider for the places from ``-most`` to ``most`` in steps of one."""

    VALUE_PROP = "value"
    LOOPBACK = None  # it moves by itself

    def __init__(self, most: int) -> None:
        super().__init__(value=0, throttle=0.05)
        self.props.update({"min": -most, "max": most, "step": 1})

    def _handle_value_change(self, value: Any) -> None:
        is_mine, self._send_update_on_value_change = self._send_update_on_value_change, False
        super()._handle_value_change(value)
        self._send_update_on_value_change = is_mine
        if is_mine:
            self.run_method("put", value)


class LiveInput(ui.input):
    """A text field."""

    def _handle_value_change(self, value: Any) -> None:
        is_mine, self._send_update_on_value_change = self._send_update_on_value_change, False
        super()._handle_value_change(value)
        self._send_update_on_value_change = is_mine
        if is_mine:
            self.client.run_javascript(PUT.format(id=self.id, text=json.dumps(value or "")))
