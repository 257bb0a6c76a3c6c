"""What a page asks, and in which order: nothing that was typed is lost, and nothing ends what it has no right to."""

from __future__ import annotations

import multiprocessing
import threading
from pathlib import Path

import pytest
import tomli_w

from winkler.web.form import form
from winkler.web.pictures.answer import Frame
from winkler.web.session.export import File
from winkler.web.session.questions import Questions
from winkler.web.session.worker import Done, Export, Look, Progress, Solve, Wrong, work

FRAME = Frame(0, "")


@pytest.fixture
def asked():
    """What was asked so far."""
    return []


@pytest.fixture
def questions(asked):
    return Questions(lambda question: asked.append(question(len(asked))))


def told(word):
    return lambda number: word


def test_a_study_is_not_lost_while_a_film_plays(questions, asked):
    questions.look(told("look 1"))
    questions.study(told("study"))
    questions.look(told("look 2"))  # of the answer that is about to go
    questions.heard(FRAME)
    assert asked == ["look 1", "study"]
    questions.look(told("look 3"))
    questions.heard(FRAME)
    questions.heard(Done())
    assert asked == ["look 1", "study"]
    questions.look(told("look 4"))
    assert asked == ["look 1", "study", "look 4"]


def test_of_studies_that_wait_the_newest_is_asked(questions, asked):
    for word in ("first", "second", "third"):
        questions.study(told(word))
    questions.heard(FRAME)
    assert asked == ["first", "third"]
    assert not questions.quiet
    questions.heard(FRAME)
    questions.heard(Done())
    assert questions.quiet


def test_only_a_study_ends_a_sweep(questions, asked):
    questions.study(told("sweep"))
    questions.export(told("file"))
    questions.heard(Progress(1, 100))
    assert asked == ["sweep"]
    questions.study(told("another"))
    questions.heard(Progress(2, 100))
    assert asked == ["sweep", "another"]
    questions.heard(FRAME)
    assert asked == ["sweep", "another", "file"]


def test_a_file_of_an_answer_that_is_wrong_is_not_asked_for(questions, asked):
    questions.study(told("study"))
    questions.export(told("file"))
    questions.heard(Wrong(("no",)))
    questions.heard(Done())
    assert asked == ["study"]
    assert questions.quiet


def test_every_file_is_asked_for(questions, asked):
    questions.export(told("csv"))
    questions.export(told("png"))
    questions.heard(File("a", b""))
    assert asked == ["csv", "png"]


def test_sheets_come_although_one_looks_and_takes_a_file(tmp_path):
    """In the worker itself: what is asked in the pause before the sheets is answered, and they still come."""
    mine, theirs = multiprocessing.Pipe()
    worker = threading.Thread(target=_worked, args=(theirs,), daemon=True)
    worker.start()
    assert mine.recv() == (0, Done())
    mine.send(Solve(1, tomli_w.dumps(form.begun("tangential")), Path(tmp_path), True))
    kinds, asked = [], False
    while (1, "Done") not in kinds:
        assert mine.poll(60.0)
        number, reply = mine.recv()
        kinds.append((number, type(reply).__name__))
        if isinstance(reply, Frame) and not asked:
            asked = True
            mine.send(Look(2, 3))
            mine.send(Export(3, "csv"))
    mine.close()
    worker.join(20.0)
    assert (2, "Frame") in kinds
    assert (3, "File") in kinds
    assert (1, "Shown") in kinds
    assert kinds.index((1, "Shown")) > kinds.index((2, "Frame"))


@pytest.mark.parametrize(("kind", "total"), [("impact", 201), ("reduction", None)])
def test_a_march_tells_how_far_it_is_and_gives_way_to_another_study(kind, total, tmp_path, monkeypatch):
    monkeypatch.setattr("winkler.web.session.worker.BEAT", 0.0)
    mine, theirs = multiprocessing.Pipe()
    worker = threading.Thread(target=_worked, args=(theirs,), daemon=True)
    worker.start()
    assert mine.recv() == (0, Done())
    mine.send(Solve(1, tomli_w.dumps(form.begun(kind)), Path(tmp_path), True))
    assert mine.recv() == (1, Progress(1, total))
    mine.send(Solve(2, tomli_w.dumps(form.begun("indentation")), Path(tmp_path), True))
    said = []
    while (2, "Frame") not in said:
        assert mine.poll(60.0)
        number, reply = mine.recv()
        said.append((number, type(reply).__name__))
    mine.close()
    worker.join(20.0)
    assert {kind for number, kind in said if number == 1} <= {"Progress", "Done"}
    assert (1, "Done") in said


def _worked(pipe):
    import signal

    before = signal.signal
    signal.signal = lambda *given: None  # handlers belong to the main thread; a worker has a process of its own
    try:
        work(pipe)
    finally:
        signal.signal = before
