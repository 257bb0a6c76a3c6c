"""A user who has the wheel and no checkout: the lines of README, and what is said where an extra is missing.

The wheel is installed by pip into an environment of its own.  What it depends on is borrowed from the environment of
the tests, by a path after which the modules of extras are hidden, each in turn.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import sysconfig
import tomllib
import venv
from pathlib import Path
from typing import NamedTuple

import pytest

from winkler.study.language.template import whole_text

pytestmark = pytest.mark.slow

HIDING = """
import os, sys
class Hidden:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in os.environ.get("HIDDEN", "").split(","):
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
sys.meta_path.insert(0, Hidden())
"""
MODULES = {
    "afm": "afmformats",
    "app": "nicegui",
    "cards": "array_api_compat",
    "cluster": "distributed",
    "export": "ziglang",
    "nanoindentation": "openpyxl",
    "topography": "SurfaceTopography",
    "video": "imageio_ffmpeg",
    "widget": "anywidget",
    "xlsx": "openpyxl",
}
SWEEP = '\n[sweep]\n"problem.load.force" = ["1 N", "2 N"]\n'
FIT = """title = "A curve"
[problem]
kind = "indentation"
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "5 um" }
medium = { kind = "half_space", first = { kind = "elastic", young = "10 kPa", poisson = 0.5 } }
[fit]
curve = "NAME"
part = "approach"
[fit.free]
"problem.bed.medium.first.young" = ["1 kPa", "1 MPa"]
contact_point = true
"""


class User(NamedTuple):
    """An environment with the wheel alone, in which commands run."""

    folder: Path
    bin: Path

    def shell(self, command: str, hidden: str = "") -> subprocess.CompletedProcess[str]:
        """Run a command as it stands, without anything of the caller's Python."""
        kept = {name: text for name, text in os.environ.items() if not name.startswith("PYTHON")}
        place = {
            **kept,
            "PATH": f"{self.bin}{os.pathsep}{kept['PATH']}",
            "HIDDEN": hidden,
            "NUMBA_CACHE_DIR": str(self.folder / "kernels"),
        }
        return subprocess.run(
            command, shell=True, cwd=self.folder, env=place, capture_output=True, text=True, timeout=300
        )


@pytest.fixture(scope="module")
def user(wheel, tmp_path_factory):
    folder = tmp_path_factory.mktemp("user")
    venv.create(folder / "venv", with_pip=False, symlinks=os.name != "nt")
    scripts = folder / "venv" / ("Scripts" if os.name == "nt" else "bin")
    command = [
        sys.executable,
        "-m",
        "pip",
        "--python",
        str(folder / "venv"),
        "install",
        "--quiet",
        "--no-deps",
        "--no-index",
        str(wheel),
    ]
    subprocess.run(command, check=True)
    [packages] = {path.parents[0] for path in (folder / "venv").rglob("winkler/__init__.py") for path in [path.parent]}
    (packages / "borrowed.pth").write_text(sysconfig.get_path("purelib") + "\n", encoding="utf-8")
    (packages / "sitecustomize.py").write_text(HIDING, encoding="utf-8")
    return User(folder, scripts)


def test_it_is_the_wheel_that_runs(user):
    shown = user.shell('python -c "import winkler, sys; print(winkler.__file__); print(winkler.__version__)"')
    place, number = shown.stdout.splitlines()
    assert Path(place).is_relative_to(user.folder)
    assert re.fullmatch(r"\d+\.\d+\.\d+(\.dev0)?", number)


def test_the_first_lines_of_readme_run(user, root):
    text = (root / "README.md").read_text(encoding="utf-8")
    [block] = re.findall(r"<!-- ci: wheel -->\n```bash\n(.*?)```", text, re.DOTALL)
    first, *lines = block.splitlines()
    assert first == "pip install winkler"
    assert len(lines) == 1
    done = user.shell(lines[0], hidden=",".join(MODULES.values()))
    assert done.returncode == 0, done.stderr
    assert (user.folder / "results" / "indentation" / "report.html").stat().st_size > 10_000


@pytest.mark.parametrize("extra", [*(pytest.param(name, marks=pytest.mark.long) for name in MODULES), "all"])
def test_three_kinds_run_without_each_extra(user, extra):
    hidden = ",".join(MODULES.values()) if extra == "all" else MODULES[extra]
    for kind in ("elliptic_indentation", "adhesive_indentation", "line_indentation"):  # no kernels to compile
        name = f"{kind}_without_{extra}"
        done = user.shell(f"winkler new {kind} --output {name}.toml && winkler run {name}.toml", hidden=hidden)
        assert done.returncode == 0, done.stderr
        folder = user.folder / "results" / name
        assert (folder / "report.html").stat().st_size > 10_000
        assert (folder / "results.csv").read_text(encoding="utf-8").count("\n") > 1


IMAGE = b"""\\*File list\r
\\Version: 0x09200000\r
\\@Sens. Zsens: V 10.0 nm/V\r
\\*Ciao image list\r
\\Data offset: 4096\r
\\Data length: 512\r
\\Bytes/pixel: 2\r
\\Samps/line: 16\r
\\Number of lines: 16\r
\\Scan Size: 1 1 ~m\r
\\@2:Image Data: S [Height] "Height"\r
\\@2:Z scale: V [Sens. Zsens] (0.0003 V/LSB) 10 V\r
\\*File list end\r
\x1a"""
MAP = """
import types, numpy, winkler as wk
cards = types.ModuleType("cards")
cards.asarray = lambda numbers: memoryview(bytes(8))
ball = wk.Topography(-numpy.linspace(-1, 1, 16)[:, None] ** 2 - numpy.linspace(-1, 1, 16) ** 2, [1.0, 1.0])
wk.SurfaceContact(ball, wk.HalfSpace(wk.Elastic(1.0, 0.0)), wk.Depth(0.1)).solve(cards)
"""


@pytest.mark.parametrize(
    "extra, command",
    [
        pytest.param("app", "winkler app --no-browser", marks=pytest.mark.long),
        pytest.param("cluster", "winkler run sweep.toml --cluster tcp://127.0.0.1:1", marks=pytest.mark.long),
        ("afm", "winkler fit curve.jpk-force.toml"),
        ("nanoindentation", "winkler fit book.xlsx.toml"),
        ("topography", "winkler show map.spm"),
        pytest.param("cards", "python map.py", marks=pytest.mark.long),
        ("xlsx", "winkler run law.toml --set output.workbook=true"),
        pytest.param("export", "winkler export law.toml --to wasm", marks=pytest.mark.long),
        pytest.param("widget", "python -c \"import winkler; winkler.widget('normal')\"", marks=pytest.mark.long),
    ],
)
def test_what_needs_an_extra_names_it(user, extra, command):
    for kind, end, name in (("indentation", SWEEP, "sweep.toml"), ("tangential", "", "law.toml")):
        (user.folder / name).write_text(whole_text(kind) + end, encoding="utf-8")
    for name in ("curve.jpk-force", "book.xlsx"):
        (user.folder / name).write_bytes(b"PK\x03\x04")
        (user.folder / f"{name}.toml").write_text(FIT.replace("NAME", name), encoding="utf-8")
    openpyxl = pytest.importorskip("openpyxl")
    openpyxl.Workbook().save(user.folder / "book.xlsx")
    (user.folder / "map.spm").write_bytes(IMAGE.ljust(4096, b"\0") + bytes(512))
    (user.folder / "map.py").write_text(MAP, encoding="utf-8")
    done = user.shell(command, hidden=MODULES[extra])
    assert done.returncode != 0
    last = done.stderr.strip().splitlines()[-1]
    assert f"winkler[{extra}]" in last, done.stderr
    assert "Traceback" not in done.stderr or command.startswith("python")


def test_each_extra_that_adds_an_ability_is_hidden_here(root):
    """The others are tools for those who work on winkler."""
    extras = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    assert set(MODULES) == set(extras) - {"test", "bench", "peers", "docs", "dev", "checks", "release"}
