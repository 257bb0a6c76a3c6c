"""Sheets of sheared height maps: what sticks and slips with arrows of the traction, its size, and the loop."""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

import numpy as np

from winkler.loading.loads import Angle, ShearForce, Torque
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.friction.curves import loop_panel
from winkler.plot.panel import NO_CONTACT, Panel, Sheet, Text, Vectors, note, titled
from winkler.plot.rough.roughness import framed, image_of
from winkler.plot.series import row_of, series, with_unit
from winkler.problems.profile_pair.rolled_patch import RolledPatch
from winkler.problems.surface_friction.state import SurfaceShearState
from winkler.problems.surface_friction.tangential import SurfaceTangentialSolution
from winkler.problems.surface_rolling.start import SurfaceRollingStartSolution
from winkler.problems.surface_rolling.state import SurfaceRollingStartState, SurfaceRollingState
from winkler.problems.surface_rolling.steady import SurfaceRollingSolution

FRAME_RATIO = 0.08
"""Rim around the contact in a picture, over its size."""
ARROWS_ACROSS = 15
"""Arrows along the larger side of a picture."""
FEWEST_POINTS = 2
ROLLED_ZONES = "stick (green) and slip, rolls to the right"
SHORTEST_ARROW = 0.02
"""Traction over the greatest one below which no arrow is drawn."""


@without_extent(SurfaceTangentialSolution)
def surface_shear_sheet(item: SurfaceTangentialSolution) -> Sheet:
    """Return stick and slip with arrows, the size of the traction at the end of the path, and the loop."""
    more = [_loop(item)] if item.time.size >= FEWEST_POINTS else []
    said = f"{with_unit(item.last.force, 'N')} at a depth of {with_unit(item.last.depth, 'm')}"
    return _beside_maps(item, more, said, "stick (green) and slip")


@without_extent(SurfaceRollingSolution)
def surface_rolling_sheet(item: SurfaceRollingSolution) -> Sheet:
    """Return stick and slip with arrows and the size of the traction under the last creepage, and the creep curve."""
    more = [(_creep_panel(item), "creep force")] if np.size(item.force) >= FEWEST_POINTS else []
    drag = with_unit(float(np.ravel(item.shear_force)[-1]), "N")
    return _beside_maps(item, more, f"{with_unit(item.last.force, 'N')}, shear force {drag}")


@without_extent(SurfaceRollingStartSolution)
def surface_rolling_start_sheet(item: SurfaceRollingStartSolution) -> Sheet:
    """Return stick and slip at the end, the traction, and forces or creepages over the distance."""
    what = "creepage" if isinstance(item.problem.drive, ShearForce) else "force"
    more = []
    if item.distance.size >= FEWEST_POINTS:
        lines = [
            (row_of(item, f"{along}_{what}"), label) for along, label in (("longitudinal", "$x$"), ("lateral", "$y$"))
        ]
        more = [(curves_panel(row_of(item, "distance"), lines, label=what), f"{what} over the distance")]
    return _beside_maps(item, more, f"after {with_unit(item.last.distance, 'm')}")


def _beside_maps(item: Any, more: list[tuple[Panel, str]], said: str, zones: str = ROLLED_ZONES) -> Sheet:
    """Return stick and slip and the traction of the last state, and panels with their names."""
    panels = list(traction_maps(item.problem.topography.pixel, item.last))
    names = [zones, "traction"] if len(panels) > 1 else ["no contact"]
    shown = titled([*panels, *(panel for panel, _ in more)], *names, *(name for _, name in more))
    title = f"{said};  {100.0 * item.last.stick_share:.3g} % of the contact sticks"
    return Sheet(shown, 3, width=4.0, height=3.4, title=title)


def _creep_panel(item: SurfaceRollingSolution) -> Panel:
    """Return forces over the creepage that changes most, in terms of its greatest value."""
    names = ("longitudinal_creepage", "lateral_creepage", "spin_creepage")
    spans = [float(np.ptp(np.asarray(getattr(item, name)))) for name in names]
    size = [float(np.max(np.abs(np.asarray(getattr(item, name))))) or 1.0 for name in names]
    name = names[int(np.argmax([span / most for span, most in zip(spans, size, strict=True)]))]
    forces = [
        (row_of(item, word), label) for word, label in (("longitudinal_force", "$F_x$"), ("lateral_force", "$F_y$"))
    ]
    return curves_panel(row_of(item, name), forces, label="creep force")


def _loop(item: SurfaceTangentialSolution) -> tuple[Panel, str]:
    """Return the loop of the torque, or of the shear force along the direction in which it was greatest."""
    turned = isinstance(item.problem.path.lateral, Angle | Torque)
    names = ("angle", "torque") if turned else ("shift", "shear_force")
    along, of = (np.asarray(getattr(item, name), dtype=float) for name in names)
    if turned:
        panel = loop_panel(series(names[0], along), series(names[1], of))
        title = "torque over the twist"
    else:
        axis = int(np.argmax(np.max(np.abs(of), axis=0)))
        ends = [f"{name}_{'xy'[axis]}" for name in names]
        panel = loop_panel(series(ends[0], along[:, axis]), series(ends[1], of[:, axis]))
        title = "shear force over the shift"
    lost = float(item.dissipation[-1])
    return panel.plus(note(f"lost: {with_unit(lost, 'J')}" if lost > 0.0 else "nothing lost", "upper left")), title


class Zones(NamedTuple):
    """What is drawn of a contact: maps of pressure [Pa], traction [Pa] and of what slips."""

    pressure: Array
    traction: Array
    slipping: Array


def traction_maps(
    pixel: tuple[float, float],
    state: SurfaceShearState | SurfaceRollingState | SurfaceRollingStartState | RolledPatch | Zones,
    corner: tuple[float, float] | None = None,
    frame: tuple[slice, slice] | None = None,
) -> tuple[Panel, ...]:
    """Return the maps of the contact in its frame; one empty panel where nothing touches.

    Parameters
    ----------
    pixel
        [m].
    state
        What its pixels bear.
    corner
        Where the map begins [m]; around its middle by default.
    frame
        Part of the map that is drawn; around the contact by default.
    """
    touching = state.pressure > 0.0
    if not touching.any():
        return (NO_CONTACT,)
    here = sides = frame or frame_of(touching)
    part = touching[here]
    begins = corner or tuple(-0.5 * n * step for n, step in zip(touching.shape, pixel, strict=True))
    starts = [begin + side.start * step for begin, side, step in zip(begins, sides, pixel, strict=True)]
    ends = [np.array([start, start + n * step]) for start, n, step in zip(starts, part.shape, pixel, strict=True)]
    slipping = state.slipping[here]
    stuck, slid = (series("pressure", np.where(part & chosen, 1.0, np.nan)) for chosen in (~slipping, slipping))
    traction = state.traction[(slice(None), *here)]
    size = np.hypot(traction[0], traction[1])
    zones = tuple(
        dataclasses.replace(image_of(of, (colour,), ends), place="", alpha=0.55)
        for of, colour in ((stuck, style.GREEN), (slid, style.ORANGE))
    )
    first = framed(zones[0]).plus(*zones[1:], *_arrows(traction, size, (starts[0], starts[1]), pixel))
    traction_image = image_of(series("traction", np.where(part, size, np.nan)), style.SHADES, ends)
    return first, framed(dataclasses.replace(traction_image, place="inset"))


def frame_of(touching: Array) -> tuple[slice, slice]:
    """Return the part of a map around what touches."""
    return _framed_slice(np.asarray(touching.any(axis=1))), _framed_slice(np.asarray(touching.any(axis=0)))


def _framed_slice(touched: Array) -> slice:
    places = np.flatnonzero(touched)
    rim = 1 + int(FRAME_RATIO * (places[-1] - places[0]))
    return slice(max(int(places[0]) - rim, 0), min(int(places[-1]) + 1 + rim, touched.size))


def _arrows(
    traction: Array, size: Array, start: tuple[float, float], pixel: tuple[float, float]
) -> tuple[Vectors | Text, ...]:
    """Return arrows of the traction at some of the pixels."""
    most = float(np.max(size))
    if most == 0.0:
        return (Text(0.5, 0.5, "no traction", framed=(True, True)),)
    step = max(1, max(size.shape) // ARROWS_ACROSS)
    chosen = np.zeros(size.shape, dtype=bool)
    chosen[step // 2 :: step, step // 2 :: step] = True
    i, j = np.nonzero(chosen & (size > SHORTEST_ARROW * most))
    if not i.size:
        return ()
    x, y = start[0] + (i + 0.5) * pixel[0], start[1] + (j + 0.5) * pixel[1]
    return (Vectors(x, y, traction[0][i, j], traction[1][i, j]),)
