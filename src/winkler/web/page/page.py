"""The page: a study on the left, its results on the right, updated while the study is edited."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import Any

import tomli_w
from nicegui import context, ui

from winkler.values.errors import WinklerError, mistake_in
from winkler.web.fields.fields import FormFields
from winkler.web.fields.fit_fields import draw_curve, draw_free, draw_measurement, show_curve
from winkler.web.fields.sweep_fields import draw_sweep
from winkler.web.form import fit_form, form
from winkler.web.form.front_examples import FRONT_EXAMPLES, QUESTIONS
from winkler.web.form.sample_curve import SAMPLE
from winkler.web.form.study_form import StudyForm
from winkler.web.form.taken import assumed_in, taken, with_assumed
from winkler.web.page.kept_studies import KeptStudies
from winkler.web.page.question import Question
from winkler.web.page.result import Result
from winkler.web.page.stopping import Stopping
from winkler.web.pictures.replies import (
    AnswerText,
    DrawnSheet,
    File,
    InspectedFile,
    InteractivePicture,
    MomentComplete,
)
from winkler.web.session.files import Files
from winkler.web.session.requests import RequestQueue
from winkler.web.session.solver import Solver, Worker, no_process
from winkler.web.session.upload_folder import CURVES, SAMPLE_CURVES, UploadFolder, keep_samples
from winkler.web.session.worker import Done, Export, Inspect, Look, Progress, Solve, Wrong

SHOWN_SECTIONS = ("title", "problem", "fit", "sweep", "source", "grade")
"""Sections of a study that the form shows, or that need no display."""
FOLDER = Path(__file__).parent


def style() -> None:
    """Add the style sheets to the page."""
    ui.add_css((FOLDER / "app.css").read_text(encoding="utf-8"))
    report = (FOLDER.parents[1] / "study" / "report" / "report.css").read_text(encoding="utf-8")
    ui.add_css(f".paper {{ {report} }}")


class Page:
    """One open page: its study, folder, worker, and displayed results.

    Parameters
    ----------
    limit
        The longest that a study may take [s].
    folder
        Parent of the folder for its uploads.
    take
        Gives the process that solves for it.

    Raises
    ------
    OSError
        If no folder can be made, or no process started.
    """

    def __init__(self, limit: float, folder: Path, take: Callable[[], Worker]) -> None:
        self.limit = limit
        self.client = context.client
        self.uploads = UploadFolder(folder)
        self.entered = StudyForm(self.changed, self.solve, self.uploads.folder)
        try:
            self.solver = Solver(self.receive, self.worker_ended, take)
        except OSError:
            self.uploads.close()
            raise
        form.put(self.entered.other_table, "fit.curve", SAMPLE)
        self.requests = RequestQueue(self.send)
        self.stopping = Stopping(limit, self.solver, self.requests)
        self.anew = True
        self.shown_task = self.entered.task

    def close(self) -> None:
        """Release the resources of a closed page."""
        self.solver.close()
        self.uploads.close()

    # ------------------------------------------------------------------------------------------------ the page

    def build(self) -> None:
        """Build the page."""
        ui.on_exception(self.unexpected)
        with ui.element("header").classes("top"):
            ui.html("<h1>winkler</h1>", sanitize=False)
            ui.label("Contact mechanics: measured shapes in; forces, pressures and stresses out.").classes("motto")
            self.kept = KeptStudies(self.restore, self.begin, self.uploads)
            examples = ui.button("Examples", icon="grid_view", on_click=lambda: self.front.toggle())
            examples.props("flat dense no-caps").props["data-kept"] = "examples"
            self.files = Files(self.uploads, self.opened, self.uploaded, self.upload_refused, self.export, self.inspect)
        self.looked_at = LookedAt(self.take_text)
        with ui.element("div").classes("desk") as desk:
            with ui.element("section").classes("study-side").props('aria-label="The study"'):
                ui.html("The study", sanitize=False, tag="h2").classes("spoken")
                self.question = Question(self.entered)
                self.parts = ui.element("div").classes("form")
                self.text = AsText(lambda: self.entered.table, self.take_text, self.edit_text)
            with ui.element("section").classes("answer-side").props('aria-label="The answer"') as right:
                self.front: Front = Front(self.entered.begin_with)
                self.result = self.stopping.result = Result(self.show_moment, self.stopping.by_hand, right)
        self.files.take_drops(desk)
        self.rebuild()
        ui.timer(0.25, self.stopping.tick)

    def begin(self) -> None:
        """Begin with the first study, as there is no earlier work."""
        self.front.show(visible=True)
        self.solve()

    def rebuild(self) -> None:
        """Rebuild the form."""
        entered = self.entered
        fits = entered.task == "fit"
        problem = fit_form.model(entered.table) if fits else form.part_of(entered.table)
        self.question.show(problem.kind)
        self.parts.clear()
        self.fields = FormFields(entered, self.uploads.names, self.files.picker, self.uploads.folders)
        with self.parts:
            if fits:
                draw_curve(self.fields, entered, self.files, self.drop_curves)
                draw_free(self.fields, entered)
                self.fields.heading("problem", "The model", fit_form.model_remark(entered.table))
            self.fields.draw(problem)
            if fits:
                draw_measurement(self.fields, entered)
            else:
                draw_sweep(self.fields, entered)
            others = [f"[{name}]" for name in entered.table if name not in SHOWN_SECTIONS]
            if others:
                ui.label(f"The study also has {', '.join(others)}: see the study as text.").classes("meaning")

    # --------------------------------------------------------------------------------------------------- files

    def opened(self, text: str) -> None:
        """Take an uploaded study."""
        self.text.open(text)

    def take_text(self, text: str) -> str:
        """Take another study from its text; return its mistakes."""
        return self._take_text(text, lambda table: self.entered.load(table, assumed_in(text)))

    def edit_text(self, text: str) -> str:
        """Take the study from its edited text; return its mistakes."""
        return self._take_text(text, self.entered.load_edited)

    def _take_text(self, text: str, take: Callable[[dict[str, Any]], None]) -> str:
        try:
            table = taken(text, self.uploads.folder)
            if "fit" not in table:  # a missing curve is reported beside its field
                self.uploads.check(table)
        except WinklerError as error:
            return str(error)
        take(table)
        return ""

    def restore(self, text: str) -> str:
        """Take up an earlier study; what is missing of it is reported beside its fields."""
        try:
            self.entered.load(taken(text, self.uploads.folder), assumed_in(text))
        except WinklerError as error:
            return str(error)
        return ""

    def uploaded(self, name: str) -> None:
        """Use an uploaded file at the path for which it was meant."""
        target = self.entered.target
        if form.at(self.entered.table, target) is None:
            return
        if target == fit_form.CURVE:
            self.fields.files, self.fields.folders, self.anew = self.uploads.names, self.uploads.folders, True
            self.entered.read_curve(name)
            show_curve(self.fields, self.entered)
        else:
            self.entered.read(target, name)

    def drop_curves(self) -> None:
        """Remove the uploaded folder of curves; a study that read it goes back to the sample."""
        self.uploads.remove_curves()
        self.fields.folders = self.uploads.folders
        if form.at(self.entered.table, fit_form.CURVE) == CURVES:
            self.entered.read_curve(SAMPLE_CURVES)
        show_curve(self.fields, self.entered)

    def upload_refused(self, sentence: str) -> None:
        """Show beside its field why an upload is refused."""
        self.fields.show_mistake(self.entered.target, sentence)

    def export(self, what: str) -> None:
        """Request the results as a file."""
        if self.result.answer is None:
            ui.notify("There are no results to save: correct the marked fields first.", type="warning")
        elif what == "study":
            self.files.take_study(with_assumed(self.result.answer.text, self.entered.still_assumed))
        else:
            self.requests.export(lambda number: Export(number, what, self.entered.assumed_sentence))
            self.result.state("busy")

    def inspect(self, name: str) -> None:
        """Request what an uploaded file is taken for."""
        self.requests.export(lambda number: Inspect(number, name, self.uploads.folder))
        self.result.state("busy")

    # --------------------------------------------------------------------------------- requests and replies

    def changed(self) -> None:
        """Rebuild the form, and solve its study."""
        self.anew = True
        self.front.show(visible=False)
        if self.entered.task == "fit":
            keep_samples(self.uploads)
        if self.entered.task != self.shown_task:
            self.shown_task = self.entered.task
            self.result.clear()
        self.rebuild()
        self.solve()

    def solve(self) -> None:
        """Request the results of the current study; while another request runs, the newest one waits."""
        table = self.entered.table
        text, only_value = tomli_w.dumps(table), not self.anew
        self._request(table, text)  # first, so that it is solved while the rest is kept and shown
        self.text.show()
        self.kept.keep(table, with_assumed(text, self.entered.still_assumed), value=only_value)

    def _request(self, table: dict[str, Any], text: str) -> None:
        """Send a study to the worker, or show which of its files are missing."""
        try:
            self.uploads.check(table)
        except WinklerError as error:
            self.requests.clear()
            self.solver.disregard()
            self.wrong(str(error).splitlines())
            return

        def request(number: int) -> Solve:
            anew, self.anew = self.anew, False
            return Solve(number, text, self.uploads.folder, anew)

        self.result.pause()
        self.requests.study(request)
        self.result.state("busy")

    def send(self, request: Callable[[int], Any]) -> None:
        """Send a request to the worker."""
        try:
            self.solver.send(request)
        except OSError as error:
            self.requests.clear()
            self.result.refuse([no_process(error)], beside=False)

    def worker_ended(self, ready: bool) -> None:
        """Show that the worker has ended by itself; the next request starts a new one."""
        self.requests.clear()
        when = ", perhaps for want of memory; ask for less" if ready else " before it was ready"
        with self.client:
            self.result.refuse([f"The process of this page ended{when}. Change the study to try again."], beside=False)

    def unexpected(self, error: Exception) -> None:
        """Show an unexpected error, which NiceGUI alone would write to the terminal."""
        self.result.refuse([f"{mistake_in(error)}; report it with this study."], beside=False)

    def show_moment(self, moment: int) -> None:
        """Request the pictures of another moment."""
        self.requests.look(lambda number: Look(number, moment))
        self.result.state("busy")

    def receive(self, reply: Any, *, newest: bool) -> None:
        """Show a reply to the newest request, or a late sheet of the study."""
        with self.client:
            match reply:
                case Progress():
                    self.stopping.progressed()
                    self.result.show_progress(reply)
                case Wrong():
                    self.wrong(list(reply.sentences))
                case AnswerText():
                    self.fields.clear()
                    self.result.show_answer(reply, self.entered.assumed_sentence)
                case DrawnSheet():
                    self.result.sheet(reply)
                case InspectedFile():
                    self.looked_at.show(reply)
                case File():
                    ui.download.content(reply.content, reply.name)
                case InteractivePicture():
                    self.result.picture(reply)
                case MomentComplete():
                    self.result.show(reply)
            if newest:
                self.requests.received(reply)
            if isinstance(reply, Done) and self.requests.is_idle and not self.solver.working:
                self.result.finish()

    def wrong(self, sentences: list[str]) -> None:
        """Show mistakes beside their fields, and the rest above the results."""
        self.fields.clear()
        rest = [one for one in sentences if not self._beside(one)]
        self.result.refuse(rest, beside=len(rest) < len(sentences))

    def _beside(self, sentence: str) -> bool:
        path = form.owner_of(sentence)
        short = sentence.removeprefix(path.rpartition(".")[0] + ".") if path else sentence
        return bool(path) and self.fields.show_mistake(path, short)


class AsText:
    """A study as text that opens below the form.

    Parameters
    ----------
    table
        Returns the table of the study as it stands.
    take, edit
        Called with the text of another study, and with the edited one; return its mistakes, empty if there are none.
    """

    def __init__(
        self, table: Callable[[], dict[str, Any]], take: Callable[[str], str], edit: Callable[[str], str]
    ) -> None:
        self.table, self.take, self.edit = table, take, edit
        with ui.expansion("The study as text", on_value_change=self.show).classes("astext") as self.fold:
            self.area = ui.textarea().props("outlined input-class=code autogrow").classes("text")
            self.area.props["aria-label"] = "The study as text"
            self.wrong = ui.label().classes("wrong").props('role="alert"')
            ui.button("Use this text", on_click=lambda: self._use(str(self.area.value), self.edit)).props(
                "outline no-caps"
            )

    def show(self) -> None:
        """Update the text, if it is open."""
        if self.fold.value:
            self.area.set_value(tomli_w.dumps(self.table()))

    def _use(self, text: str, take: Callable[[str], str]) -> None:
        """Take a study from its text, and show its mistakes below the text."""
        self.wrong.text = take(text)
        if self.wrong.text:
            self.area.set_value(text)

    def open(self, text: str) -> None:
        """Take and show an opened study file."""
        self.fold.open()
        self._use(text, self.take)


class Front:
    """Cards that begin a study.

    Parameters
    ----------
    take
        Called with the table of the chosen example.
    """

    def __init__(self, take: Callable[[dict[str, Any]], None]) -> None:
        self.take = take
        with ui.element("section").classes("front").props('aria-label="Examples"') as self.place:
            with ui.element("div").classes("front-head"):
                ui.label("Begin with a question or an example, or change the study on the left")
                close = ui.button(icon="close", on_click=lambda: self.show(visible=False)).props("flat dense round")
                close.props["aria-label"] = "close the examples"
            questions = ui.element("div").classes("front-cards front-questions")
            examples = ui.element("div").classes("front-cards")
            for place, one in enumerate(FRONT_EXAMPLES):
                with questions if place < len(QUESTIONS) else examples:
                    with ui.element("button").classes("front-card") as card:
                        ui.label(one.title).classes("front-title")
                        ui.label(one.question).classes("meaning")
                    card.props["type"] = "button"
                    card.props["data-example"] = str(place)
                    card.on("click", functools.partial(self._choose, place))
        self.show(visible=False)

    def _choose(self, place: int) -> None:
        self.show(visible=False)
        self.take(FRONT_EXAMPLES[place].table)

    def show(self, *, visible: bool) -> None:
        """Show or hide the cards."""
        self.place.set_visibility(visible)

    def toggle(self) -> None:
        """Show the cards, or hide them if they are shown."""
        self.show(visible=not self.place.visible)


class LookedAt:
    """The window that says what a file is.

    Parameters
    ----------
    take
        Takes a study by its text; returns its mistakes.
    """

    def __init__(self, take: Callable[[str], str]) -> None:
        self.take = take
        self.file: InspectedFile | None = None
        with ui.dialog() as self.window, ui.card().classes("looked-at"):
            self.page = ui.html("", sanitize=False).classes("paper")
            with ui.row():
                self.begin = ui.button("Begin the study", icon="play_arrow", on_click=self._begin).props("no-caps")
                self.begin.props["data-look"] = "begin"
                self.save = ui.button("Save the study", icon="description", on_click=self._save).props("flat no-caps")
                self.save.props["data-look"] = "save"
                ui.button("Close", on_click=self.window.close).props("flat no-caps")

    def show(self, file: InspectedFile) -> None:
        """Show what a file is taken for."""
        self.file = file
        self.page.set_content(file.html)
        self.begin.set_visibility(file.shown)
        self.save.set_visibility(bool(file.study))
        self.window.open()

    def _begin(self) -> None:
        if self.file is None:
            return
        self.window.close()
        if mistakes := self.take(self.file.study):
            ui.notify(mistakes, type="negative")

    def _save(self) -> None:
        if self.file is not None:
            ui.download.content(self.file.study.encode(), "study.toml")
