"""``winkler app``: what it says when it cannot begin; what it does is tested in a browser."""

from __future__ import annotations

import builtins
import socket
import sys

import pytest

from winkler.cli import main


def test_a_port_that_is_taken(capsys):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        assert main(["app", "--no-browser", "--port", str(port)]) == 2
    error = capsys.readouterr().err
    assert error.startswith(f"winkler: port {port} cannot be used (")
    assert "--port" in error
    assert error.count("\n") == 1


def test_without_the_extra(capsys, monkeypatch):
    usual = builtins.__import__

    def without(name, *rest, **more):
        if name.partition(".")[0] == "nicegui":
            raise ImportError(name)
        return usual(name, *rest, **more)

    for name in [name for name in sys.modules if name.partition(".")[0] == "nicegui"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setattr(builtins, "__import__", without)
    assert main(["app", "--no-browser"]) == 2
    assert capsys.readouterr().err == (
        'winkler: the app needs NiceGUI, which is not installed; install it with: pip install "winkler[app]"\n'
    )


@pytest.mark.parametrize("limit", ["0", "-3", "nan"])
def test_a_time_limit_is_positive(limit, capsys):
    assert main(["app", "--no-browser", "--time-limit", limit]) == 2
    assert "give a positive number of seconds" in capsys.readouterr().err
