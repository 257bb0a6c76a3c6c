"""The wheel and the source archive, looked at by the programs of those who run and fill an index of packages."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile

import pytest

pytestmark = pytest.mark.slow


def looked_at(module: str, *words: object) -> subprocess.CompletedProcess[str]:
    """Run a checker that is installed here, in a terminal wide enough for its lines."""
    pytest.importorskip(module.partition(".")[0], reason=f"no {module} here: pip install winkler[checks]")
    command = [sys.executable, "-m", module, *map(str, words)]
    return subprocess.run(command, capture_output=True, text=True, env={**os.environ, "COLUMNS": "200"})


def spoiled(wheel, folder, change):
    """Return a copy of a wheel with a file added or changed."""
    path = folder / wheel.name
    with zipfile.ZipFile(wheel) as old, zipfile.ZipFile(path, "w") as new:
        for item in old.infolist():
            name, content = change(item.filename, old.read(item))
            new.writestr(name, content)
    return path


def test_twine_finds_the_front_page_in_order(built, wheel, tmp_path):
    done = looked_at("twine", "check", "--strict", wheel, *built.glob("*.tar.gz"))
    assert done.returncode == 0, done.stdout
    assert done.stdout.count("PASSED") == 2

    def without_a_page(name, content):
        return name, content.partition(b"\n\n")[0] + b"\n" if name.endswith("METADATA") else content

    assert looked_at("twine", "check", "--strict", spoiled(wheel, tmp_path, without_a_page)).returncode == 1


def test_check_wheel_contents_finds_the_wheel_in_order(wheel, tmp_path):
    done = looked_at("check_wheel_contents", wheel)
    assert done.returncode == 0, done.stdout

    def with_a_compiled_file(name, content):
        old, new = "winkler/values/errors.py", "winkler/errors.pyc"
        return (new if name == old else name), content.replace(f"{old},".encode(), f"{new},".encode())

    done = looked_at("check_wheel_contents", spoiled(wheel, tmp_path, with_a_compiled_file))
    assert (done.returncode, "W001" in done.stdout) == (1, True), done.stdout


def test_validate_pyproject_finds_the_project_in_order(root, tmp_path):
    done = looked_at("validate_pyproject", root / "pyproject.toml")
    assert done.returncode == 0, done.stderr
    text = (root / "pyproject.toml").read_text(encoding="utf-8")
    assert text.count('requires-python = ">=3.11"') == 1
    (tmp_path / "pyproject.toml").write_text(text.replace('requires-python = ">=3.11"', "requires-python = 3.11"))
    assert looked_at("validate_pyproject", tmp_path / "pyproject.toml").returncode == 1
