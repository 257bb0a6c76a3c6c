"""Nothing that winkler does at run time uses the network."""

from __future__ import annotations

import socket

import pytest

from winkler.cli import main
from winkler.study.language.template import whole_text


@pytest.fixture
def closed(monkeypatch):
    """Every connection out of this process raises, and is remembered even if somebody swallows the error."""
    requested: list[str] = []

    def refuse(*words, **_):
        requested.append(str(words[-1:]))
        raise OSError("there is no network")

    for name in ("connect", "connect_ex", "sendto"):
        monkeypatch.setattr(socket.socket, name, refuse, raising=True)
    for name in ("create_connection", "getaddrinfo", "gethostbyname"):
        monkeypatch.setattr(socket, name, refuse)
    return requested


def test_the_socket_is_closed(closed):
    with pytest.raises(OSError, match="there is no network"):
        socket.create_connection(("localhost", 9))
    assert len(closed) == 1


@pytest.mark.slow
def test_a_run_with_figures_and_report(closed, tmp_path, monkeypatch):
    """The report loads nothing from elsewhere either: no link in it is followed by a browser that only shows it."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "study.toml").write_text(whole_text("indentation"), encoding="utf-8")
    assert main(["run", "study.toml", "--quiet"]) == 0
    text = (tmp_path / "results" / "study" / "report.html").read_text(encoding="utf-8")
    assert len(text) > 10_000
    for mark in ('src="http', "src='http", '<link rel="stylesheet"', "@import", "url(http"):
        assert mark not in text
    assert closed == []


def test_commands_that_only_print(closed, capsys):
    for words in (["show"], ["show", "materials"], ["show", "sphere"], ["--version"]):
        assert main(words) == 0
    assert capsys.readouterr().out
    assert closed == []
