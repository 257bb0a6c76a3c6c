"""The software that computes: winkler's version, a digest of its sources, and the versions of what it computes with.

The version of winkler does not move with each change of its sources; the digest does.  It covers the files that solve
and fit, by their names and bytes: it is the same on each machine that has the same sources.  Files that only draw, show
or check numbers, and that no solver imports, are left out.

Reading a thousand files takes some 15 ms.  So the digest is kept where Python keeps its compiled modules, under the
names, sizes and times of the files, and computed anew when one of these changes.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import os
import re
import sys
import time
from collections.abc import Iterator, Mapping
from importlib.metadata import PackageNotFoundError, distribution, version
from pathlib import Path

COMPUTING = "numba", "numpy", "scipy"
"""Packages whose other versions may give other numbers."""
CACHE = "__pycache__"
NOT_SOLVING = frozenset({"calculators", "cases", "cli", "plot", "reference", "web"})
"""Folders of the package that no solver reads."""
ENDINGS = ".py", ".toml", ".csv", ".npz"
"""Of files on which numbers depend."""
SETTLED = 2.0
"""Age from which a file's times tell whether it was changed [s]; a clock of files may stand still for so long."""
DIGITS = 16
"""Of the digest that are stated."""
NAMES = {"sources": "sources of winkler"}
ABSENT, UNKNOWN = "none", "unknown"


@functools.cache
def software() -> Mapping[str, str]:
    """Return what computes: ``winkler``, ``sources`` (a digest), ``numba``, ``numpy``, ``scipy`` -> version.

    Returns
    -------
    dict of str to str
        Packages that are not installed have the version "none".
    """
    return {"winkler": installed_version("winkler"), "sources": _digest(Path(__file__).parents[1])} | {
        name: installed_version(name) for name in COMPUTING
    }


def differences(other: object) -> str:
    """Return what of another `software` is not as it is here, for a sentence; empty if nothing.

    Parameters
    ----------
    other
        What a file or another machine states; what it leaves out is unknown.
    """
    stated = other if isinstance(other, Mapping) else {}
    return ", ".join(
        f"{NAMES.get(name, name)} {stated.get(name, UNKNOWN)} (here {own})"
        for name, own in software().items()
        if stated.get(name) != own
    )


def installed_version(package: str) -> str:
    """Return the version of an installed package; its files are read once, and not all of their text is parsed."""
    try:
        stated = re.search(r"^Version: *(\S+)", distribution(package).read_text("METADATA") or "", re.MULTILINE)
        return stated[1] if stated else version(package)
    except PackageNotFoundError:
        return ABSENT


def _digest(package: Path) -> str:
    """Return the digest of the sources of a package; "unknown" if they cannot be read."""
    try:
        files = sorted(_files(package, ""))
        return _kept_digest(package, files)
    except OSError:  # frozen into one program, perhaps
        return UNKNOWN


def _files(folder: Path, prefix: str) -> Iterator[tuple[str, int, int, int]]:
    """Yield name, size, and times of the last change of content and of anything [ns] of each file that counts."""
    with os.scandir(folder) as entries:
        for entry in entries:
            name = f"{prefix}{entry.name}"
            if entry.name.endswith(ENDINGS):
                status = entry.stat()
                yield name, status.st_size, status.st_mtime_ns, status.st_ctime_ns
            elif "." not in name and name not in NOT_SOLVING and entry.name != CACHE and entry.is_dir():
                yield from _files(Path(entry.path), f"{name}/")


def _kept_digest(package: Path, files: list[tuple[str, int, int, int]]) -> str:
    key = hashlib.sha256(repr(files).encode()).hexdigest()
    elsewhere = sys.pycache_prefix
    compiled = package / CACHE if elsewhere is None else Path(elsewhere, *package.parts[1:])
    kept = compiled / "sources.digest"
    with contextlib.suppress(OSError, ValueError):
        stored_key, digest, end = kept.read_text(encoding="ascii").split(" ")
        if stored_key == key and len(digest) == DIGITS and end == "\n":
            return digest
    total = hashlib.sha256()
    for name, size, _, _ in files:
        total.update(f"{name}\0{size}\0".encode())
        with open(f"{package}/{name}", "rb", buffering=0) as file:
            total.update(file.read())
    digest = total.hexdigest()[:DIGITS]
    if time.time() - max(status[3] for status in files) * 1e-9 > SETTLED:
        with contextlib.suppress(OSError):  # the place is not ours: it is read again next time
            kept.write_text(f"{key} {digest} \n", encoding="ascii", newline="\n")
    return digest
