"""Sheets of damping: what a contact loses per cycle, and how stiff it is, over amplitude or phase."""

from __future__ import annotations

import dataclasses
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.loading import ShearForce, Shift
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.friction.curves import draw_lines
from winkler.plot.series import Series, middle_scale, series, told
from winkler.problems.friction.bimodal_damping import BimodalDampingSolution
from winkler.problems.friction.damping import FrictionDamping, FrictionDampingSolution
from winkler.problems.friction.relaxation_damping import RelaxationDamperSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.plot.picture import Picture

__all__ = ["bimodal_sheet", "damping_sheet", "relaxation_sheet"]

POINTS = 73
LOOP = 101
LEAST, GREATEST = 0.02, 4.0
"""Curves go so far below and beyond the shift at which all slides."""
PHASES = 19


def damping_sheet(item: FrictionDampingSolution) -> Picture:
    """Return loss and loss factor over the amplitude, up to sliding and beyond, and the loop of the greatest amplitude.

    Parameters
    ----------
    item : FrictionDampingSolution
    """
    problem = item.problem
    slides = problem.law.coefficient * float(item.contact.force)
    reach = float(dataclasses.replace(problem, amplitude=ShearForce(slides)).solve().shift)
    asked = np.ravel(np.asarray(item.shift, dtype=float))
    asked = asked[asked > 0.0]
    low = min(LEAST * reach, 0.5 * float(np.min(asked, initial=reach)))
    high = max(GREATEST * reach, 1.5 * float(np.max(asked, initial=reach)))
    curve = dataclasses.replace(problem, amplitude=Shift(np.geomspace(low, high, POINTS))).solve()
    with style.styled():
        figure = style.figure(3, width=3.9, height=3.2)
        panels = figure.subplots(1, 3)
        for axes, name in ((panels[0], "loss_per_cycle"), (panels[1], "loss_factor")):
            _over(axes, curve, item, name, reach)
        panels[0].set_yscale("log")
        panels[1].set_ylim(0.0, 1.2 * 4.0 / math.pi)
        _draw_cycle(panels[2], problem, float(np.max(asked, initial=0.0)) or reach)
        titles = ("loss per cycle", "loss factor", "loop of the greatest amplitude")
        for axes, title in zip(panels, titles, strict=True):
            axes.set_title(title)
    return figure


def _over(axes: Axes, curve: FrictionDampingSolution, item: FrictionDampingSolution, name: str, reach: float) -> None:
    """Draw one quantity over the amplitude of the shift, and what was asked."""
    along = series("FrictionDampingSolution", "shift", np.asarray(curve.shift))
    of = series("FrictionDampingSolution", name, np.asarray(getattr(curve, name)))
    across, upright = middle_scale("m", along.content), middle_scale(of.word.unit, of.content)
    axes.plot(along.shown(across), of.shown(upright), color=style.BLUE)
    shift, asked = (np.ravel(np.asarray(part, dtype=float)) for part in (item.shift, getattr(item, name)))
    moving = shift > 0.0
    axes.plot(shift[moving] / across.factor, asked[moving] / upright.factor, "o", color=style.RED, label="asked")
    axes.axvline(reach / across.factor, color=style.MUTED, linewidth=0.9, linestyle=":", label="all slides")
    axes.set_xscale("log")
    axes.set_xlabel(f"amplitude of the shift $U$ [{across.unit}]")
    axes.set_ylabel(of.label(upright))
    style.framed_legend(axes, loc="upper left")


def _draw_cycle(axes: Axes, problem: FrictionDamping, amplitude: float) -> None:
    """Draw the closed loop: each way is the first loading, twice as large (Masing)."""
    share = np.linspace(0.0, 1.0, LOOP)
    first = np.asarray(dataclasses.replace(problem, amplitude=Shift(amplitude * share)).solve().shear_force)
    way, force = amplitude * (2.0 * share - 1.0), 2.0 * first - first[-1]
    along = series("FrictionDampingSolution", "shift", np.concatenate([way, -way]))
    of = series("FrictionDampingSolution", "shear_force", np.concatenate([force, -force]))
    axes.fill(along.shown(), of.shown(), color=style.RED, alpha=0.14, linewidth=0.0)
    axes.plot(along.shown(), of.shown(), color=style.BLUE)
    axes.plot(
        amplitude * share / along.scale.factor,
        first / of.scale.factor,
        color=style.MUTED,
        linewidth=1.0,
        linestyle=style.DASHES[1],
    )
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
    axes.margins(x=0.06, y=0.12)
    axes.set_xlabel(along.label())
    axes.set_ylabel(of.label())
    loss = dataclasses.replace(problem, amplitude=Shift(amplitude)).solve().loss_per_cycle
    style.note(axes, f"shaded: {told(float(loss), 'J')}", where="upper left")


def bimodal_sheet(item: BimodalDampingSolution) -> Picture:
    """Return the closed cycle of depth and shift, and the loss over what was varied, or over the phase."""
    problem = item.problem
    pushed, ahead = np.broadcast_arrays(
        np.asarray(problem.shift_amplitude, dtype=float), np.asarray(problem.phase, dtype=float)
    )
    place = int(np.argmax(np.ravel(item.loss_per_cycle)))
    path = problem.path(float(ahead.ravel()[place]), float(pushed.ravel()[place]), cycles=1)
    with style.styled():
        figure = style.figure(2, height=3.2)
        left, right = figure.subplots(1, 2)
        depth, shift = series("BimodalDamping", "depth", path.across), series("TangentialSolution", "shift", path.along)
        left.plot(shift.shown(), depth.shown(), color=style.BLUE)
        left.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
        left.margins(0.08)
        left.invert_yaxis()
        left.set_xlabel(shift.label())
        left.set_ylabel(depth.label())
        by_amplitude = np.ptp(pushed) > 0.0
        curve = item if pushed.size > 1 else _over_phase(item)
        along, label = _varied(curve, by_amplitude=bool(by_amplitude))
        loss = np.ravel(np.asarray(curve.loss_per_cycle))
        order = np.argsort(along.content, kind="stable")
        of = series("BimodalDampingSolution", "loss_per_cycle", loss[order])
        marker = "o" if pushed.size > 1 and loss.size <= 40 else ""
        right.plot(along.shown()[order], of.shown(), color=style.BLUE, marker=marker)
        if pushed.size == 1:
            x = float(ahead.ravel()[0]) / along.scale.factor
            right.plot([x], [float(np.ravel(item.loss_per_cycle)[0]) / of.scale.factor], "o", color=style.RED)
        right.set_ylim(0.0, None)
        right.margins(x=0.04)
        right.set_xlabel(label)
        right.set_ylabel(of.label())
        left.set_title("the closed cycle" + (" of the greatest loss" if pushed.size > 1 else ""))
        right.set_title(f"loss per cycle over {'amplitude' if by_amplitude else 'phase'}")
    return figure


def _over_phase(item: BimodalDampingSolution) -> BimodalDampingSolution:
    phase = float(np.ravel(np.asarray(item.problem.phase))[0])
    around = np.union1d(np.linspace(0.0, math.pi, PHASES), [phase] if 0.0 <= phase <= math.pi else [])
    return dataclasses.replace(
        item.problem, phase=around, shift_amplitude=float(np.ravel(np.asarray(item.problem.shift_amplitude))[0])
    ).solve()


def _varied(item: BimodalDampingSolution, *, by_amplitude: bool) -> tuple[Series, str]:
    name = "shift_amplitude" if by_amplitude else "phase"
    content = np.broadcast_to(np.asarray(getattr(item.problem, name), dtype=float), np.shape(item.loss_per_cycle))
    along = series("BimodalDamping", name, np.ravel(content))
    return along, along.label()


def relaxation_sheet(item: RelaxationDamperSolution) -> Picture:
    """Return the viscous damper over the amplitude of the depth."""
    problem = item.problem
    most = float(problem.depth_amplitude)
    amplitudes: Array = np.geomspace(0.05 * most, 4.0 * most, 33)
    damping = [
        float(dataclasses.replace(problem, depth_amplitude=float(amplitude)).solve().damping)
        for amplitude in amplitudes
    ]
    with style.styled():
        figure = style.figure(width=4.8, height=3.2)
        axes: Any = figure.subplots()
        along = series("RelaxationDamper", "depth_amplitude", amplitudes)
        of = series("RelaxationDamperSolution", "damping", np.array(damping))
        draw_lines(axes, along, [(of, "damping")], f"damping ${of.word.symbol}$")
        axes.plot([most / along.scale.factor], [float(item.damping) / of.scale.factor], "o", color=style.RED)
        axes.set_ylim(0.0, None)
        axes.set_title("viscous damper that the contact amounts to")
    return figure
