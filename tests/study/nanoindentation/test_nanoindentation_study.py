"""Studies of nanoindentations from file to results: calibration, evaluation, bad files by name, mistakes."""

from __future__ import annotations

import csv
import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from winkler.cli import main
from winkler.io.indenter_file import read_indenter
from winkler.study.nanoindentation.reading import is_nanoindentation, read_nanoindentation_study
from winkler.values.errors import InvalidInput

EXAMPLES = Path(__file__).resolve().parents[3] / "examples"
DATA = EXAMPLES / "data" / "nanoindentation"


def study(folder, text, name="study.toml"):
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


CALIBRATION = """
title = "tip"
[calibration]
[[calibration.reference]]
curve = "silica_*.csv"
young = "72 GPa"
poisson = 0.17
[output]
figures = []
report = false
"""
INDENTATION = """
title = "steel"
[indentation]
curve = "steel_*.csv"
poisson = 0.3
indenter = "tip/indenter.toml"
"""


@pytest.mark.slow
def test_a_calibration_is_read_by_an_evaluation(tmp_path, capsys):
    """The data are made with A = 24.5 h^2 + 1.1 um h, 0.4 um/N, and a steel of 210 GPa."""
    for number in (1, 2):
        shutil.copy(DATA / f"silica_{number}.csv", tmp_path)
    shutil.copy(DATA / "steel_1.csv", tmp_path)
    (tmp_path / "steel_2.csv").write_text("no numbers\n", encoding="utf-8")
    assert main(["fit", str(study(tmp_path, CALIBRATION)), "--output", str(tmp_path / "tip"), "--quiet"]) == 0
    indenter = read_indenter(tmp_path / "tip" / "indenter.toml")
    assert indenter.frame_compliance == pytest.approx(0.4e-6, abs=4.0 * indenter.covariance[0, 0] ** 0.5)
    capsys.readouterr()
    where = ["--output", str(tmp_path / "steel"), "--json"]
    assert main(["fit", str(study(tmp_path, INDENTATION, "steel.toml")), *where]) == 2
    answer = json.loads(capsys.readouterr().out)
    assert answer["failed"][0]["curve"] == "steel_2.csv"
    low, high = answer["means"]["young"]["interval"]
    assert low < 210e9 < high < 1.3 * low
    assert answer["means"]["young"]["shares"]["calibration"] > 0.0
    with (tmp_path / "steel" / "unloadings.csv").open(encoding="utf-8") as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
    assert len(rows) == 1 + 4
    report = (tmp_path / "steel" / "report.html").read_text(encoding="utf-8")
    for words in ("Shares of the uncertainty", "Quantities of ISO 14577", "steel_2.csv", "eta_IT", "Pile-up"):
        assert words in report


EXPECT = """
[[expect]]
quantity = "young"
value = "210 GPa"
tolerance = 0.05
[[expect]]
quantity = "hardness.0"
value = "TOLD GPa"
tolerance = 0.1
"""


@pytest.mark.long
def test_the_iso_table_has_one_row_for_each_quantity_and_few_columns(tmp_path):
    """Six curves stand in two tables, each at most four curves wide; every quantity of the CSV file is in both."""
    shutil.copy(DATA / "berkovich.toml", tmp_path)
    for number in range(1, 7):
        shutil.copy(DATA / f"steel_{(number - 1) % 3 + 1}.csv", tmp_path / f"steel_{number}.csv")
    path = study(tmp_path, INDENTATION.replace("tip/indenter", "berkovich") + "[output]\nfigures = []\n")
    assert main(["fit", str(path), "--output", str(tmp_path / "out"), "--quiet"]) == 0
    report = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    part = report.partition("Quantities of ISO 14577")[2].partition("<h2")[0]
    heads = [re.findall(r"<th[^>]*>([^<]*)</th>", one) for one in part.split("<table>")[1:]]
    assert heads == [["quantity", *(f"steel_{n}.csv" for n in numbers)] for numbers in ((1, 2, 3, 4), (5, 6))]
    with (tmp_path / "out" / "quantities.csv").open(encoding="utf-8") as file:
        names = next(csv.reader(line for line in file if not line.startswith("#")))
    for name in ("HM", "HMs", "HIT", "EIT", "HV*", "CIT", "RIT", "W", "W_e", "W_p", "eta_IT"):
        assert part.count(f"<td>{name}, ") == 2
        assert any(key.split(" ")[0] == name.replace("*", "_star") for key in names)


@pytest.mark.slow
@pytest.mark.parametrize(("told", "missed"), [(7.0, 0), (9.0, 1)])
def test_expected_numbers(tmp_path, capsys, told, missed):
    """The steel of the data has 210 GPa, and a hardness of 7 GPa."""
    head = f'title = "steel"\nsource = "the data"\ngrade = "analytical"\n{EXPECT}'.replace("TOLD", str(told))
    text = head + INDENTATION.replace('title = "steel"\n', "").replace("tip/indenter", "berkovich")
    shutil.copy(DATA / "berkovich.toml", tmp_path)
    shutil.copy(DATA / "steel_1.csv", tmp_path)
    path = study(tmp_path, text, "case.toml")
    assert main(["fit", str(path), "--output", str(tmp_path / "out"), "--json"]) == missed
    found = json.loads(capsys.readouterr().out)["expect"]
    assert [(one["quantity"], one["curve"]) for one in found] == [
        ("young", "steel_1.csv"),
        ("hardness.0", "steel_1.csv"),
    ]
    assert [one["passed"] for one in found] == [True, not missed]
    with (tmp_path / "out" / "unloadings.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    assert found[0]["got"] == pytest.approx(float(rows[-1]["young [Pa]"]), rel=1e-9)
    assert found[1]["got"] == pytest.approx(float(rows[0]["hardness [Pa]"]), rel=1e-9)
    report = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert f"{2 - missed} of 2 expectations were met" in report
    assert main(["validate", str(path)]) == missed
    assert "steel_1.csv" in capsys.readouterr().out


@pytest.mark.slow
def test_a_calibration_expects_its_frame(tmp_path):
    """The tip of the data has two coefficients; with four the frame is uncertain by a fourth."""
    for number in (1, 2):
        shutil.copy(DATA / f"silica_{number}.csv", tmp_path)
    expect = '[[expect]]\nquantity = "frame_compliance"\nvalue = "VALUE um/N"\ntolerance = 0.1\n'
    for number, code in ((0.4, 0), (0.6, 1)):
        known = CALIBRATION.replace("[calibration]\n", "[calibration]\nterms = 2\n")
        path = study(tmp_path, known + expect.replace("VALUE", str(number)))
        assert main(["fit", str(path), "--output", str(tmp_path / "tip"), "--quiet", "--overwrite"]) == code


@pytest.mark.parametrize(
    ("entry", "words"),
    [
        ('quantity = "yuong"\nvalue = "1 GPa"\ntolerance = 0.1', "expect: quantity is 'yuong'.*young"),
        ('quantity = "young"\nvalue = "1 um"\ntolerance = 0.1', "expect: value: '1 um' is a length, not a pressure"),
        ('quantity = "young"\nvalue = "1 GPa"', "expect needs tolerance"),
    ],
)
def test_wrong_expectations_are_refused(tmp_path, entry, words):
    shutil.copy(DATA / "berkovich.toml", tmp_path)
    shutil.copy(DATA / "steel_1.csv", tmp_path)
    path = study(tmp_path, INDENTATION.replace("tip/indenter", "berkovich") + f"[[expect]]\n{entry}\n")
    with pytest.raises(InvalidInput, match=words):
        read_nanoindentation_study(path)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    ("quantity", "words"),
    [
        ("peak_pressure", "'peak_pressure' is no answer; there are .*young"),
        ("young.7", "young.7 asks for one of . unloadings"),
    ],
)
def test_expectations_that_no_evaluation_has_are_refused_before_results_are_written(tmp_path, capsys, quantity, words):
    shutil.copy(DATA / "berkovich.toml", tmp_path)
    shutil.copy(DATA / "steel_1.csv", tmp_path)
    entry = f'[[expect]]\nquantity = "{quantity}"\nvalue = "1 GPa"\ntolerance = 0.1\n'
    path = study(tmp_path, INDENTATION.replace("tip/indenter", "berkovich") + entry)
    assert main(["fit", str(path), "--output", str(tmp_path / "out"), "--quiet"]) == 2
    assert re.search(words, " ".join(capsys.readouterr().err.split()))
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (INDENTATION.replace("poisson", "poison"), "has no key 'poison'.*poisson"),
        (INDENTATION.replace("poisson = 0.3", ""), "indentation.poisson is missing"),
        (INDENTATION.replace('"tip/indenter.toml"', '"lost.toml"'), "indenter is 'lost.toml'"),
        (INDENTATION.replace('indenter = "tip/indenter.toml"', ""), "there is no indenter"),
        (INDENTATION.replace("steel_*", "gold_*"), "no file fits the pattern"),
        (INDENTATION + '\n[indenter]\narea = [24.5]\n', "given twice"),
        (INDENTATION.replace('indenter = "tip/indenter.toml"', "[indenter]\narea = [24.5, 1]"), r"area\[1\]"),
        (INDENTATION + CALIBRATION.replace('title = "tip"', ""), "either \\[indentation\\] or \\[calibration\\]"),
        (CALIBRATION.replace("[calibration]\n", "[calibration]\nterms = 99\n"), "terms is 99"),
        (CALIBRATION.replace("young =", "yung ="), "has no key 'yung'.*young"),
        ("[calibration]\n", "calibration.reference is missing"),
    ],
)  # fmt: skip
def test_mistakes_are_named(tmp_path, text, words):
    for name in ("steel_1.csv", "silica_1.csv"):
        shutil.copy(DATA / name, tmp_path)
    path = study(tmp_path, text)
    assert is_nanoindentation(path)
    with pytest.raises(InvalidInput, match=words):
        read_nanoindentation_study(path)


def test_other_studies_are_left_alone(tmp_path):
    assert not is_nanoindentation(EXAMPLES / "studies" / "fitting" / "fit_gel.toml")
    assert not is_nanoindentation(tmp_path / "lost.toml")


def _powers(folder, name="a.csv", units="nm,mN"):
    """A test of F = K (D - 50 nm)^2 up to 10 mN at 300 nm, and an unloading with the exponent 3/2."""
    along, back = np.linspace(0.0, 1.0, 400), np.linspace(1.0, 0.0, 200)
    air = np.arange(0.0, 50.0, 1.0)
    depth = np.r_[air, 50.0 + 300.0 * along, 50.0 + 120.0 + 180.0 * back ** (1.0 / 1.5)]
    force = np.r_[0.0 * air, 10.0 * along**2, 10.0 * back]
    force = force + 3e-4 * np.random.default_rng(1).standard_normal(force.size)
    header = "time [s],depth,force" if not units else "time [s],depth [nm],force [mN]"
    rows = np.c_[0.1 * np.arange(depth.size), depth, force]
    np.savetxt(folder / name, rows, fmt="%.8g", delimiter=",", header=header, comments="")
    return folder / name


ANY_TIP = """
[indentation]
curve = "*.csv"
poisson = 0.3
{more}
[indenter]
area = [24.5]
[output]
figures = []
report = false
"""


def test_drift_segments_and_units_are_stated(tmp_path, capsys):
    _powers(tmp_path, units="")
    more = 'units = { position = "nm", force = "mN" }\ndrift = "0.1 nm/s"\ndrift_error = "0.02 nm/s"\n'
    more += 'segments = ["loading 0 s", "unloading 45 s"]'
    written = study(tmp_path, ANY_TIP.format(more=more))
    assert main(["fit", str(written), "--output", str(tmp_path / "r"), "--quiet"]) == 0
    with (tmp_path / "r" / "quantities.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    key = {name.partition(" ")[0]: name for name in rows[0]}
    assert float(rows[0][key["drift"]]) == pytest.approx(0.1, rel=1e-9) or float(rows[0][key["drift"]]) == 1e-10
    none = study(tmp_path, ANY_TIP.format(more=more.replace('"0.1 nm/s"', '"none"').replace("0.02", "0.03")), "n.toml")
    assert read_nanoindentation_study(none).given["drift"] == 0.0
    wrong = ANY_TIP.format(more='drift_error = "1 nm/s"')
    with pytest.raises(InvalidInput, match="drift_error belongs to a given drift"):
        read_nanoindentation_study(study(tmp_path, wrong, "w.toml"))
    with pytest.raises(InvalidInput, match="indentation.segments"):
        read_nanoindentation_study(study(tmp_path, ANY_TIP.format(more="segments = 3"), "s.toml"))


@pytest.mark.slow
def test_copies_count_once_and_are_named(tmp_path, capsys):
    shutil.copy(_powers(tmp_path), tmp_path / "b.csv")
    written = study(tmp_path, ANY_TIP.format(more=""))
    assert main(["fit", str(written), "--output", str(tmp_path / "r"), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert [one["curve"] for one in answer["doubts"]] == ["b.csv"]
    assert "the data of a.csv" in answer["doubts"][0]["doubts"][0]
    shares = answer["means"]["young"]["shares"]
    alone = study(tmp_path, ANY_TIP.format(more="").replace("*.csv", "a.csv"), "alone.toml")
    assert main(["fit", str(alone), "--output", str(tmp_path / "r2"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["means"]["young"]["shares"] == shares
