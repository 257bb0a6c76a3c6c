"""The server of the app: on this machine alone, one port, until Ctrl-C."""

from __future__ import annotations

import socket

from winkler.errors import InvalidInput

__all__ = ["HOST", "serve"]

HOST = "127.0.0.1"
"""Only programs of this machine can reach it."""


def serve(*, port: int, limit: float, browser: bool) -> None:
    """Serve the app until it is interrupted.

    Parameters
    ----------
    port
        Where; a page of the browser opens ``http://127.0.0.1:PORT``.
    limit
        The longest that a study may take [s].
    browser
        Whether a page is opened.

    Raises
    ------
    InvalidInput
        If the extra ``app`` is not installed, or the port is taken.
    """
    try:
        from nicegui import app, ui
        from starlette.middleware.trustedhost import TrustedHostMiddleware
    except ImportError:
        told = 'the app needs NiceGUI, which is not installed; install it with: pip install "winkler[app]"'
        raise InvalidInput(told) from None
    if not limit > 0.0:
        raise InvalidInput(f"the time limit is {limit:g} s; give a positive number of seconds.")
    _free(port)
    from winkler.web.page import page
    from winkler.web.solver import Worker, started

    spare: list[Worker] = []
    app.on_startup(lambda: spare.append(started()))  # so that the first page need not wait
    # pages of the internet cannot reach the app under a name of their own
    app.add_middleware(TrustedHostMiddleware, allowed_hosts=[HOST, "localhost"])
    print(f"The app runs at http://{HOST}:{port}; stop it with Ctrl-C.", flush=True)
    ui.run(
        page(limit, spare),
        host=HOST,
        port=port,
        title="winkler",
        favicon="◒",
        reload=False,
        show=browser,
        show_welcome_message=False,
        tailwind=False,
        reconnect_timeout=30.0,
    )


def _free(port: int) -> None:
    """Refuse a port that cannot be listened to."""
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((HOST, port))
        except (OSError, OverflowError) as error:
            why = getattr(error, "strerror", None) or str(error)
            raise InvalidInput(
                f"port {port} cannot be used ({why.lower()}); give another one with --port, or stop what runs there."
            ) from None
