"""The worker of a page: it runs the study as the command line does, draws, exports, and can be stopped."""

from __future__ import annotations

import asyncio
import csv
import io
import json
import sys
import time
import zipfile

import numpy as np
import pytest
import tomli_w

from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study
from winkler.study.language.template import whole_text
from winkler.study.report import netcdf
from winkler.web.form import form
from winkler.web.pictures.replies import AnswerText, DrawnSheet, InteractivePicture, MomentComplete
from winkler.web.session.solver import Solver
from winkler.web.session.worker import Done, Export, Look, Progress, Solve, Wrong, _WorkerState

METHOD = ["shape", "springs", "line_load", "pressure", "force", "stress"]


@pytest.fixture(scope="module")
def bench():
    return _WorkerState()


def answers_of(bench, text, folder):
    """Return the first parts of an answer, without the sheets: the words, and the charts by their names."""
    replies = bench.replies(Solve(1, text, folder, True))
    answer = next(replies)
    assert isinstance(answer, AnswerText)
    return answer, charts_of(replies)


def charts_of(replies):
    """Return the interactive pictures up to the end of their frame; an empty chart is one that is not shown."""
    found = {}
    for reply in replies:
        if isinstance(reply, MomentComplete):
            assert reply.total == len(found)
            return found
        found[reply.name] = json.loads(reply.chart) if reply.chart else {}
    raise AssertionError("the frame has no end")


@pytest.mark.parametrize("kind", ["indentation", "adhesive_indentation", "tangential", "equilibrium", "constriction"])
def test_the_app_and_the_command_line_have_equal_numbers(bench, tmp_path, kind):
    """Every other kind is compared in the browser, through what a person takes along."""
    answer, charts = answers_of(bench, tomli_w.dumps(form.initial_table(kind)), tmp_path)
    expected = run(parse_study(whole_text(kind))).points[0].answers
    (file,) = bench.replies(Export(2, "csv"))
    rows = list(csv.DictReader(io.StringIO(file.content.decode())))
    exported = {name.split(" ")[0]: [float(row[name]) for row in rows] for name in rows[0]}
    assert exported == {name: content.tolist() for name, content in expected.items()}
    assert run(parse_study(answer.text)).points[0].answers.keys() == expected.keys()
    assert list(charts)[:6] == METHOD
    assert all(charts.values())


def test_pictures_are_plain_data(bench, tmp_path):
    _, charts = answers_of(bench, tomli_w.dumps(form.initial_table("indentation")), tmp_path)
    springs, force = charts["springs"], charts["force"]
    depth = bench.outcome.points[0].solution.depth
    assert force["data"][-1]["x"] == pytest.approx([depth * 1e6])
    assert force["data"][-1]["y"] == pytest.approx([100.0])
    # the thickest line is g(x) - d in micrometres, deepest on the axis
    profile = max(springs["data"], key=lambda one: one["line"]["width"])
    assert float(np.min(profile["y"])) == pytest.approx(-depth * 1e6, rel=1e-6)


def test_the_frame_stays_while_the_contact_grows(bench, tmp_path):
    table = form.initial_table("indentation")
    answers_of(bench, tomli_w.dumps(table), tmp_path)
    first = bench.view
    for force, same in (("90 N", True), ("110 N", True), ("1 MN", False)):
        form.put(table, "problem.load.force", force)
        replies = bench.replies(Solve(1, tomli_w.dumps(table), tmp_path, False))
        assert isinstance(next(replies), AnswerText)
        if force != "1 MN":
            charts_of(replies)
            assert (bench.view == first) is same
        else:  # the ball is not as large as that contact
            assert isinstance(next(replies), InteractivePicture | Wrong)


def test_moments_of_a_history(bench, tmp_path):
    answer, charts = answers_of(bench, tomli_w.dumps(form.initial_table("tangential")), tmp_path)
    states = bench.outcome.points[0].solution.states
    assert answer.moments == len(states)
    loop = charts["shear_force_over_shift"]
    moved = charts_of(bench.replies(Look(2, 30)))["shear_force_over_shift"]
    assert moved["data"][0]["y"] == loop["data"][0]["y"]
    scale = np.max(np.abs(moved["data"][0]["y"])) / max(abs(state.shear_force) for state in states)
    assert float(moved["data"][-1]["y"][0]) == pytest.approx(states[30].shear_force * scale, rel=1e-6)


def test_mistakes_name_their_keys(bench, tmp_path):
    table = form.initial_table("indentation")
    form.put(table, "problem.load.force", "10 kg")
    form.drop(table, "problem.bed.profile.curvature_radius")
    (wrong,) = bench.replies(Solve(1, tomli_w.dumps(table), tmp_path, True))
    assert isinstance(wrong, Wrong)
    assert {form.owner_of(one) for one in wrong.sentences} == {
        "problem.load.force",
        "problem.bed.profile.curvature_radius",
    }
    (none,) = bench.replies(Export(2, "csv"))
    assert isinstance(none, Wrong)


@pytest.mark.slow
def test_sheets_and_files(bench, tmp_path):
    *_, sheet = bench.replies(Solve(1, tomli_w.dumps(form.initial_table("constriction")), tmp_path, True))
    assert isinstance(sheet, DrawnSheet)
    assert sheet.svg.startswith("<svg")
    (report,) = bench.replies(Export(2, "report"))
    assert report.name == "report.html"
    assert report.content.startswith(b"<!DOCTYPE html>")


def test_where_no_netcdf_file_can_be_written_a_sentence_says_so(bench, tmp_path, monkeypatch):
    """It ended in `KeyError: 'results.nc'`, which the app calls a mistake of its own."""
    answers_of(bench, tomli_w.dumps(form.initial_table("indentation")), tmp_path)
    monkeypatch.setitem(sys.modules, "h5netcdf", None)
    netcdf.has_netcdf.cache_clear()
    try:
        (wrong,) = bench.replies(Export(2, "netcdf"))
        (table,) = bench.replies(Export(3, "csv"))
    finally:
        netcdf.has_netcdf.cache_clear()
    assert wrong.sentences == (
        "results.nc: h5netcdf or h5py cannot be loaded, so the app gives no NetCDF file; save the results as CSV, or "
        "install both packages and start the app again.",
    )
    assert table.name == "results.csv"


@pytest.mark.slow
def test_figures_are_taken_along(bench, tmp_path):
    answers_of(bench, tomli_w.dumps(form.initial_table("indentation")), tmp_path)
    (pack,) = bench.replies(Export(2, "png"))
    with zipfile.ZipFile(io.BytesIO(pack.content)) as files:
        assert {f"{name}.png" for name in METHOD} <= set(files.namelist())


@pytest.mark.slow
def test_a_long_run_is_stopped_and_the_next_is_solved(tmp_path):
    """A sweep that would take minutes ends at once, and the same page answers again."""
    quick = tomli_w.dumps(form.initial_table("indentation"))
    long = tomli_w.dumps(form.initial_table("viscoelastic_adhesion")) + (
        '[sweep]\n"problem.law.work" = { from = "1 mJ/m^2", to = "90 mJ/m^2", count = 900 }\n'
    )

    async def use():
        received = []
        solver = Solver(lambda reply, newest: received.append(reply), lambda ready: received.append(None))

        async def until(kind):
            for _ in range(1200):
                if any(isinstance(one, kind) for one in received):
                    return
                await asyncio.sleep(0.05)
            raise AssertionError(f"no {kind.__name__} came")

        solver.send(lambda number: Solve(number, long, tmp_path, True))
        for _ in range(1200):
            if solver.seconds > 1.0:
                break
            await asyncio.sleep(0.05)
        assert not [one for one in received if not isinstance(one, Progress)]
        began = time.monotonic()
        solver.stop()
        assert time.monotonic() - began < 2.0
        assert not solver.working
        solver.send(lambda number: Solve(number, quick, tmp_path, True))
        await until(Done)
        assert any(isinstance(one, AnswerText) for one in received)
        process = solver.process
        solver.close()
        assert not process.is_alive()
        await asyncio.sleep(0.05)
        assert None not in received  # ends that the page brings about are no losses

    asyncio.run(use())
