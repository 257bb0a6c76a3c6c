"""Pictures of nanoindentations: modulus and hardness over depth, a calibrated area, first yield."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fitting.nanoindentation.calibration_solution import IndenterCalibration
from winkler.fitting.nanoindentation.continuous import ContinuousIndentationSolution
from winkler.fitting.nanoindentation.measurement import NanoindentationSolution
from winkler.fitting.nanoindentation.pop_ins import PopInStatistics
from winkler.fitting.nanoindentation.readings import area_of
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Area, Line, Panel, PanelAxis, Rule, Sheet
from winkler.plot.series import Series
from winkler.values.vocabulary import Word

DEPTH = Word("h_c", "m", "contact depth")
YOUNG, HARDNESS = Word("E", "Pa", "Young's modulus"), Word("H", "Pa", "hardness")
HEADROOM = 0.1
WIDTH = 1.959963984540054
"""Half-width of an interval of 95 % in standard errors."""


@without_extent(NanoindentationSolution)
def nanoindentation_sheet(item: NanoindentationSolution) -> Sheet:
    """Return an indentation: force over depth with its unloadings, and modulus and hardness with 95 % intervals."""
    problem = item.problem
    stiffness = problem.indenter.frame_compliance + problem.curve.compliance
    force = problem.curve.force - item.zero_point.baseline
    time = problem.curve.time
    drift = item.drift.rate * (time - time[0]) if problem.curve.timed else 0.0
    depth = problem.curve.position - item.zero_point.position - stiffness * force - drift
    place, load = (
        Series("depth", Word("h", "m", "depth"), np.asarray(depth)),
        Series("force", Word("F", "N", "force"), force),
    )
    marks: list[Any] = [Line(place.content, load.content, style.INK, width=1.0, coarse=problem.curve.count > 4000)]
    share = np.linspace(0.0, 1.0, 100)
    for number in range(item.force.size):
        law = item.final_depth[number] + share * (item.depth[number] - item.final_depth[number])
        name = "fitted unloadings" if not number else ""
        marks.append(Line(law, item.force[number] * share ** item.exponent[number], style.RED, width=1.2, name=name))
    marks.append(Line(item.depth, item.force, style.RED, width=0.0, marker="o", size=3.0))
    curve = Panel(tuple(marks), PanelAxis.of(place, margin=0.02), PanelAxis.of(load, margin=0.04), legend="upper left")
    others = over_depth([item])
    return Sheet((curve.plus(title="curve"), *others), width=4.0, height=3.2)


def over_depth(items: list[NanoindentationSolution]) -> tuple[Panel, Panel]:
    """Return Young's modulus and hardness of all unloadings over the contact depth, with 95 % intervals."""
    depth = np.concatenate([item.contact_depth for item in items])
    panels = []
    for word, name in ((YOUNG, "young"), (HARDNESS, "hardness")):
        numbers = np.concatenate([getattr(item, name) for item in items])
        errors = np.concatenate([getattr(item, f"{name}_errors") for item in items])
        series = Series(name, word, numbers)
        line = Line(
            depth, numbers, style.BLUE, width=1.0, marker="o", size=3.5, error_y=np.stack([WIDTH * errors] * 2),
            error_colour=style.MUTED,
        )  # fmt: skip
        place = Series("contact_depth", DEPTH, depth)
        panels.append(
            Panel((line,), PanelAxis.of(place, margin=0.06), PanelAxis.of(series, margin=0.15), title=word.meaning)
        )
    return panels[0], panels[1]


@without_extent(IndenterCalibration)
def calibration_sheet(item: IndenterCalibration) -> Sheet:
    """Return a calibration: the area over its fit, and what is left of every reading."""
    order = np.argsort(item.contact_depth)
    depth = item.contact_depth[order]
    along = np.linspace(float(depth[0]), float(depth[-1]), 200)
    fitted, error = area_of(item.indenter.area.coefficients, along), item.area_error(along)
    place = Series("contact_depth", DEPTH, depth)
    ratio = item.measured_area[order] / area_of(item.indenter.area.coefficients, depth) - 1.0
    size = Series("area", Word("A", "m^2", "projected area"), item.measured_area[order])
    ideal = 24.5 * along**2
    left = Panel(
        (
            Line(along, ideal, style.MUTED, width=1.0, dash=(4.0, 2.0), name="ideal, $24.5\\,h_c^2$"),
            Line(along, fitted, style.RED, width=1.4, name="fitted"),
            Line(depth, size.content, style.BLUE, width=0.0, marker="o", size=3.5, name="readings"),
        ),
        PanelAxis.of(place, margin=0.03),
        PanelAxis.of(size, margin=0.05),
        legend="upper left",
        title="area function",
    )
    band = WIDTH * error / fitted
    right = Panel(
        (
            Area(along, -100.0 * band, 100.0 * band, style.RED, name="95 % interval of the fit"),
            Rule(0.0),
            Line(depth, 100.0 * ratio, style.BLUE, width=0.0, marker="o", size=3.5),
        ),
        PanelAxis.of(place, margin=0.03),
        PanelAxis("area of the reading less the fitted one [%]", headroom=0.2),
        legend="upper right",
        title="what is left",
    )
    return Sheet((left, right), width=4.4, height=3.2)


@without_extent(ContinuousIndentationSolution)
def continuous_sheet(item: ContinuousIndentationSolution) -> Sheet:
    """Return Young's modulus and hardness over depth, with the 95 % interval of the calibration."""
    place = Series("depth", Word("h", "m", "depth"), item.depth)
    panels = []
    for word, numbers, errors in (
        (YOUNG, item.young, item.young_errors),
        (HARDNESS, item.hardness, item.hardness_errors),
    ):
        low, high = _middle_range(numbers)
        series = Series(word.meaning, word, np.clip(numbers, low, high))
        marks: tuple[Any, ...] = (
            Area(item.depth, numbers - WIDTH * errors, numbers + WIDTH * errors),
            Line(item.depth, numbers, width=0.0, marker=".", size=2.0, coarse=numbers.size > 4000),
        )
        panels.append(
            Panel(marks, PanelAxis.of(place, margin=0.02), PanelAxis.of(series, margin=0.1), title=word.meaning)
        )
    return Sheet(tuple(panels), width=4.4, height=3.2)


def _middle_range(numbers: Array) -> tuple[float, float]:
    low, high = np.quantile(numbers, [0.02, 0.98])
    reach = 0.5 * max(float(high - low), 0.05 * abs(float(high)))
    return float(low) - reach, float(high) + reach


@without_extent(PopInStatistics)
def pop_in_sheet(item: PopInStatistics) -> Sheet:
    """Return the cumulative probability of first yield with Weibull's distribution."""
    stress = Series("stress", Word(r"\tau", "Pa", "greatest shear stress"), item.stress)
    along = np.linspace(0.9 * float(item.stress[0]), 1.05 * float(item.stress[-1]), 200)
    marks = (
        Line(along, 1.0 - np.exp(-((along / item.scale) ** item.shape)), style.RED, width=1.4,
             name=f"Weibull, $k$ = {item.shape:.3g}"),
        Line(item.stress, item.probability, style.BLUE, width=0.0, marker="o", size=3.5, name="first pop-ins"),
        Rule(item.mean_stress, upright=True),
    )  # fmt: skip
    return Sheet(
        (Panel(marks, PanelAxis.of(stress, margin=0.03), PanelAxis("cumulative probability"), legend="upper left"),),
        width=4.6, height=3.2,
    )  # fmt: skip
