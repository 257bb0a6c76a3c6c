"""What a page requests, and in which order: nothing that was typed is lost, nothing ends what it has no right to."""

from __future__ import annotations

import multiprocessing
import threading
from pathlib import Path

import pytest
import tomli_w

from winkler.web.form import form
from winkler.web.pictures.replies import File, MomentComplete
from winkler.web.session.requests import RequestQueue
from winkler.web.session.worker import Done, Export, Look, Progress, Solve, Wrong, work

FRAME = MomentComplete(0, "")


@pytest.fixture
def sent():
    """What was sent so far."""
    return []


@pytest.fixture
def queue(sent):
    return RequestQueue(lambda request: sent.append(request(len(sent))))


def named(word):
    return lambda number: word


def test_a_study_is_not_lost_while_a_film_plays(queue, sent):
    queue.look(named("look 1"))
    queue.study(named("study"))
    queue.look(named("look 2"))  # of the answer that is about to go
    queue.received(FRAME)
    assert sent == ["look 1", "study"]
    queue.look(named("look 3"))
    queue.received(FRAME)
    queue.received(Done())
    assert sent == ["look 1", "study"]
    queue.look(named("look 4"))
    assert sent == ["look 1", "study", "look 4"]


def test_of_studies_that_wait_the_newest_is_sent(queue, sent):
    for word in ("first", "second", "third"):
        queue.study(named(word))
    queue.received(FRAME)
    assert sent == ["first", "third"]
    assert not queue.is_idle
    queue.received(FRAME)
    queue.received(Done())
    assert queue.is_idle


def test_only_a_study_ends_a_sweep(queue, sent):
    queue.study(named("sweep"))
    queue.export(named("file"))
    queue.received(Progress(1, 100))
    assert sent == ["sweep"]
    queue.study(named("another"))
    queue.received(Progress(2, 100))
    assert sent == ["sweep", "another"]
    queue.received(FRAME)
    assert sent == ["sweep", "another", "file"]


def test_a_file_of_an_answer_that_is_wrong_is_not_requested(queue, sent):
    queue.study(named("study"))
    queue.export(named("file"))
    queue.received(Wrong(("no",)))
    queue.received(Done())
    assert sent == ["study"]
    assert queue.is_idle


def test_every_file_is_requested(queue, sent):
    queue.export(named("csv"))
    queue.export(named("png"))
    queue.received(File("a", b""))
    assert sent == ["csv", "png"]


@pytest.mark.slow
def test_sheets_come_although_one_looks_and_takes_a_file(tmp_path):
    """In the worker itself: what is sent in the pause before the sheets gets a reply, and they still come."""
    mine, theirs = multiprocessing.Pipe()
    worker = threading.Thread(target=_worked, args=(theirs,), daemon=True)
    worker.start()
    assert mine.recv() == (0, Done())
    mine.send(Solve(1, tomli_w.dumps(form.initial_table("tangential")), Path(tmp_path), True))
    kinds, sent = [], False
    while (1, "Done") not in kinds:
        assert mine.poll(60.0)
        number, reply = mine.recv()
        kinds.append((number, type(reply).__name__))
        if isinstance(reply, MomentComplete) and not sent:
            sent = True
            mine.send(Look(2, 3))
            mine.send(Export(3, "csv"))
    mine.close()
    worker.join(20.0)
    assert (2, "MomentComplete") in kinds
    assert (3, "File") in kinds
    assert (1, "DrawnSheet") in kinds
    assert kinds.index((1, "DrawnSheet")) > kinds.index((2, "MomentComplete"))


@pytest.mark.parametrize(("kind", "total"), [("impact", 201), ("reduction", None)])
def test_a_march_reports_progress_and_ends_for_another_study(kind, total, tmp_path, monkeypatch):
    monkeypatch.setattr("winkler.web.session.worker.PROGRESS_INTERVAL", 0.0)
    mine, theirs = multiprocessing.Pipe()
    worker = threading.Thread(target=_worked, args=(theirs,), daemon=True)
    worker.start()
    assert mine.recv() == (0, Done())
    mine.send(Solve(1, tomli_w.dumps(form.initial_table(kind)), Path(tmp_path), True))
    assert mine.recv() == (1, Progress(1, total))
    mine.send(Solve(2, tomli_w.dumps(form.initial_table("indentation")), Path(tmp_path), True))
    replies = []
    while (2, "MomentComplete") not in replies:
        assert mine.poll(60.0)
        number, reply = mine.recv()
        replies.append((number, type(reply).__name__))
    mine.close()
    worker.join(20.0)
    assert {kind for number, kind in replies if number == 1} <= {"Progress", "Done"}
    assert (1, "Done") in replies


def _worked(pipe):
    import signal

    before = signal.signal
    signal.signal = lambda *given: None  # handlers belong to the main thread; a worker has a process of its own
    try:
        work(pipe)
    finally:
        signal.signal = before
