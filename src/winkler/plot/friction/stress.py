"""The stress below a sheared contact: a map of the plane of the motion."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fields.peaks import peak_stress
from winkler.fields.restoration import restore_body
from winkler.foundation.bed import Bed
from winkler.foundation.sheared_fields import BodyFields
from winkler.materials.elastic import Rigid
from winkler.plot import style
from winkler.plot.normal.stresses import depths_through, faces_above, interface_rules, stress_map
from winkler.plot.panel import Line, Panel, note
from winkler.plot.series import series, with_unit
from winkler.problems.answer import Dragged, SelfRestoring, is_dragged, is_self_restoring
from winkler.values.errors import InvalidInput

POINTS_ACROSS, POINTS_DOWN = 113, 49
COARSE_POINTS_ACROSS, COARSE_POINTS_DOWN = 61, 25
"""Points of a coarse map."""
DEPTH_IN_RADII = 1.6
"""Depth of the map in contact radii."""


def dragged_stress_panel(
    solution: Dragged | SelfRestoring, radius: float, extent: float, *, first: bool = True, scale: float | None = None
) -> Panel:
    """Return the von Mises stress in the plane y = 0 of a sheared contact, with a mark where it is greatest.

    Parameters
    ----------
    solution : Dragged or SelfRestoring
        One state of it.
    radius, extent : float
        Of the contact, and of the picture [m].
    first : bool
        Whether in the first body.
    scale : float, optional
        Contact radius by which the depth is scaled [m], for animations: at fewer points, without the search for the
        maximum.

    Raises
    ------
    OutsideValidity
        If the stresses inside this medium cannot be computed.
    """
    sign = 1.0 if first else -1.0
    across, down = (COARSE_POINTS_ACROSS, COARSE_POINTS_DOWN) if scale else (POINTS_ACROSS, POINTS_DOWN)
    x = np.linspace(-extent, extent, across)
    z = DEPTH_IN_RADII * (scale or radius) * (np.linspace(0.0, 1.0, down) ** 1.6 + 1e-3)
    if is_self_restoring(solution):
        medium = solution.medium
    else:
        assert is_dragged(solution)
        medium = solution.sheared.pressed.bed.medium
    faces = faces_above(medium, z[-1]) if first else ()
    fields = restore_body(solution, x[:, None], 0.0, sign * depths_through(z, faces)[None, :])
    rules = interface_rules(fields, medium) if first else ()
    edge = Line(np.array([-radius, radius]), np.zeros(2), style.INK, width=3.0, clipped=False, blunt=True, order=8.0)
    if scale:
        return body_stress_panel(fields, faces).plus(*rules, edge)
    peak = peak_stress(solution, below=sign > 0.0)
    corner = "lower centre" if sign > 0.0 else "upper centre"
    marks: list[Any] = [note("infinite at a sharp edge, kink or tip", corner)]
    if np.isfinite(peak.von_mises):
        look: dict[str, Any] = {"marker": "P", "size": 9.0, "edge": "white", "clipped": False, "order": 9.0}
        off_plane = f"$y$ = {with_unit(peak.y, 'm', 3)}, " if abs(peak.y) > 1e-3 * radius else ""
        position = f"$x$ = {with_unit(peak.x, 'm', 3)}, {off_plane}$z$ = {with_unit(peak.z, 'm', 3)}"
        marks = [
            Line(np.array([peak.x]), np.array([peak.z]), style.RED, width=0.0, **look),
            note(f"greatest: {with_unit(peak.von_mises, 'Pa')} at {position}", corner),
        ]
    return body_stress_panel(fields, faces).plus(*rules, *marks, edge)


def in_first(bed: Bed) -> bool:
    """Return whether the first body of a bed has stresses to be shown: that it is not rigid."""
    return not isinstance(getattr(bed.medium, "first", None), Rigid)


def body_stress_panel(fields: BodyFields, faces: tuple[float, ...] = ()) -> Panel:
    """Return the von Mises stress of fields that were restored on a grid of x and z.

    Parameters
    ----------
    fields : BodyFields
        x and z of shape (n, m), one varying along either axis.
    faces : tuple of float
        Depths of interfaces [m], between which is drawn by itself.

    Raises
    ------
    InvalidInput
        If they do not form such a grid.
    """
    if fields.x.ndim != 2 or min(fields.x.shape) < 2:
        raise InvalidInput(
            "draw: the fields were not restored on a grid of x and z; give restore_body(solution, x[:, None], y, "
            "z[None, :])."
        )
    if not np.isfinite(fields.von_mises).any():
        raise InvalidInput("draw: none of the restored stresses is finite; restore them below the surface.")
    x, z, stress = (series(name, getattr(fields, name)) for name in ("x", "z", "von_mises"))
    return stress_map(x, z, stress, "along the motion $x$", faces)
