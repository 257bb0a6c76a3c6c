"""``winkler report``: the page alone, with and without curves that are read off."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest

from winkler.cli import main

STUDY = """
[problem]
kind = "indentation"
load = { kind = "force", force = "100 N" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }

[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = "210 GPa", poisson = 0.3 }
"""


@pytest.fixture
def here(tmp_path, monkeypatch):
    """A folder with a study."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ball.toml").write_text(STUDY, encoding="utf-8")
    return tmp_path


@pytest.mark.slow
def test_curves_that_are_read_off_are_those_of_the_contact(here, capsys):
    """The pressure on the page is that of Hertz, p0 sqrt(1 - r^2/a^2), in the units of its axes."""
    assert main(["report", "ball.toml", "--interactive"]) == 0
    assert "Written ball.html" in capsys.readouterr().out
    page = (here / "ball.html").read_text(encoding="utf-8")
    assert not re.search(r'<script[^>]* src=|<link[^>]* href="http', page)
    (text,) = re.findall(r'<script type="application/json" id="curves">(.*?)</script>', page, re.DOTALL)
    (panel,) = json.loads(text)["pressure"]
    assert (panel["x"]["unit"], panel["y"]["unit"], panel["y"]["title"]) == ("µm", "GPa", "pressure p")
    r, p = (np.array(panel["curves"][0][axis], dtype=float) for axis in "xy")
    modulus = 210e9 / 0.91
    a = (3 * 100.0 * 10e-3 / (4 * modulus)) ** (1 / 3)
    expected = 1.5 * 100.0 / (np.pi * a**2) * np.sqrt(np.maximum(1.0 - (r * 1e-6 / a) ** 2, 0.0))
    np.testing.assert_allclose(p * 1e9, expected, atol=2e-3 * expected.max())
    left, top, right, bottom = panel["box"]
    size = re.search(r'<svg(?=[^>]* role="img")[^>]* viewBox="0 0 ([\d.]+) ([\d.]+)"', page)
    assert 0 < left < right < float(size[1])
    assert 0 < top < bottom < float(size[2])


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (["-o", "ball.pdf"], "report: 'ball.pdf' does not end like a page; give .html."),
        (["--page", "--film"], "report: --page is a sheet of paper, on which nothing moves; leave --film out."),
        (["-o", "old.html"], "report: 'old.html' exists; add --overwrite to replace it"),
    ],
)
def test_what_is_refused(options, sentence, here, capsys):
    (here / "old.html").write_text("old", encoding="utf-8")
    assert main(["report", "ball.toml", *options]) == 2
    assert sentence in capsys.readouterr().err
    assert (here / "old.html").read_text(encoding="utf-8") == "old"


@pytest.mark.slow
def test_a_film_is_in_the_page_with_a_slider_over_its_moments(here, capsys):
    loads = ", ".join(f'"{10 * count} N"' for count in range(1, 31))
    moving = STUDY.replace('force = "100 N"', f"force = [{loads}]")
    (here / "moving.toml").write_text(moving, encoding="utf-8")
    assert main(["report", "moving.toml", "-o", "still.html"]) == 0
    assert main(["report", "moving.toml", "--film", "--interactive"]) == 0
    page = (here / "moving.html").read_text(encoding="utf-8")
    assert not re.search(r'<script[^>]* src=|<link[^>]* href="http', page)
    frames = re.findall(r'<img src="data:image/png;base64,([^"]*)" alt="([^"]*)"( hidden)?>', page)
    assert 2 < len(frames) <= 12
    assert len({packed for packed, _, _ in frames}) == len(frames)  # each shows another moment
    assert ": 1 of 30" in frames[0][1]
    assert ": 30 of 30" in frames[-1][1]
    assert [bool(hidden) for _, _, hidden in frames] == [False] + [True] * (len(frames) - 1)
    assert f'type="range" min="0" max="{len(frames) - 1}"' in page
    assert sum(len(packed) for packed, _, _ in frames) < 300e3
    assert 'class="film"' not in (here / "still.html").read_text(encoding="utf-8")
    assert main(["report", "ball.toml", "--film"]) == 2
    assert "does not move; give a path, times, cycles or a list of loads" in capsys.readouterr().err
