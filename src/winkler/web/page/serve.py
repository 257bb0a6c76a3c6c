"""The server of the app: on the local machine, at one port, until Ctrl-C."""

from __future__ import annotations

import contextlib
import logging
import socket
from asyncio import CancelledError
from collections.abc import Sequence

from winkler.values.errors import InvalidInput
from winkler.web.session.security import origin_of
from winkler.web.session.standby import Standby
from winkler.web.session.uploads import uploads

HOST = "127.0.0.1"
"""Reachable only from the local machine."""


class WithoutCancelled(logging.Filter):
    """Keeps back what the server says when it cuts requests off that a browser left open: the app is ending."""

    def filter(self, record: logging.LogRecord) -> bool:
        """Return whether a record is of something else."""
        error = record.exc_info[1] if record.exc_info else None
        return not isinstance(error, CancelledError) and not record.getMessage().startswith("Cancel ")


def serve(*, port: int, limit: float, browser: bool, pages: int, addresses: Sequence[str]) -> None:
    """Serve the app until it is interrupted.

    Parameters
    ----------
    port
        Port; the browser opens ``http://127.0.0.1:PORT``.
    limit
        The longest that a study may take [s].
    browser
        Whether a page is opened.
    pages
        How many pages may be open at once.
    addresses
        Other addresses at which the app is opened, through a tunnel or a proxy.

    Raises
    ------
    InvalidInput
        If the extra ``app`` is not installed, the port is taken, or an address is none.
    """
    if not limit > 0.0:
        raise InvalidInput(f"the time limit is {limit:g} s; give a positive number of seconds.")
    origins = [origin_of(f"http://{name}:{port}") for name in (HOST, "localhost")]
    origins += [origin_of(address) for address in addresses]
    _free(port)
    logging.getLogger("uvicorn.error").addFilter(WithoutCancelled())
    standby = Standby()
    with contextlib.ExitStack() as stack:
        folder = stack.enter_context(uploads())
        stack.callback(standby.close)
        standby.prepare()  # it gets ready while the app is imported
        try:
            from nicegui import ui
        except ImportError:
            message = 'the app needs NiceGUI, which is not installed; install it with: pip install "winkler[app]"'
            raise InvalidInput(message) from None
        from winkler.web.page.assembly import assemble
        from winkler.web.page.visitors import Visitors

        visitors = Visitors(limit, pages, folder, standby)
        assemble(visitors, tuple(origins))
        print(f"The app runs at http://{HOST}:{port}; stop it with Ctrl-C.", flush=True)
        try:
            ui.run(
                host=HOST,
                port=port,
                title="winkler",
                favicon="◒",
                reload=False,
                show=browser,
                show_welcome_message=False,
                tailwind=False,
                reconnect_timeout=30.0,
                server_header=False,
                timeout_graceful_shutdown=2,
            )
        finally:
            visitors.close()


def _free(port: int) -> None:
    """Raise InvalidInput if the port cannot be used."""
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((HOST, port))
        except (OSError, OverflowError) as error:
            why = getattr(error, "strerror", None) or str(error)
            raise InvalidInput(
                f"port {port} cannot be used ({why.lower()}); give another one with --port, or stop its program."
            ) from None
