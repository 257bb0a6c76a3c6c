"""The twelve calculators without a browser: what is kept is what would be made, tables, sliders, studies."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from winkler.calculators import build
from winkler.calculators.catalogue import CALCULATORS, calculator
from winkler.calculators.series import series, series_of_two, table_of, table_of_two
from winkler.calculators.single_page import calculator_page
from winkler.study.language.reading import parse_study
from winkler.values.errors import NotConverged


def test_the_kept_module_is_that_of_these_sources():
    inputs, files = build.STAMP.read_text().split()
    assert inputs == build.made_of(), "run python -m winkler.calculators.build"
    assert files == build.digest_of_files()


def test_the_page_is_small_and_asks_nobody():
    page = calculator_page()
    assert len(page.encode()) < 3e6
    assert "default-src 'none'" in page
    assert not re.search(r"(src|srcset)\s*=|@import|url\(|fetch\(|XMLHttpRequest|import\(|^import ", page, re.MULTILINE)
    assert not {"STYLE", "SCRIPT", "DATA", "MANUAL"} & set(re.findall(r"^[A-Z]+$", page, re.MULTILINE))


def test_sliders_begin_within_their_range_and_curves_are_known():
    assert len(CALCULATORS) == 12
    for one in CALCULATORS:
        assert all(s.low <= s.start <= s.high and (s.low > 0.0 or not s.ratio) for s in one.sliders), one.name
        assert one.across in {s.name for s in one.sliders}
        assert one.up in {n.name for n in one.numbers}
        assert len({s.name for s in one.sliders} | {n.name for n in one.numbers}) <= build.MOST + build.MOST
        assert max(len(one.sliders), len(one.numbers)) <= build.MOST


@pytest.mark.parametrize("one", CALCULATORS, ids=lambda one: one.name)
def test_every_study_is_read(one):
    text = one.study
    for slider in one.sliders:
        text = text.replace(
            f"{{{slider.name}}}", f'"{slider.start!r} {slider.unit}"' if slider.unit else repr(slider.start)
        )
    for number in one.numbers:
        text = text.replace(f"{{={number.name}}}", f'"1e-7 {number.base}"')
    problem = parse_study(f'title = "t"\n\n[problem]\nkind = "{one.kind}"\n{text}').problem
    assert type(problem).__name__.lower() == one.kind.replace("_", "")


def test_a_kernel_by_the_closed_form_of_hertz():
    """With the closed-form constants of a ball as its table, the first kernel gives the numbers of Hertz."""
    one = calculator("normal")
    hertz = np.array([(9 / 16) ** (1 / 3), 0.75 ** (1 / 3), (6 / math.pi**3) ** (1 / 3), 0.0, 6 ** (1 / 3)])
    given = np.array([s.start for s in one.sliders]) * one.factors
    found = np.zeros(5)
    one.kernel(given, hertz, found)
    modulus = 210e9 / (2 * 0.91)
    radius = (3 * 100.0 * 10e-3 / (4 * modulus)) ** (1 / 3)
    expected = [radius**2 / 10e-3, radius, 1.5 * 100.0 / (math.pi * radius**2), 0.0, 2 * modulus * radius]
    np.testing.assert_allclose(found, expected, rtol=1e-14)


def test_tables_meet_their_function_and_end_where_they_end():
    table = table_of(lambda x: math.exp(-3.0 * x) * math.sqrt(x), 1e-4, 5.0)
    places = np.geomspace(1e-4, 5.0, 301)
    true = np.exp(-3.0 * places) * np.sqrt(places)
    assert np.max(np.abs([series(table, float(x)) for x in places] - true)) < 1e-11
    assert math.isnan(series(table, 0.99e-4))
    assert math.isnan(series(table, 5.001))
    two = table_of_two(lambda x, y: math.sin(x + y * y), (0.0, 2.0), (-1.0, 1.0))
    assert series_of_two(two, 0.3, -0.7) == pytest.approx(math.sin(0.79), abs=1e-12)


def test_a_table_of_noise_is_refused():
    rng = np.random.default_rng(0)
    with pytest.raises(NotConverged, match="smoother"):
        table_of(lambda x: 1.0 + 1e-6 * rng.standard_normal(), 0.0, 1.0)
    with pytest.raises(NotConverged, match="narrower"):
        table_of_two(lambda x, y: 1.0 / (1.0 + 400.0 * x * x), (-1.0, 1.0), (0.0, 1.0))
