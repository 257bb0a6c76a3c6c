"""Studies with pop-ins, with continuously measured stiffness, and stopped by Ctrl-C."""

from __future__ import annotations

import csv
import json
import math
import os
import shutil
import signal
from pathlib import Path

import numpy as np
import pytest

from winkler.cli import main
from winkler.study.nanoindentation import report, running
from winkler.study.nanoindentation.reading import read_nanoindentation_study

DATA = Path(__file__).resolve().parents[3] / "examples" / "data" / "nanoindentation"
TIP = "\n[indenter]\narea = [24.5]\n"
QUIET = "[output]\nfigures = []\nreport = false\n"
TIP_SLOPE = (1.0 - 0.07**2) / 1141e9
MODULUS = 1.0 / ((1.0 - 0.3**2) / 200e9 + TIP_SLOPE)
RADIUS = 200e-9


def table(path, heads, *columns):
    rows = [",".join(heads), *(",".join(f"{x:.9g}" for x in row) for row in zip(*columns, strict=True))]
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")


def rows_of(path):
    with path.open(encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def popped(path, yielded, seed):
    """Hertz up to first yield, a step of 15 nm, a plastic loading to 1 mN, and an unloading of m = 1.5."""
    random = np.random.default_rng(seed)
    before = np.linspace(-20e-9, 0.0, 60)
    elastic = np.linspace(0.0, yielded, 150)[1:]
    deep = (0.75 * elastic / (MODULUS * math.sqrt(RADIUS))) ** (2.0 / 3.0)
    after = np.linspace(yielded, 1e-3, 400)[1:]
    size = np.sqrt(after / 5e9 / 24.5)
    offset = deep[-1] + 15e-9 - size[0]
    down = 1e-3 * np.linspace(1.0, 0.05, 200)[1:]
    width = 1.5 * 1e-3 / (2.0 * MODULUS * math.sqrt(1e-3 / 5e9 / math.pi))
    end = size[-1] + offset
    out = end - width * (1.0 - (down / 1e-3) ** (2.0 / 3.0))
    depth = np.concatenate([before, deep, size + offset, out])
    force = np.concatenate([np.zeros(60), elastic, after, down])
    depth = depth + 0.1e-9 * random.standard_normal(depth.size)
    force = force + 0.1e-6 * random.standard_normal(force.size)
    table(path, ("depth [nm]", "force [uN]", "time [s]"), depth * 1e9, force * 1e6, 0.05 * np.arange(depth.size))


def study(folder, more="", end=QUIET):
    path = folder / "study.toml"
    text = f'[indentation]\ncurve = "curves/*.csv"\npoisson = 0.3\n{more}{TIP}{end}'
    path.write_text(text, encoding="utf-8")
    return str(path)


@pytest.mark.slow
def test_first_yield_of_a_batch(tmp_path, capsys):
    """tau = 0.31 (6 F E*^2/(pi^3 R^2))^(1/3) at the forces of the steps, with the modulus that the curves give."""
    (tmp_path / "curves").mkdir()
    forces = (150e-6, 180e-6, 210e-6)
    for number, yielded in enumerate(forces):
        popped(tmp_path / "curves" / f"c{number}.csv", yielded, number)
    out = tmp_path / "out"
    path = study(tmp_path, 'pop_ins = true\ntip_radius = "200 nm"\n')
    assert main(["fit", path, "--output", str(out), "--json"]) == 0
    found = [float(row["pop_in [N]"]) for row in rows_of(out / "quantities.csv")]
    assert found == pytest.approx(forces, rel=0.03)
    modulus = np.mean([float(row["modulus [Pa]"]) for row in rows_of(out / "unloadings.csv")])
    stress = [0.31 * (6.0 * force * modulus**2 / (math.pi**3 * RADIUS**2)) ** (1.0 / 3.0) for force in found]
    answer = json.loads(capsys.readouterr().out)["first_yield"]
    assert answer["curves"] == 3
    assert answer["mean_stress"] == pytest.approx(np.mean(stress), rel=1e-3)
    content = read_nanoindentation_study(Path(path))
    outcome = running.gathered(content, list(running.evaluated_files(content)), started=0.0)
    assert "<td>curves with a pop-in</td>" in report.page(outcome, ())
    assert len(rows_of(out / "first_yield.csv")) == 3


def continuous(path, seed=0, noise=0.0, stated=1.0):
    """H = 5 GPa and E = 200 GPa at every depth of a sharp tip; the instrument states E times a factor."""
    contact = np.linspace(30e-9, 500e-9, 400)
    area = 24.5 * contact**2
    random = np.random.default_rng(seed)
    force = 5e9 * area
    stiffness = 2.0 * MODULUS * np.sqrt(area / math.pi)
    depth = contact + 0.75 * force / stiffness
    stiffness = stiffness * (1.0 + noise * random.standard_normal(400))
    heads = ("depth [nm]", "force [mN]", "time [s]", "stiffness [N/m]", "Modulus [GPa]", "Hardness [GPa]")
    own = np.full(400, 200.0 * stated), np.full(400, 5.0)
    table(path, heads, depth * 1e9, force * 1e3, np.arange(400.0), stiffness, *own)


def test_continuous_stiffness_of_a_file(tmp_path, capsys):
    """A file without an unloading is evaluated, at every depth and as the mean over a window."""
    (tmp_path / "curves").mkdir()
    for seed in range(3):
        continuous(tmp_path / "curves" / f"c{seed}.csv", seed, 0.01)
    out = tmp_path / "out"
    path = study(tmp_path, 'depths = ["75 nm", "125 nm"]\nstiffness_error = 0.005\n')
    assert main(["fit", path, "--output", str(out), "--json"]) == 0
    rows = rows_of(out / "continuous.csv")
    assert len(rows) >= 1190
    found = json.loads(capsys.readouterr().out)
    assert found["failed"] == []
    for one in found["continuous"]:
        inside = [
            float(row["young [Pa]"])
            for row in rows
            if row["curve"] == one["curve"] and 75e-9 <= float(row["depth [m]"]) <= 125e-9
        ]
        assert one["points"] == len(inside) > 20
        assert one["young"] == pytest.approx(np.mean(inside), rel=1e-12)
        assert one["young_scatter"] == pytest.approx(np.std(inside, ddof=1), rel=1e-9)
        assert one["young"] == pytest.approx(200e9, abs=4.0 * one["young_scatter"] / math.sqrt(len(inside)))
        assert one["hardness"] == pytest.approx(5e9, rel=0.01)
        assert one["stated_young"] == pytest.approx(200e9)
    assert found["doubts"] == []
    assert main(["fit", path, "--output", str(tmp_path / "again")]) == 0
    said = capsys.readouterr().out
    assert "75 nm ... 125 nm" in said
    assert "mean of 3 curves" in said


def test_the_terminal_and_json_state_validity_and_each_reason(tmp_path, capsys):
    """Seven files without a curve have one reason, an eighth with a table of two rows another."""
    folder = tmp_path / "curves"
    folder.mkdir()
    continuous(folder / "c.csv")
    for number in range(7):
        (folder / f"x{number}.csv").write_text("?\n", encoding="utf-8")
    table(folder / "y.csv", ("depth [nm]", "force [mN]", "time [s]"), *3 * [np.arange(2.0)])
    assert main(["fit", study(tmp_path), "--output", str(tmp_path / "out"), "--json"]) == 2
    found = json.loads(capsys.readouterr().out)
    (evaluated,) = running.gathered(
        read_nanoindentation_study(tmp_path / "study.toml"),
        list(running.evaluated_files(read_nanoindentation_study(tmp_path / "study.toml"))),
        started=0.0,
    ).continuous
    told = [(note["standing"], note["statement"]) for note in found["validity"]]
    assert told == [(note.standing.value, note.statement) for note in evaluated.solution.validity]
    assert told
    assert main(["fit", study(tmp_path), "--output", str(tmp_path / "again")]) == 2
    said = capsys.readouterr().out
    assert "How far this can be trusted: " in said
    assert "8 of 9 curves have no answer:" in said
    for one in found["failed"]:
        assert one["reason"] in said
    assert "x5.csv and 1 more: " in said


def test_an_instrument_that_says_something_else_is_a_doubt(tmp_path, capsys):
    """Its own E of 220 GPa is no part of what is evaluated, and stands beside it."""
    (tmp_path / "curves").mkdir()
    continuous(tmp_path / "curves" / "c.csv", 1, 0.01, stated=1.1)
    assert main(["fit", study(tmp_path), "--output", str(tmp_path / "out"), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["continuous"][0]["stated_young"] == pytest.approx(220e9)
    assert found["continuous"][0]["young"] == pytest.approx(200e9, rel=0.003)
    (doubt,) = found["doubts"][0]["doubts"]
    assert "E 220 GPa, here 200 GPa" in doubt.replace("201 GPa", "200 GPa")
    assert "H" not in doubt.partition("compare")[0].replace("here", "")


def test_a_given_touch_moves_continuous_depths(tmp_path):
    """Depths that begin 40 nm early are corrected by contact_point, also without an unloading."""
    (tmp_path / "curves").mkdir()
    continuous(tmp_path / "curves" / "c.csv")
    text = (tmp_path / "curves" / "c.csv").read_text(encoding="utf-8").splitlines()
    cells = [line.split(",") for line in text[1:]]
    moved = [",".join([f"{float(first) + 40.0:.9g}", *rest]) for first, *rest in cells]
    (tmp_path / "curves" / "c.csv").write_text("\n".join([text[0], *moved]), encoding="utf-8")
    path = study(tmp_path, 'contact_point = "40 nm"\ncontact_point_error = "1 nm"\n')
    assert main(["fit", path, "--output", str(tmp_path / "out"), "--quiet"]) == 0
    young = [float(row["young [Pa]"]) for row in rows_of(tmp_path / "out" / "continuous.csv")]
    assert young == pytest.approx([200e9] * len(young), rel=1e-4)


@pytest.mark.skipif(os.name == "nt", reason="there is no SIGINT of a process alone there")
def test_ctrl_c_keeps_the_curves_that_are_done(tmp_path, monkeypatch, capsys):
    """The signal comes in the second of three curves, which is finished."""
    (tmp_path / "curves").mkdir()
    for number in range(3):
        popped(tmp_path / "curves" / f"c{number}.csv", 180e-6, number)
    plain, count = running.try_curves, []

    def stopped(path, **more):
        count.append(path)
        if len(count) == 2:
            os.kill(os.getpid(), signal.SIGINT)
        return plain(path, **more)

    monkeypatch.setattr(running, "try_curves", stopped)
    out = tmp_path / "out"
    assert main(["fit", study(tmp_path), "--output", str(out), "--quiet"]) == 130
    assert 1 <= len(rows_of(out / "quantities.csv")) < 3
    assert "files were done and are in" in capsys.readouterr().err


def test_show_and_validate_know_the_sections(tmp_path, capsys):
    assert main(["show", "nanoindentation"]) == 0
    shown = capsys.readouterr().out
    assert all(word in shown for word in ("tip_radius", "frame_stiffness", "calibration.reference", "young_error"))
    assert main(["show", "nanoindentation", "--json"]) == 0
    assert {row["key"] for row in json.loads(capsys.readouterr().out)["calibration"]} >= {"terms", "reference"}
    (tmp_path / "curves").mkdir()
    shutil.copy(DATA / "steel_1.csv", tmp_path / "curves")
    assert main(["validate", study(tmp_path)]) == 2
    assert "study.toml: a case needs source" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ('pop_in = true\ntip_radius = "1 um"\n', "has no key 'pop_in' (did you mean 'pop_ins'?)"),
        ("pop_ins = true\n", "belong together"),
        ('tip_radius = "1 um"\n', "belong together"),
        ("pop_ins = 1\n", "give true or false"),
        ('depths = ["85 nm", "75 nm"]\n', "give the lesser depth first"),
        ('depths = "80 nm"\n', "give two depths, such as"),
        ('pop_ins = true\ntip_radius = "-1 um"\n', "must be positive"),
    ],
)
def test_mistakes_get_a_sentence(tmp_path, capsys, more, words):
    (tmp_path / "curves").mkdir()
    shutil.copy(DATA / "steel_1.csv", tmp_path / "curves")
    for command in ("fit", "validate"):
        assert main([command, study(tmp_path, more)]) == 2
        assert words in capsys.readouterr().err
