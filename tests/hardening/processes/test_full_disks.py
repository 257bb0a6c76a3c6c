"""Disks that fill up: one sentence and code 2, the older results, and no need of a disk twice as large as the results.

Real disks of a few MB, where mounts are allowed; `tests/io/test_whole_file.py` has one that stands in for them.
"""

from __future__ import annotations

import contextlib
import shutil
import subprocess
import sys

import pytest

from winkler.io.whole_file import FULL
from winkler.study.batch.journal import Journal
from winkler.study.batch.run import gather
from winkler.study.batch.sweep import solve_points
from winkler.study.language.reading import parse_study
from winkler.study.report import writing

BALL = """title = "A ball"

[problem]
kind = "indentation"
load = { kind = "force", force = "100 N" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "210 GPa", poisson = 0.3 } }

[sweep]
"problem.load.force" = ["10 N", "20 N", "50 N", "100 N", "200 N"]

[fields]
r = { from = "0 a", to = "3 a", count = COUNT }
z = { from = "0.02 a", to = "2.5 a", count = 80 }

[output]
figures = []
report = false
"""
FULL_DISK = "no space left on device); free some space, or "


@contextlib.contextmanager
def disk(folder, size):
    """Mount a disk of so many bytes."""
    folder.mkdir(exist_ok=True)
    options = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(folder)]
    if shutil.which("mount") is None or subprocess.run(options, capture_output=True, check=False).returncode:
        pytest.skip("no disk can be mounted here: run as root, on Linux")
    try:
        yield folder
    finally:
        subprocess.run(["umount", str(folder)], check=True)


def ran(*words):
    run = subprocess.run(
        [sys.executable, "-m", "winkler", *map(str, words)], capture_output=True, text=True, check=False
    )
    return run.returncode, run.stderr


def used(folder):
    """Return what files take [bytes], as a disk counts them."""
    return sum(-(-path.stat().st_size // 4096) * 4096 for path in folder.rglob("*"))


@pytest.fixture(scope="module")
def outcome():
    study = parse_study(BALL.replace("COUNT", "121"))
    return study, gather(study, solve_points(study), started=0.0)


def test_the_journal_is_smaller_than_the_results(outcome, tmp_path):
    """It was 2.99 MB, and the archive 2.61."""
    study, found = outcome
    with Journal(tmp_path / ".ball.journal", study) as journal:
        list(solve_points(study, journal))
        assert 0 < journal.size < 0.9 * len(writing.outcome_files(found)["results.nc"])
        assert journal.size < 2.3e6


@pytest.mark.slow
def test_the_journal_gives_way_to_results_that_fit_in_its_place_alone(outcome, tmp_path, monkeypatch):
    """The disk takes the journal and so much more; the results are there, or the journal is."""
    study, found = outcome
    files = writing.outcome_files(found)
    needed = sum(map(len, files.values())) + writing.BLOCK_BYTES * len(files)
    plain = writing.write_new
    for more, fits in ((needed - 2_000_000, True), (needed - 2_600_000, False)):
        path = tmp_path / f".{more}.journal"
        (tmp_path / str(more)).mkdir()
        with Journal(path, study) as journal:
            list(solve_points(study, journal))

            def limited(place, content, left=more, path=path):
                here = sum(one.stat().st_size for one in place.parent.iterdir() if one != place)
                if here + len(content) > left and path.exists():
                    plain(place, content[: left - here])
                    raise OSError(next(iter(FULL)), "No space left on device")
                plain(place, content)

            monkeypatch.setattr(writing, "write_new", limited)
            if fits:
                writing.write_files(files, tmp_path / str(more), journal)
                assert {one.name: one.read_bytes() for one in (tmp_path / str(more)).iterdir()} == files
            else:
                with pytest.raises(OSError, match="No space left"):
                    writing.write_files(files, tmp_path / str(more), journal)
            assert path.exists() is not fits


@pytest.mark.slow
@pytest.mark.parametrize("older", [False, True])
def test_results_on_disks_of_all_sizes(older, tmp_path):
    """A library that wrote by itself ended the process with a segmentation fault, at 3 to 7.5 MB."""
    study = tmp_path / "ball.toml"
    study.write_text(BALL.replace("COUNT", "121"), encoding="utf-8")
    assert ran("run", study, "--output", tmp_path / "whole", "--quiet") == (0, "")
    results, before = used(tmp_path / "whole"), {}
    sizes = [int(part * results) for part in (0.3, 0.75, 1.0, 1.1, 2.2)]
    codes = []
    for size in sizes:
        with disk(tmp_path / "small", size) as small:
            if older:
                (small / "r").mkdir()
                files = writing.with_provenance({"a.csv": b"1\n"}, writing.Provenance("0", "", "", 1.0, ()))
                writing.write_files(files, small / "r")
                before = {path.name: path.read_bytes() for path in (small / "r").iterdir()}
            code, errors = ran("run", study, "--output", small / "r", "--quiet", "--overwrite")
            codes.append(code)
            if code:
                assert FULL_DISK + "give another folder with --output" in errors
                assert errors.count("\n") == 1
                left = {path.name for path in small.iterdir()} - {".r.journal"}
                assert left == ({"r"} if older else set())
                assert {path.name: path.read_bytes() for path in small.glob("r/*")} == before
            else:
                assert [path.name for path in small.iterdir()] == ["r"]
    assert codes == [2, 2, 2, 0, 0]


COMMANDS = {
    "report": ("report", "STUDY", "--output", "x.html"),
    "draw": ("draw", "STUDY", "--part", "bed", "--output", "x.png"),
    "new": ("new", "--output", "x.toml"),
    "table": ("table", "STUDY", "--output", "x.csv"),
    "export": ("export", "STUDY", "--to", "lammps", "--output", "."),
}


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("name", COMMANDS)
def test_commands_on_a_full_disk(name, tmp_path):
    """A full disk was said to be a folder that does not exist."""
    study = tmp_path / "ball.toml"
    study.write_text(BALL.partition("[sweep]")[0], encoding="utf-8")
    with disk(tmp_path / "small", 16_384) as small:
        (small / "fill").write_bytes(b"1" * 16_384)
        words = [str(study) if word == "STUDY" else word for word in COMMANDS[name]]
        words[-1] = str(small / words[-1])
        code, errors = ran(*words)
        kept = [path.name for path in small.iterdir()]
        assert (code, kept) == (2, ["fill"])
        assert FULL_DISK + "name a file elsewhere" in errors
        assert errors.count("\n") == 1
