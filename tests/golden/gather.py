"""Store the golden numbers of questions that have none yet: `python tests/golden/gather.py [name ...]`.

What is stored is never edited: new entries go into new files, whose digests are added to SHA256SUMS.  A name chooses
the questions that begin with it.  Before a second number is stored for a question that stands (class W), see
CONTRIBUTING.md.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from histories import KEPT

from golden import (
    NUMBERS,
    REARRANGED,
    RESIDUAL,
    Entry,
    Found,
    answered,
    difference,
    files,
    packed,
    questions,
    row_of,
    stored,
)

LASTING = 4.0
"""Seconds of processor time from which an entry goes into a file of its own, which long tests compare."""


def arithmetic() -> dict[str, str]:
    """Return the environment of a process that computes with the fewest instructions of this kind of processor."""
    from numpy._core._multiarray_umath import __cpu_dispatch__, __cpu_features__

    return {
        "NPY_DISABLE_CPU_FEATURES": " ".join(name for name in __cpu_dispatch__ if __cpu_features__.get(name)),
        "OPENBLAS_CORETYPE": "Nehalem",
        "OPENBLAS_NUM_THREADS": "2",
        "NUMBA_CPU_NAME": "x86-64",
        "NUMBA_CPU_FEATURES": "",
        "NUMBA_CACHE_DIR": os.environ.get("NUMBA_CACHE_DIR", tempfile.gettempdir()) + "-plain",
    }


def found_rows(key: str) -> list[Found | str]:
    """Return the numbers of the rows of a question."""
    return [answered(question) for question in questions()[key]]


def otherwise(keys: list[str], file: Path) -> dict[str, list[dict[str, list[float]] | str]]:
    """Return the rows of questions as another process finds them with other arithmetic."""
    subprocess.run([sys.executable, __file__, "--rows", str(file), *keys], env=os.environ | arithmetic(), check=True)
    return json.loads(file.read_text())


def write_rows(file: str, keys: list[str]) -> None:
    """Write the rows of questions, with all of their numbers."""
    rows = {
        key: [one if isinstance(one, str) else row_of(one.answers, sys.maxsize) for one in found_rows(key)]
        for key in keys
    }
    Path(file).write_text(json.dumps(rows))


def rounding(found: list[Found | str], other: list[dict[str, list[float]] | str], allowed: float) -> dict[str, float]:
    """Return by which quantities differ between two kinds of arithmetic by more than a tenth of what is allowed."""
    most: dict[str, float] = {}
    for now, then in zip(found, other, strict=True):
        if isinstance(now, Found) and isinstance(then, dict):
            for name, content in now.answers.items():
                most[name] = max(most.get(name, 0.0), difference(then[name], content))
    return {name: float(f"{apart:.1e}") for name, apart in most.items() if apart > 0.1 * allowed}


def main(names: list[str]) -> None:
    """Gather what is new."""
    known = {key for _, key, _ in stored()}
    asked = {
        key: rows for key, rows in questions().items() if key not in known and key.startswith(tuple(names or [""]))
    }
    found: dict[str, list[Found | str]] = {}
    lasting: set[str] = set()
    for key, rows in asked.items():
        began = time.process_time()
        found[key] = [answered(row) for row in rows]
        if time.process_time() - began > LASTING:
            lasting.add(key)
        print(f"{key}: {time.process_time() - began:.2f} s", flush=True)
    errors = {key: [0.0 if isinstance(one, str) else one.error for one in rows] for key, rows in found.items()}
    with tempfile.TemporaryDirectory() as folder:
        other = otherwise(list(found), Path(folder) / "rows.json") if found else {}
    sections: dict[str, dict[str, Entry]] = {}
    for key, rows in found.items():
        kept = {"kept": KEPT} if key.startswith("history/") else {}
        content = [one if isinstance(one, str) else row_of(one.answers, **kept) for one in rows]
        section = key.partition("/")[0] + ("-lasting" if key in lasting else "")
        noise = rounding(rows, other[key], max(REARRANGED, *errors[key]))
        residuals = {name for name, apart in noise.items() if apart > max(RESIDUAL, *errors[key])}
        if residuals:
            print(f"{key}: not stored: {', '.join(sorted(residuals))}")
            content = [
                one if isinstance(one, str) else {k: v for k, v in one.items() if k not in residuals} for one in content
            ]
            noise = {name: apart for name, apart in noise.items() if name not in residuals}
        error = sorted(set(errors[key]))[-1:] if len(set(errors[key])) == 1 else errors[key]
        sections.setdefault(section, {})[key] = Entry("M" if any(error) else "R", content, error, noise)
    for number, (section, entries) in enumerate(sections.items(), 1 + len(files())):
        lines = ",\n".join(f"{json.dumps(key)}: {_json(packed(entry))}" for key, entry in entries.items())
        file = NUMBERS / f"{number}-{section}.json"
        file.write_text(f"{{\n{lines}\n}}\n", encoding="utf-8")
        with (NUMBERS / "SHA256SUMS").open("a", encoding="utf-8") as sums:
            sums.write(f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n")


def _json(content: object) -> str:
    return json.dumps(content, separators=(",", ":"))


if __name__ == "__main__":
    NUMBERS.mkdir(exist_ok=True)
    np.seterr(all="ignore")
    if sys.argv[1:2] == ["--rows"]:
        write_rows(sys.argv[2], sys.argv[3:])
    else:
        main(sys.argv[1:])
