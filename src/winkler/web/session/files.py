"""The files of a page: studies that are opened, data that is uploaded, results that are taken along."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable

from nicegui import events, ui

from winkler.errors import WinklerError
from winkler.study.language.reading import parsed
from winkler.web.session.upload_folder import LARGEST, UploadFolder, files_in

__all__ = ["Files"]

TAKEN = (
    ("study", "Study file", "description"),
    ("csv", "CSV", "table_view"),
    ("netcdf", "NetCDF", "dataset"),
    ("png", "Figures", "image"),
    ("report", "Report", "article"),
)
"""What can be taken along, in words, with a picture."""
STUDY = "study.toml"


class Files:
    """What is opened, uploaded and taken along.

    Parameters
    ----------
    room
        Where uploads are kept.
    opened
        Called with the text of a study.
    uploaded
        Called with the name under which data is kept.
    wrong
        Called with the sentence that says why data is not taken.
    export
        Called with what is to be taken along.
    """

    def __init__(
        self,
        room: UploadFolder,
        opened: Callable[[str], None],
        uploaded: Callable[[str], None],
        wrong: Callable[[str], None],
        export: Callable[[str], None],
    ) -> None:
        self.room, self.opened, self.uploaded, self.wrong = room, opened, uploaded, wrong
        studies = ui.upload(on_upload=self._open, on_rejected=_refused, auto_upload=True, max_file_size=LARGEST)
        studies.classes("unseen").props('accept=".toml,.zip"').props["data-upload"] = "study"
        self.uploads = ui.upload(on_upload=self._keep, on_rejected=_refused, auto_upload=True, max_file_size=LARGEST)
        self.uploads.classes("unseen").props["data-upload"] = "data"
        with ui.element("nav").classes("files"):
            button = ui.button("Open a study", icon="folder_open").props("flat dense no-caps")
            button.on("click", js_handler=_picker(studies))
            for what, told, icon in TAKEN:
                take = ui.button(told, icon=icon, on_click=lambda what=what: export(what))
                take.props("flat dense no-caps").props["data-export"] = what

    @property
    def picker(self) -> str:
        """The script that opens the choice of a file with data."""
        return _picker(self.uploads)

    async def _open(self, event: events.UploadEventArguments) -> None:
        event.sender.reset()  # type: ignore[attr-defined]
        content, name = await event.file.read(), event.file.name
        try:
            if zipfile.is_zipfile(io.BytesIO(content)):
                name, content = STUDY, self.room.unpack(content, STUDY)
            self.opened(content.decode("utf-8-sig"))
        except UnicodeDecodeError as error:
            ui.notify(f"{name}: byte {error.start} is not UTF-8; save it as UTF-8 text.", type="negative")
        except WinklerError as error:
            ui.notify(str(error), type="negative")

    async def _keep(self, event: events.UploadEventArguments) -> None:
        self.uploads.reset()
        try:
            self.uploaded(self.room.keep(event.file.name, await event.file.read()))
        except WinklerError as error:
            self.wrong(str(error))

    def take_study(self, text: str) -> None:
        """Hand out a study; with the files that it reads, as one archive."""
        named = {name for _, name in files_in(parsed(text, STUDY))}
        data = tuple(name for name in self.room.names if name in named)
        if data:
            ui.download.content(self.room.packed(text, STUDY, data), "study.zip")
        else:
            ui.download.content(text.encode(), STUDY)


def _refused() -> None:
    """Say why a file was not taken."""
    ui.notify(f"The file is not taken: it has more than {LARGEST / 1e6:.0f} MB, or another ending.", type="negative")


def _picker(upload: ui.upload) -> str:
    """Return the script that opens the choice of a file; it runs in the browser, which wants to see the click."""
    return f"() => getElement({upload.id}).$refs.qRef.pickFiles()"
