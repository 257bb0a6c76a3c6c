"""Sheets of the frictional heat of maps: the flux, the temperature of a surface, both surfaces along the motion."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Arrow, Panel, PanelAxis, Rule, Sheet, Strokes, among, points, titled
from winkler.plot.rough.roughness import framed, image_of
from winkler.plot.series import Series, common_scale, row_of, scale_of, series, with_unit
from winkler.problems.surface_heating.state import SurfaceHeatState
from winkler.problems.surface_heating.steady import SurfaceFrictionHeatingSolution

RIM = 0.4
"""Frame around the contact, over its size."""
FEWEST_POINTS = 2
IN_A_ROW = 3


class Frame(NamedTuple):
    """The part of a map that is drawn.

    Parameters
    ----------
    part
        Its pixels.
    x, y
        Its middles of pixels [m].
    pixel
        [m].
    """

    part: tuple[slice, slice]
    x: Array
    y: Array
    pixel: tuple[float, float]

    @property
    def sides(self) -> tuple[Array, Array]:
        """Both ends along x and along y [m]."""
        x, y = (
            np.array([row[0] - 0.5 * step, row[-1] + 0.5 * step])
            for row, step in zip((self.x, self.y), self.pixel, strict=True)
        )
        return x, y


@without_extent(SurfaceFrictionHeatingSolution)
def surface_friction_heating_sheet(item: SurfaceFrictionHeatingSolution) -> Sheet:
    """Return flux, temperature of the first surface, both along the motion under the last creepage; many: the curve."""
    panels = _panels(item.last, item.problem.places, item.problem.speeds)
    if np.size(item.heat_rate) >= FEWEST_POINTS:
        names = ("max_temperature", "mean_temperature")
        curves = [
            (row_of(item, name), label) for name, label in zip(names, ("greatest of the contact", "mean"), strict=True)
        ]
        curve = curves_panel(row_of(item, "heat_rate"), curves, label="temperature")
        panels = (*panels, curve.plus(title="all creepages"))
    state = item.last
    share = f"first body conducts {100.0 * state.first_share:.3g} %"
    hottest = with_unit(state.max_temperature, "K")
    title = f"$T_\\mathrm{{max}}$ = {hottest}   heat {with_unit(state.heat_rate, 'W')}   {share}"
    return Sheet(panels, len(panels) if len(panels) <= IN_A_ROW else 2, width=4.4, height=3.4, title=title)


def _panels(state: SurfaceHeatState, middles: tuple[Array, Array], speeds: tuple[float, float]) -> tuple[Panel, ...]:
    place = state.x, state.y
    frame = _frame(state.pressure > 0.0, middles)
    touching = (state.pressure > 0.0)[frame.part]
    flux = series("flux", np.where(touching, state.flux[frame.part], np.nan), SurfaceHeatState)
    moves = speeds[0] if speeds[0] != 0.0 else speeds[1]
    which = "first" if speeds[0] != 0.0 or speeds[1] == 0.0 else "second"
    warm = series(f"{which}_temperature", getattr(state, f"{which}_temperature")[frame.part], SurfaceHeatState)
    hottest = points([place[0]], [place[1]], "white", marker="+", size=9.0)
    marks: list[Any] = [_outline(touching, frame), hottest]
    if moves != 0.0:
        marks.append(_passing(frame, moves))
    return titled(
        (_map(frame, flux), _map(frame, warm).plus(*marks), _along(state, middles, frame, place, moves)),
        "heat of friction",
        f"surface of the {which} body; + hottest" + (", → its motion" if moves else ""),
        f"along x at y = {with_unit(place[1], 'm', 3)}",
    )


def _frame(touching: Array, middles: tuple[Array, Array]) -> Frame:
    """Return the contact with some of its surroundings."""
    sides = []
    for axis in (0, 1):
        found = np.flatnonzero(touching.any(axis=1 - axis))
        rim = 1 + int(RIM * (found[-1] - found[0]))
        sides.append(slice(max(int(found[0]) - rim, 0), min(int(found[-1]) + 1 + rim, touching.shape[axis])))
    steps = [float((row[-1] - row[0]) / (row.size - 1)) for row in middles]
    return Frame((sides[0], sides[1]), middles[0][sides[0]], middles[1][sides[1]], (steps[0], steps[1]))


def _map(frame: Frame, of: Series) -> Panel:
    low = 0.0 if np.nanmin(of.content) >= 0.0 else float(np.nanmin(of.content))
    return framed(image_of(of, style.HEATS, frame.sides, lowest=low))


def _outline(touching: Array, frame: Frame) -> Strokes:
    """Return the border of the contact, along the edges of its pixels."""
    (x0, y0), (dx, dy) = (float(side[0]) for side in frame.sides), frame.pixel
    padded = np.pad(touching, 1)
    i, j = np.nonzero(padded[1:, 1:-1] != padded[:-1, 1:-1])
    k, m = np.nonzero(padded[1:-1, 1:] != padded[1:-1, :-1])
    x = x0 + dx * np.concatenate([np.stack([i, i], axis=1), np.stack([k, k + 1], axis=1)])
    y = y0 + dy * np.concatenate([np.stack([j, j + 1], axis=1), np.stack([m, m], axis=1)])
    return Strokes(x, y, (style.INK,) * len(x), np.full(len(x), 0.8), np.ones(len(x)))


def _passing(frame: Frame, velocity: float) -> Arrow:
    """Return an arrow along the motion of the surface, in a corner of the frame."""
    x, y = frame.sides
    long, high = 0.22 * float(np.ptp(x)), float(y[0] + 0.93 * np.ptp(y))
    ends = (float(x[0]) + 0.05 * float(np.ptp(x)), float(x[0]) + 0.05 * float(np.ptp(x)) + long)
    start, stop = ends if velocity > 0.0 else ends[::-1]
    return Arrow((start, high), (stop, high), style.INK)


def _along(
    state: SurfaceHeatState, middles: tuple[Array, Array], frame: Frame, place: tuple[float, float], moves: float
) -> Panel:
    """Return the temperature of both surfaces on the line along the motion through the hottest place."""
    row = int(np.argmin(np.abs(middles[1] - place[1])))
    lines = [
        (
            series(f"{name}_temperature", getattr(state, f"{name}_temperature")[frame.part[0], row], SurfaceHeatState),
            look,
        )
        for name, look in (("first", (style.RED, style.DASHES[0])), ("second", (style.BLUE, style.DASHES[1])))
    ]
    marks: list[Any] = [
        among(place, frame.x, of.content, name, colour=colour, dash=dash)
        for place, ((of, (colour, dash)), name) in enumerate(zip(lines, ("first body", "second body"), strict=True))
    ]
    touching = np.flatnonzero((state.pressure > 0.0)[frame.part[0], row])
    if touching.size:
        half = 0.5 * frame.pixel[0]
        ends = (float(frame.x[touching[0]]) - half, float(frame.x[touching[-1]]) + half)
        marks += [Rule(end, upright=True, width=0.9, dash=style.DOTTED) for end in ends]
    both = common_scale(*(of for of, _ in lines))
    return Panel(
        tuple(marks),
        PanelAxis("place $x$", scale_of("m", frame.x), margin=0.0),
        PanelAxis("temperature $T$", both, margin=0.12),
        legend="upper left" if moves > 0.0 else "upper right",
    )
