"""A report with a film in it: frames of what moves, and a slider that goes through them; the page stays one file."""

from __future__ import annotations

import base64
import io

from winkler.plot.panel import Sheet
from winkler.study.batch.points import SolvedPoint
from winkler.study.report.markup import safe, section
from winkler.web.pictures.frames import frames_of

MOST_FRAMES = 12
DOTS_PER_INCH, COLOURS = 72, 32
"""Of a frame: a dozen of them take less than 300 kB of the page."""
BEFORE = "<h2>How far this can be trusted</h2>"
"""Heading of the section above which the film stands."""
STYLE = """
.film img { display: block; width: 100%; max-width: 44rem; height: auto; }
.film [hidden] { display: none; }
.film input { width: 100%; max-width: 44rem; }
@media print { .film input { display: none; } }
"""
SCRIPT = """
for (const film of document.querySelectorAll(".film")) {
  const [slider, frames] = [film.querySelector("input"), film.querySelectorAll("img")];
  const show = () => {
    frames.forEach((frame, place) => { frame.hidden = place !== Number(slider.value); });
    slider.setAttribute("aria-valuetext", frames[slider.value].alt);
  };
  slider.addEventListener("input", show);
  slider.hidden = false;
  show();
}
"""


def with_film(page: str, point: SolvedPoint) -> str:
    """Return a report with the film of one point, and the script that moves it.

    Parameters
    ----------
    page : str
        The report.
    point : SolvedPoint
        With a path, times, cycles or a list of loads.

    Raises
    ------
    InvalidInput
        If the answer has one state alone, or no contact that could be drawn.
    """
    sheets = list(frames_of(point, most=MOST_FRAMES))
    frames = [
        f'<img src="data:image/png;base64,{_packed(sheet)}" alt="{safe(_label(sheet, place, len(sheets)))}"'
        f"{'' if place == 0 else ' hidden'}>"
        for place, sheet in enumerate(sheets)
    ]
    slider = f'<input type="range" min="0" max="{len(sheets) - 1}" value="0" aria-label="Moment" hidden>'
    film = section("Animation", f'<figure class="film">{slider}{"".join(frames)}</figure>')
    head, body = page.split("</style>", 1)
    above, below = body.split(f"<section>\n{BEFORE}", 1)
    inside, end = f"{above}{film}\n<section>\n{BEFORE}{below}".rsplit("</body>", 1)
    return f'{head}{STYLE}</style>{inside}<script type="module">{SCRIPT}</script>\n</body>{end}'


def _label(sheet: Sheet, place: int, count: int) -> str:
    title = sheet.title.replace("$", "")
    return f"The contact at a moment: {title or f'{place + 1} of {count}'}"


def _packed(sheet: Sheet) -> str:
    """Return a frame as a PNG of few colours, in letters."""
    from PIL import Image

    from winkler.plot.render import render

    drawn, store = io.BytesIO(), io.BytesIO()
    render(sheet).savefig(drawn, format="png", dpi=DOTS_PER_INCH)
    with Image.open(drawn) as image:
        image.convert("RGB").quantize(COLOURS).save(store, format="png", optimize=True)
    return base64.b64encode(store.getvalue()).decode("ascii")
