"""Write what was measured into the manual: tables between two comments, and the machine in words."""

from __future__ import annotations

import os
import platform
import re
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

PAGE = Path(__file__).resolve().parents[1] / "docs" / "benchmarks.md"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a table in Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def in_words(seconds: float) -> str:
    """Return a time with three digits and a unit that suits it."""
    for limit, factor, unit in ((1e-3, 1e6, "µs"), (1.0, 1e3, "ms")):
        if seconds < limit:
            return f"{seconds * factor:.3g} {unit}"
    return f"{seconds:.3g} s"


def machine() -> str:
    """Return what the numbers depend on, without naming anybody's computer."""
    load = f", load average {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else ""
    return (
        f"{os.cpu_count()} cores ({platform.machine()}), {platform.system()}, Python {platform.python_version()}, "
        f"numpy {version('numpy')}, scipy {version('scipy')}{load}"
    )


def replace(name: str, text: str, page: Path = PAGE) -> None:
    """Put `text` between the comments ``<!-- name: begin -->`` and ``<!-- name: end -->`` of a page."""
    old = page.read_text(encoding="utf-8")
    pattern = re.compile(rf"(<!-- {name}: begin[^>]*-->\n).*?(<!-- {name}: end -->)", re.DOTALL)
    new, count = pattern.subn(lambda found: f"{found[1]}\n{text}\n\n{found[2]}", old)
    if count != 1:
        raise ValueError(
            f"{page.name} must hold the comments '{name}: begin' and '{name}: end' once, not {count} times."
        )
    page.write_text(new, encoding="utf-8")
