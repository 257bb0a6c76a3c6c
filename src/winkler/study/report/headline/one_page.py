"""The report of a study on one page of A4: question, picture, answers, validity, yield; a PDF."""

from __future__ import annotations

import io
import textwrap
from typing import TYPE_CHECKING, Any

from winkler.study.batch.outcome import Outcome
from winkler.study.report.describe import in_words
from winkler.study.report.figure import ReportFigure
from winkler.study.report.headline.section import doubt_of, headline
from winkler.study.report.headline.summary import contact_summary
from winkler.values.readable import with_readable_numbers
from winkler.values.validity import Standing
from winkler.values.validity import in_words as trust_in_words

if TYPE_CHECKING:
    from matplotlib.figure import Figure


A4 = (8.27, 11.69)
"""Width and height [inch]."""
MARGIN, TOP, BOTTOM = 0.08, 0.06, 0.05
"""Margin over the width of the page; free parts of its height, the lower one for the line of origin."""
SIZE, SMALL, LARGE = 9.0, 7.5, 15.0
"""Sizes of letters [pt]."""
LINE = 1.45
"""Distance of lines over the size of letters."""
LETTERS = 112
"""Letters of a line at the usual size."""
COLUMNS, REMARK_LETTERS = (0.38, 0.55), 420
"""Where numbers and remarks begin, over the width of the page; letters of a line of remarks times their size."""
LETTER = 0.56
"""Width of a letter of a number over its size."""
LEAST_PICTURES, MOST_FREE, DOTS = 0.3, 0.3, 250
"""Height that pictures keep, over that of the page; most below a row of them [inch]; resolution [dots per inch]."""
WIDE, BETWEEN, TITLE = 1.75, 0.25, 0.28
"""Width over height from which a picture takes a row of its own; space beside and height above a picture [inch]."""
SHRUNK = 0.8
"""Rows of pictures are made smaller down to this to let one more onto the page."""
STRETCHED = 1.8
"""Up to this many times its height a picture takes, where none of its axes have one scale for both directions."""
LEAST_NOTES, MOST_QUESTION = 5, 6
"""Notes that are written at any rate, the worst first; lines of the question that the page has room for."""


def one_page(outcome: Outcome, shown: tuple[ReportFigure, ...]) -> bytes:
    """Return the report of an outcome as a PDF of one page.

    Parameters
    ----------
    outcome
        Outcome of a study.
    shown
        Its figures; as many are drawn as the page has room for, those of the answers first.
    """
    from winkler.plot.picture import styled

    store = io.BytesIO()
    with styled():
        laid_out(outcome, shown).savefig(store, format="pdf", dpi=DOTS, metadata={"CreationDate": None})
    return store.getvalue()


def laid_out(outcome: Outcome, shown: tuple[ReportFigure, ...]) -> Figure:
    """Return the page as a figure; parameters are those of `one_page`."""
    from matplotlib.figure import Figure

    from winkler.plot.picture import styled

    made = outcome.provenance
    above = _Lines()
    above.write(outcome.study.title or made.source or "A study", LARGE, bold=True)
    above.write(in_words(outcome.study), most=MOST_QUESTION)
    above.gap()
    doubt = doubt_of(outcome)
    if doubt.standing is Standing.OUTSIDE:
        above.write(f"Do not use these results: {with_readable_numbers(doubt.statement)} {doubt.advice}", bold=True)
    elif sentence := headline(outcome):
        above.write(sentence, bold=True)
    above.gap()
    drawn = sorted((one for one in shown if one.drawing is not None), key=lambda one: one.of_method)
    below = _answers(outcome, SIZE, 1.0 - TOP - BOTTOM - above.height)
    room = 1.0 - TOP - BOTTOM - above.height - below.height
    if len(drawn) > len([one for row in _rows(drawn, room * A4[1])[0] for one in row]):
        below = _answers(outcome, SMALL, 1.0 - TOP - BOTTOM - above.height)
    with styled():
        page = Figure(figsize=A4, layout=None)
        top = above.put(page, 1.0 - TOP)
        top = _put_pictures(page, drawn, top, top - BOTTOM - below.height)
        below.put(page, top)
        page.text(MARGIN, 0.03, f"winkler {made.version}, {made.created[:10]}, study {made.hash[:16]}", fontsize=SMALL)
    return page


def _answers(outcome: Outcome, size: float, room: float) -> _Lines:
    """Return answers, yield and validity in letters of a size, with as many notes as leave room for pictures."""
    lines = _Lines()
    lines.table([(one.name, one.text, one.remark) for one in contact_summary(outcome)], size)
    lines.gap()
    lines.write(f"How far this can be trusted: {trust_in_words(outcome.validity)}.", bold=True)
    if outcome.failed:
        lines.write(f"{len(outcome.failed)} of {len(outcome.points)} points have no answer.", size)
    order = list(Standing)
    notes = sorted(outcome.validity, key=lambda note: -order.index(note.standing))
    for place, note in enumerate(notes):
        more = _Lines()
        more.write(f"{trust_in_words((note,))}: {with_readable_numbers(note.statement)}", size)
        if place >= LEAST_NOTES and room - lines.height - more.height < LEAST_PICTURES:
            lines.write(f"and {len(notes) - place} more, see the report.", size)
            break
        lines.content += more.content
    return lines


class _Lines:
    """Lines of text: parts with their places over the width of the page, size, and weight of letters."""

    def __init__(self) -> None:
        self.content: list[tuple[tuple[tuple[float, str], ...], float, str]] = []

    @property
    def height(self) -> float:
        """Height of all lines over that of the page."""
        return sum(size for _, size, _ in self.content) * LINE / 72.0 / A4[1]

    def gap(self) -> None:
        """Leave half a line free."""
        self.content.append(((), 0.5 * SIZE, "normal"))

    def write(self, text: str, size: float = SIZE, *, bold: bool = False, most: int = 100) -> None:
        """Add a text in as many lines as it takes, at most `most`."""
        letters = int(LETTERS * SIZE / size * (0.85 if bold else 1.0))
        for line in textwrap.wrap(text, letters, max_lines=most, placeholder=" ..."):
            self.content.append((((MARGIN, line),), size, "bold" if bold else "normal"))

    def table(self, rows: list[tuple[str, str, str]], size: float) -> None:
        """Add rows of a name, a number and a remark, which gives way to long numbers."""
        letter = LETTER * size / 72.0 / A4[0]
        right = max([COLUMNS[1], *(COLUMNS[0] + letter * (len(number) + 2) for _, number, _ in rows)])
        most = int(REMARK_LETTERS / size * (1.0 - MARGIN - right) / (1.0 - MARGIN - COLUMNS[1]))
        for name, number, remark in rows:
            for place, line in enumerate(textwrap.wrap(remark, most) or [""]):
                first = ((MARGIN, name), (COLUMNS[0], number)) if place == 0 else ()
                self.content.append(((*first, (right, line)), size, "normal"))

    def put(self, page: Figure, top: float) -> float:
        """Write the lines from a height downwards and return the next one; what is below the page is left out."""
        for parts, size, weight in self.content:
            step = size * LINE / 72.0 / A4[1]
            if top - step < BOTTOM - 1e-9:
                break
            for x, text in parts:
                page.text(x, top, text, fontsize=size, weight=weight, va="top", ha="left", parse_math=False)
            top -= step
        return top


def _put_pictures(page: Figure, drawn: list[Any], top: float, room: float) -> float:
    """Draw rows of pictures that fill a part of the page below a height, and return the next height."""
    rows, heights = _rows(drawn, room * A4[1])
    if not rows:
        return top
    spare = room * A4[1] - sum(heights) - (TITLE + MOST_FREE) * len(rows)
    free_rows = [not any(map(_keeps_shape, row)) for row in rows]
    higher = sum(height for height, may in zip(heights, free_rows, strict=True) if may)
    factor = min(1.0 + max(spare, 0.0) / max(higher, 1e-9), STRETCHED)
    widths = [[height * _shape(one) for one in row] for row, height in zip(rows, heights, strict=True)]
    heights = [height * factor if may else height for height, may in zip(heights, free_rows, strict=True)]
    free = min((room * A4[1] - sum(heights)) / len(rows) - TITLE, MOST_FREE)
    for row, height, wide in zip(rows, heights, widths, strict=True):
        top -= TITLE / A4[1]
        left = 0.5 * (A4[0] - sum(wide) - BETWEEN * (len(row) - 1))
        for one, width in zip(row, wide, strict=True):
            page.text(
                left / A4[0], top + 0.05 / A4[1], one.title, fontsize=SMALL, weight="bold", va="bottom", ha="left"
            )
            place = page.add_axes((left / A4[0], top - height / A4[1], width / A4[0], height / A4[1]))
            place.imshow(_pixels(one.picture, width, height), aspect="auto", interpolation="none")
            place.set_axis_off()
            left += width + BETWEEN
        top -= (height + free) / A4[1]
    return top


def _rows(drawn: list[Any], room: float) -> tuple[list[list[Any]], list[float]]:
    """Return pictures by rows, and the height of each row [inch]: wide ones alone, others by two, as many as fit."""
    width = A4[0] * (1.0 - 2.0 * MARGIN)
    rows: list[list[Any]] = []
    for one in drawn:
        if rows and len(rows[-1]) == 1 and max(_shape(one), _shape(rows[-1][0])) < WIDE:
            rows[-1].append(one)
        else:
            rows.append([one])
    rows.sort(key=lambda row: -len(row) if len(drawn) > 2 and _shape(row[0]) < WIDE else -3)  # no lone one before pairs
    natural = [(width - BETWEEN * (len(row) - 1)) / sum(map(_shape, row)) for row in rows]
    count = next(
        (many for many in range(len(rows), 1, -1) if SHRUNK * sum(natural[:many]) + TITLE * many <= room),
        min(len(rows), 1),
    )
    scale = min(1.0, (room - TITLE * count) / max(sum(natural[:count]), 1e-9))
    return rows[:count], [scale * height for height in natural[:count]]


def _shape(one: Any) -> float:
    """Return the width of a picture over its height."""
    return float(one.drawing.width / one.drawing.height)


def _keeps_shape(one: Any) -> bool:
    return any(panel.equal for panel, _ in one.drawing.panels)


def _pixels(picture: Any, width: float, height: float) -> Any:
    """Return a picture as an image of a width and a height [inch]; one that is to be higher is laid out so."""
    from matplotlib.image import imread

    store = io.BytesIO()
    wide, high = picture.get_size_inches()
    if height > 1.01 * width * high / wide:
        picture.set_size_inches(wide, wide * height / width)
    picture.savefig(store, format="png", dpi=DOTS * width / wide)
    store.seek(0)
    return imread(store)
