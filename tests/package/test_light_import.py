"""`import winkler` is quick: what draws, writes, compiles or validates is loaded by its first use."""

from __future__ import annotations

import subprocess
import sys

import pytest

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
