"""The right side of the page: results in numbers, pictures, and validity notes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import ui

from winkler.study.report.markup import assumed_line, safe
from winkler.web.pictures.comparison import comparison
from winkler.web.pictures.replies import AnswerText, DrawnSheet, InteractivePicture, MomentComplete
from winkler.web.session.batch import Progress

STEP = 0.12
"""Time between two frames of an animation [s]."""
FRAMES = 60
"""Most frames of an animation."""
GETTING_READY = "Getting ready …"


CHOSEN_ROW = """event => {
  const row = event.target.closest('[data-curve]');
  if (row) emit(Number(row.dataset.curve));
}"""
"""Tells which curve of the list was chosen."""


class Result:
    """The elements that show results.

    Parameters
    ----------
    show_moment
        Requests the pictures of another moment.
    stop
        Stops the running request.
    place
        The enclosing element.
    """

    def __init__(self, show_moment: Callable[[int], None], stop: Callable[[], None], place: Any) -> None:
        self.show_moment, self.place = show_moment, place
        self.answer: AnswerText | None = None
        self.cards: list[Card] = []
        self.received = 0
        self.sheets = 0
        self.points = ""
        with ui.element("div").classes("status"):
            self.clock = LiveHtml().props('role="status"')
            self.clock.set_content(GETTING_READY)
            ui.button("Stop", icon="stop", on_click=lambda: stop()).props("outline dense no-caps")
        self.wrong = ui.element("div").classes("refused").props('role="alert"')
        self.wrong.set_visibility(False)
        ui.html("The answer", sanitize=False, tag="h2").classes("spoken")
        self.head = LiveHtml().classes("paper head")
        self.pinned = PinnedAnswer(self._pin)
        self.batch = self.halting = False
        self.curves = LiveHtml().classes("paper curve-list")
        self.curves.on("click", lambda event: self.choose(event.args), js_handler=CHOSEN_ROW)
        self._film()
        self.remark = ui.label().classes("meaning")
        ui.html("Pictures", sanitize=False, tag="h2").classes("spoken")
        PictureLoader()
        self.grid = ui.element("div").classes("pictures")
        self.drawn = ui.element("div").classes("paper sheets")
        self.tail = [LiveHtml().classes("paper tail") for _ in range(3)]

    def _film(self) -> None:
        with ui.element("div").classes("film") as self.film:
            self.play = ui.button(icon="play_arrow", on_click=self.toggle).props("round dense outline")
            self.play.props["aria-label"] = "play the history"
            self.moment = ui.slider(min=0, max=1, step=1, value=0).props('aria-label="moment of the history"')
            self.counter = ui.label().classes("counter")
        self.moment.on_value_change(self._turn)
        self.timer = ui.timer(STEP, self._next, active=False)
        self.film.set_visibility(False)
        self.quiet = False

    def _turn(self, event: Any) -> None:
        self._count()
        if not self.quiet:
            self.show_moment(int(event.value))

    def _count(self) -> None:
        last, now = int(self.moment.props["max"]), int(self.moment.value)
        labels = self.answer.labels if self.answer else ()
        self.counter.text = f"{now + 1} of {last + 1}" + (f": {labels[now]}" if now < len(labels) else "")

    def choose(self, moment: object) -> None:
        """Show another moment, or another curve of several."""
        if isinstance(moment, int | float) and 0 <= moment <= int(self.moment.props["max"]):
            self.moment.set_value(int(moment))

    def pause(self) -> None:
        """Pause the animation."""
        if self.timer.active:
            self.toggle()

    def toggle(self) -> None:
        """Play or pause the animation."""
        self.timer.active = not self.timer.active
        self.play.props["icon"] = "pause" if self.timer.active else "play_arrow"
        self.play.update()

    def _next(self) -> None:
        last = int(self.moment.props["max"])
        step = max(1, (last + 1) // FRAMES)
        now = int(self.moment.value)
        self.moment.set_value(0 if now >= last else min(now + step, last))

    def show_answer(self, answer: AnswerText, assumed: str = "") -> None:
        """Show the results in numbers, and which numbers of the study are assumed; pictures follow."""
        self.answer = answer
        self.wrong.set_visibility(False)
        for part in (self.head, self.curves, self.grid, self.drawn, *self.tail):
            part.classes(remove="stale")
        badge = f'<p class="standing-line">{answer.trust}</p>'
        self.head.set_content(badge + answer.doubt + answer.answers + assumed_line(assumed))
        self.curves.set_content(answer.curves)
        self._clear_sheets()
        self.place.classes(**{"add" if answer.points > 1 else "remove": "swept"})
        self.film.set_visibility(answer.moments > 1)
        self.pause()
        if answer.moments > 1:
            self.quiet = True
            if self.moment.props["max"] != answer.moments - 1:
                self.moment.props["max"] = answer.moments - 1
            self.moment.set_value(answer.moment)
            self._count()
            self.quiet = False

    def picture(self, one: InteractivePicture) -> None:
        """Show the next interactive picture: an existing one is only redrawn."""
        place, self.received = self.received, self.received + 1
        if place < len(self.cards) and self.cards[place].shows(one):
            self.cards[place].draw(one)
            return
        self.keep_cards(place)
        with self.grid:
            self.cards.append(Card(one, self.pinned.charts, self.choose))

    def _pin(self) -> None:
        """Draw the curves of the pinned answer below those that are shown, or none."""
        for card in self.cards:
            card.pin(self.pinned.charts)

    def show(self, frame: MomentComplete) -> None:
        """Remove pictures of earlier results after the last one of a moment, and update the text below."""
        self.keep_cards(frame.total)
        self.received = 0
        self.remark.text = frame.remark
        if self.answer is None:
            return
        self.pinned.show(self.answer, {card.name: card.chart for card in self.cards if card.chart})
        for part, content in zip(self.tail, (self.answer.answers, self.answer.notes, self.answer.papers), strict=True):
            part.set_content(content)

    def keep_cards(self, count: int) -> None:
        """Keep the first pictures, and remove the others."""
        for card in self.cards[count:]:
            card.place.delete()
        del self.cards[count:]

    def sheet(self, one: DrawnSheet) -> None:
        """Show a sheet of panels."""
        self.sheets += 1
        with self.drawn:
            body = one.svg or f'<p class="missing">Not shown: {safe(one.missing)}</p>'
            ui.html(f"<figure>{caption(one.title, one.sentence)}{body}</figure>", sanitize=False)

    def _clear_sheets(self) -> None:
        if self.sheets:
            self.drawn.clear()
        self.sheets = 0

    def clear(self) -> None:
        """Remove the displayed results of another study."""
        self.answer, self.received = None, 0
        self.remark.text = ""
        self.keep_cards(0)
        self.pinned.drop()
        self._clear_sheets()
        for part in (self.head, self.curves, *self.tail):
            part.set_content("")
        self.film.set_visibility(False)

    def refuse(self, sentences: list[str], *, beside: bool) -> None:
        """Show why there are no results; the last ones stay, faded."""
        self.answer, self.received = None, 0
        for part in (self.head, self.curves, self.grid, self.drawn, *self.tail):
            part.classes(add="stale")
        self.film.set_visibility(False)
        self.pause()
        self.wrong.clear()
        with self.wrong:
            for one in sentences:
                ui.label(one)
            if beside:
                before = "; the results below are the previous ones" if self.head.content else ""
                ui.label(f"Correct the marked fields{before}.")
        self.wrong.set_visibility(True)
        self.state("wrong")

    def state(self, word: str) -> None:
        """Set the state: running (``busy``), complete (``done``), or refused (``wrong``)."""
        self.points = ""
        self.batch = self.halting = False
        self.head.show_state(word)

    def show_progress(self, progress: Progress) -> None:
        """Show the number of solved points of a sweep or a path, or of fitted curves."""
        done, total, what = progress
        self.batch = what != Progress._field_defaults["what"]
        many = f"{done} {what}" if total is None else f"{done} of {total} {what}"
        self.points = f", {many}" if total is None or done < total else ""
        self.points += "; stopping after this one" if self.halting else ""

    def show_elapsed(self, seconds: float, *, ready: bool) -> None:
        """Show the elapsed time."""
        busy = not ready or seconds > 0.4
        self.clock.show_around(visible=busy, button=ready)
        if busy:
            running = f"Solving and drawing, {seconds:.0f} s{safe(self.points)}"
            self.clock.set_content(running if ready else GETTING_READY)

    def finish(self) -> None:
        """Set the state to complete."""
        self.clock.show_around(visible=False, button=True)
        if self.answer is not None:
            self.state("done")


class LiveHtml(ui.element, component="live.js"):
    """HTML that is replaced without a new look at the rest of the page."""

    content = ""
    around = (True, True)

    def set_content(self, content: str) -> None:
        """Replace the HTML, unless it is the same."""
        if content == self.content:
            return
        self.content = content
        with self.props.suspend_updates():
            self.props["first"] = content
        self.run_method("show", content)

    def show_state(self, word: str) -> None:
        """Set the state of the enclosing answer."""
        self.run_method("mark", word)

    def show_around(self, *, visible: bool, button: bool) -> None:
        """Show or hide the enclosing element, and the button in it."""
        if (visible, button) != self.around:
            self.around = (visible, button)
            self.run_method("showAround", visible, button)


DRAWN = "Dotted curves in the pictures are A."


class PinnedAnswer:
    """The button that pins an answer, and the comparison with it.

    Parameters
    ----------
    redraw
        Called when the pinned pictures have changed.
    """

    def __init__(self, redraw: Callable[[], None]) -> None:
        self.redraw = redraw
        self.answer: AnswerText | None = None
        self.charts: dict[str, str] = {}
        self.current: tuple[AnswerText | None, dict[str, str]] = (None, {})
        with ui.element("section").classes("pinned").props('aria-label="Comparison"'):
            with ui.row().classes("pin-line"):
                self.button = ui.button("Pin as A, to compare", icon="push_pin", on_click=self._toggle)
                self.button.props("outline dense no-caps").props["data-pin"] = "pin"
            self.table = ui.html("", sanitize=False).classes("paper compared")
        self.table.set_visibility(False)

    def _toggle(self) -> None:
        answer, charts = self.current
        self._pin(*((None, {}) if self.answer else (answer, dict(charts))))

    def drop(self) -> None:
        """Forget both answers, as the next ones are of another task."""
        self.current = (None, {})
        self._pin(None, {})

    def _pin(self, answer: AnswerText | None, charts: dict[str, str]) -> None:
        self.answer, self.charts = answer, charts
        self.button.text = "Unpin A" if self.answer else "Pin as A, to compare"
        self.show(*self.current)
        self.redraw()

    def show(self, answer: AnswerText | None, charts: dict[str, str]) -> None:
        """Compare an answer, and remember it with its pictures as what may be pinned."""
        self.current = (answer, charts)
        self.table.set_visibility(self.answer is not None)
        if self.answer is not None and answer is not None:
            pair = ((self.answer.text, self.answer.numbers), (answer.text, answer.numbers))
            self.table.set_content(f"<h3>A against B</h3>{comparison(*pair)}<p class='small'>{DRAWN}</p>")


PLOTLY = ui.plotly
"""Loads plotly.js, which the script of the drawing imports by name."""

BODY_PICTURE = "shape"
"""Name of the three-dimensional picture."""


class PictureLoader(ui.element, component="loader.js"):
    """Loads what draws pictures, while the first ones are computed."""


class PlotlyFigure(ui.element, component="picture.js", esm={"winkler-redraw": "redraw"}):
    """A figure: ``data``, ``layout`` and ``config`` for plotly.js, as JSON."""


class Solid(ui.element, component="solid.js"):
    """The body in space: the ``data`` of its curves, as JSON."""


NOT_PINNED = (BODY_PICTURE, "springs")
"""Pictures of bodies, over which nothing else is drawn."""
FORMATS = {"png": "PNG", "svg": "SVG", "csv": "CSV: the values of the curves"}


class Card:
    """A picture with its title, or the reason for its absence.

    Parameters
    ----------
    one
        The picture.
    pinned
        Pictures of an answer that is drawn below, by name.
    choose
        Called with the number of the moment, or of the curve, that was clicked.
    """

    def __init__(self, one: InteractivePicture, pinned: dict[str, str], choose: Callable[[object], None]) -> None:
        self.name, self.missing, self.chart = one.name, one.missing, one.chart
        with ui.element("figure").classes("card") as self.place:
            self.caption = ui.html(caption(one.title, one.sentence), sanitize=False)
            if one.chart:
                is_body = one.name == BODY_PICTURE
                self.drawing = (Solid if is_body else PlotlyFigure)().classes("plot")
                self.drawing.props.update({"first": one.chart, "data-picture": one.name})
                self.drawing.props["pinned"] = self._below(pinned)
                self.drawing.on("chosen", lambda event: choose(event.args))
                self._save_menu(one.title, ("png",) if is_body else tuple(FORMATS))
            else:
                ui.label(f"Not shown: {one.missing}").classes("missing")

    def _save_menu(self, title: str, formats: tuple[str, ...]) -> None:
        """Draw the button that saves this picture alone."""
        button = ui.button(icon="download").props("flat dense round size=sm").classes("save")
        button.props["aria-label"] = f"Save the picture: {title}"
        button.props["data-save"] = self.name
        with button, ui.menu().props('auto-close role="menu"'):
            for one in formats:
                call = f"getElement({self.drawing.id}).save('{one}', '{self.name}')"
                ui.menu_item(FORMATS[one]).props('role="menuitem"').on("click", js_handler=f"() => {call}")

    def shows(self, one: InteractivePicture) -> bool:
        """Return whether another picture can replace the data of this one."""
        return (self.name, self.missing) == (one.name, one.missing)

    def draw(self, one: InteractivePicture) -> None:
        """Redraw its figure, without a new layout of the page."""
        text = caption(one.title, one.sentence)
        if text != self.caption.content:
            self.caption.set_content(text)
        if one.chart:
            self.chart = one.chart
            self.drawing.run_method("draw", one.chart)

    def pin(self, pinned: dict[str, str]) -> None:
        """Draw the curves of another answer below those of this picture, or none."""
        if self.chart:
            self.drawing.run_method("pin", self._below(pinned))

    def _below(self, pinned: dict[str, str]) -> str:
        return pinned.get(self.name, "") if self.name not in NOT_PINNED else ""


def caption(title: str, sentence: str) -> str:
    """Return the caption of a picture."""
    text = f"<p>{safe(sentence)}</p>" if sentence else ""
    return f"<figcaption><h3>{safe(title)}</h3>{text}</figcaption>"
