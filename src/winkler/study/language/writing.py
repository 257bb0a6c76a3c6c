"""Studies as text: TOML that `winkler.study.language.reading.parse_study` reads back, floats to the last digit."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from winkler.study.language import axes
from winkler.study.language.build import unbuild, written_number, written_numbers
from winkler.study.language.designs import Crossed
from winkler.study.language.study import Expectation, Fields, Output, Places, Study


def study_text(study: Study) -> str:
    """Return a study as TOML; `parse_study` gives the same study back, floats to the last digit.

    Examples
    --------
    A study that was made in Python becomes a file by ``Path("study.toml").write_text(study_text(study))``.
    """
    import tomli_w

    table: dict[str, Any] = {"title": study.title} if study.title else {}
    table |= {name: text for name, text in (("source", study.source), ("grade", study.grade)) if text}
    table["problem"] = unbuild(study.problem)
    if study.expect:
        table["expect"] = [_expected(item) for item in study.expect]
    text = tomli_w.dumps(table) + _sweep(study)
    table = {}
    if study.fields != Fields():
        grids = (("r", study.fields.r), ("z", study.fields.z))
        table["fields"] = {name: _places(places) for name, places in grids if places.values.size}
    if study.output != Output():
        table["output"] = _output(study.output)
    return f"{text}\n{tomli_w.dumps(table)}" if table else text


def _sweep(study: Study) -> str:
    """Return the section of the sweep; its keys stay in their order, which drawn points depend on."""
    from winkler.study.language.template import inline

    if not study.sweep:
        return ""
    lines = [] if study.design == Crossed() else [f"design = {inline(axes.written_design(study.design))}"]
    lines += [f"{json.dumps(line.key)} = {inline(axes.written(line, study.problem))}" for line in study.sweep]
    return "\n[sweep]\n" + "\n".join(lines) + "\n"


def _places(places: Places) -> Any:
    if places.relative:
        return {"values": [float(number) for number in places.values], "unit": "a"}
    return written_numbers(places.values, "m")


def _output(output: Output) -> dict[str, Any]:
    table: dict[str, Any] = {"folder": output.folder} if output.folder else {}
    return (
        table
        | {"figures": list(output.figures), "report": output.report}
        | ({"workbook": True} if output.workbook else {})
    )


def _expected(item: Expectation) -> dict[str, Any]:
    unit = item.unit
    expected = item.expected
    table: dict[str, Any] = {"quantity": item.quantity}
    table["value"] = (
        written_numbers(expected, unit) if isinstance(expected, np.ndarray) else written_number(float(expected), unit)
    )
    table["tolerance"] = float(item.tolerance)
    if item.scale:
        table["scale"] = written_number(float(item.scale), unit)
    return table | {name: written_number(float(number), "m") for name, number in item.place}
