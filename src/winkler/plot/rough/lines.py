"""Sheets of rough line ensembles, nearly circular contacts, and friction of rubber."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import Bounds, curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, plane, points, titled
from winkler.plot.rough.roughness import spectrum_panel
from winkler.plot.series import row_of, scale_of, series, with_unit
from winkler.problems.normal.near_round import NearlyRoundSolution
from winkler.problems.rough.elastomer_friction import ElastomerFrictionSolution
from winkler.problems.rough.line_contact import RoughContactSolution
from winkler.problems.rough.line_indentation import RoughIndentationSolution

MOST_CONTOURS = 6
"""Most contours drawn."""
CONTOUR_DIRECTIONS = 256
"""Directions in which a contour is drawn."""


def _band_of(item: Any, name: str) -> Bounds:
    low, high = np.asarray(getattr(item, f"{name}_band"), dtype=float).reshape(2, -1)
    return Bounds(low, high, "eight lines of ten", style.BLUE)


@without_extent(RoughContactSolution, RoughIndentationSolution)
def lines_sheet(item: RoughContactSolution | RoughIndentationSolution) -> Sheet:
    """Return the spectrum, and depth, stiffness and true area over the force, with bands."""
    spectrum = spectrum_panel([(item.problem.spectrum, "")]).plus(title="power spectrum")
    if np.size(item.force) < 2:
        return Sheet((spectrum, *(_single_panel(item, name) for name in ("depth", "stiffness", "area"))), 2)
    force, stiffness = row_of(item, "force"), [(row_of(item, "stiffness"), "median")]
    if isinstance(item, RoughIndentationSolution):
        stiffness.append((row_of(item, "smooth_stiffness"), "smooth body"))
    panels = (
        curves_panel(force, [(row_of(item, "depth"), "median")], [_band_of(item, "depth")]),
        curves_panel(force, stiffness, [_band_of(item, "stiffness")]),
        curves_panel(force, [(row_of(item, "area"), "Persson")]),
    )
    titles = (f"{name} over force" for name in ("depth", "stiffness", "true contact area"))
    return Sheet((spectrum, *titled(panels, *titles)), 2)


def _single_panel(item: Any, name: str) -> Panel:
    """Return one number of a single load, with its band."""
    of = row_of(item, name)
    middle = float(of.content[0])
    band = np.ravel(np.asarray(getattr(item, f"{name}_band", (middle, middle)), dtype=float))
    low, high = float(band[0]), float(band[-1])
    errors = np.array([[middle - low], [high - middle]])
    point = Line(np.zeros(1), np.array([middle]), marker="o", error_y=errors, cap=6.0)
    across = PanelAxis(low=-1.0, high=1.0, ticks=np.empty(0))
    title = f"{name} under {with_unit(float(np.ravel(item.force)[0]), 'N')}"
    return Panel((point,), across, PanelAxis.of(of, low=0.0, high=1.3 * max(high, middle)), title)


def _interpolated_contour(contour: Array) -> Array:
    """Return a contour in `CONTOUR_DIRECTIONS` directions by trigonometric interpolation."""
    if contour.size >= CONTOUR_DIRECTIONS:
        return contour
    waves = np.fft.rfft(contour)
    if contour.size % 2 == 0:
        waves[-1] *= 0.5
    return np.asarray(np.fft.irfft(waves, CONTOUR_DIRECTIONS) * CONTOUR_DIRECTIONS / contour.size)


@without_extent(NearlyRoundSolution)
def contour_sheet(item: NearlyRoundSolution) -> Sheet:
    """Return the contour of the contact, and the force over the depth."""
    contours = np.reshape(item.contour, (-1, np.shape(item.contour)[-1]))
    drawn = contours[np.unique(np.linspace(0, len(contours) - 1, min(MOST_CONTOURS, len(contours))).astype(int))]
    lines = []
    for place, contour in enumerate(drawn):
        colour = style.shade(0.25 + 0.7 * (place + 1) / len(drawn))
        lines.append(Line(*_places(_interpolated_contour(contour), closed=True), colour))
        if contour.size <= CONTOUR_DIRECTIONS // 8:
            lines.append(points(*_places(contour), colour, size=3.5))
    scale = scale_of("m", drawn)
    axes = plane(scale, margin=0.08)
    panels = [Panel(tuple(lines), *axes, title="contour of the contact", equal=True)]
    if len(contours) > 1:
        panels.append(curves_panel(row_of(item, "depth"), [(row_of(item, "force"), "")]).plus(title="force over depth"))
    return Sheet(tuple(panels), height=3.6)


def _places(radii: Array, *, closed: bool = False) -> tuple[Array, Array]:
    """Return x and y of a contour; `closed`: back to its first point."""
    turns = np.linspace(0.0, 2.0 * math.pi, radii.size + 1)
    x, y = np.append(radii, radii[0]) * np.array([np.cos(turns), np.sin(turns)])
    return (x, y) if closed else (x[:-1], y[:-1])


@without_extent(ElastomerFrictionSolution)
def elastomer_sheet(item: ElastomerFrictionSolution) -> Sheet:
    """Return the coefficient of friction over the velocity, and the spectrum of the surface."""
    velocity = series("velocity", np.ravel(item.problem.velocity), ElastomerFrictionSolution)
    panels = curves_panel(velocity, [(row_of(item, "coefficient"), "")]), spectrum_panel([(item.problem.spectrum, "")])
    titles = ("friction over velocity: a trend", "power spectrum of the surface")
    return Sheet(titled(panels, *titles), height=3.2)
