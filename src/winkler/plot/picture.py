"""A figure that shows itself in notebooks and in the gallery, without pyplot and its global state."""

from __future__ import annotations

import base64
import io
from typing import Any

from matplotlib.figure import Figure

__all__ = ["Picture"]


class Picture(Figure):
    """A matplotlib figure; save it with ``savefig``, or let a notebook show it."""

    def _repr_html_(self) -> str:
        store = io.BytesIO()
        self.savefig(store, format="png")
        data = base64.b64encode(store.getvalue()).decode("ascii")
        width = round(96 * self.get_figwidth())
        return f'<img alt="figure" style="width:{width}px;max-width:100%" src="data:image/png;base64,{data}">'

    def __repr__(self) -> str:
        return f"<Picture of {self.get_figwidth():g} x {self.get_figheight():g} inches; save it with savefig(path)>"

    def savefig(self, fname: Any, **options: Any) -> None:
        """Write the picture to a path or stream; the format follows from the path's ending."""
        from winkler.plot.style import styled

        with styled():
            super().savefig(fname, **options)
