"""Sheets of answers with friction: a path of shifts or shear forces, one state of it, a path of twists."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import OutsideValidity
from winkler.foundation.bed import Pressed
from winkler.foundation.sheared import ShearedSprings
from winkler.foundation.sheared_fields import BodyFields, ShearedFields
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading import ShearForce
from winkler.outline import refuse_unless_round
from winkler.plot import style
from winkler.plot.extent import around
from winkler.plot.friction.curves import (
    around_contact,
    draw_energies,
    draw_lines,
    draw_loop,
    draw_slip,
    draw_traction,
    lost_told,
    shade_stick,
)
from winkler.plot.friction.springs import draw_dragged
from winkler.plot.friction.stress import draw_body_stress, draw_dragged_stress
from winkler.plot.method import headline
from winkler.plot.series import Series, places, scale_of, series, told
from winkler.problems.friction.spring_states import SpringState
from winkler.problems.friction.tangential import TangentialSolution
from winkler.problems.friction.tangential_states import TangentialState
from winkler.problems.friction.torsion import TorsionSolution
from winkler.problems.friction.torsion_states import TorsionState

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.plot.picture import Picture

__all__ = ["body_sheet", "sheared_sheet", "tangential_sheet", "tangential_state_sheet", "torsion_sheet", "twist_sheet"]

AROUND = 1.35
"""Pictures of a traction go to so many contact radii."""


def tangential_sheet(item: TangentialSolution) -> Picture:
    """Return the loop, the forces and the energies along a path; below springs, traction and slip at its last contact.

    Parameters
    ----------
    item : TangentialSolution
    """
    touching = np.flatnonzero(item.radius > 0.0)
    last = int(touching[-1]) if touching.size else 0
    sheared = _sheared(item, last) if touching.size else None
    with style.styled():
        figure = style.figure(3, 2 if sheared else 1, width=3.9)
        panels = figure.subplots(2 if sheared else 1, 3, squeeze=False).ravel()
        _draw_way(panels[0], item)
        _draw_forces(panels[1], item)
        names = {"dissipation": "lost", "stored_energy": "stored"}
        draw_energies(panels[2], item, names)
        panels[1].set_title("forces over time")
        panels[2].set_title("energy of the tangential motion")
        if sheared:
            stick, mu = float(item.stick_radius[last]), _coefficient(item.problem.law)
            fields = around_contact(sheared, AROUND * sheared.pressed.radius)
            draw_dragged(panels[3], sheared, stick, around(sheared.pressed, None))
            draw_traction(panels[4], fields, mu, stick)
            draw_slip(panels[5], fields, sheared.pressed.radius, stick)
            when = "" if last == len(item.time) - 1 else " (last contact)"
            for axes, title in zip(panels[3:], ("springs", "traction", "displacement, slip"), strict=True):
                axes.set_title(title + when)
    return figure


def tangential_state_sheet(item: TangentialState | SpringState, extent: float | None = None) -> Picture:
    """Return springs, traction, slip and, where it is known, the stress below one state of a path.

    Parameters
    ----------
    item : TangentialState or SpringState
    extent : float, optional
        [m].
    """
    sheared = item.sheared
    if item.radius == 0.0:
        with style.styled():
            figure = style.figure()
            axes = figure.subplots()
            axes.axis("off")
            style.note(axes, "no contact", where="upper centre")
            axes.set_title("no contact")
        return figure
    end, stick = around(sheared.pressed, extent), float(item.stick_radius)
    near = AROUND * sheared.pressed.radius if extent is None else extent
    with style.styled():
        figure = style.figure(2, 2, height=3.3, width=4.8)
        panels = figure.subplots(2, 2, squeeze=False).ravel()
        draw_dragged(panels[0], sheared, stick, end)
        titles = ["springs", "traction", "displacement and slip of the surface", "stress below the surface"]
        drawn = 1
        try:
            fields = around_contact(sheared, near)
            draw_traction(panels[1], fields, _coefficient(getattr(item, "law", None)), stick)
            draw_slip(panels[2], fields, item.radius, stick)
            drawn = 3
            draw_dragged_stress(panels[3], sheared, near)
            drawn = 4
        except OutsideValidity:
            for axes in panels[drawn:]:
                axes.remove()
            titles = titles[:drawn]
        for axes, title in zip(panels, titles, strict=False):
            axes.set_title(title)
        shear = np.asarray(item.shear_force, dtype=float)
        pull = (
            f"$F_x$ = {told(float(shear), 'N')}" if shear.ndim == 0 else f"$|F|$ = {told(float(np.hypot(*shear)), 'N')}"
        )
        figure.suptitle(f"{headline(item)}   {pull}")
    return figure


def sheared_sheet(item: ShearedFields) -> Picture:
    """Return restored tractions and slips over the distance from the axis."""
    order = np.argsort(np.ravel(item.r), kind="stable")
    r = series("ShearedFields", "r", np.ravel(item.r)[order])

    def lines(*words: str) -> list[tuple[Series, str]]:
        found = []
        for word in words:
            content = np.asarray(getattr(item, word)).reshape(order.size, -1)[order]
            for place in range(content.shape[1]):
                one = series("ShearedFields", word, content[:, place])
                mark = "" if content.shape[1] == 1 else f", {'xy'[place]}"
                found.append((one, one.label().partition(" [")[0] + mark))
        return found

    with style.styled():
        figure = style.figure(2)
        left, right = figure.subplots(1, 2)
        draw_lines(left, r, lines("traction", "pressure"), "on the surface")
        draw_lines(right, r, lines("tangential_displacement", "slip"), "along the surface")
        left.set_title("traction")
        right.set_title("displacement and slip")
    return figure


def body_sheet(item: BodyFields) -> Picture:
    """Return a map of the stress below a sheared contact."""
    with style.styled():
        figure = style.figure(width=5.4, height=3.2)
        axes = figure.subplots()
        draw_body_stress(axes, item)
        axes.set_title("stress below the surface")
    return figure


def torsion_sheet(item: TorsionSolution) -> Picture:
    """Return the loop, torque and energies along a path of twists, and the traction at its last contact."""
    touching = np.flatnonzero(item.radius > 0.0)
    time = series("TorsionSolution", "time", item.time)
    with style.styled():
        figure = style.figure(2, 2, height=3.2)
        panels = figure.subplots(2, 2, squeeze=False).ravel()
        angle, torque = (series("TorsionSolution", name, getattr(item, name)) for name in ("angle", "torque"))
        draw_loop(panels[0], angle, torque, float(item.dissipation[-1]))
        bound = item.torque_limit
        bounds = [(series("TorsionSolution", "torque", sign * bound), "_") for sign in (1.0, -1.0)]
        draw_lines(panels[1], time, [(torque, "torque"), (bounds[0][0], "what friction bears"), bounds[1]], "torque")
        _alike(panels[1])
        draw_energies(panels[2], item, {"dissipation": "lost", "stored_energy": "stored"})
        if touching.size:
            _draw_twist(panels[3], item.states[int(touching[-1])])
        else:
            style.note(panels[3], "no contact", where="upper centre")
        titles = ("torque over angle", "torque over time", "energy of the twist", "traction around the axis")
        for axes, title in zip(panels, titles, strict=True):
            axes.set_title(title)
    return figure


def twist_sheet(item: TorsionState) -> Picture:
    """Return the traction of a twisted contact."""
    with style.styled():
        figure = style.figure(width=5.0)
        axes = figure.subplots()
        if item.radius > 0.0:
            _draw_twist(axes, item)
        else:
            style.note(axes, "no contact", where="upper centre")
        axes.set_title("traction around the axis")
        figure.suptitle(f"{headline(item)}   $M_z$ = {told(item.torque, 'N m')}")
    return figure


def _draw_twist(axes: Axes, state: TorsionState) -> None:
    """Draw the traction around the axis under the bound of friction."""
    bed, radius, mu = state.springs.bed, state.radius, state.springs.coefficient
    r = places(radius, (*(b for b, _ in bed.kinks if b < radius), state.stick_radius), count=200)
    traction = state.traction(r)
    pressure = bed.medium.pressure(Pressed(bed, state.depth, radius), r)
    finite = np.isfinite(traction) & np.isfinite(pressure)
    bound = np.where(finite, mu * pressure, np.nan) if math.isfinite(mu) else np.full(r.shape, np.nan)
    ceiling = 3.0 * float(np.nanmedian(bound)) if math.isfinite(mu) else math.inf
    top = min(float(np.nanmax(np.abs(np.where(finite, traction, 0.0)))) * 1.3, max(ceiling, 0.0))
    if math.isfinite(mu):
        top = max(top, min(1.1 * float(np.nanmax(bound)), ceiling))
    scale, across = scale_of("Pa", [top]), scale_of("m", [radius])
    shade_stick(axes, state.stick_radius / across.factor, mirrored=False)
    for sign in (1.0, -1.0):
        label = r"$\pm\mu p$" if sign > 0.0 else "_"
        line = sign * bound / scale.factor
        axes.plot(r / across.factor, line, color=style.MUTED, linewidth=1.1, linestyle=style.DASHES[1], label=label)
    axes.plot(r / across.factor, traction / scale.factor, color=style.RED, label=r"$\tau_\theta$")
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
    low = -top if np.nanmin(traction) < -0.02 * top else 0.0
    axes.set_ylim(1.05 * low / scale.factor, 1.25 * top / scale.factor if top > 0.0 else 1.0)
    axes.set_xlim(0.0, 1.05 * radius / across.factor)
    axes.set_xlabel(series("SurfaceFields", "r", r).label(across))
    axes.set_ylabel(series("ShearedFields", "traction", traction).label(scale))
    style.framed_legend(axes, loc="upper left")


def _coefficient(law: Any) -> float:
    """Return the coefficient that bounds tractions, infinite if the law has none."""
    if isinstance(law, StaticKinetic):
        return law.static_coefficient
    return law.coefficient if isinstance(law, Coulomb) else math.inf


def _sheared(item: TangentialSolution, index: int) -> ShearedSprings | None:
    """Return the springs at one point; None where tractions cannot be restored."""
    try:
        found = item.at(index).sheared
        refuse_unless_round(found.pressed, "draw", "the traction")
        found.pressed.bed.medium.pressure(found.pressed, np.array([0.5 * found.pressed.radius]))
    except OutsideValidity:
        return None
    return found


def _draw_way(axes: Axes, item: TangentialSolution) -> None:
    """Draw the shear force over the shift; in the plane its way, within what friction bears at the end."""
    lost = float(item.dissipation[-1])
    if item.shear_force.ndim == 1:
        shift, force = (series("TangentialSolution", name, getattr(item, name)) for name in ("shift", "shear_force"))
        draw_loop(axes, shift, force, lost)
        axes.set_title("shear force over shift")
        return
    along, across = (series("TangentialSolution", "shear_force", item.shear_force[:, i]) for i in range(2))
    bound = _coefficient(item.problem.law) * float(item.force[-1])
    scale = scale_of("N", item.shear_force, bound if math.isfinite(bound) else 0.0)
    x, y = along.shown(scale), across.shown(scale)
    axes.plot(x, y, color=style.BLUE)
    axes.plot(x[:1], y[:1], "o", color=style.BLUE, markerfacecolor="white", zorder=5)
    axes.plot(x[-1:], y[-1:], "o", color=style.RED, zorder=6)
    if math.isfinite(bound):
        turn = np.linspace(0.0, 2.0 * np.pi, 181)
        circle = bound / scale.factor * np.array([np.cos(turn), np.sin(turn)])
        axes.plot(*circle, color=style.MUTED, linewidth=1.1, linestyle=style.DASHES[1])
        style.note(axes, r"dashed: $\mu F_N$ at the end", where="lower left")
    axes.set_aspect("equal")
    axes.margins(0.08)
    axes.set_xlabel(f"shear force $F_x$ [{scale.unit}]")
    axes.set_ylabel(f"shear force $F_y$ [{scale.unit}]")
    style.note(axes, lost_told(lost, item.shift, item.shear_force), where="upper left")
    axes.set_title("the way of the shear force")


def _draw_forces(axes: Axes, item: TangentialSolution) -> None:
    """Draw the shear force between the bounds of friction, over time."""
    time = series("TangentialSolution", "time", item.time)
    mu = _coefficient(item.problem.law)
    components = [item.shear_force] if item.shear_force.ndim == 1 else list(item.shear_force.T)
    names = ["$F_x$", "$F_y$"] if len(components) > 1 else ["$F_x$"]
    lines = [
        (series("TangentialSolution", "shear_force", one), name) for one, name in zip(components, names, strict=True)
    ]
    if math.isfinite(mu):
        bound = mu * np.asarray(item.force)
        lines += [
            (series("TangentialSolution", "shear_force", sign * bound), r"$\pm\mu F_N$" if sign > 0.0 else "_")
            for sign in (1.0, -1.0)
        ]
    draw_lines(axes, time, lines, "shear force" if isinstance(item.problem.path.lateral, ShearForce) else "force")
    _alike(axes)


def _alike(axes: Axes) -> None:
    """Draw both bounds alike: the last line takes after the one before."""
    upper, lower = axes.lines[-2:]
    for line in (upper, lower) if lower.get_label() == "_" else ():
        line.set(color=style.MUTED, linestyle=style.DASHES[1], linewidth=1.1)
    if axes.get_legend() is not None:
        style.framed_legend(axes, loc="upper center", ncols=3, columnspacing=1.2)
