"""Sheets of viscoelastic solids: relaxation, creep, storage and loss; and of viscoelastic half-spaces."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.materials.relaxation_data import CreepData, DynamicData, RelaxationData
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.media.relaxing.poroelastic import PoroelasticFilm
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.springs.exponential_sums import RelaxationSeries, of_relaxation
from winkler.numerics.types import Array
from winkler.plot.curves import Quantity, curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Sheet, note, titled
from winkler.plot.series import Series, series, with_unit
from winkler.values.vocabulary import Word

POINTS = 161
TIME_FACTOR_BEYOND = 30.0
"""Factor by which the drawn times extend beyond those of the solid."""
LONG_WAVES = "about $6$ thicknesses", "about $60$ thicknesses"
SMALL_WIDTH = 0.01
"""Of cells, over the thickness, up to which waves of a poroelastic film are drawn."""
NO_POINTS = (np.empty(0), np.empty(0))


@without_extent(ViscoelasticSolid)
def solid_sheet(item: ViscoelasticSolid) -> Sheet:
    """Return G(t), J(t), and storage and loss over the frequency; measured points marked.

    Parameters
    ----------
    item : ViscoelasticSolid
    extent : float, optional
        Has no meaning here.
    """
    relaxed = (item.time, item.shear) if isinstance(item, RelaxationData) else NO_POINTS
    crept = (item.time, item.compliance) if isinstance(item, CreepData) else NO_POINTS
    stored, lost = NO_POINTS, NO_POINTS
    if isinstance(item, DynamicData):
        stored, lost = (item.angular_frequency, item.storage_shear), (item.angular_frequency, item.loss_shear)
    return _sheet(item, item.series, _drawn_span(item.series, item.span), "G", "J", (relaxed, crept, stored, lost))


@without_extent(ViscoelasticHalfSpace)
def half_space_sheet(item: ViscoelasticHalfSpace) -> Sheet:
    """Return E*(t), the creep of the pair, and storage and loss over the frequency."""
    return _sheet(item, item.relaxation, _drawn_span(item.relaxation, item.span), "E^*", "C", (NO_POINTS,) * 4)


@without_extent(RelaxingInProportion)
def proportional_sheet(item: RelaxingInProportion) -> Sheet:
    """Return the common relaxation function of all moduli of a medium, and its creep, storage and loss."""
    relaxation_series = item.relaxation
    return _sheet(
        item, relaxation_series, _drawn_span(relaxation_series, item.span), r"\varphi", "", (NO_POINTS,) * 4, unit=""
    )


@without_extent(ViscoelasticCoatedHalfSpace)
def coated_sheet(item: ViscoelasticCoatedHalfSpace) -> Sheet:
    """Return how much waves of pressure sink, over their first amplitude: short and long against the layers."""
    thickness = item.elastic.thickness
    creep = item.creep_of_waves(thickness, thickness)
    time = series("time", np.geomspace(0.1 * float(creep.times[0]), 3.0 * float(creep.times[-1]), POINTS))
    waves = np.array([np.inf, 1.0 / thickness, 0.1 / thickness])
    names = "much shorter than the layers are thick", *LONG_WAVES
    curves = creep.after(waves, time.content) / creep.after(waves, np.zeros(1))
    return _waves_sheet(item, time, curves, names, "amplitude over that at first")


@without_extent(PoroelasticFilm)
def poroelastic_sheet(item: PoroelasticFilm) -> Sheet:
    """Return how much waves of pressure sink, over what they do when the liquid is at rest."""
    thickness = item.thickness
    time = series("time", item.diffusion_time * np.geomspace(1e-4, 10.0, POINTS))
    waves = np.array([10.0, 1.0, 0.1]) / thickness
    curves = item.creep_of_waves(SMALL_WIDTH * thickness, thickness).after(
        waves, np.append(time.content, 1e6 * item.diffusion_time)
    )
    names = "about $0.6$ thicknesses", *LONG_WAVES
    return _waves_sheet(item, time, curves[:, :-1] / curves[:, -1:], names, "amplitude over that at last")


def _waves_sheet(item: Any, time: Series, curves: Array, names: tuple[str, ...], meaning: str) -> Sheet:
    quantities = [
        Quantity(Series(meaning, Word("", "", meaning), curve), name) for curve, name in zip(curves, names, strict=True)
    ]
    panel = curves_panel(time, quantities)
    return Sheet(titled((panel,), "creep under waves of pressure"), width=5.2, height=3.6, title=type(item).__name__)


def _drawn_span(relaxation_series: RelaxationSeries, span: tuple[float, float]) -> tuple[float, float]:
    """Return the range of drawn times of a solid [s]."""
    if span[0] > 0.0 and math.isfinite(span[1]):
        return span
    times = np.concatenate([relaxation_series.times, of_relaxation(relaxation_series).times])
    times = times if times.size else np.ones(1)  # a dashpot alone has no time of its own
    return float(np.min(times)) / TIME_FACTOR_BEYOND, float(np.max(times)) * TIME_FACTOR_BEYOND


def _sheet(
    item: Any,
    relaxation_series: RelaxationSeries,
    span: tuple[float, float],
    modulus: str,
    compliance: str,
    points: tuple[tuple[Array, Array], ...],
    unit: str = "Pa",
) -> Sheet:
    time = series("time", np.geomspace(*span, POINTS))
    omega = series("angular_frequency", 1.0 / time.content[::-1])
    dynamic = relaxation_series.dynamic(omega.content)

    def of(content: Array, symbol: str, unit: str, meaning: str) -> Series:
        return Series(meaning, Word(symbol, unit, meaning), np.asarray(content))

    relaxes = of(relaxation_series.at(time.content), f"{modulus}(t)", unit, "relaxation")
    creeps = of(
        of_relaxation(relaxation_series).at(time.content),
        f"{compliance}(t)" if compliance else "",
        f"1/{unit}" if unit else "",
        "creep",
    )
    stored, lost = of(dynamic.real, "", unit, "storage"), of(dynamic.imag, "", unit, "loss")
    relaxation = curves_panel(time, [Quantity(relaxes, points=points[0])])
    if relaxation_series.viscosity > 0.0:
        relaxation = relaxation.plus(
            note(f"at once an impulse of {with_unit(relaxation_series.viscosity, 'Pa s')}", "lower left")
        )
    pair = [
        Quantity(stored, "storage" if "*" in modulus else f"storage ${modulus}'$", points[2]),
        Quantity(lost, "loss" if "*" in modulus else f"loss ${modulus}''$", points[3]),
    ]
    panels = (
        relaxation,
        curves_panel(time, [Quantity(creeps, points=points[1])]),
        curves_panel(omega, pair, label="modulus" if unit else "part of the moduli"),
    )
    titles = ("relaxation", "creep", "storage and loss")
    return Sheet(titled(panels, *titles), width=3.9, height=3.2, title=type(item).__name__)
