"""Folders of results are locked, and what killed runs left beside them is put right, never what a living one writes."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest

from winkler.io.processes import locking
from winkler.io.processes.locking import locked
from winkler.study.report import reserving
from winkler.study.report.reserving import reserved
from winkler.values.errors import InvalidInput

MARK, STATES = "0123456789ab", "0123456789abcdef.states.npz"
WHOLE = json.dumps({"program": "winkler", "files": ["provenance.json"]})


def laid(folder, text=WHOLE):
    folder.mkdir()
    (folder / "provenance.json").write_text(text, encoding="utf-8")


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_what_killed_runs_left_is_removed_and_what_is_of_others_is_not(tmp_path):
    for name in (f".ball.{MARK}.partial", f".ball.{MARK}.old", "ball"):
        laid(tmp_path / name)
    (tmp_path / ".0123456789abcdef.winkler-part").write_text("half")
    others = [".ball.journal", f".ball.{STATES}", ".ball.2.journal", ".ball.part", ".ball.lock.txt"]
    for name in others:
        (tmp_path / name).write_text("whole")
    laid(tmp_path / f".ball.2.{MARK}.partial")  # of a run into the folder "ball.2"
    with reserved(tmp_path / "ball"):
        assert names(tmp_path) == sorted(["ball", ".ball.lock", f".ball.2.{MARK}.partial", *others])
    assert names(tmp_path) == sorted(["ball", f".ball.2.{MARK}.partial", *others])


def test_results_that_were_put_aside_and_not_replaced_come_back(tmp_path):
    laid(tmp_path / f".ball.{MARK}.old", "old")
    laid(tmp_path / f".ball.{MARK}.partial", "new")
    with reserved(tmp_path / "ball"):
        assert names(tmp_path) == [".ball.lock", "ball"]
        assert (tmp_path / "ball/provenance.json").read_text() == "old"


def test_results_that_were_replaced_do_not_come_back(tmp_path):
    """Whoever removes new results by hand does not get older ones in their place."""
    laid(tmp_path / f".ball.{MARK}.old", "old")
    with reserved(tmp_path / "ball"):
        assert names(tmp_path) == [".ball.lock"]


HOLDER = """
import sys
from pathlib import Path
from winkler.study.report.reserving import reserved
with reserved(Path("ball")):
    print("held", flush=True)
    sys.stdin.read()
"""


def test_a_lock_dies_with_its_process(tmp_path):
    holder = subprocess.Popen(
        [sys.executable, "-c", HOLDER], cwd=tmp_path, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert holder.stdout.readline() == "held\n"
    laid(tmp_path / f".ball.{MARK}.partial")
    with pytest.raises(InvalidInput, match="another run is writing into"), reserved(tmp_path / "ball"):
        pass
    assert names(tmp_path) == [f".ball.{MARK}.partial", ".ball.lock"]  # the living run's
    with reserved(tmp_path / "other"):
        pass
    holder.kill()
    holder.communicate()
    with reserved(tmp_path / "ball"):
        assert names(tmp_path) == [".ball.lock"]
    assert names(tmp_path) == []


def test_folders_above_are_made_and_stay_only_if_something_is_put_there(tmp_path):
    with reserved(tmp_path / "a/b/ball"):
        assert names(tmp_path / "a/b") == [".ball.lock"]
    assert names(tmp_path) == []
    with reserved(tmp_path / "a/b/ball"):
        (tmp_path / "a/b/ball").mkdir()
    assert names(tmp_path / "a/b") == ["ball"]


def test_without_locks_of_the_system_nothing_is_removed(tmp_path, monkeypatch):
    """It may be of a living run; all else goes on as before."""
    monkeypatch.setattr(locking, "lock", lambda file: False)
    laid(tmp_path / f".ball.{MARK}.partial")
    with reserved(tmp_path / "ball"), reserved(tmp_path / "ball"):
        pass
    assert names(tmp_path) == [f".ball.{MARK}.partial"]


def test_a_disk_that_offers_no_locks_is_none_that_is_taken(tmp_path, monkeypatch):
    fcntl = pytest.importorskip("fcntl")

    def none(*_):
        raise OSError(37, "No locks available")

    monkeypatch.setattr(fcntl, "flock", none)
    with locked(tmp_path / "lock") as able:
        assert not able


def test_a_lock_that_was_removed_while_it_was_waited_for_is_requested_anew(tmp_path, monkeypatch):
    path, lock, calls = tmp_path / "lock", locking.lock, []

    def late(file):
        calls.append(file)
        if len(calls) == 1:  # its holder ends between opening and locking
            os.unlink(path)
        return lock(file)

    monkeypatch.setattr(locking, "lock", late)
    with locked(path) as able:
        assert able
        assert path.exists()
        assert len(calls) == 2
        monkeypatch.undo()
        with pytest.raises(BlockingIOError), locked(path):
            pass
        assert path.exists()


def test_a_folder_that_cannot_be_written_is_stated(tmp_path, monkeypatch):
    def refused(path):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(reserving, "locked", refused)
    with pytest.raises(InvalidInput, match=r"cannot be written \(permission denied\)"), reserved(tmp_path / "ball"):
        pass
