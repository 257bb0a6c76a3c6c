"""Sheets of damping: loss per cycle and loss factor of a contact, over amplitude or phase."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from winkler.loading.loads import ShearForce, Shift
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import Quantity, answered, curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Panel, PanelAxis, Polygon, Rule, Sheet, note, titled, zero
from winkler.plot.series import Series, row_of, series, with_unit
from winkler.problems.friction.bimodal_damping import BimodalDampingSolution
from winkler.problems.friction.damping import FrictionDamping, FrictionDampingSolution
from winkler.problems.friction.relaxation_damping import RelaxationDamperSolution
from winkler.values.vocabulary import Word

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
    all_slides = Rule(reach, upright=True, width=0.9, dash=style.DOTTED, name="all slides")
    panels = titled(
        (
            _over(curve, item, "loss_per_cycle").plus(all_slides),
            _over(curve, item, "loss_factor").plus(all_slides),
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
    parts = [(row_of(curve, "friction_loss"), "to friction"), (row_of(curve, "bulk_loss"), "in the bodies")]
    others = [Quantity(of, name) for of, name in parts if np.any(of.content > 0.0)]
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
    lost, damped = _over(curve, item, "loss_per_cycle", *others), _over(curve, item, "loss_factor")
    panels = titled((lost, damped, loop), "loss per cycle", "loss factor", "loop of the greatest amplitude")
    return Sheet(panels, width=3.9, height=3.2)


def _over(curve: FrictionDampingSolution, item: FrictionDampingSolution, of: str, *others: Quantity) -> Panel:
    """Return one quantity over the amplitude of the shift, with the requested points, and others of its unit."""
    shift = dataclasses.replace(row_of(curve, "shift"), name="amplitude of the shift", word=Word("U", "m", "amplitude"))
    rows = [answered(curve, item, "shift", of, "all" if others else ""), *others]
    return curves_panel(shift, rows, log=of != "loss_factor")


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
    asked = (phase_angle, item.loss_per_cycle) if amplitudes_along.size == 1 else ((), ())
    right = curves_panel(along, [Quantity(row_of(curve, "loss_per_cycle"), points=asked)])
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
    of = Quantity(series("damping", np.array(damping)), points=(greatest, item.damping))
    panel = curves_panel(series("depth_amplitude", amplitudes), [of])
    return Sheet((panel.plus(title="viscous damper that the contact amounts to"),), width=4.8, height=3.2)
