"""The package, read as text and as modules, for the tests of the rules of the package."""

from __future__ import annotations

import ast
import importlib
import os
import pkgutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

import pytest

import winkler

SOURCE = Path(winkler.__file__).parent


class Page(NamedTuple):
    """One source file: its path inside the package, its text, its syntax tree and all nodes of that."""

    name: str
    text: str
    tree: ast.Module
    nodes: tuple[ast.AST, ...]


@pytest.fixture(scope="session")
def pages() -> list[Page]:
    """Every source file of the package."""
    found = []
    for path in sorted(SOURCE.rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        tree = ast.parse(text, str(path))
        found.append(Page(path.relative_to(SOURCE).as_posix(), text, tree, tuple(ast.walk(tree))))
    assert len(found) > 20
    return found


def module_names() -> list[str]:
    """Every module of the package, `__main__` pages (which run when imported) excepted."""
    names = [info.name for info in pkgutil.walk_packages([str(SOURCE)], prefix="winkler.")]
    return ["winkler", *(name for name in sorted(names) if not name.endswith("__main__"))]


@pytest.fixture(scope="session")
def modules() -> list[ModuleType]:
    """Every module of the package, imported."""
    return [importlib.import_module(name) for name in module_names()]


@pytest.fixture(scope="session")
def built(root, tmp_path_factory) -> Path:
    """Return the folder of a wheel and a source archive: that of `WINKLER_DIST`, or one built here."""
    if folder := os.environ.get("WINKLER_DIST"):
        return Path(folder)
    pytest.importorskip(
        "hatchling", reason="neither WINKLER_DIST nor hatchling (pip install winkler[checks]), which builds a wheel"
    )
    folder = tmp_path_factory.mktemp("dist")
    words = ["build", "-t", "wheel", "-t", "sdist", "-d", str(folder)]
    subprocess.run([sys.executable, "-m", "hatchling", *words], cwd=root, check=True)
    return folder


@pytest.fixture(scope="session")
def wheel(built) -> Path:
    """Return the wheel of this tree."""
    [path] = built.glob("*.whl")
    return path
