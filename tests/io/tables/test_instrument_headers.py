"""Headers of rheometers and dynamic mechanical analysers, in their own words."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.io.curves import read_curve
from winkler.values.errors import InvalidInput

ROWS = ((0.1, 10.0, 1.0), (1.0, 12.0, 1.5), (10.0, 15.0, 2.0), (100.0, 19.0, 3.0))
SHEAR, TENSION = 1.0, 3.0
TURN = 2.0 * np.pi
HEADERS = {
    "trios": ("Frequency,Storage Modulus,Loss Modulus\nHz,MPa,MPa", ",", TURN, 1e6, SHEAR),
    "rheocompass": ("Angular Frequency\tStorage Modulus\tLoss Modulus\n[rad/s]\t[Pa]\t[Pa]", "\t", 1.0, 1.0, SHEAR),
    "oscillation": ("Freq\tG'\tG\"\nrad/s\tPa\tPa", "\t", 1.0, 1.0, SHEAR),
    "pyvisco": ("f, E_stor, E_loss\nHz, MPa, MPa", ",", TURN, 1e6, TENSION),
    "letter": ("w (rad/s),G' (Pa),G'' (Pa)", ",", 1.0, 1.0, SHEAR),
    "short": ("Ang. freq.\tStorage modulus\tLoss modulus\nrad/s\tMPa\tMPa", "\t", 1.0, 1e6, SHEAR),
    "empty_row": ("Frequency,Storage Modulus,Loss Modulus\n,,\n[Hz],[kPa],[kPa]", ",", TURN, 1e3, SHEAR),
    "program": ("run_1,freq_hz,G_storage_pa,G_loss_pa", ",", TURN, 1.0, SHEAR),
    "tension": ("run_1,omega_rad_s,E_storage_kpa,E_loss_kpa", ",", 1.0, 1e3, TENSION),
    "words": ("w_rad_per_s;g_storage_mega_Pa;g_loss_mega_Pa", ";", 1.0, 1e6, SHEAR),
    "rheowin": ("f en Hz;G' en Pa;G\" en Pa", ";", TURN, 1.0, SHEAR),
    "comma": ("Freq. (Hz);Storage modulus (MPa);Loss modulus (MPa)", ";", TURN, 1e6, SHEAR),
}


@pytest.mark.parametrize("name", HEADERS)
def test_storage_and_loss(tmp_path, name):
    """Of eleven headers two were read; the row of units was shown as the header."""
    header, separator, angular, unit, divisor = HEADERS[name]
    rows = [separator.join(f"{x:g}" if name != "comma" else f"{x:.2f}".replace(".", ",") for x in row) for row in ROWS]
    if header.startswith("run"):
        rows = [f"7{separator}{row}" for row in rows]
    path = tmp_path / "dma.txt"
    path.write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
    found = wk.read_dynamic(path)
    frequency, storage, loss = np.array(ROWS).T
    assert found.angular_frequency == pytest.approx(angular * frequency, rel=1e-12)
    assert found.storage_shear == pytest.approx(unit / divisor * storage, rel=1e-12)
    assert found.loss_shear == pytest.approx(unit / divisor * loss, rel=1e-12)


@pytest.mark.parametrize(
    ("header", "second", "loss"),
    [
        ("Frequency (Hz),E' (MPa),tan delta", 0.1, lambda size: (size, 0.1 * size)),
        ("Frequency (Hz),E* (MPa),Phase angle (deg)", 30.0, lambda size: (size * 0.75**0.5, size * 0.5)),
    ],
)
def test_the_loss_by_its_factor_or_by_an_angle(tmp_path, header, second, loss):
    path = tmp_path / "dma.csv"
    path.write_text("\n".join([header, *(f"{f:g},{s:g},{second:g}" for f, s, _ in ROWS)]) + "\n", encoding="utf-8")
    found = wk.read_dynamic(path)
    storage, lost = loss(1e6 / 3.0 * np.array(ROWS).T[1])
    assert found.storage_shear == pytest.approx(storage, rel=1e-12)
    assert found.loss_shear == pytest.approx(lost, rel=1e-12)


def test_t_is_a_temperature_where_there_is_no_time(tmp_path):
    path = tmp_path / "sweeps.txt"
    rows = "\n".join(f"{t}\t{f}\t{s}\t1" for t, f, s in ((20, 1, 10), (20, 10, 11), (40, 1, 8), (40, 10, 9)))
    path.write_text(f"T\tf\tE'\tE''\n°C\tHz\tMPa\tMPa\n{rows}\n", encoding="utf-8")
    found = wk.read_dynamic_sweeps(path)
    assert found.temperature == pytest.approx([293.15, 293.15, 313.15, 313.15])
    assert found.storage_shear == pytest.approx(1e6 / 3.0 * np.array([10.0, 11.0, 8.0, 9.0]))


def test_relaxation_and_creep_by_their_whole_names(tmp_path):
    path = tmp_path / "l.csv"
    path.write_text("Step time (s),Relaxation Modulus (MPa)\n0.1,10\n1,9\n10,8\n100,7\n", encoding="utf-8")
    assert wk.read_relaxation(path).shear == pytest.approx([1e7, 9e6, 8e6, 7e6])
    path.write_text("Time (s),Creep compliance (1/Pa)\n0.1,1e-6\n1,2e-6\n10,3e-6\n100,4e-6\n", encoding="utf-8")
    assert wk.read_creep(path).compliance == pytest.approx([1e-6, 2e-6, 3e-6, 4e-6])


def test_a_refusal_shows_the_row_of_names(tmp_path):
    """'the header has no frequency, there are 'Hz', 'MPa'' showed the row of units."""
    path = tmp_path / "dma.csv"
    path.write_text("Sample,Stiffnes,Damp\n[Hz],[MPa],[MPa]\n1,2,3\n", encoding="utf-8")
    with pytest.raises(InvalidInput, match="there are 'Sample', 'Stiffnes', 'Damp'"):
        wk.read_dynamic(path)


@pytest.mark.parametrize(("name", "sign"), [("Gap", -1.0), ("Position", 1.0)])
def test_a_ball_on_the_plate_of_a_rheometer(tmp_path, name, sign):
    """Names, an empty row, and units below; a gap falls as the ball approaches: position = -gap."""
    travel = np.r_[np.linspace(-5.0, 0.5, 200), np.linspace(0.5, -5.0, 200)[1:]]
    force = 2.0 * np.maximum(travel, 0.0) ** 1.5
    rows = [f",{n + 1},{f:.6g},{sign * x:.6g},{0.05 * n:g}" for n, (x, f) in enumerate(zip(travel, force, strict=True))]
    above = ["Project:,made,,,", ",,,,", "Interval and data points:,1,399,,"]
    names = f"Interval data:,Point No.,Normal Force,{name},Time"
    path = tmp_path / "ball.csv"
    path.write_text("\n".join([*above, names, ",,,,", ",,[N],[mm],[s]", *rows]) + "\n", encoding="utf-8")
    with pytest.raises(InvalidInput, match="give spring_constant in N/m"):
        read_curve(path)
    curve = read_curve(path, spring_constant=np.inf)
    assert curve.position == pytest.approx(1e-3 * travel, abs=1e-8)
    assert curve.force == pytest.approx(force, abs=1e-5)
    assert curve.direction[50] == 1.0
    assert curve.direction[-50] == -1.0


def test_small_letters_that_may_be_two_units_are_none(tmp_path):
    path = tmp_path / "dma.csv"
    rows = "\n".join(",".join(f"{x:g}" for x in row) for row in ROWS)
    path.write_text(f"freq_hz,G_storage_mpa,G_loss_mpa\n{rows}\n", encoding="utf-8")
    with pytest.raises(InvalidInput, match="mpa"):
        wk.read_dynamic(path)


def test_of_a_time_and_a_temperature_the_unit_tells(tmp_path):
    """RheoWin in French: ``t en s``, ``t_seg en s`` and ``T en °C`` stand beside each other."""
    path = tmp_path / "sweep.txt"
    rows = [f"{10 * k};{k};{f};{t};{s};{v}" for k, (f, s, v) in enumerate(ROWS) for t in (20, 40)]
    text = "\n".join(["t en s;t_seg en s;f en Hz;T en °C;G' en Pa;G\" en Pa", *sorted(rows)])
    path.write_bytes(text.encode("latin-1"))
    found = wk.read_dynamic_sweeps(path)
    assert sorted(set(found.temperature)) == pytest.approx([293.15, 313.15])
    assert found.storage_shear.size == 8


CURVE_HEADERS = {
    "french": ('"Temps","Course standard","Force standard"\n"s","mm","N"', "latin-1"),
    "chinese": ('"时间","位移","力"\n"(s)","(mm)","(N)"', "gb2312"),
    "chinese in utf-8": ("时间 (s),位移 (mm),载荷 (N)", "utf-8"),
    "spanish": ("tiempo [s],recorrido estándar [mm],fuerza estándar [N]", "latin-1"),
}


@pytest.mark.parametrize("name", CURVE_HEADERS)
def test_curves_of_testing_machines_in_other_languages(tmp_path, name):
    header, encoding = CURVE_HEADERS[name]
    depth = np.linspace(0.0, 2.0, 41)
    path = tmp_path / "curve.csv"
    rows = "\n".join(f"{k:g},{d:g},{d**1.5:.9g}" for k, d in enumerate(depth))
    path.write_bytes(f"{header}\n{rows}\n".encode(encoding))
    curve = read_curve(path, spring_constant=np.inf)
    assert curve.position == pytest.approx(1e-3 * depth, rel=1e-12)
    assert curve.force == pytest.approx(depth**1.5, rel=1e-8)
    assert curve.time[-1] == 40.0


@pytest.mark.parametrize("text", ["Kraft für Prüfung [µN]", "Éé è ± µ°", "Größe [µm], Fläche [mm²]", "ÄÖÜ ßäöü"])
def test_letters_of_latin_1_stay(tmp_path, text):
    """Two letters beyond ASCII beside each other are no Chinese one while others stand alone."""
    from winkler.io.text_file import lines_of

    path = tmp_path / "latin.txt"
    path.write_bytes(f"{text}\n1 2".encode("latin-1"))
    assert lines_of(path, "text")[0] == text


WAYS = ("{name} [{unit}]", "{name} ({unit})", "{name} in {unit}", "{name} en {unit}", "{name}, {unit}", "{name}_{unit}")
"""How a name and its unit stand together."""


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize(("unit", "factor"), [("uN", 1e-6), ("mN", 1e-3), ("N", 1.0)])
def test_the_number_stays_however_its_unit_is_written(tmp_path, way, unit, factor):
    depth, path = np.linspace(0.0, 50.0, 26), tmp_path / "curve.csv"
    rows = [f"{d:g};{d**1.5:.9g}" for d in depth]
    head = ";".join((way.format(name="depth", unit="nm"), way.format(name="load", unit=unit)))
    path.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    curve = read_curve(path)
    assert curve.position == pytest.approx(1e-9 * depth, rel=1e-12)
    assert curve.force == pytest.approx(factor * depth**1.5, rel=1e-8)
    words = {"uN": "micro_N", "mN": "milli_N", "N": "N"}
    path.write_text("\n".join([f"depth_nano_m;load_{words[unit]}", *rows]) + "\n", encoding="utf-8")
    assert np.array_equal(read_curve(path).force, curve.force)
