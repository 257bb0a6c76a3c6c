"""The page: a study on the left, what it comes to on the right, answered while one types and slides."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import tomli_w
from nicegui import context, ui

from winkler.errors import WinklerError, mistake_in
from winkler.io.foreign import reason_of
from winkler.study.language.catalogue import CATALOGUE, kinds
from winkler.study.language.explain import summary
from winkler.study.language.fit_reading import FITTED
from winkler.study.language.reading import parsed
from winkler.web.form import fit_form, form
from winkler.web.form.study_form import TASKS, StudyForm
from winkler.web.page.astext import AsText
from winkler.web.page.fields import Fields
from winkler.web.page.fit_fields import draw_curve, draw_free, draw_measurement
from winkler.web.page.result import Result
from winkler.web.page.sweep_fields import draw_sweep
from winkler.web.pictures.answer import AnswerText, Frame, Picture, Shown
from winkler.web.session.export import File
from winkler.web.session.files import Files
from winkler.web.session.questions import Questions
from winkler.web.session.solver import Solver
from winkler.web.session.upload_folder import UploadFolder
from winkler.web.session.worker import Done, Export, Look, Progress, Solve, Wrong

__all__ = ["Page", "style"]

KNOWN = ("title", "problem", "fit", "sweep", "source", "grade")
"""Sections of a study that the form shows, or that need no showing."""
HERE = Path(__file__).parent


def style() -> None:
    """Give the page that is being made its looks."""
    ui.add_css((HERE / "app.css").read_text(encoding="utf-8"))
    report = (HERE.parents[1] / "study" / "report" / "report.css").read_text(encoding="utf-8")
    ui.add_css(f".paper {{ {report} }}")


def no_process(error: OSError) -> str:
    """Say that there is no process to solve in."""
    return f"No process can be started ({reason_of(error).lower()}); close other programs, then change the study."


class Page:
    """What one open page holds: its study, its folder, its worker, and what is shown.

    Parameters
    ----------
    limit
        The longest that a study may take [s].
    folder
        Where its uploads are kept, in a folder of their own.

    Raises
    ------
    OSError
        If no folder can be made, or no process started.
    """

    def __init__(self, limit: float, folder: Path) -> None:
        self.limit = limit
        self.client = context.client
        self.entered = StudyForm(self.changed, self.solve)
        self.room = UploadFolder(folder)
        try:
            self.solver = Solver(self.heard, self.lost)
        except OSError:
            self.room.close()
            raise
        self.questions = Questions(self.ask)
        self.anew = True
        self.shown_task = self.entered.task

    def left(self) -> None:
        """Clean up when the page is gone."""
        self.solver.close()
        self.room.close()

    # ------------------------------------------------------------------------------------------------ the page

    def build(self) -> None:
        """Lay the page out."""
        ui.on_exception(self.unexpected)
        with ui.element("header").classes("top"):
            ui.html("<h1>winkler</h1>", sanitize=False)
            ui.label("Contact mechanics: measured shapes in; forces, pressures and stresses out.").classes("motto")
            self.files = Files(self.room, self.opened, self.uploaded, self.not_taken, self.export)
        with ui.element("main").classes("desk"):
            with ui.element("section").classes("asked").props('aria-label="The study"'):
                self._problem()
                self.parts = ui.element("div").classes("form")
                self.text = AsText(lambda: self.entered.table, self.take_text)
            with ui.element("section").classes("answered").props('aria-label="The answer"') as right:
                self.result = Result(self.look, self.stop, right)
        self.rebuild()
        ui.timer(0.25, self.tick)
        self.solve()

    def _problem(self) -> None:
        self.task = ui.toggle(TASKS, value=self.entered.task).props("no-caps unelevated spread").classes("task")
        self.task.props["aria-label"] = "what to do"
        self.task.on_value_change(lambda event: self.entered.turn(event.value))
        self.choice = ui.select({}, label="problem").props("outlined options-dense").classes("problem")
        self.choice.props["data-choice"] = "problem"
        self.meaning = ui.label().classes("meaning")
        self.choice.on_value_change(lambda event: self.entered.choose("problem", event.value) if event.value else None)

    def rebuild(self) -> None:
        """Make the form anew."""
        entered = self.entered
        fits = entered.task == "fit"
        known = "What is known stays as it stands here; what is free begins here."
        problem = fit_form.model(entered.table) if fits else form.part_of(entered.table)
        self.task.set_value(entered.task)
        names = {name: name.replace("_", " ") for name in (FITTED if fits else CATALOGUE["problem"])}
        self.choice.set_options(names, value=problem.kind)
        self.choice.props["label"] = "model of the curve" if fits else "problem"
        self.meaning.text = summary(kinds()[problem.kind].cls)
        self.parts.clear()
        self.fields = Fields(entered, self.room.names, self.files.picker)
        with self.parts:
            if fits:
                draw_curve(self.fields, entered)
                draw_free(self.fields, entered)
                self.fields.heading("problem", "The model", known)
            self.fields.draw(problem)
            if fits:
                draw_measurement(self.fields, entered)
            else:
                draw_sweep(self.fields, entered)
            others = [f"[{name}]" for name in entered.table if name not in KNOWN]
            if others:
                ui.label(f"The study also has {', '.join(others)}: see the study as text.").classes("meaning")

    # --------------------------------------------------------------------------------------------------- files

    def opened(self, text: str) -> None:
        """Take an uploaded study."""
        self.text.open(text)

    def take_text(self, text: str) -> str:
        """Take a study from its text; return what is wrong with it."""
        try:
            table = parsed(text, "")
            known = FITTED if "fit" in table else CATALOGUE["problem"]
            if str((form.at(table, "problem") or {}).get("kind")) not in known:
                self._told_by_the_study(text, fits="fit" in table)
            if not isinstance(table.get("fit", {}), dict) or not isinstance(form.at(table, "fit.free") or {}, dict):
                self._told_by_the_study(text, fits=True)
            if "fit" not in table:  # a curve that is missing is said beside its field
                self.room.check(table)
        except WinklerError as error:
            return str(error)
        self.entered.take(table)
        return ""

    def _told_by_the_study(self, text: str, *, fits: bool) -> None:
        """Let the study's own checks say what is wrong with its problem."""
        from winkler.study.language.fit_reading import parse_fit_study
        from winkler.study.language.reading import parse_study

        (parse_fit_study if fits else parse_study)(text, folder=self.room.folder)

    def uploaded(self, name: str) -> None:
        """Read what was uploaded where it was asked for."""
        if form.at(self.entered.table, self.entered.target) is not None:
            self.entered.read(self.entered.target, name)

    def not_taken(self, sentence: str) -> None:
        """Say beside its place why an upload is not taken."""
        self.fields.say(self.entered.target, sentence)

    def export(self, what: str) -> None:
        """Ask for the answer as a file."""
        if self.result.told is None:
            ui.notify("There is no answer to take along: mend what is marked first.", type="warning")
        elif what == "study":
            self.files.take_study(self.result.told.text)
        else:
            self.questions.export(lambda number: Export(number, what))
            self.result.state("busy")

    # --------------------------------------------------------------------------------- questions and answers

    def changed(self) -> None:
        """Show another form, and its answer."""
        self.anew = True
        if self.entered.task != self.shown_task:
            self.shown_task = self.entered.task
            self.result.forget()
        self.rebuild()
        self.solve()

    def solve(self) -> None:
        """Ask for the answer to the study as it stands; while another is on its way, the newest question waits."""
        table = self.entered.table
        text = tomli_w.dumps(table)
        self.text.show()
        try:
            self.room.check(table)
        except WinklerError as error:
            self.wrong(str(error).splitlines())
            return

        def question(number: int) -> Solve:
            anew, self.anew = self.anew, False
            return Solve(number, text, self.room.folder, anew)

        self.result.pause()
        self.questions.study(question)
        self.result.state("busy")

    def ask(self, question: Callable[[int], Any]) -> None:
        """Hand a question to the worker."""
        try:
            self.solver.ask(question)
        except OSError as error:
            self.questions.forget()
            self.result.refuse([no_process(error)], beside=False)

    def lost(self, ready: bool) -> None:
        """Say that the worker has ended by itself; the next question gets a new one."""
        self.questions.forget()
        when = ", perhaps for want of memory; ask for less" if ready else " before it was ready"
        with self.client:
            self.result.refuse([f"The process of this page ended{when}. Change the study to try again."], beside=False)

    def unexpected(self, error: Exception) -> None:
        """Show an error that nothing has been prepared for; NiceGUI alone would write it where the app was started."""
        self.result.refuse([f"{mistake_in(error)}; report it with this study."], beside=False)

    def look(self, moment: int) -> None:
        """Ask for the pictures of another moment."""
        self.questions.look(lambda number: Look(number, moment))
        self.result.state("busy")

    def heard(self, reply: Any, *, newest: bool) -> None:
        """Show a part of an answer: to the newest question, or a sheet that still comes for the study."""
        with self.client:
            match reply:
                case Progress():
                    self.result.reached(reply.done, reply.total)
                case Wrong():
                    self.wrong(list(reply.sentences))
                case AnswerText():
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
            if newest:
                self.questions.heard(reply)
            if isinstance(reply, Done) and self.questions.quiet and not self.solver.working:
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
        self.result.passing(self.solver.seconds, ready=not self.solver.starting)
        if self.solver.seconds > self.limit:
            late = f"The study took longer than {self.limit:g} s and was stopped"
            self.stop(f"{late}; ask for less, or run it on the command line.")

    def stop(self, why: str = "Stopped.") -> None:
        """End what is going on."""
        self.questions.forget()
        try:
            self.solver.stop()
        except OSError as error:
            why = f"{why} {no_process(error)}"
        self.result.refuse([why], beside=False)
