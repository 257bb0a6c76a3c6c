"""The picture of the method for viscoelastic contacts: springs that are pressed, and springs that recover."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.normal.springs import DrawnSprings, SpringFrame, row_panel, spring_places
from winkler.plot.panel import NO_CONTACT, Area, Line, Panel, PanelAxis
from winkler.plot.series import places, series
from winkler.problems.viscoelastic.states import ViscoelasticState
from winkler.problems.viscoelastic.tangential import DraggedState
from winkler.problems.viscoelastic.torsion import DraggedTwist

RecoveringState = ViscoelasticState | DraggedState | DraggedTwist

RADII_DRAWN = 1.35
"""Extent of a picture relative to the deformed region."""
RECOVERED_SHARE = 1e-3
"""Springs compressed by less than this part of the greatest compression count as recovered."""
NO_POINTS = np.empty(0)


def width_of(state: RecoveringState) -> float:
    """Return the extent of the picture of a state [m]: beyond the contact and the springs that have not recovered."""
    deepest = float(np.max(state.recess))
    moved = state.position[state.recess > RECOVERED_SHARE * deepest] if deepest > 0.0 else state.position[:0]
    return RADII_DRAWN * max(float(np.max(moved, initial=0.0)), state.radius, float(state.position[0]))


def recovering_panel(state: RecoveringState, bed: Bed | None = None, frame: SpringFrame | None = None) -> Panel:
    """Return the springs at one time: in contact, recovering, and at rest.

    Parameters
    ----------
    state : ViscoelasticState, DraggedState or DraggedTwist
    bed : Bed, optional
        Its plane profile is drawn over the springs.
    frame : Frame, optional
        Fixed frame, for animations.
    """
    if frame is None:
        extent, deepest = width_of(state), float(np.max(state.recess))
        unit = deepest if deepest > 0.0 else extent
        frame = SpringFrame(extent, unit, -2.4 * unit, 1.1 * unit)
    place = spring_places(frame.extent)
    sunk = np.interp(np.abs(place), state.position, state.recess, right=0.0)
    pressed = (np.abs(place) <= state.radius) & (state.radius > 0.0)
    least = RECOVERED_SHARE * max(float(np.max(state.recess)), 1e-300)
    colours = [
        style.RED if pressed_down else style.GREEN if sunk_here > least else style.MUTED
        for sunk_here, pressed_down in zip(sunk, pressed, strict=True)
    ]
    strength = np.array([0.55 if colour == style.MUTED else 0.95 for colour in colours])
    row = DrawnSprings(place, sunk, np.zeros(place.shape), tuple(colours), np.full(place.shape, 1.1), strength)
    names = (
        Line(NO_POINTS, NO_POINTS, style.RED, name="pressed"),
        Line(NO_POINTS, NO_POINTS, style.GREEN, name="recover freely"),
    )
    return row_panel(row, bed, float(state.depth), frame).plus(*names, legend="lower center", columns=2)


def pressure_panel(state: ViscoelasticState) -> Panel:
    """Return the pressure over the contact."""
    if state.radius == 0.0:
        return NO_CONTACT.plus(bare=True)
    extent = width_of(state)
    r = places(extent, (state.radius,), count=300)
    pressure: Array = state.pressure(r)
    finite = np.isfinite(pressure)
    x, p = style.mirrored(r[finite], pressure[finite])
    across = PanelAxis.of(series("r", r[finite]), low=-extent, high=extent)
    upright = PanelAxis.of(series("pressure", pressure[finite]), low=0.0)
    return Panel((Area(x, p, 0.0, style.RED), Line(x, p, style.RED)), across, upright)
