"""Sheets of heat through a rough joint, and of the flow factors of a rigid gap."""

from __future__ import annotations

import numpy as np

from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Rule, Sheet, titled
from winkler.plot.rough.roughness import map_panel
from winkler.plot.series import Series, row_of, series, with_unit
from winkler.problems.pressed_maps.flow_factors import FlowFactors
from winkler.problems.pressed_maps.seal_states import gap_of
from winkler.problems.pressed_maps.thermal_joint import ThermalJointSolution
from winkler.values.vocabulary import Word

FEWEST_LOADS = 2
DECADES = 3.0
"""Of the flux that are drawn; a gap carries thousandths of what spots do."""


@without_extent(ThermalJointSolution)
def thermal_joint_sheet(item: ThermalJointSolution) -> Sheet:
    """Return the flux of heat and the gap under the last load, and the conductances of many loads."""
    rough, state = item.problem.contact.topography, item.contact.last
    flux = item.flux()
    most = float(np.max(flux[np.isfinite(flux)], initial=0.0))
    shown = np.where(flux > most * 10.0**-DECADES, flux, np.nan)
    gap = gap_of(state.pressure, state.separation)
    flow = Series("flux", Word("", "", "decimal logarithm of the heat flux per kelvin"), np.log10(shown))
    bar = "$\\log_{10}$ of the flux in W/(m² K)"
    panels = [
        map_panel(rough, flow, style.SHADES, label=bar, lowest=np.inf),
        map_panel(rough, series("separation", np.where(gap > 0.0, gap, np.nan)), style.SHADES, label="gap $u$"),
    ]
    names = ["heat flux per kelvin", "gap, white: contact"]
    if np.size(item.force) >= FEWEST_LOADS:
        lines = [
            (row_of(item, name), legend)
            for name, legend in (
                ("conductance", "both"), ("spot_conductance", "spots"), ("gap_conductance", "gap"),
            )
            if np.all(row_of(item, name).content > 0.0)
        ]  # fmt: skip
        panels.append(curves_panel(row_of(item, "force"), lines, label="conductance"))
        names.append("conductance over force")
    force, whole, by_gap = (
        float(np.ravel(np.asarray(part))[-1]) for part in (item.force, item.conductance, item.gap_conductance)
    )
    title = f"{with_unit(force, 'N')}: {with_unit(whole, 'W/K')}, {by_gap / whole:.0%} of it through the gap"
    return Sheet(titled(tuple(panels), *names), 0, width=4.0, height=3.3, title=title)


@without_extent(FlowFactors)
def flow_factors_sheet(item: FlowFactors) -> Sheet:
    """Return the flow factors along both directions over the distance of the mean planes."""
    factors = [(row_of(item, "flow_factor"), "along $x$"), (row_of(item, "lateral_flow_factor"), "along $y$")]
    marks = [Rule(1.0, dash=(4.0, 3.0))]
    if item.closing_separation > 0.0:
        marks.append(Rule(item.closing_separation, upright=True, name="closed along $x$"))
    panel = curves_panel(row_of(item, "separation"), factors, label="flow factor $\\phi$")
    return Sheet((panel.plus(*marks, title="flow factors of the rigid gap"),), width=4.8, height=3.3)
