"""A file in the app says what it is taken for, and begins a study."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest
import tomli_w
from made_files import made_files

from winkler.web.form.study_form import StudyForm
from winkler.web.form.taken import taken
from winkler.web.pictures.replies import AnswerText, File, InspectedFile
from winkler.web.session.requests import RequestQueue
from winkler.web.session.worker import Inspect, Solve, _WorkerState

DATA = Path(__file__).parents[2] / "examples" / "data"


@pytest.fixture(scope="module")
def bench():
    return _WorkerState()


def look(bench, folder, name):
    (reply,) = bench.replies(Inspect(1, name, folder))
    assert isinstance(reply, InspectedFile)
    return reply


def test_a_curve_says_what_it_is_and_begins_its_study(bench, tmp_path):
    shutil.copy(DATA / "gel_bead.csv", tmp_path / "gel.csv")
    reply = look(bench, tmp_path, "gel.csv")
    assert "gel.csv: force curve" in reply.html
    assert "position from &#x27;piezo [nm]&#x27;" in reply.html
    assert reply.html.count('<svg class="thumbnail"') == 2
    assert str(tmp_path) not in reply.html
    assert reply.shown
    answers = list(bench.replies(Solve(2, tomli_w.dumps(taken(reply.study, tmp_path)), tmp_path, True)))
    assert any(isinstance(one, AnswerText) for one in answers)


def test_the_form_takes_each_study_that_it_is_said_to_show(bench, tmp_path):
    for path in made_files(tmp_path):
        if path.parent != tmp_path:
            shutil.copy(path, tmp_path / path.name)
        reply = look(bench, tmp_path, path.name)
        assert reply.shown == (bool(reply.study) and path.name != "steel_1.csv"), path.name
        if reply.shown:
            form = StudyForm(lambda: None, lambda: None, tmp_path)
            form.load(taken(reply.study, tmp_path))
            assert form.task == ("fit" if "[fit]" in reply.study else "solve")


def test_what_cannot_be_read_says_why_and_is_escaped(bench, tmp_path):
    (tmp_path / "bad.csv").write_text("<script>alert(1)</script> [nm], force\n")
    reply = look(bench, tmp_path, "bad.csv")
    assert not reply.study
    assert "cannot be read as it is" in reply.html
    assert "<script>" not in reply.html
    assert "there is no such file" in look(bench, tmp_path, "absent.csv").html


def test_the_next_request_is_sent_behind_it():
    sent = []
    queue = RequestQueue(lambda make: sent.append(make(len(sent))))
    queue.export(lambda number: Inspect(number, "a.csv", Path()))
    queue.export(lambda number: Inspect(number, "b.csv", Path()))
    queue.received(InspectedFile("a.csv", "", "", False))
    queue.received(File("x", b""))
    assert [one.name for one in sent] == ["a.csv", "b.csv"]
    assert queue.is_idle


def test_doubts_stand_on_the_page(bench, tmp_path):
    force = np.where(np.arange(300) == 100, 1e4, np.maximum(np.arange(-150.0, 150.0), 0.0) ** 1.5)
    np.savetxt(tmp_path / "spike.csv", np.column_stack((np.arange(300.0), force)), delimiter=",",
               header="depth [nm], force [nN]", comments="")  # fmt: skip
    assert "single number far from both neighbours (row 101)" in look(bench, tmp_path, "spike.csv").html
