"""The files of a page: opened studies, uploaded data, exported results."""

from __future__ import annotations

import asyncio
import io
import zipfile
from collections.abc import Callable

from nicegui import events, ui

from winkler.study.language.reading import parsed
from winkler.values.errors import WinklerError
from winkler.web.session.upload_folder import CURVES, LARGEST, UploadFolder, files_in

EXPORTS = (
    ("study", "Study file", "description"),
    ("csv", "CSV", "table_view"),
    ("netcdf", "NetCDF", "dataset"),
    ("png", "Figures", "image"),
    ("report", "Report", "article"),
)
"""Exports with label and icon."""
STUDY, STUDY_ENDING = "study.toml", ".toml"
PLAIN = "no-thumbnails"
"""Pictures among uploads are not shown: the security policy of the page forbids it, with errors of the browser."""


class Files:
    """Buttons for opening, uploading and exporting.

    Parameters
    ----------
    upload_folder
        Folder of the uploads.
    opened
        Called with the text of a study.
    uploaded
        Called with the stored name of data; after several curves, with that of their folder.
    wrong
        Called with the reason for refusing data.
    export
        Called with the kind of export.
    inspect
        Called with the stored name of a file of which is asked what it is.
    """

    def __init__(
        self,
        upload_folder: UploadFolder,
        opened: Callable[[str], None],
        uploaded: Callable[[str], None],
        wrong: Callable[[str], None],
        export: Callable[[str], None],
        inspect: Callable[[str], None],
    ) -> None:
        self.upload_folder, self.opened, self.uploaded, self.wrong = upload_folder, opened, uploaded, wrong
        self.inspect = inspect
        studies = ui.upload(on_upload=self._open, on_rejected=_refused, auto_upload=True, max_file_size=LARGEST)
        studies.classes("unseen").props(f'{PLAIN} accept=".toml,.zip"').props["data-upload"] = "study"
        self.uploads = ui.upload(on_upload=self._keep, on_rejected=_refused, auto_upload=True, max_file_size=LARGEST)
        self.uploads.classes("unseen").props(PLAIN).props["data-upload"] = "data"
        self.curves = ui.upload(
            on_upload=self._keep_curve, on_rejected=_refused, multiple=True, auto_upload=True, max_file_size=LARGEST
        )
        self.curves.classes("unseen").props(PLAIN).props["data-upload"] = "curves"
        self.curves.on("finish", self._curves_kept)
        self.looked_at = ui.upload(on_upload=self._look, on_rejected=_refused, auto_upload=True, max_file_size=LARGEST)
        self.looked_at.classes("unseen").props(PLAIN).props["data-upload"] = "look"
        self.refused_curves: list[str] = []
        self.keeping = 0
        with ui.element("nav").classes("files"):
            button = ui.button("Open a study", icon="folder_open").props("flat dense no-caps")
            button.on("click", js_handler=_picker(studies))
            look = ui.button("What is this file?", icon="find_in_page").props("flat dense no-caps")
            look.props["data-look"] = "button"
            look.on("click", js_handler=_picker(self.looked_at))
            for what, label, icon in EXPORTS:
                take = ui.button(label, icon=icon, on_click=lambda what=what: export(what))
                take.props("flat dense no-caps").props["data-export"] = what

    @property
    def picker(self) -> str:
        """The script that opens the choice of a file with data."""
        return _picker(self.uploads)

    @property
    def curves_picker(self) -> str:
        """The script that opens the choice of several files."""
        return _picker(self.curves)

    @property
    def folder_picker(self) -> str:
        """The script that opens the choice of a folder: all files in it are uploaded."""
        return _picker(self.curves, folder=True)

    async def _open(self, event: events.UploadEventArguments) -> None:
        event.sender.reset()  # type: ignore[attr-defined]
        content, name = await event.file.read(), event.file.name
        try:
            if zipfile.is_zipfile(io.BytesIO(content)):
                name, content = STUDY, self.upload_folder.unpack(content, STUDY)
            self.opened(content.decode("utf-8-sig"))
        except UnicodeDecodeError as error:
            ui.notify(f"{name}: byte {error.start} is not UTF-8; save it as UTF-8 text.", type="negative")
        except WinklerError as error:
            ui.notify(str(error), type="negative")

    def take_drops(self, place: ui.element) -> None:
        """Let files be dropped on an element: they are looked at, and studies opened."""
        taken = f"getElement({self.looked_at.id}).$refs.qRef.addFiles([...event.dataTransfer.files].slice(0, 1))"
        place.on("dragover", js_handler="event => event.preventDefault()")
        place.on("drop", js_handler=f"event => {{ event.preventDefault(); {taken}; }}")

    async def _look(self, event: events.UploadEventArguments) -> None:
        """Keep a file, and ask what it is; a study is opened."""
        if event.file.name.lower().endswith(STUDY_ENDING):
            await self._open(event)
            return
        self.looked_at.reset()
        try:
            self.inspect(self.upload_folder.keep(event.file.name, await event.file.read()))
        except WinklerError as error:
            ui.notify(str(error), type="negative")

    async def _keep(self, event: events.UploadEventArguments) -> None:
        self.uploads.reset()
        try:
            self.uploaded(self.upload_folder.keep(event.file.name, await event.file.read()))
        except WinklerError as error:
            self.wrong(str(error))

    async def _keep_curve(self, event: events.UploadEventArguments) -> None:
        """Keep one of several curves; files that the system hides are none."""
        if event.file.name.startswith("."):
            return
        self.keeping += 1
        try:
            self.upload_folder.keep(event.file.name, await event.file.read(), CURVES)
        except WinklerError as error:
            self.refused_curves.append(str(error))
        finally:
            self.keeping -= 1

    async def _curves_kept(self) -> None:
        """Use the folder when all of its curves have come, and the last of them is written."""
        while self.keeping:
            await asyncio.sleep(0.02)
        self.curves.reset()
        refused, self.refused_curves = self.refused_curves, []
        if self.upload_folder.curves_in(CURVES):
            self.uploaded(CURVES)
        if refused:
            more = f" {len(refused) - 1} more files were not accepted." if len(refused) > 1 else ""
            self.wrong(f"{refused[0]}{more}")

    def take_study(self, text: str) -> None:
        """Download a study; with the files that it reads, as one archive."""
        named = {name for _, name in files_in(parsed(text, STUDY))}
        data = tuple(sorted(name for name in named if isinstance(name, str) and self.upload_folder.members(name)))
        if data:
            ui.download.content(self.upload_folder.packed(text, STUDY, data), "study.zip")
        else:
            ui.download.content(text.encode(), STUDY)


def _refused() -> None:
    """Show why a file was refused."""
    ui.notify(f"The file is not accepted: it has more than {LARGEST / 1e6:.0f} MB, or another ending.", type="negative")


def _picker(upload: ui.upload, *, folder: bool = False) -> str:
    """Return the script that opens the choice of a file; it runs in the browser as part of the click.

    Quasar has no property for the choice of a folder: its hidden input gets it before it is clicked.
    """
    inputs = "u.$el.querySelectorAll('input[type=file]')"
    asked = f"for (const one of {inputs}) one.webkitdirectory = {str(folder).lower()}; "
    return f"() => {{ const u = getElement({upload.id}); {asked}u.$refs.qRef.pickFiles(); }}"
