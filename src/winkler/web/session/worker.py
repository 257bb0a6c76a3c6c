"""The process that solves and draws for one page: it can be stopped without closing the page."""

from __future__ import annotations

import contextlib
import functools
import math
import re
import time
from collections.abc import Callable, Generator, Iterable, Iterator
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from winkler.web.pictures.replies import DrawnSheet, File, InspectedFile, MomentComplete
from winkler.web.session.batch import Progress, fitted_batch

if TYPE_CHECKING:
    from winkler.study.batch.fit_outcome import FitOutcome
    from winkler.study.batch.outcome import Outcome
    from winkler.study.language.study import Study

__all__ = [
    "MOST_POINTS",
    "Done",
    "Export",
    "Halt",
    "Inspect",
    "Look",
    "Progress",
    "Solve",
    "Wrong",
    "beside_the_curve",
    "work",
]


class Solve(NamedTuple):
    """Request for the results of a study."""

    number: int
    text: str
    folder: Path
    anew: bool
    """Whether the pictures get a new frame."""


class Look(NamedTuple):
    """Request for the pictures of another moment of the last results."""

    number: int
    moment: int


class Export(NamedTuple):
    """Request for the last results as files."""

    number: int
    what: str
    """``csv``, ``netcdf``, ``png`` or ``report``."""
    assumed: str = ""
    """Which numbers of the study nobody has given; the report says it."""


class Inspect(NamedTuple):
    """Request for what an uploaded file is taken for."""

    number: int
    name: str
    folder: Path


class Wrong(NamedTuple):
    """Reasons for missing results: one sentence for each mistake."""

    sentences: tuple[str, ...]


class Halt(NamedTuple):
    """Ends the running batch of fits after the present curve; what was fitted is the answer."""

    number: int = 0


class Done(NamedTuple):
    """Marks the end of the replies to a request."""


class StudyReplaced(Exception):
    """Ends a march for another study."""

    def __init__(self, request: Solve) -> None:
        super().__init__()
        self.request = request


MOST_POINTS = 1000
"""Most points of a sweep in the app."""
PROGRESS_INTERVAL = 0.2
"""Time between two reports of progress [s]."""
SHEET_DELAY = 0.8
"""Pause before sheets are drawn [s]."""
STUDY = "study.toml"
"""Name of the study in messages and exports."""


def work(pipe: Connection) -> None:
    """Serve requests until the pipe is closed; a new study ends the drawing for the previous one.

    Sends ``(number, reply)`` for each reply.
    """
    import signal

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the process of the page
    state = _WorkerState()
    delays = {MomentComplete: SHEET_DELAY, DrawnSheet: 0.0, Progress: 0.0}
    with contextlib.suppress(EOFError, BrokenPipeError, OSError):
        pipe.send((0, Done()))
        next_study: Any = None
        while True:
            request, next_study = next_study or pipe.recv(), None
            state.report = functools.partial(_report_progress, pipe, state, request.number)
            try:
                for reply in state.replies(request):
                    pipe.send((request.number, reply))
                    # remaining points and sheets are left out when there is another study
                    if isinstance(request, Solve) and type(reply) in delays:
                        next_study = _serve_waiting(pipe, state, delays[type(reply)] if state.has_more else 0.0)
                        if next_study is not None:
                            break
            except StudyReplaced as end:
                next_study = end.request
            pipe.send((request.number, Done()))


def _report_progress(pipe: Connection, state: _WorkerState, number: int, progress: Progress) -> None:
    """Report the progress of a march, unless another study ends it."""
    pipe.send((number, progress))
    next_study = _serve_waiting(pipe, state, 0.0)
    if next_study is not None:
        raise StudyReplaced(next_study)


def _serve_waiting(pipe: Connection, state: _WorkerState, wait: float) -> Solve | None:
    """Serve waiting requests for the current results; return another study, if there is one."""
    while pipe.poll(wait):
        request = pipe.recv()
        if isinstance(request, Solve):
            return request
        for reply in state.replies(request):
            pipe.send((request.number, reply))
        pipe.send((request.number, Done()))
    return None


class _WorkerState:
    """The last results and their display."""

    def __init__(self) -> None:
        import tomli_w

        from winkler.web.form.form import initial_table
        from winkler.web.pictures import answer
        from winkler.web.pictures.moments import Moments
        from winkler.web.pictures.view import NO_VIEW

        self.answer, self.nothing, self.none = answer, NO_VIEW, Moments()
        self.view, self.moments = NO_VIEW, self.none
        self.outcome: Outcome | FitOutcome | None = None
        self.report: Callable[[Progress], None] = lambda progress: None
        self.folder = Path()
        self.halted, self.fits, self.has_more = False, False, True
        text = tomli_w.dumps(initial_table("indentation"))
        list(self.replies(Solve(0, text, Path(), True)))  # so that the first request does not wait for imports
        self.view, self.outcome = NO_VIEW, None

    def replies(self, request: Any) -> Iterator[Any]:
        from winkler.values.errors import WinklerError, mistake_in

        try:
            match request:
                case Solve():
                    yield from self._solved(request)
                case Look():
                    yield from self._pictures(request.moment, still=True)
                case Export():
                    yield self._file(request.what, request.assumed)
                case Inspect():
                    yield self._inspected(request)
                case Halt():
                    self.halted = True
        except StudyReplaced:
            raise
        except WinklerError as error:
            yield Wrong(tuple(self._plain(line) for line in str(error).splitlines()))
        except Exception as error:
            yield Wrong((f"{mistake_in(error)}; report it with this study.",))

    def _plain(self, sentence: str) -> str:
        """Return a sentence without the folder of the page, and without its file named twice."""
        sentence = sentence.removeprefix(f"{STUDY}: ").replace(f"{self.folder}/", "")
        return re.sub(r"\b([\w.-]+): \1(?=[:,])", r"\1", sentence)

    def _solved(self, request: Solve) -> Iterator[Any]:
        from winkler.study.language.reading import parsed

        self.outcome, self.moments, self.folder = None, self.none, request.folder
        self.halted, self.has_more = False, True
        if request.anew:
            self.view = self.nothing
        self.fits = "fit" in parsed(request.text, STUDY)
        yield from self._fitted(request) if self.fits else self._answered(request)

    def _answered(self, request: Solve) -> Iterator[Any]:
        from winkler.study.language.reading import parse_study
        from winkler.study.language.writing import study_text
        from winkler.study.report.headline.shown_contact import shown_point
        from winkler.web.pictures.moments import initial_moment, moments_of

        study = parse_study(request.text, file=STUDY, folder=request.folder)
        self.outcome = outcome = yield from self._run(study)
        point, self.has_more = shown_point(outcome), self.answer.has_sheets(outcome)
        self.moments = moments_of(point)
        moment = initial_moment(point, self.moments)
        yield self.answer.answer_text(outcome, study_text(study), self.moments, moment)
        yield from self._pictures(moment, still=False)
        yield from self.answer.sheets(outcome)

    def _run(self, study: Study) -> Generator[Progress, None, Outcome]:
        """Solve the points of a study; yield the progress at intervals."""
        from winkler.study.batch.marching import unwatched
        from winkler.study.batch.run import gather
        from winkler.study.batch.sweep import solve_points
        from winkler.values.errors import InvalidInput

        total, started = math.prod(study.shape), time.perf_counter()
        if total > MOST_POINTS:
            raise InvalidInput(
                f"sweep: there are {total} points, and the app solves at most {MOST_POINTS}; give fewer, or solve the "
                "study by `winkler run`, which takes millions."
            )
        points, reported = [], started
        watch = self._with_progress if total == 1 else unwatched
        for point in solve_points(study, watch=watch):
            points.append(point)
            if total > 1 and time.perf_counter() - reported > PROGRESS_INTERVAL:
                reported = time.perf_counter()
                yield Progress(len(points), total)
        return gather(study, points, started=started)

    def _with_progress(self, states: Iterable[Any], total: int | None) -> Iterator[Any]:
        """Yield the states of a march; report the progress at intervals."""
        reported = time.perf_counter()
        for done, state in enumerate(states, 1):
            if time.perf_counter() - reported > PROGRESS_INTERVAL:
                reported = time.perf_counter()
                self.report(Progress(done, total))
            yield state

    def _fitted(self, request: Solve) -> Iterator[Any]:
        from winkler.study.batch.fit_run import pieces
        from winkler.study.language.fit_reading import parse_fit_study
        from winkler.values.errors import WinklerError
        from winkler.web.pictures import fitted

        started = time.perf_counter()
        study = parse_fit_study(request.text, file=STUDY, folder=request.folder)
        try:
            self.outcome = yield from fitted_batch(study, pieces(study), started, lambda: self.halted)
        except WinklerError as error:
            raise error.reworded(beside_the_curve) from None
        yield fitted.fit_text(self.outcome, request.text)
        yield from self._pictures(0, still=False)
        yield from fitted.fit_sheets(self.outcome)

    def _pictures(self, moment: int, *, still: bool) -> Iterator[Any]:
        from winkler.values.errors import InvalidInput

        if self.outcome is None:
            raise InvalidInput("there are no results to show; wait for them, or correct the study first.")
        if self.fits:
            from winkler.web.pictures.fitted import fit_pictures

            pictures, remark = fit_pictures(cast("FitOutcome", self.outcome), moment)
        else:
            outcome = cast("Outcome", self.outcome)
            scene = self.answer.scene(outcome, self.moments, moment, self.view, still=still)
            pictures, remark, self.view = self.answer.pictures(scene), scene.remark, scene.view
        count = 0
        for count, picture in enumerate(pictures, 1):  # noqa: B007 - their number stays
            yield picture
        yield MomentComplete(count, remark)

    def _inspected(self, request: Inspect) -> InspectedFile:
        """Return what a file is taken for; of one that cannot be read the reason."""
        from winkler.study.inspection.inspect import inspect_file
        from winkler.study.inspection.inspection import Inspection
        from winkler.study.inspection.page import inspection_html
        from winkler.study.inspection.starting import placed_study
        from winkler.study.language.reading import parsed
        from winkler.values.errors import WinklerError

        try:
            found = inspect_file(request.folder / request.name)
        except WinklerError as error:
            found = Inspection(request.name, "", str(error))
        page = inspection_html(found).replace(f"{request.folder}/", "")
        text = placed_study(found, request.name).replace("STUDY", STUDY)
        shown = bool(text) and "indentation" not in parsed(text, STUDY)
        return InspectedFile(request.name, page, text, shown)

    def _file(self, what: str, assumed: str) -> File:
        from winkler.values.errors import InvalidInput
        from winkler.web.session.export import exported

        if self.outcome is None:
            raise InvalidInput("there are no results to save; correct the study first.")
        return exported(self.outcome, what, assumed)


def beside_the_curve(sentence: str) -> str:
    """Return why no curve could be fitted, with the key in the study.

    Examples
    --------
    >>> beside_the_curve("gel.csv: fit: not identifiable: the curve does not distinguish one from the other.")
    'fit.free: gel.csv: the curve does not distinguish one from the other.'
    """
    if ": fit: not identifiable: " in sentence:
        return f"fit.free: {sentence.replace('fit: not identifiable: ', '')}"
    return f"fit.curve: {sentence}"
