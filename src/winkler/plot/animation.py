"""Sheets shown one after another: an animated picture."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable
from pathlib import Path

from winkler.plot.panel import Sheet
from winkler.values.errors import InvalidInput

__all__ = ["animated"]

PER_SECOND = 8
"""Sheets shown in a second."""
DOTS_PER_INCH = 80


def animated(sheets: Iterable[Sheet], *, per_second: float = PER_SECOND) -> bytes:
    """Return sheets of one size as an animated GIF, which repeats without end.

    Raises
    ------
    InvalidInput
        If nothing is shown in a second.
    """
    if not per_second > 0.0:
        raise InvalidInput(f"film: per_second is {per_second!r}; give a positive number.")
    from matplotlib.animation import PillowWriter

    from winkler.plot.render import render

    writer = PillowWriter(fps=per_second)  # type: ignore[arg-type]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "film.gif")
        for place, sheet in enumerate(sheets):
            figure = render(sheet)
            if place == 0:
                writer.setup(figure, path, dpi=DOTS_PER_INCH)
            writer.fig = figure
            writer.grab_frame()
        writer.finish()
        return path.read_bytes()
