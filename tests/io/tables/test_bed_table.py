"""Measured beds from files: a force curve with a modulus, or radius, stiffness and depth; and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.foundation.measured import MeasuredBed
from winkler.io.tables.bed_table import read_bed
from winkler.loading.loads import Depth
from winkler.problems.normal.indentation import Indentation
from winkler.values.errors import InvalidInput

DEPTH = np.linspace(0.0, 1e-6, 60)
FORCE = 5e6 * DEPTH**1.5
RADII = np.linspace(1e-6, 1e-5, 8)
STIFFNESS, DEPTHS = 1.4e11 * RADII, RADII**2 / 1e-3


@pytest.fixture
def file(tmp_path, monkeypatch):
    """Writes ``curve.csv`` into an empty folder that is the current one, and returns its name."""
    monkeypatch.chdir(tmp_path)

    def write(header, *columns):
        rows = "\n".join(",".join(repr(float(number)) for number in row) for row in zip(*columns, strict=True))
        (tmp_path / "curve.csv").write_text(f"{header}\n{rows}\n", encoding="utf-8")
        return "curve.csv"

    return write


@pytest.mark.parametrize(
    "header", ["depth [nm], force [mN]", "Displacement (nm), Load (mN)", "d_nm,F_mN", "indentation,force\nnm,mN"]
)
def test_a_force_curve(file, header):
    bed = read_bed(file(header, DEPTH * 1e9, FORCE * 1e3), modulus=70e9)
    direct = MeasuredBed.from_curve(DEPTH, FORCE, 70e9)
    np.testing.assert_allclose(bed.radii, direct.radii, rtol=1e-8)
    answer = Indentation(bed, Depth(0.5e-6)).solve()
    assert answer.force == pytest.approx(5e6 * 0.5e-6**1.5, rel=1e-8)
    assert answer.radius == pytest.approx(7.5e6 * np.sqrt(0.5e-6) / (2 * 70e9), rel=1e-6)


def test_radii_stiffnesses_and_depths_in_any_order_of_columns(file):
    name = file("depth [nm], n [m], radius [um], k [kN/m]", DEPTHS * 1e9, RADII, RADII * 1e6, STIFFNESS * 1e-3)
    bed = read_bed(name, mindlin_ratio=0.8)
    for found, given in ((bed.radii, RADII), (bed.stiffnesses, STIFFNESS), (bed.depths, DEPTHS)):
        np.testing.assert_allclose(found, given, rtol=1e-14)
    assert bed.mindlin_ratio == 0.8


@pytest.mark.parametrize(
    ("header", "columns", "options", "sentence"),
    [
        (
            "depth [nm], force [mN]",
            (DEPTH, FORCE),
            {},
            "curve.csv: a force curve alone does not give the contact radius; give modulus = E* of the medium, such as "
            "115 GPa for a hard tip on steel.",
        ),
        (
            "radius [m], stiffness [N/m], depth [m]",
            (RADII, STIFFNESS, DEPTHS),
            {"modulus": 1e9},
            "curve.csv: the table holds contact radii and stiffnesses, so that modulus = 1e+09 Pa is not needed; "
            "leave it out.",
        ),
        (
            "depth [nm], height [nm]",
            (DEPTH, FORCE),
            {"modulus": 1e9},
            "curve.csv: the header has no force (force, load, f, p), there are 'depth [nm]', 'height [nm]'; name the "
            "columns, as in 'depth [nm], force [mN]'.",
        ),
        (
            "depth [nm], force [nm]",
            (DEPTH, FORCE),
            {"modulus": 1e9},
            "curve.csv, line 1, force: 'nm' is the unit of a length, not of a force",
        ),
        (
            "radius [m], stiffness [N/m], depth [m]",
            (RADII, STIFFNESS[::-1], DEPTHS),
            {},
            "curve.csv: MeasuredBed: stiffnesses does not rise",
        ),
    ],
)
def test_what_is_refused(file, header, columns, options, sentence):
    with pytest.raises(InvalidInput) as caught:
        read_bed(file(header, *columns), **options)
    assert str(caught.value).startswith(sentence)
