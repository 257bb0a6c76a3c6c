"""``winkler show MAP``: statistics, what to know of a map, and its picture."""

from __future__ import annotations

import json

import numpy as np
import pytest

from winkler.cli import main


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    x = np.arange(64) / 64
    z = 100.0 * np.cos(6.0 * np.pi * x)[:, None] + 100.0 * np.cos(8.0 * np.pi * x)
    np.save("waves.npy", z)
    tilted = z + 4000.0 * x[:, None]
    tilted[20, 30] += 3000.0
    tilted[3, 3] = np.nan
    np.savetxt("tilted.txt", tilted)
    np.savetxt("scan.csv", np.column_stack((x * 100.0, z[:, 0])), delimiter=",", header="x [um], z [nm]", comments="")
    return tmp_path


@pytest.mark.slow
def test_a_map_as_json(here, capsys):
    """Two crossed waves of amplitude A: Sq = A, Sku = 9/4."""
    command = ["show", "waves.npy", "--unit", "nm", "--lengths", "10 um", "--periodic", "--json", "-o", "waves.png"]
    assert main(command) == 0
    found = json.loads(capsys.readouterr().out)
    numbers = {name: row["value"] for name, row in found["statistics"].items()}
    assert numbers["rms_height"] == pytest.approx(100e-9, rel=1e-12)
    assert numbers["kurtosis"] == pytest.approx(2.25, rel=1e-9)
    assert "tip_limit" not in numbers
    assert found["remarks"] == []
    assert (here / "waves.png").read_bytes().startswith(b"\x89PNG")
    assert main(command) == 2
    assert "'waves.png' exists; add --overwrite" in capsys.readouterr().err


def test_a_bad_map_says_so(here, capsys):
    assert main(["show", "tilted.txt", "--unit", "nm", "--lengths", "10 um, 10 um", "--tip-radius", "1 mm"]) == 0
    text = capsys.readouterr().out
    assert "Missing: 1 of 4096 heights." in text
    assert "--detrend plane subtracts it." in text
    assert "--without-spikes removes them." in text
    assert "a tip of 0.001 m has rounded the map" in text
    options = ["--unit", "nm", "--lengths", "10 um", "--detrend", "plane", "--without-spikes"]
    assert main(["show", "tilted.txt", *options]) == 0
    clean = capsys.readouterr().out
    assert "- Removed from the measured heights, and bridged: 1 of 4096 pixels" in clean
    assert "Missing" not in clean
    assert "takes" not in clean


@pytest.mark.slow
def test_a_scan(here, capsys):
    assert main(["show", "scan.csv", "-o", "scan.svg"]) == 0
    text = capsys.readouterr().out
    assert "Rq" in text
    assert "Sal" not in text
    assert (here / "scan.svg").exists()


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["sphere", "--levelled", "median"], "'sphere' is not the path of a file, which has a dot or a slash"),
        (["nothing.npy"], "nothing.npy: there is no such file in '.'; give the path of a measured file."),
        (["waves.npy"], "waves.npy: the file does not state the unit of its heights; give unit, such as 'nm' or 'um'."),
        (["waves.npy", "-o", "waves.toml"], "show: 'waves.toml' does not end like a picture; give .svg, .png, .pdf."),
        (["waves.npy", "--lengths", "1 um, 2 um, 3 um"], "--lengths are '1 um, 2 um, 3 um'; give one or two"),
        (["waves.npy", "--unit", "nm", "--lengths", "1 s"], "--lengths: '1 s' is a time, not a length"),
        (["scan.csv", "--unit", "um"], "scan.csv: a table states its columns and their units; leave unit 'um' out."),
        (["waves.npy", "--unit", "nm", "--lengths", "1 um", "--detrend", "cone"], "detrend is 'cone'"),
    ],
)
def test_what_cannot_be_shown(arguments, sentence, here, capsys):
    assert main(["show", *arguments]) == 2
    error = capsys.readouterr().err
    assert sentence in error
    assert error.count("\n") == 1


def test_a_curve_with_what_was_done(here, capsys):
    place = np.linspace(-500.0, 500.0, 300)
    force = 1e-3 * np.maximum(place, 0.0) ** 1.5 + 0.02 * np.cos(40.0 * place)
    np.savetxt(
        "curve.csv", np.column_stack((place, force)), delimiter=",", header="depth [nm], force [nN]", comments=""
    )
    assert main(["show", "curve.csv"]) == 0
    text = capsys.readouterr().out
    assert "curve.csv: force curve" in text
    assert "depth from 'depth [nm]', force from 'force [nN]'" in text
    assert "-500 nm to 500 nm".replace("-", "\u2212") in text
    assert "baseline before contact" in text
    assert "--write STUDY.toml" in text
    assert main(["show", "curve.csv", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["taken_for"] == "force curve"
    assert [(one["name"], one["unit"], one["count"]) for one in found["columns"]] == [
        ("position", "m", 300), ("force", "N", 300),
    ]  # fmt: skip
    assert main(["show", "curve.csv", "scan.csv", "tilted.txt", "--json"]) == 0
    several = json.loads(capsys.readouterr().out)
    assert [one["taken_for"] for one in several["files"]] == ["force curve", "line scan", ""]
    assert several["not_read"] == 0


def test_a_folder_is_a_list_and_makes_one_study(here, capsys):
    (here / "gel").mkdir()
    place = np.linspace(-500.0, 500.0, 100)
    for number in range(3):
        rows = np.column_stack((place, (1.0 + number) * 1e-3 * np.maximum(place, 0.0) ** 1.5))
        np.savetxt(f"gel/{number}.csv", rows, delimiter=",", header="depth [nm], force [nN]", comments="")
    assert main(["show", "gel", "--write", "gel.toml"]) == 0
    assert "3 files: 3 force curve." in capsys.readouterr().out
    assert 'curve = "gel"' in (here / "gel.toml").read_text()
    assert main(["show", "gel", "--unit", "nm"]) == 2
    assert "several files make a list" in capsys.readouterr().err
    (here / "empty").mkdir()
    assert main(["show", "empty"]) == 2
    assert "the folder holds no files" in capsys.readouterr().err
    assert main(["show", ".", "--write", "all.toml"]) == 2
    assert "a study of a folder evaluates curves of one kind, and . holds" in capsys.readouterr().err
    assert main(["show", "scan.csv", "--write", "study.txt"]) == 2
    assert "a study ends in .toml" in capsys.readouterr().err
