"""`winkler --help` answers at once: it loads what prints, and nothing that computes."""

from __future__ import annotations

import subprocess
import sys

import pytest

COMPUTING = ("numpy", "scipy", "numba", "pandas", "xarray", "pint", "matplotlib", "winkler.public")
"""Not pydantic: typer itself asks for it where it is installed, before it shows the help of a command."""


@pytest.mark.parametrize("words", ["--help", "run --help", "show --help", "--version"])
def test_help_loads_nothing_that_computes(words):
    code = f"import sys; from winkler.cli import main; main({words.split()!r}); print(*sys.modules, file=sys.stderr)"
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = set(answer.stderr.split())
    assert "winkler.cli.app" in loaded
    assert loaded.isdisjoint(COMPUTING)


def test_the_names_come_when_they_are_asked_for():
    code = (
        "import sys, winkler; assert 'winkler.public' not in sys.modules; assert not hasattr(winkler, '__wrapped__'); "
        "assert 'winkler.public' not in sys.modules; import winkler.stairs; assert callable(winkler.staircase); "
        "assert winkler.Sphere(1.0).curvature_radius == 1.0; assert winkler.__version__ in winkler.__version__; "
        "names = {}; exec('from winkler import *', names); assert names['Sphere'] is winkler.Sphere"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_a_name_that_is_not_there_is_refused_by_name():
    import winkler

    with pytest.raises(AttributeError, match="module 'winkler' has no attribute 'Hertz'"):
        winkler.Hertz  # noqa: B018
