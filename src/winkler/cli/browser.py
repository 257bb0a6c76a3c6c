"""``winkler app``: the app in the browser."""

from __future__ import annotations

from typing import Annotated

import typer


def app(
    port: Annotated[int, typer.Option("--port", "-p", min=1, max=65535, help="Port on this machine.")] = 8765,
    browser: Annotated[
        bool, typer.Option("--browser/--no-browser", help="Whether to open a page of the browser.")
    ] = True,
    time_limit: Annotated[float, typer.Option(help=r"The longest that a study may take \[s].")] = 60.0,
    pages: Annotated[int, typer.Option(min=1, help="How many pages may be open at once; each has a process.")] = 6,
    address: Annotated[
        list[str] | None,
        typer.Option(help="Another address at which the app is opened, through a tunnel or a proxy; may be repeated."),
    ] = None,
) -> None:
    r"""Open the app in the browser: forms, sliders, pictures, and the study file that states it all.

    It serves this machine alone, works without a network, and ends with Ctrl-C. Needs: pip install "winkler\[app]".

    Example: winkler app --port 8080
    """
    from winkler.web.page.serve import serve

    serve(port=port, limit=time_limit, browser=browser, pages=pages, addresses=address or ())
