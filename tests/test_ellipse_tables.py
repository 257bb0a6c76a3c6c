"""The table of docs/chapters/ellipses.md is that of docs/figures/draw_ellipse.py, and known numbers stand in it."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest

DOCS = Path(__file__).resolve().parents[1] / "docs"


@pytest.mark.slow
def test_the_page_has_the_table_of_the_script():
    script = runpy.run_path(str(DOCS / "figures" / "draw_ellipse.py"), run_name="draw_ellipse")
    page = (DOCS / "chapters" / "ellipses.md").read_text(encoding="utf-8")
    written = page.split("<!-- table: written by docs/figures/draw_ellipse.py -->\n")[1].split("\n<!-- table: end -->")[
        0
    ]
    assert written == script["table"](), "run python docs/figures/draw_ellipse.py, and put its table into the page"
    rows = [[float(cell) for cell in line.strip("| ").split("|")] for line in written.splitlines()[2:]]
    assert rows[0][6:10] == [0.31, 0.4809, 0.62, 0.4809]  # Johnson, (3.45) and section 6.1, nu = 0.3
    assert [round(number, 2) for number in rows[-1][6:]] == [0.30, 0.79, 0.56, 0.71, 0.25, 0.5]
