"""A sweep on a cluster: the same numbers as here, and a sentence for everything that may be missing."""

from __future__ import annotations

import builtins
import contextlib
import math
import os
import signal
import subprocess
import sys
import types
import typing
import warnings
from concurrent.futures import CancelledError
from pathlib import Path

import numpy as np
import pytest

import winkler as wk
from winkler.cli import main
from winkler.cli.run import run as cli_run
from winkler.study.batch import cluster
from winkler.study.batch.cluster import Cluster
from winkler.study.batch.journal import Journal
from winkler.study.batch.points import Recalled
from winkler.study.batch.run import run
from winkler.study.batch.sweep import solve_points
from winkler.study.language.designs import Sobol
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis, Range
from winkler.values.errors import InvalidInput, NotConverged

BED = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25)))
STUDY = Study(
    "x",
    wk.Indentation(BED, wk.Force(1.0)),
    sweep=(
        Range("problem.load.force", -0.1, 3.0),
        Axis("problem.bed.profile", (wk.Paraboloid(1e-3), wk.Cone(1.5))),
    ),
    design=Sobol(64, 1),
)


@pytest.fixture(scope="module")
def address():
    """Return the address of a cluster of two processes on this machine."""
    distributed = pytest.importorskip("distributed")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as local:
            yield local.scheduler_address


@pytest.mark.slow
def test_the_numbers_are_those_of_this_process_and_of_a_pool(address, tmp_path):
    here = run(STUDY)
    assert here.failed
    assert run(STUDY, workers=Cluster(address)).points == here.points
    assert run(STUDY, workers=2).points == here.points
    assert run(STUDY, workers=Cluster(address), journal=tmp_path / "x.journal").points == here.points


@pytest.mark.slow
def test_the_executor_of_a_client_solves_them_too(address):
    from distributed import Client

    with Client(address, set_as_default=False) as client:
        assert run(STUDY, workers=client.get_executor()).points == run(STUDY).points


@pytest.mark.slow
def test_the_command_line(address, tmp_path, monkeypatch, capsys):
    from winkler.study.language.writing import study_text

    monkeypatch.chdir(tmp_path)
    text = study_text(STUDY) + "\n[output]\nfigures = []\nreport = false\n"
    (tmp_path / "x.toml").write_text(text, encoding="utf-8")
    assert main(["run", "x.toml", "--quiet", "--output", "here"]) == 4
    assert main(["run", "x.toml", "--quiet", "--output", "there", "--cluster", address]) == 4
    assert (tmp_path / "here/results.csv").read_bytes() == (tmp_path / "there/results.csv").read_bytes()
    assert capsys.readouterr() == ("", "")


def curves(folder, count):
    """Write force curves of a ball on gels of 1, 2 ... kPa, and the study that fits them."""
    (folder / "curves").mkdir()
    depth = np.linspace(-0.2e-6, 0.4e-6, 200)
    for number in range(count):
        bed = wk.Foundation(wk.Paraboloid(5e-6), wk.HalfSpace(wk.Elastic(1e3 * (number + 1), 0.5)))
        pressed = wk.Indentation(bed, wk.Depth(np.maximum(depth, 0.0))).solve().force
        noisy = pressed + 2e-12 * np.random.default_rng(number).standard_normal(depth.size)
        rows = "".join(f"{d!r},{f!r}\n" for d, f in zip((1e9 * depth).tolist(), (1e9 * noisy).tolist(), strict=True))
        (folder / "curves" / f"{number:02d}.csv").write_text(f"depth [nm],force [nN]\n{rows}", encoding="utf-8")
    (folder / "gels.toml").write_text(GELS, encoding="utf-8")


GELS = """title = "Gels"
[problem]
kind = "indentation"
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "5 um" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 kPa", poisson = 0.5 } }
[fit]
curve = "curves/*.csv"
part = "approach"
[fit.free]
"problem.bed.medium.first.young" = ["10 Pa", "10 MPa"]
contact_point = true
[output]
figures = []
report = false
"""


@pytest.mark.slow
def test_curves_are_fitted_on_a_cluster_whose_worker_is_killed(address, tmp_path, monkeypatch, capsys):
    from distributed import Client

    from winkler.study.batch.fit_run import fit_curves, pieces
    from winkler.study.language.fit_reading import read_fit_study

    monkeypatch.chdir(tmp_path)
    curves(tmp_path, 16)
    study = read_fit_study(tmp_path / "gels.toml")
    stream = fit_curves(study, pieces(study), workers=Cluster(address))
    found = dict([next(stream)])
    with Client(address, set_as_default=False) as client:
        before = client.run(os.getpid)
        os.kill(min(before.values()), signal.SIGKILL)
    found |= dict(stream)
    here = dict(fit_curves(study, pieces(study)))
    assert len(found) == 16
    assert all(found[place][0].fit.values.tolist() == here[place][0].fit.values.tolist() for place in here)
    assert main(["fit", "gels.toml", "--quiet", "--output", "here", "--workers", "1"]) == 0
    assert main(["fit", "gels.toml", "--quiet", "--output", "there", "--cluster", address]) == 0
    assert (tmp_path / "here/fit.csv").read_bytes() == (tmp_path / "there/fit.csv").read_bytes()
    assert capsys.readouterr() == ("", "")


def test_a_fit_takes_workers_or_a_cluster(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "gels.toml").write_text(GELS, encoding="utf-8")
    assert main(["fit", "gels.toml", "--workers", "2", "--cluster", "tcp://127.0.0.1:1"]) == 2
    assert capsys.readouterr().err == "winkler: fit: both --workers and --cluster are given; leave one of them out.\n"


@pytest.mark.slow
def test_a_worker_with_other_sources_is_refused(address, monkeypatch):
    other = cluster.software() | {"sources": "0123456789abcdef"}
    monkeypatch.setattr(cluster, "software", lambda: other)  # what a worker answers
    text = r"has sources of winkler 0123456789abcdef \(here [0-9a-f]{16}\); install there what is here"
    with pytest.raises(InvalidInput, match=text):
        run(STUDY, workers=Cluster(address))


FORCES = Axis("problem.load.force", tuple(np.linspace(1.0, 2.0, 100).tolist()))
ONE_BY_ONE = Study("x", wk.Indentation(BED, wk.Force(1.0)), sweep=(FORCES,))


@contextlib.contextmanager
def inside(**how):
    """Give a cluster that runs in threads of this process."""
    distributed = pytest.importorskip("distributed")
    few = {"n_workers": 1, "threads_per_worker": 1, "processes": False, "dashboard_address": None, "silence_logs": 50}
    with distributed.LocalCluster(**(few | how)) as local:
        yield local


@pytest.mark.slow
def test_a_cluster_whose_last_worker_died_is_given_up_and_goes_on_with_another(tmp_path):
    path = tmp_path / "x.journal"
    with inside() as local:
        cluster = Cluster(local.scheduler_address, patience=0.2)
        with Journal(path, ONE_BY_ONE) as journal:
            points = solve_points(ONE_BY_ONE, journal, workers=cluster)
            next(points)
            local.sync(local.workers[0].close)
            with pytest.raises(NotConverged) as message:
                list(points)
        stored = journal.count
        assert 0 < stored < 100
        assert str(message.value) == (
            f"cluster: '{cluster.address}' has had no worker for 0.2 s; start some with "
            f"`dask worker {cluster.address}` and run again. {stored} of 100 points are kept in '{path}', "
            "and the same run goes on from there."
        )
        local.scale(2)
        local.sync(local._correct_state)
        outcome = run(ONE_BY_ONE, workers=cluster, journal=path)
    assert sum(isinstance(point, Recalled) for point in outcome.points) == stored
    assert [point.found for point in outcome.points] == [point.found for point in run(ONE_BY_ONE).points]


@pytest.mark.slow
def test_what_dask_raises_becomes_a_sentence(monkeypatch):
    distributed = pytest.importorskip("distributed")
    deadly = distributed.KilledWorker("_solved-1", types.SimpleNamespace(address="tcp://host:9"), 3)
    raised = iter((deadly, CancelledError(), OSError("in <TCP>: Stream is closed")))
    sentences = ("died whenever they solved certain points", *2 * ("is gone; start it and its workers, and run again",))

    def broken(*_, **__):
        raise next(raised)

    with inside() as local:
        monkeypatch.setattr("distributed.wait", broken)
        for sentence in sentences:
            with pytest.raises(NotConverged, match=sentence):
                run(ONE_BY_ONE, workers=Cluster(local.scheduler_address))


def test_how_long_a_cluster_may_be_without_a_worker_is_stated():
    assert Cluster("tcp://host:8786").patience == 60.0
    option = typing.get_type_hints(cli_run, include_extras=True)["cluster"].__metadata__[0]
    assert "given up after 60 s without a worker" in option.help
    for page in ("sweeps.md", "command-line.md"):
        text = (Path(__file__).parents[3] / "docs" / page).read_text(encoding="utf-8")
        assert "60 s without" in " ".join(text.split())
    for wrong in (0.0, -1.0, math.inf, math.nan):
        with pytest.raises(InvalidInput, match="it must be a positive time in s"):
            Cluster("tcp://host:8786", patience=wrong)


@pytest.mark.slow
def test_a_cluster_without_workers_is_refused():
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(n_workers=0, dashboard_address=":0") as local,
        pytest.raises(InvalidInput, match="has no workers; start some with `dask worker"),
    ):
        run(STUDY, workers=Cluster(local.scheduler_address))


def test_without_the_extra_there_is_a_sentence(monkeypatch):
    known = builtins.__import__

    def missing(name, *rest):
        if name.startswith("distributed"):
            raise ImportError(name)
        return known(name, *rest)

    monkeypatch.setattr(builtins, "__import__", missing)
    with pytest.raises(InvalidInput, match=r"install it with `pip install winkler\[cluster\]`"):
        run(STUDY, workers=Cluster("tcp://127.0.0.1:9"))


@pytest.mark.parametrize("address", ["", " ", 3])
def test_an_address_is_text(address):
    with pytest.raises(InvalidInput, match="give that of a scheduler, such as 'tcp://host:8786'"):
        Cluster(address)


@pytest.mark.slow
def test_nobody_answers(monkeypatch):
    pytest.importorskip("distributed")
    monkeypatch.setattr(cluster, "SCHEDULER_TIMEOUT", 0.5)
    with pytest.raises(InvalidInput, match=r"nobody answers at 'tcp://127\.0\.0\.1:9'"):
        run(STUDY, workers=Cluster("tcp://127.0.0.1:9"))


PAGE = Path(__file__).resolve().parents[3] / "docs" / "tutorials" / "clusters.md"


@pytest.mark.slow
def test_the_scripts_of_the_manual_run_their_shards(tmp_path):
    """The job of SLURM with its number set by hand, one of them killed, and the rules of Snakemake one by one."""
    from winkler.study.language.writing import study_text

    text = PAGE.read_text(encoding="utf-8")
    job = text.partition("```text\n#!/bin/bash\n")[2].partition("```")[0].replace("1-20", "1-3").replace("/20", "/3")
    rules = [line.partition('"')[2].rpartition('"')[0] for line in text.splitlines() if line.startswith("    shell: ")]
    (tmp_path / "bin").mkdir()
    command = tmp_path / "bin" / "winkler"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m winkler "$@"\n', encoding="utf-8")
    command.chmod(0o755)
    study = tmp_path / "study.toml"
    study.write_text(study_text(ONE_BY_ONE) + "\n[output]\nfigures = []\n", encoding="utf-8")
    place = {**os.environ, "PATH": f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}"}

    def shell(line, **more):
        done = subprocess.run(["bash", "-c", line], cwd=tmp_path, env={**place, **more}, capture_output=True, text=True)
        assert done.returncode == 0, (line, done.stderr)

    shell("winkler run study.toml --output alone --quiet")
    for number in "12":
        shell(job, SLURM_ARRAY_TASK_ID=number)
    killed = subprocess.Popen(["bash", "-c", job], cwd=tmp_path, env={**place, "SLURM_ARRAY_TASK_ID": "3"})
    killed.kill()
    killed.wait()
    shell(job, SLURM_ARRAY_TASK_ID="3")
    shell("winkler merge study.toml --output results/study --quiet")
    assert (tmp_path / "results/study/results.csv").read_bytes() == (tmp_path / "alone/results.csv").read_bytes()
    shard, merge = (rule.replace("{input}", "study.toml").replace("/20", "/2") for rule in rules)
    for number in "12":
        shell(shard.replace("{wildcards.n}", number))
    shell(merge)
    assert (tmp_path / "results/study/results.csv").read_bytes() == (tmp_path / "alone/results.csv").read_bytes()
