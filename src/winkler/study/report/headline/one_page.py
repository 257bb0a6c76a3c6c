"""The report of a study on one page of A4: question, picture, answers, validity, yield; a PDF."""

from __future__ import annotations

import io
import textwrap
from typing import TYPE_CHECKING, Any

from winkler.study.batch.outcome import Outcome
from winkler.study.report.describe import in_words
from winkler.study.report.figure import ReportFigure
from winkler.study.report.headline.numbers import sought_numbers
from winkler.study.report.headline.section import doubt_of, headline
from winkler.study.report.headline.summary import contact_summary
from winkler.values.readable import with_readable_numbers
from winkler.values.validity import Standing
from winkler.values.validity import in_words as trust_in_words

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["laid_out", "one_page"]

A4 = (8.27, 11.69)
"""Width and height [inch]."""
MARGIN, SIZE, SMALL, LARGE = 0.08, 9.0, 7.5, 15.0
"""Margin over the width of the page; sizes of letters [pt]."""
LINE = 1.45
"""Distance of lines over the size of letters."""
LETTERS = 104
"""Letters of a line at the usual size."""
COLUMNS, REMARK_LETTERS = (0.38, 0.55), 50
"""Where numbers and remarks begin, over the width of the page; letters of a line of remarks."""
PICTURE_HEIGHT, DOTS = 0.36, 300
"""Greatest height of the picture over that of the page; its resolution [dots per inch]."""
MOST_NOTES, MOST_QUESTION = 5, 6
"""Notes, the worst first, and lines of the question that the page has room for."""


def one_page(outcome: Outcome, shown: tuple[ReportFigure, ...]) -> bytes:
    """Return the report of an outcome as a PDF of one page.

    Parameters
    ----------
    outcome
        Outcome of a study.
    shown
        Its figures; the first one of the answers is drawn, or the first one of the method.
    """
    from winkler.plot.picture import styled

    store = io.BytesIO()
    with styled():
        laid_out(outcome, shown).savefig(store, format="pdf", metadata={"CreationDate": None})
    return store.getvalue()


def laid_out(outcome: Outcome, shown: tuple[ReportFigure, ...]) -> Figure:
    """Return the page as a figure; parameters are those of `one_page`."""
    from matplotlib.figure import Figure

    from winkler.plot.picture import styled

    with styled():
        page = Figure(figsize=A4, layout=None)
        writer = _PageWriter(page)
        made = outcome.provenance
        writer.write(outcome.study.title or made.source or "A study", LARGE, bold=True)
        writer.write(in_words(outcome.study), most=MOST_QUESTION)
        writer.gap()
        doubt = doubt_of(outcome)
        if doubt.standing is Standing.OUTSIDE:
            writer.write(
                f"Do not use these numbers: {with_readable_numbers(doubt.statement)} {doubt.advice}", bold=True
            )
        elif sentence := headline(outcome):
            writer.write(sentence, bold=True)
        writer.picture(shown)
        rows = [(one.label, one.text, one.remark) for one in sought_numbers(outcome)]
        rows += [(one.name, one.text, one.remark) for one in contact_summary(outcome)]
        writer.table(rows)
        writer.gap()
        writer.write(f"How far this can be trusted: {trust_in_words(outcome.validity)}.", bold=True)
        order = list(Standing)
        notes = sorted(outcome.validity, key=lambda note: -order.index(note.standing))
        for note in notes[:MOST_NOTES]:
            writer.write(f"{trust_in_words((note,))}: {with_readable_numbers(note.statement)}", SMALL)
        if len(notes) > MOST_NOTES:
            writer.write(f"and {len(notes) - MOST_NOTES} more, see the report.", SMALL)
        if outcome.failed:
            writer.write(f"{len(outcome.failed)} of {len(outcome.points)} points have no answer.", SMALL)
        page.text(MARGIN, 0.03, f"winkler {made.version}, {made.created[:10]}, study {made.hash[:16]}", fontsize=SMALL)
    return page


class _PageWriter:
    """Writes on a page from its top downwards.

    Parameters
    ----------
    page
        The figure that becomes the page.
    """

    def __init__(self, page: Figure) -> None:
        self.page = page
        self.top = 1.0 - 0.06

    def gap(self) -> None:
        """Leave half a line free."""
        self.top -= 0.5 * SIZE * LINE / 72.0 / A4[1]

    def write(self, text: str, size: float = SIZE, *, bold: bool = False, most: int = 100) -> None:
        """Write a text in as many lines as it takes, at most `most`; what is below the page is left out."""
        letters = int(LETTERS * SIZE / size * (0.92 if bold else 1.0))
        for line in textwrap.wrap(text, letters, max_lines=most, placeholder=" ..."):
            self._line(((MARGIN, line),), size, weight="bold" if bold else "normal")

    def table(self, rows: list[tuple[str, str, str]]) -> None:
        """Write rows of a name, a number and a remark; of equal names the first."""
        for name, (number, remark) in {row[0]: row[1:] for row in rows[::-1]}.items().__reversed__():
            for place, line in enumerate(textwrap.wrap(remark, REMARK_LETTERS) or [""]):
                first = ((MARGIN, name), (COLUMNS[0], number)) if place == 0 else ()
                self._line((*first, (COLUMNS[1], line)), SMALL)

    def picture(self, shown: tuple[ReportFigure, ...]) -> None:
        """Draw the picture that stands first in the report, as wide as the page allows."""
        from matplotlib.image import imread

        drawn: list[Any] = [one for one in shown if one.picture is not None]
        first = next((one for one in drawn if not one.of_method), drawn[0] if drawn else None)
        if first is None:
            return
        store = io.BytesIO()
        first.picture.savefig(store, format="png", dpi=DOTS)
        store.seek(0)
        pixels = imread(store)
        width = 1.0 - 2.0 * MARGIN
        height = width * A4[0] / A4[1] * pixels.shape[0] / pixels.shape[1]
        if height > PICTURE_HEIGHT:
            width, height = width * PICTURE_HEIGHT / height, PICTURE_HEIGHT
        self.gap()
        place = self.page.add_axes((0.5 - 0.5 * width, self.top - height, width, height))
        place.imshow(pixels, aspect="auto")
        place.set_axis_off()
        self.top -= height
        self.gap()

    def _line(self, parts: tuple[tuple[float, str], ...], size: float, weight: str = "normal") -> None:
        step = size * LINE / 72.0 / A4[1]
        if self.top - step < 0.05:
            return
        for x, text in parts:
            self.page.text(x, self.top, text, fontsize=size, weight=weight, va="top", ha="left", parse_math=False)
        self.top -= step
