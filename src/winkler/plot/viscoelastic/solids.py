"""Sheets of viscoelastic solids: relaxation, creep, storage and loss; and of the half-spaces that they make up."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.materials.relaxation_data import CreepData, DynamicData, RelaxationData
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.springs.exponential_sums import RelaxationSeries, of_relaxation
from winkler.numerics.types import Array
from winkler.plot.decades import Quantity, decades_panel
from winkler.plot.drawing import sheet_of
from winkler.plot.panel import Sheet, note, titled
from winkler.plot.series import Series, series, told
from winkler.plot.viscoelastic.contacts import refuse_extent
from winkler.vocabulary import Word

__all__ = ["half_space_sheet", "proportional_sheet", "solid_sheet"]

POINTS = 161
BEYOND = 30.0
"""Pictures go so many times beyond the least and the greatest time of a solid."""
NOTHING = (np.empty(0), np.empty(0))


@sheet_of.register(ViscoelasticSolid)
def solid_sheet(item: ViscoelasticSolid, *, extent: float | None = None) -> Sheet:
    """Return G(t), J(t), and storage and loss over the frequency; what was measured as points.

    Parameters
    ----------
    item : ViscoelasticSolid
    extent : float, optional
        Has no meaning here.
    """
    refuse_extent(item, extent)
    relaxed = (item.time, item.shear) if isinstance(item, RelaxationData) else NOTHING
    sunk = (item.time, item.compliance) if isinstance(item, CreepData) else NOTHING
    stored, lost = NOTHING, NOTHING
    if isinstance(item, DynamicData):
        stored, lost = (item.angular_frequency, item.storage_shear), (item.angular_frequency, item.loss_shear)
    return _sheet(item, item.series, _span(item.series, item.span), "G", "J", (relaxed, sunk, stored, lost))


@sheet_of.register(ViscoelasticHalfSpace)
def half_space_sheet(item: ViscoelasticHalfSpace, *, extent: float | None = None) -> Sheet:
    """Return E*(t), what a step of load makes of the pair, and storage and loss over the frequency."""
    refuse_extent(item, extent)
    return _sheet(item, item.relaxation, _span(item.relaxation, item.span), "E^*", "C", (NOTHING,) * 4)


@sheet_of.register(RelaxingInProportion)
def proportional_sheet(item: RelaxingInProportion, *, extent: float | None = None) -> Sheet:
    """Return the function of time by which all moduli of a medium are multiplied, and what follows from it."""
    refuse_extent(item, extent)
    known = item.relaxation
    return _sheet(item, known, _span(known, item.span), r"\varphi", "", (NOTHING,) * 4, unit="")


def _span(known: RelaxationSeries, span: tuple[float, float]) -> tuple[float, float]:
    """Return the times between which a picture shows a solid [s]."""
    if span[0] > 0.0 and math.isfinite(span[1]):
        return span
    times = np.concatenate([known.times, of_relaxation(known).times])
    times = times if times.size else np.ones(1)  # a dashpot alone has no time of its own
    return float(np.min(times)) / BEYOND, float(np.max(times)) * BEYOND


def _sheet(
    item: Any,
    known: RelaxationSeries,
    span: tuple[float, float],
    modulus: str,
    compliance: str,
    points: tuple[tuple[Array, Array], ...],
    unit: str = "Pa",
) -> Sheet:
    time = series("time", np.geomspace(*span, POINTS))
    omega = series("angular_frequency", 1.0 / time.content[::-1])
    dynamic = known.dynamic(omega.content)

    def of(content: Array, symbol: str, unit: str, meaning: str) -> Series:
        return Series(meaning, Word(symbol, unit, meaning), np.asarray(content))

    relaxes = of(known.at(time.content), f"{modulus}(t)", unit, "relaxation")
    creeps = of(
        of_relaxation(known).at(time.content),
        f"{compliance}(t)" if compliance else "",
        f"1/{unit}" if unit else "",
        "creep",
    )
    stored, lost = of(dynamic.real, "", unit, "storage"), of(dynamic.imag, "", unit, "loss")
    relaxation = decades_panel(time, [Quantity(relaxes, points=points[0])])
    if known.viscosity > 0.0:
        relaxation = relaxation.plus(note(f"at once an impulse of {told(known.viscosity, 'Pa s')}", "lower left"))
    pair = [
        Quantity(stored, "storage" if "*" in modulus else f"storage ${modulus}'$", points[2]),
        Quantity(lost, "loss" if "*" in modulus else f"loss ${modulus}''$", points[3]),
    ]
    panels = (
        relaxation,
        decades_panel(time, [Quantity(creeps, points=points[1])]),
        decades_panel(omega, pair, "modulus" if unit else "part of the moduli"),
    )
    titles = ("relaxation", "creep", "storage and loss")
    return Sheet(titled(panels, *titles), width=3.9, height=3.2, title=type(item).__name__)
