"""What files are taken for, what is doubtful of them, and the studies to start from."""

from __future__ import annotations

import numpy as np
import pytest
from made_files import DATA, made_files, table

from winkler.cli import main
from winkler.errors import InvalidInput
from winkler.study.inspection import inspect
from winkler.study.inspection.inspect import inspect_file, inspect_files


def test_each_kind_is_recognised(tmp_path):
    files = made_files(tmp_path)
    assert {path.name: inspect_file(path, brief=True).taken_for for path in files} == {
        path.name: kind for path, kind in files.items()
    }


def test_each_recognised_kind_has_columns_with_units(tmp_path):
    for path in made_files(tmp_path):
        found = inspect_file(path, brief=True)
        assert found.columns, path
        for column in found.columns:
            assert column.meaning, (path, column.name)
            assert column.low <= column.high, (path, column.name)
            assert 3 <= len(column.sparkline) <= 32, (path, column.name)
    pressed = inspect_file(tmp_path / "path.csv")
    assert [column.name for column in pressed.columns] == ["time", "force", "shift"]
    shift = pressed.column("shift")
    assert (shift.unit, shift.low, shift.high) == ("m", pytest.approx(-1e-6, rel=1e-2), pytest.approx(1e-6, rel=1e-2))


KINDS = (
    "moduli.csv", "sweeps.csv", "relaxing.csv", "creeping.csv", "relaxing_sweeps.csv", "density.csv", "path.csv",
    "twist.csv", "pressures.csv", "graded.csv", "bed.csv", "body.csv", "scan.csv", "map.npz", "rail_head.prr",
    "wheel_tread.csv", "gel_bead.csv", "steel_1.csv",
)  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("name", KINDS)
def test_each_study_to_start_from_runs_as_it_is(name, tmp_path, capsys):
    path = next(one for one in made_files(tmp_path) if one.name == name)
    study = tmp_path / "studies" / "study.toml"
    study.parent.mkdir()
    assert main(["show", str(path), "--write", str(study)]) == 0
    command = capsys.readouterr().out.rpartition("run it with: winkler ")[2].split()
    assert main([*command, "--output", str(tmp_path / "results"), "--quiet"]) == 0
    assert (tmp_path / "results").is_dir()
    assert main(["show", str(path), "--write", str(study)]) == 2
    assert f"show: '{study}' exists; add --overwrite to replace it" in capsys.readouterr().err


def test_only_area_functions_and_single_holds_have_no_study(tmp_path):
    without = [path.name for path in made_files(tmp_path) if not inspect_file(path, brief=True).study]
    assert without == ["tip_area.csv", "narrow.csv"]


def _curve(tmp_path, force):
    x = np.linspace(-500.0, 500.0, 400)
    time = np.linspace(0.0, 1.0, 400)
    return table(tmp_path / "curve.csv", "time [s], depth [nm], force [nN]", time, x, force(x))


def _hertz(x):
    return 1e-3 * np.maximum(x, 0.0) ** 1.5 + 0.02 * np.random.default_rng(2).normal(size=x.size)


def test_a_good_curve_has_no_doubts_and_its_events(tmp_path):
    found = inspect_file(_curve(tmp_path, _hertz))
    assert found.taken_for == "force curve"
    assert "depth from 'depth [nm]'" in found.reason
    assert found.doubts == ()
    assert any("baseline before contact" in line for line in found.done)


@pytest.mark.parametrize(
    ("spoil", "sentence"),
    [
        (lambda x: -_hertz(x), "compressive where"),
        (lambda x: np.where(np.arange(x.size) == 123, 300.0, _hertz(x)), "force: 1 single number far from both"),
        (lambda x: np.where(np.arange(x.size) % 90 == 3, -9999.0, _hertz(x)), "force: 5 of 400 numbers are"),
        (lambda x: _hertz(x - 600.0), "no contact"),
    ],
    ids=["sign", "spike", "mark", "nothing"],
)
def test_what_is_doubtful_of_a_curve(spoil, sentence, tmp_path):
    doubts = " ".join(inspect_file(_curve(tmp_path, spoil), brief=True).doubts)
    assert sentence in doubts or (sentence.startswith("compressive") and "change the sign" in doubts)


def test_a_nanoindentation_needs_no_baseline():
    found = inspect_file(DATA / "nanoindentation" / "silica_1.csv", brief=True)
    assert found.taken_for == "nanoindentation"
    assert found.doubts == ()


def test_a_file_that_cannot_be_read_says_what_its_reader_needs(tmp_path):
    path = table(tmp_path / "piezo.csv", "piezo [nm], deflection [nm]", np.arange(20.0), np.arange(20.0))
    found = inspect_file(path)
    assert not found.is_read
    assert "give spring_constant in N/m" in found.reason
    rows = np.column_stack((np.arange(30.0), np.cos(np.arange(30.0))))
    np.savetxt(tmp_path / "bare.txt", rows)
    assert "give its unit" in inspect_file(tmp_path / "bare.txt").reason
    scan = table(tmp_path / "scan.csv", "X_(microns),y1", *rows.T)
    assert "force curve" not in inspect_file(scan).reason
    assert "unit" in inspect_file(scan).reason
    with pytest.raises(InvalidInput, match="there is no such file"):
        inspect_file(tmp_path / "absent.csv")


def test_what_its_header_calls_a_curve_is_given_to_no_reader_of_surfaces(tmp_path, monkeypatch):
    """They took 3 s to load, and 40 ms to refuse each of the curves of a folder."""
    monkeypatch.setattr(inspect, "read_surface_file", lambda *_: pytest.fail("a reader of surfaces was tried"))
    path = table(tmp_path / "piezo.csv", "piezo [nm], force [nN]", np.arange(20.0), np.arange(20.0))
    found = inspect_file(path)
    assert not found.is_read
    assert found.reason.startswith(f"{path}: read as force curve: ")
    assert "give spring_constant in N/m" in found.reason


def test_files_in_toml_are_calibrated_indenters_or_studies(tmp_path):
    tip = tmp_path / "tip.toml"
    tip.write_text(
        'kind = "calibrated_indenter"\narea = [24.5, 1e-7]\nframe_compliance = 1e-7\nyoung = 1.141e12\npoisson = 0.07\n'
    )
    found = inspect_file(tip)
    assert found.taken_for == "calibrated indenter"
    assert found.done == ("area coefficients 24.5, 1e-07 (SI)", "frame compliance 100 nm/N")
    tip.write_text('[problem]\nkind = "indentation"\n')
    assert not inspect_file(tip).is_read
    assert "if it is a study, `winkler run`" in inspect_file(tip).reason


def test_a_list_reads_what_it_can(tmp_path):
    good = _curve(tmp_path, _hertz)
    bad = tmp_path / "bad.csv"
    bad.write_text("no numbers at all\n")
    found = dict(inspect_files([good, bad, tmp_path / "absent.csv"], 60.0))
    assert [found[place].taken_for for place in range(3)] == ["force curve", "", ""]
    assert found[2].reason.startswith("it cannot be read")
    assert len(dict(inspect_files([good] * 5, -1.0))) == 1


@pytest.mark.slow
def test_many_files_are_read_by_several_processes(tmp_path):
    good = _curve(tmp_path, _hertz)
    found = dict(inspect_files([good] * 120, 600.0))
    assert sorted(found) == list(range(120))
    assert {one.taken_for for one in found.values()} == {"force curve"}
