"""The open pages of the app: a page is built once its browser has connected, and their number is limited.

A request without a connection (a preview, a port scan) gets an empty page and starts no process.  A page whose
connection is lost is kept for half a minute; it ends at once when its tab loads the app again, or when another page
needs its process.  The process of the next page is started before it is asked for.
"""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import NamedTuple

from nicegui import Client, context, ui

from winkler.web.page.page import Page, style
from winkler.web.session.standby import Standby

REST = 3.0
"""Time after a page was made until the process of the next one is started [s]."""


class Visitors:
    """The open pages, each with a process that solves for it.

    Parameters
    ----------
    limit
        The longest that a study may take [s].
    most
        Greatest number of pages.
    folder
        Folder of the uploads.
    standby
        Gives the processes.
    """

    def __init__(self, limit: float, most: int, folder: Path, standby: Standby) -> None:
        self.limit, self.most, self.folder, self.standby = limit, most, folder, standby
        self._open: dict[Client, _Visit] = {}

    async def visit(self) -> None:
        """Make a page for a browser, once it has connected."""
        client = context.client
        style()
        await client.connected()
        if client.is_deleted:  # never connected
            return
        self._free_place(client.tab_id)
        if len(self._open) >= self.most:
            _refuse(
                f"{self.most} pages of the app are open, each with a process of its own, and no more are allowed: "
                "close one and reload this page, or start the app with a greater --pages."
            )
            return
        try:
            page = Page(self.limit, self.folder, self.standby.take)
        except OSError as error:
            why = (error.strerror or type(error).__name__).lower()
            _refuse(f"This page gets no folder or no process ({why}); close other programs, then reload it.")
            return
        self._open[client] = _Visit(page, client.tab_id)
        client.on_delete(lambda: self._end(client))
        client.on_connect(lambda: None if client in self._open else ui.navigate.reload())
        page.build()
        asyncio.get_running_loop().call_later(REST, self._prepare)

    def _prepare(self) -> None:
        """Start the process of the next page, if there may be one."""
        if self._open and len(self._open) < self.most:
            self.standby.prepare()

    def _free_place(self, tab: str | None) -> None:
        """End disconnected pages: that of a reloaded tab, or the oldest one if the limit is reached."""
        reloaded = [client for client, visit in self._open.items() if visit.tab == tab]
        gone = [client for client in self._open if not client.has_socket_connection]
        for client in reloaded or gone[: int(len(self._open) >= self.most)]:
            self._end(client)

    def _end(self, client: Client) -> None:
        visit = self._open.pop(client, None)
        if visit is not None:
            visit.page.close()

    def close(self) -> None:
        """End all pages."""
        for client in list(self._open):
            self._end(client)
        self.standby.close()


def _refuse(sentence: str) -> None:
    """Show why there is no page."""
    ui.label(sentence).classes("refused").props('role="alert"')


class _Visit(NamedTuple):
    """A page, and the tab of the browser that it was made for."""

    page: Page
    tab: str | None
