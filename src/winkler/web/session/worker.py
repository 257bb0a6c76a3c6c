"""The process that solves and draws for one page: it can be stopped at any moment, and the page lives on."""

from __future__ import annotations

import contextlib
import functools
import math
import re
import time
from collections.abc import Callable, Generator, Iterable, Iterator
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from winkler.study.batch.fit_outcome import FitOutcome
    from winkler.study.batch.outcome import Outcome
    from winkler.study.language.study import Study
    from winkler.web.session.export import File

__all__ = ["POINTS", "Done", "Export", "Look", "Progress", "Solve", "Wrong", "beside_the_curve", "work"]


class Solve(NamedTuple):
    """Asks for the answer to a study."""

    number: int
    text: str
    folder: Path
    anew: bool
    """Whether the pictures find a frame anew."""


class Look(NamedTuple):
    """Asks for the pictures of another moment of the last answer."""

    number: int
    moment: int


class Export(NamedTuple):
    """Asks for the last answer as files."""

    number: int
    what: str
    """``csv``, ``netcdf``, ``png`` or ``report``."""


class Wrong(NamedTuple):
    """Says why there is no answer: one sentence for every mistake."""

    sentences: tuple[str, ...]


class Progress(NamedTuple):
    """Says how many points of a sweep, or of a path, are solved."""

    done: int
    total: int | None
    """None if it shows only on the way."""


class Done(NamedTuple):
    """Says that all has been sent for a question."""


class Newer(Exception):
    """Ends a march: there is another study."""

    def __init__(self, asked: Solve) -> None:
        super().__init__()
        self.asked = asked


POINTS = 1000
"""A sweep in the app has so many points at most."""
BEAT = 0.2
"""Seconds between two words about the progress of a sweep or a march."""
PAUSE = 0.8
"""Seconds of rest before sheets are drawn."""
STUDY = "study.toml"
"""What the study is called in sentences and exports."""


def work(pipe: Connection) -> None:
    """Answer questions until the pipe is closed; a newer question ends what is still to be drawn for the last one.

    Sends ``(number, reply)`` for every part of an answer.
    """
    import signal

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the process of the page
    bench = _Bench()
    rest = {bench.answer.Frame: PAUSE, bench.answer.Shown: 0.0, Progress: 0.0}
    with contextlib.suppress(EOFError, BrokenPipeError, OSError):
        pipe.send((0, Done()))
        newer: Any = None
        while True:
            asked, newer = newer or pipe.recv(), None
            bench.tell = functools.partial(_told, pipe, bench, asked.number)
            try:
                for reply in bench.replies(asked):
                    pipe.send((asked.number, reply))
                    # points, and sheets that follow words and pictures, are left out when there is another study
                    if isinstance(asked, Solve) and type(reply) in rest:
                        newer = _meanwhile(pipe, bench, rest[type(reply)])
                        if newer is not None:
                            break
            except Newer as end:
                newer = end.asked
            pipe.send((asked.number, Done()))


def _told(pipe: Connection, bench: _Bench, number: int, progress: Progress) -> None:
    """Tell how far a march is, unless there is another study, which ends it."""
    pipe.send((number, progress))
    newer = _meanwhile(pipe, bench, 0.0)
    if newer is not None:
        raise Newer(newer)


def _meanwhile(pipe: Connection, bench: _Bench, wait: float) -> Solve | None:
    """Answer what is asked about the answer while its sheets are drawn; return another study, which ends them."""
    while pipe.poll(wait):
        asked = pipe.recv()
        if isinstance(asked, Solve):
            return asked
        for reply in bench.replies(asked):
            pipe.send((asked.number, reply))
        pipe.send((asked.number, Done()))
    return None


class _Bench:
    """Holds the last answer."""

    def __init__(self) -> None:
        import tomli_w

        from winkler.web.form.form import begun
        from winkler.web.pictures import answer
        from winkler.web.pictures.moments import Moments
        from winkler.web.pictures.view import NOTHING

        self.answer, self.nothing, self.none = answer, NOTHING, Moments()
        self.view, self.moments = NOTHING, self.none
        self.outcome: Outcome | FitOutcome | None = None
        self.tell: Callable[[Progress], None] = lambda progress: None
        self.folder = Path()
        warm = tomli_w.dumps(begun("indentation"))
        list(self.replies(Solve(0, warm, Path(), True)))  # so that the first question does not wait for imports
        self.view, self.outcome = NOTHING, None

    def replies(self, asked: Any) -> Iterator[Any]:
        from winkler.errors import WinklerError, mistake_in

        try:
            match asked:
                case Solve():
                    yield from self._solved(asked)
                case Look():
                    yield from self._pictures(asked.moment, still=True)
                case Export():
                    yield self._file(asked.what)
        except Newer:
            raise
        except WinklerError as error:
            yield Wrong(tuple(self._plain(line) for line in str(error).splitlines()))
        except Exception as error:
            yield Wrong((f"{mistake_in(error)}; report it with this study.",))

    def _plain(self, sentence: str) -> str:
        """Return a sentence without the folder of the page, and without its file named twice."""
        sentence = sentence.removeprefix(f"{STUDY}: ").replace(f"{self.folder}/", "")
        return re.sub(r"\b([\w.-]+): \1(?=[:,])", r"\1", sentence)

    def _solved(self, asked: Solve) -> Iterator[Any]:
        from winkler.study.language.reading import parsed

        self.outcome, self.moments, self.folder = None, self.none, asked.folder
        if asked.anew:
            self.view = self.nothing
        yield from self._fitted(asked) if "fit" in parsed(asked.text, STUDY) else self._answered(asked)

    def _answered(self, asked: Solve) -> Iterator[Any]:
        from winkler.study.language.reading import parse_study, study_text
        from winkler.study.report.figures import shown_point
        from winkler.web.pictures.moments import moments_of, telling

        study = parse_study(asked.text, file=STUDY, folder=asked.folder)
        self.outcome = outcome = yield from self._run(study)
        point = shown_point(outcome)
        self.moments = moments_of(point)
        moment = telling(point, self.moments)
        yield self.answer.told(outcome, study_text(study), self.moments.total, moment)
        yield from self._pictures(moment, still=False)
        yield from self.answer.sheets(outcome)

    def _run(self, study: Study) -> Generator[Progress, None, Outcome]:
        """Solve the points of a study; yield how far it is, now and then."""
        from winkler.errors import InvalidInput
        from winkler.study.batch.marching import unwatched
        from winkler.study.batch.run import gather
        from winkler.study.batch.sweep import solve_points

        total, started = math.prod(study.shape), time.perf_counter()
        if total > POINTS:
            raise InvalidInput(
                f"sweep: there are {total} points, and the app solves at most {POINTS}; ask for fewer, or take the "
                "study to `winkler run`, which takes millions."
            )
        points, told = [], started
        watch = self._watched if total == 1 else unwatched
        for point in solve_points(study, watch=watch):
            points.append(point)
            if total > 1 and time.perf_counter() - told > BEAT:
                told = time.perf_counter()
                yield Progress(len(points), total)
        return gather(study, points, started=started)

    def _watched(self, states: Iterable[Any], total: int | None) -> Iterator[Any]:
        """Yield the states of a march; tell how far it is, now and then."""
        told = time.perf_counter()
        for done, state in enumerate(states, 1):
            if time.perf_counter() - told > BEAT:
                told = time.perf_counter()
                self.tell(Progress(done, total))
            yield state

    def _fitted(self, asked: Solve) -> Iterator[Any]:
        from winkler.errors import WinklerError
        from winkler.study.batch.fit_run import fit_study
        from winkler.study.language.fit_reading import parse_fit_study
        from winkler.web.pictures import fitted

        study = parse_fit_study(asked.text, file=STUDY, folder=asked.folder)
        try:
            self.outcome = fit_study(study)
        except WinklerError as error:
            raise type(error)(beside_the_curve(str(error))) from None
        yield fitted.fit_text(self.outcome, asked.text)
        yield from self._pictures(0, still=False)
        yield from fitted.fit_sheets(self.outcome)

    def _pictures(self, moment: int, *, still: bool) -> Iterator[Any]:
        from winkler.errors import InvalidInput
        from winkler.study.batch.fit_outcome import FitOutcome
        from winkler.web.pictures.fitted import fit_pictures

        if self.outcome is None:
            raise InvalidInput("there is no answer to look at; wait for it, or mend the study first.")
        if isinstance(self.outcome, FitOutcome):
            pictures, remark = fit_pictures(self.outcome, moment)
        else:
            scene = self.answer.scene(self.outcome, self.moments, moment, self.view, still=still)
            pictures, remark, self.view = self.answer.pictures(scene), scene.remark, scene.view
        count = 0
        for picture in pictures:
            count += 1
            yield picture
        yield self.answer.Frame(count, remark)

    def _file(self, what: str) -> File:
        from winkler.errors import InvalidInput
        from winkler.web.session.export import exported

        if self.outcome is None:
            raise InvalidInput("there is no answer to take along; mend the study first.")
        return exported(self.outcome, what, self.folder)


def beside_the_curve(sentence: str) -> str:
    """Return why no curve could be fitted, told of the key in the study that it is about.

    Examples
    --------
    >>> beside_the_curve("gel.csv: fit: not identifiable: the curve cannot tell one from the other.")
    'fit.free: gel.csv: the curve cannot tell one from the other.'
    """
    if ": fit: not identifiable: " in sentence:
        return f"fit.free: {sentence.replace('fit: not identifiable: ', '')}"
    return f"fit.curve: {sentence}"
