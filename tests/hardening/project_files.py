"""The files of the project that tests read: those git knows, or in a copy without git those it would not ignore."""

from __future__ import annotations

import os
import subprocess
from fnmatch import fnmatch
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
__all__ = ["ROOT", "project_files"]


def project_files(folder: Path, pattern: str = "*") -> list[Path]:
    """Return the files of the project below a folder, in order, whose names match a pattern.

    A user who runs a study inside `examples` leaves results there, and other copies of the package may lie about.
    """
    return [path for path in _files() if path.is_relative_to(folder) and fnmatch(path.name, pattern)]


@cache
def _files() -> list[Path]:
    if (ROOT / ".git").exists():
        command = ["git", "-c", "safe.directory=*", "-C", str(ROOT), "ls-files", "-z"]
        try:
            listed = subprocess.run(command, capture_output=True, check=True).stdout.decode().split("\0")
        except (OSError, subprocess.CalledProcessError):
            pass  # there is no git program here
        else:
            return sorted(path for name in listed if name and (path := ROOT / name).is_file())
    ignored = [line.strip("/") for line in (ROOT / ".gitignore").read_text(encoding="utf-8").split()]
    found: list[Path] = []
    for name, folders, names in os.walk(ROOT):
        place = Path(name)

        def kept(name: str, place: Path = place) -> bool:
            inside = (place / name).relative_to(ROOT).as_posix()
            return not any(fnmatch(name, pattern) or fnmatch(inside, pattern) for pattern in ignored)

        folders[:] = filter(kept, folders)
        found += [place / name for name in names if kept(name)]
    return sorted(found)
