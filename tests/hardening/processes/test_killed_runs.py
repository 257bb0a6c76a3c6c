"""A hundred and thirty kills over run, sweep, fit, wear and report: the same command goes on to equal results.

Half of them are long tests.  Each is killed by SIGKILL, SIGTERM or Ctrl-C, before an operation on a file or after some
time, in an empty folder or over older results.  What stands there is whole at once after the kill or as soon as the
next run begins; the next run leaves the same bytes as one that was not disturbed, and nothing else.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys

import numpy as np
import pytest
import tomli_w
from killing import Killer

from winkler.study.language.explain import example_study

BALL = """title = "A ball"

[problem]
kind = "indentation"
load = { kind = "force", force = "100 N" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "210 GPa", poisson = 0.3 } }
"""
SWEEP = """
[sweep]
"problem.load.force" = { from = "1 N", to = "10 N", count = 12 }
"""
WEAR = """title = "Fretting"

[problem]
kind = "fretting_wear"
normal = { kind = "depth", depth = "1 um" }
amplitude = { kind = "shift", shift = "0.45 um" }
cycles = [0, 1e4, 1e5, 2e5]
count = 30
wear = { kind = "archard", rate = "1e-5 mm^3/(N m)" }
law = { kind = "coulomb", coefficient = 0.5 }

[sweep]
"problem.wear.rate" = ["1e-5 mm^3/(N m)", "2e-5 mm^3/(N m)"]

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "210 GPa", poisson = 0.3 } }
"""
FIT = """title = "Gel"

[problem]
kind = "indentation"

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "5 um" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 kPa", poisson = 0.5 } }

[fit]
curve = "CURVE"
part = "approach"

[fit.free]
"problem.bed.medium.first.young" = true
contact_point = true
"""
PLAIN = """
[output]
figures = []
report = false
"""
STUDIES = {
    "run": ("run", BALL + PLAIN, 12, 1),
    "sweep": ("run", BALL + SWEEP + PLAIN, 12, 2),
    "wear": ("run", WEAR + PLAIN, 12, 2),
    "report": ("run", tomli_w.dumps(example_study("elastic_plastic_particle")), 10, 5),
    "fit": ("fit", FIT.replace("CURVE", "gel/curve1.csv") + PLAIN, 10, 5),
    "fits": ("fit", FIT.replace("CURVE", "gel") + PLAIN, 10, 5),
}
"""Command, study, how many kills of each sort, and how many in a row before a run is let to its end.

Each kill has a moment of its own, and the signals take turns: neighbouring moments have all three."""
OLDER = {
    "study/provenance.json": json.dumps({"program": "winkler", "files": ["a.csv", "provenance.json"]}).encode(),
    "study/a.csv": b"1\n",
}
STOPS = {signal.SIGKILL: (-signal.SIGKILL, -signal.SIGPROF), signal.SIGTERM: (143,), signal.SIGINT: (130,)}
GOES_ON = (".journal", ".states.npz")
"""What a stopped run may leave beside its results: the next one begins with it."""

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are forked, and killed by signals")


@pytest.fixture(scope="module")
def killer():
    process = Killer()
    yield process
    process.close()


def prepared(folder, name):
    """Write a study, and the curves it may need."""
    (folder / "gel").mkdir(parents=True)
    (folder / "study.toml").write_text(STUDIES[name][1], encoding="utf-8")
    depth = np.linspace(-1e-6, 1e-6, 60)
    for number in range(1, 5):
        noise = np.random.default_rng(number).standard_normal(60)
        force = 4.0 / 3.0 * 1e3 * number / 0.75 * np.sqrt(5e-6) * np.maximum(depth, 0.0) ** 1.5 + 5e-12 * noise
        rows = (f"{1e9 * d:.3f}, {1e9 * f:.6f}\n" for d, f in zip(depth, force, strict=True))
        (folder / f"gel/curve{number}.csv").write_text("depth [nm], force [nN]\n" + "".join(rows), encoding="utf-8")
    return folder


def tree(folder):
    """Return everything in a folder."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def whole(results):
    """Return whether results are there with every file that they list, and no other."""
    made = results / "provenance.json"
    return made.exists() and sorted(json.loads(made.read_text())["files"]) == sorted(tree(results))


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("by", ["operation", "time"])
@pytest.mark.parametrize("name", STUDIES)
def test_a_rerun_after_a_kill_gives_equal_results_and_leaves_nothing(name, by, tmp_path, killer):
    command, _, kills, row = STUDIES[name]
    words = (command, "study.toml", "--quiet", "--overwrite")
    killer.request(prepared(tmp_path / "warm", name), *words, fork=False)
    usual = killer.request(prepared(tmp_path / "usual", name), *words)
    expected = tree(tmp_path / "usual/results")
    assert usual["code"] == 0
    assert usual["errors"] == ""
    here, results = prepared(tmp_path / "here", name), tmp_path / "here/results"
    pace = 1.0
    for kill in range(kills):
        older = kill // row % 2  # over older results, or into nothing
        if kill % row == 0:
            shutil.rmtree(results, ignore_errors=True)
            for path, content in OLDER.items() if older else ():
                (results / path).parent.mkdir(parents=True, exist_ok=True)
                (results / path).write_bytes(content)
        sign = list(STOPS)[kill % 3]
        for _ in range(20):
            had = found(results)
            part = pace * (kill + 0.5) / kills
            when = (
                {"event": 1 + int(part * usual["events"])}
                if by == "operation"
                else {"seconds": part * usual["seconds"]}
            )
            answer = killer.request(here, *words, sign=sign, **when)
            looked_at(answer, sign, older, had, results)
            if answer["code"]:
                break
            pace *= 0.85  # it was done sooner: some of it was known from the run before
        assert answer["code"] in STOPS[sign]
        if kill % row == row - 1:
            again = killer.request(here, *words)
            assert (again["code"], again["errors"]) == (0, "")
            assert tree(results) == expected


def found(results):
    """Return the names in the folder that holds the results, hidden ones too."""
    return {path.name for path in results.iterdir()} if results.exists() else set()


def looked_at(answer, sign, older, had, results):
    """Check what a run has written and left: the results are whole, and half of them only after a hard kill."""
    code, errors, left = answer["code"], answer["errors"], found(results)
    assert code in (0, *STOPS[sign]), (answer, sign)
    hard = code in STOPS[signal.SIGKILL]
    if not hard:
        assert all(item == "study" or item.endswith(GOES_ON) for item in left - had), (answer, sign, left, had)
    if code == STOPS[signal.SIGINT][0]:
        assert errors.startswith("winkler: interrupted"), errors
        assert errors.count("\n") == 1, errors
    else:
        assert errors == ""
    if "study" in left:
        assert whole(results / "study"), (answer, sign, left)
    elif older:  # it was put aside by this kill or one before, and the next run brings it back
        assert any(item.endswith(".old") for item in left), (answer, sign, left)
        assert hard or left <= had, (answer, sign, left, had)


EARLY = """
import os, signal, sys
count = 0
def imported(name, arguments):
    global count
    count += name == "import"
    if count == {place}:
        count += 1
        os.kill(os.getpid(), {sign})
def left(frame, event, argument):
    global count
    if event == "call" and frame.f_code.co_name == "cb" and "importlib" in frame.f_code.co_filename:
        count += 1
        if count == {place}:
            os.kill(os.getpid(), {sign})
signal.signal(signal.SIGINT, signal.default_int_handler)
from winkler.cli import main
{how}
sys.exit(main(["run", "study.toml"]))
"""
AT_IMPORTS, IN_CALLBACKS = "sys.addaudithook(imported)", "sys.setprofile(left)"


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("sign", [signal.SIGTERM, signal.SIGINT])
@pytest.mark.parametrize(("how", "place"), [*((AT_IMPORTS, n) for n in (1, 100, 250, 400)), (IN_CALLBACKS, 150)])
def test_a_signal_while_winkler_is_loaded_is_not_lost(how, place, sign, tmp_path):
    """Real processes; in the callback of a module's lock Python itself would report an interrupt and forget it."""
    (tmp_path / "study.toml").write_text(STUDIES["run"][1], encoding="utf-8")
    code = EARLY.format(how=how, place=place, sign=int(sign))
    run = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (run.returncode, run.stdout) == (STOPS[sign][0], "")
    assert run.stderr == ("winkler: interrupted; nothing was written.\n" if sign == signal.SIGINT else "")
    assert [path.name for path in tmp_path.iterdir()] == ["study.toml"]
