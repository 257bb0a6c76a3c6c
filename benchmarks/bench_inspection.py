"""Files listed by `winkler show`: curves, a curve that is refused, a log; and the batch of a fit over a folder.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

from winkler.study.batch.fit_run import fit_study
from winkler.study.inspection.inspect import inspect_file
from winkler.study.language.fit_reading import read_fit_study

pytestmark = pytest.mark.bench

STUDY = """
title = "a folder"

[problem]
kind = "indentation"

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "5 um" }

[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = "4 kPa", poisson = 0.5 }

[fit]
curve = "curves"
part = "approach"

[fit.free]
"problem.bed.medium.first.young" = true
contact_point = true
baseline = true
"""


def write_curve(path, seed, above="k (N/m) 0.05\n", points=300):
    """A loop of twice so many points on a soft half-space, with noise; the spring bends by what it measures."""
    random = np.random.default_rng(seed)
    depth = np.clip(np.concatenate([np.linspace(-1e-6, 1.5e-6, points), np.linspace(1.5e-6, -1e-6, points)]), 0.0, None)
    force = 4.0 / 3.0 * 4e3 / 0.75 * np.sqrt(5e-6) * depth**1.5
    piezo = np.concatenate([np.linspace(0.0, 2.5e-6, points), np.linspace(2.5e-6, 0.0, points)]) + force / 0.05
    force = force + 2e-11 * random.standard_normal(2 * points)
    rows = "\n".join(f"{1e9 * at:.2f}, {1e9 * one:.4f}" for at, one in zip(piezo, force, strict=True))
    path.write_text(f"{above}piezo [nm], force [nN]\n{rows}\n")
    return path


@pytest.fixture
def curves(tmp_path):
    """Ten files of curves in a folder."""
    folder = tmp_path / "curves"
    folder.mkdir()
    return [write_curve(folder / f"{seed}.csv", seed) for seed in range(10)]


def bench_ten_curves_listed(benchmark, curves, below):
    found = benchmark.pedantic(lambda: [inspect_file(one, brief=True) for one in curves], rounds=10, warmup_rounds=1)
    assert {one.taken_for for one in found} == {"force curve"}
    below(0.4, "ten force curves of 600 points, as winkler show lists them, one processor")


def bench_a_curve_shown(benchmark, curves):
    found = benchmark.pedantic(lambda: inspect_file(curves[0]), rounds=10, warmup_rounds=1)
    assert found.taken_for == "force curve"
    benchmark.extra_info.update(what="one force curve, with events, as winkler show shows it")


def bench_a_refused_curve(benchmark, tmp_path):
    path = write_curve(tmp_path / "bare.csv", 0, above="")
    found = benchmark.pedantic(lambda: inspect_file(path, brief=True), rounds=10, warmup_rounds=1)
    assert "spring_constant" in found.reason
    benchmark.extra_info.update(what="a force curve that lacks its spring constant: refused")


def bench_a_log_shown(benchmark, tmp_path):
    way = 5e-6 * np.sin(np.linspace(-1.6, 200.0 * np.pi, 20_000))
    force = np.clip(30e6 * np.gradient(way), -1.0, 1.0)
    path = tmp_path / "loops.csv"
    rows = "\n".join(f"{1e6 * at:.4f}, {one:.4f}" for at, one in zip(way, force, strict=True))
    path.write_text(f"displacement [um], friction force [N]\n{rows}\n")
    found = benchmark.pedantic(lambda: inspect_file(path), rounds=5, warmup_rounds=1)
    assert found.taken_for == "loops of friction"
    benchmark.extra_info.update(what="a log of a hundred loops of 200 points")


def bench_batch_of_ten_fits(benchmark, curves, tmp_path):
    (tmp_path / "study.toml").write_text(STUDY)
    study = read_fit_study(tmp_path / "study.toml")
    found = benchmark.pedantic(lambda: fit_study(study), rounds=3, warmup_rounds=1)
    assert len(found.fitted) == 10
    benchmark.extra_info.update(what="a batch of ten fits of 300 points with three numbers")
