"""Gradings from files: with a column of Poisson's ratios or one ratio for all depths; and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.io.tables.grading_table import read_grading
from winkler.materials.depth_grading import TabulatedGrading
from winkler.values.errors import InvalidInput

GRADING = TabulatedGrading(np.array([0.0, 5e-6, 20e-6]), np.array([1e10, 2.5e10, 2e10]), np.array([0.25, 0.3, 0.28]))
ROWS = ((0, 10, 0.25), (5, 25, 0.3), (20, 20, 0.28))


@pytest.fixture
def file(tmp_path, monkeypatch):
    """Writes ``case.csv`` into an empty folder that is the current one, and returns its name."""
    monkeypatch.chdir(tmp_path)

    def write(header, rows=ROWS):
        lines = [header, *(",".join(map(str, row)) for row in rows)]
        (tmp_path / "case.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
        return "case.csv"

    return write


@pytest.mark.parametrize(
    "header",
    [
        "depth [um], young [GPa], poisson",
        "z (µm),E (GPa),nu (-)",
        "z,modulus,nu\num,GPa,-",
        "# depth_um,E_GPa,nu [-]",
    ],
)
def test_with_a_column_of_poissons_ratios(file, header):
    read = read_grading(file(header))
    for word in ("depths", "youngs", "poissons"):
        np.testing.assert_allclose(getattr(read, word), getattr(GRADING, word), rtol=1e-14)


def test_one_ratio_for_all_depths(file):
    read = read_grading(file("depth [um], young [GPa]", [row[:2] for row in ROWS]), poisson=0.3)
    assert read.poissons.tolist() == [0.3, 0.3, 0.3]
    np.testing.assert_allclose(read.youngs, GRADING.youngs, rtol=1e-14)


@pytest.mark.parametrize(
    ("header", "width", "options", "sentence"),
    [
        (
            "depth [um], young [GPa]",
            2,
            {},
            "case.csv: the table has no column of Poisson's ratios (poisson, nu); add it, or give poisson, which then "
            "holds at every depth.",
        ),
        (
            "depth [um], young [GPa], nu",
            3,
            {"poisson": 0.3},
            "case.csv: the table has a column of Poisson's ratios, and poisson = 0.3 was given as well; leave one of "
            "them out.",
        ),
        ("depth [um], young [GPa], nu [GPa]", 3, {}, "case.csv, line 1, Poisson's ratio: 'GPa' is the unit of"),
        ("depth [um], young, nu", 3, {}, "case.csv, line 1: no unit stands with 'young'; write it in the header, as "),
        ("depth [GPa], young [GPa], nu", 3, {}, "case.csv, line 1, depth: 'GPa' is the unit of a pressure"),
    ],
)
def test_what_is_refused(file, header, width, options, sentence):
    with pytest.raises(InvalidInput) as caught:
        read_grading(file(header, [row[:width] for row in ROWS]), **options)
    assert str(caught.value).startswith(sentence)


def test_what_is_no_grading_is_stated_with_its_file(file):
    with pytest.raises(InvalidInput, match=r"^case.csv: TabulatedGrading: depths"):
        read_grading(file("depth [um], young [GPa], nu", ROWS[::-1]))
