"""Sheets shown one after another: an animated picture, or a video."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from winkler.plot.panel import Sheet
from winkler.values.errors import InvalidInput

MOST_FRAMES = 24
PER_SECOND = 8
"""Sheets shown in a second."""
DOTS_PER_INCH = 80
FILMS = ("gif", "mp4")
"""Endings of films."""


def animated(sheets: Iterable[Sheet], *, per_second: float = PER_SECOND, form: str = "gif") -> bytes:
    """Return sheets of one size as an animated GIF, which repeats without end, or as an MP4 video (H.264).

    Raises
    ------
    InvalidInput
        If nothing is shown in a second, the form is not known, or there is no program that writes videos.
    """
    if not per_second > 0.0:
        raise InvalidInput(f"film: per_second is {per_second!r}; give a positive number.")
    if form not in FILMS:
        raise InvalidInput(f"film: the form '{form}' is not known; give one of {', '.join(FILMS)}.")
    from winkler.plot.render import render

    writer = _writer(form, per_second)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"film.{form}")
        for place, sheet in enumerate(sheets):
            figure = render(sheet)
            if place == 0:
                writer.setup(figure, path, dpi=DOTS_PER_INCH)
            writer.fig = figure
            writer.grab_frame()
        writer.finish()
        return path.read_bytes()


def spread(total: int, most: int) -> list[int]:
    """Return at most so many places of all, the first and the last ones among them."""
    return [int(one) for one in np.unique(np.linspace(0, total - 1, min(total, most)).round().astype(int))]


def _writer(form: str, per_second: float) -> Any:
    """Return what writes the frames of a film; for videos the program ffmpeg of the system, or of imageio-ffmpeg."""
    import matplotlib
    from matplotlib.animation import FFMpegWriter, PillowWriter

    if form == "gif":
        return PillowWriter(fps=per_second)  # type: ignore[arg-type]
    if not FFMpegWriter.isAvailable():
        with contextlib.suppress(ImportError):
            from imageio_ffmpeg import get_ffmpeg_exe

            matplotlib.rcParams["animation.ffmpeg_path"] = get_ffmpeg_exe()
    if not FFMpegWriter.isAvailable():
        raise InvalidInput(
            "film: an .mp4 is written by the program ffmpeg, which is not there; install it, or `pip install "
            "imageio-ffmpeg`, or give a name that ends in .gif."
        )
    return FFMpegWriter(fps=per_second, codec="h264", extra_args=["-pix_fmt", "yuv420p"])  # type: ignore[arg-type]
