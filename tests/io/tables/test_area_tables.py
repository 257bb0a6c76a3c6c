"""Cross-sections of a tip over the contact depth, as programs of instruments export them."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.io.indenter_file import read_area
from winkler.study.nanoindentation.reading import read_nanoindentation_study
from winkler.values.errors import InvalidInput

DEPTH = np.linspace(0.0, 500.0, 251)


def _file(tmp_path, area, header="depth [nm], area [nm^2]\n"):
    file = tmp_path / "tip.txt"
    file.write_text(header + "\n".join(f"{h:.6f} {a:.9e}" for h, a in zip(DEPTH, area, strict=True)))
    return file


def test_a_hyperboloid_has_two_coefficients(tmp_path):
    """A = 24.5 (h^2 + 2 h h_0) of a Berkovich with h_0 = 12 nm."""
    found = read_area(_file(tmp_path, 24.5 * (DEPTH**2 + 24.0 * DEPTH)))
    assert found.coefficients == pytest.approx([24.5, 24.5 * 24e-9], rel=1e-6)
    assert found.deepest == pytest.approx(500e-9)
    assert found.shallowest == pytest.approx(6e-9)


def test_another_tip_is_within_a_hundredth_of_its_table(tmp_path):
    area = 24.5 * (DEPTH + 20.0 * (1.0 - np.exp(-DEPTH / 30.0))) ** 2
    found = read_area(_file(tmp_path, area, ""), "h [nm], a [nm^2]")
    for depth, size in zip(DEPTH, area, strict=True):
        if depth * 1e-9 >= found.shallowest:
            assert found.area(depth * 1e-9) == pytest.approx(size * 1e-18, rel=0.011)


@pytest.mark.parametrize(
    ("area", "header", "said"),
    [
        (24.5 * DEPTH**2, "", r"header = .depth \[nm\], area \[nm\^2\]"),
        (24.5 * DEPTH**2 * (1.0 + 0.1 * (-1.0) ** np.arange(251)), "h [nm], a [nm^2]\n", "no area function of 9 terms"),
        (-DEPTH, "h [nm], a [nm^2]\n", "0 depths with an area"),
    ],
)
def test_what_is_no_table_of_areas_is_named(tmp_path, area, header, said):
    with pytest.raises(InvalidInput, match=said):
        read_area(_file(tmp_path, area, header))


def test_studies_take_the_table_and_numbers_of_columns(tmp_path):
    _file(tmp_path, 24.5 * (DEPTH**2 + 24.0 * DEPTH), "")
    (tmp_path / "a.csv").write_text("1 2\n2 3\n")
    study = tmp_path / "study.toml"
    study.write_text(
        '[indentation]\ncurve = "a.csv"\npoisson = 0.3\ncolumns = { depth = 1, force = 2 }\n'
        'units = { position = "nm", force = "mN" }\n[indenter]\narea = "tip.txt"\n'
        'header = "depth [nm], area [nm^2]"\nframe_stiffness = "5 MN/m"\ndeepest = "400 nm"\n'
    )
    read = read_nanoindentation_study(study)
    assert read.columns == (("depth", 1), ("force", 2))
    assert read.indenter.area.coefficients == pytest.approx([24.5, 24.5 * 24e-9], rel=1e-6)
    assert read.indenter.area.deepest == pytest.approx(400e-9)
    assert read.indenter.frame_compliance == pytest.approx(2e-7)


HYSITRON = """Hysitron Area Function Coefficients, File Version: 4.00
C0
24.5
C1
{first}
C2
-3000.0
B
{offset}
C0 Uncertainty
0.0
C1 Uncertainty
20.5
Tip Poisson's Ratio
0.07
"""


def test_an_area_function_of_hysitron_is_in_powers_of_nm(tmp_path):
    """It was refused as a table without a contact depth."""
    (tmp_path / "tip.txt").write_text(HYSITRON.format(first="1250.5", offset="0.0"))
    found = read_area(tmp_path / "tip.txt")
    for h in (50.0, 400.0):
        expected = 24.5 * h**2 + 1250.5 * h - 3000.0 * h**0.5
        assert found.area(h * 1e-9) == pytest.approx(expected * 1e-18, rel=1e-12)
    assert len(found.coefficients) == 3


@pytest.mark.parametrize(("first", "offset"), [("many", "0.0"), ("1250.5", "3.0")])
def test_an_area_function_with_other_terms_is_refused(tmp_path, first, offset):
    (tmp_path / "tip.txt").write_text(HYSITRON.format(first=first, offset=offset))
    with pytest.raises(InvalidInput, match=r"tip\.txt: its coefficients are|without B"):
        read_area(tmp_path / "tip.txt")
