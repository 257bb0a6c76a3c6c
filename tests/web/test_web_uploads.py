"""Folders of apps that were killed are removed by the next start, and those of living ones never."""

from __future__ import annotations

import os
import signal

import pytest

from winkler.values.errors import InvalidInput
from winkler.web.session import uploads as module
from winkler.web.session.uploads import uploads

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="kills a process")


def killed_app(place):
    """Let a process make a folder with an upload, and kill it; return the folder."""
    read, write = os.pipe()
    child = os.fork()
    if not child:
        try:
            with uploads(place) as folder:
                (folder / "winkler-page-1").mkdir()
                (folder / "winkler-page-1" / "tip.csv").write_text("1 2")
                os.write(write, os.fsencode(folder))
                signal.pause()
        finally:
            os._exit(1)
    folder = place / os.fsdecode(os.path.basename(os.read(read, 1000)))
    for end in (read, write):
        os.close(end)
    with uploads(place):
        assert (folder / "winkler-page-1" / "tip.csv").exists()  # its process runs: nothing is touched
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    return folder


def test_what_a_kill_leaves_is_removed_by_the_next_start(tmp_path):
    left = killed_app(tmp_path)
    other = tmp_path / "winkler-page-of-somebody"
    other.mkdir()
    assert (left / "winkler-page-1" / "tip.csv").exists()
    with uploads(tmp_path) as folder:
        assert not left.exists()
        assert sorted(tmp_path.iterdir()) == sorted([folder, other])
        assert folder.stat().st_mode & 0o077 == 0
    assert list(tmp_path.iterdir()) == [other]


def test_folders_of_others_and_links_are_left_alone(tmp_path, monkeypatch):
    target = tmp_path / "precious"
    target.mkdir()
    (target / "file").write_text("1")
    (tmp_path / "winkler-uploads-link").symlink_to(target)
    (tmp_path / "winkler-uploads-file").write_text("1")
    linked = tmp_path / "winkler-uploads-linked-lock"
    linked.mkdir()
    (linked / "lock").symlink_to(target / "file")
    with uploads(tmp_path):
        pass
    assert (target / "file").read_text() == "1"
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "precious", "winkler-uploads-file", "winkler-uploads-link", "winkler-uploads-linked-lock",
    ]  # fmt: skip
    foreign = tmp_path / "winkler-uploads-foreign"
    foreign.mkdir()
    monkeypatch.setattr(os, "getuid", lambda: foreign.stat().st_uid + 1)
    with uploads(tmp_path):
        pass
    assert foreign.exists()


def test_a_start_that_takes_the_folder_of_another_makes_it_choose_another(tmp_path, monkeypatch):
    """Between making a folder and locking its file it looks abandoned."""
    usual, hits = module.lock, []

    def taken_meanwhile(file):
        if not hits:
            hits.append(file)
            (mine,) = tmp_path.glob("winkler-uploads-*")
            (mine / "lock").unlink()
            mine.rmdir()
        return usual(file)

    monkeypatch.setattr(module, "lock", taken_meanwhile)
    with uploads(tmp_path) as folder:
        assert hits
        assert list(tmp_path.iterdir()) == [folder]


def test_no_place_for_uploads(tmp_path, monkeypatch):
    with pytest.raises(InvalidInput, match=r"no such file or directory\); let TMPDIR"), uploads(tmp_path / "none"):
        pass

    monkeypatch.setattr(module, "lock", lambda file: False)  # a disk that knows no locks
    with pytest.raises(InvalidInput, match="cannot be locked"), uploads(tmp_path):
        pass
    assert list(tmp_path.iterdir()) == []
