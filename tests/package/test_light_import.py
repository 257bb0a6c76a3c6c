"""`import winkler` is quick: what draws, writes, compiles or validates is loaded by its first use."""

from __future__ import annotations

import subprocess
import sys

import pytest

from winkler.plot.registered import everything, modules_naming

HEAVY = (
    "matplotlib",
    "plotly",
    "xarray",
    "h5netcdf",
    "h5py",
    "numba",
    "pandas",
    "pydantic",
    "pint",
    "typer",
    "rich",
    "scipy",
)


@pytest.fixture(scope="module")
def loaded() -> set[str]:
    code = "import winkler; [getattr(winkler, name) for name in winkler.__all__]; import sys; print(*sys.modules)"
    solution = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(solution.stdout.split())


def test_the_package_itself_is_loaded(loaded):
    assert "winkler" in loaded
    assert "numpy" in loaded


@pytest.mark.parametrize("heavy", HEAVY)
def test_import_stays_light(loaded, heavy):
    assert heavy not in loaded


def test_the_server_of_the_app_neither_solves_nor_draws():
    """That is done by the process of a page, which starts beside it: the page stands before what is behind it."""
    code = "import winkler.web.page.visitors, sys; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = set(done.stdout.split())
    assert "winkler.web.page.page" in loaded
    heavy = (
        "scipy",
        "winkler.fields.restoration",
        "winkler.plot.method",
        "winkler.web.pictures.answer",
        "winkler.study.batch.run",
    )
    assert loaded.isdisjoint(heavy)
    assert not [name for name in loaded if name.startswith("winkler.problems.")]


@pytest.mark.slow
def test_the_process_of_a_page_loads_fits_when_one_is_asked_for():
    code = "from winkler.web.session.worker import _WorkerState as S; S(); import sys; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert {"winkler.web.pictures.fitted", "winkler.plot.registered", "matplotlib"}.isdisjoint(done.stdout.split())


@pytest.mark.slow
def test_a_picture_of_one_kind_loads_those_that_name_it_and_is_the_same():
    code = """
import sys
import winkler as wk
from winkler.plot.registered import sheet_of_kind
bed = wk.Foundation(wk.Paraboloid(1e-2), wk.HalfSpace.between(wk.Elastic(210e9, 0.3)))
found = wk.SlidingWear(bed, wk.Archard(1e-14), wk.Force(10.0), [0.0, 1e-3], count=30).solve()
one = [panel.title for panel in sheet_of_kind(found).panels]
assert "winkler.plot.wear.wear" in sys.modules
assert not [name for name in sys.modules if name.startswith("winkler.plot.rolling.")]
from winkler.plot import sheet_of
assert one == [panel.title for panel in sheet_of(found).panels]
assert [name for name in sys.modules if name.startswith("winkler.plot.rolling.")]
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_the_picture_of_each_class_is_found_by_its_name():
    """Else all pictures, and the four hundred modules that they show, are loaded for one of them."""
    registry = everything().sheet_of.registry
    missed = {
        kind.__name__: drawn.__module__
        for kind, drawn in registry.items()
        if kind is not object and drawn.__module__ not in modules_naming(kind)
    }
    assert len(registry) > 100
    assert missed == {}
