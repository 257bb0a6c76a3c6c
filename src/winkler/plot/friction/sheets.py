"""Sheets of solutions with friction: a path of shifts or shear forces, one state of it, a path of twists."""

from __future__ import annotations

import contextlib
import math
from typing import Any

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.foundation.sheared import ShearedSprings
from winkler.foundation.sheared_fields import BodyFields, ShearedFields
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.plot import style
from winkler.plot.curves import Quantity, curves_panel
from winkler.plot.dispatch import sheet_of, without_extent
from winkler.plot.extent import around, checked_extent
from winkler.plot.friction.curves import (
    RestorableSprings,
    around_contact,
    bounds,
    energies_panel,
    loop_panel,
    loss_text,
    path_ends,
    slip_panel,
    stick_band,
    traction_panel,
)
from winkler.plot.friction.springs import dragged_panel
from winkler.plot.friction.stress import body_stress_panel, dragged_stress_panel, in_first
from winkler.plot.panel import NO_CONTACT, Line, Panel, PanelAxis, Sheet, note, titled, zero
from winkler.plot.series import Series, headline, places, scale_of, series, with_unit
from winkler.problems.friction.pushed import PushedState
from winkler.problems.friction.spring_states import SpringState
from winkler.problems.friction.tangential import TangentialSolution
from winkler.problems.friction.tangential_states import TangentialState
from winkler.problems.friction.torsion import TorsionSolution
from winkler.problems.friction.torsion_states import TorsionState
from winkler.values.checks.outline import refuse_unless_round
from winkler.values.errors import OutsideValidity

RADII_DRAWN = 1.35
"""Extent of the picture of a traction in contact radii."""
TRACTION = r"$\tau$"
ENERGY_NAMES = {"dissipation": "lost", "stored_energy": "stored"}


def tangential_sheet(item: TangentialSolution) -> Sheet:
    """Return the loop, the forces and the energies along a path; below springs, traction and slip at its last contact.

    Parameters
    ----------
    item : TangentialSolution
        Of elastic bodies.
    """
    touching = np.flatnonzero(item.radius > 0.0)
    last = int(touching[-1]) if touching.size else 0
    panels: tuple[Panel, ...] = (
        _path_panel(item),
        _forces_panel(item).plus(title="forces over time"),
        energies_panel(item, ENERGY_NAMES).plus(title="energy of the tangential motion"),
    )
    reached = item.states[last] if touching.size else None
    if isinstance(reached, PushedState):
        return Sheet((*panels, ring_panel(reached, TRACTION).plus(title="traction along the motion")), 2, height=3.2)
    if isinstance(reached, TangentialState | SpringState) and (sheared := _sheared(reached)):
        stick, radius = float(item.stick_radius[last]), sheared.pressed.radius
        fields = around_contact(sheared, RADII_DRAWN * radius)
        below = (
            dragged_panel(sheared, stick, around(sheared.pressed, None)),
            traction_panel(fields, _coefficient(item.problem.law), stick),
            slip_panel(fields, radius, stick),
        )
        when = "" if last == len(item.time) - 1 else " (last contact)"
        panels += titled(below, *(name + when for name in ("springs", "traction", "displacement, slip")))
    return Sheet(panels, 3, width=3.9)


@without_extent(PushedState)
def pushed_state_sheet(item: PushedState) -> Sheet:
    """Return the traction of a pushed contact, and where it can be computed the stress below it."""
    panels = [(ring_panel(item, TRACTION) if item.radius > 0.0 else NO_CONTACT).plus(title="traction along the motion")]
    with contextlib.suppress(OutsideValidity):
        if item.radius > 0.0:
            below = dragged_stress_panel(item, item.radius, RADII_DRAWN * item.radius)
            panels.append(below.plus(title="stress below the surface"))
    title = f"{headline(item)}   $F_x$ = {with_unit(item.shear_force, 'N')}"
    return Sheet(tuple(panels), len(panels), width=5.0, title=title)


@sheet_of.register(TangentialState)
@sheet_of.register(SpringState)
def tangential_state_sheet(item: TangentialState | SpringState, *, extent: float | None = None) -> Sheet:
    """Return springs, traction, slip and, where it can be computed, the stress below one state of a path.

    Parameters
    ----------
    item : TangentialState or SpringState
    extent : float, optional
        [m].
    """
    sheared, extent = item.sheared, checked_extent(extent)
    if item.radius == 0.0:
        return Sheet((NO_CONTACT.plus(title="no contact", bare=True),))
    end, stick = around(sheared.pressed, extent), float(item.stick_radius)
    near = RADII_DRAWN * sheared.pressed.radius if extent is None else extent
    panels: list[Panel | None] = [dragged_panel(sheared, stick, end).plus(title="springs")]
    try:
        fields = around_contact(sheared, near)
        panels.append(traction_panel(fields, _coefficient(getattr(item, "law", None)), stick).plus(title="traction"))
        panels.append(slip_panel(fields, item.radius, stick).plus(title="displacement and slip of the surface"))
        stress = dragged_stress_panel(
            RestorableSprings(sheared), sheared.pressed.radius, near, first=in_first(sheared.pressed.bed)
        )
        panels.append(stress.plus(title="stress below the surface"))
    except OutsideValidity:
        panels += [None] * (4 - len(panels))
    shear = np.asarray(item.shear_force, dtype=float)
    pull = (
        f"$F_x$ = {with_unit(float(shear), 'N')}"
        if shear.ndim == 0
        else f"$|F|$ = {with_unit(float(np.hypot(*shear)), 'N')}"
    )
    return Sheet(tuple(panels), 2, height=3.3, width=4.8, title=f"{headline(item)}   {pull}")


@without_extent(ShearedFields)
def sheared_sheet(item: ShearedFields) -> Sheet:
    """Return restored tractions and slips over the distance from the axis."""
    order = np.argsort(np.ravel(item.r), kind="stable")
    r = series("r", np.ravel(item.r)[order])

    def lines(*words: str) -> list[tuple[Series, str]]:
        quantities = []
        for word in words:
            content = np.asarray(getattr(item, word)).reshape(order.size, -1)[order]
            for place in range(content.shape[1]):
                one = series(word, content[:, place])
                mark = "" if content.shape[1] == 1 else f", {'xy'[place]}"
                quantities.append((one, one.label().partition(" [")[0] + mark))
        return quantities

    left = curves_panel(r, lines("traction", "pressure"), label="on the surface")
    right = curves_panel(r, lines("tangential_displacement", "slip"), label="along the surface")
    return Sheet(titled((left, right), "traction", "displacement and slip"))


@without_extent(BodyFields)
def body_sheet(item: BodyFields) -> Sheet:
    """Return a map of the stress below a sheared contact."""
    return Sheet((body_stress_panel(item).plus(title="stress below the surface"),), width=5.4, height=3.2)


def torsion_sheet(item: TorsionSolution) -> Sheet:
    """Return the loop, torque and energies along a path of twists, and the traction at its last contact."""
    touching = np.flatnonzero(item.radius > 0.0)
    time, angle, torque = (series(name, getattr(item, name), TorsionSolution) for name in ("time", "angle", "torque"))
    lines = [Quantity(torque, "torque"), *bounds("torque", item.torque_limit, "bound of friction")]
    panels = titled(
        (
            loop_panel(angle, torque, float(item.dissipation[-1])),
            curves_panel(time, lines, label="torque"),
            energies_panel(item, ENERGY_NAMES),
            ring_panel(item.states[int(touching[-1])], r"$\tau_\theta$") if touching.size else NO_CONTACT,
        ),
        "torque over angle",
        "torque over time",
        "energy of the twist",
        "traction around the axis",
    )
    return Sheet(panels, 2, height=3.2)


@without_extent(TorsionState)
def twist_sheet(item: TorsionState) -> Sheet:
    """Return the traction of a twisted contact."""
    panel = ring_panel(item, r"$\tau_\theta$") if item.radius > 0.0 else NO_CONTACT
    title = f"{headline(item)}   $M_z$ = {with_unit(item.torque, 'N m')}"
    return Sheet((panel.plus(title="traction around the axis"),), width=5.0, title=title)


def ring_panel(state: Any, name: str) -> Panel:
    """Return the traction of a state, twisted or pushed, under the bound of friction."""
    bed, radius, mu = state.springs.bed, state.radius, state.springs.coefficient
    r = places(radius, (*(b for b, _ in bed.kinks if b < radius), state.stick_radius), count=200)
    traction = state.traction(r)
    pressure = bed.medium.pressure(PressedSprings(bed, state.depth, radius), r)
    finite = np.isfinite(traction) & np.isfinite(pressure)
    bound = np.where(finite, mu * pressure, np.nan) if math.isfinite(mu) else np.full(r.shape, np.nan)
    ceiling = 3.0 * float(np.nanmedian(bound)) if math.isfinite(mu) else math.inf
    top = min(float(np.nanmax(np.abs(np.where(finite, traction, 0.0)))) * 1.3, max(ceiling, 0.0))
    if math.isfinite(mu):
        top = max(top, min(1.1 * float(np.nanmax(bound)), ceiling))
    scale = scale_of("Pa", [top])
    dashed: dict[str, Any] = {"colour": style.MUTED, "width": 1.1, "dash": style.DASHES[1]}
    marks = (
        *stick_band(state.stick_radius, mirrored=False),
        *(Line(r, sign * bound, name=r"$\pm\mu p$" if sign > 0.0 else "", **dashed) for sign in (1.0, -1.0)),
        Line(r, traction, style.RED, name=name),
        zero(),
    )
    low = -top if np.nanmin(traction) < -0.02 * top else 0.0
    across = PanelAxis.of(series("r", r), scale_of("m", [radius]), low=0.0, high=1.05 * radius)
    of, high = series("traction", traction), 1.25 * top if top > 0.0 else scale.factor
    return Panel(marks, across, PanelAxis.of(of, scale, low=1.05 * low, high=high), legend="best")


def _coefficient(law: Any) -> float:
    """Return the coefficient that bounds tractions, infinite if the law has none."""
    if isinstance(law, StaticKinetic):
        return law.static_coefficient
    return law.coefficient if isinstance(law, Coulomb) else math.inf


def _sheared(reached: TangentialState | SpringState) -> ShearedSprings | None:
    """Return the springs at one point; None if tractions cannot be restored."""
    try:
        state = reached.sheared
        refuse_unless_round(state.pressed, "draw", "the traction")
        state.pressed.bed.medium.pressure(state.pressed, np.array([0.5 * state.pressed.radius]))
    except OutsideValidity:
        return None
    return state


def _path_panel(item: TangentialSolution) -> Panel:
    """Return the shear force over the shift; in the plane its path, within the bound of friction at the end."""
    lost = float(item.dissipation[-1])
    if item.shear_force.ndim == 1:
        shift, force = (series(name, getattr(item, name), TangentialSolution) for name in ("shift", "shear_force"))
        return loop_panel(shift, force, lost).plus(title="shear force over shift")
    x, y = item.shear_force.T
    bound = _coefficient(item.problem.law) * float(item.force[-1])
    scale = scale_of("N", item.shear_force, bound if math.isfinite(bound) else 0.0)
    marks: list[Any] = [
        Line(x, y),
        *path_ends(x, y),
    ]
    if math.isfinite(bound):
        turn = np.linspace(0.0, 2.0 * np.pi, 181)
        circle = bound * np.cos(turn), bound * np.sin(turn)
        marks.append(Line(*circle, style.MUTED, width=1.1, dash=style.DASHES[1]))
        marks.append(note(r"dashed: $\mu F_N$ at the end", "lower left"))
    marks.append(note(loss_text(lost, item.shift, item.shear_force), "upper left"))
    axes = PanelAxis("shear force $F_x$", scale, margin=0.08), PanelAxis("shear force $F_y$", scale, margin=0.08)
    return Panel(tuple(marks), *axes, title="path of the shear force", equal=True)


def _forces_panel(item: TangentialSolution) -> Panel:
    """Return the shear force between the bounds of friction, over time."""
    time = series("time", item.time)
    mu = _coefficient(item.problem.law)
    components = [item.shear_force] if item.shear_force.ndim == 1 else list(item.shear_force.T)
    names = "$F_x$", "$F_y$"
    lines = [Quantity(series("shear_force", one), name) for one, name in zip(components, names, strict=False)]
    if math.isfinite(mu):
        lines += bounds("shear_force", mu * np.asarray(item.force))
    return curves_panel(time, lines, label="shear force")
