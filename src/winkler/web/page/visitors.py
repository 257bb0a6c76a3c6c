"""Who has the app open: a page is made for a browser that has connected, and at most so many are open at once.

Whoever only fetches the address (a preview, a check, a program that looks for open ports) gets an empty page and costs
no process.  A page whose browser has gone keeps its place for half a minute, for a connection that was lost; it ends
at once when its tab loads the app again, or when its place is needed.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from nicegui import Client, context, ui

from winkler.web.page.page import Page, style

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
        self._open: dict[Client, _Visit] = {}

    async def visit(self) -> None:
        """Make a page for a browser, once it has connected."""
        client = context.client
        style()
        await client.connected()
        if client.is_deleted:  # nobody came
            return
        self._make_room(client.tab_id)
        if len(self._open) >= self.most:
            _refuse(
                f"{self.most} pages of the app are open, each with a process of its own, and no more are allowed: "
                "close one and reload this page, or start the app with a greater --pages."
            )
            return
        try:
            page = Page(self.limit, self.folder)
        except OSError as error:
            why = (error.strerror or type(error).__name__).lower()
            _refuse(f"This page gets no folder or no process ({why}); close other programs, then reload it.")
            return
        self._open[client] = _Visit(page, client.tab_id)
        client.on_delete(lambda: self._end(client))
        client.on_connect(lambda: None if client in self._open else ui.navigate.reload())
        page.build()

    def _make_room(self, tab: str | None) -> None:
        """End pages that were left: the one of a tab that was reloaded, or the oldest one if its place is needed."""
        reloaded = [client for client, visit in self._open.items() if visit.tab == tab]
        gone = [client for client in self._open if not client.has_socket_connection]
        for client in reloaded or gone[: int(len(self._open) >= self.most)]:
            self._end(client)

    def _end(self, client: Client) -> None:
        visit = self._open.pop(client, None)
        if visit is not None:
            visit.page.left()

    def close(self) -> None:
        """End all pages."""
        for client in list(self._open):
            self._end(client)


def _refuse(sentence: str) -> None:
    """Show why there is no page."""
    ui.label(sentence).classes("refused").props('role="alert"')


class _Visit(NamedTuple):
    """A page, and the tab of the browser that it was made for."""

    page: Page
    tab: str | None
