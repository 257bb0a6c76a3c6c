"""Sheets of the electric contacts of height maps: spots, parts of the resistance, temperatures and softening."""

from __future__ import annotations

import numpy as np

from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Bars, Panel, PanelAxis, Rule, Sheet, note, titled
from winkler.plot.rough.roughness import map_panel
from winkler.plot.series import row_of, series, with_unit
from winkler.problems.surface_current.constriction import SurfaceConstrictionSolution

FEWEST_LOADS = 2
CURVES = (
    ("resistance", "all"),
    ("constriction", "constrictions"),
    ("film_resistance", "film"),
    ("bare_constriction", "constrictions without platings"),
)
PARTS = (
    ("first_constriction", "constriction, first body"),
    ("second_constriction", "constriction, second body"),
    ("film_resistance", "film"),
)


@without_extent(SurfaceConstrictionSolution)
def surface_constriction_sheet(item: SurfaceConstrictionSolution) -> Sheet:
    """Return the spots of the last load and the parts of its resistance; of many loads curves over the force."""
    state, rough = item.contact.last, item.problem.contact.topography
    pressed = series("pressure", np.where(state.pressure > 0.0, state.pressure, np.nan))
    panels, names = [map_panel(rough, pressed, style.SHADES)], ["pressure in the spots"]
    if np.size(item.force) >= FEWEST_LOADS:
        force = row_of(item, "force")
        parts = [(row_of(item, name), label) for name, label in CURVES]
        drawn = [(of, label) for of, label in parts if np.all(of.content > 0.0)]
        panels.append(curves_panel(force, drawn, label="resistance") if drawn else Panel())
        names.append("resistance and its parts")
        panels.append(curves_panel(force, [(row_of(item, "patch_count"), "")], label="spots of contact"))
        names.append("spots of contact")
        panels.append(_rise_panel(item))
        names.append("greatest rise of temperature")
        lines = [
            (row_of(item, f"{word}_current"), label)
            for word, label in (("softening", "softens"), ("melting", "melts"))
            if np.all(np.isfinite(np.asarray(getattr(item, f"{word}_current"))))
        ]
        if lines:
            panels.append(curves_panel(force, lines, label="current"))
            names.append("current at which the metal")
    else:
        panels.append(_parts_panel(item))
        names.append("parts of the resistance")
    last = float(np.ravel(np.asarray(item.resistance))[-1])
    count = int(np.ravel(np.asarray(item.patch_count))[-1])
    title = f"{with_unit(state.force, 'N')}: {count} spots, {with_unit(last, 'ohm')}"
    return Sheet(titled(tuple(panels), *names), min(len(panels), 3), width=4.0, height=3.3, title=title)


def _rise_panel(item: SurfaceConstrictionSolution) -> Panel:
    """Return the greatest rise of temperature over the force, with those at which the metal softens and melts."""
    hottest = row_of(item, "rise")
    if not np.any(hottest.content > 0.0):
        return Panel((note("no current flows"),))
    panel = curves_panel(row_of(item, "force"), [(hottest, "")], label="rise of temperature")
    stated = item.problem
    for number, name in ((stated.softening_temperature, "softens"), (stated.melting_temperature, "melts")):
        above = number - stated.temperature
        if above <= float(np.max(hottest.content)):
            panel = panel.plus(Rule(above, colour=style.RED, width=0.9, dash=style.DOTTED, name=name), legend="best")
    return panel


def _parts_panel(item: SurfaceConstrictionSolution) -> Panel:
    """Return the parts of the resistance of one load."""
    of = series("resistance", np.array([float(np.ravel(getattr(item, name))[0]) for name, _ in PARTS]), type(item))
    places = np.arange(float(len(PARTS)))
    bars = Bars(places, of.content, (style.BLUE, style.BLUE, style.RED))
    upright = PanelAxis(ticks=places, names=tuple(label for _, label in PARTS), falling=True)
    return Panel((bars,), PanelAxis.of(of), upright, grid="x")
