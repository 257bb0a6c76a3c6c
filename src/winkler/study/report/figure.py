"""One figure of a study: its name, its caption, its picture, and its files."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

from winkler.plot.picture_file import picture_file
from winkler.plot.svg.sheet import Drawing, drawing_of
from winkler.study.chapters.method_captions import CAPTIONS

if TYPE_CHECKING:
    from winkler.plot.panel import Sheet
    from winkler.plot.picture import Picture


class ReportFigure(NamedTuple):
    """A figure of a study, or the reason why it is missing.

    Parameters
    ----------
    name
        The stem of its files: a picture of the method, or ``answer_`` and the name of an answer.
    title, sentence
        Its caption.
    sheet
        Its panels; None if they could not be drawn.
    drawing
        The same in SVG; None if it could not be drawn.
    missing
        Why there is none; empty if there is one.
    """

    name: str
    title: str
    sentence: str
    sheet: Sheet | None
    drawing: Drawing | None = None
    missing: str = ""

    @property
    def picture(self) -> Picture | None:
        """The figure drawn anew by matplotlib, for files of other formats; None if it could not be drawn."""
        from winkler.plot.render import render  # matplotlib is loaded by the first figure

        return None if self.sheet is None else render(self.sheet)

    @property
    def of_method(self) -> bool:
        """Whether this is a picture of the method, not of the answers."""
        return self.name in CAPTIONS


def drawn(name: str, title: str, sentence: str, sheet: Sheet) -> ReportFigure:
    """Return a figure with its drawing."""
    return ReportFigure(name, title, sentence, sheet, drawing_of(sheet))


def capital(text: str) -> str:
    """Return a text with a capital letter at its beginning."""
    return text[:1].upper() + text[1:]


def svg_element(shown: ReportFigure, description: str) -> str:
    """Return a figure as one SVG element for a page: its own identifiers, scalable, with a description.

    Parameters
    ----------
    shown
        A figure that was drawn; its name is put before every identifier, so that many figures can stand on one page.
    description
        Description for screen readers; already escaped.
    """
    assert shown.drawing is not None
    name = shown.name.replace("_", "-")
    text = re.sub(r'\bid="', f'id="{name}-', shown.drawing.text)
    text = re.sub(r"url\(#", f"url(#{name}-", text)
    wide = f'style="max-width:{shown.drawing.width * 1.6:.0f}px"'
    said = f'role="img" aria-label="{description}" {wide}'
    return re.sub(r' width="[^"]*" height="[^"]*" (viewBox="[^"]*")', lambda size: f" {size[1]} {said}", text, count=1)


def figure_files(shown: tuple[ReportFigure, ...], formats: tuple[str, ...]) -> dict[str, bytes]:
    """Return every figure in every format: name in the folder of results -> content."""
    return {
        f"figures/{one.name}.{ending}": picture_file(one.sheet, ending, one.drawing, dpi=200)
        for one in shown
        if one.sheet is not None
        for ending in formats
    }
