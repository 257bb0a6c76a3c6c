"""Sheets of damping: loss per cycle and loss factor of a contact, over amplitude or phase."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from winkler.loading.loads import ShearForce, Shift
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.friction.curves import lines_panel
from winkler.plot.panel import Line, Panel, PanelAxis, Polygon, Rule, Sheet, note, points, titled, zero
from winkler.plot.series import Series, middle_scale, series, with_unit
from winkler.problems.friction.bimodal_damping import BimodalDampingSolution
from winkler.problems.friction.damping import FrictionDamping, FrictionDampingSolution
from winkler.problems.friction.relaxation_damping import RelaxationDamperSolution

POINTS = 73
LOOP_POINTS = 101
LEAST_SHIFT_SHARE, GREATEST_SHIFT_SHARE = 0.02, 4.0
"""Range of the curves relative to the shift at full sliding."""
PHASE_POINTS = 19
RELAXING_POINTS, RELAXING_PHASES, RELAXING_COUNT = 13, 9, 100
"""Points and springs of curves of bodies that relax, which are followed through cycles at each."""


@without_extent(FrictionDampingSolution)
def damping_sheet(item: FrictionDampingSolution) -> Sheet:
    """Return loss and loss factor over the amplitude, up to sliding and beyond, and the loop of the greatest amplitude.

    Parameters
    ----------
    item : FrictionDampingSolution
    """
    problem = item.problem
    if problem.relaxes:
        return _relaxing_sheet(item)
    slides = problem.law.coefficient * float(item.contact.force)
    reach = float(dataclasses.replace(problem, amplitude=ShearForce(slides)).solve().shift)
    requested = np.ravel(np.asarray(item.shift, dtype=float))
    requested = requested[requested > 0.0]
    low = min(LEAST_SHIFT_SHARE * reach, 0.5 * float(np.min(requested, initial=reach)))
    high = max(GREATEST_SHIFT_SHARE * reach, 1.5 * float(np.max(requested, initial=reach)))
    curve = dataclasses.replace(problem, amplitude=Shift(np.geomspace(low, high, POINTS))).solve()
    panels = titled(
        (
            _over(curve, item, "loss_per_cycle", reach, log=True),
            _over(curve, item, "loss_factor", reach, low=0.0, high=1.2 * 4.0 / math.pi),
            _cycle_panel(problem, float(np.max(requested, initial=0.0)) or reach),
        ),
        "loss per cycle",
        "loss factor",
        "loop of the greatest amplitude",
    )
    return Sheet(panels, width=3.9, height=3.2)


def _relaxing_sheet(item: FrictionDampingSolution) -> Sheet:
    """Return losses and loss factor of bodies that relax, and the loop of the greatest amplitude."""
    asked = np.ravel(np.asarray(item.shift, dtype=float))
    asked = asked[asked > 0.0] if np.any(asked > 0.0) else np.array([float(item.contact.depth)])
    shifts = np.geomspace(0.2 * float(np.min(asked)), 5.0 * float(np.max(asked)), RELAXING_POINTS)
    problem = dataclasses.replace(item.problem, count=min(item.problem.count, RELAXING_COUNT), amplitude=Shift(shifts))
    curve, cycle = problem.solve(), problem.cycle(float(np.max(asked)))
    along = series("shift", shifts)
    names = {"loss_per_cycle": "all", "friction_loss": "to friction", "bulk_loss": "in the bodies"}
    losses = [series(name, np.asarray(getattr(curve, name))) for name in names]
    shift, force = series("shift", cycle.shift), series("shear_force", cycle.shear_force)
    loop = Panel(
        (
            Polygon(shift.content, force.content, style.RED, 0.14),
            Line(shift.content, force.content),
            zero(),
            note(f"shaded: {with_unit(cycle.loss, 'J')}", "upper left"),
        ),
        PanelAxis.of(shift, margin=0.06),
        PanelAxis.of(force, margin=0.12),
    )
    across = PanelAxis("amplitude of the shift $U$", middle_scale("m", along.content), log=True)
    marks = [
        Line(along.content, of.content, style.CYCLE[at], dash=style.DASHES[at], name=label)
        for at, (of, label) in enumerate(zip(losses, names.values(), strict=True))
        if np.any(of.content > 0.0)
    ]
    marks.append(points(item.shift, item.loss_per_cycle, name="requested"))
    least = 0.1 * float(np.min(losses[0].content))
    upright = PanelAxis.of(losses[0], middle_scale("J", losses[0].content), log=True, low=least)
    factor = series("loss_factor", np.asarray(curve.loss_factor))
    damped = Panel(
        (Line(along.content, factor.content), points(item.shift, item.loss_factor)),
        across,
        PanelAxis.of(factor, middle_scale(factor.word.unit, factor.content), low=0.0),
    )
    lost = Panel(tuple(marks), across, upright, legend="upper left")
    panels = titled((lost, damped, loop), "loss per cycle", "loss factor", "loop of the greatest amplitude")
    return Sheet(panels, width=3.9, height=3.2)


def _over(curve: FrictionDampingSolution, item: FrictionDampingSolution, name: str, reach: float, **ends: Any) -> Panel:
    """Return one quantity over the amplitude of the shift, with the requested points."""
    along = series("shift", np.asarray(curve.shift))
    of = series(name, np.asarray(getattr(curve, name)))
    shift, requested = (np.ravel(np.asarray(part, dtype=float)) for part in (item.shift, getattr(item, name)))
    moving = shift > 0.0
    marks = (
        Line(along.content, of.content),
        points(shift[moving], requested[moving], name="requested"),
        Rule(reach, upright=True, width=0.9, dash=style.DOTTED, name="all slides"),
    )
    across = PanelAxis("amplitude of the shift $U$", middle_scale("m", along.content), log=True)
    upright = PanelAxis.of(of, middle_scale(of.word.unit, of.content), **ends)
    return Panel(marks, across, upright, legend="upper left")


def _cycle_panel(problem: FrictionDamping, amplitude: float) -> Panel:
    """Return the closed loop: either half is the first loading, twice as large (Masing)."""
    share = np.linspace(0.0, 1.0, LOOP_POINTS)
    first = np.asarray(dataclasses.replace(problem, amplitude=Shift(amplitude * share)).solve().shear_force)
    shift, force = amplitude * (2.0 * share - 1.0), 2.0 * first - first[-1]
    along = series("shift", np.concatenate([shift, -shift]))
    of = series("shear_force", np.concatenate([force, -force]))
    loss = dataclasses.replace(problem, amplitude=Shift(amplitude)).solve().loss_per_cycle
    marks = (
        Polygon(along.content, of.content, style.RED, 0.14),
        Line(along.content, of.content),
        Line(amplitude * share, first, style.MUTED, width=1.0, dash=style.DASHES[1]),
        zero(),
        note(f"shaded: {with_unit(float(loss), 'J')}", "upper left"),
    )
    return Panel(marks, PanelAxis.of(along, margin=0.06), PanelAxis.of(of, margin=0.12))


@without_extent(BimodalDampingSolution)
def bimodal_sheet(item: BimodalDampingSolution) -> Sheet:
    """Return the closed cycle of depth and shift, and the loss over the varied quantity, or over the phase."""
    problem = item.problem
    amplitudes_along, phase_angle = np.broadcast_arrays(
        np.asarray(problem.shift_amplitude, dtype=float), np.asarray(problem.phase, dtype=float)
    )
    place = int(np.argmax(np.ravel(item.loss_per_cycle)))
    path = problem.path(float(phase_angle.ravel()[place]), float(amplitudes_along.ravel()[place]), cycles=1)
    depth, shift = series("depth", path.across), series("shift", path.along)
    across, upright = PanelAxis.of(shift, margin=0.08), PanelAxis.of(depth, margin=0.08, falling=True)
    left = Panel((Line(shift.content, depth.content), zero()), across, upright)
    by_amplitude = bool(np.ptp(amplitudes_along) > 0.0)
    curve = item if amplitudes_along.size > 1 else _over_phase(item)
    along = _varied(curve, "shift_amplitude" if by_amplitude else "phase")
    loss = np.ravel(np.asarray(curve.loss_per_cycle))
    order = np.argsort(along.content, kind="stable")
    of = series("loss_per_cycle", loss[order])
    marks = [
        Line(along.content[order], of.content, marker="o" if amplitudes_along.size > 1 and loss.size <= 40 else "")
    ]
    if amplitudes_along.size == 1:
        marks.append(points(phase_angle.ravel(), np.ravel(item.loss_per_cycle)))
    right = Panel(tuple(marks), PanelAxis.of(along, margin=0.04), PanelAxis.of(of, low=0.0))
    panels = titled(
        (left, right),
        "the closed cycle" + (" of the greatest loss" if amplitudes_along.size > 1 else ""),
        f"loss per cycle over {'amplitude' if by_amplitude else 'phase'}",
    )
    return Sheet(panels, height=3.2)


def _over_phase(item: BimodalDampingSolution) -> BimodalDampingSolution:
    phase = float(np.ravel(np.asarray(item.problem.phase))[0])
    count = RELAXING_PHASES if item.problem.relaxes else PHASE_POINTS
    around = np.union1d(np.linspace(0.0, math.pi, count), [phase] if 0.0 <= phase <= math.pi else [])
    return dataclasses.replace(
        item.problem, phase=around, shift_amplitude=float(np.ravel(np.asarray(item.problem.shift_amplitude))[0])
    ).solve()


def _varied(item: BimodalDampingSolution, name: str) -> Series:
    content = np.broadcast_to(np.asarray(getattr(item.problem, name), dtype=float), np.shape(item.loss_per_cycle))
    return series(name, np.ravel(content))


@without_extent(RelaxationDamperSolution)
def relaxation_sheet(item: RelaxationDamperSolution) -> Sheet:
    """Return the viscous damper over the amplitude of the depth."""
    problem = item.problem
    greatest = float(problem.depth_amplitude)
    amplitudes: Array = np.geomspace(0.05 * greatest, 4.0 * greatest, 33)
    damping = [
        float(dataclasses.replace(problem, depth_amplitude=float(amplitude)).solve().damping)
        for amplitude in amplitudes
    ]
    along = series("depth_amplitude", amplitudes)
    of = series("damping", np.array(damping))
    panel = lines_panel(along, [(of, "damping")], f"damping ${of.word.symbol}$", low=0.0).plus(
        points(greatest, item.damping)
    )
    return Sheet((panel.plus(title="viscous damper that the contact amounts to"),), width=4.8, height=3.2)
