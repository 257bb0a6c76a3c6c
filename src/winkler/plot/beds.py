"""Sheets of beds and media: body and springs, stiffness of the springs, and composition of the medium."""

from __future__ import annotations

import dataclasses
from typing import Any

from winkler.foundation.elliptic import EllipticFoundation
from winkler.foundation.foundation import Foundation
from winkler.foundation.measured import MeasuredBed
from winkler.foundation.plane import PlaneFoundation
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.coated import StackMedium
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.medium import Medium
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import checked_extent, typical
from winkler.plot.medium import (
    body_is_defined,
    makeup_panel,
    spring_stiffness_panel,
    stiffness_panel,
    stiffness_text,
    typical_width,
)
from winkler.plot.method import bed_panels
from winkler.plot.normal.body import body_panel
from winkler.plot.normal.springs import at_first_touch, springs_panel
from winkler.plot.panel import Panel, Sheet, titled


@sheet_of.register(Foundation)
@sheet_of.register(PlaneFoundation)
def _bed(item: Any, *, extent: float | None = None) -> Sheet:
    end = checked_extent(extent) or (1.6 if item.rim <= item.reach else 1.0) * typical(_elastic(item))
    if not body_is_defined(_elastic(item)):
        return _general_body(item, extent)
    shape = item.profile if isinstance(item, Foundation) else item.plane_profile
    name = type(shape).__name__ if isinstance(item, Foundation) else "the body that belongs to $g(x)$"
    bed = _elastic(item)
    return _beside_springs(item, body_panel(bed, end).plus(title=name), bed, end)


@sheet_of.register(EllipticFoundation)
def _general_body(item: Any, extent: float | None = None) -> Sheet:
    """Draw the bed of a body that is not axisymmetric, whose line load gives no pressure."""
    bed = _elastic(item)
    end = checked_extent(extent) or typical(bed)
    return _beside_springs(item, stiffness_panel(bed, end).plus(title="stiffness"), bed, end)


def _elastic(item: Any) -> Any:
    relaxes = offers(item.medium, RelaxingMedium)
    return dataclasses.replace(item, medium=item.medium.elastic) if relaxes else item


def _beside_springs(item: Any, left: Panel, bed: Any, end: float) -> Sheet:
    kind = "that relax" if offers(item.medium, RelaxingMedium) else stiffness_text(bed, end)
    return Sheet((left, springs_panel(at_first_touch(bed), end).plus(title=f"springs {kind} under $g(x)$")), height=3.3)


@sheet_of.register(MeasuredBed)
def _measured(item: MeasuredBed, *, extent: float | None = None) -> Sheet:
    end = checked_extent(extent) or item.reach
    panels = (*bed_panels(item, end), springs_panel(at_first_touch(item), end))
    return Sheet(titled(panels, "measured stiffness", "its springs", "springs under $g(x)$"), width=3.9, height=3.3)


@sheet_of.register(StackMedium)
@sheet_of.register(DepthGradedHalfSpace)
@sheet_of.register(GradedHalfSpace)
def _medium(item: Medium, *, extent: float | None = None) -> Sheet:
    end = checked_extent(extent) or typical_width(item)
    panels = makeup_panel(item, end), spring_stiffness_panel(item, end)
    return Sheet(titled(panels, "the body, from its surface down", "stiffness of the springs"), height=3.3)
