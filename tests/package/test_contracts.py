"""Arrows fall: the import contracts of pyproject.toml hold."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

RUN = "import sys; from importlinter.cli import lint_imports; sys.exit(lint_imports(no_cache=True))"


def test_import_contracts_hold(root: Path):
    pytest.importorskip("importlinter", reason="import-linter comes with the extra dev; .ci/run has it")
    solution = subprocess.run(
        [sys.executable, "-c", RUN],
        cwd=root,
        env={**os.environ, "PYTHONIOENCODING": "utf-8"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert solution.returncode == 0, solution.stdout + solution.stderr
    assert "0 broken" in solution.stdout
