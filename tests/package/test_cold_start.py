"""What is loaded for a word on the command line, or for one public name: what it needs, and nothing else."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import winkler as wk

COMPUTING = (
    "numpy",
    "scipy",
    "numba",
    "pandas",
    "xarray",
    "pint",
    "matplotlib",
    "winkler.public",
)
"""Not pydantic: typer itself imports it where it is installed, before it shows the help of a command."""


@pytest.mark.parametrize("words", ["--help", "run --help", "show --help", "--version"])
def test_help_loads_nothing_that_computes(words):
    code = f"import sys; from winkler.cli import main; main({words.split()!r}); print(*sys.modules, file=sys.stderr)"
    solution = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = set(solution.stderr.split())
    assert "winkler.cli.app" in loaded
    assert loaded.isdisjoint(COMPUTING)


STUDY = """[problem]
kind = "indentation"
load = { kind = "force", force = "100 N" }

[problem.bed]
kind = "foundation"
profile = { kind = "sphere", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "210 GPa", poisson = 0.3 } }
"""
ELSEWHERE = {
    "pint", "numba", "scipy", "pandas", "xarray", "dask", "distributed", "sympy", "winkler.public",
    "winkler.web", "winkler.reference",
}  # fmt: skip
"""What one elastic contact does not need."""
OF_OTHER_STUDIES = {
    "winkler.plot", "winkler.fields.restoration", "winkler.problems.wear", "winkler.media.graded",
    "winkler.media.layered", "winkler.media.relaxing.proportional", "winkler.study.language.fit_study",
    "winkler.study.batch.processes", "winkler.study.batch.sensitivity", "winkler.io.array_file", "multiprocessing",
    "numpy.ma",
}  # fmt: skip
"""What one contact of half-spaces does not need where nothing is written."""
MOST_MODULES = 197
"""Modules of the package that such a contact loads: 197, of more than 1,200, all records and words included."""
OF_OTHER_REPORTS = {
    "winkler.calculators", "winkler.problems.adhesion.cycle",
    "winkler.problems.pressed_maps", "winkler.problems.surface_wear",
}  # fmt: skip
"""What the report of such a contact does not need."""
OF_REPORTS = {"matplotlib", "h5netcdf", "h5py", "tomli_w", "rich"}


def modules_after(code: str, folder: Path | None = None) -> set[str]:
    """Return what a new process has loaded after some lines."""
    code = f"{code}; import sys; print(*sys.modules, file=sys.stderr)"
    solution = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=folder)
    return set(solution.stderr.split())


@pytest.mark.parametrize(
    ("name", "elsewhere"),
    [
        ("Sphere", {"winkler.problems", "winkler.media", "winkler.foundation", "winkler.materials", "winkler.study"}),
        ("HalfSpace", {"winkler.problems", "winkler.foundation", "winkler.fitting", "winkler.study"}),
        ("Indentation", {"winkler.problems.friction", "winkler.problems.wear", "winkler.fitting", "winkler.study"}),
        ("fit", {"winkler.study", "winkler.plot", "winkler.problems.wear"}),
    ],
)
def test_one_name_loads_the_modules_of_its_own_page(name, elsewhere):
    loaded = modules_after(f"import winkler; winkler.{name}")
    assert getattr(wk, name).__module__ in loaded
    assert loaded.isdisjoint(ELSEWHERE | OF_REPORTS | {"pydantic", "typer"} | elsewhere)


def test_the_package_alone_loads_next_to_nothing():
    assert {name for name in modules_after("import winkler") if name.startswith(("winkler", "numpy"))} == {"winkler"}


@pytest.mark.slow
def test_names_are_found_where_modules_have_no_text():
    """As in a distribution of compiled files."""
    code = (
        "import importlib.machinery as m; m.SourceFileLoader.get_source = lambda self, name: None; import winkler; "
        "assert winkler.Sphere(1.0).curvature_radius == 1.0; assert len(winkler.__all__) > 200"
    )
    assert "winkler.public" in modules_after(code)


@pytest.mark.slow
def test_numbers_alone_load_nothing_that_draws_or_writes(tmp_path):
    (tmp_path / "ball.toml").write_text(STUDY, encoding="utf-8")
    loaded = modules_after("from winkler.cli import main; main(['run', 'ball.toml', '--json'])", tmp_path)
    assert "winkler.problems.normal.indentation" in loaded
    assert loaded.isdisjoint(ELSEWHERE | OF_REPORTS | OF_OTHER_STUDIES)
    assert sum(name.partition(".")[0] == "winkler" for name in loaded) <= MOST_MODULES
    assert [path.name for path in tmp_path.iterdir()] == ["ball.toml"]


@pytest.mark.slow
def test_a_report_loads_what_draws_and_writes_it(tmp_path):
    (tmp_path / "ball.toml").write_text(STUDY, encoding="utf-8")
    loaded = modules_after("from winkler.cli import main; main(['run', 'ball.toml', '--quiet'])", tmp_path)
    assert {"winkler.plot.svg.sheet", "h5netcdf"} <= loaded
    assert loaded.isdisjoint(ELSEWHERE | OF_OTHER_REPORTS | {"rich", "matplotlib"})
    assert (tmp_path / "results/ball/report.html").is_file()


@pytest.mark.slow
def test_the_names_come_when_they_are_requested():
    code = (
        "import sys, winkler; assert 'winkler.public' not in sys.modules; assert not hasattr(winkler, '__wrapped__'); "
        "assert 'winkler.public' not in sys.modules; import winkler.fields.punch_staircase; "
        "assert callable(winkler.staircase); "
        "assert winkler.Sphere(1.0).curvature_radius == 1.0; assert winkler.__version__ in winkler.__version__; "
        "names = {}; exec('from winkler import *', names); assert names['Sphere'] is winkler.Sphere"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_a_name_that_is_not_there_is_refused_by_name():
    with pytest.raises(AttributeError, match="module 'winkler' has no attribute 'Hertz'"):
        wk.Hertz  # noqa: B018
