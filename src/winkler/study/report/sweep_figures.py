"""The figures of sweeps with many points: maps of crossed ones, scatter plots of drawn ones, indices of Sobol."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.numerics.types import Array
from winkler.plot.series import Series, name_in_words
from winkler.plot.sweeps import VariancePart, cloud_sheet, map_sheet, part_sheet
from winkler.study.batch.outcome import Outcome
from winkler.study.language import keys
from winkler.study.language.designs import Crossed
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis
from winkler.study.report.figure import ReportFigure, capital, drawn

LEAST_MAP_VALUES = 12
"""Values of each of two keys from which they are shown as a map."""


def varied_series(study: Study, axis: Axis) -> Series:
    """Return the numbers of a varied key with their word."""
    entry = keys.word_at(study, axis.key)
    if ".constants." in axis.key:
        entry = entry._replace(symbol="")  # a name that the user chose, not a symbol of the glossary
    last = axis.key.rpartition(".")[2]
    alike = [line.key for line in study.sweep if line.key.rpartition(".")[2] == last]
    name = last if len(alike) == 1 else axis.key.removeprefix("problem.")
    return Series(name, entry, np.array(axis.values, dtype=float))


def mapped(study: Study) -> bool:
    """Return whether answers are shown as maps: two keys with many numbers each, crossed."""
    fine = all(axis.numeric and len(set(axis.values)) >= LEAST_MAP_VALUES for axis in study.axes)
    return isinstance(study.design, Crossed) and len(study.axes) == 2 and fine


def maps(outcome: Outcome, answers: dict[str, Array]) -> Iterator[ReportFigure]:
    """Yield a map of every one of the answers over two varied keys."""
    along, up = (varied_series(outcome.study, axis) for axis in outcome.study.axes)
    for name, content in answers.items():
        title = capital(f"{name_in_words(name)} over {name_in_words(along.name)} and {name_in_words(up.name)}")
        picture = map_sheet(along, up, Series(name, outcome.word(name), content))
        yield drawn(f"answer_{name}", title, "Lines join points of equal answers.", picture)


def clouds(outcome: Outcome, answers: dict[str, Array]) -> Iterator[ReportFigure]:
    """Yield every one of the answers over each varied number: one dot for each point of the design."""
    along = [varied_series(outcome.study, axis) for axis in outcome.study.axes if axis.numeric]
    for name, content in answers.items():
        picture = cloud_sheet(along, Series(name, outcome.word(name), content))
        title = capital(f"{name_in_words(name)} over what was varied")
        yield drawn(f"answer_{name}", title, "One dot for each point; everything else varies as well.", picture)


def parts(outcome: Outcome) -> Iterator[ReportFigure]:
    """Yield the indices of Sobol of each answer for every key; none for other designs."""
    names = [axis.key.removeprefix("problem.") for axis in outcome.study.axes]
    for one in outcome.indices:
        bars = [
            VariancePart("alone", one.first_order, one.first_order_low, one.first_order_high),
            VariancePart("with the others", one.total_order, one.total_order_low, one.total_order_high),
        ]
        title = capital(f"what makes {name_in_words(one.answer)} scatter")
        sentence = (
            f"Indices of Sobol of first and total order, from {one.pairs} pairs of points, with intervals of 95 %."
        )
        yield drawn(f"sensitivity_{one.answer}", title, sentence, part_sheet(names, bars))
