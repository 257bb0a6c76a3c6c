"""Write docs/architecture.md and docs/figures/architecture.svg from the imports of the package.

Run ``python docs/draw_architecture.py`` after packages were added, renamed or made to use each other; a test compares
the page with what this would write.
"""

from __future__ import annotations

import ast
import functools
import graphlib
import html
import textwrap
import tomllib
from collections import defaultdict
from pathlib import Path

DOCS = Path(__file__).resolve().parent
SOURCE = DOCS.parent / "src" / "winkler"
PAGE, PICTURE = DOCS / "architecture.md", DOCS / "figures" / "architecture.svg"
APART = ("reference", "cases")
"""Folders no solver imports: closed forms, and the literature cases."""

HEAD = """# Architecture

The package is a pipeline: a profile and a medium make a bed of springs, a problem is solved on the bed, and the fields
of the bodies are restored from the springs. A module imports from the layers below its own; among the modules of one
package the imports form no circle. `lint-imports` refuses what breaks either rule. This page and its picture are
written by `python docs/draw_architecture.py` from the imports.

![Layers of the package, the command line on top, the shared words at the bottom](figures/architecture.svg)

| layer, highest first | what it holds |
|---|---|"""

WIDTH, ROW, MARGIN, LETTER = 900, 62, 10, 6
"""Size of the picture [px]: of the whole, of one layer, between boxes, of a letter."""


@functools.cache
def modules() -> dict[str, Path]:
    """Return name -> file of every module, packages by their own name."""
    found = {}
    for path in sorted(SOURCE.rglob("*.py")):
        parts = ("winkler", *path.relative_to(SOURCE).with_suffix("").parts)
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


@functools.cache
def imports() -> dict[str, set[str]]:
    """Return module -> modules of the package that it imports, wherever the statement stands."""
    known = modules()
    found: dict[str, set[str]] = {}
    for name, path in known.items():
        used = found[name] = set()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.module:
                whole = {f"{node.module}.{alias.name}" for alias in node.names}
                used |= {item if item in known else node.module for item in whole} & set(known)
            elif isinstance(node, ast.Import):
                used |= {alias.name for alias in node.names} & set(known)
    return found


def summary(name: str) -> str:
    """Return the first line of a module's docstring."""
    path = modules()[name]
    text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
    return text.partition("\n\n")[0].replace("\n", " ").strip()


def children(package: str) -> dict[str, set[str]]:
    """Return child -> the siblings that it uses, in an order in which everything stands after what it uses."""
    depth = package.count(".") + 1
    used: dict[str, set[str]] = defaultdict(set)
    for name, others in imports().items():
        if not name.startswith(f"{package}."):
            continue
        child = name.split(".")[depth]
        used[child] |= {other.split(".")[depth] for other in others if other.startswith(f"{package}.")} - {child}
    order = graphlib.TopologicalSorter({child: sorted(used[child]) for child in sorted(used)}).static_order()
    return {child: used[child] for child in order}


def layers() -> list[list[str]]:
    """Return the layers of pyproject.toml, the highest first, each with the names of its packages and modules."""
    contracts = tomllib.loads((DOCS.parent / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]
    lines = next(contract["layers"] for contract in contracts["contracts"] if contract["type"] == "layers")
    return [[name.strip().removeprefix("winkler.") for name in line.split("|")] for line in lines]


def packages_in(package: str) -> list[str]:
    """Return the packages inside a package, lowest first."""
    return [child for child in children(f"winkler.{package}") if (SOURCE / package / child / "__init__.py").exists()]


def page() -> str:
    """Return the page of the manual."""
    rows = [(name, "") for names in layers() for name in names]
    rows += [(name, " No solver imports it.") for name in APART if f"winkler.{name}" in modules()]
    table = [f"| `{name}` | {summary(f'winkler.{name}')}{more} |" for name, more in rows]
    return "\n".join([HEAD, *table, *(line for name, _ in rows for line in chapter(name))]) + "\n"


def chapter(package: str) -> list[str]:
    """Return the packages inside a package as a table; nothing if there are none."""
    inside, used = packages_in(package), children(f"winkler.{package}")
    if not inside:
        return []
    lines = ["", f"## `{package}/`", "", "| package | what it holds | uses |", "|---|---|---|"]
    for child in inside:
        others = ", ".join(f"`{other}`" for other in inside if other in used[child])
        lines.append(f"| `{child}` | {summary(f'winkler.{package}.{child}')} | {others or '-'} |")
    return lines


def picture() -> str:
    """Return the layers as boxes: a box may use what stands below it."""
    rows = layers()
    height = len(rows) * ROW + MARGIN
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif">',
        f'<rect width="{WIDTH}" height="{height}" fill="#ffffff"/>',
    ]
    for place, names in enumerate(rows):
        wide = (WIDTH - MARGIN * (len(names) + 1)) / len(names)
        for number, name in enumerate(names):
            left, top = MARGIN + number * (wide + MARGIN), MARGIN + place * ROW
            inside = packages_in(name)
            fill = "#dbe9f6" if (SOURCE / name).is_dir() else "#f1f1ee"
            parts.append(
                f'<rect x="{left:.1f}" y="{top}" width="{wide:.1f}" height="{ROW - MARGIN}" rx="4" '
                f'fill="{fill}" stroke="#44546a"/>'
            )
            middle = left + 0.5 * wide
            parts.append(
                f'<text x="{middle:.1f}" y="{top + (18 if inside else 29)}" text-anchor="middle" font-size="15" '
                f'font-weight="bold" fill="#1b2a3a">{html.escape(name)}</text>'
            )
            for line, words in enumerate(textwrap.wrap("   ".join(inside), int(wide / LETTER))):
                parts.append(
                    f'<text x="{middle:.1f}" y="{top + 33 + 12 * line}" text-anchor="middle" font-size="11" '
                    f'fill="#1b2a3a">{html.escape(words)}</text>'
                )
    return "\n".join([*parts, "</svg>"]) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
    PICTURE.write_text(picture(), encoding="utf-8")
