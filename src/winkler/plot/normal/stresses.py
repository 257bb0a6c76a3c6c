"""The stress below a contact: a map of one half of the meridian plane, mirrored at the axis, and layer by layer."""

from __future__ import annotations

import dataclasses
import itertools
from typing import Any

import numpy as np

from winkler.fields.peaks import peak_stress
from winkler.fields.restoration import SubsurfaceFields, restore
from winkler.foundation.sheared_fields import BodyFields
from winkler.materials.elastic import Rigid
from winkler.media.medium import Medium
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.extent import is_singular
from winkler.plot.medium import interfaces
from winkler.plot.panel import Line, Map, Panel, PanelAxis, Rule, note
from winkler.plot.series import Series, common_scale, round_numbers, row_of, scale_of, series, with_unit
from winkler.problems.answer import Restorable
from winkler.problems.normal.greatest_stress import least_depth
from winkler.values.errors import InvalidInput

POINTS_ACROSS, POINTS_DOWN = 57, 49
COARSE_POINTS_ACROSS, COARSE_POINTS_DOWN, COARSE_EXTENT_IN_RADII = 31, 25, 2.2
"""Points of a coarse map, and its extent in contact radii."""
DEPTH_IN_RADII = 2.0
"""Depth of the map in contact radii."""
LEVELS = 20
INTERFACE_OFFSET = 1e-9
"""Relative distance of the rows of points on either side of an interface."""
DEPTHS_IN_LAYER = 5
"""Fewest rows of points in a layer, on both of its faces and between them."""


def first_body_deforms(solution: Restorable) -> bool:
    """Return whether the first body (z > 0) deforms; if it is rigid, the second one is drawn."""
    return not isinstance(getattr(solution.pressed.bed.medium, "first", None), Rigid)


def stress_panel(solution: Restorable, extent: float, radius: float, *, scale: float | None = None) -> Panel:
    """Return the von Mises stress below a contact, with a mark where it is greatest.

    Parameters
    ----------
    solution
        For one load, with a contact.
    extent : float
        Drawn up to this distance from the axis [m].
    radius : float
        Contact radius [m].
    scale : float, optional
        Contact radius by which the map is scaled [m], for animations: at fewer points, over a smaller extent, and
        without the search for the maximum.

    Raises
    ------
    OutsideValidity
        If the stresses inside this medium cannot be computed.
    """
    below = first_body_deforms(solution)
    sign, corner = (1.0, "lower centre") if below else (-1.0, "upper centre")
    r = np.linspace(
        0.0,
        min(extent, COARSE_EXTENT_IN_RADII * scale) if scale else extent,
        COARSE_POINTS_ACROSS if scale else POINTS_ACROSS,
    )
    # denser towards the surface; the last bit above zero is enough to stay off the poles of sharp edges
    down = COARSE_POINTS_DOWN if scale else POINTS_DOWN
    z = DEPTH_IN_RADII * (scale or radius) * (np.linspace(0.0, 1.0, down) ** 1.6 + 1e-3) + least_depth(solution.pressed)
    faces = faces_above(solution.pressed.bed.medium, z[-1]) if below else ()
    fields = restore(solution, r[:, None], sign * depths_through(z, faces)[None, :])
    marks: list[Any] = list(interface_rules(fields, solution.pressed.bed.medium))
    if is_singular(solution.pressed):
        marks.append(note("infinite at a sharp edge, kink or tip", corner))
    elif not scale:
        peak = peak_stress(solution, below=below)
        marks.append(Line(np.array([peak.r]), np.array([peak.z]), "white", width=0.0, marker="+", size=9.0))
        off_axis = f", $r$ = {with_unit(peak.r, 'm', 3)}" if peak.r > 1e-3 * radius else ""
        marks.append(
            note(f"greatest: {with_unit(peak.von_mises, 'Pa')} at $z$ = {with_unit(peak.z, 'm', 3)}{off_axis}", corner)
        )
    edge = Line(np.array([-radius, radius]), np.zeros(2), style.RED, width=3.0, clipped=False, blunt=True, order=8.0)
    return field_panel(fields, faces).plus(*marks, edge)


def faces_above(medium: Medium, depth: float) -> tuple[float, ...]:
    """Return the depths of the interfaces above a depth [m]: stresses jump there."""
    return tuple(face for face in interfaces(medium) if face < depth)


def depths_through(z: Array, faces: tuple[float, ...]) -> Array:
    """Return depths of a map [m], with rows on both faces of each layer and between them."""
    ends = itertools.pairwise((0.0, *faces))
    rows = [np.linspace(top * (1.0 + INTERFACE_OFFSET), end * (1.0 - INTERFACE_OFFSET), DEPTHS_IN_LAYER)[top == 0.0 :]
            for top, end in ends]  # fmt: skip
    return np.unique(np.concatenate([z, *rows, np.array(faces[-1:]) * (1.0 + INTERFACE_OFFSET)]))


def interface_rules(fields: SubsurfaceFields | BodyFields, medium: Medium) -> tuple[Rule, ...]:
    """Return the interfaces of a coating in the map of a stress.

    Parameters
    ----------
    fields : SubsurfaceFields or BodyFields
        What the map shows.
    medium : Medium
    """
    depths = [depth for depth in interfaces(medium) if depth < np.max(fields.z)]
    return tuple(Rule(depth, colour=style.INK, width=0.9, dash=(4.0, 2.0), order=7.0) for depth in depths)


def field_panel(fields: SubsurfaceFields, faces: tuple[float, ...] = ()) -> Panel:
    """Return the von Mises stress of fields that were restored on a grid, mirrored at the axis.

    Parameters
    ----------
    fields : SubsurfaceFields
        r and z of shape (n, m), one varying along either axis.
    faces : tuple of float
        As of `stress_map`.
    """
    r, z, stress = (np.asarray(part, dtype=float) for part in (fields.r, fields.z, fields.von_mises))
    if np.ptp(r, axis=0).max() == 0.0:
        r, z, stress = r.T, z.T, stress.T
    r, z, stress = _ordered(r, z, stress)
    if not np.isfinite(stress).any():
        raise InvalidInput(
            "draw: none of the restored stresses is finite; restore the fields below the surface, z > 0."
        )
    first = 0 if r[0, 0] > 0.0 else 1
    x, y, both = (
        np.concatenate([sign * part[first:][::-1], part]) for part, sign in ((r, -1.0), (z, 1.0), (stress, 1.0))
    )
    return stress_map(series("r", x), series("z", y), series("von_mises", both), faces=faces)


def stress_map(along: Series, down: Series, stress: Series, label: str = "", faces: tuple[float, ...] = ()) -> Panel:
    """Return the map of a stress over two series of coordinates ``(n, m)``, depth downwards, between round levels.

    Parameters
    ----------
    along, down, stress : Series
        The stress may be infinite or NaN at some points.
    label : str, optional
        Of the axis across, without a unit.
    faces : tuple of float, optional
        Depths of interfaces [m], at which stresses jump: what lies between them is drawn by itself.
    """
    finite = stress.content[np.isfinite(stress.content)]
    top, greatest = float(np.percentile(finite, 99.5)), float(np.max(finite))
    levels = round_numbers(0.0, greatest if greatest < 1.25 * top else top, LEVELS)
    clipped_stress = np.where(np.isfinite(stress.content), stress.content, 10.0 * levels[-1])
    drawn = Map(
        along.content,
        down.content,
        clipped_stress,
        PanelAxis.of(stress, scale_of("Pa", [levels[-1]])),
        levels=levels,
        lines=levels[1:],
        line_width=0.4,
        line_alpha=0.7,
        extend="max" if float(np.max(clipped_stress)) > levels[-1] else "neither",
        place="inset",
    )
    layer_of = np.searchsorted(np.array(faces), np.abs(down.content[0]))
    parts: list[Map] = []
    for layer in np.unique(layer_of):
        (columns,) = np.nonzero(layer_of == layer)
        part = [each[:, columns] for each in (along.content, down.content, clipped_stress)]
        place = "" if parts else "inset"
        parts.append(dataclasses.replace(drawn, x=part[0], y=part[1], z=part[2], place=place))
    scale, z = common_scale(along, down), down.content
    upright = PanelAxis.of(down, scale, low=max(float(np.max(z)), 0.0), high=min(float(np.min(z)), 0.0))
    upright = dataclasses.replace(upright, label=upright.label.replace("depth below the surface", "depth"))
    across = PanelAxis(label, scale) if label else PanelAxis.of(along, scale)
    return Panel(tuple(parts), across, upright, equal=True, grid="")


def _ordered(r: Array, z: Array, stress: Array) -> tuple[Array, Array, Array]:
    """Return the grid with r and z ascending."""
    rows, columns = np.argsort(r[:, 0], kind="stable"), np.argsort(z[0], kind="stable")
    return r[np.ix_(rows, columns)], z[np.ix_(rows, columns)], stress[np.ix_(rows, columns)]


def along_panel(fields: SubsurfaceFields) -> Panel:
    """Return all stresses along a line, over the coordinate that varies more.

    Parameters
    ----------
    fields : SubsurfaceFields
        r and z of shape (n,).
    """
    name = "z" if np.ptp(fields.z) >= np.ptp(fields.r) else "r"
    names = ("radial_stress", "hoop_stress", "axial_stress", "shear_stress", "von_mises")
    stresses = [(one := row_of(fields, each), one.label().partition(" [")[0]) for each in names]
    return curves_panel(row_of(fields, name), stresses, label="stress")
