"""The sheet of the stresses inside a contact: the greatest of each kind at each depth."""

from __future__ import annotations

from typing import TypeGuard

import numpy as np

from winkler.fields.restoration import SubsurfaceFields, restore
from winkler.media.halfspace import HalfSpace
from winkler.media.interior.tensor import measure_named
from winkler.media.offers import LayerStack, offers
from winkler.numerics.types import Array
from winkler.plot.dispatch import without_extent
from winkler.plot.normal.depths import ACROSS, DEEPEST, DOWN, FARTHEST, NAMES, depth_sheet
from winkler.plot.panel import Sheet
from winkler.problems.line.stress import LineFields
from winkler.problems.normal.elliptic import EllipticSolution
from winkler.problems.normal.elliptic_fields import EllipticFields
from winkler.problems.normal.greatest_stress import INTERFACE_OFFSET
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.normal.onset.ellipse_in_layers import EllipseInLayers
from winkler.problems.subsurface.contact_stress import ContactStressSolution

FEW_DOWN = 25
"""Depths below an ellipse on layers, at each of which waves in all directions are summed."""


@without_extent(ContactStressSolution)
def contact_stress_sheet(item: ContactStressSolution) -> Sheet:
    """Return the greatest stresses at each depth, below the shorter axis of an ellipse, and the greatest of all."""
    greatest = {name: (getattr(item, name), abs(getattr(item, f"{name}_depth"))) for name in NAMES}
    return depth_sheet(np.abs(_depths(item)), _at_depths(item), greatest)


def _width(item: ContactStressSolution) -> float:
    contact = item.contact
    if isinstance(contact, EllipticSolution):
        return float(min(contact.longitudinal_semi_axis, contact.lateral_semi_axis))
    return float(contact.radius if isinstance(contact, IndentationSolution) else contact.half_width)


def _on_layers(contact: object) -> TypeGuard[EllipticSolution]:
    return isinstance(contact, EllipticSolution) and not isinstance(contact.problem.medium, HalfSpace)


def _depths(item: ContactStressSolution) -> Array:
    few, medium = _on_layers(item.contact), item.problem.medium
    side = 1.0 if few else float(np.copysign(1.0, item.max_shear_depth))  # an ellipse in the body with the layers
    z = DEEPEST * _width(item) * np.linspace(1e-4, 1.0, FEW_DOWN if few else DOWN)
    if side > 0.0 and offers(medium, LayerStack):  # stresses jump where layers end
        faces = np.array([bottom for _, bottom in medium.spans if bottom < z[-1]])
        z = np.unique(np.concatenate([z, faces, (1.0 + INTERFACE_OFFSET) * faces]))
    return np.asarray(side * z)


def _at_depths(item: ContactStressSolution) -> dict[str, Array]:
    """Return the greatest of each stress at each depth [Pa]."""
    contact = item.contact
    if _on_layers(contact):
        problem, force = contact.problem, float(contact.force)
        inside = EllipseInLayers(problem.bodies.together, problem.medium, (0.0, 0.0))
        return {
            name: np.array([inside.at_depth(force, z, measure_named(name, "ContactStress")) for z in _depths(item)])
            for name in NAMES
        }
    x, z = FARTHEST * _width(item) * np.linspace(0.0, 1.0, ACROSS)[:, None], _depths(item)
    below: SubsurfaceFields | EllipticFields | LineFields
    if isinstance(contact, IndentationSolution):
        below = restore(contact, x, z)
        along = np.abs(below.shear_stress)
    elif isinstance(contact, EllipticSolution):
        shorter_is_y = contact.lateral_semi_axis <= contact.longitudinal_semi_axis
        along_x, along_y = (np.zeros(1), x) if shorter_is_y else (x, np.zeros(1))
        below = contact.stresses(along_x, along_y, z)
        along = below.orthogonal_shear
    else:
        below = contact.stresses(x, z)
        along = np.abs(below.xz_stress)
    found = zip(NAMES, (below.von_mises, below.max_shear, along), strict=True)
    return {name: np.max(content, axis=0) for name, content in found}
