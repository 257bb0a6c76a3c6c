"""A sheet of panels as the content of a file."""

from __future__ import annotations

import io

from winkler.plot.panel import Sheet
from winkler.plot.svg.sheet import Drawing, drawing_of

PROLOG = '<?xml version="1.0" encoding="utf-8"?>\n'


def picture_file(sheet: Sheet, ending: str, drawing: Drawing | None = None, **options: int) -> bytes:
    """Return a sheet as a file.

    Parameters
    ----------
    sheet
        Panels.
    ending
        ``svg``, or a format of matplotlib, which is loaded for it.
    drawing
        The sheet in SVG, if it was drawn already.
    options
        Of matplotlib, such as ``dpi``.
    """
    if ending == "svg":
        return f"{PROLOG}{(drawing or drawing_of(sheet)).text}".encode()
    from winkler.plot.render import render  # matplotlib is loaded by the first figure

    store = io.BytesIO()
    render(sheet).savefig(store, format=ending, **options)
    return store.getvalue()
