"""Moduli as rheometers and programs write them: primes, rows between names and units, sheets, and no names at all."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.io.tables.relaxation_table import read_creep, read_dynamic, read_relaxation
from winkler.io.tables.sweeps_table import read_dynamic_sweeps
from winkler.io.topography_file import read_topography
from winkler.values.errors import InvalidInput

OMEGA = np.array([0.1, 1.0, 10.0, 100.0])
STORAGE, LOSS = 1e5 * OMEGA**0.2, 3e4 * OMEGA**0.1
ROWS = "\n".join(f"{w:.6e} {a:.6e} {b:.6e}" for w, a, b in zip(OMEGA, STORAGE, LOSS, strict=True))


def _file(tmp_path, text, name="m.txt"):
    (tmp_path / name).write_text(text)
    return tmp_path / name


def _same(found):
    assert found.angular_frequency == pytest.approx(OMEGA, rel=1e-6)
    assert found.storage_shear == pytest.approx(STORAGE, rel=1e-6)
    assert found.loss_shear == pytest.approx(LOSS, rel=1e-6)


@pytest.mark.parametrize("names", ["Freq\tG'\tG\"", '"Freq"\t"G\'"\t"G\'\'"', "Freq\t'G_stor'\t'G_loss'"])
def test_primes_at_the_end_of_a_name_are_no_quotes(tmp_path, names):
    """Between tabs G' and G'' lost their primes, and were one name."""
    rows = ROWS.replace(" ", "\t")
    _same(read_dynamic(_file(tmp_path, f"T=-10;Mw=1131;\n{names}\nrad/s\tPa\tPa\n{rows}\n")))


def test_a_stated_header_stands_for_that_of_the_file(tmp_path):
    """Public data of polymers are three columns without a name; the only way was to edit each file."""
    file = _file(tmp_path, f"T=140;Mw=116000\n{ROWS}\n")
    _same(read_dynamic(file, header="omega [rad/s], g' [Pa], g'' [Pa]"))
    hertz = read_dynamic(file, header="f [Hz], g' [kPa], g'' [kPa]")
    assert hertz.angular_frequency == pytest.approx(2.0 * math.pi * OMEGA, rel=1e-6)
    assert hertz.storage_shear == pytest.approx(1e3 * STORAGE, rel=1e-6)
    assert read_relaxation(file, header="t [s], g [Pa]").shear == pytest.approx(STORAGE, rel=1e-6)
    assert read_creep(file, header="t [s], j [1/MPa]").compliance == pytest.approx(1e-6 * STORAGE, rel=1e-6)
    warm = (
        "\n".join(f"{row} 20" for row in ROWS.splitlines()) + "\n" + "\n".join(f"{row} 40" for row in ROWS.splitlines())
    )
    swept = read_dynamic_sweeps(_file(tmp_path, warm, "s.txt"), header="omega [rad/s], g' [Pa], g'' [Pa], temp [degC]")
    assert np.unique(swept.temperature) == pytest.approx([293.15, 313.15])


def test_the_key_is_named_where_there_is_no_header(tmp_path):
    file = _file(tmp_path, ROWS)
    with pytest.raises(InvalidInput, match="or give header = "):
        read_dynamic(file)
    with pytest.raises(InvalidInput, match="no line has numbers for the columns"):
        read_dynamic(file, header="omega [rad/s], g' [Pa], x, g'' [Pa]")
    with pytest.raises(InvalidInput, match="the header has no"):
        read_dynamic(file, header="omega [rad/s], g' [Pa]")


def test_a_sheet_of_a_rheometer_is_read(tmp_path):
    """Waveforms stand below each point, and a row of other words between the names and their units."""
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.append(["1% strain"])
    sheet.append(["Point No.", "Period Time", "Frequency", "Storage Modulus", "Loss Modulus", "Storage Compliance"])
    sheet.append([None, "Waveform"])
    sheet.append([None, "[s]", "[rad/s]", "[Pa]", "[Pa]", "[1/Pa]"])
    for number, row in enumerate(zip(OMEGA, STORAGE, LOSS, strict=True), 1):
        sheet.append([number, 0.0, *map(float, row), 1e-5])
        sheet.append([None, 0.002])
    book.save(tmp_path / "sweep.xlsx")
    _same(read_dynamic(tmp_path / "sweep.xlsx"))


def test_a_sheet_of_heights_is_a_map(tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    for y in range(5):
        book.active.append([float(x * y) for x in range(6)])
    book.save(tmp_path / "map.xlsx")
    found = read_topography(tmp_path / "map.xlsx", unit="nm", lengths=(1e-6, 1e-6))
    assert found.heights == pytest.approx(1e-9 * np.outer(np.arange(5.0), np.arange(6.0)))


def test_what_was_measured_twice_is_averaged_where_it_agrees(tmp_path):
    """Master curves of public polymers have frequencies of two sweeps; an amplitude sweep at one frequency is none."""
    rows = [f"{w},{a * f},{b * f}" for w, a, b in zip(OMEGA, STORAGE, LOSS, strict=True) for f in (0.95, 1.05)]
    file = _file(tmp_path, "omega [rad/s],G' [Pa],G'' [Pa]\n" + "\n".join(rows))
    _same(read_dynamic(file))
    other = file.read_text() + f"\n{OMEGA[2]},{0.5 * STORAGE[2]},{LOSS[2]}\n"
    with pytest.raises(InvalidInput, match="does not rise"):
        read_dynamic(_file(tmp_path, other, "strained.txt"))


def test_a_row_at_the_step_itself_is_left_out(tmp_path):
    time = np.array([0.0, 0.1, 1.0, 10.0, 100.0])
    table = "\n".join(f"{t},{2.0 + t}" for t in time)
    found = read_relaxation(_file(tmp_path, "t [s],g [Pa]\n" + table))
    assert found.time == pytest.approx(time[1:])
    assert found.shear == pytest.approx(2.0 + time[1:])
    crept = read_creep(_file(tmp_path, "t [s],j [1/Pa]\n" + table))
    assert crept.compliance == pytest.approx(2.0 + time[1:])
    with pytest.raises(InvalidInput, match="angular_frequency is 0"):
        read_dynamic(_file(tmp_path, "omega [rad/s],G' [Pa],G'' [Pa]\n" + "\n".join(f"{t},1,1" for t in time)))


def test_the_reason_is_that_of_the_unit_of_the_file(tmp_path):
    file = _file(tmp_path, "Freq\tG'\tG\"\tTemp\nrad/s\tPa\tPa\tC\n 1 2 3\n 2 3 4\n")
    with pytest.raises(InvalidInput, match=r"line 3: the line has 1 and the header 4 cells; or give header = "):
        read_dynamic(file)


def test_half_a_letter_at_the_end(tmp_path):
    """A program that ends lines anew leaves one byte of the last line's end; no letter is lost with it."""
    file = tmp_path / "solid.csv"
    text = "omega [rad/s]\tstorage [Pa]\tloss [Pa]\n" + "".join(f"{2**k}\t{k + 1},5\t{k + 2}\n" for k in range(5))
    file.write_bytes(text.encode("utf-16")[:-1])
    assert read_dynamic(str(file)).storage_shear.tolist() == [k + 1.5 for k in range(5)]
    file.write_bytes(text[:-1].encode("utf-16")[:-1])  # half of the last digit is no end of a line
    with pytest.raises(InvalidInput, match="damaged UTF-16"):
        read_dynamic(str(file))


@pytest.mark.parametrize("decimal", [".", ","])
def test_sweeps_below_each_other_that_begin_again(tmp_path, decimal):
    """Forty sweeps of one laboratory: 'time does not rise ... average what is given twice' named no way out."""
    omega = np.geomspace(0.1, 100.0, 12)
    sweeps = [np.c_[omega, number * (2.0 + omega), number * omega] for number in (1.0, 2.0, 5.0)]
    rows = "\n".join("\t".join(f"{one:.6g}" for one in row) for row in np.concatenate(sweeps)).replace(".", decimal)
    file = tmp_path / "sweeps.txt"
    file.write_text(f"omega [rad/s]\tG' [Pa]\tG'' [Pa]\n{rows}\n", encoding="utf-8")
    with pytest.raises(InvalidInput, match=r"it holds 3 tests \(1: lines 2 to 13; .*give one, as in test = 1"):
        read_dynamic(file)
    assert read_dynamic(file, test=3).loss_shear == pytest.approx(5.0 * omega, rel=1e-5)


def test_names_of_malvern(tmp_path):
    head = "Action Name;Frequency(Hz);Shear modulus (elastic component)(Pa);Shear modulus (viscous component)(Pa)"
    omega = np.geomspace(0.1, 10.0, 8)
    rows = "\n".join(f"Sweep;{f:.6g};{2.0 + f:.6g};{f:.6g}".replace(".", ",") for f in omega)
    (tmp_path / "malvern.csv").write_text(f"{head}\n{rows}\n", encoding="utf-8")
    found = read_dynamic(tmp_path / "malvern.csv")
    assert found.angular_frequency == pytest.approx(2.0 * np.pi * omega, rel=1e-5)
    assert found.loss_shear == pytest.approx(omega, rel=1e-5)
