"""Who has the app open: a page is made for a browser that has connected, and at most so many are open at once.

Whoever only fetches the address (a preview, a check, a program that looks for open ports) gets an empty page and costs
no process.  A page whose browser has gone keeps its place for half a minute, for a connection that was lost; if the
places are needed meanwhile, it gives way, the one that went first before the others.
"""

from __future__ import annotations

from pathlib import Path

from nicegui import Client, context, ui

from winkler.web.page import Page, style
from winkler.web.room import Room

__all__ = ["Visitors"]


class Visitors:
    """The open pages, each with a process that solves for it.

    Parameters
    ----------
    limit
        The longest that a study may take [s].
    most
        Greatest number of pages.
    folder
        Where uploads are kept.
    """

    def __init__(self, limit: float, most: int, folder: Path) -> None:
        self.limit, self.most, self.folder = limit, most, folder
        self._open: dict[Client, Page] = {}

    async def visit(self) -> None:
        """Make a page for a browser, once it has connected."""
        client = context.client
        style()
        await client.connected()
        if client.is_deleted:  # nobody came
            return
        if len(self._open) >= self.most:
            self._end_one_without_browser()
        if len(self._open) >= self.most:
            ui.label(
                f"{self.most} pages of the app are open, each with a process of its own, and no more are allowed: "
                "close one and reload this page, or start the app with a greater --pages."
            ).classes("refused").props('role="alert"')
            return
        page = self._open[client] = Page(self.limit, Room(self.folder))
        client.on_delete(lambda: self._end(client))
        client.on_connect(lambda: None if page is self._open.get(client) else ui.navigate.reload())
        page.build()

    def _end_one_without_browser(self) -> None:
        gone = next((client for client in self._open if not client.has_socket_connection), None)
        if gone is not None:
            self._end(gone)

    def _end(self, client: Client) -> None:
        page = self._open.pop(client, None)
        if page is not None:
            page.left()

    def close(self) -> None:
        """End all pages."""
        for client in list(self._open):
            self._end(client)
