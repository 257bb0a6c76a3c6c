"""The row of springs at one moment, pressed, stretched, dragged sideways or recovering, in a fixed frame."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.foundation.bed import Bed
from winkler.plot.friction.springs import dragged_panel
from winkler.plot.normal.springs import SpringFrame, plane_profile, springs_panel
from winkler.plot.panel import Panel
from winkler.plot.viscoelastic.springs import recovering_panel
from winkler.problems.answer import is_dragged, is_recovering
from winkler.web.pictures.view import View


def moment_springs(state: Any, bed: Bed, view: View) -> Panel:
    """Return the springs of a contact at one moment.

    Parameters
    ----------
    state
        A solution, or a state along a path, with the compression of its springs.
    bed
        Its plane profile is drawn.
    view
        The frame.
    """
    _, g = plane_profile(bed, view.extent)
    rise = float(np.max(g.content, initial=0.0))
    top = max(min(1.3 * view.sunk, 1.1 * rise), 0.35 * view.sunk)
    frame = SpringFrame(view.extent, view.sunk, -2.3 * view.sunk, top)
    if is_recovering(state):
        return recovering_panel(state, bed, frame)
    dragged = is_dragged(state)
    if dragged:
        return dragged_panel(state.sheared, float(state.stick_radius), view.extent, frame)
    return springs_panel(state.pressed, view.extent, frame)
