"""``winkler fit``: what it writes, what it says, its exit codes, and what it keeps when it is stopped."""

from __future__ import annotations

import csv
import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from winkler.cli import main
from winkler.study.batch import fit_run
from winkler.study.batch.pool import Machine
from winkler.study.report.writing import PROVENANCE

STUDY = """title = "Gel & bead"

[problem]
kind = "indentation"

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "5 um" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 kPa", poisson = 0.5 } }

[fit]
curve = "gel"
part = "approach"

[fit.free]
"problem.bed.medium.first.young" = true
contact_point = true

[output]
figures = []
report = false
"""


def write_curve(path: Path, young: float, seed: int) -> None:
    random = np.random.default_rng(seed)
    depth = np.linspace(-1e-6, 1e-6, 100)
    noise = 5e-12 * random.standard_normal(100)
    force = 4.0 / 3.0 * young / 0.75 * np.sqrt(5e-6) * np.maximum(depth, 0.0) ** 1.5 + noise
    rows = (f"{1e9 * d:.3f}, {1e9 * f:.6f}\n" for d, f in zip(depth, force, strict=True))
    path.write_text("depth [nm], force [nN]\n" + "".join(rows), encoding="utf-8")


@pytest.fixture
def here(tmp_path, monkeypatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "gel.toml").write_text(STUDY, encoding="utf-8")
    (tmp_path / "gel").mkdir()
    for number in (1, 2, 3):
        write_curve(tmp_path / "gel" / f"curve{number}.csv", 1e3 * (3 + number), number)
    monkeypatch.setattr(sys, "stdin", open(os.devnull))  # noqa: SIM115 (nobody answers)
    return tmp_path


def names(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


CURVES = ["curves/gel_curve1.csv", "curves/gel_curve2.csv", "curves/gel_curve3.csv"]


@pytest.mark.slow
def test_segments_on_the_command_line_are_those_of_the_study(here, capsys):
    """They overrule the file's, and the study that is stored with the results states them."""
    stated = STUDY.replace('part = "approach"', 'part = "approach"\nsegments = ["loading 0", "hold 90"]')
    (here / "stated.toml").write_text(stated.replace('"gel"', '"gel/curve1.csv"'), encoding="utf-8")
    (here / "plain.toml").write_text(STUDY.replace('"gel"', '"gel/curve1.csv"'), encoding="utf-8")
    assert main(["fit", "stated.toml", "--output", "a"]) == 0
    assert main(["fit", "plain.toml", "--output", "b", "--segments", "loading 0, hold 90"]) == 0
    assert main(["fit", "plain.toml", "--output", "c"]) == 0
    numbers = [(here / name / "fit.csv").read_text(encoding="utf-8") for name in "abc"]
    assert numbers[0] == numbers[1] != numbers[2]
    assert main(["fit", "b/study.toml", "--output", "d"]) == 2  # the curve lies elsewhere, but the segments are there
    assert 'segments = [\n    "loading 0",' in (here / "b" / "study.toml").read_text(encoding="utf-8")
    capsys.readouterr()


@pytest.mark.slow
def test_a_batch(here, capsys):
    assert main(["fit", "gel.toml"]) == 0
    folder = here / "results" / "gel"
    assert names(folder) == [*CURVES, "fit.csv", "fit.nc", PROVENANCE, "study.toml"]
    content = json.loads((folder / PROVENANCE).read_text(encoding="utf-8"))
    assert content["files"] == [*names(folder)[:-2], "study.toml", PROVENANCE]
    assert re.fullmatch(r"[0-9a-f]{64}", content["hash"])
    message = capsys.readouterr()
    assert message.err == ""
    assert "gel/curve3.csv" in message.out
    assert main(["fit", "gel.toml"]) == 2
    assert "already holds results" in capsys.readouterr().err
    before = (folder / "fit.csv").read_bytes()
    assert main(["fit", "gel.toml", "--overwrite", "--quiet"]) == 0
    assert (folder / "fit.csv").read_bytes() == before
    assert capsys.readouterr().out == ""


@pytest.mark.slow
def test_the_hash_knows_the_curves(here, capsys):
    hashes = []
    for seed in (3, 4):
        write_curve(here / "gel" / "curve3.csv", 6e3, seed)
        assert main(["fit", "gel.toml", "--json", "--overwrite"]) == 0
        hashes.append(json.loads(capsys.readouterr().out)["hash"])
    assert hashes[0] != hashes[1]


def test_a_bad_file_has_its_line_and_its_code(here, capsys):
    (here / "gel" / "bad.csv").write_text("?\n", encoding="utf-8")
    assert main(["fit", "gel.toml", "--json"]) == 2
    answer = json.loads(capsys.readouterr().out)
    assert [item["curve"] for item in answer["failed"]] == ["gel/bad.csv"]
    columns = {column["name"]: column["values"] for column in answer["columns"]}
    assert columns["problem.bed.medium.first.young"][0] is None
    assert columns["problem.bed.medium.first.young"][1:] == pytest.approx([4e3, 5e3, 6e3], rel=0.02)
    assert columns["failure"][0].startswith("there is no table")


def test_nothing_is_left_of_a_fit_without_an_answer(here, capsys):
    for path in (here / "gel").iterdir():
        path.write_text("?\n", encoding="utf-8")
    assert main(["fit", "gel.toml"]) == 2
    assert "none of the 3 curves can be fitted" in capsys.readouterr().err
    assert not (here / "results").exists()


@pytest.mark.slow
def test_the_report_holds_what_made_the_numbers(here):
    text = STUDY.replace("report = false", "report = true").replace('"gel"\npart', '"gel/curve1.csv"\npart')
    (here / "gel.toml").write_text(text, encoding="utf-8")
    assert main(["fit", "gel.toml", "--quiet"]) == 0
    page = (here / "results" / "gel" / "report.html").read_text(encoding="utf-8")
    for part in ("<svg", "Gel &amp; bead", "SHA-256", "95 % interval", "word for word", "without bounds", "Papers"):
        assert part in page, part
    assert "<script" not in page
    assert "http" not in re.sub(r"https://doi\.org/|http://www\.w3\.org/", "", page)


@pytest.mark.slow
def test_the_first_line_is_the_number_with_its_interval(here, capsys):
    (here / "gel.toml").write_text(STUDY.replace('"gel"\npart', '"gel/curve1.csv"\npart'), encoding="utf-8")
    assert main(["fit", "gel.toml", "--pages", "1"]) == 0
    first = capsys.readouterr().out.splitlines()[1]
    found = re.fullmatch(r"young = (\S+) kPa ± (\S+) Pa \(95 %\), from (\d+) effective points of 100\.", first)
    assert found is not None, first
    assert abs(float(found[1]) * 1e3 - 4e3) < 2.0 * float(found[2])
    with (here / "results/gel/fit.csv").open(encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    place = next(i for i, name in enumerate(rows[0]) if name.endswith("young_low") or "young_low" in name)
    half = 0.5 * (float(rows[-1][place + 1]) - float(rows[-1][place]))
    assert float(found[2]) == pytest.approx(half, rel=0.06)
    assert [path.name for path in (here / "results/gel/pages").iterdir()] == ["1_gel_curve1.csv.html"]


def test_a_negative_number_of_pages(here, capsys):
    assert main(["fit", "gel.toml", "--pages", "-1"]) == 2
    assert "--pages is -1" in capsys.readouterr().err


def test_run_sends_to_fit(here, capsys):
    assert main(["run", "gel.toml"]) == 2
    assert "`winkler fit gel.toml` fits it" in capsys.readouterr().err


def stopping(monkeypatch, at: str, how):
    """Let something happen in place of the fit of one curve."""
    from winkler.study.batch import fit_run

    plain = fit_run._fit_piece

    def stopped(study, piece, watch):
        if piece.endswith(at):
            how()
        return plain(study, piece, watch)

    monkeypatch.setattr(fit_run, "_fit_piece", stopped)


def interrupt():
    raise KeyboardInterrupt


@pytest.mark.slow
def test_what_was_fitted_before_a_stop_is_stored_and_the_same_command_goes_on(here, monkeypatch, capsys):
    assert main(["fit", "gel.toml", "--quiet", "--output", "whole"]) == 0
    with monkeypatch.context() as patch:
        stopping(patch, "curve3.csv", interrupt)
        assert main(["fit", "gel.toml"]) == 130
    assert capsys.readouterr().err == (
        f"winkler: interrupted; 2 curves were done and are in {Path('results') / 'gel'}, 1 of 3 files are missing; the "
        "same command goes on from there.\n"
    )
    folder = here / "results" / "gel"
    assert names(folder) == [*CURVES[:2], "fit.csv", "fit.nc", PROVENANCE, "study.toml"]
    with monkeypatch.context() as patch:
        stopping(patch, "curve1.csv", interrupt)  # it is not requested again
        assert main(["fit", "gel.toml"]) == 0
    assert "2 of 3 files were known from the run before." in capsys.readouterr().out
    assert (folder / "fit.csv").read_bytes() == (here / "whole" / "fit.csv").read_bytes()
    assert [path.name for path in (here / "results").iterdir()] == ["gel"]
    assert main(["fit", "gel.toml"]) == 2  # whole results are not replaced
    assert "already holds results" in capsys.readouterr().err


def test_a_stop_before_a_curve_has_an_answer(here, monkeypatch, capsys):
    (here / "gel" / "curve1.csv").write_text("?\n", encoding="utf-8")
    with monkeypatch.context() as patch:
        stopping(patch, "curve2.csv", interrupt)
        assert main(["fit", "gel.toml"]) == 130
    assert capsys.readouterr().err == (
        f"winkler: interrupted; 1 of 3 files are kept beside {Path('results') / 'gel'}, and the same command goes on "
        "from there.\n"
    )
    assert [path.name for path in (here / "results").iterdir()] == [".gel.journal"]
    assert main(["fit", "gel.toml"]) == 2
    assert "1 of 3 files were known from the run before." in capsys.readouterr().out


@pytest.mark.slow
def test_another_fit_is_refused_without_anew(here, monkeypatch, capsys):
    with monkeypatch.context() as patch:
        stopping(patch, "curve3.csv", interrupt)
        assert main(["fit", "gel.toml", "--output", "out"]) == 130
    (here / "gel.toml").write_text(STUDY.replace("5 um", "6 um"), encoding="utf-8")
    capsys.readouterr()
    assert main(["fit", "gel.toml", "--output", "out", "--overwrite"]) == 2
    assert "holds curves of another study, or of another version of this one; add --anew" in capsys.readouterr().err
    assert main(["fit", "gel.toml", "--output", "out", "--anew"]) == 2
    assert (here / ".out.journal").exists()  # nothing is forgotten before the folder may be written
    assert main(["fit", "gel.toml", "--output", "out", "--overwrite", "--anew"]) == 0
    assert not (here / ".out.journal").exists()
    assert "known from the run before" not in capsys.readouterr().out


@pytest.mark.few(0, slow=2)
@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork there")
@pytest.mark.parametrize("moment", ["before the first", "before the second", "in a line", "at the end"])
def test_a_batch_that_is_killed_goes_on_to_the_same_bytes(here, monkeypatch, moment):
    """A forked run kills itself; the next one fits what is missing, and all files are those of a run in peace."""
    from winkler.study.batch import fit_run
    from winkler.study.batch.journal import Journal
    from winkler.study.report import writing

    (here / "gel" / "curve2.csv").write_text("?\n", encoding="utf-8")  # no answer, but its reason
    made = fit_run.provenance("", 1.0, "gel.toml")
    monkeypatch.setattr(fit_run, "provenance", lambda *_: made)
    assert main(["fit", "gel.toml", "--quiet", "--output", "whole"]) == 2
    done, todo = {
        "before the first": (0, 3),
        "before the second": (1, 2),
        "in a line": (1, 2),
        "at the end": (3, 0),
    }[moment]
    child = os.fork()
    if child == 0:
        try:
            if moment == "in a line":
                write = Journal._write
                monkeypatch.setattr(
                    Journal, "_write", lambda self, text: torn(self) if "curve2" in text else write(self, text)
                )
            elif moment == "at the end":
                place = writing.write_new
                monkeypatch.setattr(
                    writing, "write_new", lambda path, text: killed() if "prov" in path.name else place(path, text)
                )
            else:
                stopping(monkeypatch, f"curve{done + 1}.csv", killed)
            main(["fit", "gel.toml", "--quiet"])
        finally:
            os._exit(1)
    _, status = os.waitpid(child, 0)
    assert os.WTERMSIG(status) == signal.SIGKILL
    fitted = []
    plain = fit_run._fit_piece
    monkeypatch.setattr(
        fit_run, "_fit_piece", lambda study, piece, watch: fitted.append(piece) or plain(study, piece, watch)
    )
    assert main(["fit", "gel.toml", "--quiet"]) == 2
    assert len(fitted) == todo
    folder = here / "results" / "gel"
    assert names(folder) == names(here / "whole")
    for name in names(folder):
        assert (folder / name).read_bytes() == (here / "whole" / name).read_bytes(), name
    if done:  # a run that has stored something clears away what it left
        assert [path.name for path in (here / "results").iterdir()] == ["gel"]


def killed():
    os.kill(os.getpid(), signal.SIGKILL)


def torn(journal):
    os.write(journal._file, b'12345678 {"of"')
    killed()


def one_curve(here: Path, more: str = "") -> None:
    text = STUDY.replace('"gel"\npart', '"gel/curve1.csv"\npart').replace("[fit]\n", f"[fit]\n{more}")
    (here / "gel.toml").write_text(text, encoding="utf-8")


@pytest.mark.skipif(os.name == "nt", reason="there is no SIGINT of a process alone there")
def test_ctrl_c_prints_the_best_numbers_so_far(here, monkeypatch, capsys):
    """The signal comes at the fourth evaluation, as a reader would send it."""
    from winkler.fitting.search import Search

    plain = Search.record

    def stopped(self, *evaluation):
        if self.evaluations == 3:
            os.kill(os.getpid(), signal.SIGINT)
        plain(self, *evaluation)

    monkeypatch.setattr(Search, "record", stopped)
    one_curve(here)
    assert main(["fit", "gel.toml"]) == 130
    message = capsys.readouterr().err
    assert re.fullmatch(
        r"winkler: interrupted after \d+ evaluations, residuals of [\d.]+ pN; the best numbers so far, not converged: "
        r"problem\.bed\.medium\.first\.young = [\d.]+ kPa, contact_point = .*m; nothing was written\.\n",
        message,
    ), message
    assert not (here / "results").exists()


def test_a_time_limit_of_the_study_and_of_the_command(here, capsys):
    one_curve(here, 'time_limit = "1 ns"\n')
    assert main(["fit", "gel.toml"]) == 3
    assert "within the time limit of 1e-09 s, after 1 evaluation; give more time" in capsys.readouterr().err
    assert main(["fit", "gel.toml", "--time-limit", "600", "--quiet"]) == 0
    assert main(["fit", "gel.toml", "--time-limit", "1e-9", "--overwrite"]) == 3
    assert main(["fit", "gel.toml", "--time-limit", "0"]) == 2
    assert "--time-limit is 0; give a positive time" in capsys.readouterr().err
    one_curve(here, 'time_limit = "-1 s"\n')
    assert main(["fit", "gel.toml"]) == 2
    assert "fit.time_limit is '-1 s'; it must be positive" in capsys.readouterr().err


def test_a_curve_that_takes_too_long_does_not_stop_the_others(here, monkeypatch, capsys):
    from winkler.study.batch import fit_run

    plain = fit_run.fit_steps

    def slow_at_one(curve, *arguments, **options):
        return plain(curve, *arguments, **options | {"time_limit": 1e-9 if "curve2" in curve.name else np.inf})

    monkeypatch.setattr(fit_run, "fit_steps", slow_at_one)
    assert main(["fit", "gel.toml", "--json"]) == 3
    answer = json.loads(capsys.readouterr().out)
    assert [item["curve"] for item in answer["failed"]] == ["gel/curve2.csv"]
    assert "time limit" in answer["failed"][0]["reason"]


def test_a_bar_shows_how_far_the_fit_has_come(here, monkeypatch):
    from winkler.cli import fit as module

    message = []
    plain = module._RunningFit.watch

    def recorded(self, states):
        for state in plain(self, states):
            message.append(self.progress())
            yield state

    monkeypatch.setattr(module._RunningFit, "watch", recorded)
    one_curve(here)
    assert main(["fit", "gel.toml", "--quiet"]) == 0
    assert re.fullmatch(r"fitting: 1 evaluation, residuals of [\d.]+ \S?N", message[0])
    assert re.fullmatch(r"fitting: \d\d? evaluations, residuals of [\d.]+ pN", message[-2])


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("told", "workers"), [([], Machine()), (["--workers", "1"], 1)])
def test_a_batch_takes_all_processors_unless_told(here, monkeypatch, told, workers):
    asked, real = [], fit_run.fit_curves

    def seen(*content, **how):
        asked.append(how["workers"])
        return real(*content, **{**how, "workers": 1})

    monkeypatch.setattr(fit_run, "fit_curves", seen)
    assert main(["fit", "gel.toml", "--quiet", *told]) == 0
    assert asked == [workers]


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="there is no SIGINT of a process alone there")
def test_workers_change_no_number_and_ctrl_c_leaves_none_behind(here):
    """Interrupted with two workers, and gone on with: the numbers are those of one worker in peace."""
    for number in range(4, 41):
        write_curve(here / "gel" / f"curve{number}.csv", 4e3, number)
    command = [sys.executable, "-m", "winkler", "fit", "gel.toml", "--quiet", "--output"]
    assert subprocess.run([*command, "one"], check=False).returncode == 0
    running = subprocess.Popen([*command, "two", "--workers", "2"], stderr=subprocess.PIPE, text=True)
    journal, deadline = here / ".two.journal", time.monotonic() + 120.0
    while not journal.exists() or journal.read_bytes().count(b"\n") < 6:
        assert running.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.02)
    running.send_signal(signal.SIGINT)
    _, message = running.communicate(timeout=60)
    assert running.returncode == 130, message
    assert "are missing; the same command goes on from there" in message
    assert not list(here.glob(".*partial*"))
    done = (here / "two" / "fit.csv").read_bytes().count(b"\n") - 1
    assert 5 <= done <= journal.read_bytes().count(b"\n") <= 40
    answer = subprocess.run(
        [*command[:-2], "--workers", "2", "--output", "two"], capture_output=True, text=True, check=False
    )
    assert answer.returncode == 0, answer.stderr
    assert re.search(r"\d+ of 40 files were known from the run before\.", answer.stdout)
    assert (here / "one" / "fit.csv").read_bytes() == (here / "two" / "fit.csv").read_bytes()
    assert not journal.exists()
