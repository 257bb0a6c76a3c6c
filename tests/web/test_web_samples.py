"""The made curves with which fits begin: each model has one that it can be fitted to, with what it was made of."""

from __future__ import annotations

import asyncio
import logging

import pytest
import tomli_w

from winkler.study.batch.fit_run import fit_study
from winkler.study.language.fit_reading import parse_fit_study
from winkler.study.language.fit_study import FITTED
from winkler.web.form import fit_form, form
from winkler.web.form.sample_curve import METAL_SAMPLE, RELAXING_SAMPLE, SAMPLE, SAMPLES
from winkler.web.form.study_form import StudyForm
from winkler.web.page.serve import WithoutCancelled


@pytest.fixture
def entered(tmp_path):
    for name, made in SAMPLES.items():
        (tmp_path / name).write_bytes(made())
    study = StudyForm(lambda: None, lambda: None, tmp_path)
    form.put(study.other_table, "fit.curve", SAMPLE)
    study.switch_task("fit")
    return study


def test_each_model_begins_with_a_sample_of_its_own(entered):
    for kind, curve in zip(FITTED, (SAMPLE, SAMPLE, METAL_SAMPLE, RELAXING_SAMPLE), strict=True):
        entered.choose("problem", kind)
        assert entered.content("fit.curve") == curve
    form.put(entered.table, "fit.curve", "mine.csv")
    entered.choose("problem", FITTED[0])
    assert entered.content("fit.curve") == "mine.csv"


def test_the_metal_sample_is_fitted_without_a_mistake(entered):
    entered.choose("problem", "plastic_indentation")
    study = parse_fit_study(tomli_w.dumps(entered.table), file="study.toml", folder=entered.folder)
    fit = fit_study(study).fitted[0].fit
    assert fit.value(study.free[0].path) == pytest.approx(400e6, rel=5e-3)


@pytest.mark.slow
def test_the_relaxing_sample_is_fitted_without_a_mistake(entered):
    entered.choose("problem", FITTED[-1])
    study = parse_fit_study(tomli_w.dumps(entered.table), file="study.toml", folder=entered.folder)
    fit = fit_study(study).fitted[0].fit
    found = {one.key.rpartition(".")[2]: fit.value(one.path) for one in study.free}
    assert found["shear"] == pytest.approx(1.5e3, rel=2e-3)  # within the noise, of G = 1.5 kPa (t / 1 s)^-0.15
    assert found["exponent"] == pytest.approx(0.15, abs=2e-3)


def test_bounds_take_bare_numbers_in_the_unit_beside_them():
    assert fit_form.bounds("0,5", "2 kPa", "Pa") == ["0.5 kPa", "2 kPa"]
    assert fit_form.bounds("5", "", "Pa") == "5"  # no unit is shown: the checks of the study refuse it
    assert fit_form.bounds("0,01", "0,9", "") == [0.01, 0.9]


def test_requests_that_are_cut_off_in_the_end_are_no_mistakes():
    seen = WithoutCancelled().filter

    def record(message, error=None):
        info = (type(error), error, None) if error else None
        return logging.LogRecord("uvicorn.error", logging.ERROR, "", 0, message, (), info)

    assert not seen(record("Exception in ASGI application", asyncio.CancelledError()))
    assert not seen(record("Cancel 1 running task(s), timeout graceful shutdown exceeded"))
    assert seen(record("Exception in ASGI application", ValueError("a mistake")))
