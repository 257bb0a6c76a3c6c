"""Relaxation, creep, storage and loss from files: of shear or of tension, over either frequency; what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.values.errors import InvalidInput

TIMES = (0.01, 0.1, 1.0, 10.0, 100.0)


@pytest.fixture
def file(tmp_path, monkeypatch):
    """Writes ``solid.csv`` into an empty folder that is the current one, and returns its name."""
    monkeypatch.chdir(tmp_path)

    def write(header, rows):
        lines = [header, *(",".join(map(repr, row)) for row in rows)]
        (tmp_path / "solid.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
        return "solid.csv"

    return write


@pytest.mark.parametrize(
    ("header", "factor"),
    [
        ("time [s], shear [kPa]", 1.0),
        ("t (s);G(t) (kPa)", 1.0),
        ("Time_s, G_kPa", 1.0),
        ("time [s], young [kPa]", 1.0 / 2.8),
        ("t [s], Tensile modulus [kPa]", 1.0 / 2.8),
    ],
)
def test_relaxation(file, header, factor):
    separator = ";" if ";" in header else ","
    name = file(header, [])
    rows = [f"{time}{separator}{5.0 - k}" for k, time in enumerate(TIMES)]
    with open(name, "a", encoding="utf-8") as out:
        out.write("\n".join(rows) + "\n")
    read = wk.read_relaxation(name, poisson=0.4)
    assert read.poisson == 0.4
    assert read.time.tolist() == list(TIMES)
    assert read.shear == pytest.approx(factor * 1e3 * (5.0 - np.arange(5)), rel=1e-14)


@pytest.mark.parametrize(("header", "factor"), [("t [s], J [1/MPa]", 1.0), ("t [s], D(t) [1/MPa]", 3.0)])
def test_creep(file, header, factor):
    read = wk.read_creep(file(header, [(time, 1.0 + k) for k, time in enumerate(TIMES)]))
    assert read.poisson == 0.5
    assert read.compliance == pytest.approx(factor * 1e-6 * (1.0 + np.arange(5)), rel=1e-14)


@pytest.mark.parametrize(
    ("header", "turns", "factor"),
    [
        ("omega [rad/s], G' [kPa], G'' [kPa]", 1.0, 1.0),
        ("frequency [Hz], storage [kPa], loss [kPa]", 2.0 * math.pi, 1.0),
        ("f [Hz], tensile_storage [kPa], tensile_loss [kPa]", 2.0 * math.pi, 1.0 / 3.0),
    ],
)
def test_storage_and_loss_even_if_swept_downwards(file, header, turns, factor):
    rows = [(time, 3.0 + k, 0.5 + 0.1 * k) for k, time in enumerate(TIMES)]
    read = wk.read_dynamic(file(header, rows[::-1]))
    assert read.angular_frequency == pytest.approx(turns * np.array(TIMES), rel=1e-14)
    assert read.storage_shear == pytest.approx(factor * 1e3 * (3.0 + np.arange(5)), rel=1e-14)
    assert read.loss_shear == pytest.approx(factor * 1e3 * (0.5 + 0.1 * np.arange(5)), rel=1e-14)


def test_what_was_written_is_what_is_fitted(file):
    """The numbers of a Maxwell solid lead back to it."""
    times = np.geomspace(0.01, 10.0, 25)
    read = wk.read_relaxation(file("time [s], shear [Pa]", [(t, 1e3 * math.exp(-t / 5.0)) for t in times.tolist()]))
    assert read.series_error < 0.02
    assert float(read.relaxation(2.0)) == pytest.approx(1e3 * math.exp(-0.4), rel=0.02)


@pytest.mark.parametrize(
    ("read", "header", "options", "sentence"),
    [
        (wk.read_relaxation, "time [s], force [N]", {}, r"solid\.csv: the header has no shear modulus \(shear, g, "),
        (wk.read_relaxation, "time [s], shear", {}, "no unit stands with 'shear'"),
        (wk.read_relaxation, "time [s], shear [s]", {}, "shear modulus: 's' is the unit of a time"),
        (wk.read_relaxation, "time [s], young [Pa]", {"poisson": -1.0}, r"poisson is -1\.0; a Poisson ratio"),
        (wk.read_relaxation, "time [s], shear [Pa]", {"poisson": 0.7}, r"solid\.csv: RelaxationData: poisson is 0\.7"),
        (wk.read_creep, "time [s], shear [Pa]", {}, "the header has no shear compliance"),
        (wk.read_dynamic, "omega [Hz], storage [Pa], loss [Pa]", {}, "angular frequency: 'Hz' is the unit of"),
        (wk.read_dynamic, "time [s], storage [Pa], loss [Pa]", {}, "the header has no frequency"),
    ],
)
def test_what_is_refused(file, read, header, options, sentence):
    rows = [(time, *([1.0] * header.count(","))) for time in TIMES]
    with pytest.raises(InvalidInput, match=sentence):
        read(file(header, rows), **options)


def test_what_is_no_solid_is_stated_with_its_file(file):
    with pytest.raises(InvalidInput, match=r"^solid\.csv: CreepData: time has 2 numbers; give a row of at least 4"):
        wk.read_creep(file("time [s], compliance [1/Pa]", [(1.0, 2.0), (2.0, 3.0)]))
