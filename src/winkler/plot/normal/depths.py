"""The sheet of the greatest stresses at each depth below a contact, and that of a round one."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping

import numpy as np

from winkler.fields.restoration import restore
from winkler.foundation.bed import Bed
from winkler.loading.loads import Depth
from winkler.media.interior.tensor import KINDS
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.panel import Panel, PanelAxis, Sheet, among, points
from winkler.plot.series import common_scale, series, with_unit
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.strong_parts import elastic_parts
from winkler.problems.subsurface.below_disc import below_disc

ACROSS, DOWN = 61, 81
"""Places of the plane of which the greatest at each depth is drawn."""
FARTHEST, DEEPEST = 1.2, 2.0
"""How far and deep it reaches, over the contact radius, the half-width or the shorter semi-axis."""
ROOM = 1.05
"""Greatest value on the axis of stresses, over the greatest stress."""
NAMES = {
    "von_mises": "von Mises stress",
    "max_shear": "greatest shear stress",
    "orthogonal_shear": "orthogonal shear stress",
}


def disc_sheet(bed: Bed, depth: float) -> Sheet:
    """Return the greatest stresses at each depth below a round contact of homogeneous bodies, without friction.

    Parameters
    ----------
    bed : Bed
        The springs.
    depth : float
        How deep they are pressed [m].

    Raises
    ------
    OutsideValidity
        If the bodies do not touch, or the stress is infinite at a sharp edge or apex.
    """
    contact = Indentation(bed, Depth(depth)).solve()
    find, parts = below_disc(contact), elastic_parts(bed.medium)
    found = [max((find(part, kind) for part in parts), key=lambda one: one.value) for kind in KINDS]
    side = float(np.copysign(1.0, found[1].depth))  # of the body with the greatest shear stress
    x, z = (float(contact.radius) * end for end in (FARTHEST * np.linspace(0.0, 1.0, ACROSS)[:, None],
                                                    DEEPEST * np.linspace(1e-4, 1.0, DOWN)))  # fmt: skip
    below = restore(contact, x, side * z)
    stresses = zip(NAMES, (below.von_mises, below.max_shear, np.abs(below.shear_stress)), strict=True)
    greatest = {name: (one.value, abs(one.depth)) for name, one in zip(NAMES, found, strict=True)}
    return depth_sheet(z, {name: np.max(content, axis=0) for name, content in stresses}, greatest)


def depth_sheet(depths: Array, stresses: Mapping[str, Array], greatest: Mapping[str, tuple[float, float]]) -> Sheet:
    """Return the greatest stresses at each depth, and the greatest of all.

    Parameters
    ----------
    depths : ndarray, (n,)
        [m].
    stresses
        ``von_mises``, ``max_shear`` and ``orthogonal_shear`` -> the greatest at each depth [Pa].
    greatest
        The same -> the greatest of all [Pa], and its depth [m].
    """
    drawn = [series(name, content) for name, content in stresses.items()]
    stress = dataclasses.replace(drawn[0], content=np.concatenate([one.content for one in drawn]))
    depth = series("z", depths)
    marks = [among(place, one.content, depth.content, NAMES[one.name]) for place, one in enumerate(drawn)]
    values, places = np.transpose([greatest[name] for name in stresses])
    marks.append(points(values, places, style.INK, size=5.0))
    across = dataclasses.replace(
        PanelAxis.of(stress, common_scale(*drawn), low=0.0, high=ROOM * float(np.max(values))),
        label="greatest stress at a depth",
    )
    upright = PanelAxis.of(depth, depth.scale, low=float(np.max(depth.content)), high=0.0)
    shear, deep = greatest["max_shear"]
    title = f"greatest shear stress {with_unit(shear, 'Pa')} at a depth of {with_unit(deep, 'm')}"
    return Sheet((Panel(tuple(marks), across, upright),), below=len(drawn), width=5.4, height=3.8, title=title)
