"""Films of solutions: stick, slip and traction of height maps that are sheared or roll, and dents of metals."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.plot.animation import MOST_FRAMES, PER_SECOND, animated, spread
from winkler.plot.marks import Map
from winkler.plot.panel import NO_CONTACT, Panel, Sheet, titled
from winkler.plot.particles.dent_film import dent_sheets, pressed_of
from winkler.plot.rough.shear import Zones, frame_of, traction_maps
from winkler.problems.subsurface.traction_frames import TractionFrame, frame_at
from winkler.values.errors import InvalidInput
from winkler.values.readable import scale_of


def has_frames(item: Any) -> bool:
    """Return whether a solution has frames of a history."""
    return len(getattr(item, "frames", ())) > 0


def film(item: Any, *, per_second: float = PER_SECOND, form: str = "gif") -> bytes:
    """Return the history of a solution as an animated GIF or an MP4 video.

    Parameters
    ----------
    item : SurfaceTangentialSolution, SurfaceRollingSolution, SurfaceRollingStartSolution, PlasticSolution, \
DentLimitSolution, StrengthFromDentSolution or PlasticImpactSolution
        Of height maps with frames of its states; of an impact with one velocity.
    per_second : float, optional
        States shown in a second.
    form : str, optional
        ``gif``, or ``mp4``, which the program ffmpeg writes.

    Returns
    -------
    bytes
        Contents of the file.

    Raises
    ------
    InvalidInput
        If the solution has no frames, the dent is not round or one of many, nothing is shown in a second, or no program
        writes videos.
    """
    sheets = film_sheets(item, len(item.frames) if has_frames(item) else MOST_FRAMES)
    if sheets is None:
        raise InvalidInput(
            f"film: {type(item).__name__} has no frames; give a solution of SurfaceTangential, SurfaceRolling, "
            "SurfaceRollingStart, PlasticIndentation or PlasticImpact."
        )
    return animated(sheets, per_second=per_second, form=form)


def film_sheets(item: Any, most: int) -> Iterator[Sheet] | None:
    """Return at most so many sheets of the film that a solution has; none if it has no film of its own."""
    if has_frames(item):
        return (film_sheet(item, item.frames[place].index) for place in spread(len(item.frames), most))
    pressed = pressed_of(item)
    return None if pressed is None else dent_sheets(pressed, most)


def film_sheet(item: Any, index: int) -> Sheet:
    """Return stick and slip with arrows, and the traction, in the frame kept at or before a state."""
    frame = frame_at(item.frames, index)
    panels = film_panels(item, index)
    count = int(np.count_nonzero(frame.touching))
    sticks = 100.0 * float(np.count_nonzero(frame.touching & ~frame.slipping)) / max(count, 1)
    title = f"state {frame.index + 1} of {np.shape(item.misfit)[0] if np.ndim(item.misfit) else 1}"
    names = ("stick (green) and slip", "traction")
    return Sheet(titled(panels, *names), 2, width=4.0, height=3.4, title=f"{title};  {sticks:.3g} % sticks")


def film_panels(item: Any, index: int) -> tuple[Panel, Panel]:
    """Return the two maps of a state, in one frame and with one scale for all states of the history."""
    frames, rough = item.frames, item.problem.topography
    ever = np.zeros(rough.heights.shape, dtype=bool)
    for each in frames:
        ever[_part(each)] |= each.touching
    if not ever.any():
        return NO_CONTACT, NO_CONTACT
    frame = frame_at(frames, index)
    state = Zones(
        pressure=_on_map(ever, frame, frame.touching).astype(float),
        slipping=_on_map(ever, frame, frame.slipping),
        traction=np.stack([_on_map(ever, frame, part) for part in frame.traction]).astype(float),
    )
    most = max(float(np.max(np.hypot(*each.traction))) for each in frames)
    zones, size = traction_maps(rough.pixel, state, frame=frame_of(ever)) if frame.touching.any() else (NO_CONTACT,) * 2
    marks = tuple(_scaled(mark, most) for mark in size.marks)
    return zones, dataclasses.replace(size, marks=marks)


def _part(frame: TractionFrame) -> tuple[slice, slice]:
    (i, j), (n, m) = frame.corner, frame.touching.shape
    return slice(i, i + n), slice(j, j + m)


def _on_map(whole: Array, frame: TractionFrame, part: Array) -> Array:
    made = np.zeros(whole.shape, dtype=part.dtype)
    made[_part(frame)] = part
    return made


def _scaled(mark: Any, most: float) -> Any:
    """Return a map with colours up to the greatest traction of all states."""
    if not (isinstance(mark, Map) and most > 0.0):
        return mark
    return dataclasses.replace(mark, bar=dataclasses.replace(mark.bar, scale=scale_of("Pa", most), low=0.0, high=most))
