"""Sweeps over temperature read from one table or several, in shear or tension, in degC or K."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.values.errors import InvalidInput

ROWS = "-10, 1, 3, 0.6\n-10, 10, 6, 1.2\n20, 1, 1.5, 0.3\n20, 10, 3, 0.6\n"


def test_a_table_in_degrees_celsius_and_hertz(tmp_path):
    file = tmp_path / "rubber.csv"
    file.write_text("temperature [degC], frequency [Hz], storage [MPa], loss [MPa]\n" + ROWS, encoding="utf-8")
    found = wk.read_dynamic_sweeps(file)
    assert found.temperature == pytest.approx([263.15, 263.15, 293.15, 293.15], rel=1e-15)
    assert found.angular_frequency == pytest.approx(2.0 * np.pi * np.array([1.0, 10.0, 1.0, 10.0]), rel=1e-15)
    assert found.storage_shear == pytest.approx([3e6, 6e6, 1.5e6, 3e6], rel=1e-15)
    assert found.loss_shear == pytest.approx([0.6e6, 1.2e6, 0.3e6, 0.6e6], rel=1e-15)


def test_tension_is_converted_by_poissons_ratio_and_kelvin_stay(tmp_path):
    file = tmp_path / "dma.csv"
    rows = ROWS.replace("-10", "263")
    header = "temperature [K], omega [rad/s], tensile_storage [MPa], tensile_loss [MPa]\n"
    file.write_text(header + rows, encoding="utf-8")
    found = wk.read_dynamic_sweeps(file, poisson=0.4)
    assert found.temperature[:2] == pytest.approx([263.0, 263.0])
    assert found.angular_frequency[1] == 10.0
    assert found.storage_shear[0] == pytest.approx(3e6 / 2.8, rel=1e-15)
    assert found.poisson == 0.4


def test_a_pattern_reads_several_files(tmp_path):
    for number, celsius in enumerate((0, 30)):
        lines = "".join(f"{celsius}, {t}, {2.0 / t}\n" for t in (1, 2, 4))
        text = "temperature [°C], time [s], shear [kPa]\n" + lines
        (tmp_path / f"gel_{number}.csv").write_text(text, encoding="utf-8")
    found = wk.read_relaxation_sweeps(tmp_path / "gel_*.csv")
    assert found.temperature == pytest.approx([273.15] * 3 + [303.15] * 3)
    assert found.time == pytest.approx([1.0, 2.0, 4.0] * 2)
    assert found.shear == pytest.approx([2e3, 1e3, 500.0] * 2)


@pytest.mark.parametrize(
    ("header", "sentence"),
    [
        ("frequency [Hz], storage [MPa], loss [MPa]", "temperature"),
        ("temperature [MPa], frequency [Hz], storage [MPa], loss [MPa]", "temperature"),
        ("temperature [degC], frequency [degC], storage [MPa], loss [MPa]", "frequency"),
    ],
)
def test_what_is_no_table_of_sweeps_is_refused(tmp_path, header, sentence):
    file = tmp_path / "wrong.csv"
    file.write_text(header + "\n" + ROWS, encoding="utf-8")
    with pytest.raises(wk.InvalidInput, match=sentence):
        wk.read_dynamic_sweeps(file)


def test_a_pattern_without_files_is_refused(tmp_path):
    with pytest.raises(wk.InvalidInput, match="no file matches the pattern"):
        wk.read_relaxation_sweeps(tmp_path / "none_*.csv")


def test_temperatures_below_zero_kelvin_are_refused(tmp_path):
    file = tmp_path / "cold.csv"
    text = "temperature [degC], frequency [Hz], storage [MPa], loss [MPa]\n" + ROWS.replace("-10", "-300")
    file.write_text(text, encoding="utf-8")
    with pytest.raises(wk.InvalidInput, match="temperature is -26"):
        wk.read_dynamic_sweeps(file)


def test_rows_whose_moduli_are_not_positive_are_left_out_and_named(tmp_path):
    """Noise makes a small loss negative; more than a fifth of such rows are no noise."""
    omega = np.tile(np.geomspace(0.1, 100.0, 10), 2)
    rows = np.c_[np.repeat([20.0, 40.0], 10), omega, 2.0 + omega, 0.1 * omega]
    rows[3, 3], rows[12, 2] = -0.2, 0.0
    file = tmp_path / "noisy.csv"
    np.savetxt(file, rows, delimiter=",", header="temperature [degC],omega [rad/s],G' [Pa],G'' [Pa]", comments="")
    found = wk.read_dynamic_sweeps(file)
    assert found.angular_frequency == pytest.approx(np.delete(omega, [3, 12]))
    assert found.reading == "noisy.csv: 2 rows (line 5, 14) left out, whose storage or loss is not positive"
    np.savetxt(file, rows[:10, 1:], delimiter=",", header="omega [rad/s],G' [Pa],G'' [Pa]", comments="")
    alone = wk.read_dynamic(file)
    assert alone.loss_shear == pytest.approx(np.delete(rows[:10, 3], 3))
    assert "1 row (line 5) left out" in alone.reading
    rows[:5, 3], rows[12, 2] = -0.2, 1.0
    np.savetxt(file, rows, delimiter=",", header="temperature [degC],omega [rad/s],G' [Pa],G'' [Pa]", comments="")
    with pytest.raises(InvalidInput, match="loss_shear is -0.2 at index 0"):
        wk.read_dynamic_sweeps(file)
