"""``winkler run``: what it writes, what it requests, what it prints, and what it leaves behind when it is stopped."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import pytest

import winkler as wk
from winkler.cli import main
from winkler.study.report import writing
from winkler.study.report.writing import PROVENANCE

STUDY = """title = "Ball"

[problem]
kind = "indentation"
load = { kind = "force", force = "100 N" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "210 GPa", poisson = 0.3 } }

[output]
figures = []
report = false
"""
SWEEP = '\n[sweep]\n"problem.load.force" = ["1 N", "-1 N", "2 N"]\n'


@pytest.fixture
def here(tmp_path, monkeypatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ball.toml").write_text(STUDY, encoding="utf-8")
    monkeypatch.setattr(sys, "stdin", open(os.devnull))  # noqa: SIM115 (nobody answers)
    return tmp_path


def names(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


def test_results_go_where_the_study_is_named_after(here, capsys):
    assert main(["run", "ball.toml"]) == 0
    folder = here / "results" / "ball"
    assert names(folder) == [PROVENANCE, "results.csv", "results.nc", "study.toml"]
    content = json.loads((folder / PROVENANCE).read_text())
    assert content["files"] == ["results.csv", "results.nc", "study.toml", PROVENANCE]
    assert content["study"] == "ball.toml"
    assert re.fullmatch(r"[0-9a-f]{64}", content["hash"])
    message = capsys.readouterr()
    assert message.err == ""
    assert "148.125" in message.out  # (3 F R / (4 E*))^(1/3) in um
    assert "How far this can be trusted:" in message.out
    assert str(Path("results") / "ball") in message.out


@pytest.mark.slow
def test_figures_and_report(here):
    text = STUDY.replace("figures = []\nreport = false", 'figures = ["svg"]\nreport = true')
    (here / "ball.toml").write_text(text + '\n[fields]\nr = ["0 a", "1 a", "2 a"]\n', encoding="utf-8")
    assert main(["run", "ball.toml", "--quiet"]) == 0
    written = names(here / "results" / "ball")
    assert "report.html" in written
    assert any(name.endswith(".svg") for name in written)
    assert not any(name.endswith(".png") for name in written)


def test_the_study_and_the_option_name_the_folder(here):
    (here / "ball.toml").write_text(STUDY.replace("[output]", '[output]\nfolder = "deep/inside"'), encoding="utf-8")
    assert main(["run", "ball.toml", "--quiet"]) == 0
    assert (here / "deep" / "inside" / "results.csv").is_file()
    assert main(["run", "ball.toml", "--quiet", "--output", "other"]) == 0
    assert (here / "other" / "results.csv").is_file()


def test_quiet_says_nothing(here, capsys):
    assert main(["run", "ball.toml", "--quiet"]) == 0
    assert capsys.readouterr() == ("", "")


def test_json(here, capsys):
    assert main(["run", "ball.toml", "--json"]) == 0
    content = json.loads(capsys.readouterr().out)
    assert {"title", "folder", "hash", "version", "answers", "expect", "failed", "validity"} <= set(content)
    assert content["answers"][0] == {"name": "depth", "unit": "m", "values": [pytest.approx(2.19409574e-6)]}
    assert content["version"] == wk.__version__
    assert content["folder"] is None
    assert names(here) == ["ball.toml"]


def test_json_with_a_folder_writes_there_too(here, capsys):
    assert main(["run", "ball.toml", "--json", "--output", "out"]) == 0
    assert json.loads(capsys.readouterr().out)["folder"] == "out"
    assert PROVENANCE in names(here / "out")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "endings"),
    [
        pytest.param([], {"svg"}, marks=pytest.mark.long),
        (["--figures", "png, pdf"], {"png", "pdf"}),
        pytest.param(["--figures", "all"], {"svg", "png", "pdf"}, marks=pytest.mark.long),
    ],
)
def test_figures_are_files_in_the_formats_of_the_option(words, endings, here):
    (here / "ball.toml").write_text(STUDY.partition("[output]")[0] + "[output]\nreport = false\n", encoding="utf-8")
    assert main(["run", "ball.toml", "--quiet", *words]) == 0
    assert {path.suffix[1:] for path in (here / "results/ball/figures").iterdir()} == endings


@pytest.mark.slow
def test_no_figures_but_a_report(here):
    (here / "ball.toml").write_text(STUDY.partition("[output]")[0], encoding="utf-8")
    assert main(["run", "ball.toml", "--quiet", "--figures", "none"]) == 0
    assert not (here / "results/ball/figures").exists()
    assert (here / "results/ball/report.html").read_text(encoding="utf-8").count("<svg") > 3


def test_a_format_that_nobody_draws_is_refused(here, capsys):
    assert main(["run", "ball.toml", "--figures", "gif"]) == 2
    assert "figures cannot be written as 'gif'; give some of svg, png, pdf." in capsys.readouterr().err


def test_a_second_run_is_refused_without_a_word_of_consent(here, capsys):
    assert main(["run", "ball.toml", "--quiet"]) == 0
    before = {name: (here / "results/ball" / name).read_bytes() for name in names(here / "results/ball")}
    assert main(["run", "ball.toml"]) == 2
    folder = Path("results") / "ball"
    assert capsys.readouterr().err == (
        f"winkler: output: '{folder}' already holds results; add --overwrite to replace them, or give another folder "
        "with --output.\n"
    )
    assert {name: (here / folder / name).read_bytes() for name in names(here / folder)} == before


@pytest.mark.parametrize("option", ["--overwrite", "--yes", "-y"])
def test_consent_by_option(option, here):
    assert main(["run", "ball.toml", "--quiet"]) == 0
    first = (here / "results/ball" / PROVENANCE).stat().st_ino
    assert main(["run", "ball.toml", "--quiet", option]) == 0
    assert (here / "results/ball" / PROVENANCE).stat().st_ino != first
    assert [path.name for path in (here / "results").iterdir()] == ["ball"]


class Terminal:
    """A terminal at which somebody types an answer."""

    def __init__(self, answer: str) -> None:
        self.answer = answer

    def isatty(self) -> bool:
        return True

    def readline(self, *_: object) -> str:
        return self.answer + "\n"


@pytest.mark.parametrize(("answer", "code"), [("y", 0), ("n", 2)])
def test_consent_is_requested_at_a_terminal(answer, code, here, monkeypatch, capsys):
    assert main(["run", "ball.toml", "--quiet"]) == 0
    monkeypatch.setattr(sys, "stdin", Terminal(answer))
    monkeypatch.setattr("builtins.input", lambda *_: answer)
    assert main(["run", "ball.toml", "--quiet"]) == code
    message = capsys.readouterr().err
    assert ("was kept" in message) is (code == 2)


@pytest.mark.parametrize(
    ("output", "sentence"),
    [
        ("ball.toml", "output: 'ball.toml' is a file; give a folder."),
        (".", "output: '.' is the working directory or contains it; give a folder inside it."),
        (
            "mine",
            "output: 'mine' holds what winkler did not write (diary.txt); give another folder, or move that away.",
        ),
        (
            "nest",
            "output: 'nest' holds what winkler did not write (other folders); give another folder, or move that away.",
        ),
    ],
)
@pytest.mark.parametrize("option", [[], ["--overwrite"]])
def test_folders_of_others_are_never_touched(output, sentence, option, here, capsys):
    (here / "mine").mkdir()
    (here / "mine" / "diary.txt").write_text("dear diary")
    (here / "nest" / "egg").mkdir(parents=True)
    before = sorted(here.rglob("*"))
    assert main(["run", "ball.toml", "--output", output, *option]) == 2
    assert capsys.readouterr().err == f"winkler: {sentence}\n"
    assert sorted(here.rglob("*")) == before


def test_a_file_beside_the_results_keeps_them_from_being_replaced(here, capsys):
    assert main(["run", "ball.toml", "--quiet"]) == 0
    (here / "results/ball/notes.txt").write_text("mine")
    assert main(["run", "ball.toml", "--quiet", "--overwrite"]) == 2
    assert "did not write (notes.txt)" in capsys.readouterr().err
    assert (here / "results/ball/notes.txt").read_text() == "mine"


def test_a_folder_that_cannot_be_made(here, capsys):
    assert main(["run", "ball.toml", "--output", "ball.toml/answer"]) == 2
    folder = Path("ball.toml") / "answer"
    assert capsys.readouterr().err == (
        f"winkler: output: '{folder}' lies in 'ball.toml', which is a file; give another folder.\n"
    )


@pytest.mark.skipif(os.name == "nt" or os.geteuid() == 0, reason="the superuser may write everywhere")
def test_a_folder_without_permission(here, capsys):
    (here / "locked").mkdir(mode=0o500)
    assert main(["run", "ball.toml", "--output", "locked/answer"]) == 2
    assert "cannot be written (permission denied)" in capsys.readouterr().err
    assert list((here / "locked").iterdir()) == []


def test_a_full_disk_leaves_nothing(here, monkeypatch, capsys):
    def full(*_: object) -> None:
        raise OSError(
            28, "Unable to create file (file write failed: time = Sun Nov 22\n, filename = 'a.nc', errno = 28)"
        )

    monkeypatch.setattr("winkler.study.report.writing.study_text", full)
    assert main(["run", "ball.toml"]) == 2
    errors = capsys.readouterr().err
    assert "cannot be written (no space left on device); free some space, or give another folder" in errors
    assert errors.count("\n") == 1
    assert [path.name for path in here.iterdir()] == ["ball.toml"]


@pytest.mark.parametrize("error", [KeyboardInterrupt, RuntimeError("broken")])
@pytest.mark.parametrize("before", [False, True])
def test_a_run_that_is_stopped_leaves_what_was_there(error, before, here, monkeypatch, capsys):
    if before:
        assert main(["run", "ball.toml", "--quiet"]) == 0
    earlier = {name: (here / name).read_bytes() for name in names(here)}

    def stopped(*_: object) -> str:
        raise error

    monkeypatch.setattr("winkler.study.report.writing.study_text", stopped)
    code = main(["run", "ball.toml", "--overwrite"])
    message = capsys.readouterr().err
    if error is KeyboardInterrupt:
        assert (code, message) == (130, "winkler: interrupted; nothing was written.\n")
    else:
        assert code == 70
        assert re.fullmatch(
            r"winkler: winkler made a mistake \(RuntimeError: broken at winkler\.study\.report\.writing:\d+\); run "
            r"again with --traceback and report it\.\n",
            message,
        )
    assert {name: (here / name).read_bytes() for name in names(here)} == earlier
    assert (here / "results").exists() is before


def test_a_stop_between_the_two_renamings_brings_the_old_results_back(here, monkeypatch):
    assert main(["run", "ball.toml", "--quiet"]) == 0
    earlier = {name: (here / name).read_bytes() for name in names(here)}
    real, calls = os.rename, []

    def rename(old: object, new: object) -> None:
        calls.append(new)
        if len(calls) == 2:
            raise KeyboardInterrupt
        real(old, new)

    monkeypatch.setattr(writing.os, "rename", rename)
    assert main(["run", "ball.toml", "--quiet", "--overwrite"]) == 130
    assert len(calls) == 3
    assert {name: (here / name).read_bytes() for name in names(here)} == earlier
    assert [path.name for path in (here / "results").iterdir()] == ["ball"]


def test_of_two_runs_into_one_folder_the_second_is_refused(here, monkeypatch, capsys):
    """It is refused at once, and changes nothing of what the first is writing."""
    real = writing.write_files

    def slow(*files):
        real(*files)
        monkeypatch.setattr(writing, "write_files", real)
        assert main(["run", "ball.toml", "--quiet", "--overwrite"]) == 2

    monkeypatch.setattr(writing, "write_files", slow)
    assert main(["run", "ball.toml", "--quiet"]) == 0
    assert "another run is writing into" in capsys.readouterr().err
    listed = json.loads((here / "results/ball" / PROVENANCE).read_text())["files"]
    assert names(here / "results/ball") == sorted(listed)
    assert [path.name for path in (here / "results").iterdir()] == ["ball"]


def test_failed_points_are_written_and_stated(here, capsys):
    (here / "ball.toml").write_text(STUDY + SWEEP, encoding="utf-8")
    assert main(["run", "ball.toml"]) == 4
    message = capsys.readouterr()
    assert "1 of 3 points have no answer:" in message.out
    assert "force -1 N is tensile" in message.out
    lines = (here / "results/ball/results.csv").read_text().splitlines()
    assert len(lines) == 4
    assert "tensile" in lines[2]


def test_outside_validity_is_code_four(here, capsys):
    (here / "ball.toml").write_text(STUDY.replace('"100 N"', '"-1 N"'), encoding="utf-8")
    assert main(["run", "ball.toml"]) == 4
    message = capsys.readouterr().err
    assert message.startswith("winkler: ball.toml: force -1 N is tensile")
    assert message.count("\n") == 1
    assert [path.name for path in here.iterdir()] == ["ball.toml"]


def test_not_converged_is_code_three(here, monkeypatch, capsys):
    def never(self):
        raise wk.NotConverged("the root was not found; try another load.")

    monkeypatch.setattr(wk.Indentation, "solve", never)
    assert main(["run", "ball.toml"]) == 3
    assert capsys.readouterr().err == "winkler: ball.toml: the root was not found; try another load.\n"
    assert [path.name for path in here.iterdir()] == ["ball.toml"]


@pytest.mark.parametrize(("value", "code"), [("2.19409574 um", 0), ("2.2 um", 1)])
def test_expectations(value, code, here, capsys):
    expect = f'\n[[expect]]\nquantity = "depth"\nvalue = "{value}"\ntolerance = 1e-6\n'
    (here / "ball.toml").write_text(STUDY + expect, encoding="utf-8")
    assert main(["run", "ball.toml"]) == code
    assert ("missed" in capsys.readouterr().out) is (code == 1)
    assert (here / "results/ball/results.csv").is_file()


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (
            ["run", "bell.toml"],
            "bell.toml: there is no such file; there are ball.toml; `winkler new indentation` writes one.",
        ),
        (["run", "."], ". is a folder; give a study file in it."),
        (["run", "latin.toml"], "latin.toml: byte 9 is not UTF-8; save the study as UTF-8 text."),
        (["run", "ball.toml", "--workers", "0"], "ball.toml: workers is 0; give a whole number from 1 on."),
        (
            ["run", "ball.toml", "--workers", "2", "--cluster", "tcp://host:1"],
            "run: both --workers and --cluster are given; leave one of them out.",
        ),
    ],
)
def test_what_cannot_be_read(arguments, sentence, here, capsys):
    (here / "latin.toml").write_bytes('title = "ü"'.encode("latin-1"))
    if "latin.toml" not in arguments:
        (here / "latin.toml").unlink()
    assert main(arguments) == 2
    assert capsys.readouterr().err == f"winkler: {sentence}\n"
    assert not (here / "results").exists()


@pytest.mark.parametrize(
    ("arguments", "part"),
    [
        (["rnu", "ball.toml"], "rnu"),
        (["run"], "study"),
        (["run", "ball.toml", "--outputt", "x"], "--outputt"),
        (["run", "ball.toml", "--workers", "many"], "--workers"),
        (["run", "ball.toml", "too", "much"], "too much"),
    ],
)
def test_wrong_commands_are_one_sentence(arguments, part, here, capsys):
    assert main(arguments) == 2
    message = capsys.readouterr()
    assert message.out == ""
    assert message.err.startswith("winkler: ")
    assert message.err.count("\n") == 1
    assert part in message.err.lower()
    assert "--help` lists what is allowed." in message.err
    assert not (here / "results").exists()


def test_traceback_is_shown_on_demand(here, monkeypatch):
    def broken(self):
        raise ZeroDivisionError("deep inside")

    monkeypatch.setattr(wk.Indentation, "solve", broken)
    assert main(["run", "ball.toml"]) == 70
    with pytest.raises(ZeroDivisionError, match="deep inside"):
        main(["run", "ball.toml", "--traceback"])
    with pytest.raises(ZeroDivisionError):
        main(["--traceback", "run", "ball.toml"])
    assert not (here / "results").exists()


LONG = STUDY + '\n[sweep]\n"problem.load.force" = { from = "1 N", to = "2 N", count = 100000 }\n'


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="signals are sent differently there")
@pytest.mark.parametrize(
    ("sign", "code", "message"),
    [
        (
            signal.SIGINT,
            130,
            r"winkler: interrupted; (nothing was written|\d+ of 100000 points are kept beside \S+long, "
            r"and the same command goes on from there)\.\n",
        ),
        (signal.SIGTERM, 143, ""),
    ],
)
def test_signals_stop_a_run_cleanly(sign, code, message, here):
    """Those of a whole group of processes, workers too; for one process see
    tests/hardening/processes/test_killed_runs.py."""
    (here / "long.toml").write_text(LONG, encoding="utf-8")
    words = [sys.executable, "-m", "winkler", "run", "long.toml", "--workers", "2"]
    run = subprocess.Popen(
        words, cwd=here, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    try:
        deadline = time.monotonic() + 120
        while not list(here.glob("results/.long.*.partial")):
            assert run.poll() is None, run.communicate()
            assert time.monotonic() < deadline
            time.sleep(0.02)
        time.sleep(1.0)
        os.killpg(run.pid, sign)
        out, err = run.communicate(timeout=60)
    finally:
        run.kill()
    assert (run.returncode, out) == (code, "")
    assert re.fullmatch(message, err)
    assert {path.name for path in here.iterdir()} <= {"ball.toml", "long.toml", "results"}
    if (here / "results").exists():  # of results nothing is left, only the journal
        assert [path.name for path in (here / "results").iterdir()] == [".long.journal"]


SETTINGS = {
    "problem.load.force=20 N": ('"100 N"', '"20 N"'),
    "problem.load.force='20 N'": ('"100 N"', '"20 N"'),
    'problem.load={kind = "depth", depth = "1 um"}': (
        'kind = "force", force = "100 N"',
        'kind = "depth", depth = "1 um"',
    ),
    "problem.bed.medium.first.poisson = 0.2": ("poisson = 0.3", "poisson = 0.2"),
}


@pytest.mark.parametrize("setting", SETTINGS)
def test_a_setting_is_a_study_with_another_content(here, capsys, setting):
    old, new = SETTINGS[setting]
    assert old in STUDY
    (here / "plain.toml").write_text(STUDY, encoding="utf-8")
    (here / "other.toml").write_text(STUDY.replace(old, new), encoding="utf-8")
    hashes = []
    for words in (["plain.toml", "--set", setting], ["other.toml"], ["plain.toml"]):
        assert main(["run", *words, "--json"]) == 0
        hashes.append(json.loads(capsys.readouterr().out)["hash"])
    assert hashes[0] == hashes[1] != hashes[2]


def test_a_list_is_set_by_places_and_a_new_table_is_made(tmp_path):
    from winkler.study.language.reading import read_text

    path = tmp_path / "study.toml"
    path.write_text('[[layers]]\nwidth = "1 um"\n[[layers]]\nwidth = "2 um"\n', encoding="utf-8")
    settings = ["layers.1.width=3 um", "layers.0={width = 4}", 'sweep."problem.load.force"=[1, 2]']
    raw = {"layers": [{"width": 4}, {"width": "3 um"}], "sweep": {"problem.load.force": [1, 2]}}
    assert tomllib.loads(read_text(path, settings)) == raw


@pytest.mark.parametrize(
    ("setting", "sentence"),
    [
        ("problem.load.force", "is no setting; give KEY=CONTENT, such as problem.load.force='20 N'."),
        ("problem..load=1", "is no setting; give KEY=CONTENT"),
        ("problem.load.force.x=1", "lies below problem.load.force, which is no table or list."),
        ("expect.2.value=1", "'2' is no place in a list of 1; the first one is 0."),
        ("problem.load.forse=1 N", "problem.load.forse is not known (did you mean 'force'?)"),
    ],
)
def test_a_setting_without_a_place_is_refused(here, capsys, setting, sentence):
    expected = '\n[[expect]]\nquantity = "force"\nvalue = "100 N"\ntolerance = 1e-9\n'
    (here / "study.toml").write_text(STUDY + expected, encoding="utf-8")
    assert main(["run", "study.toml", "--json", "--set", setting]) == 2
    assert sentence in capsys.readouterr().err
