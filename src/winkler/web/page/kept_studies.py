"""Keeps the work of a page: in its address, in the store of its tab, as steps for undo, and as named studies."""

from __future__ import annotations

import base64
import binascii
from collections.abc import Callable
from typing import Any

from nicegui import events, ui

from winkler.study.language.reading import parsed
from winkler.values.errors import InvalidInput, WinklerError
from winkler.web.form.link import LONGEST_LINK, code_of, study_of
from winkler.web.form.sample_curve import SAMPLES
from winkler.web.form.undo import UndoStates
from winkler.web.session.upload_folder import SAMPLE_CURVES, UploadFolder, files_in

STUDY = "study.toml"
MOST_KEPT_FILES = 500_000
"""Most bytes of uploaded files that are kept for a reload."""
MADE = {*SAMPLES, SAMPLE_CURVES}
"""Curves and folders that every page has."""
MOST_NAMED = 50
LONGEST_NAME = 80


class KeptAddress(ui.element, component="address.js"):
    """The script that reads and writes the address and the stores of the browser."""


class KeptStudies:
    """Buttons for undo, redo, a link and named studies; and what is kept without being asked.

    Parameters
    ----------
    take
        Called with the text of a study that is to be shown; returns its mistakes.
    begin
        Called once, when it is known whether there is earlier work.
    uploads
        Folder of the uploads.
    """

    def __init__(self, take: Callable[[str], str], begin: Callable[[], None], uploads: UploadFolder) -> None:
        self.take, self.begin, self.uploads = take, begin, uploads
        self.steps = UndoStates()
        self.named: list[dict[str, str]] = []
        self.files_kept: tuple[Any, ...] = ()
        self.opened = self.replaces = False
        self.address = KeptAddress()
        for name, react in {"opened": self._open, "back": self._back, "named": self._others}.items():
            self.address.on(name, react)
        self.address.on("copied", self._copied)
        self.address.on("full", lambda: ui.notify("The browser keeps no more: delete named studies.", type="negative"))
        self.address.on("undo", lambda: self._step(self.steps.can_undo, self.steps.undo))
        self.address.on("redo", lambda: self._step(self.steps.can_redo, self.steps.redo))
        with ui.element("nav").classes("kept").props('aria-label="Work"'):
            self.undo_button = _button("Undo", "undo", lambda: self._step(self.steps.can_undo, self.steps.undo))
            self.redo_button = _button("Redo", "redo", lambda: self._step(self.steps.can_redo, self.steps.redo))
            link = _button("Copy link", "link", lambda: None)
            link.on("click", js_handler=f"() => getElement({self.address.id}).copy()")
            link.tooltip("The address holds the study: bookmark it, or send it.")
            with _button("Named", "bookmark_border", lambda: None), ui.menu().props("auto-close=false") as self.menu:
                self.list = ui.element("div").classes("named")
        self._draw_named()

    # ------------------------------------------------------------------------------------------ what is kept always

    def keep(self, table: dict[str, Any], text: str, *, value: bool) -> None:
        """Keep the study as it stands.

        Parameters
        ----------
        table, text
            The study.
        value
            Whether only a value has changed.
        """
        first = not self.steps.states
        new = self.steps.keep(text, value=value)
        self.undo_button.set_enabled(self.steps.can_undo)
        self.redo_button.set_enabled(self.steps.can_redo)
        if self.replaces or (new and not first):  # as long as nobody has changed anything the address stays plain
            code = code_of(text)
            self._keep_files(table)
            self.address.run_method("keep", code, len(code) <= LONGEST_LINK, not value and not self.replaces)

    def _keep_files(self, table: dict[str, Any]) -> None:
        """Keep the uploaded files that a study reads in the store of the tab, if they are not too large."""
        read = {name for _, name in files_in(table) if isinstance(name, str)} - MADE
        names = tuple(sorted(read))
        files = (one for name in names for one in self.uploads.members(name))
        kept = tuple((one, (self.uploads.folder / one).stat().st_mtime_ns) for one in files)
        if kept == self.files_kept:
            return
        self.files_kept = kept
        archive = self.uploads.packed("", STUDY, names) if kept else b""
        content = base64.b64encode(archive).decode() if len(archive) <= MOST_KEPT_FILES else ""
        self.address.run_method("keepFiles", content)

    def _open(self, event: events.GenericEventArguments) -> None:
        """Take up earlier work: of the address, or of the tab."""
        if self.opened:
            return
        self.opened = True
        found = event.args if isinstance(event.args, dict) else {}
        self._others(event)
        code, files = str(found.get("code") or ""), str(found.get("files") or "")
        try:
            if files:
                self.uploads.unpack(base64.b64decode(files, validate=True), STUDY)
        except (WinklerError, binascii.Error):
            ui.notify("The uploaded files of this page were not kept: upload them again.", type="warning")
        if not code or not self._show(code):
            self.begin()

    def _show(self, code: str, *, replaces: bool = True) -> bool:
        """Show the study of an address; return whether it is one; unless it `replaces`, Back leads to the present."""
        try:
            wrong = self._take(study_of(code), replaces=replaces)
        except InvalidInput as error:
            wrong = str(error)
        if wrong:
            ui.notify(wrong, type="negative", multi_line=True, close_button="OK", timeout=0)
        return not wrong

    def _back(self, event: events.GenericEventArguments) -> None:
        """Show the study of the address after the buttons Back and Forward of the browser."""
        code = str((event.args or {}).get("code") or "")
        if code:
            self._show(code)
        elif self.steps.states:
            self._show(code_of(self.steps.states[0]))

    # ------------------------------------------------------------------------------------------------ undo and redo

    def _step(self, possible: bool, go: Callable[[], str]) -> None:
        if possible:
            self._take(go(), replaces=True)

    def _take(self, text: str, *, replaces: bool) -> str:
        """Show a study, whose address replaces that of the present one; return its mistakes."""
        self.replaces = replaces
        try:
            return self.take(text)
        finally:
            self.replaces = False

    # ----------------------------------------------------------------------------------------- links, named studies

    def _copied(self, event: events.GenericEventArguments) -> None:
        present = self.steps.states[self.steps.place] if self.steps.states else ""
        if len(code_of(present)) > LONGEST_LINK:
            ui.notify("This study is too long for a link: save the study file, and send that.", type="warning")
        elif not (event.args or {}).get("done"):
            ui.notify("The browser does not let the page copy: copy the address of the page.", type="warning")
        else:
            files = sorted({str(name) for _, name in files_in(parsed(present, STUDY)) if name} - MADE)
            without = f" It does not hold {', '.join(files)}: send the study file for that." if files else ""
            ui.notify(f"The link to this study is copied.{without}", type="positive")

    def _others(self, event: events.GenericEventArguments) -> None:
        """Take the named studies of the browser."""
        named = (event.args or {}).get("named") if isinstance(event.args, dict) else None
        self.named = [
            {"name": str(one["name"])[:LONGEST_NAME], "code": str(one["code"])}
            for one in (named if isinstance(named, list) else [])
            if isinstance(one, dict) and {"name", "code"} <= set(one)
        ][:MOST_NAMED]
        self._draw_named()

    def _draw_named(self) -> None:
        self.list.clear()
        with self.list:
            name = (
                ui.input(label="Keep this study as").props(f"outlined dense maxlength={LONGEST_NAME}").classes("name")
            )
            name.on("keydown.enter", lambda: self._save(str(name.value or "")))
            ui.button("Keep", on_click=lambda: self._save(str(name.value or ""))).props("outline dense no-caps")
            for one in self.named:
                with ui.row().classes("one"):
                    show = ui.button(one["name"], on_click=lambda one=one: self._show_named(one))
                    show.props("flat dense no-caps align=left").classes("kept-name")
                    drop = ui.button(icon="close", on_click=lambda one=one: self._drop(one))
                    drop.props("flat dense round size=sm").props["aria-label"] = f"delete {one['name']}"

    def _save(self, name: str) -> None:
        name = name.strip()
        if not name or not self.steps.states:
            ui.notify("Give the study a name first.", type="warning")
            return
        others = [one for one in self.named if one["name"] != name]
        if len(others) >= MOST_NAMED:
            ui.notify(f"There are {MOST_NAMED} named studies: delete one first.", type="warning")
            return
        kept = {"name": name, "code": code_of(self.steps.states[self.steps.place])}
        self._store([kept, *others])
        ui.notify(f"Kept as “{name}” in this browser.", type="positive")

    def _drop(self, one: dict[str, str]) -> None:
        self._store([other for other in self.named if other is not one])

    def _store(self, named: list[dict[str, str]]) -> None:
        self.named = named
        self.address.run_method("storeNamed", named)
        self._draw_named()

    def _show_named(self, one: dict[str, str]) -> None:
        self.menu.close()
        self._show(one["code"], replaces=False)


def _button(label: str, icon: str, act: Callable[[], None]) -> ui.button:
    button = ui.button(icon=icon, on_click=lambda: act()).props("flat dense")
    button.props["aria-label"] = label
    button.props["data-kept"] = label.lower().replace(" ", "-")
    button.tooltip(label)
    return button
