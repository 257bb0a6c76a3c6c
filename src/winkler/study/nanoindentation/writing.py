"""The files of a study of nanoindentations.

::

    unloadings.csv     one row per unloading: force, depth, contact depth, E and H with every share of uncertainty
    quantities.csv     one row per curve: the quantities of ISO 14577 with standard uncertainties, and failures
    continuous.csv     of continuously measured stiffness: one row per depth, E and H with standard uncertainties
    first_yield.csv    where pop-ins are sought: force, shear stress and cumulative probability of each
    indenter.toml      of a calibration: area function, frame compliance, covariance
    calibration.csv    of a calibration: one row per unloading
"""

from __future__ import annotations

import numpy as np

from winkler.fitting.nanoindentation.pop_ins import PopInStatistics
from winkler.io.indenter_file import indenter_text
from winkler.io.workbooks.table_workbook import workbook_file
from winkler.study.batch.outcome import ResultColumn
from winkler.study.nanoindentation.running import NanoindentationOutcome
from winkler.study.report.archive import table_file
from winkler.study.report.page_parts import page_files
from winkler.study.report.writing import with_provenance
from winkler.values.vocabulary import Word


def nanoindentation_files(outcome: NanoindentationOutcome) -> dict[str, bytes]:
    """Return the files of the results of a study: name -> content."""
    study, files = outcome.study, dict[str, bytes]()
    if study.calibrates:
        line = f"{study.title}: {len(outcome.calibration[0].force)} unloadings, study {outcome.provenance.hash[:12]}"
        files["indenter.toml"] = indenter_text(outcome.calibration[0].indenter, made_from=line).encode("utf-8")
        files["calibration.csv"] = table_file(_readings(outcome), nothing="")
    if outcome.evaluated:
        files["unloadings.csv"] = table_file(_unloadings(outcome), nothing="")
        files["quantities.csv"] = table_file(_quantities(outcome), nothing="")
    if outcome.continuous:
        files["continuous.csv"] = table_file(_continuous(outcome), nothing="")
    if (statistics := outcome.first_yield) is not None:
        files["first_yield.csv"] = table_file(_first_yield(statistics), nothing="")
    if study.output.report or study.output.figures:
        from winkler.study.nanoindentation.report import figures_of, page

        files |= page_files(outcome, figures_of(outcome), page)
    if study.output.workbook:
        files |= workbook_file(files)
    files["study.toml"] = study.text.encode("utf-8")
    return with_provenance(files, outcome.provenance, missing=outcome.left)


def _column(name: str, unit: str | None, meaning: str, content: object) -> ResultColumn:
    return ResultColumn(name, Word("", unit, meaning), np.asarray(content))


def _unloadings(outcome: NanoindentationOutcome) -> list[ResultColumn]:
    names = [one.name for one in outcome.evaluated for _ in one.solution.force]
    order = [place + 1.0 for one in outcome.evaluated for place in range(one.solution.force.size)]
    columns = [
        _column("curve", None, "where the curve comes from", names),
        _column("unloading", "", "number of the unloading", order),
    ]
    words = {
        "force": ("N", "force at the peak"),
        "depth": ("m", "depth at the peak"),
        "contact_depth": ("m", "contact depth"),
        "stiffness": ("N/m", "stiffness of the contact"),
        "exponent": ("", "exponent of the unloading"),
        "area": ("m^2", "projected area of contact"),
        "modulus": ("Pa", "reduced modulus"),
        "young": ("Pa", "Young's modulus of the sample"),
        "young_errors": ("Pa", "standard uncertainty of Young's modulus"),
        "hardness": ("Pa", "hardness"),
        "hardness_errors": ("Pa", "standard uncertainty of the hardness"),
    }
    for name, (unit, meaning) in words.items():
        content = np.concatenate([getattr(one.solution, name) for one in outcome.evaluated])
        columns.append(_column(name.replace("_errors", "_error"), unit, meaning, content))
    for name in ("young", "hardness"):
        for place, source in enumerate(outcome.evaluated[0].solution.sources):
            content = np.concatenate([getattr(one.solution, f"{name}_shares")[place] for one in outcome.evaluated])
            content = np.where(content > 0.0, content, np.nan)  # zero: nothing is known of this source
            meaning = f"standard uncertainty of {name} by {source}"
            columns.append(_column(f"{name}_by_{source.replace(' ', '_')}", "Pa", meaning, content))
    return columns


def _quantities(outcome: NanoindentationOutcome) -> list[ResultColumn]:
    good, failed = outcome.evaluated, outcome.unevaluated
    names = [*(one.name for one in good), *(one.name for one in failed)]
    columns = [_column("curve", None, "where the curve comes from", names)]
    lost, doubts = [np.nan] * len(failed), {name: " ".join(each) for name, each in outcome.doubts}
    first = good[0].quantities
    for place, (name, unit) in enumerate(zip(first.names, first.units, strict=True)):
        key = name.replace("*", "_star")
        columns.append(_column(key, unit, name, [*(one.quantities.values[place] for one in good), *lost]))
        errors = [*(one.quantities.errors[place] for one in good), *lost]
        columns.append(_column(f"{key}_error", unit, f"standard uncertainty of {name}", errors))
    if "tip_radius" in outcome.study.given:
        columns.append(_column("pop_in", "N", "force at the first pop-in", [*(one.pop_in for one in good), *lost]))
    columns += [
        _column(
            "contact_point", "m", "position of first touch", [*(o.solution.zero_point.position for o in good), *lost]
        ),
        _column(
            "contact_point_error", "m", "its standard error", [*(o.solution.zero_point.error for o in good), *lost]
        ),
        _column("drift", "m/s", "thermal drift", [*(o.solution.drift.rate for o in good), *lost]),
        _column("drift_error", "m/s", "its standard error", [*(o.solution.drift.error or np.nan for o in good), *lost]),
        _column(
            "doubts",
            None,
            "what makes the answer doubtful",
            [*(doubts.get(o.name, "") for o in good), *("" for _ in failed)],
        ),
        _column("failure", None, "why a curve has no answer", [*("" for _ in good), *(one.reason for one in failed)]),
    ]
    return columns


def _continuous(outcome: NanoindentationOutcome) -> list[ResultColumn]:
    each = [one.solution for one in outcome.continuous]
    names = [one.name for one in outcome.continuous for _ in one.solution.points]
    words = {
        "depth": ("m", "depth"),
        "force": ("N", "force"),
        "contact_depth": ("m", "contact depth"),
        "modulus": ("Pa", "reduced modulus"),
        "young": ("Pa", "Young's modulus of the sample"),
        "young_errors": ("Pa", "standard uncertainty of Young's modulus, without noise"),
        "hardness": ("Pa", "hardness"),
        "hardness_errors": ("Pa", "standard uncertainty of the hardness, without noise"),
    }
    columns = [_column("curve", None, "where the curve comes from", names)]
    for name, (unit, meaning) in words.items():
        content = np.concatenate([getattr(one, name) for one in each])
        columns.append(_column(name.replace("_errors", "_error"), unit, meaning, content))
    return columns


def _first_yield(found: PopInStatistics) -> list[ResultColumn]:
    return [
        _column("force", "N", "force at the first pop-in", found.force),
        _column("stress", "Pa", "greatest shear stress at the first pop-in", found.stress),
        _column("probability", "", "cumulative probability", found.probability),
    ]


def _readings(outcome: NanoindentationOutcome) -> list[ResultColumn]:
    item = outcome.calibration[0]
    return [
        _column("curve", None, "where the curve comes from", item.curve_names),
        _column("force", "N", "force at the peak", item.force),
        _column("contact_depth", "m", "contact depth", item.contact_depth),
        _column("area", "m^2", "area that the stiffness demands", item.measured_area),
        _column("residual", "", "ln of the measured over the fitted compliance of the contact", item.residuals),
    ]
