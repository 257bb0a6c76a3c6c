"""Every Python block of README.md and of the manual runs, and prints what the page shows.

The blocks of one page share their names, as they do for a reader who types them in one after the other.  The
folder they run in holds a copy of `examples/`, like the checkout in which the reader sits.  A block of text below
the comment ``<!-- output -->`` is what the Python block before it prints; ``...`` stands for anything.
"""

from __future__ import annotations

import contextlib
import doctest
import io
import re
import runpy
import shutil
import tomllib
from pathlib import Path

import pytest
from project_files import ROOT, project_files

PAGES = [
    ROOT / "README.md",
    *project_files(ROOT / "docs", "*.md"),
]
FENCE = re.compile(r"(?P<mark><!-- [^\n]*? -->\n)?^```(?P<kind>[^\n]*)\n(?P<body>.*?)^```$", re.MULTILINE | re.DOTALL)
CHECK = doctest.OutputChecker()
FLAGS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS


def blocks(text: str) -> list[tuple[str, str, str, int]]:
    """Return (mark, language, body, line) of every fenced block."""
    return [
        (
            (found["mark"] or "").strip(),
            found["kind"].strip(),
            found["body"],
            text.count("\n", 0, found.start("body")),
        )
        for found in FENCE.finditer(text)
    ]


def run(page: Path, text: str) -> int:
    """Run the Python blocks of a page; return how many there were."""
    names: dict[str, object] = {"__name__": "__main__"}
    printed, count = "", 0
    for mark, language, body, line in blocks(text):
        if language == "python":
            out = io.StringIO()
            code = compile("\n" * line + body, str(page), "exec")
            with contextlib.redirect_stdout(out):
                exec(code, names)
            printed, count = out.getvalue(), count + 1
        elif mark == "<!-- output -->":
            assert CHECK.check_output(body, printed, FLAGS), (
                f"{page.name}:{line}: the page says\n{body}\nbut the block prints\n{printed}"
            )
    return count


def copied(folder: Path) -> None:
    """Copy the examples into a folder."""
    shutil.copytree(ROOT / "examples", folder / "examples", ignore=shutil.ignore_patterns("results", "__pycache__"))


LONG = {
    "coatings.md", "figures.md", "line-friction.md", "line-layers.md", "line-viscoelastic.md", "line-wear.md",
    "profiles.md", "joints.md", "rollers.md", "rough.md", "seals.md", "subsurface.md", "surface-adhesion.md",
    "surface-friction.md", "surface-rolling.md", "wear.md",
}  # fmt: skip
"""Pages whose Python takes seconds; some run among the slow tests, the others before a release."""
SLOW = {"coatings.md", "line-friction.md", "line-layers.md", "profiles.md", "rough.md", "wear.md"}


@pytest.mark.few(16, slow=12)
@pytest.mark.parametrize(
    "page",
    [
        pytest.param(path, marks=pytest.mark.slow if path.name in SLOW else pytest.mark.long)
        if path.name in LONG
        else path
        for path in PAGES
    ],
    ids=[path.relative_to(ROOT).as_posix() for path in PAGES],
)
def test_the_python_of_a_page_runs(page, tmp_path, monkeypatch):
    text = page.read_text(encoding="utf-8")
    assert len(re.findall(r"^```", text, re.MULTILINE)) % 2 == 0, f"{page.name}: a fence is not closed"
    monkeypatch.chdir(tmp_path)
    if "```python" in text:
        copied(tmp_path)
    count = run(page, text)
    assert count == len(re.findall(r"^```python$", text, re.MULTILINE))
    assert count >= {"README.md": 1, "tour.md": 8}.get(page.name, 0)


@pytest.mark.parametrize("page", PAGES, ids=[path.relative_to(ROOT).as_posix() for path in PAGES])
def test_the_studies_of_a_page_can_be_read(page, tmp_path):
    """A block of TOML with a problem in it is a study, and is solved or fitted."""
    from winkler.study.batch.fit_run import fit_study
    from winkler.study.batch.run import run as solve
    from winkler.study.language.fit_reading import parse_fit_study
    from winkler.study.language.reading import parse_study

    found = [block for block in blocks(page.read_text(encoding="utf-8")) if block[1] == "toml"]
    if found:
        copied(tmp_path)
    for _, language, body, _ in found:
        if language == "toml" and "[problem]" in body and "[fit]" in body:
            fitted = fit_study(parse_fit_study(body, file=page.name, folder=tmp_path / "examples" / "studies"))
            assert fitted.refused == ()
        elif language == "toml" and "[problem]" in body:
            outcome = solve(parse_study(body, file=page.name, folder=tmp_path / "examples" / "studies"))
            assert outcome.failed == ()


def test_a_wrong_output_is_noticed(tmp_path):
    text = "```python\nprint(1 + 1)\n```\n\n<!-- output -->\n```text\n{}\n```\n"
    assert run(tmp_path / "page.md", text.format("2")) == 1
    with pytest.raises(AssertionError, match=r"page\.md:6: the page says"):
        run(tmp_path / "page.md", text.format("3"))


@pytest.mark.parametrize("name", ["run", "test"])
def test_readme_has_the_two_commands(name):
    """`.ci/run` takes them from here and runs them word for word."""
    marked = [
        (language, body)
        for mark, language, body, _ in blocks((ROOT / "README.md").read_text(encoding="utf-8"))
        if mark == f"<!-- ci: {name} -->"
    ]
    assert len(marked) == 1
    language, body = marked[0]
    assert language == "bash"
    assert body.count("\n") == 1, "one command, one line"
    assert body.startswith("python3 -m venv .venv && . .venv/bin/activate && pip install ")


def test_studies_that_are_named_are_there():
    named = {name for page in PAGES for name in re.findall(r"examples/[\w/]+\.\w+", page.read_text(encoding="utf-8"))}
    assert len(named) >= 5
    assert [name for name in sorted(named) if not (ROOT / name).exists()] == []


def test_links_inside_the_project_lead_somewhere():
    bad = []
    for page in PAGES:
        for target in re.findall(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8")):
            made_by_the_build = target.removeprefix("../").removeprefix("../").startswith("gallery/")
            if not made_by_the_build and not (page.parent / target).exists():
                bad.append(f"{page.name}: {target}")
    assert bad == []


MANUAL = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["urls"]["Documentation"]


def headings(page: Path) -> set[str]:
    """Return the anchors of a page."""
    heads = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", head.lower()).strip().replace(" ", "-") for head in heads}


def test_the_front_page_stands_on_the_index_of_packages():
    """It has no relative link, and what it links to in the manual is there."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    targets = re.findall(r"\]\(([^)\s]+)\)", text)
    assert len(targets) > 40
    assert [one for one in targets if not one.startswith("https://")] == []
    inside = [one.removeprefix(MANUAL) for one in targets if one.startswith(MANUAL)]
    assert "_images/front.png" in inside
    assert "](figures/front.png)" in (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    bad = []
    for target in inside:
        name, _, anchor = target.partition("#")
        page = ROOT / "docs" / name.replace(".html", ".md")
        if name.endswith(".html") and (not page.exists() or (anchor and anchor not in headings(page))):
            bad.append(target)
    assert bad == []


def test_the_front_page_is_short_and_its_numbers_are_those_of_the_benchmarks():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert text.count("\n") <= 150
    measured = (ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8")
    numbers = text.partition("## In numbers")[2].partition("\n## ")[0]
    rows = re.findall(r"^\| \d.*\|$", numbers, re.MULTILINE)
    assert len(rows) == 3
    assert [row for row in rows if row not in measured] == []
    assert re.findall(r"\d+(?:\.\d+)? (?:µs|ms|s)\b", re.sub(r"^\|.*$", "", numbers, flags=re.MULTILINE)) == []


def test_the_page_of_benchmarks_states_no_time_that_its_command_does_not_write():
    page = (ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8")
    names = re.findall(r"<!-- (\w+): begin \(written by benchmarks/measure\.py\) -->", page)
    written = (ROOT / "benchmarks" / "measure.py").read_text(encoding="utf-8")
    assert len(names) == len(set(names)) == 12
    assert [name for name in names if f'"{name}":' not in written and f'parts["{name}"]' not in written] == []
    by_hand = re.sub(r"<!-- (\w+): begin.*?<!-- \1: end -->", "", page, flags=re.DOTALL)
    assert re.findall(r"\d+(?:\.\d+)? ?(?:ns|µs|ms|s|minutes)\b|\d+ times", by_hand) == []


def test_the_picture_of_the_front_page_can_be_drawn_again():
    """What its script takes from the package is there; the picture itself is checked by eye."""
    page = ROOT / "docs" / "figures" / "draw_front.py"
    assert callable(runpy.run_path(str(page), run_name="draw_front")["main"])
    assert (ROOT / "docs" / "figures" / "front.png").stat().st_size < 150_000
