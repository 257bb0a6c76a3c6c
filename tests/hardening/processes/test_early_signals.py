"""Ctrl-C while the command itself is being loaded: 130 and one sentence, at once, and never lost."""

from __future__ import annotations

import os
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import winkler

PACKAGE = str(Path(winkler.__path__[0]).parent)
EARLY = """
import os, signal, sys

def imported(name, arguments):
    if name == "import" and arguments[0] == {where!r}:
        os.kill(os.getpid(), signal.SIGINT)

def left(frame, event, argument):
    if event == "call" and frame.f_code.co_name == "cb" and "importlib" in frame.f_code.co_filename:
        os.kill(os.getpid(), signal.SIGINT)

signal.signal(signal.SIGINT, signal.default_int_handler)
from winkler.__main__ import main
{how}
sys.exit(main())
"""
AT_IMPORTS, IN_CALLBACKS = "sys.addaudithook(imported)", "sys.setprofile(left)"


@pytest.mark.skipif(os.name == "nt", reason="a process cannot send itself Ctrl-C there")
@pytest.mark.parametrize(
    ("how", "where"),
    [(AT_IMPORTS, "winkler.cli"), (AT_IMPORTS, "winkler.cli.streams"), (IN_CALLBACKS, "")],
    ids=["the command line", "inside it", "a callback, where Python would report it and go on"],
)
def test_ctrl_c_before_the_command_begins(how, where, tmp_path):
    code = EARLY.format(how=how, where=where)
    run = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (run.returncode, run.stdout, run.stderr) == (130, "", "winkler: interrupted; nothing was written.\n")


def test_the_package_loads_nothing_before_signals_are_received():
    code = (
        "import sys; before = set(sys.modules); import winkler.__main__; "
        "print(*sorted(set(sys.modules) - before - set(sys.builtin_module_names)))"
    )
    run = subprocess.run([sys.executable, "-I", "-S", "-c", f"import sys; sys.path.insert(0, {PACKAGE!r}); {code}"],
                         capture_output=True, text=True, check=True)  # fmt: skip
    assert run.stdout.split() == ["winkler", "winkler.__main__"]


def test_the_installed_command_begins_there():
    project = tomllib.loads((Path(__file__).parents[3] / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["scripts"] == {"winkler": "winkler.__main__:main"}
