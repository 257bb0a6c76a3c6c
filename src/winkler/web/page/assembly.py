"""Assembly of the app: one page, and the checks of requests."""

from __future__ import annotations

from nicegui import app, core, ui
from starlette.formparsers import MultiPartParser
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response

from winkler.web.page.visitors import Visitors
from winkler.web.session.security import Security
from winkler.web.session.upload_folder import LARGEST

FRAME = 10_000
"""Greatest length of the form of an upload besides the file [bytes]."""


def _nothing(request: Request, error: Exception) -> Response:
    """Return a plain 404 response, without a page that opens a socket."""
    return PlainTextResponse("There is nothing at this address of the app; its page is at /.\n", 404)


def assemble(visitors: Visitors, origins: tuple[str, ...]) -> None:
    """Put the page and the checks into the app of NiceGUI.

    Parameters
    ----------
    visitors
        Make the pages.
    origins
        Addresses at which the app may be opened.
    """
    ui.page("/", language="en-US", dark=None)(visitors.visit)  # dark as the system is
    app.add_exception_handler(404, _nothing)
    MultiPartParser.spool_max_size = LARGEST + FRAME  # uploads never become files of NiceGUI's own
    core.sio.eio.cors_allowed_origins = list(origins)
    app.add_middleware(Security, origins=origins, largest=LARGEST + FRAME)
    app.on_shutdown(visitors.close)
