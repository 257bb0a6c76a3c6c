"""Commands that write files are killed before each operation on a file: what stands there is of one study.

Before, 54 of 78 kills of an export over an older one left files of both, and a wrong law compiled.  After SIGTERM and
Ctrl-C all files are old or all are new.  A SIGKILL may come between two renames: then the files do not compile.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess

import pytest
from killing import Killer

BALL = """title = "A ball"

[problem]
kind = "indentation"
load = { kind = "force", force = "100 N" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "RADIUS" }
medium = { kind = "half_space", first = { kind = "elastic", young = "210 GPa", poisson = 0.3 } }
"""
COMMANDS = {
    "lammps": ("export", "STUDY", "--to", "lammps", "--output", "results", "--overwrite"),
    "fortran": ("export", "STUDY", "--to", "fortran", "--output", "results", "--overwrite"),
    "fmu": ("export", "STUDY", "--to", "fmu", "--output", "results", "--overwrite"),
    "table": ("table", "STUDY", "--output", "results/x.csv", "--overwrite"),
    "draw": ("draw", "STUDY", "--part", "bed", "--output", "results/x.png", "--overwrite"),
    "report": ("report", "STUDY", "--output", "results/x.html", "--overwrite"),
}
SIGNS = {signal.SIGKILL: -signal.SIGKILL, signal.SIGTERM: 143, signal.SIGINT: 130}
MOST_KILLS = 12

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are forked, and killed by signals")


@pytest.fixture(scope="module")
def killer():
    process = Killer()
    yield process
    process.close()


def tree(folder):
    """Return the files in a folder; the time that a report took is left out."""
    texts = {path.name: path.read_bytes() for path in folder.iterdir()}
    return {name: re.sub(rb"<tr><td>(created|time taken).*?</tr>", b"", text) for name, text in texts.items()}


def is_mixed(files):
    """Return whether files state that they are of more than one export."""
    marks = [
        re.findall(rb"(?:_EXPORT (?:!= )?0x|_(?:export|begin|step)_)([0-9a-f]{12})", text) for text in files.values()
    ]
    assert all(marks)  # each file states its own
    return len({mark for one in marks for mark in one}) > 1


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("name", COMMANDS)
def test_a_kill_leaves_the_files_of_one_study(name, tmp_path, killer):
    trees, events = {}, 0
    for study, radius in (("older", "10 mm"), ("newer", "20 mm")):
        folder = tmp_path / study
        (folder / "results").mkdir(parents=True)
        (folder / "STUDY").write_text(BALL.replace("RADIUS", radius), encoding="utf-8")
        killer.request(folder, *COMMANDS[name], fork=False)
        shutil.rmtree(folder / "results")
        (folder / "results").mkdir()
        answer = killer.request(folder, *COMMANDS[name])
        assert (answer["code"], answer["errors"]) == (0, "")
        trees[study], events = tree(folder / "results"), answer["events"]
    here, mixed = tmp_path / "newer", 0
    moments = range(1, events + 1)
    for kill, event in enumerate(moments[:: -(-events // MOST_KILLS)]):
        for path, content in ((here / "results" / one, text) for one, text in trees["older"].items()):
            path.write_bytes(content)
        sign = list(SIGNS)[kill % 3]
        answer = killer.request(here, *COMMANDS[name], sign=int(sign), event=event)
        assert answer["code"] in (0, SIGNS[sign])
        found = tree(here / "results")
        named = {one: text for one, text in found.items() if not one.endswith(".winkler-part")}
        if sign == signal.SIGKILL and named not in trees.values():
            mixed += 1
            assert is_mixed(named)
        else:
            assert named in trees.values()
            assert sign == signal.SIGKILL or found == named  # nothing is left beside
        assert killer.request(here, *COMMANDS[name])["code"] == 0
        assert tree(here / "results") == trees["newer"]
    assert mixed == 0 or name in ("lammps", "fortran")


@pytest.mark.parametrize("target", ["lammps", "fortran"])
def test_files_of_two_exports_do_not_compile(target, tmp_path):
    """A copy that was broken off is seen by the compiler, also where none of this is installed."""
    from exported_laws import PROBLEMS

    from winkler.exporting.export import export

    one, other = (dict(export(PROBLEMS[name], target, name="ball").files) for name in ("ball", "beads"))
    assert set(other) <= set(one)
    source = {"lammps": "pair_ball.cpp", "fortran": "ball_c.c"}[target]
    for header, fits in ((one["ball.h"], True), (other["ball.h"], False)):
        (tmp_path / "ball.h").write_text(header)
        lines = re.sub(r"^#include (?!\"ball\.h\").*$", "", one[source], flags=re.MULTILINE)
        command = [shutil.which("cc") or "cc", "-E", "-o", os.devnull, "-x", "c", "-"]
        if shutil.which("cc") is None:
            pytest.skip("no C compiler here: install one")
        made = subprocess.run(command, input=lines, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert (made.returncode == 0) is fits
        assert fits or "ball.h is of another export than this file; export all files again" in made.stderr
