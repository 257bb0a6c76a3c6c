"""The right side of the page: the answer in words, the pictures side by side, and how far it all can be trusted."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import ui

from winkler.study.report.markup import safe
from winkler.web.page.picture import Card, caption
from winkler.web.pictures.answer import AnswerText, Frame, Picture, Shown

__all__ = ["Result"]

STEP = 0.12
"""Seconds between two moments of a film."""
FRAMES = 60
"""A film has so many moments at most."""


class Result:
    """What an answer is shown in.

    Parameters
    ----------
    look
        Asks for the pictures of another moment.
    stop
        Ends what is going on.
    place
        The element around it all.
    """

    def __init__(self, look: Callable[[int], None], stop: Callable[[], None], place: Any) -> None:
        self.look, self.place = look, place
        self.told: AnswerText | None = None
        self.cards: list[Card] = []
        self.come = 0
        self.sheets = 0
        self.points = ""
        with ui.element("div").classes("status") as self.status:
            self.clock = ui.label("Getting ready …").props('role="status"')
            self.halt = ui.button("Stop", icon="stop", on_click=lambda: stop()).props("outline dense no-caps")
        self.wrong = ui.element("div").classes("refused").props('role="alert"')
        self.wrong.set_visibility(False)
        self.head = ui.html("", sanitize=False).classes("paper head")
        self._film()
        self.remark = ui.label().classes("meaning")
        self.grid = ui.element("div").classes("pictures")
        self.drawn = ui.element("div").classes("paper sheets")
        self.tail = [ui.html("", sanitize=False).classes("paper tail") for _ in range(3)]

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
            self.look(int(event.value))

    def _count(self) -> None:
        last = int(self.moment.props["max"])
        self.counter.text = f"{int(self.moment.value) + 1} of {last + 1}"

    def pause(self) -> None:
        """Stop the film."""
        if self.timer.active:
            self.toggle()

    def toggle(self) -> None:
        """Play, or pause."""
        self.timer.active = not self.timer.active
        self.play.props["icon"] = "pause" if self.timer.active else "play_arrow"
        self.play.update()

    def _next(self) -> None:
        last = int(self.moment.props["max"])
        step = max(1, (last + 1) // FRAMES)
        now = int(self.moment.value)
        self.moment.set_value(0 if now >= last else min(now + step, last))

    def say(self, told: AnswerText) -> None:
        """Show the answer in words; pictures follow."""
        self.told = told
        self.wrong.set_visibility(False)
        for part in (self.head, self.grid, self.drawn, *self.tail):
            part.classes(remove="stale")
        badge = f'<p class="standing-line"><span class="standing {told.standing}">{told.standing}</span></p>'
        self.head.set_content(badge + told.answers)
        self.drawn.clear()
        self.sheets = 0
        self.place.classes(**{"add" if told.points > 1 else "remove": "swept"})
        self.film.set_visibility(told.moments > 1)
        self.pause()
        if told.moments > 1:
            self.quiet = True
            self.moment.props["max"] = told.moments - 1
            self.moment.update()
            self.moment.set_value(told.moment)
            self._count()
            self.quiet = False

    def picture(self, one: Picture) -> None:
        """Show the next interactive picture: one that stays is only told to draw itself again."""
        place, self.come = self.come, self.come + 1
        if place < len(self.cards) and self.cards[place].shows(one):
            self.cards[place].draw(one)
            return
        self.keep(place)
        with self.grid:
            self.cards.append(Card(one))

    def show(self, frame: Frame) -> None:
        """All pictures of a moment have come: those of another answer go, and what stands below them follows."""
        self.keep(frame.total)
        self.come = 0
        self.remark.text = frame.remark
        if self.told is None:
            return
        for part, content in zip(self.tail, (self.told.answers, self.told.notes, self.told.papers), strict=True):
            if part.content != content:  # laying out a page again takes longer than solving
                part.set_content(content)

    def keep(self, count: int) -> None:
        """Keep the first pictures, and take the others away."""
        for card in self.cards[count:]:
            card.place.delete()
        del self.cards[count:]

    def sheet(self, one: Shown) -> None:
        """Show a sheet that was drawn as a whole."""
        self.sheets += 1
        with self.drawn:
            body = one.svg or f'<p class="missing">Not shown: {safe(one.missing)}</p>'
            ui.html(f"<figure>{caption(one.title, one.sentence)}{body}</figure>", sanitize=False)

    def forget(self) -> None:
        """Take away what is shown: it is no answer to what is asked now."""
        self.told, self.come = None, 0
        self.remark.text = ""
        self.keep(0)
        self.drawn.clear()
        for part in (self.head, *self.tail):
            part.set_content("")
        self.film.set_visibility(False)

    def refuse(self, sentences: list[str], *, beside: bool) -> None:
        """Say why there is no answer; the last one stays, pale."""
        self.told, self.come = None, 0
        for part in (self.head, self.grid, self.drawn, *self.tail):
            part.classes(add="stale")
        self.film.set_visibility(False)
        self.pause()
        self.wrong.clear()
        with self.wrong:
            for one in sentences:
                ui.label(one)
            if beside:
                before = "; what is shown below is the answer before" if self.head.content else ""
                ui.label(f"Mend what is marked in the form{before}.")
        self.wrong.set_visibility(True)
        self.state("wrong")

    def state(self, word: str) -> None:
        """Say whether an answer is on its way (``busy``), complete (``done``), or refused (``wrong``)."""
        self.points = ""
        self.place.props["data-state"] = word
        self.place.props["aria-busy"] = "true" if word == "busy" else "false"
        self.place.update()

    def reached(self, done: int, total: int | None) -> None:
        """Tell how many points of a sweep or a path are solved."""
        many = f"{done} points" if total is None else f"{done} of {total} points"
        self.points = f", {many}" if total is None or done < total else ""

    def passing(self, seconds: float, *, ready: bool) -> None:
        """Tell how long it takes."""
        busy = not ready or seconds > 0.4
        self.status.set_visibility(busy)
        if busy:
            self.clock.text = f"Solving and drawing, {seconds:.0f} s{self.points}" if ready else "Getting ready …"
            self.halt.set_visibility(ready)

    def rest(self) -> None:
        """Say that all is shown."""
        self.status.set_visibility(False)
        if self.told is not None:
            self.state("done")
