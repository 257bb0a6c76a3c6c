"""A file that a command writes stands there whole, or what was there before; nothing is left beside it."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from winkler.cli import main
from winkler.errors import InvalidInput
from winkler.study.batch.locking import locked
from winkler.study.report.single_file import write_whole


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_what_a_killed_command_has_left_is_cleared_away(tmp_path):
    (tmp_path / ".ball.svg.part").write_bytes(b"half")
    (tmp_path / ".ball.svg.lock").write_bytes(b"")
    write_whole(tmp_path / "ball.svg", b"whole")
    assert names(tmp_path) == ["ball.svg"]
    assert (tmp_path / "ball.svg").read_bytes() == b"whole"


@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), KeyboardInterrupt()])
def test_what_was_there_stays_if_writing_is_broken_off(error, tmp_path, monkeypatch):
    file = tmp_path / "ball.svg"
    file.write_bytes(b"older")

    def fails(_):
        raise error

    monkeypatch.setattr(os, "fsync", fails)
    with pytest.raises((InvalidInput, KeyboardInterrupt)) as caught:
        write_whole(file, b"newer")
    if isinstance(error, OSError):
        assert str(caught.value) == (
            f"output: '{file}' cannot be written (no space left on device); give another file with --output."
        )
    assert names(tmp_path) == ["ball.svg"]
    assert file.read_bytes() == b"older"


def test_two_commands_do_not_write_one_file_at_once(tmp_path):
    with (
        locked(tmp_path / ".ball.svg.lock"),
        pytest.raises(InvalidInput, match=r"another command is writing '.*ball\.svg'; wait"),
    ):
        write_whole(tmp_path / "ball.svg", b"whole")
    assert names(tmp_path) == []


def test_a_link_stays_a_link(tmp_path):
    (tmp_path / "link.toml").symlink_to(tmp_path / "study.toml")
    write_whole(tmp_path / "link.toml", b"whole")
    assert (tmp_path / "link.toml").is_symlink()
    assert (tmp_path / "study.toml").read_bytes() == b"whole"


@pytest.mark.slow
def test_commands_that_write_one_file_keep_the_older_one_on_a_full_disk(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["new", "-o", "ball.toml"]) == 0
    assert main(["draw", "ball.toml", "--part", "profile", "-o", "ball.SVG"]) == 0
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}

    def full(_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    assert main(["new", "indentation", "--profile", "cone", "-o", "ball.toml", "--overwrite"]) == 2
    assert main(["draw", "ball.toml", "--part", "bed", "-o", "ball.SVG", "--overwrite"]) == 2
    assert capsys.readouterr().err.count("cannot be written (no space left on device)") == 2
    assert {path.name: path.read_bytes() for path in Path().iterdir()} == before
