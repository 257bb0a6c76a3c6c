"""The process that solves and draws for one page: it can be stopped at any moment, and the page lives on."""

from __future__ import annotations

import contextlib
import io
import tempfile
import zipfile
from collections.abc import Iterator
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from winkler.study.outcome import Outcome

__all__ = ["Done", "Export", "File", "Look", "Solve", "Wrong", "work"]


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
    """``csv``, ``png`` or ``report``."""


class Wrong(NamedTuple):
    """Says why there is no answer: one sentence for every mistake."""

    sentences: tuple[str, ...]


class File(NamedTuple):
    """A file to be taken along."""

    name: str
    content: bytes


class Done(NamedTuple):
    """Says that all has been sent for a question."""


PAUSE = 0.35
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
    rest = {bench.answer.Frame: PAUSE, bench.answer.Shown: 0.0}
    with contextlib.suppress(EOFError, BrokenPipeError, OSError):
        pipe.send((0, Done()))
        while True:
            asked = pipe.recv()
            for reply in bench.replies(asked):
                pipe.send((asked.number, reply))
                # sheets, which follow words and pictures, are left out when there is something newer to do
                if type(reply) in rest and pipe.poll(rest[type(reply)] if isinstance(asked, Solve) else 0.0):
                    break
            pipe.send((asked.number, Done()))


class _Bench:
    """Holds the last answer."""

    def __init__(self) -> None:
        import tomli_w

        from winkler.web import answer
        from winkler.web.form import begun
        from winkler.web.moments import Moments
        from winkler.web.view import NOTHING

        self.answer, self.nothing, self.none = answer, NOTHING, Moments()
        self.view, self.moments = NOTHING, self.none
        self.outcome: Outcome | None = None
        warm = tomli_w.dumps(begun("indentation"))
        list(self.replies(Solve(0, warm, Path(), True)))  # so that the first question does not wait for imports
        self.view, self.outcome = NOTHING, None

    def replies(self, asked: Any) -> Iterator[Any]:
        from winkler.errors import WinklerError

        try:
            match asked:
                case Solve():
                    yield from self._solved(asked)
                case Look():
                    yield from self._pictures(asked.moment, still=True)
                case Export():
                    yield self._file(asked.what)
        except WinklerError as error:
            yield Wrong(tuple(line.removeprefix(f"{STUDY}: ") for line in str(error).splitlines()))
        except Exception as error:
            told = " ".join(str(error).split())
            yield Wrong((f"winkler made a mistake ({type(error).__name__}: {told}); report it with this study.",))

    def _solved(self, asked: Solve) -> Iterator[Any]:
        from winkler.study.figures import shown_point
        from winkler.study.reading import parse_study, study_text
        from winkler.study.run import run
        from winkler.web.moments import moments_of, telling

        self.outcome, self.moments = None, self.none
        if asked.anew:
            self.view = self.nothing
        study = parse_study(asked.text, file=STUDY, folder=asked.folder)
        self.outcome = run(study)
        point = shown_point(self.outcome)
        self.moments = moments_of(point)
        moment = telling(point, self.moments)
        yield self.answer.told(self.outcome, study_text(study), self.moments.total, moment)
        yield from self._pictures(moment, still=False)
        yield from self.answer.sheets(self.outcome)

    def _pictures(self, moment: int, *, still: bool) -> Iterator[Any]:
        assert self.outcome is not None
        scene = self.answer.scene(self.outcome, self.moments, moment, self.view, still=still)
        self.view, count = scene.view, 0
        for picture in self.answer.pictures(scene):
            count += 1
            yield picture
        yield self.answer.Frame(count, scene.remark)

    def _file(self, what: str) -> File:
        from winkler.errors import InvalidInput
        from winkler.study import archive, figures, report

        outcome = self.outcome
        if outcome is None:
            raise InvalidInput("there is no answer to take along; mend the study first.")
        if what == "report":
            return File(report.REPORT, report.page(outcome).encode("utf-8"))
        with tempfile.TemporaryDirectory(prefix="winkler-app-") as place:
            folder = Path(place)
            if what == "csv":
                archive.write(outcome, folder)
                return File(archive.CSV, (folder / archive.CSV).read_bytes())
            figures.save(figures.figures_of(outcome), folder, ("png",))
            store, pictures = io.BytesIO(), sorted(folder.rglob("*.png"))
            with zipfile.ZipFile(store, "w") as pack:
                for path in pictures:
                    pack.write(path, path.name)
            return File("figures.zip", store.getvalue())
