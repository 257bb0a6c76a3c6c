"""The page: a study on the left, what it comes to on the right, answered while one types and slides."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from nicegui import context, events, ui

from winkler.errors import WinklerError
from winkler.study.catalogue import CATALOGUE, kinds
from winkler.study.explain import completed, summary
from winkler.study.reading import parsed
from winkler.web import form
from winkler.web.answer import Frame, Picture, Shown, Told
from winkler.web.fields import Fields
from winkler.web.result import Result
from winkler.web.room import LARGEST, Room
from winkler.web.solver import Solver, Worker, started
from winkler.web.typed import typed
from winkler.web.worker import Done, Export, File, Look, Solve, Wrong

__all__ = ["Page", "page"]

FIRST = "indentation"
HERE = Path(__file__).parent


def page(limit: float, spare: list[Worker]) -> Callable[[], None]:
    """Return what builds a page for everybody who opens the app.

    Parameters
    ----------
    limit
        The longest that a study may take [s].
    spare
        Workers that are ready, for the first to come.
    """

    def build() -> None:
        made = Page(limit, spare.pop() if spare else started())
        made.build()
        context.client.on_delete(made.left)

    return build


class Page:
    """What one open page holds: the table of its study, its folder, its worker.

    Parameters
    ----------
    limit
        The longest that a study may take [s].
    worker
        Solves and draws for this page.
    """

    def __init__(self, limit: float, worker: Worker) -> None:
        self.limit = limit
        self.client = context.client
        self.table: dict[str, Any] = form.begun(FIRST)
        self.room = Room()
        self.solver = Solver(self.heard, worker)
        self.waiting: Callable[[int], Any] | None = None
        self.anew = True
        self.target = ""

    def left(self) -> None:
        """Clean up when the page is gone."""
        self.solver.close()
        self.room.close()

    # ------------------------------------------------------------------------------------------------ the page

    def build(self) -> None:
        """Lay the page out."""
        ui.add_css((HERE / "app.css").read_text(encoding="utf-8"))
        report = (HERE.parent / "study" / "report.css").read_text(encoding="utf-8")
        ui.add_css(f".paper {{ {report} }}")
        with ui.element("header").classes("top"):
            ui.html("<h1>winkler</h1>", sanitize=False)
            ui.label("Contact mechanics: measured shapes in; forces, pressures and stresses out.").classes("motto")
            self._files()
        with ui.element("main").classes("desk"):
            with ui.element("section").classes("asked").props('aria-label="The study"'):
                self._problem()
                self.parts = ui.element("div").classes("form")
                self._text()
            with ui.element("section").classes("answered").props('aria-label="The answer"') as right:
                self.result = Result(self.look, self.stop, right)
        self.rebuild()
        ui.timer(0.25, self.tick)
        self.solve()

    def _problem(self) -> None:
        names = {name: name.replace("_", " ") for name in CATALOGUE["problem"]}
        self.choice = ui.select(names, value=FIRST, label="problem")
        self.choice.props("outlined options-dense").classes("problem").props["data-choice"] = "problem"
        self.meaning = ui.label().classes("meaning")
        self.choice.on_value_change(lambda event: self.choose("problem", event.value) if event.value else None)

    def _files(self) -> None:
        """Add what is opened, uploaded and taken along."""
        size = LARGEST
        opened = ui.upload(on_upload=self.opened, on_rejected=self.refused, auto_upload=True, max_file_size=size)
        opened.classes("unseen").props('accept=".toml"').props["data-upload"] = "study"
        self.uploads = ui.upload(
            on_upload=self.uploaded, on_rejected=self.refused, auto_upload=True, max_file_size=size
        )
        self.uploads.classes("unseen").props["data-upload"] = "data"
        with ui.element("nav").classes("files"):
            button = ui.button("Open a study", icon="folder_open").props("flat dense no-caps")
            button.on("click", js_handler=_picker(opened))
            for what, told, icon in (
                ("study", "Study file", "description"),
                ("csv", "CSV", "table_view"),
                ("png", "Figures", "image"),
                ("report", "Report", "article"),
            ):
                take = ui.button(told, icon=icon, on_click=lambda what=what: self.export(what))
                take.props("flat dense no-caps").props["data-export"] = what

    def _text(self) -> None:
        """Add the study as text, to be read and written."""
        with ui.expansion("The study as text", on_value_change=self.unfold).classes("astext") as self.fold:
            self.area = ui.textarea().props("outlined input-class=code autogrow").classes("text")
            self.area.props["aria-label"] = "The study as text"
            self.wrong_text = ui.label().classes("wrong").props('role="alert"')
            ui.button("Use this text", on_click=lambda: self.take_text(str(self.area.value))).props("outline no-caps")

    def unfold(self) -> None:
        """Write the study where it is read."""
        import tomli_w

        self.area.set_value(tomli_w.dumps(self.table))

    # -------------------------------------------------------------------------------------- what a person does

    def choose(self, path: str, kind: str) -> None:
        """Put a kind at a place; an empty one leaves it out."""
        if kind == str((form.at(self.table, path) or {}).get("kind", "")):
            return
        if kind:
            form.chosen(self.table, path, kind)
        else:
            form.drop(self.table, path)
        if path == "problem":
            self.table = {"title": self.table["title"], "problem": self.table["problem"]}
        self.changed()

    def change(self, path: str, text: str, takes: str) -> None:
        """Put what was typed at a key; nothing leaves it out."""
        content = typed(text, takes) if text.strip() else None
        if content == form.at(self.table, path):
            return
        if content is None:
            form.drop(self.table, path)
        else:
            form.put(self.table, path, content)
        self.solve()

    def add(self, path: str, kind: str) -> None:
        """Add a kind to a list."""
        form.put(self.table, path, [*(form.at(self.table, path) or []), completed({"kind": kind})])
        self.changed()

    def pick(self, path: str) -> None:
        """Say that the next upload belongs to a place."""
        self.target = path

    def read(self, path: str, name: str) -> None:
        """Take a file in place of numbers; an empty name goes back to numbers."""
        kind = str(form.at(self.table, path)["kind"])
        form.put(self.table, path, {"kind": kind, "file": name} if name else completed({"kind": kind}))
        self.changed()

    async def uploaded(self, event: events.UploadEventArguments) -> None:
        """Keep what was uploaded, and read it where it was asked for."""
        self.uploads.reset()
        try:
            name = self.room.keep(event.file.name, await event.file.read())
        except WinklerError as error:
            self.fields.say(self.target, str(error))
            return
        if form.at(self.table, self.target) is not None:
            self.read(self.target, name)

    def refused(self) -> None:
        """Say why a file was not taken."""
        ui.notify(
            f"The file is not taken: it has more than {LARGEST / 1e6:.0f} MB, or another ending.", type="negative"
        )

    async def opened(self, event: events.UploadEventArguments) -> None:
        """Take an uploaded study."""
        event.sender.reset()  # type: ignore[attr-defined]
        try:
            text = (await event.file.read()).decode("utf-8-sig")
        except UnicodeDecodeError as error:
            ui.notify(f"{event.file.name}: byte {error.start} is not UTF-8; save it as UTF-8 text.", type="negative")
            return
        self.fold.open()
        self.take_text(text)

    def take_text(self, text: str) -> None:
        """Take a study from its text; say what is wrong with it below the text."""
        self.area.set_value(text)
        try:
            table = parsed(text, "")
            if str((form.at(table, "problem") or {}).get("kind")) not in CATALOGUE["problem"]:
                self.solver_check(text)
            self.room.check(table)
        except WinklerError as error:
            self.wrong_text.text = str(error)
            return
        self.wrong_text.text = ""
        self.table = table
        self.changed()

    def solver_check(self, text: str) -> None:
        """Let the study's own checks say what is wrong with its problem."""
        from winkler.study.reading import parse_study

        parse_study(text, folder=self.room.folder)

    # --------------------------------------------------------------------------------- questions and answers

    def rebuild(self) -> None:
        """Make the form anew."""
        problem = form.part_of(self.table)
        self.choice.set_value(problem.kind)
        self.meaning.text = summary(kinds()[problem.kind].cls)
        self.parts.clear()
        self.fields = Fields(self, self.room.names, _picker(self.uploads))
        with self.parts:
            self.fields.draw(problem)
            others = [f"[{name}]" for name in self.table if name not in ("title", "problem", "source", "grade")]
            if others:
                ui.label(f"The study also has {', '.join(others)}: see the study as text.").classes("meaning")

    def changed(self) -> None:
        """Show another form, and its answer."""
        self.anew = True
        self.rebuild()
        self.solve()

    def solve(self) -> None:
        """Ask for the answer to the study as it stands; while another is on its way, the newest question waits."""
        import tomli_w

        text = tomli_w.dumps(self.table)
        if self.fold.value:
            self.area.set_value(text)
        try:
            self.room.check(self.table)
        except WinklerError as error:
            self.wrong(str(error).splitlines())
            return
        anew, self.anew = self.anew, False
        self.ask(lambda number: Solve(number, text, self.room.folder, anew))

    def look(self, moment: int) -> None:
        """Ask for the pictures of another moment."""
        self.ask(lambda number: Look(number, moment))

    def export(self, what: str) -> None:
        """Ask for the answer as a file."""
        if self.result.told is None:
            ui.notify("There is no answer to take along: mend what is marked first.", type="warning")
        elif what == "study":
            ui.download.content(self.result.told.text.encode(), "study.toml")
        else:
            self.ask(lambda number: Export(number, what))

    def ask(self, make: Callable[[int], Any]) -> None:
        """Ask now, or as soon as what is being answered has been."""
        self.result.state("busy")
        if self.answering:
            self.waiting = make
        else:
            self.answering = True
            self.solver.ask(make)

    answering = False

    def heard(self, reply: Any) -> None:
        """Show a part of an answer."""
        with self.client:
            match reply:
                case Wrong():
                    self.wrong(list(reply.sentences))
                case Told():
                    self.fields.clear()
                    self.result.say(reply)
                case Shown():
                    self.result.sheet(reply)
                case File():
                    ui.download.content(reply.content, reply.name)
                case Picture():
                    self.result.picture(reply)
                case Frame():
                    self.result.show(reply)
            if not isinstance(reply, Told | Picture):  # what follows the pictures gives way to a new question
                self.answering = False
                if self.waiting is not None:
                    make, self.waiting = self.waiting, None
                    self.ask(make)
            if isinstance(reply, Done):
                self.result.rest()

    def wrong(self, sentences: list[str]) -> None:
        """Show what is wrong beside the fields that it is about, and the rest above the answer."""
        self.fields.clear()
        rest = [one for one in sentences if not self._beside(one)]
        self.result.refuse(rest, beside=len(rest) < len(sentences))

    def _beside(self, sentence: str) -> bool:
        path = form.owner_of(sentence)
        short = sentence.removeprefix(path.rpartition(".")[0] + ".") if path else sentence
        return bool(path) and self.fields.say(path, short)

    def tick(self) -> None:
        """Watch the time."""
        self.result.passing(self.solver.seconds, ready=self.solver.ready)
        if self.solver.seconds > self.limit:
            late = f"The study took longer than {self.limit:g} s and was stopped"
            self.stop(f"{late}; ask for less, or run it on the command line.")

    def stop(self, why: str = "Stopped.") -> None:
        """End what is going on."""
        self.waiting, self.answering = None, False
        self.solver.stop()
        self.result.refuse([why], beside=False)


def _picker(upload: ui.upload) -> str:
    """Return the script that opens the choice of a file; it runs in the browser, which wants to see the click."""
    return f"() => getElement({upload.id}).$refs.qRef.pickFiles()"
