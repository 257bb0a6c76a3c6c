"""The picture of the method for viscoelastic contacts: springs that are pressed, and springs that recover."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.normal.springs import Frame, Row, row_panel, spring_places
from winkler.plot.panel import Area, Axis, Line, Panel, note
from winkler.plot.series import places, series
from winkler.problems.viscoelastic.states import ViscoelasticState
from winkler.problems.viscoelastic.tangential_states import ViscoelasticTangentialState

__all__ = ["no_contact", "pressure_panel", "recovering_panel", "width_of"]

Springy = ViscoelasticState | ViscoelasticTangentialState

WIDER = 1.35
"""A picture goes to so many radii of what has been pressed."""
LITTLE = 1e-3
"""Springs that are nearer to their rest than this part of the deepest count as recovered."""
NOTHING = np.empty(0)


def width_of(state: Springy) -> float:
    """Return how far the picture of a state goes [m]: beyond the contact, and beyond what has not recovered."""
    deepest = float(np.max(state.recess))
    moved = state.position[state.recess > LITTLE * deepest] if deepest > 0.0 else state.position[:0]
    return WIDER * max(float(np.max(moved, initial=0.0)), state.radius, float(state.position[0]))


def recovering_panel(state: Springy, bed: Bed | None = None, frame: Frame | None = None) -> Panel:
    """Return the springs at one moment: those that press, those that still recover, and those at rest.

    Parameters
    ----------
    state : ViscoelasticState or ViscoelasticTangentialState
    bed : Bed, optional
        Whose plane profile is drawn over the springs.
    frame : Frame, optional
        What is shown, where it must not depend on this moment alone.
    """
    if frame is None:
        extent, deepest = width_of(state), float(np.max(state.recess))
        unit = deepest if deepest > 0.0 else extent
        frame = Frame(extent, unit, -2.4 * unit, 1.1 * unit)
    place = spring_places(frame.extent)
    sunk = np.interp(np.abs(place), state.position, state.recess, right=0.0)
    pressed = (np.abs(place) <= state.radius) & (state.radius > 0.0)
    least = LITTLE * max(float(np.max(state.recess)), 1e-300)
    colours = [
        style.RED if hit else style.GREEN if down > least else style.MUTED
        for down, hit in zip(sunk, pressed, strict=True)
    ]
    strength = np.array([0.55 if colour == style.MUTED else 0.95 for colour in colours])
    row = Row(place, sunk, np.zeros(place.shape), tuple(colours), np.full(place.shape, 1.1), strength)
    names = (
        Line(NOTHING, NOTHING, style.RED, name="pressed"),
        Line(NOTHING, NOTHING, style.GREEN, name="recover freely"),
    )
    return row_panel(row, bed, float(state.depth), frame).plus(*names, legend="lower center", columns=2)


def no_contact() -> Panel:
    """Return a panel that says that the bodies do not touch."""
    return Panel((note("no contact", "upper centre"),), bare=True)


def pressure_panel(state: ViscoelasticState) -> Panel:
    """Return the pressure over the contact."""
    if state.radius == 0.0:
        return no_contact()
    extent = width_of(state)
    r = places(extent, (state.radius,), count=300)
    pressure: Array = state.pressure(r)
    known = np.isfinite(pressure)
    x, p = style.mirrored(r[known], pressure[known])
    across = Axis.of(series("r", r[known]), low=-extent, high=extent)
    upright = Axis.of(series("pressure", pressure[known]), low=0.0)
    return Panel((Area(x, p, 0.0, style.RED), Line(x, p, style.RED)), across, upright)
