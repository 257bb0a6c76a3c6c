"""C compilers that are called for whoever exports: the system's own, or that of the wheel ziglang."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from winkler.values.errors import InvalidInput

LONGEST_WAIT = 600.0
"""Seconds that a compiler may take."""
OPTIMISED = ("-O2", "-ffp-contract=off")
NAMES = ("cc", "gcc", "clang")


def _zig() -> list[str]:
    """Return the command of the compiler of the wheel ziglang; empty if it is not installed."""
    try:
        version("ziglang")
    except PackageNotFoundError:
        return []
    return [sys.executable, "-m", "ziglang", "cc"]


def _own() -> list[str]:
    """Return the command of a compiler for the system here; empty if there is none."""
    found = [path for path in map(shutil.which, NAMES) if path]
    return found[:1] or _zig()


def has_compiler() -> bool:
    """Return whether there is a compiler for the system here."""
    return bool(_own())


def compiled_here(sources: Mapping[str, str], made: str) -> bytes:
    """Return a shared library for the system here, of the last of the sources, which may include the others.

    Raises
    ------
    InvalidInput
        If there is no compiler, or it fails.
    """
    return _compiled(
        [*_own(), "-std=c99", *OPTIMISED, "-shared", "-fPIC", "-fvisibility=hidden"], sources, made, ("-lm",)
    )


def compiled_by_zig(sources: Mapping[str, str], target: str, options: tuple[str, ...], made: str) -> bytes:
    """Return what the last of the sources becomes on another system, such as "wasm32-wasi".

    Raises
    ------
    InvalidInput
        If the compiler is not there, or fails.
    """
    if not _zig():
        raise InvalidInput("export: this needs the compiler of the wheel ziglang; pip install winkler[export].")
    return _compiled([*_zig(), "-target", target, *OPTIMISED, *options], sources, made, ())


def _compiled(command: list[str], sources: Mapping[str, str], made: str, libraries: tuple[str, ...]) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        for name, text in sources.items():
            (Path(folder) / name).write_text(text, encoding="utf-8")
        try:
            done = subprocess.run(
                [*command, list(sources)[-1], "-o", made, *libraries],
                cwd=folder, capture_output=True, text=True, timeout=LONGEST_WAIT, check=False,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            raise InvalidInput(f"export: the compiler takes longer than {LONGEST_WAIT:g} s; export to c.") from None
        if done.returncode != 0:
            raise InvalidInput(f"export: the compiler failed: {done.stderr.strip()[-300:]}; export to c.")
        return (Path(folder) / made).read_bytes()
