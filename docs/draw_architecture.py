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

A medium is a stiffness k(a), a shape is a profile g(x), and a contact is a row of springs under that profile. The
package turns bodies into springs, moves them, and brings the answer back to the bodies. This page shows where each
step stands. `python docs/draw_architecture.py` writes it and its picture from the imports.

![Layers of the package, the command line on top, the shared values at the bottom](figures/architecture.svg)

## One contact, from the study to the answer

What `winkler run hertz.toml` does, and the module to read:

1. **Read.** `study.language.reading` parses the file. The kind `indentation` is looked up among the records of
   `study.chapters`, which hold the words, the question and the class of each problem. Texts like "10 mm" become SI
   numbers in `values.units`.
2. **Build.** The parts are frozen values (`values.value`): a shape of `profiles`, a solid of `materials`, a load of
   `loading`, a medium of `media`. Each field is checked by its type (`values.checks`). A wrong one raises
   `InvalidInput` of `values.errors`, with one sentence.
3. **Springs.** `foundation.foundation` asks the profile for g(x) and the medium for k(a). The integral transforms
   between them are mathematics without physics: `numerics.transforms`.
4. **Solve.** The problem, here `problems.normal.indentation`, finds the contact that bears the load. Problems with a
   history move a row of springs step by step (`problems.row`). Each step yields a state, and the solution is the state
   with arrays in place of numbers (`problems.round_march`).
5. **Judge.** The solution lists in `validity` what it rests on (`values.validity`), with the error where one is known.
   The checks that problems share stand in `problems.assumptions`.
6. **Bring back.** `fields.restoration` computes the pressure on the surface and the stress below it from the springs.
7. **Show.** `plot` draws, `study.report` writes the report, `io` the files, `cli` the table in the terminal.

In Python the same begins at step 2.

## Layers

A module imports from the layers below its own. Among the modules of one package the imports form no circle.
`lint-imports` refuses what breaks either rule.

| layer, highest first | what it holds | packages inside |
|---|---|---|"""

WIDTH, ROW, LINE, MARGIN, LETTER = 900, 32, 13, 8, 6
"""Size of the picture [px]: of the whole, of a layer and each line of packages in it, between boxes, of a letter."""


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
    table = [
        f"| `{name}` | {summary(f'winkler.{name}')}{more} | {' '.join(f'`{each}`' for each in packages_in(name))} |"
        for name, more in rows
    ]
    return "\n".join([HEAD, *table, *problems()]) + "\n"


def problems() -> list[str]:
    """Return the packages of problems as a table, the lowest first."""
    inside, used = packages_in("problems"), children("winkler.problems")
    lines = ["", "## Problems", "", "| package | what it holds | uses |", "|---|---|---|"]
    for child in inside:
        others = " ".join(f"`{other}`" for other in inside if other in used[child])
        lines.append(f"| `{child}` | {summary(f'winkler.problems.{child}')} | {others or '-'} |")
    return lines


def picture() -> str:
    """Return the layers as boxes: a box may use what stands below it."""
    parts, top = [], MARGIN
    for names in layers():
        wide = (WIDTH - MARGIN * (len(names) + 1)) / len(names)
        texts = [textwrap.wrap("   ".join(packages_in(name)), int(wide / LETTER)) for name in names]
        high = ROW + LINE * max(map(len, texts))
        for number, (name, lines) in enumerate(zip(names, texts, strict=True)):
            left = MARGIN + number * (wide + MARGIN)
            middle = left + 0.5 * wide
            parts += [
                f'<rect x="{left:.1f}" y="{top}" width="{wide:.1f}" height="{high}" rx="4" '
                'fill="#dbe9f6" stroke="#44546a"/>',
                f'<text x="{middle:.1f}" y="{top + 20}" text-anchor="middle" font-size="15" font-weight="bold" '
                f'fill="#1b2a3a">{html.escape(name)}</text>',
            ]
            parts += [
                f'<text x="{middle:.1f}" y="{top + 36 + LINE * line}" text-anchor="middle" font-size="11" '
                f'fill="#1b2a3a">{html.escape(words)}</text>'
                for line, words in enumerate(lines)
            ]
        top += high + MARGIN
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {top}" font-family="sans-serif">'
    return "\n".join([head, f'<rect width="{WIDTH}" height="{top}" fill="#ffffff"/>', *parts, "</svg>"]) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
    PICTURE.write_text(picture(), encoding="utf-8")
